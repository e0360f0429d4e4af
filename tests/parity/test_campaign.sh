#!/bin/sh
# Tests that a campaign goes on where it was killed, starts anew on another text, names what differs and
# what cannot be run, and uses the machines that parallel is told of, with a stand-in for the parity
# program that records what it is asked to draw.
# usage: test_campaign.sh   (from the root of the project)
set -u
. tests/result.sh
. tests/skip.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
build="$work/a build's directory"
state=$build/campaign/state.txt
if ! command -v parallel >/dev/null; then
    skip "campaign: GNU parallel is absent: 'make setup' installs it"
    echo "campaign: 0 passed, $failed failed"
    exit "$failed"
fi

# Says that 2 pixels of seed 9 differ. If there is a file "slow", only the first chunks of seeds end.
mkdir "$build"
cat >"$build/parity" <<END
#!/bin/sh
# arguments: --seed S --skip K --scenes N --jobs N --keep FILE
echo "\$2 \$4 \$6" >>"$work/asked"
[ ! -f "$work/slow" ] || [ "\$4" = 0 ] || sleep 60
differ=0
[ "\$2" != 9 ] || { differ=2; : >"\${10}"; }
echo "all \$6 10 100 50 \$differ 0"
echo "parity: \$6 scenes, 100 pixels compared, \$differ differ, 0 scenes refused"
[ \$differ = 0 ]
END
chmod +x "$build/parity"

campaign() { # campaign OPTION...
    : >"$work/asked"
    timeout -k 5 120 tests/parity/campaign.sh --scenes 45 --chunk 10 "$@" "$build" >"$work/out" 2>"$work/err"
    status=$?
}
ended() { # ended STATUS CHUNKS LAST-LINE: the exit status, the number of chunks asked for, the last line
    echo "status $status"
    cat "$work/asked" "$work/out" "$work/err"
    [ $status -eq "$1" ] && [ "$(grep -c '' "$work/asked")" -eq "$2" ] && tail -n 1 "$work/out" | grep -q -e "$3"
}
says() { cat "$2" && grep -q -e "$1" "$2"; }

# await COMMAND...: at most ten seconds.
await() {
    for _ in $(seq 200); do
        ! "$@" || return 0
        sleep 0.05
    done
    return 1
}
has_state() { [ "$(grep -s -c ^done "$state")" = "$1" ]; }
begins() { [ "$(grep -c '' "$work/asked")" = "$1" ]; }
nothing_runs() { ! pgrep -f "$work/.*parity" && flock -n "$build/campaign/lock" true; }
# Prints a process and all below it.
family() { echo "$1"; for child in $(pgrep -P "$1"); do family "$child"; done; }

# begin_and_kill SIGNAL: ends a campaign whose first chunks of both seeds are drawn.
begin_and_kill() {
    rm -rf "$build/campaign"
    : >"$work/slow"
    : >"$work/asked"
    tests/parity/campaign.sh --scenes 45 --chunk 10 --seeds '3 4' "$build" >"$work/out" 2>"$work/err" &
    started=$!
    result "SIG$1: draws the first chunks" await has_state 2
    result "SIG$1: draws the next chunks" await begins 4
    if [ "$1" = KILL ]; then
        # shellcheck disable=SC2046
        kill -9 $(family $started) 2>/dev/null # some may just have ended
    else
        kill -s "$1" $started
    fi
    wait $started 2>/dev/null
    result "SIG$1: a status that is not 0" test $? -ne 0
    result "SIG$1: nothing is left running" await nothing_runs
    result "SIG$1: what was drawn is in the state" has_state 2
    rm "$work/slow"
}

begin_and_kill TERM
begin_and_kill KILL
printf 'done 4 10 10 1' >>"$state" # being written when the campaign was killed
campaign --seeds '3 4' --chunks 2
result "goes on, and stops after two chunks" ended 1 2 '^campaign: 40 scenes of 2 seeds'
result "the chunk that was not whole is drawn again" says '^4 10 10$' "$work/asked"
campaign --seeds '3 4'
result "goes on to the end" ended 0 2 '^campaign: 46 scenes of 2 seeds, 60 triangles, 600 pixels, 0 differing'
result "the last chunks are what is left" says '^4 20 3$' "$work/asked"
campaign --seeds '3 4'
result "nothing is left" ended 0 0 '^campaign: 46 scenes'

# Other machines, by a stand-in for ssh that has another folder and no environment.
cat >"$work/ssh" <<END
#!/bin/sh
# arguments: MACHINE -- COMMAND...
echo "\$1" >>"$work/machines-used"
shift 2
cd / && exec env -i PATH="\$PATH" HOME="$work" SHELL=/bin/sh sh -c "\$*"
END
chmod +x "$work/ssh"
printf '1/node1\n1/node2\n:\n' >"$work/machines"
rm "$state"
PARALLEL="--ssh $work/ssh --sshloginfile $work/machines" campaign --seeds '3 4' --jobs 1
result "three machines" ended 0 6 '^campaign: 46 scenes of 2 seeds, 60 triangles, 600 pixels, 0 differing'
result "two of them by ssh" test "$(sort -u "$work/machines-used" | tr '\n' ' ')" = 'node1 node2 '

campaign --seeds '3 9'
result "goes on after a difference" ended 1 3 '^campaign: 46 scenes of 2 seeds, .* 6 differing'
result "names the chunk and the scene" says 'seed 9, skip 10: 2 pixels differ, .*failure-9-10.scene' "$work/err"
campaign --seeds '3 9'
result "a difference stays" ended 1 0 '6 differing'
sed -i 's/^text .*/text 0123/' "$state"
campaign --seeds '3 4'
result "another text" ended 0 6 '^campaign: 46 scenes'
result "another text: says so" says 'no longer 0123: starts anew' "$work/err"
printf '#!/bin/sh\necho "parity: no reference"\nexit 1\n' >"$build/parity"
campaign --scenes 400 --seeds 5
result "parity that cannot run" test $status -eq 1
result "parity that cannot run: the chunk is named" says 'seed 5, skip 0: could not be run, exit status 1' "$work/err"
result "parity that cannot run: few are tried" test "$(grep -c 'could not be run' "$work/err")" -lt 6
result "parity that cannot run: nothing is recorded" test "$(grep -c '^done 5' "$state")" -eq 0
campaign --scenes 0
result "a wrong number" test $status -eq 2
tests/parity/campaign.sh --scenes 5 >"$work/out" 2>"$work/err"
result "no build directory" test $? -eq 2
echo "campaign: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
