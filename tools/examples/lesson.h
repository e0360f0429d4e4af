/* What most lessons begin with: the command line, sliders, and the model as gn_draw takes
 * it. */
#ifndef LESSON_H
#define LESSON_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "obj_tga.h"

/* Returns how many words of the command line come before the first `--set NAME=VALUE`, which sets a
 * slider. */
static inline int lesson_words(int argc, char **argv)
{
    int n = 1;

    while (n < argc && strcmp(argv[n], "--set") != 0)
        ++n;
    return n < argc ? n : argc;
}

/* Returns argument n of the command line, or `otherwise` if the user gave fewer. */
static inline const char *lesson_argument(int argc, char **argv, int n, const char *otherwise)
{
    return lesson_words(argc, argv) > n ? argv[n] : otherwise;
}

/* A number that the reader can change, from `least` to `most`: by a slider on the lesson's web
 * page, elsewhere by `--set "NAME=VALUE"`. Returns `value` as long as nobody has. */
#ifdef LESSON_ON_PAGE
float lesson_slider(const char *name, float value, float least, float most);
int lesson_slider_int(const char *name, int value, int least, int most);
#else
enum { LESSON_MOST_SETS = 16 };
static struct {
    const char *set[LESSON_MOST_SETS]; /* what follows each --set; null once it is used */
    int count;
    char known[512];
} lesson_line;

/* At the end of the program: names what `--set` has not set. */
static inline void lesson_check_sets(void)
{
    for (int i = 0; i < lesson_line.count; ++i) {
        if (!lesson_line.set[i])
            continue;
        fflush(stdout);
        fprintf(stderr, "no slider for --set %s; write --set \"NAME=VALUE\" with one of:\n%s",
                lesson_line.set[i],
                lesson_line.known[0] ? lesson_line.known : "  (this lesson has no sliders)\n");
        _Exit(2);
    }
}

static inline float lesson_slider(const char *name, float value, float least, float most)
{
    const size_t length = strlen(name), used = strlen(lesson_line.known);

    snprintf(lesson_line.known + used, sizeof lesson_line.known - used,
             "  %s: %g to %g, at first %g\n", name, (double)least, (double)most, (double)value);
    for (int i = 0; i < lesson_line.count; ++i) {
        const char *const word = lesson_line.set[i];
        char *end;

        if (!word || strncmp(word, name, length) != 0 || word[length] != '=')
            continue;
        value = strtof(word + length + 1, &end);
        if (end == word + length + 1 || *end != 0 || !(value >= least && value <= most)) {
            fflush(stdout);
            fprintf(stderr, "--set %s: not a number from %g to %g\n", word, (double)least,
                    (double)most);
            _Exit(2);
        }
        lesson_line.set[i] = NULL;
    }
    return value;
}

static inline int lesson_slider_int(const char *name, int value, int least, int most)
{
    return (int)gn_round(lesson_slider(name, (float)value, (float)least, (float)most));
}
#endif

/* Prints the help and ends the program if the user asked for it, or gave more than `most`
 * arguments. */
static inline void lesson_help(int argc, char **argv, int most, const char *help)
{
    const int words = lesson_words(argc, argv);
    const bool asked = argc == 2 && strcmp(argv[1], "--help") == 0;

#ifndef LESSON_ON_PAGE
    for (int i = words; i < argc && lesson_line.count < LESSON_MOST_SETS; ++i)
        if (strcmp(argv[i], "--set") == 0)
            lesson_line.set[lesson_line.count++] = i + 1 < argc ? argv[++i] : "";
    if (lesson_line.count > 0)
        atexit(lesson_check_sets);
#endif
    if (!asked && words <= most + 1 && (words < 2 || argv[1][0] != '-'))
        return;
    fputs(help, asked ? stdout : stderr);
    exit(asked ? EXIT_SUCCESS : 2);
}

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

/* Rounds a place in the window to 1/256 pixel, as Gnomon does with vertices. */
static inline float lesson_rounded(float pixels)
{
    return gn_round(pixels * 256) / 256;
}

/* Twice the area of the triangle a, b, p: above 0 if p lies to the left of the edge from a to b. */
static inline double lesson_area(gn_vec3 a, gn_vec3 b, double x, double y)
{
    return ((double)b.x - a.x) * (y - a.y) - ((double)b.y - a.y) * (x - a.x);
}

/* Whether a point on the edge from a to b belongs to the triangle: a left or a lower edge. */
static inline bool lesson_owns_edge(gn_vec3 a, gn_vec3 b)
{
    return b.y < a.y || (b.y == a.y && b.x > a.x);
}

/* What lesson 3 builds by hand: the barycentric coordinates alpha, beta and gamma of a place in the
 * window. Returns whether the place belongs to the triangle, whichever way round its corners are
 * listed. */
static inline bool lesson_barycentric(const gn_vec3 corner[3], double x, double y, double weight[3])
{
    const double whole = lesson_area(corner[0], corner[1], corner[2].x, corner[2].y);

    for (int i = 0; i < 3; ++i) {
        const gn_vec3 next = corner[(i + 1) % 3], last = corner[(i + 2) % 3];

        weight[i] = lesson_area(next, last, x, y) / whole;
        if (!(weight[i] >= 0) || (weight[i] == 0 && !(whole > 0 ? lesson_owns_edge(next, last)
                                                                : lesson_owns_edge(last, next))))
            return false;
    }
    return true;
}

#endif
