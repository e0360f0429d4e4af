/* The functions that set and return materials (OpenGL 2.1 section 2.14). */
#include <gl_registry.h>
#include <string.h>

#include "color_material.h"
#include "../context/gl_errors.h"
#include "../context/integers.h"
#include "../vertices/immediate.h"
#include "../context/one_of.h"

void glColorMaterial(GLenum face, GLenum mode)
{
    static const GLenum modes[] = {
        GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_AMBIENT_AND_DIFFUSE, 0};
    context *const gl = enter(__func__);

    if (!gl || !is_face(gl, face, __func__) || !is_one_of(gl, mode, modes, __func__))
        return;
    follow_current_color(gl);
    gl->lighting.color_material_face = face;
    gl->lighting.color_material_mode = mode;
    follow_current_color(gl);
}

/* Sets values of the sides of a face. Vertices that wait are drawn first if a value changes. */
static void set_values(context *gl, GLenum face, GLenum name, const GLfloat *values)
{
    const unsigned colors = material_colors(name);

    for (int side = 0; side < 2; ++side) {
        material_state *const material = &gl->lighting.material[side];
        GLfloat *const number = name == GL_SHININESS ? &material->shininess : material->indexes;
        const size_t size = (name == GL_SHININESS ? 1 : 3) * sizeof *number;

        if (!face_has_side(face, side))
            continue;
        if (!colors && memcmp(number, values, size) != 0) {
            draw_vertices_so_far(gl);
            memcpy(number, values, size);
        }
        for (int c = 0; c < MATERIAL_COLORS; ++c) {
            const bool follows = gl->lighting.color_material &&
                                 follows_color(&gl->lighting, side, (enum material_color)c);

            if ((colors >> c & 1u) && !follows &&
                memcmp(material->color[c], values, sizeof material->color[c]) != 0) {
                draw_vertices_so_far(gl);
                memcpy(material->color[c], values, sizeof material->color[c]);
            }
        }
    }
}

static void set_material(const char *function, GLenum face, GLenum name, const GLfloat *values)
{
    context *const gl = current_context();

    if (!gl || !is_face(gl, face, function))
        return;
    if (name == GL_SHININESS && (values[0] < 0.0f || values[0] > 128.0f))
        gl_error(gl, GL_INVALID_VALUE, function);
    else if (name == GL_SHININESS || name == GL_COLOR_INDEXES || material_colors(name))
        set_values(gl, face, name, values);
    else
        gl_error(gl, GL_INVALID_ENUM, function);
}

void glMaterialfv(GLenum face, GLenum name, const GLfloat *values)
{
    set_material(__func__, face, name, values);
}

void glMaterialf(GLenum face, GLenum name, GLfloat value)
{
    const GLfloat values[4] = {value, 0.0f, 0.0f, 0.0f};

    set_material(__func__, face, name, values);
}

void glMaterialiv(GLenum face, GLenum name, const GLint *values)
{
    GLfloat floats[4] = {0.0f};

    for (int i = 0; i < 4 && material_colors(name); ++i)
        floats[i] = fraction_of_int(values[i]);
    if (name == GL_SHININESS)
        floats[0] = (GLfloat)values[0];
    for (int i = 0; i < 3 && name == GL_COLOR_INDEXES; ++i)
        floats[i] = (GLfloat)values[i];
    set_material(__func__, face, name, floats);
}

void glMateriali(GLenum face, GLenum name, GLint value)
{
    const GLfloat values[4] = {(GLfloat)value, 0.0f, 0.0f, 0.0f};

    set_material(__func__, face, name, values);
}

/* The values of a side by name. */
typedef struct material_value {
    const GLfloat *place; /* null, with an error: no such face or name */
    int count;
    bool is_color;
} material_value;

static material_value enter_material(const char *function, GLenum face, GLenum name)
{
    context *const gl = enter(function);
    const material_state *material;

    if (!gl)
        return (material_value){NULL, 0, false};
    follow_current_color(gl);
    material = &gl->lighting.material[face == GL_BACK];
    if (face == GL_FRONT || face == GL_BACK) {
        if (name == GL_SHININESS)
            return (material_value){&material->shininess, 1, false};
        if (name == GL_COLOR_INDEXES)
            return (material_value){material->indexes, 3, false};
        for (int c = 0; c < MATERIAL_COLORS; ++c)
            if (material_colors(name) == 1u << c)
                return (material_value){material->color[c], 4, true};
    }
    gl_error(gl, GL_INVALID_ENUM, function);
    return (material_value){NULL, 0, false};
}

void glGetMaterialfv(GLenum face, GLenum name, GLfloat *values)
{
    const material_value value = enter_material(__func__, face, name);

    if (value.place)
        memcpy(values, value.place, (size_t)value.count * sizeof *values);
}

void glGetMaterialiv(GLenum face, GLenum name, GLint *values)
{
    const material_value value = enter_material(__func__, face, name);

    for (int i = 0; i < value.count; ++i)
        values[i] = value.is_color ? truncated_integer(2147483647.0 * (GLdouble)value.place[i])
                                   : rounded_integer((GLdouble)value.place[i]);
}
