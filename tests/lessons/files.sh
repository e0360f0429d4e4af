#!/bin/sh
# Checks what tools/examples/obj_tga.c reads and writes, and that a wrong file gets one line on stderr
# that names it, exit status 1 and nothing on stdout. Then runs every lesson. Meant for a build with
# the sanitizers, which make the exit status another one.
# usage: files.sh BUILD-DIRECTORY   (from the root of the project)
set -u
program=$PWD/$1/lesson-files
examples=$PWD/$1/examples
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
passed=0
failed=0
cd "$work" || exit 1

result() { # result WHAT CONDITION...
    what=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $what"
        cat out error
    fi
}

good() { # good KIND FILE EXPECTED-OUTPUT
    "$program" "$1" "$2" >out 2>error
    status=$?
    printf '%b\n' "$3" >expected
    result "$1 $2" test "$status" = 0 -a ! -s error
    result "$1 $2: output" cmp -s out expected
}

bad() { # bad KIND FILE WORDS...: the line on stderr begins with the file's name and has the words
    "$program" "$1" "$2" >out 2>error
    status=$?
    kind=$1
    file=$2
    shift 2
    result "$kind $file: exit status $status, one line" test "$status" = 1 -a ! -s out -a "$(wc -l <error)" = 1
    result "$kind $file: names the file and \"$*\"" grep -q "^$file: .*$*" error
}

vertices='v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n'
obj() { printf '%b' "$2" >"$1"; }

obj polygon.obj "# a comment\n${vertices}vt 0.5\nvt 0.25 0.75\nvn 0 0 1\no name\nf 1/2/1 2/1/1 3//1 4\n"
good obj polygon.obj '6 corners\n 0,0,0 0.25,0.75,0 0,0,1\n 1,0,0 0.5,0,0 0,0,1\n 1,1,0 0,0,0 0,0,1
 0,0,0 0.25,0.75,0 0,0,1\n 1,1,0 0,0,0 0,0,1\n 0,1,0 0,0,0 0,0,0'
obj backward.obj "${vertices}f -4 -3 -2\r\nv 5 5 5\nf -1/ 1// 2"
good obj backward.obj '6 corners\n 0,0,0 0,0,0 0,0,0\n 1,0,0 0,0,0 0,0,0\n 1,1,0 0,0,0 0,0,0
 5,5,5 0,0,0 0,0,0\n 0,0,0 0,0,0 0,0,0\n 1,0,0 0,0,0 0,0,0'

bad obj absent.obj 'cannot be opened'
: >empty.obj
bad obj empty.obj 'without a triangle'
obj far.obj "${vertices}f 1 2 5\n"
bad obj far.obj 'not there, line 5'
obj before.obj "${vertices}f 1 2 -5\n"
bad obj before.obj 'not there, line 5'
obj map.obj "${vertices}f 1/1 2/1 3/1\n"
bad obj map.obj 'not there'
obj zero.obj "${vertices}f 0 1 2\n"
bad obj zero.obj 'not there'
obj huge.obj "${vertices}f 99999999999999999999999 1 2\n"
bad obj huge.obj 'not there'
obj words.obj "${vertices}f a b c\n"
bad obj words.obj 'not there'
obj two.obj "${vertices}f 1 2\n"
bad obj two.obj 'fewer than three'
obj short.obj "v 1 2\n"
bad obj short.obj 'missing'
obj nan.obj "v nan 0 0\n"
bad obj nan.obj 'missing or too large'
obj infinite.obj "v 1e39 0 0\n"
bad obj infinite.obj 'too large'
{ printf '%b' "$vertices"; head -c 5000 /dev/zero | tr '\0' ' ' | sed 's/^/f/'; echo; } >long.obj
bad obj long.obj 'too long'
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
tga plain.tga 2 2 2 30 0 1 2 3 4 5 6 7 10 11 12 13 14
good tga plain.tga '2x2 ff010203 ff040506 ff070809 ff0a0b0c'
tga top.tga 2 2 2 30 40 1 2 3 4 5 6 7 10 11 12 13 14
good tga top.tga '2x2 ff070809 ff0a0b0c ff010203 ff040506'
tga alpha.tga 2 1 1 40 10 1 2 3 200
good tga alpha.tga '1x1 80010203'
tga grey.tga 3 3 1 10 0 0 177 377
good tga grey.tga '3x1 ff000000 ff7f7f7f ffffffff'
tga runs.tga 12 3 2 30 0 203 1 2 3 1 4 5 6 7 10 11
good tga runs.tga '3x2 ff010203 ff010203 ff010203 ff010203 ff040506 ff070809'
tga grey_runs.tga 13 3 1 10 0 202 52
good tga grey_runs.tga '3x1 ff2a2a2a ff2a2a2a ff2a2a2a'
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
tga no_packet.tga 12 1 1 30 0
bad tga no_packet.tga 'ends too early'
printf '\0\0\2\0\0\0\0\0\0\0\0\0\377\377\377\377\30\0' >large.tga
bad tga large.tga 'not 1 to 16384 pixels'
printf '\0\0\2\0\0\0\0\0\0\0\0\0\0\100\0\100\30\0' >largest.tga
bad tga largest.tga 'ends too early'
tga none.tga 2 0 1 30 0
bad tga none.tga 'not 1 to 16384 pixels'
tga table.tga 1 1 1 10 0 0
bad tga table.tga 'no TGA'
tga sixteen.tga 2 1 1 20 0 0 0
bad tga sixteen.tga 'no TGA'
tga mirrored.tga 2 1 1 30 20 0 0 0
bad tga mirrored.tga 'no TGA'
"$program" copy plain.tga absent/picture.tga >out 2>error
result "a picture in no directory" test $? = 1 -a "$(cat error)" = 'absent/picture.tga: cannot be opened'
if [ -c /dev/full ]; then
    "$program" copy plain.tga /dev/full >out 2>error
    result "a full disk" test $? = 1 -a "$(cat error)" = '/dev/full: cannot be written'
fi

# The lessons find their models in build/examples of the working directory, and write there.
mkdir -p build/examples
ln -s "$examples"/*.obj "$examples"/teapot_*.tga "$examples"/head.tga "$examples"/eyes.tga build/examples
for lesson in "$examples"/[0-9][0-9]_*[!d]; do
    case $lesson in *.*) continue ;; esac
    "$lesson" </dev/null >out 2>error
    result "lesson $(basename "$lesson"): status $?" test $? = 0 -a ! -s error
    "$lesson" 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 </dev/null >out 2>error
    result "lesson $(basename "$lesson"): too many arguments" test $? = 2 -a ! -s out -a -s error
done
for lesson in 02_wireframe 07_texture 14_normal_map 18_head; do
    "$examples/$lesson" far.obj cut.tga >out 2>error
    result "$lesson: a wrong model" test $? = 1 -a ! -s out -a "$(wc -l <error)" = 1
done
"$examples/12_toon" polygon.obj out.tga 10 >out 2>error
result "12_toon: a wrong colour" test $? = 2 -a "$(wc -l <error)" = 1
"$examples/12_toon" polygon.obj out.tga 101010 0.5 202020 0.4 303030 >out 2>error
result "12_toon: thresholds that fall" test $? = 2 -a "$(wc -l <error)" = 1
"$examples/01_line" 0 0 64 0 >out 2>error
result "01_line: an end outside" test $? = 2 -a "$(wc -l <error)" = 1
for statement in 'point 1 2' 'walk 1 2 3' 'rotate 0 0 0 10' 'near -1' 'screen 0 5' 'scale 0 0 0' 'perspective nan'; do
    echo "$statement" | "$examples/20_point" >out 2>error
    result "20_point: $statement" test $? = 2 -a ! -s out -a "$(wc -l <error)" = 1
done
"$examples/../check-line" 5000 7 >out 2>error
result "check-line" grep -q '^0 of 5000 random lines' out
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
