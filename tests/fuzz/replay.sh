#!/bin/sh
# Replays the committed inputs of every fuzz target, those that once showed an error included, with
# the programs in BUILD, which need no fuzzer. Prints a line for each target that fails, then the sum.
# usage: tests/fuzz/replay.sh BUILD
set -u
cd "$(dirname "$0")/../.."
passed=0
failed=0
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
    inputs=$(find $folders -type f | wc -l)
    if "$1/fuzz-$target" $folders >/dev/null; then
        passed=$((passed + inputs))
    else
        echo "fuzz: $target failed; replay with: $1/fuzz-$target, and the input above"
        failed=$((failed + 1))
    fi
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
