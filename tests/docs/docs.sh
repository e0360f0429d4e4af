#!/bin/sh
# Tests `make docs`: Doxygen has nothing to warn of; links and anchors of all pages lead somewhere; nothing is
# loaded from a network; every name of the public headers is documented; public headers name no file that an
# embedder does not have. What breaks one of these is found.
# usage: docs.sh   (from the root of the project)
set -u
. tests/skip.sh
. tests/result.sh
python=${PYTHON:-/usr/bin/python3}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP

if ! command -v doxygen >/dev/null || ! "$python" -c 'import markdown_it, pygments' 2>/dev/null; then
    skip "documentation: needs doxygen, python3-markdown-it and python3-pygments: 'make setup' installs them"
    echo "docs: $passed passed, $failed failed"
    exit "$failed"
fi
# A copy, so that the test and `make docs` do not meet, and so that it can be changed.
tests=$PWD/tests/docs
cp -r include reference tests tools ./*.md "$work/"
cd "$work" || exit 1
echo GENERATE_XML = YES >>tools/docs/Doxyfile
result "the site is made" "$python" tools/docs/site.py build
result "links and anchors" "$python" "$tests/links.py" build/docs/html
tail -n 1 said

"$python" "$tests/pages.py" build/docs/html >found
result "titles, contents, the menu and the index of the search: $(cat found)" test ! -s found
sed -i 's|<title>6\. |<title>6.|' build/docs/html/tools_examples_06_z_buffer.html
sed -i 's| aria-current="page"||' build/docs/html/tools_guide_threads.html
sed -i 's|<nav class="contents"|<nav|' build/docs/html/reference_RULES.html
sed -i 's|"tools_guide_speed.html|"nowhere.html|g' build/docs/html/search_index.js
"$python" "$tests/pages.py" build/docs/html >found
for fault in 06_z_buffer.html:.title threads.html:.menu RULES.html:.contents speed.html:.search; do
    result "a fault of a page is found: $fault" grep -q "$fault" found
done

"$python" "$tests/undocumented.py" build/docs/xml >names
result "every name is documented" test -z "$(cat names)"
${CC:-cc} -E -P -Iinclude include/gnomon.h | grep -oE '\bgn_[a-z0-9_]*[a-z0-9] ?\(' | tr -d ' (' | sort -u |
    grep -v '^gn_draw_of_one_lane$' >functions
result "there are functions" test "$(wc -l <functions)" -ge 250
sed -n 's|.*<name>\(.*\)</name>|\1|p' build/docs/names.xml | sort -u | comm -13 - functions >absent
result "every function is in the reference" diff /dev/null absent

cited() { grep -rnE '(^|[^a-z0-9_./-])(src|reference|tests|tools)/[a-z0-9]' include; }
cited >names
result "public headers name no file of the project's own" test -z "$(cat names)"

# What a page would not have.
rm build/docs/html/vec_8h.html
sed -i 's|<img src="teapot.png"|<img src="https://example.org/teapot.png"|' build/docs/html/index.html
printf '<a href="draw_8h.html#nowhere">' >>build/docs/html/index.html
"$python" "$tests/links.py" build/docs/html >found
result "a missing file is found" grep -q 'vec_8h.html: no such file' found
result "a missing anchor is found" grep -q 'draw_8h.html#nowhere: no such anchor' found
result "what would be loaded is found" grep -q 'teapot.png: loaded from a network' found

# Names without a comment, and a row of a table that is lost.
sed -i 's|^GN_END|\nGN_API float gn_without(float x);\n&|' include/gnomon/vec.h
sed -i 's|^    uint32_t vertex_count;|    uint32_t without;\n&|; s|^    GN_INDEX_UINT8,|    GN_INDEX_WITHOUT,\n&|' include/gnomon/draw.h
sed -i 's|^GN_BEGIN|#define GN_WITHOUT 1\ntypedef struct gn_bare {\n    int member; /**< one */\n} gn_bare;\n\n&|' include/gnomon/ray.h
sed -i 's|^/\*\* An instruction set\.|&\n *     a row|' include/gnomon/backend.h
{ cat tools/docs/Doxyfile && echo GENERATE_HTML = NO; } >Doxyfile
GN_DOCS=build/docs doxygen Doxyfile && "$python" "$tests/undocumented.py" build/docs/xml >names
sed -i 's|^/\*\* An instruction set\.|& See src/draw/draw.c.|' include/gnomon/backend.h
cited >cited
result "a header that names a file is found" grep -q 'backend.h:[0-9]*:.*src/draw/draw.c' cited
for name in gn_without without GN_INDEX_WITHOUT GN_WITHOUT gn_bare ' \*     a row.*'; do
    result "found: $name" grep -qx "$name" names
done
sed -i 's|^/\*\* Returns a + b|/** @nothing|' include/gnomon/vec.h
result "what Doxygen does not understand: it fails" sh -c '! "$0" tools/docs/site.py build >log 2>&1' "$python"
result "its warning is shown" grep -q "vec.h:[0-9]*: .*nothing" log
printf '\n[lost](nowhere.md)\n' >>tools/python/README.md
result "a link that leads nowhere: it fails" sh -c '! "$0" tools/docs/site.py build >log 2>&1' "$python"
result "a link that leads nowhere is named" grep -q 'README.md:[0-9]*: nowhere.md is no page' log

echo "docs: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
