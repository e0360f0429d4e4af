#!/bin/sh
# Compares real models, drawn by the command and by OSMesa, with every shader, with one sample a
# pixel and with four: tests/models/compare_models.sh BUILD_DIRECTORY DIRECTORY_OF_MODELS. Compares every .obj file
# below the directory. Without a directory it says so and succeeds.
set -u
gnomon=$1/gnomon
models=${2:-}
size=${SIZE:-1024x1024}
picture=$1/model-compared.png
passed=0
failed=0

if [ -z "$models" ]; then
    echo 'no models were given (MODELS=DIRECTORY): skipped'
    exit 0
fi

# Every shader, with the normal maps that it can have, and with shadows.
looks='--shader=vertex-color
--shader=unlit
--shader=unlit --filter=nearest
--shader=unlit --filter=linear
--shader=flat
--shader=flat --shadows
--shader=gouraud
--shader=toon
--shader=toon --shadows --bands=7
--shader=phong
--shader=phong --normal-map=world
--shader=phong --normal-map=none --specular-map=none --exponent=100
--shader=phong --shadows
--shader=blinn-phong
--shader=blinn-phong --normal-map=world --exponent=200
--shader=blinn-phong --shadows --texture=none
--shader=normals
--shader=normals --normal-map=world
--shader=normals --normal-map=none
--shader=depth'

one() {
    output=$("$gnomon" compare "$@" --size "$size" -o "$picture" 2>&1)
    if [ $? -eq 0 ]; then
        passed=$((passed + 1))
        echo "ok: $*"
    elif echo "$output" | grep -q 'names no such normal map\|has no texture coordinates'; then
        echo "not for this model: $*"
    else
        failed=$((failed + 1))
        echo "FAILED: $*"
        echo "$output" | sed 's/^/    /'
    fi
}

list=$(find "$models" -name '*.obj' | sort)
if [ -z "$list" ]; then
    echo "$models: there are no .obj files in it" >&2
    exit 1
fi
while read -r model; do
    while read -r look; do
        for samples in 1 4; do
            # The look must be split into words.
            # shellcheck disable=SC2086
            one "$model" $look --samples="$samples"
        done
    done <<LOOKS
$looks
LOOKS
done <<LIST
$list
LIST
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
