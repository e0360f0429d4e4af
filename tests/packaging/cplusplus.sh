#!/bin/sh
# Compiles the library's sources as C++ too, as a C++ project may that copies them, and compares its
# pixels and mathematics with those of the C library. Plain C alone, to save time; all back ends are
# compiled without code being made.
# usage: cplusplus.sh BUILD-DIRECTORY   (from the root of the project; BUILD has hashes)
set -eu
. tests/skip.sh
cxx=${CXX:-g++}
command -v "$cxx" >/dev/null || { skip "C++: needs g++: 'make setup' installs it"; echo "0 passed, 0 failed"; exit 0; }
objects=$1/embed/cplusplus
mkdir -p "$objects"
flags="-x c++ -std=gnu++17 -Wall -Iinclude -fno-exceptions -ffp-contract=off"
failed=0

find src -name '*.c' | LC_ALL=C sort >"$objects/sources"
# shellcheck disable=SC2086
xargs -P 2 -I '{}' sh -c "$cxx $flags -O1 -DGN_ONLY_PORTABLE -c '{}' -o $objects/\$(echo '{}' | tr / _).o" \
    <"$objects/sources" || failed=1
# shellcheck disable=SC2086
for file in src/backends/*.c; do
    $cxx $flags -fsyntax-only "$file" || failed=1
done
[ "$failed" = 0 ] || { echo "C++: the library does not compile"; echo "0 passed, 1 failed"; exit 1; }

# The scenes and the mathematics are drawn by the program of C with the objects of C++.
# shellcheck disable=SC2046
"${CC:-cc}" -o "$objects/hashes" $(tr ' ' '\n' <"$1/hashes.command" | grep '\.o$' | grep -v "^$1/src/") \
    "$objects"/src_*.o -lstdc++ -lm
"$objects/hashes" --scenes 560 --mathematics 2000 | grep -v -e ' sse2 ' >"$objects/cplusplus.txt"
"$1/hashes" --scenes 560 --mathematics 2000 | grep -v -e ' sse2 ' -e ' avx2 ' -e ' avx512 ' -e ' neon ' >"$objects/c.txt"
if [ "$(wc -l <"$objects/c.txt")" -gt 50 ] && cmp -s "$objects/cplusplus.txt" "$objects/c.txt"; then
    echo "C++: $(wc -l <"$objects/c.txt") equal hashes of pictures and of the mathematics"
    echo "1 passed, 0 failed"
else
    diff "$objects/cplusplus.txt" "$objects/c.txt" | head -n 5
    echo "0 passed, 1 failed"
    exit 1
fi
