/* Draws in every way that must not make a difference. */
#include <stdlib.h>
#include <string.h>

#include "draw_input.h"

/* The status that the checks promise for a draw with this workspace. */
static gn_status expected_status(const draw_input *d, const gn_workspace *w)
{
    const gn_program *const program = &d->pipeline.program;
    const gn_status target = gn_target_check(&d->target);
    const gn_status pipeline = gn_pipeline_check(&d->pipeline, &d->target);
    const gn_status mesh = gn_mesh_check(&d->mesh);

    if (target != GN_OK)
        return target;
    if (pipeline != GN_OK)
        return pipeline;
    /* Indices are looked at last. */
    if (mesh != GN_OK && !(mesh == GN_INDEX_OUT_OF_RANGE && d->mesh.index_format != GN_INDEX_NONE))
        return mesh;
    if (!w->memory)
        return GN_NULL_POINTER;
    if (w->size < gn_workspace_size(0, program->varying_count + program->clip_distance_count))
        return GN_WORKSPACE_TOO_SMALL;
    if (w->backend != GN_BACKEND_AUTO && !gn_backend_available(w->backend))
        return GN_BACKEND_UNAVAILABLE;
    return mesh;
}

/* Draws with a workspace whose memory is allocated here, `shift` bytes off its alignment. */
static gn_status draw(draw_input *d, gn_workspace *w, size_t shift, gn_draw_statistics *counts,
                      uint64_t *passed)
{
    unsigned char *const memory = fuzz_memory(w->size + shift);

    memset(counts, 0, sizeof *counts);
    *passed = 0;
    w->memory = memory ? memory + shift : NULL;
    const gn_status expected = expected_status(d, w);
    const char *const words = gn_draw_fault(&d->target, &d->pipeline, &d->mesh, w);
    const gn_status status = gn_draw(&d->target, &d->pipeline, &d->mesh, w);

    FUZZ_REQUIRE(status == expected);
    FUZZ_REQUIRE((status == GN_OK) == (words == NULL));
    if (status == GN_WORKSPACE_TOO_SMALL)
        FUZZ_REQUIRE(w->size_needed > w->size);
    free(memory);
    return status;
}

static void require_sound(const gn_draw_statistics *n)
{
    FUZZ_REQUIRE(n->primitives ==
                 n->not_finite + n->outside + n->without_area + n->culled + n->missed + n->drawn);
    FUZZ_REQUIRE(n->behind <= n->outside && n->clipped <= n->drawn);
    FUZZ_REQUIRE(n->samples_passed <= n->samples_covered);
}

/* Whether a draw with this status has written only where it may. A draw that succeeds into samples
 * which share memory is not held to it. */
static bool writes_inside(const draw_input *d, gn_status status)
{
    const gn_scissor *const scissor = &d->pipeline.raster.scissor;
    const uint32_t colors = d->pipeline.program.color_count ? d->pipeline.program.color_count : 1;
    const int64_t x = scissor->enabled ? scissor->x : 0, y = scissor->enabled ? scissor->y : 0;
    const int64_t right = scissor->enabled ? x + scissor->width : INT32_MAX;
    const int64_t top = scissor->enabled ? y + scissor->height : INT32_MAX;

    for (uint32_t i = 0; i <= GN_MAX_COLORS; ++i) {
        const surface_input *const s = &d->surface[i];
        const bool is_written = status == GN_OK && (i == GN_MAX_COLORS || i < colors);
        const uint32_t kept = s->surface.samples > 1 ? d->pipeline.samples.write_disabled : 0;

        /* A sample that lies in another's memory is written with it. */
        if (!surface_holds_outside(s, x, y, right, is_written ? top : y,
                                   s->overlaps ? 15 : ~kept) &&
            !(s->overlaps && is_written))
            return false;
    }
    return true;
}

/* The most vertices of a mesh. */
#define MOST_VERTICES 64

/* One way to draw. */
typedef struct way {
    gn_backend backend;
    size_t size, shift;
    bool in_tasks, counted;
    uint32_t order, threads;
} way;

static gn_status draw_in(draw_input *d, const way *how, gn_draw_statistics *counts,
                         uint64_t *passed)
{
    uint32_t order = how->order;
    gn_workspace w = {.size = how->size, .backend = how->backend, .threads = how->threads};

    if (how->in_tasks) {
        w.parallel = fuzz_run_tasks;
        w.user = &order;
    }
    if (how->counted) {
        w.statistics = counts;
        w.samples_passed = passed;
    }
    for (int i = 0; i <= GN_MAX_COLORS; ++i)
        surface_restore(&d->surface[i]);
    const gn_status status = draw(d, &w, how->shift, counts, passed);

    FUZZ_REQUIRE(writes_inside(d, status));
    return status;
}

static bool is_ordered(const draw_input *d)
{
    for (int i = 0; i <= GN_MAX_COLORS; ++i)
        if (d->surface[i].overlaps)
            return false;
    return true;
}

void draw_everywhere(fuzz_input *in, draw_input *d)
{
    const gn_program *const program = &d->pipeline.program;
    const uint32_t varyings = program->varying_count + program->clip_distance_count;
    const size_t least = gn_workspace_size(0, varyings);
    const size_t whole = gn_workspace_size_parallel(MOST_VERTICES, MOST_VERTICES, varyings);
    const uint8_t kind = fuzz_byte(in);
    gn_draw_statistics expected, counts;
    uint64_t expected_passed, passed;
    const bool fits = least < SIZE_MAX;
    way how = {
        GN_BACKEND_PORTABLE, fits ? least + MOST_VERTICES * 200 : 1024, 0, false, true, 0, 0};
    const gn_status status = draw_in(d, &how, &expected, &expected_passed);

    if (status != GN_OK) {
        how.size = fuzz_below(in, 4096);
        how.backend = (gn_backend)fuzz_below(in, 256);
        how.backend = gn_backend_available(how.backend) ? how.backend : GN_BACKEND_COUNT;
        draw_in(d, &how, &counts, &passed);
        return;
    }
    require_sound(&expected);
    FUZZ_REQUIRE(expected.samples_passed == expected_passed);

    unsigned char *drawn[GN_MAX_COLORS + 1];

    for (int i = 0; i <= GN_MAX_COLORS; ++i)
        drawn[i] = surface_copy(&d->surface[i]);
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
        if (!gn_backend_available((gn_backend)b))
            continue;
        /* The least memory, all of it, or between; on the thread or in tasks; counted or not. */
        const uint32_t turn = (uint32_t)b + kind;

        how.backend = (gn_backend)b;
        how.in_tasks = turn & 1;
        how.size = turn & 2       ? least
                   : how.in_tasks ? whole / (1 + (kind >> 4 & 3))
                                  : least + kind * 97u;
        how.size = how.size < least ? least : how.size;
        how.shift = turn & 4 ? kind >> 3 & 15 : 0;
        how.counted = turn & 8;
        how.order = kind;
        how.threads = turn >> 1 & 3;
        FUZZ_REQUIRE(draw_in(d, &how, &counts, &passed) == GN_OK);
        if (how.counted)
            FUZZ_REQUIRE(!memcmp(&expected, &counts, sizeof counts) && passed == expected_passed);
        for (int i = 0; i <= GN_MAX_COLORS && is_ordered(d); ++i)
            FUZZ_REQUIRE(!drawn[i] || !memcmp(drawn[i], d->surface[i].memory, d->surface[i].size));
    }

    /* A byte less than the least is refused. */
    how.size = least - 1;
    FUZZ_REQUIRE(draw_in(d, &how, &counts, &passed) == GN_WORKSPACE_TOO_SMALL);
    for (int i = 0; i <= GN_MAX_COLORS; ++i)
        free(drawn[i]);
}
