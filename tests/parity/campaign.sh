#!/bin/sh
# Compares many scenes of several seeds with the reference, in chunks, two hours and more. May be
# killed at any moment: the next run goes on with the chunks that are left. The state is a text file, which names the text of the library, the
# reference and the generator by a hash; if that text has changed, the campaign starts anew. A chunk
# with differences is kept as a scene file, and the campaign goes on. Progress is on stderr; the last
# line on stdout has the figures. Exit status: 0 if all scenes are equal, 1 if one differs or a chunk
# cannot be run, 2 for a wrong command line.
set -u
usage='usage: tests/parity/campaign.sh [--scenes N] [--seeds "S..."] [--chunk N] [--jobs N] [--chunks N] [--ranks N] BUILD
  (from the root of the project, with BUILD/parity up to date, as `make campaign` ensures)
  --scenes N   scenes in all, shared evenly by the seeds (500000)
  --seeds LIST seeds (1 to 10)
  --chunk N    scenes of a chunk (2500)
  --jobs N     processes that share a chunk (2; 1 with --ranks)
  --chunks N   stops after this many chunks, with exit status 1 if some are left
  --kept FILE  the state to begin with if there is none
  --ranks N    draws N chunks at a time, with N processes of MPI, on other machines too if they share
               this directory: $MPIRUN (mpirun) starts them, with the options in $MPIRUN_FLAGS, such as
               "--hostfile FILE". A campaign may be begun with ranks and go on without, or the other way
  --farm FILE  the program for the ranks (BUILD/mpi/farm)
  --one LIST   what each rank runs: draws the chunk "SEED SKIP SCENES" and prints its line of the state
State: BUILD/campaign/state.txt, and there the failing scenes, failure-SEED-SKIP.scene. To go on with
another build directory or on another machine, name a copy of the state by --kept.'
scenes=500000
seeds='1 2 3 4 5 6 7 8 9 10'
chunk=2500
jobs=
most=-1
ranks=
farm=
one=
kept=

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
    --kept) kept=$2 ;;
    --ranks) ranks=$2 ;;
    --farm) farm=$2 ;;
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
jobs=${jobs:-$([ -n "$ranks" ] && echo 1 || echo 2)}
farm=${farm:-$build/mpi/farm}
for number in "$scenes" "$chunk" "$jobs" "${ranks:-1}"; do
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

child=
trap '[ -z "$child" ] || kill "$child" 2>/dev/null; exit 1' INT TERM HUP

# Draws a chunk, and sets `line` to its line of the state. What a killed campaign left running may
# still write to the log.
draw_chunk() { # draw_chunk SEED SKIP SCENES LOG
    log=$4
    keep=$directory/failure-$1-$2.scene
    rm -f "$log"
    "$directory/parity" --seed "$1" --skip "$2" --scenes "$3" --jobs "$jobs" --keep "$keep" \
        >"$log" 2>&1 9>&- &
    child=$!
    wait $child
    status=$?
    child=
    line=$(awk -v status=$status '
        $1 == "all" && NF == 7 { triangles = $3; pixels = $4 }
        /^skipped: colour/ { version = 1 }
        /^parity: [0-9]+ scenes,.*refused$/ { scenes = $2; differ = $7; refused = $9 }
        END { if (scenes && !version) printf "%s %d %.0f %.0f %.0f %d end\n", scenes, status, triangles, pixels, differ, refused }
        ' "$log")
    # shellcheck disable=SC2086
    set -- "$1" "$2" "$3" $line
    if [ "${4:-}" != "$3" ] || { [ "$5" != 0 ] && [ "$8" = 0 ] && [ "$9" = 0 ]; }; then
        tail -n 5 "$log" >&2
        fault "seed $1, skip $2: could not be run, exit status $status; the output is in $log" 1
    fi
    line="done $1 $2 $4 $6 $7 $8 $9 end"
    [ "$5" = 0 ] || echo "campaign: seed $1, skip $2: $8 pixels differ, $9 scenes refused: $keep" >&2
}

if [ -n "$one" ]; then
    # shellcheck disable=SC2086
    set -- $one
    [ $# -eq 3 ] || fault "not a seed, a number of scenes to skip and a number of scenes: '$one'"
    draw_chunk "$1" "$2" "$3" "$directory/log-$1-$2.txt"
    rm -f "$log"
    echo "$line"
    exit 0
fi
[ -z "$ranks" ] || [ -x "$farm" ] || fault "there is no $farm"
if command -v flock >/dev/null 2>&1; then
    exec 9>"$directory/lock"
    flock -n 9 || fault "another campaign is running in $directory" 1
fi

# The state: a line with the text's hash; a line for each chunk that is done,
# done SEED SKIP SCENES TRIANGLES PIXELS DIFFERING REFUSED end. A line that was being written when the
# campaign was killed has no end and is dropped.
text=$(find include src reference tests/parity tools/threads -name "*.[ch]" -type f | LC_ALL=C sort | xargs cksum | cksum | cut -d " " -f 1)
[ -f "$state" ] || ! grep -q -x "text $text" "$kept" 2>/dev/null || cp "$kept" "$state" || exit 1
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

report_progress() { # report_progress SEED
    # shellcheck disable=SC2046
    set -- "$1" $(sums)
    seconds=$(($(date +%s) - began))
    rate=$((drawn / (seconds > 0 ? seconds : 1)))
    left=$(((wanted - $2) / (rate > 0 ? rate : 1) / 60))
    echo "campaign: seed $1, $2 of $wanted scenes, $5 pixels differ, $rate scenes a second, $left minutes left" >&2
}

per_seed=$(((scenes + seed_count - 1) / seed_count))
wanted=$((per_seed * seed_count))
began=$(date +%s)
drawn=0

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

quoted() { printf '%s\n' "$1" | sed "s/'/'\\\\''/g; s/^/'/; s/\$/'/"; }

# The chunks are tasks of the farm, which appends to the state.
draw_over_ranks() {
    chunks_left >"$directory/chunks.txt"
    [ -s "$directory/chunks.txt" ] || return 0
    while read -r seed skip size; do
        printf 'done %s %s %s\ttests/parity/campaign.sh --one "%s %s %s" --jobs %s %s\n' \
            "$seed" "$skip" "$size" "$seed" "$skip" "$size" "$jobs" "$(quoted "$build")"
    done <"$directory/chunks.txt" >"$directory/tasks.txt"
    # The ranks keep the lock (file 9) as long as they run, even if this script is killed.
    # shellcheck disable=SC2086
    ${MPIRUN:-mpirun} ${MPIRUN_FLAGS:-} -n "$ranks" "$farm" --ranks "$ranks" --name campaign --stop \
        --tasks "$directory/tasks.txt" --results "$state" >&2 </dev/null &
    child=$!
    wait $child
    status=$?
    child=
    [ $status -eq 0 ] || fault "the ranks ended with exit status $status; the chunks that they have drawn are in $state" 1
}

if [ -n "$ranks" ]; then
    draw_over_ranks
else
    chunks_left >"$directory/chunks.txt"
    while read -r seed skip size <&3; do
        draw_chunk "$seed" "$skip" "$size" "$directory/log.txt"
        echo "$line" >>"$state"
        drawn=$((drawn + size))
        report_progress "$seed"
    done 3<"$directory/chunks.txt"
fi

# shellcheck disable=SC2046
set -- $(sums)
for kept in "$directory"/failure-*.scene; do
    [ ! -f "$kept" ] || echo "campaign: a failing scene: $kept" >&2
done
[ "$1" -eq "$wanted" ] || echo "campaign: $((wanted - $1)) scenes are left" >&2
echo "campaign: $1 scenes of $seed_count seeds, $2 triangles, $3 pixels, $4 differing, $5 scenes refused (text $text)"
[ "$1" -eq "$wanted" ] && [ "$4" -eq 0 ] && [ "$5" -eq 0 ]
