#!/bin/sh
# Replays the committed inputs of every fuzz target, those that once showed an error included, with
# the programs in BUILD, which need no fuzzer. Prints a line for each target that fails or is skipped,
# the number of inputs that targets do not test, then the sum.
# usage: tests/fuzz/replay.sh BUILD
set -u
cd "$(dirname "$0")/../.."
. tests/script.sh
begin "what fuzzing found"
untested=0
for source in tests/fuzz/fuzz_*.c; do
    target=$(basename "$source" .c)
    target=${target#fuzz_}
    folders=$(ls -d "tests/fuzz/corpus/$target" "tests/fuzz/found/$target" 2>/dev/null)
    result "$target has inputs in tests/fuzz/corpus: make fuzz fuzz-merge" [ -n "$folders" ]
    # shellcheck disable=SC2086
    result "replay with: $1/fuzz-$target, and the input above" "$1/fuzz-$target" $folders
    grep '^skipped: ' "$work/said"
    counts=$(sed -n 's/^.*: \([0-9]*\) inputs, \([0-9]*\) not tested$/\1 \2/p' "$work/said")
    counts=${counts:-0 0}
    passed=$((passed + ${counts% *} - ${counts#* }))
    untested=$((untested + ${counts#* }))
done
echo "fuzz: $untested inputs not tested: their targets refuse them"
finish
