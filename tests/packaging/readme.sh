#!/bin/sh
# Checks that the README's program compiles as it is, with warnings as errors, that it draws, and that
# it has at most 30 lines; and that every file that the documentation names exists.
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
result "it compiles without warnings" ${CC:-cc} -std=c99 -pedantic -Wall -Wextra -Werror -Iinclude -fsyntax-only "$work/triangle.c"
message=$("$work/triangle" 2>&1 >"$work/triangle.ppm")
size=$(wc -c <"$work/triangle.ppm")
colors=$(od -An -v -tx1 -w3 -j15 "$work/triangle.ppm" | sort -u | wc -l)
echo "README's program: $lines lines, \"$message\", $size bytes, $colors colours"
result "it draws" [ "$message" = "no error" -a "$size" -eq 230415 -a "$colors" -gt 1000 ]
finish
