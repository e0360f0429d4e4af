/* The table of pixel formats, from the rows of GN_FORMATS (src/formats/format_table.h). */
#include "scene_format.h"

#define SET(w) ((w) > 0)

static const scene_format rows[SCENE_FORMATS] = {
#define ROW(name, layout, kind, encoding, o0, w0, o1, w1, o2, w2, o3, w3)                          \
    [GN_FORMAT_##name] = {#name,                                                                   \
                          LAYOUT_##layout##_BYTES,                                                 \
                          LAYOUT_##layout##_ELEMENT,                                               \
                          IS_##kind,                                                               \
                          LAYOUT_##layout == LAYOUT_SHORT_HIGH_FIRST,                              \
                          SCENE_##encoding,                                                        \
                          SET(w0) + SET(w1) + SET(w2) + SET(w3),                                   \
                          {o0, o1, o2, o3},                                                        \
                          {w0, w1, w2, w3}},
#define IS_COLOR true
#define IS_DEPTH false
    GN_FORMATS(ROW)};

/* The names of the formats of one kind, colours or depths. */
#define NAME(name, layout, kind, ...) NAME_##kind(name)

const gn_format scene_color_formats[SCENE_COLOR_FORMATS] = {
#define NAME_COLOR(name) GN_FORMAT_##name,
#define NAME_DEPTH(name)
    GN_FORMATS(NAME)
#undef NAME_COLOR
#undef NAME_DEPTH
};

const gn_format scene_depth_formats[SCENE_DEPTH_FORMATS] = {
#define NAME_COLOR(name)
#define NAME_DEPTH(name) GN_FORMAT_##name,
    GN_FORMATS(NAME)};

const scene_format *scene_format_of(gn_format format)
{
    const bool known = (unsigned)format < SCENE_FORMATS;

    return &rows[known ? format : GN_FORMAT_NONE];
}

bool scene_is_color_format(gn_format format)
{
    return scene_format_of(format)->is_color;
}

bool scene_is_float_format(gn_format format)
{
    return scene_format_of(format)->encoding == SCENE_FLOAT;
}

bool scene_has_depth(gn_format format)
{
    const scene_format *const f = scene_format_of(format);

    return !f->is_color && f->width[0] > 0;
}

bool scene_has_stencil(gn_format format)
{
    const scene_format *const f = scene_format_of(format);

    return !f->is_color && f->width[1] > 0;
}

int scene_channel_width(gn_format format, int channel)
{
    return scene_format_of(format)->width[channel];
}

size_t scene_element_size(gn_format format)
{
    return scene_format_of(format)->element;
}
