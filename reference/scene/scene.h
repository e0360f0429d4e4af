/* Scenes: what both sides draw. A scene is data alone: a target, clears and a list
 * of draws, each with its state, mesh, shader and uniforms, in the library's own
 * public types. reference/scene/ draws it with the library, reference/osmesa/ with
 * OpenGL; neither knows of the other. */
#ifndef SCENE_H
#define SCENE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <gnomon.h>

/* The shader of a draw: ready-made, then users'. */
typedef enum scene_shader {
    SCENE_VERTEX_COLOR = 0,
    SCENE_FLAT,
    SCENE_GOURAUD,
    SCENE_TEXTURED_GOURAUD,
    SCENE_PHONG,       /* no ready-made one: a user's (phong.h) */
    SCENE_INPUTS,      /* another (inputs.h) */
    SCENE_DERIVATIVES, /* a third (derivatives.h) */
    SCENE_OUTPUTS,     /* one of several colours (outputs.h) */
    SCENE_SAMPLED,     /* and one of any texture (sampled.h) */

    /* Ready-made again, as gnomon/shaders.h calls them; SCENE_FLAT is gn_use_gouraud without
     * interpolation. */
    SCENE_UNLIT,
    SCENE_FACES, /* gn_use_flat */
    SCENE_TOON,
    SCENE_MAPPED_PHONG, /* gn_use_phong */
    SCENE_BLINN_PHONG,
    SCENE_NORMAL_COLOR,
    SCENE_DEPTH_COLOR,
    SCENE_DEPTH_ONLY, /* leaves colours as they are */
    SCENE_SHADER_COUNT
} scene_shader;

static inline bool scene_shader_is_textured(scene_shader shader)
{
    return shader == SCENE_TEXTURED_GOURAUD || shader == SCENE_PHONG || shader == SCENE_SAMPLED;
}

/* Those whose pixels scene_surface decides, and which may have a diffuse map. */
static inline bool scene_shader_shows_surface(scene_shader shader)
{
    return shader >= SCENE_FACES && shader <= SCENE_NORMAL_COLOR;
}

static inline bool scene_shader_is_lit(scene_shader shader)
{
    return (shader >= SCENE_FLAT && shader <= SCENE_PHONG) || scene_shader_shows_surface(shader);
}

/* Whether points may have the first of the texture coordinates for a size. */
static inline bool scene_shader_has_sizes(scene_shader shader)
{
    return shader == SCENE_VERTEX_COLOR || shader == SCENE_INPUTS || shader == SCENE_DERIVATIVES;
}

/* What the shaders with one light are given. */
typedef struct scene_light {
    gn_mat4 clip_from_model;
    gn_mat3 normal_matrix;
    gn_vec3 light_direction;
    gn_vec3 ambient;
    gn_vec3 diffuse;
} scene_light;

/* And with one texture, the diffuse map. */
typedef struct scene_uniforms {
    scene_light light;
    gn_texture texture;
    gn_sampler sampler;
} scene_uniforms;

/* Maps beside the diffuse one. */
typedef enum scene_map {
    SCENE_NORMAL_MAP = 0,
    SCENE_SPECULAR_MAP,
    SCENE_GLOW_MAP,
    SCENE_SHADOW_MAP,
    SCENE_MAP_COUNT
} scene_map;

/* What shaders that show a surface are given beside scene_uniforms. */
typedef struct scene_surface {
    gn_mat4 world_from_model;
    gn_vec3 eye;
    bool has_point_light; /* SCENE_FLAT and SCENE_GOURAUD look at it too, and what follows */
    gn_vec3 light_position;
    float attenuation[3]; /* constant, linear, quadratic */
    uint32_t exponent, bands;
    gn_normal_space normal_space;
    gn_texture map[SCENE_MAP_COUNT]; /* absent where it has no texels */
    gn_sampler shadow_sampler;       /* the other maps have that of scene_uniforms */
    gn_mat4 shadow_from_world;
    float black, white; /* of SCENE_DEPTH_COLOR */
} scene_surface;

/* A clear of the whole target before a draw; zeroed, there is none. */
typedef struct scene_clear {
    bool color, depth; /* what is cleared; with depth stencil, of which there is one or both */
    float color_value[4];
    float depth_value;
    uint8_t stencil_value;
} scene_clear;

typedef struct scene_draw {
    scene_shader shader;

    /* State. The shader, uniforms and varying_count members are not looked at: the
     * drawing side sets them. With SCENE_VERTEX_COLOR and SCENE_DERIVATIVES, interpolation[0..3] is
     * honoured (red, green, blue, alpha); other shaders bring their own interpolation. With
     * vertex_writes_point_size, where the shader has sizes, a point's size is the first of the texture
     * coordinates. What the fragment shader does (fragment_...) is honoured with SCENE_INPUTS, and
     * false otherwise; color_count with SCENE_OUTPUTS, and 1 otherwise. */
    gn_pipeline state;

    /* The pointers of the mesh, of uniforms.texture and of maps are the scene's own memory. */
    gn_mesh mesh;
    bool counted;         /* the fragments that pass are counted */
    uint32_t index_count; /* elements behind mesh.indices, 0 where there are none */

    /* clip_from_model serves every shader, the light those that are lit, the
     * texture and sampler the textured shaders: 2D textures of one level all but
     * SCENE_SAMPLED, which has any (of D16 to D32FS8 the depths; not 3D, which OpenGL lacks), and
     * those that may go without: SCENE_UNLIT and those that show a surface. */
    scene_uniforms uniforms;
    scene_surface surface;

    /* Clip distance i, of state.clip_distance_count, is ((p0*x + p1*y) + p2*z) + p3*w of the
     * position attribute. */
    float clip_plane[GN_MAX_CLIP_DISTANCES][4];

    gn_mat4 view_from_model; /* of SCENE_PHONG alone */
    gn_vec3 specular;        /* of SCENE_PHONG, SCENE_MAPPED_PHONG and SCENE_BLINN_PHONG */

    scene_clear clear;
} scene_draw;

typedef struct scene {
    uint32_t width, height;
    gn_format color_format; /* any of colours */
    gn_format depth_format; /* GN_FORMAT_NONE, D16, D24, D32F, D24S8, D32FS8, S8 */
    float clear_color[4];
    float clear_depth;
    uint8_t clear_stencil;
    scene_draw *draws;
    size_t draw_count;
    gn_format more_colors[GN_MAX_COLORS - 1]; /* attachments 1 and on; GN_FORMAT_NONE: none */
    uint32_t samples; /* of a pixel: 0 and 1 mean one, otherwise GN_SAMPLES */
} scene;

/* A drawn frame, bottom row first, tightly packed, in the formats of surface.h. Of a scene with
 * samples it holds several images, one after the other: those of the samples, then what they
 * are resolved to. */
typedef struct scene_frame {
    uint32_t width, height;
    uint32_t images; /* 1, or GN_SAMPLES + 1 */
    gn_format color_format, depth_format;
    void *color;
    void *depth;                               /* null for GN_FORMAT_NONE */
    uint64_t samples_passed;                   /* the sum over the counted draws */
    gn_format more_formats[GN_MAX_COLORS - 1]; /* attachments 1 and on */
    void *more_colors[GN_MAX_COLORS - 1];
} scene_frame;

/* Of attachment a, 0 to GN_MAX_COLORS - 1. */
static inline gn_format scene_color_format(const scene *s, int a)
{
    return a > 0 ? s->more_colors[a - 1] : s->color_format;
}

static inline gn_format scene_frame_format(const scene_frame *f, int a)
{
    return a > 0 ? f->more_formats[a - 1] : f->color_format;
}

static inline void *scene_frame_color(const scene_frame *f, int a)
{
    return a > 0 ? f->more_colors[a - 1] : f->color;
}

/* How two frames of one size and format differ. Bits are compared, except that two
 * NaN are equal, and that a step is allowed where GN_FORMAT_SRGB8_A8 has sRGB. */
typedef struct scene_difference {
    uint64_t color_pixels;    /* pixels with any channel different */
    uint64_t depth_pixels;    /* the same of depth and stencil */
    bool counts_differ;       /* samples_passed; counts as one pixel more */
    uint64_t pixels;          /* with a difference in colour or depth */
    uint64_t coverage_pixels; /* pixels one side has drawn on and the other has not: the
                                 value is still the clear value on exactly one side */
    double color_largest;     /* largest difference of a channel, of integers: in steps */
    double depth_largest;     /* of depth or stencil: in steps, floats as numbers */
    uint32_t x, y, image;     /* the first differing pixel, where pixels > 0 */
} scene_difference;

/* An empty scene with one allocated draw list; grows by scene_add_draw. All memory of a
 * scene is owned by it and freed by scene_free. Allocation failure ends the program with
 * a message: scenes are a test's data. */
scene *scene_create(uint32_t width, uint32_t height, gn_format color, gn_format depth);
void scene_free(scene *s);
scene *scene_copy(const scene *s);

/* A new zeroed draw at the end of the list; its clip_from_model, view_from_model and
 * normal_matrix are identities. The pointer is good until the next scene_add_draw. */
scene_draw *scene_add_draw(scene *s);
void scene_remove_draw(scene *s, size_t index);

/* The scene's size, formats and clear values as the clear before a draw has them: a format is
 * GN_FORMAT_NONE where it is not cleared. It owns nothing. */
scene scene_of_clear(const scene *s, const scene_draw *d);

/* Copy data into a draw's mesh; earlier data is freed. Attributes are tightly packed, and all
 * of a mesh hold the same number of vertices. The position (without indices) and the indices
 * make the draw one of all their elements; change mesh.first and mesh.count afterwards. */
void scene_set_attribute(scene_draw *d, gn_shader_attribute attribute, const float *data,
                         uint32_t components, uint32_t vertex_count);
void scene_set_indices(scene_draw *d, const uint32_t *indices, uint32_t count,
                       gn_index_format format);

/* Copies a 2D texture of one level into a draw, t growing with the row, tightly packed. */
void scene_set_texture(scene_draw *d, const void *texels, uint32_t width, uint32_t height,
                       gn_format format);

/* Copies any texture into a draw: its levels one after the other, tightly packed, in memory that
 * begins with the first's texels. */
void scene_set_levels(scene_draw *d, const gn_texture *texture);

/* Texels of a level: columns, rows, and slices, layers or faces. */
typedef struct scene_extent {
    uint32_t width, height, layers;
} scene_extent;

scene_extent scene_level_extent(const gn_texture *t, uint32_t level);

/* At least one. */
uint32_t scene_level_count(const gn_texture *t);

/* Elements of all levels of a texture, and the bytes of one: 1, 2 or 4, 0 for no format. */
size_t scene_texture_elements(const gn_texture *t);
size_t scene_element_size(gn_format format);

/* Element i, of 1, 2 or 4 bytes, of aligned memory. */
uint32_t scene_element(const void *elements, size_t size, size_t i);
void scene_set_element(void *elements, size_t size, size_t i, uint32_t value);

/* Has the levels of a texture, whose other members are there, tightly packed one after the other
 * in memory. */
void scene_pack_texture(gn_texture *t, const void *memory);

/* Copies a map into a draw, packed. */
void scene_set_map(scene_draw *d, scene_map map, const gn_texture *texture);

/* Whether a draw looks at uniforms.texture. */
static inline bool scene_draw_has_texture(const scene_draw *d)
{
    return scene_shader_is_textured(d->shader) ||
           ((d->shader == SCENE_UNLIT || scene_shader_shows_surface(d->shader)) &&
            d->uniforms.texture.level[0].texels);
}

/* Whether its maps are there, one of them or any. */
static inline bool scene_draw_has_map(const scene_draw *d, scene_map map)
{
    return scene_shader_shows_surface(d->shader) && d->surface.map[map].level[0].texels;
}

/* Whether a format is one of colours. */
bool scene_is_color_format(gn_format format);

/* Bytes of an index; 0 for GN_INDEX_NONE. */
size_t scene_index_size(gn_index_format format);

/* The vertex that element i of a mesh names, counted from the indices' first. */
uint32_t scene_vertex_of(const gn_mesh *mesh, uint32_t i);

/* Triangles, lines and points the draws submit, before clipping. */
uint64_t scene_triangle_count(const scene *s);

/* The scene as text that replays it bit for bit, and back (scene_text.h says how it reads).
 * scene_write is false where writing failed. scene_read returns null and puts a message with
 * the line number into error. */
bool scene_write(const scene *s, FILE *out);
scene *scene_read(FILE *in, char *error, size_t error_size);

/* Whether pixels of a scene have several samples. */
static inline bool scene_is_sampled(const scene *s)
{
    return s->samples > 1;
}

/* A zeroed frame for a scene; false where memory is short. */
bool scene_frame_allocate(scene_frame *frame, const scene *s);
void scene_frame_free(scene_frame *frame);

/* The scalar varyings of the shader that has most of them, and with the clip distances of the draw
 * that has most, for sizing a workspace. */
#define SCENE_VARYINGS GN_SHADER_VARYINGS
uint32_t scene_varyings(const scene *s);

/* Bytes of workspace with which every draw of the scene shades each vertex once, and may
 * run on several threads. */
size_t scene_workspace_size(const scene *s);

/* Clears and draws with the library, into surfaces of the scene's size and formats, which may
 * be top-down, and in the caller's workspace. The status is the first that is not GN_OK. */
gn_status scene_draw_to_target(const scene *s, const gn_target *target, gn_workspace *workspace);

/* The same into a frame, and resolves samples. */
gn_status scene_draw_in_workspace(const scene *s, scene_frame *frame, gn_workspace *workspace);

/* The same in a workspace of its own, of scene_workspace_size where workspace_bytes is 0. */
gn_status scene_draw_library(const scene *s, scene_frame *frame, size_t workspace_bytes,
                             gn_backend backend);

/* Compares. Clear values of the scene decide what counts as drawn. */
scene_difference scene_compare(const scene *s, const scene_frame *ours,
                               const scene_frame *reference);

#endif
