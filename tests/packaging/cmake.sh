#!/bin/sh
# Builds the README's program in CMake projects whose flags ask for fast mathematics: one has the
# library in its tree, one finds the installed library, one fetches the archive. All must draw the picture
# that the Makefile's library draws. To save time, nothing is optimised, only plain C is compiled in
# the tree, and the small library is installed; packaging/flags compares the flags of all files with those
# of the Makefile.
# usage: cmake.sh BUILD-DIRECTORY   (from the root of the project)
set -eu
. tests/packaging/packaging.sh
begin CMake "$1/embed/cmake"
need setup cmake
readme_program "$1"
root=$(pwd)
user="-DCMAKE_C_FLAGS=-O0 -ffast-math -w -DGN_ONLY_PORTABLE"

cmake_program "in the tree" subdirectory "add_subdirectory(\"$root\" gnomon)" gnomon "$user"
result "installs" sh -c 'cmake -S "$1" -B "$2/library" -DCMAKE_BUILD_TYPE=Debug -DGN_SMALL=ON -DBUILD_SHARED_LIBS=ON \
    -DCMAKE_INSTALL_PREFIX="$2/installed" && cmake --build "$2/library" -j 2 --target install' - "$root" "$work"
cmake_program installed package "find_package(gnomon 0.1 REQUIRED)" gnomon "$user" -DCMAKE_PREFIX_PATH="$work/installed"
archive=$(make -s dist BUILD="$work")
cmake_program fetched fetched "include(FetchContent)
FetchContent_Declare(gnomon URL \"$archive\")
FetchContent_MakeAvailable(gnomon)" gnomon "$user"
make -s install-library BUILD="$1" PREFIX="$work/installed" DESTDIR="$work/by-make"
same_installation "$work/installed" "$work/by-make$work/installed"

# options WHAT EXPECTED SOURCE FILE PATTERN FLAG...
options() {
    of="$1" expected=$2 source=$3 file=$4 pattern=$5
    shift 5
    cmake -S "$source" -B "$work/levels/$(basename "$source")" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "$@" >/dev/null
    compiled_with "$of" "$expected" "$work/levels/$(basename "$source")" "/$file\"" "$pattern"
}

# If no one asks for a level of optimisation, the library is optimised, and the user's files are
# compiled as the user says. The last level counts: the Makefile's.
none=-DCMAKE_BUILD_TYPE=
tree=$work/subdirectory
level='-O[^ ]*'
options "no build type" "-O3 -O2" "$root" square_root.c "$level" $none -DCMAKE_C_FLAGS= -DGN_SMALL=OFF
options "no build type, small" -Os "$root" square_root.c "$level" $none -DCMAKE_C_FLAGS= -DGN_SMALL=ON
options "no build type, flags with a level" -O1 "$root" square_root.c "$level" $none -DCMAKE_C_FLAGS="-g -O1" -DGN_SMALL=OFF
options "debugging" "" "$root" square_root.c "$level" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_FLAGS=
options "release for size" -Os "$root" square_root.c "$level" -DCMAKE_BUILD_TYPE=MinSizeRel -DCMAKE_C_FLAGS=
options "subdirectory, no build type" "-O3 -O2" "$tree" square_root.c "$level" $none -DCMAKE_C_FLAGS=
options "subdirectory, no build type" "" "$tree" triangle.c "$level" $none -DCMAKE_C_FLAGS=
options "subdirectory, debugging" "" "$tree" square_root.c "$level" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_FLAGS=

# Library and program agree about features; code is position-independent except on bare metal.
choice='-DGN_[SB][A-Z]*'
options "small and basic, the library" "-DGN_BASIC -DGN_SMALL" "$tree" square_root.c "$choice" -DGN_SMALL=ON -DGN_BASIC=ON
options "small and basic, the program" "-DGN_BASIC -DGN_SMALL" "$tree" triangle.c "$choice" -DGN_SMALL=ON -DGN_BASIC=ON
options "neither, the program" "" "$tree" triangle.c "$choice" -DGN_SMALL=OFF -DGN_BASIC=OFF
options "position-independent code" -fPIC "$root" square_root.c -fPIC -DBUILD_SHARED_LIBS=OFF
rm -rf "$work/levels"
options "bare metal" "" "$root" square_root.c -fPIC -DCMAKE_SYSTEM_NAME=Generic
finish
