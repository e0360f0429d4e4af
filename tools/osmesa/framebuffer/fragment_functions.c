/* The functions that set the state of fragments and the framebuffer. */
#include <gl_registry.h>
#include <string.h>

#include "../context/gl_context.h"
#include "../context/gl_errors.h"
#include "../context/one_of.h"

static GLfloat fraction(GLfloat value)
{
    return !(value > 0.0f) ? 0.0f : value > 1.0f ? 1.0f : value;
}

void glAlphaFunc(GLenum function, GLfloat reference)
{
    context *const gl = enter(__func__);

    if (!gl || !is_comparison(gl, function, __func__))
        return;
    gl->fragment.alpha_function = function;
    gl->fragment.alpha_reference = reference;
}

void glDepthFunc(GLenum function)
{
    context *const gl = enter(__func__);

    if (gl && is_comparison(gl, function, __func__))
        gl->fragment.depth_function = function;
}

void glDepthMask(GLboolean mask)
{
    context *const gl = enter(__func__);

    if (gl)
        gl->fragment.depth_mask = mask != 0;
}

void glColorMask(GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha)
{
    const GLboolean mask[4] = {red != 0, green != 0, blue != 0, alpha != 0};
    context *const gl = enter(__func__);

    if (gl)
        memcpy(gl->fragment.color_mask, mask, sizeof mask);
}

void glIndexMask(GLuint mask)
{
    context *const gl = enter(__func__);

    if (gl)
        gl->fragment.index_mask = (GLint)mask;
}

/* Stencil */

static void set_stencil_function(const char *name, GLenum face, GLenum function, GLint reference,
                                 GLuint mask)
{
    context *const gl = enter(name);

    if (!gl || !is_face(gl, face, name) || !is_comparison(gl, function, name))
        return;
    for (int i = 0; i < 2; ++i) {
        if (face == (i == 0 ? GL_BACK : GL_FRONT))
            continue;
        gl->fragment.stencil[i].function = function;
        gl->fragment.stencil[i].reference = reference;
        gl->fragment.stencil[i].compare_mask = mask;
    }
}

void glStencilFunc(GLenum function, GLint reference, GLuint mask)
{
    set_stencil_function(__func__, GL_FRONT_AND_BACK, function, reference, mask);
}

void glStencilFuncSeparate(GLenum face, GLenum function, GLint reference, GLuint mask)
{
    set_stencil_function(__func__, face, function, reference, mask);
}

static void set_stencil_operations(const char *name, GLenum face, GLenum fail, GLenum depth_fail,
                                   GLenum pass)
{
    static const GLenum operations[] = {GL_KEEP,   GL_REPLACE,   GL_INCR,      GL_DECR,
                                        GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP, 0};
    const GLenum operation[3] = {fail, depth_fail, pass};
    context *const gl = enter(name);

    if (!gl)
        return;
    for (int i = 0; i < 3; ++i)
        if (operation[i] != GL_ZERO && !is_one_of(gl, operation[i], operations, name))
            return;
    if (!is_face(gl, face, name))
        return;
    for (int i = 0; i < 2; ++i) {
        if (face == (i == 0 ? GL_BACK : GL_FRONT))
            continue;
        gl->fragment.stencil[i].fail = fail;
        gl->fragment.stencil[i].depth_fail = depth_fail;
        gl->fragment.stencil[i].pass = pass;
    }
}

void glStencilOp(GLenum fail, GLenum depth_fail, GLenum pass)
{
    set_stencil_operations(__func__, GL_FRONT_AND_BACK, fail, depth_fail, pass);
}

void glStencilOpSeparate(GLenum face, GLenum fail, GLenum depth_fail, GLenum pass)
{
    set_stencil_operations(__func__, face, fail, depth_fail, pass);
}

static void set_stencil_mask(const char *name, GLenum face, GLuint mask)
{
    context *const gl = enter(name);

    if (!gl || !is_face(gl, face, name))
        return;
    if (face != GL_BACK)
        gl->fragment.stencil[0].write_mask = mask;
    if (face != GL_FRONT)
        gl->fragment.stencil[1].write_mask = mask;
}

void glStencilMask(GLuint mask)
{
    set_stencil_mask(__func__, GL_FRONT_AND_BACK, mask);
}

void glStencilMaskSeparate(GLenum face, GLuint mask)
{
    set_stencil_mask(__func__, face, mask);
}

/* Blending and logical operations */

static bool is_factor(context *gl, GLenum factor, const char *name)
{
    static const GLenum factors[] = {GL_ONE,
                                     GL_SRC_COLOR,
                                     GL_ONE_MINUS_SRC_COLOR,
                                     GL_SRC_ALPHA,
                                     GL_ONE_MINUS_SRC_ALPHA,
                                     GL_DST_ALPHA,
                                     GL_ONE_MINUS_DST_ALPHA,
                                     GL_DST_COLOR,
                                     GL_ONE_MINUS_DST_COLOR,
                                     GL_SRC_ALPHA_SATURATE,
                                     GL_CONSTANT_COLOR,
                                     GL_ONE_MINUS_CONSTANT_COLOR,
                                     GL_CONSTANT_ALPHA,
                                     GL_ONE_MINUS_CONSTANT_ALPHA,
                                     0};

    return factor == GL_ZERO || is_one_of(gl, factor, factors, name);
}

static void set_factors(const char *name, GLenum source, GLenum destination, GLenum alpha_source,
                        GLenum alpha_destination)
{
    context *const gl = enter(name);

    if (!gl || !is_factor(gl, source, name) || !is_factor(gl, destination, name) ||
        !is_factor(gl, alpha_source, name) || !is_factor(gl, alpha_destination, name))
        return;
    gl->fragment.blend_source = source;
    gl->fragment.blend_destination = destination;
    gl->fragment.blend_alpha_source = alpha_source;
    gl->fragment.blend_alpha_destination = alpha_destination;
}

void glBlendFunc(GLenum source, GLenum destination)
{
    set_factors(__func__, source, destination, source, destination);
}

void glBlendFuncSeparate(GLenum source, GLenum destination, GLenum alpha_source,
                         GLenum alpha_destination)
{
    set_factors(__func__, source, destination, alpha_source, alpha_destination);
}

static void set_equations(const char *name, GLenum equation, GLenum alpha_equation)
{
    static const GLenum equations[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT,
                                       GL_MIN,      GL_MAX,           0};
    context *const gl = enter(name);

    if (!gl || !is_one_of(gl, equation, equations, name) ||
        !is_one_of(gl, alpha_equation, equations, name))
        return;
    gl->fragment.blend_equation = equation;
    gl->fragment.blend_alpha_equation = alpha_equation;
}

void glBlendEquation(GLenum equation)
{
    set_equations(__func__, equation, equation);
}

void glBlendEquationSeparate(GLenum equation, GLenum alpha_equation)
{
    set_equations(__func__, equation, alpha_equation);
}

void glBlendColor(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha)
{
    const GLfloat color[4] = {red, green, blue, alpha};
    context *const gl = enter(__func__);

    if (gl)
        memcpy(gl->fragment.blend_color, color, sizeof color);
}

void glLogicOp(GLenum operation)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    if (operation < GL_CLEAR || operation > GL_SET)
        gl_error(gl, GL_INVALID_ENUM, __func__);
    else
        gl->fragment.logic_function = operation;
}

void glSampleCoverage(GLfloat value, GLboolean invert)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    gl->fragment.sample_coverage_value = fraction(value);
    gl->fragment.sample_coverage_invert = invert != 0;
}

/* Values of clears */

void glClearColor(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha)
{
    const GLfloat color[4] = {red, green, blue, alpha};
    context *const gl = enter(__func__);

    if (gl)
        memcpy(gl->fragment.clear_color, color, sizeof color);
}

void glClearDepth(GLdouble depth)
{
    context *const gl = enter(__func__);

    if (gl)
        gl->fragment.clear_depth = !(depth > 0.0) ? 0.0 : depth > 1.0 ? 1.0 : depth;
}

void glClearDepthf(GLfloat depth)
{
    glClearDepth((GLdouble)depth);
}

void glClearStencil(GLint stencil)
{
    context *const gl = enter(__func__);

    if (gl)
        gl->fragment.clear_stencil = stencil;
}

void glClearIndex(GLfloat index)
{
    context *const gl = enter(__func__);

    if (gl)
        gl->fragment.clear_index =
            index > -2147483648.0f && index < 4294967296.0f ? (GLint)(GLint64)index : 0;
}
