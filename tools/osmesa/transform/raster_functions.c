/* The functions that set the state of rasterization, the viewport and hints. */
#include <gl_registry.h>
#include <string.h>

#include "../context/gl_context.h"
#include "../context/gl_errors.h"
#include "../context/one_of.h"

/* Viewports and windows have at most this many pixels a side. */
enum { MAX_VIEWPORT = 16384, LEAST_ORIGIN = -32768, GREATEST_ORIGIN = 32767 };

static GLint clamped(GLint value, GLint low, GLint high)
{
    return value < low ? low : value > high ? high : value;
}

void glViewport(GLint x, GLint y, GLsizei width, GLsizei height)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    if (width < 0 || height < 0) {
        gl_error(gl, GL_INVALID_VALUE, __func__);
        return;
    }
    gl->transform.viewport[0] = clamped(x, LEAST_ORIGIN, GREATEST_ORIGIN);
    gl->transform.viewport[1] = clamped(y, LEAST_ORIGIN, GREATEST_ORIGIN);
    gl->transform.viewport[2] = clamped(width, 0, MAX_VIEWPORT);
    gl->transform.viewport[3] = clamped(height, 0, MAX_VIEWPORT);
}

static GLfloat fraction(GLdouble value)
{
    return !(value > 0.0) ? 0.0f : value > 1.0 ? 1.0f : (GLfloat)value;
}

void glDepthRange(GLdouble z_near, GLdouble z_far)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    gl->transform.depth_range[0] = fraction(z_near);
    gl->transform.depth_range[1] = fraction(z_far);
}

void glDepthRangef(GLfloat z_near, GLfloat z_far)
{
    glDepthRange((GLdouble)z_near, (GLdouble)z_far);
}

void glScissor(GLint x, GLint y, GLsizei width, GLsizei height)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    if (width < 0 || height < 0) {
        gl_error(gl, GL_INVALID_VALUE, __func__);
        return;
    }
    gl->fragment.scissor_box[0] = x;
    gl->fragment.scissor_box[1] = y;
    gl->fragment.scissor_box[2] = width;
    gl->fragment.scissor_box[3] = height;
}

void glCullFace(GLenum face)
{
    context *const gl = enter(__func__);

    if (gl && is_face(gl, face, __func__))
        gl->raster.cull_face = face;
}

void glFrontFace(GLenum winding)
{
    static const GLenum windings[] = {GL_CW, GL_CCW, 0};
    context *const gl = enter(__func__);

    if (gl && is_one_of(gl, winding, windings, __func__))
        gl->raster.front_face = winding;
}

void glPolygonMode(GLenum face, GLenum mode)
{
    static const GLenum modes[] = {GL_POINT, GL_LINE, GL_FILL, 0};
    context *const gl = enter(__func__);

    if (!gl || !is_one_of(gl, mode, modes, __func__) || !is_face(gl, face, __func__))
        return;
    if (face != GL_BACK)
        gl->raster.polygon_mode[0] = mode;
    if (face != GL_FRONT)
        gl->raster.polygon_mode[1] = mode;
}

void glPolygonOffset(GLfloat factor, GLfloat units)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    gl->raster.offset_factor = factor;
    gl->raster.offset_units = units;
}

void glPointSize(GLfloat size)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    if (!(size > 0.0f)) {
        gl_error(gl, GL_INVALID_VALUE, __func__);
        return;
    }
    gl->raster.point_size = size;
}

static void set_point_parameter(GLenum name, const GLfloat *value, const char *function)
{
    context *const gl = enter(function);
    raster_state *const r = gl ? &gl->raster : NULL;
    GLfloat *const to = !gl                                    ? NULL
                        : name == GL_POINT_SIZE_MIN            ? &r->point_size_min
                        : name == GL_POINT_SIZE_MAX            ? &r->point_size_max
                        : name == GL_POINT_FADE_THRESHOLD_SIZE ? &r->point_fade_threshold
                                                               : NULL;

    if (!gl)
        return;
    if (name == GL_POINT_DISTANCE_ATTENUATION)
        memcpy(r->point_attenuation, value, sizeof r->point_attenuation);
    else if (!to)
        gl_error(gl, GL_INVALID_ENUM, function);
    else if (*value < 0.0f)
        gl_error(gl, GL_INVALID_VALUE, function);
    else
        *to = *value;
}

void glPointParameterf(GLenum name, GLfloat value)
{
    const GLfloat values[3] = {value, 0.0f, 0.0f};

    set_point_parameter(name, values, __func__);
}

void glPointParameterfv(GLenum name, const GLfloat *value)
{
    set_point_parameter(name, value, __func__);
}

void glPointParameteri(GLenum name, GLint value)
{
    glPointParameterf(name, (GLfloat)value);
}

void glPointParameteriv(GLenum name, const GLint *value)
{
    const bool has_three = name == GL_POINT_DISTANCE_ATTENUATION;
    const GLfloat values[3] = {(GLfloat)value[0], has_three ? (GLfloat)value[1] : 0.0f,
                               has_three ? (GLfloat)value[2] : 0.0f};

    set_point_parameter(name, values, __func__);
}

void glLineWidth(GLfloat width)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    if (!(width > 0.0f)) {
        gl_error(gl, GL_INVALID_VALUE, __func__);
        return;
    }
    gl->raster.line_width = width;
}

void glLineStipple(GLint factor, GLushort pattern)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    gl->raster.stipple_factor = clamped(factor, 1, 256);
    gl->raster.stipple_pattern = pattern;
}

void glShadeModel(GLenum model)
{
    static const GLenum models[] = {GL_FLAT, GL_SMOOTH, 0};
    context *const gl = enter(__func__);

    if (gl && is_one_of(gl, model, models, __func__))
        gl->lighting.shade_model = model;
}

void glHint(GLenum target, GLenum mode)
{
    static const GLenum modes[] = {GL_DONT_CARE, GL_FASTEST, GL_NICEST, 0};
    context *const gl = enter(__func__);

    if (!gl || !is_one_of(gl, mode, modes, __func__))
        return;
    switch (target) {
    case GL_PERSPECTIVE_CORRECTION_HINT:
        gl->hint.perspective = mode;
        break;
    case GL_POINT_SMOOTH_HINT:
        gl->hint.point = mode;
        break;
    case GL_LINE_SMOOTH_HINT:
        gl->hint.line = mode;
        break;
    case GL_POLYGON_SMOOTH_HINT:
        gl->hint.polygon = mode;
        break;
    case GL_FOG_HINT:
        gl->hint.fog = mode;
        break;
    case GL_GENERATE_MIPMAP_HINT:
        gl->hint.mipmap = mode;
        break;
    case GL_TEXTURE_COMPRESSION_HINT:
        gl->hint.compression = mode;
        break;
    default:
        gl_error(gl, GL_INVALID_ENUM, __func__);
    }
}
