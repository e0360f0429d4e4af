/* Computes tangents from texture coordinates. */
#include <stdlib.h>

#include "doubles.h"
#include "model.h"

typedef struct sums {
    double s[3], t[3]; /* directions in which s and t grow */
} sums;

static bool normalize(double v[3])
{
    const double length = sqrt(doubles_dot(v, v));
    if (!(length > 1e-30) || !isfinite(length))
        return false;
    for (int c = 0; c < 3; ++c)
        v[c] /= length;
    return true;
}

/* Adds the directions of one triangle to its corners. Position is linear in s and t there: two
 * edges give two equations for each direction. A triangle without area in s and t adds nothing. */
static void add_triangle(const model_part *part, const uint32_t *v, sums *all)
{
    double edge[2][3], s[2], t[2];
    for (int e = 0; e < 2; ++e) {
        const float *p = part->positions + 3 * (size_t)v[e + 1];
        const float *q = part->texcoords + 2 * (size_t)v[e + 1];
        for (int c = 0; c < 3; ++c)
            edge[e][c] = (double)p[c] - (double)part->positions[3 * (size_t)v[0] + (size_t)c];
        s[e] = (double)q[0] - (double)part->texcoords[2 * (size_t)v[0]];
        t[e] = (double)q[1] - (double)part->texcoords[2 * (size_t)v[0] + 1];
    }
    const double area = s[0] * t[1] - s[1] * t[0];
    if (!(fabs(area) > 0.0))
        return;
    double along_s[3], along_t[3];
    for (int c = 0; c < 3; ++c) {
        along_s[c] = (edge[0][c] * t[1] - edge[1][c] * t[0]) / area;
        along_t[c] = (edge[1][c] * s[0] - edge[0][c] * s[1]) / area;
    }
    /* Every triangle has the same weight. */
    if (!normalize(along_s) || !normalize(along_t))
        return;
    for (int k = 0; k < 3; ++k)
        for (int c = 0; c < 3; ++c) {
            all[v[k]].s[c] += along_s[c];
            all[v[k]].t[c] += along_t[c];
        }
}

/* Any direction across the normal. */
static void any_across(const double n[3], double result[3])
{
    const double axis[3] = {fabs(n[0]) < 0.5, fabs(n[0]) >= 0.5, 0.0};
    doubles_cross(axis, n, result);
    if (!normalize(result)) {
        result[0] = 1.0;
        result[1] = result[2] = 0.0;
    }
}

/* The tangent is the direction of s without its part along the normal. */
static void write_tangent(const float *normal, const sums *sum, float *tangent)
{
    double n[3] = {(double)normal[0], (double)normal[1], (double)normal[2]}, across[3], other[3];
    if (!normalize(n)) {
        n[0] = n[1] = 0.0;
        n[2] = 1.0;
    }
    const double along = doubles_dot(n, sum->s);
    for (int c = 0; c < 3; ++c)
        across[c] = sum->s[c] - along * n[c];
    if (!normalize(across))
        any_across(n, across);
    doubles_cross(n, across, other);
    for (int c = 0; c < 3; ++c)
        tangent[c] = (float)across[c];
    tangent[3] = doubles_dot(other, sum->t) < 0.0 ? -1.0f : 1.0f;
}

uint64_t model_tangents_size(const model_part *part)
{
    return part->has_tangents ? ((uint64_t)part->vertex_count + 1) * sizeof(sums) : 0;
}

bool model_complete_tangents(model_part *part)
{
    if (!part->has_tangents || !part->has_texcoords)
        return true;
    bool missing = false;
    for (size_t v = 0; v < part->vertex_count; ++v)
        missing = missing || part->tangents[4 * v + 3] == 0.0f;
    if (!missing)
        return true;
    sums *const all = calloc((size_t)part->vertex_count + 1, sizeof *all);
    if (all == NULL)
        return false;
    for (size_t i = 0; i + 2 < part->index_count; i += 3)
        add_triangle(part, part->indices + i, all);
    for (size_t v = 0; v < part->vertex_count; ++v)
        if (part->tangents[4 * v + 3] == 0.0f)
            write_tangent(part->normals + 3 * v, all + v, part->tangents + 4 * v);
    free(all);
    return true;
}
