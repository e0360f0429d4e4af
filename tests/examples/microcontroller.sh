#!/bin/sh
# Runs lesson 21 on a Cortex-M4F in an emulator, without an operating system, C library or heap, with
# the library compiled at -Os with GN_SMALL and GN_BASIC. The display must have been sent the picture
# that the lesson draws on this machine.
# usage: microcontroller.sh BUILD-DIRECTORY   (from the root of the project)
set -eu
. tests/skip.sh
archive=$1/libgnomon.a
build=$1/lesson-microcontroller
failed=0
for tool in arm-none-eabi-gcc qemu-system-arm; do
    command -v $tool >/dev/null 2>&1 || {
        skip "lesson on a microcontroller: $tool is absent: 'make setup-cross' installs it"
        echo "0 passed, $failed failed"
        exit "$failed"
    }
done
rm -rf "$build"
mkdir -p "$build"
common="-std=c99 -Iinclude -fno-fast-math -ffp-contract=off"
bare="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -Os -DGN_SMALL -DGN_BASIC -ffreestanding -fno-math-errno
-ffunction-sections -fdata-sections -fno-tree-loop-distribute-patterns"
for source in src/*/*.c; do
    # shellcheck disable=SC2086
    echo arm-none-eabi-gcc $common $bare -c "$source" -o "$build/$(echo "$source" | tr / _).o"
done | tr '\n' '\0' | xargs -0 -n 1 -P 2 sh -c
# shellcheck disable=SC2086
arm-none-eabi-gcc $common $bare -Wall -Wextra -Werror -Wno-unused-function -c tests/examples/microcontroller.c -o "$build/lesson.o"
# shellcheck disable=SC2086
arm-none-eabi-gcc $bare -nostdlib -nostartfiles -Wl,--gc-sections -Wl,--defsym=code_begin=0,--defsym=ram_begin=0x20000000 \
    -T tests/embedded/board.ld "$build/lesson.o" "$build"/src_*.o -lgcc -o "$build/lesson.elf"
# shellcheck disable=SC2086
${CC:-cc} $common -O2 -Wno-unused-function tests/examples/microcontroller.c "$archive" -o "$build/here"
"$build/here" >"$build/expected"
timeout 100 qemu-system-arm -M mps2-an386 -serial none -semihosting-config enable=on,target=native -nographic \
    -monitor none -icount shift=0 -kernel "$build/lesson.elf" >"$build/printed" 2>&1 </dev/null || failed=1
text=$(arm-none-eabi-size "$build/lesson.elf" | awk 'END { print $1 }')
awk -v text="$text" '
    NR == FNR { expected[FNR] = $1; next }
    { printed[FNR] = $1 }
    END {
        covered = 240 * 240 - printed[2]
        print "lesson 21 on a Cortex-M4F: " covered " pixels, hash " printed[1] ", here " expected[1] \
            ", " printed[3] " thousand instructions, " text " bytes of text"
        exit !(printed[1] == expected[1] && printed[1] != "" && covered > 5000)
    }' "$build/expected" "$build/printed" || failed=1
echo "$((1 - failed)) passed, $failed failed"
[ "$failed" -eq 0 ]
