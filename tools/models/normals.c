/* Computes normals from positions. */
#include <stdlib.h>

#include "creases.h"
#include "doubles.h"
#include "model.h"
#include "places.h"

/* What is computed of the triangles. */
typedef struct normals {
    model_places places;
    double (*means)[3];   /* of each place: the sum of the normals there, then its direction */
    float (*triangle)[3]; /* of each triangle, of unit length; 0: without area. Null: not wanted */
} normals;

/* Adds a triangle's normal, times the angle of each corner, to the sums of its corners' places;
 * `place` has those of the part's vertices. A triangle without area adds nothing. The angle at a
 * corner has the sine of the cross product, as long at every corner, and the cosine of the edges'
 * product. Writes the normal to `unit` unless it is null. */
static void add_triangle(const model_part *part, const uint32_t *v, const uint32_t *place,
                         double (*sums)[3], float *unit)
{
    const float *corner[3];
    double edge[3][3], normal[3]; /* edge k leads from corner k to the next */
    for (int k = 0; k < 3; ++k)
        corner[k] = part->positions + 3 * (size_t)v[k];
    for (int k = 0; k < 3; ++k)
        doubles_between(corner[k], corner[(k + 1) % 3], edge[k]);
    doubles_cross(edge[2], edge[0], normal);
    const double length = sqrt(doubles_dot(normal, normal));
    if (!(length > 0.0) || !isfinite(length))
        return;
    for (int c = 0; c < 3; ++c)
        normal[c] /= length;
    for (int c = 0; c < 3 && unit != NULL; ++c)
        unit[c] = (float)normal[c];
    for (int k = 0; k < 3; ++k) {
        const double angle = atan2(length, -doubles_dot(edge[k], edge[(k + 2) % 3]));
        for (int c = 0; c < 3; ++c)
            sums[place[v[k]]][c] += angle * normal[c];
    }
}

static void add_triangles(const model *m, const normals *n)
{
    const uint32_t *place = n->places.of_vertex;
    size_t triangle = 0;
    for (size_t p = 0; p < m->part_count; place += m->parts[p].vertex_count, ++p) {
        const model_part *const part = m->parts + p;
        for (size_t i = 0; part->kind == MODEL_TRIANGLES && i + 2 < part->index_count; i += 3) {
            float *const unit = n->triangle != NULL ? n->triangle[triangle++] : NULL;
            add_triangle(part, part->indices + i, place, n->means, unit);
        }
    }
}

static void normalize_means(const normals *n)
{
    for (uint32_t p = 0; p < n->places.count; ++p) {
        double *const mean = n->means[p];
        const double length = sqrt(doubles_dot(mean, mean));
        for (int c = 0; c < 3; ++c)
            mean[c] = length > 0.0 ? mean[c] / length : 0.0;
    }
}

static void write_normal(const double mean[3], float *normal)
{
    for (int c = 0; c < 3; ++c)
        normal[c] = (float)mean[c];
    if (!floats_are_direction(normal)) {
        normal[0] = normal[1] = 0.0f;
        normal[2] = 1.0f;
    }
}

/* `of_vertex` has the places of the vertices that the file has; those that creases have added have
 * their normals. */
static void write_normals(const model *m, const normals *n, const uint32_t *vertex_counts)
{
    const uint32_t *place = n->places.of_vertex;
    for (size_t p = 0; p < m->part_count; ++p)
        for (size_t v = 0; v < vertex_counts[p]; ++v, ++place)
            if (!floats_are_direction(m->parts[p].normals + 3 * v))
                write_normal(n->means[*place], m->parts[p].normals + 3 * v);
}

/* Counts vertices and triangles. Returns whether a vertex has no normal. */
static bool is_incomplete(const model *m, uint64_t *vertices, uint64_t *triangles)
{
    bool missing = false;
    *vertices = *triangles = 0;
    for (size_t p = 0; p < m->part_count; ++p) {
        const model_part *const part = m->parts + p;
        *vertices += part->vertex_count;
        *triangles += part->kind == MODEL_TRIANGLES ? part->index_count / 3 : 0;
        for (size_t v = 0; v < part->vertex_count && !missing; ++v)
            missing = !floats_are_direction(part->normals + 3 * v);
    }
    return missing;
}

static bool complete(model *m, normals *n, uint32_t *vertex_counts, double crease_degrees,
                     uint64_t *memory_left)
{
    for (size_t p = 0; p < m->part_count; ++p)
        vertex_counts[p] = m->parts[p].vertex_count;
    add_triangles(m, n);
    normalize_means(n);
    const crease_input in = {&n->places, n->triangle, n->means};
    if (n->triangle != NULL && !creases_divide(m, &in, crease_degrees, memory_left))
        return false;
    write_normals(m, n, vertex_counts);
    return true;
}

bool model_complete_normals(model *m, double crease_degrees, uint64_t *memory_left)
{
    normals n = {{0, 0, NULL}, NULL, NULL};
    const bool divides = crease_degrees < 180.0;
    uint64_t vertices, triangles;
    if (!is_incomplete(m, &vertices, &triangles))
        return true;
    const uint64_t size = model_places_size(vertices) + sizeof *n.means * (vertices + 1) +
                          (divides ? sizeof *n.triangle * (triangles + 1) : 0) +
                          sizeof(uint32_t) * ((uint64_t)m->part_count + 1);
    /* Corners have numbers of 32 bits. */
    if (size > *memory_left || triangles >= UINT32_MAX / 3)
        return false;
    *memory_left -= size;
    uint32_t *const vertex_counts = malloc(sizeof *vertex_counts * (m->part_count + 1));
    bool good = vertex_counts != NULL && model_places_find(m, &n.places);
    if (good) {
        n.means = calloc((size_t)n.places.count + 1, sizeof *n.means);
        n.triangle = divides ? calloc((size_t)triangles + 1, sizeof *n.triangle) : NULL;
        good = n.means != NULL && (n.triangle != NULL || !divides);
    }
    good = good && complete(m, &n, vertex_counts, crease_degrees, memory_left);
    model_places_free(&n.places);
    free(vertex_counts);
    free(n.means);
    free(n.triangle);
    *memory_left += size;
    return good;
}
