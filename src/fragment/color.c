/* Colours into a surface's format and memory. */
#include "fragment.h"

static void write_rgba8(const gn_surface *surface, int32_t x, int32_t y, uint32_t coverage,
                        float (*color)[GN_LANES])
{
    lanes_i pixels = lanes_pack_unorm8(lanes_load(color[0]), lanes_load(color[1]),
                                       lanes_load(color[2]), lanes_load(color[3]));

    if (surface_holds_block(surface, x, y)) {
        unsigned char *const memory = surface_row(surface, (uint32_t)y) + 4 * x;

        if (coverage != GN_ALL_LANES)
            pixels = lanes_i_select(lanes_from_bits(coverage), pixels,
                                    lanes_i_load_block(memory, surface->row_stride));
        lanes_i_store_block(memory, surface->row_stride, pixels);
        return;
    }

    int32_t pixel[GN_LANES];
    lanes_i_store(pixel, pixels);
    GN_EACH_LANE (l) {
        if (coverage >> l & 1u) {
            void *const row = surface_row(surface, (uint32_t)(y + l / BLOCK_SIZE));
            ((int32_t *)row)[x + l % BLOCK_SIZE] = pixel[l];
        }
    }
}

static void write_rgba32f(const gn_surface *surface, int32_t x, int32_t y, uint32_t coverage,
                          float (*color)[GN_LANES])
{
    GN_EACH_LANE (l) {
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
