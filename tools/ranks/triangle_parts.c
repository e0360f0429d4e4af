/* Divides the primitives of scenes among ranks. */
#include "triangle_parts.h"

#include <stdlib.h>
#include <string.h>

static uint64_t units_of(const primitive_list *list)
{
    return ((uint64_t)list->count + list->unit - 1) / list->unit;
}

void parts_of_rank(const primitive_list *lists, size_t draws, uint32_t number, uint32_t count,
                   primitive_range *parts)
{
    uint64_t all = 0, before = 0;
    for (size_t i = 0; i < draws; ++i)
        all += units_of(lists + i);
    const uint64_t first = all * number / count, end = all * (number + 1) / count;
    for (size_t i = 0; i < draws; ++i) {
        const uint64_t units = units_of(lists + i), size = lists[i].count;
        uint64_t from = first > before ? first - before : 0;
        uint64_t to = end > before ? end - before : 0;
        from = from < units ? from : units;
        to = to < units ? to : units;
        from *= lists[i].unit;
        to *= lists[i].unit;
        from = from < size ? from : size;
        to = to < size ? to : size;
        parts[i] = (primitive_range){(uint32_t)from, (uint32_t)(to - from)};
        before += units;
    }
}

/* Elements of a primitive; 0 if primitives share elements. */
static uint32_t elements_of(gn_topology topology)
{
    switch (topology) {
    case GN_TRIANGLES:
        return 3;
    case GN_LINES:
        return 2;
    case GN_POINTS:
        return 1;
    default:
        return 0;
    }
}

/* Whether decisions about a triangle depend on others of its segment. */
static bool has_segments(const scene_draw *d)
{
    return d->state.raster.topology == GN_TRIANGLES && d->state.raster.cull != GN_CULL_NONE;
}

/* How a draw can be divided. Strips, fans, loops, and draws with instances or restarts are one
 * unit. */
static primitive_list parts_of_draw(const scene_draw *d)
{
    const gn_mesh *m = &d->mesh;
    const uint32_t elements = elements_of(d->state.raster.topology);
    const bool is_indexed = m->index_format != GN_INDEX_NONE;
    if (elements == 0 || m->instance_count > 1 || (is_indexed && m->restart != GN_RESTART_NONE))
        return (primitive_list){1, 1};
    const uint32_t unit = is_indexed ? INDEXED_SEGMENT_TRIANGLES : SEGMENT_TRIANGLES;
    return (primitive_list){m->count / elements, has_segments(d) ? unit : 1};
}

/* Leaves a draw its part. */
static void cut(scene_draw *d, primitive_range part)
{
    const primitive_list list = parts_of_draw(d);
    const uint32_t elements = elements_of(d->state.raster.topology);
    if (part.count == list.count)
        return;
    d->mesh.first += part.first * elements;
    d->mesh.count = part.count * elements;
}

bool parts_scene(const scene *s, uint32_t number, uint32_t count, scene *result)
{
    primitive_list *lists = calloc(s->draw_count + 1, sizeof *lists);
    primitive_range *parts = calloc(s->draw_count + 1, sizeof *parts);
    *result = *s;
    result->draws = calloc(s->draw_count + 1, sizeof *result->draws);
    const bool good = lists != NULL && parts != NULL && result->draws != NULL;
    if (good) {
        for (size_t i = 0; i < s->draw_count; ++i)
            lists[i] = parts_of_draw(s->draws + i);
        parts_of_rank(lists, s->draw_count, number, count, parts);
        for (size_t i = 0; i < s->draw_count; ++i) {
            result->draws[i] = s->draws[i];
            cut(result->draws + i, parts[i]);
        }
    } else {
        parts_scene_free(result);
    }
    free(lists);
    free(parts);
    return good;
}

void parts_scene_free(scene *part)
{
    free(part->draws);
    part->draws = NULL;
    part->draw_count = 0;
}
