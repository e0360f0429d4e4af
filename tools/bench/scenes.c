/* Builds the benchmark's scenes. */
#include "scenes.h"

#include <math.h>
#include <stdlib.h>

#include "scene_memory.h"

enum { MOST_QUADS = 64, TEXTURE_SIDE = 512 };

const bench_scene bench_scenes[BENCH_SCENE_COUNT] = {
    {"S1", BENCH_QUADS, 1024, 64, 0.0f},
    {"S1 rolled", BENCH_ROLLED_QUADS, 1024, 64, 0.0f},
    {"S2", BENCH_TEXTURED_QUADS, 1024, 64, 0.0f},
    {"S2 nearest", BENCH_NEAREST_QUADS, 1024, 64, 0.0f},
    {"S2 levels", BENCH_LEVEL_QUADS, 1024, 64, 0.0f},
    {"S2 cube", BENCH_CUBE_QUADS, 1024, 64, 0.0f},
    {"S3", BENCH_SPHERE, 1024, 129, 820.0f / 1024.0f},
    {"S4", BENCH_PHONG_SPHERE, 1024, 29, 1000.0f / 1024.0f},
    {"S4 ready", BENCH_READY_PHONG_SPHERE, 1024, 29, 1000.0f / 1024.0f},
    {"S5", BENCH_SPHERE, 1024, 289, 564.0f / 1024.0f},
    {"S6", BENCH_CLEAR, 1024, 0, 0.0f},
};

const bench_scene bench_scale[BENCH_SCALE_COUNT] = {
    {"triangles/972", BENCH_SPHERE, 1024, 9, 0.8f},
    {"triangles/3888", BENCH_SPHERE, 1024, 18, 0.8f},
    {"triangles/16428", BENCH_SPHERE, 1024, 37, 0.8f},
    {"triangles/63948", BENCH_SPHERE, 1024, 73, 0.8f},
    {"triangles/255792", BENCH_SPHERE, 1024, 146, 0.8f},
    {"triangles/1002252", BENCH_SPHERE, 1024, 289, 0.8f},
    {"triangles/3995148", BENCH_SPHERE, 1024, 577, 0.8f},
    {"fill/256", BENCH_QUADS, 256, 4, 0.0f},
    {"fill/512", BENCH_QUADS, 512, 4, 0.0f},
    {"fill/1024", BENCH_QUADS, 1024, 4, 0.0f},
    {"fill/2048", BENCH_QUADS, 2048, 4, 0.0f},
    {"fill/4096", BENCH_QUADS, 4096, 4, 0.0f},
    {"fill/8192", BENCH_QUADS, 8192, 4, 0.0f},
    {"sphere/256", BENCH_SPHERE, 256, 129, 0.8f},
    {"sphere/512", BENCH_SPHERE, 512, 129, 0.8f},
    {"sphere/1024", BENCH_SPHERE, 1024, 129, 0.8f},
    {"sphere/2048", BENCH_SPHERE, 2048, 129, 0.8f},
    {"sphere/4096", BENCH_SPHERE, 4096, 129, 0.8f},
    {"sphere/8192", BENCH_SPHERE, 8192, 129, 0.8f},
};

static scene_draw *add_draw(scene *s, scene_shader shader)
{
    scene_draw *d = scene_add_draw(s);
    gn_transform projection;

    d->shader = shader;
    d->state.depth.test = true;
    gn_perspective_rh_no(GN_PI / 2, 1.0f, 0.5f, 200.0f, &projection);
    d->uniforms.light.clip_from_model = projection.matrix;
    return d;
}

/* Bytes without a pattern, equal in every run (the finalizer of MurmurHash3). */
static void fill_texels(uint32_t *texels, uint32_t count)
{
    for (uint32_t i = 0; i < count; ++i) {
        uint32_t h = i;

        h = (h ^ h >> 16) * UINT32_C(0x85ebca6b);
        h = (h ^ h >> 13) * UINT32_C(0xc2b2ae35);
        texels[i] = h ^ h >> 16;
    }
}

static void add_texture(scene_draw *d)
{
    static uint32_t texels[TEXTURE_SIDE * TEXTURE_SIDE];

    fill_texels(texels, TEXTURE_SIDE * TEXTURE_SIDE);
    scene_set_texture(d, texels, TEXTURE_SIDE, TEXTURE_SIDE, GN_FORMAT_RGBA8);
    d->uniforms.sampler.magnify = GN_MAGNIFY_LINEAR;
    d->uniforms.sampler.minify = GN_MINIFY_LINEAR;
}

/* All levels of a texture, each with texels of its own. */
static void add_levels(scene_draw *d, gn_texture_target target)
{
    static uint32_t texels[2 * 6 * TEXTURE_SIDE * TEXTURE_SIDE];
    const uint32_t levels = 10; /* 512 to 1 */
    gn_texture texture;

    fill_texels(texels, sizeof texels / sizeof *texels);
    if (gn_texture_packed(target, GN_FORMAT_RGBA8, TEXTURE_SIDE, TEXTURE_SIDE, 1, levels, texels,
                          &texture) != GN_OK)
        abort();
    scene_set_levels(d, &texture);
    d->uniforms.sampler.magnify = GN_MAGNIFY_LINEAR;
    d->uniforms.sampler.minify = GN_MINIFY_LINEAR_MIPMAP_LINEAR;
}

static void set_quads_texture(scene_draw *d, bench_shape shape)
{
    if (shape == BENCH_LEVEL_QUADS || shape == BENCH_CUBE_QUADS) {
        add_levels(d, shape == BENCH_CUBE_QUADS ? GN_TEXTURE_CUBE : GN_TEXTURE_2D);
        return;
    }
    add_texture(d);
    if (shape == BENCH_NEAREST_QUADS) {
        d->uniforms.sampler.magnify = GN_MAGNIFY_NEAREST;
        d->uniforms.sampler.minify = GN_MINIFY_NEAREST;
    }
}

/* For a cube the texture coordinates are a direction, the corner's. Rolled quads are turned and
 * enlarged so that they still cover the target: a rotation times 1.36. */
static void add_quads(scene *s, uint32_t quads, bench_shape shape)
{
    static const float corner_color[4][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
    float position[MOST_QUADS * 4][3], color[MOST_QUADS * 4][3];
    float normal[MOST_QUADS * 4][3], texcoord[MOST_QUADS * 4][3];
    uint32_t index[MOST_QUADS * 6];
    const bool textured = shape != BENCH_QUADS && shape != BENCH_ROLLED_QUADS;
    const scene_shader shader = !textured ? SCENE_VERTEX_COLOR
                                : shape == BENCH_LEVEL_QUADS || shape == BENCH_CUBE_QUADS
                                    ? SCENE_SAMPLED
                                    : SCENE_TEXTURED_GOURAUD;

    for (uint32_t q = 0; q < quads; ++q) {
        const float distance = 1.0f + 100.0f * (float)(quads - 1 - q) / (float)(quads - 1);
        const uint32_t order[6] = {0, 1, 2, 2, 1, 3};

        for (uint32_t v = 0; v < 4; ++v) {
            const uint32_t i = 4 * q + v;
            const float d = v < 2 ? distance : 1.25f * distance;

            position[i][0] = v & 1 ? d : -d;
            position[i][1] = v < 2 ? -d : d;
            position[i][2] = -d;
            texcoord[i][0] = v & 1 ? 4.0f : 0.0f;
            texcoord[i][1] = v < 2 ? 0.0f : 4.0f;
            texcoord[i][2] = 0.0f;
            for (int c = 0; shape == BENCH_CUBE_QUADS && c < 3; ++c)
                texcoord[i][c] = position[i][c] / distance;
            if (shape == BENCH_ROLLED_QUADS) {
                position[i][0] = 1.3f * (v & 1 ? d : -d) - 0.4f * (v < 2 ? -d : d);
                position[i][1] = 0.4f * (v & 1 ? d : -d) + 1.3f * (v < 2 ? -d : d);
            }
            for (int c = 0; c < 3; ++c) {
                color[i][c] = corner_color[v][c];
                normal[i][c] = c == 2 ? 1.0f : 0.0f;
            }
        }
        for (uint32_t i = 0; i < 6; ++i)
            index[6 * q + i] = 4 * q + order[i];
    }
    scene_draw *d = add_draw(s, shader);
    scene_set_attribute(d, GN_ATTRIBUTE_POSITION, position[0], 3, quads * 4);
    scene_set_attribute(d, GN_ATTRIBUTE_COLOR, color[0], 3, quads * 4);
    if (textured) { /* under a light that leaves the colours as they are */
        d->uniforms.light.ambient = (gn_vec3){1.0f, 1.0f, 1.0f};
        d->uniforms.light.light_direction = (gn_vec3){0.0f, 0.0f, 1.0f};
        scene_set_attribute(d, GN_ATTRIBUTE_NORMAL, normal[0], 3, quads * 4);
        scene_set_attribute(d, GN_ATTRIBUTE_TEXCOORD, texcoord[0], 3, quads * 4);
        set_quads_texture(d, shape);
    }
    scene_set_indices(d, index, quads * 6, GN_INDEX_UINT32);
}

typedef struct sphere_mesh {
    uint32_t vertex_count, index_count;
    float *normal, *color, *texcoord;
    uint32_t *index;
} sphere_mesh;

/* A cube with n x n squares per face, projected to a unit sphere; each face has its own
 * vertices. */
static sphere_mesh make_sphere(uint32_t n)
{
    static const int axes[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                   {1, 0, 2}, {2, 1, 0}, {0, 2, 1}};
    const uint32_t side = n + 1;
    sphere_mesh m = {6 * side * side, n * n * 36, NULL, NULL, NULL, NULL};
    uint32_t v = 0, i = 0;

    m.normal = scene_allocate(m.vertex_count, 3 * sizeof(float));
    m.color = scene_allocate(m.vertex_count, 3 * sizeof(float));
    m.texcoord = scene_allocate(m.vertex_count, 2 * sizeof(float));
    m.index = scene_allocate(m.index_count, sizeof(uint32_t));
    for (uint32_t face = 0; face < 6; ++face) {
        const uint32_t base = v;

        for (uint32_t y = 0; y < side; ++y) {
            for (uint32_t x = 0; x < side; ++x, ++v) {
                float p[3];

                p[axes[face][0]] = 2.0f * (float)x / (float)n - 1.0f;
                p[axes[face][1]] = 2.0f * (float)y / (float)n - 1.0f;
                p[axes[face][2]] = face < 3 ? 1.0f : -1.0f;
                const float length = sqrtf(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
                for (uint32_t c = 0; c < 3; ++c) {
                    m.normal[3 * v + c] = p[c] / length;
                    m.color[3 * v + c] = 0.5f + 0.5f * p[c] / length;
                }
                m.texcoord[2 * v] = (float)x / (float)n;
                m.texcoord[2 * v + 1] = (float)y / (float)n;
            }
        }
        for (uint32_t y = 0; y < n; ++y) {
            for (uint32_t x = 0; x < n; ++x) {
                const uint32_t a = base + y * side + x;
                const uint32_t square[6] = {a, a + 1, a + side, a + side, a + 1, a + side + 1};

                for (int k = 0; k < 6; ++k)
                    m.index[i++] = square[k];
            }
        }
    }
    return m;
}

/* From a distance at which the outline, at the angle whose sine is 1 / distance, is as wide as
 * `across`. */
static void add_sphere(scene *s, uint32_t n, float across, scene_shader shader)
{
    const float distance = sqrtf(1.0f + across * across) / across;
    sphere_mesh m = make_sphere(n);
    scene_draw *d = add_draw(s, shader);
    gn_transform back;

    gn_translate((gn_vec3){0.0f, 0.0f, -distance}, &back);
    gn_mat4_multiply(&d->uniforms.light.clip_from_model, &back.matrix,
                     &d->uniforms.light.clip_from_model);
    d->uniforms.light.light_direction = (gn_vec3){0.0f, 0.6f, 0.8f};
    d->uniforms.light.ambient = (gn_vec3){0.2f, 0.2f, 0.2f};
    d->uniforms.light.diffuse = (gn_vec3){0.8f, 0.8f, 0.8f};
    d->state.raster.cull = GN_CULL_BACK;
    scene_set_attribute(d, GN_ATTRIBUTE_POSITION, m.normal, 3, m.vertex_count);
    scene_set_attribute(d, GN_ATTRIBUTE_NORMAL, m.normal, 3, m.vertex_count);
    if (shader != SCENE_GOURAUD) {
        d->view_from_model = back.matrix;
        d->surface.world_from_model = back.matrix;
        d->surface.exponent = 32;
        d->specular = (gn_vec3){0.5f, 0.5f, 0.5f};
        scene_set_attribute(d, GN_ATTRIBUTE_TEXCOORD, m.texcoord, 2, m.vertex_count);
        add_texture(d);
    } else {
        scene_set_attribute(d, GN_ATTRIBUTE_COLOR, m.color, 3, m.vertex_count);
    }
    scene_set_indices(d, m.index, m.index_count, GN_INDEX_UINT32);
    free(m.normal);
    free(m.color);
    free(m.texcoord);
    free(m.index);
}

scene *bench_build(const bench_scene *b)
{
    scene *s = scene_create(b->side, b->side, GN_FORMAT_RGBA8, GN_FORMAT_D24);

    s->clear_color[3] = 1.0f;
    switch (b->shape) {
    case BENCH_CLEAR:
        break;
    case BENCH_QUADS:
    case BENCH_ROLLED_QUADS:
    case BENCH_TEXTURED_QUADS:
    case BENCH_NEAREST_QUADS:
    case BENCH_LEVEL_QUADS:
    case BENCH_CUBE_QUADS:
        add_quads(s, b->detail, b->shape);
        break;
    case BENCH_SPHERE:
        add_sphere(s, b->detail, b->across, SCENE_GOURAUD);
        break;
    case BENCH_PHONG_SPHERE:
        add_sphere(s, b->detail, b->across, SCENE_PHONG);
        break;
    case BENCH_READY_PHONG_SPHERE:
        add_sphere(s, b->detail, b->across, SCENE_MAPPED_PHONG);
        break;
    }
    return s;
}
