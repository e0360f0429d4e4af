/* The keywords of rows. */
#include "words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "rows.h"
#include "scene_memory.h"
#include "scene_pixel.h"
#include "scene_reader.h"

#define MAP_SIDE 256

/* A number without a pattern from 0 to 1. */
static float noise(uint32_t i)
{
    return (float)(row_spread(i) >> 8) * 0x1p-24f;
}

static void fill_level(const gn_texture *t, uint32_t level)
{
    const scene_extent e = scene_level_extent(t, level);
    const size_t count = (size_t)e.width * e.height * e.layers;
    void *const texels = (void *)t->level[level].texels;

    for (size_t i = 0; i < count; ++i) {
        const uint32_t n = (uint32_t)(4 * i) + level * 12345;
        const float value[4] = {noise(n), noise(n + 1), noise(n + 2), noise(n + 3)};

        if (scene_is_color_format(t->format))
            scene_pixel_store(texels, t->format, i, value);
        else if (t->format == GN_FORMAT_D32F)
            ((float *)texels)[i] = value[0];
        else if (t->format == GN_FORMAT_D16)
            ((uint16_t *)texels)[i] = (uint16_t)(value[0] * 65535.0f);
        else
            ((uint32_t *)texels)[i] = (uint32_t)((double)value[0] * 16777215.0);
    }
}

/* Returns a packed texture; the caller frees the first level's texels, which hold all levels. */
static gn_texture make_noise(gn_texture_target target, gn_format format, uint32_t side,
                             uint32_t depth, uint32_t levels)
{
    const uint32_t height = target == GN_TEXTURE_1D ? 1 : side;
    const size_t size = gn_texture_memory_size(target, format, side, height, depth, levels);
    void *const memory = scene_allocate(size, 1);
    gn_texture t;

    if (gn_texture_packed(target, format, side, height, depth, levels, memory, &t) != GN_OK) {
        fprintf(stderr, "bench: a row has an impossible texture\n");
        exit(EXIT_FAILURE);
    }
    fill_level(&t, 0);
    if (levels > 1 && scene_is_color_format(format)) {
        char *const rest = (char *)t.level[1].texels;

        gn_texture_generate_levels(&t, rest, size - (size_t)(rest - (char *)memory));
    } else {
        for (uint32_t level = 1; level < levels; ++level)
            fill_level(&t, level);
    }
    return t;
}

/* The coordinates of screens for a target: s and t from 0 to 4; the third is the layer or goes
 * across the slices; a cube's are the corner's direction. The fourth is the reference value of
 * comparisons. */
static void set_coordinates(scene_draw *d, const gn_texture *t)
{
    const uint32_t count = d->mesh.vertex_count;
    const float *const position = d->mesh.attribute[GN_ATTRIBUTE_POSITION].data;
    float(*const at)[4] = scene_allocate(count, sizeof *at);

    for (uint32_t i = 0; i < count; ++i) {
        const bool right = i & 1, above = i & 2;

        at[i][0] = right ? 4.0f : 0.0f;
        at[i][1] = above ? 4.0f : 0.0f;
        at[i][2] =
            t->target == GN_TEXTURE_2D_ARRAY ? (float)(i / 4 % t->depth) : (right ? 0.9f : 0.1f);
        at[i][3] = right ? 0.75f : 0.25f;
        for (int c = 0; t->target == GN_TEXTURE_CUBE && c < 3; ++c)
            at[i][c] = position[3 * i + (uint32_t)c] / -position[3 * (i - i % 4) + 2];
    }
    scene_set_attribute(d, GN_ATTRIBUTE_TEXCOORD, at[0], 4, count);
    free(at);
}

void word_noise(scene_draw *d, gn_texture_target target, gn_format format, uint32_t side,
                uint32_t depth, uint32_t levels)
{
    const gn_texture t = make_noise(target, format, side, depth, levels);

    scene_set_levels(d, &t);
    if (d->shader == SCENE_SAMPLED)
        set_coordinates(d, &t);
    free((void *)t.level[0].texels);
}

static void read_noise(reader *r, scene_draw *d)
{
    const gn_texture_target target = (gn_texture_target)read_name(r, TEXT_TEXTURE_TARGET);
    const gn_format format = (gn_format)read_name(r, TEXT_FORMAT);
    const uint32_t side = read_number(r, 10, 4096);
    const uint32_t depth = read_number(r, 10, 4096);
    const uint32_t levels = read_number(r, 10, GN_MAX_LEVELS);

    if (!r->failed)
        word_noise(d, target, format, side, depth, levels);
}

static void read_map(reader *r, scene_draw *d)
{
    const scene_map map = (scene_map)read_name(r, TEXT_MAP);
    const gn_format format = (gn_format)read_name(r, TEXT_FORMAT);

    if (!r->failed) {
        const gn_texture t = make_noise(GN_TEXTURE_2D, format, MAP_SIDE, MAP_SIDE, 1);

        scene_set_map(d, map, &t);
        free((void *)t.level[0].texels);
    }
}

static void remove_texture(scene_draw *d)
{
    free((void *)d->uniforms.texture.level[0].texels);
    memset(&d->uniforms.texture, 0, sizeof d->uniforms.texture);
}

static void give_alpha(scene_draw *d)
{
    const gn_attribute *const from = &d->mesh.attribute[GN_ATTRIBUTE_COLOR];
    const uint32_t count = d->mesh.vertex_count;
    float(*const color)[4] = scene_allocate(count, sizeof *color);

    for (uint32_t i = 0; i < count; ++i) {
        for (uint32_t c = 0; c < 3; ++c)
            color[i][c] = from->data ? from->data[i * from->components + c] : 1.0f;
        color[i][3] = 0.25f + 0.25f * (float)(i % 4);
    }
    scene_set_attribute(d, GN_ATTRIBUTE_COLOR, color[0], 4, count);
    free(color);
}

static void stretch(scene_draw *d)
{
    float *const at = (float *)d->mesh.attribute[GN_ATTRIBUTE_TEXCOORD].data;
    const uint32_t components = d->mesh.attribute[GN_ATTRIBUTE_TEXCOORD].components;

    for (uint32_t i = 0; at && i < d->mesh.vertex_count; ++i)
        at[i * components] *= 4.0f;
}

static void give_sizes(scene_draw *d)
{
    const uint32_t count = d->mesh.vertex_count;
    float *const size = scene_allocate(count, sizeof *size);

    for (uint32_t i = 0; i < count; ++i)
        size[i] = 4.0f + 0.5f * (float)(i % 17);
    scene_set_attribute(d, GN_ATTRIBUTE_TEXCOORD, size, 1, count);
    free(size);
}

/* Tangents across the normals, in some direction. */
static void give_tangents(scene_draw *d)
{
    const uint32_t count = d->mesh.vertex_count;
    const float *const normal = d->mesh.attribute[GN_ATTRIBUTE_NORMAL].data;
    float(*const tangent)[4] = scene_allocate(count, sizeof *tangent);

    for (uint32_t i = 0; normal && i < count; ++i) {
        const float *const n = normal + (size_t)i * 3;

        tangent[i][0] = n[1] * 0.8f - n[2] * 0.5f;
        tangent[i][1] = n[2] * 0.3f - n[0] * 0.8f;
        tangent[i][2] = n[0] * 0.5f - n[1] * 0.3f;
        tangent[i][3] = 1.0f;
    }
    scene_set_attribute(d, GN_ATTRIBUTE_TANGENT, tangent[0], 4, count);
    free(tangent);
}

/* The model is at the distance of world_from_model's last column; the map sees it from -1 to 1. */
static void add_shadow(scene_draw *d)
{
    const gn_mat4 *const m = &d->surface.world_from_model;
    gn_transform back;

    gn_translate((gn_vec3){-m->m[3][0], -m->m[3][1], -m->m[3][2]}, &back);
    d->surface.shadow_from_world = back.matrix;
    d->surface.shadow_sampler.compare = GN_LESS_OR_EQUAL;
    d->surface.shadow_sampler.magnify = GN_MAGNIFY_LINEAR;
    d->surface.shadow_sampler.minify = GN_MINIFY_LINEAR;
}

static void add_point_light(scene_draw *d)
{
    d->surface.has_point_light = true;
    d->surface.light_position = (gn_vec3){1.5f, 2.0f, 1.0f};
    d->surface.attenuation[0] = 1.0f;
    d->surface.attenuation[1] = 0.1f;
    d->surface.attenuation[2] = 0.05f;
}

/* Turns the order of screens round, which have six indices each, or of a sphere's squares. */
static void turn_round(scene_draw *d)
{
    const uint32_t count = d->mesh.count;
    uint32_t *const index = scene_allocate(count, sizeof *index);

    if (d->mesh.index_format != GN_INDEX_NONE && d->state.raster.topology == GN_TRIANGLES) {
        for (uint32_t i = 0; i < count; ++i)
            index[i] = scene_vertex_of(&d->mesh, count - 6 - i / 6 * 6 + i % 6);
        scene_set_indices(d, index, count, d->mesh.index_format);
    }
    free(index);
}

static void draw_again(scene *s)
{
    scene *const copy = scene_copy(s);
    scene_draw *const d = scene_add_draw(s);

    *d = copy->draws[0]; /* with its memory */
    d->state.depth.function = GN_EQUAL;
    copy->draw_count = 0;
    scene_free(copy);
}

static void shift(reader *r, scene_draw *d)
{
    float by[3];
    gn_transform moved;

    read_floats(r, by, 3);
    gn_translate((gn_vec3){by[0], by[1], by[2]}, &moved);
    gn_mat4_multiply(&d->uniforms.light.clip_from_model, &moved.matrix,
                     &d->uniforms.light.clip_from_model);
}

/* Repeats the vertices in the order of the indices, which are then removed. */
static void remove_indices(scene_draw *d)
{
    const uint32_t count = d->mesh.count;

    for (int a = 0; a < GN_MAX_ATTRIBUTES; ++a) {
        gn_attribute *const attribute = &d->mesh.attribute[a];
        const size_t size = attribute->components * sizeof(float);

        if (attribute->data) {
            char *const copy = scene_allocate(count, size);

            for (uint32_t i = 0; i < count; ++i) {
                memcpy(copy + i * size,
                       (const char *)attribute->data + scene_vertex_of(&d->mesh, i) * size, size);
            }
            free((void *)attribute->data);
            attribute->data = (const float *)(const void *)copy;
        }
    }
    d->mesh.vertex_count = count;
    scene_set_indices(d, NULL, 0, GN_INDEX_NONE);
}

static void read_index(reader *r, scene_draw *d)
{
    const gn_index_format format = (gn_index_format)read_name(r, TEXT_INDEX);
    const uint32_t count = d->mesh.count;

    if (format == GN_INDEX_NONE) {
        remove_indices(d);
        return;
    }
    uint32_t *const index = scene_allocate(count, sizeof *index);
    for (uint32_t i = 0; i < count; ++i)
        index[i] = scene_vertex_of(&d->mesh, i);
    scene_set_indices(d, index, count, format);
    free(index);
}

static bool read_own(reader *r, const char *word, scene *s, scene_draw *d)
{
    if (strcmp(word, "shader") == 0)
        d->shader = (scene_shader)read_name(r, TEXT_SHADER);
    else if (strcmp(word, "alpha") == 0)
        give_alpha(d);
    else if (strcmp(word, "noise") == 0)
        read_noise(r, d);
    else if (strcmp(word, "map") == 0)
        read_map(r, d);
    else if (strcmp(word, "plain") == 0)
        remove_texture(d);
    else if (strcmp(word, "stretch") == 0)
        stretch(d);
    else if (strcmp(word, "sizes") == 0)
        give_sizes(d);
    else if (strcmp(word, "tangents") == 0)
        give_tangents(d);
    else if (strcmp(word, "shadow") == 0)
        add_shadow(d);
    else if (strcmp(word, "point-light") == 0)
        add_point_light(d);
    else if (strcmp(word, "front-to-back") == 0)
        turn_round(d);
    else if (strcmp(word, "again") == 0)
        draw_again(s);
    else if (strcmp(word, "shift") == 0)
        shift(r, d);
    else if (strcmp(word, "index") == 0)
        read_index(r, d);
    else
        return false;
    return true;
}

bool words_apply(scene *s, const char *text, char *error, size_t error_size)
{
    FILE *const in = *text ? fmemopen((void *)text, strlen(text), "r") : NULL;
    reader r = {in, 1, "", false, error, error_size};
    char word[sizeof r.token];

    while (in && !r.failed && *strcpy(word, scene_reader_next(&r))) {
        scene_draw *const d = s->draw_count > 0 ? &s->draws[0] : NULL;

        if (!read_keyword(&r, word, s, d) && !(d && read_own(&r, word, s, d)))
            scene_reader_fail(&r, "'%s' is no keyword of a row", word);
    }
    if (in)
        fclose(in);
    return !r.failed && (in || !*text);
}
