#!/bin/sh
# Builds the README's program in two CMake projects whose flags ask for fast mathematics: one has
# the library in its tree, the other finds the installed library. Both must draw the picture that
# the Makefile's library draws. To save time, the everyday gate compiles only plain C in the tree
# and installs the small library; --all compiles every back end in both.
# usage: cmake.sh BUILD-DIRECTORY [--all]   (from the root of the project, with the library in it)
set -eu
fewer=-DGN_ONLY_PORTABLE
small=ON
if [ "${2:-}" = --all ]; then
    fewer=
    small=OFF
fi
root=$(pwd)
directory=$(cd "$1" && pwd)/embed/cmake
program=$directory/triangle.c
picture=$directory/triangle.ppm
rm -rf "$directory"
mkdir -p "$directory"
awk -v first=1 -f tests/packaging/blocks.awk README.md >"$program"
"${CC:-cc}" -std=c99 -Iinclude "$program" "$1/libgnomon.a" -o "$directory/triangle"
"$directory/triangle" 2>/dev/null >"$picture"

try() { # try NAME HOW-THE-LIBRARY-IS-FOUND FLAGS...
    name=$1
    found=$2
    shift 2
    mkdir -p "$directory/$name"
    printf 'cmake_minimum_required(VERSION 3.16)\nproject(user C)\n%s\nadd_executable(triangle "%s")\nset_target_properties(triangle PROPERTIES C_STANDARD 99)\ntarget_link_libraries(triangle gnomon::gnomon)\n' \
        "$found" "$program" >"$directory/$name/CMakeLists.txt"
    cmake -Wno-dev -S "$directory/$name" -B "$directory/$name/build" -DCMAKE_C_FLAGS="-O1 -ffast-math -w $fewer" "$@" >/dev/null
    cmake --build "$directory/$name/build" -j 2 >/dev/null
    "$directory/$name/build/triangle" 2>/dev/null | cmp - "$picture"
    echo "CMake, $name: same picture"
}

try subdirectory "add_subdirectory(\"$root\" gnomon)"
cmake -S "$root" -B "$directory/library" -DCMAKE_BUILD_TYPE=Debug -DGN_SMALL=$small -DBUILD_SHARED_LIBS=ON \
    -DCMAKE_INSTALL_PREFIX="$directory/installed" >/dev/null
cmake --build "$directory/library" -j 2 --target install >/dev/null
try package "find_package(gnomon 0.1 REQUIRED)" -DCMAKE_PREFIX_PATH="$directory/installed"
archive=$(MAKEFLAGS='' make -s dist BUILD="$directory")
try fetched "include(FetchContent)
FetchContent_Declare(gnomon URL \"$archive\")
FetchContent_MakeAvailable(gnomon)"
passed=3
failed=0

# Make installs the library of the same version under the same names, and equal texts.
MAKEFLAGS='' make -s install-library BUILD="$1" PREFIX="$directory/installed" DESTDIR="$directory/by-make"
files() {
    (cd "$1" && find . ! -type d ! -name libgnomon.a | LC_ALL=C sort)
}
texts=0
files "$directory/installed" >"$directory/by-cmake.txt"
if files "$directory/by-make$directory/installed" | diff "$directory/by-cmake.txt" -; then
    passed=$((passed + 1))
else
    failed=$((failed + 1))
fi
for file in $(grep -v 'libgnomon' "$directory/by-cmake.txt"); do
    if cmp "$directory/installed/$file" "$directory/by-make$directory/installed/$file"; then
        texts=$((texts + 1))
    else
        failed=$((failed + 1))
    fi
done
echo "CMake: make installs the same $(wc -l <"$directory/by-cmake.txt") files, $texts equal texts"

# options NAME PATTERN FILE EXPECTED SOURCE FLAGS...: checks the options of a pattern that a file is
# compiled with.
options() {
    name=$1
    pattern=$2
    file=$3
    expected=$4
    source=$5
    shift 5
    cmake -S "$source" -B "$directory/levels/$(basename "$source")" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "$@" >/dev/null
    found=$(grep '"command":' "$directory/levels/$(basename "$source")/compile_commands.json" | grep "/$file\"" |
        grep -o -e " $pattern" | tr -d ' ' | paste -s -d ' ')
    if [ "$found" = "$expected" ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "CMake, $name: $file is compiled with '$found', not '$expected'"
    fi
}

# If no one asks for a level of optimisation, the library is optimised, and the user's files are
# compiled as the user says.
levels() { # levels NAME FILE EXPECTED SOURCE FLAGS...
    label=$1
    shift
    options "$label" '-O[^ ]*' "$@"
}

none=-DCMAKE_BUILD_TYPE=
# The last level counts: the Makefile's.
levels "no build type" sqrt.c "-O3 -O2" "$root" $none -DCMAKE_C_FLAGS= -DGN_SMALL=OFF
levels "no build type, small" sqrt.c -Os "$root" $none -DCMAKE_C_FLAGS= -DGN_SMALL=ON
levels "no build type, flags with a level" sqrt.c -O1 "$root" $none -DCMAKE_C_FLAGS="-g -O1" -DGN_SMALL=OFF
levels "debugging" sqrt.c "" "$root" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_FLAGS=
levels "release for size" sqrt.c -Os "$root" -DCMAKE_BUILD_TYPE=MinSizeRel -DCMAKE_C_FLAGS=
levels "subdirectory, no build type" sqrt.c "-O3 -O2" "$directory/subdirectory" $none -DCMAKE_C_FLAGS=
levels "subdirectory, no build type" triangle.c "" "$directory/subdirectory" $none -DCMAKE_C_FLAGS=
levels "subdirectory, debugging" sqrt.c "" "$directory/subdirectory" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_FLAGS=

# Library and program agree about features; code is position-independent except on bare metal.
choice='-DGN_[SB][A-Z]*'
options "small and basic, the library" "$choice" sqrt.c "-DGN_BASIC -DGN_SMALL" "$directory/subdirectory" -DGN_SMALL=ON -DGN_BASIC=ON
options "small and basic, the program" "$choice" triangle.c "-DGN_BASIC -DGN_SMALL" "$directory/subdirectory" -DGN_SMALL=ON -DGN_BASIC=ON
options "neither, the program" "$choice" triangle.c "" "$directory/subdirectory" -DGN_SMALL=OFF -DGN_BASIC=OFF
options "position-independent code" -fPIC sqrt.c -fPIC "$root" -DBUILD_SHARED_LIBS=OFF
rm -rf "$directory/levels"
options "bare metal" -fPIC sqrt.c "" "$root" -DCMAKE_SYSTEM_NAME=Generic
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
