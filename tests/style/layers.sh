#!/bin/sh
# The layers of the library. A file of src/ may include, and call at link time, files of its own
# folder and of folders to the left in the list below. Public headers are leftmost, except those that
# describe surfaces, textures and draws: they belong to `formats`, so that a change to one of them does
# not compile the mathematics again. In src/, reference/ and tools/ no files include each other in a
# circle, and none call each other in a circle. There are no exceptions.
#
# usage: tests/style/layers.sh BUILD        BUILD holds the objects of all files
set -eu

layers='include config scalars lanes math formats texture kernel/math kernel/texture kernel/shaders kernel/geometry kernel/raster
kernel/fragment kernel/draw kernel/surfaces shaders backends draw surfaces'
drawing='blit derivatives draw light lookup pipeline program shader_functions shader_loop shader_types shaders surface texture'
build=${1:?usage: tests/style/layers.sh BUILD}
cd "$(dirname "$0")/../.."

files=$(mktemp)
trap 'rm -f "$files"' EXIT
trap 'exit 1' INT TERM HUP

# The files whose calls are looked at: those that are compiled for this machine. tools/firmware is for a board alone, tools/web/less and
# tools/web-lessons are for WebAssembly alone, and ranks_mpi.c for compilers of MPI.
sources() {
    find src reference tools \( -path tools/python/build -o -path tools/firmware -o -path tools/web/less -o -path tools/web-lessons -o -name ranks_mpi.c \) -prune -o -name '*.c' -print
}

# Lines "USER USED NAME": a file of USER's path includes the file USED by NAME, or calls its NAME.
includes() {
    find include src reference tools -path tools/python/build -prune -o -name '*.[ch]' -print -o -name '*.inl' -print >"$files"
    awk '
        function resolved(file, name,    path) {
            path = file
            sub("[^/]*$", "", path)
            path = path name
            while (sub("[^/]+/\\.\\./", "", path)) {}
            if (path in known) return path
            if ("include/" name in known) return "include/" name
            return name in only ? only[name] : ""
        }
        NR == FNR {
            known[$0] = 1
            ARGV[ARGC++] = name = $0
            sub(".*/", "", name)
            if ($0 !~ "^(include|src)/") only[name] = $0
            next
        }
        /^[ \t]*#[ \t]*include[ \t]*["<][a-z.]/ {
            split($0, part, /["<>]/)
            used = resolved(FILENAME, part[2])
            if (used != "") print FILENAME, used, part[2]
            else if ($0 ~ /"/) print FILENAME, "nothing", part[2]
        }' "$files"
}

calls() {
    sources | sed "s|^|$build/|; s|c\$|o|" | xargs nm -A -P >"$files"
    sed "s|^$build/||; s|\.o: |.c |" "$files" | awk '
        $3 ~ /^[TDRBVWC]$/ { defined_by[$2] = $1 }
        $3 == "U" { user[++n] = $1; symbol[n] = $2 }
        END {
            for (i = 1; i <= n; ++i) {
                used = defined_by[symbol[i]]
                if (used != "" && used != user[i]) print user[i], used, symbol[i]
            }
        }'
}

against_order() {
    awk -v layers="$layers" -v drawing="$drawing" -v what="$1" '
        BEGIN {
            for (n = split(layers, name); n > 0; --n) rank[name[n]] = n
            for (n = split(drawing, name, " "); n > 0; --n) is_drawing[name[n] ".h"] = 1
        }
        function rank_of(path,    part) {
            split(path, part, "/")
            if (part[1] == "include")
                return path == "include/gnomon.h" ? 99 : part[3] in is_drawing ? rank["formats"] : 1
            return part[1] == "src" ? rank[part[2] == "kernel" ? part[2] "/" part[3] : part[2]] + 0 : -1
        }
        {
            from = rank_of($1)
            to = rank_of($2)
            if (from == 0 || $2 == "nothing" || (from > 0 && (to < 1 || to > from)) ||
                $1 ~ "^include/" && $2 !~ "^include/") {
                print $1 " " what " " $3 ($2 == "nothing" ? ": no such file" : what == "calls" ? " of " $2 : ": against the order of layers")
                bad = 1
            }
        }
        END { exit bad }' >&2
}

# tsort names the files of a circle.
in_circles() {
    circles=$(awk '$2 != "nothing" { print $1, $2 }' | sort -u | tsort 2>&1 >/dev/null) && return
    printf '%s\n' "$circles" | sed "s|^tsort: -:.*|a circle of $1:|; s|^tsort:|   |" >&2
    return 1
}

for object in $(sources | sed "s|^|$build/|; s|c\$|o|"); do
    [ -f "$object" ] || { echo "layers: $object is not there: make test builds all objects" >&2; exit 2; }
done
faults=0
for relation in includes calls; do
    pairs=$($relation)
    printf '%s\n' "$pairs" | against_order $relation || faults=1
    printf '%s\n' "$pairs" | in_circles $relation || faults=1
done
[ $faults = 0 ] && echo "layers: 1 passed, 0 failed: $(find src -type f | wc -l) files of src/ in order; no circles in src/, reference/ and tools/"
exit $faults
