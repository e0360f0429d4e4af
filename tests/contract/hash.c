/* Hashes of scenes and of frames. */
#include "contract.h"

#include <stdlib.h>
#include <string.h>

#include "scene_members.h"
#include "scene_pixel.h"

void contract_add(hash *h, uint64_t value)
{
    add_word(h, (uint32_t)value);
    add_word(h, (uint32_t)(value >> 32));
}

static void add_text(hash *h, const char *text)
{
    for (; *text; ++text)
        add_byte(h, (unsigned char)*text);
    add_byte(h, 0);
}

/* Members with default values are left out, so that a new member leaves hashes of scenes that do
 * not use it unchanged. */
static void add_member(hash *h, const scene_member *m, const scene_draw *d,
                       const scene_draw *by_default)
{
    for (size_t line = 0; line < scene_member_lines(m); ++line)
        for (size_t v = 0; v < scene_member_values(m); ++v) {
            const uint32_t word = scene_member_get(m, d, line, v);
            char name[SCENE_MEMBER_NAME];
            if (word == scene_member_get(m, by_default, line, v))
                continue;
            scene_member_name(m, line, name);
            add_text(h, name);
            add_word(h, (uint32_t)v);
            if (m->type == MEMBER_FLOAT)
                add_float_bits(h, word);
            else
                add_word(h, word);
        }
}

static void add_texture(hash *h, const gn_texture *t)
{
    const size_t size = scene_element_size(t->format);
    add_text(h, text_name(TEXT_TEXTURE_TARGET, (int)t->target));
    add_text(h, text_name(TEXT_FORMAT, (int)t->format));
    for (uint32_t n = 0; n < scene_level_count(t); ++n) {
        const scene_extent e = scene_level_extent(t, n);
        const gn_texture_level *const level = &t->level[n];
        const size_t elements = e.width * gn_format_size(t->format) / size;
        add_word(h, e.width);
        add_word(h, e.height);
        add_word(h, e.layers);
        for (uint32_t row = 0; row < e.height * e.layers; ++row) {
            const char *const texels = (const char *)level->texels +
                                       (ptrdiff_t)(row / e.height) * level->layer_stride +
                                       (ptrdiff_t)(row % e.height) * level->row_stride;
            for (size_t i = 0; i < elements; ++i)
                add_word(h, scene_element(texels, size, i));
        }
    }
}

static void add_attribute(hash *h, const gn_attribute *a, uint32_t vertices)
{
    const size_t stride = a->stride ? a->stride : a->components * sizeof(float);
    add_word(h, a->components);
    for (uint32_t v = 0; v < vertices; ++v) {
        const float *const values =
            (const float *)(const void *)((const char *)a->data + v * stride);
        for (uint32_t i = 0; i < a->components; ++i)
            add_floats(h, &values[i], sizeof values[i]);
    }
}

static void add_mesh(hash *h, const scene_draw *d)
{
    const gn_mesh *const mesh = &d->mesh;
    add_word(h, mesh->vertex_count);
    for (int a = 0; a < text_name_count(TEXT_ATTRIBUTE); ++a)
        if (mesh->attribute[a].data) {
            add_text(h, text_name(TEXT_ATTRIBUTE, a));
            add_attribute(h, &mesh->attribute[a], mesh->vertex_count);
        }
    if (mesh->indices) {
        add_text(h, text_name(TEXT_INDEX, (int)mesh->index_format));
        add_word(h, d->index_count);
        for (uint32_t i = 0; i < d->index_count; ++i)
            add_word(h, scene_vertex_of(mesh, i));
    }
    add_word(h, mesh->first);
    add_word(h, mesh->count);
}

static void add_draw(hash *h, const scene_draw *d)
{
    scene_draw by_default;
    scene_default_draw(&by_default);
    add_text(h, text_name(TEXT_SHADER, (int)d->shader));
    for (size_t i = 0; i < scene_member_count; ++i)
        if (scene_members[i].type != MEMBER_ELSEWHERE)
            add_member(h, &scene_members[i], d, &by_default);
    if (d->uniforms.texture.level[0].texels)
        add_texture(h, &d->uniforms.texture);
    for (int m = 0; m < SCENE_MAP_COUNT; ++m)
        if (d->surface.map[m].level[0].texels) {
            add_text(h, text_name(TEXT_MAP, m));
            add_texture(h, &d->surface.map[m]);
        }
    add_mesh(h, d);
}

uint32_t contract_hash_scene(const scene *s)
{
    hash h = HASH_EMPTY;
    add_word(&h, s->width);
    add_word(&h, s->height);
    for (int a = 0; a < GN_MAX_COLORS; ++a)
        add_text(&h, text_name(TEXT_FORMAT, (int)scene_color_format(s, a)));
    add_text(&h, text_name(TEXT_FORMAT, (int)s->depth_format));
    for (int c = 0; c < 4; ++c)
        add_floats(&h, &s->clear_color[c], sizeof s->clear_color[c]);
    add_floats(&h, &s->clear_depth, sizeof s->clear_depth);
    add_word(&h, s->clear_stencil);
    add_word(&h, scene_is_sampled(s) ? s->samples : 1);
    for (size_t i = 0; i < s->draw_count; ++i)
        add_draw(&h, &s->draws[i]);
    return (uint32_t)(h ^ h >> 32);
}

/* The colour attachments, then depth and stencil. */
#define BUFFERS (GN_MAX_COLORS + 1)

/* Returns the pixels of a colour attachment, or those of depth and stencil, which are the last
 * buffer; null if there are none. */
static const void *frame_buffer(const scene_frame *f, int buffer, gn_format *format)
{
    if (buffer == GN_MAX_COLORS) {
        *format = f->depth_format;
        return f->depth;
    }
    *format = scene_frame_format(f, buffer);
    return scene_frame_color(f, buffer);
}

/* Extracts the channels of a pixel of any format. Returns their number. */
static int load_channels(const void *pixels, gn_format format, size_t i, uint32_t channel[4])
{
    const uint16_t *const halves = pixels;
    const uint32_t *const words = pixels;
    switch (format) {
    case GN_FORMAT_D16:
        channel[0] = halves[i];
        return 1;
    case GN_FORMAT_D24: /* with the bits above, which are 0 */
    case GN_FORMAT_D32F:
        channel[0] = words[i];
        return 1;
    case GN_FORMAT_D24S8:
        channel[0] = words[i] & 0xFFFFFF;
        channel[1] = words[i] >> 24;
        return 2;
    case GN_FORMAT_D32FS8: /* stencil with the bits above, which are 0 */
        channel[0] = words[2 * i];
        channel[1] = words[2 * i + 1];
        return 2;
    case GN_FORMAT_S8:
        channel[0] = ((const uint8_t *)pixels)[i];
        return 1;
    default:
        return scene_pixel_channels(pixels, format, i, channel);
    }
}

static bool is_srgb(gn_format format, int channel)
{
    return scene_format_of(format)->encoding == SCENE_SRGB && channel < 3;
}

static bool is_nan(gn_format format, int channel, uint32_t bits)
{
    const double value = scene_channel_value(format, channel, bits);
    return value != value;
}

/* Returns the NaN that the library promises for channels of this width instead of any other. */
static uint32_t one_nan(gn_format format, int channel, uint32_t bits)
{
    if (!is_nan(format, channel, bits))
        return bits;
    switch (scene_channel_width(format, channel)) {
    case 32:
        return 0x7FC00000;
    case 16:
        return 0x7E00;
    case 11:
        return 0x7E0;
    default:
        return 0x3F0;
    }
}

void contract_hash_frame(const scene_frame *f, bool is_reference, hash *pixels, hash *srgb,
                         uint64_t *channels)
{
    const size_t count = (size_t)f->width * f->height * f->images;
    *pixels = *srgb = HASH_EMPTY;
    for (int b = 0; b < BUFFERS; ++b) {
        gn_format format;
        const void *const memory = frame_buffer(f, b, &format);
        for (size_t i = 0; memory && i < count; ++i) {
            uint32_t channel[4];
            const int n = load_channels(memory, format, i, channel);
            for (int c = 0; c < n; ++c)
                if (is_srgb(format, c)) {
                    add_word(srgb, channel[c]);
                    ++*channels;
                } else {
                    add_word(pixels, is_reference ? one_nan(format, c, channel[c]) : channel[c]);
                }
        }
    }
    contract_add(pixels, f->samples_passed);
    contract_add(pixels, f->statistics.primitives);
}

uint64_t contract_srgb_differing(const scene_frame *a, const scene_frame *b)
{
    const size_t count = (size_t)a->width * a->height * a->images;
    uint64_t differing = 0;
    for (int n = 0; n < BUFFERS; ++n) {
        gn_format format;
        const void *const x = frame_buffer(a, n, &format);
        const void *const y = frame_buffer(b, n, &format);
        for (size_t i = 0; x && is_srgb(format, 0) && i < count; ++i) {
            uint32_t u[4], v[4];
            load_channels(x, format, i, u);
            load_channels(y, format, i, v);
            for (int c = 0; c < 3; ++c)
                differing += u[c] != v[c];
        }
    }
    return differing;
}
