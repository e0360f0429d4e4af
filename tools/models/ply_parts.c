/* Makes parts of a PLY mesh: each has vertices of its own, those that it uses. */
#include <string.h>

#include "origin.h"
#include "ply.h"

#define NONE UINT32_MAX

/* Vertices of the file become several if their corners differ in texture coordinates or colour.
 * So many of one vertex are compared; what is beyond is not shared. */
#define MOST_COMPARED 64

/* A part in the making. */
typedef struct part_maker {
    model_reader *r;
    const ply_mesh *mesh;
    const ply_primitives *from;
    model_kind kind;
    size_t corners;    /* of a primitive */
    uint32_t *newest;  /* for each vertex of the file: the last vertex of the part made of it */
    uint32_t *sources; /* for each vertex of the part: the corner it was made for */
    uint32_t *older;   /* and the vertex made of the same before it */
    uint32_t *indices;
    size_t source_count, source_room, older_room, index_count, index_room;
} part_maker;

/* Whether two corners of one vertex are one vertex of the part. */
static bool is_same(const part_maker *m, size_t a, size_t b)
{
    const ply_primitives *const p = m->from;
    if (p->has_wedges && memcmp(p->wedges + 2 * a, p->wedges + 2 * b, 2 * sizeof(float)) != 0)
        return false;
    return !p->has_colors || memcmp(p->colors + 4 * (a / m->corners),
                                    p->colors + 4 * (b / m->corners), 4 * sizeof(float)) == 0;
}

/* Adds the index of a corner, and a vertex for it if there is none. */
static bool add_corner(part_maker *m, uint32_t corner)
{
    const uint32_t vertex = m->from->corners[corner];
    uint32_t found = m->newest[vertex];
    for (int i = 0; found != NONE && !is_same(m, m->sources[found], corner); ++i)
        found = i < MOST_COMPARED ? m->older[found] : NONE;
    if (found == NONE) {
        found = (uint32_t)m->source_count++;
        if (!reader_grow(m->r, &m->sources, &m->source_room, m->source_count, sizeof *m->sources) ||
            !reader_grow(m->r, &m->older, &m->older_room, m->source_count, sizeof *m->older))
            return false;
        m->sources[found] = corner;
        m->older[found] = m->newest[vertex];
        m->newest[vertex] = found;
    }
    if (!reader_grow(m->r, &m->indices, &m->index_room, m->index_count + 1, sizeof *m->indices))
        return false;
    m->indices[m->index_count++] = found;
    return true;
}

/* Adds the corners of the primitives with a texture, a number of the header's; PLY_NO_TEXTURE: of
 * those whose number the header does not have. */
static bool add_corners(part_maker *m, uint32_t texture, size_t texture_count)
{
    const ply_primitives *const p = m->from;
    for (uint32_t c = 0; c < p->corner_count; ++c) {
        const uint32_t number = p->has_textures ? p->textures[c / m->corners] : 0;
        if ((number < texture_count ? number : PLY_NO_TEXTURE) == texture && !add_corner(m, c))
            return false;
    }
    return true;
}

static void copy_floats(float *to, const float *from, size_t count)
{
    memcpy(to, from, count * sizeof *to);
}

/* Fills a part's vertices. `base` is the colour without colours in the file. */
static void fill(const part_maker *m, model_part *part, float base)
{
    const ply_mesh *const mesh = m->mesh;
    const ply_primitives *const p = m->from;
    const float plain[4] = {base, base, base, 1.0f};
    for (size_t v = 0; v < m->source_count; ++v) {
        const size_t corner = m->sources[v], from = p->corners[corner];
        for (size_t c = 0; c < 3; ++c)
            part->positions[3 * v + c] =
                (float)(mesh->positions[3 * from + c] - m->r->result->origin[c]);
        if (mesh->normals != NULL)
            copy_floats(part->normals + 3 * v, mesh->normals + 3 * from, 3);
        copy_floats(part->colors + 4 * v,
                    p->has_colors          ? p->colors + 4 * (corner / m->corners)
                    : mesh->colors != NULL ? mesh->colors + 4 * from
                                           : plain,
                    4);
        if (part->has_texcoords)
            copy_floats(part->texcoords + 2 * v,
                        p->has_wedges ? p->wedges + 2 * corner : mesh->texcoords + 2 * from, 2);
    }
}

/* Blends a part with alpha below 1. Scanners that write alpha 0 for all mean nothing by it. */
static void choose_alpha(model_reader *r, model_part *part)
{
    float least = 1.0f, largest = 0.0f;
    for (size_t v = 0; v < part->vertex_count; ++v) {
        const float alpha = part->colors[4 * v + 3];
        least = alpha < least ? alpha : least;
        largest = alpha > largest ? alpha : largest;
    }
    if (largest > 0.0f) {
        part->surface.alpha = least < 1.0f ? MODEL_BLEND : MODEL_OPAQUE;
        return;
    }
    reader_warn(r, NULL, "alpha is 0 everywhere; it is drawn opaque");
    for (size_t v = 0; v < part->vertex_count; ++v)
        part->colors[4 * v + 3] = 1.0f;
}

static bool finish(part_maker *m, uint32_t image)
{
    model_reader *const r = m->r;
    const ply_mesh *const mesh = m->mesh;
    const size_t number = reader_add_part(r);
    if (number == SIZE_MAX)
        return false;
    model_part *const part = r->result->parts + number;
    const bool has_map = image != MODEL_NO_IMAGE;
    part->kind = m->kind;
    part->has_normals = mesh->normals != NULL;
    part->has_texcoords = m->from->has_wedges || mesh->texcoords != NULL;
    part->has_tangents = part->has_texcoords && m->kind == MODEL_TRIANGLES;
    part->has_vertex_colors = m->from->has_colors || mesh->colors != NULL;
    if (!reader_allocate_part(r, part, (uint32_t)m->source_count, (uint32_t)m->index_count))
        return false;
    memcpy(part->indices, m->indices, m->index_count * sizeof *m->indices);
    if (has_map) {
        part->maps[MAP_DIFFUSE] = model_map_of(image);
        ++r->result->material_count;
    }
    fill(m, part, has_map ? 1.0f : PLY_GREY);
    choose_alpha(r, part);
    return true;
}

/* Makes the part of the primitives with one texture; none if there are no such primitives. */
static bool make_part(model_reader *r, const ply_header *h, const ply_mesh *mesh,
                      const ply_primitives *from, model_kind kind, uint32_t texture)
{
    part_maker m;
    if (from->corner_count == 0)
        return true;
    memset(&m, 0, sizeof m);
    m.r = r;
    m.mesh = mesh;
    m.from = from;
    m.kind = kind;
    m.corners = model_corners(kind);
    m.newest = reader_allocate(r, mesh->vertex_count, sizeof *m.newest);
    bool good = m.newest != NULL;
    if (good)
        memset(m.newest, 0xff, mesh->vertex_count * sizeof *m.newest);
    const bool has_texcoords = from->has_wedges || mesh->texcoords != NULL;
    const size_t textures = kind == MODEL_TRIANGLES && has_texcoords ? h->texture_count : 0;
    good = good && add_corners(&m, texture, textures);
    uint32_t image = MODEL_NO_IMAGE;
    if (good && texture != PLY_NO_TEXTURE && m.index_count > 0) {
        char name[1024];
        image = reader_image(r, text_copy(h->textures[texture], name, sizeof name));
        good = image != MODEL_NO_IMAGE;
    }
    good = good && (m.index_count == 0 || finish(&m, image));
    reader_release(r, m.newest, mesh->vertex_count, sizeof *m.newest);
    reader_release(r, m.sources, m.source_room, sizeof *m.sources);
    reader_release(r, m.older, m.older_room, sizeof *m.older);
    reader_release(r, m.indices, m.index_room, sizeof *m.indices);
    return good;
}

static void add_bounds(const ply_mesh *mesh, const ply_primitives *p, origin_bounds *bounds)
{
    for (size_t c = 0; c < p->corner_count; ++c)
        origin_add(bounds, mesh->positions + 3 * (size_t)p->corners[c]);
}

static bool make_all(model_reader *r, const ply_header *h, const ply_mesh *mesh,
                     const ply_primitives *points)
{
    const ply_primitives *const triangles = &mesh->triangles;
    const bool has_texcoords = triangles->has_wedges || mesh->texcoords != NULL;
    char name[64];
    if (triangles->corner_count > UINT32_MAX || mesh->lines.corner_count > UINT32_MAX)
        return reader_fail(r, "it has more than %lu corners", (unsigned long)UINT32_MAX);
    if (h->texture_count > 0 && !(has_texcoords && triangles->corner_count > 0))
        reader_warn(r, NULL, "TextureFile %s is not drawn: no face has texture coordinates",
                    text_copy(h->textures[0], name, sizeof name));
    for (uint32_t t = 0; has_texcoords && t < h->texture_count; ++t)
        if (!make_part(r, h, mesh, triangles, MODEL_TRIANGLES, t))
            return false;
    return make_part(r, h, mesh, triangles, MODEL_TRIANGLES, PLY_NO_TEXTURE) &&
           make_part(r, h, mesh, &mesh->lines, MODEL_LINES, PLY_NO_TEXTURE) &&
           make_part(r, h, mesh, points, MODEL_POINTS, PLY_NO_TEXTURE);
}

bool ply_make_parts(model_reader *r, const ply_header *h, ply_mesh *mesh, bool has_points)
{
    ply_primitives points;
    origin_bounds bounds = origin_empty();
    memset(&points, 0, sizeof points);
    bool good = !has_points || ply_add_points(r, mesh, &points);
    if (good) {
        add_bounds(mesh, &mesh->triangles, &bounds);
        add_bounds(mesh, &mesh->lines, &bounds);
        add_bounds(mesh, &points, &bounds);
        origin_choose(&bounds, r->result->origin);
        good = make_all(r, h, mesh, &points);
    }
    ply_primitives_free(r, &points);
    return good;
}
