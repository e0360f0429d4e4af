#!/bin/sh
# Tests that the page's module, which `make web` has built, explains pixels as the command does
# (explained.mjs), and that dropped models are drawn as by the command.
# usage: explained.sh BUILD   (from the root of the project)
set -u
build=$1
. tests/skip.sh

failed=0

# none WHAT: nothing can be tested
none() {
    skip "pixels explained by the web page: $1"
    echo "explained: 0 passed, $failed failed"
    exit "$failed"
}

command -v node >/dev/null || none "node is absent ('make setup-web')"
[ -f "$build/web/gnomon.wasm" ] || none "no $build/web/gnomon.wasm ('make setup-web web')"
[ -x "$build/gnomon" ] || none "no $build/gnomon ('make $build/gnomon')"
exec node tests/web/explained.mjs "$build"
