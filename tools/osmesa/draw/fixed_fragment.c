/* The fragments of the fixed function, over lanes. The order of operations is the reference's. */
#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "fixed_function.h"
#include "lane_function.h"
#include "short_exponential.h"

/* Writes a colour: varyings, or the current one of all vertices. */
static void read_color(const float (*varying)[GN_LANES], int first, const GLfloat *current,
                       int count, float (*to)[GN_LANES])
{
    if (first >= 0) {
        memcpy(to, varying[first], (size_t)count * sizeof *to);
        return;
    }
    for (int c = 0; c < count; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            to[c][l] = current[c];
}

/* The bits of a comparison, as OpenGL numbers them from GL_NEVER on: passes if less, if equal, if
 * greater. What has no order passes GL_NOTEQUAL and GL_ALWAYS. */
LANE_FUNCTION
uint32_t kept_by_alpha(const fixed_function *fixed, const float alpha[GN_LANES])
{
    const uint32_t relations = fixed->alpha_function - GL_NEVER;
    const uint32_t if_less = relations & 1u, if_equal = relations >> 1 & 1u;
    const uint32_t if_greater = relations >> 2 & 1u;
    const float reference = fixed->alpha_reference;
    uint32_t kept = 0;

    for (int l = 0; l < GN_LANES; ++l) {
        const float value = fixed->alpha_in_bytes ? rintf(alpha[l] * 255.0f) : alpha[l];
        const uint32_t passes = value < reference    ? if_less
                                : value > reference  ? if_greater
                                : value == reference ? if_equal
                                                     : if_less & if_greater;

        kept |= passes << l;
    }
    return kept;
}

/* Mixes colours with the fog's (section 3.10). */
static void apply_fog(const fog_derived *fog, const gn_fragment_input *input,
                      float (*color)[GN_LANES])
{
    for (int l = 0; l < GN_LANES; ++l) {
        const float coordinate =
            fog->varying >= 0 ? input->varying[fog->varying][l] : fog->coordinate;
        const float scaled = coordinate * fog->scale;
        const float visible = clamped_color(fog->mode == GL_LINEAR ? scaled + fog->offset
                                            : fog->mode == GL_EXP  ? short_exp2(-scaled)
                                                                  : short_exp2(-(scaled * scaled)));
        const float hidden = 1.0f - visible;

        for (int c = 0; c < 3; ++c)
            color[c][l] = color[c][l] * visible + fog->color[c] * hidden;
    }
}

/* Discards the fragments where the pattern of polygons has no bit. */
static uint32_t kept_by_pattern(const fixed_function *fixed, const gn_fragment_input *input)
{
    uint32_t kept = 0;

    for (int l = 0; l < GN_LANES; ++l) {
        const int32_t x = input->x[l / 8] + l % 4, y = input->y[l / 8] + l / 4 % 2;
        const int32_t row = fixed->rows_go_down ? fixed->pattern_bottom - y : y;

        kept |= (fixed->polygon_pattern[row & (STIPPLE_SIZE - 1)] >> (x & (STIPPLE_SIZE - 1)) & 1u)
                << l;
    }
    return kept;
}

LANE_FUNCTION
void finish_fragments(const fixed_function *fixed, const gn_fragment_input *input,
                      const float (*secondary)[GN_LANES], gn_fragment_output *output)
{
    texture_colors colors;

    colors.units = fixed->unit;
    colors.input = input;
    colors.known = 0;
    if (fixed->last_unit >= 0)
        memcpy(colors.primary, output->color, sizeof colors.primary);
    for (int u = 0; u <= fixed->last_unit; ++u)
        if (fixed->unit[u].enabled)
            apply_texture(&colors, u, output->color,
                          fixed->adds_secondary && u == fixed->last_unit ? secondary : NULL);
    for (int c = 0; c < 3 && fixed->adds_secondary && fixed->last_unit < 0; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            output->color[c][l] += secondary[c][l];
    if (fixed->fog.enabled)
        apply_fog(&fixed->fog, input, output->color);
    if (fixed->tests_alpha)
        output->kept &= kept_by_alpha(fixed, output->color[3]);
}

LANE_FUNCTION
void fixed_fragment(const void *uniforms, const gn_fragment_input *input,
                    gn_fragment_output *output)
{
    const fixed_function *const fixed = uniforms;
    const bool is_back = fixed->back_color_varying >= 0 && !input->front_facing;
    float secondary[3][GN_LANES];

    read_color(input->varying, is_back ? fixed->back_color_varying : fixed->color_varying,
               fixed->current[COLOR], 4, output->color);
    if (fixed->adds_secondary)
        read_color(input->varying,
                   is_back ? fixed->back_secondary_varying : fixed->secondary_varying,
                   fixed->current[SECONDARY_AND_FOG], 3, secondary);
    finish_fragments(fixed, input, (const float(*)[GN_LANES])secondary, output);
    if (fixed->polygon_pattern && fixed->is_stippled[!input->front_facing])
        output->kept &= kept_by_pattern(fixed, input);
}
