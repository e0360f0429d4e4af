#!/bin/sh
# Builds the Debian packages, lets lintian look at them, and installs them with dpkg in an empty root.
# The README's program is compiled and linked with what stands there, through pkg-config and through
# CMake, and must draw the picture that the Makefile's library draws. Removed again, the packages
# leave no file.
# usage: deb.sh BUILD-DIRECTORY   (from the root of the project, with the library in it)
set -eu
. tests/skip.sh
. tests/result.sh
export MAKEFLAGS=
for tool in dpkg-buildpackage dh lintian fakeroot pkg-config; do
    command -v $tool >/dev/null && continue
    skip "Debian packages: not built, since $tool is absent: 'make setup-verify' installs it"
    echo "Debian packages: 0 passed, $failed failed"
    exit "$failed"
done
work=$(cd "$1" && pwd)/embed/deb
root=$work/root
rm -rf "$work"
mkdir -p "$work"
awk -v first=1 -f tests/packaging/blocks.awk README.md >"$work/triangle.c"
"${CC:-cc}" -std=c99 -Iinclude "$work/triangle.c" "$1/libgnomon.a" -o "$work/triangle"
"$work/triangle" >"$work/triangle.ppm" 2>/dev/null
same_picture() {
    env LD_LIBRARY_PATH="$root/usr/lib/$triplet" "$1" 2>/dev/null | cmp - "$work/triangle.ppm"
}

version=$(sed -n 's/^.define GN_VERSION_[A-Z]* \([0-9]*\)$/\1/p' include/gnomon/version.h | paste -s -d .)
triplet=$(dpkg-architecture -qDEB_HOST_MULTIARCH)
result "Debian packages, built" env DEB_BUILD_OPTIONS="parallel=2 noautodbgsym" make -s deb BUILD="$work"
[ "$failed" = 0 ] || { echo "Debian packages: $passed passed, $failed failed"; exit 1; }
soname=$(objdump -p "$1/libgnomon.so" | awk '$1 == "SONAME" { print $2 }')
library=libgnomon${soname#libgnomon.so.}

lintian --allow-root "$work"/deb/*.changes >"$work/lintian" 2>&1 || :
result "Debian packages, lintian: no errors" sh -c "! grep '^E:' '$work/lintian'"
echo "lintian: $(grep -c '^E:' "$work/lintian") errors, $(grep -c '^W:' "$work/lintian") warnings"
sed 's/^/    /' "$work/lintian"

# Other packages' files are not in the root, nor are the packages that these depend on.
in_root() {
    fakeroot dpkg --root="$root" --force-depends --force-not-root --force-script-chrootless "$@"
}
mkdir -p "$root/var/lib/dpkg/info" "$root/var/lib/dpkg/updates" "$root/var/log"
: >"$root/var/lib/dpkg/status"
for package in "$library" libgnomon-dev gnomon; do
    result "Debian packages, installs $package" in_root -i "$work/deb/${package}_${version}"_*.deb
done
result "Debian packages, the library is named after the SONAME" [ -e "$root/usr/lib/$triplet/$soname" ]
result "Debian packages, man page" [ -s "$root/usr/share/man/man1/gnomon.1.gz" ]
result "Debian packages, the command" sh -c "'$root/usr/bin/gnomon' --version | grep -F '$version'"
flags=$(PKG_CONFIG_LIBDIR="$root/usr/lib/$triplet/pkgconfig" PKG_CONFIG_SYSROOT_DIR="$root" PKG_CONFIG_ALLOW_SYSTEM_CFLAGS=1 \
    PKG_CONFIG_ALLOW_SYSTEM_LIBS=1 pkg-config --cflags --libs gnomon)
# shellcheck disable=SC2086
result "Debian packages, pkg-config, compiles" "${CC:-cc}" -std=c99 "$work/triangle.c" $flags -o "$work/by-pkg-config"
result "Debian packages, pkg-config, same picture" same_picture "$work/by-pkg-config"
if command -v cmake >/dev/null; then
    mkdir "$work/user"
    printf 'cmake_minimum_required(VERSION 3.16)\nproject(user C)\nfind_package(gnomon %s REQUIRED)\nadd_executable(triangle "%s")\nset_target_properties(triangle PROPERTIES C_STANDARD 99)\ntarget_link_libraries(triangle gnomon::gnomon)\n' \
        "${version%.*}" "$work/triangle.c" >"$work/user/CMakeLists.txt"
    result "Debian packages, CMake configures" cmake -S "$work/user" -B "$work/user/build" -DCMAKE_PREFIX_PATH="$root/usr"
    result "Debian packages, CMake builds" cmake --build "$work/user/build"
    result "Debian packages, CMake, same picture" same_picture "$work/user/build/triangle"
fi
result "Debian packages, removes them" in_root -r gnomon libgnomon-dev "$library"
result "Debian packages, nothing is left" [ -z "$(find "$root" -path '*/usr/*' ! -type d)" ]
echo "Debian packages: $passed passed, $failed failed"
[ "$failed" = 0 ]
