#!/bin/sh
# Checks that the README's program compiles as it is, with warnings as errors, that it draws, and that
# it has at most 30 lines. Checks that every file that the documentation names exists.
# usage: readme.sh BUILD-DIRECTORY   (from the root of the project)
set -eu
. tests/skip.sh
failed=0
directory=$1/embed
mkdir -p "$directory"
awk -v first=1 -f tests/packaging/blocks.awk README.md >"$directory/triangle.c"
if grep -n '@[A-Z]*@' README.md; then
    echo "the README has a place that was not filled in"
    exit 1
fi
grep -hoE '`(include|src|reference|tests|tools)/[A-Za-z0-9_./]*`' README.md CONTRIBUTING.md reference/RULES.md tools/guide/*.md |
    tr -d '`' | sort -u | while read -r named; do
    [ -e "$named" ] || { echo "the documentation names $named, which is not there"; exit 1; }
done
lines=$(grep -c . "$directory/triangle.c")
[ "$lines" -le 30 ] || { echo "the README's program has $lines lines"; exit 1; }
"${CC:-cc}" -std=c99 -pedantic -Wall -Wextra -Werror -Iinclude "$directory/triangle.c" "$1/libgnomon.a" -o "$directory/triangle"
message=$("$directory/triangle" 2>&1 >"$directory/triangle.ppm")
size=$(wc -c <"$directory/triangle.ppm")
colors=$(od -An -v -tx1 -w3 -j15 "$directory/triangle.ppm" | sort -u | wc -l)
echo "README's program: $lines lines, \"$message\", $size bytes, $colors colours"
[ "$message" = "no error" ] && [ "$size" -eq 230415 ] && [ "$colors" -gt 1000 ]

# Checks that a program finds the installed library through pkg-config.
prefix=$(cd "$directory" && pwd)/installed
rm -rf "$prefix"
make -s install-library BUILD="$1" PREFIX="$prefix"
if command -v pkg-config >/dev/null; then
    flags=$(PKG_CONFIG_PATH=$prefix/lib/pkgconfig pkg-config --cflags --libs gnomon)
else
    skip "pkg-config: does not find the library, since it is absent: 'make setup' installs it"
    flags="-I$prefix/include -L$prefix/lib -lgnomon"
fi
# shellcheck disable=SC2086
"${CC:-cc}" -std=c99 "$directory/triangle.c" $flags -Wl,-rpath,"$prefix/lib" -o "$directory/installed-triangle"
"$directory/installed-triangle" 2>/dev/null | cmp - "$directory/triangle.ppm"
echo "installed through pkg-config: same picture"
echo "2 passed, $failed failed"
[ "$failed" -eq 0 ]
