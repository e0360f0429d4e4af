#!/bin/sh
# Makes the source archive, unpacks it where there is no git, builds the library and a unit test
# there, and installs it for the README's program. A stand-in for git fails the test if it is called.
# The archive must hold what git tracks, and be the same bytes if it is made again from what was
# unpacked, with other rights and times. To save time, plain C alone is compiled, and not optimised.
# usage: dist.sh BUILD-DIRECTORY   (from the root of the project)
set -eu
. tests/packaging/packaging.sh
begin archive
name=gnomon-$version
readme_program "$1"
make -s dist BUILD="$work/build" >"$work/printed"
archive=$work/build/$name.tar.gz
result "archive, prints its name" grep -q "^$archive\$" "$work/printed"
tar -tzf "$archive" | sed "s|^$name/||" >"$work/listed"
if [ -e .git ] && command -v git >/dev/null; then
    git ls-files | LC_ALL=C sort >"$work/tracked"
    result "archive, the files that git tracks" diff "$work/tracked" "$work/listed"
fi
result "archive, owner and group" sh -c "! tar -tvzf '$archive' | grep -v ' 0/0 '"

mkdir -p "$work/unpacked" "$work/bin"
(umask 077 && tar -xzf "$archive" -C "$work/unpacked")
# shellcheck disable=SC2016
printf '#!/bin/sh\necho "git $*" >>"%s/called"\nexit 1\n' "$work" >"$work/bin/git"
chmod +x "$work/bin/git"
PATH=$work/bin:$PATH
here=$(pwd)
cd "$work/unpacked/$name"
touch src/*/*.c
chmod -R go-rwx .
result "archive, an archive of what was unpacked" sh -c "make -s dist && cmp build/$name.tar.gz '$archive'"
# What builds and people leave in the tree.
mkdir -p tools/python/build tools/python/src/gnomon.egg-info
touch a.out build/object.o tools/python/build/copy.py tools/python/src/gnomon.egg-info/PKG-INFO
result "archive, an archive of what was unpacked, built and tried" \
    sh -c "make -s dist BUILD=../elsewhere && cmp ../elsewhere/$name.tar.gz '$archive'"
set -- CFLAGS='-O0 -DGN_ONLY_PORTABLE'
result "archive, builds the library" make -s -j2 library "$@"
result "archive, builds a unit test" make -s build/test_draw "$@"
result "archive, the unit test" build/test_draw
result "archive, installs the library" make -s install-library PREFIX="$work/installed" "$@"
result "archive, the README's program, compiles" ${CC:-cc} -std=c99 "$work/triangle.c" -I"$work/installed/include" \
    "$work/installed/lib/libgnomon.a" -o "$work/of-archive"
result "archive, the README's program, draws" same_picture "$work/of-archive"
cd "$here"
result "archive, git is not called" [ ! -e "$work/called" ]
touch "$work/unpacked/$name/.git"
result "archive, git that fails is called" sh -c "! make -s -C '$work/unpacked/$name' dist BUILD='$work/refused' 2>'$work/refusal'"
result "archive, git that fails is named" grep -q "git ls-files" "$work/refusal"
result "archive, git that fails: no archive" [ -z "$(find "$work/refused" -type f)" ]
finish
