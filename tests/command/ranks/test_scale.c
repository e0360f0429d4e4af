/* Tests the simulator of ranks: it equals its formulas where these are exact, more ranks are never
 * more efficient than one, and no message becomes cheaper by being longer. Prints "N passed, N
 * failed". */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scale_engine.h"
#include "scale_fit.h"
#include "scale_ways.h"

static unsigned int passed, failed;

static void expect(bool good, const char *what, double a, double b)
{
    passed += good;
    failed += !good;
    if (!good)
        printf("FAILED: %s: %.12g, %.12g\n", what, a, b);
}

static bool is_near(double a, double b)
{
    return fabs(a - b) <= 1e-9 * (fabs(a) + fabs(b));
}

static figures some_figures(void)
{
    figures f;
    figures_state(&f);
    return f;
}

/* One message between two ranks. */

typedef struct one_message {
    double bytes;
    uint32_t senders; /* ranks 1 to senders send to rank 0 at the same time */
    uint32_t at[16];
} one_message;

static void next_of_message(void *context, uint32_t rank, const step_result *last, step *s)
{
    one_message *m = context;
    const uint32_t at = m->at[rank]++;
    (void)last;
    if (at == (rank == 0 ? m->senders : 1))
        *s = (step){.kind = STEP_END};
    else if (rank == 0)
        *s = (step){.kind = STEP_RECEIVE_ANY, .spent_on = TIME_EXCHANGE};
    else
        *s = (step){.kind = STEP_SEND, .spent_on = TIME_EXCHANGE, .bytes = m->bytes};
}

static double time_of_messages(uint32_t senders, double bytes, uint32_t ranks_a_machine)
{
    const machine_room room = {senders + 1, ranks_a_machine, false, 1e-5, 1e9, 1e-6, 4e9, 1e9, 1e9};
    one_message m = {.bytes = bytes, .senders = senders};
    const rank_program program = {next_of_message, &m};
    run_times t;
    return engine_run(&room, &program, &t) ? t.seconds : NAN;
}

static void test_messages(void)
{
    double last = 0.0;
    for (double bytes = 0.0; bytes < 1e9; bytes = 3.0 * bytes + 1.0) {
        const double t = time_of_messages(1, bytes, 1);
        expect(is_near(t, 1e-5 + bytes / 1e9), "a message is latency and bytes", t, bytes);
        expect(t > last, "a longer message takes longer", t, last);
        last = t;
        const double local = time_of_messages(1, bytes, 2);
        expect(is_near(local, 1e-6 + bytes / 4e9), "a message inside a machine", local, bytes);
        /* They share the receiver's port. */
        const double many = time_of_messages(7, bytes, 1);
        expect(is_near(many, 1e-5 + 7 * bytes / 1e9), "seven senders, one port", many, bytes);
        /* Four machines of two ranks: six senders from three others, one from rank 0's own. */
        const double mixed = time_of_messages(7, bytes, 2);
        expect(mixed <= many && mixed >= 1e-5 + 6 * bytes / 1e9 - 1e-12, "machines of two ranks",
               mixed, many);
    }
}

/* Both ranks wait: the simulation must end and say so. */
static void next_of_deadlock(void *context, uint32_t rank, const step_result *last, step *s)
{
    (void)context, (void)last;
    *s = (step){.kind = STEP_RECEIVE, .other = 1 - rank};
}

static void test_deadlock(void)
{
    const machine_room room = {2, 1, false, 1e-5, 1e9, 1e-6, 4e9, 1e9, 1e9};
    const rank_program program = {next_of_deadlock, NULL};
    run_times t;
    fprintf(stderr, "a message about ranks that wait is expected: ");
    expect(!engine_run(&room, &program, &t), "ranks that wait for each other are noticed", 0, 0);
}

/* Scenes. */

static double sum_of(const run_times *t)
{
    double sum = 0.0;
    for (int k = 0; k < TIME_KINDS; ++k)
        sum += t->spent[k];
    return sum;
}

static run_times run_or_fail(way_kind way, const work *w, const figures *f, uint32_t ranks,
                             uint32_t ranks_a_machine)
{
    const way_place place = {ranks_a_machine, false};
    run_times t;
    if (!way_run(way, w, f, ranks, &place, &t)) {
        expect(false, way_name(way), ranks, ranks_a_machine);
        memset(&t, 0, sizeof t);
    }
    return t;
}

static void check_efficiency(way_kind way, const work *w, const figures *f)
{
    const double one = run_or_fail(way, w, f, 1, 1).seconds;
    for (uint32_t n = 1; n <= 256; n *= 4) {
        for (uint32_t machine = 1; machine <= 16; machine *= 16) {
            const run_times t = run_or_fail(way, w, f, n, machine);
            expect(t.seconds > 0.0 && one / (n * t.seconds) <= 1.0 + 1e-12,
                   "efficiency is at most 1", n, one / (n * t.seconds));
            expect(is_near(sum_of(&t), t.seconds), "what is spent adds up", sum_of(&t), t.seconds);
        }
    }
}

/* A slower network or disk makes nothing faster. Frames are handed out in the order of messages,
 * so for them alone a delay may change who draws what; they are left out. */
static void check_monotone(way_kind way, const work *w)
{
    static const figure_kind kinds[] = {FIGURE_LATENCY, FIGURE_LOCAL_LATENCY, FIGURE_BANDWIDTH,
                                        FIGURE_LOCAL_BANDWIDTH, FIGURE_SHARED_DISK};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; ++i) {
        double last = 0.0;
        for (double slower = 1.0; slower < 1e4; slower *= 10.0) {
            figures f = some_figures();
            f.value[kinds[i]] *= i < 2 ? slower : 1.0 / slower;
            const double t = run_or_fail(way, w, &f, 32, 8).seconds;
            expect(t >= last * (1.0 - 1e-12), figure_name(kinds[i]), last, t);
            last = t;
        }
    }
}

/* The formula is exact for one rank, and for equal loads with a port for each rank if no bytes are
 * written; a write of none still takes a latency. */
static void check_formula(way_kind way, const work *w, const work *level)
{
    const way_place place = {1, false}, here = {1, true};
    figures f = some_figures();
    run_times t;
    expect(way_run(way, w, &f, 1, &here, &t) &&
               is_near(t.seconds, way_formula(way, w, &f, 1, &here)),
           "the formula of one rank", t.seconds, way_formula(way, w, &f, 1, &here));
    f.value[FIGURE_BYTES_EMPTY] = f.value[FIGURE_BYTES_DRAWN] = 0.0;
    for (uint32_t n = 1; n <= 512; n *= 2) {
        const double expected =
            way_formula(way, level, &f, n, &place) +
            f.value[FIGURE_LATENCY] * 1e-6 *
                (way_has_frames(way) ? (level->scene.frames + n - 1) / n : level->scene.frames);
        const double one = expected / ((level->scene.frames + n - 1) / n);
        const double time = run_or_fail(way, level, &f, n, 1).seconds;
        if (!way_has_frames(way))
            expect(is_near(time, expected), way_name(way), time, expected);
        else if (way == WAY_FRAMES)
            expect(time > expected - 1e-9 && time < expected + one, way_name(way), time, expected);
    }
}

static void test_scenes(void)
{
    static const work_scene scenes[] = {{"one", 1024, 12, 1}, {"several", 16384, 6, 96}};
    work *w = malloc(sizeof *w), *level = malloc(sizeof *level);
    for (int i = 0; i < 2; ++i) {
        figures f = some_figures();
        if (w == NULL || level == NULL || !work_count(&scenes[i], w)) {
            expect(false, "a scene is counted", i, 0);
            break;
        }
        work_level(w, level);
        for (int way = 0; way < WAY_COUNT; ++way) {
            if (way_has_frames((way_kind)way) && scenes[i].frames == 1)
                continue;
            check_efficiency((way_kind)way, w, &f);
            check_formula((way_kind)way, w, level);
            if (!way_has_frames((way_kind)way))
                check_monotone((way_kind)way, w);
        }
    }
    free(w);
    free(level);
}

/* Counts of bands and parts. */
static void test_counts(void)
{
    static const work_scene scene = {"", 1024, 9, 1};
    work *w = malloc(sizeof *w);
    if (w == NULL || !work_count(&scene, w)) {
        expect(false, "a scene is counted", 0, 0);
        free(w);
        return;
    }
    for (uint32_t n = 2; n <= WORK_MOST; n *= 2) {
        work_share bands = {0}, parts = {0};
        double most = 0.0;
        for (uint32_t i = n; i < 2 * n; ++i) {
            bands.drawn += w->band[i].drawn;
            bands.rows += w->band[i].rows;
            bands.fragments += w->band[i].fragments;
            bands.covered += w->band[i].covered;
            parts.drawn += w->part[i].drawn;
            parts.fragments += w->part[i].fragments;
            most = fmax(most, w->band[i].fragments);
        }
        expect(is_near(bands.fragments, w->whole.fragments), "fragments of bands", n,
               bands.fragments);
        expect(is_near(parts.fragments, w->whole.fragments), "fragments of parts", n,
               parts.fragments);
        expect(is_near(bands.covered, w->whole.covered), "pixels of bands", n, bands.covered);
        expect(is_near(parts.drawn, w->whole.drawn), "triangles of parts", n, parts.drawn);
        expect(bands.drawn > w->whole.drawn && bands.drawn <= w->whole.rows,
               "triangles of bands, some in two", bands.drawn, w->whole.drawn);
        expect(most > w->whole.fragments / n, "bands are unequal", most, n);
    }
    expect(w->whole.covered < w->whole.fragments && w->whole.covered > 1e5,
           "the model hides parts of itself", w->whole.covered, w->whole.fragments);
    free(w);
}

static void test_fit(void)
{
    static const double wanted[] = {3e-9, 0.5e-9, 20e-9};
    fit_row rows[5] = {{{1000, 5000, 10}, 0},
                       {{100, 90000, 100}, 0},
                       {{4000, 40, 4000}, 0},
                       {{7, 7, 7000}, 0},
                       {{300, 2000, 50}, 0}};
    double found[FIT_MOST];
    for (int r = 0; r < 5; ++r)
        for (int i = 0; i < FIT_MOST; ++i)
            rows[r].seconds += rows[r].count[i] * wanted[i];
    const double error = fit_rows(rows, 5, 3, found);
    expect(error < 1e-6, "an exact fit", error, 0);
    for (int i = 0; i < FIT_MOST; ++i)
        expect(fabs(found[i] / wanted[i] - 1.0) < 1e-6, "a coefficient", found[i], wanted[i]);
    /* The second would be negative. */
    rows[0] = (fit_row){{1, 0, 0}, 1.0};
    rows[1] = (fit_row){{1, 1, 0}, 0.5};
    fit_rows(rows, 2, 2, found);
    expect(found[1] >= 0.0 && found[0] > 0.5 && found[0] < 1.0, "no negative coefficient", found[0],
           found[1]);
}

int main(void)
{
    test_messages();
    test_deadlock();
    test_fit();
    test_counts();
    test_scenes();
    printf("scale: %u passed, %u failed\n", passed, failed);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
