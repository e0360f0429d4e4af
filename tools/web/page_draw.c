/* Draws the scene, whole or in bands, and hashes pictures. */
#include <stdlib.h>
#include <string.h>

#include "page_parts.h"
#include "page_text.h"

/* The memory of the picture, and of the draw. */
static scene_frame frame;
static gn_workspace workspace;

static uint32_t images_of(const scene *s)
{
    return scene_is_sampled(s) ? GN_SAMPLES + 1 : 1;
}

/* Allocates what the scene needs unless it is there. */
static int allocate(const scene *s)
{
    const size_t size = scene_workspace_size(s);
    const uint32_t images = images_of(s);
    if (workspace.size < size) {
        free(workspace.memory);
        workspace.memory = malloc(size);
        workspace.size = workspace.memory != NULL ? size : 0;
    }
    const bool fits = frame.color != NULL && frame.width == s->width && frame.height == s->height &&
                      frame.images == images;
    if (!fits)
        scene_frame_free(&frame);
    if (workspace.memory == NULL || (!fits && !scene_frame_allocate(&frame, s)))
        return page_fail("there is not enough memory for a picture of this size",
                         (const char *)NULL);
    return 0;
}

/* A surface whose memory holds the picture's lowest row first. If clip space's y points down, so
 * does the window's, and row 0 is the picture's uppermost. */
static gn_surface surface_of(const scene *s, void *memory, gn_format format, uint32_t number,
                             bool top_down)
{
    void *const first =
        (char *)memory + (size_t)number * s->width * s->height * gn_format_size(format);
    return top_down ? gn_surface_top_down(first, format, s->width, s->height)
                    : gn_surface_bottom_up(first, format, s->width, s->height);
}

/* A surface with all samples. */
static gn_surface drawn_surface(const scene *s, void *memory, gn_format format, bool top_down)
{
    const gn_surface first = surface_of(s, memory, format, 0, top_down);
    return scene_is_sampled(s) ? gn_surface_multisampled(&first) : first;
}

static void set_scissor(scene *s, bool set, uint32_t first, uint32_t count)
{
    for (size_t i = 0; i < s->draw_count; ++i)
        s->draws[i].state.raster.scissor = (gn_scissor){set, 0, (int32_t)first, s->width, count};
}

static gn_status clear(const scene *s, const gn_target *target, uint32_t first, uint32_t count)
{
    const gn_surface color = gn_surface_rows(&target->color[0], first, count);
    const gn_surface depth = gn_surface_rows(&target->depth, first, count);
    const float *const c = s->clear_color;
    const gn_status status = gn_clear_color(&color, c[0], c[1], c[2], c[3]);
    return status == GN_OK ? gn_clear_depth(&depth, s->clear_depth) : status;
}

/* Resolves rows of a surface into the last image of its memory. */
static gn_status resolve(const scene *s, const gn_surface *from, void *memory, uint32_t first,
                         uint32_t count, bool top_down)
{
    const gn_surface to = surface_of(s, memory, from->format, GN_SAMPLES, top_down);
    const gn_surface rows = gn_surface_rows(&to, first, count);
    const gn_surface samples = gn_surface_rows(from, first, count);
    return gn_resolve(&rows, &samples);
}

/* Draws rows of the window. */
static gn_status draw_rows(scene *s, uint32_t first, uint32_t count, bool top_down)
{
    gn_target target;
    memset(&target, 0, sizeof target);
    target.color[0] = drawn_surface(s, frame.color, s->color_format, top_down);
    target.depth = drawn_surface(s, frame.depth, s->depth_format, top_down);
    gn_status status = clear(s, &target, first, count);
    /* The copy has no formats, so that drawing it clears nothing. */
    scene drawn = *s;
    drawn.color_format = drawn.depth_format = GN_FORMAT_NONE;
    set_scissor(s, count < s->height, first, count);
    if (status == GN_OK)
        status = scene_draw_to_target(&drawn, &target, &workspace);
    set_scissor(s, false, 0, 0);
    if (status == GN_OK && scene_is_sampled(s))
        status = resolve(s, &target.color[0], frame.color, first, count, top_down);
    if (status == GN_OK && scene_is_sampled(s))
        status = resolve(s, &target.depth, frame.depth, first, count, top_down);
    return status;
}

/* Where the image begins that is shown. */
static size_t shown(void)
{
    return (size_t)(frame.images - 1) * frame.width * frame.height;
}

/* Puts a colour's bytes in the order red, green, blue, alpha, whatever the machine's is. */
static void order_bytes(uint32_t from, uint32_t end)
{
    const uint32_t one = 1;
    if (*(const uint8_t *)&one == 1)
        return;
    uint32_t *const pixels = (uint32_t *)frame.color + shown();
    for (size_t i = (size_t)from * frame.width; i < (size_t)end * frame.width; ++i) {
        const uint32_t p = pixels[i];
        pixels[i] = p >> 24 | (p >> 8 & 0xff00) | (p << 8 & 0xff0000) | p << 24;
    }
}

int page_draw(uint32_t from, uint32_t end)
{
    scene *const s = page_built();
    page_begin();
    if (s == NULL)
        return page_fail("there is no scene to draw: page_build comes first", (const char *)NULL);
    if (from >= end || end > s->height)
        return page_fail("the rows to draw are not those of the picture", (const char *)NULL);
    if (allocate(s) != 0)
        return 1;
    const bool top_down = page_camera()->y_down;
    const uint32_t first = top_down ? s->height - end : from;
    workspace.backend = page_used_backend();
    const gn_status status = draw_rows(s, first, end - from, top_down);
    if (status != GN_OK)
        return page_fail("drawing: ", gn_status_text(status), (const char *)NULL);
    order_bytes(from, end);
    return 0;
}

uint32_t page_width(void)
{
    return page_settings_now()->options.width;
}

uint32_t page_height(void)
{
    return page_settings_now()->options.height;
}

const uint8_t *page_color(void)
{
    return frame.color != NULL ? (const uint8_t *)frame.color + 4 * shown() : NULL;
}

const float *page_depth(void)
{
    return frame.depth != NULL ? (const float *)frame.depth + shown() : NULL;
}

static uint64_t add_bytes(uint64_t hash, const uint8_t *bytes, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        hash = (hash ^ bytes[i]) * UINT64_C(0x100000001b3);
    return hash;
}

const char *page_hash(const uint8_t *color, uint32_t width, uint32_t height)
{
    static char digits[17];
    const uint32_t sizes[2] = {width, height};
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (int i = 0; i < 2; ++i) {
        uint8_t bytes[4];
        for (int b = 0; b < 4; ++b)
            bytes[b] = (uint8_t)(sizes[i] >> 8 * b);
        hash = add_bytes(hash, bytes, sizeof bytes);
    }
    hash = add_bytes(hash, color, (size_t)4 * width * height);
    for (int i = 0; i < 16; ++i)
        digits[i] = "0123456789abcdef"[hash >> (60 - 4 * i) & 15];
    return digits;
}

const char *page_backend(void)
{
    return gn_backend_name(page_used_backend());
}

const char *page_version(void)
{
    static text t;
    const uint32_t version = gn_version();
    text_clear(&t);
    text_add_whole(&t, version / 1000000);
    text_add(&t, ".");
    text_add_whole(&t, version / 1000 % 1000);
    text_add(&t, ".");
    text_add_whole(&t, version % 1000);
    return text_of(&t);
}
