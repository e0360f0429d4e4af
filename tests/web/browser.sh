#!/bin/sh
# Tests the web page and the search of `make docs` in headless Chromium, and what the page is made of in Node.
# Screenshots are kept in BUILD/web-screenshots. What the page shows of a pixel is compared with what
# BUILD/gnomon prints; browser.mjs says so if that is absent.
# usage: browser.sh BUILD-DIRECTORY [NAME ...]   (from the root of the project); NAMEs are parts of the
# names of the tests to run
set -u
. tests/skip.sh
build=$1
shift
passed=0
failed=0
chromium=${CHROMIUM:-/usr/bin/chromium}
said=$(mktemp)
trap 'rm -f "$said"' EXIT
trap 'exit 1' INT TERM HUP

# count COMMAND...: runs tests that print "N passed, N failed", and adds these numbers.
count() {
    "$@" >"$said" 2>&1
    status=$?
    line=$(grep -E '^[0-9]+ passed, [0-9]+ failed$' "$said" | tail -n 1)
    grep -vxF -- "${line:-none}" "$said"
    if [ -z "$line" ]; then
        echo "FAILED: $* ended with status $status and without results"
        failed=$((failed + 1))
        return
    fi
    passed=$((passed + ${line%% *}))
    line=${line#* passed, }
    failed=$((failed + ${line%% *}))
}

missing=
command -v node >/dev/null || missing=node
[ -x "$chromium" ] || missing="$missing $chromium"
[ -d tests/web/node_modules/playwright-core ] || missing="$missing playwright-core"
if command -v node >/dev/null && [ $# -eq 0 ]; then
    count node tests/web/images.mjs
fi
if [ -z "$missing" ] && [ $# -eq 0 ]; then
    count node tests/web/search.mjs "$build/docs/html"
fi
if [ -n "$missing" ]; then
    skip "the web page in a browser: no ${missing# } ('make setup-web')"
elif [ ! -f "$build/web/index.html" ] || [ ! -f "$build/web/gnomon.wasm" ]; then
    skip "the web page in a browser: no $build/web ('make web')"
else
    export GNOMON="$build/gnomon" CHROMIUM="$chromium"
    [ $# -gt 0 ] || count node tests/web/models.mjs "$build"
    count node tests/web/browser.mjs "$build/web" "$build/web-screenshots" "$@"
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
