#!/bin/sh
# Shows that the pictures are equal on every machine. Builds the library for other processors,
# draws the parity suite's scenes there (hashes.c), in an emulator or under Node, and compares the
# hashes of every back end with those of the portable one on this machine. Five targets are this
# machine itself: `small` compiles with GN_SMALL, `one-lane` with GN_SMALL, GN_BASIC and one lane,
# `plain` with lanes in arrays, as for targets without vector registers, `whole-program` optimises
# across files, `memory` runs under the memory sanitizer. One lane is
# compared with sixteen lanes of a GN_BASIC library, on scenes without what such a library lacks. If a target's tools are absent, the target is named and skipped
# (skip.sh). If a target has its own form of lanes, the operations of that form are tested too
# (test_lanes.c). Also checks that no library uses a fused operation, and that the library as a
# WebAssembly module imports nothing.
# usage: cross.sh BUILD-DIRECTORY [--scenes N] [TARGET...]   (from the root of the project)
set -eu
[ $# -ge 1 ] || { echo "usage: cross.sh BUILD-DIRECTORY [--scenes N] [TARGET...]" >&2; exit 2; }
. tests/skip.sh
export MAKEFLAGS=
build=$1/cross
scenes=440
shift
if [ "${1:-}" = --scenes ]; then
    scenes=$2
    shift 2
fi
passed=0
failed=0
mkdir -p "$build"
work=$(mktemp -d) # only of this run
trap 'rm -rf "$work"' EXIT

# describe TARGET: sets its compiler, flags, the program that runs its programs, its disassembler
# and the names of fused instructions. The flags allow a careless compiler to fuse.
describe() {
    flags=-O2
    forms=""
    sixteen=""
    setup=setup-cross
    case $1 in
    aarch64)
        compiler=aarch64-linux-gnu-gcc
        forms="portable vectors neon"
        runner="qemu-aarch64 -L /usr/aarch64-linux-gnu"
        disassembler=aarch64-linux-gnu-objdump
        fused='[[:space:]]fn?m(add|sub|l[as])'
        ;;
    armhf)
        compiler=arm-linux-gnueabihf-gcc
        flags="-O2 -mfpu=neon-vfpv4"
        runner="qemu-arm -L /usr/arm-linux-gnueabihf"
        disassembler=arm-linux-gnueabihf-objdump
        fused='[[:space:]]vfn?m[as]'
        ;;
    s390x) # big-endian; in C's standard modes compilers evaluate floats as doubles
        compiler=s390x-linux-gnu-gcc
        flags="-O2 -march=z14 -fexcess-precision=fast"
        forms="portable vectors"
        runner="qemu-s390x -L /usr/s390x-linux-gnu"
        disassembler=s390x-linux-gnu-objdump
        fused='[[:space:]](m[as][de]br|[vw]fn?m[as][sd]b)'
        ;;
    wasm | wasm-simd128)
        compiler="clang-19 --target=wasm32-wasi"
        runner="node --no-warnings tests/portability/wasi.mjs"
        disassembler=""
        [ "$1" = wasm ] || { flags="-O2 -msimd128"; forms="portable vectors wasm_simd128"; }
        ;;
    small) # this machine, with little code
        setup=setup
        compiler=${CC:-cc}
        flags="-Os -DGN_SMALL -DGN_ONLY_PORTABLE"
        runner="env"
        disassembler=objdump
        fused='[[:space:]]vfn?m(add|sub)'
        ;;
    one-lane) # this machine, as a library for processors without vector registers
        setup=setup
        compiler=${CC:-cc}
        sixteen="-O1 -DGN_SMALL -DGN_BASIC -DGN_ONLY_PORTABLE -DGN_LANES=16"
        flags="-O2 -DGN_SMALL -DGN_BASIC -DGN_LANES=1"
        runner="env"
        disassembler=objdump
        fused='[[:space:]]vfn?m(add|sub)'
        ;;
    plain) # this machine, with sixteen lanes in plain arrays
        setup=setup
        compiler=${CC:-cc}
        flags="-O2 -DGN_ONLY_PORTABLE -DGN_NO_VECTORS"
        runner="env"
        disassembler=objdump
        fused='[[:space:]]vfn?m(add|sub)'
        ;;
    whole-program) # this machine, optimised across files; a cast that may break aliasing is an error
        setup=setup
        compiler=gcc
        flags="-O3 -flto=auto -Wstrict-aliasing=1 -DGN_ONLY_PORTABLE"
        runner="env"
        disassembler=""
        ;;
    memory) # this machine; a result that depends on uninitialised memory is an error
        setup=setup
        compiler=clang
        flags="-O0 -g1 -fno-omit-frame-pointer -DGN_SMALLEST_TASKS -DGN_ONLY_PORTABLE"
        flags="$flags -fsanitize=memory -fno-sanitize-recover=memory"
        runner="env"
        disassembler=""
        ;;
    *)
        echo "cross.sh: unknown target '$1'" >&2
        exit 2
        ;;
    esac
}

# Tells whether the compiler finds the libraries that it links: a C library, and the sanitizer's.
links() {
    # shellcheck disable=SC2086
    echo '#include <stdio.h>
int main(void) { return puts("") < 0; }' | $compiler $flags -x c - -o "$work/links" >/dev/null 2>&1
}

have() { # sets `absent` to the first of the commands that is absent
    absent=""
    for command in "$@"; do
        command -v "${command%% *}" >/dev/null 2>&1 || { absent=${command%% *}; return 1; }
    done
}

pass() {
    echo "$1"
    passed=$((passed + 1))
}

fail() {
    echo "$1"
    failed=$((failed + 1))
}

# drawn_share FILE: prints how many hundredths of its scenes a GN_BASIC library drew, and leaves only
# hashes in the file.
drawn_share() {
    awk '$2 == "drawn" { drawn += $3; all += $5 } END { print int(100 * drawn / all) }' "$1"
    grep -v ' drawn ' "$1" >"$work/hashes"
    cp "$work/hashes" "$1"
}

# hashes_differ FILE [EXPECTED]: prints which hashes differ, and of which classes, from those of the
# scenes made here and of their frames in C. Status 1 if none differs.
hashes_differ() {
    awk '
        NR == FNR {
            if ($2 == "scenes" || $2 == "portable")
                here[$1, $2] = $3
            next
        }
        $2 == "scenes" && $3 != here[$1, "scenes"] { made = made " " $1; other[$1] = 1 }
        $2 != "scenes" && $3 != here[$1, "portable"] && !other[$1] {
            if (!($2 in drawn))
                order[++ends] = $2
            drawn[$2] = drawn[$2] " " $1
        }
        { seen[$1, $2] = 1 }
        END {
            for (hash in here)
                missing += !(hash in seen)
            if (missing)
                text = "; " missing " hashes were not printed"
            if (made)
                text = text "; the generator made other scenes of" made
            for (i = 1; i <= ends; i++)
                text = text "; " order[i] " drew other pixels of" drawn[order[i]]
            print substr(text, 3)
            exit text == ""
        }' "${2:-$work/here}" "$1"
}

backends() { awk '$2 != "scenes" && !($2 in seen) { seen[$2]; printf "%s%s", sep, $2; sep = " and " }' "$1"; }

${MAKE:-make} -s -j2 BUILD="$(dirname "$build")" "$(dirname "$build")/hashes" >"$work/log" 2>&1 ||
    { cat "$work/log"; echo "cross: 0 passed, 1 failed"; exit 1; }
"$(dirname "$build")/hashes" --scenes "$scenes" >"$work/here"
if differences=$(hashes_differ "$work/here"); then
    fail "here: $differences"
else
    pass "here: $(backends "$work/here"): $(wc -l <"$work/here") hashes of $scenes scenes"
fi

for target in ${*:-small one-lane plain whole-program memory aarch64 armhf s390x wasm wasm-simd128}; do
    describe "$target"
    directory=$build/$target
    if ! have "$compiler" "$runner" ${disassembler:+"$disassembler"}; then
        skip "$target: not run, since $absent is absent: 'make $setup' installs it"
        continue
    fi
    if ! links; then
        skip "$target: not run, since $compiler has no libraries to link with: 'make $setup' installs them"
        continue
    fi
    if ! ${MAKE:-make} -s -j2 BUILD="$directory" CC="$compiler" CFLAGS="$flags" \
        LANES_FORMS="$forms" "$directory/hashes" ${forms:+"$directory/test-lanes"} >"$work/log" 2>&1; then
        cat "$work/log"
        fail "$target: does not build"
        continue
    fi
    # shellcheck disable=SC2086
    if ! $runner "$directory/hashes" --scenes "$scenes" >"$directory/printed" 2>"$work/log"; then
        cat "$work/log"
        fail "$target: the program fails"
        continue
    fi
    expected=$work/here
    if [ -n "$sixteen" ]; then
        expected=$work/sixteen
        ${MAKE:-make} -s -j2 BUILD="$build/sixteen" CC="$compiler" CFLAGS="$sixteen" \
            "$build/sixteen/hashes" >"$work/log" 2>&1 || { cat "$work/log"; fail "$target: sixteen lanes do not build"; continue; }
        "$build/sixteen/hashes" --scenes "$scenes" >"$expected"
        drawn_share "$expected" >/dev/null
        share=$(drawn_share "$directory/printed")
        [ "$share" -ge 75 ] || fail "$target: only $share % of the scenes are drawn"
    fi
    if differences=$(hashes_differ "$directory/printed" "$expected"); then
        fail "$target: $differences"
    else
        pass "$target (${runner%% *}): $(backends "$directory/printed"): hashes equal"
    fi
    # shellcheck disable=SC2086
    if [ -n "$forms" ] && ! $runner "$directory/test-lanes" >"$work/log" 2>&1; then
        cat "$work/log"
        fail "$target: the operations of lanes differ"
    fi
    if [ -n "$disassembler" ]; then
        if find "$directory/src" -name '*.o' -exec "$disassembler" -d {} + >"$work/disassembly" &&
            [ -s "$work/disassembly" ]; then
            count=$(grep -c -E "$fused" "$work/disassembly") || true
            [ "$count" -eq 0 ] || fail "$target: $count fused operations"
        else
            fail "$target: $disassembler fails"
        fi
    fi
    case $target in
    wasm*)
        find "$directory/src" -name '*.o' -exec clang-19 --target=wasm32 -nostdlib \
            -Wl,--no-entry,--export-dynamic,--strip-all -o "$directory/gnomon.wasm" {} + &&
            node tests/portability/imports.mjs "$directory/gnomon.wasm" ||
            fail "$target: the library alone is no module without imports"
        ;;
    esac
done
echo "cross: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
