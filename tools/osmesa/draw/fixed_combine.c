/* GL_COMBINE, over lanes (OpenGL 2.1 section 3.8.13). The order of operations is the reference's.
 */
#include <gl_registry.h>
#include <string.h>

#include "fixed_texture.h"
#include "lane_function.h"

typedef float lanes_of_color[4][GN_LANES];

static bool is_dot(GLenum mode)
{
    return mode == GL_DOT3_RGB || mode == GL_DOT3_RGBA || mode == GL_DOT3_RGB_EXT ||
           mode == GL_DOT3_RGBA_EXT;
}

/* Returns what an argument becomes. The reference subtracts the half of a signed sum from the first
 * summand that is no product: x - 1/2, or 1/2 - x if it is inverted. With four arguments both are
 * products. */
static float biased(GLenum mode, bool has_four, int i, bool is_inverted, float x)
{
    const float value = is_inverted ? 1.0f - x : x;

    if (is_dot(mode))
        return value * 2.0f - 1.0f;
    if ((mode == GL_ADD_SIGNED && i == 0 && !has_four) ||
        (mode == GL_MODULATE_SIGNED_ADD_ATI && i == 1))
        return is_inverted ? 0.5f - x : x - 0.5f;
    return value;
}

/* Writes an argument of red, green and blue, or of alpha. */
static void read_argument(texture_colors *colors, int u, const combine_state *half, int i,
                          bool is_alpha, const float (*previous)[GN_LANES], lanes_of_color to)
{
    const GLenum source = half->source[i], operand = half->operand[i];
    const bool takes_alpha =
        is_alpha || operand == GL_SRC_ALPHA || operand == GL_ONE_MINUS_SRC_ALPHA;
    const bool is_inverted = operand == GL_ONE_MINUS_SRC_ALPHA || operand == GL_ONE_MINUS_SRC_COLOR;
    const float(*from)[GN_LANES] = NULL;

    if (source == GL_PREVIOUS)
        from = previous;
    else if (source == GL_PRIMARY_COLOR)
        from = (const float(*)[GN_LANES])colors->primary;
    else if (source == GL_TEXTURE)
        from = unit_texel(colors, u);
    else if (source >= GL_TEXTURE0 && source < GL_TEXTURE0 + TEXTURE_UNITS)
        from = unit_texel(colors, (int)(source - GL_TEXTURE0));
    for (int c = is_alpha ? 3 : 0; c < (is_alpha ? 4 : 3); ++c) {
        const int channel = takes_alpha ? 3 : c;
        const float same = source == GL_CONSTANT ? colors->units[u].color[channel]
                           : source == GL_ONE    ? 1.0f
                                                 : 0.0f;

        for (int l = 0; l < GN_LANES; ++l) {
            const float value = from ? from[channel][l] : same;

            to[c][l] = biased(half->mode, colors->units[u].combines_four, i, is_inverted, value);
        }
    }
}

/* Combines one channel of arguments. */
static void combine(GLenum mode, bool has_four, const lanes_of_color a[COMBINE_ARGUMENTS], int c,
                    float to[GN_LANES])
{
    for (int l = 0; l < GN_LANES; ++l) {
        const float x = a[0][c][l], y = a[1][c][l], z = a[2][c][l], w = a[3][c][l];
        const float sum = has_four ? x * y + z * w : x + y;

        switch (mode) {
        case GL_REPLACE:
            to[l] = x;
            break;
        case GL_ADD:
            to[l] = sum;
            break;
        case GL_ADD_SIGNED:
            to[l] = has_four ? (x * y - 0.5f) + z * w : sum;
            break;
        case GL_SUBTRACT:
            to[l] = x - y;
            break;
        case GL_INTERPOLATE:
            to[l] = z * (x - y) + y;
            break;
        case GL_MODULATE_ADD_ATI:
        case GL_MODULATE_SIGNED_ADD_ATI:
            to[l] = x * z + y;
            break;
        case GL_MODULATE_SUBTRACT_ATI:
            to[l] = x * z - y;
            break;
        default:
            to[l] = x * y;
        }
    }
}

static bool takes_alpha(const combine_state *half, int i)
{
    return half->operand[i] == GL_SRC_ALPHA || half->operand[i] == GL_ONE_MINUS_SRC_ALPHA;
}

/* The dot product of two colours whose channels stand for -1 to 1. The alpha of one of them is a
 * common factor. */
static void dot(const combine_state *half, const lanes_of_color a[COMBINE_ARGUMENTS],
                float to[GN_LANES])
{
    const bool has_factor = takes_alpha(half, 0) != takes_alpha(half, 1);
    const int factor = takes_alpha(half, 0) ? 0 : 1;

    for (int l = 0; l < GN_LANES; ++l) {
        const float(*const other)[GN_LANES] = a[1 - factor];

        to[l] = has_factor
                    ? a[factor][0][l] * ((other[2][l] + other[1][l]) + other[0][l])
                    : (a[0][2][l] * a[1][2][l] + a[0][1][l] * a[1][1][l]) + a[0][0][l] * a[1][0][l];
    }
}

/* Whether results may leave 0..1 even if no argument does. */
static bool is_clamped(GLenum mode)
{
    return mode != GL_REPLACE && mode != GL_MODULATE && mode != GL_INTERPOLATE;
}

static void finish(float scale, bool clamps, float to[GN_LANES])
{
    for (int l = 0; l < GN_LANES; ++l) {
        const float value = to[l] * scale;

        to[l] = !clamps ? value : value > 0.0f ? value < 1.0f ? value : 1.0f : 0.0f;
    }
}

LANE_FUNCTION
void apply_combine(texture_colors *colors, int u, float (*color)[GN_LANES])
{
    const unit_derived *const unit = &colors->units[u];
    const GLenum color_mode = unit->combine[COMBINE_COLOR].mode;
    const bool is_extension = color_mode == GL_DOT3_RGB_EXT || color_mode == GL_DOT3_RGBA_EXT;
    const bool dots_alpha = color_mode == GL_DOT3_RGBA || color_mode == GL_DOT3_RGBA_EXT;
    const float scale[COMBINE_HALVES] = {
        is_extension ? 1.0f : unit->combine[COMBINE_COLOR].scale,
        color_mode == GL_DOT3_RGBA_EXT ? 1.0f : unit->combine[COMBINE_ALPHA].scale};
    const bool is_scaled = scale[0] != 1.0f || scale[1] != 1.0f;
    lanes_of_color argument[COMBINE_HALVES][COMBINE_ARGUMENTS], result;

    for (int half = 0; half < COMBINE_HALVES; ++half)
        for (int i = 0; i < COMBINE_ARGUMENTS; ++i)
            read_argument(colors, u, &unit->combine[half], i, half == COMBINE_ALPHA,
                          (const float(*)[GN_LANES])color, argument[half][i]);
    for (int c = 0; c < 4; ++c) {
        const int half = c < 3 ? COMBINE_COLOR : COMBINE_ALPHA;
        const bool takes_dot = is_dot(color_mode) && (c < 3 || dots_alpha);
        const GLenum mode = unit->combine[half].mode;

        if (takes_dot)
            dot(&unit->combine[COMBINE_COLOR], (const lanes_of_color *)argument[COMBINE_COLOR],
                result[c]);
        else
            combine(mode, unit->combines_four, (const lanes_of_color *)argument[half], c,
                    result[c]);
        finish(scale[half], is_scaled || takes_dot || is_clamped(mode), result[c]);
    }
    memcpy(color, result, sizeof result);
}
