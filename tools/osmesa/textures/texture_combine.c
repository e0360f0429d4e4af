/* Sets and returns the parameters of GL_COMBINE. */
#include "texture_combine.h"

#include <gl_registry.h>
#include <string.h>

#include "../context/gl_errors.h"
#include "../context/one_of.h"

/* Where a parameter is kept. */
typedef struct combine_place {
    enum { NOT_COMBINE, COMBINE_MODE, COMBINE_SOURCE, COMBINE_OPERAND, COMBINE_SCALE } kind;
    int half, index;
} combine_place;

static combine_place find_place(GLenum name)
{
    /* Of each half the names of sources and operands follow one another. */
    static const struct {
        GLenum first;
        combine_place place;
    } rows[] = {{GL_SOURCE0_RGB, {COMBINE_SOURCE, COMBINE_COLOR, 0}},
                {GL_SOURCE0_ALPHA, {COMBINE_SOURCE, COMBINE_ALPHA, 0}},
                {GL_OPERAND0_RGB, {COMBINE_OPERAND, COMBINE_COLOR, 0}},
                {GL_OPERAND0_ALPHA, {COMBINE_OPERAND, COMBINE_ALPHA, 0}}};

    switch (name) {
    case GL_COMBINE_RGB:
        return (combine_place){COMBINE_MODE, COMBINE_COLOR, 0};
    case GL_COMBINE_ALPHA:
        return (combine_place){COMBINE_MODE, COMBINE_ALPHA, 0};
    case GL_RGB_SCALE:
        return (combine_place){COMBINE_SCALE, COMBINE_COLOR, 0};
    case GL_ALPHA_SCALE:
        return (combine_place){COMBINE_SCALE, COMBINE_ALPHA, 0};
    default:
        break;
    }
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i)
        if (name >= rows[i].first && name < rows[i].first + COMBINE_ARGUMENTS)
            return (combine_place){rows[i].place.kind, rows[i].place.half,
                                   (int)(name - rows[i].first)};
    return (combine_place){NOT_COMBINE, 0, 0};
}

bool is_combine_name(GLenum name)
{
    return find_place(name).kind != NOT_COMBINE;
}

static bool is_mode(context *gl, GLenum value, int half, const char *function)
{
    static const GLenum modes[] = {GL_REPLACE,
                                   GL_MODULATE,
                                   GL_ADD,
                                   GL_ADD_SIGNED,
                                   GL_INTERPOLATE,
                                   GL_SUBTRACT,
                                   GL_MODULATE_ADD_ATI,
                                   GL_MODULATE_SIGNED_ADD_ATI,
                                   GL_MODULATE_SUBTRACT_ATI,
                                   0};

    if (half == COMBINE_COLOR && (value == GL_DOT3_RGB || value == GL_DOT3_RGBA ||
                                  value == GL_DOT3_RGB_EXT || value == GL_DOT3_RGBA_EXT))
        return true;
    return is_one_of(gl, value, modes, function);
}

static bool is_source(context *gl, GLenum value, const char *function)
{
    static const GLenum sources[] = {
        GL_TEXTURE,  GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS, GL_ONE,
        GL_TEXTURE0, GL_TEXTURE1, GL_TEXTURE2,      GL_TEXTURE3, 0};

    return value == GL_ZERO || is_one_of(gl, value, sources, function);
}

static bool is_operand(context *gl, GLenum value, int half, const char *function)
{
    static const GLenum operands[] = {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_COLOR,
                                      GL_ONE_MINUS_SRC_COLOR, 0};
    static const GLenum alphas[] = {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, 0};

    return is_one_of(gl, value, half == COMBINE_ALPHA ? alphas : operands, function);
}

void set_combine(context *gl, GLenum name, GLenum value, GLfloat number, const char *function)
{
    const combine_place place = find_place(name);
    combine_state *const half = &gl->unit[gl->active_texture].combine[place.half];

    if (place.kind == COMBINE_MODE && is_mode(gl, value, place.half, function)) {
        half->mode = value;
    } else if (place.kind == COMBINE_SOURCE && is_source(gl, value, function)) {
        half->source[place.index] = value;
    } else if (place.kind == COMBINE_OPERAND && is_operand(gl, value, place.half, function)) {
        half->operand[place.index] = value;
    } else if (place.kind == COMBINE_SCALE) {
        if (number == 1.0f || number == 2.0f || number == 4.0f)
            half->scale = number;
        else
            gl_error(gl, GL_INVALID_VALUE, function);
    }
}

GLfloat read_combine(const context *gl, GLenum name)
{
    const combine_place place = find_place(name);
    const combine_state *const half = &gl->unit[gl->active_texture].combine[place.half];

    return place.kind == COMBINE_MODE      ? (GLfloat)half->mode
           : place.kind == COMBINE_SOURCE  ? (GLfloat)half->source[place.index]
           : place.kind == COMBINE_OPERAND ? (GLfloat)half->operand[place.index]
                                           : half->scale;
}
