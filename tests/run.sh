#!/bin/sh
# Runs steps of tests/steps.sh, N at a time, and adds up their tests. The output of a step is printed
# unbroken when it ends. The last lines list what was skipped and what failed, then the sum.
# A step's tests are CMocka's "N test(s)." lines, lines that end on "N passed, N failed", and "properties:
# ... PASS" or "FAIL". A step without such a line counts as one test, by its exit status.
# Under GN_NO_SKIP a step that skips something fails. SIGINT, SIGTERM or SIGHUP ends every process.
# usage: run.sh [-j N] [--whole] [--only NAME] BUILD     NAME: a step or a suite, as `--list` prints them
#        run.sh --list [--whole] [--only NAME] BUILD     prints the names of the steps
#        run.sh --needs [--whole] [--only NAME] BUILD    prints the targets of make that the steps need
# Environment: SEED of random tests; FRESH, a second seed, which none gives in CI.
set -u

# Runs one step, whose name and command are the lines of a file. Appends its sums to $work/sums.
if [ "${1:-}" = --one ]; then
    work=$2 step=$3
    name=$(sed -n 1p "$step") command=$(sed -n 2p "$step")
    began=$(date +%s)
    sh -c "$command" >"$step.log" 2>&1
    status=$?
    # Seconds of processor time of all that the step ran.
    times >"$step.times"
    processor=$(awk 'NR == 2 { split($1 "m" $2, t, "m"); printf "%.0f", t[1] * 60 + t[2] + t[3] * 60 + t[4] }' "$step.times")
    exec 9>"$work/lock"
    flock 9
    echo "== $name: $command"
    grep -v -e '^\[ RUN' -e '^\[       OK' -e '^\[=====' "$step.log"
    sed -e 's/\x1b\[[0-9;]*m//g' "$step.log" | awk -v name="$name" -v status=$status -v strict="${GN_NO_SKIP:+1}" '
        /^\[  PASSED  \] [0-9]+ test/ { passed += $4; seen = 1 }
        /^\[  FAILED  \] [0-9]+ test/ { failed += $4; seen = 1 }
        /[0-9]+ passed, [0-9]+ failed$/ { passed += $(NF - 3); failed += $(NF - 1); seen = 1 }
        /^properties: .*PASS/ { passed++; seen = 1 }
        /^properties: .*FAIL/ { failed++; seen = 1 }
        /^skipped: / { skipped++ }
        END {
            if (!seen && !status)
                passed = 1
            if (status && !failed)
                failed = 1
            if (!status && passed + failed + skipped == 0)
                failed = 1
            if (strict && skipped && !failed)
                failed = skipped
            print passed + 0, failed + 0, skipped + 0, name
        }' >"$step.sum"
    read -r passed failed _ <"$step.sum"
    cat "$step.sum" >>"$work/sums"
    echo "-- $name: $passed passed, $failed failed, $(($(date +%s) - began)) s, processor $processor s"
    sed -n "s/^skipped: /skipped: $(echo "$name" | sed 's|/|\\/|g'): /p" "$step.log" >>"$work/skipped"
    if [ "$failed" -gt 0 ]; then
        { echo "!! $name: $failed failed, exit status $status: $command"; tail -n 15 "$step.log"; } >>"$work/failures"
    fi
    exit 0
fi

jobs=1 whole= only= print=
while [ $# -gt 1 ]; do
    case $1 in
    -j) jobs=$2; shift ;;
    --whole) whole=yes ;;
    --only) only=$2; shift ;;
    --list | --needs) print=$1 ;;
    *) break ;;
    esac
    shift
done
if [ $# -ne 1 ] || [ "$1" = --help ]; then
    sed -n '2,/^set/s/^# \{0,1\}//p' "$0"
    exit 2
fi
BUILD=$1
export BUILD SANITIZED="$BUILD/sanitized" SEED="${SEED:-1}" FRESH="${FRESH:-}"
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
count=0

# step NAME NEEDS COMMAND: a name is SUITE/NAME; NEEDS are targets of make, in BUILD or without a folder.
step() {
    case "/$1/" in *"/${only:-$1}/"*) ;; *) return 0 ;; esac
    count=$((count + 1))
    case $print in
    --list) echo "$1" ;;
    --needs) printf '%s\n' $2 ;;
    *) printf '%s\n' "$1" "$3" >"$work/$(printf %04d $count).step" ;;
    esac
}
# whole NAME NEEDS COMMAND: a step of `make whole` alone, or one that is asked for by name.
whole() { [ -z "$whole$only" ] || step "$@"; }
. tests/steps.sh
[ $count -gt 0 ] || { echo "run.sh: no step and no suite is called '$only'; tests/run.sh --list --whole $BUILD" >&2; exit 2; }
[ -z "$print" ] || exit 0

began=$(date +%s)
: >"$work/sums" >"$work/skipped" >"$work/failures"
# A session of its own, so that a signal to this script can end all that runs in it.
setsid xargs -n 1 -P "$jobs" sh "$0" --one "$work" <<STEPS &
$(ls "$work"/*.step)
STEPS
group=$!
trap 'kill -s TERM -- "-$group"; sleep 1; kill -s KILL -- "-$group"; exit 1' INT TERM HUP
until wait $group; do kill -s 0 $group || break; done 2>/dev/null
sort -u "$work/skipped"
cat "$work/failures"
echo "$count steps, $(($(date +%s) - began)) s"
awk '{ passed += $1; failed += $2; skipped += $3 }
    END {
        printf "%d passed, %d failed%s\n", passed, failed, skipped ? ", " skipped " skipped" : ""
        exit failed > 0 || NR < '$count'
    }' "$work/sums"
