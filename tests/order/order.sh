#!/bin/sh
# Checks that no expression of the tests, the reference's scenes and the tools draws two random
# numbers, or changes another state twice, in an order that C leaves to the compiler. order.awk looks
# for such expressions in the program as Clang parses it. A generator with such an expression would
# make different tests with each compiler. First, sample.c shows what is found and what is not.
# usage: order.sh [SOURCE...]   (from the root of the project; default: every source of C)
set -u
here=tests/order
passed=0
failed=0
. tests/skip.sh

if ! command -v clang >/dev/null 2>&1; then
    skip "orders of evaluation: not looked at, since clang is absent: 'make setup' installs it"
    echo "order: 0 passed, $failed failed"
    exit "$failed"
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP

# unordered SOURCE: prints the expressions that order.awk finds. Status 1: it found one; 2: Clang
# cannot parse the source.
unordered() {
    : >"$work/lines"
    clang -std=c11 -D_POSIX_C_SOURCE=200809L -w -Iinclude -Ireference/scene -Ireference/osmesa \
        -Ireference/exact -Itests/parity -Itests/theft -Itests/accuracy -Itools/models -Itools/gnomon -Itools/explain -Itools/web -Isrc/lanes \
        -Itools/ranks -Itools/ranks/scale \
        -DGN_LANES_PORTABLE -DGN_NO_VECTORS -DLANES_FORM=portable '-DLANES_FORMS=FORM(portable)' \
        -fsyntax-only -fno-color-diagnostics -Xclang -ast-dump "$1" >"$work/tree" || return 2
    status=0
    awk -f $here/order.awk "$work/tree" >"$work/lines" || status=$?
    sort -u "$work/lines"
    return $status
}

grep -n '/\* named \*/$' $here/sample.c | cut -d: -f1 >"$work/expected"
unordered $here/sample.c | cut -d: -f2 >"$work/found"
if cmp -s "$work/expected" "$work/found"; then
    passed=$((passed + 1))
else
    failed=$((failed + 1))
    echo "FAILED: in $here/sample.c these lines shall be named (-), or were (+):"
    diff -U 0 "$work/expected" "$work/found" | grep '^[-+][0-9]'
fi

[ $# -gt 0 ] || set -- tests/*/*.c tools/*/*.c reference/*/*.c
for source; do
    # ranks_mpi.c needs the header of an MPI, and draws no numbers.
    case $source in $here/sample.c | tools/ranks/ranks_mpi.c) continue ;; esac
    status=0
    unordered "$source" >"$work/named" || status=$?
    if [ $status -eq 0 ]; then
        passed=$((passed + 1))
        continue
    fi
    failed=$((failed + 1))
    if [ $status -eq 2 ]; then
        echo "FAILED: $source: Clang cannot parse it"
    else
        echo "FAILED: $source: C does not say in which order these are evaluated:"
        sed 's/^/    /' "$work/named"
    fi
done
echo "order: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
