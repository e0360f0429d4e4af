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

/* A row of texels a line. */
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
            for (size_t i = 0; i < elements; ++i) {
                fprintf(out, " %0*" PRIx32, (int)(2 * size), scene_element(texels, size, i));
            }
            fputc('\n', out);
        }
    }
}

static void write_levels(FILE *out, const char *keyword, const gn_texture *t)
{
    fprintf(out, "  %s %s %s %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 "\n", keyword,
            text_name(TEXT_TEXTURE_TARGET, (int)t->target), text_name(TEXT_FORMAT, (int)t->format),
            t->width, t->height, scene_level_extent(t, 0).layers, scene_level_count(t));
    write_texels(out, t);
}

static void write_texture(FILE *out, const gn_texture *t)
{
    if (t->target != GN_TEXTURE_2D || scene_level_count(t) > 1) {
        write_levels(out, "texture-levels", t);
        return;
    }
    fprintf(out, "  texture %s %" PRIu32 " %" PRIu32 "\n", text_name(TEXT_FORMAT, (int)t->format),
            t->width, t->height);
    write_texels(out, t);
}

/* What zero means is not written. */
static void write_sampler(FILE *out, const gn_sampler *s)
{
    static const float zero[4];
    const float clamp[2] = {s->min_lod, s->max_lod};

    fprintf(out, "  sampler %s %s %s %s\n", text_name(TEXT_WRAP, (int)s->wrap_s),
            text_name(TEXT_WRAP, (int)s->wrap_t), text_name(TEXT_MAGNIFY, (int)s->magnify),
            text_name(TEXT_MINIFY, (int)s->minify));
    if (s->wrap_r != GN_WRAP_REPEAT) {
        fprintf(out, "  wrap-r %s\n", text_name(TEXT_WRAP, (int)s->wrap_r));
    }
    if (s->compare != GN_COMPARE_DEFAULT) {
        fprintf(out, "  texture-compare %s\n", text_name(TEXT_COMPARE, (int)s->compare));
    }
    if (s->lod_bias != 0.0f) {
        write_floats(out, "  lod-bias", &s->lod_bias, 1);
    }
    if (s->lod_clamped) {
        write_floats(out, "  lod-clamp", clamp, 2);
    }
    if (s->max_anisotropy) {
        fprintf(out, "  max-anisotropy %" PRIu32 "\n", s->max_anisotropy);
    }
    if (memcmp(s->border, zero, sizeof zero) != 0) {
        write_floats(out, "  border", s->border, 4);
    }
}

static void write_stencil_face(FILE *out, const char *keyword, const gn_stencil_face *f)
{
    fprintf(out, "  %s %s %d %d %d %s %s %s\n", keyword, text_name(TEXT_COMPARE, (int)f->function),
            f->reference, f->compare_disabled, f->write_disabled,
            text_name(TEXT_STENCIL_OPERATION, (int)f->fail),
            text_name(TEXT_STENCIL_OPERATION, (int)f->depth_fail),
            text_name(TEXT_STENCIL_OPERATION, (int)f->pass));
}

static void write_state(FILE *out, const gn_pipeline *p)
{
    const float viewport[4] = {p->raster.viewport.x, p->raster.viewport.y, p->raster.viewport.width,
                               p->raster.viewport.height};
    const float range[2] = {p->depth.range.z_near, p->depth.range.z_far};

    fprintf(out, "  topology %s\n", text_name(TEXT_TOPOLOGY, (int)p->raster.topology));
    fprintf(out, "  provoking-vertex %s\n",
            text_name(TEXT_PROVOKING, (int)p->raster.provoking_vertex));
    fprintf(out, "  cull %s\n", text_name(TEXT_CULL, (int)p->raster.cull));
    fprintf(out, "  front-face %s\n", text_name(TEXT_FRONT_FACE, (int)p->raster.front_face));
    if (p->raster.viewport.set) {
        write_floats(out, "  viewport", viewport, 4);
    }
    if (p->depth.range.set) {
        write_floats(out, "  depth-range", range, 2);
    }
    if (p->raster.scissor.set) {
        fprintf(out, "  scissor %" PRId32 " %" PRId32 " %" PRIu32 " %" PRIu32 "\n",
                p->raster.scissor.x, p->raster.scissor.y, p->raster.scissor.width,
                p->raster.scissor.height);
    }
    if (p->raster.polygon_offset.set) {
        const float offset[3] = {p->raster.polygon_offset.factor, p->raster.polygon_offset.units,
                                 p->raster.polygon_offset.clamp};

        write_floats(out, "  polygon-offset", offset, 3);
    }
    fprintf(out, "  clip-depth %s\n", text_name(TEXT_CLIP_DEPTH, (int)p->depth.clip_depth));
    fprintf(out, "  depth-clamp %s\n", text_name(TEXT_SWITCH, p->depth.clamp));
    fprintf(out, "  depth-test %s\n", text_name(TEXT_SWITCH, p->depth.test));
    fprintf(out, "  depth-function %s\n", text_name(TEXT_COMPARE, (int)p->depth.function));
    fprintf(out, "  depth-write %s\n", text_name(TEXT_SWITCH, !p->depth.write_disabled));
    fprintf(out, "  stencil-test %s\n", text_name(TEXT_SWITCH, p->stencil.test));
    write_stencil_face(out, "stencil-front", &p->stencil.front);
    write_stencil_face(out, "stencil-back", &p->stencil.back);
    if (p->samples.write_disabled) {
        fprintf(out, "  samples-disabled %" PRIu32 "\n", p->samples.write_disabled);
    }
    if (p->samples.alpha_to_coverage || p->samples.alpha_to_one) {
        fprintf(out, "  alpha-to-coverage %s\n",
                text_name(TEXT_SWITCH, p->samples.alpha_to_coverage));
        fprintf(out, "  alpha-to-one %s\n", text_name(TEXT_SWITCH, p->samples.alpha_to_one));
    }
    fprintf(out, "  reads-position %s\n",
            text_name(TEXT_SWITCH, p->program.fragment_reads_position));
    fprintf(out, "  reads-primitive %s\n",
            text_name(TEXT_SWITCH, p->program.fragment_reads_primitive));
    fprintf(out, "  discards %s\n", text_name(TEXT_SWITCH, p->program.fragment_discards));
    fprintf(out, "  writes-depth %s\n", text_name(TEXT_SWITCH, p->program.fragment_writes_depth));
    if (p->raster.point_size != 0.0f) {
        write_floats(out, "  point-size", &p->raster.point_size, 1);
    }
    fprintf(out, "  program-point-size %s\n",
            text_name(TEXT_SWITCH, p->program.vertex_writes_point_size));
    if (p->raster.line_width != 0.0f) {
        write_floats(out, "  line-width", &p->raster.line_width, 1);
    }
    if (p->raster.point_origin != GN_POINT_UPPER_LEFT) {
        fprintf(out, "  point-origin %s\n",
                text_name(TEXT_POINT_ORIGIN, (int)p->raster.point_origin));
    }
    if (p->program.fragment_reads_point_coordinate) {
        fprintf(out, "  reads-point-coordinate on\n");
    }
    if (p->program.fragment_reads_sample_mask) {
        fprintf(out, "  reads-sample-mask on\n");
    }
    if (p->program.fragment_writes_sample_mask) {
        fprintf(out, "  writes-sample-mask on\n");
    }
    fprintf(out, "  polygon-mode %s %s\n",
            text_name(TEXT_POLYGON_MODE, (int)p->raster.polygon_mode_front),
            text_name(TEXT_POLYGON_MODE, (int)p->raster.polygon_mode_back));
    fprintf(out, "  interpolation %s %s %s %s\n",
            text_name(TEXT_INTERPOLATION, (int)p->program.interpolation[0]),
            text_name(TEXT_INTERPOLATION, (int)p->program.interpolation[1]),
            text_name(TEXT_INTERPOLATION, (int)p->program.interpolation[2]),
            text_name(TEXT_INTERPOLATION, (int)p->program.interpolation[3]));
}

/* Which attachment a keyword is for; nothing for the first. */
static void write_attachment(FILE *out, int attachment)
{
    if (attachment > 0) {
        fprintf(out, "-of %d", attachment);
    }
}

/* Nothing of what is as OpenGL has it at first. */
static void write_color_state(FILE *out, const gn_pipeline *p)
{
    static const float zero[4];

    if (p->program.color_count) {
        fprintf(out, "  color-count %" PRIu32 "\n", p->program.color_count);
    }
    for (int a = 0; a < GN_MAX_COLORS; ++a) {
        const gn_blend *b = &p->color.blend[a];

        if (p->color.write_disabled[a]) {
            fputs("  color-mask", out);
            write_attachment(out, a);
            for (unsigned c = 0; c < 4; ++c) {
                fprintf(out, " %s",
                        text_name(TEXT_SWITCH, !(p->color.write_disabled[a] >> c & 1u)));
            }
            fputc('\n', out);
        }
        if (b->enabled) {
            fputs("  blend", out);
            write_attachment(out, a);
            fprintf(out, " %s %s %s %s %s %s\n", text_name(TEXT_EQUATION, (int)b->equation),
                    text_name(TEXT_FACTOR, (int)b->source),
                    text_name(TEXT_FACTOR, (int)b->destination),
                    text_name(TEXT_EQUATION, (int)b->alpha_equation),
                    text_name(TEXT_FACTOR, (int)b->alpha_source),
                    text_name(TEXT_FACTOR, (int)b->alpha_destination));
        }
    }
    if (memcmp(p->color.blend_constant, zero, sizeof zero) != 0) {
        write_floats(out, "  blend-constant", p->color.blend_constant, 4);
    }
    if (p->color.logic) {
        fprintf(out, "  logic-operation %s\n",
                text_name(TEXT_LOGIC, (int)p->color.logic_operation));
    }
}

static void write_vec3(FILE *out, const char *keyword, gn_vec3 v)
{
    const float values[3] = {v.x, v.y, v.z};

    write_floats(out, keyword, values, 3);
}

static void write_point_light(FILE *out, const scene_surface *s)
{
    const float values[6] = {s->light_position.x, s->light_position.y, s->light_position.z,
                             s->attenuation[0],   s->attenuation[1],   s->attenuation[2]};

    if (s->has_point_light) {
        write_floats(out, "  world-from-model", &s->world_from_model.m[0][0], 16);
        write_floats(out, "  point-light", values, 6);
    }
}

static void write_shadow_sampler(FILE *out, const gn_sampler *s)
{
    fprintf(out, "  shadow-sampler %s %s %s %s %s", text_name(TEXT_WRAP, (int)s->wrap_s),
            text_name(TEXT_WRAP, (int)s->wrap_t), text_name(TEXT_MAGNIFY, (int)s->magnify),
            text_name(TEXT_MINIFY, (int)s->minify), text_name(TEXT_COMPARE, (int)s->compare));
    write_floats(out, "", s->border, 4);
}

static void write_surface(FILE *out, const scene_draw *d)
{
    const scene_surface *s = &d->surface;

    if (!s->has_point_light) {
        write_floats(out, "  world-from-model", &s->world_from_model.m[0][0], 16);
    }
    write_vec3(out, "  eye", s->eye);
    write_vec3(out, "  specular", d->specular);
    fprintf(out, "  exponent %" PRIu32 "\n  bands %" PRIu32 "\n  normal-space %s\n", s->exponent,
            s->bands, text_name(TEXT_NORMAL_SPACE, (int)s->normal_space));
    if (s->map[SCENE_SHADOW_MAP].level[0].texels) {
        write_shadow_sampler(out, &s->shadow_sampler);
        write_floats(out, "  shadow-from-world", &s->shadow_from_world.m[0][0], 16);
    }
    for (int m = 0; m < SCENE_MAP_COUNT; ++m) {
        if (s->map[m].level[0].texels) {
            write_levels(out, text_name(TEXT_MAP, m), &s->map[m]);
        }
    }
}

static void write_uniforms(FILE *out, const scene_draw *d)
{
    const scene_uniforms *u = &d->uniforms;
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
    write_point_light(out, &d->surface);
    if (scene_shader_shows_surface(d->shader)) {
        write_surface(out, d);
    }
    if (d->shader == SCENE_DEPTH_COLOR) {
        const float colors[2] = {d->surface.black, d->surface.white};

        write_floats(out, "  depth-colors", colors, 2);
    }
    write_sampler(out, &u->sampler);
    if (u->texture.level[0].texels) {
        write_texture(out, &u->texture);
    }
}

/* What zero means is not written. */
static void write_elements(FILE *out, const gn_mesh *mesh)
{
    for (int a = 0; a < text_name_count(TEXT_ATTRIBUTE); ++a) {
        if (mesh->attribute[a].divisor) {
            fprintf(out, "  divisor %s %" PRIu32 "\n", text_name(TEXT_ATTRIBUTE, a),
                    mesh->attribute[a].divisor);
        }
    }
    if (mesh->restart != GN_RESTART_NONE) {
        fprintf(out, "  restart %s %" PRIu32 "\n", text_name(TEXT_RESTART, (int)mesh->restart),
                mesh->restart_index);
    }
    if (mesh->base_vertex) {
        fprintf(out, "  base-vertex %" PRIu32 "\n", (uint32_t)mesh->base_vertex);
    }
    if (mesh->instance_count) {
        fprintf(out, "  instances %" PRIu32 "\n", mesh->instance_count);
    }
}

static void write_clear(FILE *out, const scene_clear *c)
{
    if (c->color) {
        write_floats(out, "  clears-color", c->color_value, 4);
    }
    if (c->depth) {
        fputs("  clears-depth", out);
        write_float(out, c->depth_value);
        fprintf(out, " %d\n", c->stencil_value);
    }
}

bool scene_write(const scene *s, FILE *out)
{
    bool has_more_colors = false;

    for (int a = 1; a < GN_MAX_COLORS; ++a) {
        has_more_colors |= scene_color_format(s, a) != GN_FORMAT_NONE;
    }
    fprintf(out, "gnomon-scene 1\nsize %" PRIu32 " %" PRIu32 "\n", s->width, s->height);
    fprintf(out, "color-format %s\n", text_name(TEXT_FORMAT, (int)s->color_format));
    if (has_more_colors) {
        fputs("more-colors", out);
        for (int a = 1; a < GN_MAX_COLORS; ++a) {
            fprintf(out, " %s", text_name(TEXT_FORMAT, (int)scene_color_format(s, a)));
        }
        fputc('\n', out);
    }
    fprintf(out, "depth-format %s\n", text_name(TEXT_FORMAT, (int)s->depth_format));
    write_floats(out, "clear-color", s->clear_color, 4);
    write_floats(out, "clear-depth", &s->clear_depth, 1);
    fprintf(out, "clear-stencil %d\n", s->clear_stencil);
    if (scene_is_sampled(s)) {
        fprintf(out, "samples %" PRIu32 "\n", s->samples);
    }
    for (size_t i = 0; i < s->draw_count; ++i) {
        const scene_draw *d = &s->draws[i];

        fprintf(out, "draw %s\n", text_name(TEXT_SHADER, (int)d->shader));
        fprintf(out, "  counted %s\n", text_name(TEXT_SWITCH, d->counted));
        write_clear(out, &d->clear);
        write_state(out, &d->state);
        write_color_state(out, &d->state);
        for (uint32_t p = 0; p < d->state.program.clip_distance_count; ++p) {
            write_floats(out, "  clip-plane", d->clip_plane[p], 4);
        }
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
        write_elements(out, &d->mesh);
        fprintf(out, "  elements %" PRIu32 " %" PRIu32 "\nend-draw\n", d->mesh.first,
                d->mesh.count);
    }
    fputs("end-scene\n", out);
    return fflush(out) == 0 && !ferror(out);
}
