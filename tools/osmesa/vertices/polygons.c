/* Divides quads, strips of quads and polygons into triangles. */
#include "polygons.h"

#include <gl_registry.h>

uint32_t mesh_element(const gn_mesh *mesh, uint32_t i)
{
    switch (mesh->index_format) {
    case GN_INDEX_UINT8:
        return ((const uint8_t *)mesh->indices)[i];
    case GN_INDEX_UINT16:
        return ((const uint16_t *)mesh->indices)[i];
    case GN_INDEX_UINT32:
        return ((const uint32_t *)mesh->indices)[i];
    default:
        return i;
    }
}

static uint32_t *put_triangle(uint32_t *to, const gn_mesh *mesh, uint32_t a, uint32_t b, uint32_t c)
{
    to[0] = mesh_element(mesh, a);
    to[1] = mesh_element(mesh, b);
    to[2] = mesh_element(mesh, c);
    return to + 3;
}

/* Puts the two triangles of a quad with corners a, b, c, d around it. The reference divides along
 * b-d where the last vertex matters, else along a-c. */
static uint32_t *put_quad(uint32_t *to, const gn_mesh *mesh, bool keeps_flat_vertex, uint32_t a,
                          uint32_t b, uint32_t c, uint32_t d)
{
    if (keeps_flat_vertex) {
        to = put_triangle(to, mesh, a, b, d);
        return put_triangle(to, mesh, b, c, d);
    }
    to = put_triangle(to, mesh, a, b, c);
    return put_triangle(to, mesh, a, c, d);
}

/* Puts the quad of a strip whose corners are i, i + 1, i + 3, i + 2, always divided between i and
 * i + 3. Where a vertex of the draw is clipped, the triangle beyond that line comes first. */
static uint32_t *put_strip_quad(uint32_t *to, const gn_mesh *mesh, bool is_clipped, uint32_t i)
{
    if (is_clipped) {
        to = put_triangle(to, mesh, i + 2, i, i + 3);
        return put_triangle(to, mesh, i, i + 1, i + 3);
    }
    to = put_triangle(to, mesh, i, i + 1, i + 3);
    return put_triangle(to, mesh, i + 2, i, i + 3);
}

uint32_t elements_of_polygons(GLenum mode, uint32_t count)
{
    if (mode == GL_POLYGON)
        return count < 3 ? 0 : count;
    return count < 4 ? 0 : mode == GL_QUADS ? count / 4 * 4 : count / 2 * 2;
}

bool divide_polygons(context *gl, GLenum mode, bool is_flat, bool is_clipped, gn_mesh *mesh,
                     const char *function)
{
    const uint32_t count = elements_of_polygons(mode, mesh->count);
    const size_t triangles = mode == GL_QUADS ? (size_t)count / 2 : (size_t)count - 2;
    uint32_t *const indices =
        3 * triangles > UINT32_MAX
            ? NULL
            : scratch_memory(gl, &gl->indices, 3 * triangles * sizeof *indices, function);
    uint32_t *to = indices;

    if (!indices)
        return false;
    if (mode == GL_POLYGON)
        for (uint32_t i = 2; i < count; ++i)
            to = put_triangle(to, mesh, i - 1, i, 0);
    else if (mode == GL_QUADS)
        for (uint32_t i = 0; i < count; i += 4)
            to = put_quad(to, mesh, is_flat || is_clipped, i, i + 1, i + 2, i + 3);
    else
        for (uint32_t i = 0; i + 2 < count; i += 2)
            to = put_strip_quad(to, mesh, is_clipped, i);
    if (mesh->index_format == GN_INDEX_NONE)
        mesh->base_vertex = 0;
    mesh->indices = indices;
    mesh->index_format = GN_INDEX_UINT32;
    mesh->count = (uint32_t)(3 * triangles);
    return true;
}
