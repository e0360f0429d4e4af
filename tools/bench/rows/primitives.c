/* Strips, fans and lines of a sphere's vertices. */
#include <stdlib.h>

#include "rows.h"
#include "scene_memory.h"

/* A sphere of shapes.c: six faces of side x side vertices. */
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

void row_set_primitives(scene_draw *d, row_shape shape, uint32_t squares)
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
