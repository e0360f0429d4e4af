#!/bin/sh
# Builds the Debian packages, lets lintian look at them, and installs them with dpkg in an empty root.
# The README's program is compiled and linked with what stands there, through pkg-config and through
# CMake, and must draw the picture that the Makefile's library draws. A program of OSMesa's draws with the
# libOSMesa that stands there. Removed again, the packages leave no file.
# To save time, they are optimised less, and built without their own test, contract/scenes.
# usage: deb.sh BUILD-DIRECTORY   (from the root of the project, with the library in it)
set -eu
. tests/packaging/packaging.sh
begin "Debian packages" "$1/embed/deb"
need setup-verify dpkg-buildpackage dh lintian fakeroot pkg-config
readme_program "$1"
root=$work/root
triplet=$(dpkg-architecture -qDEB_HOST_MULTIARCH)
result "Debian packages, built" env DEB_CFLAGS_APPEND=-O1 DEB_BUILD_OPTIONS="parallel=2 noautodbgsym nocheck" make -s deb BUILD="$work"
[ "$failed" = 0 ] || finish
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
for package in "$library" libgnomon-dev gnomon libosmesa8-gnomon; do
    result "Debian packages, installs $package" in_root -i "$work/deb/${package}_${version}"_*.deb
done
result "Debian packages, the library is named after the SONAME" [ -e "$root/usr/lib/$triplet/$soname" ]
result "Debian packages, man page" [ -s "$root/usr/share/man/man1/gnomon.1.gz" ]
result "Debian packages, the command" sh -c "'$root/usr/bin/gnomon' --version | grep -F '$version'"
result "Debian packages, a program of OSMesa's, compiles" "${CC:-cc}" -Itools/osmesa tests/packaging/osmesa_program.c -o "$work/of-osmesa" \
    "$root/usr/lib/$triplet/libOSMesa.so.8"
result "Debian packages, a program of OSMesa's, draws" env LD_LIBRARY_PATH="$root/usr/lib/$triplet" "$work/of-osmesa"
flags=$(PKG_CONFIG_LIBDIR="$root/usr/lib/$triplet/pkgconfig" PKG_CONFIG_SYSROOT_DIR="$root" PKG_CONFIG_ALLOW_SYSTEM_CFLAGS=1 \
    PKG_CONFIG_ALLOW_SYSTEM_LIBS=1 pkg-config --cflags --libs gnomon)
# shellcheck disable=SC2086
result "Debian packages, pkg-config, compiles" ${CC:-cc} -std=c99 "$work/triangle.c" $flags -o "$work/by-pkg-config"
export LD_LIBRARY_PATH="$root/usr/lib/$triplet"
result "Debian packages, pkg-config, same picture" same_picture "$work/by-pkg-config"
! command -v cmake >/dev/null || cmake_program installed user "find_package(gnomon ${version%.*} REQUIRED)" gnomon -DCMAKE_PREFIX_PATH="$root/usr"
unset LD_LIBRARY_PATH
result "Debian packages, removes them" in_root -r gnomon libgnomon-dev libosmesa8-gnomon "$library"
result "Debian packages, nothing is left" [ -z "$(find "$root" -path '*/usr/*' ! -type d)" ]
finish
