#!/bin/sh
# Runs the lessons with beside_reference.c linked in: what they draw with ready-made shaders must equal
# OSMesa's picture, colour and depth, bit for bit. Says of the others why not, and what checks them.
# usage: beside_reference.sh BUILD-DIRECTORY   (from the root of the project)
set -u
. tests/skip.sh
build=$PWD/$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
passed=0
failed=0
mkdir -p "$work/build/examples"
ln -s "$build"/examples/*.obj "$build"/examples/teapot_*.tga "$build"/examples/head.tga "$build"/examples/eyes.tga \
    "$work/build/examples"

# Lessons that draw nothing that the reference can draw, and what checks them instead.
otherwise() {
    case $1 in
    12_toon) echo "a shader of its own: check_toon.c decides every pixel again" ;;
    15_specular_map) echo "a shader of its own: check_specular.c compares with gn_use_phong" ;;
    17_matrices) echo "prints numbers: its page, and the library's matrices" ;;
    20_point) echo "prints numbers: gnomon transform prints the same" ;;
    *) return 1 ;;
    esac
}

for source in tools/examples/[0-9][0-9]_*.c; do
    lesson=$(basename "$source" .c)
    (cd "$work" && "$build/examples/compared/$lesson" </dev/null) >"$work/output" 2>"$work/error"
    status=$?
    line=$(grep '^reference: ' "$work/output")
    case $line in
    "reference: absent"*)
        skip "lessons beside the reference: OSMesa is absent: 'make setup' installs it"
        break
        ;;
    "reference: 0 draws"*)
        if [ $status = 0 ] && reason=$(otherwise "$lesson"); then
            passed=$((passed + 1))
            echo "$lesson: not compared with the reference: $reason"
        else
            failed=$((failed + 1))
            echo "FAILED: $lesson: nothing was compared: $line $(cat "$work/error")"
        fi
        ;;
    *"colour of 0, depth of 0 of "*"; 0 draws of other shaders")
        echo "$lesson: ${line#reference: }"
        if [ $status = 0 ] && ! otherwise "$lesson" >/dev/null; then
            passed=$((passed + 1))
        else
            failed=$((failed + 1))
            echo "FAILED: $lesson: status $status, or it is not listed as checked otherwise"
        fi
        ;;
    *)
        failed=$((failed + 1))
        echo "FAILED: $lesson: status $status: $line $(cat "$work/error")"
        ;;
    esac
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
