#!/bin/sh
# Tests mutate.c on sample.c: which mutations it finds, in which order, and what it makes of the file.
# usage: test_mutate.sh   (from the root of the project)
set -u
here=tests/mutants
passed=0
failed=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
tab=$(printf '\t')

check() { # check WHAT EXPECTED FOUND
    if [ "$2" = "$3" ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        printf 'FAILED: %s\n  expected: %s\n  found:    %s\n' "$1" "$2" "$3"
    fi
}

${CC:-cc} -std=c11 -D_POSIX_C_SOURCE=200809L -Wall -Wextra -Wshadow -Werror -O1 -o "$work/mutate" $here/mutate.c || exit 1
list() { "$work/mutate" --list "$1" $here/sample.c | LC_ALL=C sort; }
list 1 >"$work/list"

# line LINE: the mutations of a line, as BEFORE => AFTER, sorted.
line() { awk -F '\t' -v line="$1" '$3 == line { print $9 }' "$work/list" | LC_ALL=C sort | tr '\n' '#'; }

check "comments, directives, types, assertions have none" "" "$(awk -F '\t' '$3 < 15 { print $3 }' "$work/list")"
check "a table" 'static const float steps[3] = {0.0f, (0x1p-3f * 1.001f), 2.5f};#static const float steps[3] = {0.0f, 0.0f, 2.5f};#static const float steps[3] = {0.0f, 0x1p-3f, (2.5f * 1.001f)};#static const float steps[3] = {0.0f, 0x1p-3f, 0.0f};#static const float steps[3] = {1.0f, 0x1p-3f, 2.5f};#' "$(line 15)"
check "a declaration: no dimensions" 'int copy[4] = {(0 + 1)}, found = -1;#int copy[4] = {0}, found = -(1 + 1);#int copy[4] = {0}, found = -(1 - 1);#int copy[4] = {0}, found = 1;#' "$(line 19)"
check "a string" '' "$(line 20)"
check "a cast to void" '' "$(line 22)"
check "an assignment" '*sum = (0 + 1);#;#' "$(line 23)"
check "a loop" 'for (int i = (0 + 1); i < count; ++i) {#for (int i = 0; i < count; --i) {#for (int i = 0; i <= count; ++i) {#for (int i = 0; i >= count; ++i) {#' "$(line 24)"
check "a compound assignment" '*sum += values[i] * (2 + 1);#*sum += values[i] * (2 - 1);#*sum += values[i] + 2;#*sum -= values[i] * 2;#;#' "$(line 25)"
check "a condition" 'if (!(values[i] == 7 && !copy[0]))#if (values[i] != 7 && !copy[0])#if (values[i] == (7 + 1) && !copy[0])#if (values[i] == (7 - 1) && !copy[0])#if (values[i] == 7 && !copy[(0 + 1)])#if (values[i] == 7 && copy[0])#if (values[i] == 7 || !copy[0])#' "$(line 26)"
check "a return" ';#' "$(line 27)"
check "a label" 'case (3 + 1):#case (3 - 1):#' "$(line 31)"
check "a choice" ';#found = count <= 2 ? -found : ~found;#found = count > (2 + 1) ? -found : ~found;#found = count > (2 - 1) ? -found : ~found;#found = count > 2 ? -found : found;#found = count > 2 ? found : ~found;#found = count >= 2 ? -found : ~found;#' "$(line 32)"
check "a statement after default" ';#found = (1 + 1);#found = (1 - 1);#' "$(line 35)"
check "the last return" '' "$(line 39)"
check "functions are named" "chosen steps" "$(cut -f 4 "$work/list" | sort -u | tr '\n' ' ' | sed 's/ $//')"

list 1 >"$work/again"
check "a seed decides the order" "$(cat "$work/list")" "$(cat "$work/again")"
list 2 >"$work/other"
[ "$(cut -f 9 "$work/list")" != "$(cut -f 9 "$work/other")" ]
check "another seed has another order" 0 $?
check "and the same mutations" "$(cut -f 2- "$work/list" | LC_ALL=C sort)" "$(cut -f 2- "$work/other" | LC_ALL=C sort)"

# Every mutation changes the file as its line says, and all of them parse.
bad=0
compiled=0
while IFS= read -r mutation; do
    "$work/mutate" --apply $here/sample.c "$(printf '%s\n' "$mutation" | cut -f 5)" \
        "$(printf '%s\n' "$mutation" | cut -f 6)" "$(printf '%s\n' "$mutation" | cut -f 7)" >"$work/mutant.c"
    diff $here/sample.c "$work/mutant.c" | grep -c '^[<>]' | grep -q '^2$' || bad=$((bad + 1))
    ${CC:-cc} -std=c11 -w -fsyntax-only "$work/mutant.c" 2>/dev/null && compiled=$((compiled + 1))
done <"$work/list"
check "every mutation changes one line" 0 $bad
check "all compile" "$(wc -l <"$work/list")" $compiled

"$work/mutate" --list 2>/dev/null
check "a wrong command line" 2 $?
"$work/mutate" --list 1 "$work/absent.c" 2>"$work/message"
check "an absent file" "2 mutate: $work/absent.c cannot be read" "$? $(cat "$work/message")"
$here/mutants.sh --report >/dev/null 2>"$work/message"
check "no build directory" "2 mutants: the build directory comes first, not '--report' (--help says more)" "$? $(cat "$work/message")"
echo "mutate: $passed passed, $failed failed"
exit $((failed > 0))
