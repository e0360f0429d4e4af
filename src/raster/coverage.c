/* Coverage: the pixels of a triangle, found in blocks of 4x4. Edge values at the
 * corner of a block are exact in 64 bits; within it 32 bits are enough. */
#include "raster.h"

#include "../lanes/lanes.h"

/* Above every change of an edge function within a block, 3 * (|per_x| + |per_y|),
 * the differences being below 2^25. A value clamped to it keeps its sign there. */
#define EDGE_LIMIT ((int64_t)1 << 28)

typedef struct block_edge {
    lanes_i offset; /* from the block's lower left pixel to each of its pixels */
    int32_t least;  /* the extremes of offset */
    int32_t greatest;
} block_edge;

static block_edge make_block_edge(const edge_function *edge)
{
    const int32_t along_x = -edge->per_x * (BLOCK_SIZE - 1);
    const int32_t along_y = edge->per_y * (BLOCK_SIZE - 1);
    int32_t offset[GN_LANES];
    block_edge b;

    b.least = (along_x < 0 ? along_x : 0) + (along_y < 0 ? along_y : 0);
    b.greatest = (along_x > 0 ? along_x : 0) + (along_y > 0 ? along_y : 0);
    GN_EACH_LANE (l)
        offset[l] = edge->per_y * (l / BLOCK_SIZE) - edge->per_x * (l % BLOCK_SIZE);
    b.offset = lanes_i_load(offset);
    return b;
}

/* Pixels of the block at (x, y) inside the triangle's bounds. */
static uint32_t bounds_mask(const raster_triangle *t, int32_t x, int32_t y)
{
    uint32_t columns = 0xF;
    uint32_t rows = 0xFFFF;

    if (x < t->min_x)
        columns &= 0xFu << (t->min_x - x);
    if (x + 3 > t->max_x)
        columns &= 0xFu >> (x + 3 - t->max_x);
    if (y < t->min_y)
        rows &= 0xFFFFu << 4 * (t->min_y - y);
    if (y + 3 > t->max_y)
        rows &= 0xFFFFu >> 4 * (y + 3 - t->max_y);
    return (columns & 0xF) * 0x1111u & rows & GN_ALL_LANES;
}

void gn_cover_triangle(const raster_triangle *triangle, block_function *block, void *context)
{
    const int32_t left = triangle->min_x & ~(BLOCK_SIZE - 1);
    const int32_t bottom = triangle->min_y & ~(BLOCK_SIZE - 1);
    block_edge edge[3];

    for (int i = 0; i < 3; ++i)
        edge[i] = make_block_edge(&triangle->edge[i]);

    for (int32_t y = bottom; y <= triangle->max_y; y += BLOCK_SIZE) {
        int64_t value[3];
        bool entered = false;

        for (int i = 0; i < 3; ++i) {
            const edge_function *e = &triangle->edge[i];
            value[i] = e->constant - (int64_t)e->per_x * left + (int64_t)e->per_y * y;
        }

        for (int32_t x = left; x <= triangle->max_x; x += BLOCK_SIZE) {
            bool outside = false;
            bool inside = true;

            for (int i = 0; i < 3; ++i) {
                outside |= value[i] + edge[i].greatest < 0;
                inside &= value[i] + edge[i].least >= 0;
            }
            /* The blocks that touch a triangle are neighbours in a row. */
            if (outside && entered)
                break;
            if (!outside) {
                uint32_t coverage = bounds_mask(triangle, x, y);

                entered = true;
                if (!inside) {
                    lanes_i sign = lanes_i_splat(0);
                    for (int i = 0; i < 3; ++i) {
                        const int64_t v = value[i] > EDGE_LIMIT    ? EDGE_LIMIT
                                          : value[i] < -EDGE_LIMIT ? -EDGE_LIMIT
                                                                   : value[i];
                        sign = lanes_i_or(sign,
                                          lanes_i_add(lanes_i_splat((int32_t)v), edge[i].offset));
                    }
                    coverage &= ~lanes_i_sign_bits(sign);
                }
                if (coverage)
                    block(context, triangle, x, y, coverage);
            }
            for (int i = 0; i < 3; ++i)
                value[i] -= (int64_t)triangle->edge[i].per_x * BLOCK_SIZE;
        }
    }
}
