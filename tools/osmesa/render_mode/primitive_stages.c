#include "primitive_stages.h"

#include <gl_registry.h>
#include <math.h>

#include "../draw/draw_state.h"
#include "../draw/unfilled.h"
#include "../vertices/polygons.h"
#include "primitive_clip.h"

/* What the stages of one draw need to know. */
typedef struct stages {
    context *gl;
    placement place;
    const primitive_sink *sink;
    GLenum mode[2];                 /* of front and back faces; of both, if one is culled */
    bool has_unfilled;              /* one of them is not GL_FILL */
    bool knows_side;                /* a stage needs the side that is seen */
    bool is_front_counterclockwise; /* in rows that go down */
    bool has_offset, knows_offset;
    GLfloat offset_factor, offset_units; /* of the first triangle's mode, once it is known */
} stages;

/* A triangle after clipping. */
typedef struct staged_triangle {
    shaded_vertex v[3];
    unsigned edges;
    bool begins_pattern;
    GLfloat area; /* twice, negative if counterclockwise in rows that go down */
} staged_triangle;

static bool is_front(const stages *s, const staged_triangle *t)
{
    return (t->area < 0.0f) == s->is_front_counterclockwise;
}

/* Triangles without area are back faces where culling decides. */
static bool is_culled(const stages *s, const staged_triangle *t)
{
    const raster_state *const r = &s->gl->raster;
    const bool is_front_face = t->area != 0.0f && is_front(s, t);

    return r->cull && r->cull_face != (is_front_face ? GL_BACK : GL_FRONT);
}

/* Gives the colours of the back to a triangle that shows it. */
static void choose_side(const stages *s, staged_triangle *t)
{
    const fixed_function *const fixed = s->place.fixed;

    if (!fixed->lighting.enabled || !fixed->lighting.two_side || is_front(s, t))
        return;
    for (int i = 0; i < 3; ++i) {
        GLfloat *const varying = t->v[i].varying;

        for (int c = 0; c < 4; ++c)
            varying[fixed->color_varying + c] = varying[fixed->back_color_varying + c];
        for (int c = 0; c < 3 && fixed->secondary_varying >= 0; ++c)
            varying[fixed->secondary_varying + c] = varying[fixed->back_secondary_varying + c];
    }
}

static bool offsets_mode(const raster_state *r, GLenum mode)
{
    return mode == GL_POINT ? r->offset_point : mode == GL_LINE ? r->offset_line : r->offset_fill;
}

static bool has_float_depth(gn_format format)
{
    return format == GN_FORMAT_D32F || format == GN_FORMAT_D32FS8;
}

static GLfloat clamped_depth(GLfloat z)
{
    return !(z > 0.0f) ? 0.0f : z > 1.0f ? 1.0f : z;
}

/* Returns what a unit of an offset is, as gn_polygon_offset says; 0 without a format, and 1 for
 * floats, whose steps depend on the depth. */
static double depth_step(gn_format format)
{
    return format == GN_FORMAT_NONE  ? 0.0
           : format == GN_FORMAT_D16 ? 2.0 / 65535.0
           : has_float_depth(format) ? 1.0
                                     : 2.0 / 16777215.0;
}

/* As in the reference, the mode of the first triangle decides for all of the draw. */
static void set_offset(stages *s, const staged_triangle *t)
{
    const raster_state *const r = &s->gl->raster;
    const bool is_back = s->mode[0] != s->mode[1] && !is_front(s, t);
    const bool is_offset = offsets_mode(r, s->mode[is_back]);

    s->offset_factor = is_offset ? r->offset_factor : 0.0f;
    s->offset_units =
        is_offset ? (GLfloat)((double)r->offset_units * depth_step(s->sink->depth_format)) : 0.0f;
    s->knows_offset = true;
}

/* Returns the step of floats of the exponent of the greatest depth of a triangle. */
static GLfloat float_step(const staged_triangle *t)
{
    GLfloat greatest = 0.0f;
    int exponent;

    for (int i = 0; i < 3; ++i)
        greatest = fmaxf(greatest, fabsf(t->v[i].window[2]));
    frexpf(greatest, &exponent);
    return greatest > 0.0f ? ldexpf(1.0f, exponent - 24) : 0.0f;
}

/* Offsets depths by their slope, and by steps. */
static void offset_depths(stages *s, staged_triangle *t)
{
    const GLfloat *const a = t->v[0].window, *const b = t->v[1].window, *const c = t->v[2].window;
    const GLfloat inverse = 1.0f / t->area;
    const GLfloat e[3] = {a[0] - c[0], a[1] - c[1], a[2] - c[2]};
    const GLfloat f[3] = {b[0] - c[0], b[1] - c[1], b[2] - c[2]};
    const GLfloat per_x = fabsf((e[1] * f[2] - e[2] * f[1]) * inverse);
    const GLfloat per_y = fabsf((e[2] * f[0] - e[0] * f[2]) * inverse);
    GLfloat offset;

    if (!s->knows_offset)
        set_offset(s, t);
    offset = (per_x > per_y ? per_x : per_y) * s->offset_factor +
             s->offset_units * (has_float_depth(s->sink->depth_format) ? float_step(t) : 1.0f);
    for (int i = 0; i < 3; ++i) {
        GLfloat *const z = &t->v[i].window[2];

        *z = clamped_depth(*z + offset);
    }
}

static void pass_lines(const stages *s, const staged_triangle *t)
{
    static const int order[3] = {2, 0, 1};

    if (t->begins_pattern)
        s->sink->begin_pattern(s->sink->user);
    for (int k = 0; k < 3; ++k)
        if (t->edges >> order[k] & 1u)
            s->sink->line(s->sink->user, &s->place, &t->v[order[k]], &t->v[(order[k] + 1) % 3],
                          false);
}

/* A triangle without area has the mode of those that are clockwise. */
static void pass_unfilled(const stages *s, const staged_triangle *t)
{
    const bool is_front_face = !(t->area >= 0.0f) == s->is_front_counterclockwise;
    const GLenum mode = s->mode[is_front_face ? 0 : 1];
    const shaded_vertex *const v[3] = {&t->v[0], &t->v[1], &t->v[2]};

    if (mode == GL_FILL) {
        s->sink->triangle(s->sink->user, &s->place, v);
    } else if (mode == GL_LINE) {
        pass_lines(s, t);
    } else {
        for (int k = 0; k < 3; ++k)
            if (t->edges >> k & 1u)
                s->sink->point(s->sink->user, &s->place, v[k]);
    }
}

static void pass_staged(stages *s, staged_triangle *t)
{
    const GLfloat *const a = t->v[0].window, *const b = t->v[1].window, *const c = t->v[2].window;

    t->area = (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0]);
    if (s->knows_side && is_culled(s, t))
        return;
    choose_side(s, t);
    if (s->has_offset)
        offset_depths(s, t);
    if (s->has_unfilled) {
        for (int i = 0; i < 2; ++i)
            copy_flat_varyings(&s->place, &t->v[2], &t->v[i]);
        pass_unfilled(s, t);
    } else {
        s->sink->triangle(s->sink->user, &s->place,
                          (const shaded_vertex *const[]){&t->v[0], &t->v[1], &t->v[2]});
    }
}

/* Passes the triangles of what clipping leaves. */
static void pass_polygon(stages *s, const clipped_polygon *polygon)
{
    for (uint32_t i = 2; i < polygon->count; ++i) {
        staged_triangle t = {
            .v = {*polygon->vertex[i - 1], *polygon->vertex[i], *polygon->vertex[0]},
            .begins_pattern = i == 2};

        t.edges = (unsigned)polygon->has_edge[i - 1] |
                  (unsigned)(i + 1 == polygon->count && polygon->has_edge[i]) << 1 |
                  (unsigned)(i == 2 && polygon->has_edge[0]) << 2;
        pass_staged(s, &t);
    }
}

static void pass_triangle(stages *s, const shaded_vertex *const v[3], unsigned edges,
                          bool begins_pattern)
{
    clipped_polygon polygon;
    staged_triangle t;

    if (v[0]->outside | v[1]->outside | v[2]->outside) {
        clip_triangle(&s->place, v, edges, &polygon);
        pass_polygon(s, &polygon);
        return;
    }
    for (int i = 0; i < 3; ++i)
        t.v[i] = *v[i];
    t.edges = edges;
    t.begins_pattern = begins_pattern;
    pass_staged(s, &t);
}

static void pass_line(stages *s, const shaded_vertex *a, const shaded_vertex *b,
                      bool begins_pattern)
{
    shaded_vertex end[2];

    if (!clip_line(&s->place, a, b, end))
        return;
    if (s->has_unfilled)
        copy_flat_varyings(&s->place, &end[1], &end[0]);
    s->sink->line(s->sink->user, &s->place, &end[0], &end[1], begins_pattern);
}

/* Elements of a mesh, each a vertex. */
typedef struct elements {
    const gn_mesh *mesh;
    const shaded_vertex *vertex;
} elements;

/* Returns the vertex of an element, null if the mesh has no such vertex. */
static const shaded_vertex *vertex_at(const elements *e, uint32_t i)
{
    const uint32_t vertex = mesh_element(e->mesh, i) + (uint32_t)e->mesh->base_vertex;

    return vertex < e->mesh->vertex_count ? &e->vertex[vertex] : NULL;
}

static void pass_points(stages *s, const elements *e)
{
    for (uint32_t i = 0; i < e->mesh->count; ++i) {
        const shaded_vertex *const v = vertex_at(e, i);

        if (v && !v->outside)
            s->sink->point(s->sink->user, &s->place, v);
    }
}

static void pass_line_between(stages *s, const elements *e, uint32_t i, uint32_t k,
                              bool begins_pattern)
{
    const shaded_vertex *const a = vertex_at(e, i), *const b = vertex_at(e, k);

    if (a && b)
        pass_line(s, a, b, begins_pattern);
}

static void pass_line_primitives(stages *s, GLenum mode, const elements *e)
{
    const uint32_t count = e->mesh->count;

    for (uint32_t i = 1; i < count; i += mode == GL_LINES ? 2 : 1)
        pass_line_between(s, e, i - 1, i, mode == GL_LINES || i == 1);
    if (mode == GL_LINE_LOOP && count >= 2)
        pass_line_between(s, e, count - 1, 0, false);
}

static void pass_polygons(stages *s, GLenum mode, const elements *e, const char *function)
{
    const size_t triangles = triangles_of(mode, e->mesh->count), corners = 3 * triangles;
    uint32_t *const corner =
        triangles && corners <= UINT32_MAX
            ? scratch_memory(s->gl, &s->gl->indices, corners * sizeof *corner + triangles, function)
            : NULL;
    unsigned char *const mask = corner ? (unsigned char *)(corner + corners) : NULL;

    if (!corner)
        return;
    list_triangles(s->gl, mode, e->mesh, corner, mask);
    for (size_t t = 0; t < triangles; ++t) {
        const bool is_part = mode == GL_POLYGON ? t > 0 : mode >= GL_QUADS && t % 2;
        const shaded_vertex *v[3];

        for (int k = 0; k < 3; ++k)
            v[k] = vertex_at(e, corner[3 * t + (size_t)k]);
        if (v[0] && v[1] && v[2])
            pass_triangle(s, v, mask[t], !is_part);
    }
}

void pass_primitives(context *gl, GLenum mode, const gn_mesh *mesh, const primitive_sink *sink,
                     const char *function)
{
    const raster_state *const r = &gl->raster;
    const bool is_flipped = !gl->draw_framebuffer != (gl->transform.clip_origin == GL_UPPER_LEFT);
    stages s = {.gl = gl, .sink = sink};
    elements e = {.mesh = mesh};
    fixed_function fixed;
    gn_pipeline pipeline;

    if (!mesh->vertex_count)
        return;
    set_pipeline(gl, &pipeline);
    set_fixed_function(gl, mode, mesh, &fixed, &pipeline);
    fixed.points.enabled = false;
    set_placement(gl, &fixed, &pipeline.program, &s.place);
    s.mode[0] = r->polygon_mode[r->cull && r->cull_face != GL_BACK];
    s.mode[1] = r->cull && r->cull_face != GL_FRONT ? s.mode[0] : r->polygon_mode[1];
    s.has_unfilled = s.mode[0] != GL_FILL || s.mode[1] != GL_FILL;
    s.has_offset = r->offset_fill || r->offset_line || r->offset_point;
    s.knows_side = r->cull || s.has_unfilled || s.has_offset ||
                   (fixed.lighting.enabled && fixed.lighting.two_side);
    s.is_front_counterclockwise = (r->front_face == GL_CCW) == is_flipped;
    e.vertex = shade_vertices(gl, &s.place, mesh, function);
    if (!e.vertex)
        return;
    if (mode == GL_POINTS)
        pass_points(&s, &e);
    else if (mode < GL_TRIANGLES)
        pass_line_primitives(&s, mode, &e);
    else
        pass_polygons(&s, mode, &e, function);
    if (sink->finish)
        sink->finish(sink->user, &s.place);
}
