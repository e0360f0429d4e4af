/* Batches of the fragment engine (src/kernel/fragment/batch.inl,
 * src/kernel/raster/block_queue.inl): overlapping triangles that share batches, in every kind of
 * state; and batches that end within a triangle, a row or a draw. */
#include "generate_parts.h"

#include <stdlib.h>
#include <string.h>

/* The side of the squares that coverage finds, and the most of them in a run. */
#define SQUARE 4
#define RUN_LIMIT 80

/* Every how many blocks batches may end: steps take 1, 4 or 16 blocks together, coverage 16 or
 * 32. */
static uint32_t batch_length(random_source *r)
{
    static const uint32_t lengths[] = {1, 4, 16, 16, 16, 32, 32};
    return lengths[random_below(r, sizeof lengths / sizeof *lengths)];
}

/* A count of 1 and more, mostly a multiple of a batch's length or up to two beside it. */
static uint32_t count_near_end(random_source *r, uint32_t most)
{
    const uint32_t length = batch_length(r);
    const uint32_t times = 1 + random_below(r, most / length > 0 ? most / length : 1);
    const int32_t beside = random_between(r, -2, 2);
    const int32_t count = (int32_t)(length * times) + beside;
    if (random_chance(r, 30))
        return 1 + random_below(r, most);
    return count < 1 ? 1 : (uint32_t)count;
}

/* Colours and depths of any format, several attachments now and then. */
static void batch_target(builder *b, uint32_t width, uint32_t height)
{
    random_source *r = &b->random;
    builder_target(b, width, height, GN_FORMAT_RGBA8, random_depth_format(b));
    const uint32_t kind = random_below(r, 10);
    if (kind < 2)
        b->scene->color_format = GN_FORMAT_RGBA32F;
    else if (kind < 7)
        b->scene->color_format = random_color_format(b);
    if (random_chance(r, 20))
        add_attachments(b);
}

/* A side of 1 to 70 pixels, mostly odd, so that blocks hang over the edge. */
static uint32_t odd_side(random_source *r)
{
    const uint32_t side = 1 + random_below(r, 70);
    return random_chance(r, 70) ? side | 1 : side;
}

static void batch_colors(builder *b, bool may_blend)
{
    random_source *r = &b->random;
    const uint32_t kind = random_below(r, 10);
    if (kind < 4 && may_blend) {
        random_blend(b, 0);
    } else if (kind < 7) {
        b->state.color.logic_enabled = true;
        b->state.color.logic_operation = (gn_logic_operation)random_below(r, 16);
    }
    if (random_chance(r, 20))
        random_mask(b, 0);
    mix_attachments(b, false);
}

/* One of the kinds of state that the engine distinguishes. */
static void batch_state(builder *b, bool may_blend)
{
    random_source *r = &b->random;
    builder_common_state(b);
    if (random_chance(r, 40))
        b->state.depth.function = random_comparison(r);
    b->state.depth.write_disabled = random_chance(r, 20);
    if (random_chance(r, 35))
        random_stencil(b);
    batch_colors(b, may_blend);
    b->state.raster.front_face = (gn_front_face)random_below(r, 2);
    b->state.raster.cull = (gn_cull)(random_chance(r, 10) ? random_below(r, 3) : 0);
    b->state.raster.provoking_vertex = (gn_provoking_vertex)random_below(r, 2);
}

/* Sets a shader for the next draw, whose vertices exist. Returns the texels of its texture; the
 * caller frees them after the draw. */
static void *batch_shader(builder *b)
{
    random_source *r = &b->random;
    const uint32_t kind = random_below(r, 20);
    if (b->scene->more_colors[0] != GN_FORMAT_NONE && random_chance(r, 80)) {
        random_outputs(b);
    } else if (kind < 5) {
        random_inputs(b); /* discards, writes depth */
    } else if (kind < 7) {
        return random_picture(b);
    } else if (kind < 8) {
        b->shader = SCENE_GOURAUD;
        random_light(b);
    } else if (kind < 10) {
        for (int i = 0; i < 4; ++i)
            b->state.program.interpolation[i] = GN_FLAT;
    } else if (kind < 11 && b->scene->depth_format != GN_FORMAT_NONE) {
        b->shader = SCENE_DEPTH_ONLY;
    }
    return NULL;
}

/* Draws the collected vertices. */
static void batch_draw(builder *b)
{
    void *const texels = batch_shader(b);
    b->counted = random_chance(&b->random, 30);
    builder_draw(b);
    free(texels);
}

/* The corners of a triangle in the window, all with one depth and w or each with its own. */
typedef struct corners {
    float at[3][2];
    float z[3], w[3];
} corners;

static void add_corners(builder *b, const corners *c)
{
    for (int k = 0; k < 3; ++k) {
        vertex *v = builder_vertex(b);
        builder_place(b, v, c->at[k][0], c->at[k][1], c->z[k], c->w[k]);
    }
}

static void random_depths(random_source *r, corners *c)
{
    const bool level = random_chance(r, 40), affine = random_chance(r, 60);
    const float z = (float)random_between(r, -3, 3) * 0.25f;
    for (int k = 0; k < 3; ++k) {
        c->z[k] = level ? z : random_float(r, -0.95f, 0.95f);
        c->w[k] = affine ? 1.0f : random_octave(r, -1, 0);
    }
}

/* A triangle of a few pixels, of a few squares, of most of the target or beyond, or a sliver;
 * mostly a large one if `large`. */
static corners random_corners(builder *b, const float middle[2], bool large)
{
    random_source *r = &b->random;
    const uint32_t kind =
        random_chance(r, large ? 70 : 0) ? 5 + random_below(r, 2) : random_below(r, 8);
    const float reach = kind < 3   ? random_float(r, 0.5f, 4.0f)
                        : kind < 5 ? random_float(r, 4.0f, 16.0f)
                                   : random_float(r, 32.0f, 200.0f);
    corners c;
    for (int k = 0; k < 3; ++k)
        for (int axis = 0; axis < 2; ++axis)
            c.at[k][axis] = middle[axis] + random_float(r, -reach, reach);
    if (kind == 7) { /* a sliver: the third corner beside the side between the others */
        const float along = random_unit(r), thickness = random_octave(r, -4, 1);
        for (int axis = 0; axis < 2; ++axis)
            c.at[2][axis] = c.at[0][axis] + along * (c.at[1][axis] - c.at[0][axis]) +
                            random_float(r, -thickness, thickness);
    }
    random_depths(r, &c);
    return c;
}

/* Moves a triangle by whole pixels, exchanges corners, changes depths, or leaves it in place. */
static corners varied(random_source *r, const corners *base)
{
    corners c = *base;
    if (random_chance(r, 40)) {
        for (int axis = 0; axis < 2; ++axis) {
            const float by = (float)random_between(r, -3, 3);
            for (int k = 0; k < 3; ++k)
                c.at[k][axis] += by;
        }
    }
    if (random_chance(r, 25)) {
        const corners whole = c;
        memcpy(c.at[0], whole.at[1], sizeof c.at[0]);
        memcpy(c.at[1], whole.at[0], sizeof c.at[1]);
    }
    if (random_chance(r, 50))
        random_depths(r, &c);
    return c;
}

/* Triangles that are copies of a few, in any order: many lie in the same squares, some are equal in
 * place. */
static void shape_copies(builder *b, uint32_t count)
{
    random_source *r = &b->random;
    const gn_viewport view = builder_viewport(b);
    const uint32_t bases = 1 + random_below(r, 4);
    const bool large = random_chance(r, 50);
    corners base[4];
    float middle[2];
    for (uint32_t i = 0; i < bases; ++i) {
        if (i == 0 || random_chance(r, 40)) {
            middle[0] = view.x + random_unit(r) * view.width;
            middle[1] = view.y + random_unit(r) * view.height;
        }
        base[i] = random_corners(b, middle, large);
    }
    for (uint32_t i = 0; i < count; ++i) {
        const corners c = varied(r, &base[random_below(r, bases)]);
        add_corners(b, &c);
    }
}

/* Few layers of floats are blended (may_blend_after). */
static bool wants_few_layers(const builder *b)
{
    return !may_blend_after(b, 2) && may_blend_after(b, 0);
}

static uint32_t layers_of(builder *b, uint32_t most)
{
    return 1 + random_below(&b->random, wants_few_layers(b) && most > 8 ? 8 : most);
}

static uint32_t draws_of(builder *b, uint32_t most)
{
    return 1 + random_below(&b->random, wants_few_layers(b) && most > 2 ? 2 : most);
}

void generate_batches(builder *b)
{
    random_source *r = &b->random;
    const uint32_t width = 8 + random_below(r, 121), height = 8 + random_below(r, 89);
    batch_target(b, width, height);
    const uint32_t draws = draws_of(b, 3);
    for (uint32_t i = 0; i < draws; ++i) {
        if (i == 0 || random_chance(r, 50))
            batch_state(b, may_blend_after(b, 0));
        const gn_pipeline state = b->state;
        const uint32_t kind = random_below(r, 20);
        if (kind == 0)
            shape_points(b, layers_of(b, 40));
        else if (kind == 1)
            shape_lines(b, layers_of(b, 40));
        else
            shape_copies(b, layers_of(b, 40));
        batch_draw(b);
        b->state = state;
    }
}

/* A pixel rectangle. */
typedef struct rectangle {
    uint32_t x, y, width, height;
} rectangle;

/* A rectangle whose rows are runs of 1 to RUN_LIMIT squares, from any pixel on. */
static rectangle random_run(builder *b)
{
    random_source *r = &b->random;
    rectangle run;
    run.x = random_below(r, b->scene->width < 21 ? b->scene->width : 21);
    run.y = random_below(r, b->scene->height);
    if (random_chance(r, 30))
        run.x &= ~(uint32_t)(SQUARE - 1);
    run.width = SQUARE * count_near_end(r, RUN_LIMIT);
    run.width += random_below(r, 3);
    run.height = 1 + random_below(r, 3 * SQUARE);
    return run;
}

/* Two triangles that are a rectangle, or one that is much larger. */
static void add_rectangle(builder *b, const rectangle *at, bool larger)
{
    random_source *r = &b->random;
    const float x = (float)at->x, y = (float)at->y;
    const float width = (float)at->width, height = (float)at->height;
    const uint32_t count = larger ? 1 : 2;
    corners c;
    for (uint32_t i = 0; i < count; ++i) {
        const float sign = i == 0 ? 1.0f : -1.0f;
        const float from[2] = {i == 0 ? x : x + width, i == 0 ? y : y + height};
        for (int k = 0; k < 3; ++k) {
            c.at[k][0] = from[0] + (k == 1 ? sign * width : 0.0f);
            c.at[k][1] = from[1] + (k == 2 ? sign * height : 0.0f);
        }
        if (i == 0)
            random_depths(r, &c);
        if (larger) {
            c.at[0][0] = x - width;
            c.at[0][1] = y - height;
            c.at[1][0] = x + 4.0f * width;
            c.at[1][1] = y - height;
            c.at[2][0] = x - width;
            c.at[2][1] = y + 4.0f * height;
        }
        add_corners(b, &c);
    }
}

/* Layers of runs; the sides of a layer that is larger are those of the scissor or the viewport. */
static void shape_runs(builder *b, uint32_t layers)
{
    random_source *r = &b->random;
    rectangle run = random_run(b);
    const uint32_t kind = random_below(r, 4);
    if (kind == 0) {
        const gn_scissor scissor = {true, (int32_t)run.x, (int32_t)run.y, run.width, run.height};
        b->state.raster.scissor = scissor;
    } else if (kind == 1) {
        const gn_viewport viewport = {true, (float)run.x, (float)run.y, (float)run.width,
                                      (float)run.height};
        b->state.raster.viewport = viewport;
    }
    for (uint32_t i = 0; i < layers; ++i) {
        if (i > 0 && kind > 1 && random_chance(r, 40))
            run = random_run(b);
        add_rectangle(b, &run, kind < 2 ? random_chance(r, 70) : random_chance(r, 20));
    }
}

/* Small triangles, each within one row of squares, that have about as many squares in all as some
 * batches hold. */
static void shape_blocks(builder *b)
{
    random_source *r = &b->random;
    const uint32_t columns = (b->scene->width + SQUARE - 1) / SQUARE;
    const uint32_t rows = (b->scene->height + SQUARE - 1) / SQUARE;
    const bool one_place = random_chance(r, 30), whole = random_chance(r, 50);
    const uint32_t longest = 1 + random_below(r, 9);
    for (uint32_t left = count_near_end(r, 70); left > 0;) {
        const uint32_t wanted = 1 + random_below(r, longest);
        const uint32_t squares = wanted < left ? wanted : left;
        const uint32_t column = one_place ? 0 : random_below(r, columns);
        const uint32_t row = one_place ? 0 : random_below(r, rows);
        const float x = (float)(SQUARE * column), y = (float)(SQUARE * row);
        const float length = (float)(SQUARE * squares);
        const float height = whole ? 4.0f : random_float(r, 0.6f, 3.9f);
        corners c = {{{x, y}, {x + length, y}, {x + length * random_unit(r), y + height}},
                     {0.0f, 0.0f, 0.0f},
                     {1.0f, 1.0f, 1.0f}};
        random_depths(r, &c);
        add_corners(b, &c);
        left -= squares;
    }
}

static void batch_ends_target(builder *b)
{
    random_source *r = &b->random;
    const bool wide = random_chance(r, 40);
    const uint32_t width = wide ? 1 + random_below(r, SQUARE * (RUN_LIMIT + 5)) : odd_side(r);
    const uint32_t height = wide ? 1 + random_below(r, 24) : odd_side(r);
    batch_target(b, width, height);
}

void generate_batch_ends(builder *b)
{
    random_source *r = &b->random;
    batch_ends_target(b);
    const bool small = random_chance(r, 30); /* many draws of one or two triangles */
    const uint32_t draws = draws_of(b, small ? 10 : 3);
    for (uint32_t i = 0; i < draws; ++i) {
        if (i == 0 || random_chance(r, small ? 15 : 50))
            batch_state(b, may_blend_after(b, 0));
        const gn_pipeline state = b->state;
        const uint32_t kind = random_below(r, 10);
        if (small && kind < 5)
            shape_copies(b, 1 + random_below(r, 2));
        else if (kind < 4)
            shape_blocks(b);
        else
            shape_runs(b, layers_of(b, small ? 2 : 5));
        batch_draw(b);
        b->state = state;
    }
}
