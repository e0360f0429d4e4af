#!/bin/sh
# A share of the comparisons with the reference, which is here Mesa through EGL
# (reference/osmesa/driver.h): its pixels must be those that OSMesa draws. Then which driver is
# chosen: empty files stand in for libraries that are absent.
# usage: tests/parity/egl.sh BUILD [--seed S] [--scenes N]
set -u
. tests/script.sh
build=${1:?usage: tests/parity/egl.sh BUILD [--seed S] [--scenes N]}
shift
seed=1
scenes=550
while [ $# -gt 1 ]; do
    case $1 in
    --seed) seed=$2 ;;
    --scenes) scenes=$2 ;;
    *) break ;;
    esac
    shift 2
done
[ $# = 0 ] || { echo "egl.sh: unknown option, or no value: $1" >&2; exit 2; }
export REFERENCE=egl
begin EGL

if ! "$build/parity" --scenes 1 --keep "$work/scene" >"$work/out" 2>&1 &&
    package=$(grep -o "Debian's package lib[a-z0-9-]*" "$work/out"); then
    skip "parity through EGL: ${package##* } is absent: 'make setup' installs it"
    finish
fi

# check COMMAND...: runs a comparison and prints its last line.
check() {
    result "through EGL: $*" "$@"
    tail -n 1 "$work/said"
}

check "$build/parity" --seed "$seed" --scenes "$scenes" --keep "$build/egl-failure.scene"
script="EGL, $(sed -n 's/^parity: //p' "$work/said" | tail -n 1)"
cp "$work/said" "$work/out"
result "parity names EGL as its driver" grep '^Mesa EGL ' "$work/out"
check "$build/blits" --seed "$seed" --blits 330
check "$build/texels" --seed "$seed" --textures 2
check "$build/textures" --seed "$seed" --cases 60

# Libraries that parity is linked with (MESA in the Makefile) are found before those of LD_LIBRARY_PATH,
# unless its loader is told to leave that out.
mesa=$(ls -d "${MESA:-build/mesa}"/usr/lib/*-linux-gnu 2>/dev/null) || mesa=
loader=$(ls "$mesa"/ld-linux*.so.* 2>/dev/null) || loader=

# chooses WORDS HIDDEN [VARIABLE=VALUE]: without these libraries, parity's first line has the words.
chooses() {
    rm -rf "$work/hidden"
    mkdir "$work/hidden"
    for library in $2; do
        : >"$work/hidden/$library"
    done
    env -u REFERENCE LD_LIBRARY_PATH="$work/hidden${mesa:+:$mesa}" ${3:+"$3"} \
        ${loader:+"$loader" --inhibit-rpath ''} "$build/parity" --scenes 1 --keep "$work/scene" >"$work/out" 2>&1
    head -n 1 "$work/out" >"$work/first"
    result "without '$2' and with '${3:-}' parity's first line has no '$1': $(cat "$work/first")" grep "$1" "$work/first"
}

osmesa=libOSMesa.so.8
chooses '^Mesa EGL ' $osmesa
chooses '^Mesa EGL ' $osmesa REFERENCE=egl
chooses 'no reference.*libosmesa6' $osmesa REFERENCE=osmesa
chooses 'no reference.*libosmesa6.*libegl1' "$osmesa libEGL.so.1"
chooses 'no reference.*libegl1' libEGL.so.1 REFERENCE=egl
chooses 'no reference.*it can be osmesa or egl' '' REFERENCE=gles

finish
