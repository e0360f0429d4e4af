#!/bin/sh
# Tests that the test programs refuse what is no number, or a number out of range, with exit status 2
# and a message that names the option and the value.
# usage: test_numbers.sh BUILD-DIRECTORY   (from the root of the project, with the programs in it)
set -u
. tests/result.sh
build=${1:?usage: tests/command/test_numbers.sh BUILD-DIRECTORY}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP

# refuses PROGRAM OPTION VALUE...: each value alone.
refuses() {
    program=$1
    option=$2
    shift 2
    for value in "$@"; do
        "$build/$program" "$option" "$value" >"$work/out" 2>"$work/error"
        [ $? -eq 2 ] && grep -q -e "$option takes a whole number.*, not '$value'" "$work/error" && continue
        echo "$program $option '$value':"
        cat "$work/error"
        return 1
    done
    "$build/$program" "$option" >"$work/out" 2>"$work/error"
    [ $? -eq 2 ] && grep -q -e "$option" "$work/error"
}

while read -r program option range; do
    # shellcheck disable=SC2086
    result "$program $option" refuses "$program" "$option" '' x 3x 1e6 -1 +1 ' 1' 0x 18446744073709551616 $range
done <<END
accuracy --inputs 0
blits --blits 0
blits --pair 99999
contract --scenes 0
contract-check --every 0
distance --scenes 0
exact --seed
exhaustive --jobs 0
exhaustive --stride 4294967296
hashes --seed
parity --jobs 0 65
parity --scenes 0
parity --seed
property-tests --trials 0
stack --scenes 0
texels --textures 0
textures --target 5
textures --kind 6
texture-accuracy --lookups 0
END
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
