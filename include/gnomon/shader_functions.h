/** @file
 * Shaders as C functions of one vertex and one fragment, with vectors as in GLSL. A macro wraps
 * such a function into the loop over lanes that a gn_pipeline takes. Everything is inline, and
 * compilers vectorise the loop at -O2 and above, without further flags.
 *
 * The examples include <gnomon.h>, and leave out the (void) that -Wextra asks for where a function
 * does not use a parameter. A mesh numbers its attributes as it likes; the examples use the
 * numbers of gnomon/shaders.h. A workspace for the first one and `count` vertices has
 * gn_workspace_size(count, GN_VARYING_COUNT(colored)) bytes.
 *
 * Example 1, colours from vertex to vertex:
 *
 *     typedef struct { gn_vec4 color; } colored;
 *
 *     static gn_vec4 place(const void *u, gn_vertex *vertex, colored *out)
 *     {
 *         out->color = vertex->attribute[GN_ATTRIBUTE_COLOR];
 *         return vertex->attribute[GN_ATTRIBUTE_POSITION];
 *     }
 *     static gn_vec4 paint(const void *u, const colored *in, gn_fragment *f) { return in->color; }
 *
 *     GN_SHADERS(use_colors, void, colored, place, paint);
 *
 * use_colors(&pipeline, NULL) then makes a pipeline draw with these functions. A vertex function
 * returns the position in clip space and writes the varyings, a struct of floats and vectors of the
 * user's choice. A fragment function reads the interpolated varyings and returns the colour.
 *
 * Example 2, a texture:
 *
 *     typedef struct {
 *         gn_mat4 clip_from_model;
 *         gn_texture texture;
 *         gn_sampler sampler;
 *     } map_uniforms;
 *     typedef struct { gn_vec2 texcoord; } mapped;
 *
 *     static gn_vec4 map_vertex(const map_uniforms *u, gn_vertex *vertex, mapped *out)
 *     {
 *         out->texcoord = gn_xy4(vertex->attribute[GN_ATTRIBUTE_TEXCOORD]);
 *         return gn_multiply_mat4(&u->clip_from_model, vertex->attribute[GN_ATTRIBUTE_POSITION]);
 *     }
 *     static void map_lookups(const map_uniforms *u, const mapped *in, gn_texel_lookup *lookup)
 *     {
 *         lookup[0] = gn_lookup_2d(&u->texture, &u->sampler, in->texcoord);
 *     }
 *     static gn_vec4 map_fragment(const map_uniforms *u, const mapped *in, gn_fragment *fragment)
 *     {
 *         return fragment->texel[0];
 *     }
 *     GN_TEXTURED_SHADERS(use_map, map_uniforms, mapped, map_vertex, 1, map_lookups, map_fragment);
 *
 * A texture's level of detail comes from the differences of coordinates between neighbouring
 * fragments, so the coordinates of all fragments must be known before any texture is looked up.
 * That is why lookups are a function of their own, which runs first. For one fragment, it says
 * where to look; the fragment function finds the results in `texel`, in the same order.
 *
 * Example 3, light at every pixel (Phong 1975), from a point in the space of the eye:
 *
 *     typedef struct {
 *         gn_mat4 clip_from_model, eye_from_model;
 *         gn_mat3 normal_matrix;
 *         gn_vec3 light;
 *         gn_vec3 ambient, diffuse, specular;
 *         uint32_t exponent;
 *     } phong_uniforms;
 *
 *     typedef struct {
 *         gn_vec3 normal, place;
 *         gn_vec3 color;
 *     } phong_varyings;
 *
 *     static gn_vec4 phong_vertex(const phong_uniforms *u, gn_vertex *vertex, phong_varyings *out)
 *     {
 *         const gn_vec4 position = vertex->attribute[GN_ATTRIBUTE_POSITION];
 *         const gn_vec3 normal = gn_xyz4(vertex->attribute[GN_ATTRIBUTE_NORMAL]);
 *         const gn_vec4 white = gn_make4(1.0f, 1.0f, 1.0f, 1.0f);
 *
 *         out->normal = gn_multiply_mat3(&u->normal_matrix, normal);
 *         out->place = gn_xyz4(gn_multiply_mat4(&u->eye_from_model, position));
 *         out->color = gn_xyz4(gn_attribute_or(vertex, GN_ATTRIBUTE_COLOR, white));
 *         return gn_multiply_mat4(&u->clip_from_model, position);
 *     }
 *
 *     static gn_vec4 phong_fragment(const phong_uniforms *u, const phong_varyings *in,
 *                                   gn_fragment *fragment)
 *     {
 *         const gn_vec3 normal = gn_normalize3(in->normal);
 *         const gn_vec3 to_light = gn_normalize3(gn_subtract3(u->light, in->place));
 *         const gn_vec3 to_eye = gn_normalize3(gn_negate3(in->place));
 *         const float cosine = gn_maximum1(gn_dot3(normal, to_light), 0.0f);
 *         const gn_vec3 mirrored = gn_reflect3(gn_negate3(to_light), normal);
 *         const float shine = gn_power1(gn_maximum1(gn_dot3(mirrored, to_eye), 0.0f), u->exponent);
 *         const gn_vec3 lit = gn_add3(u->ambient, gn_scale3(u->diffuse, cosine));
 *         const gn_vec3 highlight = gn_scale3(u->specular, gn_select1(cosine > 0.0f, shine, 0.0f));
 *
 *         return gn_extend3(gn_add3(gn_multiply3(in->color, lit), highlight), 1.0f);
 *     }
 *
 *     GN_SHADERS(use_phong, phong_uniforms, phong_varyings, phong_vertex, phong_fragment);
 *
 * End of the examples.
 *
 * Functions run for every lane, covered or not, and must have no side effects. Anything that they
 * use beyond varyings, texels and the returned colour must be switched on in the pipeline's
 * program, by the field on the right:
 *
 *     vertex->point_size                 vertex_writes_point_size
 *     vertex->clip_distance              clip_distance_count, and GN_VERTEX_SHADER
 *     fragment->position                 fragment_reads_position
 *     fragment->primitive_id             fragment_reads_primitive
 *     fragment->point_coordinate         fragment_reads_point_coordinate
 *     fragment->covered_samples          fragment_reads_sample_mask
 *     fragment->sample_id                fragment_reads_sample
 *     fragment->sample_position          fragment_reads_sample
 *     fragment->discard                  fragment_discards
 *     fragment->depth                    fragment_writes_depth
 *     fragment->sample_mask              fragment_writes_sample_mask
 *     fragment->color, beyond the first  color_count, and GN_FRAGMENT_SHADER
 *
 * What is not switched on reads as 0, sample_position as 0.5, and writing it has no effect;
 * gn_program says why this is no fault.
 *
 * The bits of the results, and what keeps gcc from vectorising, are stated in
 * gnomon/shader_vectors.h. Clang vectorises the same functions. A shader is as wide as the
 * instruction set its file is compiled for, for example by -mavx2. Apart from the
 * lookups of GN_TEXTURED_SHADERS, a shader that needs several lanes at once must be written as a
 * loop over lanes: for example for gn_derivative_x, or for a lookup at a place that another
 * lookup has found. */
#ifndef GNOMON_SHADER_FUNCTIONS_H
#define GNOMON_SHADER_FUNCTIONS_H

#include "shader_loop.h"

/** The number of scalars in a struct of varyings, for the pipeline's varying_count. The struct's
 * floats are varyings 0, 1 and so on, in the struct's order; interpolation[] and interpolated_at[]
 * may be set for each. */
#define GN_VARYING_COUNT(varyings) ((uint32_t)(sizeof(varyings) / sizeof(float)))

/**
 * Defines a function `static gn_status use(gn_pipeline *pipeline, const uniforms *values)`, which
 * sets a pipeline's shaders, uniforms, varying_count, interpolation (GN_SMOOTH) and interpolated_at
 * (GN_AT_CENTER), and leaves the rest alone. It returns GN_NULL_POINTER if the pipeline is null, or
 * if `values` is null and `uniforms` is not void; otherwise GN_OK. `values` must outlive the draws.
 * A semicolon ends each of these macros.
 *
 *     uniforms   a struct, or void for none
 *     varyings   a struct of floats, gn_vec2, gn_vec3 and gn_vec4, 1 to GN_MAX_VARYINGS scalars. A
 *                shader without varyings takes a struct of one float that nothing uses. Members of
 *                other types compile, but their bits are interpolated as floats.
 *     vertex     gn_vec4 vertex(const uniforms *, gn_vertex *, varyings *out)
 *     fragment   gn_vec4 fragment(const uniforms *, const varyings *in, gn_fragment *)
 *
 * Varyings that the vertex function does not write are 0. */
#define GN_SHADERS(use, uniforms_type, varyings_type, vertex, fragment)                            \
    GN_VERTEX_SHADER(use##_vertices, uniforms_type, varyings_type, 0, vertex);                     \
    GN_FRAGMENT_SHADER(use##_fragments, uniforms_type, varyings_type, 1, fragment);                \
    GN_SHADER_USE_(use, uniforms_type, varyings_type)

/**
 * GN_SHADERS for a fragment function with textures.
 *
 *     textures   how many lookups there are, 1 to GN_MAX_SHADER_TEXTURES, a constant
 *     lookups    void lookups(const uniforms *, const varyings *in, gn_texel_lookup *lookup), which
 *                writes all of lookup[0] to lookup[textures - 1]
 *
 * `use` checks textures and samplers before anything is drawn: it calls `lookups` once, with
 * varyings of 0, and returns for each lookup in turn the statuses of gn_texture_check,
 * GN_INVALID_ENUM (a gn_lookup_2d whose texture is no GN_TEXTURE_2D) and the statuses of
 * gn_sampler_check; then the pipeline is as it was. Set the textures and samplers of `values`
 * before, and call `use` again after a change of them. */
#define GN_TEXTURED_SHADERS(use, uniforms_type, varyings_type, vertex, textures, lookups,          \
                            fragment)                                                              \
    GN_VERTEX_SHADER(use##_vertices, uniforms_type, varyings_type, 0, vertex);                     \
    GN_TEXTURED_FRAGMENT_SHADER(use##_fragments, uniforms_type, varyings_type, 1, textures,        \
                                lookups, fragment);                                                \
    GN_SHADER_TEXTURED_USE_(use, uniforms_type, varyings_type, textures, lookups)

/* A count from `least` to `most`; for any other count the array of that size does not compile. */
#define GN_SHADER_COUNT_(count, least, most)                                                       \
    ((count) >= (least) && (count) <= (most) ? (count) : -9)

/**
 * Each of these macros defines one shader, a static function called `name`: a gn_vertex_shader or
 * a gn_fragment_shader, for a pipeline's vertex_shader or fragment_shader. The pipeline's
 * varying_count must be GN_VARYING_COUNT(varyings_type) and its uniforms a pointer to
 * uniforms_type.
 *
 *     clip_distances   the pipeline's clip_distance_count, a constant
 *     colors           the pipeline's color_count, from 1 on, a constant */
#define GN_VERTEX_SHADER(name, uniforms_type, varyings_type, clip_distances, vertex)               \
    GN_SHADER_WHOLE_ static void name(const void *gn_uniforms, const gn_vertex_input *gn_input,    \
                                      gn_vertex_output *gn_output)                                 \
    {                                                                                              \
        float gn_position[4][GN_LANES];                                                            \
        float gn_varying[GN_VARYING_COUNT(varyings_type)][GN_LANES];                               \
        float gn_point_size[GN_LANES];                                                             \
        float gn_distance[GN_SHADER_COUNT_(clip_distances, 0, GN_MAX_CLIP_DISTANCES) + 1]          \
                         [GN_LANES];                                                               \
                                                                                                   \
        for (int gn_lane = 0; gn_lane < GN_SHADER_LANES_(gn_input); ++gn_lane) {                   \
            GN_SHADER_STRUCT_(varyings_type) gn_out;                                               \
            gn_vertex gn_at;                                                                       \
                                                                                                   \
            gn_shader_take_vertex_(gn_input, gn_output, gn_lane, &gn_at);                          \
            gn_shader_zero_(gn_out.scalar, GN_VARYING_COUNT(varyings_type));                       \
            gn_shader_put_vector_(                                                                 \
                vertex((const uniforms_type *)gn_uniforms, &gn_at, &gn_out.whole), gn_position,    \
                gn_lane);                                                                          \
            gn_shader_put_(gn_out.scalar, GN_VARYING_COUNT(varyings_type), gn_varying, gn_lane);   \
            gn_shader_put_(gn_at.clip_distance, clip_distances, gn_distance, gn_lane);             \
            gn_point_size[gn_lane] = gn_at.point_size;                                             \
        }                                                                                          \
        gn_shader_copy_(gn_output->position, gn_position, 4, GN_SHADER_LANES_(gn_input));          \
        gn_shader_copy_(gn_output->varying, gn_varying, GN_VARYING_COUNT(varyings_type),           \
                        GN_SHADER_LANES_(gn_input));                                               \
        gn_shader_copy_(gn_output->clip_distance, gn_distance, clip_distances,                     \
                        GN_SHADER_LANES_(gn_input));                                               \
        if (gn_output->point_size)                                                                 \
            gn_shader_copy_row_(gn_output->point_size, gn_point_size, GN_SHADER_LANES_(gn_input)); \
    }                                                                                              \
    struct name##_is_defined

/** Defines a fragment shader, as described at GN_VERTEX_SHADER. */
#define GN_FRAGMENT_SHADER(name, uniforms_type, varyings_type, colors, fragment)                   \
    GN_SHADER_WHOLE_ static void name(const void *gn_uniforms, const gn_fragment_input *gn_input,  \
                                      gn_fragment_output *gn_output)                               \
    {                                                                                              \
        GN_SHADER_FRAGMENTS_(uniforms_type, varyings_type, colors, 0, 0, fragment);                \
    }                                                                                              \
    struct name##_is_defined

/** Defines a fragment shader with textures, as described at GN_VERTEX_SHADER; `textures`
 * and `lookups` are those of GN_TEXTURED_SHADERS. */
#define GN_TEXTURED_FRAGMENT_SHADER(name, uniforms_type, varyings_type, colors, textures, lookups, \
                                    fragment)                                                      \
    GN_SHADER_WHOLE_ static void name(const void *gn_uniforms, const gn_fragment_input *gn_input,  \
                                      gn_fragment_output *gn_output)                               \
    {                                                                                              \
        float gn_s[GN_SHADER_COUNT_(textures, 1, GN_MAX_SHADER_TEXTURES)][GN_LANES];               \
        float gn_t[textures][GN_LANES], gn_r[textures][GN_LANES];                                  \
        float gn_reference[textures][GN_LANES], gn_lod[textures][GN_LANES];                        \
        float gn_texel[textures][4][GN_LANES];                                                     \
        GN_SHADER_STRUCT_(varyings_type) gn_first;                                                 \
        gn_texel_lookup gn_same[textures];                                                         \
                                                                                                   \
        for (int gn_lane = 0; gn_lane < GN_SHADER_LANES_(gn_input); ++gn_lane) {                   \
            GN_SHADER_STRUCT_(varyings_type) gn_in;                                                \
            gn_texel_lookup gn_lookup_of[textures];                                                \
                                                                                                   \
            gn_shader_take_(gn_input->varying, gn_lane, gn_in.scalar,                              \
                            GN_VARYING_COUNT(varyings_type));                                      \
            lookups((const uniforms_type *)gn_uniforms, &gn_in.whole, gn_lookup_of);               \
            gn_shader_put_lookups_(gn_lookup_of, textures, gn_lane, gn_s, gn_t, gn_r,              \
                                   gn_reference, gn_lod);                                          \
        }                                                                                          \
        gn_shader_take_(gn_input->varying, 0, gn_first.scalar, GN_VARYING_COUNT(varyings_type));   \
        lookups((const uniforms_type *)gn_uniforms, &gn_first.whole, gn_same);                     \
        gn_shader_lookup_all_(gn_input->texture_functions, gn_same, textures, gn_s, gn_t, gn_r,    \
                              gn_reference, gn_lod, gn_texel);                                     \
        GN_SHADER_FRAGMENTS_(uniforms_type, varyings_type, colors, textures, gn_texel, fragment);  \
    }                                                                                              \
    struct name##_is_defined

/* A struct of varyings and its scalars. The array has a negative size, which does not compile, if
 * the struct has too many floats or if its size is no multiple of a float's. */
#define GN_SHADER_STRUCT_(varyings_type)                                                           \
    union {                                                                                        \
        varyings_type whole;                                                                       \
        float scalar[sizeof(varyings_type) % sizeof(float) == 0 &&                                 \
                             GN_VARYING_COUNT(varyings_type) <= GN_MAX_VARYINGS                    \
                         ? (int)GN_VARYING_COUNT(varyings_type)                                    \
                         : -1];                                                                    \
    }

/* Runs the fragments of a block one after the other, then stores their results. */
#define GN_SHADER_FRAGMENTS_(uniforms_type, varyings_type, colors, textures, texels, fragment)     \
    float gn_rows[4 * GN_SHADER_COUNT_(colors, 1, GN_MAX_COLORS)][GN_LANES], gn_depths[GN_LANES];  \
    uint32_t gn_mask[GN_LANES], gn_discarded[GN_LANES], gn_any = 0;                                \
                                                                                                   \
    for (int gn_lane = 0; gn_lane < GN_SHADER_LANES_(gn_input); ++gn_lane) {                       \
        GN_SHADER_STRUCT_(varyings_type) gn_in;                                                    \
        gn_fragment gn_at;                                                                         \
                                                                                                   \
        gn_shader_take_(gn_input->varying, gn_lane, gn_in.scalar,                                  \
                        GN_VARYING_COUNT(varyings_type));                                          \
        gn_shader_take_fragment_(gn_input, gn_output, gn_lane, &gn_at);                            \
        gn_shader_take_texels_(texels, gn_lane, gn_at.texel, textures);                            \
        gn_at.color[0] = fragment((const uniforms_type *)gn_uniforms, &gn_in.whole, &gn_at);       \
        gn_shader_put_colors_(gn_at.color, colors, gn_rows, gn_lane);                              \
        gn_depths[gn_lane] = gn_at.depth;                                                          \
        gn_mask[gn_lane] = gn_at.sample_mask;                                                      \
        gn_discarded[gn_lane] = gn_at.discard;                                                     \
        gn_any |= gn_discarded[gn_lane];                                                           \
    }                                                                                              \
    gn_shader_copy_(gn_output->color, gn_rows, 4 * (colors), GN_SHADER_LANES_(gn_input));          \
    if (gn_output->depth)                                                                          \
        gn_shader_copy_row_(gn_output->depth, gn_depths, GN_SHADER_LANES_(gn_input));              \
    if (gn_output->sample_mask)                                                                    \
        gn_shader_copy_mask_(gn_output->sample_mask, gn_mask, GN_SHADER_LANES_(gn_input));         \
    gn_shader_discard_(gn_any, gn_discarded, GN_SHADER_LANES_(gn_input), gn_output)

/* Whether the uniforms are null, but the type says that there are some. */
#define GN_SHADER_LACKS_(uniforms_type, uniforms)                                                  \
    (!(uniforms) && !gn_shader_is_void_(#uniforms_type, sizeof(#uniforms_type)))

/* Whether a program has other shaders than those of `use`. */
#define GN_SHADER_IS_OTHER_(use, program)                                                          \
    ((program)->vertex_shader != use##_vertices || (program)->fragment_shader != use##_fragments)

#define GN_SHADER_USE_(use, uniforms_type, varyings_type)                                          \
    static bool use##_needs_quads(const gn_program *gn_drawn)                                      \
    {                                                                                              \
        return GN_SHADER_IS_OTHER_(use, gn_drawn);                                                 \
    }                                                                                              \
    static gn_status use(gn_pipeline *gn_drawn, const uniforms_type *gn_uniforms)                  \
    {                                                                                              \
        return GN_SHADER_LACKS_(uniforms_type, gn_uniforms)                                        \
                   ? GN_NULL_POINTER                                                               \
                   : gn_shader_use_(gn_drawn, use##_vertices, use##_fragments, use##_needs_quads,  \
                                    gn_uniforms, GN_VARYING_COUNT(varyings_type));                 \
    }                                                                                              \
    struct use##_is_defined

/* All fragments look up the same textures by the same samplers, so that one with varyings of 0 says
 * which. */
#define GN_SHADER_TEXTURED_USE_(use, uniforms_type, varyings_type, textures, lookups)              \
    static bool use##_needs_quads(const gn_program *gn_drawn)                                      \
    {                                                                                              \
        GN_SHADER_STRUCT_(varyings_type) gn_in;                                                    \
        gn_texel_lookup gn_lookup_of[textures];                                                    \
                                                                                                   \
        if (GN_SHADER_IS_OTHER_(use, gn_drawn))                                                    \
            return true;                                                                           \
        gn_shader_zero_(gn_in.scalar, GN_VARYING_COUNT(varyings_type));                            \
        lookups((const uniforms_type *)gn_drawn->uniforms, &gn_in.whole, gn_lookup_of);            \
        return gn_shader_lookups_need_quads_(gn_lookup_of, textures);                              \
    }                                                                                              \
    static gn_status use(gn_pipeline *gn_drawn, const uniforms_type *gn_uniforms)                  \
    {                                                                                              \
        GN_SHADER_STRUCT_(varyings_type) gn_in;                                                    \
        gn_texel_lookup gn_lookup_of[textures];                                                    \
        gn_status gn_fault;                                                                        \
                                                                                                   \
        if (GN_SHADER_LACKS_(uniforms_type, gn_uniforms))                                          \
            return GN_NULL_POINTER;                                                                \
        gn_shader_zero_(gn_in.scalar, GN_VARYING_COUNT(varyings_type));                            \
        lookups((const uniforms_type *)gn_uniforms, &gn_in.whole, gn_lookup_of);                   \
        gn_fault = gn_shader_check_lookups_(gn_lookup_of, textures);                               \
        return gn_fault != GN_OK                                                                   \
                   ? gn_fault                                                                      \
                   : gn_shader_use_(gn_drawn, use##_vertices, use##_fragments, use##_needs_quads,  \
                                    gn_uniforms, GN_VARYING_COUNT(varyings_type));                 \
    }                                                                                              \
    struct use##_is_defined

#endif
