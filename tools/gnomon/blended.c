/* Sorts translucent draws and triangles. */
#include "blended.h"

#include <stdlib.h>
#include <string.h>

#include "scene_memory.h"

/* How far a point of a draw lies from the viewer, in units that grow along the view: clip space's w
 * in perspective, and its z in a parallel projection. */
static double distance_of(const scene_draw *draw, const double point[3])
{
    const float(*m)[4] = draw->uniforms.light.clip_from_model.m;
    const bool is_perspective = m[0][3] != 0.0f || m[1][3] != 0.0f || m[2][3] != 0.0f;
    const int row = is_perspective ? 3 : 2;
    return (double)m[0][row] * point[0] + (double)m[1][row] * point[1] +
           (double)m[2][row] * point[2] + (double)m[3][row];
}

static const float *position_of(const gn_mesh *mesh, uint32_t index)
{
    const gn_attribute *const position = mesh->attribute + GN_ATTRIBUTE_POSITION;
    return position->data + (size_t)position->components * index;
}

/* The indices of a draw with them, which are the scene's own copy. */
static uint32_t *indices_of(const scene_draw *draw)
{
    return (uint32_t *)draw->mesh.indices;
}

typedef struct sorted_triangle {
    double distance;
    uint32_t number;
    uint32_t corner[3];
} sorted_triangle;

static int farthest_triangle_first(const void *a, const void *b)
{
    const sorted_triangle *const p = a, *const q = b;
    if (p->distance != q->distance)
        return p->distance > q->distance ? -1 : 1;
    return p->number < q->number ? -1 : 1;
}

static void sort_triangles(scene_draw *draw)
{
    uint32_t *const indices = indices_of(draw);
    const size_t count = draw->mesh.count / 3;
    sorted_triangle *const triangles = scene_allocate(count + 1, sizeof *triangles);
    for (size_t i = 0; i < count; ++i) {
        double center[3] = {0.0, 0.0, 0.0};
        sorted_triangle *const t = triangles + i;
        memcpy(t->corner, indices + 3 * i, sizeof t->corner);
        t->number = (uint32_t)i;
        for (int k = 0; k < 3; ++k)
            for (int c = 0; c < 3; ++c)
                center[c] += (double)position_of(&draw->mesh, t->corner[k])[c] / 3.0;
        t->distance = distance_of(draw, center);
    }
    qsort(triangles, count, sizeof *triangles, farthest_triangle_first);
    for (size_t i = 0; i < count; ++i)
        memcpy(indices + 3 * i, triangles[i].corner, sizeof triangles[i].corner);
    free(triangles);
}

static double distance_of_draw(const scene_draw *draw)
{
    double middle[3];
    for (int c = 0; c < 3; ++c) {
        double low = 0.0, high = 0.0;
        for (uint32_t i = 0; i < draw->mesh.count; ++i) {
            const double at = (double)position_of(&draw->mesh, indices_of(draw)[i])[c];
            low = i == 0 || at < low ? at : low;
            high = i == 0 || at > high ? at : high;
        }
        middle[c] = 0.5 * (low + high);
    }
    return distance_of(draw, middle);
}

typedef struct sorted_draw {
    double distance;
    size_t part;
    scene_draw draw;
} sorted_draw;

static int farthest_draw_first(const void *a, const void *b)
{
    const sorted_draw *const p = a, *const q = b;
    if (p->distance != q->distance)
        return p->distance > q->distance ? -1 : 1;
    return p->part < q->part ? -1 : 1;
}

void blended_order(scene_draw *draws, size_t *parts, size_t count)
{
    sorted_draw *const sorted = scene_allocate(count + 1, sizeof *sorted);
    for (size_t i = 0; i < count; ++i) {
        if (draws[i].state.raster.topology == GN_TRIANGLES)
            sort_triangles(draws + i);
        sorted[i] = (sorted_draw){distance_of_draw(draws + i), parts[i], draws[i]};
    }
    qsort(sorted, count, sizeof *sorted, farthest_draw_first);
    for (size_t i = 0; i < count; ++i) {
        draws[i] = sorted[i].draw;
        parts[i] = sorted[i].part;
    }
    free(sorted);
}
