#!/bin/sh
# Writes the documentation as one site of plain HTML, which opens from disk: BUILD/docs/html/index.html.
# It has the guide, the lessons, the documents and the reference of the public headers. Doxygen makes it
# from pages that this script prepares: links lead to pages of the site, and a file of source text that a
# page links to becomes a page. Doxygen's warnings are errors.
# usage: site.sh BUILD-DIRECTORY   (from the root of the project)
set -eu
[ $# -eq 1 ] && [ "$1" != --help ] || { sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"; exit 2; }
command -v doxygen >/dev/null || { echo "docs: Doxygen is absent: 'make setup' installs it" >&2; exit 1; }
tools=tools/docs
GN_DOCS=$1/docs
export GN_DOCS
rm -rf "$GN_DOCS"
mkdir -p "$GN_DOCS/pages"

# The files of a folder in the order in which its contents page links to them, then the others.
in_order() { # in_order FOLDER
    {
        grep -o '](\([a-z0-9_-]*\.md\))' "$1/README.md" | sed "s|](\(.*\))|$1/\1|"
        ls "$1"/*.md
    } | grep -v '/README\.md$' | awk '!seen[$0]++'
}

# page_id FILE: the name of its page, without .html.
page_id() {
    case $1 in
    README.md) echo index ;;
    tools/guide/README.md) echo guide ;;
    tools/examples/README.md) echo lessons ;;
    tools/python/README.md) echo python ;;
    tools/guide/*.md) echo "guide_$(basename "$1" .md)" ;;
    tools/examples/*.md) echo "lesson_$(basename "$1" .md)" ;;
    *.md) basename "$1" .md | tr '[:upper:]' '[:lower:]' ;;
    *) echo "source_$1" | tr -c 'A-Za-z0-9_\n' _ ;;
    esac
}

guide=$(in_order tools/guide)
lessons=$(in_order tools/examples)
documents="README.md tools/guide/README.md $guide tools/examples/README.md $lessons
    tools/python/README.md tools/gnomon/TRANSFORM.md reference/RULES.md VERIFICATION.md CONTRIBUTING.md CHANGELOG.md"

# Source texts that documents link to, as paths from the root.
sources=$(for document in $documents; do
    grep -o '](\([^)#:]*\.[a-z]*\))' "$document" | sed 's/](\(.*\))/\1/' | grep -v '\.\(md\|png\|svg\)$' |
        while read -r link; do realpath -m --relative-to=. "$(dirname "$document")/$link"; done
done | grep -v '^include/' | sort -u)

for file in $documents $sources; do
    echo "$file $(page_id "$file")"
done >"$GN_DOCS/pages.txt"
internal=$(sed -n "s|.*-v 'internal=\([^']*\)'.*|\1|p" $tools/Doxyfile)
headers="include/gnomon.h $(ls include/gnomon/*.h)"
# shellcheck disable=SC2086
{
    awk -v internal="$internal" -v list=1 -f $tools/comments.awk $headers
    basename -a $headers
} >"$GN_DOCS/names"

for file in $documents; do
    awk -v path="$file" -v names="$GN_DOCS/names" -v pages="$GN_DOCS/pages.txt" -f $tools/page.awk "$file" \
        >"$GN_DOCS/pages/$(page_id "$file").md"
done
for file in $sources; do
    printf '# %s {#%s}\n\n~~~{.%s}\n' "$file" "$(page_id "$file")" "${file##*.}"
    cat "$file"
    printf '~~~\n'
done | awk -v folder="$GN_DOCS/pages/" '/^# .* \{#source_[A-Za-z0-9_]*\}$/ {
        file = $0; sub(/.*\{#/, "", file); sub(/\}$/, "", file); file = folder file ".md" } { print > file }'

# The menu

# link PAGE TEXT
link() { printf '<li><a href="%s.html">%s</a></li>\n' "$1" "$2"; }
title() { sed -n 's/^# //p' "$1" | head -n 1 | tr -d '`' | sed 's/&/\&amp;/g; s/</\&lt;/g'; }
section() { # section TITLE PAGE FILE...
    printf '<details open><summary>%s</summary><ul>\n' "$1"
    [ -z "$2" ] || link "$2" Contents
    shift 2
    for file; do link "$(page_id "$file")" "$(title "$file")"; done
    printf '</ul></details>\n'
}
# Rows of gnomon.h's first comment: header, what it is about. A name that Doxygen gives a page has `__`
# for `_` and `_8` for a full stop.
reference() {
    printf '<details open><summary>Reference</summary><ul>\n'
    link gnomon_8h 'gnomon.h: all headers'
    sed -n '/\*\//q; s/^ \*   \([a-z_]*\.h\)  *\(.*\)/\1 \2/p' include/gnomon.h | while read -r header about; do
        link "$(echo "$header" | sed 's/_/__/g; s/\./_8/')" "<code>$header</code> $(echo "$about" | sed 's/&/\&amp;/g; s/</\&lt;/g')"
    done
    link globals_func 'All functions'
    link annotated 'All structs'
    link globals 'All names'
    printf '</ul></details>\n'
}
{
    sed '/@MENU@/,$d' $tools/header.html
    link index Gnomon | sed 's/<.\?li>//g'
    # shellcheck disable=SC2086
    section Guide guide $guide
    # shellcheck disable=SC2086
    section Lessons lessons $lessons
    reference
    section More '' tools/python/README.md tools/gnomon/TRANSFORM.md reference/RULES.md VERIFICATION.md CONTRIBUTING.md CHANGELOG.md
    sed '1,/@MENU@/d' $tools/header.html
} >"$GN_DOCS/header.html"

{
    cat $tools/Doxyfile
    printf 'INPUT = %s include\n' "$GN_DOCS/pages"
    printf 'RECURSIVE = YES\nFILE_PATTERNS = *.h *.md\nOUTPUT_DIRECTORY = %s\n' "$GN_DOCS"
    printf 'STRIP_FROM_PATH = include\nSTRIP_FROM_INC_PATH = include\n'
} >"$GN_DOCS/Doxyfile"
if ! doxygen "$GN_DOCS/Doxyfile" >"$GN_DOCS/log.txt" 2>&1 || [ -s "$GN_DOCS/log.txt" ]; then
    cat "$GN_DOCS/log.txt" >&2
    echo "docs: $(grep -c . "$GN_DOCS/log.txt") lines of warnings" >&2
    exit 1
fi
echo "$GN_DOCS/html/index.html"
