#!/bin/sh
# Mutation test: changes the library's source in one random place, builds, and runs tests until one
# fails. The mutant is then killed. A mutant that survives shows a test that is missing, or code
# whose change no caller can notice; survivors.txt names those with the reason.
# The library is built in plain C without optimisation in trees of their own under
# BUILD-DIRECTORY/mutants; the working tree is not touched. It traps at undefined operations, so that
# a mutant that makes one is killed. mutate.py chooses places, steps.txt is what runs. A mutant that
# does not compile, or whose object code equals the original's, does not count, and another is drawn.
# The seed is the commit's hash, so that nobody chooses it, unless --seed gives one.
# GNU parallel runs the mutants. A run that was ended goes on where it was, unless the library or the
# tests have changed.
# usage: mutants.sh BUILD-DIRECTORY [--mutants N] [--seed S] [--jobs N] [--only TEXT] [--check]
#   --only TEXT  only mutants whose file or function contains the text
#   --jobs N     mutants that are tried at a time, on each machine, each in a tree of its own (2)
#   --check      only checks that survivors.txt names mutations of the source
#   --try "DIRECTORY NUMBER JOB N"  what GNU parallel runs: tries a mutant of the list in tree JOB, unless N
#                mutants count already
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
check=""
try=""

usage() { sed -n '/^# usage/,/^# Ends/p' "$0" | sed '$d; s/^# //'; }
fail() { echo "mutants: $*" >&2; exit 2; }

case ${1:-} in
--help) usage; exit 0 ;;
"" | -*) usage >&2; exit 2 ;;
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
    --try) try=${2:-}; shift 2 || fail "--try takes a text" ;;
    --only) only=${2:-}; shift 2 || fail "--only takes a text" ;;
    --check) check=yes; shift ;;
    *) fail "unknown argument '$1'" ;;
    esac
done

# In plain C; lanes are arrays. All symbols are visible, so that tests of inner functions link with the
# shared library. Traps need no other library. Null pointers fault by themselves; checks of every pointer
# would make tests run twice as long.
traps='-fsanitize=undefined,float-cast-overflow -fno-sanitize=null,alignment,object-size,pointer-overflow -fsanitize-undefined-trap-on-error'
library_level="-O0 -DGN_ONLY_PORTABLE -DGN_NO_VECTORS $traps"

# The unchanged library and the tests

programs() { sed -n 's/^[^#:]*: *\(SAME \)\{0,1\}\([^ ]*\).*/\2/p' $here/steps.txt | sort -u; }

# Programs get the shared library, which stands beside them, in place of the archive or of its objects. A
# mutant then needs no new programs.
link_command() { # link_command PROGRAM
    sed "s, build/src/[^ ]*\.o\| build/libgnomon\.a,,g; s,\$, -Lbuild -lgnomon '-Wl\,-rpath\,\$ORIGIN'," "build/$1.command"
}

name_of() { echo "$1" | tr -c 'a-z0-9\n' _; }

# Leaves what each step prints with the unchanged library, and the seconds that it takes, in
# base/passed.
build_base() {
    [ ! -e "$work/base/built" ] || return 0
    echo "mutants: building the library and the tests in plain C" >&2
    rm -rf "$work/base"
    mkdir -p "$work/base/passed"
    cp -rp src include tests reference tools Makefile "$work/base/"
    cd "$work/base" || exit 2
    # shellcheck disable=SC2046
    make -s -j"$jobs" BUILD=build WARNINGS=-w CFLAGS=-O1 TEST_LEVEL= SANITIZE=-fvisibility=default \
        LIBRARY_LEVEL="$library_level" build/libgnomon.so $(programs | sed 's,^,build/,') >log 2>&1 ||
        { tail -n 20 log >&2; fail "the tests cannot be built"; }
    ln -sf libgnomon.so "build/$(objdump -p build/libgnomon.so | awk '$1 == "SONAME" { print $2 }')"
    for program in $(programs); do
        eval "$(link_command "$program") -o build/$program" || fail "$program cannot be linked"
        objdump -p "build/$program" | grep -q 'NEEDED *libgnomon' || fail "$program uses nothing of the library"
    done
    # FILE OBJECT, for every file of src/ and include/ and the objects that depend on it.
    find build -name '*.d' | while read -r list; do
        tr ' \\' '\n\n' <"$list" | awk -v object="${list%.d}.o" '
            { while (sub(/[^\/.]+\/\.\.\//, "")) ; if (/^(src|include)\/.*[^:]$/) print $0, object }'
    done | sort -u >dependencies
    sed -n 's/^[^#:]*: *\(SAME \)\{0,1\}//p' $here/steps.txt | sort -u | while read -r step; do
        began=$(date +%s)
        sh -c "build/$step" >"passed/$(name_of "$step")" 2>log || { tail -n 5 log >&2; fail "'$step' fails with the unchanged library"; }
        echo $(($(date +%s) - began)) >"passed/$(name_of "$step").seconds"
    done || exit 2
    : >built
    cd "$top" || exit 2
}

# Mutants

field() { printf '%s\n' "$line" | cut -f "$1"; }

# Prints the commands in the order for a folder of src/.
steps_for() {
    awk -v folder="$1" -F ': *' '
        /^#/ || !NF { next }
        {
            n = split($1, folders, " ")
            group = $1 == "-" ? 2 : 3
            for (i = 1; i <= n; ++i) if (folders[i] == folder && folder != "-") group = 1
            list[group] = list[group] substr($0, index($0, ":") + 2) "\n"
        }
        END { printf "%s%s%s", list[1], list[2], list[3] }' $here/steps.txt | awk '!seen[$0]++'
}

source_of() { echo "${1#build/}" | sed 's/\.o$/.c/'; }

# Builds everything that depends on the file; sets `changed` to the objects of the library that differ.
# Status 1: a compiler rejects the mutant.
build_mutant() { # build_mutant FILE
    changed=""
    objects=$(awk -v file="$1" '$1 == file { print $2 }' dependencies)
    for object in $(echo "$objects" | grep '^build/src/'); do
        eval "$(cat "$object.command") -c $(source_of "$object") -o $object" || return 1
        cmp -s "$object" "../base/$object" || changed="$changed $object"
    done
    [ -n "$changed" ] || return 0
    eval "$(cat build/libgnomon.so.command) -o build/libgnomon.so" || return 1
    for object in $(echo "$objects" | grep -v '^build/src/'); do
        eval "$(cat "$object.command") -c $(source_of "$object") -o $object" || return 1
        for program in $(grep -l -F " $object " build/*.command | sed 's,^build/,,; s,\.command$,,' | grep -v '^libgnomon'); do
            eval "$(link_command "$program") -o build/$program" || return 1
        done
    done
}

# Tells whether all changed objects are equal when they are optimised, without traps.
equal_optimised() {
    for object in $changed; do
        optimised="$(sed "s/-O0/-O2/; s/$traps//" "$object.command") -c $(source_of "$object") -o"
        eval "$optimised mutant.o" && (cd ../base && eval "$optimised ../job$job/base.o") && cmp -s mutant.o base.o || return 1
    done
}

# Sets `verdict` and the step that killed the mutant, `by`.
judge() { # judge FILE
    by=-
    verdict=uncompilable
    build_mutant "$1" 2>log </dev/null || return
    verdict=equal
    [ -n "$changed" ] || return
    verdict=killed
    folder=${1#src/}
    steps_for "${folder%%/*}" >order
    while IFS= read -r by <&3; do
        step=${by#SAME }
        expected=passed/$(name_of "$step")
        limit=$(($(cat "$expected.seconds") * 4 + 10))
        (
            ulimit -c 0
            ulimit -t $limit
            exec timeout -k 5 $((limit * 10)) sh -c "exec build/$step"
        ) >log 2>&1 </dev/null || return
        [ "$step" = "$by" ] || cmp -s log "$expected" || return
    done 3<order
    by=-
    verdict=survived
    ! equal_optimised 2>/dev/null || verdict=equal
}

# Appends the mutant's line to the results.
try() { # try DIRECTORY NUMBER JOB WANTED
    work=$1 job=$3
    [ "$(grep -s -c -e "killed$tab" -e "survived$tab" "$work/results")" -lt "$4" ] || exit 3
    line=$(sed -n "$2p" "$work/list")
    # shellcheck disable=SC2115
    rm -rf "$work/job$job" && cp -rp "$work/base" "$work/job$job" && cd "$work/job$job" || exit 2
    file=$(field 2)
    began=$(date +%s)
    python3 $here/mutate.py --apply "../base/$file" "$(field 5)" "$(field 6)" "$(field 7)" >"$file"
    judge "$file"
    printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$verdict" "$file" "$(field 4)" "$(field 8)" "$(field 9)" "$(field 3)" "$by" >>"$work/results"
    echo "mutants: $verdict ($by, $(($(date +%s) - began)) s): $file:$(field 3) $(field 4)" >&2
}

# Reasons

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
    python3 $here/mutate.py --list 1 $(find src include -name '*.[ch]' -o -name '*.inl') | cut -f 2,4,8,9 |
        LC_ALL=C sort >"$work/places"
    explained | LC_ALL=C sort >"$work/reasons"
    LC_ALL=C comm -23 "$work/reasons" "$work/places" >"$work/unknown"
    [ ! -s "$work/unknown" ] || { cat "$work/unknown" >&2; fail "survivors.txt names what is no mutation of the source"; }
}

# Prints survivors without a reason, and the line of figures.
report() {
    explained | awk -F '\t' -v wanted="$mutants" -v goal=$goal -v seed="$seed" '
        FILENAME == "-" { reason[$0] = 1; next }
        $1 == "killed" { ++killed }
        $1 == "survived" && ($2 "\t" $3 "\t" $4 "\t" $5) in reason { ++equivalent; next }
        $1 == "survived" { ++survived; printf "survived: %s:%s %s\n- %s\n+ %s\n", $2, $6, $3, $4, $5 }
        END {
            total = killed + equivalent + survived
            share = killed + survived ? 100 * killed / (killed + survived) : 0
            printf "mutants: %d, %d killed, %d equivalent, %d survived (%.1f %%), seed %s\n", total,
                killed, equivalent, survived, int(share * 10) / 10, seed
            exit share < goal || total < wanted
        }' - "$work/results"
}

tab=$(printf '\t')
top=$(pwd)
if [ -n "$try" ]; then
    # shellcheck disable=SC2086
    try $try
    exit 0
fi
if [ -n "$check" ]; then
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
    check_survivors
    echo "mutants: $(grep -c '' "$work/reasons") survivors with a reason, each a mutation of the source"
    exit 0
fi

command -v parallel >/dev/null 2>&1 || fail "GNU parallel is missing; 'make setup' installs it"
# Without a repository, as in an unpacked archive, the seed is 1.
commit=$(git rev-parse HEAD 2>/dev/null | cut -c -7)
seed=${seed:-$(printf '%d' "0x${commit:-1}")}
text=$(find include src tests reference tools/threads -type f ! -name survivors.txt | LC_ALL=C sort | xargs cksum | cksum)
work=$build/mutants/$(echo "$text $seed $only" | cksum | cut -d ' ' -f 1)
mkdir -p "$work" && work=$(cd "$work" && pwd) || exit 2
check_survivors
echo "mutants: seed $seed, in $work" >&2
build_base
# The files of which the library is made.
# shellcheck disable=SC2046
python3 $here/mutate.py --list "$seed" $(sed -n 's, build/src/.*,,p' "$work/base/dependencies" | sort -u) | LC_ALL=C sort |
    awk -F '\t' -v only="$only" 'only == "" || index($2, only) || index($4, only)' >"$work/list"
# More than are wanted, since some do not count.
head -n $((mutants * 2 + 20)) "$work/list" | awk '{ print NR }' >"$work/numbers"
parallel --jobs "$jobs" --workdir . --joblog "$work/jobs" --resume-failed --arg-file "$work/numbers" \
    $here/mutants.sh "$build" --try "'$work {} {%} $mutants'" </dev/null
report
