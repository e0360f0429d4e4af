#!/bin/sh
# Compiles the library as one file (`make amalgamation`) with gcc, clang, tcc and g++, without a
# warning, and compares its pixels and mathematics with those of the library as built. The README's
# program is then compiled beside it with no other header than its gnomon.h. The files must not
# depend on the machine that writes them: another compiler and another order of Python's sets write
# the same bytes. To save time, the everyday gate compiles every back end with gcc alone; --all
# compiles every back end with all compilers, small libraries, and those of other machines.
# usage: amalgamation.sh BUILD-DIRECTORY [--all]   (from the root of the project; BUILD has hashes)
set -eu
. tests/skip.sh
build=$1
all=${2:-}
scenes=220
[ "$all" != --all ] || scenes=2000
directory=$build/embed/amalgamation
source=$build/amalgamation/gnomon.c
passed=0
failed=0
rm -rf "$directory"
mkdir -p "$directory"
command -v python3 >/dev/null || { skip "amalgamation: needs python3: 'make setup' installs it"; echo "0 passed, $failed failed"; exit "$failed"; }
${MAKE:-make} -s amalgamation BUILD="$build"

result() { # result WHAT COMMAND...
    what=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: amalgamation, $what"
    fi
}

others=cc
! command -v clang >/dev/null || others=clang
CC=$others PYTHONHASHSEED=7 python3 tools/packaging/amalgamate.py "$directory/again"
result "written again, header" cmp "$build/amalgamation/gnomon.h" "$directory/again/gnomon.h"
result "written again, source" cmp "$source" "$directory/again/gnomon.c"

"$build/hashes" --scenes "$scenes" --mathematics 2000 >"$directory/expected"
awk -v first=1 -f tests/packaging/blocks.awk README.md >"$directory/triangle.c"
"${CC:-cc}" -std=c99 -Iinclude "$directory/triangle.c" "$build/libgnomon.a" -o "$directory/triangle"
"$directory/triangle" >"$directory/triangle.ppm" 2>/dev/null
tr ' ' '\n' <"$build/hashes.command" | grep '\.o$' | grep -v "^$build/src/" >"$directory/objects"

flags="-ffreestanding -fno-math-errno -fno-stack-protector -fno-fast-math -ffp-contract=off"
warnings="-Wall -Wextra -pedantic -Werror"

# compile NAME COMPILER...: NAME.o
compile() {
    object=$directory/$1.o
    shift
    "$@" -c "$source" -o "$object"
}

same_hashes() { # same_hashes NAME LINES
    # shellcheck disable=SC2046
    "${CC:-cc}" -Wl,-z,noexecstack -o "$directory/$1" $(cat "$directory/objects") "$directory/$1.o" -lm &&
        "$directory/$1" --scenes "$scenes" --mathematics 2000 >"$directory/$1.hashes" || return 1
    [ "$(wc -l <"$directory/$1.hashes")" -ge "$2" ] && ! grep -v -x -F -f "$directory/expected" "$directory/$1.hashes"
}

same_picture() { # same_picture NAME COMPILER... of the program
    name=$1
    shift
    "$@" -I"$build/amalgamation" "$directory/triangle.c" "$directory/$name.o" -Wl,-z,noexecstack -o "$directory/$name-triangle" &&
        $run "$directory/$name-triangle" 2>/dev/null | cmp - "$directory/triangle.ppm"
}
run=

# try NAME LINES COMPILER...: LINES is the least number of hashes that there must be.
try() {
    name=$1
    lines=$2
    shift 2
    result "$name: compiles" compile "$name" "$@"
    [ -f "$directory/$name.o" ] || return 0
    result "$name: hashes" same_hashes "$name" "$lines"
    result "$name: the README's program" same_picture "$name" "${CC:-cc}" -std=c99
    [ ! -f "$directory/$name.hashes" ] || echo "amalgamation, $name: $(wc -l <"$directory/$name.hashes") equal hashes"
}

present() { # present COMPILER SETUP
    command -v "$1" >/dev/null && return
    skip "amalgamation: not compiled by $1, which is absent: 'make $2' installs it"
    return 1
}

every=$(wc -l <"$directory/expected")
fewer=-DGN_ONLY_PORTABLE
some=50
if [ "$all" = --all ]; then
    fewer=
    some=$every
fi
# shellcheck disable=SC2086
{
    try gcc "$every" gcc -std=c99 $warnings -O1 $flags
    ! present clang setup || try clang "$some" clang -std=c99 $warnings -O1 $fewer $flags
    ! present g++ setup || try g++ "$some" g++ -x c++ -std=gnu++17 -Wall -Werror -fno-exceptions -O1 $fewer $flags
    ! present tcc setup-cross || try tcc 50 tcc -Wall -Werror
}
# gcc's object calls nothing outside itself.
result "gcc: no undefined symbols" [ -z "$(nm -u "$directory/gcc.o")" ]

if [ "$all" = --all ]; then
    # shellcheck disable=SC2086
    {
        try small 50 gcc -std=c99 $warnings -Os -DGN_SMALL $flags
        try fast-mathematics "$every" gcc -std=c99 $warnings -O2 -ffast-math -march=native $flags
        result "clang++" compile clang++ clang++ -x c++ -std=c++17 -Wall -Wno-c99-designator -O0 $fewer $flags
        if present aarch64-linux-gnu-gcc setup-cross && present qemu-aarch64 setup-cross; then
            run="qemu-aarch64 -L /usr/aarch64-linux-gnu"
            result "64-bit Arm" compile arm64 aarch64-linux-gnu-gcc -std=c99 $warnings -O1 $flags
            result "64-bit Arm: the README's program" same_picture arm64 aarch64-linux-gnu-gcc -std=c99 -static
        fi
        ! present arm-none-eabi-gcc setup-cross ||
            result "microcontroller" compile m4 arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -std=c99 $warnings -Os \
                -DGN_SMALL -DGN_BASIC $flags
    }
fi
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
