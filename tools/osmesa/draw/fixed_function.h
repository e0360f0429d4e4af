/* The fixed function: what a program's state makes of vertices and fragments without shaders of its
 * own (OpenGL 2.1 chapters 2 and 3). set_fixed_function derives once per draw what fixed_vertex.c
 * and fixed_fragment.c, which run over lanes, read. */
#ifndef OSMESA_FIXED_FUNCTION_H
#define OSMESA_FIXED_FUNCTION_H

#include "fixed_texture.h"

/* Points without sprites: whole pixels around a centre or a corner of a pixel. */
typedef struct point_placement {
    bool enabled;
    float size;     /* the same of all points, before it is rounded; if attenuated, that at 1 */
    float scale[2]; /* of the viewport, from clip space to rows and columns */
    float translation[2];
    bool is_attenuated;   /* sizes depend on the distance from the eye (glPointParameter) */
    float attenuation[3]; /* constant, linear, quadratic */
    float least, most;
    float to_depth[4]; /* as of fog */
} point_placement;

/* Fog: the coordinate is a varying; scale and offset are those of the mode. */
typedef struct fog_derived {
    bool enabled;
    GLenum mode;
    bool from_array; /* the coordinate is the vertices', not their depth in eye space */
    int varying;     /* below 0: all vertices have `coordinate` */
    float coordinate;
    float scale, offset;
    float color[3];
    float to_depth[4]; /* the row of the modelview matrix that gives z in eye space */
} fog_derived;

typedef struct fixed_function {
    GLfloat to_clip[16]; /* projection * modelview */
    uint32_t clip_planes;
    GLfloat clip_plane[CLIP_PLANES][4]; /* in clip space */
    GLfloat current[ATTRIBUTES][4];     /* of attributes that are no arrays */

    /* The first varying of each; below 0: fragments have the current value. */
    int color_varying;      /* of four */
    int secondary_varying;  /* of three */
    int back_color_varying; /* the same of the back, of two-sided lighting */
    int back_secondary_varying;

    bool clamps_vertex_colors;
    bool adds_secondary; /* GL_COLOR_SUM, or separate specular colours */
    eye_derived eye;
    lighting_derived lighting;
    unit_derived unit[TEXTURE_UNITS];
    int last_unit; /* of those that are enabled; -1: none */
    bool tests_alpha;
    bool alpha_in_bytes; /* as the window keeps it */
    GLenum alpha_function;
    float alpha_reference; /* a whole number if in bytes */
    point_placement points;
    const uint32_t *polygon_pattern; /* null: none */
    bool is_stippled[2];             /* front and back faces */
    int32_t pattern_bottom;          /* the row of its row 0, in rows that go down; else 0 */
    bool rows_go_down;
    fog_derived fog;
} fixed_function;

/* Derives the state of a draw of this mesh, and sets the program, which refers to `fixed`. Points
 * need the pipeline's viewport. */
void set_fixed_function(context *gl, GLenum mode, const gn_mesh *mesh, fixed_function *fixed,
                        gn_pipeline *pipeline);

/* Whether a vertex of the first `count` elements of a mesh, 1 or more, is clipped: by
 * the view volume or by a clip plane. */
bool crosses_view_volume(const fixed_function *fixed, gn_clip_depth clip_depth, const gn_mesh *mesh,
                         uint32_t count);

/* Returns a channel of a colour, clamped to 0..1. NaN becomes 1, as in the reference: infinite
 * specular light outside a spot is NaN. */
static inline float clamped_color(float x)
{
    const float low = x < 0.0f ? 0.0f : x;

    return low < 1.0f ? low : 1.0f;
}

/* Returns a size in whole pixels: it is rounded to parts of 256 of a pixel, and then to whole
 * pixels, halves down. */
float whole_point_size(float size);

/* Returns the column (0) or row (1) that a point at a place in the window is moved to: the centre
 * of its pixel, or the nearest corner where its size, in whole pixels, is even. */
float point_center(float whole_size, int axis, float window);

gn_vertex_shader fixed_vertex;
gn_fragment_shader fixed_fragment;

/* Takes fragments with a primary colour, in `output`, and a secondary one through textures, fog and
 * the alpha test. `secondary` is not read unless the state adds it. */
void finish_fragments(const fixed_function *fixed, const gn_fragment_input *input,
                      const float (*secondary)[GN_LANES], gn_fragment_output *output);

/* Returns which fragments pass the alpha test, as bits (OpenGL 2.1 section 4.1.4). */
uint32_t kept_by_alpha(const fixed_function *fixed, const float alpha[GN_LANES]);

/* Derives the state of rectangles of pixels, or fragments of one colour: no input but the colour
 * differs from fragment to fragment. As in the reference, the secondary colour and the fog
 * coordinate are 0. */
void set_rectangle_function(context *gl, const GLfloat color[4], fixed_function *fixed,
                            gn_program *program);

/* Writes positions in clip space of a group of lanes. */
void place_in_clip_space(const fixed_function *fixed, const float position[4][GN_LANES],
                         float clip[4][GN_LANES]);

#endif
