/* Cases: the properties that their numbers enumerate, and those that are random in each. */
#include "lookups.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WRAPS = 5, MINIFIERS = 6, MAGNIFIERS = 2, TARGETS = 5, SHAPES = 3 };

/* The properties of a case that its number determines. */
typedef struct case_digits {
    uint32_t target, kind, wrap, minify, magnify, shape;
} case_digits;

uint64_t case_count(void)
{
    return (uint64_t)TARGETS * LOOKUP_KINDS * WRAPS * MINIFIERS * MAGNIFIERS * SHAPES;
}

static uint32_t take_digit(uint64_t *number, uint32_t base)
{
    const uint32_t digit = (uint32_t)(*number % base);

    *number /= base;
    return digit;
}

static case_digits digits_of(uint64_t number)
{
    case_digits d;

    d.target = take_digit(&number, TARGETS);
    d.kind = take_digit(&number, LOOKUP_KINDS);
    d.wrap = take_digit(&number, WRAPS);
    d.minify = take_digit(&number, MINIFIERS);
    d.magnify = take_digit(&number, MAGNIFIERS);
    d.shape = take_digit(&number, SHAPES);
    return d;
}

void case_level_size(const lookup_case *c, uint32_t level, uint32_t size[3])
{
    for (int n = 0; n < 3; ++n)
        size[n] = c->size[n] >> level > 0 ? c->size[n] >> level : 1;
    if (c->target != GN_TEXTURE_3D)
        size[2] = c->size[2];
}

static uint32_t levels_of(const uint32_t size[3], gn_texture_target target)
{
    uint32_t largest = size[0] > size[1] ? size[0] : size[1];
    uint32_t levels = 1;

    if (target == GN_TEXTURE_3D && size[2] > largest)
        largest = size[2];
    while (largest >>= 1)
        ++levels;
    return levels;
}

/* Shape 0: powers of two, 1: others, 2: any. */
static uint32_t random_size(random_source *r, uint32_t shape, uint32_t largest)
{
    const uint32_t bits = random_below(r, 7);
    const uint32_t any = 1 + random_below(r, largest);
    uint32_t power = 1u << bits;

    while (power > largest)
        power >>= 1;
    if (shape == 0 || (shape == 2 && random_chance(r, 50)))
        return power;
    return (any & (any - 1)) == 0 && any + 2 < largest ? any + (any > 1 ? 1 : 2) : any;
}

static void choose_sizes(lookup_case *c, random_source *r, uint32_t shape)
{
    const uint32_t largest = c->target == GN_TEXTURE_3D ? 32 : 80;
    uint32_t levels;

    c->size[0] = random_size(r, shape, largest);
    c->size[1] = random_size(r, shape, largest);
    c->size[2] = random_size(r, shape, c->target == GN_TEXTURE_3D ? 20 : 5);
    if (c->target == GN_TEXTURE_1D)
        c->size[1] = 1;
    if (c->target == GN_TEXTURE_CUBE) {
        c->size[1] = c->size[0];
        c->size[2] = 6;
    }
    if (c->target == GN_TEXTURE_1D || c->target == GN_TEXTURE_2D)
        c->size[2] = 1;
    levels = levels_of(c->size, c->target);
    /* For wraps, OpenGL's level 0 decides whether a size is a power of two; with another base level
     * the library cannot know it. */
    c->base = shape == 0 && random_chance(r, 20) ? random_below(r, levels) : 0;
    levels -= c->base;
    c->level_count = random_chance(r, 70) ? levels : 1 + random_below(r, levels);
    /* A single level has no filter between levels; in the reference only if it is the texture's
     * first level (reference/RULES.md). */
    if (c->level_count == 1)
        c->base = 0;
}

/* One of a list beside two of them. */
static gn_format any_but(random_source *r, const gn_format *list, uint32_t count, gn_format a,
                         gn_format b)
{
    gn_format f;

    do {
        f = list[random_below(r, count)];
    } while (f == a || f == b);
    return f;
}

static gn_format choose_format(const lookup_case *c, random_source *r)
{
    if (c->target != GN_TEXTURE_3D &&
        random_chance(r, 20)) /* OpenGL has no such texture of three dimensions */
        return any_but(r, scene_depth_formats, SCENE_DEPTH_FORMATS, GN_FORMAT_S8, GN_FORMAT_S8);
    if (random_chance(r, 50))
        return random_chance(r, 70) ? GN_FORMAT_RGBA8 : GN_FORMAT_RGBA32F;
    return any_but(r, scene_color_formats, SCENE_COLOR_FORMATS, GN_FORMAT_RGBA8, GN_FORMAT_RGBA32F);
}

static void choose_sampler(lookup_case *c, random_source *r, const case_digits *d)
{
    gn_sampler *const s = &c->sampler;

    s->wrap_s = (gn_wrap)d->wrap;
    s->wrap_t = random_chance(r, 40) ? s->wrap_s : (gn_wrap)random_below(r, WRAPS);
    s->wrap_r = random_chance(r, 40) ? s->wrap_s : (gn_wrap)random_below(r, WRAPS);
    s->magnify = (gn_magnify)d->magnify;
    s->minify = (gn_minify)d->minify;
    if (random_chance(r, 30))
        s->lod_bias = random_float(r, -4.0f, 4.0f);
    if (random_chance(r, 30)) {
        s->lod_clamp_enabled = true;
        s->min_lod = random_float(r, -2.0f, 4.0f);
        s->max_lod = s->min_lod + (random_chance(r, 20) ? 0.0f : random_float(r, 0.0f, 5.0f));
        /* From the number of levels on, the reference applies no limit. */
        if (random_chance(r, 20))
            s->max_lod =
                0.5f * (float)random_between(r, 2 * GN_MAX_LEVELS - 4, 2 * GN_MAX_LEVELS + 2);
    }
    /* The reference takes a lower limit below 0 as 0, so that both limits are equal or in the wrong
     * order. This decides whether it computes a level of detail, which the direction 0 of cubes
     * shows even where there is one level. */
    if (random_chance(r, c->target == GN_TEXTURE_CUBE ? 40 : 5)) {
        s->lod_clamp_enabled = true;
        s->min_lod = random_float(r, -2.0f, 0.0f);
        s->max_lod = random_chance(r, 50) ? random_sign(r) * 0.0f : 0.5f * s->min_lod;
    }
    for (int n = 0; n < 4; ++n)
        s->border[n] = random_float(r, -0.25f, 1.25f);
    if (scene_has_depth(c->format) && can_compare(c->kind, c->target) && random_chance(r, 80))
        s->compare = (gn_compare)(1 + random_below(r, GN_ALWAYS));
}

/* Leaves a lookup that the library makes in a shorter way than others: in one level of RGBA8,
 * repeated or clamped to the edge, with nothing added to the lod. */
static void make_simple(lookup_case *c)
{
    gn_sampler *const s = &c->sampler;

    c->format = GN_FORMAT_RGBA8;
    c->level_count = 1;
    c->base = 0;
    s->wrap_s = s->wrap_s == GN_WRAP_REPEAT ? GN_WRAP_REPEAT : GN_WRAP_CLAMP_TO_EDGE;
    s->wrap_t = s->wrap_t == GN_WRAP_REPEAT ? GN_WRAP_REPEAT : GN_WRAP_CLAMP_TO_EDGE;
    s->lod_bias = 0.0f;
    s->lod_clamp_enabled = false;
    s->compare = GN_COMPARE_DEFAULT;
}

static float random_special(random_source *r)
{
    static const float special[] = {INFINITY, -INFINITY, NAN, -0.0f, 0.0f, 1e30f, -1e30f};

    return special[random_below(r, sizeof special / sizeof *special)];
}

/* Fills texels with random values. In formats of floats, `wild` percent of the values are not
 * finite, large, or a zero of either sign. */
static void fill_texels(random_source *r, gn_format format, uint32_t wild, void *texels,
                        size_t count)
{
    const size_t bytes = count * gn_format_size(format);
    float *const floats = texels;
    uint16_t *const halves = texels;
    const bool is_float = scene_is_float_format(format);

    if (scene_has_depth(format)) {
        fill_depths(r, format, texels, count);
        return;
    }
    for (size_t i = 0; i < bytes; ++i)
        ((unsigned char *)texels)[i] = (unsigned char)random_below(r, 256);
    for (size_t i = 0; i < bytes / 4; ++i)
        if (is_float && scene_channel_width(format, 0) == 32)
            floats[i] = random_chance(r, wild) ? random_special(r) : random_float(r, -0.5f, 1.5f);
    for (size_t i = 0; format == GN_FORMAT_R11F_G11F_B10F && i < count; ++i)
        if (!random_chance(r, wild))
            ((uint32_t *)texels)[i] &= 0x7FDFFBFFu; /* finite: an exponent below the highest */
    for (size_t i = 0; is_float && scene_channel_width(format, 0) == 16 && i < bytes / 2; ++i)
        if ((halves[i] & 0x7C00) == 0x7C00)
            halves[i] = (uint16_t)(random_chance(r, wild) ? halves[i] & 0xFC00 : 0x3555);
}

/* Fills a level and copies it into the library's memory, where rows and layers have a random
 * distance and may run downwards. */
static bool make_level(lookup_case *c, random_source *r, uint32_t n, unsigned char *memory,
                       size_t *used)
{
    const size_t texel = gn_format_size(c->format), element = scene_element_size(c->format);
    gn_texture_level *const level = &c->texture.level[n];
    uint32_t size[3];

    case_level_size(c, c->base + n, size);

    const size_t row = size[0] * texel;
    const size_t stride = row + element * random_below(r, 4);
    const size_t layer = stride * size[1] + element * random_below(r, 4);
    const bool flipped = random_chance(r, 30);
    const uint32_t wild = !c->is_wild ? 0 : random_chance(r, 70) ? 5 : 50;

    c->packed[n] = malloc(row * size[1] * size[2]);
    if (!c->packed[n])
        return false;
    fill_texels(r, c->format, wild, c->packed[n], (size_t)size[0] * size[1] * size[2]);
    level->row_stride = flipped ? -(ptrdiff_t)stride : (ptrdiff_t)stride;
    level->layer_stride = (ptrdiff_t)layer;
    level->texels = memory + *used + (flipped ? stride * (size[1] - 1) : 0);
    for (uint32_t z = 0; z < size[2]; ++z) {
        for (uint32_t y = 0; y < size[1]; ++y)
            memcpy((unsigned char *)(uintptr_t)level->texels + (ptrdiff_t)z * level->layer_stride +
                       (ptrdiff_t)y * level->row_stride,
                   (unsigned char *)c->packed[n] + (z * size[1] + y) * row, row);
    }
    *used += (layer * size[2] + 15) & ~(size_t)15;
    return true;
}

static bool make_texture(lookup_case *c, random_source *r)
{
    size_t used = 0, bound = 0;

    for (uint32_t n = 0; n < c->level_count; ++n) {
        uint32_t size[3];

        case_level_size(c, c->base + n, size);
        bound += (((size_t)size[0] + 4) * size[1] + 4) * size[2] * gn_format_size(c->format) + 64;
    }
    c->memory = malloc(bound);
    if (!c->memory)
        return false;
    memset(c->memory, 0xA5, bound);
    for (uint32_t n = 0; n < c->level_count; ++n)
        if (!make_level(c, r, n, c->memory, &used))
            return false;
    c->texture.target = c->target;
    c->texture.format = c->format;
    c->texture.level_count = c->level_count;

    uint32_t size[3];
    case_level_size(c, c->base, size);
    c->texture.width = size[0];
    c->texture.height = size[1];
    c->texture.depth = size[2];
    return true;
}

/* A coordinate along a dimension of `size` texels. */
static float random_coordinate(random_source *r, uint32_t size, bool is_wild)
{
    const float n = (float)size;
    const float texel = (float)random_between(r, -2 * (int32_t)size, 3 * (int32_t)size);
    const uint32_t kind = random_below(r, is_wild ? 8 : 6);
    float s = random_float(r, -2.0f, 3.0f);

    switch (kind) {
    case 0: /* a texel's centre */
        return (texel + 0.5f) / n;
    case 1: /* a border between texels */
        return texel / n;
    case 2: { /* beside one */
        uint32_t bits;
        s = 0.5f * texel / n;
        memcpy(&bits, &s, sizeof bits);
        bits += s != 0.0f ? (uint32_t)random_between(r, -3, 3) : 0;
        memcpy(&s, &bits, sizeof s);
        return s;
    }
    case 6:
        s = random_octave(r, 3, 40);
        return s * random_sign(r);
    case 7: {
        static const float far[] = {1e30f,        -1e30f,   3e9f,      -3e9f, 16777216.0f,
                                    -16777217.0f, INFINITY, -INFINITY, NAN};
        return far[random_below(r, sizeof far / sizeof *far)];
    }
    default:
        return s;
    }
}

/* A level, or halfway between two. A zero has either sign. */
static float exact_lod(random_source *r, int32_t top)
{
    const float lod = 0.5f * (float)random_between(r, -2, 2 * top);

    return lod == 0.0f ? random_sign(r) * lod : lod;
}

/* A component of a direction. */
static float random_component(random_source *r, bool is_wild)
{
    static const float special[] = {0.0f,     -0.0f,     1.0f,  -1.0f,  0.5f,   -0.5f, 2.0f,
                                    INFINITY, -INFINITY, 1e30f, -1e30f, 1e-18f, 3.25f};

    if (is_wild)
        return special[random_below(r, sizeof special / sizeof *special)];
    return random_chance(r, 10) ? special[random_below(r, 7)] : random_float(r, -1.0f, 1.0f);
}

/* Directions of a quad and their gradients: near a face's middle, an edge or a corner, or all
 * components 0. No component is NaN: for some of these the reference reads undefined texels. */
static void direct_quad(lookup_case *c, random_source *r, uint32_t x, uint32_t y)
{
    const int32_t top = (int32_t)c->level_count + 1;
    const float level = random_float(r, -3.0f, (float)top);
    const float step = random_octave(r, -6, top) / (float)c->texture.width;
    const bool is_noise = random_chance(r, 15);
    const bool is_wild = c->is_wild && random_chance(r, 30);
    const bool is_nowhere = random_chance(r, 2);
    const uint32_t ones = random_below(r, 4);
    float at[3], dx[3], dy[3];

    for (uint32_t n = 0; n < 3; ++n) {
        at[n] = random_component(r, is_wild);
        if (n < ones && !is_wild) {
            const float sign = random_sign(r);
            at[n] = sign * random_float(r, 1.0f - step, 1.0f);
        }
        dx[n] = random_float(r, -1.0f, 1.0f) * step;
        dy[n] = random_float(r, -1.0f, 1.0f) * step;
    }
    for (uint32_t l = 0; l < 4; ++l) {
        const uint32_t p = (y + l / 2) * GRID_WIDTH + x + l % 2;

        for (int n = 0; n < 3; ++n) {
            c->places.place[p][n] = is_noise
                                        ? random_component(r, is_wild)
                                        : at[n] + dx[n] * (float)(l % 2) + dy[n] * (float)(l / 2);
            c->places.gradient_x[p][n] = is_noise ? random_float(r, -1.0f, 1.0f) : dx[n];
            c->places.gradient_y[p][n] = is_noise ? random_float(r, -1.0f, 1.0f) : dy[n];
            if (is_nowhere)
                c->places.place[p][n] = random_sign(r) * 0.0f;
        }
        c->places.place[p][3] = is_noise ? random_float(r, -3.0f, (float)top) : level;
        if (c->kind == LOOKUP_LOD && random_chance(r, 10))
            c->places.place[p][3] = exact_lod(r, top);
        c->places.gradient_x[p][3] = random_reference(r, c->format, c->is_wild);
    }
}

/* Differences of a power of two texels along the first two coordinates: if the sizes are powers of
 * two too, the level of detail may lie halfway between two levels. */
static void step_exactly(const lookup_case *c, random_source *r, int32_t top, float at[3],
                         float dx[3])
{
    const float texels = ldexpf(1.0f, random_between(r, -1, top));

    for (int n = 0; n < 2; ++n) {
        const float size = n == 0 ? (float)c->texture.width : (float)c->texture.height;

        at[n] = 0.25f * (float)random_between(r, -8, 8) / size;
        dx[n] = texels / size;
    }
}

/* Coordinates of a quad at (x, y): a random place, and differences of a random length and
 * direction, or four random places. In wild cases one number of one place may be special. */
static void place_quad(lookup_case *c, random_source *r, uint32_t x, uint32_t y)
{
    const bool is_array = c->target == GN_TEXTURE_2D_ARRAY;
    const int32_t top = (int32_t)c->level_count + 1;
    const bool is_noise = random_chance(r, 15);
    const float level = random_float(r, -3.0f, (float)top);
    const float step = random_octave(r, -3, top);
    float at[3], dx[3], dy[3];

    for (int n = 0; n < 3; ++n) {
        const float size = (float)c->texture.width;

        at[n] = random_coordinate(r,
                                  n == 0   ? c->texture.width
                                  : n == 1 ? c->texture.height
                                           : c->texture.depth,
                                  c->is_wild);
        dx[n] = random_float(r, -1.0f, 1.0f) * step / size;
        dy[n] = random_float(r, -1.0f, 1.0f) * step / size;
        if (random_chance(r, 15))
            dx[n] = 0.0f;
        if (random_chance(r, 15))
            dy[n] = 0.0f;
    }
    if (random_chance(r, 5))
        step_exactly(c, r, top, at, dx);
    for (uint32_t l = 0; l < 4; ++l) {
        const uint32_t p = (y + l / 2) * GRID_WIDTH + x + l % 2;

        for (int n = 0; n < 3; ++n) {
            const uint32_t size = n == 0   ? c->texture.width
                                  : n == 1 ? c->texture.height
                                           : c->texture.depth;

            c->places.place[p][n] = is_noise
                                        ? random_coordinate(r, size, c->is_wild)
                                        : at[n] + dx[n] * (float)(l % 2) + dy[n] * (float)(l / 2);
            c->places.gradient_x[p][n] = is_noise ? random_float(r, -1.0f, 1.0f) : dx[n];
            c->places.gradient_y[p][n] = is_noise ? random_float(r, -1.0f, 1.0f) : dy[n];
        }
        if (is_array)
            c->places.place[p][2] = random_float(r, -2.0f, (float)c->size[2] + 1.0f);
        if (is_array && random_chance(r, 30))
            c->places.place[p][2] = 0.5f * (float)random_between(r, -3, 2 * (int32_t)c->size[2]);
        c->places.place[p][3] = is_noise ? random_float(r, -3.0f, (float)top) : level;
        if (c->kind == LOOKUP_LOD && random_chance(r, 10))
            c->places.place[p][3] = exact_lod(r, top);
        c->places.gradient_x[p][3] = random_reference(r, c->format, c->is_wild);
    }
    if (c->is_wild && random_chance(r, 30)) {
        const uint32_t l = random_below(r, 4);
        const uint32_t n = random_chance(r, 30) ? 3 : random_below(r, 2);

        c->places.place[(y + l / 2) * GRID_WIDTH + x + l % 2][n] = random_special(r);
    }
}

/* Numbers texels; some of their numbers, or their level, lie outside the texture. */
static void number_texels(lookup_case *c, random_source *r)
{
    for (uint32_t p = 0; p < GRID_PIXELS; ++p) {
        const uint32_t level = random_below(r, c->level_count);
        const bool is_outside = random_chance(r, 20);
        uint32_t size[3];

        case_level_size(c, c->base + level, size);
        for (int n = 0; n < 3; ++n)
            c->places.place[p][n] = is_outside ? (float)((int32_t)random_below(r, size[n] + 4) - 2)
                                               : (float)random_below(r, size[n]);
        c->places.place[p][3] = (float)level;
        if (is_outside && random_chance(r, 20))
            c->places.place[p][3] = random_chance(r, 50) ? -1.0f : (float)c->level_count;
    }
}

static void choose_places(lookup_case *c, random_source *r)
{
    if (c->kind == LOOKUP_FETCH) {
        number_texels(c, r);
        return;
    }
    for (uint32_t y = 0; y < GRID_HEIGHT; y += 2)
        for (uint32_t x = 0; x < GRID_WIDTH; x += 2)
            (c->target == GN_TEXTURE_CUBE ? direct_quad : place_quad)(c, r, x, y);
}

bool case_make(lookup_case *c, uint64_t number, uint64_t seed)
{
    const case_digits d = digits_of(number % case_count());
    random_source r = random_seed(seed * UINT64_C(1000003) + number);

    memset(c, 0, sizeof *c);
    c->number = number;
    c->seed = seed;
    c->target = (gn_texture_target)d.target;
    c->kind = (lookup_kind)d.kind;
    if (c->kind == LOOKUP_GATHER && (c->target == GN_TEXTURE_1D || c->target == GN_TEXTURE_3D))
        c->kind = LOOKUP_LOD;
    if (c->kind == LOOKUP_FETCH && c->target == GN_TEXTURE_CUBE) /* GLSL has none */
        c->kind = LOOKUP_GATHER;
    c->channel = (int)random_below(&r, 4);
    c->is_wild = random_chance(&r, 30);
    c->format = choose_format(c, &r);
    choose_sizes(c, &r, d.shape);
    choose_sampler(c, &r, &d);
    if (c->target == GN_TEXTURE_2D && c->kind == LOOKUP_IMPLICIT && random_chance(&r, 30))
        make_simple(c);
    if (!make_texture(c, &r)) {
        case_free(c);
        return false;
    }
    choose_places(c, &r);
    return true;
}

void case_free(lookup_case *c)
{
    for (int n = 0; n < GN_MAX_LEVELS; ++n)
        free(c->packed[n]);
    free(c->memory);
}

void case_describe(const lookup_case *c, char *text, size_t size)
{
    static const char *const targets[] = {"2D", "1D", "2D array", "3D", "cube"};
    static const char *const kinds[] = {"texture",     "texture with bias", "textureLod",
                                        "textureGrad", "textureGather",     "texelFetch"};
    static const char *const wraps[] = {"repeat", "edge", "mirror", "border", "mirror edge"};
    static const char *const minifiers[] = {
        "nearest mip linear", "nearest",          "linear", "nearest mip nearest",
        "linear mip nearest", "linear mip linear"};
    const gn_sampler *const s = &c->sampler;

    snprintf(text, size,
             "%s of %s, format %d, %ux%ux%u, levels %u from %u, wrap %s, %s, %s, min %s, mag %s, "
             "bias %g, lod %g to %g%s, channel %d, compare %d%s",
             kinds[c->kind], targets[c->target], (int)c->format, c->size[0], c->size[1], c->size[2],
             c->level_count, c->base, wraps[s->wrap_s], wraps[s->wrap_t], wraps[s->wrap_r],
             minifiers[s->minify], s->magnify == GN_MAGNIFY_LINEAR ? "linear" : "nearest",
             (double)s->lod_bias, (double)s->min_lod, (double)s->max_lod,
             s->lod_clamp_enabled ? "" : " (not clamped)", c->channel, (int)s->compare,
             c->is_wild ? ", wild" : "");
}
