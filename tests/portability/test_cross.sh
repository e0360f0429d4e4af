#!/bin/sh
# Tests that cross.sh finds what it looks for, in a copy of the project: a library with another
# constant, a tool or a C library that is absent, a package that no set-up installs, a function that no
# build calls, a table with few builds. embedded.sh also names an absent tool.
# usage: test_cross.sh BUILD   (from the root of the project; BUILD, a directory in it, has hashes)
set -u
build=${1:-}
case $build in
"" | /* | ../*)
    echo "usage: test_cross.sh BUILD   (a directory in the project)" >&2
    exit 2
    ;;
esac
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
passed=0
failed=0

# run STATUS COMMAND...: keeps what the command prints, and tests its exit status.
run() {
    expected=$1
    shift
    "$@" >"$work/log" 2>&1
    status=$?
    check "exit status $expected" [ $status -eq "$expected" ]
}

check() { # check WHAT COMMAND...
    what=$1
    shift
    if "$@" >/dev/null; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $what"
        sed 's/^/    /' "$work/log"
    fi
}

prints() { check "prints '$1'" grep -q -e "$1" "$work/log"; }

# The copy has the objects too. Its files keep their times, so that the build of this machine stays
# whole, although its text is changed.
change() { # change SED-SCRIPT FILE
    sed -i.whole "$1" "$work/tree/$2"
    check "$2 is changed" [ "$(cmp -s "$2" "$work/tree/$2" && echo same)" = "" ]
    touch -r "$2" "$work/tree/$2"
}

mkdir -p "$work/tree/$build" "$work/bin"
cp -a Makefile include src tests reference tools "$work/tree"
cp -a "$build/src" "$build/tests" "$build/reference" "$build/hashes" "$build/hashes.command" "$work/tree/$build"
table=tests/portability/builds
change 's/lanes_splat(16777215\.0f)/lanes_splat(LARGEST_DEPTH)/' src/fragment/depth.h
change '$a\
build whole | x86-64 | shared | | gcc | -O0 -DGN_SMALL -DGN_ONLY_PORTABLE -DLARGEST_DEPTH=16777215.0f |\
build mutant | x86-64 | shared | | gcc | -O0 -DGN_SMALL -DGN_ONLY_PORTABLE -DLARGEST_DEPTH=16777214.0f |\
build unlinked | x86-64 | own | | gcc | -nostdlib |' $table

# A path with every command but two.
IFS=:
for directory in $PATH; do
    ln -s "$directory"/* "$work/bin" 2>/dev/null
done
unset IFS
rm -f "$work/bin/clang" "$work/bin/qemu-system-arm"

cd "$work/tree" || exit 1
unset GN_NO_SKIP
export PATH="$work/bin"
run 1 tests/portability/cross.sh "$build" --scenes 0 whole mutant unlinked clang-O1
prints '^whole: portable: hashes equal$'
prints '^mutant: .*portable differs in .* piles .* basic-piles '
prints '^skipped: unlinked: not run, since gcc has no libraries to link with; package g++ .*make setup'
prints "^skipped: clang-O1: not run, since clang is absent; package clang: 'make setup' installs it"
prints '^pictures: 3 builds, 2 distinct$'
prints '^mathematics: 3 builds, 1 distinct$'
prints '^hashes: 3 builds, 2 distinct$'

cd - >/dev/null || exit 1
change '/qemu-user/s///' tools/setup-cross.sh
change 's/gn_vec3_angle//' tests/portability/mathematics.c
cd "$work/tree" || exit 1
GN_NO_SKIP=1 run 1 tests/portability/cross.sh "$build" --scenes 0 clang-O1
prints "^clang-O1: clang is absent; package clang: 'make setup' installs it"
prints '^packages that no set-up installs: .* qemu-arm: qemu-user'
prints 'does not call gn_vec3_angle'
prints '^hashes: 1 builds, 1 distinct$'

run 0 tests/microcontrollers/embedded.sh "$build" m4f-O2
prints "^skipped: m4f-O2: not run, since .* is absent: 'make setup-cross' installs it"
prints '^embedded: 0 passed, 0 failed$'
GN_NO_SKIP=1 run 1 tests/microcontrollers/embedded.sh "$build" m4f-O2 m0plus-O2
prints '^embedded: 0 passed, 2 failed$'

run 2 tests/portability/cross.sh "$build" no-such-build
prints "unknown build 'no-such-build'"
run 2 tests/portability/cross.sh "$build" --without "mutant no-such-build"
prints "unknown build 'no-such-build'"
run 2 tests/portability/cross.sh "$build" --without mutant whole
prints '^usage: '

sed -i -E '/^build /{/^build (whole|mutant) /!d}' $table
run 1 tests/portability/cross.sh "$build" --without mutant --scenes 0
prints '^builds with hashes: 2, fewer than 30$'
echo "cross: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
