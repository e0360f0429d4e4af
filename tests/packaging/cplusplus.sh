#!/bin/sh
# Compiles the library's sources as C++ too, as a C++ project may that copies them, and compares its
# pixels and mathematics with those of the C library. Plain C alone, unoptimised, to save time; all
# back ends are compiled without code being made.
# usage: cplusplus.sh BUILD-DIRECTORY   (from the root of the project; BUILD has hashes)
set -eu
. tests/packaging/packaging.sh
begin C++ "$1/embed/cplusplus"
cxx=${CXX:-g++}
need setup "$cxx"
flags="-x c++ -std=gnu++17 -Wall -Iinclude -fno-exceptions -ffp-contract=off"
# shellcheck disable=SC2086
result "C++: the library compiles" sh -c 'find src -name "*.c" | LC_ALL=C sort |
    xargs -P 2 -I "{}" sh -c "$2 -O0 -DGN_ONLY_PORTABLE -c {} -o $1/\$(echo {} | tr / _).o"' - "$work" "$cxx $flags"
for file in src/backends/*.c; do
    # shellcheck disable=SC2086
    result "C++: $file compiles" $cxx $flags -fsyntax-only "$file"
done
[ "$failed" = 0 ] || finish

# The scenes and the mathematics are drawn by the program of C with the objects of C++.
# shellcheck disable=SC2046
${CC:-cc} -o "$work/hashes" $(hashes_objects "$1") "$work"/src_*.o -lstdc++ -lm
list() { # list PROGRAM: the hashes of portable C
    "$1" --scenes 560 --mathematics 2000 | grep -v -e ' sse41 ' -e ' avx2 ' -e ' avx512 ' -e ' neon '
}
list "$work/hashes" >"$work/of-cplusplus"
list "$1/hashes" >"$work/of-c"
result "C++: more than 50 hashes" [ "$(wc -l <"$work/of-c")" -gt 50 ]
result "C++: equal hashes of pictures and of the mathematics" cmp "$work/of-c" "$work/of-cplusplus"
finish
