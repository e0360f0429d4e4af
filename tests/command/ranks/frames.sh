#!/bin/sh
# Frames over ranks: gnomon spin and gnomon render --views write the same bytes with 1 to 4 ranks as
# one process does, each frame once, with both engines of MPI. Faults end all ranks with a status and
# a line that names them, and leave nothing half-written.
# usage: tests/command/ranks/frames.sh BUILD
set -u
cd "$(dirname "$0")/../../.."
build=$(cd "${1:?usage: tests/command/ranks/frames.sh BUILD}" && pwd) || exit 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
. tests/result.sh
. tests/skip.sh
. tests/command/ranks/launch.sh
SECONDS_LIMIT=60
cd "$work" || exit 2

# A knobbly ball with maps of its own, by the names that the command looks for. A map is larger
# than the block in which ranks share models.
awk 'function c(i) { return i "/" i "/" i }
BEGIN {
    n = 20; m = 40; pi = atan2(0, -1)
    for (i = 0; i <= n; ++i) for (j = 0; j <= m; ++j) {
        a = pi * (0.01 + 0.98 * i / n); b = 2 * pi * j / m; r = 1 + 0.2 * sin(5 * a) * cos(4 * b)
        printf "v %.6f %.6f %.6f\nvt %.6f %.6f\n", r * sin(a) * cos(b), r * cos(a), r * sin(a) * sin(b), j / m, i / n
        printf "vn %.6f %.6f %.6f\n", sin(a) * cos(b), cos(a), sin(a) * sin(b)
    }
    for (i = 0; i < n; ++i) for (j = 0; j < m; ++j) {
        p = i * (m + 1) + j + 1; q = p + m + 1
        print "f", c(p), c(p + 1), c(q)
        print "f", c(q), c(p + 1), c(q + 1)
    }
}' >ball.obj
for map in diffuse:vertex-color nm_tangent:normals spec:gouraud; do
    "$build/gnomon" spin --frames 1 --size 700x500 --shader "${map#*:}" -o "ball_${map%:*}.png" >/dev/null || exit 2
done
cat >around.txt <<'END'
# Views from all sides; some say little.
--eye 0,1,5
--eye 3,0,0 --fov 60    # nearer

--eye=0,4,1 --orthographic 2.5
--target 0,0.5,0 --eye 0,0,9 --up 1,0,0 --near 7 --far 10
--fov 20
--eye -3,-2,-4
END

# One run of each kind; %s is the name of the files.
turn='spin ball.obj --axis y --shadows --frames 9 --size 120x90'
list='render ball.obj --shader phong --shadows --views around.txt --size 100x70'
jobs="$turn -o %s_%%02d.png
$turn -o %s_%%d.tga
$turn -o %s.png
$list -o %s_v%%d.png --depth %s_d%%d.png
$list -o %s_v%%d.tga --samples 4"
all_jobs() { printf '%s\n' "$jobs" | sed "s/%s/$1/g; s/%%/%/g"; }

# The files that one process writes have the same names, with `one` in front.
all_jobs one | while read -r line; do "$build/gnomon" $line >/dev/null || exit 2; done
count=$(ls one*.png one*.tga | wc -l)

same_files() {
    [ "$(ls | grep -c "^$1[_.]")" = "$count" ] || { echo "not $count files: $(ls | grep "^$1[_.]" | tr '\n' ' ')"; return 1; }
    for file in one[_.]*; do
        cmp "$file" "$1${file#one}" || return 1
    done
}

# The rank of a process that either engine has started is $OMPI_COMM_WORLD_RANK or $PMI_RANK.
cat >as_rank <<'END'
#!/bin/sh
# as_rank FILE COMMAND...: does what FILE says with $rank, then becomes the command
rank=${OMPI_COMM_WORLD_RANK:-${PMI_RANK:?}}
. "$1"
shift
exec "$@"
END
chmod +x as_rank

# Says what is missing in what a run has said, and whether its status is wrong.
says() { grep -q -- "$1" said.txt || { echo "not said: $1"; cat said.txt; return 1; }; }

# ends TEXT COMMAND...: fails unless the command ends with a status other than 0, not that of
# a timeout, and says the text in one line of the command.
ends() {
    text=$1
    shift
    "$@" >said.txt 2>&1
    status=$?
    if [ $status = 0 ] || [ $status = 124 ] || [ $status = 137 ]; then
        echo "status $status"
        cat said.txt
        return 1
    fi
    [ "$(grep -c -e "$text" said.txt)" = 1 ] || { echo "not said once: $text"; cat said.txt; return 1; }
}

# Names in a directory, in one line.
holds() { [ "$(ls -A "$1" | tr '\n' ' ')" = "$2" ] || { echo "$1 has: $(ls -A "$1")"; return 1; }; }

for_ranks() { # ENGINE N: files are equal
    all_jobs "$1$2" >jobs.txt
    while read -r line; do
        over_ranks "$1" "$2" "$build/$1/gnomon" $line </dev/null >said.txt 2>&1 || { cat said.txt; return 1; }
        [ "$2" = 1 ] || says "^$2 ranks of .*, each with [0-9 to]* [a-z]*; memory of a rank: [1-9][0-9 to]* MiB$" || return 1
        [ "$(grep -c ' a second$' said.txt)" = 1 ] || { cat said.txt; return 1; }
    done <jobs.txt
    same_files "$1$2"
}

# Frames that all go to one pipe have as many bytes together as all frames have, so none is written
# twice or never.
each_once() {
    rm -rf once && mkdir once && mkfifo once/pipe
    for i in 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16; do ln -s pipe once/f$i.ppm; done
    cat once/pipe >once/all &
    reader=$!
    exec 3>once/pipe
    over_ranks "$1" 3 "$build/$1/gnomon" spin --frames 17 --size 100x80 -o once/f%d.ppm >said.txt 2>&1 3>&-
    status=$?
    exec 3>&-
    wait $reader
    size=$(wc -c <once/all)
    [ $status = 0 ] && [ "$size" = $((17 * (14 + 3 * 100 * 80))) ] || { echo "status $status, $size bytes"; cat said.txt; return 1; }
}

# Only rank 0 can read the model, its maps and the views.
only_first_reads() {
    rm -rf alone && mkdir alone alone/empty
    echo "[ \$rank = 0 ] || cd alone/empty" >first.sh
    over_ranks "$1" 3 "$work/as_rank" "$work/first.sh" "$build/$1/gnomon" $list -o "$work/alone/%02d.png" >said.txt 2>&1 || { cat said.txt; return 1; }
    ! grep 'rank [12]' said.txt || return 1
    for i in 0 1 2 3 4 5; do cmp "one_v$i.png" "alone/0$i.png" || return 1; done
}

no_model() {
    rm -rf gone && mkdir gone
    ends 'rank 0: missing.obj: cannot be read: No such file' over_ranks "$1" 3 "$build/$1/gnomon" spin missing.obj -o gone/%d.png &&
        ends 'rank 0: missing.txt: cannot be read: No such file' over_ranks "$1" 3 "$build/$1/gnomon" render ball.obj --views missing.txt -o gone/%d.png &&
        holds gone ''
}

wrong_usage() {
    rm -rf gone && mkdir gone
    printf -- '--fov 30\n--eye 1,2\n' >bad.txt
    printf -- '# nothing\n--eye 1,2,3 --target 1,2,3\n' >impossible.txt
    ends "bad.txt:2: --eye: '1,2': not three numbers" over_ranks "$1" 3 "$build/$1/gnomon" render ball.obj --views bad.txt -o gone/%d.png &&
        ends 'impossible.txt:2: --eye: impossible camera' over_ranks "$1" 3 "$build/$1/gnomon" render ball.obj --views impossible.txt -o gone/%d.png &&
        ends '-o is a pattern' over_ranks "$1" 3 "$build/$1/gnomon" render ball.obj --views around.txt -o gone/a.png &&
        ends 'no such option\|unknown option' over_ranks "$1" 3 "$build/$1/gnomon" spin --nothing &&
        ends '--up: impossible camera' over_ranks "$1" 3 "$build/$1/gnomon" spin --up 0,0,0 -o gone/%d.png &&
        holds gone ''
}

# A rank finds no directory to write to; it says so itself.
no_directory() {
    rm -rf there && mkdir there there/out there/other
    echo 'if [ $rank = 2 ]; then cd there/other; else cd there; fi' >first.sh
    ends 'rank 2: out/0.png: ' over_ranks "$1" 3 "$work/as_rank" "$work/first.sh" "$build/$1/gnomon" spin --frames 9 -o out/%d.png &&
        holds there/out ''
}

# A device that is full, at one frame or under the whole animation.
full_device() {
    rm -rf full && mkdir full
    ln -s /dev/full full/4.png
    ends 'full/4.png: cannot be written: No space left' over_ranks "$1" 3 "$build/$1/gnomon" spin --frames 400 --size 90x60 -o full/%d.png || return 1
    [ "$(ls full | wc -l)" -lt 100 ] || { echo "went on after the fault: $(ls full | wc -l) files"; return 1; }
    ls -A full | grep -v '^[0-9]*\.png$' && return 1
    ends '/dev/full: cannot be written: No space left' over_ranks "$1" 3 "$build/$1/gnomon" spin --frames 40 --size 90x60 -o /dev/full
}

# The files of rank 1 may not become as large as they must: as on a full disk, a write fails
# half-way. Blocks have 512 bytes; the limit leaves room for what MPI needs.
full_disk() {
    rm -rf full && mkdir full
    echo "[ \$rank = 0 ] || { trap '' XFSZ; ulimit -f 81920; }" >limit.sh
    ends 'rank 1: full/a.*.tga: cannot be written: File too large' over_ranks "$1" 2 "$work/as_rank" "$work/limit.sh" "$build/$1/gnomon" spin --frames 5 --size 3400x3400 -o full/a%d.tga || return 1
    for file in full/*; do
        [ "$(wc -c <"$file")" = $((18 + 26 + 4 * 3400 * 3400)) ] || { ls -lA full; return 1; }
    done
    [ -z "$(ls -A full | grep -v '^a[0-4].tga$')" ] || { ls -lA full; return 1; }
}

# A rank is killed as soon as some frames are there. Frames that are there are complete, and the next
# run goes on in the same directory, whatever the killed one has left.
killed() { # ENGINE RANK NAMES FILES
    rm -rf kill && mkdir kill
    echo 'echo $$ >kill/pid$rank' >pid.sh
    over_ranks "$1" 3 "$work/as_rank" "$work/pid.sh" "$build/$1/gnomon" spin ball.obj --frames 3000 --size 320x240 -o "kill/$3" >said.txt 2>&1 &
    launcher=$!
    tries=0
    until [ -s "kill/pid$2" ] && [ "$(ls kill | wc -l)" -ge "$4" ] || [ $tries = 300 ]; do
        sleep 0.05
        tries=$((tries + 1))
    done
    kill -9 "$(cat "kill/pid$2")"
    wait $launcher
    status=$?
    [ $status != 0 ] && [ $status != 124 ] || { echo "status $status"; cat said.txt; return 1; }
    says "signal 9\|EXIT CODE: 9" || return 1
    files=$(ls kill | grep -c '^[0-9a]*\.png$')
    [ "$files" -lt 2900 ] || { echo "$files files: not killed in time"; return 1; }
    rm -f kill/pid*
}

killed_frames() {
    killed "$1" 1 %04d.png 12 || return 1
    rm -rf whole && mkdir whole
    for file in kill/[0-9][0-9][0-9][0-9].png; do
        [ "$(tail -c 8 "$file" | head -c 4)" = IEND ] || { echo "$file is not complete"; return 1; }
    done
    over_ranks "$1" 3 "$build/$1/gnomon" $turn -o kill/%04d.png >said.txt 2>&1 || { cat said.txt; return 1; }
    for i in 0 1 2 3 4 5 6 7 8; do cmp "one_0$i.png" "kill/000$i.png" || return 1; done
}

killed_animation() {
    killed "$1" 0 a.png 4 || return 1
    [ ! -e kill/a.png ] || { echo 'a.png is there'; return 1; }
    over_ranks "$1" 3 "$build/$1/gnomon" $turn -o kill/a.png >said.txt 2>&1 || { cat said.txt; return 1; }
    cmp one.png kill/a.png
}

# Where no terminal is, rank 0 tells how far all are, in at most nine lines.
progress_is_told() {
    over_ranks "$1" 2 "$build/$1/gnomon" spin --frames 300 --size 700x500 -o once/f.png >said.txt 2>&1 || { cat said.txt; return 1; }
    lines=$(grep -c '^gnomon: [0-9]* of 300, [0-9]* s left$' said.txt)
    [ "$lines" -ge 1 ] && [ "$lines" -le 9 ] || { cat said.txt; return 1; }
}

tasks_once() { over_ranks "$1" "$2" "$build/$1/test_tasks" "$work/log" "${TEST_SEED:-1}$2" 20; }

result 'tasks of one process' "$build/test_tasks" "$work/log" "${TEST_SEED:-1}" 20
for engine in $engines; do
    if ! has_engine "$engine"; then
        skip "frames over ranks: mpirun.$engine is absent: 'make setup-mpi' installs it"
        continue
    fi
    for n in 1 2 3 4; do
        result "$engine, $n ranks: equal bytes" for_ranks "$engine" $n
        result "$engine, $n ranks: tasks" tasks_once "$engine" $n
    done
    result "$engine: each frame is written once" each_once "$engine"
    result "$engine: progress" progress_is_told "$engine"
    result "$engine: only rank 0 reads" only_first_reads "$engine"
    result "$engine: no model" no_model "$engine"
    result "$engine: wrong usage" wrong_usage "$engine"
    result "$engine: a rank without the directory" no_directory "$engine"
    result "$engine: a full device" full_device "$engine"
    result "$engine: a full disk" full_disk "$engine"
    result "$engine: a rank is killed, frames" killed_frames "$engine"
    result "$engine: a rank is killed, animation" killed_animation "$engine"
done
echo "frames over ranks: $passed passed, $failed failed"
[ "$failed" = 0 ]
