#!/bin/sh
# Tests merge.awk on what llvm-cov would show of two builds of one small source.
# usage: test_merge.sh   (from the root of the project)
set -u
passed=0
failed=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
mkdir -p "$work/src/math"
cat >"$work/src/math/a.c" <<'END'
static int chosen(int a, int b)
{
    if (a && b)
        return 1;
    return 2;
}

int other(int a)
{
    return a ? 3 : 4;
}
END

# shown COUNT-OF-LINE-4 TRUE FALSE PAIR: one build, in which line 10 is a folded branch and the empty
# line 7 has a count.
shown() {
    cat <<END
$work/src/math/a.c:
    1|       |static int chosen(int a, int b)
    2|     10|{
    3|     10|    if (a && b)
  ------------------
  |  Branch (3:9): [True: $2, False: 6]
  |  Branch (3:14): [True: $2, False: $3]
  ------------------
  |---> MC/DC Decision Region (3:9) to (3:15)
  |
  |  C1-Pair: covered: (1,3)
  |  C2-Pair: $4
  ------------------
    4|      $1|        return 1;
    5|  1.50k|    return 2;
    6|     10|}
    7|      0|
    8|       |int other(int a)
    9|     10|{
   10|     10|    return a ? 3 : 4;
  ------------------
  |  Branch (10:12): [Folded - Ignored]
  ------------------
   11|     10|}
$work/tests/other.c:
    1|      0|not counted
END
}

# merged FILE...: the last line, and the number of places without a reason.
merged() {
    awk -v root="$work" -v list="$work/list" -f tests/coverage/merge.awk "$@" >"$work/out"
    echo "$? $(tail -n 1 "$work/out")"
}

check() { # check WHAT EXPECTED FOUND
    if [ "$2" = "$3" ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        printf 'FAILED: %s\n  expected: %s\n  found:    %s\n' "$1" "$2" "$3"
    fi
}

: >"$work/list"
shown 0 0 0 'not covered' >"$work/one"
shown 4 4 0 'not covered' >"$work/two"
shown 0 0 6 'covered: (2,3)' >"$work/three"
check "one build" \
    "1 coverage: lines 87.5 %, branches 25.0 %, MC/DC 50.0 %, 4 places unreached, 4 without a reason" \
    "$(merged "$work/one")"
check "the function is named" 1 "$(grep -c '^src/math/a.c:4 is not reached: chosen: ' "$work/out")"
check "the condition is named" 1 "$(grep -c '^src/math/a.c:3:14 is never true: chosen: ' "$work/out")"
check "two builds" \
    "1 coverage: lines 100.0 %, branches 75.0 %, MC/DC 50.0 %, 1 places unreached, 1 without a reason" \
    "$(merged "$work/one" "$work/two")"
check "three builds" \
    "0 coverage: lines 100.0 %, branches 100.0 %, MC/DC 100.0 %, 0 places unreached, each with its reason" \
    "$(merged "$work/one" "$work/two" "$work/three")"
printf 'src/math/a.c chosen\n    The reason.\n' >"$work/list"
check "a reason is no excuse for few branches" \
    "1 coverage: lines 100.0 %, branches 75.0 %, MC/DC 50.0 %, 1 places unreached, each with its reason" \
    "$(merged "$work/one" "$work/two")"
check "a reason without a place" 1 "$(merged "$work/one" "$work/two" "$work/three" | cut -d ' ' -f 1)"
check "is named" 1 "$(grep -c '^unreached.txt: src/math/a.c chosen: wholly reached' "$work/out")"
printf 'src/math/a.c other\n    The reason.\n' >"$work/list"
merged "$work/one" >"$work/figures"
check "another function's reason" 1 "$(grep -c ', 4 without a reason' "$work/figures")"
echo "merge: $passed passed, $failed failed"
exit $((failed > 0))
