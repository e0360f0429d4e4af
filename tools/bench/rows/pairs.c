/* All rows: the single ones, then random combinations of two. A combination has the shape and the
 * text of one row and, after that, the text of another one, which plain shapes have. */
#include "rows.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene_memory.h"

/* Each run has the same combinations: those whose names have the lowest hashes. So a new row
 * replaces a few of them at most. */
#define SEED UINT32_C(2022)

enum { PAIRS = 64, MOST_NAME = 80, MOST_TEXT = 1024 };

typedef struct candidate {
    uint32_t hash;
    const bench_row *a, *b;
} candidate;

/* FNV-1a, whose last bytes do not reach all bits. */
static uint32_t hash(uint32_t h, const char *text)
{
    for (; *text; ++text)
        h = (h ^ (unsigned char)*text) * UINT32_C(16777619);
    return h;
}

static int compare_candidates(const void *a, const void *b)
{
    const uint32_t x = ((const candidate *)a)->hash, y = ((const candidate *)b)->hash;

    return (x > y) - (x < y);
}

static bool is_one_of(const char *text, const char *const *list)
{
    for (; *list; ++list)
        if (strcmp(text, *list) == 0)
            return true;
    return false;
}

/* The first row of a combination may be any that draws a frame, except whole scenes, which have no
 * state of their own, frames of clears alone, and many draws, whose text changes the first only. */
static bool may_be_first(const bench_row *row)
{
    static const char *const without[] = {"scene", "clears", GROUP_FIXED, NULL};

    return row->work == WORK_DRAW && row->shape != SHAPE_CUBES && !is_one_of(row->group, without);
}

/* The second row's text must mean the same with any shape. */
static bool may_be_second(const bench_row *row)
{
    static const char *const groups[] = {
        "colour",      "depth",         "blend",    "logic",    "masks",     "stencil", "samples",
        "attachments", "interpolation", "polygons", "clipping", "fragments", NULL};
    const bool is_plain = row->shape == SHAPE_SCREENS || row->shape == SHAPE_SPHERE;

    return row->work == WORK_DRAW && is_plain && *row->text && is_one_of(row->group, groups);
}

/* Two rows are not combined if one has the first text and the other has the second. A text that
 * begins with @ is a group, one with = a shape. */
typedef struct exclusion {
    const char *a, *b, *reason;
} exclusion;

static const exclusion exclusions[] = {
    {"shader ", "shader ", "a draw has one shader"},
    {"shader ", "=own shader", "the shape has its own shader"},
    {"color-format", "color-format", "a surface has one format"},
    {"depth-format", "depth-format", "a surface has one format"},
    {"color.blend[0]", "color.blend[0]", "an attachment is blended in one way"},
    {"color.write_disabled", "color.write_disabled", "an attachment has one mask"},
    {"color.blend", "color.logic ", "a logical operation takes the place of blending"},
    {"depth.function", "front-to-back", "the row's own function fits the row's order"},
    {"front-to-back", "front-to-back", "the order is turned round once"},
    {"program.interpolation", "shader ", "only vertex colours have their qualifiers here"},
    {"program.interpolation", "=own shader", "only vertex colours have their qualifiers here"},
    {"raster.polygon_mode", "=lines or points", "lines and points have no mode"},
    {"srgb8-a8", "color.blend", "layers multiply the step that is allowed in sRGB"},
    {"srgb8-a8", "samples 4", "the average of samples may be two steps away"},
    {"raster.polygon_offset", "depth-format none", "the offset needs a depth buffer's step"},
    {"raster.polygon_offset", "depth-format s8", "the offset needs a depth buffer's step"},
    {"shader depth-only", "depth-format none", "it needs a depth buffer"},
    {"shader depth-only", "depth-format s8", "it needs a depth buffer"},
    {"shader depth-only", "@attachments", "it writes no colour"},
    {"samples 4", "raster.polygon_mode", "the reference loses pixels of sampled lines"},
    {"samples 4", "=lines or points", "the reference loses pixels of sampled lines"},
    {"samples 4", "raster.scissor", "the reference's scissor leaks among samples"},
    {"max_anisotropy", "", "a mean difference is allowed, which another state could enlarge"},
};

static bool has_own_shader(const bench_row *row)
{
    return row->shape == SHAPE_TEXTURED || row->shape == SHAPE_SAMPLED ||
           row->shape == SHAPE_PHONG || row->shape == SHAPE_USER;
}

static bool has(const bench_row *row, const char *what)
{
    if (strcmp(what, "=own shader") == 0)
        return has_own_shader(row);
    if (strcmp(what, "=lines or points") == 0)
        return row->shape >= SHAPE_LINES && row->shape <= SHAPE_POINTS;
    if (what[0] == '@')
        return strcmp(row->group, what + 1) == 0;
    return strstr(row->text, what);
}

static bool may_be_combined(const bench_row *a, const bench_row *b)
{
    bool may = strcmp(a->group, b->group) != 0;

    for (size_t i = 0; i < sizeof exclusions / sizeof *exclusions; ++i) {
        const exclusion *const e = &exclusions[i];

        may = may && !(has(a, e->a) && has(b, e->b)) && !(has(b, e->a) && has(a, e->b));
    }
    return may;
}

/* Screens that cost as much as the rows' own: a row with few screens has slow fragments. */
static uint32_t detail_of(const bench_row *a, const bench_row *b)
{
    const uint32_t plain = 16;
    const bool few = a->shape < SHAPE_SPHERE && b->shape == SHAPE_SCREENS && b->detail < plain;
    const uint32_t detail = few ? a->detail * b->detail / plain : a->detail;

    return detail < 2 ? 2 : detail;
}

static bool is_new(const bench_row *rows, size_t count, const char *name)
{
    for (size_t i = 0; i < count; ++i)
        if (strcmp(rows[i].name, name) == 0)
            return false;
    return true;
}

/* The length of a second row's name without its shape, which the combination does not have. */
static size_t length_without_shape(const char *name)
{
    static const char *const shapes[] = {", sphere", " sphere", ", screens", " screens"};
    const size_t length = strlen(name);

    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; ++i) {
        const size_t ending = strlen(shapes[i]);

        if (length > ending && strcmp(name + length - ending, shapes[i]) == 0)
            return length - ending;
    }
    return length;
}

/* Lists the pairs of rows that may be combined as to their groups and shapes, in the order of their
 * hashes. The caller frees the list. */
static candidate *list_candidates(size_t *count)
{
    const size_t rows = single_state_count;
    candidate *const list = scene_allocate(rows * rows, sizeof *list);

    *count = 0;
    for (size_t i = 0; i < rows * rows; ++i) {
        const bench_row *const a = &single_states[i / rows];
        const bench_row *const b = &single_states[i % rows];

        if (may_be_first(a) && may_be_second(b))
            list[(*count)++] =
                (candidate){row_spread(hash(hash(hash(SEED, a->name), " + "), b->name)), a, b};
    }
    qsort(list, *count, sizeof *list, compare_candidates);
    return list;
}

static void combine(bench_row *rows, size_t count)
{
    static char names[PAIRS][MOST_NAME], texts[PAIRS][MOST_TEXT];
    size_t candidates, pair = 0;
    candidate *const list = list_candidates(&candidates);

    for (size_t i = 0; i < candidates && pair < PAIRS; ++i) {
        const bench_row *const a = list[i].a, *const b = list[i].b;
        bench_row *const row = &rows[count + pair];

        if (!may_be_combined(a, b))
            continue;
        snprintf(names[pair], MOST_NAME, "%s + %.*s", a->name, (int)length_without_shape(b->name),
                 b->name);
        snprintf(texts[pair], MOST_TEXT, "%s %s", a->text, b->text);
        if (!is_new(rows + count, pair, names[pair]))
            continue;
        *row = *a;
        row->group = "pairs";
        row->name = names[pair];
        row->text = texts[pair];
        row->detail = detail_of(a, b);
        ++pair;
    }
    free(list);
    if (pair < PAIRS) {
        fprintf(stderr, "bench-states: only %zu pairs of rows can be combined\n", pair);
        exit(EXIT_FAILURE);
    }
}

const bench_row *state_rows(size_t *count)
{
    static bench_row *rows;

    *count = single_state_count + PAIRS;
    if (!rows) {
        rows = scene_allocate(*count, sizeof *rows);
        memcpy(rows, single_states, single_state_count * sizeof *rows);
        combine(rows, single_state_count);
    }
    return rows;
}
