/* The stencil test, and after it the depth test, on surfaces that hold stencil (OpenGL 4.5 sections
 * 17.3.3 and 17.3.5). */
#ifndef GN_FRAGMENT_STENCIL_H
#define GN_FRAGMENT_STENCIL_H

#include "depth.h"

/* Returns an operation as clamp(stencil * factor + offset) in the low eight bits. */
static inline stencil_update stencil_update_of(gn_stencil_operation operation, int32_t reference)
{
    static const int32_t factor[] = {1, 0, 0, 1, 1, -1, 1, 1};
    static const int32_t offset[] = {0, 0, 0, 1, -1, 255, 1, -1};
    const bool wraps =
        operation == GN_STENCIL_INCREMENT_WRAP || operation == GN_STENCIL_DECREMENT_WRAP;
    stencil_update u;

    u.factor = factor[operation];
    u.offset = operation == GN_STENCIL_REPLACE ? reference : offset[operation];
    u.low = wraps ? -1 : 0;
    u.high = wraps ? 256 : 255;
    return u;
}

static inline stencil_state stencil_state_of(const gn_stencil_face *face)
{
    stencil_state s;

    s.compare = comparison_of(face->function == GN_COMPARE_DEFAULT ? GN_ALWAYS : face->function);
    s.compared = 255 & ~face->compare_disabled;
    s.reference = face->reference & s.compared;
    s.written = 255 & ~face->write_disabled;
    s.fail = stencil_update_of(face->fail, face->reference);
    s.depth_fail = stencil_update_of(face->depth_fail, face->reference);
    s.pass = stencil_update_of(face->pass, face->reference);
    return s;
}

/* Depths and stencil values of a block; 0 for what the format does not have. `second` is the word
 * in which GN_FORMAT_D32FS8 holds stencil, with 24 more bits: pixels that are not covered keep
 * them. */
typedef struct stored_block {
    lanes_i depth, stencil, second;
} stored_block;

GN_INLINE void load_stored(gn_format format, const block_pixels *memory, uint32_t coverage,
                           stored_block *g)
{
    const lanes_i byte = lanes_i_splat(255);
    lanes_i word[4];

    load_pixels(format_layout(format), memory, coverage, word);
    if (format == GN_FORMAT_S8) {
        g->depth = lanes_i_splat(0);
        g->stencil = word[0];
    } else if (format == GN_FORMAT_D32FS8) {
        g->depth = word[0];
        g->second = word[1];
        g->stencil = lanes_i_and(word[1], byte);
    } else {
        g->depth = lanes_i_and(word[0], lanes_i_splat(0xFFFFFF));
        g->stencil = lanes_i_and(lanes_i_shift_right(word[0], 24), byte);
    }
}

GN_INLINE void store_stored(gn_format format, const block_pixels *memory, uint32_t coverage,
                            const stored_block *g)
{
    lanes_i word[4];

    word[0] = format == GN_FORMAT_S8 ? g->stencil : g->depth;
    if (format == GN_FORMAT_D32FS8)
        word[1] = lanes_i_select(lanes_from_bits(coverage), g->stencil, g->second);
    if (format == GN_FORMAT_D24S8)
        word[0] = lanes_i_or(g->depth, lanes_i_shift_left(g->stencil, 24));
    store_pixels(format_layout(format), memory, coverage, word);
}

/* Updates the written bits of the stencil of some lanes. */
static inline lanes_i update_stencil(const stencil_state *state, const stencil_update *u,
                                     uint32_t lanes, lanes_i stencil)
{
    if (!lanes || (u->factor == 1 && u->offset == 0))
        return stencil;

    const lanes_i result = lanes_i_clamp(
        lanes_i_add(lanes_i_mul(stencil, lanes_i_splat(u->factor)), lanes_i_splat(u->offset)),
        lanes_i_splat(u->low), lanes_i_splat(u->high));
    const lanes_i written = lanes_i_or(lanes_i_and(result, lanes_i_splat(state->written)),
                                       lanes_i_and(stencil, lanes_i_splat(255 & ~state->written)));

    return lanes_i_select(lanes_from_bits(lanes), written, stencil);
}

/* Tests a block against a surface that holds stencil, stencil first, and writes both. Returns the
 * part of coverage that passed. */
GN_INLINE uint32_t test_stencil(const fragment_state *state, gn_format format,
                                const fragment_place *at, bool back, uint32_t coverage,
                                lanes_f depth)
{
    const stencil_state *face = &state->stencil[back ? 1 : 0];
    const block_pixels memory = memory_of(at, &state->depth, format);
    stored_block g;
    uint32_t passed = coverage;
    uint32_t both;

    load_stored(format, &memory, coverage, &g);
    if (state->tests_stencil)
        passed &= compare_depth(&face->compare, lanes_i_splat(face->reference),
                                lanes_i_and(g.stencil, lanes_i_splat(face->compared)));
    both = passed;
    if (state->tests_depth) {
        const lanes_i incoming = quantize_depth(format, depth, false);

        both &= compare_depth(&state->test, incoming, g.depth);
        if (state->test.write)
            g.depth = lanes_i_select(lanes_from_bits(both), incoming, g.depth);
    }
    if (state->tests_stencil) {
        g.stencil = update_stencil(face, &face->fail, coverage & ~passed, g.stencil);
        g.stencil = update_stencil(face, &face->depth_fail, passed & ~both, g.stencil);
        g.stencil = update_stencil(face, &face->pass, both, g.stencil);
    }
    store_stored(format, &memory, coverage, &g);
    return both;
}

#endif
