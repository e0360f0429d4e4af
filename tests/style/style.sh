#!/bin/sh
# Checks that all C files have one style. clang-format (.clang-format) decides layout and braces: a
# body of one statement has no braces, and the branches of an `if` have all braces or none.
# style.awk decides the rest: `++i`, not `i++`, if nothing uses the value; a file includes first the
# header that it implements, then <> of the system and of libraries, then <gnomon/...>, then "" of
# the project. Only clang-format 14, Debian 12's, is used: other versions format a file otherwise.
# usage: tests/style/style.sh [--fix]    --fix rewrites the files, as far as a script can
set -u
cd "$(dirname "$0")/../.."
. tests/skip.sh
failed=0
passed=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP

format=
for tool in clang-format-14 clang-format; do
    [ -n "$format" ] || ! $tool --version 2>/dev/null | grep -q 'version 14\.' || format=$tool
done
[ -n "$format" ] || skip "style: layout is not looked at, since clang-format 14 is absent: 'make setup' installs it"

# Writes all files as they should be to a directory of their own.
files=$(find include src reference tests tools -name '*.c' -o -name '*.h' -o -name '*.inl' -o -name '*.cpp' | grep -v '^tools/python/build/' | sort)
dirname $files | sort -u | sed "s|^|$work/|" | xargs mkdir -p
# libtheft's header may come from the system.
own=$(printf '%s\n' $files | sed -n '/^include/d; /\/theft\.h$/d; s|.*/\(.*\.h\)$|\1|p' | sort -u | tr '\n' ' ')
awk -v own="$own" -v to="$work" -f tests/style/style.awk $files
cp .clang-format "$work/"
[ -z "$format" ] || (cd "$work" && $format -i $files)

for file in $files; do
    if cmp -s "$file" "$work/$file"; then
        passed=$((passed + 1))
    elif [ "${1:-}" = --fix ]; then
        cat "$work/$file" >"$file"
        echo "fixed: $file"
    else
        echo "$file is not in style; tests/style/style.sh --fix makes it:" >&2
        diff -U 0 "$file" "$work/$file" | sed -n '3,12p' >&2
        failed=$((failed + 1))
    fi
done

# Finds what clang-format does not: an `if` with braces at some branches only.
mixed=$(grep -nE '^ *else( if .*)? \{$|^ *\} else$|^ *\} else if .*\)$' -r include src reference tests tools \
    --include='*.[ch]' --include='*.inl' --include='*.cpp')
if [ -n "$mixed" ]; then
    echo "branches with braces beside some without, which no script mends:" >&2
    printf '%s\n' "$mixed" | sed 's/^/    /' >&2
    failed=$((failed + 1))
fi
echo "style: $passed passed, $failed failed"
[ "$failed" = 0 ]
