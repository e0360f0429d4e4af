#!/bin/sh
# Builds the library as a DLL with MinGW, by CMake and by Meson, and the README's program
# with it, which must draw under Wine the picture that the Makefile's library draws. Plain C alone,
# unoptimised, to save time; tests/portability/builds has every back end.
# usage: windows.sh BUILD-DIRECTORY   (from the root of the project)
set -eu
. tests/packaging/packaging.sh
compiler=x86_64-w64-mingw32-gcc
begin "DLL by CMake and Meson" "$1/embed/windows"
need setup cmake meson
need setup-cross $compiler wine
readme_program "$1"
printf 'set(CMAKE_SYSTEM_NAME Windows)\nset(CMAKE_C_COMPILER %s)\n' $compiler >"$work/toolchain.cmake"
printf "[binaries]\nc = '%s'\nar = '%s-ar'\nstrip = '%s-strip'\n[host_machine]\nsystem = 'windows'\ncpu_family = 'x86_64'\ncpu = 'x86_64'\nendian = 'little'\n" \
    $compiler "${compiler%-gcc}" "${compiler%-gcc}" >"$work/cross.ini"
cmake -S . -B "$work/cmake" -DCMAKE_TOOLCHAIN_FILE="$work/toolchain.cmake" -DBUILD_SHARED_LIBS=ON \
    -DCMAKE_C_FLAGS="-O0 -DGN_ONLY_PORTABLE" >/dev/null
cmake --build "$work/cmake" -j 2 >/dev/null
meson setup "$work/meson" . --cross-file "$work/cross.ini" -Doptimised=false -Dc_args=-DGN_ONLY_PORTABLE >/dev/null
ninja -C "$work/meson" -j 2 >/dev/null
# tests/portability/windows.sh removes every \r that Windows adds, and those of the picture; so they are
# removed from the expected picture too.
tr -d '\r' <"$work/triangle.ppm" >"$work/triangle.text"
mv "$work/triangle.text" "$work/triangle.ppm"
WINEPREFIX=$(cd "$1" && pwd)/wine
export WINEPREFIX
for by in cmake meson; do
    $compiler -std=c99 -Iinclude "$work/triangle.c" "$work/$by/libgnomon.dll.a" -o "$work/$by/triangle.exe"
    result "DLL by $by" same_picture tests/portability/windows.sh "$work/$by/triangle.exe"
done
finish
