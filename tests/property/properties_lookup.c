/* Properties of lookups that hold for every texture: a lookup of one place equals the lookup of
 * sixteen, and a texel's centre returns the texel. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gnomon.h>

#include "random_inputs.h"
#include "random_textures.h"
#include "scene.h"

/* A texture with its texels, which the caller frees. */
static gn_texture random_texture(random_source *r)
{
    gn_texture t = random_texture_shape(r, 24);
    const size_t count = scene_texture_elements(&t), size = scene_element_size(t.format);
    void *const texels = allocated(count * size);

    for (size_t i = 0; i < count; ++i) {
        const float number = random_float(r, 0.125f, 1.0f);
        const int width = scene_channel_width(t.format, 0);
        const bool is_float = scene_is_float_format(t.format) && width == 32 &&
                              (t.format != GN_FORMAT_D32FS8 || i % 2 == 0);
        uint32_t bits = (uint32_t)(random_bits(r) >> 32);

        if (is_float)
            memcpy(&bits, &number, sizeof bits);
        if (scene_is_float_format(t.format) && width == 16) /* 0 to 1 */
            bits &= 0x3BFF3BFF;
        if (scene_is_float_format(t.format) && width == 11)
            bits &= 0x77DDFBBF;
        if (t.format == GN_FORMAT_D24)
            bits &= 0xFFFFFF;
        scene_set_element(texels, size, i, bits);
    }
    scene_pack_texture(&t, texels);
    return t;
}

static void free_texels(const gn_texture *t)
{
    free((void *)t->level[0].texels);
}

/* Whether places do not affect their neighbours. Otherwise, if one of four places is filtered
 * linearly, so are the other three, whose nearest texel gets the weight 1; and a cube's corner
 * changes the order of their sums. That changes results by a rounding or two of texels up to 1, if
 * coordinates are not beyond the integers. */
static bool stand_alone(const gn_texture *t, const gn_sampler *s)
{
    const bool minifies_linearly = s->minify == GN_MINIFY_LINEAR ||
                                   s->minify == GN_MINIFY_LINEAR_MIPMAP_NEAREST ||
                                   s->minify == GN_MINIFY_LINEAR_MIPMAP_LINEAR;

    return t->target != GN_TEXTURE_CUBE && (s->magnify == GN_MAGNIFY_LINEAR) == minifies_linearly;
}

static enum theft_trial_res one_place_is_one_of_sixteen(struct theft *theft, void *instance)
{
    random_source r = random_seed(*(const uint64_t *)instance);
    const gn_texture t = random_texture(&r);
    const gn_sampler s = random_sampler_state(&r);
    const bool alone = stand_alone(&t, &s);
    const bool is_tame = !alone || random_chance(&r, 60);
    static const float offset[3] = {0.3183f, 0.4142f, 0.2718f};
    float coordinate[3][GN_LANES], lod[GN_LANES], reference[GN_LANES], texel[4][GN_LANES], one[4];
    const gn_lookup lookup = {.coordinate = {coordinate[0], coordinate[1], coordinate[2]},
                              .reference = reference,
                              .lod_source = GN_LOD_EXPLICIT,
                              .lod = lod};
    bool good = true;

    (void)theft;
    for (int l = 0; l < GN_LANES; ++l) {
        for (int c = 0; c < 3; ++c)
            /* Never on a texel's border, where neighbouring places choose independently, nor,
             * because each has its own offset, on an edge of a cube. */
            coordinate[c][l] = is_tame
                                   ? ((float)random_between(&r, -2048, 3071) + offset[c]) / 1024.0f
                                   : random_hostile_number(&r);
        lod[l] = is_tame ? random_float(&r, -2.0f, 7.0f) : random_hostile_number(&r);
        reference[l] = random_unit(&r);
    }
    gn_texture_lookup(&t, &s, &lookup, texel);
    for (int l = 0; l < GN_LANES && good; ++l) {
        const float at[3] = {coordinate[0][l], coordinate[1][l], coordinate[2][l]};

        gn_texture_lookup_at(&t, &s, at, lod[l], reference[l], one);
        for (int c = 0; c < 4; ++c)
            good = good && (same_floats(&texel[c][l], &one[c], 1) ||
                            (!alone && fabsf(texel[c][l] - one[c]) <= 3e-7f));
    }
    free_texels(&t);
    return verdict(good);
}

/* The number of a texel on a repeat of the texture. */
static int32_t repeated(gn_wrap wrap, int32_t number, int32_t size, int32_t repeat)
{
    return wrap == GN_WRAP_MIRRORED_REPEAT && repeat % 2 ? size - 1 - number : number;
}

/* The direction to a texel of a cube's face (OpenGL 4.5 table 8.19). */
static void direction_to(int32_t face, float s, float t, float d[3])
{
    const float across[6][3] = {{1.0f, -t, -s}, {-1.0f, -t, s}, {s, 1.0f, t},
                                {s, -1.0f, -t}, {s, -t, 1.0f},  {-s, -t, -1.0f}};

    memcpy(d, across[face], sizeof across[face]);
}

static enum theft_trial_res centres_give_their_texels(struct theft *theft, void *instance)
{
    random_source r = random_seed(*(const uint64_t *)instance);
    const gn_texture t = random_texture(&r);
    gn_sampler s = random_sampler_state(&r);
    const uint32_t level = random_below(&r, scene_level_count(&t));
    const scene_extent e = scene_level_extent(&t, level);
    const int32_t size[3] = {(int32_t)e.width, (int32_t)e.height, (int32_t)e.layers};
    const gn_wrap wraps[3] = {s.wrap_s, s.wrap_t, s.wrap_r};
    int32_t number[3][GN_LANES], levels[GN_LANES];
    const int32_t *const numbers[3] = {number[0], number[1], number[2]};
    float coordinate[3][GN_LANES], lod[GN_LANES], texel[4][GN_LANES], fetched[4][GN_LANES];
    const gn_lookup lookup = {.coordinate = {coordinate[0], coordinate[1], coordinate[2]},
                              .lod_source = GN_LOD_EXPLICIT,
                              .lod = lod};
    bool good = true;

    (void)theft;
    s.magnify = GN_MAGNIFY_NEAREST;
    s.minify = GN_MINIFY_NEAREST_MIPMAP_NEAREST;
    s.compare = GN_COMPARE_DEFAULT;
    s.lod_bias = 0.0f;
    s.lod_clamp_enabled = false;
    s.max_anisotropy = 0;
    for (int l = 0; l < GN_LANES; ++l) {
        for (int c = 0; c < 3; ++c) {
            const bool is_layer = c == 2 && t.target == GN_TEXTURE_2D_ARRAY;
            const bool repeats = wraps[c] == GN_WRAP_REPEAT || wraps[c] == GN_WRAP_MIRRORED_REPEAT;
            const int32_t repeat = repeats && !is_layer ? random_between(&r, -4, 4) : 0;
            const float centre = random_chance(&r, 30) ? 0.5f : random_float(&r, 0.1f, 0.9f);

            number[c][l] = (int32_t)random_below(&r, (uint32_t)size[c]);
            coordinate[c][l] =
                is_layer
                    ? (float)number[c][l]
                    : (float)repeat + ((float)repeated(wraps[c], number[c][l], size[c], repeat) +
                                       (repeat % 2 ? 0.5f : centre)) /
                                          (float)size[c];
        }
        if (t.target == GN_TEXTURE_CUBE) {
            float d[3];

            direction_to(number[2][l], 2.0f * ((float)number[0][l] + 0.5f) / (float)size[0] - 1.0f,
                         2.0f * ((float)number[1][l] + 0.5f) / (float)size[1] - 1.0f, d);
            for (int c = 0; c < 3; ++c)
                coordinate[c][l] = d[c];
        }
        levels[l] = (int32_t)level;
        lod[l] = (float)level + random_float(&r, -0.4f, 0.4f);
    }
    gn_texture_lookup(&t, &s, &lookup, texel);
    gn_texture_fetch(&t, numbers, levels, fetched);
    for (int l = 0; l < GN_LANES; ++l)
        for (int c = 0; c < 4; ++c)
            good = good && same_floats(&texel[c][l], &fetched[c][l], 1);
    free_texels(&t);
    return verdict(good);
}

static const property lookups_in_textures[] = {
    DRAWING("a lookup at one place gives what sixteen places give", one_place_is_one_of_sixteen,
            SEEDS, 100),
    DRAWING("the nearest filter gives at a texel's centre what is fetched",
            centres_give_their_texels, SEEDS, 100),
};

SUITE(properties_lookup, lookups_in_textures);
