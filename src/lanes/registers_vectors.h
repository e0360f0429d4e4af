/* Vectors of GNU C, four lanes each, which compilers keep in registers on every target that has
 * vector registers. Uses only operators, shuffles, and conversions in range, whose bits C and
 * IEEE 754 define. Elements of a vector have the order of memory on every target, so only the rows
 * of pixels below depend on the byte order.
 * Not alone: lanes.h chooses one such file; lanes_registers.h says what it defines. */
#ifndef GN_LANES_REGISTERS_VECTORS_H
#define GN_LANES_REGISTERS_VECTORS_H

#include <gnomon/scalar.h>

#include "../scalars/square_root.h"

#define LANES_REGISTERS 4

/* Each lane of a mask is all ones or all zeros. */
typedef float register_f __attribute__((vector_size(16)));
typedef int32_t register_i __attribute__((vector_size(16)));
typedef register_i register_m;

typedef uint32_t vector_words __attribute__((vector_size(16)));
typedef uint16_t vector_shorts __attribute__((vector_size(16)));
typedef uint8_t vector_bytes __attribute__((vector_size(16)));
typedef uint64_t vector_pairs __attribute__((vector_size(16)));

/* Vectors at any address. */
typedef float stored_vector_f __attribute__((vector_size(16), aligned(1), may_alias));
typedef int32_t stored_vector_i __attribute__((vector_size(16), aligned(1), may_alias));

/* Selects four elements of a and b, which are numbered 0 to 3 and 4 to 7. */
#if defined(__clang__)
#define VECTOR_SHUFFLE(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#else
#define VECTOR_SHUFFLE(a, b, ...) __builtin_shuffle(a, b, (register_i){__VA_ARGS__})
#endif

#define register_load(p) (*(const stored_vector_f *)(const void *)(p))
#define register_store(p, a) (*(stored_vector_f *)(void *)(p) = (a))
#define register_i_load(p) (*(const stored_vector_i *)(const void *)(p))
#define register_i_store(p, a) (*(stored_vector_i *)(void *)(p) = (a))
#define register_splat(a) vector_splat(a)
#define register_columns() ((register_f){0.0f, 1.0f, 2.0f, 3.0f})
#define register_rows(per_y, y, n) vector_splat((per_y) * ((y) + (float)(n)))
#define register_add(a, b) ((a) + (b))
#define register_sub(a, b) ((a) - (b))
#define register_mul(a, b) ((a) * (b))
#define register_div(a, b) ((a) / (b))
#define register_sqrt(a) vector_sqrt(a)
#define register_min(a, b) vector_select_floats((register_i)((b) > (a)), a, b)
#define register_max(a, b) vector_select_floats((register_i)((a) > (b)), a, b)
#define register_greater(a, b) ((register_i)((a) > (b)))
#define register_less_equal(a, b) ((register_i)((a) <= (b)))
#define register_and(a, b) ((a) & (b))
#define register_not(a) (~(a))
#define register_select(m, a, b) vector_select_floats(m, a, b)
#define register_from_bits(bits, n) vector_from_bits(bits, VECTOR_BITS(n))
#define register_m_as_int(a) (a)
#define register_negative(a) ((a) >> 31)
#define register_truncate(a) vector_truncate(a)
#define register_round(a) vector_round(a)
#define register_floor(a) vector_floor(a)
#define register_floor_to_int(a) vector_floor_to_int(a)
#define register_to_float(a) __builtin_convertvector(a, register_f)
#define register_as_int(a) ((register_i)(a))
#define register_as_float(a) ((register_f)(a))
#define register_quad_left(a) VECTOR_SHUFFLE(a, a, 0, 0, 2, 2)
#define register_quad_right(a) VECTOR_SHUFFLE(a, a, 1, 1, 3, 3)
#define register_i_splat(a) vector_splat_int(a)
#define register_i_columns(a) ((register_i){0, a, 2 * (a), 3 * (a)})
#define register_i_rows(per_row, n) vector_splat_int((n) * (per_row))
/* Sums and products of unsigned numbers wrap around. */
#define register_i_add(a, b) ((register_i)((vector_words)(a) + (vector_words)(b)))
#define register_i_sub(a, b) ((register_i)((vector_words)(a) - (vector_words)(b)))
#define register_i_mul(a, b) ((register_i)((vector_words)(a) * (vector_words)(b)))
#define register_i_mul_short(a, b) register_i_mul(a, vector_splat_int(b))
#define register_i_or(a, b) ((a) | (b))
#define register_i_and(a, b) ((a) & (b))
#define register_i_xor(a, b) ((a) ^ (b))
#define register_i_mul_shorts(a, b) ((register_i)((vector_shorts)(a) * (vector_shorts)(b)))
#define register_i_high_bytes(a) ((register_i)((vector_shorts)(a) >> 8))
#define register_i_add_bytes(a, b) vector_add_bytes((vector_bytes)(a), (vector_bytes)(b))
#define register_i_sub_bytes(a, b) vector_sub_bytes((vector_bytes)(a), (vector_bytes)(b))
#define register_i_add_shorts(a, b) vector_add_shorts((vector_shorts)(a), (vector_shorts)(b))
#define register_i_sub_shorts(a, b) vector_sub_shorts((vector_shorts)(a), (vector_shorts)(b))
#define register_i_scale_shorts(a, b) vector_scale_shorts((vector_words)(a), (vector_words)(b))
#define register_i_shift_left(a, count) ((register_i)((vector_words)(a) << (uint32_t)(count)))
#define register_i_shift_right(a, count) ((a) >> (count))
#define register_i_shift_right_logical(a, count)                                                   \
    ((register_i)((vector_words)(a) >> (uint32_t)(count)))
#define register_i_min(a, b) vector_select((register_i)((a) < (b)), a, b)
#define register_i_max(a, b) vector_select((register_i)((a) > (b)), a, b)
#define register_i_select(m, a, b) vector_select(m, a, b)
#define register_i_greater(a, b) ((register_i)((a) > (b)))
#define register_i_equal(a, b) ((register_i)((a) == (b)))
#define register_i_load_rows(ROW) register_i_load(ROW(0))
#define register_i_store_rows(ROW, a) register_i_store(ROW(0), a)
#define register_i_load_rows_of_bytes(ROW) vector_load_bytes(ROW(0))
#define register_i_store_rows_of_bytes(ROW, a) vector_store_bytes(ROW(0), a)
#define register_i_load_rows_of_shorts(ROW) vector_load_shorts(ROW(0))
#define register_i_store_rows_of_shorts(ROW, a) vector_store_shorts(ROW(0), a)
#define register_i_load_rows_of_threes(ROW) vector_load_threes(ROW(0))
#define register_i_store_rows_of_threes(ROW, a) vector_store_threes(ROW(0), (vector_pairs)(a))
#define register_load_pairs(AT, first) vector_load_pairs(AT(first), AT((first) + 1))
#define register_even(a, b) VECTOR_SHUFFLE(a, b, 0, 2, 4, 6)
#define register_odd(a, b) VECTOR_SHUFFLE(a, b, 1, 3, 5, 7)
#define register_shuffle(a, b, i, j, k, l) VECTOR_SHUFFLE(a, b, i, j, (k) + 4, (l) + 4)
#define register_spread(a, i) VECTOR_SHUFFLE(a, a, i, i, i, i)
#define register_splat_vec4(p) register_load(p)
#define register_i_interleave_low(a, b) VECTOR_SHUFFLE(a, b, 0, 4, 1, 5)
#define register_i_interleave_high(a, b) VECTOR_SHUFFLE(a, b, 2, 6, 3, 7)
#define register_i_set(NUMBER) ((register_i){NUMBER(0), NUMBER(1), NUMBER(2), NUMBER(3)})
#define register_indices(at, index) register_i_store(at, index)
#define register_pack_unorm8(red, green, blue, alpha) vector_pack(red, green, blue, alpha)

/* The bits of register n's lanes. */
#define VECTOR_BITS(n) ((register_i){1 << 4 * (n), 2 << 4 * (n), 4 << 4 * (n), 8 << 4 * (n)})
#define registers_bits(q)                                                                          \
    vector_bits((q[0] & VECTOR_BITS(0)) | (q[1] & VECTOR_BITS(1)) | (q[2] & VECTOR_BITS(2)) |      \
                (q[3] & VECTOR_BITS(3)))

GN_OPERATION register_f vector_splat(float a)
{
    return (register_f){a, a, a, a};
}

GN_OPERATION register_i vector_splat_int(int32_t a)
{
    return (register_i){a, a, a, a};
}

GN_OPERATION register_i vector_select(register_i mask, register_i a, register_i b)
{
    return (mask & a) | (~mask & b);
}

GN_OPERATION register_f vector_select_floats(register_i mask, register_f a, register_f b)
{
    return (register_f)vector_select(mask, (register_i)a, (register_i)b);
}

GN_OPERATION float lane_sqrt(float a)
{
#if GN_HAVE_SQUARE_ROOT
    return float_square_root(a);
#else
    return gn_sqrt(a);
#endif
}

GN_OPERATION register_f vector_sqrt(register_f a)
{
    return (register_f){lane_sqrt(a[0]), lane_sqrt(a[1]), lane_sqrt(a[2]), lane_sqrt(a[3])};
}

/* Combines the bits of all four elements by `or`. */
GN_OPERATION uint32_t vector_bits(register_i bits)
{
    bits |= VECTOR_SHUFFLE(bits, bits, 2, 3, 0, 1);
    bits |= VECTOR_SHUFFLE(bits, bits, 1, 0, 3, 2);
    return (uint32_t)bits[0];
}

GN_OPERATION register_i vector_from_bits(uint32_t bits, register_i lane)
{
    return (register_i)((vector_splat_int((int32_t)bits) & lane) == lane);
}

/* An unsigned sum that is smaller than a summand has wrapped around; so has a difference that is
 * greater than the minuend. */
GN_OPERATION register_i vector_add_bytes(vector_bytes a, vector_bytes b)
{
    const vector_bytes sum = a + b;

    return (register_i)(sum | (vector_bytes)(sum < a));
}

GN_OPERATION register_i vector_sub_bytes(vector_bytes a, vector_bytes b)
{
    const vector_bytes difference = a - b;

    return (register_i)(difference & (vector_bytes)(difference <= a));
}

GN_OPERATION register_i vector_add_shorts(vector_shorts a, vector_shorts b)
{
    const vector_shorts sum = a + b;

    return (register_i)(sum | (vector_shorts)(sum < a));
}

GN_OPERATION register_i vector_sub_shorts(vector_shorts a, vector_shorts b)
{
    const vector_shorts difference = a - b;

    return (register_i)(difference & (vector_shorts)(difference <= a));
}

/* Returns p + p / 2^16 + 2^15 for a product p of shorts; the upper half is the scaled product. */
GN_OPERATION vector_words vector_scaled(vector_words product)
{
    return product + (product >> 16) + 0x8000u;
}

GN_OPERATION register_i vector_scale_shorts(vector_words a, vector_words b)
{
    const vector_words low = vector_scaled((a & 0xFFFFu) * (b & 0xFFFFu));
    const vector_words high = vector_scaled((a >> 16) * (b >> 16));

    return (register_i)(low >> 16 | (high & 0xFFFF0000u));
}

/* C leaves conversions out of range undefined, so these lanes convert 0. */
GN_OPERATION register_i vector_truncate(register_f a)
{
    const register_i bits = (register_i)a;
    const register_i outside = (register_i)((bits & INT32_MAX) >= LANE_BITS_2_31);

    return __builtin_convertvector((register_f)(bits & ~outside), register_i) |
           (outside & INT32_MIN);
}

/* From 2^23 on, floats are integers. Between 2^23 and 2^24 the last place is 1, so adding 2^23
 * rounds. */
GN_OPERATION register_i vector_round(register_f a)
{
    const register_i bits = (register_i)a;
    const register_i magnitude = bits & INT32_MAX;
    const register_i outside = (register_i)(magnitude >= LANE_BITS_2_31);
    const register_i broken = (register_i)(magnitude < LANE_BITS_2_23);
    const register_f rounder = (register_f)((broken & LANE_BITS_2_23) | (bits & INT32_MIN));
    const register_f rounded = ((register_f)(bits & ~outside) + rounder) - rounder;

    return __builtin_convertvector(rounded, register_i) | (outside & INT32_MIN);
}

GN_OPERATION register_f vector_floor(register_f a)
{
    const register_i bits = (register_i)a;
    const register_i broken = (register_i)((bits & INT32_MAX) < LANE_BITS_2_23);
    const register_f t = __builtin_convertvector(
        __builtin_convertvector((register_f)(bits & broken), register_i), register_f);
    const register_f one = vector_splat(1.0f);
    const register_f below = t - (register_f)((register_i)(t > a) & (register_i)one);

    return vector_select_floats(broken, below, a);
}

/* Returns INT32_MIN where a is NaN or out of range. */
GN_OPERATION register_i vector_floor_to_int(register_f a)
{
    const register_i bits = (register_i)a;
    const register_i outside = (register_i)((bits & INT32_MAX) >= LANE_BITS_2_31);
    const register_f inside = (register_f)(bits & ~outside);
    const register_i truncated = __builtin_convertvector(inside, register_i);
    const register_i is_above =
        (register_i)(__builtin_convertvector(truncated, register_f) > inside);

    return (truncated + is_above) | (outside & INT32_MIN);
}

/* Returns a channel in units of 1/255 in the low byte; the bits above it vary. From 0 to 255,
 * adding 2^23 rounds and leaves the integer in the low bits. The bits of every input that yields 0
 * are at least those of 2^31 as unsigned numbers; with the sign bit flipped they keep
 * that order as signed numbers. */
GN_OPERATION vector_words vector_unorm8(register_f channel)
{
    const register_f scaled = channel * 255.0f;
    const register_i bits = (register_i)scaled;
    const register_i some = (register_i)((bits ^ INT32_MIN) < (LANE_BITS_2_31 ^ INT32_MIN));
    const register_i full = (register_i)(bits > LANE_BITS_255);

    return (vector_words)(((register_i)(scaled + 8388608.0f) | full) & some);
}

GN_OPERATION register_i vector_pack(register_f red, register_f green, register_f blue,
                                    register_f alpha)
{
    return (register_i)((vector_unorm8(red) & 0xFFu) | (vector_unorm8(green) & 0xFFu) << 8 |
                        (vector_unorm8(blue) & 0xFFu) << 16 | vector_unorm8(alpha) << 24);
}

GN_OPERATION register_f vector_load_pairs(const void *first, const void *second)
{
    return (register_f)(vector_pairs){*(const any_pair *)first, *(const any_pair *)second};
}

#if defined(__clang__)
#define VECTOR_SHUFFLE_SHORTS(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#define VECTOR_SHUFFLE_BYTES(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#else
#define VECTOR_SHUFFLE_SHORTS(a, b, ...) __builtin_shuffle(a, b, (vector_shorts){__VA_ARGS__})
#define VECTOR_SHUFFLE_BYTES(a, b, ...) __builtin_shuffle(a, b, (vector_bytes){__VA_ARGS__})
#endif

/* Rows of four pixels, of one, two and three bytes, on little-endian processors: the first of two
 * neighbouring elements is the low half of the element of twice the width. */

GN_OPERATION register_i vector_words_of(vector_shorts shorts)
{
    const vector_shorts zero = {0};

    return (register_i)VECTOR_SHUFFLE_SHORTS(shorts, zero, 0, 8, 1, 9, 2, 10, 3, 11);
}

GN_OPERATION register_i vector_load_bytes(const void *row)
{
    const vector_bytes zero = {0};
    const vector_bytes bytes = (vector_bytes)(register_i){*(const any_word *)row};

    return vector_words_of((vector_shorts)VECTOR_SHUFFLE_BYTES(bytes, zero, 0, 16, 1, 17, 2, 18, 3,
                                                               19, 4, 20, 5, 21, 6, 22, 7, 23));
}

/* Joins the bytes of each half of the vector, then the halves. */
GN_OPERATION void vector_store_bytes(void *row, register_i a)
{
    const vector_pairs bytes = (vector_pairs)(a & 0xFF);
    const vector_pairs joined = bytes | bytes >> 24;

    *(any_word *)row = (int32_t)((uint32_t)(joined[0] & 0xFFFF) | (uint32_t)joined[1] << 16);
}

GN_OPERATION register_i vector_load_shorts(const void *row)
{
    return vector_words_of((vector_shorts)(vector_pairs){*(const any_pair *)row});
}

GN_OPERATION void vector_store_shorts(void *row, register_i a)
{
    const vector_pairs shorts = (vector_pairs)(a & 0xFFFF);
    const vector_pairs joined = shorts | shorts >> 16;

    *(any_pair *)row = (uint32_t)joined[0] | joined[1] << 32;
}

/* The low three bytes of the first and of the second word in each half of a register. */
#define VECTOR_FIRST_THREE 0xFFFFFFu
#define VECTOR_SECOND_THREE 0x00FFFFFF00000000u

/* The third and fourth pixel, from byte 6 of the row on, go to the upper half. */
GN_OPERATION register_i vector_load_threes(const unsigned char *row)
{
    const uint64_t low = *(const any_pair *)(const void *)row;
    const any_word high = *(const any_word *)(const void *)(row + 8);
    const vector_pairs halves = {low, low >> 48 | (uint64_t)(uint32_t)high << 16};

    return (register_i)((halves & VECTOR_FIRST_THREE) | (halves << 8 & VECTOR_SECOND_THREE));
}

GN_OPERATION void vector_store_threes(unsigned char *row, vector_pairs a)
{
    const vector_pairs halves = (a & VECTOR_FIRST_THREE) | (a & VECTOR_SECOND_THREE) >> 8;

    *(any_pair *)(void *)row = halves[0] | halves[1] << 48;
    *(any_word *)(void *)(row + 8) = (int32_t)(halves[1] >> 16);
}

#endif
