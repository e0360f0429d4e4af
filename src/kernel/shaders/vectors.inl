/* Vectors over lanes, in the order of operations of the reference's GLSL (reference/RULES.md): dot
 * products are summed from the last component to the first. */
#ifndef GN_KERNEL_SHADERS_VECTORS_INL
#define GN_KERNEL_SHADERS_VECTORS_INL

#include "../../lanes/lanes.h"

#include <gnomon/mat.h>

static inline void load_vector(const float (*rows)[GN_LANES], lanes_f v[3])
{
    for (int c = 0; c < 3; ++c)
        v[c] = lanes_load(rows[c]);
}

static inline void store_vector(const lanes_f v[3], float (*rows)[GN_LANES])
{
    for (int c = 0; c < 3; ++c)
        lanes_store(rows[c], v[c]);
}

static inline void splat_vector(gn_vec3 a, lanes_f v[3])
{
    v[0] = lanes_splat(a.x);
    v[1] = lanes_splat(a.y);
    v[2] = lanes_splat(a.z);
}

static inline void copy_vector(const lanes_f from[3], lanes_f to[3])
{
    for (int c = 0; c < 3; ++c)
        to[c] = from[c];
}

static inline lanes_f dot(const lanes_f a[3], const lanes_f b[3])
{
    return lanes_add(lanes_add(lanes_mul(a[2], b[2]), lanes_mul(a[1], b[1])),
                     lanes_mul(a[0], b[0]));
}

static inline void scale_vector(lanes_f v[3], lanes_f scale)
{
    for (int c = 0; c < 3; ++c)
        v[c] = lanes_mul(v[c], scale);
}

static inline lanes_f one_over(lanes_f a)
{
    return lanes_div(lanes_splat(1.0f), a);
}

/* Normalizes a vector; a zero vector becomes NaN. */
static inline void normalize(lanes_f v[3])
{
    scale_vector(v, one_over(lanes_sqrt(dot(v, v))));
}

/* Normalizes a vector; a zero vector stays 0. */
static inline void normalize_or_zero(lanes_f v[3])
{
    const lanes_f zero = lanes_splat(0.0f);
    const lanes_f squared = dot(v, v);

    scale_vector(v,
                 lanes_select(lanes_greater(squared, zero), one_over(lanes_sqrt(squared)), zero));
}

static inline void cross(const lanes_f a[3], const lanes_f b[3], lanes_f out[3])
{
    out[0] = lanes_sub(lanes_mul(a[1], b[2]), lanes_mul(b[1], a[2]));
    out[1] = lanes_sub(lanes_mul(a[2], b[0]), lanes_mul(b[2], a[0]));
    out[2] = lanes_sub(lanes_mul(a[0], b[1]), lanes_mul(b[0], a[1]));
}

/* Returns the greater of a and 0; 0 for NaN. */
static inline lanes_f above_zero(lanes_f a)
{
    const lanes_f zero = lanes_splat(0.0f);

    return lanes_select(lanes_greater(a, zero), a, zero);
}

/* Returns m0*x + m1*y + m2*z, summed from left to right. */
static inline lanes_f sum_of_products(float m0, lanes_f x, float m1, lanes_f y, float m2, lanes_f z)
{
    return lanes_add(lanes_add(lanes_mul(lanes_splat(m0), x), lanes_mul(lanes_splat(m1), y)),
                     lanes_mul(lanes_splat(m2), z));
}

static inline void turn_by_mat3(const gn_mat3 *m, const lanes_f v[3], lanes_f out[3])
{
    for (int row = 0; row < 3; ++row)
        out[row] = sum_of_products(m->m[0][row], v[0], m->m[1][row], v[1], m->m[2][row], v[2]);
}

/* Multiplies a vector by the upper-left 3x3 of a matrix. */
static inline void turn_by_mat4(const gn_mat4 *m, const lanes_f v[3], lanes_f out[3])
{
    for (int row = 0; row < 3; ++row)
        out[row] = sum_of_products(m->m[0][row], v[0], m->m[1][row], v[1], m->m[2][row], v[2]);
}

/* Writes the first `rows` rows of m * (x, y, z, w). */
static inline void transform(const gn_mat4 *m, const lanes_f v[4], int rows, lanes_f out[4])
{
    GN_UNROLLED
    for (int row = 0; row < rows; ++row)
        out[row] =
            lanes_add(sum_of_products(m->m[0][row], v[0], m->m[1][row], v[1], m->m[2][row], v[2]),
                      lanes_mul(lanes_splat(m->m[3][row]), v[3]));
}

#endif
