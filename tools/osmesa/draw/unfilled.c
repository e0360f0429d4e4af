#include "unfilled.h"

#include <gl_registry.h>
#include <string.h>

#include "../context/gl_errors.h"
#include "../vertices/polygons.h"

enum { FIRST_EDGE = 1, SECOND_EDGE = 2, THIRD_EDGE = 4, ALL_EDGES = 7, EDGE_VARYINGS = 4 };

static bool is_culled(const context *gl, int side)
{
    return gl->raster.cull && gl->raster.cull_face != (side ? GL_FRONT : GL_BACK);
}

bool draws_unfilled(const context *gl, GLenum mode)
{
    for (int side = 0; mode >= GL_TRIANGLES && side < 2; ++side)
        if (!is_culled(gl, side) && gl->raster.polygon_mode[side] != GL_FILL)
            return true;
    return false;
}

bool draws_polygon_points(const context *gl)
{
    for (int side = 0; side < 2; ++side)
        if (!is_culled(gl, side) && gl->raster.polygon_mode[side] != GL_POINT)
            return false;
    return true;
}

static bool edge_flag(const context *gl, const gn_mesh *mesh, uint32_t element)
{
    const edge_flags *const flags = &gl->edge_flags;
    const uint32_t vertex = mesh_element(mesh, element) + (uint32_t)mesh->base_vertex;

    return flags->vertex ? flags->vertex[vertex * flags->step] != 0.0f : gl->current.edge_flag;
}

/* The triangles of a mode: corners as elements of the mesh, and which edges the mode has. */
typedef struct triangle_list {
    const context *gl;
    const gn_mesh *mesh;
    uint32_t *corner;
    unsigned char *mask;
} triangle_list;

static void put(triangle_list *list, uint32_t a, uint32_t b, uint32_t c, unsigned edges)
{
    const uint32_t corners[3] = {a, b, c};
    unsigned mask = 0;

    for (int k = 0; k < 3; ++k) {
        *list->corner++ = corners[k];
        if ((edges >> k & 1u) && edge_flag(list->gl, list->mesh, corners[k]))
            mask |= 1u << k;
    }
    *list->mask++ = (unsigned char)mask;
}

/* As in the reference, quads divide as where vertices are clipped, and flags apply to strips and
 * fans, too. */
void list_triangles(const context *gl, GLenum mode, const gn_mesh *mesh, uint32_t *corner,
                    unsigned char *mask)
{
    triangle_list triangles = {.gl = gl, .mesh = mesh, .corner = corner, .mask = mask};
    triangle_list *const list = &triangles;
    const uint32_t count = mesh->count;

    switch (mode) {
    case GL_TRIANGLES:
        for (uint32_t i = 0; i + 2 < count; i += 3)
            put(list, i, i + 1, i + 2, ALL_EDGES);
        break;
    case GL_TRIANGLE_STRIP:
        for (uint32_t i = 0; i + 2 < count; ++i)
            put(list, i % 2 ? i + 1 : i, i % 2 ? i : i + 1, i + 2, ALL_EDGES);
        break;
    case GL_TRIANGLE_FAN:
        for (uint32_t i = 1; i + 1 < count; ++i)
            put(list, 0, i, i + 1, ALL_EDGES);
        break;
    case GL_QUADS:
        for (uint32_t i = 0; i + 3 < count; i += 4) {
            put(list, i, i + 1, i + 3, FIRST_EDGE | THIRD_EDGE);
            put(list, i + 1, i + 2, i + 3, FIRST_EDGE | SECOND_EDGE);
        }
        break;
    case GL_QUAD_STRIP:
        for (uint32_t i = 0; i + 3 < count; i += 2) {
            put(list, i + 2, i, i + 3, FIRST_EDGE | THIRD_EDGE);
            put(list, i, i + 1, i + 3, FIRST_EDGE | SECOND_EDGE);
        }
        break;
    default:
        for (uint32_t i = 2; i < count; ++i)
            put(list, i - 1, i, 0,
                (unsigned)FIRST_EDGE | (i + 1 == count ? SECOND_EDGE : 0u) |
                    (i == 2 ? THIRD_EDGE : 0u));
    }
}

size_t triangles_of(GLenum mode, uint32_t count)
{
    if (mode == GL_TRIANGLES)
        return count / 3;
    if (mode == GL_QUADS)
        return (size_t)count / 4 * 2;
    if (mode == GL_QUAD_STRIP)
        return count < 4 ? 0 : (size_t)count / 2 * 2 - 2;
    return count < 3 ? 0 : (size_t)count - 2;
}

/* Copies the attributes of the corners. */
static void copy_corners(const gn_mesh *mesh, const uint32_t *corner, size_t corners,
                         GLfloat (*to)[4], gn_mesh *separate)
{
    for (int a = 0; a < ATTRIBUTES; ++a) {
        const gn_attribute *const from = &mesh->attribute[a];
        const size_t stride = from->stride ? from->stride : from->components * sizeof(GLfloat);

        if (!from->data)
            continue;
        separate->attribute[a] =
            (gn_attribute){.data = (const GLfloat *)to, .components = 4, .stride = sizeof *to};
        for (size_t i = 0; i < corners; ++i, ++to) {
            const uint32_t vertex = mesh_element(mesh, corner[i]) + (uint32_t)mesh->base_vertex;
            const GLfloat *const value =
                (const void *)((const char *)from->data + (size_t)vertex * stride);

            for (uint32_t c = 0; c < 4; ++c)
                (*to)[c] = c < from->components ? value[c] : c == 3 ? 1.0f : 0.0f;
        }
    }
}

bool separate_triangles(context *gl, GLenum mode, gn_mesh *mesh, fixed_function *fixed,
                        gn_program *program, const char *function)
{
    const size_t triangles = triangles_of(mode, mesh->count), corners = 3 * triangles;
    gn_mesh separate = {.vertex_count = (uint32_t)corners, .count = (uint32_t)corners};
    size_t attributes = 0;
    unsigned char *mask;
    uint32_t *first;
    GLfloat(*copies)[4];

    if (!triangles || corners > UINT32_MAX)
        return false;
    for (int a = 0; a < ATTRIBUTES; ++a)
        attributes += mesh->attribute[a].data != NULL;
    first = scratch_memory(gl, &gl->indices, corners * sizeof *first + triangles, function);
    copies = scratch_memory(gl, &gl->corners, corners * attributes * sizeof *copies, function);
    if (!first || !copies)
        return false;
    mask = (unsigned char *)(first + corners);
    fixed->edge_mask = mask;
    list_triangles(gl, mode, mesh, first, mask);
    copy_corners(mesh, first, corners, copies, &separate);
    *mesh = separate;
    for (int side = 0; side < 2; ++side)
        fixed->polygon_mode[side] = gl->raster.polygon_mode[side];
    fixed->edge_varying = -1;
    if (program->varying_count + EDGE_VARYINGS <= GN_MAX_VARYINGS) {
        fixed->edge_varying = (int)program->varying_count;
        program->interpolation[program->varying_count] = GN_FLAT;
        for (int i = 1; i < EDGE_VARYINGS; ++i)
            program->interpolation[program->varying_count + (uint32_t)i] = GN_SMOOTH;
        program->varying_count += EDGE_VARYINGS;
        program->fragment_discards = true;
    }
    return true;
}
