/* Loads LANES pixels of a surface from memory into words, and stores them, by their layout.
 * Fragments, rows of surfaces and texels of blits are loaded and stored by these functions. */
#ifndef GN_FORMATS_PIXEL_ROWS_H
#define GN_FORMATS_PIXEL_ROWS_H

#include "../lanes/rows.h"
#include "../lanes/square.h"
#include "pixel_memory.h"
#include "surface_memory.h"

/* LANES pixels in memory: a row, which begins at half[0], or the two halves of a block, whose
 * rows are `stride` bytes apart. If `in_surface`, all pixels lie on the surface; otherwise only
 * covered ones are accessed. Loads do not write to them. */
typedef struct lane_pixels {
    bool is_row, in_surface;
    unsigned char *half[2];
    ptrdiff_t stride;
} lane_pixels;

/* Returns the memory of pixel (x, y) of a surface. It may lie outside the surface. */
GN_INLINE unsigned char *pixel_memory(const gn_surface *surface, pixel_layout layout, int32_t x,
                                      int32_t y)
{
    return address_of(surface_row(surface, (uint32_t)y), (uint32_t)x,
                      (ptrdiff_t)layout_bytes(layout));
}

/* Returns LANES pixels that lie side by side. */
GN_INLINE lane_pixels row_pixels(const unsigned char *pixels)
{
    const lane_pixels m = {true, true, {(unsigned char *)(uintptr_t)pixels, 0}, 0};

    return m;
}

/* Returns the memory of lane l's pixel. */
GN_INLINE unsigned char *lane_memory(pixel_layout layout, const lane_pixels *m, int l)
{
    const int size = (int)layout_bytes(layout);

    return m->is_row
               ? m->half[0] + l * size
               : address_of(m->half[l / HALF_LANES], (uint32_t)(l / SQUARE_SIZE % 2), m->stride) +
                     l % SQUARE_SIZE * size;
}

/* Finds the four rows of four pixels, as lanes/rows.h takes them. */
GN_INLINE void find_pixel_rows(pixel_layout layout, const lane_pixels *m, unsigned char *row[4])
{
    for (int r = 0; r < LANES / SQUARE_SIZE; ++r)
        row[r] = lane_memory(layout, m, r * SQUARE_SIZE);
}

/* Exchanges the bytes of shorts. */
GN_INLINE lanes_i exchanged_bytes(lanes_i a)
{
    const lanes_i low = lanes_i_splat(0xFF);

    return lanes_i_or(lanes_i_and(lanes_i_shift_right(a, 8), low),
                      lanes_i_shift_left(lanes_i_and(a, low), 8));
}

/* Loads covered pixels one by one; other lanes are 0. */
GN_INLINE void load_each(pixel_layout layout, const lane_pixels *m, uint32_t coverage,
                         lanes_i word[4])
{
    GN_ALIGNED_LANES int32_t loaded[4][LANES];

    GN_EACH_LANE (l) {
        int32_t pixel[4];

        for (int i = 0; i < 4; ++i) /* compilers make no call of memset of this */
            pixel[i] = 0;
        if (coverage >> l & 1u)
            load_pixel(lane_memory(layout, m, l), 0, layout, pixel);
        for (int i = 0; i < 4; ++i)
            loaded[i][l] = pixel[i];
    }
    for (int i = 0; i < layout_words(layout); ++i)
        word[i] = lanes_i_load(loaded[i]);
}

/* Stores covered pixels one by one. */
GN_INLINE void store_each(pixel_layout layout, const lane_pixels *m, uint32_t coverage,
                          const lanes_i word[4])
{
    GN_ALIGNED_LANES int32_t stored[4][LANES];

    for (int i = 0; i < layout_words(layout); ++i)
        lanes_i_store(stored[i], word[i]);
    GN_EACH_LANE (l) {
        int32_t pixel[4];

        for (int i = 0; i < 4; ++i)
            pixel[i] = i < layout_words(layout) ? stored[i][l] : 0;
        if (coverage >> l & 1u)
            store_pixel(lane_memory(layout, m, l), 0, layout, pixel);
    }
}

/* load_each and store_each out of line. */
GN_OUT_OF_LINE void load_covered(pixel_layout layout, const lane_pixels *m, uint32_t coverage,
                                 lanes_i word[4])
{
    load_each(layout, m, coverage, word);
}

GN_OUT_OF_LINE void store_covered(pixel_layout layout, const lane_pixels *m, uint32_t coverage,
                                  const lanes_i word[4])
{
    store_each(layout, m, coverage, word);
}

/* Loads pixels: all of them if they lie on the surface, otherwise the covered ones. The layout is a
 * constant. load_covered gets copies, so that the values here stay in registers. */
GN_INLINE void load_pixels(pixel_layout layout, const lane_pixels *m, uint32_t coverage,
                           lanes_i word[4])
{
    unsigned char *row[4];

    if (!m->in_surface) {
        const lane_pixels pixels = *m;
        lanes_i loaded[4];

        load_covered(layout, &pixels, coverage, loaded);
        for (int i = 0; i < layout_words(layout); ++i)
            word[i] = loaded[i];
        return;
    }
    find_pixel_rows(layout, m, row);
    if (layout == LAYOUT_WORD)
        word[0] = m->is_row ? lanes_i_load((const stored_word *)(const void *)m->half[0])
                            : lanes_i_load_block(m->half[0], m->half[1], m->stride);
    else if (layout == LAYOUT_BYTE)
        word[0] = lanes_i_load_bytes(row);
    else if (layout == LAYOUT_SHORT)
        word[0] = lanes_i_load_shorts(row);
#if GN_LANES_HAVE_PAIRS
    else if (layout == LAYOUT_SHORT_HIGH_FIRST)
        word[0] = exchanged_bytes(lanes_i_load_shorts(row));
    else if (layout == LAYOUT_THREE_BYTES)
        word[0] = lanes_i_load_threes(row);
    else if (layout == LAYOUT_FOUR_SHORTS || layout == LAYOUT_TWO_WORDS)
        lanes_i_load_pairs(row, &word[0], &word[1]);
    else if (layout == LAYOUT_THREE_WORDS)
        lanes_i_load_triples(row, word);
    else if (layout == LAYOUT_FOUR_WORDS)
        lanes_i_load_fours(row, word);
#endif
    else
        load_each(layout, m, GN_ALL_LANES, word);
}

/* Stores pixels as load_pixels loads them. */
GN_INLINE void store_pixels(pixel_layout layout, const lane_pixels *m, uint32_t coverage,
                            const lanes_i word[4])
{
    unsigned char *row[4];

    if (!m->in_surface) {
        const lane_pixels pixels = *m;
        lanes_i stored[4];

        for (int i = 0; i < layout_words(layout); ++i)
            stored[i] = word[i];
        store_covered(layout, &pixels, coverage, stored);
        return;
    }
    find_pixel_rows(layout, m, row);
    if (layout == LAYOUT_WORD && m->is_row)
        lanes_i_store((stored_word *)(void *)m->half[0], word[0]);
    else if (layout == LAYOUT_WORD)
        lanes_i_store_block(m->half[0], m->half[1], m->stride, word[0]);
    else if (layout == LAYOUT_BYTE)
        lanes_i_store_bytes(row, word[0]);
    else if (layout == LAYOUT_SHORT)
        lanes_i_store_shorts(row, word[0]);
#if GN_LANES_HAVE_PAIRS
    else if (layout == LAYOUT_SHORT_HIGH_FIRST)
        lanes_i_store_shorts(row, exchanged_bytes(word[0]));
    else if (layout == LAYOUT_THREE_BYTES)
        lanes_i_store_threes(row, word[0]);
    else if (layout == LAYOUT_FOUR_SHORTS || layout == LAYOUT_TWO_WORDS)
        lanes_i_store_pairs(row, word[0], word[1]);
    else if (layout == LAYOUT_THREE_WORDS)
        lanes_i_store_triples(row, word);
    else if (layout == LAYOUT_FOUR_WORDS)
        lanes_i_store_fours(row, word);
#endif
    else
        store_each(layout, m, GN_ALL_LANES, word);
}

/* Loads LANES pixels: lane l is the pixel row[l] + column[l] bytes after `pixels`. */
GN_INLINE void gather_pixels(pixel_layout layout, const unsigned char *pixels,
                             const ptrdiff_t row[LANES], const int32_t column[LANES],
                             lanes_i word[4])
{
    int32_t loaded[4][LANES];

    GN_EACH_LANE (l) {
        int32_t pixel[4];

        load_pixel(pixels + row[l] + column[l], 0, layout, pixel);
        for (int i = 0; i < layout_words(layout); ++i)
            loaded[i][l] = pixel[i];
    }
    for (int i = 0; i < layout_words(layout); ++i)
        word[i] = lanes_i_load(loaded[i]);
}

/* Whether load_pixel_pairs knows a layout. */
GN_INLINE bool layout_has_pairs(pixel_layout layout)
{
    return GN_LANES_HAVE_PAIRS &&
           (layout == LAYOUT_SHORT || layout == LAYOUT_WORD || layout == LAYOUT_FOUR_SHORTS);
}

/* Loads 2 * LANES pixels that lie side by side: the even ones are `left`, the odd ones
 * `right`. */
GN_INLINE void load_pixel_pairs(pixel_layout layout, const unsigned char *pixels, lanes_i left[4],
                                lanes_i right[4])
{
#if GN_LANES_HAVE_PAIRS
    const lane_pixels m = row_pixels(pixels);
    uint32_t offset[LANES];
    lanes_i word[4];

    if (layout == LAYOUT_FOUR_SHORTS) {
        GN_EACH_LANE (l)
            offset[l] = 16u * (uint32_t)l;
        lanes_i_gather_rows(pixels, offset, 1, word);
        left[0] = word[0];
        left[1] = word[1];
        right[0] = word[2];
        right[1] = word[3];
    } else if (layout == LAYOUT_WORD) {
        load_pixels(LAYOUT_TWO_WORDS, &m, GN_ALL_LANES, word);
        left[0] = word[0];
        right[0] = word[1];
    } else {
        load_pixels(LAYOUT_WORD, &m, GN_ALL_LANES, word);
        left[0] = lanes_i_and(word[0], lanes_i_splat(0xFFFF));
        right[0] = lanes_i_and(lanes_i_shift_right(word[0], 16), lanes_i_splat(0xFFFF));
    }
#else
    (void)layout;
    (void)pixels;
    (void)left;
    (void)right;
#endif
}

/* Whether a colour format of a layout is compiled. */
GN_INLINE bool layout_has_colors(pixel_layout layout)
{
#define IS_OF_LAYOUT(name, of, kind, ...)                                                          \
    || (layout == LAYOUT_##of && FORMAT_##kind == FORMAT_COLOR &&                                  \
        format_is_compiled(GN_FORMAT_##name))
    return false GN_FORMATS(IS_OF_LAYOUT);
#undef IS_OF_LAYOUT
}

/* Calls FUNCTION(layout) with a constant for the layout of a colour. */
#define CASE_OF_LAYOUT(FUNCTION, name, bytes, element)                                             \
    case LAYOUT_##name:                                                                            \
        if (layout_has_colors(LAYOUT_##name)) {                                                    \
            FUNCTION(LAYOUT_##name);                                                               \
        }                                                                                          \
        break;
#define GN_EACH_COLOR_LAYOUT(layout, FUNCTION)                                                     \
    switch (layout) {                                                                              \
        PIXEL_LAYOUTS(CASE_OF_LAYOUT, FUNCTION)                                                    \
    default:                                                                                       \
        break;                                                                                     \
    }

#endif
