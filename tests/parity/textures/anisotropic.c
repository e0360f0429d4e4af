/* Anisotropic lookups by the library, on every back end, whose bits must be equal; and by the
 * reference, which filters in a way of its own while the library takes the extension's samples.
 * They are compared by the mean of their differences, which must be well below that of lookups
 * without anisotropy. In 3D neither is anisotropic, and their bits must be equal. */
#include "lookups.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TARGETS 5

/* The largest mean difference of a channel, as a share of that of lookups without anisotropy. */
static const double largest_share[TARGETS] = {[GN_TEXTURE_2D] = 0.6,
                                              [GN_TEXTURE_2D_ARRAY] = 0.6,
                                              [GN_TEXTURE_3D] = 0.0,
                                              [GN_TEXTURE_CUBE] = 0.9};

/* Cases of a target; a mean of fewer is not meaningful. */
#define LEAST_CASES 64

/* Steps through all cases (main.c). */
#define STRIDE UINT64_C(7919)

typedef struct differences {
    double sum, isotropic, largest;
    uint64_t count, lookups;
} differences;

/* A quad's places over a footprint 1 to 16 texels long and up to 24 times as long as wide, with the
 * longer side along x or y, in any direction. */
static void spread_quad(lookup_case *c, random_source *r, uint32_t x, uint32_t y)
{
    const gn_texture *const t = &c->texture;
    const float size[3] = {(float)t->width, (float)t->height, (float)t->depth};
    const bool is_cube = t->target == GN_TEXTURE_CUBE, is_array = t->target == GN_TEXTURE_2D_ARRAY;
    const int count = is_cube || t->target == GN_TEXTURE_3D ? 3 : 2;
    const float longer = random_octave(r, 0, 3), shorter = longer / random_float(r, 1.0f, 24.0f);
    const bool is_x = random_chance(r, 50);
    const uint32_t layer = random_below(r, t->depth);
    float at[3], dx[3], dy[3], square_x = 0.0f, square_y = 0.0f;

    for (int n = 0; n < 3; ++n) {
        at[n] = is_cube ? random_float(r, -1.0f, 1.0f) : random_float(r, -1.0f, 2.0f);
        dx[n] = n < count ? random_float(r, -1.0f, 1.0f) : 0.0f;
        dy[n] = n < count ? random_float(r, -1.0f, 1.0f) : 0.0f;
        square_x += dx[n] * dx[n];
        square_y += dy[n] * dy[n];
    }
    for (int n = 0; n < count; ++n) {
        const float texel = is_cube ? 2.0f / size[0] : 1.0f / size[n];

        dx[n] *= texel * (is_x ? longer : shorter) / sqrtf(square_x);
        dy[n] *= texel * (is_x ? shorter : longer) / sqrtf(square_y);
    }
    if (is_array)
        at[2] = (float)layer;
    for (uint32_t l = 0; l < 4; ++l) {
        const uint32_t p = (y + l / 2) * GRID_WIDTH + x + l % 2;

        for (int n = 0; n < 3; ++n) {
            c->places.place[p][n] = at[n] + dx[n] * (float)(l % 2) + dy[n] * (float)(l / 2);
            c->places.gradient_x[p][n] = dx[n];
            c->places.gradient_y[p][n] = dy[n];
        }
        c->places.place[p][3] = 0.0f;
    }
}

/* Levels are generated from the first, as textures usually have them. With independent levels
 * nothing could be compared where one filter takes another level than the other. */
static bool make_levels(lookup_case *c)
{
    const size_t size =
        gn_texture_memory_size(c->target, c->format, c->texture.width, c->texture.height,
                               c->texture.depth, c->texture.level_count);
    void *const memory = malloc(size);
    gn_texture made = c->texture;
    const bool done = memory && gn_texture_generate_levels(&made, memory, size) == GN_OK &&
                      made.level_count == c->texture.level_count;

    for (uint32_t n = 1; done && n < made.level_count; ++n) {
        uint32_t extent[3];

        case_level_size(c, c->base + n, extent);
        memcpy(c->packed[n], made.level[n].texels,
               (size_t)extent[0] * extent[1] * extent[2] * gn_format_size(c->format));
        c->texture.level[n] = made.level[n];
        c->texture.level[n].texels = c->packed[n];
    }
    free(memory);
    return done;
}

/* Whether the reference's anisotropic filter can be compared with the library's. For floats the
 * reference does not keep differences within 0 to 1. It compares depths after filtering them. It
 * stops with a fault of its own for textures of one dimension, and if the filter has no levels but
 * the shader passes a bias or gradients. */
static bool is_comparable(const lookup_case *c)
{
    const bool has_levels =
        c->sampler.minify != GN_MINIFY_NEAREST && c->sampler.minify != GN_MINIFY_LINEAR;
    const bool is_color = scene_is_color_format(c->format);
    const bool is_float = scene_is_float_format(c->format);
    const bool is_asked = c->kind == LOOKUP_IMPLICIT ||
                          (has_levels && (c->kind == LOOKUP_BIAS || c->kind == LOOKUP_GRADIENTS));

    return c->target != GN_TEXTURE_1D && is_asked && is_color && !is_float && !c->is_wild &&
           c->texture.width >= 8 && c->texture.height >= 2;
}

static void add(differences *d, const float (*ours)[4], const float (*theirs)[4],
                const float (*isotropic)[4])
{
    for (int p = 0; p < GRID_PIXELS; ++p) {
        for (int n = 0; n < 4; ++n) {
            const double e = fabs((double)ours[p][n] - (double)theirs[p][n]);

            d->sum += e;
            d->isotropic += fabs((double)isotropic[p][n] - (double)theirs[p][n]);
            d->largest = e <= d->largest ? d->largest : e;
            ++d->count;
        }
    }
    ++d->lookups;
}

static bool compare_with_reference(lookup_case *c, random_source *r, differences *d)
{
    static float ours[GRID_PIXELS][4], theirs[GRID_PIXELS][4], isotropic[GRID_PIXELS][4];
    const uint32_t most = c->sampler.max_anisotropy;
    char error[1024] = "";

    c->sampler.lod_bias = 0.0f;
    c->sampler.lod_clamped = false;
    for (uint32_t y = 0; y < GRID_HEIGHT; y += 2)
        for (uint32_t x = 0; x < GRID_WIDTH; x += 2)
            spread_quad(c, r, x, y);
    library_look_up_directly(c, ours);
    if (!opengl_look_up(c, theirs, error, sizeof error)) {
        fprintf(stderr, "anisotropic: %s\n", error);
        return false;
    }
    c->sampler.max_anisotropy = 0;
    library_look_up_directly(c, isotropic);
    c->sampler.max_anisotropy = most;
    add(d, (const float(*)[4])ours, (const float(*)[4])theirs, (const float(*)[4])isotropic);
    return true;
}

/* Counts texels that differ between a back end and gn_sample; -1 if a lookup failed. */
static int64_t count_unequal(const lookup_case *c)
{
    static float ours[GRID_PIXELS][4], others[GRID_PIXELS][4];
    char error[1024] = "";
    int64_t unequal = 0;

    library_look_up_directly(c, ours);
    for (int b = GN_BACKEND_AUTO + 1; b < GN_BACKEND_COUNT; ++b) {
        if (!gn_backend_available((gn_backend)b))
            continue;
        if (!library_look_up(c, (gn_backend)b, others, error, sizeof error)) {
            fprintf(stderr, "anisotropic: %s\n", error);
            return -1;
        }
        for (int p = 0; p < GRID_PIXELS; ++p) {
            for (int n = 0; n < 4; ++n) {
                const float x = ours[p][n], y = others[p][n];

                unequal += memcmp(&x, &y, sizeof x) != 0 && (x == x || y == y);
            }
        }
    }
    return unequal;
}

static void print_target(int target, const differences *d, lookup_totals *t)
{
    static const char *const names[TARGETS] = {"2D", "1D", "2D array", "3D", "cube"};
    const bool good = d->lookups > 0 && d->sum <= largest_share[target] * d->isotropic;

    if (d->lookups > 0)
        printf("anisotropic %-9s %4" PRIu64 " cases: mean difference %.4f, largest %.3f; "
               "of isotropic lookups %.4f\n",
               names[target], d->lookups, d->sum / (double)d->count, d->largest,
               d->isotropic / (double)d->count);
    t->passed += good;
    t->failed += !good;
}

/* Null if there is not enough memory. */
static lookup_case *make_case(uint64_t number, uint64_t seed, random_source *r)
{
    lookup_case *const c = malloc(sizeof *c);

    *r = random_seed(seed * UINT64_C(1000003) + number);
    if (!c || !case_make(c, number % case_count(), seed + 1)) {
        fprintf(stderr, "anisotropic: out of memory\n");
        free(c);
        return NULL;
    }
    c->sampler.max_anisotropy = 2 + random_below(r, GN_MAX_ANISOTROPY - 1);
    return c;
}

static bool compare_back_ends(uint64_t seed, uint64_t cases, lookup_totals *t)
{
    uint64_t differ = 0;

    for (uint64_t i = 0; i < cases; ++i) {
        random_source r;
        lookup_case *const c = make_case(i * STRIDE, seed, &r);
        const int64_t count = c ? count_unequal(c) : -1;

        if (c)
            case_free(c);
        free(c);
        if (count < 0)
            return false;
        if (count > 0)
            fprintf(stderr, "anisotropic: case %" PRIu64 ": %" PRId64 " channels differ\n", i,
                    count);
        differ += count > 0;
    }
    printf("anisotropic: %" PRIu64 " cases on every back end, %" PRIu64 " differ\n", cases, differ);
    t->passed += cases - differ;
    t->failed += differ;
    return true;
}

/* Runs as many cases of a target as can be compared. */
static bool compare_target(uint64_t seed, uint64_t cases, int target, lookup_totals *t)
{
    differences d = {0.0, 0.0, 0.0, 0, 0};
    bool done = true;

    for (uint64_t i = 0; done && d.lookups < cases; ++i) {
        random_source r;
        lookup_case *const c = make_case((i * STRIDE) * TARGETS + (uint64_t)target, seed, &r);

        done = c && (!is_comparable(c) || !make_levels(c) || compare_with_reference(c, &r, &d));
        if (c)
            case_free(c);
        free(c);
    }
    print_target(target, &d, t);
    return done;
}

bool anisotropic_run(uint64_t seed, uint64_t cases, lookup_totals *t)
{
    bool done = compare_back_ends(seed, cases, t);

    for (int target = 0; done && target < TARGETS; ++target)
        done = target == GN_TEXTURE_1D || compare_target(seed, LEAST_CASES + cases / 8, target, t);
    return done;
}
