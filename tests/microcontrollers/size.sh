#!/bin/sh
# Measures how much of the library a microcontroller's program holds: compiled at -Os for a
# Cortex-M4, with software and hardware floats, complete and with GN_SMALL and GN_BASIC. Only what
# microcontroller.c reaches is linked, with the compiler's own routines for floats. The program then
# draws in an emulator, in a workspace of 16 KiB, and its picture is compared with one drawn here.
# The stack size is the part of the stack's fill pattern that the program has overwritten. Fails if a
# picture differs, a symbol is undefined, there is writable data, or the text of the small library
# is too long.
# usage: size.sh BUILD-DIRECTORY   (from the root of the project)
set -eu
. tests/script.sh
begin size "$1/size"
need setup-cross arm-none-eabi-gcc
archive=$1/libgnomon.a
goal=32768 # of text, with GN_SMALL and GN_BASIC
compiler=arm-none-eabi-gcc

own="-Os -ffreestanding -fvisibility=hidden -fno-math-errno -fno-fast-math -ffp-contract=off"
sections="-ffunction-sections -fdata-sections"
common="-std=c99 -Wall -Wextra -Werror -Iinclude"
memory="-Wl,--defsym=code_begin=0,--defsym=ram_begin=0x20000000,--defsym=ram_length=72K"

# least VARYINGS FLAGS...: prints the bytes of the least workspace.
least() {
    printf '#include <gnomon.h>\nchar least[GN_WORKSPACE_SIZE(0, %s)];\n' "$1" >"$work/least.c"
    shift
    $compiler "$@" -Iinclude -c "$work/least.c" -o "$work/least.o"
    arm-none-eabi-nm -S -t d "$work/least.o" | awk '$4 == "least" { print $2 + 0 }'
}

# library NAME FLAGS...: compiles the library into a directory.
library() {
    directory=$work/$1
    shift
    rm -rf "$directory"
    mkdir -p "$directory"
    for source in src/*/*.c; do
        # shellcheck disable=SC2086
        $compiler $common "$@" $own $sections -c "$source" \
            -o "$directory/$(echo "$source" | tr '/' '_').o"
    done
}

# program LIBRARY NAME FLAGS...: compiles the program; `object` begins its files' names.
program() {
    object=$work/$1-$2
    shift 2
    # shellcheck disable=SC2086
    $compiler $common "$@" $own $sections -c tests/microcontrollers/microcontroller.c -o "$object.o"
}

# measure LIBRARY PROGRAM-NAME LABEL VARYINGS FLAGS...: a row of the table.
measure() {
    from=$1 scene=$2 label=$3 varyings=$4
    shift 4
    program "$from" "$scene" "$@"
    roots=$(arm-none-eabi-nm -u "$object.o" | awk '$2 ~ /^gn_/ { printf " -Wl,-u,%s", $2 }')
    # shellcheck disable=SC2086
    $compiler "$@" -nostdlib -r $roots -Wl,--gc-sections "$work/$from"/*.o -lgcc -o "$object.library"
    workspace=$(least "$varyings" "$@")
    undefined=$(arm-none-eabi-nm -u "$object.library" | awk '{ printf "%s%s", sep, $2; sep = " " }')
    notes=""
    stack=-
    [ -z "$emulator" ] || run "$@"
    # shellcheck disable=SC2046
    set -- $(arm-none-eabi-size "$object.library" | tail -1)
    case $from in
    *-small) [ "$1" -le $goal ] || notes="$notes; text above $goal" ;;
    esac
    [ "$2" -eq 0 ] && [ "$3" -eq 0 ] || notes="$notes; data"
    [ -z "$undefined" ] || notes="$notes; undefined: $undefined"
    printf '%-46s %7d %5d %5d %10d %6s%s\n' "$label" "$1" "$2" "$3" "$workspace" "$stack" "${notes:+  ${notes#; }}"
    result "$label" [ -z "$notes" ]
}

# run FLAGS...: runs the program that `measure` compiled, compares its picture with one drawn here, and
# sets `stack` to the bytes of stack that it used.
run() {
    # shellcheck disable=SC2086
    $compiler "$@" -nostdlib -Wl,--gc-sections $memory -T tests/microcontrollers/board.ld \
        "$object.o" "$work/$from"/*.o -lgcc -o "$object.elf"
    # shellcheck disable=SC2086
    ${CC:-cc} -std=c99 -O2 -fno-fast-math -ffp-contract=off -Iinclude $scenery \
        tests/microcontrollers/microcontroller.c "$archive" -o "$work/here"
    here=$("$work/here" | head -n 1)
    timeout 120 qemu-system-arm -M mps2-an386 -nographic -monitor none -serial none \
        -semihosting-config enable=on,target=native -kernel "$object.elf" >"$object.printed" 2>&1 || true
    hash=$(head -n 1 "$object.printed")
    if [ "$hash" = "$here" ] && [ "$hash" != 0 ]; then
        stack=$(sed -n 2p "$object.printed")
    else
        notes="$notes; picture '$hash', here '$here'"
    fi
}

soft="-mcpu=cortex-m4 -mthumb -mfloat-abi=soft"
hard="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16"
color="-DTEXTURED=0 -DDEPTH=GN_FORMAT_NONE"

emulator=yes
command -v qemu-system-arm >/dev/null 2>&1 || {
    emulator=
    skip "microcontroller: not run, since qemu-system-arm is absent: 'make setup-cross' installs it"
}
printf '%-46s %7s %5s %5s %10s %6s\n' "library in a program, bytes" text data bss workspace stack
# shellcheck disable=SC2086
for kind in "soft:$soft" "hard:$hard" "hard-basic:$hard -DGN_BASIC" "soft-small:$soft -DGN_SMALL -DGN_BASIC" "hard-small:$hard -DGN_SMALL -DGN_BASIC"; do
    name=${kind%%:*}
    flags=${kind#*:}
    library "$name" $flags
    scenery=$color
    measure "$name" color "$name: vertex colours, no depth" 4 $flags $color
    scenery=
    measure "$name" texture "$name: nearest texture, light, D16" 6 $flags
    scenery=-DUSER_SHADER=1
    measure "$name" lookup "$name: nearest texture by a user's shader" 6 $flags $scenery
done
finish
