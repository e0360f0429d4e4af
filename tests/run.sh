#!/bin/sh
# Runs the steps named on the command line, each `NAME=COMMAND`, N at a time, and adds up their
# tests: CMocka's "N test(s)." lines, lines "N passed, N failed" and lines "properties: ... PASS"
# or "FAIL". A step that prints no such line counts as one test, by its exit status. A step that
# exits non-zero without printing a failure counts as one failure. The output of each step is
# printed unbroken, in the order of the command line, with the seconds that the step took, by the
# clock and by processors; the seconds by the clock depend on the steps that ran at the same time.
# The end of the output lists: what was skipped, from lines "skipped: ..." and CMocka's; what
# emulation stands in for (lines "in emulation: ..."); and the steps that failed, each with the
# lines of its output that say so and its last line. So the tail of a log says what failed. Under
# GN_NO_SKIP a step that skips something fails. If GN_RECORDS names a file, each step's figures are
# added to it (tests/assurance/record.sh), and the sum under the key GN_RECORD_KEY ("make test"). The
# last line is the sum. If SIGINT, SIGTERM or SIGHUP ends the run, it ends every process that it started.
# usage: run.sh [-j N] NAME=COMMAND...   (steps that use each other's files must be one step)
set -u

# Runs a step. A pipe tells when the step has ended, even if the pipe is read later.
run_step() { # run_step NUMBER STEP
    start=$(date +%s)
    sh -c "${2#*=}" >"$work/$1.log" 2>&1
    status=$?
    times >"$work/$1.times" # in a pipeline these would be the times of another shell
    sed 's/[ms]/ /g' "$work/$1.times" | awk -v status="$status" -v wall=$(($(date +%s) - start)) '
        # User and system time of the commands that have ended.
        NR == 2 { printf "%d %d %d\n", status, wall, 60 * $1 + $2 + 60 * $3 + $4 + 0.5 }' >"$work/$1.result"
    : >"$work/$1.ended" &
}

# Takes steps that no other worker has taken, until there is none; creating the directory takes a step.
# If the run that started this worker was killed, nobody would end a further step.
work_off() {
    number=0
    for step in "$@"; do
        number=$((number + 1))
        kill -0 "$PPID" 2>/dev/null || kill -s KILL 0
        ! mkdir "$work/$number.taken" 2>/dev/null || (run_step "$number" "$step")
    done
}

if [ "${1:-}" = --worker ]; then # --worker DIRECTORY NAME=COMMAND...: this script starts itself so
    work=$2
    shift 2
    work_off "$@"
    exit
fi

if ! command -v setsid >/dev/null; then
    echo "run.sh: needs setsid, of util-linux" >&2
    exit 1
fi
refuse() {
    echo "run.sh: $1 (--help says more)" >&2
    exit 2
}
case ${1:-} in -h | --help) sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"; exit ;; esac
at_once=1
if [ "${1:-}" = -j ]; then
    at_once=${2:-}
    case $at_once in '' | *[!0-9]*) refuse "-j takes a number, not '$at_once'" ;; esac
    [ "$at_once" -gt 0 ] || refuse "-j takes a number above 0"
    shift 2
fi
[ $# -gt 0 ] || refuse "no step"
for step in "$@"; do
    case $step in -*) refuse "not a step: '$step'" ;; *=*) ;; *) refuse "not a step, NAME=COMMAND: '$step'" ;; esac
done
passed=0
failed=0
skipped=0
seen_steps=0
began=$(date +%s)
records=${GN_RECORDS:-}
key=${GN_RECORD_KEY:-make test}
unset GN_RECORDS GN_RECORD_KEY # a step may run this script too
work=$(mktemp -d) || exit 1
failures=$work/failures
notes=$work/notes
: >"$failures"
: >"$notes"
workers=

# Ends the workers and everything that they run. Each worker has a process group of its own. It has
# none yet in its first moment, when only its own number reaches it. What ignores the first signal is
# killed after five seconds.
clean_up() {
    trap '' INT TERM HUP # a second Ctrl-C must not interrupt this
    for worker in $workers; do
        kill -s TERM -- "-$worker" "$worker"
    done 2>/dev/null
    tenths=50
    for worker in $workers; do
        while [ $tenths -gt 0 ] && kill -s 0 -- "-$worker"; do
            sleep 0.1
            tenths=$((tenths - 1))
        done
        kill -s KILL -- "-$worker"
    done 2>/dev/null
    rm -rf "$work"
}
trap clean_up EXIT
trap 'exit 1' INT TERM HUP

# record KEY SECONDS FAILED FIGURES
record() {
    [ -n "$records" ] || return 0
    verdict=held
    [ "$3" -eq 0 ] || verdict=FAILED
    tests/assurance/record.sh --add "$records" "$1" "$2" $verdict "$4"
}

number=0
for step in "$@"; do
    number=$((number + 1))
    mkfifo "$work/$number.ended" || exit 1
done
while [ "$at_once" -gt 0 ]; do
    # `set -m` would not do: without a terminal it gives dash no process groups.
    setsid sh "$0" --worker "$work" "$@" &
    workers="$workers $!"
    at_once=$((at_once - 1))
done

for step in "$@"; do
    name=${step%%=*}
    command=${step#*=}
    seen_steps=$((seen_steps + 1))
    log=$work/$seen_steps.log
    echo "== $name: $command"
    until true <"$work/$seen_steps.ended"; do :; done 2>/dev/null # signals interrupt it
    read -r status wall processors <"$work/$seen_steps.result"
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
    s=$(sed -n -e 's/^skipped: //p' -e 's/^\[  SKIPPED \] \([a-z].*\)/\1/p' "$log" | sort -u |
        sed "s|^|skipped: $name: |" | tee -a "$notes" | grep -c '')
    grep '^in emulation: ' "$log" >>"$notes"
    if [ "$status" -ne 0 ] && [ "$f" -eq 0 ]; then
        echo "$name: exit status $status"
        f=1
    elif [ "$seen" -eq 0 ]; then
        p=1
    elif [ $((p + f + s)) -eq 0 ]; then
        echo "$name: no test was run"
        f=1
    fi
    if [ "$s" -gt 0 ] && [ "$f" -eq 0 ] && [ -n "${GN_NO_SKIP:-}" ]; then
        echo "$name: $s skipped, where nothing may be (GN_NO_SKIP)"
        f=$s
    fi
    skipped=$((skipped + s))
    passed=$((passed + p))
    failed=$((failed + f))
    echo "-- $name: $p passed, $f failed, $wall s, $processors s of processors"
    record "test/$name" "$wall" "$f" "$(grep '[0-9]' "$log" | tail -n 1)"
    if [ "$f" -gt 0 ]; then
        lines=$(grep -c '' "$log")
        {
            echo "!! $name: $f failed, exit status $status: $command"
            head -n $((lines > 12 ? lines - 12 : 0)) "$log" |
                grep -i -E 'fail|error|differ|seed|skipped' | grep -v -E 'PASS|, 0 (failed|differ)' | tail -n 12
            tail -n 12 "$log"
        } >>"$failures"
    fi
    rm -f "$log"
done
# A worker that still looks for a step would find one to take while the directory is removed.
# shellcheck disable=SC2086
wait $workers
workers=
sort -u "$notes"
cat "$failures"
echo "$# steps, $(($(date +%s) - began)) s"
sum="$passed passed, $failed failed"
[ "$skipped" -eq 0 ] || sum="$sum, $skipped skipped"
record "$key" $(($(date +%s) - began)) "$failed" "$sum"
echo "$sum"
[ "$failed" -eq 0 ]
