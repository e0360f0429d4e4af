/* glMap in display lists: the control points are recorded one after another. */
#include <gl_registry.h>

#include "../context/gl_errors.h"
#include "../evaluators/bezier.h"
#include "../evaluators/evaluator_maps.h"
#include "list_record.h"

/* The functions that registry.py calls while a list is compiled. */
void compile_glMap1f(GLenum target, GLfloat u1, GLfloat u2, GLint stride, GLint order,
                     const GLfloat *points);
void compile_glMap1d(GLenum target, GLdouble u1, GLdouble u2, GLint stride, GLint order,
                     const GLdouble *points);
void compile_glMap2f(GLenum target, GLfloat u1, GLfloat u2, GLint ustride, GLint uorder, GLfloat v1,
                     GLfloat v2, GLint vstride, GLint vorder, const GLfloat *points);
void compile_glMap2d(GLenum target, GLdouble u1, GLdouble u2, GLint ustride, GLint uorder,
                     GLdouble v1, GLdouble v2, GLint vstride, GLint vorder, const GLdouble *points);

typedef struct recorded_map {
    GLenum target;
    GLfloat domain[4];
    GLint stride[2], order[2];
    const GLfloat *points;
} recorded_map;

static void replay_map1(void *arguments)
{
    const recorded_map *const a = arguments;

    glMap1f(a->target, a->domain[0], a->domain[1], a->stride[0], a->order[0], a->points);
}

static void replay_map2(void *arguments)
{
    const recorded_map *const a = arguments;

    glMap2f(a->target, a->domain[0], a->domain[1], a->stride[0], a->order[0], a->domain[2],
            a->domain[3], a->stride[1], a->order[1], a->points);
}

/* Records a map; one of `floats` and `doubles` is null. Points are kept if there are as many as a
 * map can have. As in the reference, the strides are forgotten, so that wrong ones are no errors.
 */
static void record_map(replay_function *replay, recorded_map map, const GLfloat *floats,
                       const GLdouble *doubles)
{
    GLfloat packed[MOST_ORDER * MOST_ORDER * MOST_COMPONENTS];
    const int components = map_components(map.target);
    const bool is_right = map.order[0] >= 1 && map.order[0] <= MOST_ORDER && map.order[1] >= 1 &&
                          map.order[1] <= MOST_ORDER && (floats || doubles);
    size_t count = 0;
    recorded_map *a;

    for (GLint i = 0; is_right && i < map.order[0]; ++i)
        for (GLint j = 0; j < map.order[1]; ++j)
            for (int c = 0; c < components; ++c) {
                const ptrdiff_t at =
                    (ptrdiff_t)i * map.stride[0] + (ptrdiff_t)j * map.stride[1] + c;

                packed[count++] = floats ? floats[at] : (GLfloat)doubles[at];
            }
    a = record_call(replay, sizeof *a, CALL_OTHER);
    if (!a)
        return;
    *a = map;
    a->points = record_memory(packed, count * sizeof *packed);
    a->stride[1] = components;
    a->stride[0] = replay == replay_map2 && is_right ? components * map.order[1] : components;
}

void compile_glMap1f(GLenum target, GLfloat u1, GLfloat u2, GLint stride, GLint order,
                     const GLfloat *points)
{
    record_map(replay_map1,
               (recorded_map){target, {u1, u2, 0.0f, 1.0f}, {stride, 0}, {order, 1}, NULL}, points,
               NULL);
}

void compile_glMap1d(GLenum target, GLdouble u1, GLdouble u2, GLint stride, GLint order,
                     const GLdouble *points)
{
    record_map(replay_map1,
               (recorded_map){
                   target, {(GLfloat)u1, (GLfloat)u2, 0.0f, 1.0f}, {stride, 0}, {order, 1}, NULL},
               NULL, points);
}

void compile_glMap2f(GLenum target, GLfloat u1, GLfloat u2, GLint ustride, GLint uorder, GLfloat v1,
                     GLfloat v2, GLint vstride, GLint vorder, const GLfloat *points)
{
    record_map(replay_map2,
               (recorded_map){target, {u1, u2, v1, v2}, {ustride, vstride}, {uorder, vorder}, NULL},
               points, NULL);
}

void compile_glMap2d(GLenum target, GLdouble u1, GLdouble u2, GLint ustride, GLint uorder,
                     GLdouble v1, GLdouble v2, GLint vstride, GLint vorder, const GLdouble *points)
{
    record_map(replay_map2,
               (recorded_map){target,
                              {(GLfloat)u1, (GLfloat)u2, (GLfloat)v1, (GLfloat)v2},
                              {ustride, vstride},
                              {uorder, vorder},
                              NULL},
               NULL, points);
}
