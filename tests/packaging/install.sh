#!/bin/sh
# Installs into an empty tree, compares the files there with a list, moves the tree, and builds the
# README's program as CMake, pkg-config and the linker find the library in it, shared and static: the
# picture must be the one that libgnomon.a draws. Then uninstalls: nothing may be left but a file
# that another project put beside the headers.
# usage: install.sh BUILD-DIRECTORY   (from the root of the project, with library and command in it)
set -eu
. tests/skip.sh
. tests/result.sh
export MAKEFLAGS=
build=$1
work=$(cd "$1" && pwd)/embed/install
root=$work/root
rm -rf "$work"
mkdir -p "$work"

awk -v first=1 -f tests/packaging/blocks.awk README.md >"$work/triangle.c"
"${CC:-cc}" -std=c99 -Iinclude "$work/triangle.c" "$build/libgnomon.a" -o "$work/triangle"
"$work/triangle" >"$work/triangle.ppm" 2>/dev/null
same_picture() {
    "$@" 2>/dev/null | cmp - "$work/triangle.ppm"
}

installed() { # the files in the tree, without the headers in gnomon/
    (cd "$root" && find . -type f -o -type l) | sed 's|^\./||' | grep -v '/include/gnomon/' | LC_ALL=C sort
}

# A prefix and a folder of libraries other than the usual ones.
prefix=/opt/gnomon
set -- BUILD="$build" DESTDIR="$root" PREFIX=$prefix LIBDIR=$prefix/lib/triplet
# This install(1) first installs the same build elsewhere: two installations at a time must not
# take each other's texts.
mkdir "$work/between"
cat >"$work/between/install" <<END
#!/bin/sh
PATH='$PATH'
[ -e '$work/other' ] || env -i PATH="\$PATH" make -s install-library BUILD='$build' DESTDIR='$work/other' PREFIX=/usr >&2
exec install "\$@"
END
chmod +x "$work/between/install"
(umask 077 && PATH="$work/between:$PATH" make -s install "$@")
for place in "$root$prefix/lib/triplet=$prefix" "$work/other/usr/lib=/usr"; do
    result "install, two at a time, ${place#*=}" grep -qx "prefix=${place#*=}" "${place%=*}/pkgconfig/gnomon.pc"
done
version=$(sed -n 's/^.define GN_VERSION_[A-Z]* \([0-9]*\)$/\1/p' include/gnomon/version.h | paste -s -d .)
series=${version%.*}
case $series in
0.*) ;;
*) series=${series%.*} ;;
esac
cat >"$work/expected" <<END
opt/gnomon/bin/gnomon
opt/gnomon/include/gnomon.h
opt/gnomon/lib/triplet/cmake/gnomon/gnomon-config-version.cmake
opt/gnomon/lib/triplet/cmake/gnomon/gnomon-config.cmake
opt/gnomon/lib/triplet/libgnomon.a
opt/gnomon/lib/triplet/libgnomon.so
opt/gnomon/lib/triplet/libgnomon.so.$series
opt/gnomon/lib/triplet/libgnomon.so.$version
opt/gnomon/lib/triplet/pkgconfig/gnomon.pc
opt/gnomon/share/bash-completion/completions/gnomon
opt/gnomon/share/man/man1/gnomon.1
opt/gnomon/share/zsh/site-functions/_gnomon
END
installed >"$work/found"
result "install, the files" diff "$work/expected" "$work/found"
result "install, the headers" diff -r include/gnomon "$root$prefix/include/gnomon"
result "install, others may read it" [ -z "$(find "$root" ! -type l ! -perm -o=r)" ]
result "install, the SONAME" sh -c "objdump -p '$root$prefix/lib/triplet/libgnomon.so' | grep 'SONAME *libgnomon.so.$series\$'"
result "install, the command" sh -c "'$root$prefix/bin/gnomon' --version | grep -F '$version'"

# The tree may be moved.
mv "$root" "$work/moved"
moved=$work/moved$prefix
if command -v cmake >/dev/null; then
    for target in gnomon static; do
        mkdir -p "$work/$target"
        printf 'cmake_minimum_required(VERSION 3.16)\nproject(user C)\nfind_package(gnomon %s REQUIRED)\nadd_executable(triangle "%s")\nset_target_properties(triangle PROPERTIES C_STANDARD 99)\ntarget_link_libraries(triangle gnomon::%s)\n' \
            "$series" "$work/triangle.c" $target >"$work/$target/CMakeLists.txt"
        result "install, CMake configures, gnomon::$target" cmake -S "$work/$target" -B "$work/$target/build" \
            -Dgnomon_DIR="$moved/lib/triplet/cmake/gnomon"
        result "install, CMake builds, gnomon::$target" cmake --build "$work/$target/build"
        result "install, CMake, gnomon::$target: same picture" same_picture "$work/$target/build/triangle"
        linked=$(objdump -p "$work/$target/build/triangle" | grep -c "NEEDED *libgnomon.so.$series\$") || :
        result "install, CMake, gnomon::$target: linked as asked" [ "$linked" = "$([ $target = static ] && echo 0 || echo 1)" ]
    done

    suits() { # suits yes|no VERSION: whether find_package(gnomon VERSION) accepts the installed one
        printf 'set(CMAKE_SIZEOF_VOID_P %s)\nset(PACKAGE_FIND_VERSION %s)\n%s\ninclude("%s")\nif(NOT PACKAGE_VERSION_COMPATIBLE OR PACKAGE_VERSION_UNSUITABLE)\nmessage(FATAL_ERROR no)\nendif()\n' \
            "${4:-8}" "$2" "${3:-}" "$work/versions/gnomon-config-version.cmake" >"$work/suits.cmake"
        if cmake -P "$work/suits.cmake" 2>/dev/null; then found=yes; else found=no; fi
        [ "$found" = "$1" ]
    }
    versions() { # versions VERSION: the file of that version
        mkdir -p "$work/versions"
        sed -e "s|@GN_VERSION@|$1|" -e 's|@GN_POINTER_SIZE@|8|' tools/packaging/gnomon-config-version.cmake.in \
            >"$work/versions/gnomon-config-version.cmake"
    }
    range='set(PACKAGE_FIND_VERSION_RANGE x)
set(PACKAGE_FIND_VERSION_MIN 0.1)
set(PACKAGE_FIND_VERSION_MAX 0.3)
set(PACKAGE_FIND_VERSION_RANGE_MAX'
    versions 0.2.1
    result "install, 0.2.1 suits 0.2" suits yes 0.2
    result "install, 0.2.1 suits 0.2.1" suits yes 0.2.1
    result "install, 0.2.1 suits no 0.2.2" suits no 0.2.2
    result "install, 0.2.1 suits no 0.1" suits no 0.1
    result "install, 0.2.1 suits no 1.2" suits no 1.2
    result "install, 0.2.1 suits any" suits yes ""
    result "install, 0.2.1 suits 0.1 to 0.3" suits yes 0.1 "$range EXCLUDE)"
    result "install, 0.2.1 suits no program of 32 bits" suits no 0.2 "" 4
    versions 0.3
    result "install, 0.3 suits 0.1 to 0.3" suits yes 0.1 "$range INCLUDE)"
    result "install, 0.3 suits nothing below 0.3" suits no 0.1 "$range EXCLUDE)"
    versions 1.10.0
    result "install, 1.10.0 suits 1.2" suits yes 1.2
    result "install, 1.10.0 suits no 0.10" suits no 0.10
    result "install, 1.10.0 suits no 2.0" suits no 2.0
else
    skip "CMake: finds no installed library, since it is absent: 'make setup' installs it"
fi
if command -v pkg-config >/dev/null; then
    flags=$(PKG_CONFIG_PATH=$moved/lib/triplet/pkgconfig pkg-config --define-variable=prefix="$moved" --cflags --libs gnomon)
    # shellcheck disable=SC2086
    result "install, pkg-config, compiles" "${CC:-cc}" -std=c99 "$work/triangle.c" $flags -Wl,-rpath,"$moved/lib/triplet" -o "$work/by-pkg-config"
    result "install, pkg-config: same picture" same_picture "$work/by-pkg-config"
    result "install, pkg-config, version" [ "$(PKG_CONFIG_PATH=$moved/lib/triplet/pkgconfig pkg-config --modversion gnomon)" = "$version" ]
else
    skip "pkg-config: finds no installed library, since it is absent: 'make setup' installs it"
fi
mv "$work/moved" "$root"

touch "$root$prefix/include/gnomon/another.h"
make -s uninstall "$@"
result "install, uninstalled, but not another's file" [ "$(find "$root" -type f -o -type l)" = "$root$prefix/include/gnomon/another.h" ]
rm "$root$prefix/include/gnomon/another.h"
make -s uninstall "$@"
result "install, uninstalled" [ -z "$(find "$root" -type f -o -type l -o -name 'gnomon?*' -o -path '*/gnomon/gnomon')" ]
result "install, uninstalled, folders of its own" [ -z "$(find "$root$prefix/include" "$root$prefix/lib" -name gnomon)" ]

make -s install-library "$@"
result "install, the library alone" [ "$(installed)" = "$(grep -v -e /bin/ -e /share/ "$work/expected")" ]

# Libraries outside the prefix: no relative path leads from them to the headers once either is moved.
apart() { # apart PLACE=PATH...: the folder of the headers in the file for CMake
    rm -rf "$work/apart"
    make -s install-library BUILD="$build" DESTDIR="$work/apart" "$@"
    sed -n 's/^get_filename_component(_gnomon_include "\([^"]*\)".*/\1/p' "$(find "$work/apart" -name gnomon-config.cmake)"
}
result "install, libraries apart from the prefix" [ "$(apart LIBDIR=/opt/libraries)" = /usr/local/include ]
result "install, headers apart from the prefix" [ "$(apart INCLUDEDIR=/opt/headers)" = /opt/headers ]
result "install, both in the prefix" [ "$(apart PREFIX=/opt/gnomon)" = ../../../include ]

# A place that make's lists cannot hold is refused before anything is written.
make -s install-library BUILD="$build" DESTDIR="$work/refused" PREFIX='/a b' >"$work/refusal" 2>&1 && failed=$((failed + 1))
result "install, spaces are refused by name" grep -q "PREFIX must be a path without spaces" "$work/refusal"
result "install, nothing was written" [ ! -e "$work/refused" ]
echo "install: $passed passed, $failed failed"
[ "$failed" = 0 ]
