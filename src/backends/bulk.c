/* Operations on many vectors or matrices. A back end works on whole blocks of lanes in the caller's
 * arrays. The vectors left over are copied to one more block on the stack. */
#include <gnomon/bulk.h>
#include <gnomon/lanes.h>

#include "entry_points.h"

/* Returns the back end that GN_BACKEND_AUTO stands for; any other is returned as it is. */
static gn_backend backend_for(gn_backend backend, size_t count)
{
    if (backend != GN_BACKEND_AUTO)
        return backend;
    return count >= GN_BULK_ASK ? gn_backend_best() : backend_of_every_processor();
}

/* Works on the last `rest` vectors, fewer than a block, to which the job's pointers point. */
static void run_rest(gn_backend backend, bulk_job *job, size_t rest)
{
    const int components = job->kind == BULK_VEC4 ? 4 : 3;
    const int arrays = job->packed ? 1 : components;
    const size_t floats = job->packed ? rest * (size_t)components : rest;
    float block[4 * GN_LANES];
    float *to[4];

    for (int i = 0; i < 4 * GN_LANES; ++i)
        block[i] = 0.0f;
    for (int array = 0; array < arrays; ++array) {
        float *own = block + array * GN_LANES;

        for (size_t i = 0; i < floats; ++i)
            own[i] = job->v[array][i];
        to[array] = job->result[array];
        job->v[array] = job->result[array] = own;
    }
    job->count = GN_LANES;
    bulk_on(backend, job);
    for (int array = 0; array < arrays; ++array)
        for (size_t i = 0; i < floats; ++i)
            to[array][i] = job->result[array][i];
}

static gn_status run(bulk_job *job, size_t count, gn_backend asked)
{
    const gn_backend backend = backend_for(asked, count);
    const size_t rest = count % GN_LANES;
    const int components = job->kind == BULK_VEC4 ? 4 : 3;
    const int arrays = job->packed ? 1 : components;

    if (!backend_is_compiled(backend))
        return GN_BACKEND_UNAVAILABLE;
    job->count = count - rest;
    if (job->count > 0)
        bulk_on(backend, job);
    if (rest > 0) {
        for (int i = 0; i < arrays; ++i) {
            job->v[i] += job->packed ? job->count * (size_t)components : job->count;
            job->result[i] += job->packed ? job->count * (size_t)components : job->count;
        }
        run_rest(backend, job, rest);
    }
    return GN_OK;
}

static bool take_mat4(bulk_job *job, bulk_kind kind, const gn_mat4 *m)
{
    if (!m)
        return false;
    job->kind = kind;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            job->m[column][row] = m->m[column][row];
    return true;
}

/* Takes only the part of the matrix that BULK_DIRECTION reads. */
static bool take_mat3(bulk_job *job, const gn_mat3 *m)
{
    if (!m)
        return false;
    job->kind = BULK_DIRECTION;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            job->m[column][row] = m->m[column][row];
    return true;
}

/* v and result are arrays of gn_vec3 or gn_vec4, whose components are read as consecutive floats.
 */
static gn_status run_packed(bulk_job *job, const void *v, void *result, size_t count,
                            gn_backend backend)
{
    if (count > 0 && (!v || !result))
        return GN_NULL_POINTER;
    job->packed = true;
    job->v[0] = (const float *)v;
    job->result[0] = (float *)result;
    return run(job, count, backend);
}

static gn_status run_arrays(bulk_job *job, const float *const *v, float *const *result,
                            size_t count, gn_backend backend)
{
    const int components = job->kind == BULK_VEC4 ? 4 : 3;

    if (count > 0 && (!v || !result))
        return GN_NULL_POINTER;
    for (int i = 0; count > 0 && i < components; ++i) {
        if (!v[i] || !result[i])
            return GN_NULL_POINTER;
        job->v[i] = v[i];
        job->result[i] = result[i];
    }
    job->packed = false;
    return run(job, count, backend);
}

gn_status gn_mat4_multiply_packed(const gn_mat4 *a, const gn_mat4 *b, gn_mat4 *result, size_t count,
                                  gn_backend backend)
{
    bulk_job job;

    if (count > 0 && (!a || !b || !result))
        return GN_NULL_POINTER;
    backend = backend_for(backend, 4 * count);
    if (!backend_is_compiled(backend))
        return GN_BACKEND_UNAVAILABLE;
    if (count > 0) {
        job.kind = BULK_MATRIX;
        job.packed = true;
        job.left = a->m[0];
        job.v[0] = b->m[0];
        job.result[0] = result->m[0];
        job.count = count;
        bulk_on(backend, &job);
    }
    return GN_OK;
}

gn_status gn_mat4_multiply_vec4_packed(const gn_mat4 *m, const gn_vec4 *v, gn_vec4 *result,
                                       size_t count, gn_backend backend)
{
    bulk_job job;

    if (!take_mat4(&job, BULK_VEC4, m))
        return GN_NULL_POINTER;
    return run_packed(&job, v, result, count, backend);
}

gn_status gn_mat4_multiply_vec4_arrays(const gn_mat4 *m, const float *const v[4],
                                       float *const result[4], size_t count, gn_backend backend)
{
    bulk_job job;

    if (!take_mat4(&job, BULK_VEC4, m))
        return GN_NULL_POINTER;
    return run_arrays(&job, v, result, count, backend);
}

gn_status gn_mat4_transform_point_packed(const gn_mat4 *m, const gn_vec3 *v, gn_vec3 *result,
                                         size_t count, gn_backend backend)
{
    bulk_job job;

    if (!take_mat4(&job, BULK_POINT, m))
        return GN_NULL_POINTER;
    return run_packed(&job, v, result, count, backend);
}

gn_status gn_mat4_transform_point_arrays(const gn_mat4 *m, const float *const v[3],
                                         float *const result[3], size_t count, gn_backend backend)
{
    bulk_job job;

    if (!take_mat4(&job, BULK_POINT, m))
        return GN_NULL_POINTER;
    return run_arrays(&job, v, result, count, backend);
}

gn_status gn_mat4_transform_direction_packed(const gn_mat4 *m, const gn_vec3 *v, gn_vec3 *result,
                                             size_t count, gn_backend backend)
{
    bulk_job job;

    if (!take_mat4(&job, BULK_DIRECTION, m))
        return GN_NULL_POINTER;
    return run_packed(&job, v, result, count, backend);
}

gn_status gn_mat4_transform_direction_arrays(const gn_mat4 *m, const float *const v[3],
                                             float *const result[3], size_t count,
                                             gn_backend backend)
{
    bulk_job job;

    if (!take_mat4(&job, BULK_DIRECTION, m))
        return GN_NULL_POINTER;
    return run_arrays(&job, v, result, count, backend);
}

gn_status gn_mat3_multiply_vec3_packed(const gn_mat3 *m, const gn_vec3 *v, gn_vec3 *result,
                                       size_t count, gn_backend backend)
{
    bulk_job job;

    if (!take_mat3(&job, m))
        return GN_NULL_POINTER;
    return run_packed(&job, v, result, count, backend);
}

gn_status gn_mat3_multiply_vec3_arrays(const gn_mat3 *m, const float *const v[3],
                                       float *const result[3], size_t count, gn_backend backend)
{
    bulk_job job;

    if (!take_mat3(&job, m))
        return GN_NULL_POINTER;
    return run_arrays(&job, v, result, count, backend);
}
