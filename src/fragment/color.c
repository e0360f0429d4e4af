/* Colours into a surface's format and memory. */
#include "fragment.h"

lanes_i gn_unorm8(lanes_f channel)
{
    const lanes_i low = lanes_i_splat(0);
    const lanes_i high = lanes_i_splat(255);
    lanes_i r = lanes_round(lanes_mul(channel, lanes_splat(255.0f)));

    r = lanes_i_select(lanes_i_greater(r, low), r, low);
    return lanes_i_select(lanes_i_greater(high, r), r, high);
}

static void write_rgba8(const gn_surface *surface, int32_t x, int32_t y, uint32_t coverage,
                        float (*color)[GN_LANES])
{
    const lanes_i red = gn_unorm8(lanes_load(color[0]));
    const lanes_i green = gn_unorm8(lanes_load(color[1]));
    const lanes_i blue = gn_unorm8(lanes_load(color[2]));
    const lanes_i alpha = gn_unorm8(lanes_load(color[3]));
    uint32_t pixel[GN_LANES];

    GN_EACH_LANE(l)
    pixel[l] = (uint32_t)red.v[l] | (uint32_t)green.v[l] << 8 | (uint32_t)blue.v[l] << 16 |
               (uint32_t)alpha.v[l] << 24;

    for (int row = 0; row < BLOCK_SIZE; ++row) {
        const uint32_t covered = coverage >> (row * BLOCK_SIZE) & 0xF;

        if (!covered)
            continue;
        uint32_t *out = (uint32_t *)(void *)surface_row(surface, (uint32_t)(y + row)) + x;
        for (int column = 0; column < BLOCK_SIZE; ++column) {
            if (covered >> column & 1u)
                out[column] = pixel[row * BLOCK_SIZE + column];
        }
    }
}

static void write_rgba32f(const gn_surface *surface, int32_t x, int32_t y, uint32_t coverage,
                          float (*color)[GN_LANES])
{
    GN_EACH_LANE(l)
    {
        if (coverage >> l & 1u) {
            const uint32_t row = (uint32_t)(y + l / BLOCK_SIZE);
            float *out = (float *)(void *)surface_row(surface, row) + 4 * (x + l % BLOCK_SIZE);

            for (int c = 0; c < 4; ++c)
                out[c] = color[c][l];
        }
    }
}

void gn_write_color(const gn_surface *surface, int32_t x, int32_t y, uint32_t coverage,
                    float (*color)[GN_LANES])
{
    if (surface->format == GN_FORMAT_RGBA8)
        write_rgba8(surface, x, y, coverage, color);
    else
        write_rgba32f(surface, x, y, coverage, color);
}
