/* The state of OpenGL that a program can set and query (OpenGL 2.1 tables 6.5 to 6.35), in groups
 * as in the specification. state_table.c lists what glGet returns of it. Enumerations are kept as
 * the program gives them; draw_state.c turns them into those of Gnomon. */
#ifndef OSMESA_GL_STATE_H
#define OSMESA_GL_STATE_H

#include <stdbool.h>

#include "gl_types.h"
#include "../transform/matrix_kind.h"

enum {
    TEXTURE_UNITS = 4,
    MODELVIEW_DEPTH = 32,
    PROJECTION_DEPTH = 32,
    TEXTURE_DEPTH = 10,
    LIGHTS = 8,
    CLIP_PLANES = 8
};

/* The attributes of a vertex. The secondary colour and the fog coordinate share one, since the
 * library takes eight. */
enum attribute_name {
    POSITION,
    NORMAL,
    COLOR,
    SECONDARY_AND_FOG,
    TEXTURE_COORDINATE,
    ATTRIBUTES = TEXTURE_COORDINATE + TEXTURE_UNITS
};

/* The arrays of a program (tables 6.6 to 6.9). */
enum array_name {
    VERTEX_ARRAY,
    NORMAL_ARRAY,
    COLOR_ARRAY,
    SECONDARY_COLOR_ARRAY,
    FOG_COORDINATE_ARRAY,
    EDGE_FLAG_ARRAY,
    INDEX_ARRAY,
    TEXTURE_COORDINATE_ARRAY,
    ARRAYS = TEXTURE_COORDINATE_ARRAY + TEXTURE_UNITS
};

typedef struct buffer_object buffer_object;

/* What new vertices get (table 6.5). */
typedef struct current_state {
    GLfloat attribute[ATTRIBUTES][4]; /* that of POSITION is not used */
    GLboolean edge_flag;
    GLfloat index;
} current_state;

/* Where bitmaps and rectangles of pixels are drawn, and with what (table 6.5). */
typedef struct raster_position_state {
    GLfloat position[4]; /* in the window; the last one is that of clip space */
    GLfloat color[4], secondary_color[4], distance, index;
    GLfloat coordinate[TEXTURE_UNITS][4]; /* of textures */
    GLboolean is_valid;
} raster_position_state;

typedef struct vertex_array {
    GLboolean enabled;
    GLint size;
    GLenum type;
    GLint stride;
    const void *pointer; /* an offset if there is a buffer */
    buffer_object *buffer;
    GLint buffer_name;
} vertex_array;

/* Arrays and the buffers that they are in (tables 6.6 to 6.10). */
typedef struct array_state {
    vertex_array array[ARRAYS];
    GLint client_texture; /* the unit that glTexCoordPointer sets */
    buffer_object *array_buffer, *element_buffer, *pack_buffer, *unpack_buffer;
    GLint array_buffer_name, element_buffer_name, pack_buffer_name, unpack_buffer_name;
} array_state;

/* A stack of matrices in memory of its own; `m` and `kind` have `limit` of them. */
typedef struct matrix_stack {
    GLfloat (*m)[16];
    matrix_kind *kind;
    GLint depth; /* 1 to limit */
    GLint limit;
} matrix_stack;

/* Transformation (table 6.11). */
typedef struct transform_state {
    GLenum mode;
    matrix_stack modelview, projection, texture[TEXTURE_UNITS];
    GLint viewport[4];
    GLfloat depth_range[2];
    GLenum clip_origin, clip_depth; /* glClipControl */
    GLboolean clip_plane_enabled[CLIP_PLANES];
    GLfloat clip_plane[CLIP_PLANES][4]; /* in eye space */
    GLboolean normalize, rescale_normal;
} transform_state;

typedef struct light_state {
    GLfloat ambient[4], diffuse[4], specular[4];
    GLfloat position[4];       /* in eye space */
    GLfloat spot_direction[3]; /* in eye space */
    GLfloat spot_exponent, spot_cutoff;
    GLfloat constant_attenuation, linear_attenuation, quadratic_attenuation;
    GLboolean enabled;
} light_state;

/* The colours of a material. */
enum material_color {
    MATERIAL_AMBIENT,
    MATERIAL_DIFFUSE,
    MATERIAL_SPECULAR,
    MATERIAL_EMISSION,
    MATERIAL_COLORS
};

typedef struct material_state {
    GLfloat color[MATERIAL_COLORS][4];
    GLfloat shininess;
    GLfloat indexes[3];
} material_state;

/* Coloring and lighting (tables 6.12 to 6.14). */
typedef struct lighting_state {
    GLboolean enabled, color_material, local_viewer, two_side;
    GLenum color_material_face, color_material_mode, color_control, shade_model;
    GLfloat ambient[4];
    light_state light[LIGHTS];
    material_state material[2]; /* front, back */
    GLboolean color_sum;
} lighting_state;

/* Textures (tables 6.16 to 6.20). Of several that are enabled, the last target is read. */
enum texture_target_name { TARGET_1D, TARGET_2D, TARGET_3D, TARGET_CUBE, TEXTURE_TARGETS };

typedef struct texture_object texture_object;

typedef struct texture_generation {
    GLboolean enabled;
    GLenum mode;
    GLfloat object_plane[4], eye_plane[4];
} texture_generation;

/* How GL_COMBINE makes a colour, or its alpha. */
enum combine_half { COMBINE_COLOR, COMBINE_ALPHA, COMBINE_HALVES };
enum { COMBINE_ARGUMENTS = 4 };

typedef struct combine_state {
    GLenum mode, source[COMBINE_ARGUMENTS], operand[COMBINE_ARGUMENTS];
    GLfloat scale;
} combine_state;

typedef struct texture_unit {
    GLboolean enabled[TEXTURE_TARGETS];
    texture_object *bound[TEXTURE_TARGETS];
    GLenum mode;
    combine_state combine[COMBINE_HALVES];
    GLfloat color[4], lod_bias;
    texture_generation generation[4]; /* s, t, r, q */
} texture_unit;

typedef struct fog_state {
    GLboolean enabled;
    GLfloat color[4], index, density, start, end;
    GLenum mode, coordinate_source;
} fog_state;

/* Rasterization (tables 6.15 and 6.16). */
typedef struct raster_state {
    GLfloat point_size, point_size_min, point_size_max, point_fade_threshold;
    GLfloat point_attenuation[3];
    GLfloat line_width;
    GLint stipple_factor, stipple_pattern;
    GLboolean point_smooth, line_smooth, line_stipple, polygon_smooth, polygon_stipple;
    GLboolean cull;
    GLenum cull_face, front_face, polygon_mode[2];
    GLboolean offset_fill, offset_line, offset_point;
    GLfloat offset_factor, offset_units;
} raster_state;

enum { STIPPLE_SIZE = 32 };

typedef struct stencil_state {
    GLenum function, fail, depth_fail, pass;
    GLint reference;
    GLuint compare_mask, write_mask;
} stencil_state;

/* Fragments and the framebuffer (tables 6.22 to 6.24). */
typedef struct fragment_state {
    GLboolean scissor, alpha_test, stencil_test, depth_test, blend, dither, logic_operation,
        index_logic_operation, multisample, framebuffer_srgb, alpha_to_coverage, alpha_to_one,
        sample_coverage;
    GLint scissor_box[4];
    GLenum alpha_function;
    GLfloat alpha_reference;
    stencil_state stencil[2]; /* front, back */
    GLenum depth_function;
    GLenum blend_source, blend_destination, blend_alpha_source, blend_alpha_destination;
    GLenum blend_equation, blend_alpha_equation;
    GLfloat blend_color[4];
    GLenum logic_function;
    GLfloat sample_coverage_value;
    GLboolean sample_coverage_invert;
    GLboolean color_mask[4], depth_mask;
    GLint index_mask;
    GLfloat clear_color[4], clear_accumulation[4];
    GLint clear_index;
    GLdouble clear_depth;
    GLint clear_stencil;
    GLenum draw_buffer, read_buffer;
} fragment_state;

/* How pixels lie in the program's memory (tables 6.26 and 6.27). */
typedef struct pixel_store {
    GLboolean swap_bytes, lsb_first;
    GLint image_height, skip_images, row_length, skip_rows, skip_pixels, alignment;
} pixel_store;

/* Pixel transfer (tables 6.28 and 6.29). */
typedef struct pixel_transfer_state {
    GLboolean map_color, map_stencil;
    GLint index_shift, index_offset;
    GLfloat scale[4], bias[4]; /* of red to alpha */
    GLfloat depth_scale, depth_bias;
} pixel_transfer_state;

/* In the order of their names in OpenGL. */
enum pixel_map_name {
    MAP_I_TO_I,
    MAP_S_TO_S,
    MAP_I_TO_R,
    MAP_I_TO_G,
    MAP_I_TO_B,
    MAP_I_TO_A,
    MAP_R_TO_R,
    MAP_G_TO_G,
    MAP_B_TO_B,
    MAP_A_TO_A,
    PIXEL_MAPS
};

enum { PIXEL_MAP_SIZE = 256 };

typedef struct pixel_map {
    GLint size;
    GLfloat value[PIXEL_MAP_SIZE];
} pixel_map;

/* What becomes of primitives that are not drawn: hits, or values, in the program's memory. */
enum { NAME_STACK_DEPTH = 64 };

typedef struct selection_state {
    GLuint *buffer;
    GLint size, count; /* of the buffer, and what it holds */
    bool overflows;
    GLint hits;
    GLint depth;
    GLuint name[NAME_STACK_DEPTH];
    bool is_hit; /* since the names changed last */
    GLfloat least_z, greatest_z;
} selection_state;

typedef struct feedback_state {
    GLfloat *buffer;
    GLint size, count;
    bool overflows;
    GLenum type;
    bool resets_pattern; /* the next line is the first one of a polygon */
} feedback_state;

/* Evaluators (table 6.30), in the order of the names of maps in OpenGL. */
enum evaluator_map_name {
    MAP_COLOR_4,
    MAP_INDEX,
    MAP_NORMAL,
    MAP_COORDINATE_1,
    MAP_VERTEX_3 = MAP_COORDINATE_1 + 4,
    MAP_VERTEX_4,
    EVALUATOR_MAPS
};

typedef struct evaluator_state {
    GLboolean auto_normal, map1[EVALUATOR_MAPS], map2[EVALUATOR_MAPS];
    GLint segments1, segments2[2];
    GLfloat domain1[2], domain2[4];
    GLfloat step1, step2[2]; /* of glEvalMesh; as in the reference, 0 until glMapGrid */
} evaluator_state;

typedef struct evaluator_map {
    GLint order[2];    /* a curve has 1 as the second one */
    GLfloat domain[4]; /* u1, u2, v1, v2 */
    GLfloat scale[2];
    GLfloat *points; /* null: those of a new context */
} evaluator_map;

typedef struct hint_state {
    GLenum perspective, point, line, polygon, fog, mipmap, compression;
} hint_state;

#endif
