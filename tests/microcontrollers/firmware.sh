#!/bin/sh
# Copies tools/firmware to another place, as its README says, builds it there for a Cortex-M4F and then, in the same
# folder, for a Cortex-M0+, runs it in an emulator, and reads what was sent as the display does (check_display.c).
# usage: firmware.sh BUILD-DIRECTORY   (from the root of the project)
set -eu
. tests/script.sh
begin firmware "$1/firmware"
need setup-cross arm-none-eabi-gcc qemu-system-arm
archive=$1/libgnomon.a
root=$PWD
# shellcheck disable=SC2086
${CC:-cc} -std=c99 -O2 -fno-fast-math -ffp-contract=off -Iinclude -DDISPLAY_H '-DPROGRAM="../../tools/firmware/main.c"' \
    tests/microcontrollers/check_display.c "$archive" -o "$work/check-display"

cp -r tools/firmware "$work/copy"
sed -i 's/FRAMES = 3/FRAMES = 1/' "$work/copy/display.c" # the frame that stays is the last one

# board NAME VARIABLE=VALUE...: builds and runs the copy.
board() {
    name=$1
    shift
    result "$name: it builds" sh -c 'cd "$1" && shift && make -s -j 2 "$@"' - "$work/copy" GNOMON="$root" "$@"
    sed -n 's/^ *\([0-9]*\)\t *\([0-9]*\)\t *\([0-9]*\)\t.*/\1 bytes of flash, \2 of initial data, \3 of RAM without the stack/p' "$work/said"
    result "$name: it runs" sh -c 'cd "$1" && shift && timeout 100 make -s picture "$@" </dev/null 2>&1' - "$work/copy" GNOMON="$root" "$@"
    cat "$work/said"
    result "$name: the display shows the picture" "$work/check-display" "$work/copy/display.rgb565"
    cat "$work/said"
}
board cortex-m4f
# The first pixel is the background, 0.05, 0.1 and 0.2 in 31, 63 and 31 steps.
result "the picture of the display has its size and its colours" \
    sh -c 'wc -l <"$1" | grep -qx 57601 && sed 2q "$1" | tr "\n" " " | grep -qx "P3 240 240 255 16 24 49 "' - "$work/copy/display.ppm"
board cortex-m0plus CPU='-mcpu=cortex-m0plus -mthumb' BOARD=mps2-an385
finish
