#!/bin/sh
# The library is freestanding: linked with -nostdlib -Wl,-z,defs it has no undefined
# symbol and no writable data, with every compiler found and at several levels of
# optimisation, nor has it on a microcontroller; the flags of users who ask for fast
# mathematics do not reach it: no multiplication is fused with an addition, of the processors
# that can, and AVX-512's back end is always compiled for one; its headers compile alone, as
# C99 and as C++.
# usage: freestanding.sh BUILD-DIRECTORY   (from the root of the project)
set -eu
build=$1/freestanding
warnings="-Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"
own="-ffreestanding -fvisibility=hidden -fPIC -fno-math-errno -fno-stack-protector -fno-fast-math -ffp-contract=off"
passed=0
failed=0

compile_all() { # compile_all DIRECTORY COMPILER FLAGS...: every file, as many at a time as there are processors
    into=$1
    shift
    # shellcheck disable=SC2016
    printf '%s\n' src/*/*.c | xargs -P "$(nproc 2>/dev/null || echo 1)" -I '{}' sh -c '
        source=$1 into=$2
        shift 2
        "$@" -c "$source" -o "$into/$(echo "$source" | tr / _).o"' sh '{}' "$into" "$@"
}

check() { # check NAME COMPILER FLAGS...
    name=$1
    compiler=$2
    shift 2
    directory=$build/$name
    rm -rf "$directory"
    mkdir -p "$directory"
    ok=yes
    # shellcheck disable=SC2086
    compile_all "$directory" "$compiler" -std=c99 -pedantic $warnings "$@" -Iinclude $own || ok=no
    "$compiler" -shared -nostdlib -Wl,-z,defs "$directory"/*.o -o "$directory/libgnomon.so" || ok=no
    undefined=$(nm -D -u "$directory/libgnomon.so" | wc -l)
    writable=$(size -A "$directory/libgnomon.so" |
        awk '/^\.(data|bss|data\.rel\.ro|tdata|tbss)/ { n += $2 } END { print n + 0 }')
    objdump -d "$directory/libgnomon.so" >"$directory/disassembly" || ok=no
    fused=$(grep -c -E '[[:space:]]vfn?m(add|sub)' "$directory/disassembly") || true
    echo "$name: undefined symbols: $undefined, data+bss bytes: $writable, fused operations: $fused"
    if [ $ok = yes ] && [ "$undefined" -eq 0 ] && [ "$writable" -eq 0 ] && [ "$fused" -eq 0 ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
    fi
}

# A Cortex-M4, whose compiler calls memcpy and memset for little: nothing is undefined but its
# own routines for floats and 64-bit integers, and for doubles in the one file that has any.
check_microcontroller() { # check_microcontroller NAME FLAGS...
    name=$1
    shift
    directory=$build/$name
    rm -rf "$directory"
    mkdir -p "$directory"
    ok=yes
    # shellcheck disable=SC2086
    compile_all "$directory" arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -std=c99 -pedantic $warnings "$@" \
        -Iinclude $own -fno-pic || ok=no
    doubles=$(arm-none-eabi-nm -u -A "$directory"/*.o | awk '
        /__aeabi_(c?d|[a-z]+2d)/ && !/src_math_invert\.c\.o:/ { n++ } END { print n + 0 }')
    arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -nostdlib -r "$directory"/*.o -lgcc -o "$directory/library" || ok=no
    undefined=$(arm-none-eabi-nm -u "$directory/library" | awk '{ text = text " " $2 } END { print text }')
    writable=$(arm-none-eabi-size "$directory/library" | awk 'NR == 2 { print $2 + $3 }')
    echo "$name: undefined symbols:${undefined:- 0}, data+bss bytes: $writable, calls for doubles outside src/math/invert.c: $doubles"
    if [ $ok = yes ] && [ -z "$undefined" ] && [ "$doubles" -eq 0 ] && [ "$writable" -eq 0 ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
    fi
}

header() { # header NAME COMMAND...
    name=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
    else
        echo "$name: does not compile"
        failed=$((failed + 1))
    fi
}

command -v gcc >/dev/null && check gcc-O2 gcc -O2 && check gcc-O0 gcc -O0 && check gcc-Os gcc -Os &&
    check gcc-Ofast gcc -Ofast -march=skylake-avx512 -ffp-contract=fast
command -v clang >/dev/null && check clang-O2 clang -O2
check only-portable "${CC:-cc}" -O2 -DGN_ONLY_PORTABLE
check basic "${CC:-cc}" -O1 -DGN_SMALL -DGN_BASIC
if command -v arm-none-eabi-gcc >/dev/null; then
    check_microcontroller cortex-m4-O2 -O2
    check_microcontroller cortex-m4-small -Os -DGN_SMALL
else
    echo "cortex-m4: not compiled, since arm-none-eabi-gcc is absent: 'make setup-cross' installs it"
fi

for file in include/gnomon.h include/gnomon/*.h; do
    include=${file#include/}
    printf '#include <%s>\ntypedef int not_empty;\n' "$include" >"$build/one.c"
    header "$include as C99" "${CC:-cc}" -std=c99 -pedantic $warnings -Iinclude -c "$build/one.c" -o "$build/one.o"
    if command -v g++ >/dev/null; then
        header "$include as C++" g++ -x c++ -std=c++98 -pedantic $warnings -Wno-long-long -Wno-variadic-macros \
            -Iinclude -c "$build/one.c" -o "$build/one.o"
    fi
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
