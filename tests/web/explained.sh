#!/bin/sh
# Tests that the page's module, which `make web` has built, explains pixels as the command does
# (explained.mjs).
# usage: explained.sh BUILD   (from the root of the project)
set -u
build=$1
. tests/skip.sh

for absent in "$build/web/gnomon.wasm" "$(command -v node || echo node)"; do
    if [ ! -e "$absent" ]; then
        skip "pixels explained by the web page: $absent is absent: 'make setup-web' installs what 'make web' and this need"
        echo "explained: 0 passed, ${failed:-0} failed"
        exit "${failed:-0}"
    fi
done
exec node tests/web/explained.mjs "$build"
