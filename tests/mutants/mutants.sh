#!/bin/sh
# Mutation test: changes the library's source in one random place, builds, and runs tests until one
# fails. The mutant is then killed. A mutant that survives shows a test that is missing, or code
# whose change no caller can notice; survivors.txt names those with the reason.
# The library is built in plain C without optimisation in trees of their own under
# BUILD-DIRECTORY/mutants; the working tree is not touched. It traps at undefined operations, so that
# a mutant that makes one is killed. mutate.py chooses places, steps.txt is what runs. A mutant that
# does not compile, or whose object code equals the original's, is not counted, and another is drawn.
# The seed is the commit's hash, so that nobody chooses it, unless --seed gives one.
# Results are in BUILD-DIRECTORY/mutants/results-SEED.txt. A run that was ended goes on there; a run
# after tests have changed tries survivors without a reason again; a run after src/ or include/ has
# changed begins anew.
# usage: mutants.sh BUILD-DIRECTORY [--mutants N] [--seed S] [--jobs N] [--only TEXT] [--report] [--check]
#   --only TEXT  only mutants whose file or function contains the text
#   --jobs N     mutants that are tried at a time, on each machine, each in a tree of its own (2)
#   --try "N JOB TESTS" what GNU parallel runs: tries mutant N of the list in tree JOB, and prints its line
#                of the results; TESTS is the sum of the tests
#   --report     prints the results so far, runs nothing
#   --check      only checks that survivors.txt names mutations of the source
# Environment: PARALLEL has options for parallel, such as "--sshloginfile FILE"; its machines share this
# directory.
# Ends with "mutants: N, N killed, N equivalent, N survived (P %), seed S": P is the share of the
# killed among those that are not equivalent. Exit status 0 if P is at least 95.
set -u
export MAKEFLAGS=
here=tests/mutants
goal=95
mutants=200
seed=""
jobs=2
only=""
report=""
check=""
try=""

usage() { sed -n '/^# usage/,/^# Ends/p' "$0" | sed '$d; s/^# //'; }
fail() { echo "mutants: $*" >&2; exit 2; }

[ "${1:-}" != --help ] || { usage; exit 0; }
case ${1:-} in
"") usage >&2; exit 2 ;;
-*) fail "the build directory comes first, not '$1' (--help says more)" ;;
esac
build=$1
shift
while [ $# -gt 0 ]; do
    case $1 in
    --mutants | --seed | --jobs)
        case ${2:-} in '' | *[!0-9]*) fail "$1 takes a number" ;; esac
        case $1 in --mutants) mutants=$2 ;; --seed) seed=$2 ;; *) jobs=$2 ;; esac
        shift 2
        ;;
    --try) try=${2:-}; shift 2 || fail "--try takes three numbers" ;;
    --only) only=${2:-}; shift 2 || fail "--only takes a text" ;;
    --report) report=yes; shift ;;
    --check) check=yes; shift ;;
    --help) usage; exit 0 ;;
    *) fail "unknown argument '$1'" ;;
    esac
done

# Without a repository, as in an unpacked archive, the seed is 1.
commit=$(git rev-parse HEAD 2>/dev/null | cut -c -7)
seed=${seed:-$(printf '%d' "0x${commit:-1}")}
work=$(mkdir -p "$build/mutants" && cd "$build/mutants" && pwd) || exit 2
base=$work/base
results=$work/results-$seed.txt
tab=$(printf '\t')

# In plain C; lanes are arrays. All symbols are visible, so that tests of inner functions link with the
# shared library. Traps need no other library. Null pointers fault by themselves; checks of every pointer
# would make tests run twice as long.
traps='-fsanitize=undefined,float-cast-overflow -fno-sanitize=null,alignment,object-size,pointer-overflow -fsanitize-undefined-trap-on-error'
library_level="-O0 -DGN_ONLY_PORTABLE -DGN_NO_VECTORS $traps"
programs() { sed -n 's/^[^#:]*: *\(SAME \)\{0,1\}\([^ ]*\).*/\2/p' $here/steps.txt | sort -u; }

# sum_of FOLDER...: one number for the contents of all their files.
sum_of() { find "$@" -type f | LC_ALL=C sort | xargs cksum | cksum | cut -d ' ' -f 1; }

if [ -z "$try" ]; then
    sources=$(sum_of include src)-$(sum_of $here/mutate.py)
    tests=$(sum_of tests/*/*.[ch] reference tools/threads $here/steps.txt)
else
    # shellcheck disable=SC2086
    set -- $try
    [ $# -eq 3 ] || fail "--try takes three numbers: '$try'"
    number=$1
    job=$2
    tests=$3
fi

say() { echo "mutants: $*" >&2; }

# The unchanged library and the tests

build_base() {
    [ "$(cat "$base/built" 2>/dev/null)" != "$sources $tests" ] || return 0
    say "building the library and the tests in plain C"
    mkdir -p "$base"
    for folder in src include tests reference tools; do
        # Files keep their times, so that make builds what has changed; what is gone must go.
        rm -rf "$base/$folder"
        cp -rp $folder "$base/"
    done
    cp -p Makefile $here/steps.txt "$base/"
    rm -f "$base/built"
    programs=$(programs | sed 's,^,build/,')
    # shellcheck disable=SC2086
    (cd "$base" && make -s -j"$jobs" BUILD=build WARNINGS=-w CFLAGS=-O1 TEST_LEVEL= SANITIZE=-fvisibility=default \
        LIBRARY_LEVEL="$library_level" build/libgnomon.so $programs) >"$work/build.log" 2>&1 ||
        { tail -n 20 "$work/build.log" >&2; fail "the tests cannot be built"; }
    # Programs find the library beside them, so that a mutant needs no new programs.
    ln -sf libgnomon.so "$base/build/$(objdump -p "$base/build/libgnomon.so" | awk '$1 == "SONAME" { print $2 }')"
    for program in $(programs); do
        (cd "$base" && eval "$(link_command "$program") -o build/$program") || fail "$program cannot be linked"
        objdump -p "$base/build/$program" | grep -q 'NEEDED *libgnomon' || fail "$program uses nothing of the library"
    done
    dependencies
    rm -rf "$work"/job* "$base/passed"
    mkdir "$base/passed"
    echo "$sources $tests" >"$base/built"
}

# Programs get the shared library in place of the archive or of its objects.
link_command() { # link_command PROGRAM
    sed "s, build/src/[^ ]*\.o\| build/libgnomon\.a,,g; s,\$, -Lbuild -lgnomon '-Wl\,-rpath\,\$ORIGIN'," "build/$1.command"
}

# Writes for every file of src/ and include/ the objects that depend on it: FILE OBJECT.
dependencies() {
    (cd "$base" && find build -name '*.d' | while read -r list; do
        tr ' \\' '\n\n' <"$list" | grep -E '^(src|include|tests|reference|tools)/.*[^:]$' |
            awk -v object="${list%.d}.o" '
            { while (sub(/[^\/.]+\/\.\.\//, "")); if ($0 ~ /^(src|include)\//) print $0, object }'
    done | sort -u) >"$base/dependencies"
}

# Runs a step with the unchanged library before it first judges a mutant. It must pass; how long it
# takes sets its limit. Leaves the seconds, and what the step prints, in files of $base/passed.
check_step() { # check_step NAME STEP
    while [ ! -f "$base/passed/$1" ]; do
        if ! mkdir "$base/passed/$1.claim" 2>/dev/null; then
            [ ! -f "$work/failed" ] || return 1
            sleep 1
            continue
        fi
        began_step=$(date +%s)
        if ! (cd "$base" && sh -c "build/${2#SAME }") >"$base/passed/$1.output" 2>"$base/passed/$1.errors"; then
            tail -n 5 "$base/passed/$1.output" "$base/passed/$1.errors" >&2
            say "'$2' fails with the unchanged library"
            : >"$work/failed"
            return 1
        fi
        echo $(($(date +%s) - began_step)) >"$base/passed/$1"
    done
}

# Prints the commands in the order for a folder of src/.
steps() {
    awk -v folder="$1" -F ': *' '
        /^#/ || !NF { next }
        {
            n = split($1, folders, " ")
            group = $1 == "-" ? 2 : 3
            for (i = 1; i <= n; ++i) if (folders[i] == folder && folder != "-") group = 1
            list[group] = list[group] substr($0, index($0, ":") + 2) "\n"
        }
        END { printf "%s%s%s", list[1], list[2], list[3] }' "$base/steps.txt" | awk '!seen[$0]++'
}

# Mutants

list_mutants() {
    list=$work/list-$seed
    [ "$(cat "$list.of" 2>/dev/null)" != "$sources $seed" ] || return 0
    # The files of which the library is made.
    sed -n 's, build/src/.*,,p' "$base/dependencies" | sort -u >"$work/files"
    # shellcheck disable=SC2046
    python3 $here/mutate.py --list "$seed" $(cat "$work/files") | LC_ALL=C sort >"$list"
    [ -s "$list" ] || fail "no list of mutations"
    echo "$sources $seed" >"$list.of"
}

field() { printf '%s\n' "$1" | cut -f "$2"; }

# Runs a command of steps.txt in this directory. Status 0: passed, 1: failed, 2: took too long.
run_step() {
    name=$(echo "$1" | tr -c 'a-z0-9\n' _)
    check_step "$name" "$1" || exit 2
    limit=$(($(cat "$base/passed/$name") * 4 + 10))
    rm -f step.log # what a killed run left running may still write to it
    (
        ulimit -c 0
        ulimit -t $limit
        exec timeout -k 5 $((limit * 10)) sh -c "exec build/${1#SAME }"
    ) >step.log 2>&1 &
    child=$!
    wait $child
    case $? in
    0) [ "${1#SAME }" = "$1" ] || cmp -s step.log "$base/passed/$name.output" || return 1 ;;
    124 | 137 | 152) return 2 ;;
    *) return 1 ;;
    esac
}

# Builds everything that depends on the file; sets `changed` to the objects of the library that
# differ, and `made` to all files that were made. Status 1: a compiler rejects the mutant.
build_mutant() { # build_mutant FILE
    changed=""
    made=""
    objects=$(awk -v file="$1" '$1 == file { print $2 }' "$base/dependencies")
    for object in $objects; do
        case $object in build/src/*) ;; *) continue ;; esac
        made="$made $object"
        eval "$(cat "$object.command") -c $(source_of "$object") -o $object" 2>/dev/null </dev/null || return 1
        cmp -s "$object" "$base/$object" || changed="$changed $object"
    done
    [ -n "$changed" ] || return 0
    made="$made build/libgnomon.so"
    eval "$(cat build/libgnomon.so.command) -o build/libgnomon.so" 2>/dev/null || return 1
    for object in $objects; do
        case $object in build/src/*) continue ;; esac
        made="$made $object"
        eval "$(cat "$object.command") -c $(source_of "$object") -o $object" 2>/dev/null </dev/null || return 1
        for program in $(grep -l -F " $object " build/*.command); do
            program=${program#build/}
            program=${program%.command}
            [ "$program" != libgnomon.so ] && [ "$program" != libgnomon.a ] || continue
            made="$made build/$program"
            eval "$(link_command "$program") -o build/$program" 2>/dev/null || return 1
        done
    done
}

source_of() { echo "${1#build/}" | sed 's/\.o$/.c/'; }

# Tells whether all changed objects are equal when they are optimised, without traps.
equal_optimised() {
    for object in $changed; do
        for tree in . "$base"; do
            (cd "$tree" && eval "$(sed "s/-O0/-O2/; s/$traps//" "$object.command") -c $(source_of "$object") -o -" \
                2>/dev/null) >"optimised-$([ "$tree" = . ] && echo mutant || echo base)" || return 1
        done
        cmp -s optimised-mutant optimised-base || return 1
    done
}

# Sets `verdict` and `by`.
judge() { # judge FILE
    by=-
    if ! build_mutant "$1"; then
        verdict=uncompilable
        return
    fi
    if [ -z "$changed" ]; then
        verdict=equal
        return
    fi
    folder=${1#src/}
    steps "${folder%%/*}" >order
    while IFS= read -r step <&3; do
        run_step "$step"
        case $? in
        1) verdict=killed; by=$step; return ;;
        2) verdict=timeout; by=$step; return ;;
        esac
    done 3<order
    if equal_optimised; then
        verdict=equal
    else
        verdict=survived
    fi
}

# The verdict that counts for each number is the last one.
counted() {
    awk -F '\t' -v tests="$tests" '/^#/ { next } { verdict[$1] = $2 } END {
        for (n in verdict) count += verdict[n] != "equal" && verdict[n] != "uncompilable"
        print count + 0 }' "$results"
}

# Prints the mutants for whose survival survivors.txt has a reason: FILE, function, text before, text
# after, with tabs between.
explained() {
    awk '
        /^#/ || /^$/ { next }
        /^- /        { before = substr($0, 3); next }
        /^\+ /       { key = place "\t" before "\t" substr($0, 3); next }
        /^    /      { if (key != "") print key; key = ""; next }
                     { place = $0; sub(/ /, "\t", place) }' $here/survivors.txt
}

# A reason whose mutation the source no longer has would excuse nothing, or another mutation.
check_survivors() {
    # shellcheck disable=SC2046
    python3 $here/mutate.py --list "$seed" $(find src include -name '*.[ch]' -o -name '*.inl') | cut -f 2,4,8,9 |
        LC_ALL=C sort >"$work/places"
    explained | LC_ALL=C sort >"$work/reasons"
    LC_ALL=C comm -23 "$work/reasons" "$work/places" >"$work/unknown"
    [ ! -s "$work/unknown" ] || { cat "$work/unknown" >&2; fail "survivors.txt names what is no mutation of the source"; }
}

# Prints the numbers that have a verdict. A survivor of other tests without a reason has none.
judged() {
    explained | awk -F '\t' -v tests="$tests" '
        FILENAME == "-" { reason[$0] = 1; next }
        /^#/            { next }
        {
            file = $6
            sub(/:.*/, "", file)
            verdict[$1] = $2
            is_done[$1] = $2 != "survived" || $4 == tests || (file "\t" $7 "\t" $8 "\t" $9) in reason
        }
        END { for (n in verdict) if (is_done[n]) print n }' - "$results"
}

# Goes to a tree of one's own, as the base is. A run that is killed may leave a part of one.
enter_tree() { # enter_tree NUMBER
    job=$work/job$1
    if [ ! -d "$job" ]; then
        rm -rf "$job.partial"
        cp -rp "$base" "$job.partial" && mv "$job.partial" "$job" || exit 2
    fi
    cd "$job" || exit 2
    child=""
    trap '[ -z "$child" ] || kill $child 2>/dev/null; exit 1' TERM INT
    restore
}

# Prints the mutants that have no verdict: lines of the list, with their numbers.
without_verdict() {
    judged >"$work/judged"
    awk -F '\t' -v only="$only" -v judged="$work/judged" '
        BEGIN { while ((getline n < judged) > 0) done[n] = 1 }
        (only == "" || index($2, only) || index($4, only)) && !(NR in done) { print NR "\t" $0 }' \
        "$work/list-$seed"
}

# Tries as many mutants as are to be counted, and then others for those that are not counted, until
# there are enough. Those whose survival is looked at again are not counted anew. Parallel appends whole
# lines to the results.
try_all() {
    while true; do
        without_verdict >"$work/todo"
        awk -F '\t' -v left=$((mutants - $(counted))) '
            FILENAME == ARGV[1] { if (!/^#/) is_known[$1] = 1; next }
            $1 in is_known || left-- > 0 { print $1 }' "$results" "$work/todo" >"$work/round"
        [ -s "$work/round" ] || break
        say "$(counted) of $mutants count; $(grep -c '' "$work/round") more are tried"
        parallel --quote --jobs "$jobs" --workdir . --halt soon,fail=1 --arg-file "$work/round" \
            $here/mutants.sh "$build" --seed "$seed" --try "{} {%} $tests" </dev/null >>"$results" &
        workers=$!
        wait $workers
        status=$?
        workers=""
        [ $status -eq 0 ] || fail "parallel ended with exit status $status; $results has the results so far"
    done
}

# restore: undoes the mutant that `undo` names.
restore() {
    [ -f undo ] || return 0
    while read -r path; do
        cp -p "$base/$path" "$path"
    done <undo
    rm -f undo
}

# Sets `result` to the mutant's line. restore undoes the mutant.
try() { # try LINE
    file=$(field "$1" 3)
    place=$(field "$1" 6)
    length=$(field "$1" 7)
    began=$(date +%s)

    # If this run is ended, the next one restores all that may be changed.
    { echo "$file"; echo build/libgnomon.so; awk -v file="$file" '$1 == file { print $2 }' "$base/dependencies"
        for object in $(awk -v file="$file" '$1 == file && $2 !~ /^build\/src/ { print $2 }' "$base/dependencies"); do
            grep -l -F " $object " build/*.command | sed 's/\.command$//'
        done
    } >undo
    python3 $here/mutate.py --apply "$base/$file" "$place" "$length" "$(field "$1" 8)" >mutated
    cp mutated "$file"
    judge "$file"
    seconds=$(($(date +%s) - began))
    result=$(printf '%s\t%s\t%s\t%s\t%s\t%s:%s\t%s\t%s\t%s' "$number" "$verdict" "$by" "$tests" "$seconds" "$file" \
        "$(field "$1" 4)" "$(field "$1" 5)" "$(field "$1" 9)" "$(field "$1" 10)")
}

# Prints survivors without a reason, and the line of figures. The first N mutants in the order of the
# draw count, whatever the order of jobs was.
print_report() {
    explained >"$work/explained"
    sort -s -t "$tab" -k 1,1n "$results" | awk -F '\t' -v wanted="$mutants" -v goal=$goal -v seed="$seed" '
        FILENAME != "-" { reason[$0] = 1; next }
        /^#/ { next }
        { line[$1] = $0; if (!($1 in known)) { known[$1] = 1; order[++count] = $1 } }
        END {
            for (i = 1; i <= count && total < wanted; ++i) {
                split(line[order[i]], f, "\t")
                if (f[2] == "equal" || f[2] == "uncompilable") continue
                ++total
                if (f[2] == "killed" || f[2] == "timeout") { ++killed; continue }
                file = f[6]; sub(/:.*/, "", file)
                key = file "\t" f[7] "\t" f[8] "\t" f[9]
                if (key in reason) { ++equivalent; continue }
                ++survived
                printf "survived: %s %s\n- %s\n+ %s\n", f[6], f[7], f[8], f[9]
            }
            share = total > equivalent ? 100 * killed / (total - equivalent) : 0
            printf "mutants: %d, %d killed, %d equivalent, %d survived (%.1f %%), seed %s\n", total,
                killed, equivalent, survived, int(share * 10) / 10, seed
            exit share < goal || total < wanted
        }' "$work/explained" -
}

if [ -n "$try" ]; then
    enter_tree "$job"
    line=$(sed -n "${number}p" "$work/list-$seed")
    [ -n "$line" ] || fail "list-$seed has no line $number"
    try "$number$tab$line"
    restore
    printf '%s\n' "$result"
    say "$verdict ($by, $seconds s): $file:$(field "$line" 3) $(field "$line" 4)"
    exit 0
fi
if [ -n "$report" ]; then
    [ -f "$results" ] || fail "no results of seed $seed"
    print_report
    exit
fi
check_survivors
[ -z "$check" ] || { echo "mutants: $(grep -c '' "$work/reasons") survivors with a reason, each a mutation of the source"; exit 0; }
command -v parallel >/dev/null 2>&1 || fail "GNU parallel is missing; 'make setup' installs it"
say "seed $seed"
build_base
list_mutants
if [ "$(head -n 1 "$results" 2>/dev/null)" != "# $sources" ]; then
    [ ! -f "$results" ] || mv "$results" "$results.old"
    echo "# $sources" >"$results"
fi
rm -rf "$work/failed" "$base"/passed/*.claim
workers=""
trap '[ -z "$workers" ] || kill $workers 2>/dev/null' EXIT
trap 'exit 1' INT TERM
try_all
print_report
