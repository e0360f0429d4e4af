/* Shrinking state, target and numbers: each member on its own to what a zeroed one
 * means, the target to the pixels that matter, numbers to fewer bits. */
#include <stdlib.h>
#include <string.h>

#include "shrink_parts.h"

/* Sets one member, counted by `step`, of the scene to its simplest value. False where it
 * has that value; *last where there is no such member. */
static bool simplify_scene(scene *s, unsigned step, bool *last)
{
    switch (step) {
    case 0: {
        const bool change = s->depth_format != GN_FORMAT_NONE;
        s->depth_format = GN_FORMAT_NONE;
        return change;
    }
    case 1: {
        const bool change = s->color_format != GN_FORMAT_RGBA8;
        s->color_format = GN_FORMAT_RGBA8;
        return change;
    }
    case 2: {
        const float zero[4] = {0.0f, 0.0f, 0.0f, 0.0f};
        const bool change = memcmp(s->clear_color, zero, sizeof zero) != 0;
        memcpy(s->clear_color, zero, sizeof zero);
        return change;
    }
    case 3: {
        const bool change = s->clear_depth != 1.0f;
        s->clear_depth = 1.0f;
        return change;
    }
    case 4: {
        const bool change = s->clear_stencil != 0;
        s->clear_stencil = 0;
        return change;
    }
    case 5:
    case 6:
    case 7:
    case 8:
    case 9:
    case 10:
    case 11: {
        gn_format *const more = &s->more_colors[step - 5];
        const bool change = *more != GN_FORMAT_NONE;
        *more = GN_FORMAT_NONE;
        return change;
    }
    case 12:
    case 13:
    case 14:
    case 15:
    case 16:
    case 17:
    case 18: {
        gn_format *const more = &s->more_colors[step - 12];
        const bool change = *more != GN_FORMAT_NONE && *more != GN_FORMAT_RGBA8;
        *more = change ? GN_FORMAT_RGBA8 : *more;
        return change;
    }
    case 19: {
        const bool change = s->samples != 0;
        s->samples = 0;
        return change;
    }
    default:
        *last = true;
        return false;
    }
}

/* Sets one member of a stencil face to its simplest value. False where it has that value. */
static bool simplify_face(gn_stencil_face *f, unsigned member)
{
    gn_stencil_face was = *f;
    if (member == 0)
        f->function = GN_COMPARE_DEFAULT;
    else if (member == 1)
        f->reference = 0;
    else if (member == 2)
        f->compare_disabled = 0;
    else if (member == 3)
        f->write_disabled = 0;
    else if (member == 4)
        f->fail = GN_STENCIL_KEEP;
    else if (member == 5)
        f->depth_fail = GN_STENCIL_KEEP;
    else
        f->pass = GN_STENCIL_KEEP;
    return memcmp(&was, f, sizeof was) != 0;
}

/* The same for a draw. */
static bool simplify_draw(scene_draw *d, unsigned step, bool *last)
{
    gn_pipeline *p = &d->state;
    bool change = false;
    switch (step) {
    case 0:
        change = d->shader != SCENE_VERTEX_COLOR;
        d->shader = SCENE_VERTEX_COLOR;
        p->program.fragment_reads_primitive = p->program.fragment_reads_point_coordinate = false;
        p->program.fragment_reads_sample_mask = p->program.fragment_writes_sample_mask = false;
        p->program.fragment_reads_position = p->program.fragment_discards =
            p->program.fragment_writes_depth = false;
        return change;
    case 1:
        change = d->shader > SCENE_GOURAUD;
        d->shader = change ? SCENE_GOURAUD : d->shader;
        return change;
    case 2:
        change = p->depth.test;
        p->depth.test = false;
        return change;
    case 3:
        change = p->depth.function != GN_COMPARE_DEFAULT;
        p->depth.function = GN_COMPARE_DEFAULT;
        return change;
    case 4:
        change = p->depth.write_disabled;
        p->depth.write_disabled = false;
        return change;
    case 5:
        change = p->depth.range.set;
        memset(&p->depth.range, 0, sizeof p->depth.range);
        return change;
    case 6:
        change = p->raster.viewport.set;
        memset(&p->raster.viewport, 0, sizeof p->raster.viewport);
        return change;
    case 7:
        change = p->raster.cull != GN_CULL_NONE;
        p->raster.cull = GN_CULL_NONE;
        return change;
    case 8:
        change = p->raster.front_face != GN_FRONT_COUNTER_CLOCKWISE;
        p->raster.front_face = GN_FRONT_COUNTER_CLOCKWISE;
        return change;
    case 9:
        change = p->raster.provoking_vertex != GN_PROVOKING_LAST;
        p->raster.provoking_vertex = GN_PROVOKING_LAST;
        return change;
    case 10:
    case 11:
    case 12:
    case 13:
        change = p->program.interpolation[step - 10] != GN_SMOOTH;
        p->program.interpolation[step - 10] = GN_SMOOTH;
        return change;
    case 14:
        change = d->uniforms.sampler.magnify != GN_MAGNIFY_NEAREST ||
                 d->uniforms.sampler.minify != GN_MINIFY_NEAREST;
        d->uniforms.sampler.magnify = GN_MAGNIFY_NEAREST;
        d->uniforms.sampler.minify = GN_MINIFY_NEAREST;
        return change && scene_shader_is_textured(d->shader);
    case 15:
        change = p->raster.polygon_offset.set;
        memset(&p->raster.polygon_offset, 0, sizeof p->raster.polygon_offset);
        return change;
    case 16:
        change = p->raster.polygon_offset.clamp != 0.0f;
        p->raster.polygon_offset.clamp = 0.0f;
        return change;
    case 17:
        change = p->raster.polygon_offset.factor != 0.0f;
        p->raster.polygon_offset.factor = 0.0f;
        return change;
    case 18:
        change = p->raster.polygon_offset.units != 0.0f;
        p->raster.polygon_offset.units = 0.0f;
        return change;
    case 19:
        change = p->depth.clamp;
        p->depth.clamp = false;
        return change;
    case 20:
        change = p->depth.clip_depth != GN_NEGATIVE_ONE_TO_ONE;
        p->depth.clip_depth = GN_NEGATIVE_ONE_TO_ONE;
        return change;
    case 21:
        change = p->raster.scissor.set;
        memset(&p->raster.scissor, 0, sizeof p->raster.scissor);
        return change;
    case 22:
        change = p->color.write_disabled[0] != 0;
        p->color.write_disabled[0] = 0;
        return change;
    case 23:
        change = p->color.blend[0].enabled;
        memset(&p->color.blend[0], 0, sizeof p->color.blend[0]);
        return change;
    case 24:
        change = p->color.blend[0].equation != GN_EQUATION_DEFAULT;
        p->color.blend[0].equation = GN_EQUATION_DEFAULT;
        return change;
    case 25:
        change = p->color.blend[0].alpha_equation != GN_EQUATION_DEFAULT;
        p->color.blend[0].alpha_equation = GN_EQUATION_DEFAULT;
        return change;
    case 26:
        change = p->color.blend[0].source != GN_FACTOR_DEFAULT;
        p->color.blend[0].source = GN_FACTOR_DEFAULT;
        return change;
    case 27:
        change = p->color.blend[0].destination != GN_FACTOR_DEFAULT;
        p->color.blend[0].destination = GN_FACTOR_DEFAULT;
        return change;
    case 28:
        change = p->color.blend[0].alpha_source != GN_FACTOR_DEFAULT;
        p->color.blend[0].alpha_source = GN_FACTOR_DEFAULT;
        return change;
    case 29:
        change = p->color.blend[0].alpha_destination != GN_FACTOR_DEFAULT;
        p->color.blend[0].alpha_destination = GN_FACTOR_DEFAULT;
        return change;
    case 30:
        for (int c = 0; c < 4; c++) {
            change = change || p->color.blend_constant[c] != 0.0f;
            p->color.blend_constant[c] = 0.0f;
        }
        return change;
    case 31:
        change = p->color.logic;
        p->color.logic = false;
        p->color.logic_operation = GN_LOGIC_COPY;
        return change;
    case 32:
        change = p->color.logic_operation != GN_LOGIC_COPY;
        p->color.logic_operation = GN_LOGIC_COPY;
        return change;
    case 33:
        change = p->program.fragment_reads_position;
        p->program.fragment_reads_position = false;
        return change;
    case 34:
        change = p->program.fragment_discards;
        p->program.fragment_discards = false;
        return change;
    case 35:
        change = p->program.fragment_writes_depth;
        p->program.fragment_writes_depth = false;
        return change;
    case 36:
        change = p->program.fragment_reads_primitive;
        p->program.fragment_reads_primitive = false;
        return change;
    case 37:
        change = d->counted;
        d->counted = false;
        return change;
    case 38:
        change = p->stencil.test;
        p->stencil.test = false;
        return change;
    case 39:
    case 40:
    case 41:
    case 42:
    case 43:
    case 44:
    case 45:
        return simplify_face(&p->stencil.front, step - 39);
    case 46:
    case 47:
    case 48:
    case 49:
    case 50:
    case 51:
    case 52:
        return simplify_face(&p->stencil.back, step - 46);
    case 53:
        change = p->raster.point_size != 0.0f;
        p->raster.point_size = 0.0f;
        return change;
    case 54:
        change = p->program.vertex_writes_point_size;
        p->program.vertex_writes_point_size = false;
        return change;
    case 55:
        change = p->raster.line_width != 0.0f;
        p->raster.line_width = 0.0f;
        return change;
    case 56:
        change = d->mesh.instance_count > 1;
        d->mesh.instance_count = 0;
        return change;
    case 57:
        change = false;
        for (int a = 0; a < GN_MAX_ATTRIBUTES; a++) {
            change = change || d->mesh.attribute[a].divisor;
            d->mesh.attribute[a].divisor = 0;
        }
        return change;
    case 58:
        change = p->program.color_count > 1;
        p->program.color_count = 0;
        return change;
    case 59:
    case 60:
    case 61:
    case 62:
    case 63:
    case 64:
    case 65:
        change = p->color.blend[step - 58].enabled;
        memset(&p->color.blend[step - 58], 0, sizeof p->color.blend[0]);
        return change;
    case 66:
    case 67:
    case 68:
    case 69:
    case 70:
    case 71:
    case 72:
        change = p->color.write_disabled[step - 65] != 0;
        p->color.write_disabled[step - 65] = 0;
        return change;
    case 73:
        change = p->samples.write_disabled != 0;
        p->samples.write_disabled = 0;
        return change;
    case 74:
        change = p->samples.alpha_to_coverage;
        p->samples.alpha_to_coverage = false;
        return change;
    case 75:
        change = p->samples.alpha_to_one;
        p->samples.alpha_to_one = false;
        return change;
    case 76:
        change = p->program.fragment_reads_point_coordinate;
        p->program.fragment_reads_point_coordinate = false;
        return change;
    case 77:
        change = p->raster.point_origin != GN_POINT_UPPER_LEFT;
        p->raster.point_origin = GN_POINT_UPPER_LEFT;
        return change;
    case 78:
        change = p->program.clip_distance_count > 0;
        p->program.clip_distance_count = 0;
        return change;
    case 79:
        change = p->program.clip_distance_count > 0;
        p->program.clip_distance_count -= change;
        return change;
    case 80: /* without the first of them */
        change = p->program.clip_distance_count > 1;
        p->program.clip_distance_count -= change;
        memmove(d->clip_plane[0], d->clip_plane[change], 7 * sizeof *d->clip_plane);
        return change;
    case 81:
        change = p->raster.polygon_mode_front != GN_POLYGON_FILL;
        p->raster.polygon_mode_front = GN_POLYGON_FILL;
        return change;
    case 82:
        change = p->raster.polygon_mode_back != GN_POLYGON_FILL;
        p->raster.polygon_mode_back = GN_POLYGON_FILL;
        return change;
    case 83:
        change = p->program.fragment_reads_sample_mask;
        p->program.fragment_reads_sample_mask = false;
        return change;
    case 84:
        change = p->program.fragment_writes_sample_mask;
        p->program.fragment_writes_sample_mask = false;
        return change;
    default:
        return shrink_sampler(&d->uniforms.sampler, step - 83, last) &&
               scene_shader_is_textured(d->shader);
    }
}

/* Whether shrinking has come to what the reference draws otherwise than OpenGL, whatever it was
 * that differed: the stencil's back face in polygon modes (reference/RULES.md). */
static bool is_left_out(const scene_draw *d)
{
    const gn_pipeline *p = &d->state;
    return (p->raster.polygon_mode_front != GN_POLYGON_FILL ||
            p->raster.polygon_mode_back != GN_POLYGON_FILL) &&
           p->stencil.test && d->shader != SCENE_INPUTS &&
           memcmp(&p->stencil.front, &p->stencil.back, sizeof p->stencil.front) != 0;
}

bool shrink_state(shrinking *s)
{
    bool progress = false, last = false;
    for (unsigned step = 0; !last; step++) {
        scene *candidate = scene_copy(s->best);
        if (simplify_scene(candidate, step, &last))
            progress = shrink_try(s, candidate) || progress;
        else
            scene_free(candidate);
    }
    for (size_t i = 0; i < s->best->draw_count; i++) {
        last = false;
        for (unsigned step = 0; !last; step++) {
            scene *candidate = scene_copy(s->best);
            if (simplify_draw(&candidate->draws[i], step, &last) &&
                !is_left_out(&candidate->draws[i]))
                progress = shrink_try(s, candidate) || progress;
            else
                scene_free(candidate);
        }
    }
    return progress;
}

/* A part of the target, under viewports that put everything where it was. */
static scene *cropped(const scene *s, uint32_t x, uint32_t y, uint32_t width, uint32_t height)
{
    scene *copy = scene_copy(s);
    for (size_t i = 0; i < copy->draw_count; i++) {
        gn_viewport *v = &copy->draws[i].state.raster.viewport;
        if (!v->set) {
            const gn_viewport whole = {true, 0.0f, 0.0f, (float)s->width, (float)s->height};
            *v = whole;
        }
        v->x -= (float)x;
        v->y -= (float)y;
        copy->draws[i].state.raster.scissor.x -= (int32_t)x;
        copy->draws[i].state.raster.scissor.y -= (int32_t)y;
    }
    copy->width = width;
    copy->height = height;
    return copy;
}

/* Cuts columns and rows off at the four sides: half, a quarter, down to one. */
bool shrink_target(shrinking *s)
{
    bool progress = false;
    uint32_t chunk = s->best->width > s->best->height ? s->best->width : s->best->height;
    for (chunk = (chunk + 1) / 2; chunk > 0; chunk /= 2)
        for (int side = 0; side < 4; side++) {
            const uint32_t w = s->best->width, h = s->best->height;
            if ((side < 2 ? w : h) <= chunk)
                continue;
            const uint32_t x = side == 0 ? chunk : 0, y = side == 2 ? chunk : 0;
            if (shrink_try(s, cropped(s->best, x, y, side < 2 ? w - chunk : w,
                                      side < 2 ? h : h - chunk))) {
                progress = true;
                side--;
            }
        }
    return progress;
}

static float with_bits(float x, int bits)
{
    uint32_t pattern;
    memcpy(&pattern, &x, sizeof pattern);
    pattern &= ~UINT32_C(0) << (23 - bits);
    memcpy(&x, &pattern, sizeof x);
    return x;
}

/* Setting positions makes a mesh without indices one of all its vertices. */
static void replace_attribute(scene_draw *d, int a, const float *data, uint32_t components)
{
    const uint32_t first = d->mesh.first, count = d->mesh.count;
    scene_set_attribute(d, (gn_shader_attribute)a, data, components, d->mesh.vertex_count);
    d->mesh.first = first;
    d->mesh.count = count;
}

/* The best scene with attribute a of a draw simplified in one vertex, or in all of them
 * where vertex is UINT32_MAX: cut to `bits` bits, or for bits < 0 set to one. Null
 * where nothing changes. */
static scene *simpler_attribute(const scene *s, size_t draw, int a, uint32_t vertex, int bits)
{
    const gn_mesh *mesh = &s->draws[draw].mesh;
    const gn_attribute *from = &mesh->attribute[a];
    if (!from->data)
        return NULL;
    const size_t count = (size_t)mesh->vertex_count * from->components;
    float *data = malloc(count > 0 ? count * sizeof *data : 1);
    if (!data)
        return NULL;
    memcpy(data, from->data, count * sizeof *data);
    for (size_t i = 0; i < count; i++)
        if (vertex == UINT32_MAX || i / from->components == vertex)
            data[i] = bits < 0 ? 1.0f : with_bits(data[i], bits);
    scene *copy = NULL;
    if (memcmp(data, from->data, count * sizeof *data) != 0) {
        copy = scene_copy(s);
        replace_attribute(&copy->draws[draw], a, data, from->components);
    }
    free(data);
    return copy;
}

static bool simplify_attribute(shrinking *s, size_t draw, int a)
{
    static const int bits[] = {-1, 0, 2, 4, 8, 12, 16};
    bool progress = false;
    const uint32_t vertices = s->best->draws[draw].mesh.vertex_count;
    const uint32_t single = vertices <= 12 ? vertices : 0;
    for (size_t b = a == GN_ATTRIBUTE_POSITION ? 1 : 0; b < sizeof bits / sizeof *bits; b++) {
        scene *candidate = simpler_attribute(s->best, draw, a, UINT32_MAX, bits[b]);
        if (candidate && shrink_try(s, candidate))
            return true;
    }
    for (uint32_t v = 0; v < single; v++)
        for (size_t b = 1; b < sizeof bits / sizeof *bits; b++) {
            scene *candidate = simpler_attribute(s->best, draw, a, v, bits[b]);
            if (candidate && shrink_try(s, candidate)) {
                progress = true;
                break;
            }
        }
    return progress;
}

/* Clip coordinates as the positions, the identity as the matrix. */
static bool apply_matrix(shrinking *s, size_t draw)
{
    const scene_draw *d = &s->best->draws[draw];
    const gn_attribute *from = &d->mesh.attribute[GN_ATTRIBUTE_POSITION];
    const gn_mat4 *m = &d->uniforms.light.clip_from_model;
    gn_mat4 identity = {{{0}}};
    for (int i = 0; i < 4; i++)
        identity.m[i][i] = 1.0f;
    if (!from->data || memcmp(m, &identity, sizeof identity) == 0)
        return false;
    float *data = malloc(d->mesh.vertex_count * 4 * sizeof *data);
    if (!data)
        return false;
    for (uint32_t i = 0; i < d->mesh.vertex_count; i++) {
        float p[4] = {0.0f, 0.0f, 0.0f, 1.0f};
        memcpy(p, from->data + (size_t)i * from->components, from->components * sizeof *p);
        for (int row = 0; row < 4; row++)
            data[4 * i + (uint32_t)row] =
                ((m->m[0][row] * p[0] + m->m[1][row] * p[1]) + m->m[2][row] * p[2]) +
                m->m[3][row] * p[3];
    }
    scene *copy = scene_copy(s->best);
    copy->draws[draw].uniforms.light.clip_from_model = identity;
    replace_attribute(&copy->draws[draw], GN_ATTRIBUTE_POSITION, data, 4);
    free(data);
    return shrink_try(s, copy);
}

bool shrink_numbers(shrinking *s)
{
    bool progress = false;
    for (size_t i = 0; i < s->best->draw_count; i++) {
        progress = apply_matrix(s, i) || progress;
        progress = shrink_texture(s, i) || progress;
        for (int a = 0; a <= GN_ATTRIBUTE_TEXCOORD; a++)
            progress = simplify_attribute(s, i, a) || progress;
    }
    return progress;
}
