#include "smooth_primitives.h"

#include <math.h>

static shaded_vertex corner_of(const placement *place, const shaded_vertex *v, const float moved[2],
                               const float coverage[COVERAGE_VARYINGS])
{
    shaded_vertex corner = *v;

    for (int i = 0; i < 2; ++i)
        corner.window[i] += moved[i];
    for (uint32_t i = 0; i < COVERAGE_VARYINGS; ++i)
        corner.varying[place->program->varying_count + i] = coverage[i];
    return corner;
}

static void add_triangle(window_primitives *p, const placement *place, coverage_kind coverage,
                         const shaded_vertex *a, const shaded_vertex *b, const shaded_vertex *c)
{
    shaded_vertex *const corner = add_window_primitive(p, place, GN_TRIANGLES, coverage);

    corner[0] = *a;
    corner[1] = *b;
    corner[2] = *c;
}

/* The varyings are the distances across and along the line from its middle, each before its
 * greatest. The line is half a pixel longer at each end, and wider at each side. */
static void add_smooth_line(window_primitives *p, const placement *place, const shaded_vertex *a,
                            const shaded_vertex *b)
{
    const float width = p->gl->raster.line_width;
    const float half_width = width <= 1.0f ? 1.0f : 0.5f * width + 0.5f;
    const float dx = b->window[0] - a->window[0], dy = b->window[1] - a->window[1];
    const float length = sqrtf(dx * dx + dy * dy);
    const float x = dx / length, y = dy / length, half_length = 0.5f * length + 0.5f;
    shaded_vertex corner[4];

    if (!(length > 0.0f))
        return;
    for (int i = 0; i < 4; ++i) {
        const float along = i < 2 ? -0.5f : 0.5f, across = i % 2 ? -half_width : half_width;
        const float moved[2] = {along * x - across * y, along * y + across * x};
        const float coverage[COVERAGE_VARYINGS] = {-across, half_width,
                                                   i < 2 ? -half_length : half_length, half_length};

        corner[i] = corner_of(place, i < 2 ? a : b, moved, coverage);
    }
    add_triangle(p, place, LINE_COVERAGE, &corner[2], &corner[1], &corner[0]);
    add_triangle(p, place, LINE_COVERAGE, &corner[3], &corner[1], &corner[2]);
}

/* The varyings are the place in the square around the unit circle, a threshold, and 1. */
static void add_smooth_point(window_primitives *p, const placement *place, const shaded_vertex *v)
{
    const bool is_least = v->point_size <= 2.0f && !place->fixed->points.is_attenuated;
    const float radius = is_least ? 1.0f : 0.5f * v->point_size;
    const float inverse = 1.0f / radius;
    const float threshold = 1.0f - 2.0f * inverse + inverse * inverse;
    shaded_vertex corner[4];

    for (int i = 0; i < 4; ++i) {
        const float x = i == 1 || i == 2 ? 1.0f : -1.0f, y = i < 2 ? -1.0f : 1.0f;
        const float moved[2] = {x * radius, y * radius};
        const float coverage[COVERAGE_VARYINGS] = {x, y, threshold, 1.0f};

        corner[i] = corner_of(place, v, moved, coverage);
    }
    add_triangle(p, place, POINT_COVERAGE, &corner[0], &corner[1], &corner[2]);
    add_triangle(p, place, POINT_COVERAGE, &corner[0], &corner[2], &corner[3]);
}

/* In targets of four samples, GL_POINT_SMOOTH and GL_LINE_SMOOTH have no effect. */
static bool draws_smooth(const window_primitives *p, const placement *place)
{
    return !p->is_multisampled &&
           place->program->varying_count + COVERAGE_VARYINGS < GN_MAX_VARYINGS;
}

void add_window_point(window_primitives *p, const placement *place, const shaded_vertex *v)
{
    shaded_vertex *point;

    if (p->gl->raster.point_smooth && draws_smooth(p, place)) {
        add_smooth_point(p, place, v);
        return;
    }
    point = add_window_primitive(p, place, GN_POINTS, WHOLE_COVERAGE);
    *point = *v;
    point->point_size = whole_point_size(v->point_size);
    for (int axis = 0; axis < 2; ++axis)
        point->window[axis] = point_center(point->point_size, axis, v->window[axis]);
}

void add_window_line(window_primitives *p, const placement *place, const shaded_vertex *a,
                     const shaded_vertex *b)
{
    shaded_vertex *line;

    if (p->gl->raster.line_smooth && draws_smooth(p, place)) {
        add_smooth_line(p, place, a, b);
        return;
    }
    line = add_window_primitive(p, place, GN_LINES, WHOLE_COVERAGE);
    line[0] = *a;
    line[1] = *b;
}
