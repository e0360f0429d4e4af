/* glMap, glMapGrid and glGetMap. */
#include "evaluator_maps.h"

#include <gl_registry.h>
#include <stdlib.h>
#include <string.h>

#include "../context/gl_errors.h"
#include "../context/integers.h"
#include "bezier.h"

static const unsigned char components[EVALUATOR_MAPS] = {
    [MAP_COLOR_4] = 4,          [MAP_INDEX] = 1,
    [MAP_NORMAL] = 3,           [MAP_COORDINATE_1] = 1,
    [MAP_COORDINATE_1 + 1] = 2, [MAP_COORDINATE_1 + 2] = 3,
    [MAP_COORDINATE_1 + 3] = 4, [MAP_VERTEX_3] = 3,
    [MAP_VERTEX_4] = 4};

/* Returns the map of a target; null, and *name is not set, if there is none. */
static evaluator_map *find_map(context *gl, GLenum target, enum evaluator_map_name *name)
{
    const GLenum one = target - GL_MAP1_COLOR_4, two = target - GL_MAP2_COLOR_4;

    if (one >= EVALUATOR_MAPS && two >= EVALUATOR_MAPS)
        return NULL;
    *name = (enum evaluator_map_name)(one < EVALUATOR_MAPS ? one : two);
    return one < EVALUATOR_MAPS ? &gl->map1[one] : &gl->map2[two];
}

int map_components(GLenum target)
{
    const GLenum one = target - GL_MAP1_COLOR_4, two = target - GL_MAP2_COLOR_4;

    return one < EVALUATOR_MAPS ? components[one] : two < EVALUATOR_MAPS ? components[two] : 0;
}

const GLfloat *map_points(const evaluator_map *map, enum evaluator_map_name name)
{
    static const GLfloat ones[] = {1.0f, 1.0f, 1.0f, 1.0f};
    static const GLfloat up[] = {0.0f, 0.0f, 1.0f};
    static const GLfloat origin[] = {0.0f, 0.0f, 0.0f, 1.0f};

    return map->points                                ? map->points
           : name == MAP_NORMAL                       ? up
           : name == MAP_COLOR_4 || name == MAP_INDEX ? ones
                                                      : origin;
}

void free_evaluator_maps(context *gl)
{
    for (int i = 0; i < EVALUATOR_MAPS; ++i) {
        free(gl->map1[i].points);
        free(gl->map2[i].points);
    }
}

/* What glMap has been called with. One of `floats` and `doubles` is null. */
typedef struct map_arguments {
    GLenum target;
    bool is_surface;
    GLfloat domain[4]; /* u1, u2, v1, v2; 0, 1 for v of a curve */
    GLint stride[2], order[2];
    const GLfloat *floats;
    const GLdouble *doubles;
} map_arguments;

/* Returns a copy of the points; null if memory is short. */
static GLfloat *copy_points(const map_arguments *a, int count)
{
    const size_t size = (size_t)a->order[0] * (size_t)a->order[1] * (size_t)count;
    GLfloat *const copy = malloc(size * sizeof *copy);
    GLfloat *to = copy;

    for (GLint i = 0; copy && i < a->order[0]; ++i)
        for (GLint j = 0; j < a->order[1]; ++j)
            for (int c = 0; c < count; ++c) {
                const size_t at =
                    (size_t)i * (size_t)a->stride[0] + (size_t)j * (size_t)a->stride[1] + (size_t)c;

                *to++ = a->floats ? a->floats[at] : (GLfloat)a->doubles[at];
            }
    return copy;
}

static GLenum error_of(const context *gl, const map_arguments *a)
{
    const int count = map_components(a->target), directions = a->is_surface ? 2 : 1;

    for (int k = 0; k < directions; ++k)
        if (a->domain[2 * k] == a->domain[2 * k + 1] || a->order[k] < 1 || a->order[k] > MOST_ORDER)
            return GL_INVALID_VALUE;
    if (!a->is_surface && !a->floats && !a->doubles)
        return GL_INVALID_VALUE;
    if (count == 0)
        return GL_INVALID_ENUM;
    for (int k = 0; k < directions; ++k)
        if (a->stride[k] < count)
            return GL_INVALID_VALUE;
    if (gl->active_texture != 0)
        return GL_INVALID_OPERATION;
    if (a->is_surface != (a->target >= GL_MAP2_COLOR_4))
        return GL_INVALID_ENUM;
    return GL_NO_ERROR;
}

static void set_map(const char *function, const map_arguments *a)
{
    context *const gl = enter(function);
    const GLenum error = gl ? error_of(gl, a) : GL_NO_ERROR;
    enum evaluator_map_name name = MAP_COLOR_4;
    evaluator_map *const map = gl ? find_map(gl, a->target, &name) : NULL;
    GLfloat *points;

    if (error)
        gl_error(gl, error, function);
    if (error || !map || (!a->floats && !a->doubles))
        return;
    points = copy_points(a, components[name]);
    if (!points) {
        gl_error(gl, GL_OUT_OF_MEMORY, function);
        return;
    }
    free(map->points);
    map->points = points;
    for (int k = 0; k < 2; ++k) {
        map->order[k] = a->order[k];
        map->scale[k] = 1.0f / (a->domain[2 * k + 1] - a->domain[2 * k]);
    }
    memcpy(map->domain, a->domain, sizeof map->domain);
}

void glMap1f(GLenum target, GLfloat u1, GLfloat u2, GLint stride, GLint order,
             const GLfloat *points)
{
    set_map(__func__, &(map_arguments){.target = target,
                                       .domain = {u1, u2, 0.0f, 1.0f},
                                       .stride = {stride, 0},
                                       .order = {order, 1},
                                       .floats = points});
}

void glMap1d(GLenum target, GLdouble u1, GLdouble u2, GLint stride, GLint order,
             const GLdouble *points)
{
    set_map(__func__, &(map_arguments){.target = target,
                                       .domain = {(GLfloat)u1, (GLfloat)u2, 0.0f, 1.0f},
                                       .stride = {stride, 0},
                                       .order = {order, 1},
                                       .doubles = points});
}

void glMap2f(GLenum target, GLfloat u1, GLfloat u2, GLint ustride, GLint uorder, GLfloat v1,
             GLfloat v2, GLint vstride, GLint vorder, const GLfloat *points)
{
    set_map(__func__, &(map_arguments){.target = target,
                                       .is_surface = true,
                                       .domain = {u1, u2, v1, v2},
                                       .stride = {ustride, vstride},
                                       .order = {uorder, vorder},
                                       .floats = points});
}

void glMap2d(GLenum target, GLdouble u1, GLdouble u2, GLint ustride, GLint uorder, GLdouble v1,
             GLdouble v2, GLint vstride, GLint vorder, const GLdouble *points)
{
    set_map(__func__,
            &(map_arguments){.target = target,
                             .is_surface = true,
                             .domain = {(GLfloat)u1, (GLfloat)u2, (GLfloat)v1, (GLfloat)v2},
                             .stride = {ustride, vstride},
                             .order = {uorder, vorder},
                             .doubles = points});
}

/* Grids */

void glMapGrid1f(GLint un, GLfloat u1, GLfloat u2)
{
    context *const gl = enter(__func__);
    evaluator_state *const e = gl ? &gl->evaluator : NULL;

    if (!gl)
        return;
    if (un < 1) {
        gl_error(gl, GL_INVALID_VALUE, __func__);
        return;
    }
    e->segments1 = un;
    e->domain1[0] = u1;
    e->domain1[1] = u2;
    e->step1 = (u2 - u1) / (GLfloat)un;
}

void glMapGrid1d(GLint un, GLdouble u1, GLdouble u2)
{
    glMapGrid1f(un, (GLfloat)u1, (GLfloat)u2);
}

void glMapGrid2f(GLint un, GLfloat u1, GLfloat u2, GLint vn, GLfloat v1, GLfloat v2)
{
    context *const gl = enter(__func__);
    evaluator_state *const e = gl ? &gl->evaluator : NULL;

    if (!gl)
        return;
    if (un < 1 || vn < 1) {
        gl_error(gl, GL_INVALID_VALUE, __func__);
        return;
    }
    e->segments2[0] = un;
    e->segments2[1] = vn;
    e->domain2[0] = u1;
    e->domain2[1] = u2;
    e->domain2[2] = v1;
    e->domain2[3] = v2;
    e->step2[0] = (u2 - u1) / (GLfloat)un;
    e->step2[1] = (v2 - v1) / (GLfloat)vn;
}

void glMapGrid2d(GLint un, GLdouble u1, GLdouble u2, GLint vn, GLdouble v1, GLdouble v2)
{
    glMapGrid2f(un, (GLfloat)u1, (GLfloat)u2, vn, (GLfloat)v1, (GLfloat)v2);
}

/* Queries */

/* Calls `take` with each value that a query of a map returns. */
static void query_map(const char *function, GLenum target, GLenum query,
                      void (*take)(void *result, size_t i, GLfloat value), void *result)
{
    context *const gl = enter(function);
    enum evaluator_map_name name = MAP_COLOR_4;
    const evaluator_map *const map = gl ? find_map(gl, target, &name) : NULL;
    const int directions = target < GL_MAP2_COLOR_4 ? 1 : 2;
    size_t count;

    if (!gl)
        return;
    if (!map) {
        gl_error(gl, GL_INVALID_ENUM, function);
        return;
    }
    switch (query) {
    case GL_COEFF:
        count = (size_t)map->order[0] * (size_t)map->order[1] * components[name];
        for (size_t i = 0; i < count; ++i)
            take(result, i, map_points(map, name)[i]);
        break;
    case GL_ORDER:
        for (int k = 0; k < directions; ++k)
            take(result, (size_t)k, (GLfloat)map->order[k]);
        break;
    case GL_DOMAIN:
        for (int k = 0; k < 2 * directions; ++k)
            take(result, (size_t)k, map->domain[k]);
        break;
    default:
        gl_error(gl, GL_INVALID_ENUM, function);
    }
}

static void take_double(void *result, size_t i, GLfloat value)
{
    ((GLdouble *)result)[i] = (GLdouble)value;
}

static void take_float(void *result, size_t i, GLfloat value)
{
    ((GLfloat *)result)[i] = value;
}

static void take_integer(void *result, size_t i, GLfloat value)
{
    ((GLint *)result)[i] = rounded_integer((GLdouble)value);
}

void glGetMapdv(GLenum target, GLenum query, GLdouble *v)
{
    query_map(__func__, target, query, take_double, v);
}

void glGetMapfv(GLenum target, GLenum query, GLfloat *v)
{
    query_map(__func__, target, query, take_float, v);
}

void glGetMapiv(GLenum target, GLenum query, GLint *v)
{
    query_map(__func__, target, query, take_integer, v);
}
