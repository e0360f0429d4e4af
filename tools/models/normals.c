/* Computes normals from positions. */
#include <stdlib.h>
#include <string.h>

#include "doubles.h"
#include "model.h"

/* Vertices of all parts by their places: position and smoothing. The places are numbered; a table
 * of hashes, open addressing, finds the number of a place that is known. */
typedef struct places {
    uint32_t *table; /* numbers plus 1; 0: free */
    size_t mask;
    uint32_t *first_part, *first_vertex; /* of each place */
    uint32_t *of_vertex;                 /* the place of each vertex, part after part */
    double (*sums)[3];                   /* of the normals of the triangles there */
    uint32_t count;
} places;

static uint32_t smoothing_of(const model_part *part, size_t vertex)
{
    return part->smoothing != NULL ? part->smoothing[vertex] : 0;
}

static bool is_same_place(const model_part *a, size_t va, const model_part *b, size_t vb)
{
    const float *const p = a->positions + 3 * va, *const q = b->positions + 3 * vb;
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2] &&
           smoothing_of(a, va) == smoothing_of(b, vb);
}

/* Mixes the bits of the coordinates, in which -0 equals 0, and of the smoothing. */
static size_t hash_of(const model_part *part, size_t vertex)
{
    uint64_t hash = smoothing_of(part, vertex);
    for (size_t c = 0; c < 3; ++c) {
        const float value = part->positions[3 * vertex + c] + 0.0f;
        uint32_t bits;
        memcpy(&bits, &value, sizeof bits);
        hash = (hash ^ bits) * UINT64_C(0x9E3779B97F4A7C15);
        hash ^= hash >> 29;
    }
    return (size_t)hash;
}

/* The number of a vertex's place, a new one if none is like it. */
static uint32_t place_of(places *all, const model *m, uint32_t part, uint32_t vertex)
{
    const model_part *const own = m->parts + part;
    size_t slot = hash_of(own, vertex) & all->mask;
    for (; all->table[slot] != 0; slot = (slot + 1) & all->mask) {
        const uint32_t place = all->table[slot] - 1;
        if (is_same_place(own, vertex, m->parts + all->first_part[place], all->first_vertex[place]))
            return place;
    }
    all->first_part[all->count] = part;
    all->first_vertex[all->count] = vertex;
    all->table[slot] = ++all->count;
    return all->count - 1;
}

static void subtract(const float *a, const float *b, double result[3])
{
    for (int i = 0; i < 3; ++i)
        result[i] = (double)a[i] - (double)b[i];
}

/* Adds a triangle's normal, times the angle of each corner, to the sums of its corners' places. A
 * triangle without area adds nothing. The angle at a corner has the sine of the cross product, as
 * long at every corner, and the cosine of the edges' product. */
static void add_triangle(const model_part *part, const uint32_t *v, places *all,
                         const uint32_t *place)
{
    const float *corner[3];
    double edge[3][3], normal[3]; /* edge k leads from corner k to the next */
    for (int k = 0; k < 3; ++k)
        corner[k] = part->positions + 3 * (size_t)v[k];
    for (int k = 0; k < 3; ++k)
        subtract(corner[(k + 1) % 3], corner[k], edge[k]);
    doubles_cross(edge[2], edge[0], normal);
    const double length = sqrt(doubles_dot(normal, normal));
    if (!(length > 0.0) || !isfinite(length))
        return;
    for (int k = 0; k < 3; ++k) {
        const double angle = atan2(length, -doubles_dot(edge[k], edge[(k + 2) % 3]));
        for (int c = 0; c < 3; ++c)
            all->sums[place[v[k]]][c] += angle * (normal[c] / length);
    }
}

static void write_normal(const double sum[3], float *normal)
{
    const double length = sqrt(doubles_dot(sum, sum));
    for (int c = 0; c < 3; ++c)
        normal[c] = length > 0.0 ? (float)(sum[c] / length) : 0.0f;
    if (!floats_are_direction(normal)) {
        normal[0] = normal[1] = 0.0f;
        normal[2] = 1.0f;
    }
}

static bool allocate(places *all, size_t vertices)
{
    size_t slots = 16;
    while (slots < 2 * vertices)
        slots *= 2;
    all->mask = slots - 1;
    all->table = calloc(slots, sizeof *all->table);
    all->first_part = malloc(vertices * sizeof *all->first_part);
    all->first_vertex = malloc(vertices * sizeof *all->first_vertex);
    all->of_vertex = malloc(vertices * sizeof *all->of_vertex);
    return all->table != NULL && all->first_part != NULL && all->first_vertex != NULL &&
           all->of_vertex != NULL;
}

/* Finds the places of all vertices, and the sums there. Returns false if there is not enough
 * memory. */
static bool fill(places *all, const model *m)
{
    uint32_t *at = all->of_vertex;
    for (uint32_t p = 0; p < m->part_count; ++p)
        for (uint32_t v = 0; v < m->parts[p].vertex_count; ++v)
            *at++ = place_of(all, m, p, v);
    all->sums = calloc((size_t)all->count + 1, sizeof *all->sums);
    if (all->sums == NULL)
        return false;
    at = all->of_vertex;
    for (size_t p = 0; p < m->part_count; at += m->parts[p].vertex_count, ++p) {
        const model_part *const part = m->parts + p;
        for (size_t i = 0; part->kind == MODEL_TRIANGLES && i + 2 < part->index_count; i += 3)
            add_triangle(part, part->indices + i, all, at);
    }
    return true;
}

/* Counts the vertices. Returns whether one has no normal. */
static bool is_incomplete(const model *m, size_t *vertices)
{
    bool missing = false;
    *vertices = 0;
    for (size_t p = 0; p < m->part_count; ++p) {
        const model_part *const part = m->parts + p;
        *vertices += part->vertex_count;
        for (size_t v = 0; v < part->vertex_count && !missing; ++v)
            missing = !floats_are_direction(part->normals + 3 * v);
    }
    return missing;
}

bool model_complete_normals(model *m)
{
    places all;
    size_t vertices;
    if (!is_incomplete(m, &vertices))
        return true;
    memset(&all, 0, sizeof all);
    const bool good = vertices < UINT32_MAX && allocate(&all, vertices) && fill(&all, m);
    const uint32_t *place = all.of_vertex;
    for (size_t p = 0; p < m->part_count && good; ++p) {
        const model_part *const part = m->parts + p;
        for (size_t v = 0; v < part->vertex_count; ++v, ++place)
            if (!floats_are_direction(part->normals + 3 * v))
                write_normal(all.sums[*place], part->normals + 3 * v);
    }
    free(all.table);
    free(all.first_part);
    free(all.first_vertex);
    free(all.of_vertex);
    free(all.sums);
    return good;
}

uint64_t model_normals_size(const model *m)
{
    size_t vertices;
    return is_incomplete(m, &vertices) ? (uint64_t)vertices * 52 + 128 : 0;
}
