/* Shrinks state, target and numbers: each member on its own to what a zeroed member means, the
 * target to the pixels that matter, numbers to fewer bits. */
#include <stdlib.h>
#include <string.h>

#include "scene_members.h"
#include "shrink_parts.h"

/* Tries other bytes at one offset of the scene. */
static bool replace(shrinking *s, size_t offset, const void *value, size_t size)
{
    if (memcmp((const char *)s->best + offset, value, size) == 0)
        return false;
    scene *candidate = scene_copy(s->best);
    memcpy((char *)candidate + offset, value, size);
    return shrink_try(s, candidate);
}

#define REPLACE(s, member, value) replace(s, offsetof(scene, member), &(value), sizeof(value))

/* Tries simpler formats, clear values and samples. */
static bool simplify_scene(shrinking *s)
{
    static const gn_format none = GN_FORMAT_NONE, simplest = GN_FORMAT_RGBA8;
    static const float black[4], farthest = 1.0f;
    static const uint8_t no_stencil = 0;
    static const uint32_t one_sample = 0;
    bool progress = REPLACE(s, depth_format, none);
    progress = REPLACE(s, color_format, simplest) || progress;
    for (int a = 0; a < GN_MAX_COLORS - 1; ++a)
        if (s->best->more_colors[a] != none)
            progress = REPLACE(s, more_colors[a], none) || REPLACE(s, more_colors[a], simplest) ||
                       progress;
    progress = REPLACE(s, clear_color, black) || progress;
    progress = REPLACE(s, clear_depth, farthest) || progress;
    progress = REPLACE(s, clear_stencil, no_stencil) || progress;
    return REPLACE(s, samples, one_sample) || progress;
}

/* Compares members, not bytes, because bytes between members have any values. */
static bool are_equal(const gn_stencil_face *a, const gn_stencil_face *b)
{
    return a->function == b->function && a->reference == b->reference &&
           a->compare_disabled == b->compare_disabled && a->write_disabled == b->write_disabled &&
           a->fail == b->fail && a->depth_fail == b->depth_fail && a->pass == b->pass;
}

/* Whether the reference is known to draw this draw otherwise than OpenGL, so that shrinking must
 * not turn another difference into this one: the stencil's back face in polygon modes
 * (reference/RULES.md). */
static bool is_left_out(const scene_draw *d)
{
    const gn_pipeline *p = &d->state;
    return (p->raster.polygon_mode_front != GN_POLYGON_FILL ||
            p->raster.polygon_mode_back != GN_POLYGON_FILL) &&
           p->stencil.test_enabled && d->shader != SCENE_INPUTS &&
           !are_equal(&p->stencil.front, &p->stencil.back);
}

/* Tries a candidate that differs in one draw, unless is_left_out holds for that draw. */
static bool try_draw(shrinking *s, scene *candidate, size_t draw)
{
    if (!is_left_out(&candidate->draws[draw]) || is_left_out(&s->best->draws[draw]))
        return shrink_try(s, candidate);
    scene_free(candidate);
    return false;
}

static float with_bits(float x, int bits)
{
    uint32_t pattern;
    memcpy(&pattern, &x, sizeof pattern);
    pattern &= ~UINT32_C(0) << (23 - bits);
    memcpy(&x, &pattern, sizeof x);
    return x;
}

static uint32_t float_with_bits(uint32_t word, int bits)
{
    float x;
    memcpy(&x, &word, sizeof x);
    x = with_bits(x, bits);
    memcpy(&word, &x, sizeof word);
    return word;
}

/* Returns the highest `bits` bits, counted from the first set bit. */
static uint32_t number_with_bits(uint32_t number, int bits)
{
    int length = 0;
    while (length < 32 && number >> length)
        ++length;
    return length > bits ? number >> (length - bits) << (length - bits) : number;
}

/* The ways to make a value simpler: 0 sets what shrinking prefers, 1 sets the default, 2 and on set
 * smaller and rounder numbers. */
#define WAYS 8

/* Returns the value made simpler in one of the ways, or the value itself. Between two values at
 * most one is simpler than the other, so that shrinking ends. */
static uint32_t simpler_value(const scene_member *m, uint32_t value, uint32_t by_default, int way)
{
    static const int float_bits[WAYS] = {0, 0, 0, 2, 4, 8, 12, 16},
                     number_bits[WAYS] = {0, 0, 0, 1, 2, 4, 8, 16};
    const uint32_t simplest = m->simplest ? m->simplest : by_default;
    if (value == simplest || way == 0)
        return simplest;
    if (value == by_default || way == 1)
        return by_default;
    const bool negative = m->type == MEMBER_INTEGER && value > INT32_MAX;
    const uint32_t magnitude = negative ? 0 - value : value;
    const uint32_t rounder =
        way == 2 ? magnitude / 2 : number_with_bits(magnitude, number_bits[way]);
    switch (m->type) {
    case MEMBER_BYTE:
    case MEMBER_NUMBER:
    case MEMBER_INTEGER:
        return negative ? 0 - rounder : rounder;
    case MEMBER_FLOAT:
        return float_with_bits(value, float_bits[way]);
    default:
        return value;
    }
}

/* Returns a copy of the scene with a member's line simpler in one of the ways; null where no value
 * changes. */
static scene *simpler_line(const scene *s, size_t draw, const scene_member *m, size_t line, int way)
{
    const scene_draw *d = &s->draws[draw];
    scene_draw by_default;
    scene *copy = NULL;
    scene_default_draw(&by_default);
    for (size_t v = 0; v < scene_member_values(m); ++v) {
        const uint32_t value = scene_member_get(m, d, line, v);
        const uint32_t simpler =
            simpler_value(m, value, scene_member_get(m, &by_default, line, v), way);
        if (simpler == value)
            continue;
        copy = copy ? copy : scene_copy(s);
        scene_member_set(m, &copy->draws[draw], line, v, simpler);
    }
    return copy;
}

static bool simplify_member(shrinking *s, size_t draw, const scene_member *m)
{
    bool progress = false;
    for (size_t line = 0; line < scene_member_lines(m); ++line)
        for (int way = 0; way < WAYS; ++way) {
            scene *candidate = simpler_line(s->best, draw, m, line, way);
            if (candidate && try_draw(s, candidate, draw)) {
                progress = true;
                break;
            }
        }
    return progress;
}

/* Tries simpler shaders. SCENE_VERTEX_COLOR ignores what the program says of the fragment shader,
 * so the program's switches for it are turned off too. */
static bool simplify_shader(shrinking *s, size_t draw)
{
    static const scene_shader shaders[] = {SCENE_VERTEX_COLOR, SCENE_GOURAUD};
    for (size_t i = 0; i < sizeof shaders / sizeof *shaders; ++i) {
        if (s->best->draws[draw].shader <= shaders[i])
            continue;
        scene *candidate = scene_copy(s->best);
        candidate->draws[draw].shader = shaders[i];
        for (size_t m = 0; m < scene_member_count && shaders[i] == SCENE_VERTEX_COLOR; ++m)
            if (strncmp(scene_members[m].name, "program.fragment_", 17) == 0 &&
                scene_members[m].type == MEMBER_SWITCH)
                scene_member_set(&scene_members[m], &candidate->draws[draw], 0, 0, false);
        if (try_draw(s, candidate, draw))
            return true;
    }
    return false;
}

/* Tries the draw without the last clip plane, then without the first. */
static bool remove_plane(shrinking *s, size_t draw, bool first)
{
    scene *candidate = scene_copy(s->best);
    scene_draw *d = &candidate->draws[draw];
    if (d->state.program.clip_distance_count == 0) {
        scene_free(candidate);
        return false;
    }
    --d->state.program.clip_distance_count;
    if (first)
        memmove(d->clip_plane[0], d->clip_plane[1],
                (GN_MAX_CLIP_DISTANCES - 1) * sizeof *d->clip_plane);
    return try_draw(s, candidate, draw);
}

bool shrink_state(shrinking *s)
{
    bool progress = simplify_scene(s);
    for (size_t i = 0; i < s->best->draw_count; ++i) {
        progress = simplify_shader(s, i) || progress;
        for (size_t m = 0; m < scene_member_count; ++m)
            if (scene_members[m].type != MEMBER_ELSEWHERE)
                progress = simplify_member(s, i, &scene_members[m]) || progress;
        progress = remove_plane(s, i, false) || progress;
        progress = remove_plane(s, i, true) || progress;
    }
    return progress;
}

/* Cuts the target to a part of it. Viewports move, so that everything stays where it was. */
static scene *cropped(const scene *s, uint32_t x, uint32_t y, uint32_t width, uint32_t height)
{
    scene *copy = scene_copy(s);
    for (size_t i = 0; i < copy->draw_count; ++i) {
        gn_viewport *v = &copy->draws[i].state.raster.viewport;
        if (!v->enabled) {
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
        for (int side = 0; side < 4; ++side) {
            const uint32_t w = s->best->width, h = s->best->height;
            if ((side < 2 ? w : h) <= chunk)
                continue;
            const uint32_t x = side == 0 ? chunk : 0, y = side == 2 ? chunk : 0;
            if (shrink_try(s, cropped(s->best, x, y, side < 2 ? w - chunk : w,
                                      side < 2 ? h : h - chunk))) {
                progress = true;
                --side;
            }
        }
    return progress;
}

/* Sets an attribute and keeps the mesh's elements: setting positions would make a mesh without
 * indices draw all its vertices. */
static void replace_attribute(scene_draw *d, int a, const float *data, uint32_t components)
{
    const uint32_t first = d->mesh.first, count = d->mesh.count;
    scene_set_attribute(d, (gn_shader_attribute)a, data, components, d->mesh.vertex_count);
    d->mesh.first = first;
    d->mesh.count = count;
}

/* Returns the best scene with attribute a simplified in one vertex of a draw, or in all vertices if
 * vertex is UINT32_MAX. Cuts the attribute to `bits` bits, or sets it to one if bits < 0. Returns
 * null if nothing changes. */
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
    for (size_t i = 0; i < count; ++i)
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
    for (size_t b = a == GN_ATTRIBUTE_POSITION ? 1 : 0; b < sizeof bits / sizeof *bits; ++b) {
        scene *candidate = simpler_attribute(s->best, draw, a, UINT32_MAX, bits[b]);
        if (candidate && shrink_try(s, candidate))
            return true;
    }
    for (uint32_t v = 0; v < single; ++v)
        for (size_t b = 1; b < sizeof bits / sizeof *bits; ++b) {
            scene *candidate = simpler_attribute(s->best, draw, a, v, bits[b]);
            if (candidate && shrink_try(s, candidate)) {
                progress = true;
                break;
            }
        }
    return progress;
}

/* Makes clip coordinates the positions and the identity the matrix. */
static bool apply_matrix(shrinking *s, size_t draw)
{
    const scene_draw *d = &s->best->draws[draw];
    const gn_attribute *from = &d->mesh.attribute[GN_ATTRIBUTE_POSITION];
    const gn_mat4 *m = &d->uniforms.light.clip_from_model;
    gn_mat4 identity = {{{0}}};
    for (int i = 0; i < 4; ++i)
        identity.m[i][i] = 1.0f;
    if (!from->data || memcmp(m, &identity, sizeof identity) == 0)
        return false;
    float *data = malloc(d->mesh.vertex_count * 4 * sizeof *data);
    if (!data)
        return false;
    for (uint32_t i = 0; i < d->mesh.vertex_count; ++i) {
        float p[4] = {0.0f, 0.0f, 0.0f, 1.0f};
        memcpy(p, from->data + (size_t)i * from->components, from->components * sizeof *p);
        for (int row = 0; row < 4; ++row)
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
    for (size_t i = 0; i < s->best->draw_count; ++i) {
        progress = apply_matrix(s, i) || progress;
        progress = shrink_texture(s, i) || progress;
        for (int a = 0; a <= GN_ATTRIBUTE_TEXCOORD; ++a)
            progress = simplify_attribute(s, i, a) || progress;
    }
    return progress;
}
