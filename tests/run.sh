#!/bin/sh
# Runs the steps named on the command line, each `NAME=COMMAND`, and adds up their tests:
# CMocka's "N test(s)." lines, lines "N passed, N failed" and lines "properties: ... PASS"
# or "FAIL". A step that names no test counts as one, by its exit status; one that exits
# non-zero without naming a failure counts as one failure. At the end stand the steps that
# failed, each with the lines of its output that say so and the last of all, so that the tail
# of a log says what failed. The last line is the sum.
set -u
passed=0
failed=0
log=$(mktemp)
failures=$(mktemp)
trap 'rm -f "$log" "$failures"' EXIT

for step in "$@"; do
    name=${step%%=*}
    command=${step#*=}
    echo "== $name: $command"
    start=$(date +%s)
    sh -c "$command" >"$log" 2>&1
    status=$?
    grep -v -e '^\[ RUN' -e '^\[       OK' -e '^\[=====' "$log"
    counts=$(sed 's/\x1b\[[0-9;]*m//g' "$log" | awk '
        /^\[  PASSED  \] [0-9]+ test/ { p += $4; n = 1 }
        /^\[  FAILED  \] [0-9]+ test/ { f += $4; n = 1 }
        /^[0-9]+ passed, [0-9]+ failed$/ { p += $1; f += $3; n = 1 }
        /passed, [0-9]+ failed$/ && !/^[0-9]/ && match($0, /[0-9]+ passed, [0-9]+ failed$/) {
            split(substr($0, RSTART), w, /[ ,]+/); p += w[1]; f += w[3]; n = 1 }
        /^properties: .*PASS/ { p += 1; n = 1 }
        /^properties: .*FAIL/ { f += 1; n = 1 }
        END { print p + 0, f + 0, n + 0 }')
    p=${counts%% *}
    rest=${counts#* }
    f=${rest%% *}
    seen=${rest#* }
    if [ "$status" -ne 0 ] && [ "$f" -eq 0 ]; then
        echo "$name: exit status $status"
        f=1
    elif [ "$seen" -eq 0 ]; then
        p=1
    elif [ $((p + f)) -eq 0 ]; then
        echo "$name: no test was run"
        f=1
    fi
    passed=$((passed + p))
    failed=$((failed + f))
    echo "-- $name: $p passed, $f failed, $(($(date +%s) - start)) s"
    if [ "$f" -gt 0 ]; then
        lines=$(grep -c '' "$log")
        {
            echo "!! $name: $f failed, exit status $status: $command"
            head -n $((lines > 12 ? lines - 12 : 0)) "$log" |
                grep -i -E 'fail|error|differ|seed' | grep -v -E 'PASS|, 0 (failed|differ)' | tail -n 12
            tail -n 12 "$log"
        } >>"$failures"
    fi
done
cat "$failures"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
