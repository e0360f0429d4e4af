#!/bin/sh
# How much a microcontroller's program holds of the library: compiled at -Os for a Cortex-M4,
# with software and hardware floats, and linked so that only what microcontroller.c reaches
# stays, with the compiler's own routines for floats. The same program then draws in an
# emulator, in a workspace of 16 KiB, and its picture is compared with one drawn here.
# usage: size.sh BUILD-DIRECTORY   (from the root of the project)
set -eu
build=$1/size
goal=32768
compiler=arm-none-eabi-gcc
passed=0
failed=0
rm -rf "$build"
mkdir -p "$build"

if ! command -v $compiler >/dev/null 2>&1; then
    echo "size: nothing measured, since $compiler is absent: 'make setup-cross' installs it"
    exit 0
fi

own="-Os -ffreestanding -fvisibility=hidden -fno-math-errno -fno-fast-math -ffp-contract=off"
sections="-ffunction-sections -fdata-sections"
common="-std=c99 -Wall -Wextra -Werror -Iinclude"

# least VARYINGS: bytes of the least workspace.
least() {
    printf '#include <gnomon.h>\nchar least[GN_WORKSPACE_SIZE(0, %s)];\n' "$1" |
        $compiler -mcpu=cortex-m4 -mthumb -Iinclude -x c -c - -o "$build/least.o"
    arm-none-eabi-nm -S -t d "$build/least.o" | awk '$4 == "least" { print $2 + 0 }'
}

# library NAME FLAGS...: compiles the library into a directory.
library() {
    directory=$build/$1
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
    object=$build/$1-$2
    shift 2
    # shellcheck disable=SC2086
    $compiler $common "$@" $own $sections -c tests/portability/microcontroller.c -o "$object.o"
}

# measure LIBRARY VARYINGS LABEL PROGRAM-NAME FLAGS...: a row of the table.
measure() {
    from=$1 varyings=$2 label=$3
    shift 3
    program "$from" "$@"
    shift
    roots=$(arm-none-eabi-nm -u "$object.o" | awk '$2 ~ /^gn_/ { printf " -Wl,-u,%s", $2 }')
    # shellcheck disable=SC2086
    $compiler "$@" -nostdlib -r $roots -Wl,--gc-sections "$build/$from"/*.o -lgcc -o "$object.library"
    undefined=$(arm-none-eabi-nm -u "$object.library" | awk '{ printf "%s%s", sep, $2; sep = " " }')
    set -- $(arm-none-eabi-size "$object.library" | tail -1)
    note=""
    [ "$1" -le $goal ] || note="above $goal"
    printf '%-44s %7d %5d %5d %9d  %-12s %s\n' "$label" "$1" "$2" "$3" "$(least "$varyings")" \
        "${undefined:-none}" "$note"
}

# draws LIBRARY NAME FLAGS...: runs the program that `measure` compiled.
draws() {
    from=$1 object=$build/$1-$2 label="$1, $2"
    shift 2
    # shellcheck disable=SC2086
    $compiler "$@" -nostdlib -Wl,--gc-sections -T tests/portability/microcontroller.ld \
        "$object.o" "$build/$from"/*.o -lgcc -o "$object.elf"
    timeout 120 qemu-system-arm -M mps2-an386 -nographic -monitor none -serial none \
        -semihosting-config enable=on,target=native -kernel "$object.elf" >"$object.printed" 2>&1 || true
    hash=$(head -n 1 "$object.printed")
    if [ "$hash" = "$here" ] && [ "$hash" != 00000000 ]; then
        passed=$((passed + 1))
        echo "$label: drawn in a workspace of 16 KiB, hash $hash equal;" \
            "stack $(printf %d "0x$(sed -n 2p "$object.printed")") bytes"
    else
        failed=$((failed + 1))
        echo "$label: hash '$hash', here '$here'"
    fi
}

soft="-mcpu=cortex-m4 -mthumb -mfloat-abi=soft"
hard="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16"
color="-DTEXTURED=0 -DDEPTH=GN_FORMAT_NONE"

printf '%-44s %7s %5s %5s %9s  %s\n' "library in a program, bytes" text data bss workspace undefined
# shellcheck disable=SC2086
for kind in "soft:$soft" "hard:$hard" "soft-small:$soft -DGN_SMALL" "hard-small:$hard -DGN_SMALL"; do
    name=${kind%%:*}
    flags=${kind#*:}
    case $name in
    *-small) grep -qw GN_SMALL src/*/*.h || continue ;;
    esac
    library "$name" $flags
    measure "$name" 4 "$name: vertex colours, no depth" color $flags $color
    measure "$name" 6 "$name: nearest texture, light, D16" texture $flags
done

if ! command -v qemu-system-arm >/dev/null 2>&1; then
    echo "not run, since qemu-system-arm is absent: 'make setup-cross' installs it"
    exit 0
fi
# shellcheck disable=SC2086
for scene in color texture; do
    [ $scene = texture ] && own_flags="" || own_flags=$color
    ${CC:-cc} -std=c99 -O2 -fno-fast-math -ffp-contract=off -Iinclude $own_flags \
        tests/portability/microcontroller.c "$1/libgnomon.a" -o "$build/here"
    here=$("$build/here")
    for linked in "$build"/*-$scene.library; do
        kind=$(basename "$linked" "-$scene.library")
        case $kind in
        soft*) draws "$kind" $scene $soft ;;
        *) draws "$kind" $scene $hard ;;
        esac
    done
done
echo "size: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
