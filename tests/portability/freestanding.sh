#!/bin/sh
# Checks that the library is freestanding: linked with -nostdlib -Wl,-z,defs it has no undefined
# symbol and no writable data. That holds for the default build, for every compiler found, for
# several levels of optimisation, and on a microcontroller. The flags of users who ask for fast
# mathematics have no effect: no multiplication is fused with an addition on processors that can
# fuse; AVX-512's back end is always compiled for such a processor. Names that can be linked are
# declared in the headers, or begin with gni_. The headers compile alone, as C99 and as C++.
# Optimising the back ends takes minutes. So only plain C is compiled again: at -O0, where compilers call
# memcpy and memset most, and with fast mathematics at -O2, the lowest level that fuses. With --quick, only
# the library as it was built is looked at, and one with few features; with --all, all compilers compile the
# back ends at all levels.
# The last line is "freestanding: [without NAMES: ]N passed, N failed"; the names are those of absent
# compilers.
# usage: freestanding.sh BUILD-DIRECTORY [--quick | --all]   (from the root of the project, with the library in it)
set -eu
. tests/script.sh
begin freestanding "$1/freestanding"
all=${2:-}
warnings="-Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"
own="-ffreestanding -fvisibility=hidden -fPIC -fno-math-errno -fno-stack-protector -fno-fast-math -ffp-contract=off"
names=
without=

# plan NAME COMPILER FLAGS...: plans to compile the library so. All planned libraries are compiled
# together, since one file of the back ends takes as long as all other files.
plan() {
    name=$1
    names="$names $name"
    shift
    mkdir -p "$work/$name"
    echo "exec $* -std=c99 -pedantic $warnings -Iinclude $own -c \"\$1\" -o \"\$2\"" >"$work/$name/compile"
}

# Compiles as many files at a time as there are processors, the slowest first.
compile_all() {
    for source in src/backends/*.c $(printf '%s\n' src/*/*.c | grep -v '^src/backends/'); do
        for name in $names; do
            echo "$name $source"
        done
    done | xargs -P "$(nproc 2>/dev/null || echo 1)" -n 2 sh -c '
        sh "$0/$1/compile" "$2" "$0/$1/$(echo "$2" | tr / _).o" || : >"$0/$1/failed"' "$work"
}

# shared NAME LIBRARY: prints what a shared library has, and tells whether it has nothing of that. Constants
# that hold addresses (.data.rel.ro) do not count: the loader writes them once and makes them
# read-only. GCC 14 makes some with -fPIC.
shared() {
    undefined=$(nm -D -u "$2" | wc -l)
    writable=$(size -A "$2" | awk '/^\.(data|bss|tdata|tbss)[^.]/ { n += $2 } END { print n + 0 }')
    objdump -d "$2" >"$work/disassembly" || return 1
    fused=$(grep -c -E '[[:space:]]vfn?m(add|sub)' "$work/disassembly") || true
    echo "$1: undefined symbols: $undefined, data+bss bytes: $writable, fused operations: $fused" | tee -a "$work/figures"
    [ "$undefined" -eq 0 ] && [ "$writable" -eq 0 ] && [ "$fused" -eq 0 ]
}

# hosted NAME: the same of the library that was planned under this name.
hosted() {
    [ ! -e "$work/$1/failed" ] &&
        ${CC:-cc} -shared -nostdlib -Wl,-z,defs "$work/$1"/*.o -o "$work/$1/libgnomon.so" && shared "$1" "$work/$1/libgnomon.so"
}

# bare NAME: the same of a library for a Cortex-M4, where the compiler calls memcpy and memset even for
# small copies. Nothing is undefined except the compiler's own routines for floats and 64-bit integers,
# and for doubles in the only file that uses doubles there.
bare() {
    folder=$work/$1
    doubles=$(arm-none-eabi-nm -u -A "$folder"/*.o | awk '
        /__aeabi_(c?d|[a-z]+2d)/ && !/src_math_adjugate\.c\.o:/ { n++ } END { print n + 0 }')
    arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -nostdlib -r "$folder"/*.o -lgcc -o "$folder/library" || return 1
    undefined=$(arm-none-eabi-nm -u "$folder/library" | awk '{ text = text " " $2 } END { print text }')
    writable=$(arm-none-eabi-size "$folder/library" | awk 'NR == 2 { print $2 + $3 }')
    echo "$1: undefined symbols:${undefined:- 0}, data+bss bytes: $writable, calls for doubles outside src/math/adjugate.c: $doubles" |
        tee -a "$work/figures"
    [ ! -e "$folder/failed" ] && [ -z "$undefined" ] && [ "$doubles" -eq 0 ] && [ "$writable" -eq 0 ]
}

# prefixes ARCHIVE: names that one file of the library defines for others begin with gni_; all other names
# that can be linked are declared in the public headers.
prefixes() {
    grep -ohE '\<gn_[a-z0-9_]+' include/gnomon/*.h | sort -u >"$work/declared"
    nm -g --defined-only "$1" | awk 'NF == 3 && $3 !~ /^gni_/ { print $3 }' | sort -u >"$work/defined"
    ! comm -13 "$work/declared" "$work/defined" | grep . >&2
}

has() { command -v "$1" >/dev/null; }

lacks() { # lacks COMPILER WHAT SETUP
    without="$without${without:+, }$1"
    skip "$2, since $1 is absent: 'make $3' installs it"
}

user=${CC:-cc}
! has gcc || user=gcc
fast="-ffast-math -ffp-contract=fast"
case $($user -dumpmachine) in
x86_64*) fast="$fast -march=skylake-avx512" ;;
esac

if [ "$all" != --quick ]; then
    fewer=-DGN_ONLY_PORTABLE
    [ "$all" != --all ] || fewer=
    # shellcheck disable=SC2086
    ! has gcc || plan gcc-O0 gcc -O0 $fewer
    # shellcheck disable=SC2086
    plan fast-only-portable "$user" -O2 $fast -DGN_ONLY_PORTABLE
fi
plan basic ${CC:-cc} -O1 -DGN_SMALL -DGN_BASIC
if [ "$all" = --all ]; then
    ! has gcc || plan gcc-Os gcc -Os
    # shellcheck disable=SC2086
    plan fast "$user" -Ofast $fast
    ! has clang || plan clang-O2 clang -O2
    plan only-portable ${CC:-cc} -O2 -DGN_ONLY_PORTABLE
fi
hosts=$names
names=
if [ "$all" != --quick ] && has arm-none-eabi-gcc; then
    own="$own -fno-pic"
    plan cortex-m4-small arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -Os -DGN_SMALL
    plan cortex-m4-one-lane arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -O2 -DGN_SMALL -DGN_BASIC
    [ "$all" != --all ] || plan cortex-m4-O2 arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -O2
    [ "$all" != --all ] || plan cortex-m4-Os arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -Os
fi
boards=$names
names="$hosts $boards"
compile_all

result "as built" shared "as built" "$1/libgnomon.so"
result "prefixes of names" prefixes "$1/libgnomon.a"
for name in $hosts; do
    result "$name" hosted "$name"
done
for name in $boards; do
    result "$name" bare "$name"
done
cat "$work/figures"
[ "$all" = --quick ] || has arm-none-eabi-gcc || lacks arm-none-eabi-gcc "Cortex-M4: not compiled for" setup-cross
for tool in gcc g++ clang; do
    has $tool || lacks $tool "$tool: compiles nothing" setup
done

for file in include/gnomon.h include/gnomon/*.h; do
    include=${file#include/}
    printf '#include <%s>\ntypedef int not_empty;\n' "$include" >"$work/one.c"
    result "$include as C99" ${CC:-cc} -std=c99 -pedantic $warnings -Iinclude -c "$work/one.c" -o "$work/one.o"
    if command -v g++ >/dev/null; then
        result "$include as C++" g++ -x c++ -std=c++98 -pedantic $warnings -Wno-long-long -Wno-variadic-macros \
            -Iinclude -c "$work/one.c" -o "$work/one.o"
    fi
done
echo "freestanding: ${without:+without $without: }$passed passed, $failed failed"
[ "$failed" -eq 0 ]
