/* make texture-accuracy: differences of gn_texture_lookup from the exact sampler (reference/exact),
 * by target and filter, as a table in Markdown. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../command_line.h"
#include "random.h"
#include "sampler.h"
#include "scene.h"

#define DEFAULT_SEED 1
#define DEFAULT_LOOKUPS 20000

/* Lookups are left out if they are this near to where a discontinuous choice changes: more than the
 * error of coordinates, up to a few times the texture's length, when they are multiplied by the
 * size. */
#define LEAST_DOUBT 1e-4L

/* Of the places behind a number, at most this part may be left out. Measured: less than a 100th. */
#define MOST_LEFT_OUT 20

static const char help[] =
    "usage: texture-accuracy [--seed S] [--lookups N]\n"
    "\n"
    "Prints how far gn_texture_lookup is from lookups in long double as OpenGL 4.5 specifies it.\n"
    "Texels are random bytes, so that neighbours and levels differ as much as they can. Sizes are\n"
    "odd and even, coordinates from -1 to 2, with all wraps. A difference is that of a channel,\n"
    "whose range is 0 to 1. Anisotropic lookups have gradients for each place where other lookups\n"
    "have an implicit level.\n"
    "\n"
    "  --seed S       seed of textures and lookups (1)\n"
    "  --lookups N    lookups of 16 places each behind every number printed (20000)\n"
    "\n"
    "Exit status: 0: no difference is above its bound, 1: one is, 2: wrong command line.\n";

typedef struct filter {
    const char *name;
    gn_magnify magnify;
    gn_minify minify;
} filter;

static const filter filters[] = {
    {"nearest", GN_MAGNIFY_NEAREST, GN_MINIFY_NEAREST},
    {"linear", GN_MAGNIFY_LINEAR, GN_MINIFY_LINEAR},
    {"nearest, nearest level", GN_MAGNIFY_NEAREST, GN_MINIFY_NEAREST_MIPMAP_NEAREST},
    {"linear, nearest level", GN_MAGNIFY_LINEAR, GN_MINIFY_LINEAR_MIPMAP_NEAREST},
    {"nearest, between levels", GN_MAGNIFY_NEAREST, GN_MINIFY_NEAREST_MIPMAP_LINEAR},
    {"linear, between levels", GN_MAGNIFY_LINEAR, GN_MINIFY_LINEAR_MIPMAP_LINEAR},
};

enum { FILTERS = sizeof filters / sizeof *filters };

/* A number of the table. */
typedef struct errors {
    long double largest, sum;
    uint64_t count, left_out;
} errors;

typedef struct subject {
    gn_texture texture;
    gn_sampler sampler;
    void *texels;
} subject;

static subject random_subject(random_source *r, gn_texture_target target, gn_format format,
                              const filter *f)
{
    const uint32_t most = target == GN_TEXTURE_3D ? 20 : 64;
    subject s;

    memset(&s, 0, sizeof s);
    s.texture.target = target;
    s.texture.format = format;
    s.texture.width = 1 + random_below(r, most);
    s.texture.height = target == GN_TEXTURE_1D     ? 1
                       : target == GN_TEXTURE_CUBE ? s.texture.width
                                                   : 1 + random_below(r, most);
    s.texture.depth = 1 + random_below(r, most);
    for (uint32_t n = most; n > 0; n /= 2) {
        const scene_extent e = scene_level_extent(&s.texture, s.texture.level_count);
        const bool is_last =
            e.width == 1 && e.height == 1 && (target != GN_TEXTURE_3D || e.layers == 1);

        ++s.texture.level_count;
        if (is_last)
            break;
    }
    s.sampler.magnify = f->magnify;
    s.sampler.minify = f->minify;
    s.sampler.wrap_s = (gn_wrap)random_below(r, 5);
    s.sampler.wrap_t = (gn_wrap)random_below(r, 5);
    s.sampler.wrap_r = (gn_wrap)random_below(r, 5);
    for (int c = 0; c < 4; ++c)
        s.sampler.border[c] = random_unit(r);

    const size_t count = scene_texture_elements(&s.texture), size = scene_element_size(format);
    const uint32_t mask = format == GN_FORMAT_D24 ? 0xFFFFFF : UINT32_MAX;

    s.texels = malloc(count * size);
    if (!s.texels) {
        fprintf(stderr, "texture-accuracy: out of memory\n");
        exit(EXIT_FAILURE);
    }
    for (size_t i = 0; i < count; ++i)
        scene_set_element(s.texels, size, i, (uint32_t)(random_bits(r) >> 32) & mask);
    scene_pack_texture(&s.texture, s.texels);
    return s;
}

/* Coordinates of a block: a plane over its fragments, as in a triangle. */
static void random_block(random_source *r, const gn_texture *t, float coordinate[3][GN_LANES])
{
    const float size[3] = {(float)t->width, (float)t->height, (float)t->depth};
    const int32_t octave = random_between(r, -3, 5);
    const bool is_cube = t->target == GN_TEXTURE_CUBE;

    for (int c = 0; c < 3; ++c) {
        const bool is_layer = t->target == GN_TEXTURE_2D_ARRAY && c == 2;
        const float from = is_layer  ? random_float(r, 0.0f, size[2])
                           : is_cube ? random_float(r, -1.0f, 1.0f)
                                     : random_float(r, -1.0f, 1.9f);
        const float along_x = random_signed_octave(r, octave, octave);
        const float along_y = random_signed_octave(r, octave, octave);
        const float scale = is_layer ? 0.0f : is_cube ? 1.0f / size[0] : 1.0f / size[c];

        for (int l = 0; l < GN_LANES; ++l)
            coordinate[c][l] = from + (along_x * (float)(l % 4) + along_y * (float)(l / 4)) * scale;
    }
}

/* The level of detail of each quad from the coordinates of its lower left lane, as gn_lookup
 * specifies. For cubes the differences of directions are the quad's, but each place derives them on
 * its own face. */
static long double quad_lod(const gn_texture *t, float coordinate[3][GN_LANES], int lane)
{
    const int first = lane / 8 * 8 + lane % 4 / 2 * 2;
    long double at[3], dx[3], dy[3];

    for (int c = 0; c < 3; ++c) {
        const long double from = (long double)coordinate[c][first];

        at[c] = (long double)coordinate[c][t->target == GN_TEXTURE_CUBE ? lane : first];
        dx[c] = (long double)coordinate[c][first + 1] - from;
        dy[c] = (long double)coordinate[c][first + 4] - from;
    }
    return exact_lod(t, at, dx, dy);
}

/* Adds the differences of a lane, unless another choice would be as right. */
static void add_lane(errors *e, float texel[4][GN_LANES], int lane, const exact_texel *expected)
{
    e->left_out += expected->doubt < LEAST_DOUBT;
    for (int c = 0; c < 4 && expected->doubt >= LEAST_DOUBT; ++c) {
        const long double d = fabsl((long double)texel[c][lane] - expected->channel[c]);

        e->largest = d <= e->largest ? e->largest : d;
        e->sum += d;
        ++e->count;
    }
}

/* Gradients for every lane, one up to 20 times as long as the other. */
static void random_gradients(random_source *r, const gn_texture *t, float gradient[2][3][GN_LANES])
{
    const float size[3] = {(float)t->width, (float)t->height, (float)t->depth};
    const bool is_cube = t->target == GN_TEXTURE_CUBE;

    for (int l = 0; l < GN_LANES; ++l) {
        const float length = random_octave(r, -2, 4);
        const uint32_t longer = random_below(r, 2);
        const float ratio = random_float(r, 1.0f, 20.0f);

        for (uint32_t g = 0; g < 2; ++g) {
            for (int c = 0; c < 3; ++c) {
                gradient[g][c][l] = random_float(r, -1.0f, 1.0f) * length /
                                    (size[is_cube ? 0 : c] * (g == longer ? 1.0f : ratio));
            }
        }
    }
}

static void measure_anisotropic_block(random_source *r, const subject *s, errors *e)
{
    float coordinate[3][GN_LANES], reference[GN_LANES], texel[4][GN_LANES];
    float gradient[2][3][GN_LANES];
    gn_lookup lookup = {.reference = reference, .lod_source = GN_LOD_GRADIENTS};

    random_block(r, &s->texture, coordinate);
    random_gradients(r, &s->texture, gradient);
    for (int c = 0; c < 3; ++c) {
        lookup.coordinate[c] = coordinate[c];
        lookup.gradient_x[c] = gradient[0][c];
        lookup.gradient_y[c] = gradient[1][c];
    }
    for (int l = 0; l < GN_LANES; ++l)
        reference[l] = random_unit(r);
    gn_texture_lookup(&s->texture, &s->sampler, &lookup, texel);
    for (int l = 0; l < GN_LANES; ++l) {
        exact_lookup exact = {.reference = (long double)reference[l]};
        long double dx[3], dy[3];

        for (int c = 0; c < 3; ++c) {
            exact.coordinate[c] = (long double)coordinate[c][l];
            dx[c] = (long double)gradient[0][c][l];
            dy[c] = (long double)gradient[1][c][l];
        }

        const exact_texel expected =
            exact_sample_anisotropic(&s->texture, &s->sampler, &exact, dx, dy);

        add_lane(e, texel, l, &expected);
    }
}

static void measure_block(random_source *r, const subject *s, bool is_implicit, errors *e)
{
    float coordinate[3][GN_LANES], lod[GN_LANES], reference[GN_LANES], texel[4][GN_LANES];
    gn_lookup lookup = {.coordinate = {coordinate[0], coordinate[1], coordinate[2]},
                        .reference = reference,
                        .lod_source = is_implicit ? GN_LOD_IMPLICIT : GN_LOD_EXPLICIT,
                        .lod = is_implicit ? NULL : lod};

    random_block(r, &s->texture, coordinate);
    for (int l = 0; l < GN_LANES; ++l) {
        lod[l] = random_float(r, -1.0f, 1.0f + (float)s->texture.level_count);
        reference[l] = random_unit(r);
    }
    gn_texture_lookup(&s->texture, &s->sampler, &lookup, texel);
    for (int l = 0; l < GN_LANES; ++l) {
        exact_lookup exact = {.reference = (long double)reference[l]};

        for (int c = 0; c < 3; ++c)
            exact.coordinate[c] = (long double)coordinate[c][l];
        exact.lod = is_implicit ? quad_lod(&s->texture, coordinate, l) : (long double)lod[l];

        const exact_texel expected = exact_sample(&s->texture, &s->sampler, &exact);

        add_lane(e, texel, l, &expected);
    }
}

static errors measure(uint64_t seed, uint64_t lookups, gn_texture_target target, gn_format format,
                      gn_compare compare, uint32_t max_anisotropy, const filter *f,
                      bool is_implicit)
{
    random_source r = random_seed(seed);
    errors e = {0.0L, 0.0L, 0, 0};

    for (uint64_t done = 0; done < lookups;) {
        subject s = random_subject(&r, target, format, f);

        s.sampler.compare = compare;
        s.sampler.max_anisotropy = max_anisotropy ? 1 + random_below(&r, max_anisotropy) : 0;
        if (target == GN_TEXTURE_3D)
            s.sampler.max_anisotropy = 1; /* lookups in 3D take one sample, whatever it is */
        for (int i = 0; i < 20 && done < lookups; ++i, ++done)
            if (max_anisotropy && is_implicit)
                measure_anisotropic_block(&r, &s, &e);
            else
                measure_block(&r, &s, is_implicit, &e);
        free(s.texels);
    }
    return e;
}

/* The reference's rules explain the differences: weights are of coordinates rounded to 24 bits, of
 * up to 128 texels; sRGB is decoded by a polynomial; and an implicit level of detail is half of a
 * logarithm that is linear between powers of two, up to 0.0861 below the true one: so much of the
 * difference of two levels. Means of up to 16 samples are rounded as often. */
static long double bound(gn_format format, uint32_t max_anisotropy, const filter *f,
                         bool is_implicit)
{
    const bool between =
        f->minify == GN_MINIFY_NEAREST_MIPMAP_LINEAR || f->minify == GN_MINIFY_LINEAR_MIPMAP_LINEAR;
    const bool alone =
        f->minify == GN_MINIFY_NEAREST || f->minify == GN_MINIFY_NEAREST_MIPMAP_NEAREST;

    return format == GN_FORMAT_SRGB8_A8 ? 1.5e-3L
           : is_implicit && between     ? 0.0435L
           : alone                      ? max_anisotropy ? 1e-6L : 1e-7L
                                        : 2e-5L;
}

typedef struct table {
    uint64_t seed, lookups;
    uint64_t passed, failed, count, left_out;
} table;

static void print_cell(table *t, const errors *e, long double most)
{
    const uint64_t places = e->count / 4 + e->left_out;
    const bool good = e->largest <= most && e->count > 0 && e->left_out <= places / MOST_LEFT_OUT;

    printf(" %.1Le | %.1Le |", e->count ? e->sum / (long double)e->count : 0.0L, e->largest);
    t->passed += good;
    t->failed += !good;
    t->count += places;
    t->left_out += e->left_out;
}

static void print_row(table *t, const char *name, gn_texture_target target, gn_format format,
                      gn_compare compare, uint32_t max_anisotropy, const filter *f)
{
    printf("| %s, %s%s |", name, max_anisotropy ? "anisotropic " : "", f->name);
    for (int implicit = 0; implicit < 2; ++implicit) {
        const errors e =
            measure(t->seed, t->lookups, target, format, compare, max_anisotropy, f, implicit);

        print_cell(t, &e, bound(format, max_anisotropy, f, implicit));
    }
    printf("\n");
    fflush(stdout);
}

int main(int argc, char **argv)
{
    static const char *const names[] = {"2D", "1D", "2D array", "3D", "cube"};
    table t = {DEFAULT_SEED, DEFAULT_LOOKUPS, 0, 0, 0, 0};

    const command_option known[] = {
        {"--seed", .number = &t.seed}, {"--lookups", .number = &t.lookups, .least = 1}, {NULL}};

    if (command_line_asks_help(argc, argv)) {
        fputs(help, stdout);
        return EXIT_SUCCESS;
    }
    if (!command_line_read("texture-accuracy", argc, argv, known, NULL))
        return 2;
    printf("texture-accuracy: seed %" PRIu64 "\n\n", t.seed);
    printf("| target, filter | explicit level: mean | largest | implicit: mean | largest |\n"
           "|---|---|---|---|---|\n");
    for (int target = 0; target < 5; ++target) {
        for (int f = 0; f < FILTERS; ++f) {
            print_row(&t, names[target], (gn_texture_target)target, GN_FORMAT_RGBA8,
                      GN_COMPARE_DEFAULT, 0, &filters[f]);
        }
    }
    print_row(&t, "2D of sRGB", GN_TEXTURE_2D, GN_FORMAT_SRGB8_A8, GN_COMPARE_DEFAULT, 0,
              &filters[1]);
    print_row(&t, "2D of 16 bits", GN_TEXTURE_2D, GN_FORMAT_RGBA16, GN_COMPARE_DEFAULT, 0,
              &filters[1]);
    print_row(&t, "2D of D24, compared", GN_TEXTURE_2D, GN_FORMAT_D24, GN_LESS_OR_EQUAL, 0,
              &filters[1]);
    print_row(&t, "cube of D24, compared", GN_TEXTURE_CUBE, GN_FORMAT_D24, GN_LESS_OR_EQUAL, 0,
              &filters[1]);
    for (int target = 0; target < 5; ++target) {
        for (int f = 1; f < FILTERS && target != GN_TEXTURE_1D; f += 2) { /* the linear ones */
            print_row(&t, names[target], (gn_texture_target)target, GN_FORMAT_RGBA8,
                      GN_COMPARE_DEFAULT, GN_MAX_ANISOTROPY, &filters[f]);
        }
    }
    print_row(&t, names[0], GN_TEXTURE_2D, GN_FORMAT_RGBA8, GN_COMPARE_DEFAULT, GN_MAX_ANISOTROPY,
              &filters[0]);
    print_row(&t, "2D of D24, compared", GN_TEXTURE_2D, GN_FORMAT_D24, GN_LESS_OR_EQUAL,
              GN_MAX_ANISOTROPY, &filters[1]);
    printf("\n%" PRIu64 " places, %" PRIu64
           " of them left out: nearer than %.0Le to where a texel, level or comparison changes\n",
           t.count, t.left_out, LEAST_DOUBT);
    printf("%" PRIu64 " passed, %" PRIu64 " failed\n", t.passed, t.failed);
    return t.failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
