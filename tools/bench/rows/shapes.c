/* Builds the scenes of rows. */
#include <math.h>
#include <stdlib.h>

#include "rows.h"
#include "scene_memory.h"
#include "words.h"

#define ACROSS 0.8f

enum { MOST_QUADS = 64, TEXTURE_SIDE = 512, STATE_TEXTURE_SIDE = 256 };

static scene_draw *add_draw(scene *s, scene_shader shader)
{
    scene_draw *d = scene_add_draw(s);
    gn_transform projection;

    d->shader = shader;
    d->state.depth.test_enabled = true;
    gn_perspective_rh_no(GN_PI / 2, 1.0f, 0.5f, 200.0f, &projection);
    d->uniforms.light.clip_from_model = projection.matrix;
    return d;
}

static void add_texture(scene_draw *d, uint32_t side, uint32_t levels)
{
    word_noise(d, GN_TEXTURE_2D, GN_FORMAT_RGBA8, side, 1, levels);
    d->uniforms.sampler.magnify = GN_MAGNIFY_LINEAR;
    d->uniforms.sampler.minify = levels > 1 ? GN_MINIFY_LINEAR_MIPMAP_LINEAR : GN_MINIFY_LINEAR;
}

/* Rolled quads are turned, and 1.36 times as large, so that they still cover the target. */
static void add_quads(scene *s, uint32_t quads, row_shape shape)
{
    static const float corner_color[4][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
    float position[MOST_QUADS * 4][3], color[MOST_QUADS * 4][3];
    float normal[MOST_QUADS * 4][3], texcoord[MOST_QUADS * 4][2];
    uint32_t index[MOST_QUADS * 6];
    const bool textured = shape == SHAPE_TEXTURED || shape == SHAPE_SAMPLED;
    const scene_shader shader = shape == SHAPE_TEXTURED  ? SCENE_TEXTURED_GOURAUD
                                : shape == SHAPE_SAMPLED ? SCENE_SAMPLED
                                                         : SCENE_VERTEX_COLOR;

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
            if (shape == SHAPE_ROLLED) {
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
        scene_set_attribute(d, GN_ATTRIBUTE_TEXCOORD, texcoord[0], 2, quads * 4);
        add_texture(d, STATE_TEXTURE_SIDE, shape == SHAPE_SAMPLED ? 9 : 1);
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
        add_texture(d, TEXTURE_SIDE, 1);
    } else {
        scene_set_attribute(d, GN_ATTRIBUTE_COLOR, m.color, 3, m.vertex_count);
    }
    scene_set_indices(d, m.index, m.index_count, GN_INDEX_UINT32);
    free(m.normal);
    free(m.color);
    free(m.texcoord);
    free(m.index);
}

/* A grid of points over the target; the nearer ones are below. */
static void add_points(scene *s, uint32_t side)
{
    const size_t count = (size_t)side * side;
    float(*const position)[3] = scene_allocate(count, sizeof *position);
    float(*const color)[3] = scene_allocate(count, sizeof *color);
    scene_draw *const d = scene_add_draw(s);

    for (size_t i = 0; i < count; ++i) {
        const float x = ((float)(i % side) + 0.5f) / (float)side;
        const float y = ((float)(i / side) + 0.5f) / (float)side;

        position[i][0] = 2.0f * x - 1.0f;
        position[i][1] = 2.0f * y - 1.0f;
        position[i][2] = y;
        color[i][0] = x;
        color[i][1] = y;
        color[i][2] = 0.5f;
    }
    d->shader = SCENE_VERTEX_COLOR;
    d->state.depth.test_enabled = true;
    d->state.raster.topology = GN_POINTS;
    scene_set_attribute(d, GN_ATTRIBUTE_POSITION, position[0], 3, (uint32_t)count);
    scene_set_attribute(d, GN_ATTRIBUTE_COLOR, color[0], 3, (uint32_t)count);
    free(position);
    free(color);
}

/* The matrix of cube i: about 10 pixels across, turned, in a grid of 50 cubes a row. */
static void place_cube(uint32_t i, uint32_t side, gn_mat4 *clip_from_model)
{
    const uint32_t columns = 50;
    const gn_vec3 place = {((float)(i % columns) + 0.5f) / (float)columns * 2.0f - 1.0f,
                           ((float)(i / columns) + 0.5f) / 40.0f * 2.0f - 1.0f,
                           (float)(i % 7) * 0.1f - 0.3f};
    const float size = 8.0f / (float)side;
    gn_transform moved, turned, scaled;

    gn_translate(place, &moved);
    gn_rotate_axis((gn_vec3){1.0f, 2.0f, 0.5f}, 0.1f * (float)i, &turned);
    gn_scale((gn_vec3){size, size, size}, &scaled);
    gn_transform_compose(&moved, &turned, &moved);
    gn_transform_compose(&moved, &scaled, &moved);
    *clip_from_model = moved.matrix;
}

static void add_cubes(scene *s, uint32_t count)
{
    static const uint32_t square[6] = {0, 1, 2, 2, 1, 3};
    float position[24][3], color[24][3];
    uint32_t index[36];

    for (uint32_t v = 0; v < 24; ++v) {
        const uint32_t axis = v / 8, high = v / 4 % 2;
        const float u = v & 1 ? 1.0f : -1.0f, w = v & 2 ? 1.0f : -1.0f;

        position[v][axis] = high ? 1.0f : -1.0f;
        position[v][(axis + 1) % 3] = high ? u : -u;
        position[v][(axis + 2) % 3] = w;
        for (int c = 0; c < 3; ++c)
            color[v][c] = 0.5f + 0.5f * position[v][c];
    }
    for (uint32_t i = 0; i < 36; ++i)
        index[i] = i / 6 * 4 + square[i % 6];
    for (uint32_t i = 0; i < count; ++i) {
        scene_draw *const d = scene_add_draw(s);

        d->shader = SCENE_VERTEX_COLOR;
        d->state.depth.test_enabled = true;
        d->state.raster.cull = GN_CULL_BACK;
        place_cube(i, s->width, &d->uniforms.light.clip_from_model);
        scene_set_attribute(d, GN_ATTRIBUTE_POSITION, position[0], 3, 24);
        scene_set_attribute(d, GN_ATTRIBUTE_COLOR, color[0], 3, 24);
        scene_set_indices(d, index, 36, GN_INDEX_UINT16);
    }
}

/* The shape with its plain state. */
static scene *plain_scene(const bench_row *row)
{
    scene *const s = scene_create(row->side, row->side, GN_FORMAT_RGBA8, GN_FORMAT_D24);
    const float across = row->across > 0.0f ? row->across : ACROSS;

    s->clear_color[3] = 1.0f;
    switch (row->shape) {
    case SHAPE_NOTHING:
        break;
    case SHAPE_SCREENS:
    case SHAPE_ROLLED:
    case SHAPE_TEXTURED:
    case SHAPE_SAMPLED:
        add_quads(s, row->detail, row->shape);
        break;
    case SHAPE_SPHERE:
        add_sphere(s, row->detail, across, SCENE_GOURAUD);
        break;
    case SHAPE_PHONG:
        add_sphere(s, row->detail, across, SCENE_MAPPED_PHONG);
        break;
    case SHAPE_USER:
        add_sphere(s, row->detail, across, SCENE_PHONG);
        break;
    case SHAPE_POINTS:
        add_points(s, row->detail);
        break;
    case SHAPE_CUBES:
        add_cubes(s, row->detail);
        break;
    default:
        add_sphere(s, row->detail, across, SCENE_GOURAUD);
        row_set_primitives(&s->draws[0], row->shape, row->detail);
        break;
    }
    return s;
}

scene *row_scene(const bench_row *row, char *error, size_t error_size)
{
    scene *const s = plain_scene(row);

    if (!words_apply(s, row->text, error, error_size)) {
        scene_free(s);
        return NULL;
    }
    return s;
}

scene *row_destination(const bench_row *row, const scene *s, char *error, size_t error_size)
{
    scene *to;

    if (row->work == WORK_LEVELS) {
        const gn_texture *const t = &s->draws[0].uniforms.texture;
        const uint32_t layers = scene_level_extent(t, 0).layers;

        return scene_create(t->width / 2, t->height * layers, t->format, GN_FORMAT_NONE);
    }
    to = scene_create(s->width, s->height, s->color_format, GN_FORMAT_NONE);
    if (!words_apply(to, row->to, error, error_size)) {
        scene_free(to);
        return NULL;
    }
    return to;
}
