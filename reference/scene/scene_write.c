/* Writes scenes as text. */
#include "scene.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "scene_members.h"

/* Writes a finite float other than zero as C's %a does, which some C libraries lack or do
 * otherwise: a digit 1, at most six digits of the rest, the exponent. */
static void write_hexadecimal(FILE *out, float f)
{
    int exponent;
    const double above_1 = 2.0 * fabs(frexp((double)f, &exponent)) - 1.0;
    const char *point = ".";

    fputs(f < 0.0f ? " -0x1" : " 0x1", out);
    for (uint32_t rest = (uint32_t)(above_1 * 4294967296.0); rest != 0; rest <<= 4) {
        fprintf(out, "%s%" PRIx32, point, rest >> 28);
        point = "";
    }
    fprintf(out, "p%+d", exponent - 1);
}

static void write_float(FILE *out, float f)
{
    uint32_t bits;

    memcpy(&bits, &f, sizeof bits);
    if (isnan(f))
        fprintf(out, " nan:%08" PRIx32, bits);
    else if (isinf(f) || f == 0.0f)
        fprintf(out, "%s%s", bits >> 31 ? " -" : " ", isinf(f) ? "inf" : "0x0p+0");
    else
        write_hexadecimal(out, f);
}

static void write_floats(FILE *out, const char *keyword, const float *values, size_t count)
{
    fputs(keyword, out);
    for (size_t i = 0; i < count; ++i)
        write_float(out, values[i]);
    fputc('\n', out);
}

static void write_attribute(FILE *out, const char *name, const gn_attribute *a,
                            uint32_t vertex_count)
{
    const size_t stride = a->stride ? a->stride : a->components * sizeof(float);

    fprintf(out, "  %s %" PRIu32 "\n", name, a->components);
    for (uint32_t v = 0; v < vertex_count; ++v) {
        write_floats(out, "   ", (const float *)(const void *)((const char *)a->data + v * stride),
                     a->components);
    }
}

static void write_indices(FILE *out, const scene_draw *d)
{
    const gn_mesh *mesh = &d->mesh;

    fprintf(out, "  indices %s %" PRIu32, text_name(TEXT_INDEX, (int)mesh->index_format),
            d->index_count);
    for (uint32_t i = 0; i < d->index_count; ++i)
        fprintf(out, "%s%" PRIu32, i % 12 ? " " : "\n    ", scene_vertex_of(mesh, i));
    fputc('\n', out);
}

/* Writes one row of texels per line. */
static void write_texels(FILE *out, const gn_texture *t)
{
    const uint32_t levels = scene_level_count(t);
    const size_t size = scene_element_size(t->format);

    for (uint32_t level = 0; level < levels; ++level) {
        const scene_extent e = scene_level_extent(t, level);
        const gn_texture_level *const l = &t->level[level];

        for (uint32_t row = 0; row < e.height * e.layers; ++row) {
            const char *const texels = (const char *)l->texels +
                                       (ptrdiff_t)(row / e.height) * l->layer_stride +
                                       (ptrdiff_t)(row % e.height) * l->row_stride;
            const size_t elements = e.width * gn_format_size(t->format) / size;

            fputs("   ", out);
            for (size_t i = 0; i < elements; ++i)
                fprintf(out, " %0*" PRIx32, (int)(2 * size), scene_element(texels, size, i));
            fputc('\n', out);
        }
    }
}

static void write_texture(FILE *out, const char *keyword, const gn_texture *t)
{
    fprintf(out, "  %s %s %s %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 "\n", keyword,
            text_name(TEXT_TEXTURE_TARGET, (int)t->target), text_name(TEXT_FORMAT, (int)t->format),
            t->width, t->height, scene_level_extent(t, 0).layers, scene_level_count(t));
    write_texels(out, t);
}

static void write_value(FILE *out, const scene_member *m, uint32_t word)
{
    float number;

    switch (m->type) {
    case MEMBER_SWITCH:
        fprintf(out, " %s", text_name(TEXT_SWITCH, (int)word));
        break;
    case MEMBER_NAMED:
        fprintf(out, " %s", text_name(m->names, (int)word));
        break;
    case MEMBER_BYTE:
    case MEMBER_NUMBER:
        fprintf(out, " %" PRIu32, word);
        break;
    case MEMBER_INTEGER:
        fprintf(out, " %" PRId32, (int32_t)word);
        break;
    case MEMBER_FLOAT:
        memcpy(&number, &word, sizeof number);
        write_float(out, number);
        break;
    case MEMBER_ELSEWHERE:
        break;
    }
}

static bool is_default(const scene_member *m, const scene_draw *d, const scene_draw *by_default,
                       size_t line)
{
    for (size_t v = 0; v < scene_member_values(m); ++v)
        if (scene_member_get(m, d, line, v) != scene_member_get(m, by_default, line, v))
            return false;
    return true;
}

/* Lines whose values are scene_default_draw's are left out. */
static void write_member(FILE *out, const scene_member *m, const scene_draw *d,
                         const scene_draw *by_default)
{
    for (size_t line = 0; line < scene_member_lines(m); ++line) {
        char name[SCENE_MEMBER_NAME];

        if (is_default(m, d, by_default, line))
            continue;
        scene_member_name(m, line, name);
        fprintf(out, "  %s", name);
        for (size_t v = 0; v < scene_member_values(m); ++v)
            write_value(out, m, scene_member_get(m, d, line, v));
        fputc('\n', out);
    }
}

void scene_write_members(const scene_draw *d, FILE *out)
{
    scene_draw by_default;

    scene_default_draw(&by_default);
    for (size_t i = 0; i < scene_member_count; ++i)
        if (scene_members[i].type != MEMBER_ELSEWHERE)
            write_member(out, &scene_members[i], d, &by_default);
}

static void write_draw(FILE *out, const scene_draw *d)
{
    fprintf(out, "draw %s\n", text_name(TEXT_SHADER, (int)d->shader));
    scene_write_members(d, out);
    if (d->uniforms.texture.level[0].texels)
        write_texture(out, "texture", &d->uniforms.texture);
    for (int m = 0; m < SCENE_MAP_COUNT; ++m)
        if (d->surface.map[m].level[0].texels)
            write_texture(out, text_name(TEXT_MAP, m), &d->surface.map[m]);
    fprintf(out, "  vertices %" PRIu32 "\n", d->mesh.vertex_count);
    for (int a = 0; a < text_name_count(TEXT_ATTRIBUTE); ++a) {
        if (d->mesh.attribute[a].data) {
            write_attribute(out, text_name(TEXT_ATTRIBUTE, a), &d->mesh.attribute[a],
                            d->mesh.vertex_count);
        }
    }
    if (d->mesh.indices)
        write_indices(out, d);
    fprintf(out, "  elements %" PRIu32 " %" PRIu32 "\nend-draw\n", d->mesh.first, d->mesh.count);
}

bool scene_write(const scene *s, FILE *out)
{
    bool has_more_colors = false;

    for (int a = 1; a < GN_MAX_COLORS; ++a)
        has_more_colors |= scene_color_format(s, a) != GN_FORMAT_NONE;
    fprintf(out, "gnomon-scene 1\nsize %" PRIu32 " %" PRIu32 "\n", s->width, s->height);
    fprintf(out, "color-format %s\n", text_name(TEXT_FORMAT, (int)s->color_format));
    if (has_more_colors) {
        fputs("more-colors", out);
        for (int a = 1; a < GN_MAX_COLORS; ++a)
            fprintf(out, " %s", text_name(TEXT_FORMAT, (int)scene_color_format(s, a)));
        fputc('\n', out);
    }
    fprintf(out, "depth-format %s\n", text_name(TEXT_FORMAT, (int)s->depth_format));
    write_floats(out, "clear-color", s->clear_color, 4);
    write_floats(out, "clear-depth", &s->clear_depth, 1);
    fprintf(out, "clear-stencil %d\n", s->clear_stencil);
    if (scene_is_sampled(s))
        fprintf(out, "samples %" PRIu32 "\n", s->samples);
    for (size_t i = 0; i < s->draw_count; ++i)
        write_draw(out, &s->draws[i]);
    fputs("end-scene\n", out);
    return fflush(out) == 0 && !ferror(out);
}
