/* Makes a part of STL facets: finds corners that are one vertex, and computes missing normals. */
#include <string.h>

#include "doubles.h"
#include "origin.h"
#include "stl.h"

/* So many vertices are compared with a corner; what is beyond is not shared. Only files that were
 * made to be slow come near it. */
#define MOST_COMPARED 64

/* A vertex as the part has it. Compared as memory: zeros have no sign. */
typedef struct stl_vertex {
    float position[3], normal[3], color[4];
} stl_vertex;

/* A place in the hash table. The tag, more bits of the hash, spares most comparisons. */
typedef struct hash_slot {
    uint32_t tag, vertex; /* the number of the vertex plus 1; 0: empty */
} hash_slot;

typedef struct part_maker {
    const stl_facets *facets;
    double origin[3];
    uint64_t not_finite; /* facets with such a normal */
    hash_slot *slots;    /* by the hash of vertices */
    size_t slot_count;   /* a power of two, above the number of corners */
    uint32_t *sources;   /* for each vertex, the corner it was made for */
    size_t vertex_count, source_room;
} part_maker;

/* The normal by the right-hand rule. A triangle without area cannot be seen: any normal will do. */
static void compute_normal(stl_facet *facet)
{
    double a[3], b[3], n[3];
    for (int c = 0; c < 3; ++c) {
        a[c] = facet->corners[1][c] - facet->corners[0][c];
        b[c] = facet->corners[2][c] - facet->corners[0][c];
    }
    doubles_cross(a, b, n);
    const double length = sqrt(doubles_dot(n, n));
    const bool has_area = length > 0.0 && isfinite(length);
    for (int c = 0; c < 3; ++c)
        facet->normal[c] = has_area ? (float)(n[c] / length) : (float)(c == 2);
}

/* A facet with a normal, and its colour. */
static void read_facet(const stl_facets *f, size_t number, stl_facet *facet, float color[4])
{
    if (f->records != NULL) {
        stl_decode(f, number, facet);
        stl_decode_color(f, number, color);
    } else {
        *facet = f->array[number];
        memcpy(color, f->color, sizeof f->color);
    }
    if (!floats_are_direction(facet->normal))
        compute_normal(facet);
}

/* The vertex of a corner. Adding 0 makes -0 to 0. */
static stl_vertex make_vertex(const part_maker *m, const stl_facet *facet, const float color[4],
                              uint32_t corner)
{
    stl_vertex v;
    for (int c = 0; c < 3; ++c) {
        v.position[c] = (float)(facet->corners[corner][c] - m->origin[c]) + 0.0f;
        v.normal[c] = facet->normal[c] + 0.0f;
    }
    memcpy(v.color, color, sizeof v.color);
    return v;
}

/* The vertex that was made for a corner of the file. */
static stl_vertex vertex_of(const part_maker *m, uint32_t corner)
{
    stl_facet facet;
    float color[4];
    read_facet(m->facets, corner / 3, &facet, color);
    return make_vertex(m, &facet, color, corner % 3);
}

static uint64_t hash(const stl_vertex *v)
{
    uint32_t words[6];
    uint64_t h = 0;
    memcpy(words, v->position, sizeof v->position);
    memcpy(words + 3, v->normal, sizeof v->normal);
    for (int i = 0; i < 6; ++i) {
        h = (h ^ words[i]) * UINT64_C(0x9e3779b97f4a7c15);
        h ^= h >> 29;
    }
    return h;
}

static bool is_same(const part_maker *m, const stl_vertex *v, uint32_t number)
{
    const stl_vertex other = vertex_of(m, m->sources[number]);
    return memcmp(v, &other, sizeof other) == 0;
}

/* Finds the vertex of a corner, or makes one. */
static bool find_vertex(model_reader *r, part_maker *m, const stl_vertex *v, uint32_t corner,
                        uint32_t *number)
{
    const uint64_t h = hash(v);
    const uint32_t tag = (uint32_t)(h >> 32);
    const size_t mask = m->slot_count - 1;
    size_t slot = (size_t)h & mask;
    for (int compared = 0; m->slots[slot].vertex != 0 && compared < MOST_COMPARED;
         slot = (slot + 1) & mask) {
        if (m->slots[slot].tag != tag)
            continue;
        *number = m->slots[slot].vertex - 1;
        if (is_same(m, v, *number))
            return true;
        ++compared;
    }
    *number = (uint32_t)m->vertex_count++;
    if (m->slots[slot].vertex == 0)
        m->slots[slot] = (hash_slot){tag, *number + 1};
    if (!reader_grow(r, &m->sources, &m->source_room, m->vertex_count, sizeof *m->sources))
        return false;
    m->sources[*number] = corner;
    return true;
}

/* Finds the vertices of all corners. */
static bool find_vertices(model_reader *r, part_maker *m, uint32_t *indices)
{
    for (size_t f = 0; f < m->facets->count; ++f) {
        stl_facet facet;
        float color[4];
        read_facet(m->facets, f, &facet, color);
        for (uint32_t k = 0; k < 3; ++k) {
            const stl_vertex v = make_vertex(m, &facet, color, k);
            if (!find_vertex(r, m, &v, (uint32_t)(3 * f) + k, indices + 3 * f + k))
                return false;
        }
    }
    return true;
}

static void fill(const part_maker *m, model_part *part)
{
    for (size_t v = 0; v < m->vertex_count; ++v) {
        const stl_vertex from = vertex_of(m, m->sources[v]);
        memcpy(part->positions + 3 * v, from.position, sizeof from.position);
        memcpy(part->normals + 3 * v, from.normal, sizeof from.normal);
        memcpy(part->colors + 4 * v, from.color, sizeof from.color);
    }
}

static bool make_part(model_reader *r, part_maker *m, uint32_t *indices)
{
    const size_t index_count = 3 * m->facets->count;
    if (!find_vertices(r, m, indices))
        return false;
    reader_release(r, m->slots, m->slot_count, sizeof *m->slots);
    m->slots = NULL;
    const size_t number = reader_add_part(r);
    if (number == SIZE_MAX)
        return false;
    model_part *const part = r->result->parts + number;
    part->has_normals = true;
    part->has_vertex_colors = m->facets->coloring != STL_NO_COLORS;
    if (!reader_allocate_part(r, part, (uint32_t)m->vertex_count, (uint32_t)index_count))
        return false;
    memcpy(part->indices, indices, index_count * sizeof *indices);
    fill(m, part);
    return true;
}

/* Chooses the origin, and warns of normals that are not finite. */
static void look_at_facets(model_reader *r, part_maker *m)
{
    origin_bounds bounds = origin_empty();
    stl_facet facet;
    for (size_t i = 0; i < m->facets->count; ++i) {
        if (m->facets->records != NULL)
            stl_decode(m->facets, i, &facet);
        else
            facet = m->facets->array[i];
        for (int k = 0; k < 3; ++k)
            origin_add(&bounds, facet.corners[k]);
        m->not_finite +=
            !(isfinite(facet.normal[0]) && isfinite(facet.normal[1]) && isfinite(facet.normal[2]));
    }
    origin_choose(&bounds, m->origin);
    memcpy(r->result->origin, m->origin, sizeof m->origin);
    if (m->not_finite > 0)
        reader_warn(r, NULL, "%llu %s computed from the corners", (unsigned long long)m->not_finite,
                    m->not_finite == 1 ? "facet has a normal that is not finite; it is"
                                       : "facets have normals that are not finite; they are");
}

bool stl_make_part(model_reader *r, const stl_facets *facets)
{
    part_maker m;
    memset(&m, 0, sizeof m);
    m.facets = facets;
    if (facets->count > UINT32_MAX / 3)
        return reader_fail(r, "it has too many triangles");
    look_at_facets(r, &m);
    const size_t corners = 3 * facets->count;
    for (m.slot_count = 4; m.slot_count <= corners + corners / 4;)
        m.slot_count *= 2;
    uint32_t *const indices = reader_allocate(r, corners, sizeof *indices);
    m.slots = indices != NULL ? reader_allocate(r, m.slot_count, sizeof *m.slots) : NULL;
    const bool good = m.slots != NULL && make_part(r, &m, indices);
    reader_release(r, m.slots, m.slot_count, sizeof *m.slots);
    reader_release(r, m.sources, m.source_room, sizeof *m.sources);
    reader_release(r, indices, corners, sizeof *indices);
    return good;
}
