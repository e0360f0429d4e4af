#!/bin/sh
# Tests tests/run.sh: its sums, its closing lines, skipped tests, and its end by a signal.
# usage: test_run.sh   (from the root of the project)
set -u
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
log=$work/log
records=$work/records
passed=0
failed=0

# check WHAT LAST-LINE EXIT-STATUS STEP...: with GN_NO_SKIP as `no_skip` says.
check() {
    what=$1
    last=$2
    expected=$3
    shift 3
    GN_NO_SKIP=$no_skip tests/run.sh "$@" >"$log" 2>&1
    status=$?
    if [ $status -eq "$expected" ] && [ "$(tail -n 1 "$log")" = "$last" ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $what: exit status $status"
        sed 's/^/    /' "$log"
    fi
}

# says WHAT PATTERN: the closing lines, after the last step, have the pattern.
says() {
    if sed '1,/^-- last/d' "$log" | grep -q -- "$2"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $1: no line '$2'"
    fi
}

whole="skipped: engine: not run, since fuel is absent: 'make setup-cross' installs it"
no_skip=
check "sums" "7 passed, 0 failed" 0 'a=echo "x: 3 passed, 0 failed"' 'b=echo "3 passed, 0 failed"' 'last=true'
check "a failure" "3 passed, 2 failed" 1 'a=echo "3 passed, 1 failed"; false' 'last=false'
says "a failure is named" '^!! a: 1 failed'
check "properties count by their lines" "2 passed, 1 failed" 1 \
    "a=printf 'properties: a ... PASS (9 trials)\nproperties: b ... FAIL (seed 0x1)\nproperties: 1 hold, 1 fail, 10 inputs\n'; false" 'last=true'
check "no test" "0 passed, 1 failed" 1 'last=echo "0 passed, 0 failed"'
check "a part is skipped" "4 passed, 0 failed, 1 skipped" 0 "a=echo \"$whole\"; echo '3 passed, 0 failed'" 'last=true'
says "what is skipped is named" "^skipped: a: engine: .*installs it"
check "a whole step is skipped" "1 passed, 0 failed, 1 skipped" 0 "a=echo \"$whole\"; echo '0 passed, 0 failed'" 'last=true'
check "a part of a step without counts" "2 passed, 0 failed, 1 skipped" 0 "a=echo \"$whole\"" 'last=true'
check "CMocka's" "3 passed, 0 failed, 1 skipped" 0 \
    "a=printf '[  SKIPPED ] far\\n[  PASSED  ] 2 test(s).\\n[  SKIPPED ] 1 test(s), listed below:\\n[  SKIPPED ] far\\n'" 'last=true'
check "emulation is no skip" "2 passed, 0 failed" 0 'a=echo "in emulation: avx512"' 'last=true'
says "emulation is told" '^in emulation: avx512'
check "no step" "run.sh: no step (--help says more)" 2
check "no number of workers" "run.sh: -j takes a number, not 'two' (--help says more)" 2 -j two 'last=true'
check "no worker" "run.sh: -j takes a number above 0 (--help says more)" 2 -j 0 'last=true'
check "an option that is none" "run.sh: not a step: '-j2' (--help says more)" 2 -j2 'last=true'
check "a step without a name" "run.sh: not a step, NAME=COMMAND: 'true' (--help says more)" 2 'last=true' 'true'
no_skip=1
check "nothing may be skipped" "4 passed, 1 failed, 1 skipped" 1 "a=echo \"$whole\"; echo '3 passed, 0 failed'" 'last=true'
says "a skip fails by name" '^!! a: 1 failed'
check "a script that fails for it" "1 passed, 1 failed, 1 skipped" 1 \
    "a=. tests/skip.sh; failed=0; skip 'x: absent'; echo \"0 passed, \$failed failed\"; exit \$failed" 'last=true'
check "nothing is skipped" "1 passed, 0 failed" 0 'last=true'

# interrupted SIGNAL STATUS STEP...: a run of the steps that gets the signal when two lines have come
# through descriptor 9 ends with the status, and with it every process that it started. All of them
# hold that descriptor open. A shell lets its background processes ignore SIGINT, which env undoes.
interrupted() {
    signal=$1
    expected=$2
    shift 2
    rm -f "$work/held"
    mkfifo "$work/held"
    env --default-signal=INT,HUP tests/run.sh -j 3 "$@" 9>"$work/held" >"$log" 2>&1 &
    run=$!
    {
        read -r _ && read -r _
        kill -s "$signal" "$run"
        timeout 20 cat >"$work/rest"
        left=$?
    } <"$work/held"
    wait "$run" 2>/dev/null
    status=$?
    if [ $status -eq "$expected" ] && [ $left -eq 0 ] && [ ! -s "$work/rest" ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: SIG$signal: exit status $status, processes left: $left, $(cat "$work/rest")"
    fi
}

# The run inside the run gets SIGTERM from the outer one.
interrupted INT 1 'runs=echo >&9; sleep 40; echo on >&9' \
    'runs a run=tests/run.sh "inner=echo >&9; sleep 40; echo on >&9"' 'has ended=true'
interrupted HUP 1 'ignores it=trap "" TERM; echo >&9; sleep 40; echo on >&9' 'runs=echo >&9; sleep 40'
interrupted KILL 137 'a=echo >&9; sleep 1' 'b=echo >&9; sleep 1' 'c=sleep 1' 'later=echo on >&9'

# recorded KEY: the last run added a record of its step and one of its sum, under this key.
recorded() {
    if [ "$(cut -f 1,6 "$records" | tr '\t\n' ' ,')" = "test/last held,$1 held," ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: records with the key '$1'"
        sed 's/^/    /' "$records"
    fi
    : >"$records"
}
GN_RECORDS=$records tests/run.sh 'last=true' >"$log"
recorded "make test"
GN_RECORDS=$records GN_RECORD_KEY='make whole' tests/run.sh 'last=true' >"$log"
recorded "make whole"
echo "run: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
