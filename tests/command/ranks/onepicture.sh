#!/bin/sh
# One picture over many ranks: the bytes of one process for 1 to 4 ranks with both engines of MPI, by
# rows and by triangles, in every shader; scenes of the comparison with the reference, divided in both
# ways; and what happens if a rank is killed, a disk is full, a file cannot be read or written.
#
# usage: [MODELS=DIRECTORY] tests/command/ranks/onepicture.sh BUILD        MODELS has OBJ files to draw as well
set -u
build=$(cd "${1:?usage: tests/command/ranks/onepicture.sh BUILD}" && pwd) || exit 2
cd "$(dirname "$0")/../../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
. tests/result.sh
. tests/skip.sh
. tests/command/ranks/launch.sh
SECONDS_LIMIT=${SECONDS_LIMIT:-100}
gnomon=$build/gnomon

present=
for engine in $engines; do
    if has_engine "$engine" && [ -x "$build/$engine/gnomon" ]; then
        present="$present $engine"
    else
        skip "one picture over ranks of $engine: it is absent; make setup-mpi installs it"
    fi
done

# Waves of triangles with colours of their own, crossed by others; every second layer lies exactly on
# the layer before it, with other colours and its triangles in another order.
sheet() {
    awk -v n="$1" 'BEGIN {
        for (layer = 0; layer < 4; ++layer)
            for (y = 0; y <= n; ++y)
                for (x = 0; x <= n; ++x) {
                    z = layer < 2 ? sin(x * 9 / n) * cos(y * 7 / n) / 4 : (x - y) / n / 2
                    printf "v %.6f %.6f %.6f %.3f %.3f %.3f\n", x / n, y / n, z, x * 7 % 11 / 10,
                        (y + layer) * 5 % 7 / 6, (layer * 3 + x) % 4 / 3
                    printf "vt %.5f %.5f\n", x / n * 3, y / n * 3
                }
        for (layer = 0; layer < 4; ++layer)
            for (i = 0; i < n * n; ++i) {
                k = layer % 2 ? n * n - 1 - i : i
                a = layer * (n + 1) * (n + 1) + int(k / n) * (n + 1) + k % n + 1
                b = a + n + 1
                printf "f %d/%d %d/%d %d/%d\nf %d/%d %d/%d %d/%d\n", a, a, a + 1, a + 1, b, b, a + 1,
                    a + 1, b + 1, b + 1, b, b
            }
    }'
}
sheet 40 >"$work/sheet.obj"
"$build/make-models" "$work" || exit 1

# draws ENGINE N OUT OPTION...: draws over N ranks.
draws() {
    with=$1
    count=$2
    out=$3
    shift 3
    over_ranks "$with" "$count" "$build/$with/gnomon" render "$@" -o "$out" </dev/null
}

# equals ENGINE N FILE OPTION...: what N ranks draw has the bytes of FILE.
equals() {
    file=$3
    drawn=$work/drawn.${file##*.}
    rm -f "$drawn"
    engine_of=$1
    count_of=$2
    shift 3
    draws "$engine_of" "$count_of" "$drawn" "$@" && cmp "$file" "$drawn"
}

# Every look by one process, and over ranks in both ways: engines and numbers of ranks take turns.
looks='--shader vertex-color
--shader unlit --background 10203040
--shader flat --shadows --cull back
--shader gouraud --samples 4
--shader toon --bands 5 --cull front
--shader phong --shadows --samples 4
--shader blinn-phong --rotate y,70 --eye 0.5,0.7,0.6
--shader normals --samples 4
--shader depth
--shader flat --cull back --eye 0.5,0.5,0.5 --near 0.2 --samples 4
--wireframe
--points=5 --orthographic 2
--shader unlit --texture TEXTURE --filter mipmap'
turn=0
pick() { # pick N: the engine and number of ranks of turn N
    picked_ranks=$((2 + $1 % 3))
    set -- $1 $present
    shift $((1 + $1 % ($# - 1)))
    picked=$1
}
texture=$(find "$work" -name '*diffuse*.tga' | head -n 1)
while [ -n "$present" ] && read -r look; do
    look=$(echo "$look" | sed "s|TEXTURE|$texture|")
    model=$work/sheet.obj
    [ $((turn % 2)) = 0 ] || model=$work/teapot.obj
    case $look in *TEXTURE* | *mipmap*) model=$work/sheet.obj ;; esac
    suffix=$(echo raw tga ppm raw | cut -d' ' -f$((1 + turn % 4)))
    # Odd sizes, so that the first band has an odd number of rows.
    set -- "$model" $look --size $((211 + turn))x$((160 + turn))
    if ! "$gnomon" render "$@" -o "$work/one.$suffix" >"$work/said" 2>&1; then
        failed=$((failed + 1))
        echo "FAILED: one process: $*"
        cat "$work/said"
    fi
    pick $turn
    result "by rows, $picked, $picked_ranks ranks: $*" equals "$picked" "$picked_ranks" "$work/one.$suffix" "$@"
    pick $((turn + 1))
    result "by triangles, $picked, $picked_ranks ranks: $*" \
        equals "$picked" "$picked_ranks" "$work/one.$suffix" "$@" --sort last
    turn=$((turn + 1))
done <<END
$looks
END

# Fewer rows than ranks have parts.
"$gnomon" render "$work/teapot.obj" --size 33x7 --samples 4 -o "$work/one.raw" >/dev/null
for engine in $present; do
    result "$engine: seven rows" equals "$engine" 4 "$work/one.raw" "$work/teapot.obj" --size 33x7 --samples 4
    result "$engine: seven rows by triangles" equals "$engine" 4 "$work/one.raw" "$work/teapot.obj" --size 33x7 \
        --samples 4 --sort last
done

# Without the depth test the order of triangles decides: exact by rows, refused by triangles.
refuses() {
    file=$work/refused.png
    if "$@" -o "$file" >"$work/words" 2>&1; then
        echo "drawn"
        return 1
    fi
    cat "$work/words"
    [ ! -e "$file" ] && grep -q -e "$words" "$work/words"
}
says_nothing_of() { # says_nothing_of WORDS COMMAND...
    not_said=$1
    shift
    "$@" >"$work/words" 2>&1 || { cat "$work/words"; return 1; }
    cat "$work/words"
    ! grep -q -e "$not_said" "$work/words"
}
for engine in $present; do
    set -- "$work/sheet.obj" --no-depth-test --size 99x77
    "$gnomon" render "$@" -o "$work/one.raw" >/dev/null
    result "$engine: no depth test, by rows" equals "$engine" 3 "$work/one.raw" "$@"
    result "$engine: no depth test, something is drawn" says_nothing_of 'nothing was drawn' over_ranks "$engine" 2 \
        "$build/$engine/gnomon" render "$@" -o "$work/two.raw"
    words='no-depth-test.*order of the triangles'
    result "$engine: no depth test, by triangles" refuses over_ranks "$engine" 2 "$build/$engine/gnomon" render "$@" --sort last
    words='--statistics'
    result "$engine: statistics" refuses over_ranks "$engine" 2 "$build/$engine/gnomon" render "$work/sheet.obj" --statistics
done

# PNG files and those of the depth: the bytes of one rank, the pixels of one process.
same_png() {
    rm -f "$work/n.png" "$work/nd.png"
    draws "$1" "$2" "$work/n.png" "$work/teapot.obj" --shadows --samples 4 --size 260x201 --depth "$work/nd.png" $3 &&
        cmp "$work/n.png" "$work/first.png" && cmp "$work/nd.png" "$work/firstd.png"
}
# Every checksum of a PNG is right, and it holds as many bytes as its header says.
sound_png() {
    python3 -c 'import struct, sys, zlib
data = open(sys.argv[1], "rb").read()
at, stream = 8, b""
while at < len(data):
    size, kind = struct.unpack(">I4s", data[at:at + 8])
    body = data[at + 8:at + 8 + size]
    assert struct.unpack(">I", data[at + 8 + size:at + 12 + size])[0] == zlib.crc32(kind + body), kind
    stream += body if kind == b"IDAT" else b""
    at += 12 + size
width, height, bits, color = struct.unpack(">IIBB", data[16:26])
assert kind == b"IEND"
assert len(zlib.decompress(stream)) == height * (1 + width * bits // 8 * (4 if color == 6 else 1))' "$1"
}
"$gnomon" render "$work/teapot.obj" --shadows --samples 4 --size 260x201 -o "$work/one.png" --depth "$work/oned.png" >/dev/null
first=
for engine in $present; do
    if [ -z "$first" ]; then
        first=$engine
        draws "$engine" 1 "$work/first.png" "$work/teapot.obj" --shadows --samples 4 --size 260x201 \
            --depth "$work/firstd.png" >/dev/null
        result "$engine: the picture of one rank" "$gnomon" diff "$work/one.png" "$work/first.png"
        result "$engine: the depth of one rank" "$gnomon" diff "$work/oned.png" "$work/firstd.png"
        result "$engine: checksums of the picture" sound_png "$work/first.png"
        result "$engine: checksums of the depth" sound_png "$work/firstd.png"
    fi
    for n in 1 2 3 4; do
        result "$engine, $n ranks: PNG by rows" same_png "$engine" $n ''
        result "$engine, $n ranks: PNG by triangles" same_png "$engine" $n '--sort last'
    done
done

# Standard output, which has no places to write to.
piped() {
    draws "$1" 3 - "$work/teapot.obj" --shadows --samples 4 --size 260x201 2>"$work/words" | cmp - "$work/first.png"
}
for engine in $present; do
    result "$engine: PNG to standard output" piped "$engine"
done

# Processes that srun has started without MPI would each write the whole picture.
for program in "$gnomon" $(for engine in $present; do echo "$build/$engine/gnomon"; done); do
    words='srun --mpi='
    result "$program: srun without MPI" refuses env SLURM_STEP_NUM_TASKS=4 "$program" render "$work/teapot.obj"
    result "$program: srun of one process" env SLURM_STEP_NUM_TASKS=1 "$program" --version
done

# Without a launcher the command for MPI is alone and starts nothing.
alone() { # alone PROGRAM: a picture in tiles, whose summary names no ranks
    "$1" render "$work/teapot.obj" --size 17000x9 -o "$work/two.raw" >"$work/words" 2>&1 || { cat "$work/words"; return 1; }
    cat "$work/words"
    ! grep -q rank "$work/words" && cmp "$work/one.raw" "$work/two.raw"
}
"$gnomon" render "$work/teapot.obj" --size 17000x9 -o "$work/one.raw" >/dev/null
for engine in $present; do
    result "$engine: without a launcher" alone "$build/$engine/gnomon"
done

# Real models.
if [ -z "${MODELS:-}" ]; then
    echo "real models: none; MODELS names a folder of OBJ files"
else
    find "$MODELS" -name '*.obj' | sort >"$work/list"
    while read -r model; do
        "$gnomon" render "$model" --samples 4 -o "$work/one.raw" >/dev/null
        for engine in $present; do
            result "$engine: $model by rows" equals "$engine" 3 "$work/one.raw" "$model" --samples 4 </dev/null
            result "$engine: $model by triangles" equals "$engine" 4 "$work/one.raw" "$model" --samples 4 --sort last </dev/null
        done
    done <"$work/list"
fi

# Memory of a rank. The second of the two numbers, or the only one, is the largest.
memory() { # memory WHICH ENGINE N OPTION...
    which=$1
    shift
    draws "$1" "$2" "$work/memory.ppm" "$3" $4 | sed -n "s|.*memory of a rank: \([0-9]*\)\( to \([0-9]*\)\)\{0,1\} MiB|\1 \3|p" |
        awk -v which="$which" '{ print which == "least" || NF == 1 ? $1 : $2 }'
}
falls() { # falls WHICH ENGINE OPTION... PERCENT: memory of 4 ranks is at most PERCENT of that of one
    one=$(memory "$1" "$2" 1 "$3" "$4")
    four=$(memory "$1" "$2" 4 "$3" "$4")
    echo "$one MiB of one rank, $four MiB of four"
    [ "${four:-0}" -gt 0 ] && [ $((four * 100)) -le $((one * $5)) ]
}
sheet 200 >"$work/large.obj"
for engine in $present; do
    result "$engine: memory by rows" falls most "$engine" "$work/sheet.obj" '--size 4000x4000 --shader unlit' 50
done
[ -z "$first" ] || result "$first: memory by triangles" falls least "$first" "$work/large.obj" '--size 64x64 --sort last' 80

# Pictures in tiles: equal bytes for all numbers of ranks, and for one process.
set -- "$work/sheet.obj" --size 16401x67 --points=3 --samples 4 --depth "$work/tilesd.png"
"$gnomon" render "$@" -o "$work/tiles.png" >/dev/null
"$gnomon" render "$@" -o "$work/tiles.raw" >/dev/null
mv "$work/tilesd.png" "$work/one_tilesd.png"
result "checksums of a picture in tiles" sound_png "$work/tiles.png"
for engine in $present; do
    for n in 1 3; do
        result "$engine, $n ranks: PNG in tiles" equals "$engine" $n "$work/tiles.png" "$@"
        result "$engine, $n ranks: depth in tiles" cmp "$work/one_tilesd.png" "$work/tilesd.png"
    done
    result "$engine: raw in tiles" equals "$engine" 4 "$work/tiles.raw" "$@"
done

# Scenes of the comparison with the reference.
scenes() {
    with=$1
    count=$2
    shift 2
    over_ranks "$with" "$count" "$build/$with/scenes-over-ranks" "$@"
}
seed=1
for engine in $present; do
    for n in 2 3 4; do
        # Ranks of MPICH wait busily, which takes long on few processors.
        each=$([ "$engine" = mpich ] && [ $n -gt 2 ] && echo 1 || echo 4)
        result "$engine: scenes over $n ranks" scenes "$engine" $n $seed $each
        sed 's/^/    /' "$work/said" | grep 'ranks:'
        seed=$((seed + 1))
    done
done

# Classes in which mistakes show that are rare elsewhere: bands that divide squares of two by two
# pixels, draws of several segments, wide points at the edges of tiles.
if [ -n "$first" ]; then
    result "$first: sample shading" scenes "$first" 3 11 150 sample-shading
    result "$first: segments" scenes "$first" 3 11 300 segments
    result "$first: points in tiles" scenes "$first" 1 11 60 points
fi

# What can go wrong. Each run must end by itself, with an error that names what is wrong, and leave
# nothing under the output's name; only if a rank is killed may a file of another name stay.
goes_wrong() { # goes_wrong STATUS-LEFTOVERS WORDS COMMAND...
    kind=$1
    words=$2
    shift 2
    rm -rf "$work/wrong"
    mkdir "$work/wrong"
    "$@" >"$work/words" 2>&1 </dev/null
    status=$?
    cat "$work/words"
    echo "status $status"
    [ $status != 0 ] && [ $status != 124 ] && grep -q -e "$words" "$work/words" || return 1
    if [ "$kind" = killed ]; then
        [ ! -e "$work/wrong/out.raw" ]
    else
        [ -z "$(ls "$work/wrong")" ]
    fi
}
# A rank that does something before it begins: rank_does N ACTION ENGINE RANKS OPTION...
rank_does() {
    number=$1
    action=$2
    engine_of=$3
    count_of=$4
    shift 4
    over_ranks "$engine_of" "$count_of" sh -c '
        number=$1 action=$2 program=$3
        shift 3
        [ "${OMPI_COMM_WORLD_RANK:-${PMI_RANK:-}}" != "$number" ] || eval "$action"
        exec "$program" render "$@"' sh "$number" "$action" "$build/$engine_of/gnomon" "$@"
}
says_once() { # says_once WORDS COMMAND...
    words=$1
    shift
    "$@" >"$work/words" 2>&1 </dev/null && return 1
    cat "$work/words"
    [ "$(grep -c -e "$words" "$work/words")" = 1 ]
}
from_wrong() { (cd "$work/wrong" && "$@"); }
for engine in $present; do
    for sort in first last; do
        result "$engine, --sort $sort: a rank is killed" goes_wrong killed 'killed\|Killed\|KILLED\|signal 9\|EXIT CODE: 9' \
            rank_does 1 '(sleep 0.4; kill -9 $$) & ' "$engine" 3 "$work/sheet.obj" --size 6000x6000 \
            -o "$work/wrong/out.raw" --sort $sort
        result "$engine, --sort $sort: no model" goes_wrong fault 'absent.obj' \
            over_ranks "$engine" 3 "$build/$engine/gnomon" render "$work/absent.obj" -o "$work/wrong/out.raw" --sort $sort
    done
    result "$engine: a disk is full for one rank" goes_wrong fault 'rank 1: .*out.raw: cannot be written: .*\(File too large\|bytes were written\)' \
        rank_does 1 'ulimit -f 49152' "$engine" 2 "$work/sheet.obj" --size 3000x3000 -o "$work/wrong/out.raw"
    result "$engine: a disk is full for the first rank" goes_wrong fault 'rank 0: .*out.raw: cannot be written: .*\(File too large\|bytes were written\)' \
        rank_does 0 'ulimit -f 32768' "$engine" 2 "$work/sheet.obj" --size 3000x3000 -o "$work/wrong/out.raw"
    result "$engine: a device is full, and the depth is a file" goes_wrong fault '/dev/full: cannot be written: No space' \
        over_ranks "$engine" 3 "$build/$engine/gnomon" render "$work/sheet.obj" -o /dev/full --format raw \
        --depth "$work/wrong/out.png"
    for sort in first last; do
        result "$engine, --sort $sort: a camera that all ranks refuse is named once" says_once 'gnomon, rank .*--up: impossible camera' \
            over_ranks "$engine" 4 "$build/$engine/gnomon" render "$work/sheet.obj" --up 0,0,0 -o "$work/out.raw" --sort $sort
    done
    result "$engine: a folder that does not exist" goes_wrong fault 'absent/out.png' \
        over_ranks "$engine" 3 "$build/$engine/gnomon" render "$work/sheet.obj" -o "$work/absent/out.png"
    result "$engine: a rank that finds no such file" goes_wrong fault 'rank 2: out.raw: cannot be written: ' \
        from_wrong rank_does 2 'cd /' "$engine" 3 "$work/sheet.obj" -o out.raw
done

echo "$passed passed, $failed failed"
[ $failed = 0 ]
