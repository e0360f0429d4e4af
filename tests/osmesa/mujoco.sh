#!/bin/sh
# MuJoCo's sample program record, unmodified, reads the same colours and depths with this project's
# libOSMesa and with the reference's. It needs Debian's libmujoco-dev and libmujoco-samples.
# usage: tests/osmesa/mujoco.sh BUILD
set -u
. tests/script.sh
begin osmesa

library=$(realpath "$1/osmesa")
. tests/osmesa/reference.sh
sample=/usr/share/doc/libmujoco-samples/examples/record.cc
models=/usr/share/mujoco/model
if ! [ -f "$sample" ] || ! [ -f /usr/include/mujoco/mujoco.h ]; then
    skip "MuJoCo: needs libmujoco-dev and libmujoco-samples: 'make setup-verify' installs them"
    finish
fi
need setup-verify g++

result "record.cc compiles" g++ -O1 -DMJ_OSMESA -Itools/osmesa "$sample" -o "$work/record" \
    -lmujoco -L"$library" -l:libOSMesa.so.8
result "the reader of frames compiles" cc -shared -fPIC tests/osmesa/mujoco_frames.c \
    -o "$work/frames.so" -ldl

# record RUNNER MODEL: three frames to $work/RUNNER. The program returns 1 in the end.
record() {
    LD_PRELOAD=$work/frames.so FRAMES=$work/$1 "$1" "$work/record" "$models/$2" 0.1 15 "$work/rgb" \
        >"$work/output" 2>&1
    [ "$(tr -d '\n' <"$work/output")" = . ] # x: an error of OpenGL
}

for model in humanoid/humanoid.xml mug/mug.xml composite/particle.xml composite/cloth.xml; do
    result "$model: the reference draws" record reference "$model"
    result "$model: this library draws" record ours "$model"
    result "$model: all bytes are equal" cmp "$work/reference" "$work/ours"
    result "$model: there are frames" test "$(wc -c <"$work/ours")" -ge 6000000
done
finish
