#!/bin/sh
# Makes the lessons' web pages and tests them: the modules in Node, the pages in headless Chromium.
# usage: lessons.sh BUILD-DIRECTORY [SCREENSHOTS]   (from the root of the project; `make lessons` first)
set -u
. tests/skip.sh
build=$1
screenshots=${2:-}
failed=0

none() { # none WHAT: nothing can be tested
    skip "lessons on the web: $1: 'make setup-web' installs it"
    echo "0 passed, $failed failed"
    exit "$failed"
}

compiler=${WEB_CC:-clang-19}
for tool in "$compiler" wasm-ld-19 node; do
    command -v "$tool" >/dev/null 2>&1 || none "$tool is absent"
done
echo '#include <stdlib.h>' | "$compiler" --target=wasm32-wasi -fsyntax-only -x c - 2>/dev/null ||
    none "the C library for wasm32-wasi is absent"
"${PYTHON:-/usr/bin/python3}" -c 'import markdown_it, pygments' 2>/dev/null || none "python3-markdown-it or python3-pygments is absent"

make --no-print-directory -s BUILD="$build" web-lessons >/dev/null || {
    echo "FAILED: make web-lessons"
    echo "0 passed, 1 failed"
    exit 1
}
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
