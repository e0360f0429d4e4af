/* glEvalCoord, glEvalPoint and glEvalMesh: vertices whose attributes are those of the maps (OpenGL
 * 2.1 section 5.1). The current attributes stay as they are. */
#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "../context/gl_errors.h"
#include "../vertices/immediate.h"
#include "bezier.h"
#include "evaluator_maps.h"

/* Where to evaluate; a curve does not use v. */
typedef struct evaluator_place {
    bool is_surface;
    GLfloat u, v;
} evaluator_place;

/* Returns whether vertices get an attribute from a map, and which map. Of maps that set the same
 * attribute, the one with the most components counts. */
static bool find_enabled(const GLboolean *enabled, int attribute, enum evaluator_map_name *name)
{
    if (attribute == COLOR || attribute == NORMAL) {
        *name = attribute == COLOR ? MAP_COLOR_4 : MAP_NORMAL;
        return enabled[*name];
    }
    if (attribute == POSITION) {
        *name = enabled[MAP_VERTEX_4] ? MAP_VERTEX_4 : MAP_VERTEX_3;
        return enabled[*name];
    }
    for (int i = 3; attribute == TEXTURE_COORDINATE && i >= 0; --i)
        if (enabled[MAP_COORDINATE_1 + i]) {
            *name = (enum evaluator_map_name)(MAP_COORDINATE_1 + i);
            return true;
        }
    return false;
}

static int components_of(enum evaluator_map_name name)
{
    return map_components(GL_MAP1_COLOR_4 + (GLenum)name);
}

static bezier_surface surface_of(const evaluator_map *map, enum evaluator_map_name name)
{
    return (bezier_surface){
        map_points(map, name), components_of(name), {map->order[0], map->order[1]}};
}

/* Writes four components of an attribute. */
static void evaluate(const context *gl, enum evaluator_map_name name, const evaluator_place *at,
                     GLfloat *out)
{
    const evaluator_map *const map = at->is_surface ? &gl->map2[name] : &gl->map1[name];
    const bezier_surface surface = surface_of(map, name);
    const GLfloat u = (at->u - map->domain[0]) * map->scale[0];

    out[0] = out[1] = out[2] = 0.0f;
    out[3] = 1.0f;
    if (at->is_surface)
        bezier_point(&surface, u, (at->v - map->domain[2]) * map->scale[1], out);
    else
        bezier_curve(surface.points, surface.components, surface.components, map->order[0], u, out);
}

/* Writes a point of a surface of positions, and its normal (OpenGL 2.1 equation 5.1). */
static void evaluate_with_normal(const context *gl, enum evaluator_map_name name,
                                 const evaluator_place *at, GLfloat *out, GLfloat *normal)
{
    const evaluator_map *const map = &gl->map2[name];
    const bezier_surface surface = surface_of(map, name);
    GLfloat du[MOST_COMPONENTS], dv[MOST_COMPONENTS], square;

    out[3] = 1.0f;
    bezier_tangents(&surface, (at->u - map->domain[0]) * map->scale[0],
                    (at->v - map->domain[2]) * map->scale[1], out, du, dv);
    for (int c = 0; c < 3 && surface.components == 4; ++c) {
        du[c] = du[c] * out[3] - du[3] * out[c];
        dv[c] = dv[c] * out[3] - dv[3] * out[c];
    }
    for (int c = 0; c < 3; ++c) {
        const int a = (c + 1) % 3, b = (c + 2) % 3;

        normal[c] = du[a] * dv[b] - du[b] * dv[a];
    }
    square = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
    if (square != 0.0f) {
        const GLfloat scale = 1.0f / sqrtf(square);

        for (int c = 0; c < 3; ++c)
            normal[c] *= scale;
    }
}

static void grow_to(context *gl, int attribute, int size)
{
    if (size > gl->immediate.size[attribute])
        grow_layout(gl, attribute, size);
}

/* Adds a vertex between glBegin and glEnd, if positions are evaluated. */
static void evaluate_vertex(context *gl, const evaluator_place *at)
{
    const GLboolean *const enabled = at->is_surface ? gl->evaluator.map2 : gl->evaluator.map1;
    const bool has_normal = at->is_surface && gl->evaluator.auto_normal;
    GLfloat kept[ATTRIBUTES][4], position[4];
    enum evaluator_map_name name, position_map;

    if (!gl->immediate.is_inside || !find_enabled(enabled, POSITION, &position_map))
        return;
    for (int a = POSITION; a <= TEXTURE_COORDINATE; ++a)
        if (find_enabled(enabled, a, &name))
            grow_to(gl, a, components_of(name));
    if (has_normal)
        grow_to(gl, NORMAL, 3);
    memcpy(kept, gl->current.attribute, sizeof kept);
    for (int a = NORMAL; a <= TEXTURE_COORDINATE; ++a)
        if (find_enabled(enabled, a, &name))
            evaluate(gl, name, at, gl->current.attribute[a]);
    if (has_normal)
        evaluate_with_normal(gl, position_map, at, position, gl->current.attribute[NORMAL]);
    else
        evaluate(gl, position_map, at, position);
    add_vertex(components_of(position_map), position[0], position[1], position[2], position[3]);
    memcpy(gl->current.attribute, kept, sizeof kept);
}

/* Coordinates */

void glEvalCoord1f(GLfloat u)
{
    context *const gl = current_context();

    if (gl)
        evaluate_vertex(gl, &(evaluator_place){false, u, 0.0f});
}

void glEvalCoord1d(GLdouble u)
{
    glEvalCoord1f((GLfloat)u);
}

void glEvalCoord1fv(const GLfloat *u)
{
    glEvalCoord1f(u[0]);
}

void glEvalCoord1dv(const GLdouble *u)
{
    glEvalCoord1f((GLfloat)u[0]);
}

void glEvalCoord2f(GLfloat u, GLfloat v)
{
    context *const gl = current_context();

    if (gl)
        evaluate_vertex(gl, &(evaluator_place){true, u, v});
}

void glEvalCoord2d(GLdouble u, GLdouble v)
{
    glEvalCoord2f((GLfloat)u, (GLfloat)v);
}

void glEvalCoord2fv(const GLfloat *u)
{
    glEvalCoord2f(u[0], u[1]);
}

void glEvalCoord2dv(const GLdouble *u)
{
    glEvalCoord2f((GLfloat)u[0], (GLfloat)u[1]);
}

/* Points of the grid */

static GLfloat grid_coordinate(GLint i, const GLfloat *domain, GLint segments)
{
    return (GLfloat)i * ((domain[1] - domain[0]) / (GLfloat)segments) + domain[0];
}

void glEvalPoint1(GLint i)
{
    const context *const gl = current_context();

    if (gl)
        glEvalCoord1f(grid_coordinate(i, gl->evaluator.domain1, gl->evaluator.segments1));
}

void glEvalPoint2(GLint i, GLint j)
{
    const context *const gl = current_context();
    const evaluator_state *const e = gl ? &gl->evaluator : NULL;

    if (gl)
        glEvalCoord2f(grid_coordinate(i, e->domain2, e->segments2[0]),
                      grid_coordinate(j, e->domain2 + 2, e->segments2[1]));
}

/* Meshes: primitives of points of the grid, whose coordinates are sums of steps. */

typedef struct grid_range {
    GLint first, last;
    GLfloat start, step;
} grid_range;

static grid_range range_of(GLint first, GLint last, GLfloat low, GLfloat step)
{
    return (grid_range){first, last, low + (GLfloat)first * step, step};
}

/* Returns the context of a mesh; null between glBegin and glEnd and for a wrong mode, which are
 * errors. */
static context *enter_mesh(const char *function, GLenum mode, bool can_fill)
{
    context *const gl = current_context();

    if (!gl)
        return NULL;
    if (gl->immediate.is_inside)
        gl_error(gl, GL_INVALID_OPERATION, function);
    else if (mode != GL_POINT && mode != GL_LINE && !(can_fill && mode == GL_FILL))
        gl_error(gl, GL_INVALID_ENUM, function);
    else
        return gl;
    return NULL;
}

static bool has_positions(const GLboolean *enabled)
{
    enum evaluator_map_name name;

    return find_enabled(enabled, POSITION, &name);
}

void glEvalMesh1(GLenum mode, GLint i1, GLint i2)
{
    const context *const gl = enter_mesh(__func__, mode, false);
    const evaluator_state *const e = gl ? &gl->evaluator : NULL;

    if (!gl || !has_positions(e->map1))
        return;
    const grid_range r = range_of(i1, i2, e->domain1[0], e->step1);
    GLfloat u = r.start;

    glBegin(mode == GL_POINT ? GL_POINTS : GL_LINE_STRIP);
    for (GLint64 i = r.first; i <= r.last; ++i, u += r.step)
        glEvalCoord1f(u);
    glEnd();
}

/* Adds the points of one row, or of one column, of a grid. */
static void add_row(const grid_range *along, GLfloat across, bool is_column)
{
    GLfloat coordinate = along->start;

    for (GLint64 i = along->first; i <= along->last; ++i, coordinate += along->step)
        glEvalCoord2f(is_column ? across : coordinate, is_column ? coordinate : across);
}

static void add_strip(const grid_range *along, GLfloat v, GLfloat next_v)
{
    GLfloat u = along->start;

    glBegin(GL_TRIANGLE_STRIP);
    for (GLint64 i = along->first; i <= along->last; ++i, u += along->step) {
        glEvalCoord2f(u, v);
        glEvalCoord2f(u, next_v);
    }
    glEnd();
}

static void add_lines(const grid_range *along, const grid_range *across, bool is_column)
{
    GLfloat coordinate = across->start;

    for (GLint64 i = across->first; i <= across->last; ++i, coordinate += across->step) {
        glBegin(GL_LINE_STRIP);
        add_row(along, coordinate, is_column);
        glEnd();
    }
}

void glEvalMesh2(GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2)
{
    const context *const gl = enter_mesh(__func__, mode, true);
    const evaluator_state *const e = gl ? &gl->evaluator : NULL;

    if (!gl || !has_positions(e->map2))
        return;
    const grid_range u = range_of(i1, i2, e->domain2[0], e->step2[0]);
    const grid_range v = range_of(j1, j2, e->domain2[2], e->step2[1]);
    GLfloat at = v.start;

    if (mode == GL_POINT) {
        glBegin(GL_POINTS);
        for (GLint64 j = v.first; j <= v.last; ++j, at += v.step)
            add_row(&u, at, false);
        glEnd();
    } else if (mode == GL_LINE) {
        add_lines(&u, &v, false);
        add_lines(&v, &u, true);
    } else {
        for (GLint64 j = v.first; j < v.last; ++j, at += v.step)
            add_strip(&u, at, at + v.step);
    }
}
