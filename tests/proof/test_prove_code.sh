#!/bin/sh
# Checks that tests/proof/prove_code.sh rejects what is wrong: functions mutated in a copy of the
# sources, and contracts that contradict themselves. A mutant is rejected if a goal of its function
# is not proved, or if Eva raises an alarm; a text that Frama-C cannot read does not count. What is
# not mutated must be proved with the same provers and time-outs: those of --once where they suffice,
# 20 seconds where those do.
# usage: test_prove_code.sh [--jobs N | --provers N] [--list] [NAME ...]
#   NAME         functions and drivers of Eva (default: all, which takes half an hour and more)
#   --jobs N     names at the same time, each with one prover (1)
#   --provers N  provers at the same time, with one job (2)
#   --list       only prints the names
# PROOF_TIMEOUT is the time-out where 20 seconds do not suffice, in seconds by the clock (60). A
# machine with much load needs more to prove what is not mutated.
set -u
here=$(cd "$(dirname "$0")" && pwd)
passed=0
failed=0
jobs=1
provers=2
lists=
while [ $# -gt 0 ]; do
    case $1 in
    --jobs) jobs=$2 && shift ;;
    --provers) provers=$2 && shift ;;
    --list) lists=yes ;;
    --help) sed -n '2,/^set -u/{/^set -u/!s/^# \{0,1\}//p}' "$0" && exit 0 ;;
    -*) echo "test_prove_code: unknown option $1; see --help" >&2 && exit 2 ;;
    *) break ;;
    esac
    shift
done
names=$*
directory=$(mktemp -d) || exit 1
trap 'rm -rf "$directory"' EXIT
trap 'exit 1' INT TERM

# finish: prints the sums and ends.
finish() {
    echo "code that is wrong: $passed rejected, $failed not"
    echo "proofs of C functions: $passed passed, $failed failed"
    [ "$failed" -eq 0 ]
    exit
}

# sum_of PATTERN: adds up what the pattern's group takes from the sums of each name.
sum_of() { sed -n "s/^code that is wrong: $1\$/\1/p" "$directory/reports" | awk '{ n += $1 } END { print n + 0 }'; }

if [ -z "$lists" ]; then
    "$0" --list >"$directory/all" || exit 1
    for name in $names; do
        grep -qx -e "$name" "$directory/all" ||
            { echo "test_prove_code: there is no mutant of $name; see --list" >&2; exit 2; }
    done
fi

if [ "$jobs" -gt 1 ]; then
    "$0" --list "$@" | awk '!seen[$0]++' >"$directory/names"
    xargs -n 1 -P "$jobs" "$0" --provers 1 <"$directory/names" >"$directory/reports"
    grep -v -e '^code that is wrong' -e '^proofs of C functions' "$directory/reports"
    passed=$(sum_of '\([0-9]*\) rejected, .*')
    failed=$(sum_of '.* rejected, \([0-9]*\) not')
    ended=$(grep -c '^code that is wrong' "$directory/reports")
    failed=$((failed + $(wc -l <"$directory/names") - ended))
    finish
fi

# asked NAME: whether the function or driver is to be tested.
asked() {
    [ -n "$names" ] || return 0
    case " $names " in *" $1 "*) return 0 ;; esac
    return 1
}

# prove NAME OPTION...: proves a function, or a driver, from the copies.
prove() {
    only=$1
    shift
    "$directory/tests/proof/prove_code.sh" -q --only "$only" --jobs "$provers" "$@" "$directory" >"$directory/log" 2>&1
}

copy() {
    rm -rf "$directory/src" "$directory/tests"
    mkdir -p "$directory/tests"
    cp -r "$here/../../src" "$here/../../include" "$directory/"
    cp -r "$here" "$directory/tests/proof"
}

bad() {
    failed=$((failed + 1))
    printf '%s\n' "FAILED: $1" "$(sed 's/^/    /' "$directory/log")"
}

# prove_as_it_is NAME: without a mutation NAME is proved; once for all its mutants. Leaves the options
# that this took in a file.
prove_as_it_is() {
    [ ! -f "$directory/options_$1" ] || return
    echo "test_prove_code: $1 as it is" >&2
    copy
    for options in --once "--timeout 20" "--timeout ${PROOF_TIMEOUT:-60}"; do
        echo "$options" >"$directory/options_$1"
        prove "$1" $options && return
    done
    bad "not proved: $1"
}

# is_rejected: whether the last proof failed by a goal of WP or by an alarm of Eva.
is_rejected() {
    grep -q -e '^FAILED: [A-Za-z0-9_]*$' -e '^ *\[eva:alarm\]' "$directory/log" &&
        grep -q '^proved: [0-9]* / [1-9]' "$directory/log"
}

# mutant NAME FILE EXPRESSION: changes one file by sed; the proof of NAME must then fail by a goal.
mutant() {
    asked "$1" || return
    [ -z "$lists" ] || { echo "$1" && return; }
    prove_as_it_is "$1"
    echo "test_prove_code: $2: $3" >&2
    copy
    sed "$3" "$directory/$2" >"$directory/mutated"
    if cmp -s "$directory/mutated" "$directory/$2"; then
        : >"$directory/log"
        bad "'$3' changes nothing in $2"
        return
    fi
    cp "$directory/mutated" "$directory/$2"
    if prove "$1" $(cat "$directory/options_$1") || ! is_rejected; then
        bad "not rejected: $2: $3"
    else
        passed=$((passed + 1))
    fi
}

edges=src/kernel/raster/cover_large.inl
mutant set_edge_through $edges 's/own - 1) >> 8/own) >> 8/'
mutant owns_ties $edges 's/return per_x < 0/return per_x <= 0/'
mutant owns_ties $edges 's/upside_down ? per_y < 0/upside_down ? per_y > 0/'
mutant set_edge_through $edges 's/- 1) >> 8/- 1) >> 7/'
mutant set_edge_through $edges 's/wide_product(per_x, x) - wide/wide_product(per_x, x) + wide/'
mutant set_edge_through $edges 's/change_x = -per_x/change_x = per_x/'
mutant wide_product $edges 's/(int64_t)a \* b/a * b/'
mutant values_at $edges 's/constant - wide_product/constant + wide_product/'
mutant step_right $edges 's/squares \* SQUARE_SIZE)/squares)/'
mutant is_outside $edges 's/greatest < 0/greatest <= 0/'
mutant is_inside $edges 's/edge\[1\]\.least >= 0/edge[1].least > 0/'
mutant count_inside $edges 's/count + stride <= limit \&\& is_inside/count + stride <= limit + 1 \&\& is_inside/'
mutant count_outside $edges 's/count += stride;/count += 0;/'
mutant begins_outside src/kernel/raster/square.inl 's/range\.first >= range\.count/range.first > range.count/'
mutant squares_inside src/kernel/raster/square.inl 's/last = max - (SQUARE_SIZE - 1)/last = max - SQUARE_SIZE/'
mutant make_queue_room src/kernel/raster/block_queue.inl 's/room > QUEUE_BLOCKS/room > QUEUE_BLOCKS + 1/'
mutant add_square src/kernel/raster/block_queue.inl 's/block\[queue->count\]/block[queue->count + 1]/'
mutant cover_row $edges 's/^        skip = 1;/        skip = 0;/'
mutant cover_rows $edges 's/y <= top; y += SQUARE_SIZE/y <= top; y += 0/'
mutant cover_row_of_each $edges 's/uint32_t l = first; l < end; ++l/uint32_t l = first; l <= end; ++l/'
mutant set_edges_of_each $edges 's/i < count; ++i/i <= count; ++i/'
mutant set_edge_of_samples src/kernel/raster/cover_samples.inl 's/s = 0; s < GN_SAMPLES/s = 0; s <= GN_SAMPLES/'
mutant cover_sample_row src/kernel/raster/cover_samples.inl 's/^        x += SQUARE_SIZE;/        x += 0;/'
mutant cover_sample_rows src/kernel/raster/cover_samples.inl 's/y <= max_y; y += SQUARE_SIZE/y <= max_y; y += 0/'
mutant cover_sample_row_between src/kernel/raster/cover_samples.inl 's/x <= box->max_x; x += SQUARE_SIZE/x <= box->max_x; x -= SQUARE_SIZE/'
mutant cover_small_row src/kernel/raster/cover_small.inl 's/queue->count == QUEUE_BLOCKS/queue->count > QUEUE_BLOCKS/'
mutant cover_small src/kernel/raster/cover_small.inl 's/if (y + SQUARE_SIZE > max_y)/if (y > max_y)/'
mutant lanes_met src/kernel/raster/cover_packed.inl 's/fall_per_square\[i\] \* number/fall_per_square[i] * number * 4096/'
mutant cover_packed_row src/kernel/raster/cover_packed.inl 's/QUEUE_BLOCKS - 1 - 2 \* HALVES_TOGETHER/QUEUE_BLOCKS - 1 - HALVES_TOGETHER/'
mutant cover_packed src/kernel/raster/cover_packed.inl 's/count = 2 \* queue->count/count = 4 * queue->count/'
mutant cover_from src/kernel/raster/coverage.inl 's/(end < list->count/(end < list->count + 1/'
mutant cover_each src/kernel/raster/coverage.inl 's/l < list->count;)/l <= list->count;)/'
mutant cover_box src/kernel/raster/cover_points_and_lines.inl 's/full_squares > 1 ? full_squares : 1/full_squares > 1 ? full_squares : 0/'
mutant cover_pixel_row src/kernel/raster/cover_pixels.inl 's/ \&\& x <= max_x) {/) {/'
mutant cover_pixels src/kernel/raster/cover_pixels.inl 's/y <= max_y; ++y/y <= max_y; y += 0/'
steps=src/kernel/fragment/steps.inl
mutant compact_batch $steps 's/n < b->count; ++n/n <= b->count; ++n/'
mutant blocks_together $steps 's/ \&\& together < most/ \&\& together < most + 1/'
mutant step_blocks $steps 's/done < count;)/done <= count;)/'
mutant shade_rest $steps 's/i < count; ++i/i <= count + 1; ++i/'
mutant name_rows $steps 's/row < SQUARE_SIZE/row <= SQUARE_SIZE/'
mutant most_columns $steps 's/most > STEP_COLUMNS ? STEP_COLUMNS : most/most > STEP_COLUMNS ? most : STEP_COLUMNS/'
mutant step_columns $steps 's/columns < most ? columns : most/most/'
mutant room_of src/kernel/geometry/clip.inl 's/: CLIP_MAX_VERTICES;/: 2 * CLIP_ROOM;/'
mutant clip_to_plane src/kernel/geometry/clip.inl 's/out->count > CLIP_MAX_POLYGON - 2/out->count > CLIP_MAX_POLYGON - 1/'
mutant clip_to_plane src/kernel/geometry/clip.inl 's/ || c->used == room_of(c))/)/'
mutant take_pieces src/kernel/geometry/clip.inl 's/from + l + 2 : 2/from + l + 3 : 2/'
mutant add_halves src/kernel/raster/cover_packed.inl 's/block\[count \/ 2\];$/block[count];/'
mutant finish_halves src/kernel/raster/cover_packed.inl 's/= (count + 1) \/ 2;/= count + 1;/'
mutant add_sampled_square src/kernel/raster/cover_samples.inl 's/queue->count == SAMPLED_SQUARES/queue->count > SAMPLED_SQUARES/'
mutant eva_sizes src/texture/packed_levels.c 's/return (uint64_t)(e\.width \* e\.height)/return (uint32_t)(e.width * e.height)/'
mutant eva_sizes src/draw/prepare.c 's/= ((uint64_t)stored - 1).*/= stored + 15;/'
mutant eva_sizes src/texture/texture_faults.h 's/s->width > GN_MAX_SIZE/s->width > 16 * GN_MAX_SIZE/'
mutant eva_snapping src/kernel/raster/points_and_lines.inl 's/return v < SNAPPED_LIMIT \/ 256 \&\& /return /'
mutant eva_inverses src/math/inverse.c 's/pivots\[4\] = {m->m\[0\]\[0\]/pivots[4] = {m->m[4][0]/'
mutant eva_inverses src/math/inverse.c 's/i < 4; ++i) {/i <= 4; ++i) {/'
mutant eva_clipping src/kernel/geometry/clip.inl 's/n < c->used; ++n) {/n <= c->used + 3; ++n) {/'
mutant eva_clipping src/lanes/lanes_portable.h 's/magnitude >= LANE_BITS_2_31);/magnitude > LANE_BITS_2_31 + 256);/'
mutant eva_clipping src/lanes/lanes_portable.h 's/(outside & INT32_MIN);/(outside \& INT32_MIN) + (int32_t)lane_as_float(bits);/'
mutant eva_edges src/kernel/raster/setup.inl 's/stored_vertex \*v = /stored_vertex *v = list->provoking[l] > 64 ? 0 : /'
mutant eva_edges $edges 's/-per_x \* (SQUARE_SIZE - 1)/-per_x * (64 * SQUARE_SIZE)/'
mutant eva_edges src/lanes/lanes.h 's/(bits & 0x1F) + (bits >> 8)/(bits \& 0xFF) + (bits >> 8)/'
mutant eva_texels src/kernel/texture/texel.inl 's/load_four_words(words + 4/load_four_words(words + 8/'
mutant eva_texels src/texture/texel_layout.c 's/(int32_t)(end - 8)/(int32_t)(end - 4)/'
mutant eva_texels src/texture/texel_layout.c 's/out->row_stride >> shift)/out->row_stride >> 1)/'

# A contract that nothing fulfils would prove anything: the false assertion behind it must be rejected.
mutant set_edge_through tests/proof/code/contracts/kernel/raster/cover_large.inl.acsl 's/ensures edge_ok(e);/ensures \\false;/'
mutant values_at tests/proof/code/contracts/kernel/raster/cover_large.inl.acsl 's/ensures values_are(.result, edge, x, y);/ensures \\false;/'
mutant add_square tests/proof/code/contracts/kernel/raster/block_queue.inl.acsl 's/ensures queue->count <= QUEUE_BLOCKS;/ensures \\false;/'
contracts=tests/proof/code/contracts/kernel/raster
mutant set_edges_of_each $contracts/cover_large.inl.acsl '/ set_edges_of_each(/,/^\*\//s/ensures .*/ensures \\false;/'
mutant cover_rows $contracts/cover_large.inl.acsl '/ cover_rows(/,/^\*\//s/ensures .*/ensures \\false;/'
mutant cover_triangle_samples $contracts/cover_samples.inl.acsl '/ cover_triangle_samples(/,/^\*\//s/ensures .*/ensures \\false;/'
mutant cover_small $contracts/cover_small.inl.acsl '/ cover_small(/,/^\*\//s/ensures .*/ensures \\false;/'
mutant cover_packed $contracts/cover_packed.inl.acsl '/ cover_packed(/,/^\*\//s/ensures .*/ensures \\false;/'
mutant cover_triangles $contracts/coverage.inl.acsl '/ cover_triangles(/,/^\*\//s/assigns .*/assigns \\nothing; ensures \\false;/'
mutant step_rows tests/proof/code/contracts/kernel/fragment/steps.inl.acsl '/ step_rows(/,/^\*\//s/assigns .*/assigns \\nothing; ensures \\false;/'
mutant cover_line $contracts/cover_points_and_lines.inl.acsl '/ cover_line(/,/^\*\//s/ensures .*/ensures \\false;/'
mutant cover_pixels $contracts/cover_pixels.inl.acsl '/ cover_pixels(/,/^\*\//s/ensures .*/ensures \\false;/'
mutant count_owners tests/proof/code/wp_shared_edge.c 's/ensures .result == 1;/ensures \\false;/'

[ -n "$lists" ] || finish
