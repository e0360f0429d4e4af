/* Faces, strips and edges of PLY files, as corners of triangles and lines. */
#include <math.h>
#include <string.h>

#include "ply.h"
#include "polygon.h"

enum { INDICES, WEDGES };                          /* lists */
enum { TEXTURE = PLY_COLOR_COUNT, FIRST, SECOND }; /* values behind the colours */

static const ply_name face_names[] = {{"vertex_indices", INDICES, true},
                                      {"vertex_index", INDICES, true},
                                      {"texcoord", WEDGES, true},
                                      {"texnumber", TEXTURE, false},
                                      PLY_COLOR_NAMES,
                                      {NULL, 0, false}};

static const ply_name strip_names[] = {
    {"vertex_indices", INDICES, true}, {"vertex_index", INDICES, true}, {NULL, 0, false}};

static const ply_name edge_names[] = {
    {"vertex1", FIRST, false}, {"vertex2", SECOND, false}, PLY_COLOR_NAMES, {NULL, 0, false}};

/* What reading faces, strips or edges goes through. */
typedef struct face_reader {
    ply_rows rows;
    ply_mesh *mesh;
    ply_primitives *result;
    polygon polygon; /* the face that is read */
} face_reader;

static const char *element_name(const face_reader *f, char name[64])
{
    return text_copy(f->rows.element->name, name, 64);
}

/* A vertex that an element names. Returns false with the fault recorded if it is not there. */
static bool vertex_of(const face_reader *f, double index, uint32_t *vertex)
{
    char name[64];
    if (!(index >= 0.0 && index < (double)f->mesh->vertex_count) || index != floor(index))
        return ply_fail(f->rows.source, "%s %llu names vertex %.17g, but there are only %zu",
                        element_name(f, name), (unsigned long long)f->rows.source->number, index,
                        f->mesh->vertex_count);
    *vertex = (uint32_t)index;
    return true;
}

/* Whether the element has a list of indices, of integers. */
static bool require_indices(const face_reader *f)
{
    char name[64], property[64];
    element_name(f, name);
    for (size_t i = 0; i < f->rows.element->property_count; ++i) {
        const ply_property *const p = f->rows.properties + i;
        if (p->is_list && f->rows.targets[i] == INDICES)
            return !ply_type_is_float(p->type) ||
                   reader_fail(f->rows.source->r,
                               "property %s of %s is a list of floats; indices are integers",
                               text_copy(p->name, property, sizeof property), name);
    }
    return reader_fail(f->rows.source->r, "element %s has no list vertex_indices", name);
}

static bool begin(face_reader *f, ply_source *s, const ply_header *h, const ply_name *names,
                  ply_mesh *mesh, ply_primitives *result)
{
    memset(f, 0, sizeof *f);
    f->mesh = mesh;
    f->result = result;
    f->polygon.work_left = POLYGON_MOST_WORK;
    return ply_rows_begin(&f->rows, s, h, names, false);
}

static void end(face_reader *f)
{
    model_reader *const r = f->rows.source->r;
    ply_rows_free(&f->rows);
    polygon_release(r, &f->polygon);
}

/* Makes room for the corners of one more primitive, and adds its colour and texture. */
static bool add_primitive(face_reader *f, size_t corners)
{
    model_reader *const r = f->rows.source->r;
    ply_primitives *const p = f->result;
    const size_t number = p->corner_count / corners;
    if (!reader_grow(r, &p->corners, &p->corner_room, p->corner_count + corners,
                     sizeof *p->corners))
        return false;
    if (p->has_colors) {
        if (!reader_grow(r, &p->colors, &p->color_room, 4 * (number + 1), sizeof *p->colors))
            return false;
        ply_rows_color(&f->rows, p->colors + 4 * number);
    }
    if (p->has_textures) {
        const double texture = f->rows.values[TEXTURE];
        if (!reader_grow(r, &p->textures, &p->texture_room, number + 1, sizeof *p->textures))
            return false;
        p->textures[number] =
            f->rows.has_value[TEXTURE] && texture >= 0.0 && texture < (double)UINT32_MAX
                ? (uint32_t)texture
                : PLY_NO_TEXTURE;
    }
    return true;
}

/* The texture coordinates of a face's corner; 0 if the face has none. */
static void write_wedge(const face_reader *f, uint32_t corner, float wedge[2])
{
    const double *const list = f->rows.lists[WEDGES];
    wedge[0] = wedge[1] = 0.0f;
    if (f->rows.list_length[WEDGES] == 2 * f->rows.list_length[INDICES]) {
        wedge[0] = (float)list[2 * (size_t)corner];
        wedge[1] = (float)list[2 * (size_t)corner + 1];
    }
}

/* Adds a triangle of the row's corners with these numbers. */
static bool add_triangle(face_reader *f, uint32_t a, uint32_t b, uint32_t c)
{
    const uint32_t corners[3] = {a, b, c};
    ply_primitives *const p = f->result;
    if (!add_primitive(f, 3))
        return false;
    if (p->has_wedges && !reader_grow(f->rows.source->r, &p->wedges, &p->wedge_room,
                                      2 * (p->corner_count + 3), sizeof *p->wedges))
        return false;
    for (size_t i = 0; i < 3; ++i) {
        if (p->has_wedges)
            write_wedge(f, corners[i], p->wedges + 2 * (p->corner_count + i));
        p->corners[p->corner_count + i] = (uint32_t)f->rows.lists[INDICES][corners[i]];
    }
    p->corner_count += 3;
    return true;
}

static bool add_polygon(face_reader *f, size_t count)
{
    model_reader *const r = f->rows.source->r;
    polygon *const p = &f->polygon;
    bool is_simple;
    if (!polygon_begin(r, p, count))
        return false;
    for (size_t i = 0; i < count; ++i)
        memcpy(p->corners[i].position,
               f->mesh->positions + 3 * (size_t)(uint32_t)f->rows.lists[INDICES][i],
               sizeof p->corners[i].position);
    if (!polygon_cut(r, p, &is_simple))
        return false;
    if (!is_simple)
        reader_warn(r, NULL,
                    "a face crosses itself, or has very many corners; its triangles may "
                    "overlap");
    for (size_t i = 0; i < p->index_count; i += 3)
        if (!add_triangle(f, p->triangles[i], p->triangles[i + 1], p->triangles[i + 2]))
            return false;
    return true;
}

static bool add_face(face_reader *f)
{
    const ply_source *const s = f->rows.source;
    const size_t count = f->rows.list_length[INDICES];
    const size_t wedges = f->rows.list_length[WEDGES];
    uint32_t vertex;
    for (size_t i = 0; i < count; ++i)
        if (!vertex_of(f, f->rows.lists[INDICES][i], &vertex))
            return false;
    if (f->result->has_wedges && wedges != 0 && wedges != 2 * count)
        reader_warn(s->r, ply_place(s), "texcoord has not two numbers for each corner; 0 is used");
    if (count < 3) {
        reader_warn(s->r, ply_place(s), "a face with fewer than 3 corners is not drawn");
        return true;
    }
    return count == 3 ? add_triangle(f, 0, 1, 2) : add_polygon(f, count);
}

/* Room for a triangle of each element. The rest of the file bounds it: a text has at least two
 * bytes for each corner. */
static bool reserve(face_reader *f)
{
    const ply_source *const s = f->rows.source;
    const size_t left = (size_t)(s->at.end - s->at.at) / 2;
    const uint64_t count = f->rows.element->count;
    const size_t wanted = count > left / 3 ? left : (size_t)(3 * count);
    return reader_grow(s->r, &f->result->corners, &f->result->corner_room, wanted,
                       sizeof *f->result->corners);
}

bool ply_read_faces(ply_source *s, const ply_header *h, ply_mesh *mesh)
{
    face_reader f;
    bool good = begin(&f, s, h, face_names, mesh, &mesh->triangles) && require_indices(&f);
    if (good) {
        mesh->triangles.has_wedges = f.rows.has_list[WEDGES];
        mesh->triangles.has_colors = ply_rows_have(&f.rows, PLY_RED, 3, "colours");
        mesh->triangles.has_textures = f.rows.has_value[TEXTURE];
        good = reserve(&f);
    }
    for (uint64_t i = 0; i < s->element->count && good; ++i)
        good = ply_rows_next(&f.rows) && add_face(&f);
    end(&f);
    return good;
}

/* Adds the triangles of a strip: each corner makes one with the two before it. The winding
 * alternates; -1 begins anew, of whatever sign the type is. Triangles that name a vertex twice only
 * join strips. */
static bool add_strip(face_reader *f)
{
    const double *const list = f->rows.lists[INDICES];
    const size_t count = f->rows.list_length[INDICES];
    uint32_t first = 0, vertex;
    for (uint32_t i = 0; i < count; ++i) {
        if (list[i] == -1.0 || list[i] == (double)UINT32_MAX) {
            first = i + 1;
            continue;
        }
        if (!vertex_of(f, list[i], &vertex))
            return false;
        if (i - first < 2 || list[i] == list[i - 1] || list[i] == list[i - 2] ||
            list[i - 1] == list[i - 2])
            continue;
        const uint32_t odd = (i - first) & 1;
        if (!add_triangle(f, i - 2 + odd, i - 1 - odd, i))
            return false;
    }
    return true;
}

bool ply_read_strips(ply_source *s, const ply_header *h, ply_mesh *mesh)
{
    face_reader f;
    bool good = begin(&f, s, h, strip_names, mesh, &mesh->triangles) && require_indices(&f);
    for (uint64_t i = 0; i < s->element->count && good; ++i)
        good = ply_rows_next(&f.rows) && add_strip(&f);
    end(&f);
    return good;
}

static bool add_edge(face_reader *f)
{
    ply_primitives *const p = f->result;
    uint32_t ends[2];
    if (!vertex_of(f, f->rows.values[FIRST], ends) ||
        !vertex_of(f, f->rows.values[SECOND], ends + 1) || !add_primitive(f, 2))
        return false;
    memcpy(p->corners + p->corner_count, ends, sizeof ends);
    p->corner_count += 2;
    return true;
}

bool ply_read_edges(ply_source *s, const ply_header *h, ply_mesh *mesh)
{
    face_reader f;
    bool good = begin(&f, s, h, edge_names, mesh, &mesh->lines);
    if (good && !(f.rows.has_value[FIRST] && f.rows.has_value[SECOND]))
        good = reader_fail(s->r, "element edge has no properties vertex1 and vertex2");
    mesh->lines.has_colors = good && ply_rows_have(&f.rows, PLY_RED, 3, "colours");
    for (uint64_t i = 0; i < s->element->count && good; ++i)
        good = ply_rows_next(&f.rows) && add_edge(&f);
    end(&f);
    return good;
}

bool ply_add_points(model_reader *r, const ply_mesh *mesh, ply_primitives *points)
{
    uint64_t left_out = 0;
    if (!reader_grow(r, &points->corners, &points->corner_room, mesh->vertex_count,
                     sizeof *points->corners))
        return false;
    for (size_t v = 0; v < mesh->vertex_count; ++v) {
        const double *const p = mesh->positions + 3 * v;
        if (isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2]))
            points->corners[points->corner_count++] = (uint32_t)v;
        else
            ++left_out;
    }
    if (left_out > 0)
        reader_warn(r, NULL, "%llu %s not finite and not drawn", (unsigned long long)left_out,
                    left_out == 1 ? "point is" : "points are");
    return true;
}

void ply_primitives_free(model_reader *r, ply_primitives *p)
{
    reader_release(r, p->corners, p->corner_room, sizeof *p->corners);
    reader_release(r, p->wedges, p->wedge_room, sizeof *p->wedges);
    reader_release(r, p->colors, p->color_room, sizeof *p->colors);
    reader_release(r, p->textures, p->texture_room, sizeof *p->textures);
}
