/* The ready-made shaders and their uniforms; and their fragment shaders, called for one row of
 * lanes. */
#ifndef UNIT_READY_MADE_H
#define UNIT_READY_MADE_H

#include <math.h>

#include "public_lookups.h"
#include "drawing.h"

enum {
    VERTEX_COLOR,
    DEPTH_ONLY,
    DEPTH_COLOR,
    UNLIT,
    FLAT,
    GOURAUD,
    TOON,
    PHONG,
    BLINN_PHONG,
    NORMAL_COLOR,
    METALLIC_ROUGHNESS,
    SHADERS
};

/* All that take lit uniforms. */
enum { FIRST_LIT = FLAT, LAST_LIT = NORMAL_COLOR };

typedef struct all_uniforms {
    gn_color_uniforms color;
    gn_depth_color_uniforms depth;
    gn_unlit_uniforms unlit;
    gn_lit_uniforms lit;
    gn_metallic_roughness_uniforms metallic;
} all_uniforms;

static all_uniforms uniforms;

/* Zeros, but for the matrices: model space is clip space and world space. */
static inline void reset_uniforms(void)
{
    memset(&uniforms, 0, sizeof uniforms);
    gn_mat4_identity(&uniforms.color.clip_from_model);
    gn_mat4_identity(&uniforms.depth.clip_from_model);
    gn_mat4_identity(&uniforms.unlit.clip_from_model);
    gn_mat4_identity(&uniforms.lit.clip_from_model);
    gn_mat4_identity(&uniforms.lit.world_from_model);
    gn_mat3_identity(&uniforms.lit.normal_matrix);
    gn_mat4_identity(&uniforms.metallic.clip_from_model);
    gn_mat4_identity(&uniforms.metallic.world_from_model);
    gn_mat3_identity(&uniforms.metallic.normal_matrix);
}

/* Calls the shader's gn_use_ function; `u` may be null. */
static inline gn_status use_with(int shader, gn_pipeline *p, const all_uniforms *u)
{
    typedef gn_status use_lit(gn_pipeline * pipeline, const gn_lit_uniforms *lit);
    static use_lit *const lit[] = {gn_use_flat,  gn_use_gouraud,     gn_use_toon,
                                   gn_use_phong, gn_use_blinn_phong, gn_use_normal_color};

    switch (shader) {
    case VERTEX_COLOR:
        return gn_use_vertex_color(p, u ? &u->color : NULL);
    case DEPTH_ONLY:
        return gn_use_depth_only(p, u ? &u->color : NULL);
    case DEPTH_COLOR:
        return gn_use_depth_color(p, u ? &u->depth : NULL);
    case UNLIT:
        return gn_use_unlit(p, u ? &u->unlit : NULL);
    case METALLIC_ROUGHNESS:
        return gn_use_metallic_roughness(p, u ? &u->metallic : NULL);
    default:
        return lit[shader - FIRST_LIT](p, u ? &u->lit : NULL);
    }
}

static inline gn_status use_shader(int shader, gn_pipeline *p)
{
    return use_with(shader, p, &uniforms);
}

/* The uniforms are refused, and the pipeline stays as it was. */
static inline void assert_shader_refuses(int shader, gn_status expected)
{
    gn_pipeline p, before;

    memset(&p, 0, sizeof p);
    before = p;
    assert_int_equal(use_shader(shader, &p), expected);
    assert_memory_equal(&p, &before, sizeof p);
}

/* A texture of one texel. */
static inline gn_texture texture_of(gn_format format, const void *texel)
{
    gn_texture t;

    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, format, 1, 1, 1, 1, texel, &t), GN_OK);
    return t;
}

enum { ALPHA = 3, TEXCOORD, NORMAL = 6, PLACE = 9, TANGENT = 12, HANDEDNESS = 15 };

/* What the fragment shader reads, and what it makes of lane 9. */
static float varying[GN_SHADER_VARYINGS][GN_LANES];
static bool is_front;
static float rgba[4];
static uint32_t kept;

static inline void set_varyings(int first, const float *values, int count)
{
    for (int n = 0; n < count; ++n)
        for (int l = 0; l < GN_LANES; ++l)
            varying[first + n][l] = values[n];
}

static inline void set_varying(int first, float x, float y, float z)
{
    set_varyings(first, (const float[3]){x, y, z}, 3);
}

static inline void shade(int shader)
{
    static float color[4][GN_LANES];
    gn_pipeline p = {0};
    const gn_fragment_input in = {.varying = (const float(*)[GN_LANES])varying,
                                  .coverage = 0xFFFF,
                                  .texture_functions = &public_lookups,
                                  .front_facing = is_front};
    gn_fragment_output out = {.color = color, .kept = 0xFFFF};

    assert_int_equal(use_shader(shader, &p), GN_OK);
    p.program.fragment_shader(p.program.uniforms, &in, &out);
    kept = out.kept;
    for (int channel = 0; channel < 4; ++channel)
        rgba[channel] = color[channel][9];
}

/* The tolerance is that of the powers in metallic-roughness; the other shaders have none. */
static inline void expect_color(int shader, double red, double green, double blue)
{
    const double expected[3] = {red, green, blue};

    shade(shader);
    for (int i = 0; i < 3; ++i)
        if (!(fabs((double)rgba[i] - expected[i]) <=
              2e-6 + (shader == METALLIC_ROUGHNESS ? 2e-5 * fabs(expected[i]) : 0.0)))
            fail_msg("shader %d, channel %d: %.9g, not %.9g", shader, i, (double)rgba[i],
                     expected[i]);
}

static inline void expect_grey(int shader, double value)
{
    expect_color(shader, value, value, value);
}

#endif
