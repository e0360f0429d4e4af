#!/bin/sh
# Builds the README's program in a Meson project whose flags ask for fast mathematics, with the
# source archive as its subproject `gnomon`, through a wrap file. It must draw the picture that the
# Makefile's library draws. Installs the library with Meson and compares names and texts with those
# that `make install-library` installs. To save time, the everyday gate compiles plain C alone;
# --all compiles every back end, shared and static.
# usage: meson.sh BUILD-DIRECTORY [--all]   (from the root of the project, with the library in it)
set -eu
. tests/skip.sh
export MAKEFLAGS=
passed=0
failed=0
for tool in meson ninja; do
    command -v $tool >/dev/null && continue
    skip "Meson: needs $tool: 'make setup' installs it"
    echo "0 passed, $failed failed"
    exit "$failed"
done
fewer=-DGN_ONLY_PORTABLE
kinds=shared
if [ "${2:-}" = --all ]; then
    fewer=
    kinds="shared static"
fi
directory=$(cd "$1" && pwd)/embed/meson
rm -rf "$directory"
mkdir -p "$directory/user/subprojects/packagefiles"
awk -v first=1 -f tests/packaging/blocks.awk README.md >"$directory/user/triangle.c"
"${CC:-cc}" -std=c99 -Iinclude "$directory/user/triangle.c" "$1/libgnomon.a" -o "$directory/triangle"
"$directory/triangle" >"$directory/triangle.ppm" 2>/dev/null

archive=$(make -s dist BUILD="$directory")
cp "$archive" "$directory/user/subprojects/packagefiles/"
cat >"$directory/user/subprojects/gnomon.wrap" <<END
[wrap-file]
directory = $(basename "$archive" .tar.gz)
source_filename = $(basename "$archive")
source_hash = $(sha256sum "$archive" | cut -d ' ' -f 1)

[provide]
dependency_names = gnomon
END
cat >"$directory/user/meson.build" <<'END'
project('user', 'c', default_options: ['c_std=c99'])
executable('triangle', 'triangle.c', dependencies: dependency('gnomon', version: '>=0.1'))
END

quietly() { # quietly COMMAND...: prints its output only if it fails
    "$@" >"$directory/log" 2>&1 || { cat "$directory/log"; echo "FAILED: Meson: $*"; exit 1; }
}

for kind in $kinds; do
    quietly meson setup "$directory/$kind" "$directory/user" --wrap-mode=forcefallback -Ddefault_library=$kind \
        -Doptimization=1 -Ddebug=false -Dc_args="-ffast-math $fewer"
    quietly ninja -C "$directory/$kind" -j 2
    "$directory/$kind/triangle" 2>/dev/null | cmp - "$directory/triangle.ppm"
    echo "Meson, subproject, $kind: same picture"
    passed=$((passed + 1))
done

# options NAME FILE EXPECTED OPTION...: the level and the choices that a file is compiled with.
options() {
    name=$1
    file=$2
    expected=$3
    shift 3
    rm -rf "$directory/options"
    quietly meson setup "$directory/options" "$directory/user" --wrap-mode=forcefallback "$@"
    found=$(grep '"command":' "$directory/options/compile_commands.json" | grep "$file" | head -n 1 |
        grep -o -e ' -O[^ ]*' -e ' -DGN_[SB][A-Z]*' | tr -d ' ' | LC_ALL=C sort | paste -s -d ' ')
    if [ "$found" = "$expected" ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: Meson, $name: $file is compiled with '$found', not '$expected'"
    fi
}
options "by default, the library" src_math_mat4.c -O3
options "by default, the program" triangle.c "-O0"
options "not optimised" src_math_mat4.c -O0 -Dgnomon:optimised=false
options "small and basic, the library" src_math_mat4.c "-DGN_BASIC -DGN_SMALL -Os" -Dgnomon:small=true -Dgnomon:basic=true
options "small and basic, the program" triangle.c "-DGN_BASIC -DGN_SMALL -O0" -Dgnomon:small=true -Dgnomon:basic=true

# The library alone, as Meson installs it.
quietly meson setup "$directory/library" "$directory/user/subprojects/$(basename "$archive" .tar.gz)" \
    --prefix=/opt/gnomon --libdir=lib -Ddefault_library=both -Doptimization=0 -Ddebug=false -Dc_args="-DGN_ONLY_PORTABLE"
quietly env DESTDIR="$directory/by-meson" meson install -C "$directory/library"
quietly make -s install-library BUILD="$1" DESTDIR="$directory/by-make" PREFIX=/opt/gnomon
for tree in by-make by-meson; do
    (cd "$directory/$tree" && find . ! -type d | LC_ALL=C sort) >"$directory/$tree.txt"
done
if diff "$directory/by-make.txt" "$directory/by-meson.txt"; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
texts=0
for file in $(grep -v 'lib/libgnomon' "$directory/by-make.txt"); do
    if cmp "$directory/by-make/$file" "$directory/by-meson/$file"; then texts=$((texts + 1)); else failed=$((failed + 1)); fi
done
echo "Meson: make installs the same $(wc -l <"$directory/by-make.txt") files, $texts equal texts"
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
