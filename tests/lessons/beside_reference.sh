#!/bin/sh
# Runs the lessons with beside_reference.c linked in: what they draw with ready-made shaders must equal
# OSMesa's picture, colour and depth, bit for bit. Says of the others why not, and what checks them.
# usage: beside_reference.sh BUILD-DIRECTORY   (from the root of the project)
set -u
. tests/lessons/work.sh
begin "lessons beside the reference"
build=$PWD/$1
lesson_files

# Lessons that draw nothing that the reference can draw, and what checks them instead.
otherwise() {
    case $1 in
    12_toon) echo "a shader of its own: check_toon.c decides every pixel again" ;;
    15_specular_map) echo "a shader of its own: check_specular.c compares with gn_use_phong" ;;
    17_matrices) echo "prints numbers: its page, and the library's matrices" ;;
    20_point) echo "prints numbers: gnomon transform prints the same" ;;
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
        result "$lesson: nothing was compared: $line $(cat "$work/error")" [ $status = 0 -a -n "$(otherwise "$lesson")" ]
        echo "$lesson: not compared with the reference: $(otherwise "$lesson")"
        ;;
    *)
        echo "$lesson: ${line#reference: }"
        result "$lesson: status $status: $line $(cat "$work/error")" \
            expr "$status $line" : '0 reference: .*colour of 0, depth of 0 of .*; 0 draws of other shaders$'
        result "$lesson: it is listed as checked otherwise" [ -z "$(otherwise "$lesson")" ]
        ;;
    esac
done
finish
