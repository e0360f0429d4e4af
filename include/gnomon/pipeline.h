/** @file
 * The pipeline: the shaders of a draw and the state that it runs under. A zeroed gn_pipeline is
 * OpenGL's initial state without shaders. Set program.vertex_shader and, for targets with colour,
 * program.fragment_shader before drawing.
 *
 *     field                            OpenGL                         zero value
 *     program                          the program in use
 *       .vertex_shader                                                none, which is a fault
 *       .fragment_shader                                              none, a fault with colour
 *       .uniforms                      Uniform...                     null
 *       .varying_count                 outs of the vertex shader      0
 *       .interpolation[n]              smooth, noperspective, flat    GN_SMOOTH
 *       .interpolated_at[n]            centroid, sample               GN_AT_CENTER
 *       .color_count                   outs of the fragment shader,   0, which means 1
 *                                      DrawBuffers
 *       .clip_distance_count           CLIP_DISTANCEi for i below it  0
 *       .clip_plane                    CLIP_PLANEi for i below it     null: distances are linear
 *       .vertex_writes_point_size      PROGRAM_POINT_SIZE             off: raster.point_size
 *       .fragment_reads_position       use of gl_FragCoord            not given to the shader
 *       .fragment_reads_primitive      use of gl_PrimitiveID          not given to the shader
 *       .fragment_reads_point_coordinate use of gl_PointCoord         not given to the shader
 *       .fragment_reads_sample_mask    use of gl_SampleMaskIn         not given to the shader
 *       .fragment_reads_sample         use of gl_SampleID,            the shader runs once a pixel
 *                                      gl_SamplePosition
 *       .fragment_discards             discard                        the shader discards nothing
 *       .fragment_writes_all_colors                                   unwritten colours are 0
 *       .fragment_writes_depth         gl_FragDepth                   interpolated depth
 *       .fragment_writes_sample_mask   gl_SampleMask                  the samples covered
 *     raster
 *       .topology                      mode of DrawArrays             GN_TRIANGLES
 *       .provoking_vertex              ProvokingVertex                GN_PROVOKING_LAST
 *       .cull                          CULL_FACE with CullFace        GN_CULL_NONE
 *       .front_face                    FrontFace                      GN_FRONT_COUNTER_CLOCKWISE
 *       .polygon_mode_front, _back     PolygonMode                    GN_POLYGON_FILL
 *       .polygon_offset                POLYGON_OFFSET_FILL, _LINE,    off
 *                                      _POINT, PolygonOffsetClamp
 *       .viewport                      Viewport                       the whole target
 *       .scissor                       SCISSOR_TEST with Scissor      off
 *       .point_size                    PointSize                      0, which means 1
 *       .point_origin                  POINT_SPRITE_COORD_ORIGIN      GN_POINT_UPPER_LEFT
 *       .line_width                    LineWidth                      0, which means 1
 *     depth
 *       .test_enabled                  DEPTH_TEST                     off
 *       .function                      DepthFunc                      GN_COMPARE_DEFAULT: GN_LESS
 *       .write_disabled                not DepthMask                  depth is written
 *       .clamp_enabled                 DEPTH_CLAMP                    off
 *       .clip_depth                    ClipControl's depth            GN_NEGATIVE_ONE_TO_ONE
 *       .range                         DepthRange                     0 to 1
 *     stencil
 *       .test_enabled                  STENCIL_TEST                   off
 *       .front, .back                  StencilFuncSeparate,           GN_COMPARE_DEFAULT, which is
 *                                      ..OpSeparate, ..MaskSeparate:  GN_ALWAYS; reference 0, all
 *                                      FRONT and BACK                 bits; GN_STENCIL_KEEP
 *     color
 *       .write_disabled[i]             not ColorMaski                 every channel is written
 *       .blend[i].enabled              Enablei of BLEND               off
 *       .blend[i]'s factors            BlendFunci, ..Separatei        source one, destination zero
 *       .blend[i]'s equations          BlendEquationi, ..Separatei    GN_EQUATION_ADD
 *       .blend_constant                BlendColor                     0, 0, 0, 0
 *       .logic_enabled                 COLOR_LOGIC_OP                 off
 *       .logic_operation               LogicOp                        GN_LOGIC_COPY
 *     samples
 *       .write_disabled                SAMPLE_MASK, not SampleMaski   every sample is drawn
 *       .alpha_to_coverage_enabled     SAMPLE_ALPHA_TO_COVERAGE       off
 *       .alpha_to_one_enabled          SAMPLE_ALPHA_TO_ONE            off
 *       .shading_enabled               SAMPLE_SHADING                 off
 *       .least_shading                 MinSampleShading               0
 *
 * Switches. A bool named `enabled` turns on the struct that it stands in, and one named `X_enabled`
 * turns on X; while it is false, the values that belong to it are ignored. What OpenGL has on at
 * first is negated, since zero is the default: a bool or a mask named `X_disabled`, whose set bits
 * are not written or not compared. Members of the program say what the shaders do instead:
 * `fragment_reads_...`, `fragment_writes_...`.
 *
 * As in OpenGL, depth is written only if the depth test is on, and stencil only if the stencil test
 * is on. If the target has no depth, the depth test passes; if it has no stencil, the stencil test
 * passes.
 *
 * Reversed depth, which keeps precision far away: take a projection _zo_reversed or
 * _zo_infinite_reversed, set depth.clip_depth to GN_ZERO_TO_ONE and depth.function to GN_GREATER,
 * clear depth to 0, and use GN_FORMAT_D32F. (With a projection _no_reversed leave clip_depth as it
 * is; precision is not gained then.) */
#ifndef GNOMON_PIPELINE_H
#define GNOMON_PIPELINE_H

#include <stdbool.h>

#include "compare.h"
#include "program.h"
#include "surface.h"

/** Vertices form primitives as in OpenGL (4.5 section 10.1). Triangle i of a strip is (i, i+1, i+2)
 * for even i and (i+1, i, i+2) for odd i. Triangle i of a fan is (0, i+1, i+2). Line i of a strip
 * or a loop is (i, i+1), and the last line of a loop goes from the last vertex to the first. */
typedef enum gn_topology {
    GN_TRIANGLES = 0,  /**< three vertices each */
    GN_TRIANGLE_STRIP, /**< each vertex after the second makes one with the two before it */
    GN_TRIANGLE_FAN,   /**< each vertex after the second makes one with the first and that before
                            it */
    GN_POINTS,         /**< one vertex each */
    GN_LINES,          /**< two vertices each */
    GN_LINE_STRIP,     /**< from each vertex to the next */
    GN_LINE_LOOP       /**< from each vertex to the next, and from the last to the first */
} gn_topology;

/** The largest size of a point and width of a line, in pixels. Larger values are drawn as these,
 * and values below 1 as 1. A point's size is rounded to 1/256 pixel. If a pixel has one sample, a
 * line's width is rounded to whole pixels, halves to even. If it has several, the width is not
 * rounded: the line is a rectangle of that width, whose sides run along and across it. @{ */
#define GN_MAX_POINT_SIZE 256
#define GN_MAX_LINE_WIDTH 255
/** @} */

/** The vertex of a primitive whose value GN_FLAT varyings have: the last (GN_PROVOKING_LAST) or the
 * first (GN_PROVOKING_FIRST). */
typedef enum gn_provoking_vertex { GN_PROVOKING_LAST = 0, GN_PROVOKING_FIRST } gn_provoking_vertex;

/** Which triangles are not drawn, by the way they face. */
typedef enum gn_cull {
    GN_CULL_NONE = 0,      /**< all are drawn */
    GN_CULL_BACK,          /**< back faces are not drawn */
    GN_CULL_FRONT,         /**< front faces are not drawn */
    GN_CULL_FRONT_AND_BACK /**< no triangle is drawn; points and lines are */
} gn_cull;

/** The winding of front faces in y-up window coordinates, GN_FRONT_COUNTER_CLOCKWISE or
 * GN_FRONT_CLOCKWISE. */
typedef enum gn_front_face { GN_FRONT_COUNTER_CLOCKWISE = 0, GN_FRONT_CLOCKWISE } gn_front_face;

/** How triangles are drawn. */
typedef enum gn_polygon_mode {
    GN_POLYGON_FILL = 0, /**< whole */
    GN_POLYGON_LINE,     /**< their edges, as lines */
    GN_POLYGON_POINT     /**< their vertices, as points */
} gn_polygon_mode;

/** Channels of a colour, as bits: GN_CHANNEL_RED, GN_CHANNEL_GREEN, GN_CHANNEL_BLUE and
 * GN_CHANNEL_ALPHA; GN_CHANNEL_ALL is all four. */
typedef enum gn_channel {
    GN_CHANNEL_RED = 1,
    GN_CHANNEL_GREEN = 2,
    GN_CHANNEL_BLUE = 4,
    GN_CHANNEL_ALPHA = 8,
    GN_CHANNEL_ALL = 15
} gn_channel;

/** The factor that blending multiplies a colour by (OpenGL 4.5 table 17.2). */
typedef enum gn_blend_factor {
    GN_FACTOR_DEFAULT = 0,  /**< source: one; destination: zero; for alpha: the colour's factor */
    GN_FACTOR_ZERO,         /**< 0 */
    GN_FACTOR_ONE,          /**< 1 */
    GN_FACTOR_SOURCE_COLOR, /**< the source's colour */
    GN_FACTOR_ONE_MINUS_SOURCE_COLOR,      /**< 1 - the source's colour */
    GN_FACTOR_DESTINATION_COLOR,           /**< the destination's colour */
    GN_FACTOR_ONE_MINUS_DESTINATION_COLOR, /**< 1 - the destination's colour */
    GN_FACTOR_SOURCE_ALPHA,                /**< the source's alpha */
    GN_FACTOR_ONE_MINUS_SOURCE_ALPHA,      /**< 1 - the source's alpha */
    GN_FACTOR_DESTINATION_ALPHA,           /**< the destination's alpha */
    GN_FACTOR_ONE_MINUS_DESTINATION_ALPHA, /**< 1 - the destination's alpha */
    GN_FACTOR_CONSTANT_COLOR,              /**< blend_constant */
    GN_FACTOR_ONE_MINUS_CONSTANT_COLOR,    /**< 1 - blend_constant */
    GN_FACTOR_CONSTANT_ALPHA,              /**< blend_constant's alpha */
    GN_FACTOR_ONE_MINUS_CONSTANT_ALPHA,    /**< 1 - blend_constant's alpha */
    GN_FACTOR_SOURCE_ALPHA_SATURATE /**< min(source alpha, 1 - destination alpha); for alpha: one;
                                       in formats of red, green and blue alone: zero */
} gn_blend_factor;

/** How source and destination, each times its factor, are combined (table 17.1). */
typedef enum gn_blend_equation {
    GN_EQUATION_DEFAULT = 0,      /**< GN_EQUATION_ADD; for alpha: the colour's equation */
    GN_EQUATION_ADD,              /**< source + destination */
    GN_EQUATION_SUBTRACT,         /**< source - destination */
    GN_EQUATION_REVERSE_SUBTRACT, /**< destination - source */
    GN_EQUATION_MIN,              /**< the lesser of the two colours, without factors */
    GN_EQUATION_MAX               /**< the greater of the two colours, without factors */
} gn_blend_equation;

/** Blends a fragment's colour, the source, with the surface's colour, the destination. For alpha,
 * each of the three alpha members applies unless it is 0, which means the colour's. In formats of
 * fractions the source and the constant are first converted to 8 or 16 bits per channel, and
 * results saturate. GN_FORMAT_SRGB8_A8 is blended as linear floats within 0 to 1. If the surface
 * has no alpha, the destination's alpha is one. */
typedef struct gn_blend {
    bool enabled; /**< false: nothing is blended; the enumerations must be valid all the same */
    gn_blend_equation equation;                      /**< how source and destination are combined */
    gn_blend_factor source, destination;             /**< what each is multiplied by first */
    gn_blend_equation alpha_equation;                /**< `equation` for alpha */
    gn_blend_factor alpha_source, alpha_destination; /**< `source` and `destination` for alpha */
} gn_blend;

/** How the bits s of a fragment's colour and d of the surface's colour are combined (OpenGL 4.5
 * section 17.3.9). */
typedef enum gn_logic_operation {
    GN_LOGIC_COPY = 0,      /**< s */
    GN_LOGIC_CLEAR,         /**< 0 */
    GN_LOGIC_AND,           /**< s & d */
    GN_LOGIC_AND_REVERSE,   /**< s & ~d */
    GN_LOGIC_AND_INVERTED,  /**< ~s & d */
    GN_LOGIC_NOOP,          /**< d */
    GN_LOGIC_XOR,           /**< s ^ d */
    GN_LOGIC_OR,            /**< s | d */
    GN_LOGIC_NOR,           /**< ~(s | d) */
    GN_LOGIC_EQUIVALENT,    /**< ~(s ^ d) */
    GN_LOGIC_INVERT,        /**< ~d */
    GN_LOGIC_OR_REVERSE,    /**< s | ~d */
    GN_LOGIC_COPY_INVERTED, /**< ~s */
    GN_LOGIC_OR_INVERTED,   /**< ~s | d */
    GN_LOGIC_NAND,          /**< ~(s & d) */
    GN_LOGIC_SET            /**< all ones */
} gn_logic_operation;

/** What becomes of the stored stencil (OpenGL 4.5 section 17.3.3). */
typedef enum gn_stencil_operation {
    GN_STENCIL_KEEP = 0,       /**< it stays */
    GN_STENCIL_ZERO,           /**< it becomes 0 */
    GN_STENCIL_REPLACE,        /**< it becomes the reference */
    GN_STENCIL_INCREMENT,      /**< plus 1, up to 255 */
    GN_STENCIL_DECREMENT,      /**< minus 1, down to 0 */
    GN_STENCIL_INVERT,         /**< every bit changes */
    GN_STENCIL_INCREMENT_WRAP, /**< plus 1, from 255 to 0 */
    GN_STENCIL_DECREMENT_WRAP  /**< minus 1, from 0 to 255 */
} gn_stencil_operation;

/** The stencil test and its operations, for front faces or for back faces. */
typedef struct gn_stencil_face {
    gn_compare function;       /**< passes where `reference FUNCTION stored stencil` holds */
    uint8_t reference;         /**< what the stored stencil is compared with, and replaced by */
    uint8_t compare_disabled;  /**< bits ignored on both sides of the test: ~ of StencilFunc's
                                    mask */
    uint8_t write_disabled;    /**< bits that keep their values: ~ of StencilMask */
    gn_stencil_operation fail; /**< applied where the stencil test fails */
    gn_stencil_operation depth_fail; /**< where the stencil test passes and the depth test fails */
    gn_stencil_operation pass;       /**< where both tests pass */
} gn_stencil_face;

/** The place of the view volume in the window: x to x + width, y to y + height. With a negative
 * height, y of clip space points to lower rows: what is drawn is mirrored, so that triangles face
 * the other way (raster.front_face), and pixels on a horizontal edge belong to the triangle whose
 * top edge it is. */
typedef struct gn_viewport {
    bool enabled; /**< false: the whole target, and the other fields are ignored */
    float x, y;
    float width, height;
} gn_viewport;

/** Only pixels x to x + width - 1, y to y + height - 1 are drawn. If the rectangle is empty or
 * beside the target, nothing is drawn. All values are valid. */
typedef struct gn_scissor {
    bool enabled; /**< false: the whole target, and the other fields are ignored */
    int32_t x, y;
    uint32_t width, height;
} gn_scissor;

/** z_near may be above z_far: a reversed range. */
typedef struct gn_depth_range {
    bool enabled; /**< false: 0 to 1 */
    float z_near; /**< window depth of NDC z = -1, or of 0 with GN_ZERO_TO_ONE; in 0..1 */
    float z_far;  /**< window depth of NDC z = 1; in 0..1 */
} gn_depth_range;

/** The z in clip space that are drawn and mapped to the depth range: -w <= z <= w
 * (GN_NEGATIVE_ONE_TO_ONE) or 0 <= z <= w (GN_ZERO_TO_ONE). */
typedef enum gn_clip_depth { GN_NEGATIVE_ONE_TO_ONE = 0, GN_ZERO_TO_ONE } gn_clip_depth;

/** Adds slope * factor + step * units to the depth of a triangle's fragments. slope is the greater
 * of |dz/dx| and |dz/dy|. step is 2 / (2^n - 1) for a format of n bits; for floats (D32F, D32FS8)
 * it is 2^(e - 23), where e is the exponent of the triangle's largest |depth|. In a target without
 * depth it is 1, which only a fragment's position[2] shows. If polygon_mode_front or _back is not
 * GN_POLYGON_FILL, all triangles get the offset in the depths of their vertices, which are then
 * clamped to 0..1. Lines and points of line and point topologies get none. */
typedef struct gn_polygon_offset {
    bool enabled; /**< false: nothing is added, and the other fields are ignored */
    float factor;
    float units;
    float clamp; /**< above 0: the most that is added; below 0: the least */
} gn_polygon_offset;

/** The corner of a point's square where gl_PointCoord is 0, 0: GN_POINT_UPPER_LEFT or
 * GN_POINT_LOWER_LEFT. */
typedef enum gn_point_origin { GN_POINT_UPPER_LEFT = 0, GN_POINT_LOWER_LEFT } gn_point_origin;

/** Which primitives the vertices form, and which pixels the primitives cover. */
typedef struct gn_raster {
    gn_topology topology;
    gn_provoking_vertex provoking_vertex;
    gn_cull cull;
    gn_front_face front_face;
    gn_polygon_mode polygon_mode_front; /**< of front faces */
    gn_polygon_mode polygon_mode_back;  /**< of back faces */
    gn_polygon_offset polygon_offset;
    gn_viewport viewport;
    gn_scissor scissor;
    float point_size; /**< in pixels; 0 means 1; see GN_MAX_POINT_SIZE */
    gn_point_origin point_origin;
    float line_width; /**< in pixels; 0 means 1; see GN_MAX_LINE_WIDTH */
} gn_raster;

/** The depth test, the bounds of z and the depths of the window. */
typedef struct gn_depth {
    bool test_enabled;
    gn_compare function; /**< passes where `incoming depth FUNCTION stored depth` holds */
    bool write_disabled;
    bool clamp_enabled; /**< depth clips nothing; instead, fragments' depths are clamped to the
                           range */
    gn_clip_depth clip_depth;
    gn_depth_range range;
} gn_depth;

/** The stencil test. */
typedef struct gn_stencil {
    bool test_enabled;
    gn_stencil_face front, back;
} gn_stencil;

/** What happens to the colours that the fragment shader writes, for each attachment. */
typedef struct gn_color {
    uint32_t write_disabled[GN_MAX_COLORS]; /**< GN_CHANNEL_RED and so on, or'ed */
    gn_blend blend[GN_MAX_COLORS];
    float blend_constant[4]; /**< red, green, blue, alpha */

    /** If `logic_enabled` is set, nothing is blended, and formats of floats and sRGB store the
     * colour as it is. */
    bool logic_enabled;
    gn_logic_operation logic_operation;
} gn_color;

/** No effect on targets with one sample per pixel. Alpha is the alpha of the shader's first
 * colour.
 *
 * The fragment shader runs once for each pixel that is drawn, or once for each sample of it. It
 * runs for each sample if the program reads the sample, or a varying is GN_AT_SAMPLE, or
 * `shading_enabled` is set and least_shading is above 1 / GN_SAMPLES. (OpenGL asks for at least
 * that fraction of the samples; all of them are shaded.) In the last case all varyings and the
 * point coordinate have the values of the sample's place, whatever their `interpolated_at` is. In
 * the other cases only varyings GN_AT_SAMPLE have those values. In lines and points the values are
 * those of the place half a pixel to the upper right.
 *
 * A shader that runs for each sample decides on that sample alone: its colours, its discard, its
 * depth and its sample mask are the sample's. The depth that it finds in its output is the depth
 * at the sample. Its alpha decides on that sample alone in alpha to coverage, too. */
typedef struct gn_samples {
    uint32_t write_disabled;        /**< bit s: nothing is drawn to sample s */
    bool alpha_to_coverage_enabled; /**< draws sample s unless alpha <= s / 4.0; the fragment shader
                                 then runs before the tests */
    bool alpha_to_one_enabled;      /**< then sets alpha to 1 */
    bool shading_enabled; /**< asks for the fraction least_shading of samples to be shaded */
    float least_shading;  /**< 0 to 1; ignored unless `shading_enabled` is set */
} gn_samples;

/** The shaders of a draw and the state that it runs under. */
typedef struct gn_pipeline {
    gn_program program;
    gn_raster raster;
    gn_depth depth;
    gn_stencil stencil;
    gn_color color;
    gn_samples samples;
} gn_pipeline;

GN_BEGIN

/** Returns the first fault of a pipeline, or GN_OK if gn_draw accepts it. `target` is the target to
 * draw to; null leaves out the fault that depends on it. In the order of the checks:
 * - GN_NULL_POINTER: the pipeline.
 * - GN_NO_SHADER: no vertex shader; no fragment shader, but the target has colour, or the program
 *   discards or writes depth or a sample mask.
 * - GN_TOO_MANY_VARYINGS: program.varying_count.
 * - GN_INVALID_ENUM: the interpolation or interpolated_at of a varying.
 * - GN_INVALID_ENUM: raster.topology, provoking_vertex, cull or front_face.
 * - GN_NOT_FINITE or GN_INVALID_VIEWPORT: a number of the viewport that is not finite, a width
 *   below 0 or above GN_MAX_SIZE, a height or an origin beyond +-GN_MAX_SIZE. A size of 0 is
 *   valid; no filled triangle is then drawn.
 * - GN_NOT_FINITE or GN_OUT_OF_RANGE: an end of depth.range that is not in 0 to 1.
 * - GN_NOT_FINITE: a number of the polygon offset.
 * - GN_INVALID_ENUM: depth.clip_depth.
 * - GN_OUT_OF_RANGE: program.clip_distance_count above GN_MAX_CLIP_DISTANCES.
 * - GN_INVALID_ENUM: a comparison or operation of depth or stencil.
 * - GN_OUT_OF_RANGE: program.color_count above GN_MAX_COLORS.
 * - GN_OUT_OF_RANGE: color.write_disabled[i] has bits beyond GN_CHANNEL_ALL. GN_INVALID_ENUM or
 *   GN_NOT_FINITE: color.blend[i]; the constant is looked at only where blend[i] is enabled.
 * - GN_INVALID_ENUM: color.logic_operation.
 * - GN_OUT_OF_RANGE: samples.write_disabled has bits beyond GN_SAMPLES.
 * - GN_NOT_FINITE or GN_OUT_OF_RANGE: with samples.shading_enabled, a least_shading not in 0 to 1.
 * - GN_NOT_FINITE or GN_OUT_OF_RANGE: a point size or line width that is not finite or below 0.
 * - GN_INVALID_ENUM: raster.point_origin, a polygon mode.
 * - For the ready-made shaders of gnomon/shaders.h: GN_NULL_POINTER (null uniforms that they read),
 *   GN_OUT_OF_RANGE (program.fragment_reads_position is off, but the shader reads it;
 *   program.varying_count is below what the shaders and their maps use). A library compiled with
 *   GN_SMALL does not find these three.
 * - GN_NOT_COMPILED: a feature that a GN_BASIC library lacks. The numbers and values of features
 *   that it lacks are not looked at. */
GN_API gn_status gn_pipeline_check(const gn_pipeline *pipeline, const gn_target *target);

GN_END

#endif
