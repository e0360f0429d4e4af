#!/bin/sh
# Checks tools/examples/from_your_course.md. Its blocks of C are one program; it must print what stands
# behind `//`, line by line. Each number in the sentences of a section must be one of its block's
# numbers, and each name of the library must stand in a public header.
# usage: course.sh BUILD-DIRECTORY [--print]   (from the root of the project); --print prints the
# page with what its program prints
set -u
. tests/script.sh
begin "from your course to Gnomon"
page=tools/examples/from_your_course.md

{
    printf '#include "course.h"\n#include <string.h>\nint main(void)\n{\n'
    awk -f tests/packaging/blocks.awk "$page"
    printf 'return 0;\n}\n'
} >"$work/course.c"
result "the page compiles in C99" ${CC:-cc} -std=c99 -pedantic -Wall -Wextra -Werror -Iinclude -Itests/lessons \
    "$work/course.c" "$1/libgnomon.a" -o "$work/course"
result "the page's program runs" sh -c '"$1" >"$2"' - "$work/course" "$work/printed"

if [ "${2:-}" = --print ]; then
    awk -v printed="$work/printed" '
        /^```/ { on = /^```c$/ }
        on && sub(/\/\/.*/, "") { getline line < printed; $0 = $0 "// " line }
        { print }' "$page"
    exit
fi

# What stands behind `//` in blocks; at least one line in each block.
awk '/^```/ { if (on && !seen) print "a block shows nothing"; on = /^```c$/; seen = 0 }
    on && sub(/.*\/\/ ?/, "") { print; seen = 1 }' "$page" >"$work/shown"
result "the page shows what its program prints" diff "$work/shown" "$work/printed"

# Numbers stand alone, and not in names or paths: 0.5f and -1 are numbers, vec3 and D24 are none.
numbers='
    function numbers(text, section, found,    part, n, i) {
        gsub(/\([a-z0-9_.\/]*\.(md|h)\)/, " ", text)
        gsub(/[A-Za-z_][A-Za-z0-9_]*/, " ", text)
        n = split(text, part, /[^0-9.]+/)
        for (i = 1; i <= n; ++i) {
            sub(/\.$/, "", part[i])
            if (part[i] ~ /^[0-9]/) found[section, part[i] + 0] = FNR
        }
    }
    /^## / { ++section; sub(/^## [0-9]+\./, "") }
    /^```/ { code = /^```c$/; next }
    section && code { gsub(/f\>/, " "); gsub(/\.f/, "."); numbers($0, section, known) }
    section && !code { gsub(/Lesson [0-9]+/, ""); gsub(/Direct3D/, ""); numbers($0, section, said) }
    END {
        for (key in said) {
            ++count
            split(key, part, SUBSEP)
            if (!(key in known)) { print "line " said[key] ": " part[2] " is not in the block"; bad = 1 }
        }
        if (section < 10 || count < 25) { print section " sections, " count " numbers"; bad = 1 }
        exit bad
    }'
result "the numbers of its sentences are its program's" awk "$numbers" "$page"

grep -oE '\b(gn|GN)_[A-Za-z0-9_]+' "$page" | sort -u >"$work/names"
names_exist() {
    absent=$(while read -r name; do grep -qw "$name" include/gnomon/*.h || echo "$name"; done <"$work/names")
    [ -z "$absent" ] || { echo "no header has" $absent; return 1; }
}
result "its names stand in the headers" names_exist
result "it names functions" test "$(grep -c . "$work/names")" -ge 30
result "the index of lessons links to it" grep -q '](from_your_course\.md)' tools/examples/README.md
result "at most 230 lines" test "$(grep -c '' "$page")" -le 230
finish
