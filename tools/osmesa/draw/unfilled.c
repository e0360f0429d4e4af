#include "unfilled.h"

#include <gl_registry.h>

#include "../vertices/polygons.h"

enum { FIRST_EDGE = 1, SECOND_EDGE = 2, THIRD_EDGE = 4, ALL_EDGES = 7 };

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

static bool edge_flag(const context *gl, const gn_mesh *mesh, uint32_t element)
{
    const edge_flags *const flags = &gl->edge_flags;
    const uint32_t vertex = mesh_element(mesh, element) + (uint32_t)mesh->base_vertex;

    return flags->vertex ? flags->vertex[vertex * flags->step] != 0.0f : gl->current.edge_flag;
}

bool hides_edges(const context *gl, const gn_mesh *mesh)
{
    const GLenum *const mode = gl->raster.polygon_mode;

    if (!gl->edge_flags.vertex || (mode[0] == GL_FILL && mode[1] == GL_FILL))
        return false;
    for (uint32_t i = 0; i < mesh->count; ++i)
        if (!edge_flag(gl, mesh, i))
            return true;
    return false;
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
