/* Loads and stores the pixels of sixteen fragments, as words (formats/pixel_memory.h). */
#ifndef GN_KERNEL_FRAGMENT_PIXELS_INL
#define GN_KERNEL_FRAGMENT_PIXELS_INL

#include "../../formats/pixel_rows.h"
#include "../../lanes/rows.h"
#include "planes.inl"

/* The pixels of a block on one surface, whose rows are `stride` bytes apart. Where `in_surface`,
 * all of them lie on the surface; otherwise only covered ones are accessed. */
typedef struct block_pixels {
    fragment_shape shape;
    bool in_surface;
    surface_place at;
    ptrdiff_t stride;
} block_pixels;

/* Returns the pixels of a block on a surface of the given format. */
GN_INLINE block_pixels memory_of(const fragment_place *at, const gn_surface *surface,
                                 gn_format format)
{
    block_pixels m;

    m.shape = at->shape;
    m.in_surface = at->in_surface;
    m.at = at->shape == SHAPE_ROW ? row_memory(surface, format, at->block.x[0], at->block.y[0])
                                  : block_memory(surface, format, &at->block);
    m.stride = surface->row_stride;
    return m;
}

/* Pixels that lie side by side in memory: all of a row, or a row of a block. */
#define PIXELS_TOGETHER(shape) ((shape) == SHAPE_ROW ? GN_LANES : SQUARE_SIZE)

/* Returns the memory of lane `first`, a multiple of PIXELS_TOGETHER. */
GN_INLINE unsigned char *lane_memory(const block_pixels *m, int first)
{
    return address_of(m->at.half[first / HALF_LANES], (uint32_t)(first / SQUARE_SIZE % 2),
                      m->stride);
}

/* Loads the words of a layout whose pixels are words. */
GN_INLINE lanes_i load_pixel_words(const block_pixels *m)
{
    return m->shape == SHAPE_ROW ? lanes_i_load((const stored_word *)(const void *)m->at.half[0])
                                 : lanes_i_load_block(m->at.half[0], m->at.half[1], m->stride);
}

GN_INLINE void store_pixel_words(const block_pixels *m, lanes_i a)
{
    if (m->shape == SHAPE_ROW)
        lanes_i_store((stored_word *)(void *)m->at.half[0], a);
    else
        lanes_i_store_block(m->at.half[0], m->at.half[1], m->stride, a);
}

/* Returns the bytes of a pixel of a layout. */
GN_INLINE int layout_bytes(pixel_layout layout)
{
    return layout == GN_LAYOUT(2, 1) ? 2 : layout == GN_LAYOUT(8, 4) ? 8 : (int)layout;
}

/* Finds the four rows of four pixels that a block is made of, or the one pixel of one lane; `size`
 * is the bytes of a pixel. */
GN_INLINE void find_pixel_rows(const block_pixels *m, int size, unsigned char *row[4])
{
    for (int r = 0; r < GN_LANES / SQUARE_SIZE; ++r)
        row[r] = m->shape == SHAPE_ROW ? m->at.half[0] + r * SQUARE_SIZE * size
                                       : lane_memory(m, r * SQUARE_SIZE);
}

/* Loads rows of four pixels, pixel by pixel. */
static inline void load_each(pixel_layout layout, unsigned char *const row[4], lanes_i word[4])
{
    GN_ALIGNED_LANES int32_t loaded[4][GN_LANES];

    GN_EACH_LANE (l) {
        int32_t pixel[4];

        load_pixel(row[l / SQUARE_SIZE], l % SQUARE_SIZE, layout, pixel);
        for (int i = 0; i < layout_words(layout); ++i)
            loaded[i][l] = pixel[i];
    }
    for (int i = 0; i < layout_words(layout); ++i)
        word[i] = lanes_i_load(loaded[i]);
}

static inline void store_each(pixel_layout layout, unsigned char *const row[4],
                              const lanes_i word[4])
{
    GN_ALIGNED_LANES int32_t stored[4][GN_LANES];

    for (int i = 0; i < layout_words(layout); ++i)
        lanes_i_store(stored[i], word[i]);
    GN_EACH_LANE (l) {
        int32_t pixel[4];

        for (int i = 0; i < layout_words(layout); ++i)
            pixel[i] = stored[i][l];
        store_pixel(row[l / SQUARE_SIZE], l % SQUARE_SIZE, layout, pixel);
    }
}

/* Loads a whole block. */
GN_INLINE void load_in_surface(pixel_layout layout, const block_pixels *m, lanes_i word[4])
{
    unsigned char *row[4];

    find_pixel_rows(m, layout_bytes(layout), row);
    if (layout == GN_LAYOUT(1, 1))
        word[0] = lanes_i_load_bytes(row);
    else if (layout == GN_LAYOUT(2, 2))
        word[0] = lanes_i_load_shorts(row);
#if GN_LANES_HAVE_PAIRS
    else if (layout == GN_LAYOUT(2, 1))
        word[0] = exchanged_bytes(lanes_i_load_shorts(row));
    else if (layout == GN_LAYOUT(3, 1))
        word[0] = lanes_i_load_threes(row);
    else if (layout == GN_LAYOUT(8, 2) || layout == GN_LAYOUT(8, 4))
        lanes_i_load_pairs(row, &word[0], &word[1]);
    else if (layout == GN_LAYOUT(16, 4))
        lanes_i_load_fours(row, word);
#endif
    else
        load_each(layout, row, word);
}

GN_INLINE void store_in_surface(pixel_layout layout, const block_pixels *m, const lanes_i word[4])
{
    unsigned char *row[4];

    find_pixel_rows(m, layout_bytes(layout), row);
    if (layout == GN_LAYOUT(1, 1))
        lanes_i_store_bytes(row, word[0]);
    else if (layout == GN_LAYOUT(2, 2))
        lanes_i_store_shorts(row, word[0]);
#if GN_LANES_HAVE_PAIRS
    else if (layout == GN_LAYOUT(2, 1))
        lanes_i_store_shorts(row, exchanged_bytes(word[0]));
    else if (layout == GN_LAYOUT(3, 1))
        lanes_i_store_threes(row, word[0]);
    else if (layout == GN_LAYOUT(8, 2) || layout == GN_LAYOUT(8, 4))
        lanes_i_store_pairs(row, word[0], word[1]);
    else if (layout == GN_LAYOUT(16, 4))
        lanes_i_store_fours(row, word);
#endif
    else
        store_each(layout, row, word);
}

/* Loads the covered pixels of a block; other lanes are 0. */
GN_OUT_OF_LINE void load_covered(pixel_layout layout, const block_pixels *m, uint32_t coverage,
                                 lanes_i word[4])
{
    GN_ALIGNED_LANES int32_t loaded[4][GN_LANES];

    GN_EACH_LANE (l) {
        int32_t pixel[4];

        for (int i = 0; i < 4; ++i) /* compilers make no call of memset of this */
            pixel[i] = 0;
        if (coverage >> l & 1u)
            load_pixel(lane_memory(m, l), l % SQUARE_SIZE, layout, pixel);
        for (int i = 0; i < 4; ++i)
            loaded[i][l] = pixel[i];
    }
    for (int i = 0; i < layout_words(layout); ++i)
        word[i] = lanes_i_load(loaded[i]);
}

/* Stores the covered pixels of a block. */
GN_OUT_OF_LINE void store_covered(pixel_layout layout, const block_pixels *m, uint32_t coverage,
                                  const lanes_i word[4])
{
    GN_ALIGNED_LANES int32_t stored[4][GN_LANES];

    for (int i = 0; i < layout_words(layout); ++i)
        lanes_i_store(stored[i], word[i]);
    GN_EACH_LANE (l) {
        int32_t pixel[4];

        for (int i = 0; i < 4; ++i)
            pixel[i] = i < layout_words(layout) ? stored[i][l] : 0;
        if (coverage >> l & 1u)
            store_pixel(lane_memory(m, l), l % SQUARE_SIZE, layout, pixel);
    }
}

/* Loads the pixels of a block: all of them, or the covered ones if the block hangs over. Whatever
 * is passed by address is a copy, so that the usual way keeps its values in registers. */
GN_INLINE void load_pixels(pixel_layout layout, const block_pixels *m, uint32_t coverage,
                           lanes_i word[4])
{
    if (!m->in_surface) {
        const block_pixels pixels = *m;
        lanes_i loaded[4];

        load_covered(layout, &pixels, coverage, loaded);
        for (int i = 0; i < layout_words(layout); ++i)
            word[i] = loaded[i];
    } else if (layout == GN_LAYOUT(4, 4)) {
        word[0] = load_pixel_words(m);
    } else {
        load_in_surface(layout, m, word);
    }
}

/* Stores the pixels of a block: all of them, or the covered ones if the block hangs over. */
GN_INLINE void store_pixels(pixel_layout layout, const block_pixels *m, uint32_t coverage,
                            const lanes_i word[4])
{
    if (!m->in_surface) {
        const block_pixels pixels = *m;
        lanes_i stored[4];

        for (int i = 0; i < layout_words(layout); ++i)
            stored[i] = word[i];
        store_covered(layout, &pixels, coverage, stored);
    } else if (layout == GN_LAYOUT(4, 4)) {
        store_pixel_words(m, word[0]);
    } else {
        store_in_surface(layout, m, word);
    }
}

/* Prefetches a block's memory, which is loaded after other work. */
GN_INLINE void prefetch_words(surface_place at, ptrdiff_t stride)
{
#if defined(__GNUC__)
    for (int half = 0; half < 2; ++half) {
        __builtin_prefetch(at.half[half], 1);
        __builtin_prefetch(address_of(at.half[half], 1, stride), 1);
    }
#else
    (void)at;
    (void)stride;
#endif
}

#endif
