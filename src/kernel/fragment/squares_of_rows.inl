/* Squares of a batch of rows. A shader receives squares, for its derivatives; tests and outputs are
 * faster for rows. So a shader's batch of rows is shaded in squares: each column of 16 pixels has
 * SQUARES_IN_ROW squares, and lanes 4r to 4r + 3 of a square are part of row r. Squares are
 * numbered from left to right. */
#ifndef GN_KERNEL_FRAGMENT_SQUARES_OF_ROWS_INL
#define GN_KERNEL_FRAGMENT_SQUARES_OF_ROWS_INL

#include "batch.inl"

/* Returns how many squares a batch of rows has. */
static inline uint32_t square_count(const fragment_batch *b)
{
    return b->columns * SQUARES_IN_ROW;
}

/* Returns the block of the batch that holds row r of a square. */
static inline uint32_t row_of_square(const fragment_batch *b, uint32_t square, uint32_t r)
{
    return r * b->columns + square / SQUARES_IN_ROW;
}

/* Returns the first lane of a row that is in a square. */
static inline uint32_t first_of_square(uint32_t square)
{
    return square % SQUARES_IN_ROW * SQUARE_SIZE;
}

#define SQUARE_ROW_COVERED ((1u << SQUARE_SIZE) - 1u)

/* Returns whether all pixels of a batch's rows are covered. */
static inline bool is_covered_wholly(const fragment_batch *b, const uint32_t *rows)
{
    uint32_t all = GN_ALL_LANES;

    for (uint32_t n = 0; n < b->count; ++n)
        all &= rows[n];
    return all == GN_ALL_LANES;
}

/* Returns a square's part of the coverage of rows. */
static inline uint32_t covered_in_square(const fragment_batch *b, const uint32_t *rows,
                                         uint32_t square)
{
    uint32_t coverage = 0;

    for (uint32_t r = 0; r < SQUARE_SIZE; ++r)
        coverage |=
            (rows[row_of_square(b, square, r)] >> first_of_square(square) & SQUARE_ROW_COVERED)
            << r * SQUARE_SIZE;
    return coverage;
}

/* Removes a square's fragments that are not kept from the coverage of rows. */
static inline void discard_in_square(const fragment_batch *b, uint32_t *rows, uint32_t square,
                                     uint32_t kept)
{
    for (uint32_t r = 0; kept != GN_ALL_LANES && r < SQUARE_SIZE; ++r)
        rows[row_of_square(b, square, r)] &=
            ~((~kept >> r * SQUARE_SIZE & SQUARE_ROW_COVERED) << first_of_square(square));
}

/* Stores a square's words in the rows that hold them. Each row is an array of lanes. */
GN_INLINE void store_square(void *rows, const fragment_batch *b, uint32_t square, lanes_i a)
{
    const size_t row_size = LANES * sizeof(int32_t);
    const ptrdiff_t stride = (ptrdiff_t)(b->columns * row_size);
    unsigned char *const lower = (unsigned char *)rows + row_of_square(b, square, 0) * row_size +
                                 first_of_square(square) * sizeof(int32_t);

    lanes_i_store_block(lower, lower + SQUARE_SIZE / 2 * stride, stride, a);
}

#endif
