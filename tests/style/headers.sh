#!/bin/sh
# Checks that every header compiles alone: a file that includes it needs nothing before it. A header
# that cannot compile alone says so in its first comment, by a sentence that begins a line:
# " * Not alone: the reason.". A header that says so and compiles alone fails too.
#
# usage: tests/style/headers.sh [HEADER...]        without arguments, all headers of the project
set -eu
cd "$(dirname "$0")/../.."

paths='-Iinclude -Ireference/scene -Ireference/osmesa -Ireference/exact -Itests/accuracy -Itests/parity -Itests/property/theft -Itools/models -Itools/gnomon -Itools/explain -Itools/ranks'
warnings='-Wall -Wextra -Wshadow -Werror -Wno-unused-function'

says_why() { awk '/^ \* Not alone: ./ { found = 1 } /\*\// { exit } END { exit !found }' "$1"; }

compiles() {
    case $1 in
    include/* | src/*) standard=c99 ;;
    *) standard=c11 ;;
    esac
    # shellcheck disable=SC2086
    printf '#include "%s"\ntypedef int not_empty;\n' "$PWD/$1" |
        ${CC:-cc} -std=$standard -pedantic -D_POSIX_C_SOURCE=200809L $warnings $paths \
            -fno-fast-math -ffp-contract=off -fsyntax-only -x c - 2>"$errors"
}

errors=$(mktemp)
trap 'rm -f "$errors"' EXIT
trap 'exit 1' INT TERM HUP
[ $# -gt 0 ] || set -- $(find include src reference tests tools -name '*.h' -o -name '*.inl' | sort)

alone=0
excused=0
faults=0
for header; do
    if compiles "$header"; then
        alone=$((alone + 1))
        says_why "$header" || continue
        echo "$header: compiles alone, but its first comment says \"Not alone\"" >&2
    elif says_why "$header"; then
        excused=$((excused + 1))
        continue
    else
        sed 1q "$errors" >&2
        grep -m 1 'error' "$errors" >&2 || :
        echo "$header: does not compile alone, and no line of its first comment begins with \"Not alone:\" and the reason" >&2
    fi
    faults=$((faults + 1))
done
echo "headers: $alone compile alone, $excused say why they do not, $faults wrong"
[ $faults = 0 ]
