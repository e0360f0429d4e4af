/* Scenes to text. */
#include "scene.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "scene_text.h"

static void write_float(FILE *out, float f)
{
    uint32_t bits;

    memcpy(&bits, &f, sizeof bits);
    if (isnan(f)) {
        fprintf(out, " nan:%08" PRIx32, bits);
    } else {
        fprintf(out, " %a", (double)f);
    }
}

static void write_floats(FILE *out, const char *keyword, const float *values, size_t count)
{
    fputs(keyword, out);
    for (size_t i = 0; i < count; ++i) {
        write_float(out, values[i]);
    }
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
    for (uint32_t i = 0; i < d->index_count; ++i) {
        fprintf(out, "%s%" PRIu32, i % 12 ? " " : "\n    ", scene_vertex_of(mesh, i));
    }
    fputc('\n', out);
}

static void write_texture(FILE *out, const gn_texture *t)
{
    const size_t words = gn_format_size(t->format) / 4;

    fprintf(out, "  texture %s %" PRIu32 " %" PRIu32 "\n", text_name(TEXT_FORMAT, (int)t->format),
            t->width, t->height);
    for (uint32_t y = 0; y < t->height; ++y) {
        const char *row = (const char *)t->texels + (ptrdiff_t)y * t->row_stride;

        fputs("   ", out);
        for (size_t i = 0; i < t->width * words; ++i) {
            uint32_t word;

            memcpy(&word, row + 4 * i, sizeof word);
            fprintf(out, " %08" PRIx32, word);
        }
        fputc('\n', out);
    }
}

static void write_state(FILE *out, const gn_pipeline *p)
{
    const float viewport[4] = {p->viewport.x, p->viewport.y, p->viewport.width, p->viewport.height};
    const float range[2] = {p->depth_range.z_near, p->depth_range.z_far};

    fprintf(out, "  topology %s\n", text_name(TEXT_TOPOLOGY, (int)p->topology));
    fprintf(out, "  provoking-vertex %s\n", text_name(TEXT_PROVOKING, (int)p->provoking_vertex));
    fprintf(out, "  cull %s\n", text_name(TEXT_CULL, (int)p->cull));
    fprintf(out, "  front-face %s\n", text_name(TEXT_FRONT_FACE, (int)p->front_face));
    if (p->viewport.set) {
        write_floats(out, "  viewport", viewport, 4);
    }
    if (p->depth_range.set) {
        write_floats(out, "  depth-range", range, 2);
    }
    fprintf(out, "  depth-test %s\n", text_name(TEXT_SWITCH, p->depth_test));
    fprintf(out, "  depth-function %s\n", text_name(TEXT_COMPARE, (int)p->depth_function));
    fprintf(out, "  depth-write %s\n", text_name(TEXT_SWITCH, !p->depth_write_disabled));
    if (p->point_size != 0.0f) {
        write_floats(out, "  point-size", &p->point_size, 1);
    }
    fprintf(out, "  program-point-size %s\n", text_name(TEXT_SWITCH, p->program_point_size));
    if (p->line_width != 0.0f) {
        write_floats(out, "  line-width", &p->line_width, 1);
    }
    fprintf(out, "  polygon-mode %s %s\n",
            text_name(TEXT_POLYGON_MODE, (int)p->polygon_mode_front),
            text_name(TEXT_POLYGON_MODE, (int)p->polygon_mode_back));
    fprintf(out, "  interpolation %s %s %s %s\n",
            text_name(TEXT_INTERPOLATION, (int)p->interpolation[0]),
            text_name(TEXT_INTERPOLATION, (int)p->interpolation[1]),
            text_name(TEXT_INTERPOLATION, (int)p->interpolation[2]),
            text_name(TEXT_INTERPOLATION, (int)p->interpolation[3]));
}

static void write_uniforms(FILE *out, const scene_draw *d)
{
    const gn_textured_uniforms *u = &d->uniforms;
    const float specular[3] = {d->specular.x, d->specular.y, d->specular.z};
    const float direction[3] = {u->light.light_direction.x, u->light.light_direction.y,
                                u->light.light_direction.z};
    const float ambient[3] = {u->light.ambient.x, u->light.ambient.y, u->light.ambient.z};
    const float diffuse[3] = {u->light.diffuse.x, u->light.diffuse.y, u->light.diffuse.z};

    write_floats(out, "  clip-from-model", &u->light.clip_from_model.m[0][0], 16);
    write_floats(out, "  normal-matrix", &u->light.normal_matrix.m[0][0], 9);
    write_floats(out, "  light-direction", direction, 3);
    write_floats(out, "  ambient", ambient, 3);
    write_floats(out, "  diffuse", diffuse, 3);
    if (d->shader == SCENE_PHONG) {
        write_floats(out, "  view-from-model", &d->view_from_model.m[0][0], 16);
        write_floats(out, "  specular", specular, 3);
    }
    fprintf(out, "  sampler %s %s %s %s\n", text_name(TEXT_WRAP, (int)u->sampler.wrap_s),
            text_name(TEXT_WRAP, (int)u->sampler.wrap_t),
            text_name(TEXT_MAGNIFY, (int)u->sampler.magnify),
            text_name(TEXT_MINIFY, (int)u->sampler.minify));
    if (u->texture.texels) {
        write_texture(out, &u->texture);
    }
}

bool scene_write(const scene *s, FILE *out)
{
    fprintf(out, "gnomon-scene 1\nsize %" PRIu32 " %" PRIu32 "\n", s->width, s->height);
    fprintf(out, "color-format %s\n", text_name(TEXT_FORMAT, (int)s->color_format));
    fprintf(out, "depth-format %s\n", text_name(TEXT_FORMAT, (int)s->depth_format));
    write_floats(out, "clear-color", s->clear_color, 4);
    write_floats(out, "clear-depth", &s->clear_depth, 1);
    for (size_t i = 0; i < s->draw_count; ++i) {
        const scene_draw *d = &s->draws[i];

        fprintf(out, "draw %s\n", text_name(TEXT_SHADER, (int)d->shader));
        write_state(out, &d->state);
        write_uniforms(out, d);
        fprintf(out, "  vertices %" PRIu32 "\n", d->mesh.vertex_count);
        for (int a = 0; a < text_name_count(TEXT_ATTRIBUTE); ++a) {
            if (d->mesh.attribute[a].data) {
                write_attribute(out, text_name(TEXT_ATTRIBUTE, a), &d->mesh.attribute[a],
                                d->mesh.vertex_count);
            }
        }
        if (d->mesh.indices) {
            write_indices(out, d);
        }
        fprintf(out, "  elements %" PRIu32 " %" PRIu32 "\nend-draw\n", d->mesh.first,
                d->mesh.count);
    }
    fputs("end-scene\n", out);
    return fflush(out) == 0 && !ferror(out);
}
