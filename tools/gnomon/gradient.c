/* Fills a picture with strips of one colour each. */
#include "gradient.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "look_parts.h"
#include "scene_memory.h"

/* Each channel has at most 256 values on the way, so there are at most 4 * 255 changes. */
enum { MOST_STRIPS = 4 * 255 + 1 };

/* The colour of a row, counted from the top: the nearest whole numbers, halves rounded up. */
static void color_of(const int32_t upper[4], const int32_t lower[4], uint32_t row, uint32_t height,
                     int32_t result[4])
{
    const int64_t steps = height > 1 ? (int64_t)height - 1 : 1;
    for (int c = 0; c < 4; ++c) {
        const int64_t sum = upper[c] * (steps - row) + lower[c] * (int64_t)row;
        result[c] = (int32_t)((2 * sum + steps) / (2 * steps));
    }
}

/* The edge above a row, in normalised device coordinates. */
static float edge_above(uint32_t row, uint32_t height)
{
    return (float)(1.0 - 2.0 * row / height);
}

/* The four corners of a strip that covers rows `first` to end - 1. */
static void write_strip(float *positions, float *colors, const float color[4], uint32_t first,
                        uint32_t end, uint32_t height)
{
    for (int k = 0; k < 4; ++k) {
        positions[3 * k] = k % 2 == 0 ? -1.0f : 1.0f;
        positions[3 * k + 1] = edge_above(k < 2 ? end : first, height);
        positions[3 * k + 2] = 0.0f;
        memcpy(colors + 4 * k, color, 4 * sizeof *color);
    }
}

/* Returns the number of strips. */
static uint32_t write_strips(const scene *s, const int32_t upper[4], const int32_t lower[4],
                             bool is_linear, float *positions, float *colors)
{
    uint32_t count = 0;
    for (uint32_t first = 0, end; first < s->height; first = end) {
        int32_t color[4], next[4];
        float stored[4];
        color_of(upper, lower, first, s->height, color);
        for (end = first + 1; end < s->height; ++end) {
            color_of(upper, lower, end, s->height, next);
            if (memcmp(color, next, sizeof next) != 0)
                break;
        }
        for (int c = 0; c < 4; ++c) {
            stored[c] = (float)color[c] / 255.0f;
            if (is_linear && c < 3)
                stored[c] = look_to_linear(stored[c]);
        }
        write_strip(positions + 12 * count, colors + 16 * count, stored, first, end, s->height);
        ++count;
    }
    return count;
}

void gradient_add(scene *s, const float upper[4], const float lower[4], bool is_linear)
{
    static const uint32_t corners[6] = {0, 1, 2, 2, 1, 3};
    float *const positions = scene_allocate((size_t)12 * MOST_STRIPS, sizeof *positions);
    float *const colors = scene_allocate((size_t)16 * MOST_STRIPS, sizeof *colors);
    uint32_t *const indices = scene_allocate((size_t)6 * MOST_STRIPS, sizeof *indices);
    int32_t bytes[2][4];
    for (int c = 0; c < 4; ++c) {
        bytes[0][c] = (int32_t)lrintf(255.0f * upper[c]);
        bytes[1][c] = (int32_t)lrintf(255.0f * lower[c]);
    }
    const uint32_t count = write_strips(s, bytes[0], bytes[1], is_linear, positions, colors);
    for (uint32_t i = 0; i < 6 * count; ++i)
        indices[i] = i / 6 * 4 + corners[i % 6];
    scene_draw *const draw = scene_add_draw(s);
    draw->shader = SCENE_VERTEX_COLOR;
    for (int c = 0; c < 4; ++c)
        draw->state.program.interpolation[c] = GN_FLAT;
    scene_set_attribute(draw, GN_ATTRIBUTE_POSITION, positions, 3, 4 * count);
    scene_set_attribute(draw, GN_ATTRIBUTE_COLOR, colors, 4, 4 * count);
    scene_set_indices(draw, indices, 6 * count, GN_INDEX_UINT32);
    free(positions);
    free(colors);
    free(indices);
}
