#!/bin/sh
# Compiles the code of README.md and of the guide (tools/guide/*.md), and runs its programs. Rules for
# authors:
#
#   ```c           with `int main(` in it is a whole program. It is compiled as C99 against include/
#                  alone, linked with libgnomon.a, and with tools/threads/pool.c if it includes
#                  "pool.h", and must return 0.
#   ```c           without it is a piece of a file: declarations and functions. It must compile behind
#                  the page's earlier pieces. Statements stand in a function that the piece shows.
#   ```c no-test   is code for another library (OSMesa, PortableGL, TinyGL, cglm), which is not
#                  compiled. These blocks are counted, and each must use that library.
#   ```python      must run, behind the page's earlier ones (--python, which tests/packaging/python.sh runs)
#   ```sh          and indented lines: targets of `make`, subcommands of `gnomon` and their long
#                  options must exist
#
# usage: guide.sh BUILD-DIRECTORY [PAGE...]           (from the root of the project)
#        guide.sh --python PYTHON [PAGE...]           only the blocks of Python
set -u
. tests/script.sh
begin guide

python=
build=$1
if [ "$1" = --python ]; then
    python=$2
    case $python in */*) python=$(cd "$(dirname "$python")" && pwd)/${python##*/} ;; esac
    shift
fi
shift
[ $# -gt 0 ] || set -- README.md tools/guide/*.md tools/python/README.md

if [ -n "$python" ]; then
    for page; do
        awk -v language=python -f tests/packaging/blocks.awk "$page" >"$work/page.py"
        [ ! -s "$work/page.py" ] || result "$page: its Python runs" sh -c 'cd "$1" && "$2" page.py' - "$work" "$python"
    done
    finish
fi

library=$(realpath "$build/libgnomon.a")
# A piece may show functions that nothing calls.
warnings="-std=c99 -pedantic -Wall -Wextra -Werror"
compile_program() { # compile_program BLOCK
    threads=
    if grep -q '^#include .*pool\.h' "$1"; then
        threads="-Itools/threads -pthread $work/pool.o"
        [ -e "$work/pool.o" ] || ${CC:-cc} -std=c11 -D_POSIX_C_SOURCE=200809L -Iinclude -c tools/threads/pool.c -o "$work/pool.o" || return 1
    fi
    # shellcheck disable=SC2086
    ${CC:-cc} $warnings -Iinclude -x c "$work/block.c" -x none $threads "$library" -o "$work/program"
}

programs=0
pieces=0
foreign=0
for page; do
    rm -rf "$work/blocks" "$work/foreign"
    mkdir "$work/blocks" "$work/foreign"
    awk -v folder="$work/blocks/" -f tests/packaging/blocks.awk "$page"
    : >"$work/before.c"
    for block in "$work/blocks"/*; do
        [ -e "$block" ] || continue
        line=$(basename "$block" | sed 's/^0*//')
        {
            printf '#line %d "%s"\n' $((line + 1)) "$page"
            cat "$block"
        } >"$work/block.c"
        if grep -q 'int main(' "$block"; then
            programs=$((programs + 1))
            result "$page:$line: the program compiles" compile_program "$block"
            result "$page:$line: the program returns 0" sh -c 'cd "$1" && timeout 60 ./program >output' - "$work"
            rm -f "$work/program"
        else
            pieces=$((pieces + 1))
            cat "$work/block.c" >>"$work/before.c"
            # shellcheck disable=SC2086
            result "$page:$line: the piece compiles" ${CC:-cc} $warnings -Wno-unused -Iinclude -Itools/threads -fsyntax-only "$work/before.c"
        fi
    done
    awk -v info=no-test -v folder="$work/foreign/" -f tests/packaging/blocks.awk "$page"
    for block in "$work/foreign"/*; do
        [ -e "$block" ] || continue
        foreign=$((foreign + 1))
        line=$(basename "$block" | sed 's/^0*//')
        result "$page:$line: 'no-test' is for another library's code" grep -qE '\b(OSMesa|gl[A-Z]|pgl|glm_|ZB_|glc_|GL_|vec[234]\b|mat[34]\b)' "$block"
    done
done

# Commands: in blocks of sh, and in indented lines.
cat Makefile tools/firmware/Makefile tests/*.mk tests/fuzz/*.mk tools/*/*.mk | sed -n 's/^\([a-z][a-z-]*\)\( [a-z -]*\)*:.*/\1/p' | sort -u >"$work/targets"
for page; do
    {
        awk -v language=sh -f tests/packaging/blocks.awk "$page"
        awk '/^```/ { fence = !fence } !fence && /^    /' "$page"
    } | sed -n -e 's/ #.*//' -e 's/^ *//' -e 's|^build/gnomon |gnomon |' -e 's/^\(mpirun\|srun\|parallel\|seq\) .* gnomon /gnomon /' -e '/^\(make\|gnomon\) /p' |
        sort -u | while read -r line; do echo "$page: $line"; done
done >"$work/commands"

target_exists() { grep -qxF "$1" "$work/targets"; }
while IFS= read -r line; do
    page=${line%%: *}
    command=${line#*: }
    case $command in
    make\ *)
        for word in ${command#make }; do
            case $word in
            -* | *=* | */* | [0-9]* | *[A-Z]*) ;;
            *[!a-z-]*) break ;; # another command follows
            *) result "$page: $command: a target" target_exists "$word" ;;
            esac
        done
        ;;
    *)
        if [ ! -x "$build/gnomon" ]; then
            [ -e "$work/told" ] || skip "guide: commands of gnomon, since $build/gnomon is not built: 'make all' builds it"
            : >"$work/told"
            continue
        fi
        # shellcheck disable=SC2086
        set -- $command
        [ $# -ge 2 ] || continue
        case $2 in
        --*) set -- gnomon "" "$2" ;;
        *)
            [ -e "$work/help-$2" ] || { "$build/gnomon" "$2" --help; "$build/gnomon" "$2" --help-all; } >"$work/help-$2" 2>/dev/null
            result "$page: $command: a subcommand" grep -q "^gnomon $2\b" "$work/help-$2"
            ;;
        esac
        for word; do
            case $word in
            --help | --help-all | --version) ;;
            --*) result "$page: $command: $word" grep -qE -e "(^|[^a-z-])${word%%=*}([^a-z-]|\$)" "$work/help-$2" ;;
            esac
        done
        ;;
    esac
done <"$work/commands"

echo "guide: $programs programs, $pieces pieces, $foreign blocks for other libraries, $(grep -c '' "$work/commands") commands"
finish
