/* Rows of one target: dividing them, their memory, and drawing them. */
#define _DEFAULT_SOURCE
#include "bands.h"

#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

/* Row 0 of unit n, within the picture. */
static uint32_t first_of_unit(uint32_t height, uint32_t unit, uint64_t n)
{
    const uint64_t row = n * unit;
    const uint64_t first = row > band_shift(height) ? row - band_shift(height) : 0;
    return first < height ? (uint32_t)first : height;
}

row_range band_of_units(uint32_t height, uint32_t unit, uint64_t first, uint64_t end)
{
    const uint32_t row = first_of_unit(height, unit, first);
    return (row_range){row, first_of_unit(height, unit, end) - row};
}

row_range band_of_rank(uint32_t height, uint32_t unit, uint32_t number, uint32_t count)
{
    const uint64_t units = ((uint64_t)height + band_shift(height) + unit - 1) / unit;
    return band_of_units(height, unit, units * number / count, units * (number + 1) / count);
}

static size_t frame_bytes(const scene_frame *frame, gn_format format)
{
    return (size_t)frame->width * frame->height * frame->images * gn_format_size(format);
}

/* Sets *memory; null for no format. */
static bool reserve(const scene_frame *frame, gn_format format, void **memory)
{
    const size_t size = frame_bytes(frame, format);
    *memory = NULL;
    if (size == 0)
        return true;
    void *const result = mmap(NULL, size, PROT_READ | PROT_WRITE,
                              MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (result == MAP_FAILED)
        return false;
    *memory = result;
    return true;
}

bool band_frame_reserve(scene_frame *frame, const scene *s)
{
    memset(frame, 0, sizeof *frame);
    frame->width = s->width;
    frame->height = s->height;
    frame->images = scene_is_sampled(s) ? GN_SAMPLES + 1 : 1;
    frame->color_format = s->color_format;
    frame->depth_format = s->depth_format;
    bool good = reserve(frame, s->color_format, &frame->color) &&
                reserve(frame, s->depth_format, &frame->depth);
    for (int a = 0; a < GN_MAX_COLORS - 1; ++a) {
        frame->more_formats[a] = s->more_colors[a];
        good = good && reserve(frame, s->more_colors[a], &frame->more_colors[a]);
    }
    if (!good)
        band_frame_release(frame);
    return good;
}

void band_frame_release(scene_frame *frame)
{
    for (int a = 0; a < GN_MAX_COLORS; ++a)
        if (scene_frame_color(frame, a) != NULL)
            munmap(scene_frame_color(frame, a), frame_bytes(frame, scene_frame_format(frame, a)));
    if (frame->depth != NULL)
        munmap(frame->depth, frame_bytes(frame, frame->depth_format));
    memset(frame, 0, sizeof *frame);
}

static void forget(const scene_frame *frame, gn_format format, void *memory, row_range rows)
{
    const size_t page = (size_t)sysconf(_SC_PAGESIZE), row = frame->width * gn_format_size(format);
    for (size_t i = 0; memory != NULL && i < frame->images; ++i) {
        const size_t lowest = (i + 1) * frame->height - rows.first - rows.count;
        const size_t begin = (lowest * row + page - 1) / page * page;
        const size_t end = (lowest + rows.count) * row / page * page;
        if (begin < end)
            madvise((char *)memory + begin, end - begin, MADV_DONTNEED);
    }
}

void band_frame_forget(scene_frame *frame, row_range rows)
{
    for (int a = 0; a < GN_MAX_COLORS; ++a)
        forget(frame, scene_frame_format(frame, a), scene_frame_color(frame, a), rows);
    forget(frame, frame->depth_format, frame->depth, rows);
}

/* One image of a frame's memory, and all samples of it. */
static gn_surface image_of(const scene *s, void *memory, gn_format format, uint32_t number)
{
    const size_t size = (size_t)s->width * s->height * gn_format_size(format);
    return gn_surface_bottom_up((char *)memory + size * number, format, s->width, s->height);
}

static gn_surface surface_of(const scene *s, void *memory, gn_format format)
{
    const gn_surface first = image_of(s, memory, format, 0);
    return scene_is_sampled(s) ? gn_surface_multisampled(&first) : first;
}

static gn_target target_of(const scene *s, const scene_frame *frame)
{
    gn_target target;
    memset(&target, 0, sizeof target);
    for (int a = 0; a < GN_MAX_COLORS; ++a)
        if (scene_color_format(s, a) != GN_FORMAT_NONE)
            target.color[a] = surface_of(s, scene_frame_color(frame, a), scene_color_format(s, a));
    if (s->depth_format != GN_FORMAT_NONE)
        target.depth = surface_of(s, frame->depth, s->depth_format);
    return target;
}

/* Rows of the window, counted from its lower edge. */
static uint32_t lowest_of(const scene *s, row_range rows)
{
    return s->height - rows.first - rows.count;
}

/* Clears rows, in the formats of `s`, to its clear values. */
static gn_status clear(const scene *s, const gn_target *target, uint32_t first, uint32_t count)
{
    const float *const c = s->clear_color;
    gn_status status = GN_OK;
    for (int a = 0; status == GN_OK && a < GN_MAX_COLORS; ++a) {
        const gn_surface rows = gn_surface_rows(&target->color[a], first, count);
        if (scene_color_format(s, a) != GN_FORMAT_NONE)
            status = gn_clear_color(&rows, c[0], c[1], c[2], c[3]);
    }
    if (status == GN_OK && s->depth_format != GN_FORMAT_NONE) {
        const gn_surface rows = gn_surface_rows(&target->depth, first, count);
        status = gn_clear_depth_stencil(&rows, s->clear_depth, s->clear_stencil);
    }
    return status;
}

/* The part of a scissor that lies in these rows. */
static gn_scissor cut(const scene *s, const gn_scissor *own, uint32_t first, uint32_t count)
{
    gn_scissor result = {true, 0, (int32_t)first, s->width, count};
    if (!own->enabled)
        return result;
    const int64_t own_end = (int64_t)own->y + own->height;
    const int64_t end = (int64_t)first + count;
    const int64_t from = own->y > (int64_t)first ? own->y : (int64_t)first;
    const int64_t to = own_end < end ? own_end : end;
    result = *own;
    result.y = (int32_t)from;
    result.height = to > from ? (uint32_t)(to - from) : 0;
    if (result.height == 0)
        result.y = (int32_t)first;
    return result;
}

gn_status band_draw(const scene *s, row_range rows, scene_frame *frame, gn_workspace *workspace)
{
    const gn_target target = target_of(s, frame);
    const uint32_t first = lowest_of(s, rows);
    if (rows.count == 0)
        return GN_OK;
    gn_status status = clear(s, &target, first, rows.count);
    for (size_t i = 0; status == GN_OK && i < s->draw_count; ++i) {
        const scene cleared = scene_of_clear(s, &s->draws[i]);
        status = clear(&cleared, &target, first, rows.count);
        /* A scene without formats, so that drawing it clears nothing. */
        scene one = *s;
        scene_draw draw = s->draws[i];
        memset(&draw.clear, 0, sizeof draw.clear);
        draw.state.raster.scissor = cut(s, &draw.state.raster.scissor, first, rows.count);
        one.color_format = one.depth_format = GN_FORMAT_NONE;
        memset(one.more_colors, 0, sizeof one.more_colors);
        one.draws = &draw;
        one.draw_count = 1;
        if (status == GN_OK)
            status = scene_draw_to_target(&one, &target, workspace);
    }
    return status;
}

static gn_status resolve(const scene *s, row_range rows, const gn_surface *from, void *memory)
{
    const uint32_t first = lowest_of(s, rows);
    const gn_surface to = image_of(s, memory, from->format, GN_SAMPLES);
    const gn_surface resolved = gn_surface_rows(&to, first, rows.count);
    const gn_surface samples = gn_surface_rows(from, first, rows.count);
    return gn_resolve(&resolved, &samples);
}

gn_status band_resolve(const scene *s, row_range rows, scene_frame *frame)
{
    const gn_target target = target_of(s, frame);
    gn_status status = GN_OK;
    if (!scene_is_sampled(s) || rows.count == 0)
        return GN_OK;
    for (int a = 0; status == GN_OK && a < GN_MAX_COLORS; ++a)
        if (scene_color_format(s, a) != GN_FORMAT_NONE)
            status = resolve(s, rows, &target.color[a], scene_frame_color(frame, a));
    if (status == GN_OK && s->depth_format != GN_FORMAT_NONE)
        status = resolve(s, rows, &target.depth, frame->depth);
    return status;
}
