/* Products of many vectors and matrices, over lanes. Every back end compiles this code. The order
 * of operations is that of the functions for one vector (src/math/matrix.c). */
#ifndef GN_KERNEL_MATH_BULK_INL
#define GN_KERNEL_MATH_BULK_INL

#include "../../lanes/packed.h"
#include "bulk_job.h"

/* A copy of the matrix in memory that no result can overlap, so that it is read only once. */
typedef struct bulk_matrix {
    float m[4][4];
} bulk_matrix;

GN_INLINE bulk_matrix bulk_own_matrix(const bulk_job *job)
{
    bulk_matrix own;

    for (int i = 0; i < 16; ++i)
        own.m[i / 4][i % 4] = job->m[i / 4][i % 4];
    return own;
}

/* Returns one component of the products with GN_LANES vectors. */
GN_INLINE lanes_f bulk_row(const bulk_matrix *c, int row, bulk_kind kind, const lanes_f *v)
{
    const lanes_f x = lanes_mul(lanes_splat(c->m[0][row]), v[0]);
    const lanes_f y = lanes_mul(lanes_splat(c->m[1][row]), v[1]);
    const lanes_f z = lanes_mul(lanes_splat(c->m[2][row]), v[2]);
    const lanes_f sum = lanes_add(lanes_add(x, y), z);

    switch (kind) {
    case BULK_VEC4:
        return lanes_add(sum, lanes_mul(lanes_splat(c->m[3][row]), v[3]));
    case BULK_POINT:
        return lanes_add(sum, lanes_splat(c->m[3][row]));
    default:
        return sum;
    }
}

GN_INLINE void bulk_arrays(const bulk_job *job, bulk_kind kind)
{
    const int components = kind == BULK_VEC4 ? 4 : 3;
    const bulk_matrix own = bulk_own_matrix(job);
    const float *from[4];
    float *to[4];

    for (int i = 0; i < components; ++i) {
        from[i] = job->v[i];
        to[i] = job->result[i];
    }
    for (size_t at = 0, end = job->count; at < end; at += GN_LANES) {
        lanes_f v[4];

        for (int i = 0; i < components; ++i)
            v[i] = lanes_load(from[i] + at);
        for (int i = 0; i < components; ++i)
            lanes_store(to[i] + at, bulk_row(&own, i, kind, v));
    }
}

GN_INLINE void bulk_packed_vec3(const bulk_job *job, bulk_kind kind)
{
    const bulk_matrix own = bulk_own_matrix(job);
    const float *from = job->v[0];
    float *to = job->result[0];

    for (size_t at = 0, end = 3 * job->count; at < end; at += 3 * GN_LANES) {
        lanes_f v[3], product[3];

        lanes_load_vec3(from + at, v);
        for (int i = 0; i < 3; ++i)
            product[i] = bulk_row(&own, i, kind, v);
        lanes_store_vec3(to + at, product);
    }
}

#if GN_LANES == 1
/* One lane holds no column: vectors and columns of the right matrices are multiplied one after the
 * other. */
GN_INLINE void bulk_product(const bulk_matrix *m, const float *from, float *to)
{
    lanes_f v[4];

    for (int i = 0; i < 4; ++i)
        v[i] = lanes_load(from + i);
    for (int i = 0; i < 4; ++i)
        lanes_store(to + i, bulk_row(m, i, BULK_VEC4, v));
}

static void bulk_packed_vec4(const bulk_job *job)
{
    const bulk_matrix own = bulk_own_matrix(job);

    for (size_t at = 0, end = 4 * job->count; at < end; at += 4)
        bulk_product(&own, job->v[0] + at, job->result[0] + at);
}

static void bulk_packed_mat4(const bulk_job *job)
{
    for (size_t at = 0, end = 16 * job->count; at < end; at += 16) {
        bulk_matrix left; /* the result may overwrite the matrix itself */

        for (int i = 0; i < 16; ++i)
            left.m[i / 4][i % 4] = job->left[at + (size_t)i];
        for (size_t column = at; column < at + 16; column += 4)
            bulk_product(&left, job->v[0] + column, job->result[0] + column);
    }
}

#else
/* Multiplies as many vectors as there are groups of four lanes, each by whole columns. */
GN_INLINE lanes_f bulk_columns(lanes_f c0, lanes_f c1, lanes_f c2, lanes_f c3, lanes_f vectors)
{
    lanes_f v[4];

    lanes_spread(vectors, v);
    const lanes_f xy = lanes_add(lanes_mul(c0, v[0]), lanes_mul(c1, v[1]));
    const lanes_f xyz = lanes_add(xy, lanes_mul(c2, v[2]));
    return lanes_add(xyz, lanes_mul(c3, v[3]));
}

static void bulk_packed_vec4(const bulk_job *job)
{
    const lanes_f c0 = lanes_splat_vec4(job->m[0]), c1 = lanes_splat_vec4(job->m[1]);
    const lanes_f c2 = lanes_splat_vec4(job->m[2]), c3 = lanes_splat_vec4(job->m[3]);
    const float *from = job->v[0];
    float *to = job->result[0];

    for (size_t at = 0, end = 4 * job->count; at < end; at += GN_LANES)
        lanes_store(to + at, bulk_columns(c0, c1, c2, c3, lanes_load(from + at)));
}

/* Multiplies matrices; the lanes hold one matrix. */
static void bulk_packed_mat4(const bulk_job *job)
{
    const float *left = job->left, *from = job->v[0];
    float *to = job->result[0];

    for (size_t at = 0, end = 16 * job->count; at < end; at += 16) {
        const lanes_f c0 = lanes_splat_vec4(left + at), c1 = lanes_splat_vec4(left + at + 4);
        const lanes_f c2 = lanes_splat_vec4(left + at + 8), c3 = lanes_splat_vec4(left + at + 12);

        lanes_store(to + at, bulk_columns(c0, c1, c2, c3, lanes_load(from + at)));
    }
}

#endif

static void run_bulk(const bulk_job *job)
{
    switch (job->kind) {
    case BULK_MATRIX:
        bulk_packed_mat4(job);
        break;
    case BULK_VEC4:
        if (job->packed)
            bulk_packed_vec4(job);
        else
            bulk_arrays(job, BULK_VEC4);
        break;
    case BULK_POINT:
        if (job->packed)
            bulk_packed_vec3(job, BULK_POINT);
        else
            bulk_arrays(job, BULK_POINT);
        break;
    default:
        if (job->packed)
            bulk_packed_vec3(job, BULK_DIRECTION);
        else
            bulk_arrays(job, BULK_DIRECTION);
        break;
    }
}

#endif
