#!/bin/sh
# gnomon compare with random options: models in random places, with random shaders, cameras and
# states, are drawn as the reference draws them. A command line that differs is printed.
# usage: tests/command/test_random_options.sh BUILD SEED [COUNT]
set -u
gnomon=$(realpath "${1:?usage: $0 BUILD SEED [COUNT]}")/gnomon
seed=${2:?no seed}
count=${3:-30}
passed=0
failed=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
cd "$work" || exit 1

printf '%s\n' 'v -1 -1 0' 'v 1 -1 0' 'v 1 1 0' 'v -1 1 0' 'vt 0 0' 'vt 1 0' 'vt 1 1' 'vt 0 1' 'vn 0 0 1' \
    'f 1/1/1 2/2/1 3/3/1' 'f 1/1/1 3/3/1 4/4/1' >square.obj
printf '%s\n' 'v 0 0 0' 'v 1 0 0' 'v 0 1 0' 'v 0 0 1' 'f 1 3 2' 'f 1 2 4' 'f 1 4 3' 'f 2 3 4' >tetra.obj
printf 'P6 2 2 255\n\344\350\300\100\340\260\177\177\377\200\200\360' >map.ppm

lines() {
    awk -v seed="$seed" -v count="$count" '
        function below(n) { return int(rand() * n) }
        function within(low, high) { return sprintf("%.2f", low + rand() * (high - low)) }
        function one_of(words,    part) { return part[below(split(words, part, " ")) + 1] }
        function factor() { return (below(2) ? "" : "-") within(0.3, 2) }
        function place(    kind) {
            kind = below(3)
            if (kind == 0) return " --rotate " one_of("x y z 1,2,3") "," below(400) - 200
            if (kind == 1) return " --scale " factor() "," factor() "," factor()
            return " --translate " within(-1, 1) "," within(-1, 1) "," within(-1, 1)
        }
        BEGIN {
            srand(seed)
            for (i = 0; i < count; ++i) {
                line = ""
                for (m = below(3); m >= 0; --m) {
                    line = line (m > 0 && below(2) ? " tetra.obj" : " square.obj")
                    for (k = below(4); k > 0; --k) line = line place()
                }
                shader = one_of("vertex-color unlit flat gouraud toon phong blinn-phong normals depth")
                line = line " --shader " shader
                if (shader ~ "flat|toon|phong" && below(2)) line = line " --shadows"
                if (shader ~ "phong" && below(2)) line = line " --normal-map " one_of("tangent world") ":map.ppm"
                if (below(3) == 0) line = line " --cull " one_of("back front")
                if (below(4) == 0) line = line " --no-depth-test"
                kind = below(6)
                if (kind == 0) line = line " --wireframe"
                if (kind == 1) line = line " --points=" one_of("0.3 1 2.5 7 64")
                if (kind > 1 && below(3) == 0) {
                    line = line " " one_of("--edges --grid --edges=ff000080")
                    kind = 0
                }
                if (kind > 0 && below(2)) line = line " --samples 4"
                if (below(4) == 0) line = line " --background " one_of("ff8000,00208080 ffffff,000000")
                if (below(3) == 0) line = line " --near " within(0.5, 4)
                if (below(3) == 0) line = line " --far " within(4.1, 8)
                if (below(4) == 0) line = line " --orthographic " within(1, 4)
                print line
            }
        }'
}

echo "random options: seed $seed"
lines >lines
while read -r line; do
    # shellcheck disable=SC2086
    if "$gnomon" compare $line --size 150x110 -o compared.png >said 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "differs: gnomon compare $line"
        sed 's/^/    /' said
    fi
done <lines
[ "$passed" -gt 0 ] || failed=$((failed + 1))
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
