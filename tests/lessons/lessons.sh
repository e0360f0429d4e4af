#!/bin/sh
# Checks the lessons of tools/examples: each compiles alone against the public headers, runs on the
# models that the build makes, has a page in the chain of pages, and draws the picture that its page
# shows. Then checks results: random lines beside Bresenham's, 101 frames, points beside `gnomon
# transform`, and the shaders of lessons 12 and 15 pixel by pixel.
# usage: lessons.sh BUILD-DIRECTORY [SEED]   (from the root of the project)
set -u
. tests/lessons/work.sh
begin lessons
build=$PWD/$1
seed=${2:-1}
folder=tools/examples
root=$PWD
mkdir "$work/frames"
lesson_files
run() { # run LESSON ARGUMENT...
    lesson=$1
    shift
    (cd "$work" && "$build/examples/$lesson" "$@")
}

# The command that README.md gives to compile a lesson by hand.
command=$(sed -n 's/^    cc \(-std=c99 .*\) build\/libgnomon\.a -o 07_texture$/\1/p' $folder/README.md)
# shellcheck disable=SC2086
result "README.md: its command compiles a lesson" ${CC:-cc} $command "$build/libgnomon.a" -o "$work/by-hand"
result "README.md: the lesson compiled by hand runs" sh -c 'cd "$1" && ./by-hand build/examples/head.obj build/examples/head.tga head.tga' - "$work"

helper_lines=$(cat $folder/obj_tga.h $folder/obj_tga.c | grep -c .)
result "obj_tga: $helper_lines lines, at most 150" test "$helper_lines" -le 150

# Another directory of the build has the lesson's program and its model.
mkdir -p "$work/other/examples"
ln -s "$build/examples/02_wireframe" "$build/examples/teapot.obj" "$work/other/examples"
result "make lessons: runs in another directory" make -s lessons BUILD="$work/other" LESSONS=02_wireframe \
    LESSON_PROGRAMS="$build/examples/02_wireframe" LESSON_MODELS=
result "make lessons: the pictures are there" test -s "$work/other/examples/02_wireframe.tga"

# The block of output in a page, and the output.
page_output() { sed -n '/^```text$/,/^```$/p' "$1" | sed '1d;$d'; }

one_to_six() { lines=$(grep -c '' "$1") && [ "$lines" -ge 1 ] && [ "$lines" -le 6 ]; }

before=README
for source in "$folder"/[0-9][0-9]_*.c; do
    lesson=$(basename "$source" .c)
    page=$folder/$lesson.md
    result "$lesson: compiles in C99 against the public headers" \
        ${CC:-cc} -std=c99 -pedantic -Wall -Wextra -Werror -Iinclude -fsyntax-only "$source"
    result "$lesson: includes lesson.h and the C library alone" \
        awk '/^#include/ && !/"lesson\.h"|<(math|stdio|stdlib|string)\.h>/ { print; bad = 1 } END { exit bad }' "$source"
    result "$lesson: a page" test -f "$page"
    result "$lesson: its page links to $before" grep -q "^Before: .*]($before\.md)\. Next: " "$page"
    [ "$before" = README ] || result "$before: its page links to $lesson" \
        grep -q "^Before: .* Next: .*]($lesson\.md)\.\$" "$folder/$before.md"
    result "$lesson: README.md has a line" grep -q "]($lesson\.md)" $folder/README.md
    result "$lesson: its page names the program" grep -q "]($lesson\.c)" "$page"
    result "$lesson: its page has all parts" test "$(grep -c -x -E '## (Why|The formula|The program|Try next)' "$page")" = 4
    result "$lesson: its page shows a drawing" grep -q "](drawings/${lesson%%_*}_[a-z_]*\.svg)" "$page"
    [ "$lesson" = 20_point ] || result "$lesson: its formulas are set" grep -q -x '```math' "$page"
    for slider in $(sed -n 's/.*--set "\([^"]*\)=[^"]*".*/\1/p' "$page" | tr ' ' '~'); do
        result "$lesson: the slider that its page sets" grep -q "\"$(echo "$slider" | tr '~' ' ')\"" "$source"
    done
    run "$lesson" --help >"$work/help" 2>"$work/error"
    result "$lesson: --help, 1 to 6 lines" test $? = 0 -a ! -s "$work/error"
    result "$lesson: --help, 1 to 6 lines" one_to_six "$work/help"
    run "$lesson" </dev/null >"$work/output" 2>"$work/error"
    result "$lesson: runs" test $? = 0 -a ! -s "$work/error"
    if [ -f "$work/build/examples/$lesson.tga" ]; then
        result "$lesson: draws the picture of its page" \
            "$build/lesson-picture" check "$work/build/examples/$lesson.tga" "$folder/pictures/$lesson.png"
        result "$lesson: its page shows the picture" grep -q "](pictures/$lesson\.png)" "$page"
    else
        page_output "$page" >"$work/shown"
        result "$lesson: prints what its page shows" diff "$work/shown" "$work/output"
    fi
    before=$lesson
done
result "$before: its page leads back" grep -q 'Next: \[Lessons\](README\.md)\.$' "$folder/$before.md"
result "lessons: 21" test "$(ls "$folder"/[0-9][0-9]_*.c | wc -l)" = 21
result "pages: as many as lessons" test "$(ls "$folder"/[0-9][0-9]_*.md | wc -l)" = 21
result "pictures: no more than lessons draw" test "$(ls "$folder"/pictures | wc -l)" = "$(ls "$work"/build/examples/[0-9]*.tga | wc -l)"

# Results of single lessons.
"$build/check-line" 100000 "$seed" >"$work/output"
result "01_line: Bresenham's lines" grep -q "^0 of 100000 random lines" "$work/output"
cat "$work/output"
run 03_triangles >"$work/output"
result "03_triangles: by hand" grep -q -x '0 pixels drawn twice, 0 differ from those by hand' "$work/output"
result "03_triangles: colours by hand" grep -q -x 'colours: at most [01] of 255 steps from those by hand' "$work/output"
run 03_triangles --set "triangles=7" >"$work/output"
result "03_triangles: a slider is set" grep -q -x '0 pixels drawn twice, 0 differ from those by hand' "$work/output"
# refuses WHAT LESSON ARGUMENT...: status 2, and a message with the words.
refuses() {
    words=$1
    shift
    (run "$@" >"$work/output" 2>"$work/error")
    [ $? = 2 ] && grep -q -e "$words" "$work/error"
}
result "a slider's name that is none" refuses "triangles: 3 to 12" 03_triangles --set "trangles=7"
result "a slider's value out of range" refuses "not a number from -1.5 to 0.4" 06_z_buffer --set "near plane=9"
result "a slider's value that is no number" refuses "not a number" 06_z_buffer --set "near plane=near"
result "a slider without a value" refuses "no slider for --set" 06_z_buffer --set
run 06_z_buffer >"$work/output"
result "06_z_buffer: by hand" awk '/^depths:/ { ok = $2 < 10 && $4 == 160000 } END { exit !ok }' "$work/output"
run 08_perspective >"$work/output"
result "08_perspective: by hand" grep -q -x 'floor: 0 of 96000 pixels differ from those by hand' "$work/output"
run 10_gouraud >"$work/output"
result "10_gouraud: by hand" awk '/^colours:/ { ok = $2 < 10 && $4 > 50000 } END { exit !ok }' "$work/output"
run 05_painter >"$work/output"
result "05_painter: sorting helps" awk '/^wrong pixels:/ { ok = $3 > 1000 && $10 < $3 / 10 } END { exit !ok }' "$work/output"

run 18_head --set "turn of the head=0.35"
result "18_head: a slider as it was leaves the picture as it was" \
    "$build/lesson-picture" check "$work/build/examples/18_head.tga" $folder/pictures/18_head.png

run 19_turning_triangle sheet.tga frames
result "19_turning_triangle: 101 frames" test "$(ls "$work/frames" | wc -l)" = 101
result "19_turning_triangle: 700x700" test "$(wc -c <"$work/frames/frame-050.tga")" = $((18 + 3 * 700 * 700))
result "19_turning_triangle: the last frame is the first" cmp "$work/frames/frame-000.tga" "$work/frames/frame-100.tga"
result "19_turning_triangle: others differ" test "$(cd "$work/frames" && cksum ./* | cut -d ' ' -f 1 | sort -u | wc -l)" -ge 90
rm -r "$work/frames"

nm -u "$build/tools/examples/21_microcontroller.o" >"$work/symbols"
result "21_microcontroller: symbols are listed" grep -q gn_draw "$work/symbols"
result "21_microcontroller: upright on a display" "$build/check-display"
cat "$work/said"
result "21_microcontroller: no memory of the heap" sh -c '! grep -E "alloc|free" "$1"' - "$work/symbols"

# Numbers of a way, a stage a line: those of `gnomon transform` after the same setup.
numbers() { sed -n 's/^ *\(local\|world\|view\|clip\|NDC\|pixel\) /\1 /p' | sed 's/in column.*//'; }
equal_numbers() { # equal_numbers FILE FILE: within 2e-5 of their magnitude, or of 1
    awk 'NR == FNR { line[NR] = $0; next }
        {
            n = split(line[++at], a, " ")
            if (n != NF || a[1] != $1) { print "line " at ": " line[at] " | " $0; bad = 1 }
            for (i = 2; i <= NF; ++i) {
                d = a[i] - $i; if (d < 0) d = -d
                m = $i < 0 ? -$i : $i
                if (d > 2e-5 * (m > 1 ? m : 1)) { print line[at] " | " $0; bad = 1 }
            }
            count += NF - 1
        }
        END { exit bad || count < 130 || at != FNR }' "$1" "$2"
}
cat >"$work/setup" <<'END'
screen 800 600
scale 1 2 0.5
rotate 0 1 0 30
rotate 1 0 0 -40
rotate 1 2 3 71
translate 0.5 -0.25 -2
position 1 2 5
target 0 0.5 -1
up 0 1 0
perspective 50
near 0.5
far 40
point 1 0 0
point 0 1 0
point -0.5 0.25 0.75
point 3 -2 1
point 0 0 0
point 7 7 -7
point 0.001 0.002 0.003
END
run 20_point <"$work/setup" >"$work/output"
for convention in OpenGL Direct3D; do
    awk -v name="$convention" '/^[A-Z]/ { on = $1 == name "," } on' "$work/output" | numbers >"$work/ours"
    { echo "convention $(echo $convention | tr 'A-Z' 'a-z')"; cat "$work/setup"; } |
        "$build/gnomon" transform | numbers >"$work/theirs"
    result "20_point: $convention, beside gnomon transform" equal_numbers "$work/ours" "$work/theirs"
done
# Everything behind the eye in one convention.
printf 'position 0 0 3\npoint 0 0 9\n' >"$work/behind"
run 20_point <"$work/behind" >"$work/output"
result "20_point: behind the eye" test "$(grep -c 'behind the eye' "$work/output")" = 2

cd "$work" || exit 1
result "12_toon: every pixel decided again" \
    "$build/check-toon" build/examples/teapot.obj toon.tga "$seed"
cat said
result "15_specular_map: beside gn_use_phong" \
    "$build/check-specular" build/examples/teapot.obj build/examples/teapot_diffuse.tga build/examples/teapot_specular.tga .
cat said
cd "$root" || exit 1
finish
