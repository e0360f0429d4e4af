#!/bin/sh
# Coverage: which lines, branches and conditions (MC/DC) of src/ the tests reach. Three forms of
# the library are measured, each in a build of its own, and added up (merge.py): plain C over
# sixteen lanes; little code (GN_SMALL); one lane with few features (GN_BASIC), which draws scenes
# whose hashes `tests/portability/cross.sh BUILD one-lane` compares. The lanes of processors' vectors
# are not in them; `build/test-lanes` compares each of their operations with the plain form's.
# A run that was ended goes on: what a test reached counts until its program is built again.
# unreached.txt names the functions of which something is never reached, with the reason.
# usage: coverage.sh BUILD-DIRECTORY [--jobs N]   (from the root of the project)
# Ends with "coverage: lines P %, branches P %, MC/DC P %, N places unreached, each with its reason".
# Exit status 0 if lines are at least 99 %, branches 95 %, and every unreached place has a reason.
set -u
export MAKEFLAGS=
here=tests/coverage
jobs=2
usage() { sed -n '/^# usage/,/^# Exit/p' "$0" | sed 's/^# //'; }
fail() { echo "coverage: $*" >&2; exit 2; }
say() { echo "coverage: $*" >&2; }

[ "${1:-}" != --help ] || { usage; exit 0; }
[ $# -ge 1 ] || { usage >&2; exit 2; }
work=$1/coverage
shift
while [ $# -gt 0 ]; do
    case $1 in
    --jobs) jobs=${2:-2}; shift 2 || fail "--jobs takes a number" ;;
    --help) usage; exit 0 ;;
    *) fail "unknown argument '$1'" ;;
    esac
done
for tool in clang-19 llvm-profdata-19 llvm-cov-19; do
    command -v $tool >/dev/null 2>&1 || fail "$tool is missing: make setup-verify"
done

plain='-DGN_ONLY_PORTABLE -DGN_NO_VECTORS'
# Atomic counters: the ways of a branch are differences of counts, which threads must not falsify.
instrument='-fprofile-instr-generate -fprofile-update=atomic -fcoverage-mapping -fcoverage-mcdc'
units=$(ls tests/unit/test_*.c | sed 's,.*/,,; s,\.c$,,')

# tests FORM: the form's tests, one a line. Unit tests know the plain form; test_far_texels knows
# every form.
tests() {
    case $1 in
    plain)
        printf '%s\n' $units
        echo "test_cglm 1"
        echo "exhaustive-scalars --stride 9973"
        echo "texels --textures 12"
        echo "textures --cases 300"
        echo "blits --blits 2310"
        for seed in 1 2; do
            echo "property-tests --seed $seed --trials 100"
            echo "parity --seed $seed --scenes 735"
        done
        echo "parity --class sample-shading --scenes 300"
        for scene in tests/parity/scenes/*.scene; do
            echo "parity --replay $scene"
        done
        ;;
    basic)
        echo test_basic
        echo test_far_texels
        echo test_workspaces
        echo "hashes --scenes 0 --basic 980 --mathematics 30"
        ;;
    *)
        echo "parity --seed 1 --scenes 490"
        echo "blits --blits 330"
        echo "textures --cases 120"
        echo "exhaustive-scalars --stride 9973"
        ;;
    esac
}

flags() {
    case $1 in
    plain) echo "-O1 $plain" ;;
    small) echo "-O1 $plain -DGN_SMALL" ;;
    basic) echo "-O1 $plain -DGN_SMALL -DGN_BASIC -DGN_LANES=1" ;;
    esac
}

measure() { # measure FORM
    build=$work/$1
    form_flags=$(flags "$1")
    programs=$(tests "$1" | sed "s, .*,,; s,^,$build/," | sort -u)
    say "$1: building"
    # shellcheck disable=SC2086
    make -s -j"$jobs" BUILD="$build" CC=clang-19 LINKER='clang-19 -fprofile-instr-generate' WARNINGS=-w \
        CFLAGS="$form_flags" LIBRARY_LEVEL="$form_flags $instrument" $programs >"$work/$1.log" 2>&1 ||
        { tail -n 20 "$work/$1.log" >&2; fail "$1: cannot be built"; }
    mkdir -p "$build/raw"
    tests "$1" | while read -r program arguments; do
        name=$(echo "$program${arguments:+ $arguments}" | tr -c 'a-z0-9\n' _)
        # What a program has reached stays true until the program is built again.
        [ "$build/raw/$name.profraw" -nt "$build/$program" ] || echo "$program${arguments:+ $arguments}"
    done >"$work/$1.todo"
    say "$1: running $(wc -l <"$work/$1.todo") of $(tests "$1" | wc -l) tests"
    xargs -P "$jobs" -I '{}' sh -c '
        name=$(echo "{}" | tr -c "a-z0-9\n" _)
        rm -f '"$build"'/raw/$name.profraw
        LLVM_PROFILE_FILE='"$build"'/raw/$name.part '"$build"'/{} >'"$build"'/raw/$name.log 2>&1 ||
            { tail -n 5 '"$build"'/raw/$name.log >&2; echo "coverage: FAILED: '"$1"': {}" >&2; exit 1; }
        mv '"$build"'/raw/$name.part '"$build"'/raw/$name.profraw
        echo "coverage: '"$1"': {}" >&2' <"$work/$1.todo" || fail "$1: a test failed"
    tests "$1" | while read -r line; do
        echo "$build/raw/$(echo "$line" | tr -c 'a-z0-9\n' _).profraw"
    done | xargs llvm-profdata-19 merge -sparse -o "$build/all.profdata" || fail "$1: no profile"
    objects=$(echo "$programs" | sed 's/^/-object /')
    # shellcheck disable=SC2086
    llvm-cov-19 show -show-instantiations=false -show-branches=count -show-mcdc $objects \
        -instr-profile "$build/all.profdata" >"$build/shown.txt" 2>"$build/shown.log" ||
        { tail -n 5 "$build/shown.log" >&2; fail "$1: llvm-cov failed"; }
}

mkdir -p "$work"
sources=$(find src include -type f | LC_ALL=C sort | xargs cksum | cksum)
for form in small basic plain; do
    measure $form
done
[ "$sources" = "$(find src include -type f | LC_ALL=C sort | xargs cksum | cksum)" ] ||
    fail "src/ or include/ has changed during the run"
python3 $here/merge.py $here/unreached.txt "$work"/*/shown.txt
