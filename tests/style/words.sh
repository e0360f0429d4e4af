#!/bin/sh
# The words of drawing. src/kernel/draw/job.h has the way from gn_draw to a pixel and a glossary:
# - each file of the way exists and defines the functions named beside it; there are at most 30 files;
# - each word of the glossary is part of a name in the stages of drawing, and no word stands twice;
# - no name of these stages is a word that the glossary has another one for;
# - no two files of src/ have one name.
# usage: tests/style/words.sh
set -u
cd "$(dirname "$0")/../.."
text=src/kernel/draw/job.h
stages="src/kernel/draw src/kernel/geometry src/kernel/raster src/kernel/fragment"
# Words of which names of the stages consist no more, and the word that stands for them.
others='run:span strip:band part:chunk usual:less whole:in_surface solid:opaque kept_list:stored triangle_list:primitive_list'
passed=0
failed=0

result() { # result MESSAGE...: one test, which fails if there is a message
    [ $# -gt 0 ] || { passed=$((passed + 1)); return; }
    echo "words: $*" >&2
    failed=$((failed + 1))
}

# Names without comments and without what a comment of one line quotes.
names=$(mktemp)
trap 'rm -f "$names"' EXIT
find $stages -type f -exec cat {} + | awk '
    { while (match($0, /\/\*[^*]*\*\//)) $0 = substr($0, 1, RSTART - 1) substr($0, RSTART + RLENGTH) }
    /\/\*/ { sub(/\/\*.*/, ""); print; inside = 1; next }
    inside { if (!sub(/.*\*\//, "")) next; inside = 0 }
    { print }' | grep -oE '[A-Za-z_][A-Za-z_0-9]*' | sort -u >"$names"

files=0
way=$(sed -n 's/^ \*   \([a-z][a-z/_0-9]*\.\(c\|h\|inl\)\)  *\(.*\)/\1 \3/p' $text)
while read -r file functions; do
    files=$((files + 1))
    [ -f "$file" ] || file=src/$file
    [ -f "$file" ] || { result "$text: there is no $file"; continue; }
    for function in $(printf '%s\n' "$functions" | grep -oE '[a-z0-9]+(_[a-z0-9]+)+'); do
        if grep -qw "$function" "$file"; then result; else result "$text: $file has no $function"; fi
    done
done <<END
$way
END
if [ $files -ge 20 ] && [ $files -le 30 ]; then result; else result "$text: the way enters $files files, not 20 to 30"; fi

glossary=$(sed -n '/ \* Glossary/,/\*\//s/^ \*   \([a-z-]*\)  *[a-z0-9].*/\1/p' $text)
[ "$(printf '%s\n' "$glossary" | sort | uniq -d)" ] && result "$text: $(printf '%s\n' "$glossary" | sort | uniq -d) stands twice"
for word in $glossary; do
    if grep -qiE "(^|_)$(echo "$word" | tr -d -)(s|es)?(_|\$)" "$names"; then result; else result "no name has the word $word"; fi
done
for pair in $others; do
    found=$(grep -E "(^|_)${pair%%:*}s?(_|\$)" "$names" | grep -v -E 'runs_per_sample|triangle_strip|TRIANGLE_STRIP|LINE_STRIP|proof_' | tr '\n' ' ')
    if [ -z "$found" ]; then result; else result "$found: the word is ${pair#*:}"; fi
done

twice=$(find src -type f | sed 's|.*/||' | sort | uniq -d | tr '\n' ' ')
if [ -z "$twice" ]; then result; else result "two files are called $twice"; fi
echo "words: $passed passed, $failed failed"
[ $failed = 0 ]
