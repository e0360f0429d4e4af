/* Finds the edges of a part's triangles. */
#include "edges.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "doubles.h"
#include "look_parts.h"
#include "places.h"
#include "scene_memory.h"

/* The cosine of 1 degree: two triangles that differ by less are in one plane. */
#define PLANE_COSINE 0.99984769515639124

/* A material is dark if its mean brightness, as the display shows it, is below this. */
#define DARK 0.25f

/* The opacity of lines whose colour is not given. Opaque lines would cover a fine mesh. */
#define OPACITY 0.7f

/* What is looked at to find the mean of a material. */
enum { MOST_LOOKED_AT = 4096 };

/* A side of a triangle, between two places. */
typedef struct side {
    uint32_t low, high; /* places */
    uint32_t corner;    /* where it begins, in the part's indices */
} side;

static int compare_sides(const void *a, const void *b)
{
    const side *const x = a, *const y = b;
    if (x->low != y->low)
        return x->low < y->low ? -1 : 1;
    if (x->high != y->high)
        return x->high < y->high ? -1 : 1;
    return x->corner < y->corner ? -1 : x->corner > y->corner;
}

static bool normal_of(const model_part *part, uint32_t corner, double result[3])
{
    const uint32_t *const v = part->indices + corner - corner % 3;
    const float *const p = part->positions + 3 * (size_t)v[0];
    double a[3], b[3];
    doubles_between(p, part->positions + 3 * (size_t)v[1], a);
    doubles_between(p, part->positions + 3 * (size_t)v[2], b);
    doubles_cross(a, b, result);
    const double length = sqrt(doubles_dot(result, result));
    for (int c = 0; c < 3; ++c)
        result[c] /= length;
    return length > 0.0 && isfinite(length);
}

/* Whether the sides that join the same places are shown as an edge. Two triangles in one plane may
 * have opposite windings. */
static bool is_shown(const model_part *part, const side *sides, size_t count)
{
    double a[3], b[3];
    return count != 2 || !normal_of(part, sides[0].corner, a) ||
           !normal_of(part, sides[1].corner, b) || !(fabs(doubles_dot(a, b)) >= PLANE_COSINE);
}

static size_t list_sides(const model_part *part, const uint32_t *places, side *sides)
{
    const uint32_t end = part->index_count / 3 * 3;
    size_t count = 0;
    for (uint32_t i = 0; i < end; ++i) {
        const uint32_t next = i % 3 == 2 ? i - 2 : i + 1;
        const uint32_t a = places[part->indices[i]], b = places[part->indices[next]];
        if (a != b)
            sides[count++] = (side){a < b ? a : b, a < b ? b : a, i};
    }
    return count;
}

/* Writes the ends of the edges that are shown. Returns the number of vertices. */
static uint32_t write_edges(const model_part *part, const side *sides, size_t count,
                            uint32_t *indices)
{
    uint32_t written = 0;
    for (size_t first = 0, end; first < count; first = end) {
        const side *const s = sides + first;
        for (end = first + 1;
             end < count && sides[end].low == s->low && sides[end].high == s->high;)
            ++end;
        if (!is_shown(part, s, end - first))
            continue;
        indices[written++] = part->indices[s->corner];
        indices[written++] = part->indices[s->corner % 3 == 2 ? s->corner - 2 : s->corner + 1];
    }
    return written;
}

/* Fills in the indices of a part of lines, as many as it returns. */
static uint32_t find_edges(const model_part *part, uint32_t *indices)
{
    model_part alone = *part;
    const model one = {.part_count = 1, .parts = &alone};
    side *const sides = malloc(((size_t)part->index_count + 1) * sizeof *sides);
    model_places places;
    uint32_t written = 0;
    if (model_places_find(&one, &places) && sides != NULL) {
        const size_t count = list_sides(part, places.of_vertex, sides);
        qsort(sides, count, sizeof *sides, compare_sides);
        written = write_edges(part, sides, count, indices);
    }
    model_places_free(&places);
    free(sides);
    return written;
}

static float brightness(const float color[3])
{
    return 0.2126f * color[0] + 0.7152f * color[1] + 0.0722f * color[2];
}

/* The mean brightness of a part's vertices times that of its map, each as the display shows it. */
static float mean_brightness(const model_part *part, const part_maps *maps)
{
    const image *const map = maps->images + MAP_DIFFUSE;
    const size_t texels = map->texels != NULL ? (size_t)map->width * map->height : 0;
    const size_t step = part->vertex_count / MOST_LOOKED_AT + 1;
    double sum = 0.0, of_map = 0.0;
    size_t count = 0;
    for (size_t v = 0; v < part->vertex_count && !maps->replaces_color; v += step, ++count) {
        const float own = brightness(part->colors + 4 * v);
        sum += (double)(part->surface.has_linear_colors ? look_to_encoded(own) : own);
    }
    const double of_vertices = count > 0 ? sum / (double)count : 1.0;
    count = 0;
    for (size_t t = 0; t < texels; t += texels / MOST_LOOKED_AT + 1, ++count) {
        const uint32_t texel = map->texels[t];
        of_map += (double)brightness((float[]){(float)(texel & 255) / 255.0f,
                                               (float)(texel >> 8 & 255) / 255.0f,
                                               (float)(texel >> 16 & 255) / 255.0f});
    }
    return (float)(of_vertices * (count > 0 ? of_map / (double)count : 1.0));
}

static void choose_color(const look *l, const model_part *part, const part_maps *maps,
                         float color[4])
{
    const float default_value = mean_brightness(part, maps) < DARK ? 1.0f : 0.0f;
    if (l->options->edges_color_given) {
        memcpy(color, l->options->edges_color, 4 * sizeof *color);
        return;
    }
    color[0] = color[1] = color[2] = default_value;
    color[3] = OPACITY;
}

bool edges_add(scene *s, const look *l, const model_part *part, const part_maps *maps)
{
    static const part_maps no_maps;
    if (part->kind != MODEL_TRIANGLES)
        return false;
    model_part lines = *part;
    look own = *l;
    options plain = *l->options;
    float color[4];
    lines.kind = MODEL_LINES;
    lines.indices = scene_allocate(2 * (size_t)part->index_count + 1, sizeof *lines.indices);
    lines.colors = scene_allocate(4 * (size_t)part->vertex_count + 1, sizeof *lines.colors);
    lines.index_count = find_edges(part, lines.indices);
    choose_color(l, part, maps, color);
    for (size_t v = 0; v < part->vertex_count; ++v)
        memcpy(lines.colors + 4 * v, color, sizeof color);
    lines.has_normals = lines.has_texcoords = lines.has_tangents = false;
    lines.surface = model_surface_default();
    lines.surface.alpha = color[3] < 1.0f ? MODEL_BLEND : MODEL_OPAQUE;
    for (int i = 0; i < MAP_COUNT; ++i)
        lines.maps[i] = model_map_of(MODEL_NO_IMAGE);
    plain.opaque = plain.shading_given = false;
    own.options = &plain;
    own.shading = SHADING_UNLIT;
    own.shadow = NULL;
    if (lines.index_count > 0)
        look_add_part(s, &own, &lines, &no_maps);
    free(lines.indices);
    free(lines.colors);
    return lines.index_count > 0;
}

void edges_push_back(scene_draw *draw)
{
    draw->state.raster.polygon_offset =
        (gn_polygon_offset){.enabled = true, .factor = 1.0f, .units = 1.0f};
}
