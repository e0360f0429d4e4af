/* The stencil test, and after it the depth test, on surfaces that hold stencil (OpenGL 4.5 sections
 * 17.3.3 and 17.3.5). Stencil values are updated in place, in the byte of a pixel's words that
 * holds them, by operations on bytes. */
#ifndef GN_KERNEL_FRAGMENT_STENCIL_INL
#define GN_KERNEL_FRAGMENT_STENCIL_INL

#include "depth.inl"

/* Returns the word of a pixel that holds the stencil value. */
GN_INLINE int stencil_word(gn_format format)
{
    return format == GN_FORMAT_D32FS8 ? 1 : 0;
}

/* Returns an operation on the byte at bit `shift`. */
static inline stencil_update stencil_update_of(gn_stencil_operation operation, uint32_t reference,
                                               int shift)
{
    const bool sets = operation == GN_STENCIL_ZERO || operation == GN_STENCIL_REPLACE;
    stencil_update u;

    u.keeps = operation == GN_STENCIL_KEEP;
    u.mask = (sets ? 0u : 255u) << shift;
    u.toggled = (operation == GN_STENCIL_REPLACE  ? reference
                 : operation == GN_STENCIL_INVERT ? 255u
                                                  : 0u)
                << shift;
    u.increment = (operation == GN_STENCIL_INCREMENT ? 1u : 0u) << shift;
    u.decrement = (operation == GN_STENCIL_DECREMENT ? 1u : 0u) << shift;
    u.step = (operation == GN_STENCIL_INCREMENT_WRAP   ? 1u
              : operation == GN_STENCIL_DECREMENT_WRAP ? 255u
                                                       : 0u)
             << shift;
    return u;
}

static inline void set_stencil_state(stencil_state *s, const gn_stencil_face *face,
                                     gn_format format)
{
    const int shift = format == GN_FORMAT_D24S8 ? 24 : 0;

    s->compare = comparison_of(face->function == GN_COMPARE_DEFAULT ? GN_ALWAYS : face->function);
    s->compared = 255 & ~face->compare_disabled;
    s->reference = face->reference & s->compared;
    s->written = (255u & ~(uint32_t)face->write_disabled) << shift;
    s->fail = stencil_update_of(face->fail, face->reference, shift);
    s->depth_fail = stencil_update_of(face->depth_fail, face->reference, shift);
    s->pass = stencil_update_of(face->pass, face->reference, shift);
}

/* Updates the written bits of the stencil values in some lanes of `word`. */
GN_INLINE lanes_i update_stencil(const stencil_update *u, uint32_t written, lanes_m lanes,
                                 lanes_i word)
{
    if (u->keeps)
        return word;

    const lanes_i set = lanes_i_xor(lanes_i_and(word, lanes_i_splat((int32_t)u->mask)),
                                    lanes_i_splat((int32_t)u->toggled));
    const lanes_i clamped =
        lanes_i_sub_bytes(lanes_i_add_bytes(set, lanes_i_splat((int32_t)u->increment)),
                          lanes_i_splat((int32_t)u->decrement));
    const lanes_i result = lanes_i_add(clamped, lanes_i_splat((int32_t)u->step));
    const lanes_i changes = lanes_i_and(lanes_m_as_int(lanes), lanes_i_splat((int32_t)written));

    return lanes_i_xor(word, lanes_i_and(lanes_i_xor(word, result), changes));
}

/* Tests a block against a surface that holds stencil, stencil first, and writes both. Returns the
 * part of coverage that passed. In GN_FORMAT_D32FS8 the 24 bits beside stencil become 0 where
 * covered. */
GN_INLINE uint32_t test_stencil(const fragment_state *state, const comparison *test,
                                gn_format format, const fragment_place *at, bool back,
                                uint32_t coverage, lanes_f depth)
{
    const stencil_state *const face = &state->stencil[back ? 1 : 0];
    const pixel_layout layout = format_layout(format);
    const lane_pixels memory = pixels_at(at, &state->depth, layout);
    const lanes_i depth_bits = lanes_i_splat(format == GN_FORMAT_D24S8 ? 0xFFFFFF : -1);
    const lanes_m covered = lanes_from_bits(coverage);
    lanes_m passed = covered, both;
    lanes_i word[4];

    load_pixels(layout, &memory, coverage, word);
    lanes_i *const held = &word[stencil_word(format)];

    if (state->tests_stencil) {
        const lanes_i value = format == GN_FORMAT_D24S8 ? lanes_i_shift_right(word[0], 24) : *held;

        passed =
            lanes_and(passed, passing_lanes(&face->compare, lanes_i_splat(face->reference),
                                            lanes_i_and(value, lanes_i_splat(face->compared))));
    }
    both = passed;
    if (format_has_depth(format) && state->tests_depth) {
        const lanes_i incoming = quantize_depth(format, depth, false);

        both = lanes_and(passed, passing_lanes(test, incoming, lanes_i_and(word[0], depth_bits)));
        if (test->write)
            word[0] =
                lanes_i_xor(word[0], lanes_i_and(lanes_i_xor(word[0], incoming),
                                                 lanes_i_and(lanes_m_as_int(both), depth_bits)));
    }
    if (state->tests_stencil) {
        *held = update_stencil(&face->fail, face->written, lanes_and(covered, lanes_not(passed)),
                               *held);
        *held = update_stencil(&face->depth_fail, face->written, lanes_and(passed, lanes_not(both)),
                               *held);
        *held = update_stencil(&face->pass, face->written, both, *held);
    }
    if (format == GN_FORMAT_D32FS8)
        *held = lanes_i_select(covered, lanes_i_and(*held, lanes_i_splat(255)), *held);
    if (format == GN_FORMAT_D32FS8 || state->tests_stencil ||
        (state->tests_depth && test->write && lanes_bits(both)))
        store_pixels(layout, &memory, coverage, word);
    return lanes_bits(both);
}

#endif
