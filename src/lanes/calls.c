/* The functions that calls.h declares. */
#define GN_LANES_CALLS_DEFINE
#include "lanes.h"

#if GN_LANES_CALLED

#define GN_OPERAND(type, a) (*(const type *)(const void *)(a))

#define GN_DEFINE_UNARY(result, name, type)                                                        \
    result gni_lanes_##name(const GN_ELEMENT_##type *a)                                            \
    {                                                                                              \
        return lanes_##name(GN_OPERAND(type, a));                                                  \
    }
#define GN_DEFINE_BINARY(result, name, type)                                                       \
    result gni_lanes_##name(const GN_ELEMENT_##type *a, const GN_ELEMENT_##type *b)                \
    {                                                                                              \
        return lanes_##name(GN_OPERAND(type, a), GN_OPERAND(type, b));                             \
    }
#define GN_DEFINE_SELECT(type, name)                                                               \
    type gni_lanes_##name(const uint32_t *m, const GN_ELEMENT_##type *a,                           \
                          const GN_ELEMENT_##type *b)                                              \
    {                                                                                              \
        return lanes_##name(GN_OPERAND(lanes_m, m), GN_OPERAND(type, a), GN_OPERAND(type, b));     \
    }
#define GN_DEFINE_CONSTANT(result, name, type)                                                     \
    result gni_lanes_##name(const GN_ELEMENT_##type *a, int b)                                     \
    {                                                                                              \
        return lanes_##name(GN_OPERAND(type, a), b);                                               \
    }

GN_LANES_CALLS(GN_DEFINE_UNARY, GN_DEFINE_BINARY, GN_DEFINE_SELECT, GN_DEFINE_CONSTANT)

void gni_lanes_store(float *p, const float *a)
{
    lanes_store(p, GN_OPERAND(lanes_f, a));
}

void gni_lanes_i_store(stored_word *p, const int32_t *a)
{
    lanes_i_store(p, GN_OPERAND(lanes_i, a));
}

void gni_lanes_i_store_block(unsigned char *lower, unsigned char *upper, ptrdiff_t stride,
                             const int32_t *a)
{
    lanes_i_store_block(lower, upper, stride, GN_OPERAND(lanes_i, a));
}

lanes_i gni_lanes_pack_unorm8(const float *red, const float *green, const float *blue,
                              const float *alpha)
{
    return lanes_pack_unorm8(GN_OPERAND(lanes_f, red), GN_OPERAND(lanes_f, green),
                             GN_OPERAND(lanes_f, blue), GN_OPERAND(lanes_f, alpha));
}

#endif
