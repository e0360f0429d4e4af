/* Makes parts of the model from the primitives of a glTF at their places: morphed by the default
 * weights, moved by the joints of skins in their rest pose or by the nodes. */
#include <math.h>
#include <string.h>

#include "doubles.h"
#include "gltf.h"
#include "origin.h"

/* Vertices that are worked on at a time; whole triangles. */
#define BATCH 96

/* More vertices times morph targets than this are refused: a small file could ask for years. */
#define MOST_MORPHS ((uint64_t)1 << 30)

typedef struct morph {
    gltf_accessor position, normal, tangent; /* count 0: absent */
    double weight;
} morph;

/* A primitive at a place, and the part that it goes to. */
typedef struct filler {
    gltf *g;
    const gltf_primitive *p;
    gltf_group *group;
    model_part *part;
    const gltf_material *material;
    gltf_matrix world;
    bool is_moved;
    const gltf_skin *skin; /* null: moved by `world` */
    morph *morphs;
    size_t morph_count, morph_capacity;
    origin_bounds *all;
} filler;

typedef struct batch {
    double positions[BATCH][3], normals[BATCH][3], tangents[BATCH][4];
    float floats[4 * BATCH]; /* what is read */
} batch;

/* Returns false, without a change, for a vector without length. */
static bool normalize(double v[3])
{
    const double length = sqrt(doubles_dot(v, v));
    if (!(length > 0.0))
        return false;
    for (int c = 0; c < 3; ++c)
        v[c] /= length;
    return true;
}

static void apply_point(const gltf_matrix *m, double v[3])
{
    double result[3];
    for (int row = 0; row < 3; ++row)
        result[row] =
            m->m[0][row] * v[0] + m->m[1][row] * v[1] + m->m[2][row] * v[2] + m->m[3][row];
    memcpy(v, result, sizeof result);
}

static void apply_direction(const gltf_matrix *m, double v[3])
{
    double result[3];
    for (int row = 0; row < 3; ++row)
        result[row] = m->m[0][row] * v[0] + m->m[1][row] * v[1] + m->m[2][row] * v[2];
    memcpy(v, result, sizeof result);
    normalize(v);
}

/* The inverse transpose of the upper 3 x 3, times the determinant's magnitude: the cofactors, whose
 * columns are cross products of the matrix's. */
static gltf_matrix normal_matrix(const gltf_matrix *m)
{
    const double sign = gltf_determinant(m) < 0.0 ? -1.0 : 1.0;
    gltf_matrix result = gltf_identity();
    for (int column = 0; column < 3; ++column) {
        doubles_cross(m->m[(column + 1) % 3], m->m[(column + 2) % 3], result.m[column]);
        for (int row = 0; row < 3; ++row)
            result.m[column][row] *= sign;
    }
    return result;
}

/* Moves what a vertex has by a matrix. A matrix that mirrors turns normal x tangent, so that w,
 * which the bitangent is multiplied by, gets the other sign. */
static void move(const gltf_matrix *m, const gltf_matrix *normals, bool has_normals, double *p,
                 double *n, double *t)
{
    apply_point(m, p);
    if (!has_normals)
        return;
    apply_direction(normals, n);
    apply_direction(m, t);
    if (gltf_determinant(m) < 0.0)
        t[3] = -t[3];
}

/* Adds floats to values that have `stride` components, times a weight. */
static void add_floats(const float *floats, uint32_t count, uint32_t components, size_t stride,
                       double weight, double *values)
{
    for (uint32_t i = 0; i < count; ++i)
        for (uint32_t c = 0; c < components; ++c)
            values[i * stride + c] += weight * (double)floats[i * components + c];
}

static void add_accessor(const gltf_accessor *a, const uint32_t *which, uint32_t first,
                         uint32_t count, double weight, size_t stride, batch *b, double *values)
{
    if (a->count == 0)
        return;
    gltf_floats(a, which, first, count, b->floats);
    add_floats(b->floats, count, a->components, stride, weight, values);
}

static void read_base(const filler *f, const uint32_t *which, uint32_t first, uint32_t count,
                      batch *b)
{
    memset(b->positions, 0, count * sizeof b->positions[0]);
    memset(b->normals, 0, count * sizeof b->normals[0]);
    memset(b->tangents, 0, count * sizeof b->tangents[0]);
    add_accessor(&f->p->position, which, first, count, 1.0, 3, b, b->positions[0]);
    add_accessor(&f->p->normal, which, first, count, 1.0, 3, b, b->normals[0]);
    add_accessor(&f->p->tangent, which, first, count, 1.0, 4, b, b->tangents[0]);
    for (size_t i = 0; i < f->morph_count; ++i) {
        const morph *const m = f->morphs + i;
        add_accessor(&m->position, which, first, count, m->weight, 3, b, b->positions[0]);
        add_accessor(&m->normal, which, first, count, m->weight, 3, b, b->normals[0]);
        add_accessor(&m->tangent, which, first, count, m->weight, 4, b, b->tangents[0]);
    }
}

static void add_matrix(const gltf_matrix *m, double weight, gltf_matrix *sum)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            sum->m[column][row] += weight * m->m[column][row];
}

/* The matrix of a vertex: the mean of its joints' by weight; if all weights are 0, that of its
 * first joint. */
static bool blend_joints(const filler *f, uint32_t vertex, gltf_matrix *m)
{
    double sum = 0.0;
    memset(m, 0, sizeof *m);
    for (int set = 0; set < GLTF_JOINT_SETS; ++set) {
        float joints[4], weights[4];
        if (f->p->joints[set].count == 0 || f->p->weights[set].count == 0)
            continue;
        gltf_floats(f->p->joints + set, NULL, vertex, 1, joints);
        gltf_floats(f->p->weights + set, NULL, vertex, 1, weights);
        for (int k = 0; k < 4; ++k) {
            if (!(weights[k] > 0.0f))
                continue;
            /* Unsigned integers of 16 bits, which a float holds. */
            if (!(joints[k] < (float)f->skin->joint_count))
                return reader_fail_at(f->g->r, gltf_path(f->g, f->p->token),
                                      "a joint of a vertex is %u, but its skin has %u joints",
                                      (unsigned)joints[k], (unsigned)f->skin->joint_count);
            add_matrix(f->skin->joints + (size_t)joints[k], (double)weights[k], m);
            sum += (double)weights[k];
        }
    }
    if (!(sum > 0.0)) {
        float joints[4];
        gltf_floats(f->p->joints, NULL, vertex, 1, joints);
        *m = f->skin->joints[joints[0] < (float)f->skin->joint_count ? (size_t)joints[0] : 0];
        return true;
    }
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            m->m[column][row] /= sum;
    return true;
}

/* Moves the vertices of a batch to their places in the world. */
static bool move_batch(const filler *f, const uint32_t *which, uint32_t first, uint32_t count,
                       batch *b)
{
    const bool has_normals = f->p->normal.count != 0;
    gltf_matrix m = f->world, normals = normal_matrix(&m);
    if (!f->is_moved && f->skin == NULL)
        return true;
    for (uint32_t i = 0; i < count; ++i) {
        if (f->skin != NULL) {
            if (!blend_joints(f, which != NULL ? which[i] : first + i, &m))
                return false;
            normals = normal_matrix(&m);
        }
        move(&m, &normals, has_normals, b->positions[i], b->normals[i], b->tangents[i]);
    }
    return true;
}

/* The normals of triangles (section 3.7.2.1: without NORMAL they are flat); of one that has no
 * area, and of lines and points, any direction. */
static void flat_normals(const filler *f, uint32_t count, batch *b)
{
    for (uint32_t i = 0; i < count; ++i) {
        b->normals[i][0] = b->normals[i][1] = 0.0;
        b->normals[i][2] = 1.0;
    }
    for (uint32_t i = 0; f->p->kind == MODEL_TRIANGLES && i + 2 < count; i += 3) {
        double edges[2][3], normal[3];
        for (int c = 0; c < 3; ++c) {
            edges[0][c] = b->positions[i + 1][c] - b->positions[i][c];
            edges[1][c] = b->positions[i + 2][c] - b->positions[i][c];
        }
        doubles_cross(edges[0], edges[1], normal);
        for (uint32_t k = 0; normalize(normal) && k < 3; ++k)
            memcpy(b->normals[i + k], normal, sizeof normal);
    }
}

static void write_texcoords(const filler *f, const uint32_t *which, uint32_t first, uint32_t count,
                            batch *b, float *texcoords)
{
    const double *const m = f->material->transform;
    gltf_floats(&f->p->texcoord, which, first, count, b->floats);
    for (uint32_t i = 0; i < count; ++i) {
        const double u = (double)b->floats[2 * i], v = (double)b->floats[2 * i + 1];
        texcoords[2 * i] = (float)(m[0] * u + m[1] * v + m[2]);
        texcoords[2 * i + 1] = (float)(1.0 - (m[3] * u + m[4] * v + m[5]));
    }
}

/* The material's colour times the vertex's; without COLOR_0 that is white, and three components
 * have alpha 1 (section 3.7.2.1). */
static void write_colors(const filler *f, const uint32_t *which, uint32_t first, uint32_t count,
                         batch *b, float *colors)
{
    const uint32_t components = f->p->color.count != 0 ? f->p->color.components : 0;
    if (components != 0)
        gltf_floats(&f->p->color, which, first, count, b->floats);
    for (uint32_t i = 0; i < count; ++i) {
        float *const color = colors + 4 * (size_t)i;
        memcpy(color, f->material->color, sizeof f->material->color);
        for (uint32_t c = 0; c < components; ++c)
            color[c] *= b->floats[i * components + c];
        if (f->material->surface.alpha == MODEL_OPAQUE)
            color[3] = 1.0f;
    }
}

static void write_vectors(const filler *f, uint32_t count, const batch *b, size_t at)
{
    const double *const origin = f->g->r->result->origin;
    for (uint32_t i = 0; i < count; ++i) {
        float *const position = f->part->positions + 3 * (at + i);
        float *const normal = f->part->normals + 3 * (at + i);
        for (int c = 0; c < 3; ++c) {
            const double x = b->positions[i][c];
            position[c] = (float)(x - origin[c]);
            normal[c] = (float)b->normals[i][c];
        }
        origin_add(f->all, b->positions[i]);
        for (size_t c = 0; f->part->tangents != NULL && f->p->normal.count != 0 && c < 4; ++c)
            f->part->tangents[4 * (at + i) + c] = (float)b->tangents[i][c];
    }
}

/* Fills vertices of the part from number `at` on: those that `which` names, or if it is null those
 * from `first` on. */
static bool fill_vertices(const filler *f, const uint32_t *which, uint32_t first, uint32_t count,
                          size_t at)
{
    batch b;
    for (uint32_t done = 0; done < count; done += BATCH) {
        const uint32_t some = count - done < BATCH ? count - done : BATCH;
        const uint32_t *const these = which != NULL ? which + done : NULL;
        const size_t to = at + done;
        read_base(f, these, first + done, some, &b);
        if (!move_batch(f, these, first + done, some, &b))
            return false;
        if (f->p->normal.count == 0)
            flat_normals(f, some, &b);
        write_vectors(f, some, &b, to);
        if (f->part->texcoords != NULL)
            write_texcoords(f, these, first + done, some, &b, f->part->texcoords + 2 * to);
        write_colors(f, these, first + done, some, &b, f->part->colors + 4 * to);
    }
    return true;
}

/* Whether every triangle has vertices of its own, with its normal. */
static bool is_flat(const gltf_primitive *p)
{
    return p->kind == MODEL_TRIANGLES && p->normal.count == 0;
}

static uint64_t part_vertices(const gltf_primitive *p)
{
    return is_flat(p) ? p->index_count : p->vertex_count;
}

/* Fills indices and vertices of the part. */
static bool fill(filler *f, bool is_turned)
{
    const gltf_primitive *const p = f->p;
    const uint32_t count = (uint32_t)p->index_count, base = f->group->vertices_done;
    uint32_t *const indices = f->part->indices + f->group->indices_done;
    uint32_t *const source = gltf_source_indices(f->g, p);
    if (source == NULL)
        return false;
    gltf_expand(p, source, is_turned, indices);
    reader_release(f->g->r, source, gltf_source_count(p), sizeof *source);
    if (is_flat(p)) {
        for (uint32_t i = 0; i < count; ++i)
            indices[i] += p->first_vertex;
        if (!fill_vertices(f, indices, 0, count, base))
            return false;
        for (uint32_t i = 0; i < count; ++i)
            indices[i] = base + i;
    } else {
        for (uint32_t i = 0; i < count; ++i)
            indices[i] += base;
        if (!fill_vertices(f, NULL, p->first_vertex, p->vertex_count, base))
            return false;
    }
    f->group->vertices_done += (uint32_t)part_vertices(p);
    f->group->indices_done += count;
    return true;
}

/* Finds the weights of morph targets: the node's or the mesh's (section 3.7.2.2). */
static bool find_weights(gltf *g, const gltf_placement *place, uint32_t *weights)
{
    const uint32_t node = gltf_element(g, GLTF_NODES, place->node);
    const uint32_t mesh = gltf_element(g, GLTF_MESHES, place->mesh);
    if (!gltf_container(g, node, "weights", JSON_ARRAY, weights))
        return false;
    return *weights != JSON_NONE || gltf_container(g, mesh, "weights", JSON_ARRAY, weights);
}

static bool add_morph(filler *f, uint32_t target, double weight)
{
    morph m;
    m.weight = weight;
    if (!gltf_read_target(f->g, f->p, target, "POSITION", &m.position) ||
        !gltf_read_target(f->g, f->p, target, "NORMAL", &m.normal) ||
        !gltf_read_target(f->g, f->p, target, "TANGENT", &m.tangent) ||
        !reader_grow(f->g->r, &f->morphs, &f->morph_capacity, f->morph_count + 1, sizeof m))
        return false;
    f->morphs[f->morph_count++] = m;
    return true;
}

/* Reads the morph targets whose weights are not 0. */
static bool read_morphs(filler *f, const gltf_placement *place)
{
    const json *const j = &f->g->j;
    uint32_t weights;
    if (!find_weights(f->g, place, &weights))
        return false;
    uint32_t w = json_first(j, weights), target = json_first(j, f->p->targets);
    for (; w != JSON_NONE && target != JSON_NONE;
         w = json_after(j, w), target = json_after(j, target)) {
        double weight;
        if (!json_number(j, w, &weight))
            return reader_fail_at(f->g->r, gltf_path(f->g, w), "is no number that fits");
        if (weight != 0.0 && !add_morph(f, target, weight))
            return false;
    }
    return true;
}

static bool is_identity(const gltf_matrix *m)
{
    const gltf_matrix identity = gltf_identity();
    bool same = true;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            same = same && m->m[column][row] == identity.m[column][row];
    return same;
}

/* Finds the skin of a node, if the primitive has joints. */
static bool find_skin(filler *f, uint32_t node)
{
    uint32_t skin = GLTF_NONE;
    if (f->p->joints[0].count == 0 || f->p->weights[0].count == 0)
        return true;
    return gltf_index(f->g, gltf_element(f->g, GLTF_NODES, node), "skin", GLTF_SKINS, &skin) &&
           (skin == GLTF_NONE || gltf_read_skin(f->g, skin, &f->skin));
}

/* Fills the primitive at a place. Triangles that are mirrored are turned, so that their front stays
 * the front (section 3.7.4); a skin mirrors if its first joint does. */
static bool fill_place(gltf *g, const gltf_placement *place, const gltf_primitive *p,
                       origin_bounds *all)
{
    gltf_group *const group = g->groups + p->group;
    filler f = {g,
                p,
                group,
                g->r->result->parts + group->part,
                g->materials + p->material,
                place->world,
                !is_identity(&place->world),
                NULL,
                NULL,
                0,
                0,
                all};
    bool good = find_skin(&f, place->node) && read_morphs(&f, place);
    if (good)
        good = fill(&f, gltf_determinant(f.skin != NULL ? f.skin->joints : &f.world) < 0.0);
    reader_release(g->r, f.morphs, f.morph_capacity, sizeof *f.morphs);
    return good;
}

/* Fills all parts. */
static bool fill_all(gltf *g, origin_bounds *all)
{
    *all = origin_empty();
    for (size_t i = 0; i < g->group_count; ++i)
        g->groups[i].vertices_done = g->groups[i].indices_done = 0;
    for (size_t i = 0; i < g->placement_count; ++i) {
        const gltf_placement *const place = g->placements + i;
        for (uint32_t p = g->meshes[place->mesh]; p != GLTF_NONE; p = g->primitives[p].next)
            if (!fill_place(g, place, g->primitives + p, all))
                return false;
    }
    return true;
}

/* Chooses the origin. Returns whether it is not zero, so that positions must be written anew. */
static bool is_far(gltf *g, const origin_bounds *all)
{
    double *const origin = g->r->result->origin;
    origin_choose(all, origin);
    return origin[0] != 0.0 || origin[1] != 0.0 || origin[2] != 0.0;
}

/* Counts what goes to each group. */
static bool count_all(gltf *g)
{
    uint64_t morphs = 0;
    for (size_t i = 0; i < g->placement_count; ++i) {
        const uint32_t mesh = g->placements[i].mesh;
        if (!gltf_read_mesh(g, mesh))
            return false;
        for (uint32_t p = g->meshes[mesh]; p != GLTF_NONE; p = g->primitives[p].next) {
            const gltf_primitive *const primitive = g->primitives + p;
            gltf_group *const group = g->groups + primitive->group;
            const uint64_t vertices = part_vertices(primitive);
            group->vertex_count += vertices;
            group->index_count += primitive->index_count;
            const uint32_t targets = json_count(&g->j, primitive->targets);
            morphs += targets > 0 && vertices > MOST_MORPHS / targets ? MOST_MORPHS + 1
                                                                      : vertices * targets;
            if (group->vertex_count > UINT32_MAX || group->index_count > UINT32_MAX ||
                morphs > MOST_MORPHS)
                return reader_fail_at(g->r, gltf_path(g, primitive->token),
                                      "the model has more vertices than can be drawn");
        }
    }
    return true;
}

static bool add_parts(gltf *g)
{
    for (size_t i = 0; i < g->group_count; ++i) {
        gltf_group *const group = g->groups + i;
        const gltf_material *const material = g->materials + group->material;
        group->part = reader_add_part(g->r);
        if (group->part == SIZE_MAX)
            return false;
        model_part *const part = g->r->result->parts + group->part;
        part->kind = group->kind;
        part->has_normals = group->has_normals;
        part->has_vertex_colors = group->has_colors;
        part->has_texcoords = group->has_texcoords;
        part->has_tangents = group->has_texcoords && group->kind == MODEL_TRIANGLES;
        part->surface = material->surface;
        /* Lines and points without normals are not lit (section 3.9.6). */
        if (group->kind != MODEL_TRIANGLES && !group->has_normals)
            part->surface.is_unlit = 1;
        if (part->has_texcoords)
            memcpy(part->maps, material->maps, sizeof part->maps);
        if (!reader_allocate_part(g->r, part, (uint32_t)group->vertex_count,
                                  (uint32_t)group->index_count))
            return false;
    }
    return true;
}

bool gltf_make_parts(gltf *g)
{
    origin_bounds all;
    return count_all(g) && add_parts(g) && fill_all(g, &all) &&
           (!is_far(g, &all) || fill_all(g, &all));
}
