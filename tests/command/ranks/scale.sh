#!/bin/sh
# Tests the simulator of ranks (build/scale): formulas, efficiencies and counts (test_scale.c); its
# options and their faults; that its output depends on nothing but them; that the guide's table is
# what it prints; its measurements; messages between two ranks with each engine of MPI; and the
# commands of the guide's page.
#
# usage: tests/command/ranks/scale.sh BUILD
set -u
build=$(cd "${1:?usage: tests/command/ranks/scale.sh BUILD}" && pwd) || exit 2
cd "$(dirname "$0")/../../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
. tests/result.sh
. tests/skip.sh
. tests/command/ranks/launch.sh
SECONDS_LIMIT=${SECONDS_LIMIT:-100}
scale=$build/scale
page=tools/guide/beyond_one_machine.md

# Its own tests are counted as they are.
"$build/test_scale" >"$work/tests" 2>"$work/errors"
grep FAILED "$work/tests"
passed=$(sed -n 's/.* \([0-9]*\) passed, .*/\1/p' "$work/tests")
failed=$(sed -n 's/.*, \([0-9]*\) failed$/\1/p' "$work/tests")
passed=${passed:-0}
failed=${failed:-1}

# Options.
exits() { # exits STATUS TEXT COMMAND...: the status, and a line of standard error
    wanted=$1
    text=$2
    shift 2
    "$@" >"$work/out" 2>"$work/err"
    status=$?
    [ "$status" = "$wanted" ] && grep -qF -e "$text" "$work/err" && return
    echo "status $status, not $wanted; or not said: $text"
    cat "$work/err"
    return 1
}
"$scale" --help >"$work/help"
result "--help" test $? -eq 0
while read -r text && read -r options; do
    # shellcheck disable=SC2086
    result "scale $options" exits 2 "$text" "$scale" $options
done <<'FAULTS'
no such scene: 'teacup'
--scene teacup
no such way: 'sort-middle'
--way sort-middle
--ranks takes a power of two: '3'
--ranks 3
--ranks takes a number from 1 to 1024: '2048'
--ranks 2048
--ranks-a-machine takes a number from 1 to 1024: '0'
--ranks-a-machine 0
--level takes a number from 1 to 400: '-1'
--level -1
--size takes a number from 16 to 65536: '12x'
--size 12x
--frames takes a number from 1 to 100000: '100001'
--frames 100001
'speed=1': a figure is NAME=VALUE
--set speed=1
'bandwidth=0': the value is a number above 0
--set bandwidth=0
'latency=-1': the value is a number that is not negative
--set latency=-1
'latency=nan': the value is a number that is not negative
--set latency=nan
cannot read /nowhere/figures
--figures /nowhere/figures
an option without its value: '--scene'
--scene
unknown option: '--colour'
--colour
this goes with --measure: '--quick'
--quick
this cannot be used with --json: '--table'
--json --table
FAULTS
printf 'vertex=2 # ns\n\n# a comment\nvertex=two\n' >"$work/bad"
result "a line of figures that is wrong is named" exits 2 "$work/bad, line 4" "$scale" --figures "$work/bad"
result "--messages in one process" exits 1 "takes two ranks" "$scale" --messages "$work/none"
result "--messages in one process writes nothing" test ! -e "$work/none"
result "--measure where nothing can be written" exits 1 "/nowhere/figures" "$scale" --measure /nowhere/figures
for option in $(grep -o '^  --[a-z-]*' "$work/help"); do
    result "$option of --help exists" sh -c 'cd "$3" && ! "$1" "$2" --help-me 2>&1 | grep -q "unknown option: .$2"' - \
        "$scale" "$option" "$work"
done

# The output depends on the options alone, is JSON, and no efficiency is above 1.
small="--level 6 --size 256 --frames 50 --ranks 128"
# shellcheck disable=SC2086
{
    "$scale" $small --json >"$work/one.json"
    "$scale" $small --json >"$work/two.json"
    "$scale" $small --json --set latency=500 >"$work/other.json"
}
result "two runs are equal" cmp "$work/one.json" "$work/two.json"
result "another latency gives other times" sh -c '! cmp -s "$1" "$2"' - "$work/one.json" "$work/other.json"
result "3 scenes, 4 ways, 8 numbers of ranks" test "$(grep -c '"scene"' "$work/one.json")" -eq 96
efficient() {
    sed -n 's/.*"efficiency": \([0-9.]*\),.*/\1/p' "$1" |
        awk '$1 <= 0 || $1 > 1.000001 { bad = 1 } END { exit bad || NR != 96 }'
}
result "efficiencies are above 0 and at most 1" efficient "$work/one.json"
if command -v python3 >/dev/null; then
    result "--json is JSON" python3 -m json.tool "$work/one.json" /dev/null
else
    skip "scale: JSON is not parsed, since python3 is absent: 'make setup' installs it"
fi

# The guide's table is what is printed.
"$scale" --table >"$work/table"
result "8 lines and a head are printed" test "$(wc -l <"$work/table")" -eq 10
while IFS= read -r line; do
    result "$page: $line" grep -qxF -e "$line" "$page"
done <"$work/table"

# What is measured is read again; a model has the triangles that are counted.
measured() { grep -c '^[a-z_]*=[0-9.e+-]* # ' "$1"; }
result "--measure" "$scale" --measure "$work/figures" --quick
result "--measure measures 18 figures" test "$(measured "$work/figures")" -eq 18
result "no measured time is 0" sh -c '! grep -E "^(vertex|fragment|read|touch|merge|extract|frame_empty|compress_empty|disk)=0 " "$1"' - "$work/figures"
result "measured figures are used" sh -c '"$1" --list --figures "$2" | grep -c measured | grep -qx 18' - "$scale" "$work/figures"
result "--measure leaves nothing else" test "$(ls "$work" | grep -c '^figures')" -eq 1
result "--model" "$scale" --level 5 --model "$work/model.obj"
triangles=$("$scale" --level 5 --scene triangles --ranks 1 | sed -n 's/^scene triangles: \([0-9]*\) triangles.*/\1/p')
result "the model has $triangles triangles" test "$(grep -c '^f ' "$work/model.obj")" -eq "${triangles:-0}"

# Messages between two ranks.
for engine in $engines; do
    if ! has_engine "$engine"; then
        skip "scale: messages of $engine: it is absent; make setup-mpi installs it"
        continue
    fi
    cp "$work/figures" "$work/$engine"
    result "messages of $engine" over_ranks "$engine" 2 "$build/$engine/scale" --messages "$work/$engine"
    result "messages of $engine are two figures" test "$(measured "$work/$engine")" -eq 20
    over_ranks "$engine" 2 "$build/$engine/scale" --level 2 >"$work/refused" 2>&1
    result "a simulation over ranks of $engine fails" test $? -ne 0
    result "a simulation over ranks of $engine is refused" grep -q 'works in one process' "$work/refused"
done

# The page's job script is a shell script for Slurm, and the options of its commands exist.
awk -v language=sh -v folder="$work/block" -f tests/packaging/blocks.awk "$page"
script=$(grep -l '^#SBATCH' "$work"/block*)
result "the page has one job script" test -f "${script:-none}"
result "the job script is a shell script" sh -n "$script"
result "the job script asks for ranks and starts them" grep -q '^srun .*gnomon spin' "$script"
result "the job script's directives come first" sh -c 'awk "/^#SBATCH/ { if (code) exit 1 } !/^#/ && NF { code = 1 }" "$1"' - "$script"
for command in render spin; do
    "$build/gnomon" "$command" --help-all >"$work/help-$command"
    options=$(grep -o "gnomon $command .*" "$page" | grep -v '`' | sed 's/ #.*//' | grep -oE -e ' --[a-z]+' | sort -u)
    result "$page: gnomon $command has options" test -n "$options"
    for option in $options; do
        result "$page: gnomon $command $option" grep -qE -e "$option([^a-z-]|\$)" "$work/help-$command"
    done
done

# Its commands without MPI work, with fewer frames.
if command -v parallel >/dev/null; then
    mkdir "$work/parallel"
    cp "$work/model.obj" "$work/parallel/head.obj"
    printf -- '--eye 3,1,0 --fov 30\n--eye 0,1,-3\n' >"$work/parallel/views.txt"
    cat "$work"/block* | grep -E '^(seq|parallel -j) ' | sed 's/ 359 / 2 /; s/-j 8/-j 2/; s/-P 8/-P 2/' >"$work/commands"
    result "the page has three commands without MPI" test "$(wc -l <"$work/commands")" -eq 3
    while IFS= read -r command; do
        result "$page: $command" env PATH="$build:$PATH" HOME="$work" sh -c 'cd "$1" && eval "$2" && test "$(ls | grep -c "\.png$")" -ge 2 && mkdir -p "${2%% *}" && mv ./*.png "${2%% *}"' - "$work/parallel" "$command"
    done <"$work/commands"
    result "they draw what options of the camera and of places say" sh -c 'cd "$1" && ! cmp -s parallel/view_1.png parallel/view_2.png && ! cmp -s seq/frame_0000.png seq/frame_0002.png' - "$work/parallel"
else
    skip "scale: commands of GNU parallel do not run, since it is absent: 'make setup-mpi' installs it"
fi

echo "scale: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
