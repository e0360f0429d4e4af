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

/* The depths and stencil values of a square; 0 for what the surface does not have. */
typedef struct stored_block {
    lanes_i depth, stencil;
} stored_block;

static inline bool holds_words(const gn_surface *surface, const fragment_place *at)
{
    return surface->format == GN_FORMAT_D24S8 && surface_holds_square(surface, at->x, at->y);
}

GN_OUT_OF_LINE stored_block load_stored(const gn_surface *surface, const fragment_place *at,
                                        uint32_t coverage)
{
    int32_t depth[GN_LANES], stencil[GN_LANES];
    stored_block b;

    if (holds_words(surface, at)) {
        const lanes_i words = load_words(SHAPE_SQUARE, &at->depth, surface->row_stride);

        b.depth = lanes_i_and(words, lanes_i_splat(0xFFFFFF));
        b.stencil = lanes_i_and(lanes_i_shift_right(words, 24), lanes_i_splat(255));
        return b;
    }
    GN_EACH_LANE (l) {
        const unsigned char *const row = surface_row(surface, (uint32_t)(at->y + l / SQUARE_SIZE));
        const stored_word *const words = (const stored_word *)(const void *)row;
        const int32_t x = at->x + l % SQUARE_SIZE;

        depth[l] = 0;
        stencil[l] = 0;
        if (!(coverage >> l & 1u))
            continue;
        if (surface->format == GN_FORMAT_S8) {
            stencil[l] = row[x];
        } else if (surface->format == GN_FORMAT_D32FS8) {
            depth[l] = words[2 * x];
            stencil[l] = words[2 * x + 1] & 255;
        } else {
            depth[l] = words[x] & 0xFFFFFF;
            stencil[l] = words[x] >> 24 & 255;
        }
    }
    b.depth = lanes_i_load(depth);
    b.stencil = lanes_i_load(stencil);
    return b;
}

GN_OUT_OF_LINE void store_stored(const gn_surface *surface, const fragment_place *at,
                                 uint32_t coverage, const stored_block *b)
{
    int32_t depth[GN_LANES], stencil[GN_LANES];

    if (holds_words(surface, at)) {
        store_words(SHAPE_SQUARE, &at->depth, surface->row_stride,
                    lanes_i_or(b->depth, lanes_i_shift_left(b->stencil, 24)));
        return;
    }
    lanes_i_store(depth, b->depth);
    lanes_i_store(stencil, b->stencil);
    GN_EACH_LANE (l) {
        unsigned char *const row = surface_row(surface, (uint32_t)(at->y + l / SQUARE_SIZE));
        stored_word *const words = (stored_word *)(void *)row;
        const int32_t x = at->x + l % SQUARE_SIZE;

        if (!(coverage >> l & 1u))
            continue;
        if (surface->format == GN_FORMAT_S8) {
            row[x] = (unsigned char)stencil[l];
        } else if (surface->format == GN_FORMAT_D32FS8) {
            words[2 * x] = depth[l];
            words[2 * x + 1] = stencil[l];
        } else {
            words[x] = (int32_t)((uint32_t)depth[l] | (uint32_t)stencil[l] << 24);
        }
    }
}

/* Updates the written bits of the stencil of some lanes. */
static inline lanes_i update_stencil(const stencil_state *state, const stencil_update *u,
                                     uint32_t lanes, lanes_i stencil)
{
    const lanes_i result = lanes_i_clamp(
        lanes_i_add(lanes_i_mul(stencil, lanes_i_splat(u->factor)), lanes_i_splat(u->offset)),
        lanes_i_splat(u->low), lanes_i_splat(u->high));
    const lanes_i written = lanes_i_or(lanes_i_and(result, lanes_i_splat(state->written)),
                                       lanes_i_and(stencil, lanes_i_splat(255 & ~state->written)));

    return lanes_i_select(lanes_from_bits(lanes), written, stencil);
}

/* Tests a square, stencil first, and writes both. Returns the part of coverage that passed. */
GN_OUT_OF_LINE uint32_t test_stencil(const fragment_state *state, const fragment_place *at,
                                     bool back, uint32_t coverage, lanes_f depth)
{
    const stencil_state *face = &state->stencil[back ? 1 : 0];
    stored_block b = load_stored(&state->depth, at, coverage);
    uint32_t passed = coverage;
    uint32_t both;

    if (state->tests_stencil)
        passed &= compare_depth(&face->compare, lanes_i_splat(face->reference),
                                lanes_i_and(b.stencil, lanes_i_splat(face->compared)));
    both = passed;
    if (state->tests_depth) {
        const lanes_i incoming = quantize_depth(state->depth.format, depth, false);

        both &= compare_depth(&state->test, incoming, b.depth);
        if (state->test.write)
            b.depth = lanes_i_select(lanes_from_bits(both), incoming, b.depth);
    }
    if (state->tests_stencil) {
        b.stencil = update_stencil(face, &face->fail, coverage & ~passed, b.stencil);
        b.stencil = update_stencil(face, &face->depth_fail, passed & ~both, b.stencil);
        b.stencil = update_stencil(face, &face->pass, both, b.stencil);
    }
    store_stored(&state->depth, at, coverage, &b);
    return both;
}

#endif
