#!/bin/sh
# Tests that a campaign goes on where it was killed, and starts anew on another text, with a stand-in
# for the parity program that records what it is asked to draw.
# usage: test_campaign.sh   (from the root of the project)
set -u
directory=$(mktemp -d)
trap 'rm -rf "$directory"' EXIT
trap 'exit 1' INT TERM HUP
passed=0
failed=0
state=$directory/campaign/state.txt

# Says that 2 pixels of seed 9 differ. Kills the campaign in the second chunk if there is a file "kill".
cat >"$directory/parity" <<END
#!/bin/sh
# arguments: --seed S --skip K --scenes N --jobs N --keep FILE
echo "\$2 \$4 \$6" >>$directory/asked
if [ -f $directory/kill ] && [ "\$(grep -c '' $directory/asked)" -eq 2 ]; then
    kill -9 \$PPID
    exit 1
fi
differ=0
[ "\$2" != 9 ] || { differ=2; : >"\${10}"; }
echo "all \$6 10 100 50 \$differ 0"
echo "parity: \$6 scenes, 100 pixels compared, \$differ differ, 0 scenes refused"
[ \$differ = 0 ]
END
chmod +x "$directory/parity"

campaign() {
    : >"$directory/asked"
    tests/parity/campaign.sh --kept "$directory/none" "$@" "$directory" >"$directory/out" 2>"$directory/err" 9>&-
    status=$?
}

check() { # check WHAT STATUS CHUNKS LAST-LINE: the exit status, the chunks asked for, the last line
    what=$1
    if [ $status -eq "$2" ] && [ "$(grep -c '' "$directory/asked")" -eq "$3" ] &&
        { [ -z "$4" ] || tail -n 1 "$directory/out" | grep -q -- "$4"; }; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $what: exit status $status"
        sed 's/^/    /' "$directory/asked" "$directory/out" "$directory/err"
    fi
}

say() { # say WHAT PATTERN FILE
    if grep -q -- "$2" "$3"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $1: no line '$2'"
        sed 's/^/    /' "$3"
    fi
}

small='--scenes 45 --chunk 10 --jobs 1'
: >"$directory/kill"
# shellcheck disable=SC2086
{
    campaign $small --seeds "3 4"
    check "killed in the second chunk" 137 2 ''
    rm "$directory/kill"
    printf 'done 4 0 10 1' >>"$state" # being written when the campaign was killed
    campaign $small --seeds "3 4" --chunks 2
    check "goes on, and stops after two chunks" 1 2 '^campaign: 30 scenes of 2 seeds'
    say "the chunk that was not whole is drawn again" '^4 0 10$' "$directory/asked"
    campaign $small --seeds "3 4"
    check "goes on to the end" 0 3 '^campaign: 46 scenes of 2 seeds, 60 triangles, 600 pixels, 0 differing'
    say "the last chunk is what is left" '^4 20 3$' "$directory/asked"
    campaign $small --seeds "3 4"
    check "nothing is left" 0 0 '^campaign: 46 scenes'
    campaign $small --seeds "3 9"
    check "goes on after a difference" 1 3 '^campaign: 46 scenes of 2 seeds, .* 6 differing'
    say "names the scene" 'failure-9-10.scene' "$directory/err"
    campaign $small --seeds "3 9"
    check "a difference stays" 1 0 '6 differing'
    cp "$state" "$directory/kept" && rm "$state"
    campaign $small --seeds "3 4" --kept "$directory/kept"
    check "goes on with a kept state" 0 0 '^campaign: 46 scenes'
    sed -i 's/^text .*/text 0123/' "$directory/kept" && rm "$state"
    campaign $small --seeds "3 4" --kept "$directory/kept" --chunks 1
    check "a kept state of another text is left alone" 1 1 '^campaign: 10 scenes'
    sed -i 's/^text .*/text 0123/' "$state"
    campaign $small --seeds "3 4"
    check "another text" 0 6 '^campaign: 46 scenes'
    say "says so" 'no longer 0123: starts anew' "$directory/err"
    printf '#!/bin/sh\necho "parity: no reference"\nexit 1\n' >"$directory/parity"
    campaign $small --seeds 5
    check "parity that cannot run" 1 0 ''
    say "says what happened" 'could not be run, exit status 1' "$directory/err"
    campaign --scenes 0
    check "a wrong number" 2 0 ''
    tests/parity/campaign.sh --scenes 5 >"$directory/out" 2>"$directory/err"
    status=$?
    check "no build directory" 2 0 ''
}
echo "campaign: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
