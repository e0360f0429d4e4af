#!/bin/sh
# Tests property-tests --only and --list: the chosen properties run, with the inputs that they have
# when all properties run.
# usage: test_only.sh PROPERTY-TESTS
set -u
program=$1
directory=$(mktemp -d)
trap 'rm -rf "$directory"' EXIT
trap 'exit 1' INT TERM HUP
passed=0
failed=0

# run OPTION...: leaves status, and files out and error.
run() {
    "$program" "$@" >"$directory/out" 2>"$directory/error"
    status=$?
}

# lines: the lines of properties in the last output.
lines() {
    grep '^properties: .* \.\.\. ' "$directory/out"
}

# check WHAT CONDITION...
check() {
    what=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $what, exit status $status" >&2
        sed 's/^properties/  &/' "$directory/out" "$directory/error" >&2
    fi
}

run --list
cp "$directory/out" "$directory/names"
check "--list: success" [ "$status" = 0 ]
check "--list: no name twice" [ -z "$(sort "$directory/names" | uniq -d)" ]

run --seed 1 --trials 20
lines >"$directory/all"
sed 's/^properties: \(.*\) \.\.\. .*/\1/' "$directory/all" >"$directory/run"
check "--list: the properties that run, in their order" cmp "$directory/names" "$directory/run"

check "the sum is the last line" [ "$(tail -n 1 "$directory/out" | sed 's/, [0-9]* inputs$//')" = \
    "properties: $(grep -c '' "$directory/names") hold, 0 fail" ]

# A name that other names contain chooses only the property of that name.
name="ray and box"
run --seed 1 --trials 20 --only "$name"
check "a name: success" [ "$status" = 0 ]
check "a name: that property alone" [ "$(lines | wc -l)" = 1 ]
check "a name: its line in the run of all" [ "$(lines)" = "$(grep -F "properties: $name ..." "$directory/all")" ]

run --seed 1 --trials 20 --only inverse
lines >"$directory/some"
grep 'properties: .*inverse.* \.\.\. ' "$directory/all" >"$directory/expected"
check "a part of names: several" [ "$(wc -l <"$directory/some")" -gt 5 ]
check "a part of names: their lines in the run of all" cmp "$directory/some" "$directory/expected"
run --list --only inverse
grep inverse "$directory/names" >"$directory/expected"
check "--list --only: the names with that part" cmp "$directory/out" "$directory/expected"

run --only "compose: invrse"
check "unknown: status 2" [ "$status" = 2 ]
check "unknown: nothing on standard output" [ ! -s "$directory/out" ]
check "unknown: one line, which names what is near and --list" [ "$(grep -c \
    'no property is named "compose: invrse".*"compose: inverse".*--list' "$directory/error")" = 1 ]
check "unknown: one line" [ "$(wc -l <"$directory/error")" = 1 ]
run --only "%%%"
check "like no name: status 2" [ "$status" = 2 ]
check "like no name: nothing is near" [ "$(cat "$directory/error")" = \
    'property-tests: no property is named "%%%", and no name contains it; --list prints all names' ]
run --only
check "no name: status 2" [ "$status" = 2 ]
check "no name: the option is named" grep -q -- '--only takes a name; see --help' "$directory/error"
run --help
check "--help: --only, --list" [ "$(grep -c -e '^  --only' -e '^  --list' "$directory/out")" = 2 ]

echo "only: $passed passed, $failed failed"
[ "$failed" = 0 ]
