/* Declarations shared by the files of the reference: the GL entry points, the state of a reference,
 * and the steps from a scene to its pixels. */
#ifndef OSMESA_GL_H
#define OSMESA_GL_H

#include <GL/glcorearb.h>

#include "driver.h"
#include "functions.h"
#include "osmesa.h"

/* gn_compare lists the functions in the order of OpenGL's numbers. */
static inline GLenum gl_comparison(gn_compare c, GLenum default_function)
{
    return c == GN_COMPARE_DEFAULT ? default_function : GL_NEVER + (GLenum)(c - GN_NEVER);
}

/* Number of framebuffers kept for later scenes of equal size and formats. */
#define FRAMEBUFFER_CACHE_SIZE 16

/* Variants of the vertex-colour program: each of four scalars has one of three qualifiers and one
 * of three locations; with and without point sizes; with reference_divides for all
 * of them, for those that are not at centres, or for none. */
#define VERTEX_COLOR_PROGRAMS 39366

/* Variants of the program of inputs.h: with and without position, primitive, discard, depth, point
 * coordinates, point sizes, reading sample masks, writing them and reading the sample, and
 * reference_divides_varying; with one of three locations of the varyings. */
#define INPUTS_PROGRAMS 3072

/* Variants of the program of sampled.h: each texture target with colours, depths and compared
 * depths. */
#define SAMPLED_PROGRAMS 15

typedef struct framebuffer {
    GLuint name;
    GLuint color[GN_MAX_COLORS], depth; /* textures if is_sampled; else depth is a renderbuffer */
    uint32_t width, height;
    gn_format color_format[GN_MAX_COLORS], depth_format;
    uint64_t last_use;
    bool is_sampled;
    bool is_layered; /* colours are layers of textures, not renderbuffers */
} framebuffer;

/* A program of twins.c, for one shader and the maps and lights of its draw. */
typedef struct reference_twin {
    uint32_t key;
    GLuint program;
} reference_twin;

struct reference {
    const reference_driver *driver;
    void *context; /* the driver's */
    bool is_pinned;
    char version[32];
    char renderer[128];
    GLuint vertex_array;
    GLuint vertex_color_programs[2][VERTEX_COLOR_PROGRAMS]; /* [with clip distances] */
    GLuint derivatives_programs[2][VERTEX_COLOR_PROGRAMS];
    GLuint inputs_programs[2][INPUTS_PROGRAMS];
    GLuint outputs_programs[2][GN_MAX_COLORS];
    GLuint sampled_programs[2][SAMPLED_PROGRAMS];
    GLuint lit_programs[2][SCENE_SHADER_COUNT];
    reference_twin *twins;
    size_t twin_count;
    framebuffer framebuffers[FRAMEBUFFER_CACHE_SIZE];
    uint64_t uses;
    GLuint sample_programs[2]; /* programs that read numbers, and stencil */
};

/* A draw's mesh and texture as GL objects. */
typedef struct uploaded_draw {
    GLuint vertices;
    GLuint indices;
    GLuint array; /* the vertex array object of a draw that is timed, otherwise 0 */
    GLuint texture;
    GLuint maps[SCENE_MAP_COUNT];
    GLuint program;
    GLuint queries[2]; /* of a counted draw: samples passed, primitives */
    size_t offset[5];  /* of the attributes in `vertices` */
} uploaded_draw;

/* A scene prepared for timing. The framebuffers are its own: the cache never deletes them. */
struct reference_prepared {
    const scene *scene; /* the caller's; for state and uniforms */
    framebuffer target;
    uploaded_draw *draws;
    framebuffer to; /* the destination of blits; its name is 0 if there is none */
    GLbitfield blit_mask;
    GLenum filter;
};

/* Writes a formatted reason into error. Returns false. */
bool reference_fail(char *error, size_t error_size, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Returns false if GL has an error; error then holds a reason that names `doing`. */
bool reference_check(const char *doing, char *error, size_t error_size);

/* Returns the GL program of a draw, which is made on first use; 0 with the compiler's log in
 * error. */
GLuint reference_program(reference *r, const scene_draw *d, char *error, size_t error_size);

/* Binds and returns the framebuffer of a scene; null with the reason in error. */
framebuffer *reference_framebuffer(reference *r, const scene *s, char *error, size_t error_size);
bool framebuffer_create(framebuffer *f, const scene *s, reference_depth depth, bool layered,
                        char *error, size_t error_size);
void framebuffer_destroy(framebuffer *f);

/* Makes draws go to the scene's first `count` attachments. */
void framebuffer_choose_colors(const scene *s, int count);

/* The steps of drawing: create GL objects for the draws' data (null with the reason in error),
 * clear, set one draw's state and draw it, delete the objects. */
uploaded_draw *reference_upload(reference *r, const scene *s, char *error, size_t error_size);
void reference_clear(const scene *s);
void reference_issue(const scene *s, const scene_draw *d, const uploaded_draw *u);
void reference_discard(uploaded_draw *draws, size_t count);

/* For draws that are timed. The first gives a draw its vertex array object. The second does what
 * reference_issue does, but leaves out what draw `before` of the same frame has set already; draw
 * `before` is null for the first draw of a frame. */
void reference_prepare_attributes(const scene_draw *d, uploaded_draw *u);
void reference_issue_prepared(const scene *s, const scene_draw *d, const uploaded_draw *u,
                              const scene_draw *before, const uploaded_draw *before_u);

/* Makes a program from a vertex shader, in front of which the common declarations are put, and a
 * complete fragment shader; returns 0 with the compiler's log in error. */
GLuint reference_link(const char *vertex, const char *fragment, char *error, size_t error_size);

/* Does what reference_link does; if `clipped`, the vertex shader has the clip distances of a
 * scene's draws. */
GLuint reference_link_clipped(const char *vertex, const char *fragment, bool clipped, char *error,
                              size_t error_size);

/* Does what reference_link_clipped does, with the fragment shader in two parts. */
GLuint reference_link_parts(const char *vertex_body, const char *fragment_head,
                            const char *fragment_body, bool clipped, char *error,
                            size_t error_size);

/* The declarations of varyings in a vertex shader and in a fragment shader, and what the vertex
 * shader's main does with them in the end. All are empty at first. */
#define LOCATED_TEXT 1024
typedef struct located_texts {
    char outs[LOCATED_TEXT], divisions[LOCATED_TEXT], ins[LOCATED_TEXT];
} located_texts;

/* Adds a varying of a draw. */
void reference_declare(const scene_draw *d, int varying, gn_interpolation interpolation,
                       const char *type, const char *name, located_texts *texts);

/* Whether shaders divide and multiply smooth varyings by w themselves (locations.c): any of the
 * draw's; this one. */
bool reference_divides(const scene_draw *d);
bool reference_divides_varying(const scene_draw *d, int varying);

/* The program of a draw with SCENE_SAMPLED; returns as reference_program does. */
GLuint reference_sampled_program(reference *r, const scene_draw *d, char *error, size_t error_size);

/* Creates and binds a texture with its sampler's state; 0 if there is not enough memory. */
GLuint reference_upload_texture(const gn_texture *t, const gn_sampler *sampler);

/* The programs of twins.c: whether a draw has one; that program; its uniforms; its maps as GL
 * objects, bound to units from 1 on; the deletion of all of them. */
bool reference_has_twin(const scene_draw *d);
GLuint reference_twin_program(reference *r, const scene_draw *d, char *error, size_t error_size);
void reference_set_twin_uniforms(const scene_draw *d, GLuint program);
void reference_upload_maps(const scene_draw *d, GLuint maps[SCENE_MAP_COUNT]);
void reference_bind_maps(const GLuint maps[SCENE_MAP_COUNT]);
void reference_free_twins(reference *r);

GLenum reference_texture_target(gn_texture_target target);

/* Whether lookups compare: the sampler asks for it and the texels are depths. */
bool reference_is_compared(const gn_texture *t, const gn_sampler *sampler);

/* Reads every sample of the bound framebuffer of a scene, and the resolved pixels. */
bool reference_read_samples(reference *r, const scene *s, const framebuffer *f, scene_frame *frame,
                            char *error, size_t error_size);

/* Reads the bound framebuffer, which must have one sample, into an image of a frame. */
void reference_read_image(const scene *s, uint32_t image, scene_frame *frame);

/* OpenGL's name of a format, and the type of its pixels in memory. */
typedef struct reference_image_format {
    GLenum internal, format, type;
} reference_image_format;

reference_image_format reference_image_format_of(gn_format format);

/* Converts a depth of 24 bits to one of 32. The driver cuts the 32 bits off or rounds them to 24
 * again, so the result lies in the middle of those that become the depth. (If the upper bits were
 * repeated below, the depths 1 to 65,535 would come out one less.) */
uint32_t reference_depth32_of(uint32_t depth24);

/* Pixels that Gnomon and OpenGL have in different forms, from the former to the latter or back:
 * words of depth, and bytes of which the higher is first. */
void reference_turn_pixels(gn_format format, void *pixels, size_t count, bool to_opengl);

/* Sets which samples are drawn. */
void reference_set_sample_state(const gn_pipeline *p);

/* Sets OpenGL's state for writing colours to the framebuffer. */
void reference_set_color_state(const gn_pipeline *p);

#endif
