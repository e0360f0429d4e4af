#!/bin/sh
# Counts the instructions that a microcontroller executes to draw a sphere of 1,200 triangles
# (frame.c), in an emulator that counts them: on a Cortex-M4F with floats in hardware, and for
# information on a Cortex-M0+ and a 32-bit RISC-V processor, which compute floats in software. Each
# picture is compared with the one that the library draws on this machine. Prints a table, where
#   240x240, 60x60   instructions of gn_draw at the two sizes, in thousands
#   clear            instructions of clearing colour and depth at 240x240, in thousands
#   pixel            instructions that a covered pixel more takes, from the two sizes
#   triangle         what is left at 60x60 for each of the mesh's triangles
#   text             bytes of the library's text that the program holds
#   stack, workspace bytes that the program used
# A row passes if its pictures are equal and the emulator counts instructions.
# usage: embedded.sh BUILD-DIRECTORY [CONFIGURATION...]   (from the root of the project)
set -eu
. tests/script.sh
begin embedded "$1/embedded"
archive=$1/libgnomon.a
here=tests/microcontrollers
shift

common="-std=c99 -Iinclude -I$here"
own="-ffreestanding -fvisibility=hidden -fno-math-errno -fno-fast-math -ffp-contract=off
-ffunction-sections -fdata-sections"
small="-DGN_SMALL -DGN_BASIC"

# describe CONFIGURATION: sets the compiler's prefix, its flags and the emulator.
describe() {
    prefix=arm-none-eabi-
    memory="-Wl,--defsym=code_begin=0,--defsym=ram_begin=0x20000000,--defsym=ram_length=2M"
    emulator="qemu-system-arm -M mps2-an386 -serial none -semihosting-config enable=on,target=native"
    case $1 in
    m4f-O2) flags="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -O2 $small" ;;
    m4f-Os) flags="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -Os $small" ;;
    m4f-whole) flags="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -O3" ;;
    m4f-small) flags="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -O2 -DGN_SMALL" ;;
    m0plus-O2) # the board's processor is a Cortex-M3, which runs the same instructions
        emulator="qemu-system-arm -M mps2-an385 -serial none -semihosting-config enable=on,target=native"
        flags="-mcpu=cortex-m0plus -mthumb -O2 $small"
        ;;
    rv32-O2)
        prefix=riscv64-unknown-elf-
        memory="-Wl,--defsym=code_begin=0x80000000,--defsym=ram_begin=0x80400000,--defsym=ram_length=2M"
        emulator="qemu-system-riscv32 -M virt -bios none"
        flags="-march=rv32imac -mabi=ilp32 -mcmodel=medany -O2 $small"
        ;;
    *)
        echo "embedded.sh: unknown configuration '$1': m4f-O2, m4f-Os, m4f-whole, m4f-small, m0plus-O2, rv32-O2" >&2
        exit 2
        ;;
    esac
}

# library CONFIGURATION: compiles the library.
library() {
    directory=$work/$1
    rm -rf "$directory"
    mkdir -p "$directory"
    for source in src/*/*.c; do
        # shellcheck disable=SC2086
        echo "$prefix"gcc $common $flags $own -c "$source" -o "$directory/$(echo "$source" | tr / _).o"
    done | tr '\n' '\0' | xargs -0 -n 1 -P 2 sh -c
}

# text PROGRAM: prints the bytes of the library's text that a program holds, with the compiler's
# own routines.
text() {
    roots=$("$prefix"nm -u "$1.o" | awk '$2 ~ /^gn_/ { printf " -Wl,-u,%s", $2 }')
    # shellcheck disable=SC2086
    "$prefix"gcc $flags -nostdlib -r $roots -Wl,--gc-sections "$directory"/src_*.o -lgcc -o "$1.library"
    "$prefix"size "$1.library" | awk 'END { print $1 }'
}

# scene CONFIGURATION SCENE NAME: a row of the table.
scene() {
    program=$work/$1/scene-$2
    # shellcheck disable=SC2086
    "$prefix"gcc $common -Wall -Wextra -Werror $flags $own -DSCENE="$2" -c $here/frame.c -o "$program.o"
    # shellcheck disable=SC2086
    "$prefix"gcc $flags -nostdlib -nostartfiles -Wl,--gc-sections $memory -T $here/board.ld \
        "$program.o" "$directory"/src_*.o -lgcc -o "$program.elf"
    ${CC:-cc} -std=c99 -O2 -fno-fast-math -ffp-contract=off -Iinclude -I$here -DSCENE="$2" \
        $here/frame.c "$archive" -o "$work/here-$2"
    "$work/here-$2" >"$work/here-$2.printed"
    # shellcheck disable=SC2086
    timeout 300 $emulator -nographic -monitor none -icount shift=0 -kernel "$program.elf" \
        >"$program.printed" 2>&1 </dev/null || echo "the emulator fails" >"$program.printed"
    result "$1, $3" awk -v name="$1" -v scene="$3" -v text="$(text "$program")" '
        function hashes(line) { split(line, f, " "); return f[4] " " f[5] }
        NR == FNR { expected[FNR] = $0; next }
        { line[FNR] = $0 }
        END {
            if (line[1] < 2999000 || line[1] > 3001000)
                fault = "a loop of 3,000,000 instructions counts as " line[1]
            else if (hashes(line[2]) != hashes(expected[2]) || hashes(line[3]) != hashes(expected[3]))
                fault = "the pictures are not those of this machine"
            if (fault) {
                print fault
                exit 1
            }
            split(line[2], large, " ")
            split(line[3], small, " ")
            pixel = (large[3] - small[3]) / (large[4] - small[4])
            printf "%-10s %-14s %8d %7d %6d %6d %8d %6d %6d %9d\n", name, scene, large[3] / 1000,
                small[3] / 1000, large[2] / 1000, pixel, (small[3] - pixel * small[4]) / 1200, text,
                large[6], line[4]
        }' "$work/here-$2.printed" "$program.printed"
    grep "^$1 " "$work/said" || :
}

[ $# -gt 0 ] || set -- m4f-O2 m4f-Os m4f-whole m4f-small m0plus-O2 rv32-O2
printf '%-10s %-14s %8s %7s %6s %6s %8s %6s %6s %9s\n' "" "" 240x240 60x60 clear pixel triangle text stack workspace
for configuration in "$@"; do
    describe "$configuration"
    for tool in "${prefix}gcc" "${emulator%% *}"; do
        command -v "$tool" >/dev/null || {
            skip "$configuration: not run, since $tool is absent: 'make setup-cross' installs it"
            continue 2
        }
    done
    library "$configuration"
    scene "$configuration" 0 "vertex colours"
    scene "$configuration" 1 "nearest"
    scene "$configuration" 2 "bilinear"
    scene "$configuration" 3 "user's shader"
done
finish
