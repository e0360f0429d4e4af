/* Scenes: what the library and the reference both draw. A scene is plain data: a target, clears and
 * a list of draws, each with its state, mesh, shader and uniforms, in the library's own public
 * types. reference/scene/ draws it with the library, reference/osmesa/ with OpenGL; the two do not
 * depend on each other. */
#ifndef SCENE_H
#define SCENE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <gnomon.h>

#include "scene_format.h"

/* X(shader of a draw, its name in the text of scenes). The ready-made ones after users' have the
 * names of gnomon/shaders.h where no other is said. Hashes hold the numbers of the order. */
#define SCENE_SHADERS(X)                                                                           \
    X(VERTEX_COLOR, "vertex-color")                                                                \
    X(FLAT, "flat") /* gn_use_gouraud without interpolation */                                     \
    X(GOURAUD, "gouraud")                                                                          \
    X(TEXTURED_GOURAUD, "textured-gouraud")                                                        \
    X(PHONG, "phong")             /* a user's (phong.h) */                                         \
    X(INPUTS, "inputs")           /* a user's (inputs.h) */                                        \
    X(DERIVATIVES, "derivatives") /* a user's (derivatives.h) */                                   \
    X(OUTPUTS, "outputs")         /* a user's, with several colours (outputs.h) */                 \
    X(SAMPLED, "sampled")         /* a user's, with any texture (sampled.h) */                     \
    X(UNLIT, "unlit")                                                                              \
    X(FACES, "faces") /* gn_use_flat */                                                            \
    X(TOON, "toon")                                                                                \
    X(MAPPED_PHONG, "mapped-phong") /* gn_use_phong */                                             \
    X(BLINN_PHONG, "blinn-phong")                                                                  \
    X(NORMAL_COLOR, "normal-color")                                                                \
    X(DEPTH_COLOR, "depth-color")                                                                  \
    X(DEPTH_ONLY, "depth-only") /* writes no colours */                                            \
    X(METALLIC_ROUGHNESS, "metallic-roughness")

#define SCENE_SHADER(shader, name) SCENE_##shader,
typedef enum scene_shader { SCENE_SHADERS(SCENE_SHADER) SCENE_SHADER_COUNT } scene_shader;

static inline bool scene_shader_is_textured(scene_shader shader)
{
    return shader == SCENE_TEXTURED_GOURAUD || shader == SCENE_PHONG || shader == SCENE_SAMPLED;
}

/* Shaders that scene_surface describes; they may have a diffuse map. */
static inline bool scene_shader_shows_surface(scene_shader shader)
{
    return (shader >= SCENE_FACES && shader <= SCENE_NORMAL_COLOR) ||
           shader == SCENE_METALLIC_ROUGHNESS;
}

static inline bool scene_shader_is_lit(scene_shader shader)
{
    return (shader >= SCENE_FLAT && shader <= SCENE_PHONG) || scene_shader_shows_surface(shader);
}

/* Whether the shader's points may take their size from the first texture coordinate. */
static inline bool scene_shader_has_sizes(scene_shader shader)
{
    return shader == SCENE_VERTEX_COLOR || shader == SCENE_INPUTS || shader == SCENE_DERIVATIVES;
}

/* Uniforms of the shaders with one light. */
typedef struct scene_light {
    gn_mat4 clip_from_model;
    gn_mat3 normal_matrix;
    gn_vec3 light_direction;
    gn_vec3 ambient;
    gn_vec3 diffuse;
} scene_light;

/* Uniforms of the shaders with one light and one texture, the diffuse map. */
typedef struct scene_uniforms {
    scene_light light;
    gn_texture texture;
    gn_sampler sampler;
} scene_uniforms;

/* Maps besides the diffuse map. */
typedef enum scene_map {
    SCENE_NORMAL_MAP = 0,
    SCENE_SPECULAR_MAP,
    SCENE_GLOW_MAP,
    SCENE_SHADOW_MAP,
    SCENE_METALLIC_ROUGHNESS_MAP,
    SCENE_OCCLUSION_MAP,
    SCENE_MAP_COUNT
} scene_map;

/* Uniforms, besides scene_uniforms, of the shaders that show a surface. */
typedef struct scene_surface {
    gn_mat4 world_from_model;
    gn_vec3 eye;
    bool has_point_light; /* SCENE_FLAT and SCENE_GOURAUD read this member and those that follow;
                             has_spot_light prevails */
    gn_vec3 light_position;
    float attenuation[3]; /* constant, linear, quadratic */
    uint32_t exponent, bands;
    gn_normal_space normal_space;
    gn_texture map[SCENE_MAP_COUNT];         /* a map without texels is absent */
    gn_sampler shadow_sampler;               /* the other maps use the sampler of scene_uniforms */
    gn_sampler map_sampler[SCENE_MAP_COUNT]; /* those of SCENE_METALLIC_ROUGHNESS, but its diffuse
                                                map and its shadow map */
    gn_mat4 shadow_from_world;
    float black, white; /* only for SCENE_DEPTH_COLOR */
    float alpha_cutoff; /* of the ready-made shaders that have one */
    bool has_spot_light;
    float light_range, cone[2]; /* of the light; the cosines are inner_cosine and outer_cosine */
    uint32_t more_light_count;
    gn_light more_lights[GN_MAX_LIGHTS - 1];
    float metallic, roughness, normal_scale, occlusion_strength; /* of SCENE_METALLIC_ROUGHNESS */
    gn_vec3 emissive;
    bool double_sided;
} scene_surface;

/* A clear of the whole target before a draw. A zeroed one clears nothing. */
typedef struct scene_clear {
    bool color, depth; /* what is cleared; `depth` stands for depth, stencil or both, whatever the
                          format has */
    float color_value[4];
    float depth_value;
    uint8_t stencil_value;
} scene_clear;

typedef struct scene_draw {
    scene_shader shader;

    /* State. The shader, uniforms and varying_count members are not read; the drawing side sets
     * them. SCENE_VERTEX_COLOR and SCENE_DERIVATIVES use interpolation[0..3] (red, green, blue,
     * alpha); other shaders set their own interpolation. With vertex_writes_point_size, if the
     * shader has sizes, a point's size is the first texture coordinate. The fragment_... members
     * are used with SCENE_INPUTS and are false otherwise; color_count is used with SCENE_OUTPUTS
     * and is 1 otherwise. */
    gn_pipeline state;

    /* The scene owns the memory behind the pointers of the mesh, of uniforms.texture and of
     * maps. */
    gn_mesh mesh;
    bool counted;         /* its primitives and fragments are counted */
    uint32_t index_count; /* elements behind mesh.indices, 0 without indices */

    /* Every shader uses clip_from_model, the lit shaders use the light, the textured shaders use
     * the texture and the sampler. The texture is a 2D texture of one level, except with
     * SCENE_SAMPLED, which takes any texture (for D16 to D32FS8 the depths; not 3D, which OpenGL
     * lacks). SCENE_UNLIT and the shaders that show a surface may have none. */
    scene_uniforms uniforms;
    scene_surface surface;

    /* Clip distance i, for i below state.clip_distance_count, is ((p0*x + p1*y) + p2*z) + p3*w of
     * the position attribute. */
    float clip_plane[GN_MAX_CLIP_DISTANCES][4];

    gn_mat4 view_from_model; /* only for SCENE_PHONG */
    bool phong_functions;    /* SCENE_PHONG as functions of one fragment; equal bits */
    gn_vec3 specular;        /* only for SCENE_PHONG, SCENE_MAPPED_PHONG and SCENE_BLINN_PHONG */

    scene_clear clear;
} scene_draw;

typedef struct scene {
    uint32_t width, height;
    gn_format color_format; /* any colour format */
    gn_format depth_format; /* GN_FORMAT_NONE, D16, D24, D32F, D24S8, D32FS8, S8 */
    float clear_color[4];
    float clear_depth;
    uint8_t clear_stencil;
    scene_draw *draws;
    size_t draw_count;
    gn_format more_colors[GN_MAX_COLORS - 1]; /* attachments from 1 on; GN_FORMAT_NONE: none */
    uint32_t samples; /* per pixel: 0 and 1 mean one sample, otherwise GN_SAMPLES */
} scene;

/* A drawn frame, bottom row first, tightly packed, in the formats of surface.h. A frame of a scene
 * with samples holds several images, one after the other: those of the samples, then the resolved
 * image. */
typedef struct scene_frame {
    uint32_t width, height;
    uint32_t images; /* 1, or GN_SAMPLES + 1 */
    gn_format color_format, depth_format;
    void *color;
    void *depth;                               /* null for GN_FORMAT_NONE */
    uint64_t samples_passed;                   /* the sum over the counted draws */
    gn_draw_statistics statistics;             /* likewise; the reference sets `primitives` only */
    gn_format more_formats[GN_MAX_COLORS - 1]; /* attachments 1 and on */
    void *more_colors[GN_MAX_COLORS - 1];
} scene_frame;

/* Returns attachment a, 0 to GN_MAX_COLORS - 1. */
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

/* How two frames of equal size and format differ. Bits are compared, but two NaN are equal, and
 * GN_FORMAT_SRGB8_A8 may differ by one step in its sRGB channels. */
typedef struct scene_difference {
    uint64_t color_pixels;    /* pixels with any channel different */
    uint64_t depth_pixels;    /* pixels with another depth or stencil */
    bool counts_differ;       /* samples_passed or statistics.primitives differ, or the library's
                                 statistics contradict each other; counts as one more pixel */
    uint64_t pixels;          /* pixels with a difference in colour or depth */
    uint64_t coverage_pixels; /* pixels that only one side has drawn on: exactly one side still has
                                 the clear value */
    double color_largest;     /* largest difference of a channel; for integers in steps */
    double depth_largest; /* largest difference of depth or stencil; in steps, floats as numbers */
    uint32_t x, y, image; /* the first differing pixel, if pixels > 0 */
} scene_difference;

/* Creates an empty scene; scene_add_draw adds draws to its list. The scene owns all its memory, and
 * scene_free frees it. If an allocation fails, the program ends with a message, since scenes are
 * test data. */
scene *scene_create(uint32_t width, uint32_t height, gn_format color, gn_format depth);
void scene_free(scene *s);
scene *scene_copy(const scene *s);

/* Fills a draw with zeros and its matrices with identities. */
void scene_default_draw(scene_draw *d);

/* A new default draw at the end of the list. The pointer is good until the next scene_add_draw. */
scene_draw *scene_add_draw(scene *s);
void scene_remove_draw(scene *s, size_t index);

/* Returns the scene's size, formats and clear values as they are for the clear before a draw: a
 * format is GN_FORMAT_NONE if it is not cleared. The result owns nothing. */
scene scene_of_clear(const scene *s, const scene_draw *d);

/* Copy data into a draw's mesh; earlier data is freed. Attributes are tightly packed; all
 * attributes of a mesh have the same number of vertices. Setting the position (of a mesh without
 * indices) or the indices makes the draw draw all elements; change mesh.first and mesh.count
 * afterwards. */
void scene_set_attribute(scene_draw *d, gn_shader_attribute attribute, const float *data,
                         uint32_t components, uint32_t vertex_count);
void scene_set_indices(scene_draw *d, const uint32_t *indices, uint32_t count,
                       gn_index_format format);

/* Copies a tightly packed 2D texture of one level into a draw; t grows with the row. */
void scene_set_texture(scene_draw *d, const void *texels, uint32_t width, uint32_t height,
                       gn_format format);

/* Copies any texture into a draw: its levels are one after the other, tightly packed, in memory
 * that begins with the first level's texels. */
void scene_set_levels(scene_draw *d, const gn_texture *texture);

/* Extent of a level: columns, rows, and slices, layers or faces. */
typedef struct scene_extent {
    uint32_t width, height, layers;
} scene_extent;

scene_extent scene_level_extent(const gn_texture *t, uint32_t level);

/* Number of levels; at least 1. */
uint32_t scene_level_count(const gn_texture *t);

/* Elements of all levels of a texture. */
size_t scene_texture_elements(const gn_texture *t);

/* Element i of aligned memory; elements have 1, 2 or 4 bytes. */
uint32_t scene_element(const void *elements, size_t size, size_t i);
void scene_set_element(void *elements, size_t size, size_t i, uint32_t value);

/* Points the levels of a texture, whose other members are set, into memory, tightly packed one
 * after the other. */
void scene_pack_texture(gn_texture *t, const void *memory);

/* Copies a map into a draw, packed. */
void scene_set_map(scene_draw *d, scene_map map, const gn_texture *texture);

/* Whether a draw's shader reads the lights of `surface`. */
static inline bool scene_draw_has_lights(const scene_draw *d)
{
    return scene_shader_is_lit(d->shader) && d->shader != SCENE_PHONG &&
           d->shader != SCENE_NORMAL_COLOR;
}

/* Whether a draw's shader discards fragments of low alpha. */
static inline bool scene_draw_has_cutoff(const scene_draw *d)
{
    return d->surface.alpha_cutoff > 0.0f && (d->shader == SCENE_UNLIT || scene_draw_has_lights(d));
}

/* The kind of a draw's light. */
static inline gn_light_kind scene_light_kind(const scene_surface *s)
{
    return s->has_spot_light    ? GN_LIGHT_SPOT
           : s->has_point_light ? GN_LIGHT_POINT
                                : GN_LIGHT_DIRECTIONAL;
}

/* Whether a draw's shader reads uniforms.texture. */
static inline bool scene_draw_has_texture(const scene_draw *d)
{
    return scene_shader_is_textured(d->shader) ||
           ((d->shader == SCENE_UNLIT || scene_shader_shows_surface(d->shader)) &&
            d->uniforms.texture.level[0].texels);
}

/* Whether a draw has this map; whether it has any. */
static inline bool scene_draw_has_map(const scene_draw *d, scene_map map)
{
    return scene_shader_shows_surface(d->shader) && d->surface.map[map].level[0].texels;
}

/* The sampler of a map. */
static inline const gn_sampler *scene_map_sampler(const scene_draw *d, scene_map map)
{
    if (map == SCENE_SHADOW_MAP)
        return &d->surface.shadow_sampler;
    return d->shader == SCENE_METALLIC_ROUGHNESS ? &d->surface.map_sampler[map]
                                                 : &d->uniforms.sampler;
}

/* Bytes of an index; 0 for GN_INDEX_NONE. */
size_t scene_index_size(gn_index_format format);

/* Number of the vertex that element i of a mesh names, counted from the first index. */
uint32_t scene_vertex_of(const gn_mesh *mesh, uint32_t i);

/* The number of triangles, lines and points that the draws submit, before clipping. */
uint64_t scene_triangle_count(const scene *s);

/* Writes the scene as text, from which scene_read restores it bit for bit (scene_text.h specifies
 * the text). scene_write returns false if writing failed. scene_read returns null on failure, with
 * a message that has the line number in error. */
bool scene_write(const scene *s, FILE *out);
scene *scene_read(FILE *in, char *error, size_t error_size);

/* Whether pixels of a scene have several samples. */
static inline bool scene_is_sampled(const scene *s)
{
    return s->samples > 1;
}

/* Whether a pipeline asks for all samples to be shaded, so that all varyings are at samples. */
static inline bool scene_shades_samples(const gn_pipeline *p)
{
    return p->samples.shading_enabled && p->samples.least_shading * GN_SAMPLES > 1.0f;
}

/* Whether a varying of a draw may be interpolated elsewhere than at pixels' centres. */
static inline bool scene_draw_is_located(const scene_draw *d)
{
    bool located = scene_shades_samples(&d->state);

    for (int c = 0; c < 4; ++c)
        located = located || d->state.program.interpolated_at[c] != GN_AT_CENTER;
    return located;
}

/* Whether all vertices of a draw have one w in clip space, computed without rounding. */
bool scene_draw_has_one_w(const scene_draw *d);

/* Creates a zeroed frame for a scene; false if there is not enough memory. */
bool scene_frame_allocate(scene_frame *frame, const scene *s);
void scene_frame_free(scene_frame *frame);

/* For sizing a workspace: the greatest number of scalar varyings of any draw's shader, and with it
 * the greatest number of clip distances. */
#define SCENE_VARYINGS GN_SHADER_VARYINGS
uint32_t scene_varyings(const scene *s);

/* Bytes of a workspace in which every draw of the scene shades each vertex once and may run on
 * several threads. */
size_t scene_workspace_size(const scene *s);

/* Clears and draws with the library, into surfaces of the scene's size and formats, which may be
 * top-down, and in the caller's workspace. Returns the first status that is not GN_OK. */
gn_status scene_draw_to_target(const scene *s, const gn_target *target, gn_workspace *workspace);

/* Draws as scene_draw_to_target does, into a frame, and resolves samples. */
gn_status scene_draw_in_workspace(const scene *s, scene_frame *frame, gn_workspace *workspace);

/* Draws as scene_draw_in_workspace does, in a workspace that it allocates; the size is
 * scene_workspace_size if workspace_bytes is 0. */
gn_status scene_draw_library(const scene *s, scene_frame *frame, size_t workspace_bytes,
                             gn_backend backend);

/* Compares two frames. The scene's clear values decide which pixels count as drawn. */
scene_difference scene_compare(const scene *s, const scene_frame *ours,
                               const scene_frame *reference);

#endif
