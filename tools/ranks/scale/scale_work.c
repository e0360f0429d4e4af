/* Counts the work of bands and parts with the library's statistics.
 *
 * Triangles of bands are not sums: one that spans two bands belongs to both. So each block of
 * triangles is drawn into the whole picture, then into its halves, quarters and so on, down to
 * single rows, but not into the parts of a band in which none of it is drawn. */
#include "scale_work.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scale_model.h"

#define SIDE WORK_MOST /* a row is a band of the last level */
#define BLOCK 4096     /* triangles */

const work_scene work_scenes[WORK_SCENES] = {
    {"triangles", 1024, 125, 1},
    {"pixels", 16384, 40, 1},
    {"frames", 1024, 40, 1000},
};

typedef struct counter {
    scale_model model;
    gn_workspace workspace;
    gn_pipeline pipeline;
    gn_color_uniforms uniforms;
    gn_surface depth;
    work *result;
} counter;

static bool fail(const char *why)
{
    fprintf(stderr, "scale: %s\n", why);
    return false;
}

/* Counts some triangles in some rows. */
static gn_status count(counter *k, uint32_t first_triangle, uint32_t triangles, uint32_t first_row,
                       uint32_t rows, gn_draw_statistics *result)
{
    const gn_target target = {.depth = gn_surface_rows(&k->depth, first_row, rows)};
    gn_mesh mesh = k->model.p.scene->draws[0].mesh;
    mesh.first = 3 * first_triangle;
    mesh.count = 3 * triangles;
    k->pipeline.raster.viewport = (gn_viewport){true, 0, -(float)first_row, SIDE, SIDE};
    memset(result, 0, sizeof *result);
    k->workspace.statistics = result;
    return gn_draw(&target, &k->pipeline, &mesh, &k->workspace);
}

/* Counts a block of triangles in band `number` of the heap of bands, and in the bands in it. */
static gn_status count_bands(counter *k, uint32_t first, uint32_t triangles, uint32_t number,
                             uint32_t rows)
{
    gn_draw_statistics s;
    const uint32_t bands = SIDE / rows;
    gn_status status = count(k, first, triangles, (number - bands) * rows, rows, &s);
    if (status != GN_OK || s.drawn == 0)
        return status;
    work_share *band = &k->result->band[number];
    band->drawn += (double)s.drawn;
    if (rows == 1) {
        band->rows += (double)s.drawn;
        band->fragments += (double)s.samples_covered;
        return GN_OK;
    }
    status = count_bands(k, first, triangles, 2 * number, rows / 2);
    return status != GN_OK ? status : count_bands(k, first, triangles, 2 * number + 1, rows / 2);
}

static gn_status count_parts(counter *k)
{
    const uint32_t triangles = k->model.p.scene->draws[0].mesh.count / 3;
    gn_status status = GN_OK;
    for (uint32_t i = 0; i < WORK_MOST && status == GN_OK; ++i) {
        gn_draw_statistics s;
        const uint32_t first = (uint32_t)((uint64_t)triangles * i / WORK_MOST);
        const uint32_t end = (uint32_t)((uint64_t)triangles * (i + 1) / WORK_MOST);
        status = count(k, first, end - first, 0, SIDE, &s);
        k->result->part[WORK_MOST + i].drawn = (double)s.drawn;
        k->result->part[WORK_MOST + i].fragments = (double)s.samples_covered;
    }
    return status;
}

/* Pixels of each row that show the model. */
static bool count_covered(counter *k)
{
    drawing *d = &k->model.d;
    if (drawing_draw(k->model.p.scene, d) != 0)
        return false;
    const float *depth = d->frame.depth;
    for (uint32_t y = 0; y < SIDE; ++y)
        for (uint32_t x = 0; x < SIDE; ++x)
            k->result->band[WORK_MOST + y].covered += depth[(size_t)y * SIDE + x] < 1.0f;
    return true;
}

static void add_up(work *w)
{
    for (uint32_t i = WORK_MOST - 1; i > 0; --i) {
        const work_share *a = &w->band[2 * i], *b = &w->band[2 * i + 1];
        w->band[i].rows = a->rows + b->rows;
        w->band[i].fragments = a->fragments + b->fragments;
        w->band[i].covered = a->covered + b->covered;
        w->part[i].drawn = w->part[2 * i].drawn + w->part[2 * i + 1].drawn;
        w->part[i].fragments = w->part[2 * i].fragments + w->part[2 * i + 1].fragments;
    }
    for (uint32_t i = 1; i < 2 * WORK_MOST && w->part[1].drawn > 0.0; ++i)
        w->part[i].rows = w->band[1].rows * w->part[i].drawn / w->part[1].drawn;
    w->whole = w->band[1];
}

/* Counts pictures of a turn: fragments and pixels; rows grow with the drawn triangles. */
static bool count_turn(counter *k)
{
    const work_share *whole = &k->result->whole;
    for (uint32_t i = 0; i < WORK_TURNS; ++i) {
        work_share *turn = &k->result->turn[i];
        gn_draw_statistics s;
        drawing *d = &k->model.d;
        if (!scale_model_turn(&k->model, i, WORK_TURNS) || drawing_draw(k->model.p.scene, d) != 0)
            return false;
        k->uniforms.clip_from_model = k->model.p.scene->draws[0].uniforms.light.clip_from_model;
        if (count(k, 0, k->model.p.scene->draws[0].mesh.count / 3, 0, SIDE, &s) != GN_OK)
            return fail("the turned model cannot be counted");
        turn->drawn = (double)s.drawn;
        turn->fragments = (double)s.samples_covered;
        turn->rows = whole->rows * turn->drawn / whole->drawn;
        for (size_t p = 0; p < (size_t)SIDE * SIDE; ++p)
            turn->covered += ((const float *)d->frame.depth)[p] < 1.0f;
    }
    return true;
}

static void enlarge(work_share *s, double scale)
{
    s->fragments *= scale * scale;
    s->covered *= scale * scale;
    s->rows *= scale;
    if (s->rows < s->drawn)
        s->rows = s->drawn;
}

static bool prepare(counter *k, const work_scene *which)
{
    if (!scale_model_make(which->level, SIDE, false, &k->model))
        return false;
    const scene_draw *draw = &k->model.p.scene->draws[0];
    k->uniforms.clip_from_model = draw->uniforms.light.clip_from_model;
    k->pipeline.raster.cull = draw->state.raster.cull;
    k->pipeline.depth.write_disabled = true;
    k->depth = gn_surface_bottom_up(k->model.d.frame.depth, GN_FORMAT_D32F, SIDE, SIDE);
    k->workspace.memory = k->model.d.workspace.memory;
    k->workspace.size = k->model.d.workspace.size;
    k->workspace.backend = k->model.d.workspace.backend;
    return gn_use_depth_only(&k->pipeline, &k->uniforms) == GN_OK || fail("depth cannot be drawn");
}

static bool count_all(counter *k)
{
    const uint32_t triangles = k->model.p.scene->draws[0].mesh.count / 3;
    gn_status status = count_parts(k);
    for (uint32_t i = 0; i < triangles && status == GN_OK; i += BLOCK)
        status = count_bands(k, i, triangles - i < BLOCK ? triangles - i : BLOCK, 1, SIDE);
    if (status != GN_OK)
        return fail(gn_status_text(status));
    if (!count_covered(k))
        return false;
    add_up(k->result);
    return count_turn(k);
}

bool work_count(const work_scene *which, work *result)
{
    counter k = {.result = result};
    memset(result, 0, sizeof *result);
    result->scene = *which;
    bool good = prepare(&k, which);
    if (good) {
        const gn_mesh *mesh = &k.model.p.scene->draws[0].mesh;
        result->vertices = mesh->vertex_count;
        result->triangles = mesh->count / 3.0;
        result->model_bytes = 40.0 * result->vertices + 12.0 * result->triangles;
        good = count_all(&k);
    }
    const double scale = (double)which->side / SIDE;
    enlarge(&result->whole, scale);
    for (uint32_t i = 1; i < 2 * WORK_MOST; ++i) {
        enlarge(&result->band[i], scale);
        enlarge(&result->part[i], scale);
    }
    for (uint32_t i = 0; i < WORK_TURNS; ++i)
        enlarge(&result->turn[i], scale);
    scale_model_free(&k.model);
    return good;
}

void work_level(const work *like, work *result)
{
    *result = *like;
    for (uint32_t i = 1; i < 2 * WORK_MOST; ++i) {
        uint32_t divisions = 1;
        while (2 * divisions <= i)
            divisions *= 2;
        const double n = divisions;
        const work_share *w = &like->whole;
        const work_share share = {w->drawn / n, w->rows / n, w->fragments / n, w->covered / n};
        result->band[i] = result->part[i] = share;
    }
    for (uint32_t i = 0; i < WORK_TURNS; ++i)
        result->turn[i] = like->whole;
}
