/* All rows: the single ones, then random combinations of two. A combination has the shape and the
 * text of one row and, after that, the text of another one, which plain shapes have. */
#include "rows.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene_memory.h"

/* Each run has the same combinations. */
#define SEED UINT32_C(2022)

enum { MOST_NAME = 80, MOST_TEXT = 1024 };

/* A generator of Lehmer's kind: the product of the state and 48271 modulo 2^31 - 1. */
static uint32_t next(uint32_t *state)
{
    *state = (uint32_t)((uint64_t)*state * 48271 % 0x7FFFFFFF);
    return *state;
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
static bool may_be_first(const state_row *row)
{
    static const char *const without[] = {"scene", "clears", STATE_FIXED, NULL};

    return row->work == WORK_DRAW && row->shape != SHAPE_CUBES && !is_one_of(row->group, without);
}

/* The second row's text must mean the same with any shape. */
static bool may_be_second(const state_row *row)
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

static bool has_own_shader(const state_row *row)
{
    return row->shape == SHAPE_TEXTURED || row->shape == SHAPE_SAMPLED ||
           row->shape == SHAPE_PHONG || row->shape == SHAPE_USER;
}

static bool has(const state_row *row, const char *what)
{
    if (strcmp(what, "=own shader") == 0)
        return has_own_shader(row);
    if (strcmp(what, "=lines or points") == 0)
        return row->shape >= SHAPE_LINES && row->shape <= SHAPE_POINTS;
    if (what[0] == '@')
        return strcmp(row->group, what + 1) == 0;
    return strstr(row->text, what);
}

static bool may_be_combined(const state_row *a, const state_row *b)
{
    bool may = strcmp(a->group, b->group) != 0;

    for (size_t i = 0; i < sizeof exclusions / sizeof *exclusions; ++i) {
        const exclusion *const e = &exclusions[i];

        may = may && !(has(a, e->a) && has(b, e->b)) && !(has(b, e->a) && has(a, e->b));
    }
    return may;
}

/* Screens that cost as much as the rows' own: a row with few screens has slow fragments. */
static uint32_t detail_of(const state_row *a, const state_row *b)
{
    const uint32_t plain = 16;
    const bool few = a->shape < SHAPE_SPHERE && b->shape == SHAPE_SCREENS && b->detail < plain;
    const uint32_t detail = few ? a->detail * b->detail / plain : a->detail;

    return detail < 2 ? 2 : detail;
}

static bool is_new(const state_row *rows, size_t count, const char *name)
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

static void combine(state_row *rows, size_t count)
{
    static char names[STATE_PAIRS][MOST_NAME], texts[STATE_PAIRS][MOST_TEXT];
    uint32_t random = SEED;

    for (size_t pair = 0; pair < STATE_PAIRS;) {
        const state_row *const a = &state_single_rows[next(&random) % state_single_row_count];
        const state_row *const b = &state_single_rows[next(&random) % state_single_row_count];
        state_row *const row = &rows[count + pair];

        if (!may_be_first(a) || !may_be_second(b) || !may_be_combined(a, b))
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
}

const state_row *state_rows(size_t *count)
{
    static state_row *rows;

    *count = state_single_row_count + STATE_PAIRS;
    if (!rows) {
        rows = scene_allocate(*count, sizeof *rows);
        memcpy(rows, state_single_rows, state_single_row_count * sizeof *rows);
        combine(rows, state_single_row_count);
    }
    return rows;
}
