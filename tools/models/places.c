/* Finds vertices of equal position and smoothing with a table of hashes, open addressing. */
#include "places.h"

#include <stdlib.h>
#include <string.h>

typedef struct finder {
    const model *m;
    uint32_t *table; /* numbers of places, plus 1; 0: free */
    size_t mask;
    uint32_t *first_part, *first_vertex; /* of each place */
    uint32_t count;
} finder;

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
static uint32_t place_of(finder *f, uint32_t part, uint32_t vertex)
{
    const model_part *const own = f->m->parts + part;
    size_t slot = hash_of(own, vertex) & f->mask;
    for (; f->table[slot] != 0; slot = (slot + 1) & f->mask) {
        const uint32_t place = f->table[slot] - 1;
        const model_part *const other = f->m->parts + f->first_part[place];
        if (is_same_place(own, vertex, other, f->first_vertex[place]))
            return place;
    }
    f->first_part[f->count] = part;
    f->first_vertex[f->count] = vertex;
    f->table[slot] = ++f->count;
    return f->count - 1;
}

static size_t slots_for(uint64_t vertices)
{
    size_t slots = 16;
    while (slots < 2 * vertices)
        slots *= 2;
    return slots;
}

bool model_places_find(const model *m, model_places *result)
{
    uint64_t vertices = 0;
    for (size_t p = 0; p < m->part_count; ++p)
        vertices += m->parts[p].vertex_count;
    *result = (model_places){0, 0, NULL};
    if (vertices >= UINT32_MAX)
        return false;
    const size_t slots = slots_for(vertices);
    finder f = {m,
                calloc(slots, sizeof *f.table),
                slots - 1,
                malloc((size_t)(vertices + 1) * sizeof *f.first_part),
                malloc((size_t)(vertices + 1) * sizeof *f.first_vertex),
                0};
    result->of_vertex = malloc((size_t)(vertices + 1) * sizeof *result->of_vertex);
    const bool good = f.table != NULL && f.first_part != NULL && f.first_vertex != NULL &&
                      result->of_vertex != NULL;
    uint32_t *at = result->of_vertex;
    for (uint32_t p = 0; p < m->part_count && good; ++p)
        for (uint32_t v = 0; v < m->parts[p].vertex_count; ++v)
            *at++ = place_of(&f, p, v);
    result->count = f.count;
    result->vertex_count = (uint32_t)vertices;
    free(f.table);
    free(f.first_part);
    free(f.first_vertex);
    return good;
}

void model_places_free(model_places *places)
{
    free(places->of_vertex);
    places->of_vertex = NULL;
}

uint64_t model_places_size(uint64_t vertices)
{
    return slots_for(vertices) * (uint64_t)sizeof(uint32_t) + 12 * (vertices + 1);
}
