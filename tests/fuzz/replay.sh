#!/bin/sh
# Replays the committed inputs of every fuzz target, those that once showed an error included, with
# the programs in BUILD, which need no fuzzer. Prints a line for each target that fails or is skipped,
# the number of inputs that targets do not test, then the sum.
# usage: tests/fuzz/replay.sh BUILD
set -u
cd "$(dirname "$0")/../.."
passed=0
failed=0
untested=0
log=$(mktemp)
trap 'rm -f "$log"' EXIT
trap 'exit 1' INT TERM HUP
for source in tests/fuzz/fuzz_*.c; do
    target=$(basename "$source" .c)
    target=${target#fuzz_}
    folders=
    for folder in "tests/fuzz/corpus/$target" "tests/fuzz/found/$target"; do
        [ ! -d "$folder" ] || folders="$folders $folder"
    done
    if [ -z "$folders" ]; then
        echo "fuzz: $target has no inputs in tests/fuzz/corpus: make fuzz fuzz-merge" >&2
        failed=$((failed + 1))
        continue
    fi
    if "$1/fuzz-$target" $folders >"$log"; then
        grep '^skipped: ' "$log"
        counts=$(sed -n 's/^.*: \([0-9]*\) inputs, \([0-9]*\) not tested$/\1 \2/p' "$log")
        passed=$((passed + ${counts% *} - ${counts#* }))
        untested=$((untested + ${counts#* }))
    else
        echo "fuzz: $target failed; replay with: $1/fuzz-$target, and the input above"
        failed=$((failed + 1))
    fi
done
echo "fuzz: $untested inputs not tested: their targets refuse them"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
