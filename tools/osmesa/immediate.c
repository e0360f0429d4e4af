#include "immediate.h"

#include <gl_registry.h>
#include <stdlib.h>
#include <string.h>

#include "draw_mesh.h"
#include "gl_errors.h"

enum { FIRST_CAPACITY = 64 };

static bool grow(context *gl)
{
    immediate_state *const im = &gl->immediate;
    const uint32_t capacity = im->capacity ? 2 * im->capacity : FIRST_CAPACITY;
    void *const memory =
        capacity < im->capacity ? NULL : realloc(im->vertex, (size_t)capacity * sizeof *im->vertex);

    if (!memory) {
        gl_error(gl, GL_OUT_OF_MEMORY, "glVertex");
        return false;
    }
    im->vertex = memory;
    im->capacity = capacity;
    return true;
}

void add_vertex(GLfloat x, GLfloat y, GLfloat z, GLfloat w)
{
    context *const gl = current_context();
    immediate_state *const im = gl ? &gl->immediate : NULL;

    if (!im || !im->is_inside || (im->count == im->capacity && !grow(gl)))
        return;
    GLfloat(*const vertex)[4] = im->vertex[im->count++];
    memcpy(vertex, gl->current.attribute, sizeof gl->current.attribute);
    vertex[POSITION][0] = x;
    vertex[POSITION][1] = y;
    vertex[POSITION][2] = z;
    vertex[POSITION][3] = w;
}

void glBegin(GLenum mode)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    if (mode > GL_POLYGON) {
        gl_error(gl, GL_INVALID_ENUM, __func__);
        return;
    }
    gl->immediate.is_inside = true;
    gl->immediate.mode = mode;
    gl->immediate.count = 0;
    gl->immediate.touched = 0;
}

void glEnd(void)
{
    context *const gl = current_context();
    immediate_state *const im = gl ? &gl->immediate : NULL;
    gn_mesh mesh;

    if (!gl)
        return;
    if (!im->is_inside) {
        gl_error(gl, GL_INVALID_OPERATION, __func__);
        return;
    }
    im->is_inside = false;
    if (im->count == 0)
        return;
    memset(&mesh, 0, sizeof mesh);
    for (int a = 0; a < ATTRIBUTES; ++a) {
        if (a == POSITION || (im->touched >> a & 1u)) {
            mesh.attribute[a].data = im->vertex[0][a];
            mesh.attribute[a].components = 4;
            mesh.attribute[a].stride = sizeof *im->vertex;
        }
    }
    mesh.vertex_count = mesh.count = im->count;
    draw_mesh(gl, im->mode, &mesh, __func__);
}
