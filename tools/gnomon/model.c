/* Models in memory. */
#include "model.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

bool model_part_allocate(model_part *part, uint32_t vertex_count, uint32_t index_count)
{
    size_t vertices = vertex_count;
    part->vertex_count = vertex_count;
    part->index_count = index_count;
    gn_transform_identity(&part->world_from_model);
    part->positions = calloc(vertices + 1, 3 * sizeof(float));
    part->normals = calloc(vertices + 1, 3 * sizeof(float));
    part->colors = calloc(vertices + 1, 4 * sizeof(float));
    part->texcoords = part->has_texcoords ? calloc(vertices + 1, 2 * sizeof(float)) : NULL;
    part->tangents = part->has_tangents ? calloc(vertices + 1, 4 * sizeof(float)) : NULL;
    part->indices = calloc((size_t)index_count + 1, sizeof(uint32_t));
    return part->positions != NULL && part->normals != NULL && part->colors != NULL &&
           part->indices != NULL && (!part->has_texcoords || part->texcoords != NULL) &&
           (!part->has_tangents || part->tangents != NULL);
}

void model_free(model *m)
{
    for (size_t i = 0; i < m->part_count; ++i) {
        model_part *part = m->parts + i;
        free(part->positions);
        free(part->normals);
        free(part->colors);
        free(part->texcoords);
        free(part->tangents);
        free(part->indices);
        for (int k = 0; k < MAP_COUNT; ++k) {
            free(part->maps[k].name);
            free(part->maps[k].bytes);
        }
    }
    free(m->parts);
    memset(m, 0, sizeof *m);
}

uint64_t model_triangle_count(const model *m)
{
    uint64_t count = 0;
    for (size_t i = 0; i < m->part_count; ++i)
        count += m->parts[i].index_count / 3;
    return count;
}

/* A vertex in the world. */
static void place_vertex(const model_part *part, uint32_t vertex, double result[3])
{
    const float *p = part->positions + 3 * (size_t)vertex;
    const float(*m)[4] = part->world_from_model.matrix.m;
    for (int c = 0; c < 3; ++c)
        result[c] = (double)m[0][c] * (double)p[0] + (double)m[1][c] * (double)p[1] +
                    (double)m[2][c] * (double)p[2] + (double)m[3][c];
}

void model_box(const model *m, double low[3], double high[3])
{
    for (int c = 0; c < 3; ++c) {
        low[c] = DBL_MAX;
        high[c] = -DBL_MAX;
    }
    for (size_t p = 0; p < m->part_count; ++p) {
        const model_part *part = m->parts + p;
        for (size_t i = 0; i < part->index_count; ++i) {
            double position[3];
            place_vertex(part, part->indices[i], position);
            for (int c = 0; c < 3; ++c) {
                low[c] = fmin(low[c], position[c]);
                high[c] = fmax(high[c], position[c]);
            }
        }
    }
}

bounding_sphere model_bounds(const model *m)
{
    bounding_sphere sphere = {{0.0, 0.0, 0.0}, 0.0};
    double low[3], high[3];
    model_box(m, low, high);
    for (int c = 0; c < 3; ++c)
        sphere.center[c] = 0.5 * (low[c] + high[c]);
    for (size_t p = 0; p < m->part_count; ++p) {
        const model_part *part = m->parts + p;
        for (size_t i = 0; i < part->index_count; ++i) {
            double position[3];
            place_vertex(part, part->indices[i], position);
            double square = 0.0;
            for (int c = 0; c < 3; ++c) {
                double d = position[c] - sphere.center[c];
                square += d * d;
            }
            sphere.radius = fmax(sphere.radius, sqrt(square));
        }
    }
    if (!(sphere.radius > 0.0))
        sphere.radius = 1.0;
    return sphere;
}
