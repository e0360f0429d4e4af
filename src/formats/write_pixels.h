/* Stores pixels in which fragments replace only some pixels or some bits. */
#ifndef GN_FORMATS_WRITE_PIXELS_H
#define GN_FORMATS_WRITE_PIXELS_H

#include "pixel_rows.h"

/* Stores words of pixels where covered: the bits that are set in `written`, or all if it is null.
 * The layout is a constant. The words are overwritten. */
GN_INLINE void write_pixels(pixel_layout layout, const block_pixels *m, uint32_t coverage,
                            const int32_t *written, lanes_i word[4])
{
    const bool selects = m->in_surface && (!m->is_row || coverage != GN_ALL_LANES);
    lanes_i there[4];

    if (written || selects) {
        load_pixels(layout, m, coverage, there);
        for (int i = 0; i < layout_words(layout); ++i) {
            if (written)
                word[i] = lanes_i_or(lanes_i_and(word[i], lanes_i_splat(written[i])),
                                     lanes_i_and(there[i], lanes_i_splat(~written[i])));
            if (selects)
                word[i] = lanes_i_select(lanes_from_bits(coverage), word[i], there[i]);
        }
    }
    store_pixels(layout, m, coverage, word);
}

#endif
