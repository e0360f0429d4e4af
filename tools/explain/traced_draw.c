/* Draws at one pixel with the tracing stages: first finds the primitives with fragments there, then
 * traces each of them alone. */
#include <stdlib.h>
#include <string.h>

#include "stages.h"
#include "traced_scene.h"
#include "tracing.h"

/* The words of the pixel on a surface, for each sample. */
typedef struct pixel_words {
    uint32_t word[GN_SAMPLES];
} pixel_words;

static unsigned char *word_at(const gn_surface *surface, uint32_t sample)
{
    return (unsigned char *)surface->pixels + (ptrdiff_t)surface->row_stride * (ptrdiff_t)pixel.y +
           (size_t)pixel.x * 4 + (size_t)surface->sample_stride * sample;
}

static uint32_t samples_on(const gn_surface *surface)
{
    return !surface->pixels ? 0 : surface->sample_stride ? GN_SAMPLES : 1;
}

static void save(const gn_surface *surface, pixel_words *words)
{
    for (uint32_t s = 0; s < samples_on(surface); ++s)
        memcpy(&words->word[s], word_at(surface, s), 4);
}

static void restore(const gn_surface *surface, const pixel_words *words)
{
    for (uint32_t s = 0; s < samples_on(surface); ++s)
        memcpy(word_at(surface, s), &words->word[s], 4);
}

/* Confines a draw to the pixel. Returns false if its own scissor excludes the pixel. */
static bool confine(gn_scissor *scissor)
{
    const gn_scissor own = *scissor;
    const int64_t x = pixel.x, y = pixel.y;

    *scissor = (gn_scissor){true, (int32_t)pixel.x, (int32_t)pixel.y, 1, 1};
    return !own.set || (x >= own.x && y >= own.y && x - own.x < (int64_t)own.width &&
                        y - own.y < (int64_t)own.height);
}

static uint32_t index_at(const gn_mesh *mesh, uint32_t n)
{
    switch (mesh->index_format) {
    case GN_INDEX_UINT8:
        return ((const uint8_t *)mesh->indices)[n] + (uint32_t)mesh->base_vertex;
    case GN_INDEX_UINT16:
        return ((const uint16_t *)mesh->indices)[n] + (uint32_t)mesh->base_vertex;
    case GN_INDEX_UINT32:
        return ((const uint32_t *)mesh->indices)[n] + (uint32_t)mesh->base_vertex;
    default:
        return n;
    }
}

/* Traces one primitive of a list of triangles, lines or points. */
static gn_status trace_primitive(const gn_target *target, const gn_pipeline *pipeline,
                                 const gn_mesh *mesh, gn_workspace *workspace, uint32_t primitive,
                                 uint32_t corners)
{
    gn_mesh one = *mesh;

    one.first += primitive * corners;
    one.count = corners;
    pixel.primitive = primitive;
    pixel.corners = corners;
    for (uint32_t i = 0; i < corners; ++i)
        pixel.vertex[i] = index_at(&one, one.first + i);
    graph_clear();
    trace.is_recording = true;
    pixel.shared = told.stage_count;
    pixel.fragment_is_told = false;
    told.steps = 0;
    names_of_draw(pipeline);
    if (pixel.has_view) {
        pixel.world_from_model = pixel.scene->draws[pixel.draw].surface.world_from_model;
        names_add_world(&pixel.world_from_model, &pixel.view_from_world);
    }
    const gn_status status = stages_draw(target, pipeline, &one, workspace);

    if (!pixel.fragment_is_told)
        told_fault("a primitive has no fragment when it is traced alone", "");
    report_check_nodes();
    trace.is_recording = false;
    return status;
}

gn_status traced_draw(const gn_target *target, const gn_pipeline *pipeline, const gn_mesh *mesh,
                      gn_workspace *workspace)
{
    const uint32_t corners = pipeline->raster.topology == GN_TRIANGLES ? 3
                             : pipeline->raster.topology == GN_LINES   ? 2
                             : pipeline->raster.topology == GN_POINTS  ? 1
                                                                       : 0;
    uint64_t *const counter = workspace->samples_passed;
    gn_pipeline confined = *pipeline;
    pixel_words color, depth;

    if (corners == 0 || mesh->instance_count > 1 || mesh->restart != GN_RESTART_NONE)
        return GN_NOT_COMPILED;
    if (!confine(&confined.raster.scissor)) {
        ++pixel.draw;
        return GN_OK;
    }
    pixel.color = &target->color[0];
    pixel.depth = &target->depth;
    save(pixel.color, &color);
    save(pixel.depth, &depth);
    pixel.found_count = 0;
    pixel.is_finding = true;
    trace.is_recording = false;
    workspace->samples_passed = 0;
    gn_status status = stages_draw(target, &confined, mesh, workspace);

    pixel.is_finding = false;
    restore(pixel.color, &color);
    restore(pixel.depth, &depth);
    for (uint32_t i = 0; i < pixel.found_count && status == GN_OK; ++i)
        status = trace_primitive(target, &confined, mesh, workspace, pixel.found[i], corners);
    workspace->samples_passed = counter;
    ++pixel.draw;
    return status;
}
