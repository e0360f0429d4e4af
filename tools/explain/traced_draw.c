/* Draws at one pixel with the tracing stages: first finds the primitives with fragments there, then
 * traces each of them alone, and last the primitive that was asked for, if it is none of them. */
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

/* Whether a scissor lets the pixel through. */
static bool lies_in_scissor(const gn_scissor *s)
{
    const int64_t x = pixel.x, y = pixel.y;

    return !s->enabled || (x >= s->x && y >= s->y && x - s->x < (int64_t)s->width &&
                           y - s->y < (int64_t)s->height);
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

/* How many vertices a primitive has; 0: the topology is not explained. */
static uint32_t corners_of(const gn_pipeline *pipeline)
{
    return pipeline->raster.topology == GN_TRIANGLES ? 3
           : pipeline->raster.topology == GN_LINES   ? 2
           : pipeline->raster.topology == GN_POINTS  ? 1
                                                     : 0;
}

uint32_t explain_primitives(const scene_draw *draw)
{
    const uint32_t corners = corners_of(&draw->state);

    return corners ? draw->mesh.count / corners : 0;
}

/* Traces one primitive of a list of triangles, lines or points. */
static gn_status trace_primitive(const gn_target *target, const gn_pipeline *pipeline,
                                 const gn_mesh *mesh, gn_workspace *workspace, uint32_t primitive)
{
    const uint32_t corners = corners_of(pipeline);
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

    if (!pixel.fragment_is_told && !pixel.is_missing)
        told_fault("a primitive has no fragment when it is traced alone", "");
    report_check_nodes();
    trace.is_recording = false;
    return status;
}

static const char *reason_of(const gn_draw_statistics *counts, bool in_scissor)
{
    return pixel.covers_alone     ? "it is culled in its draw: a vertex near it in the mesh lies "
                                    "outside the view volume, so the triangle is also culled by "
                                    "its winding before the vertices snapped"
           : counts->not_finite   ? "a coordinate is infinite or NaN, or too far outside the window"
           : counts->behind       ? "it lies behind the eye: no vertex has a w above 0"
           : counts->outside      ? "it lies outside the view volume, or on the side of a clip "
                                    "distance that is not drawn"
           : counts->without_area ? "it has no area after its vertices have snapped"
           : counts->culled       ? "it is culled for the way it faces"
           : counts->missed  ? "the smallest upright rectangle around it has no pixel's centre "
                               "in the picture and the scissor"
           : !in_scissor     ? "the scissor of its draw leaves out the pixel"
           : counts->clipped ? "what clipping leaves of it does not cover the pixel"
                             : "it does not cover the pixel";
}

/* Traces the primitive that was asked for, which has no fragment at the pixel, and tells why. It is
 * drawn with its own scissor, but without fragments. */
static gn_status trace_missing(const gn_target *target, const gn_pipeline *pipeline,
                               const gn_mesh *mesh, gn_workspace *workspace)
{
    static const char kind[3][9] = {"point", "line", "triangle"};
    const bool in_scissor = lies_in_scissor(&pipeline->raster.scissor);
    gn_draw_statistics counts = {0};
    gn_draw_statistics *const counter = workspace->statistics;

    workspace->statistics = &counts;
    pixel.is_missing = true;
    pixel.edges_hold = pixel.covers_alone = false;
    const gn_status status =
        trace_primitive(target, pipeline, mesh, workspace, pixel.asked.primitive);

    pixel.is_missing = false;
    workspace->statistics = counter;
    if (in_scissor && pixel.edges_hold && !pixel.covers_alone)
        told_fault("the edge functions decide otherwise than the library", "");
    report_missing(pixel.draw, pixel.asked.primitive, kind[corners_of(pipeline) - 1], pixel.shared,
                   reason_of(&counts, in_scissor));
    return status;
}

/* Whether the primitive that was asked for is one of this draw and was not found. */
static bool misses_asked(const gn_pipeline *pipeline, const gn_mesh *mesh)
{
    bool misses = pixel.is_asked && pixel.asked.draw == pixel.draw &&
                  pixel.asked.primitive < mesh->count / corners_of(pipeline);

    for (uint32_t i = 0; i < pixel.found_count; ++i)
        misses = misses && pixel.found[i] != pixel.asked.primitive;
    return misses;
}

gn_status traced_draw(const gn_target *target, const gn_pipeline *pipeline, const gn_mesh *mesh,
                      gn_workspace *workspace)
{
    uint64_t *const counter = workspace->samples_passed;
    gn_status status = GN_OK;
    gn_pipeline confined = *pipeline;
    pixel_words color, depth;

    if (corners_of(pipeline) == 0 || mesh->instance_count > 1 || mesh->restart != GN_RESTART_NONE)
        return GN_NOT_COMPILED;
    confined.raster.scissor = (gn_scissor){true, (int32_t)pixel.x, (int32_t)pixel.y, 1, 1};
    pixel.color = &target->color[0];
    pixel.depth = &target->depth;
    save(pixel.color, &color);
    save(pixel.depth, &depth);
    pixel.found_count = 0;
    trace.is_recording = false;
    workspace->samples_passed = 0;
    if (lies_in_scissor(&pipeline->raster.scissor)) {
        pixel.is_finding = true;
        status = stages_draw(target, &confined, mesh, workspace);
        pixel.is_finding = false;
        restore(pixel.color, &color);
        restore(pixel.depth, &depth);
    }
    for (uint32_t i = 0; i < pixel.found_count && status == GN_OK; ++i)
        status = trace_primitive(target, &confined, mesh, workspace, pixel.found[i]);
    if (status == GN_OK && misses_asked(pipeline, mesh))
        status = trace_missing(target, pipeline, mesh, workspace);
    workspace->samples_passed = counter;
    ++pixel.draw;
    return status;
}
