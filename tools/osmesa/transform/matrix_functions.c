/* The functions of OpenGL's matrices (OpenGL 2.1 section 2.11.2). */
#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "../context/gl_context.h"
#include "../context/gl_errors.h"
#include "matrix_product.h"
#include "../context/one_of.h"

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

/* A matrix and what is known of it. */
typedef struct known_matrix {
    GLfloat *m; /* null if no function may change it */
    matrix_kind *kind;
} known_matrix;

/* Returns the matrix that functions change. */
static known_matrix enter_matrix(const char *function)
{
    context *const gl = enter(function);
    matrix_stack *const stack = gl ? stack_of_mode(gl) : NULL;

    if (!stack)
        return (known_matrix){NULL, NULL};
    return (known_matrix){stack->m[stack->depth - 1], &stack->kind[stack->depth - 1]};
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
    analyse_matrix(&stack->kind[stack->depth - 1], stack->m[stack->depth - 1]);
    memcpy(stack->m[stack->depth], stack->m[stack->depth - 1], sizeof *stack->m);
    stack->kind[stack->depth] = stack->kind[stack->depth - 1];
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
    const known_matrix to = enter_matrix(__func__);

    if (to.m) {
        set_identity(to.m);
        set_identity_kind(to.kind);
    }
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
    const known_matrix to = enter_matrix(__func__);

    if (to.m && from && memcmp(to.m, from, 16 * sizeof *from) != 0) {
        memcpy(to.m, from, 16 * sizeof *from);
        forget_parts(to.kind);
    }
}

void glMultMatrixf(const GLfloat *from)
{
    const known_matrix to = enter_matrix(__func__);

    GLfloat identity[16];

    set_identity(identity);
    if (to.m && from && memcmp(from, identity, sizeof identity) != 0) {
        multiply_matrices(to.m, to.m, from);
        add_part(to.kind, MATRIX_GENERAL);
    }
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
    const known_matrix to = enter_matrix(__func__);

    if (to.m && degrees != 0.0f && rotate_matrix(to.m, degrees, x, y, z))
        add_part(to.kind, MATRIX_ROTATION);
}

void glRotated(GLdouble degrees, GLdouble x, GLdouble y, GLdouble z)
{
    glRotatef((GLfloat)degrees, (GLfloat)x, (GLfloat)y, (GLfloat)z);
}

void glTranslatef(GLfloat x, GLfloat y, GLfloat z)
{
    const known_matrix to = enter_matrix(__func__);

    if (to.m) {
        translate_matrix(to.m, x, y, z);
        add_part(to.kind, MATRIX_TRANSLATION);
    }
}

void glTranslated(GLdouble x, GLdouble y, GLdouble z)
{
    glTranslatef((GLfloat)x, (GLfloat)y, (GLfloat)z);
}

void glScalef(GLfloat x, GLfloat y, GLfloat z)
{
    const known_matrix to = enter_matrix(__func__);

    if (to.m) {
        const bool is_uniform = fabsf(x - y) < 1e-8f && fabsf(x - z) < 1e-8f;

        scale_matrix(to.m, x, y, z);
        add_part(to.kind, is_uniform ? MATRIX_UNIFORM_SCALE : MATRIX_SCALE);
    }
}

void glScaled(GLdouble x, GLdouble y, GLdouble z)
{
    glScalef((GLfloat)x, (GLfloat)y, (GLfloat)z);
}

void glFrustum(GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble z_near,
               GLdouble z_far)
{
    const known_matrix to = enter_matrix(__func__);

    if (!to.m)
        return;
    if (!(z_near > 0.0) || !(z_far > 0.0) || z_near == z_far || left == right || top == bottom) {
        gl_error(current_context(), GL_INVALID_VALUE, __func__);
        return;
    }
    multiply_frustum(to.m, (GLfloat)left, (GLfloat)right, (GLfloat)bottom, (GLfloat)top,
                     (GLfloat)z_near, (GLfloat)z_far);
    add_part(to.kind, MATRIX_PERSPECTIVE);
}

void glOrtho(GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble z_near,
             GLdouble z_far)
{
    const known_matrix to = enter_matrix(__func__);

    if (!to.m)
        return;
    if (left == right || bottom == top || z_near == z_far) {
        gl_error(current_context(), GL_INVALID_VALUE, __func__);
        return;
    }
    multiply_ortho(to.m, (GLfloat)left, (GLfloat)right, (GLfloat)bottom, (GLfloat)top,
                   (GLfloat)z_near, (GLfloat)z_far);
    add_part(to.kind, MATRIX_SCALE | MATRIX_TRANSLATION);
}
