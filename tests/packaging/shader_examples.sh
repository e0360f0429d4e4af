#!/bin/sh
# Checks the examples in the preface of gnomon/shader_functions.h: they have at most 10, 20 and 40
# lines, compile as they stand in C99 and in C++, with warnings as errors, and draw what the
# ready-made shaders draw. Compilers must vectorise them.
# usage: shader_examples.sh BUILD-DIRECTORY   (from the root of the project)
set -eu
. tests/script.sh
begin "examples of shaders" "$1/shader-examples"
directory=$work
header=include/gnomon/shader_functions.h
printf '#include <gnomon.h>\n' >"$directory/main.c"
for example in 1:10 2:20 3:40; do
    number=${example%:*}
    awk -v example="$number" '
        /^ \* Example / { inside = $3 + 0 == example }
        /^ \* End of the examples/ { inside = 0 }
        inside && /^ \*     / { print substr($0, 8) }' $header >"$directory/example.h"
    lines=$(grep -c . "$directory/example.h") || lines=0
    result "example $number: $lines lines, not 1 to ${example#*:}" [ "$lines" -gt 0 -a "$lines" -le "${example#*:}" ]
    cat "$directory/example.h" >>"$directory/main.c"
done
printf '#include "shader_examples_main.h"\n' >>"$directory/main.c"

# Users' functions need not use all their parameters.
warnings="-pedantic -Wall -Wextra -Werror -Wno-unused-parameter -Wno-long-long"
library=$1/libgnomon.a
draw() { # draw COMPILER...
    # shellcheck disable=SC2086
    "$@" $warnings -ffp-contract=off -Iinclude -Itests/packaging -c "$directory/main.c" -o "$directory/examples.o" &&
        ${CC:-cc} "$directory/examples.o" "$library" -o "$directory/examples" && "$directory/examples"
}

result "C99" draw ${CC:-cc} -std=c99 -O2
for compiler in gcc clang; do
    command -v $compiler >/dev/null || { skip "$compiler: compiles no examples, since it is absent: 'make setup' installs it"; continue; }
    result "$compiler, C99, -O0" draw $compiler -std=c99 -O0
    result "$compiler, C99, -O3" draw $compiler -std=c99 -O3
    result "$compiler, C++98" draw $compiler -x c++ -std=c++98 -O2
    result "$compiler, C++17" draw $compiler -x c++ -std=c++17 -O2
done
cat "$work/said"

# Counts outside their limits must not compile, neighbours within them must.
misuse() { # misuse WORD DEFINITION
    printf '%s\n' '#include <gnomon.h>' 'typedef struct { gn_vec4 color; } in_out;' \
        'static gn_vec4 v(const void *u, gn_vertex *p, in_out *o) { (void)u; (void)p; o->color = gn_make4(0, 0, 0, 0); return o->color; }' \
        'static gn_vec4 f(const void *u, const in_out *i, gn_fragment *p) { (void)u; (void)p; return i->color; }' \
        'static void l(const void *u, const in_out *i, gn_texel_lookup *t) { (void)u; (void)i; (void)t; }' \
        "$2" >"$directory/misuse.c"
    if ${CC:-cc} -std=c99 -w -Iinclude -fsyntax-only "$directory/misuse.c" 2>/dev/null; then compiles=yes; else compiles=no; fi
    result "$2: compiles: $compiles" [ "$compiles" = "$1" ]
}
misuse yes 'GN_VERTEX_SHADER(s, void, in_out, 8, v);'
misuse no 'GN_VERTEX_SHADER(s, void, in_out, 9, v);'
misuse yes 'GN_FRAGMENT_SHADER(s, void, in_out, 8, f);'
misuse no 'GN_FRAGMENT_SHADER(s, void, in_out, 9, f);'
misuse no 'GN_FRAGMENT_SHADER(s, void, in_out, 0, f);'
misuse yes 'GN_TEXTURED_FRAGMENT_SHADER(s, void, in_out, 1, 8, l, f);'
misuse no 'GN_TEXTURED_FRAGMENT_SHADER(s, void, in_out, 1, 9, l, f);'
misuse no 'GN_TEXTURED_FRAGMENT_SHADER(s, void, in_out, 1, 0, l, f);'

# Checks that the loops over lanes become vector instructions without further flags. gcc must leave
# no scalar multiplication; clang keeps a scalar loop for arrays that overlap.
vectorised() { # vectorised COMPILER LEVEL
    "$1" -std=c99 "$2" -Iinclude -Itests/packaging -c "$directory/main.c" -o "$directory/examples.o"
    for shader in use_colors_vertices use_map_vertices use_phong_vertices use_phong_fragments; do
        objdump -d --disassemble=$shader "$directory/examples.o" >"$directory/listing"
        packed=$(grep -c 'm[uo][lv][au]*ps' "$directory/listing") || :
        scalar=$(grep -c 'mulss' "$directory/listing") || :
        [ "$1" = gcc ] || scalar=0
        result "$1 $2, $shader: $packed packed and $scalar scalar instructions" [ "$packed" -gt 0 -a "$scalar" -eq 0 ]
    done
}
case $(${CC:-cc} -dumpmachine) in
x86_64*)
    for compiler in gcc clang; do
        command -v $compiler >/dev/null || continue
        vectorised $compiler -O2
        vectorised $compiler -O3
    done
    ;;
esac
finish
