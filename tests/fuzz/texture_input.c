/* Textures and samplers out of a fuzzer's input. */
#include "texture_input.h"

#include <stdlib.h>
#include <string.h>

#include "scene.h"

#define MOST_BYTES ((int64_t)1 << 18)
#define FAR ((ptrdiff_t)1 << 40)

static gn_sampler make_sampler(fuzz_input *in)
{
    const uint8_t wraps = fuzz_byte(in), filters = fuzz_byte(in), more = fuzz_byte(in);
    gn_sampler s = {0};

    s.wrap_s = (gn_wrap)(wraps % 5);
    s.wrap_t = (gn_wrap)(wraps / 5 % 5);
    s.wrap_r = (gn_wrap)(wraps / 25 % 5);
    s.magnify = (gn_magnify)(filters & 1);
    s.minify = (gn_minify)((filters >> 1 & 7) % 6);
    s.compare = (gn_compare)((filters >> 4) % 9);
    if (more & 1)
        s.lod_bias = fuzz_float(in);
    if (more & 2) {
        s.lod_clamp_enabled = true;
        s.min_lod = fuzz_float(in);
        s.max_lod = more & 4 ? fuzz_float(in) : s.min_lod + 2.0f;
    }
    if (more & 8)
        s.max_anisotropy = fuzz_below(in, GN_MAX_ANISOTROPY + 2);
    for (int c = 0; c < 4 && more & 16; ++c)
        s.border[c] = fuzz_float(in);
    switch (more >> 5) {
    case 6:
        s.minify = (gn_minify)fuzz_below(in, 8);
        s.wrap_s = (gn_wrap)fuzz_below(in, 7);
        break;
    case 7:
        s.wrap_r = (gn_wrap)fuzz_word(in);
        s.compare = (gn_compare)fuzz_below(in, 12);
        break;
    default:
        break;
    }
    return s;
}

/* Lays a level out: in its packed place, with gaps, backwards, or with strides of any size. */
static void lay_out(fuzz_input *in, const gn_texture *t, uint32_t level, gn_texture_level *l)
{
    const scene_extent e = scene_level_extent(t, level);
    const ptrdiff_t element = (ptrdiff_t)scene_element_size(t->format);
    const uint8_t layout = fuzz_byte(in);
    const ptrdiff_t row = (ptrdiff_t)(e.width * gn_format_size(t->format)) + (layout & 3) * element;
    const ptrdiff_t layer = row * (ptrdiff_t)e.height + (layout >> 2 & 3) * element;

    l->row_stride = layout & 16 ? -row : row;
    l->layer_stride = layout & 32 ? -layer : layer;
    switch (layout >> 6 == 3 ? fuzz_below(in, 8) : 0) {
    case 1:
        l->row_stride = FAR * fuzz_byte(in);
        break;
    case 2:
        l->layer_stride = -FAR * fuzz_byte(in);
        break;
    case 3:
        l->row_stride = PTRDIFF_MIN;
        break;
    case 4:
        l->layer_stride = PTRDIFF_MAX;
        break;
    case 5:
        l->row_stride -= (ptrdiff_t)fuzz_below(in, 9);
        break;
    case 6: /* layers side by side, as tiles of one image */
        l->row_stride = row * (ptrdiff_t)e.layers;
        l->layer_stride = row;
        break;
    default:
        break;
    }
}

static bool is_far(ptrdiff_t stride)
{
    return stride <= -FAR || stride >= FAR;
}

static void fill(uint32_t seed, unsigned char *memory, size_t size, gn_format format)
{
    uint32_t x = seed * 2654435761u + 1;

    for (size_t i = 0; i < size; ++i) {
        x = x * 1664525u + 1013904223u;
        memory[i] = (unsigned char)(x >> 24);
    }
    for (size_t i = 0; format == GN_FORMAT_D24 && i + 4 <= size; i += 4) {
        uint32_t word;

        memcpy(&word, memory + i, sizeof word);
        word &= 0xFFFFFF;
        memcpy(memory + i, &word, sizeof word);
    }
}

/* Allocates the memory of a level. Returns false if nobody has as much. */
static bool give_memory(fuzz_input *in, texture_input *result, uint32_t level, uint32_t seed)
{
    gn_texture *const t = &result->texture;
    gn_texture_level *const l = &t->level[level];
    const scene_extent e = scene_level_extent(t, level);
    const ptrdiff_t rows = e.height > 1 ? (ptrdiff_t)e.height - 1 : 0;
    const ptrdiff_t layers = e.layers > 1 ? (ptrdiff_t)e.layers - 1 : 0;
    ptrdiff_t low = 0, high = (ptrdiff_t)(e.width * gn_format_size(t->format));

    if ((rows && is_far(l->row_stride)) || (layers && is_far(l->layer_stride)))
        return false;
    if (rows)
        *(l->row_stride < 0 ? &low : &high) += rows * l->row_stride;
    if (layers)
        *(l->layer_stride < 0 ? &low : &high) += layers * l->layer_stride;
    if (high - low > MOST_BYTES)
        return false;

    const size_t shift = fuzz_rarely(in, 64) ? 1 + fuzz_below(in, 3) : 0;
    const size_t size = (size_t)(high - low) + shift;

    result->memory[level] = fuzz_memory(size);
    fill(seed + level, result->memory[level], size, t->format);
    l->texels = result->memory[level] - low + shift;
    return true;
}

bool texture_make(fuzz_input *in, uint32_t most, texture_input *result)
{
    static const char nowhere[8];
    gn_texture *const t = &result->texture;
    const uint8_t target = fuzz_byte(in), format = fuzz_byte(in), spoilt = fuzz_byte(in);

    memset(result, 0, sizeof *result);
    result->sampler = make_sampler(in);
    t->target = (gn_texture_target)(target % 5);
    t->format = format & 0x80 ? scene_depth_formats[format % SCENE_DEPTH_FORMATS]
                              : scene_color_formats[format % SCENE_COLOR_FORMATS];
    t->width = 1 + fuzz_below(in, most);
    t->height = t->target == GN_TEXTURE_1D     ? 1
                : t->target == GN_TEXTURE_CUBE ? t->width
                                               : 1 + fuzz_below(in, most);
    t->depth = 1 + fuzz_below(in, 5);
    uint32_t levels = 1;

    while (t->width >> levels || t->height >> levels ||
           (t->target == GN_TEXTURE_3D && t->depth >> levels))
        ++levels;
    t->level_count = target >= 128 ? levels : fuzz_below(in, levels + 1);
    switch (spoilt) {
    case 1:
        t->target = (gn_texture_target)fuzz_word(in);
        break;
    case 2:
        t->format = (gn_format)fuzz_word(in);
        break;
    case 3:
        t->width = fuzz_magnitude(in);
        break;
    case 4:
        t->height = fuzz_magnitude(in);
        break;
    case 5:
        t->depth = fuzz_magnitude(in);
        break;
    case 6:
        t->level_count = fuzz_magnitude(in);
        break;
    default:
        break;
    }

    /* A shape that is refused needs no memory. gn_texture_memory_size refuses what
     * gn_texture_check does, as far as the shape goes. */
    if (gn_texture_memory_size(t->target, t->format, t->width, t->height, t->depth,
                               t->level_count) == 0) {
        for (int i = 0; i < GN_MAX_LEVELS; ++i)
            t->level[i] = (gn_texture_level){nowhere, 1 << 20, 1 << 30};
        FUZZ_REQUIRE(gn_texture_check(t) != GN_OK);
        return true;
    }
    for (uint32_t i = 0; i < scene_level_count(t); ++i)
        lay_out(in, t, i, &t->level[i]);

    /* Strides that are refused need no memory either. */
    gn_texture placed = *t;
    static const uint64_t aligned[1];

    for (int i = 0; i < GN_MAX_LEVELS; ++i)
        placed.level[i].texels = aligned;
    const bool refused = gn_texture_check(&placed) != GN_OK;

    for (uint32_t i = 0; i < scene_level_count(t); ++i) {
        if (refused) {
            t->level[i].texels = aligned;
        } else if (!give_memory(in, result, i, spoilt)) {
            texture_free(result);
            return false;
        }
    }
    if (spoilt == 7 && !refused)
        t->level[fuzz_below(in, scene_level_count(t))].texels = NULL;
    return true;
}

void texture_free(texture_input *t)
{
    for (int i = 0; i < GN_MAX_LEVELS; ++i) {
        free(t->memory[i]);
        t->memory[i] = NULL;
    }
}
