/* Anisotropic lookups by the library, on every back end, whose bits must be equal; and by the
 * reference, which takes other samples than the library, those of the extension
 * (reference/RULES.md, Anisotropic filtering). They are compared by the mean of their differences,
 * as a share of that of lookups without anisotropy:
 * - over any footprint;
 * - over footprints for which both can be made to take the same samples, where hardly a difference
 *   may be left.
 * In 1D and 3D neither is anisotropic, and their bits must be equal. */
#include "lookups.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TARGETS 5

enum { ANY_FOOTPRINT, SAME_SAMPLES, CHOICES };

/* The largest mean difference of a channel, as a share of that of lookups without anisotropy.
 * Measured: 0.40 to 0.46 in 2D and arrays, 0.59 to 0.80 in cubes; of the same samples at most 0.03.
 * Without its anisotropy the library has a share of 1. */
static const double largest_share[CHOICES][TARGETS] = {
    {[GN_TEXTURE_2D] = 0.6, [GN_TEXTURE_2D_ARRAY] = 0.6, [GN_TEXTURE_CUBE] = 0.9},
    {[GN_TEXTURE_2D] = 0.05, [GN_TEXTURE_2D_ARRAY] = 0.05, [GN_TEXTURE_CUBE] = 0.05}};

/* Cases of a target; a mean of fewer is not meaningful. About one in ten can be compared. */
#define LEAST_CASES 64
#define MOST_TRIES 100

/* Steps through all cases (main.c). */
#define STRIDE UINT64_C(7919)

typedef struct differences {
    double sum, isotropic, largest;
    uint64_t count, lookups;
} differences;

/* The gradients of a footprint, in texels of the first level. */
typedef struct footprint {
    float x[3], y[3];
} footprint;

/* Places of a quad from `at` on, as far apart as the gradients say. */
static void place_quad(lookup_case *c, uint32_t x, uint32_t y, const float at[3],
                       const footprint *f)
{
    const gn_texture *const t = &c->texture;
    const float size[3] = {(float)t->width, (float)t->height, (float)t->depth};

    for (uint32_t l = 0; l < 4; ++l) {
        const uint32_t p = (y + l / 2) * GRID_WIDTH + x + l % 2;

        for (int n = 0; n < 3; ++n) {
            const float texel = t->target == GN_TEXTURE_CUBE ? 2.0f / size[0] : 1.0f / size[n];
            const float dx = texel * f->x[n], dy = texel * f->y[n];

            c->places.place[p][n] = at[n] + dx * (float)(l % 2) + dy * (float)(l / 2);
            c->places.gradient_x[p][n] = dx;
            c->places.gradient_y[p][n] = dy;
        }
        c->places.place[p][3] = 0.0f;
    }
}

/* A quad's places over a footprint 1 to 16 texels long and up to 24 times as long as wide, with the
 * longer side along x or y, in any direction. */
static void spread_quad(lookup_case *c, random_source *r, uint32_t x, uint32_t y)
{
    const bool is_cube = c->target == GN_TEXTURE_CUBE, is_array = c->target == GN_TEXTURE_2D_ARRAY;
    const int count = is_cube || c->target == GN_TEXTURE_3D ? 3
                      : c->target == GN_TEXTURE_1D          ? 1
                                                            : 2;
    const float longer = random_octave(r, 0, 3), shorter = longer / random_float(r, 1.0f, 24.0f);
    const bool is_x = random_chance(r, 50);
    const uint32_t layer = random_below(r, c->texture.depth);
    float at[3], square_x = 0.0f, square_y = 0.0f;
    footprint f;

    for (int n = 0; n < 3; ++n) {
        at[n] = is_cube ? random_float(r, -1.0f, 1.0f) : random_float(r, -1.0f, 2.0f);
        f.x[n] = n < count ? random_float(r, -1.0f, 1.0f) : 0.0f;
        f.y[n] = n < count ? random_float(r, -1.0f, 1.0f) : 0.0f;
        square_x += f.x[n] * f.x[n];
        square_y += f.y[n] * f.y[n];
    }
    for (int n = 0; n < count; ++n) {
        f.x[n] *= (is_x ? longer : shorter) / sqrtf(square_x);
        f.y[n] *= (is_x ? shorter : longer) / sqrtf(square_y);
    }
    if (is_array)
        at[2] = (float)layer;
    place_quad(c, x, y, at, &f);
}

/* Directions of a footprint's longer and shorter side. They are arbitrary where the texture is
 * square. Elsewhere the reference takes the samples that it takes in square textures only if x is
 * along s and y along t. */
static void choose_directions(const lookup_case *c, random_source *r, bool is_x, float along[2],
                              float across[2])
{
    const float angle = random_float(r, 0.0f, 6.2831853f), sign = random_sign(r);
    const bool is_square = c->texture.width == c->texture.height;

    along[0] = is_square ? cosf(angle) : is_x ? sign : 0.0f;
    along[1] = is_square ? sinf(angle) : is_x ? 0.0f : sign;
    across[0] = -along[1];
    across[1] = along[0];
}

/* A quad's places over a footprint for which both take `count` samples in the same level: its width
 * is a texel of a level, and its length is count times its width. Both are off by a little, to the
 * side where rounding changes nothing. On a cube all lies in one face, over whose edges the
 * reference does not look. */
static void spread_countable_quad(lookup_case *c, random_source *r, uint32_t x, uint32_t y,
                                  uint32_t count)
{
    const bool is_cube = c->target == GN_TEXTURE_CUBE, is_x = random_chance(r, 50);
    const uint32_t normal = is_cube ? random_below(r, 3) : 2;
    const uint32_t s = (normal + 1) % 3, t = (normal + 2) % 3;
    const uint32_t layer = random_below(r, c->texture.depth);
    float wide = ldexpf(1.03f, (int)random_below(r, c->texture.level_count)), room = 1.0f;
    float at[3], along[2], across[2];
    footprint f = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}};

    do {
        const float reach = (1.5f * (float)count + 2.0f) * wide;

        room = 1.0f - 2.0f * reach / (float)c->texture.width;
    } while (is_cube && room < 0.1f && (wide *= 0.5f) > 1.0f);
    choose_directions(c, r, is_x, along, across);
    for (uint32_t n = 0; n < 3; ++n)
        at[n] = is_cube ? random_float(r, -room, room) : random_float(r, -1.0f, 2.0f);
    if (is_cube)
        at[normal] = random_sign(r);
    else if (c->target == GN_TEXTURE_2D_ARRAY)
        at[normal] = (float)layer;
    for (int n = 0; n < 2; ++n) {
        const float longer = 0.99f * (float)count * wide * along[n], shorter = wide * across[n];

        f.x[n == 0 ? s : t] = is_x ? longer : shorter;
        f.y[n == 0 ? s : t] = is_x ? shorter : longer;
    }
    place_quad(c, x, y, at, &f);
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
 * reference does not keep differences within 0 to 1. It compares depths after filtering them. */
static bool is_comparable(const lookup_case *c)
{
    const bool is_asked =
        c->kind == LOOKUP_IMPLICIT || c->kind == LOOKUP_BIAS || c->kind == LOOKUP_GRADIENTS;

    return is_asked && scene_is_color_format(c->format) && !scene_is_float_format(c->format) &&
           !c->is_wild && c->texture.width >= 8 &&
           (c->texture.height >= 2 || c->target == GN_TEXTURE_1D);
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

/* Looks up with anisotropy on both sides and without it here. `ours` has what differs for the
 * library's lookups: null if nothing does. */
static bool compare_with_reference(lookup_case *c, const lookup_case *ours, differences *d)
{
    static float here[GRID_PIXELS][4], theirs[GRID_PIXELS][4], isotropic[GRID_PIXELS][4];
    const uint32_t most = c->sampler.max_anisotropy;
    char error[1024] = "";

    library_lookup_directly(ours ? ours : c, here);
    if (!opengl_lookup(c, theirs, error, sizeof error)) {
        fprintf(stderr, "anisotropic: %s\n", error);
        return false;
    }
    c->sampler.max_anisotropy = 0;
    library_lookup_directly(c, isotropic);
    c->sampler.max_anisotropy = most;
    add(d, (const float(*)[4])here, (const float(*)[4])theirs, (const float(*)[4])isotropic);
    return true;
}

static bool compare_any(lookup_case *c, random_source *r, differences *d)
{
    c->sampler.lod_bias = 0.0f;
    c->sampler.lod_clamp_enabled = false;
    for (uint32_t y = 0; y < GRID_HEIGHT; y += 2)
        for (uint32_t x = 0; x < GRID_WIDTH; x += 2)
            spread_quad(c, r, x, y);
    return compare_with_reference(c, NULL, d);
}

/* The reference's samples are a count-th of the longer side apart, the library's a (count + 1)-th.
 * They are the same if the library has a footprint (count + 1) / count times as large. This adds
 * 1 / count to its level of detail, because the logarithm is linear between powers of two; a bias
 * takes it away. Whatever the filter, the reference mixes texels of one level. */
static bool compare_same(lookup_case *c, random_source *r, differences *d)
{
    const uint32_t room = c->target == GN_TEXTURE_CUBE ? c->texture.width / 8 : GN_MAX_ANISOTROPY;
    const uint32_t most = room < GN_MAX_ANISOTROPY ? room : GN_MAX_ANISOTROPY;
    lookup_case *ours;
    bool done;

    if (most < 2)
        return true; /* a face without room for two samples */

    const uint32_t count = 2 + random_below(r, most - 1);
    const float larger = (float)(count + 1) / (float)count;

    ours = malloc(sizeof *ours);
    if (!ours)
        return false;
    c->kind = LOOKUP_IMPLICIT;
    c->sampler.minify = GN_MINIFY_LINEAR_MIPMAP_NEAREST;
    c->sampler.lod_bias = 0.0f;
    c->sampler.lod_clamp_enabled = false;
    c->sampler.max_anisotropy = GN_MAX_ANISOTROPY;
    for (uint32_t y = 0; y < GRID_HEIGHT; y += 2)
        for (uint32_t x = 0; x < GRID_WIDTH; x += 2)
            spread_countable_quad(c, r, x, y, count);
    *ours = *c;
    ours->kind = LOOKUP_GRADIENTS;
    ours->sampler.lod_bias = -1.0f / (float)count;
    for (int p = 0; p < GRID_PIXELS; ++p) {
        for (int n = 0; n < 3; ++n) {
            ours->places.gradient_x[p][n] *= larger;
            ours->places.gradient_y[p][n] *= larger;
        }
    }
    done = compare_with_reference(c, ours, d);
    free(ours);
    return done;
}

/* Counts texels that differ between a back end and gn_texture_lookup; -1 if a lookup failed. */
static int64_t count_unequal(const lookup_case *c)
{
    static float ours[GRID_PIXELS][4], others[GRID_PIXELS][4];
    char error[1024] = "";
    int64_t unequal = 0;

    library_lookup_directly(c, ours);
    for (int b = GN_BACKEND_AUTO + 1; b < GN_BACKEND_COUNT; ++b) {
        if (!gn_backend_available((gn_backend)b))
            continue;
        if (!library_lookup(c, (gn_backend)b, others, error, sizeof error)) {
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

static void print_target(int target, int choice, const differences *d, lookup_totals *t)
{
    static const char *const names[TARGETS] = {"2D", "1D", "2D array", "3D", "cube"};
    static const char *const choices[CHOICES] = {"", ", same samples"};
    const bool good =
        d->lookups >= LEAST_CASES / 2 && d->sum <= largest_share[choice][target] * d->isotropic;

    if (d->lookups > 0)
        printf("anisotropic %s%s: %" PRIu64 " cases, mean difference %.4f, largest %.3f; "
               "of isotropic lookups %.4f\n",
               names[target], choices[choice], d->lookups, d->sum / (double)d->count, d->largest,
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
    const bool is_filtered = target != GN_TEXTURE_1D && target != GN_TEXTURE_3D;
    differences d[CHOICES] = {{0.0, 0.0, 0.0, 0, 0}, {0.0, 0.0, 0.0, 0, 0}};
    bool done = true;

    for (uint64_t i = 0; done && d[ANY_FOOTPRINT].lookups < cases && i < MOST_TRIES * cases; ++i) {
        random_source r;
        lookup_case *const c = make_case((i * STRIDE) * TARGETS + (uint64_t)target, seed, &r);

        done = c && (!is_comparable(c) || !make_levels(c) ||
                     (compare_any(c, &r, &d[ANY_FOOTPRINT]) &&
                      (!is_filtered || compare_same(c, &r, &d[SAME_SAMPLES]))));
        if (c)
            case_free(c);
        free(c);
    }
    print_target(target, ANY_FOOTPRINT, &d[ANY_FOOTPRINT], t);
    if (is_filtered)
        print_target(target, SAME_SAMPLES, &d[SAME_SAMPLES], t);
    return done;
}

bool anisotropic_run(uint64_t seed, uint64_t cases, lookup_totals *t)
{
    bool done = compare_back_ends(seed, cases, t);

    for (int target = 0; done && target < TARGETS; ++target)
        done = compare_target(seed, LEAST_CASES + cases / 8, target, t);
    return done;
}
