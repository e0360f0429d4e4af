#!/bin/sh
# Builds the README's program in a Meson project whose flags ask for fast mathematics, with the
# source archive as its subproject `gnomon`, through a wrap file. It must draw the picture that the
# Makefile's library draws. Installs the library with Meson and compares names and texts with those
# that `make install-library` installs. Plain C alone, unoptimised, to save
# time; packaging/flags compares the flags of all files with the Makefile's.
# usage: meson.sh BUILD-DIRECTORY   (from the root of the project, with the library in it)
set -eu
. tests/packaging/packaging.sh
begin Meson "$1/embed/meson"
need setup meson ninja
readme_program "$1"
archive=$(make -s dist BUILD="$work")
name=$(basename "$archive" .tar.gz)
user=$work/user
mkdir -p "$user/subprojects/packagefiles"
cp "$archive" "$user/subprojects/packagefiles/"
cp "$work/triangle.c" "$user"
printf '%s\n' '[wrap-file]' "directory = $name" "source_filename = $name.tar.gz" \
    "source_hash = $(sha256sum "$archive" | cut -d ' ' -f 1)" '[provide]' 'dependency_names = gnomon' >"$user/subprojects/gnomon.wrap"
printf '%s\n' "project('user', 'c', default_options: ['c_std=c99'])" \
    "executable('triangle', 'triangle.c', dependencies: dependency('gnomon', version: '>=0.1'))" >"$user/meson.build"

result "Meson, configures" meson setup "$work/shared" "$user" --wrap-mode=forcefallback -Ddefault_library=shared \
    -Doptimization=0 -Ddebug=false -Dgnomon:optimised=false -Dc_args="-ffast-math -DGN_ONLY_PORTABLE"
result "Meson, builds" ninja -C "$work/shared" -j 2
result "Meson, subproject: same picture" same_picture "$work/shared/triangle"

# options WHAT EXPECTED FILE OPTION...: the level and the choices that a file is compiled with.
options() {
    of="$1" expected=$2 file=$3
    shift 3
    rm -rf "$work/options"
    result "Meson, configures, $of" meson setup "$work/options" "$user" --wrap-mode=forcefallback "$@"
    compiled_with "$of" "$expected" "$work/options" "$file" '-\(O\|DGN_[SB]\)[^ ]*'
}
options "by default, the library" -O3 src_math_matrix.c
options "by default, the program" -O0 triangle.c
options "not optimised" -O0 src_math_matrix.c -Dgnomon:optimised=false
options "small and basic, the library" "-Os -DGN_SMALL -DGN_BASIC" src_math_matrix.c -Dgnomon:small=true -Dgnomon:basic=true
options "small and basic, the program" "-O0 -DGN_SMALL -DGN_BASIC" triangle.c -Dgnomon:small=true -Dgnomon:basic=true

# The library alone, as Meson installs it.
result "Meson, configures the library" meson setup "$work/library" "$user/subprojects/$name" \
    --prefix=/opt/gnomon --libdir=lib -Ddefault_library=both -Doptimised=false -Ddebug=false -Dc_args="-DGN_ONLY_PORTABLE"
result "Meson, installs" env DESTDIR="$work/by-meson" meson install -C "$work/library"
make -s install-library BUILD="$1" DESTDIR="$work/by-make" PREFIX=/opt/gnomon
result "Meson, the static library" [ -e "$work/by-meson/opt/gnomon/lib/libgnomon.a" ]
same_installation "$work/by-make" "$work/by-meson"
finish
