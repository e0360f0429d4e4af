/* Bounds of models. */
#include "bounds.h"

#include <float.h>
#include <math.h>

/* A vertex where its part is drawn. */
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
                low[c] = position[c] < low[c] ? position[c] : low[c];
                high[c] = position[c] > high[c] ? position[c] : high[c];
            }
        }
    }
}

bounding_sphere model_bounds(const model *m)
{
    bounding_sphere sphere = {{0.0, 0.0, 0.0}, 0.0, {0.0, 0.0, 0.0}};
    double low[3], high[3];
    model_box(m, low, high);
    for (int c = 0; c < 3; ++c) {
        sphere.center[c] = 0.5 * (low[c] + high[c]);
        sphere.origin[c] = m->origin[c];
    }
    double greatest = 0.0;
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
            greatest = square > greatest ? square : greatest;
        }
    }
    sphere.radius = greatest > 0.0 ? sqrt(greatest) : 1.0;
    return sphere;
}
