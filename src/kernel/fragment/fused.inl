/* Frequent states whose steps are one loop: a depth test by the most common formats, and colours
 * that replace those of GN_FORMAT_RGBA8. steps.inl defines their functions,
 * among which fragment_functions_of chooses; other states take the steps. */
#ifndef GN_KERNEL_FRAGMENT_FUSED_INL
#define GN_KERNEL_FRAGMENT_FUSED_INL

#include "loops.inl"

/* The states: the names of their blocks_function and span_function, depth format, source and where
 * colours go. To fuse the steps of another state, add its line. */
#define GN_FUSED_STATES_OF_LANES(STATE)                                                            \
    STATE(shader_blocks, shader_span, GN_FORMAT_NONE, SOURCE_SHADER, OUTPUT_RGBA8)                 \
    STATE(shader_d24_blocks, shader_d24_span, GN_FORMAT_D24, SOURCE_SHADER, OUTPUT_RGBA8)          \
    STATE(shader_d32f_blocks, shader_d32f_span, GN_FORMAT_D32F, SOURCE_SHADER, OUTPUT_RGBA8)       \
    STATE(color_blocks, color_span, GN_FORMAT_NONE, SOURCE_COLOR, OUTPUT_RGBA8)                    \
    STATE(color_d24_blocks, color_d24_span, GN_FORMAT_D24, SOURCE_COLOR, OUTPUT_RGBA8)             \
    STATE(color_d32f_blocks, color_d32f_span, GN_FORMAT_D32F, SOURCE_COLOR, OUTPUT_RGBA8)          \
    STATE(texture_d24_blocks, texture_d24_span, GN_FORMAT_D24, SOURCE_TEXTURE, OUTPUT_RGBA8)       \
    STATE(texture_d32f_blocks, texture_d32f_span, GN_FORMAT_D32F, SOURCE_TEXTURE, OUTPUT_RGBA8)    \
    STATE(depth_d24_blocks, depth_d24_span, GN_FORMAT_D24, SOURCE_COLOR, OUTPUT_NOTHING)           \
    STATE(depth_d32f_blocks, depth_d32f_span, GN_FORMAT_D32F, SOURCE_COLOR, OUTPUT_NOTHING)

/* With one lane, the depth format of microcontrollers; only spans are fused. */
#define GN_FUSED_STATES_OF_ONE_LANE(STATE)                                                         \
    STATE(shader_d16_blocks, shader_d16_span, GN_FORMAT_D16, SOURCE_SHADER, OUTPUT_RGBA8)          \
    STATE(color_d16_blocks, color_d16_span, GN_FORMAT_D16, SOURCE_COLOR, OUTPUT_RGBA8)             \
    STATE(texture_d16_blocks, texture_d16_span, GN_FORMAT_D16, SOURCE_TEXTURE, OUTPUT_RGBA8)

#if LANES == 1
#define GN_FUSED_STATES(STATE) GN_FUSED_STATES_OF_ONE_LANE(STATE)
#else
#define GN_FUSED_STATES(STATE) GN_FUSED_STATES_OF_LANES(STATE)
#endif

/* Whether a state needs nothing that fused states leave out: tests come before the shader, depths
 * are those of the triangle and have no stencil, inlined varyings are smooth, and at most one
 * colour is written, which replaces that of GN_FORMAT_RGBA8, or with one lane of a format of two
 * bytes. */
static inline bool may_be_fused(const fragment_state *state)
{
    return !state->is_late && !state->moves_depth && !state->clamps_depth &&
           !format_has_stencil(state->depth.format) &&
           (state->is_smooth || state->source == SOURCE_SHADER) && !has_more_colors(state) &&
           shader_colors(state) == 1 &&
           (state->color.format == GN_FORMAT_NONE ||
            ((state->color.format == GN_FORMAT_RGBA8 ||
              (LANES == 1 && format_is_565(state->color.format))) &&
             state->combine.use == COLOR_REPLACES));
}

#endif
