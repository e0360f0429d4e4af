/* Explains random pixels of the scenes that parity generates: every class, so all shaders, filters,
 * samples, polygon modes and clip conventions occur. For each pixel explain_pixel compares the
 * traced words with gn_draw's and evaluates every recorded operation anew; here the report is
 * checked for what every fragment must have. Prints "N passed, N failed".
 *
 *   explain-pixels [SEED [SCENES]]    scenes of each class */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "explain.h"
#include "generate.h"
#include "told.h"

static uint64_t random_state;

static uint32_t random_below(uint32_t n)
{
    random_state = random_state * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)((random_state >> 33) % n);
}

/* Makes of a scene one that can be explained, with formats of the page and the command. */
static void adapt(scene *s)
{
    s->color_format = GN_FORMAT_RGBA8;
    if (s->depth_format != GN_FORMAT_NONE && s->depth_format != GN_FORMAT_D24)
        s->depth_format = GN_FORMAT_D32F;
    for (int a = 0; a < GN_MAX_COLORS - 1; ++a)
        s->more_colors[a] = GN_FORMAT_NONE;
}

/* Returns whether a fragment's stages have a value of this name, or one that begins so. */
static bool has_value(const report_fragment *f, const char *wanted, bool is_beginning)
{
    const size_t length = strlen(wanted) + !is_beginning;
    const uint32_t range[2][2] = {{f->shared, f->shared_end}, {f->own, f->own_end}};

    for (int r = 0; r < 2; ++r) {
        for (uint32_t s = range[r][0]; s < range[r][1]; ++s) {
            for (uint32_t n = 0; n < told.stages[s].count; ++n) {
                const char *name = report_words(told.values[told.stages[s].first + n].name);

                if (strncmp(name, wanted, length) == 0)
                    return true;
            }
        }
    }
    return false;
}

/* Returns what a fragment lacks of what it must have, or null. */
static const char *missing(const scene *s, const report_fragment *f)
{
    static const char always[][20] = {"v1.clip.x",     "v1.clip.w",    "v1.one_over_w",
                                      "v1.ndc.z",      "v1.window.y",  "v1.snapped.x",
                                      "depth.origin",  "depth.per_x",  "one_over_w.per_y"};
    static const char of_triangles[][24] = {"v3.position.x", "v2.snapped.y", "twice_the_area",
                                            "one_over_area"};
    const scene_draw *const d = &s->draws[f->draw];
    const bool is_triangle = strcmp(f->kind, "triangle") == 0;
    const bool is_written = strcmp(report_words(f->result), "written") == 0;

    for (size_t i = 0; i < sizeof always / sizeof always[0]; ++i)
        if (!has_value(f, always[i], false))
            return always[i];
    for (size_t i = 0; i < sizeof of_triangles / sizeof of_triangles[0]; ++i)
        if (is_triangle && !has_value(f, of_triangles[i], false))
            return of_triangles[i];
    if (is_triangle && !scene_is_sampled(s) && !has_value(f, "barycentric.", true))
        return "barycentric";
    if (!is_written || d->shader == SCENE_DEPTH_ONLY)
        return NULL;
    if (!has_value(f, "shaded.red", true))
        return "shaded.red";
    return has_value(f, "word", true) ? NULL : "word";
}

static unsigned passed, failed, fragments, skipped;

static void fail(scene_class c, uint64_t number, uint32_t x, uint32_t y, const char *why,
                 const char *more)
{
    printf("%s %" PRIu64 ", pixel %u,%u from the bottom: %s%s\n", scene_class_name(c), number,
           (unsigned)x, (unsigned)y, why, more);
    ++failed;
}

static void check_pixel(const scene *s, scene_class c, uint64_t number, uint32_t x, uint32_t y)
{
    static const explain_view no_view;
    explained e;
    const char *const fault = explain_pixel(s, x, y, &no_view, &e);

    if (fault && strstr(fault, "only")) {
        ++skipped;
        return;
    }
    if (fault) {
        fail(c, number, x, y, fault, "");
        return;
    }
    if (e.faults || e.word != e.drawn_word) {
        fail(c, number, x, y, prose_of(&told.fault), e.faults ? "" : "another word");
        return;
    }
    for (uint32_t i = 0; i < told.fragment_count; ++i) {
        const char *const lacks = missing(s, &told.fragments[i]);

        if (lacks) {
            fail(c, number, x, y, "a fragment lacks ", lacks);
            return;
        }
    }
    fragments += e.fragments;
    ++passed;
}

int main(int argc, char **argv)
{
    const uint64_t seed = argc > 1 ? strtoull(argv[1], NULL, 10) : 1;
    const uint64_t scenes = argc > 2 ? strtoull(argv[2], NULL, 10) : 10;

    for (int c = 0; c < CLASS_COUNT; ++c) {
        for (uint64_t number = 0; number < scenes; ++number) {
            scene *const s = generate_scene(seed, (scene_class)c, number);

            random_state = seed * 1000003 + (uint64_t)c * 1009 + number;
            adapt(s);
            for (int i = 0; i < 3; ++i) {
                const uint32_t x = random_below(s->width), y = random_below(s->height);

                check_pixel(s, (scene_class)c, number, x, y);
            }
            scene_free(s);
        }
    }
    explain_free();
    printf("%u fragments; %u pixels of scenes that are not explained\n", fragments, skipped);
    printf("%u passed, %u failed\n", passed, failed);
    return failed ? 1 : 0;
}
