#!/bin/sh
# Runs the test programs named on the command line, each `NAME=COMMAND`, and adds up
# what they say: CMocka's "N test(s)." lines and lines "N passed, N failed". A program
# that exits non-zero without naming a failure, or that names no test at all, counts as
# one failure; one that only exits 0 with a line "NAME: ok" counts as one pass.
# The last line is the sum.
set -u
passed=0
failed=0
log=$(mktemp)
trap 'rm -f "$log"' EXIT

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
        /: ok$/ { p += 1; n = 1 }
        END { print p + 0, f + 0, n + 0 }')
    p=${counts%% *}
    rest=${counts#* }
    f=${rest%% *}
    seen=${rest#* }
    if [ "$status" -ne 0 ] && [ "$f" -eq 0 ]; then
        echo "$name: exit status $status"
        f=1
    elif [ "$seen" -eq 0 ] || [ $((p + f)) -eq 0 ]; then
        echo "$name: no test was run"
        f=1
    fi
    passed=$((passed + p))
    failed=$((failed + f))
    echo "-- $name: $p passed, $f failed, $(($(date +%s) - start)) s"
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
