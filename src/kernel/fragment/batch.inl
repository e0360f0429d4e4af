/* A batch: the blocks that take the steps of a state together, and what one step leaves for the
 * next. A step is one loop over the blocks, in which everything that is constant over a draw is
 * known beforehand. A state takes some of the steps, in this order:
 *
 *   test     depth and stencil; leaves the fragments that passed (test.inl)
 *   source   colours, by the fragment shader or inlined (source.inl)
 *   encode   colours as the numbers in which the attachment's format is blended (output.inl)
 *   load     the attachment's pixels as such numbers
 *   combine  encoded and loaded numbers, by blending or a logical operation (combine.inl)
 *   store    numbers as pixels of the format, where covered and written
 *
 * If the shader decides on coverage or depth, source comes before test. Tests, and load to store,
 * run once for each sample of a multisampled target, and encode to store for each attachment.
 *
 * A batch is of halves (blocks at the edges of triangles, and small triangles) or of rows (the
 * inside of large triangles). The fragment shader receives rows as squares (squares_of_rows.inl).
 *
 * Blocks of a batch may overlap where they are of different triangles. A step keeps the order of
 * triangles, since it takes block by block and accesses one attachment only. Where load and store
 * are two steps, a batch has blocks of one triangle, which do not overlap. */
#ifndef GN_KERNEL_FRAGMENT_BATCH_INL
#define GN_KERNEL_FRAGMENT_BATCH_INL

#include "pixels.inl"

/* The most blocks of a batch. Their arrays, 1 KiB a block, stay in the first-level cache. Where
 * operations on lanes are loops, a step costs little beside them, so few blocks save stack. */
#if !GN_STATES_SPECIALISED
#define STEP_BLOCKS 1
#elif defined(GN_LANES_ARRAYS)
#define STEP_BLOCKS 4
#else
#define STEP_BLOCKS 16
#endif

/* The columns of blocks in a batch of rows. */
#define STEP_COLUMNS (STEP_BLOCKS / SQUARE_SIZE > 0 ? STEP_BLOCKS / SQUARE_SIZE : 1)

/* The squares across a row of 16 pixels. */
#define SQUARES_IN_ROW (LANES / SQUARE_SIZE)

/* Colours of a batch: one for each block and attachment. There is room for the squares across a row
 * with all attachments; where few blocks save stack, for one square. */
#define LEAST_COLORS (STEP_BLOCKS < 16 ? COLOR_LIMIT : SQUARES_IN_ROW * COLOR_LIMIT)
#define STEP_COLORS (STEP_BLOCKS > LEAST_COLORS ? STEP_BLOCKS : LEAST_COLORS)

typedef struct fragment_batch {
    fragment_shape shape;
    uint32_t count;
    uint32_t coverage[STEP_BLOCKS];

    raster_primitive primitive; /* of rows; of halves only the set-up */

    /* Halves. */
    const covered_block *blocks;

    /* Rows: block n is at column[n] and row[n] of the terms, which are n % columns and n / columns
     * until rows are removed (compact_batch). */
    int32_t x, y;
    uint32_t columns;
    uint8_t column[STEP_BLOCKS], row[STEP_BLOCKS];
    bool w_per_row;               /* w is the same in every column */
    uint16_t shaded[STEP_BLOCKS]; /* the lanes of each square that were shaded */

    /* Results of steps, by lanes. The numbers of a colour are its bytes in the first word, its
     * shorts in two words, or its floats in four. The steps from load on use neither terms nor
     * depths, so stored numbers share their memory. */
    GN_ALIGNED_LANES float color[STEP_COLORS][4][GN_LANES];
    GN_ALIGNED_LANES int32_t source[4][STEP_BLOCKS][LANES];
    GN_ALIGNED_LANES union {
        struct {
            column_terms columns[STEP_COLUMNS];
            row_terms rows;
            float w[SQUARE_SIZE]; /* of each row, if w_per_row is set */
            float depth[STEP_BLOCKS][GN_LANES];
        } terms;
        int32_t stored[4][STEP_BLOCKS][LANES];
    } shared;
} fragment_batch;

/* Whether a batch is of rows: not where states have no functions of their own. */
static inline bool is_of_rows(const fragment_batch *b)
{
    return GN_STATES_SPECIALISED && b->shape == SHAPE_ROW;
}

/* Returns the triangle of block n. */
GN_INLINE raster_primitive batch_primitive(const fragment_batch *b, fragment_shape shape,
                                           uint32_t n)
{
    return shape == SHAPE_ROW ? b->primitive : primitive_in(b->primitive.setup, b->blocks[n].lane);
}

/* Sets the place of block n. `shape` is the batch's, as a constant where loops need speed. `inside`
 * is null, or where in their pixels the attributes of halves are needed (set_places). */
GN_INLINE void set_batch_place(const fragment_state *state, const fragment_batch *b,
                               fragment_shape shape, uint32_t n, const float *inside,
                               fragment_place *at)
{
    if (shape == SHAPE_ROW) {
        at->shape = SHAPE_ROW;
        at->in_surface = true;
        at->block.x[0] = b->x + b->column[n] * LANES;
        at->block.y[0] = b->y + b->row[n];
        at->columns = &b->shared.terms.columns[b->column[n]];
        at->row = b->shared.terms.rows.value[b->row[n]];
        at->w = 0;
        return;
    }
    at->shape = SHAPE_HALVES;
    at->block = b->blocks[n].at;
    at->in_surface = surfaces_hold_block(state, &at->block);
    set_places(&at->places, &at->block, inside);
}

/* Returns the pixels of block n on a surface. */
GN_INLINE lane_pixels batch_pixels(const fragment_state *state, const fragment_batch *b,
                                   fragment_shape shape, uint32_t n, const gn_surface *surface,
                                   pixel_layout layout)
{
    fragment_place at;

    set_batch_place(state, b, shape, n, 0, &at);
    return pixels_at(&at, surface, layout);
}

#endif
