/* The functions of OpenGL's matrices (OpenGL 2.1 section 2.11.2). */
#include <gl_registry.h>
#include <string.h>

#include "gl_context.h"
#include "gl_errors.h"
#include "matrix_product.h"
#include "one_of.h"

void glMatrixMode(GLenum mode)
{
    static const GLenum modes[] = {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE, 0};
    context *const gl = enter(__func__);

    if (gl && is_one_of(gl, mode, modes, __func__))
        gl->transform.mode = mode;
}

static matrix_stack *stack_of_mode(context *gl)
{
    switch (gl->transform.mode) {
    case GL_MODELVIEW:
        return &gl->transform.modelview;
    case GL_PROJECTION:
        return &gl->transform.projection;
    default:
        return &gl->transform.texture[gl->active_texture];
    }
}

/* Returns the matrix that functions change, null if no function may. */
static GLfloat *enter_matrix(const char *function)
{
    context *const gl = enter(function);
    matrix_stack *const stack = gl ? stack_of_mode(gl) : NULL;

    return stack ? stack->m[stack->depth - 1] : NULL;
}

void glPushMatrix(void)
{
    context *const gl = enter(__func__);
    matrix_stack *const stack = gl ? stack_of_mode(gl) : NULL;

    if (!stack)
        return;
    if (stack->depth == stack->limit) {
        gl_error(gl, GL_STACK_OVERFLOW, __func__);
        return;
    }
    memcpy(stack->m[stack->depth], stack->m[stack->depth - 1], sizeof *stack->m);
    ++stack->depth;
}

void glPopMatrix(void)
{
    context *const gl = enter(__func__);
    matrix_stack *const stack = gl ? stack_of_mode(gl) : NULL;

    if (!stack)
        return;
    if (stack->depth == 1)
        gl_error(gl, GL_STACK_UNDERFLOW, __func__);
    else
        --stack->depth;
}

void glLoadIdentity(void)
{
    GLfloat *const m = enter_matrix(__func__);

    if (m)
        set_identity(m);
}

/* Loading and multiplying. Matrices of doubles are rounded first. */

static void to_floats(GLfloat to[16], const GLdouble from[16])
{
    for (int i = 0; i < 16; ++i)
        to[i] = (GLfloat)from[i];
}

static void transpose(GLfloat to[16], const GLfloat from[16])
{
    for (int i = 0; i < 16; ++i)
        to[i] = from[i % 4 * 4 + i / 4];
}

void glLoadMatrixf(const GLfloat *from)
{
    GLfloat *const m = enter_matrix(__func__);

    if (m && from)
        memcpy(m, from, 16 * sizeof *m);
}

void glMultMatrixf(const GLfloat *from)
{
    GLfloat *const m = enter_matrix(__func__);

    if (m && from)
        multiply_matrices(m, m, from);
}

void glLoadMatrixd(const GLdouble *from)
{
    GLfloat floats[16];

    if (!from)
        return;
    to_floats(floats, from);
    glLoadMatrixf(floats);
}

void glMultMatrixd(const GLdouble *from)
{
    GLfloat floats[16];

    if (!from)
        return;
    to_floats(floats, from);
    glMultMatrixf(floats);
}

void glLoadTransposeMatrixf(const GLfloat *from)
{
    GLfloat transposed[16];

    if (!from)
        return;
    transpose(transposed, from);
    glLoadMatrixf(transposed);
}

void glMultTransposeMatrixf(const GLfloat *from)
{
    GLfloat transposed[16];

    if (!from)
        return;
    transpose(transposed, from);
    glMultMatrixf(transposed);
}

void glLoadTransposeMatrixd(const GLdouble *from)
{
    GLfloat floats[16];

    if (!from)
        return;
    to_floats(floats, from);
    glLoadTransposeMatrixf(floats);
}

void glMultTransposeMatrixd(const GLdouble *from)
{
    GLfloat floats[16];

    if (!from)
        return;
    to_floats(floats, from);
    glMultTransposeMatrixf(floats);
}

void glRotatef(GLfloat degrees, GLfloat x, GLfloat y, GLfloat z)
{
    GLfloat *const m = enter_matrix(__func__);

    if (m && degrees != 0.0f)
        rotate_matrix(m, degrees, x, y, z);
}

void glRotated(GLdouble degrees, GLdouble x, GLdouble y, GLdouble z)
{
    glRotatef((GLfloat)degrees, (GLfloat)x, (GLfloat)y, (GLfloat)z);
}

void glTranslatef(GLfloat x, GLfloat y, GLfloat z)
{
    GLfloat *const m = enter_matrix(__func__);

    if (m)
        translate_matrix(m, x, y, z);
}

void glTranslated(GLdouble x, GLdouble y, GLdouble z)
{
    glTranslatef((GLfloat)x, (GLfloat)y, (GLfloat)z);
}

void glScalef(GLfloat x, GLfloat y, GLfloat z)
{
    GLfloat *const m = enter_matrix(__func__);

    if (m)
        scale_matrix(m, x, y, z);
}

void glScaled(GLdouble x, GLdouble y, GLdouble z)
{
    glScalef((GLfloat)x, (GLfloat)y, (GLfloat)z);
}

void glFrustum(GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble z_near,
               GLdouble z_far)
{
    GLfloat *const m = enter_matrix(__func__);

    if (!m)
        return;
    if (!(z_near > 0.0) || !(z_far > 0.0) || z_near == z_far || left == right || top == bottom)
        gl_error(current_context(), GL_INVALID_VALUE, __func__);
    else
        multiply_frustum(m, (GLfloat)left, (GLfloat)right, (GLfloat)bottom, (GLfloat)top,
                         (GLfloat)z_near, (GLfloat)z_far);
}

void glOrtho(GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble z_near,
             GLdouble z_far)
{
    GLfloat *const m = enter_matrix(__func__);

    if (!m)
        return;
    if (left == right || bottom == top || z_near == z_far)
        gl_error(current_context(), GL_INVALID_VALUE, __func__);
    else
        multiply_ortho(m, (GLfloat)left, (GLfloat)right, (GLfloat)bottom, (GLfloat)top,
                       (GLfloat)z_near, (GLfloat)z_far);
}
