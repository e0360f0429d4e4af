#!/bin/sh
# Makes the lessons' web pages and tests them: the modules in Node, the pages in headless Chromium.
# usage: lessons.sh BUILD-DIRECTORY [SCREENSHOTS]   (from the root of the project; `make lessons` first)
set -u
. tests/script.sh
begin "lessons on the web"
build=$1
screenshots=${2:-}
compiler=${WEB_CC:-clang-19}
need setup-web "$compiler" wasm-ld-19 node
absent=
echo '#include <stdlib.h>' | "$compiler" --target=wasm32-wasi -fsyntax-only -x c - 2>/dev/null || absent="the C library for wasm32-wasi"
"${PYTHON:-/usr/bin/python3}" -c 'import markdown_it, pygments' 2>/dev/null || absent="python3-markdown-it or python3-pygments"
[ -z "$absent" ] || { skip "lessons on the web: $absent is absent: 'make setup-web' installs it"; finish; }
result "make web-lessons" make --no-print-directory -s BUILD="$build" web-lessons
[ "$failed" = 0 ] || finish
node tests/web/lessons.mjs "$build" || failed=1

NODE_PATH=${NODE_PATH:-$PWD/tests/web/node_modules}
export NODE_PATH
chromium=${CHROMIUM:-/usr/bin/chromium}
if [ ! -x "$chromium" ]; then
    skip "lessons on the web, in a browser: $chromium is absent: 'make setup-web' installs it"
elif ! node -e 'require("playwright-core")' 2>/dev/null; then
    skip "lessons on the web, in a browser: playwright-core is absent: 'make setup-web' installs it"
else
    # shellcheck disable=SC2086
    node tests/web/lessons_browser.mjs "$build" $screenshots || failed=1
fi
exit "$failed"
