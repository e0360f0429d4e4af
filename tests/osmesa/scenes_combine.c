/* Scenes with GL_COMBINE in up to four units. */
#include "scene_parts.h"

enum { ARGUMENTS = 3, UNITS = 4 };

/* Where an argument may be inverted: elsewhere the reference combines 1 - x with constants and
 * repeated arguments in ways that are not all known, which shows in last bits. For the same reason
 * no argument is given twice, and only the first unit, whose arguments are no sums or products, has
 * more than one operation. */
static bool can_invert(GLenum mode)
{
    return mode == GL_REPLACE || mode == GL_MODULATE || mode == GL_ADD || mode == GL_ADD_SIGNED;
}

static GLenum choose_mode(random_source *r, bool is_alpha, GLenum unit)
{
    if (unit > 0)
        return PICK(r, GL_REPLACE, GL_MODULATE);
    if (is_alpha)
        return PICK(r, GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT,
                    GL_MODULATE_ADD_ATI);
    return PICK(r, GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT,
                GL_DOT3_RGB, GL_DOT3_RGBA, GL_DOT3_RGB_EXT, GL_DOT3_RGBA_EXT,
                GL_MODULATE_SIGNED_ADD_ATI, GL_MODULATE_SUBTRACT_ATI);
}

/* Sets what red, green and blue, or alpha, are made of. GL_PRIMARY_COLOR is what the first unit has
 * before it, so that this unit has one of the two; the texture of another unit is read if there is
 * one. */
static void set_half(const library *gl, random_source *r, bool is_alpha, GLenum unit,
                     uint32_t units)
{
    const GLenum mode = choose_mode(r, is_alpha, unit);
    const GLenum other = GL_TEXTURE0 + (unit + 1) % units;
    const GLenum sources[] = {GL_TEXTURE, GL_CONSTANT, GL_PREVIOUS,
                              unit > 0 ? GL_PRIMARY_COLOR : other, other};
    const uint32_t count = units == 1 ? 3 : unit > 0 ? 5 : 4;
    const uint32_t first = random_below(r, count);

    gl->TexEnvi(GL_TEXTURE_ENV, is_alpha ? GL_COMBINE_ALPHA : GL_COMBINE_RGB, (GLint)mode);
    gl->TexEnvf(GL_TEXTURE_ENV, is_alpha ? GL_ALPHA_SCALE : GL_RGB_SCALE,
                (GLfloat)(1 << (one_in(r, 2) ? 0 : random_below(r, 3))));
    for (GLenum i = 0; i < ARGUMENTS; ++i) {
        const GLenum source = sources[(first + i) % count];
        const bool is_inverted = i == 0 && unit == 0 && can_invert(mode) && one_in(r, 2);
        const GLenum operand = is_alpha || (mode != GL_INTERPOLATE && one_in(r, 3))
                                   ? is_inverted ? GL_ONE_MINUS_SRC_ALPHA : GL_SRC_ALPHA
                               : is_inverted ? GL_ONE_MINUS_SRC_COLOR
                                             : GL_SRC_COLOR;

        gl->TexEnvi(GL_TEXTURE_ENV, (is_alpha ? GL_SOURCE0_ALPHA : GL_SOURCE0_RGB) + i,
                    (GLint)source);
        gl->TexEnvi(GL_TEXTURE_ENV, (is_alpha ? GL_OPERAND0_ALPHA : GL_OPERAND0_RGB) + i,
                    (GLint)operand);
    }
}

/* The sum of two products, of GL_NV_texture_env_combine4. */
static void set_half_of_four(const library *gl, random_source *r, bool is_alpha, uint32_t units)
{
    const GLenum sources[] = {GL_TEXTURE, GL_CONSTANT, GL_PREVIOUS,
                              units > 1 ? GL_TEXTURE1 : GL_ZERO};
    const uint32_t first = random_below(r, 4);

    gl->TexEnvi(GL_TEXTURE_ENV, is_alpha ? GL_COMBINE_ALPHA : GL_COMBINE_RGB,
                (GLint)PICK(r, GL_ADD, GL_ADD_SIGNED));
    for (GLenum i = 0; i < 4; ++i) {
        gl->TexEnvi(GL_TEXTURE_ENV, (is_alpha ? GL_SOURCE0_ALPHA : GL_SOURCE0_RGB) + i,
                    (GLint)sources[(first + i) % 4]);
        gl->TexEnvi(GL_TEXTURE_ENV, (is_alpha ? GL_OPERAND0_ALPHA : GL_OPERAND0_RGB) + i,
                    is_alpha || one_in(r, 3) ? GL_SRC_ALPHA : GL_SRC_COLOR);
    }
}

void draw_combine(const library *gl, random_source *r, int width, int height)
{
    const GLenum units = 1 + random_below(r, UNITS);

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    for (GLenum unit = 0; unit < units; ++unit) {
        gl->ActiveTexture(GL_TEXTURE0 + unit);
        set_texture(gl, r);
        gl->MultiTexCoord4f(GL_TEXTURE0 + unit, between(r, -1.0f, 1.0f), between(r, -1.0f, 1.0f),
                            between(r, 0.0f, 1.0f), 1.0f);
        if (unit == 0 && one_in(r, 4)) {
            gl->TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE4_NV);
            set_half_of_four(gl, r, false, units);
            set_half_of_four(gl, r, true, units);
            continue;
        }
        gl->TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
        set_half(gl, r, false, unit, units);
        set_half(gl, r, true, unit, units);
    }
    set_later_states(gl, r);
    draw_textured_vertices(gl, r, false, false);
}
