#!/bin/sh
# Tests the WebAssembly modules of the web page, which `make web` has built, in Node (modules.mjs), and
# shows that a changed contract is noticed.
# usage: modules.sh BUILD   (from the root of the project)
set -u
build=$1
. tests/script.sh
begin modules
for absent in "$build/web/gnomon-simd.wasm" "$build/web/gnomon.wasm" "$(command -v node || echo node)"; do
    [ -e "$absent" ] && continue
    skip "modules of the web page: $absent is absent: 'make setup-web' installs what 'make web' and this need"
    finish
done

# fails PATTERN COMMAND...: the command fails and says so.
fails() {
    pattern=$1
    shift
    ! "$@" >"$work/log" 2>&1 && grep -q "$pattern" "$work/log"
}

node tests/web/modules.mjs "$build" >"$work/modules" 2>&1
grep -v '^modules: ' "$work/modules"
counts=$(sed -n 's/^modules: \([0-9]*\) passed, \([0-9]*\) failed$/\1 \2/p' "$work/modules")
passed=${counts% *}
failed=${counts#* }
[ -n "$counts" ] || { passed=0; failed=1; }

pictures=tests/contract/pictures.txt
head -n 9 $pictures >"$work/short.txt"
result "too short a contract is noticed" \
    fails 'the contract has its pictures' node tests/web/modules.mjs "$build" "$work/short.txt" gnomon-simd.wasm
sed '8s/^...../abcde/' $pictures | head -n 9 >"$work/changed.txt"
result "a changed hash is noticed" \
    fails 'is drawn as by the reference' node tests/web/modules.mjs "$build" "$work/changed.txt" gnomon-simd.wasm
finish
