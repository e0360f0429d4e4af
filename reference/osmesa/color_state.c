/* OpenGL's state for writing colours to the framebuffer: blending, logical operations, masks. */
#include "gl.h"

static GLenum factor(gn_blend_factor f, GLenum otherwise)
{
    switch (f) {
    case GN_FACTOR_ZERO:
        return GL_ZERO;
    case GN_FACTOR_ONE:
        return GL_ONE;
    case GN_FACTOR_SOURCE_COLOR:
        return GL_SRC_COLOR;
    case GN_FACTOR_ONE_MINUS_SOURCE_COLOR:
        return GL_ONE_MINUS_SRC_COLOR;
    case GN_FACTOR_DESTINATION_COLOR:
        return GL_DST_COLOR;
    case GN_FACTOR_ONE_MINUS_DESTINATION_COLOR:
        return GL_ONE_MINUS_DST_COLOR;
    case GN_FACTOR_SOURCE_ALPHA:
        return GL_SRC_ALPHA;
    case GN_FACTOR_ONE_MINUS_SOURCE_ALPHA:
        return GL_ONE_MINUS_SRC_ALPHA;
    case GN_FACTOR_DESTINATION_ALPHA:
        return GL_DST_ALPHA;
    case GN_FACTOR_ONE_MINUS_DESTINATION_ALPHA:
        return GL_ONE_MINUS_DST_ALPHA;
    case GN_FACTOR_CONSTANT_COLOR:
        return GL_CONSTANT_COLOR;
    case GN_FACTOR_ONE_MINUS_CONSTANT_COLOR:
        return GL_ONE_MINUS_CONSTANT_COLOR;
    case GN_FACTOR_CONSTANT_ALPHA:
        return GL_CONSTANT_ALPHA;
    case GN_FACTOR_ONE_MINUS_CONSTANT_ALPHA:
        return GL_ONE_MINUS_CONSTANT_ALPHA;
    case GN_FACTOR_SOURCE_ALPHA_SATURATE:
        return GL_SRC_ALPHA_SATURATE;
    case GN_FACTOR_DEFAULT:
        break;
    }
    return otherwise;
}

static GLenum equation(gn_blend_equation e, GLenum otherwise)
{
    switch (e) {
    case GN_EQUATION_ADD:
        return GL_FUNC_ADD;
    case GN_EQUATION_SUBTRACT:
        return GL_FUNC_SUBTRACT;
    case GN_EQUATION_REVERSE_SUBTRACT:
        return GL_FUNC_REVERSE_SUBTRACT;
    case GN_EQUATION_MIN:
        return GL_MIN;
    case GN_EQUATION_MAX:
        return GL_MAX;
    case GN_EQUATION_DEFAULT:
        break;
    }
    return otherwise;
}

static void set_blend(GLuint attachment, const gn_blend *b)
{
    const GLenum source = factor(b->source, GL_ONE);
    const GLenum destination = factor(b->destination, GL_ZERO);
    const GLenum color = equation(b->equation, GL_FUNC_ADD);

    if (!b->enabled) {
        glDisablei(GL_BLEND, attachment);
        return;
    }
    glEnablei(GL_BLEND, attachment);
    glBlendFuncSeparatei(attachment, source, destination, factor(b->alpha_source, source),
                         factor(b->alpha_destination, destination));
    glBlendEquationSeparatei(attachment, color, equation(b->alpha_equation, color));
}

static void set_logic(bool enabled, gn_logic_operation operation)
{
    static const GLenum names[] = {GL_COPY,          GL_CLEAR,       GL_AND,    GL_AND_REVERSE,
                                   GL_AND_INVERTED,  GL_NOOP,        GL_XOR,    GL_OR,
                                   GL_NOR,           GL_EQUIV,       GL_INVERT, GL_OR_REVERSE,
                                   GL_COPY_INVERTED, GL_OR_INVERTED, GL_NAND,   GL_SET};

    if (enabled) {
        glEnable(GL_COLOR_LOGIC_OP);
        glLogicOp(names[operation]);
    } else {
        glDisable(GL_COLOR_LOGIC_OP);
    }
}

void reference_set_color_state(const gn_pipeline *p)
{
    for (GLuint a = 0; a < GN_MAX_COLORS; ++a) {
        const uint32_t written = ~p->color.write_disabled[a];

        glColorMaski(a, (written & GN_CHANNEL_RED) != 0, (written & GN_CHANNEL_GREEN) != 0,
                     (written & GN_CHANNEL_BLUE) != 0, (written & GN_CHANNEL_ALPHA) != 0);
        set_blend(a, &p->color.blend[a]);
    }
    glBlendColor(p->color.blend_constant[0], p->color.blend_constant[1], p->color.blend_constant[2],
                 p->color.blend_constant[3]);
    set_logic(p->color.logic_enabled, p->color.logic_operation);
}
