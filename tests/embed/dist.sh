#!/bin/sh
# Makes the source archive, unpacks it where there is no git, builds the library and a unit test
# there, and installs it for the README's program. A stand-in for git fails the test if it is called.
# The archive must hold what git tracks, and be the same bytes if it is made again from what was
# unpacked, with other rights and times. To save time, the everyday gate compiles plain C alone; --all builds the
# library and the command as users do.
# usage: dist.sh BUILD-DIRECTORY [--all]   (from the root of the project)
set -eu
. tests/skip.sh
export MAKEFLAGS=
directory=$(mktemp -d)
trap 'rm -rf "$directory"' EXIT
passed=0
failed=0
check() { # check WHAT COMMAND...
    what=$1
    shift
    if "$@" >"$directory/log" 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: archive, $what"
        tail -n 20 "$directory/log" | sed 's/^/    /'
    fi
}

version=$(sed -n 's/^.define GN_VERSION_[A-Z]* \([0-9]*\)$/\1/p' include/gnomon/version.h | paste -s -d .)
name=gnomon-$version
make -s dist BUILD="$directory/build" >"$directory/printed"
archive=$directory/build/$name.tar.gz
check "prints its name" grep -q "^$archive\$" "$directory/printed"
tar -tzf "$archive" | sed "s|^$name/||" >"$directory/listed"
if [ -e .git ] && command -v git >/dev/null; then
    git ls-files | LC_ALL=C sort >"$directory/tracked"
    check "the files that git tracks" diff "$directory/tracked" "$directory/listed"
fi
check "owner and group" sh -c "! tar -tvzf '$archive' | grep -v ' 0/0 '"

mkdir -p "$directory/unpacked" "$directory/bin"
(umask 077 && tar -xzf "$archive" -C "$directory/unpacked")
# shellcheck disable=SC2016
printf '#!/bin/sh\necho "git $*" >>"%s/called"\nexit 1\n' "$directory" >"$directory/bin/git"
chmod +x "$directory/bin/git"
PATH=$directory/bin:$PATH
here=$(pwd)
cd "$directory/unpacked/$name"
touch src/*/*.c
chmod -R go-rwx .
check "an archive of what was unpacked" sh -c "make -s dist && cmp build/$name.tar.gz '$archive'"
# What builds and people leave in the tree.
mkdir -p tools/python/build tools/python/src/gnomon.egg-info
touch a.out build/object.o tools/python/build/copy.py tools/python/src/gnomon.egg-info/PKG-INFO
check "an archive of what was unpacked, built and tried" \
    sh -c "make -s dist BUILD=../elsewhere && cmp ../elsewhere/$name.tar.gz '$archive'"
if [ "${2:-}" = --all ]; then
    set --
    check "builds everything" make -s -j2 all
    check "the command" sh -c "build/gnomon --version | grep -F '$version'"
else
    set -- CFLAGS='-O1 -DGN_ONLY_PORTABLE'
    check "builds the library" make -s -j2 library "$@"
fi
check "builds a unit test" make -s build/test_draw "$@"
check "the unit test" build/test_draw
check "installs the library" make -s install-library PREFIX="$directory/installed" "$@"
awk -v first=1 -f tests/embed/blocks.awk README.md >"$directory/triangle.c"
check "the README's program, compiles" "${CC:-cc}" -std=c99 "$directory/triangle.c" -I"$directory/installed/include" \
    "$directory/installed/lib/libgnomon.a" -o "$directory/triangle"
check "the README's program, draws" sh -c "'$directory/triangle' | wc -c | grep -q -x 230415"
cd "$here"
check "git is not called" [ ! -e "$directory/called" ]
echo "archive: $passed passed, $failed failed"
[ "$failed" = 0 ]
