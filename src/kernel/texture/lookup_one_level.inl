/* Lookups in a 2D texture of one level, of GN_FORMAT_RGBA8 or (GN_SIMPLE_ANY) another format that
 * is_simple allows, that repeats or is clamped to its edge: the choice of the filter, the fetch and
 * the filter (OpenGL 4.5 sections 8.14 and 8.15), in the order of operations of the reference
 * rasterizer. lookup.inl handles all others; lookup_rgba8_levels.inl uses the filters of this file.
 */
#ifndef GN_KERNEL_TEXTURE_LOOKUP_ONE_LEVEL_INL
#define GN_KERNEL_TEXTURE_LOOKUP_ONE_LEVEL_INL

#include "../../config/features.h"
#include "../../formats/pixel_memory.h"
#include "../../formats/unorm.h"
#include "../../lanes/derivative.h"
#include "../../texture/lookup_kernels.h"
#include "wrap.inl"

static inline lanes_i word_index(const gn_texture *texture, uint32_t level, lanes_i column,
                                 lanes_i row)
{
    const int32_t words_per_row = (int32_t)(texture->level[level].row_stride / 4);

    return lanes_i_add(lanes_i_mul_short(row, words_per_row), column);
}

static inline lanes_f mix(lanes_f weight, lanes_f a, lanes_f b)
{
    return lanes_add(a, lanes_mul(weight, lanes_sub(b, a)));
}

/* The four texels around a coordinate, in the order in which they are mixed. */
enum { CORNER_00, CORNER_10, CORNER_01, CORNER_11, CORNER_COUNT };

#if GN_SIMPLE_ANY

/* Fetches texel by texel, from a texture with format_is_565. */
GN_OUT_OF_LINE void fetch_565(const gn_texture *texture, const lanes_i *column, const lanes_i *row,
                              lanes_f texel[4])
{
    const pixel_layout layout = format_layout(texture->format);
    const unsigned char *const texels = (const unsigned char *)texture->level[0].texels;
    int32_t s[LANES], t[LANES], packed[LANES];

    lanes_i_store(s, *column);
    lanes_i_store(t, *row);
    GN_EACH_LANE (l) {
        int32_t word[4];

        load_pixel(texels + (ptrdiff_t)t[l] * texture->level[0].row_stride, s[l], layout, word);
        packed[l] = word[0];
    }
    texel[0] = unorm_channel(lanes_i_load(packed), 11, 5);
    texel[1] = unorm_channel(lanes_i_load(packed), 5, 6);
    texel[2] = unorm_channel(lanes_i_load(packed), 0, 5);
    texel[3] = lanes_splat(1.0f);
}

/* Fetches texel by texel, from every simple texture. */
GN_OUT_OF_LINE void fetch_any(const gn_texture *texture, const lanes_i *column, const lanes_i *row,
                              lanes_f texel[4])
{
    const unsigned char *const texels = (const unsigned char *)texture->level[0].texels;
    const int words = texture->format == GN_FORMAT_RGBA8 ? 1 : 4;
    int32_t s[LANES], t[LANES];
    int32_t word[4][LANES];

    if (!GN_HAVE_TEXTURES && format_is_565(texture->format)) {
        fetch_565(texture, column, row, texel);
        return;
    }
    lanes_i_store(s, *column);
    lanes_i_store(t, *row);
    GN_EACH_LANE (l) {
        const stored_word *const line =
            (const stored_word *)(const void *)(texels +
                                                (ptrdiff_t)t[l] * texture->level[0].row_stride);

        for (int n = 0; n < words; ++n)
            word[n][l] = line[words * s[l] + n];
    }
    for (int c = 0; c < 4; ++c)
        texel[c] = words == 1 ? lanes_unpack_unorm8(lanes_i_load(word[0]), c)
                              : lanes_as_float(lanes_i_load(word[c]));
}

GN_OUT_OF_LINE void lookup_linear_any(const gn_texture *texture, const gn_sampler *sampler,
                                      const lanes_f *s, const lanes_f *t, lanes_f texel[4])
{
    const texel_pair u = wrap_linear(
        sampler->wrap_s, repeats_by_mask(sampler->wrap_s, texture->width), *s, texture->width);
    const texel_pair v = wrap_linear(
        sampler->wrap_t, repeats_by_mask(sampler->wrap_t, texture->height), *t, texture->height);
    const lanes_i right = second_texel(sampler->wrap_s, &u);
    const lanes_i above = second_texel(sampler->wrap_t, &v);
    lanes_f corner[CORNER_COUNT][4];

    fetch_any(texture, &u.first, &v.first, corner[CORNER_00]);
    fetch_any(texture, &right, &v.first, corner[CORNER_10]);
    fetch_any(texture, &u.first, &above, corner[CORNER_01]);
    fetch_any(texture, &right, &above, corner[CORNER_11]);
    for (int c = 0; c < 4; ++c)
        texel[c] = mix(v.weight, mix(u.weight, corner[CORNER_00][c], corner[CORNER_10][c]),
                       mix(u.weight, corner[CORNER_01][c], corner[CORNER_11][c]));
}

#endif

/* Looks up a level, which is 0 if the texels are no words. */
GN_OUT_OF_LINE void lookup_nearest(const gn_texture *texture, uint32_t level,
                                   const gn_sampler *sampler, const lanes_f *s, const lanes_f *t,
                                   lanes_f texel[4])
{
    const lanes_i column =
        wrap_nearest(sampler->wrap_s, repeats_by_mask(sampler->wrap_s, texture->width), *s,
                     size_of_level(texture->width, level));
    const lanes_i row =
        wrap_nearest(sampler->wrap_t, repeats_by_mask(sampler->wrap_t, texture->height), *t,
                     size_of_level(texture->height, level));

#if GN_SIMPLE_ANY
    if (!has_rgba8_words(texture, 0)) {
        fetch_any(texture, &column, &row, texel);
        return;
    }
#endif
    const lanes_i packed = lanes_i_gather((const stored_word *)texture->level[level].texels,
                                          word_index(texture, level, column, row));
    texel[0] = lanes_unpack_unorm8(packed, 0);
    texel[1] = lanes_unpack_unorm8(packed, 1);
    texel[2] = lanes_unpack_unorm8(packed, 2);
    texel[3] = lanes_unpack_unorm8(packed, 3);
}

/* Returns the words of the nearest texels, as lookup_nearest finds them. */
GN_INLINE lanes_i nearest_words(const masked_words *m, lanes_f s, lanes_f t)
{
    const lanes_i column = lanes_i_and(lanes_floor_to_int(lanes_mul(s, lanes_splat(m->width))),
                                       lanes_i_splat(m->last_column));
    const lanes_i row = lanes_i_and(lanes_floor_to_int(lanes_mul(t, lanes_splat(m->height))),
                                    lanes_i_splat(m->last_row));

    return lanes_i_gather((const stored_word *)m->words,
                          lanes_i_add(lanes_i_mul(row, lanes_i_splat(m->words_per_row)), column));
}

/* The words of four texels around a coordinate, and the weights of the second ones. */
typedef struct word_corners {
    lanes_i corner[CORNER_COUNT];
    lanes_f weight_s, weight_t;
} word_corners;

/* Fetches the words of four texels, if a lane is at an end. Where a column is clamped at the end,
 * both texels of a row are the last one, which is the right one of the last two. */
GN_OUT_OF_LINE void fetch_at_ends(const gn_texture *texture, uint32_t level,
                                  const gn_sampler *sampler, const texel_pair *u,
                                  const texel_pair *v, lanes_i corner[CORNER_COUNT])
{
    const stored_word *const words = (const stored_word *)texture->level[level].texels;
    const uint32_t width = size_of_level(texture->width, level);
    const lanes_i row[2] = {v->first, second_texel(sampler->wrap_t, v)};
    lanes_i column[2];

    if (GN_STATES_SPECIALISED && width > 1 &&
        (sampler->wrap_s != GN_WRAP_REPEAT || lanes_bits(u->at_end) == 0)) {
        column[0] = lanes_i_add(u->first, lanes_m_as_int(u->at_end)); /* minus 1 there */
        for (int i = 0; i < CORNER_COUNT; i += 2) {
            lanes_i left, right;

            lanes_i_gather_pairs(words, word_index(texture, level, column[0], row[i >> 1]), &left,
                                 &right);
            corner[i] = lanes_i_select(u->at_end, right, left);
            corner[i + 1] = right;
        }
        return;
    }
    column[0] = u->first;
    column[1] = second_texel(sampler->wrap_s, u);
    for (int i = 0; i < CORNER_COUNT; ++i)
        corner[i] = lanes_i_gather(words, word_index(texture, level, column[i & 1], row[i >> 1]));
}

/* Fetches the words of the four texels of a level. If no lane is at an end, the two texels of a row
 * are neighbours in memory. */
GN_WIDE_INLINE void fetch_corners(const gn_texture *texture, uint32_t level,
                                  const gn_sampler *sampler, const lanes_f *s, const lanes_f *t,
                                  word_corners *out)
{
    const stored_word *const words = (const stored_word *)texture->level[level].texels;
    const texel_pair u =
        wrap_linear(sampler->wrap_s, repeats_by_mask(sampler->wrap_s, texture->width), *s,
                    size_of_level(texture->width, level));
    const texel_pair v =
        wrap_linear(sampler->wrap_t, repeats_by_mask(sampler->wrap_t, texture->height), *t,
                    size_of_level(texture->height, level));
    const lanes_i at_end = lanes_i_or(lanes_m_as_int(u.at_end), lanes_m_as_int(v.at_end));

    out->weight_s = u.weight;
    out->weight_t = v.weight;
    if (lanes_i_sign_bits(at_end) == 0) {
        const lanes_i index = word_index(texture, level, u.first, v.first);

        lanes_i_gather_pairs(words, index, &out->corner[CORNER_00], &out->corner[CORNER_10]);
        lanes_i_gather_pairs(words + texture->level[level].row_stride / 4, index,
                             &out->corner[CORNER_01], &out->corner[CORNER_11]);
    } else {
        texel_pair along_s, along_t; /* copies: the pairs themselves stay in registers */
        lanes_i corner[CORNER_COUNT];

        along_s.first = u.first;
        along_s.at_end = u.at_end;
        along_t.first = v.first;
        along_t.at_end = v.at_end;
        fetch_at_ends(texture, level, sampler, &along_s, &along_t, corner);
        for (int i = 0; i < CORNER_COUNT; ++i)
            out->corner[i] = corner[i];
    }
}

/* Returns one channel of the four texels, mixed. The channel must be a constant. */
GN_INLINE lanes_f mix_corners(const lanes_i corner[CORNER_COUNT], int channel, lanes_f u, lanes_f v)
{
    const lanes_f below = mix(u, lanes_unpack_unorm8(corner[CORNER_00], channel),
                              lanes_unpack_unorm8(corner[CORNER_10], channel));
    const lanes_f above = mix(u, lanes_unpack_unorm8(corner[CORNER_01], channel),
                              lanes_unpack_unorm8(corner[CORNER_11], channel));

    return mix(v, below, above);
}

/* The arrays that calls write to are separate from `texel`, because such arrays stay in memory
 * instead of registers. */
GN_INLINE void lookup_linear_inline(const gn_texture *texture, uint32_t level,
                                    const gn_sampler *sampler, const lanes_f *s, const lanes_f *t,
                                    lanes_f texel[4])
{
#if GN_SIMPLE_ANY
    if (!has_rgba8_words(texture, 0)) {
        lanes_f any[4];

        lookup_linear_any(texture, sampler, s, t, any);
        for (int c = 0; c < 4; ++c)
            texel[c] = any[c];
        return;
    }
#endif

    word_corners w;
    fetch_corners(texture, level, sampler, s, t, &w);
    texel[0] = mix_corners(w.corner, 0, w.weight_s, w.weight_t);
    texel[1] = mix_corners(w.corner, 1, w.weight_s, w.weight_t);
    texel[2] = mix_corners(w.corner, 2, w.weight_s, w.weight_t);
    texel[3] = mix_corners(w.corner, 3, w.weight_s, w.weight_t);
}

/* Looks up a level, which is 0 if the texels are no words. */
GN_OUT_OF_LINE void lookup_linear(const gn_texture *texture, uint32_t level,
                                  const gn_sampler *sampler, const lanes_f *s, const lanes_f *t,
                                  lanes_f texel[4])
{
    lookup_linear_inline(texture, level, sampler, s, t, texel);
}

/* Returns the footprint of each quad's lower left lane: the greater of the squared lengths of the
 * derivatives, in texels; that along y if either is NaN. */
static inline lanes_f footprint_of_quads(const gn_texture *texture, lanes_f s, lanes_f t)
{
    const lanes_f width = lanes_splat((float)texture->width);
    const lanes_f height = lanes_splat((float)texture->height);
    const lanes_f s_along_x = lanes_mul(derivative_x(s), width);
    const lanes_f s_along_y = lanes_mul(derivative_y(s), width);
    const lanes_f t_along_x = lanes_mul(derivative_x(t), height);
    const lanes_f t_along_y = lanes_mul(derivative_y(t), height);
    const lanes_f x = lanes_add(lanes_mul(s_along_x, s_along_x), lanes_mul(t_along_x, t_along_x));
    const lanes_f y = lanes_add(lanes_mul(s_along_y, s_along_y), lanes_mul(t_along_y, t_along_y));

    return of_first_in_quad(lanes_max(x, y));
}

/* Returns the lanes in which the texture is minified: the footprint of their quad is above 1 or
 * NaN. Out of line, so that callers need less stack. */
GN_OUT_OF_LINE uint32_t minified_lanes(const gn_texture *texture, const lanes_f *s,
                                       const lanes_f *t)
{
    return lanes_bits(
        lanes_not(lanes_less_equal(footprint_of_quads(texture, *s, *t), lanes_splat(1.0f))));
}

/* Returns the lanes, as bits, that use the linear filter. */
static inline uint32_t linear_lanes(const gn_texture *texture, const gn_sampler *sampler,
                                    const lanes_f *s, const lanes_f *t)
{
    if (has_one_filter(sampler) || LANES == 1) /* one lane has no derivatives */
        return sampler->magnify == GN_MAGNIFY_LINEAR ? GN_ALL_LANES : 0;

    const uint32_t minified = minified_lanes(texture, s, t);
    return minifies_linearly(sampler->minify) ? minified : ~minified & GN_ALL_LANES;
}

GN_OUT_OF_LINE void lookup_both(const gn_texture *texture, const gn_sampler *sampler,
                                const lanes_f *s, const lanes_f *t, uint32_t linear_lanes,
                                lanes_f texel[4])
{
    const lanes_m use_linear = lanes_from_bits(linear_lanes);
    lanes_f linear[4], nearest[4];

    lookup_linear(texture, 0, sampler, s, t, linear);
    lookup_nearest(texture, 0, sampler, s, t, nearest);
    for (int c = 0; c < 4; ++c)
        texel[c] = lanes_select(use_linear, linear[c], nearest[c]);
}

/* Looks up 16 places. The lanes must be those of a block, unless has_one_filter is true. */
static inline void lookup_one_level(const gn_texture *texture, const gn_sampler *sampler,
                                    const lanes_f *s, const lanes_f *t, lanes_f texel[4])
{
    const uint32_t linear = linear_lanes(texture, sampler, s, t);

    if (linear == GN_ALL_LANES)
        lookup_linear(texture, 0, sampler, s, t, texel);
    else if (linear == 0)
        lookup_nearest(texture, 0, sampler, s, t, texel);
    else
        lookup_both(texture, sampler, s, t, linear, texel);
}

#endif
