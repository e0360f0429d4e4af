/* Sets clip planes, and derives those of a draw. */
#include "clip_planes.h"

#include <gl_registry.h>
#include <string.h>

#include "../context/gl_errors.h"

/* to = plane * the inverse of the matrix on top of a stack. The order of operations is the
 * reference's. */
static void transform_plane(matrix_stack *stack, const GLfloat plane[4], GLfloat to[4])
{
    const GLfloat *const m = stack->m[stack->depth - 1];
    matrix_kind *const kind = &stack->kind[stack->depth - 1];
    GLfloat inverse[16];

    analyse_matrix(kind, m);
    invert_matrix(kind, m, inverse);
    for (int i = 0; i < 4; ++i)
        to[i] = clip_distance(inverse + 4 * i, plane[0], plane[1], plane[2], plane[3]);
}

uint32_t derive_clip_planes(context *gl, GLfloat plane[CLIP_PLANES][4])
{
    transform_state *const t = &gl->transform;
    uint32_t count = 0;

    for (int i = 0; i < CLIP_PLANES; ++i)
        if (t->clip_plane_enabled[i])
            transform_plane(&t->projection, t->clip_plane[i], plane[count++]);
    return count;
}

static GLfloat *find_plane(context *gl, GLenum name, const char *function)
{
    if (name >= GL_CLIP_PLANE0 && name < GL_CLIP_PLANE0 + CLIP_PLANES)
        return gl->transform.clip_plane[name - GL_CLIP_PLANE0];
    gl_error(gl, GL_INVALID_ENUM, function);
    return NULL;
}

void glClipPlane(GLenum name, const GLdouble *equation)
{
    context *const gl = enter(__func__);
    GLfloat *const plane = gl ? find_plane(gl, name, __func__) : NULL;
    GLfloat given[4];

    if (!plane)
        return;
    for (int i = 0; i < 4; ++i)
        given[i] = (GLfloat)equation[i];
    transform_plane(&gl->transform.modelview, given, plane);
}

void glGetClipPlane(GLenum name, GLdouble *equation)
{
    context *const gl = enter(__func__);
    const GLfloat *const plane = gl ? find_plane(gl, name, __func__) : NULL;

    for (int i = 0; i < 4 && plane; ++i)
        equation[i] = (GLdouble)plane[i];
}
