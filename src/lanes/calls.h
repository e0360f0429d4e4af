/* The operations of the portable lanes as functions that take addresses, so that code is small:
 * passing 64 bytes by value takes more code at every call than most operations. Each operand is
 * passed as the array in its structure, which decays to its address even in the result of another
 * operation. Such a result lives until the end of the expression (C11 6.2.4; GCC and Clang do the
 * same in C99). Operations that are not listed here pass by value.
 * Not alone: lanes.h includes it after the portable form, whose types it uses. */
#ifndef GN_LANES_CALLS_H
#define GN_LANES_CALLS_H

#define GN_ELEMENT_lanes_f float
#define GN_ELEMENT_lanes_i int32_t
#define GN_ELEMENT_lanes_m uint32_t

/* The arguments: the type of the result, the name, the type of the operands. */
#define GN_LANES_CALLS(UNARY, BINARY, SELECT, CONSTANT)                                            \
    BINARY(lanes_f, add, lanes_f)                                                                  \
    BINARY(lanes_f, sub, lanes_f)                                                                  \
    BINARY(lanes_f, mul, lanes_f)                                                                  \
    BINARY(lanes_f, div, lanes_f)                                                                  \
    UNARY(lanes_f, sqrt, lanes_f)                                                                  \
    BINARY(lanes_f, min, lanes_f)                                                                  \
    BINARY(lanes_f, max, lanes_f)                                                                  \
    BINARY(lanes_m, greater, lanes_f)                                                              \
    BINARY(lanes_m, less_equal, lanes_f)                                                           \
    BINARY(lanes_m, and, lanes_m)                                                                  \
    UNARY(lanes_m, not, lanes_m)                                                                   \
    UNARY(uint32_t, bits, lanes_m)                                                                 \
    SELECT(lanes_f, select)                                                                        \
    UNARY(lanes_i, m_as_int, lanes_m)                                                              \
    UNARY(lanes_i, truncate, lanes_f)                                                              \
    UNARY(lanes_i, round, lanes_f)                                                                 \
    UNARY(lanes_f, floor, lanes_f)                                                                 \
    UNARY(lanes_f, to_float, lanes_i)                                                              \
    UNARY(lanes_i, as_int, lanes_f)                                                                \
    UNARY(lanes_f, as_float, lanes_i)                                                              \
    BINARY(lanes_i, i_add, lanes_i)                                                                \
    BINARY(lanes_i, i_sub, lanes_i)                                                                \
    BINARY(lanes_i, i_mul, lanes_i)                                                                \
    BINARY(lanes_i, i_or, lanes_i)                                                                 \
    BINARY(lanes_i, i_and, lanes_i)                                                                \
    CONSTANT(lanes_i, i_shift_left, lanes_i)                                                       \
    CONSTANT(lanes_i, i_shift_right, lanes_i)                                                      \
    BINARY(lanes_i, i_min, lanes_i)                                                                \
    BINARY(lanes_i, i_max, lanes_i)                                                                \
    SELECT(lanes_i, i_select)                                                                      \
    BINARY(lanes_m, i_greater, lanes_i)                                                            \
    BINARY(lanes_m, i_equal, lanes_i)                                                              \
    UNARY(uint32_t, i_sign_bits, lanes_i)                                                          \
    CONSTANT(lanes_f, unpack_unorm8, lanes_i)

#define GN_DECLARE_UNARY(result, name, type) result gni_lanes_##name(const GN_ELEMENT_##type *a);
#define GN_DECLARE_BINARY(result, name, type)                                                      \
    result gni_lanes_##name(const GN_ELEMENT_##type *a, const GN_ELEMENT_##type *b);
#define GN_DECLARE_SELECT(type, name)                                                              \
    type gni_lanes_##name(const uint32_t *m, const GN_ELEMENT_##type *a,                           \
                          const GN_ELEMENT_##type *b);
#define GN_DECLARE_CONSTANT(result, name, type)                                                    \
    result gni_lanes_##name(const GN_ELEMENT_##type *a, int b);

GN_LANES_CALLS(GN_DECLARE_UNARY, GN_DECLARE_BINARY, GN_DECLARE_SELECT, GN_DECLARE_CONSTANT)
void gni_lanes_store(float *p, const float *a);
void gni_lanes_i_store(stored_word *p, const int32_t *a);
void gni_lanes_i_store_block(unsigned char *lower, unsigned char *upper, ptrdiff_t stride,
                             const int32_t *a);
lanes_i gni_lanes_pack_unorm8(const float *red, const float *green, const float *blue,
                              const float *alpha);

#if !defined(GN_LANES_CALLS_DEFINE)
#define lanes_store(p, a) gni_lanes_store(p, (a).v)
#define lanes_add(a, b) gni_lanes_add((a).v, (b).v)
#define lanes_sub(a, b) gni_lanes_sub((a).v, (b).v)
#define lanes_mul(a, b) gni_lanes_mul((a).v, (b).v)
#define lanes_div(a, b) gni_lanes_div((a).v, (b).v)
#define lanes_sqrt(a) gni_lanes_sqrt((a).v)
#define lanes_min(a, b) gni_lanes_min((a).v, (b).v)
#define lanes_max(a, b) gni_lanes_max((a).v, (b).v)
#define lanes_greater(a, b) gni_lanes_greater((a).v, (b).v)
#define lanes_less_equal(a, b) gni_lanes_less_equal((a).v, (b).v)
#define lanes_and(a, b) gni_lanes_and((a).v, (b).v)
#define lanes_not(a) gni_lanes_not((a).v)
#define lanes_bits(a) gni_lanes_bits((a).v)
#define lanes_select(m, a, b) gni_lanes_select((m).v, (a).v, (b).v)
#define lanes_m_as_int(a) gni_lanes_m_as_int((a).v)
#define lanes_truncate(a) gni_lanes_truncate((a).v)
#define lanes_round(a) gni_lanes_round((a).v)
#define lanes_floor(a) gni_lanes_floor((a).v)
#define lanes_to_float(a) gni_lanes_to_float((a).v)
#define lanes_as_int(a) gni_lanes_as_int((a).v)
#define lanes_as_float(a) gni_lanes_as_float((a).v)
#define lanes_i_store(p, a) gni_lanes_i_store(p, (a).v)
#define lanes_i_add(a, b) gni_lanes_i_add((a).v, (b).v)
#define lanes_i_sub(a, b) gni_lanes_i_sub((a).v, (b).v)
#define lanes_i_mul(a, b) gni_lanes_i_mul((a).v, (b).v)
#define lanes_i_or(a, b) gni_lanes_i_or((a).v, (b).v)
#define lanes_i_and(a, b) gni_lanes_i_and((a).v, (b).v)
#define lanes_i_shift_left(a, count) gni_lanes_i_shift_left((a).v, count)
#define lanes_i_shift_right(a, count) gni_lanes_i_shift_right((a).v, count)
#define lanes_i_min(a, b) gni_lanes_i_min((a).v, (b).v)
#define lanes_i_max(a, b) gni_lanes_i_max((a).v, (b).v)
#define lanes_i_select(m, a, b) gni_lanes_i_select((m).v, (a).v, (b).v)
#define lanes_i_greater(a, b) gni_lanes_i_greater((a).v, (b).v)
#define lanes_i_equal(a, b) gni_lanes_i_equal((a).v, (b).v)
#define lanes_i_sign_bits(a) gni_lanes_i_sign_bits((a).v)
#define lanes_i_store_block(lower, upper, stride, a)                                               \
    gni_lanes_i_store_block(lower, upper, stride, (a).v)
#define lanes_pack_unorm8(red, green, blue, alpha)                                                 \
    gni_lanes_pack_unorm8((red).v, (green).v, (blue).v, (alpha).v)
#define lanes_unpack_unorm8(packed, channel) gni_lanes_unpack_unorm8((packed).v, channel)
#endif

#endif
