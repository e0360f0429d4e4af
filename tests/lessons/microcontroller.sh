#!/bin/sh
# Runs lesson 21 on a Cortex-M4F in an emulator, without an operating system, C library or heap, with
# the library that `make static` compiles at -Os with GN_SMALL and GN_BASIC. The display must have been
# sent the picture that the lesson draws on this machine. The library must have no writable data, and
# none of the tables of position-independent code.
# usage: microcontroller.sh BUILD-DIRECTORY   (from the root of the project)
set -eu
. tests/script.sh
begin "lesson on a microcontroller" "$1/lesson-microcontroller"
need setup-cross arm-none-eabi-gcc qemu-system-arm
archive=$1/libgnomon.a
common="-std=c99 -Iinclude -fno-fast-math -ffp-contract=off"
flags="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -Os -DGN_SMALL -DGN_BASIC -ffunction-sections -fdata-sections"
bare="$flags -ffreestanding -fno-math-errno -fno-tree-loop-distribute-patterns"
make -s -j 2 static CC=arm-none-eabi-gcc AR=arm-none-eabi-ar BUILD="$work/library" CFLAGS="$flags" >"$work/log"
library=$work/library/libgnomon.a
result "the static library is not position-independent code" sh -c '! arm-none-eabi-objdump -r "$1" | grep GOT' - "$library"
arm-none-eabi-objdump -h "$library" >"$work/sections"
result "it has no writable data" awk '$2 ~ /^\.(data|bss|got)/ && $3 !~ /^0+$/ { print $2 ": " $3; found = 1 } END { exit found }' "$work/sections"
# shellcheck disable=SC2086
arm-none-eabi-gcc $common $bare -Wall -Wextra -Werror -c tests/lessons/microcontroller.c -o "$work/lesson.o"
# shellcheck disable=SC2086
arm-none-eabi-gcc $bare -nostdlib -nostartfiles -Wl,--gc-sections -Wl,--defsym=code_begin=0,--defsym=ram_begin=0x20000000,--defsym=ram_length=2M \
    -T tests/microcontrollers/board.ld "$work/lesson.o" "$library" -lgcc -o "$work/lesson.elf"
# shellcheck disable=SC2086
${CC:-cc} $common -O2 tests/lessons/microcontroller.c "$archive" -o "$work/here"
"$work/here" >"$work/expected"
result "the emulator ends" sh -c 'timeout 100 qemu-system-arm -M mps2-an386 -serial none -semihosting-config enable=on,target=native -nographic \
    -monitor none -icount shift=0 -kernel "$1/lesson.elf" >"$1/printed" 2>&1 </dev/null' - "$work"
text=$(arm-none-eabi-size "$work/lesson.elf" | awk 'END { print $1 }')
result "the display was sent the picture" awk -v text="$text" '
    NR == FNR { expected[FNR] = $1; next }
    { printed[FNR] = $1 }
    END {
        covered = 240 * 240 - printed[2]
        print "lesson 21 on a Cortex-M4F: " covered " pixels, hash " printed[1] ", here " expected[1] \
            ", " printed[3] " thousand instructions, " text " bytes of text"
        exit !(printed[1] == expected[1] && printed[1] != "" && covered > 5000)
    }' "$work/expected" "$work/printed"
cat "$work/said"
finish
