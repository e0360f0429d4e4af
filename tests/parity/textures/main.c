/* Lookups in textures by the library, on every back end, and by the pinned reference. Every bit of
 * every texel must be equal, except for anisotropic lookups (anisotropic.c). */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../command_line.h"
#include "lookups.h"

#define REPORTED 5

/* Visits all cases in an order that spreads every property over the first few: steps of a number
 * that has no common factor with the number of cases. */
#define STRIDE UINT64_C(7919)

/* Cases for each case of anisotropic lookups. */
#define CASES_PER_ANISOTROPIC 4

typedef struct totals {
    uint64_t cases, failed, texels, differ;
    uint64_t by_kind[5][LOOKUP_KINDS][2]; /* cases, and those that differ */
} totals;

typedef struct settings {
    uint64_t seed, cases, one;
    bool has_one, is_verbose;
    int target, kind;
} settings;

static bool are_equal(float a, float b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (a != a && b != b);
}

static void report(const lookup_case *c, const char *who, const float (*ours)[4],
                   const float (*theirs)[4])
{
    char text[400];
    int reported = 0;

    case_describe(c, text, sizeof text);
    fprintf(stderr, "case %" PRIu64 " of seed %" PRIu64 ", %s: %s\n", c->number, c->seed, who,
            text);
    for (int p = 0; p < GRID_PIXELS && reported < REPORTED; ++p) {
        bool equal = true;

        for (int n = 0; n < 4; ++n)
            equal = equal && are_equal(ours[p][n], theirs[p][n]);
        if (equal)
            continue;
        ++reported;
        fprintf(stderr, "  (%d, %d) at %.9g %.9g %.9g, lod %.9g", p % GRID_WIDTH, p / GRID_WIDTH,
                (double)c->places.place[p][0], (double)c->places.place[p][1],
                (double)c->places.place[p][2], (double)c->places.place[p][3]);
        if (c->kind == LOOKUP_GRADIENTS)
            fprintf(stderr, ", dx %.9g %.9g %.9g, dy %.9g %.9g %.9g",
                    (double)c->places.gradient_x[p][0], (double)c->places.gradient_x[p][1],
                    (double)c->places.gradient_x[p][2], (double)c->places.gradient_y[p][0],
                    (double)c->places.gradient_y[p][1], (double)c->places.gradient_y[p][2]);
        fprintf(stderr, "\n    here");
        for (int n = 0; n < 4; ++n)
            fprintf(stderr, " %.9g", (double)ours[p][n]);
        fprintf(stderr, ", reference");
        for (int n = 0; n < 4; ++n)
            fprintf(stderr, " %.9g", (double)theirs[p][n]);
        fprintf(stderr, "\n");
    }
}

static uint64_t count_differing(const float (*ours)[4], const float (*theirs)[4])
{
    uint64_t differ = 0;

    for (int p = 0; p < GRID_PIXELS; ++p) {
        bool equal = true;

        for (int n = 0; n < 4; ++n)
            equal = equal && are_equal(ours[p][n], theirs[p][n]);
        differ += !equal;
    }
    return differ;
}

/* Runs one case on every back end; false if a lookup failed. */
static bool compare(const lookup_case *c, totals *t)
{
    static float ours[GRID_PIXELS][4], theirs[GRID_PIXELS][4];
    char error[1024] = "";
    uint64_t differ = 0;

    if (!opengl_lookup(c, theirs, error, sizeof error)) {
        fprintf(stderr, "case %" PRIu64 ": %s\n", c->number, error);
        return false;
    }
    for (int b = GN_BACKEND_AUTO; b < GN_BACKEND_COUNT; ++b) {
        const char *const who = b == GN_BACKEND_AUTO ? "called" : gn_backend_name((gn_backend)b);

        if (!gn_backend_available((gn_backend)b))
            continue;
        if (b == GN_BACKEND_AUTO) {
            library_lookup_directly(c, ours);
        } else if (!library_lookup(c, (gn_backend)b, ours, error, sizeof error)) {
            fprintf(stderr, "case %" PRIu64 ": %s\n", c->number, error);
            return false;
        }

        const uint64_t here = count_differing((const float(*)[4])ours, (const float(*)[4])theirs);
        if (here && !differ && t->failed < 20)
            report(c, who, (const float(*)[4])ours, (const float(*)[4])theirs);
        differ += here;
        t->texels += GRID_PIXELS;
    }
    ++t->cases;
    t->failed += differ > 0;
    t->differ += differ;
    ++t->by_kind[c->target][c->kind][0];
    t->by_kind[c->target][c->kind][1] += differ > 0;
    return true;
}

static bool run(const settings *s, totals *t)
{
    const uint64_t count = s->has_one ? 1 : s->cases, all = case_count();

    for (uint64_t i = 0; i < count; ++i) {
        const uint64_t number = s->has_one ? s->one : i * STRIDE % all + i / all * all;
        lookup_case *const c = malloc(sizeof *c);
        bool done;

        if (!c || !case_make(c, number, s->seed)) {
            fprintf(stderr, "out of memory\n");
            free(c);
            return false;
        }
        done = (s->target >= 0 && s->target != (int)c->target) ||
               (s->kind >= 0 && s->kind != (int)c->kind) || compare(c, t);
        case_free(c);
        free(c);
        if (!done)
            return false;
        if (i % 100 == 99)
            fprintf(stderr, "\r%" PRIu64 " of %" PRIu64 " cases, %" PRIu64 " differ", i + 1, count,
                    t->failed);
    }
    return true;
}

static void print_totals(const settings *s, const totals *t)
{
    static const char *const targets[] = {"2D", "1D", "2D array", "3D", "cube"};
    static const char *const kinds[] = {"texture", "bias", "lod", "gradients", "gather", "fetch"};

    for (int target = 0; target < 5; ++target) {
        for (int kind = 0; kind < LOOKUP_KINDS; ++kind) {
            if (t->by_kind[target][kind][0])
                printf("%-10s %-10s %6" PRIu64 " cases, %" PRIu64 " differ\n", targets[target],
                       kinds[kind], t->by_kind[target][kind][0], t->by_kind[target][kind][1]);
        }
    }
    printf("textures: seed %" PRIu64 ", %" PRIu64 " texels compared, %" PRIu64 " differ\n", s->seed,
           t->texels, t->differ);
}

static void usage(FILE *out)
{
    fprintf(out,
            "usage: textures [--seed N] [--cases N] [--quick] [--case NUMBER]\n"
            "                [--target 0..4] [--kind 0..5]\n"
            "Compares random lookups in textures by the library and by OSMesa.\n"
            "  --cases   number of cases, up to %" PRIu64 " (default: all)\n"
            "  --quick   300 cases\n"
            "  --case    only this case\n"
            "  --target  only 2D, 1D, 2D array, 3D or cube\n"
            "  --kind    only texture, texture with bias, textureLod, textureGrad,\n"
            "            textureGather or texelFetch\n",
            case_count());
}

static bool parse(int count, char **arguments, settings *s)
{
    s->seed = 1;
    s->cases = case_count();
    s->target = -1;
    s->kind = -1;
    for (int i = 1; i < count; ++i) {
        const char *const name = arguments[i];
        uint64_t number, most = UINT64_MAX;

        if (!strcmp(name, "--quick")) {
            s->cases = 300;
            continue;
        }
        if (!strcmp(name, "--target")) {
            most = 4;
        } else if (!strcmp(name, "--kind")) {
            most = LOOKUP_KINDS - 1;
        } else if (!strcmp(name, "--cases")) {
            most = case_count();
        } else if (!strcmp(name, "--case")) {
            most = case_count() - 1;
        } else if (strcmp(name, "--seed") != 0) {
            usage(stderr);
            return false;
        }
        if (!option_number("textures", name, arguments[++i], !strcmp(name, "--cases"), most,
                           &number))
            return false;
        if (!strcmp(name, "--seed")) {
            s->seed = number;
        } else if (!strcmp(name, "--cases")) {
            s->cases = number;
        } else if (!strcmp(name, "--target")) {
            s->target = (int)number;
        } else if (!strcmp(name, "--kind")) {
            s->kind = (int)number;
        } else {
            s->one = number;
            s->has_one = true;
        }
    }
    return true;
}

int main(int count, char **arguments)
{
    char error[256] = "";
    static totals t;
    lookup_totals anisotropic = {0, 0};
    settings s = {0};
    reference *osmesa;
    bool done;

    if (count > 1 && !strcmp(arguments[1], "--help")) {
        usage(stdout);
        return 0;
    }
    if (!parse(count, arguments, &s))
        return 2;
    osmesa = reference_create(REFERENCE_PINNED, error, sizeof error);
    if (!osmesa) {
        fprintf(stderr, "textures: %s\n", error);
        return 1;
    }
    done = run(&s, &t);
    fprintf(stderr, "\n");
    print_totals(&s, &t);
    if (done && s.target < 0 && s.kind < 0 && !s.has_one)
        done = anisotropic_run(s.seed, s.cases / CASES_PER_ANISOTROPIC, &anisotropic);
    t.failed += anisotropic.failed;
    printf("%" PRIu64 " passed, %" PRIu64 " failed\n",
           t.cases + anisotropic.passed + anisotropic.failed - t.failed, t.failed);
    reference_destroy(osmesa);
    return done && t.cases > 0 && t.failed == 0 ? 0 : 1;
}
