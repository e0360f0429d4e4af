#!/bin/sh
# Tests that the page's module, which `make web` has built, explains pixels as the command does
# (explained.mjs), and that dropped models are drawn as by the command.
# usage: explained.sh BUILD   (from the root of the project)
set -u
. tests/script.sh
begin explained
build=$1
need setup-web node
for made in web/gnomon.wasm gnomon; do
    [ -e "$build/$made" ] && continue
    skip "pixels explained by the web page: no $build/$made ('make setup-web web $build/gnomon')"
    finish
done
exec node tests/web/explained.mjs "$build"
