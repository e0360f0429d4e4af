/* Every function of tests/accuracy's tables against cglm's, for random, extreme and structured
 * inputs. The results may differ by the sum of both errors against the exact result,
 * |ours - theirs| <= u (own_bound * scale + other_bound * other_scale),
 * with the bounds derived beside the rows. Inputs for which cglm is wrong are left out there, with
 * the reason: frustum planes with a depth of zero to one, slerp near antipodes, inverses of
 * matrices with tiny scales, look-at with up parallel to the view.
 *
 * Each library is also tested against its bound of the exact result: Gnomon's, so that the table's
 * bound is true, and cglm's, so that the tolerance is no wider than necessary. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../../unit/unit.h"

#include "rows.h"

#define U 0x1p-24L
#define SLACK (1.0L + 0x1p-18L) /* covers the terms that first-order bounds leave out */

/* Inputs of each kind for each row; fewer where the sanitizer makes each one slow. */
#if defined(__SANITIZE_ADDRESS__)
enum { INPUTS = 4000 };
#else
enum { INPUTS = 20000 };
#endif

static uint64_t seed;

static const char *const kind_names[KINDS] = {"random", "extreme", "structured"};

static void fail_with(const struct row *row, enum kind kind, const char *what, const float *in,
                      int output, long double own, long double other, long double tolerance)
{
    fprintf(stderr, "%s, %s inputs, seed %" PRIu64 ": %s\narguments", row->name, kind_names[kind],
            seed, what);
    for (int i = 0; i < MOST_INPUTS; ++i)
        fprintf(stderr, " %a", (double)in[i]);
    fprintf(stderr, "\nnumber %d of the result: %La and %La, may differ by %La\n", output, own,
            other, tolerance);
    fail();
}

static void compare(const struct row *row, enum kind kind, const float *in, float *own,
                    float *other)
{
    struct exact exact;
    const bool has_other = row->other != NULL && !(row->other_bound < 0.0);
    evaluate(row, in, &exact);
    settle_sign(row, &exact, own);
    settle_sign(row, &exact, other);
    for (int i = 0; i < row->outputs; ++i) {
        const long double ours = (long double)own[i], theirs = (long double)other[i];
        const long double own_error = U * SLACK * row->own_bound * exact.scale[i];
        const long double other_error = U * SLACK * row->other_bound * exact.other_scale[i];
        if (!(fabsl(ours - exact.value[i]) <= own_error))
            fail_with(row, kind, "ours and exact", in, i, ours, exact.value[i], own_error);
        if (has_other && !(fabsl(theirs - exact.value[i]) <= other_error))
            fail_with(row, kind, "theirs and exact", in, i, theirs, exact.value[i], other_error);
        if (has_other && !(fabsl(ours - theirs) <= own_error + other_error))
            fail_with(row, kind, "ours and theirs", in, i, ours, theirs, own_error + other_error);
    }
}

static void rows_agree(void **state)
{
    const struct row *row = *state;
    uint64_t random = seed * 0x9E3779B97F4A7C15u + 1;
    for (enum kind kind = RANDOM; kind < KINDS; ++kind) {
        int compared = 0;
        for (int i = 0; i < INPUTS; ++i) {
            float in[MOST_INPUTS] = {0}, copy[MOST_INPUTS];
            float own[MOST_OUTPUTS] = {0}, other[MOST_OUTPUTS] = {0};
            make_inputs(row, kind, &random, in);
            if (!row->own(in, own))
                continue;
            memcpy(copy, in, sizeof copy);
            if (row->other)
                row->other(copy, other);
            compare(row, kind, in, own, other);
            ++compared;
        }
        assert_true(compared > INPUTS / 10);
    }
}

/* usage: test_cglm [SEED]; the seed is printed. */
int main(int argc, char **argv)
{
    static const struct table *const tables[] = ALL_TABLES;
    struct CMUnitTest tests[256];
    size_t count = 0;
    seed = argc > 1 ? strtoull(argv[1], NULL, 0) : (uint64_t)time(NULL);
    printf("differential: seed %" PRIu64 "\n", seed);
    for (size_t t = 0; t < sizeof tables / sizeof tables[0]; ++t) {
        for (size_t i = 0; i < tables[t]->count && count < 256; ++i) {
            const struct CMUnitTest test = {tables[t]->rows[i].name, rows_agree, NULL, NULL,
                                            (void *)(uintptr_t)&tables[t]->rows[i]};
            tests[count++] = test;
        }
    }
    return _cmocka_run_group_tests("cglm", tests, count, NULL, NULL);
}
