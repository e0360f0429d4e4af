/* Drawing a scene on both sides and with several workspaces, and comparing. */
#include "compare.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

/* The scene in a workspace of that size and on that back end, against `ours`. */
static bool compare_variant(const scene *s, size_t workspace, gn_backend backend,
                            comparison *result)
{
    scene_frame frame;
    if (!scene_frame_allocate(&frame, s))
        return false;
    result->status = scene_draw_library(s, &frame, workspace, backend);
    if (result->status == GN_OK && result->workspace.pixels == 0)
        result->workspace = scene_compare(s, &frame, &result->ours);
    scene_frame_free(&frame);
    return true;
}

/* Pixels of the reference that are not as a clear leaves them. */
static bool count_drawn(const scene *s, comparison *result)
{
    scene empty = *s;
    scene_frame frame;
    empty.draw_count = 0;
    if (!scene_frame_allocate(&frame, s))
        return false;
    result->status = scene_draw_library(&empty, &frame, 0, GN_BACKEND_AUTO);
    if (result->status == GN_OK)
        result->drawn = scene_compare(s, &frame, &result->theirs).pixels;
    scene_frame_free(&frame);
    return true;
}

bool compare_scene(const comparer *c, const scene *s, uint64_t number, comparison *result,
                   char *error, size_t error_size)
{
    memset(result, 0, sizeof *result);
    bool allocated =
        scene_frame_allocate(&result->ours, s) && scene_frame_allocate(&result->theirs, s);
    if (!allocated) {
        snprintf(error, error_size, "no memory for a frame of %" PRIu32 "x%" PRIu32, s->width,
                 s->height);
        return false;
    }
    result->status = scene_draw_library(s, &result->ours, 0, GN_BACKEND_AUTO);
    const size_t least = gn_workspace_size(0, GN_SHADER_VARYINGS);
    /* A batch more, or any number of bytes: whole meshes, parts of them, or one by one. */
    if (result->status == GN_OK && (c->small_workspaces || number % 3 == 0))
        allocated = compare_variant(s, least, GN_BACKEND_AUTO, result);
    if (result->status == GN_OK && allocated && (c->small_workspaces || number % 3 == 1))
        allocated =
            compare_variant(s, least + (size_t)(number * 619 % 20011), GN_BACKEND_AUTO, result);
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; b++)
        if (result->status == GN_OK && allocated && gn_backend_available((gn_backend)b))
            allocated = compare_variant(s, 0, (gn_backend)b, result);
    if (!allocated) {
        snprintf(error, error_size, "no memory for a frame of %" PRIu32 "x%" PRIu32, s->width,
                 s->height);
        return false;
    }
    if (result->status != GN_OK)
        return true;
    if (!reference_draw(c->reference, s, &result->theirs, error, error_size))
        return false;
    result->reference = scene_compare(s, &result->ours, &result->theirs);
    return count_drawn(s, result);
}

void compare_free(comparison *result)
{
    scene_frame_free(&result->ours);
    scene_frame_free(&result->theirs);
}

bool compare_fails(const comparer *c, const comparison *result)
{
    return result->status != GN_OK || result->workspace.pixels > 0 ||
           (c->coverage_only ? result->reference.coverage_pixels : result->reference.pixels) > 0;
}

uint64_t compare_count(const comparison *result)
{
    return result->reference.pixels + result->workspace.pixels + (result->status != GN_OK);
}

static void print_pixel(const scene_frame *f, size_t i)
{
    switch (f->color_format) {
    case GN_FORMAT_RGBA8: {
        const uint32_t p = ((const uint32_t *)f->color)[i];
        printf("color %3" PRIu32 " %3" PRIu32 " %3" PRIu32 " %3" PRIu32, p & 255, p >> 8 & 255,
               p >> 16 & 255, p >> 24);
        break;
    }
    case GN_FORMAT_RGBA32F: {
        const float *p = (const float *)f->color + 4 * i;
        printf("color %.9g %.9g %.9g %.9g", (double)p[0], (double)p[1], (double)p[2], (double)p[3]);
        break;
    }
    default:
        break;
    }
    switch (f->depth_format) {
    case GN_FORMAT_D16:
        printf(" depth %u", (unsigned)((const uint16_t *)f->depth)[i]);
        break;
    case GN_FORMAT_D24:
        printf(" depth %" PRIu32, ((const uint32_t *)f->depth)[i]);
        break;
    case GN_FORMAT_D32F:
        printf(" depth %.9g", (double)((const float *)f->depth)[i]);
        break;
    default:
        break;
    }
    printf("\n");
}

static bool same_bits(const void *a, const void *b, gn_format format, size_t i)
{
    const size_t size = gn_format_size(format);
    return size == 0 || memcmp((const char *)a + i * size, (const char *)b + i * size, size) == 0;
}

void compare_print_pixels(const comparison *result, uint64_t limit)
{
    const scene_frame *a = &result->ours, *b = &result->theirs;
    const size_t pixels = (size_t)a->width * a->height;
    for (size_t i = 0; i < pixels && limit > 0; i++) {
        if (same_bits(a->color, b->color, a->color_format, i) &&
            same_bits(a->depth, b->depth, a->depth_format, i))
            continue;
        printf("pixel (%zu, %zu)\n  ours      ", i % a->width, i / a->width);
        print_pixel(a, i);
        printf("  reference ");
        print_pixel(b, i);
        limit--;
    }
}
