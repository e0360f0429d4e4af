/* Explains a pixel of a scene. */
#include "explain.h"

#include <stdlib.h>
#include <string.h>

#include "resolve.h"
#include "told.h"
#include "traced_scene.h"
#include "tracing.h"

/* Returns why a scene cannot be explained, or null. */
static const char *fault_of(const scene *s, uint32_t x, uint32_t y)
{
    if (x >= s->width || y >= s->height)
        return "the pixel lies outside the picture";
    if (s->color_format != GN_FORMAT_RGBA8)
        return "only pictures of 8 bits a channel are explained";
    if (s->depth_format != GN_FORMAT_D32F && s->depth_format != GN_FORMAT_D24 &&
        s->depth_format != GN_FORMAT_NONE)
        return "only depths of 24 and 32 bits are explained";
    for (size_t i = 0; i < s->draw_count; ++i)
        if (s->draws[i].shader >= SCENE_PHONG && s->draws[i].shader <= SCENE_SAMPLED)
            return "only pictures that the library's own shaders draw are explained";
    return NULL;
}

static uint32_t image_word(const scene_frame *frame, uint32_t image, uint32_t x, uint32_t y)
{
    uint32_t word;

    memcpy(&word,
           (const char *)frame->color +
               4 * (((size_t)image * frame->height + y) * frame->width + x),
           4);
    return word;
}

static uint32_t shown_word(const scene_frame *frame, uint32_t x, uint32_t y)
{
    return image_word(frame, frame->images - 1, x, y);
}

static gn_surface surface_in(const scene_frame *frame, void *memory, gn_format format,
                             uint32_t image)
{
    const size_t size = (size_t)frame->width * frame->height * gn_format_size(format);

    return gn_surface_bottom_up((char *)memory + size * image, format, frame->width, frame->height);
}

static gn_surface drawn_surface(const scene_frame *frame, void *memory, gn_format format)
{
    const gn_surface first = surface_in(frame, memory, format, 0);

    return frame->images > 1 ? gn_surface_multisampled(&first) : first;
}

/* Draws the scene with the tracing stages into a frame, whose other pixels are unspecified. */
static gn_status draw_traced(const scene *s, scene_frame *frame)
{
    gn_workspace workspace = {0};
    gn_target target;

    memset(&target, 0, sizeof target);
    target.color[0] = drawn_surface(frame, frame->color, s->color_format);
    if (s->depth_format != GN_FORMAT_NONE)
        target.depth = drawn_surface(frame, frame->depth, s->depth_format);
    workspace.size = scene_workspace_size(s);
    workspace.memory = malloc(workspace.size);
    if (!workspace.memory)
        return GN_WORKSPACE_TOO_SMALL;
    gn_status status = traced_scene_draw(s, &target, &workspace);

    if (status == GN_OK && frame->images > 1) {
        const gn_surface to = surface_in(frame, frame->color, s->color_format, GN_SAMPLES);

        status = gn_resolve(&to, &target.color[0]);
    }
    free(workspace.memory);
    return status;
}

/* How many rows above and below the pixel gn_draw draws; 0: the whole picture. The page's module
 * draws slowly. */
#if !defined(EXPLAIN_ROWS)
#define EXPLAIN_ROWS 0
#endif

/* Confines a draw to the rows around the pixel. */
static void confine_rows(gn_scissor *scissor)
{
    const int64_t low = (int64_t)pixel.y - EXPLAIN_ROWS, high = (int64_t)pixel.y + EXPLAIN_ROWS;
    const int64_t from = scissor->enabled && scissor->y > low ? scissor->y : low;
    const int64_t end = scissor->enabled && (int64_t)scissor->y + scissor->height < high
                            ? (int64_t)scissor->y + scissor->height
                            : high;

    if (EXPLAIN_ROWS == 0)
        return;
    *scissor = (gn_scissor){true, scissor->enabled ? scissor->x : 0, (int32_t)from,
                            scissor->enabled ? scissor->width : GN_MAX_SIZE,
                            end > from ? (uint32_t)(end - from) : 0};
}

/* Draws the scene with gn_draw, at least the rows around the pixel. */
static gn_status draw_ordinarily(const scene *s, scene_frame *frame)
{
    scene confined = *s;

    confined.draws = calloc(s->draw_count + 1, sizeof *s->draws);
    if (!confined.draws)
        return GN_WORKSPACE_TOO_SMALL;
    for (size_t i = 0; i < s->draw_count; ++i) {
        confined.draws[i] = s->draws[i];
        confine_rows(&confined.draws[i].state.raster.scissor);
    }
    const gn_status status = scene_draw_library(&confined, frame, 0, GN_BACKEND_AUTO);

    free(confined.draws);
    return status;
}

/* Compares the traced words with those of the ordinary drawing. */
static void compare(const scene_frame *drawn, const scene_frame *traced, explained *out)
{
    out->word = shown_word(traced, out->x, out->row);
    out->drawn_word = shown_word(drawn, out->x, out->row);
    for (uint32_t image = 0; image < traced->images; ++image) {
        const uint32_t word = image_word(traced, image, out->x, out->row);

        if (image < GN_SAMPLES)
            out->sample_word[image] = word;
        if (word != image_word(drawn, image, out->x, out->row))
            told_fault("the traced word is not the one that gn_draw stores", "");
    }
}

static const char *explain_frames(const scene *s, scene_frame *drawn, scene_frame *traced,
                                  explained *out)
{
    gn_status status = draw_ordinarily(s, drawn);

    if (status == GN_OK)
        status = draw_traced(s, traced);
    if (status == GN_NOT_COMPILED)
        return "only lists of triangles, lines and points, drawn once, are explained";
    if (status != GN_OK)
        return gn_status_text(status);
    compare(drawn, traced, out);
    if (traced->images > 1)
        tell_resolve(out->sample_word, GN_SAMPLES, out->word);
    if (trace.failed || told.failed || told.strings.failed)
        return "there is not enough memory";
    out->fragments = told.fragment_count;
    out->nodes = told.nodes;
    out->faults = told.faults;
    return NULL;
}

const char *explain_pixel(const scene *s, uint32_t x, uint32_t y, const explain_view *view,
                          const explain_primitive *asked, explained *out)
{
    const char *fault = fault_of(s, x, y);
    scene_frame drawn, traced;

    explain_free();
    memset(out, 0, sizeof *out);
    if (fault)
        return fault;
    out->x = pixel.x = x;
    out->y = y;
    out->row = pixel.y = view && view->y_down ? s->height - 1 - y : y;
    out->width = s->width;
    out->height = s->height;
    out->samples = scene_is_sampled(s) ? GN_SAMPLES : 1;
    pixel.has_view = view && view->is_known;
    if (pixel.has_view)
        pixel.view_from_world = view->view_from_world;
    pixel.scene = s;
    pixel.is_asked = asked != NULL;
    if (asked)
        pixel.asked = *asked;
    report_clear();
    memset(&drawn, 0, sizeof drawn);
    memset(&traced, 0, sizeof traced);
    fault = "there is not enough memory";
    if (scene_frame_allocate(&drawn, s) && scene_frame_allocate(&traced, s))
        fault = explain_frames(s, &drawn, &traced, out);
    scene_frame_free(&drawn);
    scene_frame_free(&traced);
    return fault;
}

void explain_free(void)
{
    report_free();
    graph_free();
    free(pixel.found);
    memset(&pixel, 0, sizeof pixel);
}
