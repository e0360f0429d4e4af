#!/bin/sh
# Compares the interface of the shared library with the recorded one of the last version, and says
# which number of the version must rise:
# - nothing differs: none;
# - functions are added: the minor number;
# - anything else differs (a function, a type that one takes, a structure's member, the SONAME): the
#   major number, or before 1.0 the minor number, which is then part of the SONAME
#   (gnomon/version.h).
# A version that CHANGELOG.md lists under a heading of its own is released, and its record stays. As
# long as it is not released, --record writes its record again. The records,
# tests/packaging/abi/libgnomon-VERSION.abi, are libabigail's description of an x86-64 library with
# debugging information.
# usage: abi.sh BUILD-DIRECTORY             compares; then tests that changes are found
#        abi.sh BUILD-DIRECTORY --record    writes the record of this version (make abi)
set -eu
. tests/skip.sh
export MAKEFLAGS=
passed=0
failed=0
for tool in abidw abidiff gcc; do
    command -v $tool >/dev/null && continue
    [ "${2:-}" != --record ] || { echo "abi.sh: needs $tool: 'make setup' installs it" >&2; exit 2; }
    skip "interface: not compared, since $tool is absent: 'make setup' installs it"
    echo "interface: 0 passed, $failed failed"
    exit "$failed"
done
case $(gcc -dumpmachine) in
x86_64-*linux*) ;;
*)
    echo "skipped: interface: recorded for x86-64 Linux alone"
    echo "interface: 0 passed, 0 failed"
    exit 0
    ;;
esac
mkdir -p "$1"
build=$(cd "$1" && pwd)/abi
root=$(pwd)

version_of() { # version_of TREE
    sed -n 's/^.define GN_VERSION_[A-Z]* \([0-9]*\)$/\1/p' "$1/include/gnomon/version.h" | paste -s -d .
}

# describe TREE BUILD: the description of a tree's library. Plain C has the same interface.
describe() {
    make -s -C "$1" BUILD="$2" CC=gcc CFLAGS='-g -O0 -DGN_ONLY_PORTABLE' "$2/libgnomon.so" >"$2.log" 2>&1 ||
        { cat "$2.log" >&2; return 1; }
    abidw --headers-dir "$1/include" --drop-private-types --no-show-locs --no-corpus-path --no-comp-dir-path \
        --type-id-style hash "$2/libgnomon.so"
}

# least OLD-VERSION KIND: the least version that may follow.
least() {
    echo "$1" | awk -F . -v kind="$2" '{
        if (kind == "none") print
        else if (kind == "added" || $1 == 0) print $1 "." $2 + 1 ".0"
        else print $1 + 1 ".0.0"
    }'
}

# compare OLD-VERSION OLD NEW-VERSION NEW REPORT: tells whether the new version has risen as it must.
compare() {
    kind=none
    status=0
    abidiff --no-default-suppression "$2" "$4" >"$5" || status=$?
    [ $((status & 3)) = 0 ] || { cat "$5"; return 1; }
    if [ "$status" != 0 ]; then
        kind=added
        abidiff --no-default-suppression --no-added-syms "$2" "$4" >/dev/null || kind=changed
    fi
    must=$(least "$1" $kind)
    [ "$(printf '%s\n' "$must" "$3" | sort -V | head -n 1)" = "$must" ]
}

released() {
    grep -q "^## $1\( \|\$\)" "$root/CHANGELOG.md"
}

version=$(version_of .)
record=$(printf '%s\n' tests/packaging/abi/libgnomon-*.abi | sort -V | tail -n 1)
recorded=$(basename "$record" .abi | sed 's/libgnomon-//')
[ -e "$record" ] || [ "${2:-}" = --record ] || { echo "no record in tests/packaging/abi: 'make abi' writes it"; echo "interface: 0 passed, 1 failed"; exit 1; }
describe "$root" "$build" >"$build.now"

if [ "${2:-}" = --record ]; then
    if [ -e "$record" ] && released "$recorded" && ! compare "$recorded" "$record" "$version" "$build.now" "$build.report"; then
        echo "abi.sh: $recorded is released, and this interface needs at least version $must" >&2
        exit 1
    fi
    mkdir -p tests/packaging/abi
    cp "$build.now" "tests/packaging/abi/libgnomon-$version.abi"
    echo "tests/packaging/abi/libgnomon-$version.abi"
    exit 0
fi

if compare "$recorded" "$record" "$version" "$build.now" "$build.report"; then
    passed=$((passed + 1))
    echo "interface: version $version, beside the recorded $recorded: $kind; SONAME $(objdump -p "$build/libgnomon.so" | awk '/SONAME/ { print $2 }')"
    [ ! -s "$build.report" ] || cat "$build.report"
else
    failed=$((failed + 1))
    cat "$build.report"
    echo "FAILED: the interface of $version is not that of the recorded $recorded ($kind)."
    if released "$recorded"; then
        echo "The version must be at least $must (include/gnomon/version.h). Then 'make abi' records it."
    else
        echo "$recorded is not released: 'make abi' records it anew. Were it released, the version would have to be $must."
    fi
fi

# Changes of copies that have only the scalar functions, which compile in a second.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
tree() { # tree NAME: a copy
    mkdir -p "$work/$1/src"
    cp -r Makefile include "$work/$1/"
    find tests tools -name '*.mk' | tar -cf - -T - | tar -xf - -C "$work/$1"
    cp -r src/config src/scalars "$work/$1/src/"
    sed -i 's/^GN_API uint32_t gn_version(void);/&\ntypedef struct gn_pair {\n    int first;\n} gn_pair;\nGN_API int gn_first(const gn_pair *p);/' \
        "$work/$1/include/gnomon/version.h"
    printf 'int gn_first(const gn_pair *p)\n{\n    return p->first;\n}\n' >>"$work/$1/src/config/version.c"
}
tree before
describe "$work/before" "$work/before-build" >"$work/before.abi"

# found WHAT KIND LEAST-AFTER-0.1.0 LEAST-AFTER-1.2.3: checks what is said of the copy `after`.
found() {
    describe "$work/after" "$work/after-build" >"$work/after.abi"
    for case in "0.1.0 $3" "1.2.3 $4"; do
        old=${case% *}
        if compare "$old" "$work/before.abi" "$old" "$work/after.abi" "$work/report"; then enough=yes; else enough=no; fi
        if [ "$kind $must $enough" = "$2 ${case#* } $([ "$2" = none ] && echo yes || echo no)" ] &&
            compare "$old" "$work/before.abi" "${case#* }" "$work/after.abi" "$work/report"; then
            passed=$((passed + 1))
        else
            failed=$((failed + 1))
            cat "$work/report"
            echo "FAILED: interface, $1: $kind, at least $must"
        fi
    done
    rm -rf "$work/after" "$work/after-build"
}

tree after
found "a copy" none 0.1.0 1.2.3
tree after
sed -i 's/gn_version(void)/gn_version(uint32_t of)/' "$work/after/include/gnomon/version.h"
sed -i 's/gn_version(void)/gn_version(uint32_t of)/; s/return GN/return 0 * of + GN/' "$work/after/src/config/version.c"
found "a parameter is added" changed 0.2.0 2.0.0
tree after
sed -i 's/^\(GN_API uint32_t gn_version\)(void);/&\n\1_added(void);/' "$work/after/include/gnomon/version.h"
printf 'uint32_t gn_version_added(void)\n{\n    return 1;\n}\n' >>"$work/after/src/config/version.c"
found "a function is added" added 0.2.0 1.3.0
tree after
sed -i 's/^    int first;/    int before_first;\n&/' "$work/after/include/gnomon/version.h"
found "a member is added" changed 0.2.0 2.0.0
tree after
sed -i '/^GN_API int gn_first/d' "$work/after/include/gnomon/version.h"
sed -i 's/^int gn_first/static inline &/' "$work/after/src/config/version.c"
found "a function is removed" changed 0.2.0 2.0.0
echo "interface: $passed passed, $failed failed"
[ "$failed" = 0 ]
