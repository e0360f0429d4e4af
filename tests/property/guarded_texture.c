/* Textures in guarded memory. */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS, MAP_NORESERVE */
#include "guarded_texture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "random.h"
#include "scene.h"

/* The bytes of a level that the test fills. */
#define MOST_FILLED ((size_t)1 << 20)

size_t guarded_length(ptrdiff_t stride)
{
    return stride < 0 ? 0 - (size_t)stride : (size_t)stride;
}

size_t guarded_span(const gn_texture *t, uint32_t level)
{
    const scene_extent e = scene_level_extent(t, level);

    return guarded_length(t->level[level].layer_stride) * (e.layers - 1) +
           guarded_length(t->level[level].row_stride) * (e.height - 1) +
           e.width * gn_format_size(t->format);
}

/* Allocates memory for a level between pages that may not be read; returns its first byte. */
static unsigned char *map_level(guarded *g, size_t bytes, bool at_end)
{
    const size_t page = (size_t)sysconf(_SC_PAGESIZE), whole = (bytes + page - 1) / page * page;
    const int protection = bytes <= MOST_FILLED ? PROT_READ | PROT_WRITE : PROT_READ;

    g->mapped = whole + 2 * page;
    g->mapping =
        mmap(NULL, g->mapped, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (g->mapping == MAP_FAILED || mprotect(g->mapping + page, whole, protection) != 0) {
        fprintf(stderr, "properties: out of memory\n");
        exit(EXIT_FAILURE);
    }
    return g->mapping + page + (at_end ? whole - bytes : 0);
}

/* An element of a texel, or of a gap between texels. Channels of texels are 0.25 to 0.5 (in sRGB
 * the encoding of that; channels of less than 8 bits have any value), those of gaps are greater. */
static uint32_t element(random_source *r, gn_format format, size_t i, bool is_texel)
{
    const float number = is_texel ? random_float(r, 0.25f, 0.5f) : NAN;
    const uint32_t bits = (uint32_t)(random_bits(r) >> 32);
    const int width = scene_channel_width(format, 0);
    uint32_t word;

    memcpy(&word, &number, sizeof word);
    if (format == GN_FORMAT_D32FS8 && i % 2)
        return bits & 255;
    if (width == 10)
        return is_texel ? 0x50040100 + (bits & 0x0FF3FCFF) : 0xFFFFFFFF;
    if (width == 11)
        return is_texel ? 0x681A0340 + (bits & 0x07C1F83F) : 0xFFFFFFFF;
    if (scene_is_float_format(format))
        return width == 32 ? word : is_texel ? 0x34003400 + (bits & 0x03FF03FF) : 0x7E007E00;
    if (width == 16)
        return is_texel ? 0x4000 + (bits & 0x3FFF) : 0xFFFF;
    if (width == 24)
        return is_texel ? 0x400000 + (bits & (scene_has_stencil(format) ? 0xFF3FFFFF : 0x3FFFFF))
                        : 0xFFFFFFFF;
    return is_texel ? 0x40404040 + (bits & 0x3F3F3F3F) : 0xFFFFFFFF;
}

static void fill_level(random_source *r, const gn_texture *t, uint32_t level, unsigned char *memory)
{
    const size_t size = scene_element_size(t->format), bytes = guarded_span(t, level);
    const scene_extent e = scene_level_extent(t, level);
    const gn_texture_level *const l = &t->level[level];
    const size_t row = e.width * (gn_format_size(t->format) / size);

    for (size_t i = 0; i < bytes / size; ++i)
        scene_set_element(memory, size, i, element(r, t->format, i, false));
    for (uint32_t layer = 0; layer < e.layers; ++layer)
        for (uint32_t y = 0; y < e.height; ++y) {
            char *const texels = (char *)l->texels +
                                 (e.layers > 1 ? l->layer_stride : 0) * (ptrdiff_t)layer +
                                 (e.height > 1 ? l->row_stride : 0) * (ptrdiff_t)y;

            for (size_t i = 0; i < row; ++i)
                scene_set_element(texels, size, i, element(r, t->format, i, true));
        }
}

bool guarded_map(const gn_texture *shape, uint64_t seed, const bool at_end[GN_MAX_LEVELS],
                 gn_texture *t, guarded memory[GN_MAX_LEVELS])
{
    random_source r = random_seed(seed);
    bool filled = true;

    *t = *shape;
    for (uint32_t level = 0; level < scene_level_count(t); ++level) {
        const scene_extent e = scene_level_extent(t, level);
        gn_texture_level *const l = &t->level[level];
        gn_texture_level counted = *l; /* strides that have no effect are 0 */

        counted.row_stride = e.height > 1 ? l->row_stride : 0;
        counted.layer_stride = e.layers > 1 ? l->layer_stride : 0;

        gn_texture spanned = *t;

        spanned.level[level] = counted;

        const size_t bytes = guarded_span(&spanned, level);
        unsigned char *const first = map_level(&memory[level], bytes, at_end[level]);
        const ptrdiff_t rows = counted.row_stride * (ptrdiff_t)(e.height - 1);
        const ptrdiff_t layers = counted.layer_stride * (ptrdiff_t)(e.layers - 1);

        l->texels = first - (rows < 0 ? rows : 0) - (layers < 0 ? layers : 0);
        spanned.level[level].texels = l->texels;
        if (bytes <= MOST_FILLED)
            fill_level(&r, &spanned, level, first);
        else
            filled = false;
    }
    return filled;
}

void guarded_unmap(const gn_texture *t, const guarded memory[GN_MAX_LEVELS])
{
    for (uint32_t level = 0; level < scene_level_count(t); ++level)
        munmap(memory[level].mapping, memory[level].mapped);
}
