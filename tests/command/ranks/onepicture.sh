#!/bin/sh
# One picture over many ranks: the bytes of one process for 1 to 4 ranks with both engines of MPI, by
# rows and by triangles, in every shader; scenes of the comparison with the reference, divided in both
# ways; memory; and what happens if a rank is killed, a disk is full, a file cannot be read or written.
# usage: tests/command/ranks/onepicture.sh BUILD
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
find_present "$build" 'one picture over ranks'
first=${present# }
first=${first%% *}

# Waves of triangles with colours of their own, crossed by others; every second layer lies exactly on
# the layer before it, with other colours and its triangles in another order.
sheet() { # sheet SIDE
    awk -v n="$1" 'BEGIN {
        for (layer = 0; layer < 4; ++layer)
            for (y = 0; y <= n; ++y)
                for (x = 0; x <= n; ++x) {
                    z = layer < 2 ? sin(x * 9 / n) * cos(y * 7 / n) / 4 : (x - y) / n / 2
                    printf "v %.6f %.6f %.6f %.3f %.3f %.3f\nvt %.5f %.5f\n", x / n, y / n, z, x * 7 % 11 / 10,
                        (y + layer) * 5 % 7 / 6, (layer * 3 + x) % 4 / 3, x / n * 3, y / n * 3
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
sheet 200 >"$work/large.obj"
"$build/make-models" "$work" || exit 1

draws() { # draws ENGINE N OUT OPTION...
    with=$1
    count=$2
    out=$3
    shift 3
    over_ranks "$with" "$count" "$build/$with/gnomon" render "$@" -o "$out"
}
equals() { # equals ENGINE N FILE OPTION...: what N ranks draw has the bytes of FILE
    file=$3
    drawn=$work/drawn.${file##*.}
    rm -f "$drawn"
    with=$1
    count=$2
    shift 3
    draws "$with" "$count" "$drawn" "$@" && cmp "$file" "$drawn"
}

# Every look by one process, and over ranks in both ways: engines and numbers of ranks take turns.
# Sizes are odd, so that the first band has an odd number of rows; the last has fewer rows than ranks.
turn=0
pick() { # pick N: sets picked and picked_ranks
    picked_ranks=$((2 + $1 % 3))
    set -- $1 $present
    shift $((1 + $1 % ($# - 1)))
    picked=$1
}
while [ -n "$present" ] && read -r model suffix look; do
    set -- "$work/$model.obj" --size $((211 + turn))x$((160 + turn)) $look
    result "one process: $*" "$gnomon" render "$@" -o "$work/one.$suffix"
    pick $turn
    result "by rows, $picked, $picked_ranks ranks: $*" equals "$picked" "$picked_ranks" "$work/one.$suffix" "$@"
    pick $((turn + 1))
    result "by triangles, $picked, $picked_ranks ranks: $*" equals "$picked" "$picked_ranks" "$work/one.$suffix" "$@" --sort last
    turn=$((turn + 1))
done <<END
sheet raw --shader vertex-color
teapot tga --shader unlit --background 10203040
sheet ppm --shader flat --shadows --cull back
teapot raw --shader gouraud --samples 4
sheet raw --shader toon --bands 5 --cull front
teapot tga --shader phong --shadows --samples 4
sheet ppm --shader blinn-phong --rotate y,70 --eye 0.5,0.7,0.6
teapot raw --shader normals --samples 4
sheet raw --shader depth
teapot tga --shader flat --cull back --eye 0.5,0.5,0.5 --near 0.2 --samples 4
sheet ppm --wireframe
teapot raw --points=5 --orthographic 2
sheet raw --shader unlit --texture $work/teapot_diffuse.tga --filter mipmap
teapot raw --samples 4 --size 33x7
END

# Without the depth test the order of triangles decides: exact by rows, refused by triangles.
"$gnomon" render "$work/sheet.obj" --no-depth-test --size 99x77 -o "$work/one.raw" >/dev/null
draws_something() { ! "$@" 2>&1 | grep 'nothing was drawn'; }
for engine in $present; do
    result "$engine: no depth test" equals "$engine" 3 "$work/one.raw" "$work/sheet.obj" --no-depth-test --size 99x77
    result "$engine: no depth test, something is drawn" draws_something draws "$engine" 2 "$work/two.raw" \
        "$work/sheet.obj" --no-depth-test --size 99x77
done

# PNG files, and those of the depth: the bytes of one rank, the pixels of one process. In tiles one
# process writes the same bytes.
png_parts() { # png_parts FILE: every checksum is right, and it holds as many bytes as its header says
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
same_png() { # same_png ENGINE N OPTION...: picture and depth have the bytes of first.png and firstd.png
    with=$1
    count=$2
    shift 2
    rm -f "$work/n.png" "$work/nd.png"
    draws "$with" "$count" "$work/n.png" "$@" --depth "$work/nd.png" &&
        cmp "$work/n.png" "$work/first.png" && cmp "$work/nd.png" "$work/firstd.png"
}
same_raw() { "$1" render $tiles -o "$work/two.raw" >"$work/words" 2>&1 && ! grep rank "$work/words" && cmp "$work/one.raw" "$work/two.raw"; }
piped() { draws "$1" 3 - $picture 2>"$work/words" | cmp - "$work/first.png"; } # which has no places to write to
picture="$work/teapot.obj --shadows --samples 4 --size 260x201"
tiles="$work/sheet.obj --points=3 --samples 4 --size 16401x67"
if [ -n "$first" ]; then
    draws "$first" 1 "$work/first.png" $picture --depth "$work/firstd.png" >/dev/null
    "$gnomon" render $picture -o "$work/one.png" --depth "$work/oned.png" >/dev/null
    for d in '' d; do
        result "pixels of a PNG in parts" "$gnomon" diff "$work/one$d.png" "$work/first$d.png"
        result "a PNG in parts" png_parts "$work/first$d.png"
    done
fi
for engine in $present; do
    result "$engine: PNG to standard output" piped "$engine"
    for n in 1 2 3 4; do
        result "$engine, $n ranks: PNG by rows" same_png "$engine" $n $picture
        result "$engine, $n ranks: PNG by triangles" same_png "$engine" $n $picture --sort last
    done
done
"$gnomon" render $tiles -o "$work/first.png" --depth "$work/firstd.png" >/dev/null
"$gnomon" render $tiles -o "$work/one.raw" >/dev/null
result "a PNG in tiles" png_parts "$work/first.png"
for engine in $present; do
    result "$engine, 1 rank: PNG in tiles" same_png "$engine" 1 $tiles
    result "$engine, 3 ranks: PNG in tiles" same_png "$engine" 3 $tiles
    result "$engine, 4 ranks: raw in tiles" equals "$engine" 4 "$work/one.raw" $tiles
    result "$engine: without a launcher" same_raw "$build/$engine/gnomon"
done

# Processes that srun has started without MPI would each write the whole picture.
for program in "$gnomon" $(for engine in $present; do echo "$build/$engine/gnomon"; done); do
    result "$program: srun of one process" env SLURM_STEP_NUM_TASKS=1 "$program" --version
    result "$program: srun without MPI" ends 'srun --mpi=' env SLURM_STEP_NUM_TASKS=4 "$program" render "$work/teapot.obj" -o "$work/wrong/out.png"
done

# Memory of a rank: the least of all ranks, or the most.
memory() { # memory ENGINE N OPTION...: prints both
    with=$1
    count=$2
    shift 2
    draws "$with" "$count" "$work/memory.ppm" "$@" |
        sed -n 's|.*memory of a rank: \([0-9]*\)\( to \([0-9]*\)\)\{0,1\} MiB|\1 \3|p' | awk '{ print $1, $NF }'
}
falls() { # falls FIELD PERCENT ENGINE OPTION...: memory of 4 ranks is at most PERCENT of that of one
    field=$1
    percent=$2
    with=$3
    shift 3
    one=$(memory "$with" 1 "$@" | cut -d ' ' -f "$field")
    four=$(memory "$with" 4 "$@" | cut -d ' ' -f "$field")
    echo "$one MiB of one rank, $four MiB of four"
    [ "${four:-0}" -gt 0 ] && [ $((four * 100)) -le $((one * percent)) ]
}
for engine in $present; do
    result "$engine: memory by rows" falls 2 50 "$engine" "$work/sheet.obj" --size 4000x4000 --shader unlit
    result "$engine: memory by triangles" falls 1 80 "$engine" "$work/large.obj" --size 64x64 --sort last
done

# Scenes of the comparison with the reference; and classes in which mistakes show that are rare
# elsewhere: bands that divide squares of two by two pixels, draws of several segments, wide points at
# the edges of tiles. Ranks of MPICH wait busily, which takes long on few processors.
for engine in $present; do
    for n in 2 3 4; do
        each=$([ "$engine" = mpich ] && [ $n -gt 2 ] && echo 1 || echo 4)
        result "$engine: scenes over $n ranks" over_ranks "$engine" $n "$build/$engine/scenes-over-ranks" $n "$each"
        sed 's/^/    /' "$work/said" | grep 'ranks:'
    done
done
if [ -n "$first" ]; then
    result "$first: sample shading" over_ranks "$first" 3 "$build/$first/scenes-over-ranks" 11 150 sample-shading
    result "$first: segments" over_ranks "$first" 3 "$build/$first/scenes-over-ranks" 11 300 segments
    result "$first: points in tiles" over_ranks "$first" 1 "$build/$first/scenes-over-ranks" 11 60 points
fi

# What can go wrong. Only if a rank is killed may a file of another name stay.
killed() { # killed ENGINE
    rm -rf "$work/kill" && mkdir "$work/kill"
    unlike_others "$1" 3 '[ $rank != 1 ] || (sleep 0.4; kill -9 $$) &' "$build/$1/gnomon" render "$work/sheet.obj" \
        --size 6000x6000 -o "$work/kill/out.raw"
    status=$?
    [ $status != 0 ] && [ $status != 124 ] && [ ! -e "$work/kill/out.raw" ]
}
for engine in $present; do
    render="$build/$engine/gnomon render"
    sheet="$work/sheet.obj -o $work/wrong/out"
    result "$engine: a rank is killed" killed "$engine"
    result "$engine: no model" ends 'absent.obj' over_ranks "$engine" 3 $render "$work/absent.obj" -o "$work/wrong/out.raw"
    result "$engine: a camera that all ranks refuse is named once" ends 'gnomon, rank .*--up: impossible camera' \
        over_ranks "$engine" 4 $render $sheet.raw --up 0,0,0 --sort last
    result "$engine: by triangles without depth test" ends 'no-depth-test.*order of the triangles' \
        over_ranks "$engine" 2 $render $sheet.raw --no-depth-test --sort last
    result "$engine: statistics" ends '--statistics' over_ranks "$engine" 2 $render $sheet.raw --statistics
    full='out.raw: cannot be written: .*\(File too large\|bytes were written\)'
    result "$engine: a disk is full for one rank" ends "rank 1: .*$full" \
        unlike_others "$engine" 2 '[ $rank != 1 ] || ulimit -f 49152' $render $sheet.raw --size 3000x3000
    result "$engine: a disk is full for the first rank" ends "rank 0: .*$full" \
        unlike_others "$engine" 2 '[ $rank != 0 ] || ulimit -f 32768' $render $sheet.raw --size 3000x3000
    result "$engine: a device is full, and the depth is a file" ends '/dev/full: cannot be written: No space' \
        over_ranks "$engine" 3 $render "$work/sheet.obj" -o /dev/full --format raw --depth "$work/wrong/out.png"
    result "$engine: a folder that does not exist" ends 'absent/out.png' \
        over_ranks "$engine" 3 $render "$work/sheet.obj" -o "$work/absent/out.png"
    result "$engine: a rank that finds no such file" ends 'rank 2: out.raw: cannot be written: ' \
        unlike_others "$engine" 3 "cd $work/wrong; [ \$rank != 2 ] || cd /" $render "$work/sheet.obj" -o out.raw
done
echo "one picture over ranks: $passed passed, $failed failed"
[ $failed = 0 ]
