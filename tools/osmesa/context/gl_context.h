/* A context: the state of OpenGL, the window that it draws to and its memory. Each thread has a
 * current one or none. */
#ifndef OSMESA_GL_CONTEXT_H
#define OSMESA_GL_CONTEXT_H

#include <gnomon.h>

#include "gl_state.h"

typedef struct osmesa_context context;

/* The window: the program's memory, and depth and stencil, which are the context's. */
typedef struct window_state {
    GLenum format, type;
    GLint depth_bits, stencil_bits, accumulation_bits;
    GLint row_length, y_up; /* OSMesaPixelStore */
    GLint width, height;
    void *memory; /* the program's; null: never current yet */

    /* Row 0 is the top row: the reference draws its window so. */
    gn_target target;
    void *depth_memory;
    int16_t *accumulation; /* four of each pixel; null: there is no accumulation buffer */
    void *color_memory;    /* where the program's format is not one of Gnomon's; otherwise null */
} window_state;

/* The list that is compiled, and how lists are called. */
typedef struct display_list display_list;
typedef struct list_state {
    GLenum mode; /* 0: none is compiled, or calls are replayed */
    GLuint name, base;
    display_list *compiled;
    struct list_compiler *compiler;
    int nesting;
} list_state;

enum { PENDING_PRIMITIVES = 64 };

typedef struct pending_primitive {
    GLenum mode;
    uint32_t first, count;
} pending_primitive;

/* Vertices of glBegin and glEnd, each with all attributes. As in the reference, primitives wait
 * until state changes, an attribute is set that their vertices lack, or there are too many: what is
 * drawn together shows in how quads are divided. */
typedef struct immediate_state {
    bool is_inside;
    GLfloat (*vertex)[ATTRIBUTES][4];
    uint32_t count, capacity;

    /* The components of each attribute of the waiting vertices, the fog coordinate last; 0: the
     * current value at the draw. */
    unsigned char size[ATTRIBUTES + 1];
    pending_primitive primitive[PENDING_PRIMITIVES];
    uint32_t primitives; /* inside, the last one is not ended */
    bool continues_loop; /* the last one is the rest of a loop, with the loop's first vertex */
    void (*draw)(context *gl); /* draws what waits; null before the first vertex */

    /* Of a list that is compiled: takes primitives instead of drawing them (list_meshes.c). */
    void (*store)(context *gl, GLenum mode, const gn_mesh *mesh);
    uint32_t unknown;   /* bits of attributes whose current value the list does not know */
    bool keeps_current; /* the last primitive is of arrays, which leave the current values alone */
} immediate_state;

/* What glPushAttrib and glPushClientAttrib have saved (attribute_stacks.c). */
enum { ATTRIBUTE_DEPTH = 16 };

typedef struct saved_attributes saved_attributes;
typedef struct saved_client_attributes saved_client_attributes;

typedef struct attribute_stacks {
    GLint depth, client_depth;
    saved_attributes *saved[ATTRIBUTE_DEPTH];
    saved_client_attributes *client_saved[ATTRIBUTE_DEPTH];
} attribute_stacks;

/* Where the edge flags of the vertices that are drawn are. */
typedef struct edge_flags {
    const GLfloat *vertex; /* 0 or not; null: all have the current one */
    size_t step;           /* floats from one to the next */
} edge_flags;

/* Memory that grows and is used again by each draw. */
typedef struct scratch {
    void *memory;
    size_t size;
} scratch;

typedef struct object_table object_table;
typedef struct framebuffer_object framebuffer_object;
typedef struct renderbuffer renderbuffer;
typedef struct occlusion_query occlusion_query;

/* What contexts share. */
typedef struct shared_objects {
    int references;
    object_table *buffers, *textures, *renderbuffers, *framebuffers, *lists;
    texture_object *default_texture[TEXTURE_TARGETS]; /* of the name 0 */
} shared_objects;

/* Limits of KHR_debug. */
enum { DEBUG_GROUPS = 64, LABEL_SIZE = 256 };

struct osmesa_context {
    GLenum error;
    immediate_state immediate;
    list_state list;
    current_state current;
    raster_position_state raster_position;
    array_state arrays;
    transform_state transform;
    lighting_state lighting;
    texture_unit unit[TEXTURE_UNITS];
    fog_state fog;
    raster_state raster;
    GLint stipple_counter; /* how far the lines of a strip are in the pattern, in its pixels */
    uint32_t polygon_pattern[STIPPLE_SIZE]; /* rows upwards; bit 0 is the left pixel */
    fragment_state fragment;
    pixel_store pack, unpack;
    GLfloat pixel_zoom[2];
    pixel_transfer_state transfer;
    pixel_map map[PIXEL_MAPS];
    evaluator_state evaluator;
    evaluator_map map1[EVALUATOR_MAPS], map2[EVALUATOR_MAPS];
    hint_state hint;
    GLenum render_mode;
    selection_state selection;
    feedback_state feedback;
    attribute_stacks stacks;
    window_state window;
    framebuffer_object *draw_framebuffer, *read_framebuffer; /* null: the window */
    renderbuffer *renderbuffer;
    object_table *queries;
    occlusion_query *query; /* the active one, or null */
    GLenum clamp_vertex_color, clamp_fragment_color, clamp_read_color;
    GLenum provoking_vertex;
    GLint active_texture;
    GLint debug_groups; /* of KHR_debug; the first one is always there */
    GLboolean debug_output, debug_is_synchronous;
    GLboolean seamless_cubes;
    texture_object *proxy[TEXTURE_TARGETS];
    shared_objects *shared;
    gn_workspace workspace;
    edge_flags edge_flags;
    scratch vertices, indices, pixels, corners, flags, shaded;

    GLfloat modelview[MODELVIEW_DEPTH][16], projection[PROJECTION_DEPTH][16];
    GLfloat texture[TEXTURE_UNITS][TEXTURE_DEPTH][16];
    matrix_kind modelview_kind[MODELVIEW_DEPTH], projection_kind[PROJECTION_DEPTH];
    matrix_kind texture_kind[TEXTURE_UNITS][TEXTURE_DEPTH];
};

/* The calling thread's context, or null. */
context *current_context(void);
void set_current_context(context *gl);

/* Draws the vertices that wait. */
void flush_vertices(context *gl);

/* Frees the list that is compiled. */
void free_compiled_list(context *gl);

/* Returns the current context for the function of OpenGL that has this name, and draws the vertices
 * that wait. Returns null if there is none, and between glBegin and glEnd, which is an error of the
 * function. */
context *enter(const char *function);

/* Returns at least `size` bytes of a scratch, whose content is lost; null if memory is short, which
 * is an error of the function with this name. */
void *scratch_memory(context *gl, scratch *s, size_t size, const char *function);

#endif
