/* Draws a scene with both sides, with several workspaces, back ends and numbers of threads, and
 * compares. */
#include "compare.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "scene_pixel.h"

bool compare_start(comparer *c)
{
    static const uint32_t threads[COMPARE_POOLS] = {1, 2, 3, 8};
    for (int i = 0; i < COMPARE_POOLS; ++i) {
        c->pools[i] = thread_pool_create(threads[i]);
        if (!c->pools[i])
            return false;
    }
    return true;
}

void compare_stop(comparer *c)
{
    for (int i = 0; i < COMPARE_POOLS; ++i)
        thread_pool_destroy(c->pools[i]);
}

/* One way to draw a scene. The pixels must not depend on it. */
typedef struct variant {
    size_t workspace; /* bytes; 0: scene_workspace_size */
    gn_backend backend;
    thread_pool *pool; /* null: only the calling thread */
    uint32_t threads;  /* the number of threads that the library is told to use */
} variant;

static bool same_bits(const void *a, const void *b, gn_format format, size_t i)
{
    const size_t size = gn_format_size(format);
    return size == 0 || memcmp((const char *)a + i * size, (const char *)b + i * size, size) == 0;
}

static bool same_pixels(const scene_frame *a, const scene_frame *b, size_t i)
{
    bool same = same_bits(a->depth, b->depth, a->depth_format, i);
    for (int c = 0; c < GN_MAX_COLORS; ++c)
        same = same && same_bits(scene_frame_color(a, c), scene_frame_color(b, c),
                                 scene_frame_format(a, c), i);
    return same;
}

/* Compares bit for bit: no step of sRGB and no other NaN is allowed here. */
static scene_difference compare_exactly(const scene_frame *a, const scene_frame *b)
{
    const size_t image = (size_t)a->width * a->height;
    scene_difference d = {0};
    for (size_t i = 0; i < image * a->images; ++i) {
        if (same_pixels(a, b, i) || d.pixels++ > 0)
            continue;
        d.x = (uint32_t)(i % a->width);
        d.y = (uint32_t)(i % image / a->width);
        d.image = (uint32_t)(i / image);
    }
    d.counts_differ = a->samples_passed != b->samples_passed ||
                      memcmp(&a->statistics, &b->statistics, sizeof a->statistics) != 0;
    d.pixels += d.counts_differ;
    return d;
}

/* Draws the scene in this way and compares with `ours`; keeps the first difference. Returns false
 * if there is not enough memory. */
static bool compare_variant(const scene *s, const variant *v, comparison *result,
                            scene_difference *difference)
{
    scene_frame frame;
    gn_workspace workspace = {0};
    if (result->status != GN_OK)
        return true;
    workspace.size = v->workspace ? v->workspace : scene_workspace_size(s);
    workspace.memory = malloc(workspace.size);
    workspace.backend = v->backend;
    workspace.parallel = v->pool ? thread_pool_run : NULL;
    workspace.user = v->pool;
    workspace.threads = v->threads;
    const bool allocated = scene_frame_allocate(&frame, s) && workspace.memory;
    if (allocated)
        result->status = scene_draw_in_workspace(s, &frame, &workspace);
    if (allocated && result->status == GN_OK && difference->pixels == 0) {
        *difference = compare_exactly(&frame, &result->ours);
        if (difference == &result->workspace)
            result->differing = v->backend;
    }
    free(workspace.memory);
    scene_frame_free(&frame);
    return allocated;
}

/* The least size and up to 20 kilobytes more: room for small meshes whole and for larger ones in
 * parts. */
static size_t odd_workspace(const scene *s, uint64_t number)
{
    return gn_workspace_size(0, scene_varyings(s)) + (size_t)(number * 619 % 20011);
}

static bool compare_workspaces(const comparer *c, const scene *s, uint64_t number,
                               comparison *result)
{
    const variant least = {gn_workspace_size(0, scene_varyings(s)), GN_BACKEND_AUTO, NULL, 0};
    const variant odd = {odd_workspace(s, number), GN_BACKEND_AUTO, NULL, 0};
    bool allocated = true;
    if (c->everything || number % 3 == 0)
        allocated = compare_variant(s, &least, result, &result->workspace);
    if (allocated && (c->everything || number % 3 == 1))
        allocated = compare_variant(s, &odd, result, &result->workspace);
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
        const variant whole = {0, (gn_backend)b, NULL, 0};
        if (allocated && gn_backend_available((gn_backend)b))
            allocated = compare_variant(s, &whole, result, &result->workspace);
    }
    return allocated;
}

/* The least size for several threads and up to 100 kilobytes more: from one segment to one round of
 * work. */
static size_t odd_threads_workspace(const scene *s, uint64_t number)
{
    return gn_workspace_size_parallel(0, 0, scene_varyings(s)) + (size_t)(number * 619 % 100003);
}

/* Chooses one number of threads for each scene. Of every four runs of four scenes, the last run has
 * an odd workspace. Every run of sixteen scenes has another back end, in turn. */
static bool compare_threads(const comparer *c, const scene *s, uint64_t number, comparison *result)
{
    const int backends = GN_BACKEND_COUNT - GN_BACKEND_PORTABLE;
    const gn_backend turn =
        (gn_backend)(GN_BACKEND_PORTABLE + (int)(number / 16 % (uint64_t)backends));
    bool allocated = true;
    for (uint64_t i = 0; i < COMPARE_POOLS; ++i) {
        const variant v = {number / COMPARE_POOLS % 4 == 3 ? odd_threads_workspace(s, number) : 0,
                           gn_backend_available(turn) ? turn : GN_BACKEND_AUTO, c->pools[i],
                           (uint32_t)(number / 2 % 4)};
        if (allocated && (c->everything || i == number % COMPARE_POOLS))
            allocated = compare_variant(s, &v, result, &result->threads);
    }
    return allocated;
}

/* Counts the pixels of the reference that differ from the clear value. */
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
    if (allocated) {
        result->status = scene_draw_library(s, &result->ours, 0, GN_BACKEND_AUTO);
        allocated =
            compare_workspaces(c, s, number, result) && compare_threads(c, s, number, result);
    }
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

bool compare_fails(const comparison *result)
{
    return result->status != GN_OK || result->workspace.pixels > 0 || result->threads.pixels > 0 ||
           result->reference.pixels > 0;
}

uint64_t compare_count(const comparison *result)
{
    return result->reference.pixels + result->workspace.pixels + result->threads.pixels +
           (result->status != GN_OK);
}

static void print_color(const void *color, gn_format format, size_t i)
{
    uint32_t channel[4];
    const int count = scene_pixel_channels(color, format, i, channel);

    printf(" color");
    for (int c = 0; c < count; ++c)
        printf(format == GN_FORMAT_RGBA8 ? " %3.9g" : " %.9g",
               scene_channel_value(format, c, channel[c]));
}

static void print_pixel(const scene_frame *f, size_t i)
{
    for (int a = 0; a < GN_MAX_COLORS; ++a)
        if (scene_frame_color(f, a))
            print_color(scene_frame_color(f, a), scene_frame_format(f, a), i);
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
    case GN_FORMAT_D24S8:
        printf(" depth %" PRIu32 " stencil %" PRIu32, ((const uint32_t *)f->depth)[i] & 0xFFFFFF,
               ((const uint32_t *)f->depth)[i] >> 24);
        break;
    case GN_FORMAT_D32FS8:
        printf(" depth %.9g stencil %" PRIu32, (double)((const float *)f->depth)[2 * i],
               ((const uint32_t *)f->depth)[2 * i + 1]);
        break;
    case GN_FORMAT_S8:
        printf(" stencil %u", ((const uint8_t *)f->depth)[i]);
        break;
    default:
        break;
    }
    printf("\n");
}

void compare_print_pixels(const comparison *result, uint64_t limit)
{
    const scene_frame *a = &result->ours, *b = &result->theirs;
    const size_t image = (size_t)a->width * a->height;
    const size_t pixels = image * a->images;
    for (size_t i = 0; i < pixels && limit > 0; ++i) {
        if (same_pixels(a, b, i))
            continue;
        printf("pixel (%zu, %zu)", i % a->width, i % image / a->width);
        if (a->images > 1 && i / image == GN_SAMPLES)
            printf(" resolved");
        else if (a->images > 1)
            printf(" sample %zu", i / image);
        printf("\n  ours     ");
        print_pixel(a, i);
        printf("  reference");
        print_pixel(b, i);
        --limit;
    }
}
