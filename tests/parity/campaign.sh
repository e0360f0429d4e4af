#!/bin/sh
# Compares many scenes of several seeds with the reference, in chunks that GNU parallel runs: two hours
# and more. It may be killed at any moment: the next run with the same words draws the chunks that are
# left, unless the library, the reference or the generator has changed. A chunk in which a pixel differs is
# kept as a scene file. Exit status 0: all scenes were drawn, and are equal.
# usage: campaign.sh BUILD SCENES "SEED..." JOBS   (from the root of the project; BUILD has parity)
# Environment: PARALLEL has options for parallel, such as "--sshloginfile FILE"; its machines share this
# directory.
set -eu
build=$1 scenes=$2 seeds=$3 jobs=$4
chunk=2500
command -v parallel >/dev/null || { echo "campaign: GNU parallel is missing; 'make setup' installs it" >&2; exit 1; }

text=$(find include src reference tests/parity tools/threads -name '*.[ch]' -o -name '*.inl' | LC_ALL=C sort | xargs cksum | cksum)
directory=$build/campaign/$(echo "$text $scenes $seeds" | cksum | cut -d ' ' -f 1)
mkdir -p "$directory"
exec 9>"$directory/lock"
flock -n 9 || { echo "campaign: another one is running in $directory" >&2; exit 1; }
# A rebuild must not change what runs.
[ -e "$directory/parity" ] || cp "$build/parity" "$directory/parity"

each=$((scenes / $(echo "$seeds" | wc -w)))
for skip in $(seq 0 $chunk $((each - 1))); do
    for seed in $seeds; do
        echo "$seed $skip $((each - skip < chunk ? each - skip : chunk))"
    done
done >"$directory/chunks"
parallel --colsep ' ' --jobs "$jobs" --workdir . --joblog "$directory/jobs" --resume-failed --arg-file "$directory/chunks" \
    "'$directory/parity' --seed {1} --skip {2} --scenes {3} --jobs 1 --keep '$directory/{1}-{2}.scene' >'$directory/{1}-{2}.log' 2>&1
    status=\$?; echo \"campaign: chunk {#} of $(wc -l <"$directory/chunks"), seed {1}: \$(tail -n 1 '$directory/{1}-{2}.log')\"; exit \$status" \
    </dev/null >&2 || echo "campaign: not every chunk is equal: $directory has their output and scenes" >&2

tail -q -n 1 "$directory"/*.log | awk -v wanted=$((each * $(echo "$seeds" | wc -w))) '
    /^parity: [0-9]+ scenes,.*refused$/ { scenes += $2; pixels += $4; differ += $7; refused += $9 }
    END {
        printf "campaign: %d of %d scenes, %.0f pixels, %d differ, %d scenes refused\n", scenes, wanted, pixels, differ, refused
        exit scenes != wanted || differ > 0 || refused > 0
    }'
