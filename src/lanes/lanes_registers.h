/* The operations of lanes.h over the registers of an instruction set, with the results that
 * lanes_portable.h defines.
 *
 * A form of lanes is a file registers_NAME.h of types and macros. A register holds one, two or four
 * rows of a block, 128 bits each. ROW(r) is the address of row r of a register, given as a macro.
 *
 *   LANES_REGISTERS           the registers that hold 16 lanes: 4, 2 or 1
 *   register_f _i _m          the types of registers of floats, integers and masks
 *   register_NAME             the operation lanes_NAME on one register
 *   register_columns          the column of each lane, as floats
 *   register_i_columns        the column of each lane times an integer
 *   register_rows             per_y * (y + the row of each lane) in register n
 *   register_i_rows           the row of each lane in register n times an integer
 *   register_from_bits        the masks of the lanes of register n
 *   registers_bits            the bits of the masks of all registers
 *   register_negative         what registers_bits takes as a mask of the lanes that are negative
 *   register_i_shift_right_logical
 *   register_i_splat_two         if LANES_REGISTERS is 1
 *   register_quad_lower       and _upper, if LANES_REGISTERS is 1 or 2
 *   register_i_load_rows      four words a row, from ROW(r); and store
 *   register_load_pairs       in row r two words from AT(4 * r + first), two from the next AT
 *   register_i_set            NUMBER(l) in lane l
 *   register_indices          writes the lanes to memory, to be used as indices
 *   register_even             in each row lanes 0 and 2 of a, then of b
 *   register_odd              in each row lanes 1 and 3 of a, then of b
 *   register_shuffle          in each row lanes i and j of a, then k and l of b
 *   register_spread           in each row lane i in all four
 *   register_i_interleave_low   in each row lane 0 of a, 0 of b, 1 of a, 1 of b
 *   register_i_interleave_high  in each row lane 2 of a, 2 of b, 3 of a, 3 of b
 *   register_splat_vec4        four floats in each row
 *   register_load_vec3        and store, in place of register_shuffle
 *
 *   register_i_pack_words     in each row the words of a, then of b, saturated to signed shorts
 *   register_i_pack_shorts    in each row the shorts of a, then of b, saturated to bytes
 *   register_i_transpose_bytes  the bytes of each row as a matrix of 4x4
 *   register_pack_unorm8      in place of these three
 *
 * and for rows.h, with bytes, shorts and threes in place of TYPE,
 *   register_i_load_rows_of_TYPE  four pixels a row, from ROW(r); and store
 *
 * Not alone: lanes.h includes it after such a file. */
#ifndef GN_LANES_LANES_REGISTERS_H
#define GN_LANES_LANES_REGISTERS_H

/* The lanes and the rows in a register. */
#define REGISTER_LANES (LANES / LANES_REGISTERS)
#define REGISTER_ROWS (4 / LANES_REGISTERS)

typedef struct lanes_f {
    register_f q[LANES_REGISTERS];
} lanes_f;

typedef struct lanes_i {
    register_i q[LANES_REGISTERS];
} lanes_i;

typedef struct lanes_m {
    register_m q[LANES_REGISTERS];
} lanes_m;

/* A statement for each register; n is its number, a constant. */
#define LANES_REGISTER_IS(number, ...)                                                             \
    {                                                                                              \
        enum { n = number };                                                                       \
        __VA_ARGS__;                                                                               \
    }
#if LANES_REGISTERS == 1
#define LANES_FOR_REGISTERS(...) LANES_REGISTER_IS(0, __VA_ARGS__)
#elif LANES_REGISTERS == 2
#define LANES_FOR_REGISTERS(...)                                                                   \
    LANES_REGISTER_IS(0, __VA_ARGS__)                                                              \
    LANES_REGISTER_IS(1, __VA_ARGS__)
#else
#define LANES_FOR_REGISTERS(...)                                                                   \
    LANES_REGISTER_IS(0, __VA_ARGS__)                                                              \
    LANES_REGISTER_IS(1, __VA_ARGS__)                                                              \
    LANES_REGISTER_IS(2, __VA_ARGS__)                                                              \
    LANES_REGISTER_IS(3, __VA_ARGS__)
#endif

/* Returns lanes whose register n is the value of an expression with n. */
#define LANES_EACH_REGISTER(type, ...)                                                             \
    type r;                                                                                        \
    LANES_FOR_REGISTERS(r.q[n] = __VA_ARGS__)                                                      \
    return r

/* Define an operation that applies a register's operation to each register. The arguments: the type
 * of the result, the name, the register's operation, the type of the operands. */
#define LANES_UNARY(result, name, one, type)                                                       \
    GN_OPERATION result name(type a)                                                               \
    {                                                                                              \
        LANES_EACH_REGISTER(result, one(a.q[n]));                                                  \
    }
#define LANES_BINARY(result, name, one, type)                                                      \
    GN_OPERATION result name(type a, type b)                                                       \
    {                                                                                              \
        LANES_EACH_REGISTER(result, one(a.q[n], b.q[n]));                                          \
    }
#define LANES_SELECT(result, name, one, type)                                                      \
    GN_OPERATION result name(lanes_m m, type a, type b)                                            \
    {                                                                                              \
        LANES_EACH_REGISTER(result, one(m.q[n], a.q[n], b.q[n]));                                  \
    }
#define LANES_SCALAR(result, name, one, scalar)                                                    \
    GN_OPERATION result name(scalar a)                                                             \
    {                                                                                              \
        LANES_EACH_REGISTER(result, one(a));                                                       \
    }
#define LANES_AND_INT(result, name, one, type)                                                     \
    GN_OPERATION result name(type a, int b)                                                        \
    {                                                                                              \
        LANES_EACH_REGISTER(result, one(a.q[n], b));                                               \
    }

LANES_SCALAR(lanes_f, lanes_splat, register_splat, float)
LANES_BINARY(lanes_f, lanes_add, register_add, lanes_f)
LANES_BINARY(lanes_f, lanes_sub, register_sub, lanes_f)
LANES_BINARY(lanes_f, lanes_mul, register_mul, lanes_f)
LANES_BINARY(lanes_f, lanes_div, register_div, lanes_f)
LANES_UNARY(lanes_f, lanes_sqrt, register_sqrt, lanes_f)
LANES_BINARY(lanes_f, lanes_min, register_min, lanes_f)
LANES_BINARY(lanes_f, lanes_max, register_max, lanes_f)
LANES_BINARY(lanes_m, lanes_greater, register_greater, lanes_f)
LANES_BINARY(lanes_m, lanes_less_equal, register_less_equal, lanes_f)
LANES_BINARY(lanes_m, lanes_and, register_and, lanes_m)
LANES_UNARY(lanes_m, lanes_not, register_not, lanes_m)
LANES_SELECT(lanes_f, lanes_select, register_select, lanes_f)
LANES_UNARY(lanes_i, lanes_m_as_int, register_m_as_int, lanes_m)
LANES_UNARY(lanes_i, lanes_truncate, register_truncate, lanes_f)
LANES_UNARY(lanes_i, lanes_round, register_round, lanes_f)
LANES_UNARY(lanes_f, lanes_floor, register_floor, lanes_f)
LANES_UNARY(lanes_i, lanes_floor_to_int, register_floor_to_int, lanes_f)
LANES_UNARY(lanes_f, lanes_to_float, register_to_float, lanes_i)
LANES_UNARY(lanes_i, lanes_as_int, register_as_int, lanes_f)
LANES_UNARY(lanes_f, lanes_as_float, register_as_float, lanes_i)
LANES_UNARY(lanes_f, lanes_quad_left, register_quad_left, lanes_f)
LANES_UNARY(lanes_f, lanes_quad_right, register_quad_right, lanes_f)
LANES_SCALAR(lanes_i, lanes_i_splat, register_i_splat, int32_t)
LANES_BINARY(lanes_i, lanes_i_add, register_i_add, lanes_i)
LANES_BINARY(lanes_i, lanes_i_sub, register_i_sub, lanes_i)
LANES_BINARY(lanes_i, lanes_i_mul, register_i_mul, lanes_i)
LANES_AND_INT(lanes_i, lanes_i_mul_short, register_i_mul_short, lanes_i)
LANES_BINARY(lanes_i, lanes_i_or, register_i_or, lanes_i)
LANES_BINARY(lanes_i, lanes_i_and, register_i_and, lanes_i)
LANES_BINARY(lanes_i, lanes_i_xor, register_i_xor, lanes_i)
LANES_BINARY(lanes_i, lanes_i_mul_shorts, register_i_mul_shorts, lanes_i)
LANES_UNARY(lanes_i, lanes_i_high_bytes, register_i_high_bytes, lanes_i)
LANES_BINARY(lanes_i, lanes_i_add_bytes, register_i_add_bytes, lanes_i)
LANES_BINARY(lanes_i, lanes_i_sub_bytes, register_i_sub_bytes, lanes_i)
LANES_BINARY(lanes_i, lanes_i_add_shorts, register_i_add_shorts, lanes_i)
LANES_BINARY(lanes_i, lanes_i_sub_shorts, register_i_sub_shorts, lanes_i)
LANES_BINARY(lanes_i, lanes_i_scale_shorts, register_i_scale_shorts, lanes_i)
LANES_AND_INT(lanes_i, lanes_i_shift_left, register_i_shift_left, lanes_i)
LANES_AND_INT(lanes_i, lanes_i_shift_right, register_i_shift_right, lanes_i)
LANES_BINARY(lanes_i, lanes_i_min, register_i_min, lanes_i)
LANES_BINARY(lanes_i, lanes_i_max, register_i_max, lanes_i)
LANES_SELECT(lanes_i, lanes_i_select, register_i_select, lanes_i)
LANES_BINARY(lanes_m, lanes_i_greater, register_i_greater, lanes_i)
LANES_BINARY(lanes_m, lanes_i_equal, register_i_equal, lanes_i)

GN_OPERATION uint32_t lanes_bits(lanes_m a)
{
    return registers_bits(a.q);
}

GN_OPERATION uint32_t lanes_i_sign_bits(lanes_i a)
{
    lanes_m negative;

    LANES_FOR_REGISTERS(negative.q[n] = register_negative(a.q[n]))
    return lanes_bits(negative);
}

GN_OPERATION lanes_m lanes_from_bits(uint32_t bits)
{
    LANES_EACH_REGISTER(lanes_m, register_from_bits(bits, n));
}

GN_OPERATION lanes_f lanes_load(const float p[LANES])
{
    LANES_EACH_REGISTER(lanes_f, register_load(p + REGISTER_LANES * n));
}

GN_OPERATION void lanes_store(float *p, lanes_f a){
    LANES_FOR_REGISTERS(register_store(p + REGISTER_LANES * n, a.q[n]))}

GN_OPERATION lanes_i lanes_i_load(const stored_word *p)
{
    LANES_EACH_REGISTER(lanes_i, register_i_load(p + REGISTER_LANES * n));
}

GN_OPERATION void lanes_i_store(stored_word *p, lanes_i a){
    LANES_FOR_REGISTERS(register_i_store(p + REGISTER_LANES * n, a.q[n]))}

GN_OPERATION lanes_f lanes_columns(float per_x, float x, float origin)
{
    const register_f column = register_add(register_splat(x), register_columns());
    const register_f value =
        register_add(register_mul(register_splat(per_x), column), register_splat(origin));

    LANES_EACH_REGISTER(lanes_f, value);
}

GN_OPERATION lanes_f lanes_rows(float per_y, float y)
{
    LANES_EACH_REGISTER(lanes_f, register_rows(per_y, y, n));
}

GN_OPERATION lanes_i lanes_i_plane(int32_t per_column, int32_t per_row)
{
    const register_i columns = register_i_columns(per_column);

    LANES_EACH_REGISTER(lanes_i, register_i_add(columns, register_i_rows(per_row, n)));
}

GN_OPERATION lanes_i lanes_i_splat_two(int32_t lower, int32_t upper)
{
#if LANES_REGISTERS == 1
    LANES_EACH_REGISTER(lanes_i, register_i_splat_two(lower, upper));
#else
    LANES_EACH_REGISTER(lanes_i, register_i_splat(2 * n < LANES_REGISTERS ? lower : upper));
#endif
}

#if LANES_REGISTERS == 4

GN_OPERATION lanes_f lanes_quad_lower(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, a.q[n & 2]);
}

GN_OPERATION lanes_f lanes_quad_upper(lanes_f a)
{
    LANES_EACH_REGISTER(lanes_f, a.q[n | 1]);
}

#else

LANES_UNARY(lanes_f, lanes_quad_lower, register_quad_lower, lanes_f)
LANES_UNARY(lanes_f, lanes_quad_upper, register_quad_upper, lanes_f)

#endif

#if defined(register_i_transpose_bytes)
#define register_pack_unorm8(red, green, blue, alpha) pack_by_shuffle(red, green, blue, alpha)

/* Returns a channel in units of 1/255. */
GN_OPERATION register_i register_unorm8(register_f channel)
{
    return register_round(register_mul(channel, register_splat(255.0f)));
}

/* Needs no clamp, since the packs saturate. */
GN_OPERATION register_i pack_by_shuffle(register_f red, register_f green, register_f blue,
                                        register_f alpha)
{
    const register_i rg = register_i_pack_words(register_unorm8(red), register_unorm8(green));
    const register_i ba = register_i_pack_words(register_unorm8(blue), register_unorm8(alpha));

    return register_i_transpose_bytes(register_i_pack_shorts(rg, ba));
}

#endif

GN_OPERATION lanes_i lanes_pack_unorm8(lanes_f red, lanes_f green, lanes_f blue, lanes_f alpha)
{
    LANES_EACH_REGISTER(lanes_i, register_pack_unorm8(red.q[n], green.q[n], blue.q[n], alpha.q[n]));
}

/* Channels 1 and 2 are converted in place, times a factor that is smaller by the same power of two,
 * which changes no rounding. */
GN_OPERATION lanes_f lanes_unpack_unorm8(lanes_i packed, int channel)
{
    const float scale = (float)(1.0 / 255.0) / (float)(1 << 8 * (channel % 3));
    const register_i byte = register_i_splat(0xFF << 8 * (channel % 3));

    if (channel == 3) {
        LANES_EACH_REGISTER(
            lanes_f,
            register_mul(register_to_float(register_i_shift_right_logical(packed.q[n], 24)),
                         register_splat(scale)));
    }
    LANES_EACH_REGISTER(lanes_f, register_mul(register_to_float(register_i_and(packed.q[n], byte)),
                                              register_splat(scale)));
}

/* The address of row 0 to 3 of a block, and that of row r of register n. */
#define LANES_BLOCK_ROW(row) (((row) < 2 ? lower : upper) + (row) % 2 * stride)
#define LANES_REGISTER_ROW(r) LANES_BLOCK_ROW(REGISTER_ROWS *n + (r))

GN_OPERATION lanes_i lanes_i_load_block(const unsigned char *lower, const unsigned char *upper,
                                        ptrdiff_t stride)
{
    LANES_EACH_REGISTER(lanes_i, register_i_load_rows(LANES_REGISTER_ROW));
}

GN_OPERATION void lanes_i_store_block(unsigned char *lower, unsigned char *upper, ptrdiff_t stride,
                                      lanes_i a){
    LANES_FOR_REGISTERS(register_i_store_rows(LANES_REGISTER_ROW, a.q[n]))}

/* Transposes 4x4 words: lane l of row r of register c becomes lane c of row r of register l. */
GN_OPERATION void registers_transpose(register_i r[4])
{
    const register_i a = register_i_interleave_low(r[0], r[2]);
    const register_i b = register_i_interleave_low(r[1], r[3]);
    const register_i c = register_i_interleave_high(r[0], r[2]);
    const register_i d = register_i_interleave_high(r[1], r[3]);

    r[0] = register_i_interleave_low(a, b);
    r[1] = register_i_interleave_high(a, b);
    r[2] = register_i_interleave_low(c, d);
    r[3] = register_i_interleave_high(c, d);
}

/* Writes register n of out[0] to out[3]. Row i of r[l] holds the four words of lane 4 * i + l of
 * that register. */
GN_OPERATION void lanes_from_rows(register_i r[4], int n, lanes_i out[4])
{
    registers_transpose(r);
    GN_UNROLLED
    for (int c = 0; c < 4; ++c)
        out[c].q[n] = r[c];
}

GN_OPERATION void lanes_to_rows(const lanes_i in[4], int n, register_i r[4])
{
    GN_UNROLLED
    for (int c = 0; c < 4; ++c)
        r[c] = in[c].q[n];
    registers_transpose(r);
}

/* The lane that is lane l of row r of register n. */
#define LANES_LANE(l, r) ((uint32_t)(REGISTER_LANES * n + 4 * (r) + (l)))
#define LANES_GATHERED_ROW(r) (memory + offset[LANES_LANE(l, r) * step])
#define LANES_SCATTERED_ROW(r) (memory + (size_t)LANES_LANE(l, r) * stride)

GN_OPERATION void lanes_i_gather_rows(const unsigned char *memory, const uint32_t *offset,
                                      uint32_t step, lanes_i out[4])
{
    GN_UNROLLED
    for (int n = 0; n < LANES_REGISTERS; ++n) {
        register_i r[4];

        GN_UNROLLED
        for (int l = 0; l < 4; ++l)
            r[l] = register_i_load_rows(LANES_GATHERED_ROW);
        lanes_from_rows(r, n, out);
    }
}

GN_OPERATION void lanes_i_scatter_rows(unsigned char *memory, size_t stride, const lanes_i in[4])
{
    GN_UNROLLED
    for (int n = 0; n < LANES_REGISTERS; ++n) {
        register_i r[4];

        lanes_to_rows(in, n, r);
        GN_UNROLLED
        for (int l = 0; l < 4; ++l)
            register_i_store_rows(LANES_SCATTERED_ROW, r[l]);
    }
}

/* Loads of single words and pairs take less time than gather instructions. */

GN_OPERATION void lanes_indices(lanes_i index, int32_t at[LANES]){
    LANES_FOR_REGISTERS(register_indices(at + REGISTER_LANES * n, index.q[n]))}

#define LANES_WORD(l) base[at[l]]
#define LANES_PAIR(l) (base + (ptrdiff_t)at[l] * size)

GN_OPERATION register_i register_gather(const stored_word *base, const int32_t *at)
{
    return register_i_set(LANES_WORD);
}

GN_INLINE lanes_i lanes_i_gather(const stored_word *base, lanes_i index)
{
    int32_t at[LANES];

    lanes_indices(index, at);
    LANES_EACH_REGISTER(lanes_i, register_gather(base, at + REGISTER_LANES * n));
}

/* Loads the pairs of words at base + size * at[l]. */
GN_OPERATION void register_gather_pairs(const unsigned char *base, const int32_t *at, int size,
                                        register_i *first, register_i *second)
{
    const register_f a = register_load_pairs(LANES_PAIR, 0);
    const register_f b = register_load_pairs(LANES_PAIR, 2);

    *first = register_as_int(register_even(a, b));
    *second = register_as_int(register_odd(a, b));
}

GN_INLINE void lanes_i_gather_pairs(const stored_word *base, lanes_i index, lanes_i *first,
                                    lanes_i *second)
{
    int32_t at[LANES];

    lanes_indices(index, at);
    GN_UNROLLED
    for (int n = 0; n < LANES_REGISTERS; ++n)
        register_gather_pairs((const unsigned char *)base, at + REGISTER_LANES * n, 4, &first->q[n],
                              &second->q[n]);
}

#endif
