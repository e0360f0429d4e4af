/* Textures of every target, format and sampler state under the shader of reference/scene/sampled.h.
 */
#include "generate_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The `levels` argument of random_sampling: all possible levels, or some. */
#define ANY_LEVELS 0

static uint32_t random_side(random_source *r, gn_texture_target target)
{
    static const uint32_t sides[] = {1, 2, 3, 4, 5, 7, 8, 9, 16, 20, 32, 37, 50, 64};

    return sides[random_below(r, target == GN_TEXTURE_3D     ? 9
                                 : target == GN_TEXTURE_CUBE ? 11
                                                             : 14)];
}

static void random_size(random_source *r, gn_texture *t, uint32_t levels)
{
    uint32_t most = 1;

    t->width = random_side(r, t->target);
    t->height = random_side(r, t->target);
    t->depth = t->target == GN_TEXTURE_3D ? random_side(r, t->target) : 1 + random_below(r, 5);
    if (t->target == GN_TEXTURE_CUBE || random_chance(r, 30))
        t->height = t->width;
    if (t->target == GN_TEXTURE_1D)
        t->height = 1;
    while (t->width >> most || t->height >> most ||
           (t->target == GN_TEXTURE_3D && t->depth >> most))
        ++most;
    t->level_count = levels != ANY_LEVELS   ? levels
                     : random_chance(r, 70) ? most
                                            : 1 + random_below(r, most);
}

static gn_format random_texture_format(random_source *r, bool depths)
{
    static const gn_format of_depth[] = {GN_FORMAT_D16, GN_FORMAT_D24, GN_FORMAT_D32F,
                                         GN_FORMAT_D24S8, GN_FORMAT_D32FS8};
    const bool common = random_chance(r, 30);
    const gn_format color = random_texel_format(r, common);
    const uint32_t depth = random_below(r, 5);

    return depths ? of_depth[depth] : color;
}

static uint32_t bits_of(float f)
{
    uint32_t bits;
    memcpy(&bits, &f, sizeof bits);
    return bits;
}

/* A binary16, mostly from 0 to 1, otherwise any that is not NaN or infinite. */
static uint32_t random_half(random_source *r)
{
    const uint32_t bits = (uint32_t)(random_bits(r) >> 48);

    if (random_chance(r, 80))
        return bits % 0x3C01;
    return (bits & 0x7C00) == 0x7C00 ? bits & 0xBFFF : bits;
}

/* Large enough that products do not become denormal; the contract leaves denormals out. */
static float random_texel(random_source *r)
{
    const float within = random_unit(r), beyond = random_float(r, -1.0f, 2.0f);

    return random_chance(r, 80) ? within : beyond;
}

/* Depths, some of which equal the values that they are compared with. */
static float random_depth(random_source *r)
{
    const float any = random_unit(r), eighth = (float)random_below(r, 9) * 0.125f;

    return random_chance(r, 50) ? any : eighth;
}

static uint32_t random_element(random_source *r, gn_format format, size_t i)
{
    const float depth = random_depth(r);

    if (format == GN_FORMAT_R11F_G11F_B10F) {
        const uint32_t red = random_half(r) >> 4 & 0x7FF, green = random_half(r) >> 4 & 0x7FF;

        return red | green << 11 | (random_half(r) >> 5 & 0x3FF) << 22;
    }
    if (scene_is_color_format(format) && scene_is_float_format(format)) {
        if (scene_channel_width(format, 0) == 32)
            return bits_of(random_texel(r));
        const uint32_t half = random_half(r);

        return scene_element_size(format) == 2 ? half : half | random_half(r) << 16;
    }
    switch (format) {
    case GN_FORMAT_D16:
        return (uint32_t)((double)depth * 65535.0);
    case GN_FORMAT_D24:
        return (uint32_t)((double)depth * 16777215.0);
    case GN_FORMAT_D24S8:
        return (uint32_t)((double)depth * 16777215.0) | random_below(r, 256) << 24;
    case GN_FORMAT_D32F:
        return bits_of(depth);
    case GN_FORMAT_D32FS8:
        return i % 2 ? random_below(r, 256) : bits_of(depth);
    default:
        return (uint32_t)(random_bits(r) >> 32);
    }
}

static void *random_elements(random_source *r, const gn_texture *t)
{
    const size_t count = scene_texture_elements(t), size = scene_element_size(t->format);
    void *elements = malloc(count * size);
    if (!elements) {
        fprintf(stderr, "parity: out of memory\n");
        exit(EXIT_FAILURE);
    }
    for (size_t i = 0; i < count; ++i)
        scene_set_element(elements, size, i, random_element(r, t->format, i));
    return elements;
}

static void random_sampler(random_source *r, const gn_texture *t, gn_sampler *s, bool depths)
{
    s->wrap_s = (gn_wrap)random_below(r, 5);
    s->wrap_t = (gn_wrap)random_below(r, 5);
    s->wrap_r = (gn_wrap)random_below(r, 5);
    s->magnify = (gn_magnify)random_below(r, 2);
    s->minify = (gn_minify)random_below(r, 6);
    if (random_chance(r, 30))
        s->lod_bias = random_chance(r, 80) ? random_float(r, -3.0f, 3.0f)
                                           : (float)random_between(r, -20, 20) * 0.5f;
    s->lod_clamp_enabled = random_chance(r, 25);
    if (s->lod_clamp_enabled) {
        s->min_lod = random_float(r, -2.0f, (float)t->level_count);
        s->max_lod = s->min_lod + (random_chance(r, 20) ? 0.0f : random_float(r, 0.0f, 4.0f));
    }
    for (int c = 0; c < 4; ++c)
        s->border[c] = random_chance(r, 90) ? random_unit(r) : random_float(r, -1.0f, 2.0f);
    if (depths)
        s->compare = (gn_compare)random_below(r, GN_ALWAYS + 1);
}

/* The range of texture coordinates. */
typedef struct reach {
    uint32_t kind;
    float extent;
    int32_t octave;
} reach;

static float random_coordinate(random_source *r, const reach *a, float from, float size)
{
    const float sign = random_sign(r);

    switch (a->kind) {
    case 1:
        return random_float(r, -3.0f, 4.0f);
    case 2:
        return random_float(r, -a->extent, a->extent);
    case 3: /* texel borders and centres, where the nearest filter and the weights tie */
        return (float)random_between(r, -6, 20) * 0.5f / size;
    case 4:
        return from * 1.5f - 0.25f;
    case 5: /* magnified */
        return 0.375f + from * a->extent * 0.0078125f;
    case 6: /* beyond the integers */
        return sign * random_octave(r, a->octave, a->octave);
    default:
        return from;
    }
}

/* A direction of any length: random, along axes and diagonals, where faces tie, or near an edge. */
static void random_direction(random_source *r, float d[3])
{
    const uint32_t kind = random_below(r, 4);
    const float length = random_chance(r, 70) ? 1.0f : random_octave(r, -8, 8);

    for (int c = 0; c < 3; ++c) {
        const float whole = (float)random_between(r, -1, 1), near = random_float(r, 0.98f, 1.0f);

        d[c] = kind == 0 ? whole : kind == 1 ? whole * near : random_float(r, -1.0f, 1.0f);
        d[c] *= length;
    }
}

static void random_coordinates(builder *b)
{
    random_source *r = &b->random;
    const gn_texture *t = &b->uniforms.texture;
    const float sizes[3] = {(float)t->width, (float)t->height, (float)t->depth};
    const uint32_t kind = random_below(r, 7);
    const float extent = random_octave(r, -3, 6);
    const int32_t octave = random_between(r, 20, 60);
    const reach far = {kind, extent, octave};
    const bool smooth = random_chance(r, 50);
    const float reference = random_depth(r), span = random_chance(r, 50) ? 0.0f : 0.5f;

    b->texcoord_components = 4;
    for (uint32_t i = 0; i < b->vertex_count; ++i) {
        vertex *v = &b->vertices[i];

        v->texcoord[2] = random_unit(r);
        for (int c = 0; c < 3; ++c)
            v->texcoord[c] = random_coordinate(r, &far, v->texcoord[c], sizes[c]);
        if (t->target == GN_TEXTURE_2D_ARRAY)
            v->texcoord[2] = random_float(r, -1.0f, sizes[2] + 1.0f);
        if (t->target == GN_TEXTURE_CUBE && smooth)
            memcpy(v->texcoord, v->position, 3 * sizeof *v->texcoord);
        else if (t->target == GN_TEXTURE_CUBE)
            random_direction(r, v->texcoord);
        v->texcoord[3] = reference + random_float(r, -span, span);
    }
}

void *random_sampling(builder *b, gn_texture_target target, uint32_t levels, bool depths)
{
    random_source *r = &b->random;
    gn_texture *t = &b->uniforms.texture;

    b->shader = SCENE_SAMPLED;
    t->target = target;
    random_size(r, t, levels);
    t->format = random_texture_format(r, depths);
    random_sampler(r, t, &b->uniforms.sampler, depths);
    void *texels = random_elements(r, t);
    t->level[0].texels = texels;
    random_coordinates(b);
    return texels;
}

void *random_any_sampling(builder *b)
{
    const gn_texture_target target = (gn_texture_target)random_below(&b->random, 5);
    const bool depths = random_chance(&b->random, 30);

    return random_sampling(b, target, ANY_LEVELS, depths && target != GN_TEXTURE_3D);
}

static void add_sampled(builder *b, gn_texture_target target, uint32_t levels, bool depths)
{
    random_source *r = &b->random;

    builder_common_state(b);
    if (random_chance(r, 50)) {
        random_camera(b);
        add_body(b);
    } else {
        const placement places[] = {PLACE_ANYWHERE, PLACE_AFFINE, PLACE_TIES, PLACE_CLIP};
        const placement place = places[random_below(r, 4)];
        shape_triangles(b, place, builder_triangle_count(b));
    }
    const float least = random_chance(r, 30) ? -1.0f : 0.25f;
    for (uint32_t i = 0; i < b->vertex_count; ++i)
        for (int c = 0; c < 4; ++c)
            b->vertices[i].color[c] = least + (1.0f - least) * b->vertices[i].color[c];
    void *texels = random_sampling(b, target, levels, depths);
    builder_draw(b);
    free(texels);
}

static void generate_targets(builder *b, const gn_texture_target *targets, uint32_t count,
                             uint32_t levels, bool depths)
{
    random_source *r = &b->random;

    builder_common_target(b);
    if (random_chance(r, 50))
        b->scene->color_format = GN_FORMAT_RGBA32F;
    for (uint32_t draws = 1 + random_below(r, 2); draws > 0; --draws) {
        const bool of_depths = depths || random_chance(r, 10);
        const gn_texture_target target = targets[random_below(r, count)];
        add_sampled(b, target, levels, of_depths && target != GN_TEXTURE_3D);
    }
}

void generate_textures(builder *b)
{
    static const gn_texture_target targets[] = {GN_TEXTURE_2D, GN_TEXTURE_2D, GN_TEXTURE_1D};
    generate_targets(b, targets, 3, 1, false);
}

void generate_mipmaps(builder *b)
{
    static const gn_texture_target targets[] = {GN_TEXTURE_2D, GN_TEXTURE_2D, GN_TEXTURE_1D};
    generate_targets(b, targets, 3, ANY_LEVELS, false);
}

void generate_volumes(builder *b)
{
    static const gn_texture_target targets[] = {GN_TEXTURE_3D, GN_TEXTURE_2D_ARRAY};
    generate_targets(b, targets, 2, ANY_LEVELS, false);
}

void generate_cubes(builder *b)
{
    static const gn_texture_target targets[] = {GN_TEXTURE_CUBE};
    generate_targets(b, targets, 1, ANY_LEVELS, false);
}

void generate_shadows(builder *b)
{
    static const gn_texture_target targets[] = {GN_TEXTURE_2D, GN_TEXTURE_2D_ARRAY, GN_TEXTURE_CUBE,
                                                GN_TEXTURE_1D};
    generate_targets(b, targets, 4, ANY_LEVELS, true);
}
