#!/bin/sh
# Compares many scenes of several seeds with the reference, in chunks, two hours and more. GNU parallel
# runs the chunks, on several machines if it is told so. May be killed at any moment: the next run goes
# on with the chunks that are left. The state is a text file, which names the text of the library, the
# reference and the generator by a hash; if that text has changed, the campaign starts anew. A chunk with
# differences is kept as a scene file, and the campaign goes on. Progress is on stderr; the last line on
# stdout has the figures. Exit status: 0 if all scenes are equal, 1 if one differs or a chunk cannot be
# run, 2 for a wrong command line.
set -u
usage='usage: tests/parity/campaign.sh [--scenes N] [--seeds "S..."] [--chunk N] [--jobs N] [--chunks N] BUILD
  (from the root of the project, with BUILD/parity up to date, as `make campaign` ensures)
  --scenes N   scenes in all, shared evenly by the seeds (500000)
  --seeds LIST seeds (1 to 10)
  --chunk N    scenes of a chunk (2500)
  --jobs N     chunks that are drawn at a time, on each machine (2)
  --chunks N   stops after this many chunks, with exit status 1 if some are left
  --one CHUNK  what parallel runs: draws the chunk "SEED SKIP SCENES NUMBER OF" and prints its line of the state
Environment: PARALLEL has options for parallel, such as "--sshloginfile FILE"; its machines share this directory.
State: BUILD/campaign/state.txt, and there the failing scenes, failure-SEED-SKIP.scene. To go on with
another build directory, or where the directory is not shared, copy the state there.'
scenes=500000
seeds='1 2 3 4 5 6 7 8 9 10'
chunk=2500
jobs=2
most=-1
one=

fault() {
    echo "campaign: $1" >&2
    exit "${2:-2}"
}

while [ $# -gt 1 ]; do
    case $1 in
    --scenes) scenes=$2 ;;
    --seeds) seeds=$2 ;;
    --chunk) chunk=$2 ;;
    --jobs) jobs=$2 ;;
    --chunks) most=$2 ;;
    --one) one=$2 ;;
    *) fault "unknown option: $1 (--help says more)" ;;
    esac
    shift 2
done
case ${1:-} in
--help) echo "$usage"; exit 0 ;;
'') fault "the build directory is missing (--help says more)" ;;
-*) fault "unknown option, or no value after it: $1 (--help says more)" ;;
esac
build=$1
for number in "$scenes" "$chunk" "$jobs"; do
    case $number in '' | 0 | *[!0-9]*) fault "not a number above 0: '$number'" ;; esac
done
seed_count=0
for seed in $seeds; do
    case $seed in *[!0-9]*) fault "not a seed: '$seed'" ;; esac
    seed_count=$((seed_count + 1))
done
[ $seed_count -gt 0 ] || fault "no seeds"
[ -x "$build/parity" ] || fault "there is no $build/parity"

directory=$build/campaign
state=$directory/state.txt
mkdir -p "$directory" || exit 1

# Draws a chunk, and prints its line of the state. What a killed campaign left running may still write
# to the log.
draw_chunk() { # draw_chunk SEED SKIP SCENES NUMBER OF
    log=$directory/log-$1-$2.txt
    keep=$directory/failure-$1-$2.scene
    label="$4 of $5: seed $1, skip $2"
    rm -f "$log"
    "$directory/parity" --seed "$1" --skip "$2" --scenes "$3" --jobs 1 --keep "$keep" >"$log" 2>&1
    status=$?
    found=$(awk -v status=$status '
        $1 == "all" && NF == 7 { triangles = $3; pixels = $4 }
        /^skipped: colour/ { version = 1 }
        /^parity: [0-9]+ scenes,.*refused$/ { scenes = $2; differ = $7; refused = $9 }
        END { if (scenes && !version) printf "%s %.0f %.0f %.0f %d\n", scenes, triangles, pixels, differ, refused }
        ' "$log")
    # shellcheck disable=SC2086
    set -- "$1" "$2" "$3" $found
    if [ "${4:-}" != "$3" ] || { [ $status != 0 ] && [ "$7" = 0 ] && [ "$8" = 0 ]; }; then
        tail -n 5 "$log" >&2
        fault "$label: could not be run, exit status $status; the output is in $log" 1
    fi
    if [ $status = 0 ]; then
        echo "campaign: $label: $3 scenes are equal" >&2
    else
        echo "campaign: $label: $7 pixels differ, $8 scenes refused: $keep" >&2
    fi
    rm -f "$log"
    echo "done $1 $2 $found end"
}

if [ -n "$one" ]; then
    exec 9>&-
    # shellcheck disable=SC2086
    set -- $one
    [ $# -eq 5 ] || fault "--one takes five numbers: '$one'"
    draw_chunk "$@"
    exit 0
fi
command -v parallel >/dev/null 2>&1 || fault "GNU parallel is missing; 'make setup' installs it" 1
if command -v flock >/dev/null 2>&1; then
    exec 9>"$directory/lock"
    flock -n 9 || fault "another campaign is running in $directory" 1
fi

# The state: a line with the text's hash; a line for each chunk that is done,
# done SEED SKIP SCENES TRIANGLES PIXELS DIFFERING REFUSED end. A line that was being written when the
# campaign was killed has no end and is dropped.
text=$(find include src reference tests/parity tools/threads -type f \( -name "*.[ch]" -o -name "*.inl" \) | LC_ALL=C sort | xargs cksum | cksum | cut -d " " -f 1)
before=$(sed -n 's/^text //p' "$state" 2>/dev/null)
if [ -n "$before" ] && [ "$before" != "$text" ]; then
    echo "campaign: the text is $text, no longer $before: starts anew" >&2
    rm -f "$state" "$directory"/failure-*.scene
fi
{
    echo "text $text"
    [ ! -f "$state" ] || awk '$1 == "done" && NF == 9 && $9 == "end"' "$state"
} >"$state.partial" && mv "$state.partial" "$state" || exit 1

# A rebuild while the campaign runs must not change what runs.
cp "$build/parity" "$directory/parity" || exit 1

# Prints scenes, triangles, pixels, differing pixels and refused scenes, of this campaign's chunks: the
# state may also have those of other seeds, numbers of scenes and sizes of chunks.
sums() {
    awk -v seeds="$seeds" -v per="$per_seed" -v chunk="$chunk" '
        BEGIN { split(seeds, s, " "); for (i in s) wanted[s[i]] = 1 }
        $1 == "done" && ($2 in wanted) && $3 % chunk == 0 && $4 == (per - $3 < chunk ? per - $3 : chunk) {
            n += $4; t += $5; p += $6; d += $7; r += $8 }
        END { printf "%d %.0f %.0f %.0f %d\n", n, t, p, d, r }' "$state"
}

per_seed=$(((scenes + seed_count - 1) / seed_count))
wanted=$((per_seed * seed_count))

# Prints SEED SKIP SCENES of every chunk that is left, in order.
chunks_left() {
    skip=0
    while [ $skip -lt $per_seed ]; do
        size=$((per_seed - skip < chunk ? per_seed - skip : chunk))
        for seed in $seeds; do
            grep -q "^done $seed $skip $size " "$state" && continue
            [ "$most" -ne 0 ] || return 0
            most=$((most - 1))
            echo "$seed $skip $size"
        done
        skip=$((skip + chunk))
    done
}

# Parallel appends whole lines to the state, and keeps the lock (file 9) as long as it runs.
chunks=$directory/chunks.txt
chunks_left >"$chunks"
parallel --quote --jobs "$jobs" --workdir . --halt soon,fail=1 --arg-file "$chunks" \
    tests/parity/campaign.sh --one "{} {#} $(grep -c '' "$chunks")" "$build" </dev/null >>"$state" &
workers=$!
trap 'kill $workers 2>/dev/null; exit 1' INT TERM HUP
wait $workers
status=$?
[ $status -eq 0 ] || fault "parallel ended with exit status $status; the chunks that were drawn are in $state" 1

# shellcheck disable=SC2046
set -- $(sums)
for kept in "$directory"/failure-*.scene; do
    [ ! -f "$kept" ] || echo "campaign: a failing scene: $kept" >&2
done
[ "$1" -eq "$wanted" ] || echo "campaign: $((wanted - $1)) scenes are left" >&2
echo "campaign: $1 scenes of $seed_count seeds, $2 triangles, $3 pixels, $4 differing, $5 scenes refused (text $text)"
[ "$1" -eq "$wanted" ] && [ "$4" -eq 0 ] && [ "$5" -eq 0 ]
