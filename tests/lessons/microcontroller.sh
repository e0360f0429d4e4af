#!/bin/sh
# Runs lesson 21 on a Cortex-M4F in an emulator, without an operating system, C library or heap, with
# the library that `make static` compiles at -Os with GN_SMALL and GN_BASIC. The display must have been
# sent the picture that the lesson draws on this machine. The library must have no writable data, and
# none of the tables of position-independent code.
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
flags="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -Os -DGN_SMALL -DGN_BASIC -ffunction-sections -fdata-sections"
bare="$flags -ffreestanding -fno-math-errno -fno-tree-loop-distribute-patterns"
MAKEFLAGS='' make -s -j 2 static CC=arm-none-eabi-gcc AR=arm-none-eabi-ar BUILD="$build/library" CFLAGS="$flags" >"$build/log"
library=$build/library/libgnomon.a
arm-none-eabi-objdump -r "$library" | grep -q GOT && {
    echo "lesson on a microcontroller: the static library is position-independent code"
    failed=1
}
arm-none-eabi-objdump -h "$library" | awk '$2 ~ /^\.(data|bss|got)/ && $3 !~ /^0+$/ { print $2 ": " $3; found = 1 } END { exit found }' || failed=1
# shellcheck disable=SC2086
arm-none-eabi-gcc $common $bare -Wall -Wextra -Werror -c tests/lessons/microcontroller.c -o "$build/lesson.o"
# shellcheck disable=SC2086
arm-none-eabi-gcc $bare -nostdlib -nostartfiles -Wl,--gc-sections -Wl,--defsym=code_begin=0,--defsym=ram_begin=0x20000000,--defsym=ram_length=2M \
    -T tests/microcontrollers/board.ld "$build/lesson.o" "$library" -lgcc -o "$build/lesson.elf"
# shellcheck disable=SC2086
${CC:-cc} $common -O2 tests/lessons/microcontroller.c "$archive" -o "$build/here"
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
