/* Reads PLY files: meshes, lines and clouds of points with their colours and one texture a face. */
#include "ply.h"

#include <string.h>

/* Values of vertices behind the colours. */
enum {
    X = PLY_COLOR_COUNT,
    Y,
    Z,
    NORMAL_X,
    NORMAL_Y,
    NORMAL_Z,
    S,
    T,
    SPLAT_RED,
    SPLAT_GREEN,
    SPLAT_BLUE
};

static const ply_name vertex_names[] = {{"x", X, false},
                                        {"y", Y, false},
                                        {"z", Z, false},
                                        {"nx", NORMAL_X, false},
                                        {"ny", NORMAL_Y, false},
                                        {"nz", NORMAL_Z, false},
                                        {"u", S, false},
                                        {"v", T, false},
                                        {"s", S, false},
                                        {"t", T, false},
                                        {"texture_u", S, false},
                                        {"texture_v", T, false},
                                        {"texture_s", S, false},
                                        {"texture_t", T, false},
                                        {"f_dc_0", SPLAT_RED, false},
                                        {"f_dc_1", SPLAT_GREEN, false},
                                        {"f_dc_2", SPLAT_BLUE, false},
                                        PLY_COLOR_NAMES,
                                        {NULL, 0, false}};

/* Whether the vertices are Gaussian splats, as Kerbl et al., "3D Gaussian Splatting for Real-Time
 * Radiance Field Rendering", 2023, write them. */
static bool are_splats(const ply_header *h, const ply_element *e)
{
    const ply_property *const p = h->properties + e->first_property;
    int found = 0;
    for (size_t i = 0; i < e->property_count; ++i)
        found += text_is(p[i].name, "f_dc_0") + text_is(p[i].name, "f_dc_1") +
                 text_is(p[i].name, "f_dc_2") + text_is(p[i].name, "scale_0");
    return found == 4;
}

/* Finds what vertices have, and allocates it. */
static bool prepare_vertices(ply_rows *rows, bool is_splat, ply_mesh *mesh)
{
    model_reader *const r = rows->source->r;
    static const char names[3][2] = {"x", "y", "z"};
    const size_t count = (size_t)rows->element->count;
    for (int c = 0; c < 3; ++c)
        if (!rows->has_value[X + c])
            return reader_fail(r, "element vertex has no property %s", names[c]);
    const bool has_normals = ply_rows_have(rows, NORMAL_X, 3, "normals");
    const bool has_texcoords = ply_rows_have(rows, S, 2, "texture coordinates");
    const bool has_colors = ply_rows_have(rows, PLY_RED, 3, "colours");
    if (count > 0 && count < UINT32_MAX)
        mesh->positions = reader_allocate(r, count, 3 * sizeof(double));
    else
        reader_fail(r, count == 0 ? "it has no vertices" : "it has too many vertices");
    bool good = mesh->positions != NULL;
    if (good && has_normals)
        good = (mesh->normals = reader_allocate(r, count, 3 * sizeof(float))) != NULL;
    if (good && has_texcoords)
        good = (mesh->texcoords = reader_allocate(r, count, 2 * sizeof(float))) != NULL;
    if (good && (has_colors || is_splat))
        good = (mesh->colors = reader_allocate(r, count, 4 * sizeof(float))) != NULL;
    mesh->vertex_count = good ? count : 0;
    return good;
}

/* The colour of a splat as it looks on average: of its spherical harmonics only the constant one,
 * whose value is 1 / (2 sqrt(pi)). */
static void splat_color(const ply_rows *rows, float color[4])
{
    for (int c = 0; c < 3; ++c) {
        const double value = 0.5 + 0.28209479177387814 * rows->values[SPLAT_RED + c];
        color[c] = (float)(value < 0.0 ? 0.0 : value > 1.0 ? 1.0 : value);
    }
    color[3] = 1.0f;
}

static void store_vertex(const ply_rows *rows, bool is_splat, ply_mesh *mesh, size_t v)
{
    memcpy(mesh->positions + 3 * v, rows->values + X, 3 * sizeof(double));
    for (size_t c = 0; c < 3 && mesh->normals != NULL; ++c)
        mesh->normals[3 * v + c] = (float)rows->values[NORMAL_X + c];
    for (size_t c = 0; c < 2 && mesh->texcoords != NULL; ++c)
        mesh->texcoords[2 * v + c] = (float)rows->values[S + c];
    if (mesh->colors != NULL && is_splat)
        splat_color(rows, mesh->colors + 4 * v);
    else if (mesh->colors != NULL)
        ply_rows_color(rows, mesh->colors + 4 * v);
}

static bool read_vertices(ply_source *s, const ply_header *h, ply_mesh *mesh)
{
    ply_rows rows;
    const bool is_splat = are_splats(h, s->element);
    if (is_splat)
        reader_warn(s->r, NULL, "Gaussian splats are drawn as points of one colour");
    /* Finds where a file ends that is too short, without memory for what it announces. */
    if (ply_room(s, h) < s->element->count)
        return ply_skip(s, h);
    bool good = ply_rows_begin(&rows, s, h, vertex_names, is_splat) &&
                prepare_vertices(&rows, is_splat, mesh);
    for (size_t v = 0; v < mesh->vertex_count && good; ++v) {
        good = ply_rows_next(&rows);
        if (good)
            store_vertex(&rows, is_splat, mesh, v);
    }
    ply_rows_free(&rows);
    return good;
}

typedef enum element_kind { VERTEX, FACE, STRIPS, EDGE, KIND_COUNT } element_kind;

/* The elements that are drawn, and where they begin. */
typedef struct body_reader {
    ply_header header;
    ply_mesh mesh;
    ply_source source;
    const ply_element *elements[KIND_COUNT]; /* null: the file has none */
    ply_source starts[KIND_COUNT];
    bool is_read[KIND_COUNT], is_passed[KIND_COUNT];
} body_reader;

static const char *const element_names[KIND_COUNT] = {"vertex", "face", "tristrips", "edge"};

static void find_elements(body_reader *b)
{
    for (size_t i = b->header.element_count; i-- > 0;)
        for (int k = 0; k < KIND_COUNT; ++k)
            if (text_is(b->header.elements[i].name, element_names[k]))
                b->elements[k] = b->header.elements + i;
}

static bool read_element(body_reader *b, element_kind kind, ply_source *s)
{
    b->is_read[kind] = true;
    if (kind != VERTEX && s->element->count == 0)
        return true;
    switch (kind) {
    case VERTEX:
        return read_vertices(s, &b->header, &b->mesh);
    case FACE:
        return ply_read_faces(s, &b->header, &b->mesh);
    case STRIPS:
        return ply_read_strips(s, &b->header, &b->mesh);
    default:
        return ply_read_edges(s, &b->header, &b->mesh);
    }
}

/* Whether what the elements of a kind need has been read. */
static bool is_ready(const body_reader *b, element_kind kind)
{
    if (kind == VERTEX)
        return true;
    return b->is_read[VERTEX] && (kind != STRIPS || b->elements[FACE] == NULL || b->is_read[FACE]);
}

/* Reads an element in its place, or passes it: one that is not drawn, or is read later. */
static bool read_in_place(body_reader *b, const ply_element *e)
{
    ply_source *const s = &b->source;
    char name[64];
    s->element = e;
    s->number = 0;
    for (int k = 0; k < KIND_COUNT; ++k) {
        if (b->elements[k] != e)
            continue;
        if (is_ready(b, (element_kind)k))
            return read_element(b, (element_kind)k, s);
        b->starts[k] = *s;
        b->is_passed[k] = true;
        return ply_skip(s, &b->header);
    }
    reader_warn(s->r, NULL, "element %s is not drawn", text_copy(e->name, name, sizeof name));
    return ply_skip(s, &b->header);
}

static bool read_body(body_reader *b)
{
    for (size_t i = 0; i < b->header.element_count; ++i)
        if (!read_in_place(b, b->header.elements + i))
            return false;
    for (int k = FACE; k < KIND_COUNT; ++k)
        if (b->is_passed[k] && !read_element(b, (element_kind)k, b->starts + k))
            return false;
    return true;
}

/* Whether there is something behind the last element. A text may end in blank lines. */
static void warn_of_rest(body_reader *b)
{
    ply_source *const s = &b->source;
    if (s->encoding == PLY_ASCII && !text_next_line(&s->at))
        return;
    const size_t rest = (size_t)(s->at.end - s->at.at);
    if (rest > 0)
        reader_warn(s->r, s->encoding == PLY_ASCII ? reader_line(s->r, s->at.line) : NULL,
                    "%zu bytes behind the last element are left out", rest);
}

static bool has_any(const ply_element *e)
{
    return e != NULL && e->count > 0;
}

static bool read_all(model_reader *r, body_reader *b)
{
    if (!ply_header_read(r, &b->header))
        return false;
    b->source.r = r;
    b->source.encoding = b->header.encoding;
    b->source.at = b->header.body;
    find_elements(b);
    if (b->elements[VERTEX] == NULL)
        return reader_fail(r, "its header has no element vertex");
    if (!read_body(b))
        return false;
    warn_of_rest(b);
    const bool has_points =
        !has_any(b->elements[FACE]) && !has_any(b->elements[STRIPS]) && !has_any(b->elements[EDGE]);
    return ply_make_parts(r, &b->header, &b->mesh, has_points);
}

bool read_ply(model_reader *r)
{
    body_reader b;
    memset(&b, 0, sizeof b);
    const bool good = read_all(r, &b);
    ply_mesh *const mesh = &b.mesh;
    const size_t count = b.elements[VERTEX] != NULL ? (size_t)b.elements[VERTEX]->count : 0;
    reader_release(r, mesh->positions, count, 3 * sizeof(double));
    reader_release(r, mesh->normals, count, 3 * sizeof(float));
    reader_release(r, mesh->texcoords, count, 2 * sizeof(float));
    reader_release(r, mesh->colors, count, 4 * sizeof(float));
    ply_primitives_free(r, &mesh->triangles);
    ply_primitives_free(r, &mesh->lines);
    ply_header_free(r, &b.header);
    return good;
}
