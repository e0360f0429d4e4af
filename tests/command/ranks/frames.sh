#!/bin/sh
# Frames over ranks: gnomon spin and gnomon render --views write the same bytes with 1 to 4 ranks as
# one process does, with both engines of MPI. Faults end all ranks with a status and a line that names
# them, and leave nothing half-written. The guide's commands for GNU parallel draw frames too.
# usage: tests/command/ranks/frames.sh BUILD
set -u
cd "$(dirname "$0")/../../.."
build=$(cd "${1:?usage: tests/command/ranks/frames.sh BUILD}" && pwd) || exit 2
page=$(pwd)/tools/guide/beyond_one_machine.md
blocks=$(pwd)/tests/packaging/blocks.awk
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
. tests/result.sh
. tests/skip.sh
. tests/command/ranks/launch.sh
SECONDS_LIMIT=60
cd "$work" || exit 2
find_present "$build" 'frames over ranks'

# A teapot with maps by the names that the command looks for, and views from all sides, of which some
# say little.
"$build/make-models" . || exit 2
cat >views.txt <<'END'
# the camera looks at the middle
--eye 0,1,5
--eye 3,0,0 --fov 60    # nearer

--eye=0,4,1 --orthographic 2.5
--target 0,0.5,0 --eye 0,0,9 --up 1,0,0 --near 7 --far 10
--fov 20
--eye -3,-2,-4
END

# One run of each kind; %s is the name of the files.
turn='spin teapot.obj --axis y --shadows --frames 9 --size 120x90'
list='render teapot.obj --shader phong --shadows --views views.txt --size 100x70'
all_jobs() { # all_jobs NAME
    printf '%s\n' "$turn -o %s_%%02d.png" "$turn -o %s_%%d.tga" "$turn -o %s.png" \
        "$list -o %s_v%%d.png --depth %s_d%%d.png" "$list -o %s_v%%d.tga --samples 4" | sed "s/%s/$1/g; s/%%/%/g"
}
all_jobs one | while read -r line; do "$build/gnomon" $line >/dev/null || exit 2; done

same_files() { # same_files NAME: the files have the bytes of one process
    [ "$(ls | grep -c "^$1[_.]")" = "$(ls | grep -c '^one[_.]')" ] || return 1
    for file in one[_.]*; do
        cmp "$file" "$1${file#one}" || return 1
    done
}
draws_all() { # draws_all ENGINE N
    all_jobs "$1$2" >jobs
    while read -r line <&3; do
        over_ranks "$1" "$2" "$build/$1/gnomon" $line >words 2>&1 || { cat words; return 1; }
        cat words
        [ "$2" = 1 ] || grep -q "^$2 ranks of .*, each with [0-9 to]* [a-z]*; memory of a rank: [1-9][0-9 to]* MiB$" words || return 1
        [ "$(grep -c ' a second$' words)" = 1 ] || return 1
    done 3<jobs
    same_files "$1$2"
}

only_first_reads() { # only_first_reads ENGINE
    rm -rf alone && mkdir -p alone/empty
    unlike_others "$1" 3 '[ $rank = 0 ] || cd alone/empty' "$build/$1/gnomon" $list -o "$work/alone/%d.png" || return 1
    for i in 0 1 2 3 4 5; do cmp "one_v$i.png" "alone/$i.png" || return 1; done
}

# Where no terminal is, rank 0 tells how far all are, in at most nine lines.
progress_is_told() { # progress_is_told ENGINE
    over_ranks "$1" 2 "$build/$1/gnomon" spin --frames 300 --size 700x500 -o turn.png >words 2>&1 || { cat words; return 1; }
    cat words
    told=$(grep -c '^gnomon: [0-9]* of 300, [0-9]* s left$' words)
    [ "$told" -ge 1 ] && [ "$told" -le 9 ]
}

printf -- '--fov 30\n--eye 1,2\n' >bad.txt
printf -- '# nothing\n--eye 1,2,3 --target 1,2,3\n' >impossible.txt
faults() { # faults ENGINE: what is wrong, and the run that must say so
    while IFS='|' read -r wrong options <&3; do
        result "$1: $wrong" ends "$wrong" over_ranks "$1" 3 "$build/$1/gnomon" $options
    done 3<<'END'
rank 0: missing.obj: cannot be read: No such file|spin missing.obj -o wrong/%d.png
rank 0: missing.txt: cannot be read: No such file|render teapot.obj --views missing.txt -o wrong/%d.png
bad.txt:2: --eye: '1,2': not three numbers|render teapot.obj --views bad.txt -o wrong/%d.png
impossible.txt:2: --eye: impossible camera|render teapot.obj --views impossible.txt -o wrong/%d.png
-o is a pattern|render teapot.obj --views views.txt -o wrong/a.png
unknown option|spin --nothing
--up: impossible camera|spin --up 0,0,0 -o wrong/%d.png
/dev/full: cannot be written: No space left|spin --frames 40 --size 90x60 -o /dev/full
END
    mkdir -p there
    result "$1: a rank without the directory" ends 'rank 2: wrong/0.png: ' \
        unlike_others "$1" 3 '[ $rank != 2 ] || cd there' "$build/$1/gnomon" spin --frames 9 -o wrong/%d.png
}

# The files of rank 1 may not become as large as they must, as on a full disk. Frames of others are
# there, and complete. Blocks have 512 bytes; the limit leaves room for what MPI needs.
full_disk() { # full_disk ENGINE
    rm -rf full && mkdir full
    unlike_others "$1" 2 "[ \$rank = 0 ] || { trap '' XFSZ; ulimit -f 81920; }" \
        "$build/$1/gnomon" spin --frames 400 --size 3400x3400 -o full/%d.tga >words 2>&1 && return 1
    cat words
    ls -lA full
    [ "$(grep -c 'rank 1: full/.*.tga: cannot be written: File too large' words)" = 1 ] || return 1
    [ "$(ls -A full | wc -l)" -lt 100 ] && [ -z "$(find full -type f ! -size $((18 + 26 + 4 * 3400 * 3400))c)" ]
}

# A rank is killed when some frames are there. Frames that are there are complete, and the next run
# goes on in the same directory, whatever the killed one has left.
killed() { # killed ENGINE
    rm -rf kill && mkdir kill
    unlike_others "$1" 3 '[ $rank != 1 ] || (until [ -e kill/0012.png ]; do sleep 0.05; done; kill -9 $$) &' \
        "$build/$1/gnomon" spin teapot.obj --frames 3000 --size 320x240 -o kill/%04d.png >words 2>&1
    status=$?
    cat words
    ls kill
    [ $status != 0 ] && [ $status != 124 ] && [ "$(ls kill | wc -l)" -lt 2900 ] || return 1
    for file in kill/[0-9][0-9][0-9][0-9].png; do
        [ "$(tail -c 8 "$file" | head -c 4)" = IEND ] || return 1
    done
    over_ranks "$1" 3 "$build/$1/gnomon" $turn -o kill/%04d.png || return 1
    for i in 0 1 2 3 4 5 6 7 8; do cmp "one_0$i.png" "kill/000$i.png" || return 1; done
}

result 'tasks of one process' "$build/test_tasks" "${TEST_SEED:-1}" 20
for engine in $present; do
    for n in 1 2 3 4; do
        result "$engine, $n ranks: equal bytes" draws_all "$engine" $n
        result "$engine, $n ranks: tasks" over_ranks "$engine" $n "$build/$engine/test_tasks" "${TEST_SEED:-1}$n" 20
    done
    result "$engine: progress" progress_is_told "$engine"
    result "$engine: only rank 0 reads" only_first_reads "$engine"
    faults "$engine"
    result "$engine: a full disk" full_disk "$engine"
    result "$engine: a rank is killed" killed "$engine"
done

# The page's job script, and its commands without MPI, with fewer frames.
awk -v language=sh -v folder="$work/block" -f "$blocks" "$page"
for block in block*; do
    result "$page: sh can read $block" sh -n "$block"
done
if command -v parallel >/dev/null; then
    mkdir parallel
    cp teapot.obj parallel/head.obj
    sed '/^[^-]/d; /^$/d; s/ *#.*//' views.txt >parallel/views.txt
    cat block* | grep -E '^(seq|parallel -j) ' | sed 's/ 359 / 2 /; s/-j 8/-j 2/; s/-P 8/-P 2/' >commands
    result "the page has three commands without MPI" test "$(wc -l <commands)" -eq 3
    while IFS= read -r command <&3; do
        result "$page: $command" env PATH="$build:$PATH" HOME="$work" sh -c 'cd parallel && rm -f ./*.png && eval "$1" && ls && test "$(cksum ./*.png | cut -d " " -f 1 | sort -u | wc -l)" -ge 3' - "$command"
    done 3<commands
else
    skip "frames over ranks: commands of GNU parallel do not run, since it is absent: 'make setup' installs it"
fi
echo "frames over ranks: $passed passed, $failed failed"
[ "$failed" = 0 ]
