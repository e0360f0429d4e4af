/* Matrices beside cglm's. A sum of n products is off by n u of their magnitudes (mat.h). */
#include <string.h>

#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>

#include "matrices.h"
#include "rows.h"
#include "wide.h"

/* The product of n x n matrices, a column at a time. */
static void exact_product(const float *in, int n, int columns, struct exact *exact)
{
    for (int i = 0; i < n * columns; ++i)
        exact->value[i] =
            sum_of_products(in + i % n, n, in + n * n + i / n * n, 1, n, &exact->scale[i]);
}

OWN(multiply3)
{
    const gn_mat3 a = mat3_of(in), b = mat3_of(in + 9);
    gn_mat3 r;
    gn_mat3_multiply(&a, &b, &r);
    return put_matrix(&r, out, sizeof r);
}
OTHER(multiply3)
{
    glm_mat3_mul((vec3 *)in, (vec3 *)(in + 9), (vec3 *)out);
}
EXACT(multiply3)
{
    exact_product(in, 3, 3, exact);
}

OWN(multiply4)
{
    const gn_mat4 a = mat4_of(in), b = mat4_of(in + 16);
    gn_mat4 r;
    gn_mat4_multiply(&a, &b, &r);
    return put_matrix(&r, out, sizeof r);
}
OTHER(multiply4)
{
    glm_mat4_mul((vec4 *)in, (vec4 *)(in + 16), (vec4 *)out);
}
EXACT(multiply4)
{
    exact_product(in, 4, 4, exact);
}

OWN(vector3)
{
    const gn_mat3 m = mat3_of(in);
    return put_vec3(gn_mat3_multiply_vec3(&m, vec3_of(in + 9)), out);
}
OTHER(vector3)
{
    glm_mat3_mulv((vec3 *)in, in + 9, out);
}
EXACT(vector3)
{
    exact_product(in, 3, 1, exact);
}

OWN(vector4)
{
    const gn_mat4 m = mat4_of(in);
    return put_vec4(gn_mat4_multiply_vec4(&m, vec4_of(in + 16)), out);
}
OTHER(vector4)
{
    glm_mat4_mulv((vec4 *)in, in + 16, out);
}
EXACT(vector4)
{
    exact_product(in, 4, 1, exact);
}

OWN(point)
{
    const gn_mat4 m = mat4_of(in);
    return put_vec3(gn_mat4_transform_point(&m, vec3_of(in + 16)), out);
}
OTHER(point)
{
    glm_mat4_mulv3((vec4 *)in, in + 16, 1.0f, out);
}
static void with_w(const float *in, float w, struct exact *exact)
{
    float copy[20];
    memcpy(copy, in, sizeof copy);
    copy[19] = w;
    exact_product(copy, 4, 1, exact);
}
EXACT(point)
{
    with_w(in, 1.0f, exact);
}

OWN(direction)
{
    const gn_mat4 m = mat4_of(in);
    return put_vec3(gn_mat4_transform_direction(&m, vec3_of(in + 16)), out);
}
OTHER(direction)
{
    glm_mat4_mulv3((vec4 *)in, in + 16, 0.0f, out);
}
EXACT(direction)
{
    with_w(in, 0.0f, exact);
}

OWN(transpose3)
{
    gn_mat3 m = mat3_of(in);
    gn_mat3_transpose(&m, &m);
    return put_matrix(&m, out, sizeof m);
}
OTHER(transpose3)
{
    glm_mat3_transpose_to((vec3 *)in, (vec3 *)out);
}
EXACT(transpose3)
{
    for (int i = 0; i < 9; ++i)
        relative(exact, i, (wide)in[i % 3 * 3 + i / 3]);
}

OWN(transpose4)
{
    gn_mat4 m = mat4_of(in);
    gn_mat4_transpose(&m, &m);
    return put_matrix(&m, out, sizeof m);
}
OTHER(transpose4)
{
    glm_mat4_transpose_to((vec4 *)in, (vec4 *)out);
}
EXACT(transpose4)
{
    for (int i = 0; i < 16; ++i)
        relative(exact, i, (wide)in[i % 4 * 4 + i / 4]);
}

OWN(trace)
{
    const gn_mat4 m = mat4_of(in);
    return put(gn_mat4_trace(&m), out);
}
OTHER(trace)
{
    *out = glm_mat4_trace((vec4 *)in);
}
EXACT(trace)
{
    for (int i = 0; i < 4; ++i) {
        exact->value[0] += (wide)in[5 * i];
        exact->scale[0] += fabsl((wide)in[5 * i]);
    }
}

/* Sums are taken in the order of the shaders that pictures are compared with (mat.h). */
static const char glsl_order[] = "the order of operations is GLSL's";

static const struct row rows[] = {
    ROW(multiply3, "mat3 multiply", 18, 9, 50, NULL, 3, 3, .fixed = glsl_order),
    ROW(multiply4, "mat4 multiply", 32, 16, 50, NULL, 4, 4, .fixed = glsl_order),
    ROW(vector3, "mat3 times vec3", 12, 3, 50, NULL, 3, 3, .fixed = glsl_order),
    ROW(vector4, "mat4 times vec4", 20, 4, 50, NULL, 4, 4, .fixed = glsl_order),
    ROW(point, "mat4 transform point", 20, 3, 50, NULL, 4, 4, .fixed = glsl_order),
    ROW(direction, "mat4 transform direction", 20, 3, 50, NULL, 3, 4, .fixed = glsl_order),
    ROW(transpose3, "mat3 transpose", 9, 9, 120, NULL, 0, 0),
    ROW(transpose4, "mat4 transpose", 16, 16, 120, NULL, 0, 0),
    ROW(trace, "mat4 trace", 16, 1, 60, NULL, 3, 3),
};

const struct table matrix_rows = {rows, sizeof rows / sizeof rows[0]};
