/** @file
 * Parts of the macros of gnomon/shader_functions.h: they take vertices and fragments out of lanes
 * one by one, and put their results back. Nothing here is for users.
 *
 * Lists of steps replace loops here. The macros pass constant counts, so that the compiler keeps
 * only the steps that are needed and turns the scalars of structs into variables of the loop over
 * lanes. It would unroll loops too late for that. */
#ifndef GNOMON_SHADER_LOOP_H
#define GNOMON_SHADER_LOOP_H

#include "shader_types.h"

#if defined(__GNUC__)
#define GN_SHADER_INLINE_ static inline __attribute__((always_inline))
#define GN_SHADER_WHOLE_ __attribute__((flatten)) /* inlines every function that it calls */
#else
#define GN_SHADER_INLINE_ static inline
#define GN_SHADER_WHOLE_
#endif

/* The lanes that a shader computes: all, as a constant, unless the library may ask for one. */
#define GN_SHADER_LANES_(input) (GN_HAVE_ONE_LANE ? (int)(input)->count : GN_LANES)

/* STEP(n) for eight numbers n from `first` on, or for 32 numbers from 0 on. */
#define GN_SHADER_8_(STEP, first)                                                                  \
    STEP((first) + 0)                                                                              \
    STEP((first) + 1)                                                                              \
    STEP((first) + 2)                                                                              \
    STEP((first) + 3)                                                                              \
    STEP((first) + 4)                                                                              \
    STEP((first) + 5)                                                                              \
    STEP((first) + 6)                                                                              \
    STEP((first) + 7)

#define GN_SHADER_32_(STEP)                                                                        \
    GN_SHADER_8_(STEP, 0)                                                                          \
    GN_SHADER_8_(STEP, 8)                                                                          \
    GN_SHADER_8_(STEP, 16)                                                                         \
    GN_SHADER_8_(STEP, 24)

/* Copies lane `lane` of row n to scalar n, for up to GN_MAX_VARYINGS rows. gn_shader_put_ copies
 * from scalar n to the lane. */
GN_SHADER_INLINE_ void gn_shader_take_(const float (*rows)[GN_LANES], int lane, float *scalar,
                                       uint32_t count)
{
#define GN_SHADER_TAKE_(n)                                                                         \
    if (count > n)                                                                                 \
        scalar[n] = rows[n][lane];
    GN_SHADER_32_(GN_SHADER_TAKE_)
#undef GN_SHADER_TAKE_
}

GN_SHADER_INLINE_ void gn_shader_put_(const float *scalar, uint32_t count, float (*rows)[GN_LANES],
                                      int lane)
{
#define GN_SHADER_PUT_(n)                                                                          \
    if (count > n)                                                                                 \
        rows[n][lane] = scalar[n];
    GN_SHADER_32_(GN_SHADER_PUT_)
#undef GN_SHADER_PUT_
}

GN_SHADER_INLINE_ void gn_shader_zero_(float *scalar, uint32_t count)
{
#define GN_SHADER_ZERO_(n)                                                                         \
    if (count > n)                                                                                 \
        scalar[n] = 0.0f;
    GN_SHADER_32_(GN_SHADER_ZERO_)
#undef GN_SHADER_ZERO_
}

GN_SHADER_INLINE_ gn_vec4 gn_shader_take_vector_(const float (*rows)[GN_LANES], int lane)
{
    return gn_make4(rows[0][lane], rows[1][lane], rows[2][lane], rows[3][lane]);
}

GN_SHADER_INLINE_ void gn_shader_put_vector_(gn_vec4 v, float (*rows)[GN_LANES], int lane)
{
    rows[0][lane] = v.x;
    rows[1][lane] = v.y;
    rows[2][lane] = v.z;
    rows[3][lane] = v.w;
}

GN_SHADER_INLINE_ void gn_shader_put_colors_(const gn_vec4 *color, uint32_t count,
                                             float (*rows)[GN_LANES], int lane)
{
#define GN_SHADER_PUT_COLOR_(n)                                                                    \
    if (count > n)                                                                                 \
        gn_shader_put_vector_(color[n], rows + 4 * (n), lane);
    GN_SHADER_8_(GN_SHADER_PUT_COLOR_, 0)
#undef GN_SHADER_PUT_COLOR_
}

/* A shader's results go through arrays of its own. The compiler knows that these arrays overlap
 * neither the uniforms nor the input. */
GN_SHADER_INLINE_ void gn_shader_copy_row_(float *to, const float *from, int lanes)
{
    for (int lane = 0; lane < lanes; ++lane)
        to[lane] = from[lane];
}

GN_SHADER_INLINE_ void gn_shader_copy_(float (*to)[GN_LANES], float (*from)[GN_LANES],
                                       uint32_t count, int lanes)
{
    for (uint32_t row = 0; row < count; ++row)
        gn_shader_copy_row_(to[row], from[row], lanes);
}

GN_SHADER_INLINE_ void gn_shader_copy_mask_(uint32_t *to, const uint32_t *from, int lanes)
{
    for (int lane = 0; lane < lanes; ++lane)
        to[lane] = from[lane];
}

GN_SHADER_INLINE_ void gn_shader_take_vertex_(const gn_vertex_input *input,
                                              const gn_vertex_output *output, int lane,
                                              gn_vertex *vertex)
{
    static const float none[GN_LANES] = {0.0f};

#define GN_SHADER_ATTRIBUTE_(n)                                                                    \
    vertex->attribute[n] = gn_shader_take_vector_(input->attribute[n], lane);
    GN_SHADER_8_(GN_SHADER_ATTRIBUTE_, 0)
#undef GN_SHADER_ATTRIBUTE_
    vertex->present = input->present;
    vertex->vertex_id = input->vertex_id[lane];
    vertex->instance = input->instance;
    vertex->point_size = (output->point_size ? output->point_size : none)[lane];
    gn_shader_zero_(vertex->clip_distance, GN_MAX_CLIP_DISTANCES);
}

/* Inputs that the pipeline has not switched on are read from rows of 0, so that nothing is chosen
 * lane by lane. */
GN_SHADER_INLINE_ void gn_shader_take_fragment_(const gn_fragment_input *input,
                                                const gn_fragment_output *output, int lane,
                                                gn_fragment *fragment)
{
    static const float none[4][GN_LANES] = {{0.0f}};
    static const uint32_t no_samples[GN_LANES] = {0};
    const float(*const point)[GN_LANES] = input->point_coordinate ? input->point_coordinate : none;

    fragment->position = gn_shader_take_vector_(input->position ? input->position : none, lane);
    fragment->point_coordinate = gn_make2(point[0][lane], point[1][lane]);
    fragment->primitive_id = input->primitive_id;
    fragment->covered_samples = (input->sample_mask ? input->sample_mask : no_samples)[lane];
    fragment->sample_id = input->sample_id;
    fragment->sample_position = gn_make2(input->sample_position[0], input->sample_position[1]);
    fragment->front_facing = input->front_facing;
#define GN_SHADER_BLACK_(n) fragment->color[n] = gn_make4(0.0f, 0.0f, 0.0f, 0.0f);
    GN_SHADER_8_(GN_SHADER_BLACK_, 0)
#undef GN_SHADER_BLACK_
    fragment->depth = (output->depth ? output->depth : none[0])[lane];
    fragment->sample_mask = 0xFFFFFFFFu;
    fragment->discard = false;
}

GN_SHADER_INLINE_ gn_vec4 gn_shader_texel_(float (*texel)[GN_LANES], int lane)
{
    return gn_make4(texel[0][lane], texel[1][lane], texel[2][lane], texel[3][lane]);
}

GN_SHADER_INLINE_ void gn_shader_take_texels_(float (*texel)[4][GN_LANES], int lane, gn_vec4 *found,
                                              uint32_t count)
{
#define GN_SHADER_TEXEL_(n)                                                                        \
    if (count > n)                                                                                 \
        found[n] = gn_shader_texel_(texel[n], lane);
    GN_SHADER_8_(GN_SHADER_TEXEL_, 0)
#undef GN_SHADER_TEXEL_
}

/* Each row is an array of its own, so that a row that is not passed to the library need not be
 * written. */
GN_SHADER_INLINE_ void gn_shader_put_lookup_(const gn_texel_lookup *lookup, int lane, float *s,
                                             float *t, float *r, float *reference, float *lod)
{
    s[lane] = lookup->coordinate.x;
    t[lane] = lookup->coordinate.y;
    r[lane] = lookup->coordinate.z;
    reference[lane] = lookup->reference;
    lod[lane] = lookup->lod;
}

GN_SHADER_INLINE_ void gn_shader_put_lookups_(const gn_texel_lookup *lookup, uint32_t count,
                                              int lane, float (*s)[GN_LANES], float (*t)[GN_LANES],
                                              float (*r)[GN_LANES], float (*reference)[GN_LANES],
                                              float (*lod)[GN_LANES])
{
#define GN_SHADER_PUT_LOOKUP_(n)                                                                   \
    if (count > n)                                                                                 \
        gn_shader_put_lookup_(lookup + (n), lane, s[n], t[n], r[n], reference[n], lod[n]);
    GN_SHADER_8_(GN_SHADER_PUT_LOOKUP_, 0)
#undef GN_SHADER_PUT_LOOKUP_
}

GN_SHADER_INLINE_ void gn_shader_lookup_(const gn_texture_functions *texture_functions,
                                         const gn_texel_lookup *lookup, float *s, float *t,
                                         float *r, float *reference, float *lod,
                                         float (*texel)[GN_LANES])
{
    gn_lookup all;

    if (lookup->is_2d) {
        texture_functions->lookup_2d(texture_functions->memory, lookup->texture, lookup->sampler, s,
                                     t, texel);
        return;
    }
    all.coordinate[0] = s;
    all.coordinate[1] = t;
    all.coordinate[2] = r;
    all.reference = reference;
    all.lod_source = lookup->lod_source;
    all.lod = lookup->has_lod ? lod : 0;
    all.gradient_x[0] = all.gradient_x[1] = all.gradient_x[2] = 0;
    all.gradient_y[0] = all.gradient_y[1] = all.gradient_y[2] = 0;
    texture_functions->lookup(texture_functions->memory, lookup->texture, lookup->sampler, &all,
                              texel);
}

GN_SHADER_INLINE_ void gn_shader_lookup_all_(const gn_texture_functions *texture_functions,
                                             const gn_texel_lookup *lookup, uint32_t count,
                                             float (*s)[GN_LANES], float (*t)[GN_LANES],
                                             float (*r)[GN_LANES], float (*reference)[GN_LANES],
                                             float (*lod)[GN_LANES], float (*texel)[4][GN_LANES])
{
#define GN_SHADER_LOOKUP_(n)                                                                       \
    if (count > n)                                                                                 \
        gn_shader_lookup_(texture_functions, lookup + (n), s[n], t[n], r[n], reference[n], lod[n], \
                          texel[n]);
    GN_SHADER_8_(GN_SHADER_LOOKUP_, 0)
#undef GN_SHADER_LOOKUP_
}

/* Clears the bits of discarded fragments, if there are any. */
GN_SHADER_INLINE_ void gn_shader_discard_(uint32_t any, const uint32_t *discarded, int lanes,
                                          gn_fragment_output *output)
{
    for (int lane = 0; any && lane < lanes; ++lane)
        output->kept &= ~(discarded[lane] << lane);
}

/* Returns whether a type's name of `size` bytes is void: C has no other way to ask for it. */
GN_SHADER_INLINE_ int gn_shader_is_void_(const char *name, unsigned long size)
{
    return size == sizeof "void" && name[0] == 'v' && name[1] == 'o' && name[2] == 'i' &&
           name[3] == 'd';
}

/* Returns whether a lookup of a fragment needs neighbours. Precondition: gn_shader_check_lookups_
 * has found no fault. */
static inline bool gn_shader_lookups_need_quads_(const gn_texel_lookup *lookup, uint32_t count)
{
    bool needs = false;

    for (uint32_t n = 0; n < count; ++n)
        needs = needs || gn_lookup_needs_quads(lookup[n].texture, lookup[n].sampler);
    return needs;
}

/* Returns the first fault of the textures and samplers that a fragment looks up. */
static inline gn_status gn_shader_check_lookups_(const gn_texel_lookup *lookup, uint32_t count)
{
    gn_status status = GN_OK;

    for (uint32_t n = 0; n < count && status == GN_OK; ++n) {
        status = gn_texture_check(lookup[n].texture);
        if (status == GN_OK && lookup[n].is_2d && lookup[n].texture->target != GN_TEXTURE_2D)
            status = GN_INVALID_ENUM;
        if (status == GN_OK)
            status = gn_sampler_check(lookup[n].sampler);
    }
    return status;
}

static inline gn_status gn_shader_use_(gn_pipeline *pipeline, gn_vertex_shader *vertex,
                                       gn_fragment_shader *fragment, gn_needs_quads *needs_quads,
                                       const void *uniforms, uint32_t varying_count)
{
    if (!pipeline)
        return GN_NULL_POINTER;
    pipeline->program.vertex_shader = vertex;
    pipeline->program.fragment_shader = fragment;
    pipeline->program.uniforms = uniforms;
    pipeline->program.needs_quads = GN_HAVE_ONE_LANE ? needs_quads : 0;
    pipeline->program.varying_count = varying_count;
    for (uint32_t n = 0; n < varying_count; ++n) {
        pipeline->program.interpolation[n] = GN_SMOOTH;
        pipeline->program.interpolated_at[n] = GN_AT_CENTER;
    }
    return GN_OK;
}

#endif
