/* The pipeline: shaders and the state a draw runs under. A zeroed gn_pipeline is
 * OpenGL's initial state, short of the shaders.
 *
 *   field                OpenGL                         zero value
 *   topology             mode of DrawArrays             GN_TRIANGLES
 *   provoking_vertex     ProvokingVertex                last vertex
 *   cull                 CULL_FACE with CullFace        nothing is culled
 *   front_face           FrontFace                      counter-clockwise
 *   viewport             Viewport                       the whole target
 *   depth_range          DepthRange                     0 to 1
 *   depth_test           DEPTH_TEST                     off
 *   depth_function       DepthFunc                      GN_LESS
 *   depth_write_disabled not DepthMask                  depth is written
 *   interpolation        smooth, noperspective, flat    smooth
 *   point_size           PointSize                      1
 *   program_point_size   PROGRAM_POINT_SIZE             off
 *   line_width           LineWidth                      1
 *   polygon_mode_front   PolygonMode(FRONT)             GN_POLYGON_FILL
 *   polygon_mode_back    PolygonMode(BACK)              GN_POLYGON_FILL
 *
 * As in OpenGL, depth is written only where the depth test is on. */
#ifndef GNOMON_PIPELINE_H
#define GNOMON_PIPELINE_H

#include <stdbool.h>

#include "surface.h"
#include "texture.h"

/* Scalar varyings a vertex shader may hand to the fragment shader. */
#define GN_MAX_VARYINGS 32

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
 * it, lesser ones than 1 at 1. A line's width is rounded to whole pixels, a point's size to
 * 1/256 pixel. */
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

/* Passes where `incoming depth FUNCTION stored depth` holds. */
typedef enum gn_compare {
    GN_LESS = 0,
    GN_NEVER,
    GN_EQUAL,
    GN_LESS_OR_EQUAL,
    GN_GREATER,
    GN_NOT_EQUAL,
    GN_GREATER_OR_EQUAL,
    GN_ALWAYS
} gn_compare;

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

/* z_near may be above z_far: a reversed range. */
typedef struct gn_depth_range {
    bool set;     /* false: 0 to 1 */
    float z_near; /* window depth of NDC z = -1, in 0..1 */
    float z_far;  /* window depth of NDC z = 1, in 0..1 */
} gn_depth_range;

/* Input of a vertex shader: up to 16 vertices. Lanes beyond `count` repeat
 * the last of them, so that a shader may simply run over all GN_LANES; what it
 * gives there is not used. */
typedef struct gn_vertex_input {
    const float (*attribute)[4][GN_LANES]; /* [attribute][component][lane] */
    const uint32_t *vertex_id;             /* [lane]: position in the mesh's arrays */
    uint32_t count;                        /* 1 to GN_LANES */
} gn_vertex_input;

/* Output of a vertex shader; the memory is the library's. Every lane of the
 * position and of the pipeline's varyings must be written. */
typedef struct gn_vertex_output {
    float (*position)[GN_LANES]; /* [x, y, z, w][lane] in clip space */
    float (*varying)[GN_LANES];  /* [varying][lane] */
    float *point_size;           /* [lane], to be written too; null without program_point_size */
} gn_vertex_output;

/* Input of a fragment shader: a block of 4x4 fragments, lane l at pixel
 * (x + l % 4, y + l / 4). Varyings hold values in every lane, also where a
 * fragment is not covered, so that derivatives can be taken in 2x2 quads. */
typedef struct gn_fragment_input {
    const float (*varying)[GN_LANES]; /* [varying][lane] */
    uint32_t coverage;                /* bit l: lane l is covered and passed early tests */
    int32_t x, y;                     /* window coordinates of lane 0: x a multiple of 4, y of 2 */

    /* gn_sample_2d in the form of the back end that runs the shader; the same result. */
    gn_sample_2d_function *sample_2d;
} gn_fragment_input;

/* Output of a fragment shader: color[channel][lane], red, green, blue, alpha.
 * Every lane must be written; those not covered are not used. */
typedef struct gn_fragment_output {
    float (*color)[GN_LANES];
} gn_fragment_output;

/* Shaders are plain functions over 16 lanes; `uniforms` is the pipeline's
 * pointer, handed through. They may be called any number of times, with a workspace's
 * `parallel` on several threads at once, and must have no side effects. */
typedef void gn_vertex_shader(const void *uniforms, const gn_vertex_input *input,
                              gn_vertex_output *output);
typedef void gn_fragment_shader(const void *uniforms, const gn_fragment_input *input,
                                gn_fragment_output *output);

typedef struct gn_pipeline {
    gn_vertex_shader *vertex_shader;
    gn_fragment_shader *fragment_shader; /* may be null where the target has no colour */
    const void *uniforms;
    uint32_t varying_count; /* scalars, 0 to GN_MAX_VARYINGS */
    gn_interpolation interpolation[GN_MAX_VARYINGS];

    gn_topology topology;
    gn_provoking_vertex provoking_vertex;
    gn_cull cull;
    gn_front_face front_face;
    gn_viewport viewport;
    gn_depth_range depth_range;

    bool depth_test;
    gn_compare depth_function;
    bool depth_write_disabled;

    float point_size;        /* in pixels; 0: 1 */
    bool program_point_size; /* points have the size that the vertex shader gives them */
    float line_width;        /* in pixels; 0: 1 */
    gn_polygon_mode polygon_mode_front;
    gn_polygon_mode polygon_mode_back;
} gn_pipeline;

GN_BEGIN

/* The first fault of a pipeline, in the order of its fields: GN_NULL_POINTER
 * (pipeline), GN_NO_SHADER (no vertex shader), GN_TOO_MANY_VARYINGS,
 * GN_INVALID_ENUM (an enumeration), GN_NOT_FINITE or GN_INVALID_VIEWPORT (a
 * viewport number that is not finite; a size below 0 or above GN_MAX_SIZE, an
 * origin beyond +-GN_MAX_SIZE), GN_NOT_FINITE or GN_OUT_OF_RANGE (a depth range
 * outside 0..1), the same for a point size or line width below 0,
 * GN_INVALID_ENUM (a polygon mode). */
GN_API gn_status gn_pipeline_check(const gn_pipeline *pipeline);

GN_END

#endif
