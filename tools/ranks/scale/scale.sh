#!/bin/sh
# Measures what the cost model needs, prints the predictions for 1 to 1,024 ranks, and compares those
# for 1 and 2 ranks with the times that the command takes here. `make scale` runs it.
#
# Figures go to BUILD/scale.figures. Without MPI, the figures of messages are the stated ones, and
# nothing is compared.
#
# usage: tools/ranks/scale/scale.sh BUILD        (from the root of the project)
# environment: SCALE_ENGINE=openmpi or mpich; RANKS_SIZE=4096, pixels a side of the scene `pixels` in
#     the comparison; RANKS_FRAMES=60, frames of the scene `frames` there; SCALE_REPEATS=3, runs of
#     which the shortest counts; SCALE_SCENES="triangles pixels frames", what is compared;
#     GNOMON=BUILD/ENGINE/gnomon, the command; SCALE_QUICK=yes, less exact figures in seconds
set -eu
. tests/command/ranks/launch.sh
build=${1:?usage: tools/ranks/scale/scale.sh BUILD}
figures=$build/scale.figures
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
repeats=${SCALE_REPEATS:-3}
size=${RANKS_SIZE:-4096}
frames=${RANKS_FRAMES:-60}

engine=${SCALE_ENGINE:-}
for one in $engines; do
    [ -n "$engine" ] || ! has_engine "$one" || [ ! -x "$build/$one/scale" ] || engine=$one
done

now() { date +%s.%N; }

# used: writes the processor time of all commands that this shell has waited for, to $work/used.
used() {
    times >"$work/times"
    sed -n '2s/[ms]/ /gp' "$work/times" | awk '{ print 60 * $1 + $2 + 60 * $3 + $4 }' >"$work/used"
}

# shortest COMMAND...: the seconds of the shortest of several runs, and the least processor time.
shortest() {
    least=
    for run in $(seq "$repeats"); do
        used
        before=$(cat "$work/used")
        begin=$(now)
        "$@" >"$work/said" 2>&1 || {
            echo "scale: run $run of $* failed:" >&2
            cat "$work/said" >&2
            return 1
        }
        end=$(now)
        used
        least=$(echo "$begin $end $before $(cat "$work/used") $least" | awk '{
            wall = $2 - $1; busy = $4 - $3
            print NF < 5 || wall < $5 ? wall : $5, NF < 5 || busy < $6 ? busy : $6 }')
    done
    echo "$least"
}

"$build/scale" --measure "$figures" ${SCALE_QUICK:+--quick}
if [ -n "$engine" ]; then
    gnomon=${GNOMON:-$build/$engine/gnomon}
    over_ranks "$engine" 2 "$build/$engine/scale" --messages "$figures"
    start=$(shortest over_ranks "$engine" 2 "$gnomon" --version)
    start=${start% *}
    echo "start=$start # s: 2 ranks of gnomon --version, $engine" >>"$figures"
else
    echo "scale: no engine of MPI is here ('make setup-mpi mpi'): figures of messages are stated ones"
fi
"$build/scale" --figures "$figures" ${SCALE_QUICK:+--ranks 4}
[ -n "$engine" ] || exit 0

# predicted WAY RANKS SCALE-OPTION...: the seconds by the simulation, of ranks on this machine.
predicted() {
    way=$1
    ranks=$2
    shift 2
    "$build/scale" --figures "$figures" --ranks 2 --ranks-a-machine 2 --json --way "$way" "$@" |
        sed -n "s/.*\"ranks\": $ranks,.*\"seconds\": \([0-9.e+-]*\),.*/\1/p"
}

# compare SCENE WAY SCALE-OPTIONS COMMAND...
compare() {
    scene=$1
    way=$2
    options=$3
    shift 3
    for ranks in 1 2; do
        # shellcheck disable=SC2086
        expected=$(predicted "$way" "$ranks" --scene "$scene" $options)
        took=$(shortest over_ranks "$engine" "$ranks" "$@")
        echo "$scene $way $ranks $expected $took" |
            awk -v start="$start" '{
                printf "  %-10s %-11s %5d %11.3f %10.3f %7.2f", $1, $2, $3, $4, $5, $4 / $5
                if ($3 == 1)
                    printf " %11.3f %10.3f %7.2f", $4 - start, $6, ($4 - start) / $6
                printf "\n"
            }'
    done
}

echo
echo "compared with $gnomon over $engine, the least of $repeats runs; ratio: predicted / measured. On the right, of one rank,"
echo "without starting: the processor time, which other programs disturb less. Two ranks wait busily."
echo "  scene      way         ranks   predicted   measured   ratio   predicted  processor   ratio"
for scene in ${SCALE_SCENES:-triangles pixels frames}; do
    "$build/scale" --scene "$scene" --model "$work/model.obj"
    case $scene in
    frames)
        compare frames frames "--frames $frames" "$gnomon" spin "$work/model.obj" --frames "$frames" -o "$work/%04d.png"
        compare frames animation "--frames $frames" "$gnomon" spin "$work/model.obj" --frames "$frames" -o "$work/all.png"
        ;;
    *)
        side=1024
        [ "$scene" != pixels ] || side=$size
        for way in first last; do
            compare "$scene" sort-$way "--size $side" "$gnomon" render "$work/model.obj" --size "${side}x$side" --sort $way -o "$work/one.png"
        done
        ;;
    esac
done
