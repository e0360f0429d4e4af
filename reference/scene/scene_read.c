/* Reads scenes from text. */
#include "scene.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "scene_members.h"
#include "scene_memory.h"
#include "scene_reader.h"

static void read_attribute(reader *r, scene_draw *d, int attribute)
{
    const uint32_t components = read_number(r, 10, 4);
    const size_t count = (size_t)components * d->mesh.vertex_count;
    uint32_t *words;

    if (components == 0) {
        scene_reader_fail(r, "an attribute has 1 to 4 components");
        return;
    }
    words = read_words(r, count, read_float_word);
    if (!r->failed) {
        float *values = scene_reallocate(NULL, count, sizeof *values);

        memcpy(values, words, count * sizeof *values);
        scene_set_attribute(d, (gn_shader_attribute)attribute, values, components,
                            d->mesh.vertex_count);
        free(values);
    }
    free(words);
}

static void read_indices(reader *r, scene_draw *d)
{
    const gn_index_format format = (gn_index_format)read_name(r, TEXT_INDEX);
    const uint32_t count = read_number(r, 10, UINT32_MAX);
    uint32_t *words = read_words(r, count, read_decimal_word);
    const uint32_t largest = format == GN_INDEX_UINT8    ? UINT8_MAX
                             : format == GN_INDEX_UINT16 ? UINT16_MAX
                                                         : UINT32_MAX;

    for (uint32_t i = 0; i < count && !r->failed; ++i) {
        if (words[i] > largest) {
            scene_reader_fail(r, "index %" PRIu32 " does not fit %s", words[i],
                              text_name(TEXT_INDEX, (int)format));
        }
    }
    if (!r->failed)
        scene_set_indices(d, words, count, format);
    free(words);
}

/* Returns the texels of a texture whose other members are set, packed, in memory that the caller
 * frees. Returns null after a fault. */
static void *read_texels(reader *r, gn_texture *t)
{
    const bool sampled = scene_is_color_format(t->format) || scene_has_depth(t->format);
    const size_t size = scene_element_size(t->format);

    if (!r->failed && !sampled)
        scene_reader_fail(r, "a texture is of a format of colours or depths, such as rgba8");
    if (!r->failed && (t->width == 0 || t->height == 0))
        scene_reader_fail(r, "a texture has a size");
    if (r->failed)
        return NULL;

    const size_t count = scene_texture_elements(t);
    uint32_t *words = read_words(r, count, read_hexadecimal_word);
    void *packed = NULL;

    if (!r->failed) {
        packed = scene_allocate(count, size);
        for (size_t i = 0; i < count; ++i)
            scene_set_element(packed, size, i, words[i]);
        scene_pack_texture(t, packed);
    }
    free(words);
    return packed;
}

/* Reads uniforms.texture if map is SCENE_MAP_COUNT, otherwise that map. */
static void read_texture(reader *r, scene_draw *d, scene_map map)
{
    gn_texture t;

    memset(&t, 0, sizeof t);
    t.target = (gn_texture_target)read_name(r, TEXT_TEXTURE_TARGET);
    t.format = (gn_format)read_name(r, TEXT_FORMAT);
    t.width = read_number(r, 10, GN_MAX_SIZE);
    t.height = read_number(r, 10, GN_MAX_SIZE);
    t.depth = read_number(r, 10, GN_MAX_SIZE);
    t.level_count = read_number(r, 10, GN_MAX_LEVELS);

    void *const packed = read_texels(r, &t);
    if (packed && map == SCENE_MAP_COUNT)
        scene_set_levels(d, &t);
    else if (packed)
        scene_set_map(d, map, &t);
    free(packed);
}

static uint32_t read_value(reader *r, const scene_member *m)
{
    switch (m->type) {
    case MEMBER_SWITCH:
        return (uint32_t)read_name(r, TEXT_SWITCH);
    case MEMBER_NAMED:
        return (uint32_t)read_name(r, m->names);
    case MEMBER_BYTE:
    case MEMBER_NUMBER:
        return read_number(r, 10, m->largest);
    case MEMBER_INTEGER:
        return (uint32_t)read_integer(r);
    case MEMBER_FLOAT:
        return read_float_word(r);
    case MEMBER_ELSEWHERE:
        break;
    }
    return 0;
}

static bool read_member(reader *r, const char *keyword, scene_draw *d)
{
    size_t line;
    const scene_member *const m = scene_member_named(keyword, &line);

    for (size_t v = 0; m && v < scene_member_values(m); ++v)
        scene_member_set(m, d, line, v, read_value(r, m));
    return m;
}

static bool read_mesh(reader *r, const char *keyword, scene_draw *d)
{
    if (!strcmp(keyword, "vertices")) {
        for (int a = 0; a < text_name_count(TEXT_ATTRIBUTE); ++a)
            if (d->mesh.attribute[a].data)
                scene_reader_fail(r, "vertices stands after an attribute");
        d->mesh.vertex_count = read_number(r, 10, UINT32_MAX);
    } else if (!strcmp(keyword, "indices")) {
        read_indices(r, d);
    } else if (!strcmp(keyword, "elements")) {
        d->mesh.first = read_number(r, 10, UINT32_MAX);
        d->mesh.count = read_number(r, 10, UINT32_MAX);
    } else if (!strcmp(keyword, "texture")) {
        read_texture(r, d, SCENE_MAP_COUNT);
    } else if (text_value(TEXT_MAP, keyword) >= 0) {
        read_texture(r, d, (scene_map)text_value(TEXT_MAP, keyword));
    } else {
        for (int a = 0; a < text_name_count(TEXT_ATTRIBUTE); ++a) {
            if (!strcmp(keyword, text_name(TEXT_ATTRIBUTE, a))) {
                read_attribute(r, d, a);
                return true;
            }
        }
        return false;
    }
    return true;
}

static void read_draw(reader *r, scene *s)
{
    const scene_shader shader = (scene_shader)read_name(r, TEXT_SHADER);
    scene_draw *d = scene_add_draw(s);
    char keyword[sizeof r->token];

    d->shader = shader;
    while (!r->failed) {
        strcpy(keyword, scene_reader_next(r));
        if (!strcmp(keyword, "end-draw"))
            break;
        if (!*keyword)
            scene_reader_fail(r, "the text ends within a draw");
        else if (!read_member(r, keyword, d) && !read_mesh(r, keyword, d))
            scene_reader_fail(r, "'%s' is no keyword of a draw", keyword);
    }
    if (!r->failed && d->mesh.indices && (uint64_t)d->mesh.first + d->mesh.count > d->index_count)
        scene_reader_fail(r, "elements beyond the %" PRIu32 " indices", d->index_count);
}

static bool has_more_colors(const scene *s)
{
    for (int a = 1; a < GN_MAX_COLORS; ++a)
        if (scene_color_format(s, a) != GN_FORMAT_NONE)
            return true;
    return false;
}

static bool read_frame(reader *r, const char *keyword, scene *s)
{
    if (!strcmp(keyword, "size")) {
        s->width = read_number(r, 10, GN_MAX_SIZE);
        s->height = read_number(r, 10, GN_MAX_SIZE);
    } else if (!strcmp(keyword, "color-format")) {
        s->color_format = (gn_format)read_name(r, TEXT_FORMAT);
    } else if (!strcmp(keyword, "more-colors")) {
        for (int a = 0; a < GN_MAX_COLORS - 1; ++a) {
            s->more_colors[a] = (gn_format)read_name(r, TEXT_FORMAT);
            if (!r->failed && s->more_colors[a] != GN_FORMAT_NONE &&
                !scene_is_color_format(s->more_colors[a]))
                scene_reader_fail(r, "more-colors are formats of colours, such as rgba8, or none");
        }
    } else if (!strcmp(keyword, "depth-format")) {
        s->depth_format = (gn_format)read_name(r, TEXT_FORMAT);
    } else if (!strcmp(keyword, "clear-color")) {
        read_floats(r, s->clear_color, 4);
    } else if (!strcmp(keyword, "clear-depth")) {
        s->clear_depth = read_float(r);
    } else if (!strcmp(keyword, "clear-stencil")) {
        s->clear_stencil = (uint8_t)read_number(r, 10, 255);
    } else if (!strcmp(keyword, "samples")) {
        s->samples = read_number(r, 10, GN_SAMPLES);
    } else if (!strcmp(keyword, "draw")) {
        read_draw(r, s);
    } else {
        return false;
    }
    return true;
}

bool read_keyword(reader *r, const char *keyword, scene *s, scene_draw *d)
{
    return read_frame(r, keyword, s) || (d && read_member(r, keyword, d));
}

scene *scene_read(FILE *in, char *error, size_t error_size)
{
    reader r = {in, 1, "", false, error, error_size};
    scene *s = scene_create(0, 0, GN_FORMAT_NONE, GN_FORMAT_NONE);
    char keyword[sizeof r.token];

    if (error_size)
        error[0] = '\0';
    if (strcmp(scene_reader_next(&r), "gnomon-scene") || strcmp(scene_reader_next(&r), "1"))
        scene_reader_fail(&r, "not a scene: the text starts with 'gnomon-scene 1'");
    while (!r.failed) {
        strcpy(keyword, scene_reader_next(&r));
        if (!strcmp(keyword, "end-scene"))
            break;
        if (!*keyword)
            scene_reader_fail(&r, "the text ends before end-scene");
        else if (!read_frame(&r, keyword, s))
            scene_reader_fail(&r, "'%s' is no keyword of a scene", keyword);
    }
    if (!r.failed && (s->width == 0 || s->height == 0))
        scene_reader_fail(&r, "a scene has a size");
    if (!r.failed && !scene_is_color_format(s->color_format) &&
        (s->color_format != GN_FORMAT_NONE || !has_more_colors(s)))
        scene_reader_fail(&r, "a scene's color-format is one of colours, such as rgba8");
    if (!r.failed && scene_is_color_format(s->depth_format))
        scene_reader_fail(&r, "a scene's depth-format is one of depth or stencil, or none");
    if (r.failed) {
        scene_free(s);
        return NULL;
    }
    return s;
}
