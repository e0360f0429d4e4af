#!/bin/sh
# Tests `make docs`: Doxygen has nothing to warn of; links and anchors of all pages lead somewhere;
# nothing is loaded from a network; every function of the public headers has an entry. What has no
# documentation, and a link that leads nowhere, must make it fail. The filter of the headers' comments
# is tested on sample.h.
# usage: docs.sh BUILD-DIRECTORY [--print]   (from the root of the project); --print prints what the
# filter makes of sample.h, for sample.txt
set -u
. tests/skip.sh
. tests/result.sh
internal=$(sed -n "s|.*-v 'internal=\([^']*\)'.*|\1|p" tools/docs/Doxyfile)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP

filter() { # filter OPTION... HEADER
    awk -v internal="$internal" "$@"
}

filter -v list=1 -f tools/docs/comments.awk tests/docs/sample.h >"$work/names"
filter -v names="$work/names" -f tools/docs/comments.awk tests/docs/sample.h >"$work/filtered" 2>"$work/errors"
if [ "${2:-}" = --print ]; then
    cat "$work/filtered"
    exit
fi
result "the filter: sample.h becomes sample.txt" diff tests/docs/sample.txt "$work/filtered"
result "the filter: no error" test ! -s "$work/errors"
result "the filter: lines keep their numbers" test "$(wc -l <"$work/filtered")" -eq "$(wc -l <tests/docs/sample.h)"
for header in include/gnomon.h include/gnomon/*.h; do
    filter -f tools/docs/comments.awk "$header" >"$work/header" 2>/dev/null
    [ "$(wc -l <"$work/header")" -eq "$(wc -l <"$header")" ] || echo "$header"
done >"$work/moved"
result "the filter: lines of all headers keep their numbers" test ! -s "$work/moved"

if ! command -v doxygen >/dev/null || ! command -v python3 >/dev/null; then
    skip "documentation: the site is not made, since doxygen or python3 is absent: 'make setup' installs them"
    echo "docs: $passed passed, $failed failed"
    [ "$failed" -eq 0 ]
    exit
fi

# A copy, so that the test and `make docs` do not meet, and so that it can be changed.
copy=$work/copy
mkdir -p "$copy/tests"
cp -r include reference tools ./*.md "$copy/"
cp -r tests/lessons "$copy/tests/"
cd "$copy" || exit 1
result "the site is made" tools/docs/site.sh build
# Functions as the compiler sees them, without the bodies of inline ones and what users never name.
functions=$("${CC:-cc}" -E -P -Iinclude include/gnomon.h | awk '
    { for (i = 1; i <= length($0); ++i) {
        c = substr($0, i, 1)
        depth += c == "{"
        if (!depth) text = text c
        depth -= c == "}"
        if (c == "}" && !depth) text = text ";" }
      text = text " " }
    END { print text }' | grep -oE '\bgn_[a-z0-9_]*[a-z0-9] ?\(' | tr -d ' (' | sort -u | grep -v '^gn_draw_of_one_lane$')
result "there are functions" test "$(echo "$functions" | wc -l)" -ge 250
# shellcheck disable=SC2086
result "links, anchors, entries" python3 "$OLDPWD/tests/docs/links.py" build/docs/html $functions
echo "$(tail -n 1 "$work/said"), $(echo "$functions" | wc -l) functions"

# What a page would not have.
rm build/docs/html/vec_8h.html
sed -i 's|<img src="teapot.png"|<img src="https://example.org/teapot.png"|' build/docs/html/index.html
printf '<a href="draw_8h.html#nowhere">' >>build/docs/html/index.html
python3 "$OLDPWD/tests/docs/links.py" build/docs/html gn_vec3_add >"$work/found"
result "a missing file is found" grep -q 'vec_8h.html: no such file' "$work/found"
result "a missing anchor is found" grep -q 'draw_8h.html#nowhere: no such anchor' "$work/found"
result "what would be loaded is found" grep -q 'teapot.png: loaded from a network' "$work/found"
result "a missing entry is found" grep -q '^gn_vec3_add: has no entry' "$work/found"

# Names without a comment.
sed -i 's|^GN_END|\nGN_API float gn_without(float x);\n&|' include/gnomon/vec.h
sed -i 's|^    uint32_t vertex_count;|    uint32_t without;\n&|; s|^    GN_INDEX_UINT8,|    GN_INDEX_WITHOUT,\n&|' include/gnomon/draw.h
sed -i 's|^GN_BEGIN|#define GN_WITHOUT 1\ntypedef struct gn_bare {\n    int member; /* one */\n} gn_bare;\n\n&|' include/gnomon/ray.h
result "names without a comment: it fails" sh -c '! tools/docs/site.sh build >log 2>&1'
for name in gn_without without GN_INDEX_WITHOUT GN_WITHOUT gn_bare; do
    result "without a comment: $name" grep -qE "[^A-Za-z_]$name[^A-Za-z_].*(not documented|no comment)" log
done
printf '\n[lost](nowhere.md)\n' >>tools/python/README.md
result "a link that leads nowhere: it fails" sh -c '! tools/docs/site.sh build >log 2>&1'
result "a link that leads nowhere is named" grep -q 'README.md:[0-9]*: nowhere.md is no page' log

echo "docs: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
