/* A lookup in any texture with any numbers reads only its texels: each level is at an end of memory
 * beyond which nothing may be read, and the values of texels differ from those of the gaps between
 * rows and layers. */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include <gnomon.h>

#include "guarded_texture.h"
#include "random_inputs.h"
#include "random_textures.h"
#include "scene.h"

#define MOST_MAPPED ((size_t)1 << 34)

typedef struct hostile {
    gn_texture texture; /* without the levels' texels; strides are set */
    gn_sampler sampler;
    bool at_end[GN_MAX_LEVELS]; /* at the end of its memory, or at its beginning */
    uint64_t texels;            /* the seed of the texels */
    gn_lod_source lod_source;
    int channel;
    float coordinate[3][GN_LANES], reference[GN_LANES], lod[GN_LANES];
    float gradient[2][3][GN_LANES];
    int32_t number[3][GN_LANES], level[GN_LANES];
} hostile;

static ptrdiff_t random_stride(random_source *r, size_t least, size_t element, bool is_large)
{
    const size_t padding = random_chance(r, 40)   ? 0
                           : random_chance(r, 70) ? 1 + random_below(r, 5)
                           : is_large             ? random_below(r, 1 << 16)
                                                  : random_below(r, 2000);
    const ptrdiff_t stride = (ptrdiff_t)(least + padding * element);

    return random_chance(r, 70) ? stride : -stride;
}

/* With one row or layer, its stride may be any multiple of the element. */
static void random_strides(random_source *r, gn_texture *t)
{
    const size_t element = scene_element_size(t->format);

    for (uint32_t level = 0; level < scene_level_count(t); ++level) {
        const scene_extent e = scene_level_extent(t, level);
        gn_texture_level *const l = &t->level[level];
        const size_t row = e.width * gn_format_size(t->format);
        const bool is_large = t->width > 1000;

        l->row_stride = random_stride(r, row, element, is_large);
        l->layer_stride =
            random_stride(r, guarded_length(l->row_stride) * e.height, element, is_large);
        if (e.height == 1 && random_chance(r, 20))
            l->row_stride = random_chance(r, 50) ? 0 : PTRDIFF_MIN;
        if (e.layers == 1 && random_chance(r, 50))
            l->layer_stride = random_chance(r, 50) ? 0 : PTRDIFF_MIN;
    }
}

static void random_lookup(hostile *h, random_source *r)
{
    const bool is_tame = random_chance(r, 30);
    const int32_t most = random_chance(r, 50) ? 8 : 70;

    h->lod_source = (gn_lod_source)random_below(r, 3);
    h->channel = (int)random_below(r, 4);
    for (int l = 0; l < GN_LANES; ++l) {
        for (int c = 0; c < 3; ++c) {
            h->coordinate[c][l] = is_tame ? random_float(r, -2.0f, 3.0f) : random_hostile_number(r);
            for (int g = 0; g < 2; ++g)
                h->gradient[g][c][l] =
                    is_tame ? random_float(r, -1.0f, 1.0f) : random_hostile_number(r);
            h->number[c][l] = random_chance(r, 80) ? random_between(r, -2, most)
                                                   : (int32_t)(uint32_t)random_bits(r);
        }
        h->reference[l] = is_tame ? random_unit(r) : random_hostile_number(r);
        h->lod[l] = is_tame ? random_float(r, -2.0f, 8.0f) : random_hostile_number(r);
        h->level[l] =
            random_chance(r, 80) ? random_between(r, -1, 8) : (int32_t)(uint32_t)random_bits(r);
    }
}

static bool maps(const gn_texture *t)
{
    for (uint32_t level = 0; level < scene_level_count(t); ++level)
        if (guarded_span(t, level) > MOST_MAPPED)
            return false;
    return true;
}

static enum theft_alloc_res make_hostile(struct theft *t, void *env, void **output)
{
    hostile *const h = *output = allocated(sizeof *h);
    random_source r = random_seed(theft_random_bits(t, 32));

    (void)env;
    do {
        const bool is_large = random_chance(&r, 15);

        h->texture = random_texture_shape(&r, is_large ? GN_MAX_SIZE : 70);
        if (is_large && random_chance(&r, 50)) {
            h->texture.width = GN_MAX_SIZE;
            h->texture.height = h->texture.target == GN_TEXTURE_1D ? 1 : h->texture.width;
            h->texture.level_count = 1;
        }
        random_strides(&r, &h->texture);
    } while (!maps(&h->texture));
    h->sampler = random_sampler_state(&r);
    for (int level = 0; level < GN_MAX_LEVELS; ++level)
        h->at_end[level] = random_chance(&r, 60);
    h->texels = random_bits(&r);
    random_lookup(h, &r);
    return THEFT_ALLOC_OK;
}

static void print_hostile(FILE *f, const void *instance, void *env)
{
    const hostile *h = instance;
    const gn_texture *t = &h->texture;

    (void)env;
    fprintf(f,
            "target %d, format %d, %" PRIu32 "x%" PRIu32 "x%" PRIu32 ", %" PRIu32
            " levels; wraps %d %d %d, filters %d %d, compare %d, bias %g, clamp %d %g %g, "
            "anisotropy %" PRIu32 "; lod source %d\n",
            (int)t->target, (int)t->format, t->width, t->height, t->depth, t->level_count,
            (int)h->sampler.wrap_s, (int)h->sampler.wrap_t, (int)h->sampler.wrap_r,
            (int)h->sampler.magnify, (int)h->sampler.minify, (int)h->sampler.compare,
            (double)h->sampler.lod_bias, h->sampler.lod_clamp_enabled, (double)h->sampler.min_lod,
            (double)h->sampler.max_lod, h->sampler.max_anisotropy, (int)h->lod_source);
    for (int l = 0; l < GN_LANES; ++l)
        fprintf(f, "  %.9g %.9g %.9g, lod %.9g, reference %.9g\n", (double)h->coordinate[0][l],
                (double)h->coordinate[1][l], (double)h->coordinate[2][l], (double)h->lod[l],
                (double)h->reference[l]);
}

static sigjmp_buf before_read;

static void leave_read(int signal)
{
    (void)signal;
    siglongjmp(before_read, 1);
}

/* ---- Possible results of lookups ---- */

static int channels_of(gn_format format)
{
    return scene_is_color_format(format) ? scene_format_of(format)->channels : 1;
}

/* Whether a channel's value is one that texels and the border have. */
static bool is_of_texture(const hostile *h, bool filled, int c, float value)
{
    const gn_format format = h->texture.format;
    const bool any = scene_channel_width(format, 0) < 8;
    const bool compared = scene_has_depth(format) && h->sampler.compare != GN_COMPARE_DEFAULT;
    const float least = !filled || any || compared              ? 0.0f
                        : format == GN_FORMAT_SRGB8_A8 && c < 3 ? 0.05f
                                                                : 0.249f;

    if (c >= channels_of(format))
        return value == (c == 3 ? 1.0f : 0.0f);
    return value >= least && value <= (any || compared ? 1.000001f : 0.501f);
}

static bool is_tame(float x)
{
    return fabsf(x) <= 1e30f;
}

/* Whether no input of the lookup makes a weight or a direction NaN. */
static bool has_numbers(const hostile *h, int lane)
{
    const bool is_cube = h->texture.target == GN_TEXTURE_CUBE;
    bool tame = is_tame(h->sampler.lod_bias);
    float length = 0.0f;

    for (int l = 0; l < GN_LANES; ++l)
        for (int c = 0; c < 3; ++c) {
            const bool looked_at = l == lane || h->lod_source == GN_LOD_IMPLICIT;

            tame = tame && (!looked_at || is_tame(h->coordinate[c][l]));
            if (h->lod_source == GN_LOD_GRADIENTS)
                tame = tame && is_tame(h->gradient[0][c][l]) && is_tame(h->gradient[1][c][l]);
            if (l == lane)
                length = fmaxf(length, fabsf(h->coordinate[c][l]));
            /* A direction's derivatives are divided by the square of its length. */
            if (is_cube && h->lod_source != GN_LOD_EXPLICIT)
                tame = tame && fabsf(h->coordinate[c][l]) <= 1e9f;
            tame = tame && is_tame(h->lod[l]);
        }
    return tame && (!is_cube || length >= 1e-9f);
}

/* Whether some filter has weights that may become NaN: along repeating dimensions and borders, and
 * in cubes. */
static bool has_weights(const gn_texture *t, const gn_sampler *s)
{
    const gn_wrap wraps[3] = {s->wrap_s, s->wrap_t, s->wrap_r};
    const int count = t->target == GN_TEXTURE_1D ? 1 : t->target == GN_TEXTURE_3D ? 3 : 2;
    bool may_be_nan = t->target == GN_TEXTURE_CUBE;

    for (int c = 0; c < count; ++c)
        may_be_nan =
            may_be_nan || wraps[c] == GN_WRAP_REPEAT || wraps[c] == GN_WRAP_CLAMP_TO_BORDER;
    if (!may_be_nan)
        return false;
    return s->magnify != GN_MAGNIFY_NEAREST ||
           (s->minify != GN_MINIFY_NEAREST && s->minify != GN_MINIFY_NEAREST_MIPMAP_NEAREST);
}

static bool texels_are_of_texture(const hostile *h, bool filled, bool has_weight, const char *what,
                                  float texel[4][GN_LANES])
{
    for (int l = 0; l < GN_LANES; ++l)
        for (int c = 0; c < 4; ++c) {
            const bool may_be_nan = has_weight && !has_numbers(h, l);

            if (!is_of_texture(h, filled, c, texel[c][l]) &&
                !(may_be_nan && texel[c][l] != texel[c][l])) {
                fprintf(stderr, "%s: lane %d, channel %d is %.9g\n", what, l, c,
                        (double)texel[c][l]);
                return false;
            }
        }
    return true;
}

/* ---- Lookups ---- */

typedef struct shading {
    const hostile *hostile;
    const gn_texture *texture;
    gn_lookup lookup;
} shading;

static gn_lookup lookup_of(const hostile *h)
{
    gn_lookup lookup = {.reference = h->reference, .lod_source = h->lod_source, .lod = h->lod};

    for (int c = 0; c < 3; ++c) {
        lookup.coordinate[c] = h->coordinate[c];
        lookup.gradient_x[c] = h->gradient[0][c];
        lookup.gradient_y[c] = h->gradient[1][c];
    }
    return lookup;
}

static void cover_all(const void *uniforms, const gn_vertex_input *input, gn_vertex_output *output)
{
    (void)uniforms;
    for (int l = 0; l < GN_LANES; ++l) {
        output->position[0][l] = input->vertex_id[l] == 1 ? 3.0f : -1.0f;
        output->position[1][l] = input->vertex_id[l] == 2 ? 3.0f : -1.0f;
        output->position[2][l] = 0.0f;
        output->position[3][l] = 1.0f;
    }
}

static void sample_hostile(const void *uniforms, const gn_fragment_input *input,
                           gn_fragment_output *output)
{
    const shading *s = uniforms;

    gn_fragment_lookup(input, s->texture, &s->hostile->sampler, &s->lookup,
                       (float(*)[GN_LANES])output->color);
}

/* Whether a shader on the back end reads the result of gn_texture_lookup. */
static bool shader_agrees(const shading *s, gn_backend backend, float texel[4][GN_LANES])
{
    float pixels[GN_LANES][4];
    const gn_target target = {{gn_surface_bottom_up(pixels, GN_FORMAT_RGBA32F, 4, 4)}, {0}};
    const gn_pipeline pipeline = {.program.vertex_shader = cover_all,
                                  .program.fragment_shader = sample_hostile,
                                  .program.uniforms = s};
    const gn_mesh mesh = {.vertex_count = 3, .count = 3};
    const size_t size = gn_workspace_size(0, 4);
    gn_workspace workspace = {.memory = malloc(size), .size = size, .backend = backend};
    bool good = workspace.memory && gn_draw(&target, &pipeline, &mesh, &workspace) == GN_OK;

    for (int l = 0; l < GN_LANES; ++l)
        for (int c = 0; c < 4; ++c)
            good = good && same_floats(&pixels[l][c], &texel[c][l], 1);
    free(workspace.memory);
    if (!good)
        fprintf(stderr, "back end %s reads otherwise\n", gn_backend_name(backend));
    return good;
}

/* Fetches outside the texture return 0, and alpha 1 if the format has none. */
static bool fetched_is_good(const hostile *h, bool filled, float texel[4][GN_LANES])
{
    hostile plain = *h;

    plain.sampler.compare = GN_COMPARE_DEFAULT;
    for (int l = 0; l < GN_LANES; ++l) {
        const uint32_t levels = scene_level_count(&h->texture);
        const bool has_level = h->level[l] >= 0 && (uint32_t)h->level[l] < levels;
        const scene_extent e =
            scene_level_extent(&h->texture, has_level ? (uint32_t)h->level[l] : 0);
        const bool is_inside =
            has_level && (uint32_t)h->number[0][l] < e.width &&
            (e.height == 1 && h->texture.target == GN_TEXTURE_1D
                 ? true
                 : (uint32_t)h->number[1][l] < e.height) &&
            (h->texture.target <= GN_TEXTURE_1D || (uint32_t)h->number[2][l] < e.layers);

        for (int c = 0; c < 4; ++c) {
            const float absent = c == 3 && channels_of(h->texture.format) < 4 ? 1.0f : 0.0f;

            if (is_inside ? !is_of_texture(&plain, filled, c, texel[c][l])
                          : texel[c][l] != absent) {
                fprintf(stderr, "fetch: lane %d, channel %d is %.9g\n", l, c, (double)texel[c][l]);
                return false;
            }
        }
    }
    return true;
}

static bool lookups_stay_inside(const hostile *h, const gn_texture *t, bool filled)
{
    const shading s = {h, t, lookup_of(h)};
    const int32_t *const number[3] = {h->number[0], h->number[1], h->number[2]};
    float texel[4][GN_LANES], one[4];

    gn_texture_lookup(t, &h->sampler, &s.lookup, texel);
    bool good = texels_are_of_texture(h, filled, has_weights(t, &h->sampler), "sample", texel);
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT && good; ++b)
        if (gn_backend_available((gn_backend)b))
            good = shader_agrees(&s, (gn_backend)b, texel);
    if (good && t->target != GN_TEXTURE_1D && t->target != GN_TEXTURE_3D) {
        const int c = scene_has_depth(t->format) ? 0 : h->channel;

        gn_texture_gather(t, &h->sampler, &s.lookup, c, texel);
        for (int k = 0; k < 4; ++k)
            for (int l = 0; l < GN_LANES && good; ++l)
                good = is_of_texture(h, filled, c, texel[k][l]);
        if (!good)
            fprintf(stderr, "gather gives none of the texture\n");
    }
    gn_texture_fetch(t, number, h->level, texel);
    good = good && fetched_is_good(h, filled, texel);
    for (int l = 0; l < GN_LANES; ++l) {
        const float at[3] = {h->coordinate[0][l], h->coordinate[1][l], h->coordinate[2][l]};

        gn_texture_lookup_at(t, &h->sampler, at, h->lod[l], h->reference[l], one);
    }
    if (t->target == GN_TEXTURE_2D)
        gn_texture_lookup_2d(t, &h->sampler, h->coordinate[0], h->coordinate[1], texel);
    return good;
}

/* Also returns false if the lookup reads outside the texture's memory. */
static bool is_checked_and_read(const hostile *h, const gn_texture *t, bool filled)
{
    if (sigsetjmp(before_read, 1) != 0) {
        fprintf(stderr, "a read outside the texture\n");
        return false;
    }
    return gn_texture_check(t) == GN_OK && lookups_stay_inside(h, t, filled);
}

static enum theft_trial_res reads_nothing_else(struct theft *theft, void *instance)
{
    const hostile *h = instance;
    struct sigaction own, old[2];
    guarded memory[GN_MAX_LEVELS];
    gn_texture t;
    const bool filled = guarded_map(&h->texture, h->texels, h->at_end, &t, memory);

    (void)theft;
    memset(&own, 0, sizeof own);
    own.sa_handler = leave_read;
    sigaction(SIGSEGV, &own, &old[0]);
    sigaction(SIGBUS, &own, &old[1]);
    const bool good = is_checked_and_read(h, &t, filled);
    sigaction(SIGSEGV, &old[0], NULL);
    sigaction(SIGBUS, &old[1], NULL);
    guarded_unmap(&t, memory);
    return verdict(good);
}

static const property textures[] = {
    DRAWING("lookups read texels of the texture alone", reads_nothing_else,
            INSTANCES(make_hostile, print_hostile, NULL), 200),
};

SUITE(properties_textures, textures);
