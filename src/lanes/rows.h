/* Lanes of pixels that are no words of 32 bits: four rows of four pixels, which are bytes, shorts
 * or pairs of words. Rows lie anywhere in memory.
 *
 *   load_bytes store_bytes     one byte a pixel; stores take a lane's low 8 bits
 *   load_shorts store_shorts   one short a pixel, aligned; stores take a lane's low 16 bits
 *   load_pairs store_pairs     two words a pixel, aligned to shorts at least
 *   load_threes store_threes   three bytes a pixel; stores take a lane's low 24 bits
 *   load_triples store_triples three words a pixel
 *   load_fours store_fours     four words a pixel
 *
 * Registers (lanes_registers.h) that define register_i_load_rows_of_bytes and so on have all of
 * these. Others have loads and stores of bytes and shorts alone. */
#ifndef GN_LANES_ROWS_H
#define GN_LANES_ROWS_H

#include "lanes.h"

/* Whether there are loads and stores of pairs, threes and fours. They take the first word from the
 * lower address, as only little-endian processors have both pairs of shorts and pairs of words. */
#if defined(register_i_load_rows_of_bytes) && GN_IS_LITTLE_ENDIAN
#define GN_LANES_HAVE_PAIRS 1
#else
#define GN_LANES_HAVE_PAIRS 0
#endif

#if GN_LANES_HAVE_PAIRS

/* Row r of register n, from byte `at` on. */
#define LANES_PIXELS(r) row[REGISTER_ROWS * n + (r)]
#define LANES_PIXELS_AT(r) (row[REGISTER_ROWS * n + (r)] + at)

static inline lanes_i lanes_i_load_bytes(unsigned char *const row[4])
{
    LANES_EACH_REGISTER(lanes_i, register_i_load_rows_of_bytes(LANES_PIXELS));
}

static inline void lanes_i_store_bytes(unsigned char *const row[4], lanes_i a)
{
    LANES_FOR_REGISTERS(register_i_store_rows_of_bytes(LANES_PIXELS, a.q[n]))
}

static inline lanes_i lanes_i_load_shorts(unsigned char *const row[4])
{
    LANES_EACH_REGISTER(lanes_i, register_i_load_rows_of_shorts(LANES_PIXELS));
}

static inline void lanes_i_store_shorts(unsigned char *const row[4], lanes_i a)
{
    LANES_FOR_REGISTERS(register_i_store_rows_of_shorts(LANES_PIXELS, a.q[n]))
}

static inline lanes_i lanes_i_load_threes(unsigned char *const row[4])
{
    LANES_EACH_REGISTER(lanes_i, register_i_load_rows_of_threes(LANES_PIXELS));
}

static inline void lanes_i_store_threes(unsigned char *const row[4], lanes_i a){
    LANES_FOR_REGISTERS(register_i_store_rows_of_threes(LANES_PIXELS, a.q[n]))}

GN_OPERATION register_i register_i_load_rows_at(unsigned char *const row[4], int n, int at)
{
    return register_i_load_rows(LANES_PIXELS_AT);
}

GN_OPERATION void register_i_store_rows_at(unsigned char *const row[4], int n, int at, register_i a)
{
    register_i_store_rows(LANES_PIXELS_AT, a);
}

static inline void lanes_i_load_pairs(unsigned char *const row[4], lanes_i *first, lanes_i *second)
{
    GN_UNROLLED
    for (int n = 0; n < LANES_REGISTERS; ++n) {
        const register_f a = register_as_float(register_i_load_rows_at(row, n, 0));
        const register_f b = register_as_float(register_i_load_rows_at(row, n, 16));

        first->q[n] = register_as_int(register_even(a, b));
        second->q[n] = register_as_int(register_odd(a, b));
    }
}

static inline void lanes_i_store_pairs(unsigned char *const row[4], lanes_i first, lanes_i second)
{
    GN_UNROLLED
    for (int n = 0; n < LANES_REGISTERS; ++n) {
        const register_i a = first.q[n], b = second.q[n];

        register_i_store_rows_at(row, n, 0, register_i_interleave_low(a, b));
        register_i_store_rows_at(row, n, 16, register_i_interleave_high(a, b));
    }
}

/* Loads the three words of each pixel: x, y and z. A row has 48 bytes, so its last register begins
 * with z of the third pixel. The fourth word is not set to anything. */
static inline void lanes_i_load_triples(unsigned char *const row[4], lanes_i word[4])
{
    GN_UNROLLED
    for (int n = 0; n < LANES_REGISTERS; ++n) {
        const register_i last = register_i_load_rows_at(row, n, 32); /* z2 x3 y3 z3 */
        const register_f odd = register_odd(register_as_float(last), register_as_float(last));
        register_i a[4];

        GN_UNROLLED
        for (int i = 0; i < 3; ++i)
            a[i] = register_i_load_rows_at(row, n, 12 * i);
        a[3] = register_i_interleave_low(register_as_int(odd),                    /* x3 z3 x3 z3 */
                                         register_i_interleave_high(last, last)); /* y3 y3 .. */
        lanes_from_rows(a, n, word);
    }
}

static inline void lanes_i_store_triples(unsigned char *const row[4], const lanes_i word[3])
{
    const lanes_i words[4] = {word[0], word[1], word[2], word[2]};

    GN_UNROLLED
    for (int n = 0; n < LANES_REGISTERS; ++n) {
        register_i a[4];

        lanes_to_rows(words, n, a);

        const register_f last = register_as_float(a[3]);
        const register_i xz = register_as_int(register_even(last, last)); /* x3 z3 x3 z3 */
        const register_i y = register_as_int(register_odd(last, last));   /* y3 ... */
        const register_i zy =
            register_i_interleave_low(register_i_interleave_high(a[2], a[3]), y); /* z2 y3 .. */

        GN_UNROLLED
        for (int i = 0; i < 3; ++i)
            register_i_store_rows_at(row, n, 12 * i, a[i]);
        register_i_store_rows_at(row, n, 32, register_i_interleave_low(zy, xz));
    }
}

/* Loads the four words of each pixel. */
static inline void lanes_i_load_fours(unsigned char *const row[4], lanes_i word[4])
{
    GN_UNROLLED
    for (int n = 0; n < LANES_REGISTERS; ++n) {
        register_i a[4];

        GN_UNROLLED
        for (int i = 0; i < 4; ++i)
            a[i] = register_i_load_rows_at(row, n, 16 * i);
        lanes_from_rows(a, n, word);
    }
}

static inline void lanes_i_store_fours(unsigned char *const row[4], const lanes_i word[4])
{
    GN_UNROLLED
    for (int n = 0; n < LANES_REGISTERS; ++n) {
        register_i a[4];

        lanes_to_rows(word, n, a);
        GN_UNROLLED
        for (int i = 0; i < 4; ++i)
            register_i_store_rows_at(row, n, 16 * i, a[i]);
    }
}

#else

/* The lanes of a row of pixels, and the rows. */
#define ROW_LANES (LANES == 1 ? 1 : LANES / 4)
#define BLOCK_ROWS (LANES / ROW_LANES)

static inline lanes_i lanes_i_load_bytes(unsigned char *const row[4])
{
    int32_t value[LANES];

    for (int r = 0; r < BLOCK_ROWS; ++r)
        for (int n = 0; n < ROW_LANES; ++n)
            value[ROW_LANES * r + n] = row[r][n];
    return lanes_i_load(value);
}

static inline void lanes_i_store_bytes(unsigned char *const row[4], lanes_i a)
{
    int32_t value[LANES];

    lanes_i_store(value, a);
    for (int r = 0; r < BLOCK_ROWS; ++r)
        for (int n = 0; n < ROW_LANES; ++n)
            row[r][n] = (unsigned char)value[ROW_LANES * r + n];
}

static inline lanes_i lanes_i_load_shorts(unsigned char *const row[4])
{
    int32_t value[LANES];

    for (int r = 0; r < BLOCK_ROWS; ++r)
        for (int n = 0; n < ROW_LANES; ++n)
            value[ROW_LANES * r + n] = ((const stored_short *)(const void *)row[r])[n];
    return lanes_i_load(value);
}

static inline void lanes_i_store_shorts(unsigned char *const row[4], lanes_i a)
{
    int32_t value[LANES];

    lanes_i_store(value, a);
    for (int r = 0; r < BLOCK_ROWS; ++r)
        for (int n = 0; n < ROW_LANES; ++n)
            ((stored_short *)(void *)row[r])[n] = (uint16_t)value[ROW_LANES * r + n];
}

#endif

#endif
