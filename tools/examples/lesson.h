/* What most lessons begin with: the command line, sliders, and the model as gn_draw takes
 * it. */
#ifndef LESSON_H
#define LESSON_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "obj_tga.h"

/* Prints the help and ends the program if the user asked for it, or gave more than `most`
 * arguments. */
static inline void lesson_help(int argc, char **argv, int most, const char *help)
{
    const bool asked = argc == 2 && strcmp(argv[1], "--help") == 0;

    if (!asked && argc <= most + 1 && (argc < 2 || argv[1][0] != '-'))
        return;
    fputs(help, asked ? stdout : stderr);
    exit(asked ? EXIT_SUCCESS : 2);
}

/* Returns argument n of the command line, or `otherwise` if the user gave fewer. */
static inline const char *lesson_argument(int argc, char **argv, int n, const char *otherwise)
{
    return argc > n ? argv[n] : otherwise;
}

/* A number that the reader can change by a slider on the lesson's web page, from `least` to `most`.
 * Returns where the slider stands, which is `value` at first. There are no sliders elsewhere:
 * returns `value`. */
#ifdef LESSON_ON_PAGE
float lesson_slider(const char *name, float value, float least, float most);
int lesson_slider_int(const char *name, int value, int least, int most);
#else
static inline float lesson_slider(const char *name, float value, float least, float most)
{
    (void)name, (void)least, (void)most;
    return value;
}

static inline int lesson_slider_int(const char *name, int value, int least, int most)
{
    (void)name, (void)least, (void)most;
    return value;
}
#endif

/* Returns a direction, turned about the axis y: by 0 the direction itself, bit for bit. */
static inline gn_vec3 lesson_turned(gn_vec3 direction, float angle)
{
    gn_transform turn;

    gn_rotate_y(angle, &turn); /* fails for no finite angle */
    return gn_mat4_transform_direction(&turn.matrix, direction);
}

/* Ends the program if a function of the library says that something is wrong. */
static inline void lesson_check(gn_status status)
{
    if (status == GN_OK)
        return;
    fprintf(stderr, "%s\n", gn_status_text(status));
    exit(EXIT_FAILURE);
}

/* Gives the corners that have no normal the normal of their triangle. */
static inline void lesson_complete_normals(obj_model *model)
{
    for (uint32_t i = 0; i < model->count; ++i) {
        const obj_corner *triangle = &model->corner[i - i % 3];
        const gn_vec3 a = gn_vec3_subtract(triangle[1].position, triangle[0].position);
        const gn_vec3 b = gn_vec3_subtract(triangle[2].position, triangle[0].position);
        gn_vec3 *normal = &model->corner[i].normal;

        if (gn_vec3_length(*normal) == 0 && gn_vec3_normalize(gn_vec3_cross(a, b), normal))
            *normal = (gn_vec3){0, 0, 1}; /* the triangle has no area */
    }
}

/* Reads a model, moves its middle to the origin and scales it so that its longest side reaches from
 * -1 to 1: then one camera fits every model. */
static inline obj_model lesson_model(const char *path)
{
    obj_model model = obj_read(path);
    gn_vec3 low = model.corner[0].position, high = low;

    for (uint32_t i = 0; i < model.count; ++i) {
        low = gn_vec3_minimum(low, model.corner[i].position);
        high = gn_vec3_maximum(high, model.corner[i].position);
    }
    const gn_vec3 size = gn_vec3_subtract(high, low);
    const gn_vec3 middle = gn_vec3_scale(gn_vec3_add(low, high), 0.5f);
    const float longest = gn_maximum1(gn_maximum1(size.x, size.y), size.z);
    for (uint32_t i = 0; i < model.count && longest > 0; ++i) {
        const gn_vec3 moved = gn_vec3_subtract(model.corner[i].position, middle);

        model.corner[i].position = gn_vec3_scale(moved, 2 / longest);
    }
    lesson_complete_normals(&model);
    return model;
}

/* Returns the mesh of a model: where gn_draw finds positions, normals and texture coordinates, and
 * how many bytes lie between one corner's and the next. Lesson 3 writes it out. */
static inline gn_mesh lesson_mesh(const obj_model *model)
{
    const uint32_t stride = sizeof *model->corner;

    return (gn_mesh){
        .attribute = {[GN_ATTRIBUTE_POSITION] = {&model->corner->position.x, 3, stride, 0},
                      [GN_ATTRIBUTE_NORMAL] = {&model->corner->normal.x, 3, stride, 0},
                      [GN_ATTRIBUTE_TEXCOORD] = {&model->corner->texcoord.x, 2, stride, 0}},
        .vertex_count = model->count,
        .count = model->count,
    };
}

#endif
