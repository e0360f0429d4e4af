# Sourced by the scripts of this folder: the README's program, which others build in their ways, and
# what they compare. The functions put files into $work.
. tests/script.sh

version=$(sed -n 's/^.define GN_VERSION_[A-Z]* \([0-9]*\)$/\1/p' include/gnomon/version.h | paste -s -d .)

# readme_program BUILD: triangle.c, and triangle.ppm, the picture that it draws with libgnomon.a.
readme_program() {
    awk -v first=1 -f tests/packaging/blocks.awk README.md >"$work/triangle.c"
    ${CC:-cc} -std=c99 -Iinclude "$work/triangle.c" "$1/libgnomon.a" -o "$work/triangle"
    "$work/triangle" >"$work/triangle.ppm" 2>/dev/null
}

# same_picture COMMAND...: whether a program draws that picture.
same_picture() {
    "$@" 2>/dev/null | cmp - "$work/triangle.ppm"
}

# cmake_program WHAT FOLDER FOUND TARGET FLAG...: builds the program in a project of CMake, where FOUND finds
# the library, as FOLDER/build/triangle, which must draw the picture.
cmake_program() {
    found_by=$1 folder=$work/$2
    mkdir -p "$folder"
    printf '%s\n' 'cmake_minimum_required(VERSION 3.16)' 'project(user C)' "$3" "add_executable(triangle \"$work/triangle.c\")" \
        'set_target_properties(triangle PROPERTIES C_STANDARD 99)' "target_link_libraries(triangle gnomon::$4)" >"$folder/CMakeLists.txt"
    shift 4
    result "$script, CMake configures, $found_by" cmake -Wno-dev -S "$folder" -B "$folder/build" "$@"
    result "$script, CMake builds, $found_by" cmake --build "$folder/build" -j 2
    result "$script, CMake, $found_by: same picture" same_picture "$folder/build/triangle"
}

# same_installation FOLDER FOLDER: the library installed in two ways has the same files and texts.
same_installation() {
    for tree in "$1" "$2"; do
        (cd "$tree" && find . ! -type d ! -name libgnomon.a | LC_ALL=C sort) >"$tree.txt"
    done
    result "$script: the files that make installs" diff "$1.txt" "$2.txt"
    for file in $(grep -v 'lib/libgnomon' "$1.txt"); do
        result "$script: $file, as make installs it" cmp "$1/$file" "$2/$file"
    done
}

# compiled_with WHAT EXPECTED FOLDER FILE PATTERN: the options of a pattern with which a folder's
# compile_commands.json compiles a file.
compiled_with() {
    found=$(grep '"command":' "$3/compile_commands.json" | grep "$4" | head -n 1 | grep -o -e " $5" | tr -d ' ' | paste -s -d ' ')
    result "$script, $1: $4 is compiled with '$found', not '$2'" [ "$found" = "$2" ]
}

# hashes_objects BUILD: the objects of `hashes` that are not the library's.
hashes_objects() {
    tr ' ' '\n' <"$1/hashes.command" | grep '\.o$' | grep -v "^$1/src/"
}
