/* The pipeline: the shaders of a draw and the state that it runs under. A zeroed gn_pipeline is
 * OpenGL's initial state without shaders. Set program.vertex_shader and, for targets with colour,
 * program.fragment_shader before drawing.
 *
 *   field                            OpenGL                           zero value
 *   program                          the program in use
 *     .vertex_shader                                                  none, which is a fault
 *     .fragment_shader                                                none: no colour is written
 *     .uniforms                      Uniform...                       null
 *     .varying_count                 outs of the vertex shader        0
 *     .interpolation[n]              smooth, noperspective, flat      GN_SMOOTH
 *     .color_count                   outs of the fragment shader,     0, which means 1
 *                                    DrawBuffers
 *     .clip_distance_count           CLIP_DISTANCEi for i below it    0
 *     .vertex_writes_point_size      PROGRAM_POINT_SIZE               off: raster.point_size
 *     .fragment_reads_position       use of gl_FragCoord              not given to the shader
 *     .fragment_reads_primitive      use of gl_PrimitiveID            not given to the shader
 *     .fragment_reads_point_coordinate use of gl_PointCoord           not given to the shader
 *     .fragment_reads_sample_mask    use of gl_SampleMaskIn           not given to the shader
 *     .fragment_discards             discard                          the shader discards nothing
 *     .fragment_writes_depth         gl_FragDepth                     interpolated depth
 *     .fragment_writes_sample_mask   gl_SampleMask                    the samples covered
 *   raster
 *     .topology                      mode of DrawArrays               GN_TRIANGLES
 *     .provoking_vertex              ProvokingVertex                  GN_PROVOKING_LAST
 *     .cull                          CULL_FACE with CullFace          GN_CULL_NONE
 *     .front_face                    FrontFace                        GN_FRONT_COUNTER_CLOCKWISE
 *     .polygon_mode_front, _back     PolygonMode                      GN_POLYGON_FILL
 *     .polygon_offset                POLYGON_OFFSET_FILL, _LINE,      off
 *                                    _POINT, PolygonOffsetClamp
 *     .viewport                      Viewport                         the whole target
 *     .scissor                       SCISSOR_TEST with Scissor        off
 *     .point_size                    PointSize                        0, which means 1
 *     .point_origin                  POINT_SPRITE_COORD_ORIGIN        GN_POINT_UPPER_LEFT
 *     .line_width                    LineWidth                        0, which means 1
 *   depth
 *     .test                          DEPTH_TEST                       off
 *     .function                      DepthFunc                        GN_COMPARE_DEFAULT: GN_LESS
 *     .write_disabled                not DepthMask                    depth is written
 *     .clamp                         DEPTH_CLAMP                      off
 *     .clip_depth                    ClipControl's depth              GN_NEGATIVE_ONE_TO_ONE
 *     .range                         DepthRange                       0 to 1
 *   stencil
 *     .test                          STENCIL_TEST                     off
 *     .front, .back                  StencilFuncSeparate and the      GN_COMPARE_DEFAULT, which is
 *                                    like, FRONT and BACK             GN_ALWAYS; reference 0, all
 *                                                                     bits; GN_STENCIL_KEEP
 *   color
 *     .write_disabled[i]             not ColorMaski                   every channel is written
 *     .blend[i].enabled              Enablei of BLEND                 off
 *     .blend[i]'s factors            BlendFunci, ..Separatei          source one, destination zero
 *     .blend[i]'s equations          BlendEquationi, ..Separatei      GN_EQUATION_ADD
 *     .blend_constant                BlendColor                       0, 0, 0, 0
 *     .logic                         COLOR_LOGIC_OP                   off
 *     .logic_operation               LogicOp                          GN_LOGIC_COPY
 *   samples
 *     .write_disabled                SAMPLE_MASK, not SampleMaski     every sample is drawn
 *     .alpha_to_coverage             SAMPLE_ALPHA_TO_COVERAGE         off
 *     .alpha_to_one                  SAMPLE_ALPHA_TO_ONE              off
 *
 * What OpenGL writes at first is negated here, since zero is the default: every such field ends in
 * `_disabled`, and its set bits are not written or not compared.
 *
 * As in OpenGL, depth is written only where the depth test is on, and stencil only where the
 * stencil test is on. A test passes where the target lacks what it tests. */
#ifndef GNOMON_PIPELINE_H
#define GNOMON_PIPELINE_H

#include <stdbool.h>

#include "compare.h"
#include "sampling.h"
#include "surface.h"

/* Scalar varyings a vertex shader may hand to the fragment shader. */
#define GN_MAX_VARYINGS 32

/* Distances to planes of the user's that a vertex shader may write. */
#define GN_MAX_CLIP_DISTANCES 8

/* Vertex attributes of up to four components each. */
#define GN_MAX_ATTRIBUTES 8

/* Triangles are listed as OpenGL lists them (4.5 section 10.1): triangle i of a
 * strip is (i, i+1, i+2) for even i and (i+1, i, i+2) for odd i, of a fan
 * (0, i+1, i+2). Line i of a strip is (i, i+1), of a loop too, and the loop's last line goes
 * from the last vertex to the first. */
typedef enum gn_topology {
    GN_TRIANGLES = 0,
    GN_TRIANGLE_STRIP,
    GN_TRIANGLE_FAN,
    GN_POINTS,
    GN_LINES,
    GN_LINE_STRIP,
    GN_LINE_LOOP
} gn_topology;

/* The greatest size of a point and width of a line, in pixels. Greater ones are drawn at
 * it, lesser ones than 1 at 1. A point's size is rounded to 1/256 pixel. A line's width is rounded
 * to whole pixels, halves up, where a pixel has one sample. Among several samples it is not
 * rounded: the line is a rectangle of that width, whose sides run along and across it. */
#define GN_MAX_POINT_SIZE 255
#define GN_MAX_LINE_WIDTH 255

typedef enum gn_provoking_vertex { GN_PROVOKING_LAST = 0, GN_PROVOKING_FIRST } gn_provoking_vertex;

typedef enum gn_cull {
    GN_CULL_NONE = 0,
    GN_CULL_BACK,
    GN_CULL_FRONT,
    GN_CULL_FRONT_AND_BACK
} gn_cull;

/* The winding of front faces in y-up window coordinates. */
typedef enum gn_front_face { GN_FRONT_COUNTER_CLOCKWISE = 0, GN_FRONT_CLOCKWISE } gn_front_face;

/* How triangles are drawn: whole, their edges, or their vertices. */
typedef enum gn_polygon_mode {
    GN_POLYGON_FILL = 0,
    GN_POLYGON_LINE,
    GN_POLYGON_POINT
} gn_polygon_mode;

/* Channels of a colour, as bits. */
typedef enum gn_channel {
    GN_CHANNEL_RED = 1,
    GN_CHANNEL_GREEN = 2,
    GN_CHANNEL_BLUE = 4,
    GN_CHANNEL_ALPHA = 8,
    GN_CHANNEL_ALL = 15
} gn_channel;

/* What a colour is multiplied by in blending (OpenGL 4.5 table 17.2). */
typedef enum gn_blend_factor {
    GN_FACTOR_DEFAULT = 0, /* the source's: one; the destination's: zero; of alpha: the colour's */
    GN_FACTOR_ZERO,
    GN_FACTOR_ONE,
    GN_FACTOR_SOURCE_COLOR,
    GN_FACTOR_ONE_MINUS_SOURCE_COLOR,
    GN_FACTOR_DESTINATION_COLOR,
    GN_FACTOR_ONE_MINUS_DESTINATION_COLOR,
    GN_FACTOR_SOURCE_ALPHA,
    GN_FACTOR_ONE_MINUS_SOURCE_ALPHA,
    GN_FACTOR_DESTINATION_ALPHA,
    GN_FACTOR_ONE_MINUS_DESTINATION_ALPHA,
    GN_FACTOR_CONSTANT_COLOR,
    GN_FACTOR_ONE_MINUS_CONSTANT_COLOR,
    GN_FACTOR_CONSTANT_ALPHA,
    GN_FACTOR_ONE_MINUS_CONSTANT_ALPHA,
    GN_FACTOR_SOURCE_ALPHA_SATURATE /* min(source alpha, 1 - destination alpha); of alpha: one */
} gn_blend_factor;

/* How source and destination, times their factors, become one (table 17.1). */
typedef enum gn_blend_equation {
    GN_EQUATION_DEFAULT = 0, /* GN_EQUATION_ADD; of alpha: the colour's */
    GN_EQUATION_ADD,
    GN_EQUATION_SUBTRACT,         /* source - destination */
    GN_EQUATION_REVERSE_SUBTRACT, /* destination - source */
    GN_EQUATION_MIN,              /* of the two themselves, without factors */
    GN_EQUATION_MAX
} gn_blend_equation;

/* Blending: a fragment's colour, the source, with the surface's, the destination. Alpha goes
 * by the three members of its own, where they are not zero. In formats of fractions the source and
 * the constant are converted first, to 8 bits or 16, and results saturate; GN_FORMAT_SRGB8_A8 is
 * blended as linear floats within 0 to 1. Where the surface has no alpha, its alpha is one. */
typedef struct gn_blend {
    bool enabled; /* false: the other fields do not matter */
    gn_blend_equation equation;
    gn_blend_factor source, destination;
    gn_blend_equation alpha_equation;
    gn_blend_factor alpha_source, alpha_destination;
} gn_blend;

/* What becomes of the bits s of a fragment's colour and d of the surface's (OpenGL 4.5
 * section 17.3.9). */
typedef enum gn_logic_operation {
    GN_LOGIC_COPY = 0,      /* s */
    GN_LOGIC_CLEAR,         /* 0 */
    GN_LOGIC_AND,           /* s & d */
    GN_LOGIC_AND_REVERSE,   /* s & ~d */
    GN_LOGIC_AND_INVERTED,  /* ~s & d */
    GN_LOGIC_NOOP,          /* d */
    GN_LOGIC_XOR,           /* s ^ d */
    GN_LOGIC_OR,            /* s | d */
    GN_LOGIC_NOR,           /* ~(s | d) */
    GN_LOGIC_EQUIVALENT,    /* ~(s ^ d) */
    GN_LOGIC_INVERT,        /* ~d */
    GN_LOGIC_OR_REVERSE,    /* s | ~d */
    GN_LOGIC_COPY_INVERTED, /* ~s */
    GN_LOGIC_OR_INVERTED,   /* ~s | d */
    GN_LOGIC_NAND,          /* ~(s & d) */
    GN_LOGIC_SET            /* all ones */
} gn_logic_operation;

typedef enum gn_stencil_operation {
    GN_STENCIL_KEEP = 0,
    GN_STENCIL_ZERO,
    GN_STENCIL_REPLACE,   /* by the reference */
    GN_STENCIL_INCREMENT, /* up to 255 */
    GN_STENCIL_DECREMENT, /* down to 0 */
    GN_STENCIL_INVERT,
    GN_STENCIL_INCREMENT_WRAP,
    GN_STENCIL_DECREMENT_WRAP
} gn_stencil_operation;

typedef struct gn_stencil_face {
    gn_compare function; /* passes where `reference FUNCTION stored stencil` holds */
    uint8_t reference;
    uint8_t compare_disabled;  /* bits that both sides of the test lack: not StencilFunc's mask */
    uint8_t write_disabled;    /* bits that stay as they are: not StencilMask */
    gn_stencil_operation fail; /* applied where the stencil test fails */
    gn_stencil_operation depth_fail; /* where the stencil test passes and the depth test fails */
    gn_stencil_operation pass;       /* where both tests pass */
} gn_stencil_face;

/* How a varying gets its value at a fragment (OpenGL 4.5 section 14.6.1). */
typedef enum gn_interpolation {
    GN_SMOOTH = 0,    /* perspective-correct */
    GN_NOPERSPECTIVE, /* linear in window coordinates */
    GN_FLAT           /* the provoking vertex's value */
} gn_interpolation;

typedef struct gn_viewport {
    bool set; /* false: the whole target, the other fields are not looked at */
    float x, y;
    float width, height;
} gn_viewport;

/* Only pixels x to x + width - 1, y to y + height - 1 are drawn; of an empty rectangle, or
 * one beside the target, none. All values are valid. */
typedef struct gn_scissor {
    bool set; /* false: the whole target, the other fields are not looked at */
    int32_t x, y;
    uint32_t width, height;
} gn_scissor;

/* z_near may be above z_far: a reversed range. */
typedef struct gn_depth_range {
    bool set;     /* false: 0 to 1 */
    float z_near; /* window depth of NDC z = -1, in 0..1 */
    float z_far;  /* window depth of NDC z = 1, in 0..1 */
} gn_depth_range;

/* The depths in front of the eye that are drawn and mapped to the depth range:
 * -w <= z <= w or 0 <= z <= w. */
typedef enum gn_clip_depth { GN_NEGATIVE_ONE_TO_ONE = 0, GN_ZERO_TO_ONE } gn_clip_depth;

/* Added to the depth of a triangle's fragments is slope * factor + step * units: slope is the
 * greater of |dz/dx| and |dz/dy|, step is 2 / (2^n - 1) for a format of n bits and for
 * GN_FORMAT_D32F 2^(e - 23), where e is the exponent of the triangle's largest |depth|. Triangles
 * drawn as lines or points have it too, in the depths of their vertices; other lines and points
 * have none. */
typedef struct gn_polygon_offset {
    bool set; /* false: nothing is added, the other fields are not looked at */
    float factor;
    float units;
    float clamp; /* above 0: the most that is added; below 0: the least */
} gn_polygon_offset;

/* The corner of a point where its coordinates are 0, 0. */
typedef enum gn_point_origin { GN_POINT_UPPER_LEFT = 0, GN_POINT_LOWER_LEFT } gn_point_origin;

/* Input of a vertex shader: up to 16 vertices. Lanes beyond `count` repeat
 * the last of them, so that a shader may simply run over all GN_LANES; what it
 * gives there is not used. */
typedef struct gn_vertex_input {
    const float (*attribute)[4][GN_LANES]; /* [attribute][component][lane] */
    const uint32_t *vertex_id;             /* [lane]: position in the mesh's arrays */
    uint32_t count;                        /* 1 to GN_LANES */
    uint32_t instance;                     /* from 0 on */
    uint32_t present;                      /* bit a: the mesh has attribute a */
} gn_vertex_input;

/* Output of a vertex shader; the memory is the library's. Every lane comes with a value, which
 * stays where the shader writes nothing: position 0, 0, 0, 1, varyings 0, the pipeline's point_size
 * and clip distances 0, which clip nothing. A clip distance is linear over a triangle or line; the
 * part where it is negative is clipped away. A point with a clip distance that is negative, NaN or
 * infinite is not drawn, nor is a triangle with one that is NaN or infinite. */
typedef struct gn_vertex_output {
    float (*position)[GN_LANES];      /* [x, y, z, w][lane] in clip space */
    float (*varying)[GN_LANES];       /* [varying][lane], varying_count of them */
    float *point_size;                /* [lane]; null without program.vertex_writes_point_size */
    float (*clip_distance)[GN_LANES]; /* [distance][lane], clip_distance_count of them */
} gn_vertex_output;

/* Input of a fragment shader: two halves of 4x2 fragments each, which may lie apart in their
 * primitive, lane l at pixel (x[l / 8] + l % 4, y[l / 8] + l / 4 % 2).
 *
 * Varyings hold values in every lane, also where a fragment is not covered, so that derivatives can
 * be taken in 2x2 quads. They are those of the pixel's centre (of lines among several samples, of
 * its upper right corner), also where the centre lies outside the triangle: in lanes that are not
 * covered, and where only some of several samples are. There the triangle's planes go on, so that a
 * varying may lie outside the range of its values at the vertices. A smooth varying is divided by
 * the interpolated 1/w, which may be 0 or negative beyond an edge: where it is 0, the varying is
 * infinite or NaN. GN_FLAT varyings are constant. A shader that needs a range must clamp. As a
 * colour, NaN is stored as 0 in formats of integers and as NaN in formats of floats; an infinity,
 * or a number beyond +-2^31 / 255, is stored as 0 in linear channels of up to 8 bits. In channels
 * of 16 bits and in sRGB minus infinity is 0 and plus infinity the largest value. Floats hold
 * infinities. */
typedef struct gn_fragment_input {
    const float (*varying)[GN_LANES]; /* [varying][lane] */
    uint32_t coverage;                /* bit l: lane l is covered and passed early tests */
    int32_t x[2], y[2];               /* window coordinates of lanes 0 and 8, all even */

    /* The functions of sampling.h in the form of the back end that runs the shader; the same
     * results. */
    const gn_sampling *sampling;

    bool front_facing; /* gl_FrontFacing, by front_face */

    /* gl_PrimitiveID: the primitive's number in its instance, from 0 on, through restarts. 0
     * without the pipeline's fragment_reads_primitive. */
    uint32_t primitive_id;

    /* gl_FragCoord, [x, y, z, w][lane]: the pixel's centre in window coordinates, the
     * interpolated depth with the polygon offset, before it is clamped, the interpolated 1/w. Null
     * without the pipeline's fragment_reads_position. */
    const float (*position)[GN_LANES];

    /* gl_PointCoord, [s, t][lane]: where in its point's square the pixel's centre lies, from 0
     * to 1 (a pixel's width beyond, since positions and sizes are rounded), t from the side that
     * point_origin says; 0, 0 in lines and filled triangles. Null without the pipeline's
     * fragment_reads_point_coordinate. */
    const float (*point_coordinate)[GN_LANES];

    /* gl_SampleMaskIn, [lane]: bit s: sample s is covered and not in samples.write_disabled,
     * whether or not it passes the tests. With one sample a pixel 1 in the lanes of `coverage`, 0
     * in others. Null without the pipeline's fragment_reads_sample_mask. */
    const uint32_t *sample_mask;
} gn_fragment_input;

/* Output of a fragment shader: color[4 * attachment + channel][lane], red, green, blue, alpha, of
 * as many attachments as the pipeline's color_count says, whatever the target has. Every lane comes
 * as 0, which stays where the shader writes nothing. Lanes that are not covered are not used. */
typedef struct gn_fragment_output {
    float (*color)[GN_LANES];

    /* Comes with every lane's bit set; the shader clears the bits of fragments it
     * discards. Looked at only with fragment_discards. */
    uint32_t kept;

    /* gl_FragDepth, [lane], clamped to 0..1 afterwards (with depth.clamp to the depth range), NaN
     * to the upper end, without polygon offset; comes with the interpolated depth. Null without
     * fragment_writes_depth. */
    float *depth;

    /* gl_SampleMask, [lane]; comes with every bit set; the shader clears the bits of samples that
     * it discards. Not looked at where a pixel has one sample. Null without
     * fragment_writes_sample_mask. */
    uint32_t *sample_mask;
} gn_fragment_output;

/* Shaders are plain functions over 16 lanes; `uniforms` is the pipeline's
 * pointer, handed through. They may be called any number of times, with a workspace's
 * `parallel` on several threads at once, and must have no side effects. */
typedef void gn_vertex_shader(const void *uniforms, const gn_vertex_input *input,
                              gn_vertex_output *output);
typedef void gn_fragment_shader(const void *uniforms, const gn_fragment_input *input,
                                gn_fragment_output *output);

/* The shaders, and what they read and write beyond varyings and colours. A fragment shader that
 * discards, or writes depth or a sample mask, runs before the depth and stencil tests. Any other
 * runs after them, on the fragments that passed. */
typedef struct gn_program {
    gn_vertex_shader *vertex_shader;
    gn_fragment_shader *fragment_shader; /* may be null where the target has no colour */
    const void *uniforms;                /* handed to both shaders */
    uint32_t varying_count;              /* scalars, 0 to GN_MAX_VARYINGS */
    gn_interpolation interpolation[GN_MAX_VARYINGS];
    uint32_t color_count; /* colours that the fragment shader writes, 0 meaning 1; attachments from
                             color_count on stay as they are */
    uint32_t clip_distance_count;  /* 0 to GN_MAX_CLIP_DISTANCES */
    bool vertex_writes_point_size; /* points have the size that the vertex shader writes */
    bool fragment_reads_position;
    bool fragment_reads_primitive;
    bool fragment_reads_point_coordinate;
    bool fragment_reads_sample_mask;
    bool fragment_discards;
    bool fragment_writes_depth;
    bool fragment_writes_sample_mask; /* without effect where a pixel has one sample */
} gn_program;

/* Which primitives are made of the vertices, and which pixels they cover. */
typedef struct gn_raster {
    gn_topology topology;
    gn_provoking_vertex provoking_vertex;
    gn_cull cull;
    gn_front_face front_face;
    gn_polygon_mode polygon_mode_front;
    gn_polygon_mode polygon_mode_back;
    gn_polygon_offset polygon_offset;
    gn_viewport viewport;
    gn_scissor scissor;
    float point_size; /* in pixels; 0 means 1; see GN_MAX_POINT_SIZE */
    gn_point_origin point_origin;
    float line_width; /* in pixels; 0 means 1; see GN_MAX_LINE_WIDTH */
} gn_raster;

typedef struct gn_depth {
    bool test;
    gn_compare function; /* passes where `incoming depth FUNCTION stored depth` holds */
    bool write_disabled;
    bool clamp; /* depth clips nothing; the depths of fragments are clamped to the range */
    gn_clip_depth clip_depth;
    gn_depth_range range;
} gn_depth;

typedef struct gn_stencil {
    bool test;
    gn_stencil_face front, back;
} gn_stencil;

/* What becomes of the colours that the fragment shader writes, for each attachment. */
typedef struct gn_color {
    uint32_t write_disabled[GN_MAX_COLORS]; /* GN_CHANNEL_RED and so on, or'ed */
    gn_blend blend[GN_MAX_COLORS];
    float blend_constant[4]; /* red, green, blue, alpha */

    /* Where `logic` is set, nothing is blended. In formats of floats and sRGB the colour is then
     * written as it is. */
    bool logic;
    gn_logic_operation logic_operation;
} gn_color;

/* Without effect on targets with one sample a pixel. The alpha is that of the shader's first
 * colour. */
typedef struct gn_samples {
    uint32_t write_disabled; /* bit s: nothing is drawn to sample s */
    bool alpha_to_coverage; /* draws sample s unless alpha <= s / 4; the fragment shader runs before
                               the tests then */
    bool alpha_to_one;      /* sets alpha to 1 afterwards */
} gn_samples;

typedef struct gn_pipeline {
    gn_program program;
    gn_raster raster;
    gn_depth depth;
    gn_stencil stencil;
    gn_color color;
    gn_samples samples;
} gn_pipeline;

GN_BEGIN

/* Returns the first fault of a pipeline, or GN_OK where gn_draw takes it. `target` is the target it
 * is to draw to; null leaves out the fault that depends on it. In the order of the checks:
 * - GN_NULL_POINTER: the pipeline.
 * - GN_NO_SHADER: no vertex shader; no fragment shader, but the target has colour, or the program
 *   discards or writes depth or a sample mask.
 * - GN_TOO_MANY_VARYINGS: program.varying_count. GN_INVALID_ENUM: the interpolation of a varying.
 * - GN_INVALID_ENUM: an enumeration of raster or depth.clip_depth.
 * - GN_NOT_FINITE or GN_INVALID_VIEWPORT: a number of the viewport that is not finite, a size below
 *   0 or above GN_MAX_SIZE, an origin beyond +-GN_MAX_SIZE.
 * - GN_NOT_FINITE or GN_OUT_OF_RANGE: an end of depth.range that is not in 0 to 1.
 * - GN_NOT_FINITE: a number of the polygon offset.
 * - GN_OUT_OF_RANGE: program.clip_distance_count above GN_MAX_CLIP_DISTANCES.
 * - GN_INVALID_ENUM: a comparison or operation of depth or stencil.
 * - GN_OUT_OF_RANGE: program.color_count above GN_MAX_COLORS.
 * - GN_OUT_OF_RANGE: color.write_disabled[i] has bits beyond GN_CHANNEL_ALL. GN_INVALID_ENUM or
 *   GN_NOT_FINITE: color.blend[i]; the constant is looked at only where blend[i] is enabled.
 * - GN_INVALID_ENUM: color.logic_operation.
 * - GN_OUT_OF_RANGE: samples.write_disabled has bits beyond GN_SAMPLES.
 * - GN_NOT_FINITE or GN_OUT_OF_RANGE: a point size or line width that is not finite or below 0.
 * - GN_INVALID_ENUM: raster.point_origin, a polygon mode.
 * - For the ready-made shaders of gnomon/shaders.h: GN_NULL_POINTER (null uniforms that they read),
 *   GN_OUT_OF_RANGE (program.fragment_reads_position is off, but the shader reads it;
 *   program.varying_count is below what the shaders and their maps use). A library compiled with
 *   GN_SMALL does not find these three.
 * - GN_NOT_COMPILED: a feature that a GN_BASIC library lacks. */
GN_API gn_status gn_pipeline_check(const gn_pipeline *pipeline, const gn_target *target);

/* Returns the fault that gn_pipeline_check finds, in words that name the field, such as
 * "color.blend[0].source is no gn_blend_factor", in static storage; null where there is none. */
GN_API const char *gn_pipeline_fault(const gn_pipeline *pipeline, const gn_target *target);

GN_END

#endif
