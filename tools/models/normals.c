/* Computes normals from positions. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model.h"

/* A vertex, sorted by its position and its smoothing. */
typedef struct located {
    float position[3];
    uint32_t smoothing;
    uint32_t vertex;
    size_t part;
} located;

static int compare_positions(const void *a, const void *b)
{
    const float *p = ((const located *)a)->position;
    const float *q = ((const located *)b)->position;
    for (int i = 0; i < 3; ++i)
        if (p[i] != q[i])
            return p[i] < q[i] ? -1 : 1;
    const uint32_t r = ((const located *)a)->smoothing, s = ((const located *)b)->smoothing;
    return r < s ? -1 : r > s;
}

static void subtract(const float *a, const float *b, double result[3])
{
    for (int i = 0; i < 3; ++i)
        result[i] = (double)a[i] - (double)b[i];
}

static void cross(const double a[3], const double b[3], double result[3])
{
    result[0] = a[1] * b[2] - a[2] * b[1];
    result[1] = a[2] * b[0] - a[0] * b[2];
    result[2] = a[0] * b[1] - a[1] * b[0];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The triangle's normal, of unit length; false if the triangle has no area. */
static bool face_normal(const float *a, const float *b, const float *c, double result[3])
{
    double ab[3];
    double ac[3];
    subtract(b, a, ab);
    subtract(c, a, ac);
    cross(ab, ac, result);
    double length = sqrt(dot(result, result));
    if (!(length > 0.0) || !isfinite(length))
        return false;
    for (int i = 0; i < 3; ++i)
        result[i] /= length;
    return true;
}

static double corner_angle(const float *corner, const float *next, const float *previous)
{
    double a[3];
    double b[3];
    double c[3];
    subtract(next, corner, a);
    subtract(previous, corner, b);
    cross(a, b, c);
    return atan2(sqrt(dot(c, c)), dot(a, b));
}

static bool is_normal(const float *n)
{
    return isfinite(n[0]) && isfinite(n[1]) && isfinite(n[2]) &&
           (n[0] != 0.0f || n[1] != 0.0f || n[2] != 0.0f);
}

/* Adds each triangle's weighted normal to the sums of its three corners. */
static void add_faces(const model_part *part, double *sums)
{
    for (size_t i = 0; part->kind == MODEL_TRIANGLES && i + 2 < part->index_count; i += 3) {
        const uint32_t *v = part->indices + i;
        const float *corner[3];
        double normal[3];
        for (int k = 0; k < 3; ++k)
            corner[k] = part->positions + 3 * (size_t)v[k];
        if (!face_normal(corner[0], corner[1], corner[2], normal))
            continue;
        for (int k = 0; k < 3; ++k) {
            double weight = corner_angle(corner[k], corner[(k + 1) % 3], corner[(k + 2) % 3]);
            for (int c = 0; c < 3; ++c)
                sums[3 * (size_t)v[k] + (size_t)c] += weight * normal[c];
        }
    }
}

/* Vertices first to last - 1 have one position and one smoothing: those without a normal get the
 * sum. */
static void assign(model *m, double *const *sums, const located *first, const located *last)
{
    double total[3] = {0.0, 0.0, 0.0};
    for (const located *l = first; l < last; ++l)
        for (size_t c = 0; c < 3; ++c)
            total[c] += sums[l->part][3 * (size_t)l->vertex + c];
    double length = sqrt(dot(total, total));
    for (const located *l = first; l < last; ++l) {
        float *normal = m->parts[l->part].normals + 3 * (size_t)l->vertex;
        if (is_normal(normal))
            continue;
        for (int c = 0; c < 3; ++c)
            normal[c] = length > 0.0 ? (float)(total[c] / length) : 0.0f;
        if (!is_normal(normal)) {
            normal[0] = normal[1] = 0.0f;
            normal[2] = 1.0f;
        }
    }
}

bool model_complete_normals(model *m)
{
    size_t total = 0;
    bool missing = false;
    for (size_t p = 0; p < m->part_count; ++p) {
        const model_part *part = m->parts + p;
        total += part->vertex_count;
        for (size_t v = 0; v < part->vertex_count && !missing; ++v)
            missing = !is_normal(part->normals + 3 * v);
    }
    if (!missing)
        return true;

    located *all = malloc(total * sizeof *all);
    double **sums = calloc(m->part_count, sizeof *sums);
    bool good = all != NULL && sums != NULL;
    size_t count = 0;
    for (size_t p = 0; p < m->part_count && good; ++p) {
        const model_part *part = m->parts + p;
        sums[p] = calloc((size_t)part->vertex_count + 1, 3 * sizeof **sums);
        good = sums[p] != NULL;
        if (!good)
            break;
        add_faces(part, sums[p]);
        for (uint32_t v = 0; v < part->vertex_count; ++v, ++count) {
            memcpy(all[count].position, part->positions + 3 * (size_t)v,
                   sizeof all[count].position);
            all[count].smoothing = part->smoothing != NULL ? part->smoothing[v] : 0;
            all[count].vertex = v;
            all[count].part = p;
        }
    }
    if (good) {
        qsort(all, total, sizeof *all, compare_positions);
        for (size_t first = 0, last; first < total; first = last) {
            for (last = first + 1; last < total; ++last)
                if (compare_positions(all + first, all + last) != 0)
                    break;
            assign(m, sums, all + first, all + last);
        }
    }
    for (size_t p = 0; sums != NULL && p < m->part_count; ++p)
        free(sums[p]);
    free(sums);
    free(all);
    return good;
}
