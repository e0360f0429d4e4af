/* Draws frames. */
#include "drawing.h"

#include <stdlib.h>
#include <string.h>

#include "report.h"

int drawing_allocate(const scene *s, gn_backend backend, drawing *result)
{
    memset(result, 0, sizeof *result);
    result->workspace.size = scene_workspace_size(s);
    result->workspace.backend = backend;
    result->workspace.memory = malloc(result->workspace.size);
    if (result->workspace.memory == NULL || !scene_frame_allocate(&result->frame, s))
        return report_fault("--size", "not enough memory for %ux%u pixels", (unsigned)s->width,
                            (unsigned)s->height);
    return 0;
}

int drawing_draw(const scene *s, drawing *d)
{
    const gn_status status = scene_draw_in_workspace(s, &d->frame, &d->workspace);
    return status == GN_OK ? 0 : report_fault("drawing", "%s", gn_status_text(status));
}

void drawing_free(drawing *d)
{
    free(d->workspace.memory);
    scene_frame_free(&d->frame);
    memset(d, 0, sizeof *d);
}

/* The image that is shown; with several samples, the resolved image. */
static size_t shown_row(const scene_frame *frame, uint32_t y)
{
    return ((size_t)frame->images * frame->height - 1 - y) * frame->width;
}

void drawing_color_row(const void *context, uint32_t y, uint8_t *row)
{
    const scene_frame *frame = context;
    const uint32_t *pixels = (const uint32_t *)frame->color + shown_row(frame, y);
    for (size_t x = 0; x < frame->width; ++x)
        for (size_t channel = 0; channel < 4; ++channel)
            row[4 * x + channel] = (uint8_t)(pixels[x] >> (8 * channel));
}

void drawing_depth_row(const void *context, uint32_t y, uint8_t *row)
{
    const scene_frame *frame = context;
    const float *pixels = (const float *)frame->depth + shown_row(frame, y);
    for (size_t x = 0; x < frame->width; ++x) {
        /* The surface holds 0 to 1, so this is at most 65535. */
        uint32_t grey = (uint32_t)((double)pixels[x] * 65535.0 + 0.5);
        row[2 * x] = (uint8_t)(grey >> 8);
        row[2 * x + 1] = (uint8_t)grey;
    }
}
