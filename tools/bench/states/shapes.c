/* Builds the meshes of rows. */
#include "shapes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../scenes.h"
#include "scene_memory.h"
#include "words.h"

/* Width of a sphere's outline, as a part of the target's side: that of S3. */
#define ACROSS 0.8f

/* A sphere of bench_build: six faces of side x side vertices. */
static uint32_t vertex_at(uint32_t side, uint32_t face, uint32_t x, uint32_t y)
{
    return (face * side + y) * side + x;
}

/* Indices under construction. */
typedef struct list {
    uint32_t *index, count;
} list;

#define RESTART UINT32_MAX

static void put(list *l, uint32_t index)
{
    l->index[l->count++] = index;
}

/* Each strip goes along one column of squares; its triangles have the order of corners that the
 * sphere's squares have. */
static void put_strip(list *l, uint32_t side, uint32_t face, uint32_t x)
{
    for (uint32_t y = 0; y < side; ++y) {
        put(l, vertex_at(side, face, x, y));
        put(l, vertex_at(side, face, x + 1, y));
    }
}

/* Without restarts the last vertex of a strip and the first of the next are repeated. Each strip
 * has an even number of vertices, so that the next one is not turned over. */
static void put_strips(list *l, uint32_t side, bool restarts)
{
    for (uint32_t face = 0; face < 6; ++face) {
        for (uint32_t x = 0; x + 1 < side; ++x) {
            if (l->count > 0 && restarts) {
                put(l, RESTART);
            } else if (l->count > 0) {
                put(l, l->index[l->count - 1]);
                put(l, vertex_at(side, face, x, 0));
            }
            put_strip(l, side, face, x);
        }
    }
}

/* A fan around every second vertex along both directions. */
static void put_fans(list *l, uint32_t side)
{
    static const int ring[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                   {-1, -1}, {0, -1}, {1, -1}, {1, 0}};

    for (uint32_t face = 0; face < 6; ++face) {
        for (uint32_t y = 1; y + 1 < side; y += 2) {
            for (uint32_t x = 1; x + 1 < side; x += 2) {
                if (l->count > 0)
                    put(l, RESTART);
                put(l, vertex_at(side, face, x, y));
                for (int i = 0; i < 9; ++i) {
                    put(l, vertex_at(side, face, (uint32_t)((int)x + ring[i][0]),
                                     (uint32_t)((int)y + ring[i][1])));
                }
            }
        }
    }
}

/* The edges along both directions of the squares. */
static void put_lines(list *l, uint32_t side)
{
    for (uint32_t face = 0; face < 6; ++face) {
        for (uint32_t y = 0; y < side; ++y) {
            for (uint32_t x = 0; x + 1 < side; ++x) {
                put(l, vertex_at(side, face, x, y));
                put(l, vertex_at(side, face, x + 1, y));
                put(l, vertex_at(side, face, y, x));
                put(l, vertex_at(side, face, y, x + 1));
            }
        }
    }
}

/* A strip or loop along every row of vertices, and one along every column. */
static void put_line_strips(list *l, uint32_t side)
{
    for (uint32_t row = 0; row < 12 * side; ++row) {
        const uint32_t face = row / (2 * side), y = row % (2 * side) / 2;

        if (l->count > 0)
            put(l, RESTART);
        for (uint32_t x = 0; x < side; ++x)
            put(l, row % 2 ? vertex_at(side, face, y, x) : vertex_at(side, face, x, y));
    }
}

/* Replaces the sphere's triangles by other primitives. */
static void set_primitives(scene_draw *d, state_shape shape, uint32_t squares)
{
    const uint32_t side = squares + 1;
    list l = {scene_allocate((size_t)side * side * 60, sizeof(uint32_t)), 0};

    switch (shape) {
    case SHAPE_STRIPS:
    case SHAPE_ONE_STRIP:
        d->state.raster.topology = GN_TRIANGLE_STRIP;
        put_strips(&l, side, shape == SHAPE_STRIPS);
        break;
    case SHAPE_FANS:
        d->state.raster.topology = GN_TRIANGLE_FAN;
        put_fans(&l, side);
        break;
    case SHAPE_LINES:
        d->state.raster.topology = GN_LINES;
        put_lines(&l, side);
        break;
    default:
        d->state.raster.topology = shape == SHAPE_LINE_STRIPS ? GN_LINE_STRIP : GN_LINE_LOOP;
        put_line_strips(&l, side);
        break;
    }
    if (shape != SHAPE_ONE_STRIP && shape != SHAPE_LINES)
        d->mesh.restart = GN_RESTART_FIXED_INDEX;
    scene_set_indices(d, l.index, l.count, GN_INDEX_UINT32);
    free(l.index);
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
    d->state.depth.test = true;
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
        d->state.depth.test = true;
        d->state.raster.cull = GN_CULL_BACK;
        place_cube(i, s->width, &d->uniforms.light.clip_from_model);
        scene_set_attribute(d, GN_ATTRIBUTE_POSITION, position[0], 3, 24);
        scene_set_attribute(d, GN_ATTRIBUTE_COLOR, color[0], 3, 24);
        scene_set_indices(d, index, 36, GN_INDEX_UINT16);
    }
}

static bench_shape bench_shape_of(state_shape shape)
{
    switch (shape) {
    case SHAPE_SCREENS:
        return BENCH_QUADS;
    case SHAPE_ROLLED:
        return BENCH_ROLLED_QUADS;
    case SHAPE_TEXTURED:
        return BENCH_TEXTURED_QUADS;
    case SHAPE_SAMPLED:
        return BENCH_LEVEL_QUADS;
    case SHAPE_PHONG:
        return BENCH_READY_PHONG_SPHERE;
    case SHAPE_USER:
        return BENCH_PHONG_SPHERE;
    case SHAPE_NOTHING:
    case SHAPE_POINTS:
    case SHAPE_CUBES:
        return BENCH_CLEAR;
    default:
        return BENCH_SPHERE;
    }
}

scene *state_scene(const state_row *row, char *error, size_t error_size)
{
    const bench_scene b = {"", bench_shape_of(row->shape), row->side, row->detail, ACROSS};
    scene *const s = bench_build(&b);

    switch (row->shape) {
    case SHAPE_STRIPS:
    case SHAPE_ONE_STRIP:
    case SHAPE_FANS:
    case SHAPE_LINES:
    case SHAPE_LINE_STRIPS:
    case SHAPE_LINE_LOOPS:
        set_primitives(&s->draws[0], row->shape, row->detail);
        break;
    case SHAPE_POINTS:
        add_points(s, row->detail);
        break;
    case SHAPE_CUBES:
        add_cubes(s, row->detail);
        break;
    case SHAPE_TEXTURED:
        word_noise(&s->draws[0], GN_TEXTURE_2D, GN_FORMAT_RGBA8, 256, 1, 1);
        break;
    case SHAPE_SAMPLED:
        word_noise(&s->draws[0], GN_TEXTURE_2D, GN_FORMAT_RGBA8, 256, 1, 9);
        break;
    default:
        break;
    }
    if (!words_apply(s, row->text, error, error_size)) {
        scene_free(s);
        return NULL;
    }
    return s;
}

scene *state_destination(const state_row *row, const scene *s, char *error, size_t error_size)
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
