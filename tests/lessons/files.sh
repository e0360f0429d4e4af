#!/bin/sh
# Checks what tools/examples/obj_tga.c reads and writes, and that a wrong file gets one line on stderr
# that names it, exit status 1 and nothing on stdout. Then runs every lesson. Meant for a build with
# the sanitizers, which make the exit status another one.
# usage: files.sh BUILD-DIRECTORY   (from the root of the project)
set -u
. tests/lessons/work.sh
begin "lessons, files"
build=$PWD/$1
program=$build/lesson-files
examples=$build/examples
lesson_files
cd "$work" || exit 1

# ends STATUS COMMAND...: whether a command ends so, says one line on stderr and prints nothing.
ends() {
    wanted=$1
    shift
    "$@" >out 2>error </dev/null
    status=$?
    echo "status $status"
    cat out error
    [ $status = "$wanted" ] && [ ! -s out ] && [ "$(wc -l <error)" = 1 ]
}

# prints KIND FILE EXPECTED: whether the program reads a file so, in silence.
prints() {
    "$program" "$1" "$2" >out 2>error || { cat error; return 1; }
    [ ! -s error ] && printf '%b\n' "$3" | diff - out
}
good() { result "$1 $2" prints "$@"; }

# refuses KIND FILE WORDS: whether the line on stderr begins with the file's name and has the words.
refuses() { ends 1 "$program" "$1" "$2" && grep -q "^$2: .*$3" error; }
bad() { result "$1 $2: $3" refuses "$@"; }

vertices='v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n'

# good_obj FILE TEXT EXPECTED; bad_obj FILE WORDS TEXT
good_obj() {
    printf '%b' "$2" >"$1"
    good obj "$1" "$3"
}
bad_obj() {
    printf '%b' "$3" >"$1"
    bad obj "$1" "$2"
}
good_obj polygon.obj "# a comment\n${vertices}vt 0.5\nvt 0.25 0.75\nvn 0 0 1\no name\nf 1/2/1 2/1/1 3//1 4\n" '6 corners
 0,0,0 0.25,0.75,0 0,0,1\n 1,0,0 0.5,0,0 0,0,1\n 1,1,0 0,0,0 0,0,1
 0,0,0 0.25,0.75,0 0,0,1\n 1,1,0 0,0,0 0,0,1\n 0,1,0 0,0,0 0,0,0'
good_obj backward.obj "${vertices}f -4 -3 -2\r\nv 5 5 5\nf -1/ 1// 2" '6 corners
 0,0,0 0,0,0 0,0,0\n 1,0,0 0,0,0 0,0,0\n 1,1,0 0,0,0 0,0,0
 5,5,5 0,0,0 0,0,0\n 0,0,0 0,0,0 0,0,0\n 1,0,0 0,0,0 0,0,0'
bad obj absent.obj 'cannot be opened'
bad_obj empty.obj 'without a triangle' ''
bad_obj far.obj 'not there, line 5' "${vertices}f 1 2 5\n"
bad_obj before.obj 'not there, line 5' "${vertices}f 1 2 -5\n"
bad_obj map.obj 'not there' "${vertices}f 1/1 2/1 3/1\n"
bad_obj zero.obj 'not there' "${vertices}f 0 1 2\n"
bad_obj huge.obj 'not there' "${vertices}f 99999999999999999999999 1 2\n"
bad_obj words.obj 'not there' "${vertices}f a b c\n"
bad_obj two.obj 'fewer than three' "${vertices}f 1 2\n"
bad_obj short.obj 'missing' "v 1 2\n"
bad_obj nan.obj 'missing or too large' "v nan 0 0\n"
bad_obj infinite.obj 'too large' "v 1e39 0 0\n"
bad_obj long.obj 'too long' "${vertices}f$(printf '%5000s' '')\n"
mkdir directory
bad obj directory 'without a triangle'
bad tga directory 'no TGA'

# tga FILE TYPE WIDTH HEIGHT BITS DESCRIPTOR BYTES...: numbers are octal
tga() {
    file=$1
    printf "\\000\\000\\$2\\000\\000\\000\\000\\000\\000\\000\\000\\000\\$3\\000\\$4\\000\\$5\\$6" >"$file"
    shift 6
    for byte; do printf "\\$byte" >>"$file"; done
}
# good_tga FILE EXPECTED NUMBERS...; bad_tga FILE WORDS NUMBERS...: numbers as of tga
good_tga() {
    name=$1 expected=$2
    shift 2
    tga "$name" "$@"
    good tga "$name" "$expected"
}
bad_tga() {
    name=$1 words=$2
    shift 2
    tga "$name" "$@"
    bad tga "$name" "$words"
}
good_tga plain.tga '2x2 ff010203 ff040506 ff070809 ff0a0b0c' 2 2 2 30 0 1 2 3 4 5 6 7 10 11 12 13 14
good_tga top.tga '2x2 ff070809 ff0a0b0c ff010203 ff040506' 2 2 2 30 40 1 2 3 4 5 6 7 10 11 12 13 14
good_tga alpha.tga '1x1 80010203' 2 1 1 40 10 1 2 3 200
good_tga grey.tga '3x1 ff000000 ff7f7f7f ffffffff' 3 3 1 10 0 0 177 377
good_tga runs.tga '3x2 ff010203 ff010203 ff010203 ff010203 ff040506 ff070809' 12 3 2 30 0 203 1 2 3 1 4 5 6 7 10 11
good_tga grey_runs.tga '3x1 ff2a2a2a ff2a2a2a ff2a2a2a' 13 3 1 10 0 202 52
tga named.tga 2 1 1 30 0 141 142 1 2 3
printf '\002' | dd of=named.tga conv=notrunc 2>/dev/null
good tga named.tga '1x1 ff010203'
"$program" copy runs.tga copied.tga
good tga copied.tga '3x2 ff010203 ff010203 ff010203 ff010203 ff040506 ff070809'

bad tga absent.tga 'cannot be opened'
: >empty.tga
bad tga empty.tga 'no TGA'
head -c 17 plain.tga >head.tga
bad tga head.tga 'no TGA'
head -c 29 plain.tga >cut.tga
bad tga cut.tga 'ends too early'
head -c 20 runs.tga >cut_runs.tga
bad tga cut_runs.tga 'ends too early'
bad_tga no_packet.tga 'ends too early' 12 1 1 30 0
printf '\0\0\2\0\0\0\0\0\0\0\0\0\377\377\377\377\30\0' >large.tga
bad tga large.tga 'not 1 to 16384 pixels'
printf '\0\0\2\0\0\0\0\0\0\0\0\0\0\100\0\100\30\0' >largest.tga
bad tga largest.tga 'ends too early'
bad_tga none.tga 'not 1 to 16384 pixels' 2 0 1 30 0
bad_tga table.tga 'no TGA' 1 1 1 10 0 0
bad_tga sixteen.tga 'no TGA' 2 1 1 20 0 0 0
bad_tga mirrored.tga 'no TGA' 2 1 1 30 20 0 0 0
result "a picture in no directory" ends 1 "$program" copy plain.tga absent/picture.tga
result "a picture in no directory: what is said" [ "$(cat error)" = 'absent/picture.tga: cannot be opened' ]
if [ -c /dev/full ]; then
    result "a full disk" ends 1 "$program" copy plain.tga /dev/full
    result "a full disk: what is said" [ "$(cat error)" = '/dev/full: cannot be written' ]
fi

# runs LESSON: whether it ends well, in silence on stderr.
runs() { "$1" </dev/null >out 2>error && [ ! -s error ]; }
for lesson in "$examples"/[0-9][0-9]_*[!d]; do
    case $lesson in *.*) continue ;; esac
    result "lesson $(basename "$lesson")" runs "$lesson"
    # Its help, of some lines, says how it is called.
    "$lesson" 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 </dev/null >out 2>error
    result "lesson $(basename "$lesson"): too many arguments" [ $? = 2 -a ! -s out -a -s error ]
done
for lesson in 02_wireframe 07_texture 14_normal_map 18_head; do
    result "$lesson: a wrong model" ends 1 "$examples/$lesson" far.obj cut.tga
done
result "12_toon: a wrong colour" ends 2 "$examples/12_toon" polygon.obj out.tga 10
result "12_toon: thresholds that fall" ends 2 "$examples/12_toon" polygon.obj out.tga 101010 0.5 202020 0.4 303030
result "01_line: an end outside" ends 2 "$examples/01_line" 0 0 64 0
for statement in 'point 1 2' 'walk 1 2 3' 'rotate 0 0 0 10' 'near -1' 'screen 0 5' 'scale 0 0 0' 'perspective nan'; do
    echo "$statement" >statement
    result "20_point: $statement" ends 2 sh -c '"$1" <statement' - "$examples/20_point"
done
"$build/check-line" 5000 7 >out 2>error
result "check-line" grep -q '^0 of 5000 random lines' out
finish
