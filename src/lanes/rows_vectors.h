/* The operations of rows.h on lanes in vectors of GNU C, for little-endian processors: the first of
 * two elements of a vector is the low half of the element that both are.
 * Not alone: rows.h includes it after the types of lanes. */
#ifndef GN_LANES_ROWS_VECTORS_H
#define GN_LANES_ROWS_VECTORS_H

/* Numbers and vectors at any address. */
typedef int32_t __attribute__((may_alias, aligned(1))) any_word;
typedef uint64_t __attribute__((may_alias, aligned(1))) any_pair;
typedef int32_t any_vector __attribute__((vector_size(16), may_alias, aligned(1)));

#if defined(__clang__)
#define LANES_SHUFFLE_SHORTS(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#define LANES_SHUFFLE_BYTES(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#else
#define LANES_SHUFFLE_SHORTS(a, b, ...) __builtin_shuffle(a, b, (vector_shorts){__VA_ARGS__})
#define LANES_SHUFFLE_BYTES(a, b, ...) __builtin_shuffle(a, b, (vector_bytes){__VA_ARGS__})
#endif

/* Returns eight bytes of two rows. */
static inline vector_pairs lanes_pair_rows(const unsigned char *first, const unsigned char *second)
{
    return (vector_pairs){*(const any_pair *)(const void *)first,
                          *(const any_pair *)(const void *)second};
}

/* Returns the shorts 0 to 3, and 4 to 7, as words. */
static inline vector_i lanes_low_shorts(vector_shorts a)
{
    const vector_shorts zero = {0};

    return (vector_i)LANES_SHUFFLE_SHORTS(a, zero, 0, 8, 1, 9, 2, 10, 3, 11);
}

static inline vector_i lanes_high_shorts(vector_shorts a)
{
    const vector_shorts zero = {0};

    return (vector_i)LANES_SHUFFLE_SHORTS(a, zero, 4, 12, 5, 13, 6, 14, 7, 15);
}

/* Returns the shorts of two vectors as lanes. */
static inline lanes_i lanes_of_shorts(vector_shorts low, vector_shorts high)
{
    lanes_i a;

    a.q[0] = lanes_low_shorts(low);
    a.q[1] = lanes_high_shorts(low);
    a.q[2] = lanes_low_shorts(high);
    a.q[3] = lanes_high_shorts(high);
    return a;
}

/* Returns the low shorts of two registers. */
static inline vector_shorts lanes_vector_shorts(vector_i a, vector_i b)
{
    return LANES_SHUFFLE_SHORTS((vector_shorts)a, (vector_shorts)b, 0, 2, 4, 6, 8, 10, 12, 14);
}

static inline lanes_i lanes_i_load_bytes(unsigned char *const row[4])
{
    const vector_bytes zero = {0};
    const vector_i words = {
        *(const any_word *)(const void *)row[0], *(const any_word *)(const void *)row[1],
        *(const any_word *)(const void *)row[2], *(const any_word *)(const void *)row[3]};
    const vector_bytes bytes = (vector_bytes)words;
    const vector_shorts low = (vector_shorts)LANES_SHUFFLE_BYTES(bytes, zero, 0, 16, 1, 17, 2, 18,
                                                                 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
    const vector_shorts high = (vector_shorts)LANES_SHUFFLE_BYTES(
        bytes, zero, 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31);

    return lanes_of_shorts(low, high);
}

static inline void lanes_i_store_bytes(unsigned char *const row[4], lanes_i a)
{
    const vector_bytes low = (vector_bytes)lanes_vector_shorts(a.q[0], a.q[1]);
    const vector_bytes high = (vector_bytes)lanes_vector_shorts(a.q[2], a.q[3]);
    const vector_i words = (vector_i)LANES_SHUFFLE_BYTES(low, high, 0, 2, 4, 6, 8, 10, 12, 14, 16,
                                                         18, 20, 22, 24, 26, 28, 30);

    *(any_word *)(void *)row[0] = words[0];
    *(any_word *)(void *)row[1] = words[1];
    *(any_word *)(void *)row[2] = words[2];
    *(any_word *)(void *)row[3] = words[3];
}

static inline lanes_i lanes_i_load_shorts(unsigned char *const row[4])
{
    const vector_shorts low = (vector_shorts)lanes_pair_rows(row[0], row[1]);
    const vector_shorts high = (vector_shorts)lanes_pair_rows(row[2], row[3]);

    return lanes_of_shorts(low, high);
}

static inline void lanes_i_store_shorts(unsigned char *const row[4], lanes_i a)
{
    const vector_pairs low = (vector_pairs)lanes_vector_shorts(a.q[0], a.q[1]);
    const vector_pairs high = (vector_pairs)lanes_vector_shorts(a.q[2], a.q[3]);

    *(any_pair *)(void *)row[0] = low[0];
    *(any_pair *)(void *)row[1] = low[1];
    *(any_pair *)(void *)row[2] = high[0];
    *(any_pair *)(void *)row[3] = high[1];
}

static inline void lanes_i_load_pairs(unsigned char *const row[4], lanes_i *first, lanes_i *second)
{
    GN_UNROLLED
    for (int n = 0; n < 4; ++n) {
        const vector_i a = *(const any_vector *)(const void *)row[n];
        const vector_i b = *(const any_vector *)(const void *)(row[n] + 16);

        first->q[n] = LANES_SHUFFLE(a, b, 0, 2, 4, 6);
        second->q[n] = LANES_SHUFFLE(a, b, 1, 3, 5, 7);
    }
}

static inline void lanes_i_store_pairs(unsigned char *const row[4], lanes_i first, lanes_i second)
{
    GN_UNROLLED
    for (int n = 0; n < 4; ++n) {
        const vector_i a = first.q[n], b = second.q[n];

        *(any_vector *)(void *)row[n] = LANES_SHUFFLE(a, b, 0, 4, 1, 5);
        *(any_vector *)(void *)(row[n] + 16) = LANES_SHUFFLE(a, b, 2, 6, 3, 7);
    }
}

/* Loads the four words of each pixel. */
static inline void lanes_i_load_fours(unsigned char *const row[4], lanes_i word[4])
{
    GN_UNROLLED
    for (int n = 0; n < 4; ++n) {
        vector_i a[4];

        GN_UNROLLED
        for (int i = 0; i < 4; ++i)
            a[i] = lanes_vector_load(row[n] + 16 * i);
        lanes_vector_from_rows(a, n, word);
    }
}

static inline void lanes_i_store_fours(unsigned char *const row[4], const lanes_i word[4])
{
    GN_UNROLLED
    for (int n = 0; n < 4; ++n) {
        vector_i a[4];

        lanes_vector_to_rows(word, n, a);
        GN_UNROLLED
        for (int i = 0; i < 4; ++i)
            lanes_vector_store(row[n] + 16 * i, a[i]);
    }
}

/* The first and the second pixel in each half of a register. */
#define LANES_FIRST_THREE 0xFFFFFFu
#define LANES_SECOND_THREE 0x00FFFFFF00000000u

/* Loads a row of threes: twelve bytes. The second half of a register begins with byte 6. */
static inline vector_i lanes_three_row(const unsigned char *row)
{
    const uint64_t low = *(const any_pair *)(const void *)row;
    const any_word high = *(const any_word *)(const void *)(row + 8);
    const vector_pairs halves = {low, low >> 48 | (uint64_t)(uint32_t)high << 16};

    return (vector_i)((halves & LANES_FIRST_THREE) | (halves << 8 & LANES_SECOND_THREE));
}

static inline void lanes_store_three_row(unsigned char *row, vector_i a)
{
    const vector_pairs pixels = (vector_pairs)a;
    const vector_pairs halves = (pixels & LANES_FIRST_THREE) | (pixels & LANES_SECOND_THREE) >> 8;

    *(any_pair *)(void *)row = halves[0] | halves[1] << 48;
    *(any_word *)(void *)(row + 8) = (int32_t)(halves[1] >> 16);
}

static inline lanes_i lanes_i_load_threes(unsigned char *const row[4])
{
    LANES_EACH_REGISTER(lanes_i, lanes_three_row(row[n]));
}

static inline void lanes_i_store_threes(unsigned char *const row[4], lanes_i a)
{
    lanes_store_three_row(row[0], a.q[0]);
    lanes_store_three_row(row[1], a.q[1]);
    lanes_store_three_row(row[2], a.q[2]);
    lanes_store_three_row(row[3], a.q[3]);
}

#endif
