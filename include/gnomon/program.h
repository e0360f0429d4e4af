/** @file
 * Programs: the shaders of a draw, what the library gives them and takes from them, and the lookups
 * in textures of fragment shaders. The table of gnomon/pipeline.h has OpenGL's names for the
 * members of a program. */
#ifndef GNOMON_PROGRAM_H
#define GNOMON_PROGRAM_H

#include <stdbool.h>

#include "lookup.h"

/** The most scalar varyings that a vertex shader may pass to the fragment shader. */
#define GN_MAX_VARYINGS 32

/** The most distances to the user's clip planes that a vertex shader may write. */
#define GN_MAX_CLIP_DISTANCES 8

/** The most vertex attributes, each of up to four components. */
#define GN_MAX_ATTRIBUTES 8

/** How a varying gets its value at a fragment (OpenGL 4.5 section 14.6.1). */
typedef enum gn_interpolation {
    GN_SMOOTH = 0,    /**< perspective-correct */
    GN_NOPERSPECTIVE, /**< linear in window coordinates */
    GN_FLAT           /**< the provoking vertex's value */
} gn_interpolation;

/** Where in its pixel a varying gets its value, if a pixel has several samples (OpenGL 4.5 section
 * 14.3.1). No effect on GN_FLAT varyings and with one sample per pixel, but for what GN_AT_SAMPLE
 * says of the shader.
 *
 * A pixel's centre may lie outside a triangle of which some samples are covered. There a varying at
 * the centre may lie outside the range of its values at the vertices (gn_fragment_input); at the
 * centroid and at a covered sample it does not, but for rounding. */
typedef enum gn_interpolation_point {
    GN_AT_CENTER = 0, /**< at the pixel's centre */

    /** At the pixel's centre if all samples are present, otherwise at the present sample of the
     * lowest number. A sample is present if it is covered, is not in samples.write_disabled, and
     * has passed the depth and stencil tests. The tests do not count in one case: the shader runs
     * before them, and either it writes depth or the stencil test is on and writes some bit. If the
     * shader runs for each sample, samples that it discarded before are not present. Derivatives
     * are taken between these places, which need not be a pixel apart. */
    GN_AT_CENTROID,

    GN_AT_SAMPLE /**< at each sample; the fragment shader runs for each sample */
} gn_interpolation_point;

/** Input of a vertex shader: up to 16 vertices. Lanes beyond `count` repeat the last vertex, so
 * that a shader may run over all GN_LANES. What the shader computes in those lanes is not used. */
typedef struct gn_vertex_input {
    const float (*attribute)[4][GN_LANES]; /**< [attribute][component][lane] */
    const uint32_t *vertex_id;             /**< [lane]: position in the mesh's arrays */
    uint32_t count;                        /**< 1 to GN_LANES */
    uint32_t instance;                     /**< from 0 on */
    uint32_t present;                      /**< bit a: the mesh has attribute a */
} gn_vertex_input;

/** Output of a vertex shader; the memory is the library's. Every lane has a value beforehand, which
 * stays if the shader does not write it: position 0, 0, 0, 1; varyings 0; point size
 * raster.point_size, even if that is 0; clip distances 0, which clip nothing. A clip distance is
 * linear over a triangle or line, and the part where it is negative is clipped away. A point
 * with a clip distance that is negative, NaN or infinite is not drawn. A triangle or line with a
 * clip distance that is NaN or infinite is not drawn. */
typedef struct gn_vertex_output {
    float (*position)[GN_LANES];      /**< [x, y, z, w][lane] in clip space */
    float (*varying)[GN_LANES];       /**< [varying][lane], varying_count of them */
    float *point_size;                /**< [lane]; NaN counts as 1; null without
                                           program.vertex_writes_point_size */
    float (*clip_distance)[GN_LANES]; /**< [distance][lane], clip_distance_count of them */
} gn_vertex_output;

/** Input of a fragment shader: two halves of 4x2 fragments each, which may lie apart in their
 * primitive. Lane l is at pixel (x[l / 8] + l % 4, y[l / 8] + l / 4 % 2). In a library of one lane
 * (gnomon/lanes.h) there is one fragment, at (x[0], y[0]), and it is covered.
 *
 * Varyings have values in every lane, covered or not, so that derivatives can be taken in 2x2
 * quads. The values are those at the pixel's centre, unless the pipeline's `interpolated_at` or
 * `samples.shading_enabled` say otherwise. Lines with several samples per pixel have the values of
 * a place half a pixel to the upper right. The centre may lie outside the triangle: in lanes that
 * are not covered, and where only some of several samples are covered. There the triangle's planes
 * are extended, so that a varying may lie outside the range of its values at the vertices. A smooth
 * varying is divided by the interpolated 1/w, which may be 0 or negative beyond an edge; where it
 * is 0, the varying is infinite or NaN. GN_FLAT varyings are constant. A shader that needs a range
 * must clamp.
 *
 * A colour that is NaN is stored as 0 in formats of integers and as NaN in formats of floats. In
 * linear formats of up to 8 bits per channel, an infinity or a number beyond +-2^31 / 255 is stored
 * as 0. In formats of more bits and in sRGB, minus infinity is stored as 0 and plus infinity as the
 * largest value. Floats hold infinities; floats without sign hold minus infinity as 0. */
typedef struct gn_fragment_input {
    const float (*varying)[GN_LANES]; /**< [varying][lane] */
    uint32_t count;                   /**< GN_LANES, or 1 (gn_needs_quads) */
    uint32_t coverage;                /**< bit l: lane l is covered and passed early tests */
    int32_t x[2], y[2];               /**< window coordinates of lanes 0 and 8, all even */

    const gn_texture_functions *texture_functions; /**< for gn_fragment_lookup and so on, below */

    bool front_facing; /**< gl_FrontFacing, by front_face */

    /** gl_PrimitiveID: the primitive's number in its instance, from 0 on; restarts do not reset it.
     * 0 if the pipeline's fragment_reads_primitive is off. */
    uint32_t primitive_id;

    /** gl_FragCoord, [x, y, z, w][lane]: x and y of the pixel's centre in window coordinates; the
     * interpolated depth with the polygon offset, before it is clamped; the interpolated 1/w. If
     * the shader runs for each sample, x, y and z are those of the sample. Null if the pipeline's
     * fragment_reads_position is off. */
    const float (*position)[GN_LANES];

    /** gl_PointCoord, [s, t][lane]: where the pixel's centre lies in the point's square, from 0 to
     * 1, or up to a pixel's width beyond, since positions and sizes are rounded. With several
     * samples per pixel it is the place half a pixel to the upper right of the centre. t starts at
     * the side that point_origin names. 0, 0 in lines and filled triangles. Null if the pipeline's
     * fragment_reads_point_coordinate is off. */
    const float (*point_coordinate)[GN_LANES];

    /** gl_SampleMaskIn, [lane]: bit s is set if sample s is covered and not in
     * samples.write_disabled, whether or not it passes the tests. With one sample per pixel the
     * mask is 1 in the lanes of `coverage` and 0 in the others. If the shader runs for each sample,
     * only that sample's bit can be set. Null if the pipeline's fragment_reads_sample_mask is
     * off. */
    const uint32_t *sample_mask;

    /** gl_SampleID: the sample that the shader runs for, in all lanes; 0 if the shader runs for
     * each pixel. */
    uint32_t sample_id;

    /** gl_SamplePosition: the place of that sample in the pixel, from the lower left corner; 0.5,
     * 0.5 if the shader runs for each pixel. */
    float sample_position[2];
} gn_fragment_input;

/** The functions of gnomon/lookup.h for fragment shaders: gn_texture_lookup, gn_texture_lookup_2d,
 * gn_texture_gather and gn_texture_fetch in the form of the back end that runs the shader, with
 * equal results. What a texture and its sampler mean is worked out at the first lookup and kept;
 * every lookup compares their members with those, so a shader may change them or make its own. A
 * texture or sampler with a fault is not read: the texels are opaque black, and gn_draw returns the
 * fault when all has been drawn. (A library with both GN_SMALL and GN_BASIC checks them only if it
 * is compiled with GN_DEBUG.) @{ */
static inline void gn_fragment_lookup(const gn_fragment_input *input, const gn_texture *texture,
                                      const gn_sampler *sampler, const gn_lookup *lookup,
                                      float texel[4][GN_LANES])
{
    input->texture_functions->lookup(input->texture_functions->memory, texture, sampler, lookup,
                                     texel);
}

static inline void gn_fragment_lookup_2d(const gn_fragment_input *input, const gn_texture *texture,
                                         const gn_sampler *sampler, const float s[GN_LANES],
                                         const float t[GN_LANES], float texel[4][GN_LANES])
{
    input->texture_functions->lookup_2d(input->texture_functions->memory, texture, sampler, s, t,
                                        texel);
}

static inline void gn_fragment_gather(const gn_fragment_input *input, const gn_texture *texture,
                                      const gn_sampler *sampler, const gn_lookup *lookup,
                                      int channel, float texel[4][GN_LANES])
{
    input->texture_functions->gather(input->texture_functions->memory, texture, sampler, lookup,
                                     channel, texel);
}

static inline void gn_fragment_fetch(const gn_fragment_input *input, const gn_texture *texture,
                                     const int32_t *const coordinate[3], const int32_t *level,
                                     float texel[4][GN_LANES])
{
    input->texture_functions->fetch(input->texture_functions->memory, texture, coordinate, level,
                                    texel);
}
/** @} */

/** Output of a fragment shader: color[4 * attachment + channel][lane], with the channels red,
 * green, blue, alpha, for as many attachments as the pipeline's color_count says, whatever the
 * target has. Every lane is 0 beforehand, which stays if the shader does not write it; with
 * fragment_writes_all_colors it may be any value beforehand. Lanes that are not covered are
 * ignored. */
typedef struct gn_fragment_output {
    float (*color)[GN_LANES];

    /** Every lane's bit is set beforehand. The shader clears the bits of fragments that it
     * discards. Ignored without fragment_discards (gn_program says why). */
    uint32_t kept;

    /** gl_FragDepth, [lane]: beforehand the interpolated depth, with the polygon offset only if the
     * vertices have it (gn_polygon_offset); it is not added later either. Afterwards clamped to
     * 0..1, or with depth.clamp_enabled to the depth range; NaN becomes the upper end. Null without
     * fragment_writes_depth. */
    float *depth;

    /** gl_SampleMask, [lane]: every bit is set beforehand. The shader clears the bits of samples
     * that it discards. If it runs for each sample, only that sample's bit counts. Ignored if a
     * pixel has one sample. Null without fragment_writes_sample_mask. */
    uint32_t *sample_mask;
} gn_fragment_output;

/**
 * Shaders are plain functions over 16 lanes. `uniforms` is the pipeline's pointer, passed through.
 * A shader may be called any number of times, on several threads at once if the workspace has
 * `parallel`, and must have no side effects.
 *
 * The library does not know the uniforms of a caller's shader. It checks a texture and a sampler
 * when a shader first looks them up, after other pixels may have been drawn. To find faults before
 * anything is drawn, check them where the shader and its uniforms are put into a pipeline:
 *
 *     gn_status use_mine(gn_pipeline *pipeline, const my_uniforms *u)
 *     {
 *         gn_status status = gn_texture_check(&u->map);
 *
 *         if (!status && u->map.target != GN_TEXTURE_2D)
 *             status = GN_INVALID_ENUM;
 *         if (!status)
 *             status = gn_sampler_check(&u->sampler);
 *         if (!status) {
 *             pipeline->program.fragment_shader = my_shader;
 *             pipeline->program.uniforms = u;
 *         }
 *         return status;
 *     }
 *
 * The gn_use_ functions of gnomon/shaders.h and the function that GN_TEXTURED_SHADERS defines do
 * this by themselves. @{ */
typedef void gn_vertex_shader(const void *uniforms, const gn_vertex_input *input,
                              gn_vertex_output *output);
typedef void gn_fragment_shader(const void *uniforms, const gn_fragment_input *input,
                                gn_fragment_output *output);
/** @} */

struct gn_program;

/**
 * Returns whether fragments of a program need their neighbours: a shader takes derivatives, or
 * looks up a texture with a sampler for which gn_lookup_needs_quads is true. If they do not, a
 * library with GN_HAVE_ONE_LANE (gnomon/lanes.h) runs both shaders for one vertex and one fragment
 * at a time. Then the input's `count` is 1, a fragment is at (x[0], y[0]), and the other lanes have
 * no values and are not used. So shaders for such a library compute the lanes 0 to count - 1. A
 * lookup that needs neighbours all the same gives opaque black, and gn_draw returns
 * GN_NOT_COMPILED.
 *
 * gn_draw calls the function once a draw, in such a library alone. It must return true for a
 * program with other shaders than those it was written for: a caller may put a shader of its own
 * into a pipeline. */
typedef bool gn_needs_quads(const struct gn_program *program);

/**
 * The shaders, and what they read and write beyond varyings and colours. A fragment shader runs
 * before the depth and stencil tests if it discards, writes depth or a sample mask, or if
 * samples.alpha_to_coverage_enabled is on. Otherwise it runs after them, on the fragments that
 * passed. On targets with one sample a pixel, sample masks and alpha to coverage make no
 * difference.
 *
 * The flags from vertex_writes_point_size on are the caller's promise about the shaders. A draw
 * prepares and looks at only what they name, which is what makes the others fast, and one shader
 * may serve pipelines with different flags. gn_pipeline_check cannot compare them with the shaders:
 * a shader is a pointer to a function, running it on made-up input would read the caller's uniforms
 * and show only the branches that this input takes, and a look at `kept` after each call would cost
 * every draw. A shader that uses what its flag does not name finds:
 *
 *     flag that is off                 a loop over lanes        a function (shader_functions.h)
 *     vertex_writes_point_size         a null pointer           0; what it writes is ignored
 *     fragment_reads_position          a null pointer           0, 0, 0, 0
 *     fragment_reads_primitive         0                        0
 *     fragment_reads_point_coordinate  a null pointer           0, 0
 *     fragment_reads_sample_mask       a null pointer           0
 *     fragment_reads_sample            sample 0 at 0.5, 0.5,    sample 0 at 0.5, 0.5,
 *                                      once a pixel             once a pixel
 *     fragment_discards                what it clears in        what it sets is ignored
 *                                      `kept` is ignored
 *     fragment_writes_depth            a null pointer           0; what it writes is ignored
 *     fragment_writes_sample_mask      a null pointer           what it writes is ignored
 *
 * (A program with GN_AT_SAMPLE varyings, or a pipeline with samples.shading_enabled, runs the
 * shader for each sample whether it reads the sample or not.) If pixels that should be discarded
 * are drawn, fragment_discards is off. A flag that no shader needs costs time; what else it changes
 * stands at gn_fragment_output for depths, at gn_samples for samples. */
typedef struct gn_program {
    gn_vertex_shader *vertex_shader;     /**< never null in a draw */
    gn_fragment_shader *fragment_shader; /**< may be null if the target has no colour */
    const void *uniforms;                /**< passed to both shaders */
    /** Null: fragments need their neighbours. The functions that gnomon/shaders.h declares and
     * GN_SHADERS defines set it, with GN_HAVE_ONE_LANE. */
    gn_needs_quads *needs_quads;
    uint32_t varying_count;                                  /**< scalars, 0 to GN_MAX_VARYINGS */
    gn_interpolation interpolation[GN_MAX_VARYINGS];         /**< of each varying */
    gn_interpolation_point interpolated_at[GN_MAX_VARYINGS]; /**< where in the pixel, of each */
    uint32_t color_count; /**< how many colours the fragment shader writes, 0 meaning 1; attachments
                               from color_count on stay as they are */
    uint32_t clip_distance_count; /**< 0 to GN_MAX_CLIP_DISTANCES */
    /** Null: where an edge is clipped, its clip distances are linear, as those of gl_ClipDistance.
     * Otherwise clip_distance_count planes [x, y, z, w] in clip space: there, a distance is the sum
     * ((p.x * x + p.y * y) + p.z * z) + p.w * w of the plane p and the position, as those of
     * OpenGL's glClipPlane. The vertex shader writes such distances too. Both differ by rounding,
     * and only where a triangle meets several planes. */
    const float (*clip_plane)[4];
    bool vertex_writes_point_size; /**< points have the size that the vertex shader writes */
    bool fragment_reads_position;
    bool fragment_reads_primitive;
    bool fragment_reads_point_coordinate;
    bool fragment_reads_sample_mask;
    bool fragment_reads_sample; /**< the fragment shader runs for each sample (gn_samples) */
    bool fragment_discards;
    /** The fragment shader writes every covered lane of every colour. The first colour is not set
     * to 0 beforehand, so that small shaders are up to a fifth faster. No effect on ready-made
     * shaders. */
    bool fragment_writes_all_colors;
    bool fragment_writes_depth;
    bool fragment_writes_sample_mask; /**< no effect if a pixel has one sample */
} gn_program;

#endif
