#!/bin/sh
# Installs into an empty tree, compares the files there with a list, moves the tree, and builds the
# README's program as CMake, pkg-config and the linker find the library in it, shared and static: the
# picture must be the one that libgnomon.a draws. Then uninstalls: nothing may be left but a file
# that another project put beside the headers.
# usage: install.sh BUILD-DIRECTORY   (from the root of the project, with library and command in it)
set -eu
. tests/packaging/packaging.sh
build=$1
begin install "$1/embed/install"
readme_program "$build"
root=$work/root

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
series=${version%.*}
case $series in
0.*) ;;
*) series=${series%.*} ;;
esac
sed 's|^|opt/gnomon/|' >"$work/expected" <<END
bin/gnomon
include/gnomon.h
lib/triplet/cmake/gnomon/gnomon-config-version.cmake
lib/triplet/cmake/gnomon/gnomon-config.cmake
lib/triplet/libgnomon.a
lib/triplet/libgnomon.so
lib/triplet/libgnomon.so.$series
lib/triplet/libgnomon.so.$version
lib/triplet/pkgconfig/gnomon.pc
share/bash-completion/completions/gnomon
share/man/man1/gnomon.1
share/zsh/site-functions/_gnomon
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
        cmake_program "gnomon::$target" $target "find_package(gnomon $series REQUIRED)" $target -Dgnomon_DIR="$moved/lib/triplet/cmake/gnomon"
        linked=$(objdump -p "$work/$target/build/triangle" | grep -c "NEEDED *libgnomon.so.$series\$") || :
        result "install, CMake, gnomon::$target: linked as asked" [ "$linked" = "$([ $target = static ] && echo 0 || echo 1)" ]
    done

    # Which versions find_package(gnomon VERSION) accepts: installed, wanted, bytes of a pointer, yes or
    # no; a range is 0.1 to 0.3 with its end (INCLUDE) or without (EXCLUDE).
    while read -r has wanted pointer suits; do
        {
            printf 'set(CMAKE_SIZEOF_VOID_P %s)\n' "$pointer"
            case $wanted in
            *CLUDE) printf 'set(PACKAGE_FIND_VERSION%s)\n' ' 0.1' '_RANGE x' '_MIN 0.1' '_MAX 0.3' "_RANGE_MAX $wanted" ;;
            *) printf 'set(PACKAGE_FIND_VERSION %s)\n' "${wanted#any}" ;;
            esac
            sed -e "s|@GN_VERSION@|$has|" -e 's|@GN_POINTER_SIZE@|8|' tools/packaging/gnomon-config-version.cmake.in
            printf 'if(NOT PACKAGE_VERSION_COMPATIBLE OR PACKAGE_VERSION_UNSUITABLE)\nmessage(FATAL_ERROR no)\nendif()\n'
        } >"$work/suits.cmake"
        if cmake -P "$work/suits.cmake" 2>/dev/null; then found=yes; else found=no; fi
        result "install, $has suits $wanted, $pointer bytes: $suits" [ "$found" = "$suits" ]
    done <<'END'
0.2.1 0.2 8 yes
0.2.1 0.2.1 8 yes
0.2.1 0.2.2 8 no
0.2.1 0.1 8 no
0.2.1 1.2 8 no
0.2.1 any 8 yes
0.2.1 EXCLUDE 8 yes
0.2.1 any 4 no
0.3 INCLUDE 8 yes
0.3 EXCLUDE 8 no
1.10.0 1.2 8 yes
1.10.0 0.10 8 no
1.10.0 2.0 8 no
END
else
    skip "CMake: finds no installed library, since it is absent: 'make setup' installs it"
fi
if command -v pkg-config >/dev/null; then
    export PKG_CONFIG_PATH="$moved/lib/triplet/pkgconfig"
    flags=$(pkg-config --define-variable=prefix="$moved" --cflags --libs gnomon)
    # shellcheck disable=SC2086
    result "install, pkg-config, compiles" ${CC:-cc} -std=c99 "$work/triangle.c" $flags -Wl,-rpath,"$moved/lib/triplet" -o "$work/by-pkg-config"
    result "install, pkg-config: same picture" same_picture "$work/by-pkg-config"
    result "install, pkg-config, version" [ "$(pkg-config --modversion gnomon)" = "$version" ]
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
    make -s install-library BUILD="$build" DESTDIR="$work/apart" "$@" >/dev/null
    sed -n 's/^get_filename_component(_gnomon_include "\([^"]*\)".*/\1/p' "$(find "$work/apart" -name gnomon-config.cmake)"
}
result "install, libraries apart from the prefix" [ "$(apart LIBDIR=/opt/libraries)" = /usr/local/include ]
result "install, headers apart from the prefix" [ "$(apart INCLUDEDIR=/opt/headers)" = /opt/headers ]
result "install, both in the prefix" [ "$(apart PREFIX=/opt/gnomon)" = ../../../include ]

# A place that make's lists cannot hold is refused before anything is written.
result "install, spaces are refused" sh -c "! make -s install-library BUILD='$build' DESTDIR='$work/refused' PREFIX='/a b' >'$work/refusal' 2>&1"
result "install, spaces are refused by name" grep -q "PREFIX must be a path without spaces" "$work/refusal"
result "install, nothing was written" [ ! -e "$work/refused" ]
finish
