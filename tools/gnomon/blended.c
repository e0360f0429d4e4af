/* Sorts translucent triangles. */
#include "blended.h"

#include <stdlib.h>
#include <string.h>

#include "scene_memory.h"

double blended_distance(const scene_draw *draw, const double point[3])
{
    const float(*m)[4] = draw->uniforms.light.clip_from_model.m;
    const bool is_perspective = m[0][3] != 0.0f || m[1][3] != 0.0f || m[2][3] != 0.0f;
    /* Clip space's w is the distance along the view in perspective; its z grows with it in a
     * parallel projection. */
    const int row = is_perspective ? 3 : 2;
    return (double)m[0][row] * point[0] + (double)m[1][row] * point[1] +
           (double)m[2][row] * point[2] + (double)m[3][row];
}

typedef struct sorted_triangle {
    double distance;
    uint32_t number;
    uint32_t corner[3];
} sorted_triangle;

static int farthest_first(const void *a, const void *b)
{
    const sorted_triangle *const p = a, *const q = b;
    if (p->distance != q->distance)
        return p->distance > q->distance ? -1 : 1;
    return p->number < q->number ? -1 : 1;
}

void blended_sort(scene_draw *draw)
{
    const gn_mesh *const mesh = &draw->mesh;
    const gn_attribute *const position = mesh->attribute + GN_ATTRIBUTE_POSITION;
    uint32_t *const indices = (uint32_t *)mesh->indices; /* the scene's own copy */
    const size_t count = mesh->count / 3;
    if (draw->state.raster.topology != GN_TRIANGLES || mesh->index_format != GN_INDEX_UINT32)
        return;
    sorted_triangle *const triangles = scene_allocate(count + 1, sizeof *triangles);
    for (size_t i = 0; i < count; ++i) {
        double center[3] = {0.0, 0.0, 0.0};
        sorted_triangle *const t = triangles + i;
        memcpy(t->corner, indices + 3 * i, sizeof t->corner);
        t->number = (uint32_t)i;
        for (int k = 0; k < 3; ++k) {
            const float *const p =
                position->data + (size_t)position->components * indices[3 * i + (size_t)k];
            for (int c = 0; c < 3; ++c)
                center[c] += (double)p[c] / 3.0;
        }
        t->distance = blended_distance(draw, center);
    }
    qsort(triangles, count, sizeof *triangles, farthest_first);
    for (size_t i = 0; i < count; ++i)
        memcpy(indices + 3 * i, triangles[i].corner, sizeof triangles[i].corner);
    free(triangles);
}
