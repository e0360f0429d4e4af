#!/bin/sh
# A share of the comparisons with the reference, which is here Mesa through EGL
# (reference/osmesa/driver.h): its pixels must be those that OSMesa draws. Then which driver is
# chosen: empty files stand in for libraries that are absent.
# usage: tests/parity/egl.sh BUILD [--seed S] [--scenes N]
set -u
. "$(dirname "$0")/../skip.sh"
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
failed=0
passed=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP

if ! "$build/parity" --scenes 1 --keep "$work/scene" >"$work/out" 2>&1 &&
    package=$(grep -o "Debian's package lib[a-z0-9-]*" "$work/out"); then
    skip "parity through EGL: ${package##* } is absent: 'make setup' installs it"
    [ "$failed" = 0 ]
    exit
fi

# check COMMAND...: runs a comparison and prints its last line.
check() {
    if "$@" >"$work/out"; then
        passed=$((passed + 1))
        tail -n 1 "$work/out"
    else
        failed=$((failed + 1))
        echo "FAILED through EGL: $*"
        tail -n 20 "$work/out"
    fi
}

check "$build/parity" --seed "$seed" --scenes "$scenes" --keep "$build/egl-failure.scene"
figures=$(tail -n 1 "$work/out")
if ! grep -q '^Mesa EGL ' "$work/out"; then
    failed=$((failed + 1))
    echo 'FAILED: parity does not name EGL as its driver'
fi
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
    if head -n 1 "$work/out" | grep -q "$1"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: without '$2' and with '${3:-}' parity's first line has no '$1':"
        head -n 1 "$work/out"
    fi
}

osmesa=libOSMesa.so.8
chooses '^Mesa EGL ' $osmesa
chooses '^Mesa EGL ' $osmesa REFERENCE=egl
chooses 'no reference.*libosmesa6' $osmesa REFERENCE=osmesa
chooses 'no reference.*libosmesa6.*libegl1' "$osmesa libEGL.so.1"
chooses 'no reference.*libegl1' libEGL.so.1 REFERENCE=egl
chooses 'no reference.*it can be osmesa or egl' '' REFERENCE=gles

echo "EGL, ${figures#parity: }: $passed passed, $failed failed"
[ "$failed" = 0 ]
