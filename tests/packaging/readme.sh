#!/bin/sh
# Checks that the README's program compiles as it is, with warnings as errors, that it draws, and that
# it has at most 30 lines; that a program finds the installed library through pkg-config; and that
# every file that the documentation names exists.
# usage: readme.sh BUILD-DIRECTORY   (from the root of the project)
set -eu
. tests/packaging/packaging.sh
begin README "$1/embed/readme"
readme_program "$1"
result "the README has no place that was not filled in" sh -c "! grep -n '@[A-Z]*@' README.md"
grep -hoE '`(include|src|reference|tests|tools)/[A-Za-z0-9_./]*`' README.md CONTRIBUTING.md reference/RULES.md tools/guide/*.md |
    tr -d '`' | sort -u | while read -r named; do [ -e "$named" ] || echo "$named"; done >"$work/absent"
result "the files that the documentation names: $(cat "$work/absent")" [ ! -s "$work/absent" ]
lines=$(grep -c . "$work/triangle.c")
result "the README's program has $lines lines" [ "$lines" -le 30 ]
result "it compiles without warnings" "${CC:-cc}" -std=c99 -pedantic -Wall -Wextra -Werror -Iinclude -fsyntax-only "$work/triangle.c"
message=$("$work/triangle" 2>&1 >"$work/triangle.ppm")
size=$(wc -c <"$work/triangle.ppm")
colors=$(od -An -v -tx1 -w3 -j15 "$work/triangle.ppm" | sort -u | wc -l)
echo "README's program: $lines lines, \"$message\", $size bytes, $colors colours"
result "it draws" [ "$message" = "no error" -a "$size" -eq 230415 -a "$colors" -gt 1000 ]

prefix=$work/installed
make -s install-library BUILD="$1" PREFIX="$prefix"
if command -v pkg-config >/dev/null; then
    flags=$(PKG_CONFIG_PATH=$prefix/lib/pkgconfig pkg-config --cflags --libs gnomon)
else
    skip "pkg-config: does not find the library, since it is absent: 'make setup' installs it"
    flags="-I$prefix/include -L$prefix/lib -lgnomon"
fi
# shellcheck disable=SC2086
result "it is linked with the installed library" "${CC:-cc}" -std=c99 "$work/triangle.c" $flags -Wl,-rpath,"$prefix/lib" -o "$work/by-pkg-config"
result "installed: same picture" same_picture "$work/by-pkg-config"
finish
