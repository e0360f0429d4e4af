#!/bin/sh
# Compiles the library as one file (`make amalgamation`) with gcc, clang, tcc and g++, without a
# warning, and compares its pixels and mathematics with those of the library as built. The README's
# program is then compiled beside it with no other header than its gnomon.h. The files must not
# depend on the machine that writes them: another compiler and another order of Python's sets write
# the same bytes. It is compiled for 64-bit Arm and a microcontroller too. To save time, gcc alone
# optimises, and compiles every back end; the files of src/ are compiled with other flags and for other
# machines (tests/portability/builds).
# usage: amalgamation.sh BUILD-DIRECTORY   (from the root of the project; BUILD has hashes)
set -eu
. tests/packaging/packaging.sh
build=$1
scenes=220
begin amalgamation "$build/embed/amalgamation"
need setup python3
readme_program "$build"
source=$build/amalgamation/gnomon.c
make -s amalgamation BUILD="$build"

others=cc
! command -v clang >/dev/null || others=clang
CC=$others PYTHONHASHSEED=7 python3 tools/packaging/amalgamate.py "$work/again"
result "written again, header" cmp "$build/amalgamation/gnomon.h" "$work/again/gnomon.h"
result "written again, source" cmp "$source" "$work/again/gnomon.c"

hash_all() { "$1" --scenes "$scenes" --mathematics 2000; }
hash_all "$build/hashes" >"$work/expected"

flags="-ffreestanding -fno-math-errno -fno-stack-protector -fno-fast-math -ffp-contract=off"
warnings="-Wall -Wextra -pedantic -Werror"

# compile NAME COMPILER...: NAME.o
compile() {
    object=$work/$1.o
    shift
    "$@" -c "$source" -o "$object"
}

same_hashes() { # same_hashes NAME LINES
    # shellcheck disable=SC2046
    ${CC:-cc} -Wl,-z,noexecstack -o "$work/$1" $(hashes_objects "$build") "$work/$1.o" -lm &&
        hash_all "$work/$1" >"$work/$1.hashes" || return 1
    [ "$(wc -l <"$work/$1.hashes")" -ge "$2" ] && ! grep -v -x -F -f "$work/expected" "$work/$1.hashes"
}

# picture NAME RUNNER COMPILER... of the program
picture() {
    name=$1 run=$2
    shift 2
    "$@" -I"$build/amalgamation" "$work/triangle.c" "$work/$name.o" -Wl,-z,noexecstack -o "$work/$name-triangle" &&
        same_picture $run "$work/$name-triangle"
}

# try NAME LINES COMPILER...: LINES is the least number of hashes that there must be.
try() {
    name=$1 lines=$2
    shift 2
    result "$name: compiles" compile "$name" "$@"
    [ -f "$work/$name.o" ] || return 0
    result "$name: hashes" same_hashes "$name" "$lines"
    result "$name: the README's program" picture "$name" "" ${CC:-cc} -std=c99
    [ ! -f "$work/$name.hashes" ] || echo "amalgamation, $name: $(wc -l <"$work/$name.hashes") equal hashes"
}

present() { # present COMPILER SETUP
    command -v "$1" >/dev/null && return
    skip "amalgamation: not compiled by $1, which is absent: 'make $2' installs it"
    return 1
}

every=$(wc -l <"$work/expected")
portable=-DGN_ONLY_PORTABLE
# shellcheck disable=SC2086
{
    try gcc "$every" gcc -std=c99 $warnings -O1 $flags
    ! present clang setup || try clang 50 clang -std=c99 $warnings -O0 $portable $flags
    ! present g++ setup || try g++ 50 g++ -x c++ -std=gnu++17 -Wall -Werror -fno-exceptions -O0 $portable $flags
    ! present tcc setup-cross || try tcc 50 tcc -Wall -Werror
}
# gcc's object calls nothing outside itself.
result "gcc: no undefined symbols" [ -z "$(nm -u "$work/gcc.o")" ]

# shellcheck disable=SC2086
{
    if present aarch64-linux-gnu-gcc setup-cross && present qemu-aarch64 setup-cross; then
        result "64-bit Arm" compile arm64 aarch64-linux-gnu-gcc -std=c99 $warnings -O0 $portable $flags
        result "64-bit Arm: the README's program" picture arm64 "qemu-aarch64 -L /usr/aarch64-linux-gnu" aarch64-linux-gnu-gcc -std=c99 -static
    fi
    ! present arm-none-eabi-gcc setup-cross ||
        result "microcontroller" compile m4 arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -std=c99 $warnings -Os \
            -DGN_SMALL -DGN_BASIC $flags
}
finish
