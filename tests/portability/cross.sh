#!/bin/sh
# Shows that the bits are equal on every machine: builds the library for every row of `builds`, runs
# hashes.c there, in an emulator, under Node or under Wine, and compares.
# - Every build draws the same common scenes and calls every function of the mathematics with the same
#   arguments. The hashes of a set, of all builds and all their back ends, must be one hash. A
#   library compiled with GN_BASIC draws what it can draw; every other library draws that too.
# - Each build then draws more scenes, of another seed, which are compared class by class with the
#   hashes of this machine. Slow emulators draw fewer of them, microcontrollers none.
# - No library uses a fused operation; as a WebAssembly module it imports nothing. If a target has its
#   own form of lanes, the operations of that form are tested too (test_lanes.c).
# - x87 floats are refused by name.
# - If no BUILDs are named, at least 40 builds have hashes, so that a table that has lost rows fails.
# A tool that is absent is named. The build is then skipped if BUILDs are named, and a failure otherwise
# (and under GN_NO_SKIP, skip.sh).
# usage: cross.sh BUILD-DIRECTORY [--scenes N] [--jobs N] [BUILD...]
#        (from the root of the project)
set -eu
. tests/script.sh
script=cross
table=tests/portability/builds
make=${MAKE:-make}
common=110 # scenes of each set that every build draws
rounds=64  # of the mathematics

usage() {
    echo "usage: cross.sh BUILD-DIRECTORY [--scenes N] [--jobs N] [BUILD...]"
    echo "  --scenes N        scenes that a fast machine draws beyond the common $common (440)"
    echo "  --jobs N          builds at a time (2)"
    echo "  BUILD             rows of tests/portability/builds (all of them)"
    echo "The last line is: hashes: N builds, N distinct"
}

# describe BUILD: sets the build's columns and those of its machine.
describe() {
    columns=$(awk -v build="build $1" -F '[[:space:]]+[|]' '
        function set(name, i) {
            gsub(/^[[:space:]]+|[[:space:]]+$/, "", $i)
            return sprintf("%s=\047%s\047\n", name, $i)
        }
        /^machine / { of[substr($1, 9)] = set("runner", 2) set("disassembler", 3) set("fused", 4) set("share", 5) }
        $1 == build {
            own = set("machine", 2) set("scenes", 3) set("forms", 4) set("compiler", 5) set("flags", 6)
            print own of[$2]
        }' $table)
    [ -n "$columns" ] || { echo "cross.sh: unknown build '$1'; $table lists them" >&2; exit 2; }
    eval "$columns"
    linked=-lm
    case $machine in
    cortex-*)
        linked="-lm -nostartfiles -T tests/microcontrollers/board.ld"
        linked="$linked -Wl,--defsym=code_begin=0,--defsym=ram_begin=0x21000000,--defsym=ram_length=16M"
        ;;
    # The deepest draws take more than the 64 KiB of stack that the linker reserves after the data,
    # and an overflow overwrites the data. A stack that lies before all data ends the program instead.
    wasm) linked="-lm -Wl,--stack-first -Wl,-z,stack-size=131072" ;;
    esac
    # What runners start.
    started=
    case $machine in
    cortex-*) started=qemu-system-arm ;;
    windows) started=wine ;;
    esac
}

have() { # sets `absent` to the first of the commands that is absent
    absent=""
    for command in "$@"; do
        command -v "${command%% *}" >/dev/null 2>&1 || { absent=${command%% *}; return 1; }
    done
}

# Tells whether the compiler finds the libraries that it links: a C library, and the sanitizer's.
links() {
    echo '#include <stdio.h>
int main(void) { return puts("") < 0; }' >"$own/links.c"
    # shellcheck disable=SC2086
    $compiler $flags "$own/links.c" $linked -o "$own/links" >"$own/log" 2>&1
}

absent() { # absent BUILD WHAT
    status=skipped
    [ -z "${GN_NO_SKIP:-}" ] || status=failed
    echo "$status: $1: not run, since $2: 'make setup setup-cross' installs it"
    echo $status >"$own/status"
}

# hashes_differ EXPECTED PRINTED: prints which hashes of the second file differ, or are not there, and
# of which classes or functions, from those of this machine's portable back end. Status 1 if none.
hashes_differ() {
    awk '
        $2 == "drawn" { next }
        { made = $2 == "scenes" || $2 == "inputs" }
        NR == FNR {
            if (made)
                other[$1] = $3
            else if ($2 == "portable")
                here[$1] = $3
            next
        }
        { seen[$1] = 1 }
        made && $3 != other[$1] { made_here = made_here " " $1; skip[$1] = 1 }
        !made && $3 != here[$1] && !skip[$1] {
            if (!($2 in drawn))
                order[++ends] = $2
            drawn[$2] = drawn[$2] " " $1
        }
        END {
            for (name in here)
                missing += !(name in seen)
            if (missing)
                text = "; " missing " hashes were not printed"
            if (made_here)
                text = text "; the generator made others of" made_here
            for (i = 1; i <= ends; i++)
                text = text "; " order[i] " differs in" drawn[order[i]]
            print substr(text, 3)
            exit text == ""
        }' "$1" "$2"
}

backends() { awk '$1 ~ /^basic-/ && $2 != "scenes" && !($2 in seen) { seen[$2]; printf "%s%s", sep, $2; sep = " and " }' "$1"; }

# sets_of FILE: prints a line of each set and back end, SET BACK-END HASH, where HASH is that of all
# the set's hashes. A function that has one form for all back ends counts for each.
sets_of() {
    for set in mathematics basic pictures; do
        grep -v -e ' scenes ' -e ' inputs ' -e ' drawn ' "$1" | awk -v set=$set '
            (/^gn_/ ? "mathematics" : /^basic-/ ? "basic" : "pictures") == set' >"$1.$set"
        for backend in $(cut -d ' ' -f 2 "$1.$set" | sort -u); do
            awk -v backend="$backend" '
                $2 == "portable" && !($1 in hash) { hash[$1] = $3; name[++n] = $1 }
                $2 == backend { hash[$1] = $3 }
                END { for (i = 1; i <= n; i++) print name[i], hash[name[i]] }' "$1.$set" |
                md5sum | awk -v set=$set -v backend="$backend" '{ print set, backend, $1 }'
        done
    done
}

# limited COMMAND...: runs a program that a wrong compiler may have made: such programs have taken all
# memory, or have not ended. Sanitizers and Node reserve addresses beyond all memory.
limited() (
    case "$runner $flags" in
    *-fsanitize=* | node*) ;;
    env*) ulimit -v 4000000 ;;
    *) ulimit -v 16000000 ;;
    esac
    exec timeout 1800 "$@"
)

# Run `hashes` on the common scenes, and on those of another seed.
run_common() {
    all=$common
    [ "$scenes" != basic ] || all=0
    # shellcheck disable=SC2086
    limited $runner "$1" --scenes "$all" --basic $common --mathematics $rounds
}

run_more() {
    more=$((more_scenes * share / 100))
    all=$more
    [ "$scenes" != basic ] || all=0
    # shellcheck disable=SC2086
    [ "$more" -eq 0 ] || limited $runner "$1" --scenes "$all" --basic "$more" --seed 2
}

# The same of this machine, for a build that draws `scenes` and this share of the scenes.
expected() {
    awk -v basic="$scenes" '!/^[a-z]/ || basic != "basic" || /^(basic|gn_|arguments)/' "$work/here.common" >"$own/common.expected"
    more=$((more_scenes * share / 100))
    all=$more
    [ "$scenes" != basic ] || all=0
    [ "$more" -eq 0 ] || "$top/hashes" --scenes "$all" --basic "$more" --seed 2 >"$own/more.expected"
}

fail() { echo "$1: $2"; echo failed >"$own/status"; }

# Compiles every file of the library, which needs no C library.
compile_only() {
    for source in src/*/*.c; do
        # shellcheck disable=SC2086
        $compiler $flags -std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror \
            -Iinclude -ffreestanding -fno-math-errno -fno-stack-protector -fno-fast-math -ffp-contract=off \
            -c "$source" -o "$own/$(echo "$source" | tr / _).o" >"$own/log" 2>&1 ||
            { grep error "$own/log"; fail "$1" "$source does not compile"; return; }
    done
    echo "$1: compiled"
    echo compiled >"$own/status"
}

# one BUILD: makes and tests a build. Its directory then holds `status`: passed, failed, skipped or
# compiled; and `sets`, the hashes of what it drew.
one() {
    describe "$1"
    own=$top/cross/$1
    mkdir -p "$own"
    rm -f "$own/status" "$own/sets" "$own"/*.expected "$own"/*.printed
    [ "$runner" = - ] || started="$started ${runner%% *}"
    # shellcheck disable=SC2086
    if ! have "$compiler" $started ${disassembler#-}; then
        absent "$1" "$absent is absent"
        return
    fi
    if [ "$scenes" = compiled ]; then
        compile_only "$1"
        return
    fi
    if [ "$scenes" != shared ] && ! links; then
        absent "$1" "$compiler has no libraries to link with"
        return
    fi
    program=$own/hashes
    set -- "$1" "$program" ${forms:+"$own/test-lanes"}
    name=$1
    shift
    with=
    [ "$scenes" != shared ] || with="SCENES_BUILD=$top LINKER=gcc"
    # shellcheck disable=SC2086
    if ! $make -s BUILD="$own" CC="$compiler" CFLAGS="$flags" LANES_FORMS="$forms" HASHES_LINKED="$linked" $with \
        "$@" >"$own/log" 2>&1; then
        grep -v '^  [A-Z][A-Z] ' "$own/log" | tail -n 30
        fail "$name" "does not build"
        return
    fi
    expected
    if ! run_common "$program" >"$own/common.printed" 2>"$own/log" ||
        ! run_more "$program" >"$own/more.printed" 2>"$own/log"; then
        tail -n 10 "$own/log"
        fail "$name" "the program fails"
        return
    fi
    sets_of "$own/common.printed" | sed "s/^/$name /" >"$own/sets"
    if differences=$(hashes_differ "$own/common.expected" "$own/common.printed"); then
        fail "$name" "$differences"
    fi
    if [ -e "$own/more.expected" ] && differences=$(hashes_differ "$own/more.expected" "$own/more.printed"); then
        fail "$name" "more scenes: $differences"
    fi
    # shellcheck disable=SC2086
    if [ -n "$forms" ] && ! limited $runner "$own/test-lanes" >"$own/log" 2>&1; then
        cat "$own/log"
        fail "$name" "the operations of lanes differ"
    fi
    case "$disassembler $flags" in
    -* | *-flto*) ;; # objects without instructions
    *)
        count=$(find "$own/src" -name '*.o' -exec "$disassembler" -d {} + | tee "$own/disassembly" | grep -c -E "$fused") || true
        [ -s "$own/disassembly" ] || fail "$name" "$disassembler fails"
        rm -f "$own/disassembly"
        [ "$count" -eq 0 ] || fail "$name" "$count fused operations"
        ;;
    esac
    case $machine in
    wasm)
        find "$own/src" -name '*.o' -exec clang-19 --target=wasm32 -nostdlib \
            -Wl,--no-entry,--export-dynamic,--strip-all -o "$own/gnomon.wasm" {} + &&
            node tests/portability/imports.mjs "$own/gnomon.wasm" ||
            fail "$name" "the library alone is no module without imports"
        ;;
    esac
    [ -e "$own/status" ] || { echo "$name: $(backends "$own/common.printed"): hashes equal"; echo passed >"$own/status"; }
}

if [ "${1:-}" = --one ]; then # in a process of its own, for xargs
    top=$2 work=$3 more_scenes=$4
    one "$5"
    exit 0
fi

case ${1:-} in
--help) usage; exit 0 ;;
"" | -*) usage >&2; exit 2 ;;
esac
top=$1
more_scenes=440
jobs=2
shift
while [ $# -gt 0 ]; do
    case $1 in
    --scenes | --jobs)
        [ $# -ge 2 ] && [ "$2" -ge 0 ] 2>/dev/null || { usage >&2; exit 2; }
        [ "$1" = --jobs ] && jobs=$2 || more_scenes=$2
        shift 2
        ;;
    --help) usage; exit 0 ;;
    -*) usage >&2; exit 2 ;;
    *) break ;;
    esac
done
least=0 # builds that have hashes
if [ $# -eq 0 ]; then
    least=40
    export GN_NO_SKIP=1
    # shellcheck disable=SC2046
    set -- $(awk '$1 == "build" { print $2 }' $table)
fi
for name in "$@"; do
    describe "$name"
done
mkdir -p "$top/cross"
work=$(mktemp -d) # only of this run
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP

x87() { # the library's file says why it does not compile
    ! i686-linux-gnu-gcc -O2 -std=c99 -ffreestanding -Iinclude -mno-sse -c src/backends/portable.c -o "$work/x87.o" 2>"$work/log" &&
        grep '#error "x87' "$work/log"
}
if command -v i686-linux-gnu-gcc >/dev/null 2>&1; then
    result "x87 floats, which have excess precision, are refused by name" x87
else
    skip "x87: not tried, since i686-linux-gnu-gcc is absent: 'make setup-cross' installs it"
fi

result "hashes can be built here" $make -s -j"$jobs" BUILD="$top" "$top/hashes"
[ -e "$top/hashes" ] || finish
scenes=shared runner=env flags="" share=100
run_common "$top/hashes" >"$work/here.common"
run_more "$top/hashes" >"$work/here.more"
equal() { ! hashes_differ "$1" "$1"; }
result "here, the common scenes" equal "$work/here.common"
result "here, more scenes" equal "$work/here.more"
echo "here: $(backends "$work/here.common"): $(cat "$work"/here.* | wc -l) hashes, $common scenes of each set and $more_scenes more"
sets_of "$work/here.common" | sed 's/^/here /' >"$work/sets"

printf '%s\n' "$@" | xargs -P "$jobs" -I NAME "$0" --one "$top" "$work" "$more_scenes" NAME

compiled=""
without=""
for name in "$@"; do
    own=$top/cross/$name
    [ ! -e "$own/sets" ] || cat "$own/sets" >>"$work/sets"
    case $(cat "$own/status" 2>/dev/null) in
    passed) passed=$((passed + 1)) ;;
    compiled)
        passed=$((passed + 1))
        compiled="$compiled $name"
        ;;
    skipped) without="$without $name" ;;
    *)
        without="$without $name"
        failed=$((failed + 1))
        ;;
    esac
done

# distinct SET: prints the builds and the hashes of a set.
distinct() {
    awk -v set="$1" '
        $2 == set { builds[$1]; hashes[$4] }
        END { for (b in builds) n++; for (h in hashes) d++; printf "%d builds, %d distinct", n, d }' "$work/sets"
}
[ -z "$compiled" ] || echo "compiled only:$compiled"
[ -z "$without" ] || echo "skipped or failed:$without"
builds=$(cut -d ' ' -f 1 "$work/sets" | sort -u | wc -l)
result "builds with hashes: $builds, at least $least" [ "$builds" -ge "$least" ]
echo "pictures: $(distinct pictures)"
echo "pictures of what a GN_BASIC library draws: $(distinct basic)"
echo "mathematics: $(distinct mathematics)"
echo "cross: $passed passed, $failed failed"
awk '{ builds[$1]; if (!(($2, $4) in seen)) { seen[$2, $4]; if (++d[$2] > most) most = d[$2] } }
    END { for (b in builds) n++; printf "hashes: %d builds, %d distinct\n", n, most }' "$work/sets"
[ "$failed" -eq 0 ] && [ "$(awk '{ print $2, $4 }' "$work/sets" | sort -u | wc -l)" -eq 3 ]
