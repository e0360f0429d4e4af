/* Generates the levels of a texture: each from the level before it, by the reference's rules for
 * linear blits; in 3D from two layers. */
#include "../backends/entry_points.h"
#include "../formats/properties.h"
#include "../texture/packed_levels.h"
#include "../texture/texture_faults.h"
#include "blit_layer.h"

/* Writes the addresses of the first and the last byte of level 0. */
static void level_addresses(const gn_texture *t, uintptr_t range[2])
{
    const gn_texture_level *const l = &t->level[0];
    const texel_extent e = extent_of_level(t, 0);
    const size_t rows = e.height > 1 ? stride_length(l->row_stride) * (e.height - 1) : 0;
    const size_t layers = e.layers > 1 ? stride_length(l->layer_stride) * (e.layers - 1) : 0;

    range[0] = (uintptr_t)l->texels;
    range[1] = (uintptr_t)l->texels + e.width * texel_size(t->format) - 1;
    if (l->row_stride < 0)
        range[0] -= rows;
    else
        range[1] += rows;
    if (l->layer_stride < 0)
        range[0] -= layers;
    else
        range[1] += layers;
}

static gn_surface surface_of(const gn_texture *t, uint32_t level, uint32_t layer)
{
    const gn_texture_level *const l = &t->level[level];
    const texel_extent e = extent_of_level(t, level);
    const unsigned char *texels = (const unsigned char *)l->texels;
    gn_surface s;

    if (e.layers > 1)
        texels += (ptrdiff_t)layer * l->layer_stride;
    /* A surface's pixels are not const; only the levels in the caller's memory are written. */
    s.pixels = (void *)(uintptr_t)texels;
    s.row_stride = l->row_stride;
    s.width = e.width;
    s.height = e.height;
    s.format = t->format;
    s.samples = 0;
    s.sample_stride = 0;
    return s;
}

/* Makes level `level` of a 3D texture. Layers are mixed at the centres of the new layers, which are
 * computed in the reference's order of operations. */
static void make_layers(const gn_texture *t, uint32_t level, gn_backend backend)
{
    const uint32_t count = extent_of_level(t, level).layers;
    const uint32_t before = extent_of_level(t, level - 1).layers;
    const float scale = (float)before / (float)count;

    for (uint32_t z = 0; z < count; ++z) {
        const float r = ((float)z * scale + 0.5f * scale) / (float)before;
        const float centre = r * (float)before - 0.5f;
        const float c = centre > 0.0f ? centre : 0.0f;
        const uint32_t first = (uint32_t)c < before ? (uint32_t)c : before - 1;
        const gn_surface to = surface_of(t, level, z);
        const gn_surface from = surface_of(t, level - 1, first);
        const gn_surface next = surface_of(t, level - 1, first + 1 < before ? first + 1 : first);

        gni_blit_layer(&to, 3, &from, &next, c - (float)first, backend);
    }
}

static void make_level(const gn_texture *t, uint32_t level, gn_backend backend)
{
    const uint32_t layers = extent_of_level(t, level).layers;

    if (t->target == GN_TEXTURE_3D) {
        make_layers(t, level, backend);
        return;
    }
    for (uint32_t n = 0; n < layers; ++n) {
        const gn_surface to = surface_of(t, level, n);
        const gn_surface from = surface_of(t, level - 1, n);

        gni_blit_layer(&to, t->target == GN_TEXTURE_1D ? 1 : 2, &from, 0, 0.0f, backend);
    }
}

gn_status gn_texture_generate_levels(gn_texture *texture, void *memory, size_t size)
{
    const gn_status status = gn_texture_check(texture);
    uintptr_t read[2];

    if (status)
        return status;
    if (!GN_HAVE_TEXTURES)
        return GN_NOT_COMPILED;
    if (!format_is_color(texture->format))
        return GN_INVALID_FORMAT;

    const texture_shape shape = shape_of(texture);
    const uint32_t count = most_levels(&shape);
    if (count > 1) {
        const size_t needed = gni_packed_bytes(texture, 1, count);
        const uintptr_t first = (uintptr_t)memory;

        if (!memory)
            return GN_NULL_POINTER;
        if (first % texel_element(texture->format) != 0)
            return GN_MISALIGNED;
        if (needed == 0 || size < needed)
            return GN_WORKSPACE_TOO_SMALL;
        level_addresses(texture, read);
        if (first <= read[1] && read[0] <= first + (needed - 1))
            return GN_OVERLAP;
    }
    const texel_extent e = extent_of_level(texture, 0);
    const gn_backend backend = backend_of_rows((size_t)e.width * e.height * e.layers);
    texture->level_count = count;
    gni_place_levels(texture, 1, count, memory);
    for (uint32_t n = 1; n < count; ++n)
        make_level(texture, n, backend);
    return GN_OK;
}
