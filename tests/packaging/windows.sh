#!/bin/sh
# Builds the library as a DLL with MinGW, by CMake and by Meson's defaults, and the README's program
# with it, which must draw under Wine the picture that the Makefile's library draws.
# usage: windows.sh BUILD-DIRECTORY   (after cmake.sh, from the root of the project)
set -eu
. tests/skip.sh
compiler=x86_64-w64-mingw32-gcc
failed=0
for tool in $compiler wine cmake meson; do
    command -v $tool >/dev/null && continue
    skip "DLL: needs $tool: 'make setup setup-cross' installs it"
    echo "0 passed, $failed failed"
    exit "$failed"
done
build=$(cd "$1" && pwd)
directory=$build/embed/windows
rm -rf "$directory"
mkdir -p "$directory"
printf 'set(CMAKE_SYSTEM_NAME Windows)\nset(CMAKE_C_COMPILER %s)\n' $compiler >"$directory/toolchain.cmake"
printf "[binaries]\nc = '%s'\nar = '%s-ar'\nstrip = '%s-strip'\n[host_machine]\nsystem = 'windows'\ncpu_family = 'x86_64'\ncpu = 'x86_64'\nendian = 'little'\n" \
    $compiler "${compiler%-gcc}" "${compiler%-gcc}" >"$directory/cross.ini"

cmake -S . -B "$directory/cmake" -DCMAKE_TOOLCHAIN_FILE="$directory/toolchain.cmake" -DBUILD_SHARED_LIBS=ON >/dev/null
cmake --build "$directory/cmake" -j 2 >/dev/null
meson setup "$directory/meson" . --cross-file "$directory/cross.ini" -Dc_args=-DGN_ONLY_PORTABLE >/dev/null
ninja -C "$directory/meson" -j 2 >/dev/null
# tests/portability/windows.sh removes every \r that Windows adds, and those of the picture; so they are
# removed from the expected picture too.
tr -d '\r' <"$directory/../cmake/triangle.ppm" >"$directory/triangle.ppm"
passed=0
for by in cmake meson; do
    $compiler -std=c99 -Iinclude "$directory/../cmake/triangle.c" "$directory/$by/libgnomon.dll.a" -o "$directory/$by/triangle.exe"
    if WINEPREFIX=$build/wine tests/portability/windows.sh "$directory/$by/triangle.exe" 2>/dev/null |
        cmp - "$directory/triangle.ppm"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
    fi
done
echo "DLL by CMake and Meson: $passed passed, $failed failed"
[ "$failed" = 0 ]
