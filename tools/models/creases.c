/* Divides vertices at creases. Places whose triangles all face about the same way, which are most
 * in a smooth model, are left out first. */
#include "creases.h"

#include <stdlib.h>
#include <string.h>

#include "doubles.h"

/* A vertex for a group of corners that cannot share the file's. */
typedef struct vertex_copy {
    uint32_t part, vertex; /* what it is a copy of */
    float normal[3];
} vertex_copy;

/* Where a part stands in the model, and how many vertices it gets. */
typedef struct part_place {
    uint32_t first_corner, first_vertex, added;
} part_place;

/* A corner at a place, while the place is divided. */
typedef struct local_corner {
    model_part *part;
    uint32_t part_number;
    uint32_t number;   /* in the part */
    uint32_t triangle; /* of all */
    uint32_t parent;   /* groups of corners are trees; the root has the least number */
    bool is_bent;      /* of a root: its group has different normals */
    double sum[3];     /* of a root: of the normals of its group, times their angles */
} local_corner;

/* What is sorted: numbers by a key, then by themselves. */
typedef struct keyed {
    uint64_t key;
    uint32_t number;
} keyed;

/* The corners at divided places, place after place. A corner is named by its number among those of
 * all triangles, part after part. */
typedef struct division {
    model *m;
    const crease_input *in;
    uint64_t *memory_left;
    uint64_t taken; /* of it, for what is freed at the end */
    double least_cosine;
    part_place *parts;
    uint8_t *is_sharp; /* of each place: a triangle faces far from the mean */
    uint32_t *first;   /* where each place begins in `corners`, and the end */
    uint32_t *corners;
    uint32_t *vertices; /* in their parts: what becomes of the index of each of `corners` */
    local_corner *own;  /* those of one place */
    keyed *sorted;
    vertex_copy *copies;
    size_t copy_count, copy_room;
} division;

static void *allocate(division *d, uint64_t count, size_t size)
{
    const uint64_t bytes = (count + 1) * size;
    if (bytes > *d->memory_left)
        return NULL;
    *d->memory_left -= bytes;
    d->taken += bytes;
    return calloc((size_t)count + 1, size);
}

static uint32_t triangle_count(const model_part *part)
{
    return part->kind == MODEL_TRIANGLES ? part->index_count / 3 : 0;
}

static bool may_divide(const model_part *part, uint32_t vertex)
{
    return !floats_are_direction(part->normals + 3 * (size_t)vertex) &&
           (part->smoothing == NULL || part->smoothing[vertex] == 0);
}

static double dot_with_mean(const float *normal, const double *mean)
{
    return (double)normal[0] * mean[0] + (double)normal[1] * mean[1] + (double)normal[2] * mean[2];
}

/* Finds the places at which a triangle faces away from the mean by more than half of the angle, and
 * counts the corners of each place that may be divided, in the second `first` behind its own. At
 * the other places no two triangles differ by more than the angle. Returns whether there is such a
 * place. */
static bool find_sharp(division *d, double degrees)
{
    const double half_cosine = cos(0.5 * degrees * (3.14159265358979323846 / 180.0));
    const uint32_t *place = d->in->places->of_vertex;
    const float(*normal)[3] = (const float(*)[3])d->in->normals;
    bool some = false;
    for (size_t p = 0; p < d->m->part_count; place += d->m->parts[p].vertex_count, ++p) {
        const model_part *const part = d->m->parts + p;
        const uint32_t *v = part->indices;
        for (uint32_t t = triangle_count(part); t > 0; --t, ++normal, v += 3) {
            if (!floats_are_direction(*normal))
                continue;
            for (int k = 0; k < 3; ++k) {
                const uint32_t at = place[v[k]];
                if (!may_divide(part, v[k]))
                    continue;
                ++d->first[at + 2];
                if (!(dot_with_mean(*normal, d->in->means[at]) >= half_cosine))
                    d->is_sharp[at] = some = true;
            }
        }
    }
    return some;
}

/* Turns the counts into places' beginnings in `corners`. Each entry behind the first is where the
 * place before it begins, and write_corners moves it to its end. Returns the number of corners;
 * *most is the most at one place. */
static uint32_t sum_counts(division *d, uint32_t *most)
{
    const uint32_t places = d->in->places->count;
    *most = 0;
    for (uint32_t p = 0; p < places; ++p) {
        const uint32_t count = d->is_sharp[p] ? d->first[p + 2] : 0;
        *most = count > *most ? count : *most;
        d->first[p + 2] = d->first[p + 1] + count;
    }
    return d->first[places + 1];
}

static void write_corners(division *d)
{
    const uint32_t *place = d->in->places->of_vertex;
    const float(*normal)[3] = (const float(*)[3])d->in->normals;
    uint32_t corner = 0;
    for (size_t p = 0; p < d->m->part_count; place += d->m->parts[p].vertex_count, ++p) {
        const model_part *const part = d->m->parts + p;
        const uint32_t *const end = part->indices + 3 * (size_t)triangle_count(part);
        for (const uint32_t *v = part->indices; v < end; ++v, ++corner) {
            const uint32_t at = place[*v];
            if (!d->is_sharp[at] || !may_divide(part, *v) ||
                !floats_are_direction(normal[corner / 3]))
                continue;
            d->vertices[d->first[at + 1]] = *v;
            d->corners[d->first[at + 1]++] = corner;
        }
    }
}

/* The last part that begins at the corner or before it. */
static uint32_t part_of(const division *d, uint32_t corner)
{
    size_t low = 0, high = d->m->part_count;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (d->parts[middle].first_corner <= corner)
            low = middle;
        else
            high = middle;
    }
    return (uint32_t)low;
}

static void load_corners(division *d, const uint32_t *corners, uint32_t count)
{
    for (uint32_t i = 0; i < count; ++i) {
        local_corner *const own = d->own + i;
        own->part_number = part_of(d, corners[i]);
        own->part = d->m->parts + own->part_number;
        own->number = corners[i] - d->parts[own->part_number].first_corner;
        own->triangle = corners[i] / 3;
        own->parent = i;
        own->is_bent = false;
        memset(own->sum, 0, sizeof own->sum);
    }
}

static int compare_keys(const void *a, const void *b)
{
    const keyed *const x = a, *const y = b;
    if (x->key != y->key)
        return x->key < y->key ? -1 : 1;
    return x->number < y->number ? -1 : x->number > y->number;
}

/* Most places have few corners. */
static void sort(keyed *all, size_t count)
{
    if (count > 32) {
        qsort(all, count, sizeof *all, compare_keys);
        return;
    }
    for (size_t i = 1; i < count; ++i) {
        const keyed moved = all[i];
        size_t at = i;
        for (; at > 0 && compare_keys(&moved, all + at - 1) < 0; --at)
            all[at] = all[at - 1];
        all[at] = moved;
    }
}

static uint32_t root_of(local_corner *own, uint32_t corner)
{
    while (own[corner].parent != corner)
        corner = own[corner].parent = own[own[corner].parent].parent;
    return corner;
}

static const float *normal_of(const division *d, const local_corner *corner)
{
    return d->in->normals[corner->triangle];
}

static bool is_smooth_between(const division *d, uint32_t a, uint32_t b)
{
    const float *const m = normal_of(d, d->own + a), *const n = normal_of(d, d->own + b);
    return (double)m[0] * (double)n[0] + (double)m[1] * (double)n[1] +
               (double)m[2] * (double)n[2] >=
           d->least_cosine;
}

/* The vertex of the corner that is k further on in the triangle. */
static uint32_t vertex_of(const local_corner *corner, uint32_t k)
{
    const uint32_t n = corner->number;
    return corner->part->indices[n - n % 3 + (n + k) % 3];
}

/* Joins the corners at a place whose triangles share an edge there that is no crease. Returns the
 * number of groups. */
static uint32_t join(division *d, uint32_t count)
{
    uint32_t groups = count;
    size_t entries = 0;
    for (uint32_t i = 0; i < count; ++i)
        for (uint32_t k = 1; k < 3; ++k) {
            const local_corner *const own = d->own + i;
            const uint32_t *const places =
                d->in->places->of_vertex + d->parts[own->part_number].first_vertex;
            d->sorted[entries++] = (keyed){places[vertex_of(own, k)], i};
        }
    sort(d->sorted, entries);
    for (size_t i = 1; i < entries; ++i) {
        const uint32_t a = d->sorted[i - 1].number, b = d->sorted[i].number;
        if (d->sorted[i - 1].key != d->sorted[i].key || !is_smooth_between(d, a, b))
            continue;
        const uint32_t x = root_of(d->own, a), y = root_of(d->own, b);
        d->own[x > y ? x : y].parent = x > y ? y : x;
        groups -= x != y;
    }
    return groups;
}

/* The angle of a triangle at a corner of it. */
static double angle_at(const local_corner *corner)
{
    const float *const p = corner->part->positions;
    const float *const at = p + 3 * (size_t)vertex_of(corner, 0);
    double a[3], b[3], across[3];
    doubles_between(at, p + 3 * (size_t)vertex_of(corner, 1), a);
    doubles_between(at, p + 3 * (size_t)vertex_of(corner, 2), b);
    doubles_cross(a, b, across);
    return atan2(sqrt(doubles_dot(across, across)), doubles_dot(a, b));
}

/* Sums the normals of groups that have different ones. */
static void sum_groups(division *d, uint32_t count)
{
    for (uint32_t i = 0; i < count; ++i) {
        local_corner *const root = d->own + root_of(d->own, i);
        if (memcmp(normal_of(d, root), normal_of(d, d->own + i), 3 * sizeof(float)) != 0)
            root->is_bent = true;
    }
    for (uint32_t i = 0; i < count; ++i) {
        local_corner *const root = d->own + root_of(d->own, i);
        const float *const normal = normal_of(d, d->own + i);
        if (!root->is_bent)
            continue;
        const double angle = angle_at(d->own + i);
        for (int c = 0; c < 3; ++c)
            root->sum[c] += angle * (double)normal[c];
    }
}

/* The normal of a group; that of the first triangle if the sum has no length. */
static void write_group_normal(const division *d, const local_corner *root, double result[3])
{
    const double length = sqrt(doubles_dot(root->sum, root->sum));
    const bool is_sum = root->is_bent && length > 0.0;
    for (int c = 0; c < 3; ++c)
        result[c] = is_sum ? root->sum[c] / length : (double)normal_of(d, root)[c];
}

static bool grow_copies(division *d)
{
    const size_t added = d->copy_room + 64;
    const uint64_t bytes = added * sizeof *d->copies;
    vertex_copy *copies = NULL;
    if (bytes <= *d->memory_left)
        copies = realloc(d->copies, (d->copy_room + added) * sizeof *copies);
    if (copies == NULL)
        return false;
    *d->memory_left -= bytes;
    d->taken += bytes;
    d->copies = copies;
    d->copy_room += added;
    return true;
}

/* Adds a copy of a corner's vertex, if there is memory for it. Returns its number in the part. */
static bool add_copy(division *d, const local_corner *corner, const float normal[3],
                     uint32_t *number)
{
    part_place *const part = d->parts + corner->part_number;
    if (corner->part->vertex_count + (uint64_t)part->added >= UINT32_MAX)
        return false;
    if (d->copy_count == d->copy_room && !grow_copies(d))
        return false;
    *number = corner->part->vertex_count + part->added++;
    d->copies[d->copy_count++] =
        (vertex_copy){corner->part_number, vertex_of(corner, 0), {normal[0], normal[1], normal[2]}};
    return true;
}

/* Gives each group of corners at a place vertices of its own. The first group of a vertex keeps
 * it. */
static bool divide(division *d, uint32_t count, uint32_t *vertices, double mean[3])
{
    uint32_t used = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const local_corner *const own = d->own + i;
        const uint32_t vertex = d->parts[own->part_number].first_vertex + vertex_of(own, 0);
        d->sorted[i] = (keyed){(uint64_t)vertex << 32 | root_of(d->own, i), i};
    }
    sort(d->sorted, count);
    for (uint32_t i = 0; i < count; ++i) {
        const keyed *const one = d->sorted + i;
        const local_corner *const own = d->own + one->number;
        if (i == 0 || one->key != one[-1].key) {
            double precise[3];
            float normal[3];
            write_group_normal(d, d->own + (uint32_t)one->key, precise);
            for (int c = 0; c < 3; ++c)
                normal[c] = (float)precise[c];
            used = vertex_of(own, 0);
            if (i == 0 || one->key >> 32 != one[-1].key >> 32)
                memcpy(own->part->normals + 3 * (size_t)used, normal, sizeof normal);
            else if (!add_copy(d, own, normal, &used))
                return false;
        }
        vertices[one->number] = used;
    }
    write_group_normal(d, d->own, mean);
    return true;
}

static bool divide_places(division *d)
{
    for (uint32_t p = 0; p < d->in->places->count; ++p) {
        const uint32_t first = d->first[p], count = d->first[p + 1] - first;
        if (count < 2)
            continue;
        load_corners(d, d->corners + first, count);
        if (join(d, count) < 2)
            continue;
        sum_groups(d, count);
        if (!divide(d, count, d->vertices + first, d->in->means[p]))
            return false;
    }
    return true;
}

/* Makes room for more vertices in one array of a part. */
static bool grow(void *array, size_t size, const model_part *part, uint32_t added)
{
    void *old, *longer;
    memcpy(&old, array, sizeof old);
    if (old == NULL)
        return true;
    longer = realloc(old, size * ((size_t)part->vertex_count + added + 1));
    if (longer == NULL)
        return false;
    memcpy(array, &longer, sizeof longer);
    return true;
}

static bool grow_part(division *d, model_part *part, uint32_t added)
{
    const size_t smoothing = part->smoothing != NULL ? sizeof *part->smoothing : 0;
    const uint64_t bytes = model_part_size(part, part->vertex_count + added, 0) -
                           model_part_size(part, part->vertex_count, 0) +
                           smoothing * (uint64_t)added;
    if (bytes > *d->memory_left)
        return false;
    *d->memory_left -= bytes;
    return grow(&part->positions, 3 * sizeof(float), part, added) &&
           grow(&part->normals, 3 * sizeof(float), part, added) &&
           grow(&part->colors, 4 * sizeof(float), part, added) &&
           grow(&part->texcoords, 2 * sizeof(float), part, added) &&
           grow(&part->tangents, 4 * sizeof(float), part, added) &&
           grow(&part->smoothing, sizeof *part->smoothing, part, added);
}

static void copy_numbers(float *array, size_t components, uint32_t to, uint32_t from)
{
    if (array != NULL)
        memcpy(array + components * to, array + components * from, components * sizeof *array);
}

/* Adds the copy behind the part's vertices. */
static void write_copy(model_part *part, const vertex_copy *copy)
{
    const uint32_t to = part->vertex_count++;
    copy_numbers(part->positions, 3, to, copy->vertex);
    copy_numbers(part->colors, 4, to, copy->vertex);
    copy_numbers(part->texcoords, 2, to, copy->vertex);
    copy_numbers(part->tangents, 4, to, copy->vertex);
    memcpy(part->normals + 3 * (size_t)to, copy->normal, sizeof copy->normal);
    if (part->smoothing != NULL)
        part->smoothing[to] = part->smoothing[copy->vertex];
}

static bool rewrite_parts(division *d)
{
    const uint32_t corner_count = d->first[d->in->places->count];
    for (size_t p = 0; p < d->m->part_count; ++p)
        if (d->parts[p].added > 0 && !grow_part(d, d->m->parts + p, d->parts[p].added))
            return false;
    for (size_t i = 0; i < d->copy_count; ++i)
        write_copy(d->m->parts + d->copies[i].part, d->copies + i);
    for (uint32_t i = 0; i < corner_count; ++i) {
        const uint32_t part = part_of(d, d->corners[i]);
        d->m->parts[part].indices[d->corners[i] - d->parts[part].first_corner] = d->vertices[i];
    }
    return true;
}

static bool divide_all(division *d, double degrees)
{
    uint32_t corner = 0, vertex = 0, most;
    d->parts = allocate(d, d->m->part_count, sizeof *d->parts);
    d->is_sharp = allocate(d, d->in->places->count, sizeof *d->is_sharp);
    d->first = allocate(d, d->in->places->count + (uint64_t)1, sizeof *d->first);
    if (d->parts == NULL || d->is_sharp == NULL || d->first == NULL)
        return false;
    for (size_t p = 0; p < d->m->part_count; ++p) {
        d->parts[p] = (part_place){corner, vertex, 0};
        corner += 3 * triangle_count(d->m->parts + p);
        vertex += d->m->parts[p].vertex_count;
    }
    if (!find_sharp(d, degrees))
        return true;
    const uint32_t count = sum_counts(d, &most);
    d->corners = allocate(d, count, sizeof *d->corners);
    d->vertices = allocate(d, count, sizeof *d->vertices);
    d->own = allocate(d, most, sizeof *d->own);
    d->sorted = allocate(d, 2 * (uint64_t)most, sizeof *d->sorted);
    if (d->corners == NULL || d->vertices == NULL || d->own == NULL || d->sorted == NULL)
        return false;
    write_corners(d);
    return divide_places(d) && rewrite_parts(d);
}

bool creases_divide(model *m, const crease_input *in, double degrees, uint64_t *memory_left)
{
    division d;
    memset(&d, 0, sizeof d);
    d.m = m;
    d.in = in;
    d.memory_left = memory_left;
    d.least_cosine = cos(degrees * (3.14159265358979323846 / 180.0));
    const bool good = divide_all(&d, degrees);
    free(d.parts);
    free(d.is_sharp);
    free(d.first);
    free(d.corners);
    free(d.vertices);
    free(d.own);
    free(d.sorted);
    free(d.copies);
    *memory_left += d.taken;
    return good;
}
