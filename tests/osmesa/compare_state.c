/* Calls functions that set state with random arguments, right and wrong ones, in the reference's
 * libOSMesa and in this project's, and compares the error of each call and, from time to time, what
 * glGet returns of everything.
 * usage: osmesa-state LIBRARY [SEED [CALLS]] */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare_attachments.h"
#include "state_calls.h"
#include "state_names.h"

enum { WINDOW = 32, MOST_VALUES = 16 };

enum {
    COMBINE_NAMES = sizeof combine_names / sizeof *combine_names,
    RENDERBUFFER_NAMES = sizeof renderbuffer_names / sizeof *renderbuffer_names,
    TEXTURE_NAMES = sizeof texture_names / sizeof *texture_names,
    LIGHT_NAMES = sizeof light_names / sizeof *light_names,
    MATERIAL_NAMES = sizeof material_names / sizeof *material_names,
    ASKED_LIGHTS = 2,
    PLANES = 8,
    PIXEL_MAPS = 10,
    PIXEL_MAP_SIZE = 256,
    EVALUATOR_MAPS = 18,
    EVALUATOR_VALUES = 30 * 30 * 4
};

typedef struct answers {
    GLdouble plane[PLANES][4];
    GLfloat parameter[2][TEXTURE_NAMES][4], generation[4][3][4], environment[2][4];
    GLint integer_parameter[2][TEXTURE_NAMES][4];
    GLfloat combine[COMBINE_NAMES];
    GLubyte pattern[1 << 17]; /* of polygons */
    GLfloat map[PIXEL_MAPS][PIXEL_MAP_SIZE];
    GLuint integer_map[PIXEL_MAPS][PIXEL_MAP_SIZE];
    GLfloat evaluator[EVALUATOR_MAPS][EVALUATOR_VALUES + 6];
    GLdouble wide_evaluator[EVALUATOR_MAPS][4]; /* domains */
    GLint integer_evaluator[EVALUATOR_MAPS][EVALUATOR_VALUES];
    GLint renderbuffer[RENDERBUFFER_NAMES]; /* zeros if none is bound */
    GLfloat light[ASKED_LIGHTS][LIGHT_NAMES][4], material[2][MATERIAL_NAMES][4];
    GLint integer[NAMES][MOST_VALUES];
    GLfloat number[NAMES][MOST_VALUES];
    GLdouble wide[NAMES][MOST_VALUES];
    GLboolean truth[NAMES][MOST_VALUES];
} answers;

/* Fractions beyond -1..1 as integers: the reference's depend on the processor. */
static void forget_overflows(answers *a)
{
    for (int n = 0; n < NAMES; ++n)
        for (int i = 0; i < MOST_VALUES; ++i)
            if (a->integer[n][i] == INT32_MIN || a->integer[n][i] == INT32_MAX ||
                a->integer[n][i] == -INT32_MAX)
                a->integer[n][i] = 0;
}

static void ask(const library *gl, answers *to)
{
    memset(to, 0, sizeof *to);
    for (int n = 0; n < NAMES; ++n) {
        gl->GetIntegerv(names[n], to->integer[n]);
        gl->GetFloatv(names[n], to->number[n]);
        gl->GetDoublev(names[n], to->wide[n]);
        gl->GetBooleanv(names[n], to->truth[n]);
    }
    for (int i = 0; i < 2; ++i)
        for (int n = 0; n < TEXTURE_NAMES; ++n) {
            const GLenum target = GL_TEXTURE_1D + (GLenum)i, name = texture_names[n];

            gl->GetTexParameterfv(target, name, to->parameter[i][n]);
            gl->GetTexParameteriv(target, name, to->integer_parameter[i][n]);
        }
    for (int i = 0; i < 4; ++i)
        for (int n = 0; n < 3; ++n)
            gl->GetTexGenfv(GL_S + (GLenum)i, generation_names[n], to->generation[i][n]);
    gl->GetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, to->environment[0]);
    gl->GetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, to->environment[1]);
    for (int n = 0; n < COMBINE_NAMES; ++n)
        gl->GetTexEnvfv(GL_TEXTURE_ENV, combine_names[n], &to->combine[n]);
    for (int i = 0; i < ASKED_LIGHTS; ++i)
        for (int n = 0; n < LIGHT_NAMES; ++n)
            gl->GetLightfv(GL_LIGHT0 + (GLenum)i, light_names[n], to->light[i][n]);
    for (int side = 0; side < 2; ++side)
        for (int n = 0; n < MATERIAL_NAMES; ++n)
            gl->GetMaterialfv(side ? GL_BACK : GL_FRONT, material_names[n], to->material[side][n]);
    GLint bound;
    gl->GetIntegerv(GL_RENDERBUFFER_BINDING, &bound);
    for (int n = 0; n < RENDERBUFFER_NAMES && bound != 0; ++n)
        gl->GetRenderbufferParameteriv(GL_RENDERBUFFER, renderbuffer_names[n],
                                       &to->renderbuffer[n]);
    for (GLenum i = 0; i < PLANES; ++i)
        gl->GetClipPlane(GL_CLIP_PLANE0 + i, to->plane[i]);
    if (has_little_storage(gl, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS))
        gl->GetPolygonStipple(to->pattern);
    for (GLenum i = 0; i < EVALUATOR_MAPS; ++i) {
        const GLenum map = i < 9 ? GL_MAP1_COLOR_4 + i : GL_MAP2_COLOR_4 + i - 9;

        gl->GetMapfv(map, GL_ORDER, to->evaluator[i]);
        gl->GetMapfv(map, GL_DOMAIN, to->evaluator[i] + 2);
        gl->GetMapfv(map, GL_COEFF, to->evaluator[i] + 6);
        gl->GetMapdv(map, GL_DOMAIN, to->wide_evaluator[i]);
        gl->GetMapiv(map, GL_COEFF, to->integer_evaluator[i]);
    }
    for (GLenum i = 0; i < PIXEL_MAPS; ++i) {
        gl->GetPixelMapfv(GL_PIXEL_MAP_I_TO_I + i, to->map[i]);
        gl->GetPixelMapuiv(GL_PIXEL_MAP_I_TO_I + i, to->integer_map[i]);
    }
    forget_overflows(to);
}

static bool is_equal(const answers *a, const answers *b, int n)
{
    return memcmp(a->integer[n], b->integer[n], sizeof a->integer[n]) == 0 &&
           memcmp(a->number[n], b->number[n], sizeof a->number[n]) == 0 &&
           memcmp(a->wide[n], b->wide[n], sizeof a->wide[n]) == 0 &&
           memcmp(a->truth[n], b->truth[n], sizeof a->truth[n]) == 0;
}

/* Compares lights and materials, and prints the first value that differs. */
static bool are_lights_equal(const answers *a, const answers *b)
{
    for (int i = 0; i < ASKED_LIGHTS; ++i)
        for (int n = 0; n < LIGHT_NAMES; ++n)
            if (memcmp(a->light[i][n], b->light[i][n], sizeof a->light[i][n]) != 0) {
                printf("light %d, %#x: %.9g beside %.9g\n", i, light_names[n],
                       (double)a->light[i][n][0], (double)b->light[i][n][0]);
                return false;
            }
    for (int side = 0; side < 2; ++side)
        for (int n = 0; n < MATERIAL_NAMES; ++n)
            if (memcmp(a->material[side][n], b->material[side][n], sizeof a->material[side][n]) !=
                0) {
                printf("material %d, %#x: %.9g beside %.9g\n", side, material_names[n],
                       (double)a->material[side][n][0], (double)b->material[side][n][0]);
                return false;
            }
    return true;
}

/* Compares the bound renderbuffers, and prints the first value that differs. */
static bool are_renderbuffers_equal(const answers *a, const answers *b)
{
    for (int n = 0; n < RENDERBUFFER_NAMES; ++n)
        if (a->renderbuffer[n] != b->renderbuffer[n]) {
            printf("renderbuffer, %#x: %d beside %d\n", renderbuffer_names[n], a->renderbuffer[n],
                   b->renderbuffer[n]);
            return false;
        }
    return true;
}

/* Compares the pattern of polygons and the maps of pixel transfer, and prints the first value that
 * differs. */
static bool are_maps_equal(const answers *a, const answers *b)
{
    if (memcmp(a->pattern, b->pattern, sizeof a->pattern) != 0) {
        printf("the pattern of polygons\n");
        return false;
    }
    for (int i = 0; i < PIXEL_MAPS; ++i)
        for (int n = 0; n < PIXEL_MAP_SIZE; ++n)
            if (memcmp(&a->map[i][n], &b->map[i][n], sizeof a->map[i][n]) != 0 ||
                a->integer_map[i][n] != b->integer_map[i][n]) {
                printf("map %d, %d: %.9g, %u beside %.9g, %u\n", i, n, (double)a->map[i][n],
                       a->integer_map[i][n], (double)b->map[i][n], b->integer_map[i][n]);
                return false;
            }
    return true;
}

/* Compares the maps of evaluators, and prints the first that differs. */
static bool are_evaluators_equal(const answers *a, const answers *b)
{
    for (int i = 0; i < EVALUATOR_MAPS; ++i)
        if (memcmp(a->evaluator[i], b->evaluator[i], sizeof a->evaluator[i]) != 0 ||
            memcmp(a->wide_evaluator[i], b->wide_evaluator[i], sizeof a->wide_evaluator[i]) != 0 ||
            memcmp(a->integer_evaluator[i], b->integer_evaluator[i],
                   sizeof a->integer_evaluator[i]) != 0) {
            printf("map %d of evaluators: orders %g, %g, domain %g to %g, point %g beside %g, %g, "
                   "%g to %g, %g\n",
                   i, (double)a->evaluator[i][0], (double)a->evaluator[i][1],
                   (double)a->evaluator[i][2], (double)a->evaluator[i][3],
                   (double)a->evaluator[i][6], (double)b->evaluator[i][0],
                   (double)b->evaluator[i][1], (double)b->evaluator[i][2],
                   (double)b->evaluator[i][3], (double)b->evaluator[i][6]);
            return false;
        }
    return true;
}

/* Compares clip planes, and prints the first that differs. */
static bool are_planes_equal(const answers *a, const answers *b)
{
    for (int i = 0; i < PLANES; ++i)
        for (int c = 0; c < 4; ++c)
            if (memcmp(&a->plane[i][c], &b->plane[i][c], sizeof a->plane[i][c]) != 0) {
                printf("clip plane %d: %.9g beside %.9g\n", i, a->plane[i][c], b->plane[i][c]);
                return false;
            }
    return true;
}

static bool are_textures_equal(const answers *a, const answers *b)
{
    const bool equal =
        memcmp(a->parameter, b->parameter, sizeof a->parameter) == 0 &&
        memcmp(a->integer_parameter, b->integer_parameter, sizeof a->integer_parameter) == 0;
    const bool generated = memcmp(a->generation, b->generation, sizeof a->generation) == 0;
    const bool combined = memcmp(a->environment, b->environment, sizeof a->environment) == 0 &&
                          memcmp(a->combine, b->combine, sizeof a->combine) == 0;

    if (!equal || !generated || !combined)
        printf("textures: equal %d, generated %d, combined %d\n", equal, generated, combined);
    for (int n = 0; n < COMBINE_NAMES; ++n)
        if (a->combine[n] != b->combine[n])
            printf("  %#x: %g beside %g\n", combine_names[n], (double)a->combine[n],
                   (double)b->combine[n]);
    for (int i = 0; i < 2; ++i)
        for (int n = 0; n < TEXTURE_NAMES; ++n)
            for (int c = 0; c < 4; ++c)
                if (a->parameter[i][n][c] != b->parameter[i][n][c])
                    printf("  %#x: %g beside %g\n", texture_names[n], (double)a->parameter[i][n][c],
                           (double)b->parameter[i][n][c]);
    return equal && generated && combined;
}

static void print_difference(const answers *a, const answers *b, int n, const char *group,
                             unsigned kind, GLsizei stride)
{
    printf("state %#x after call %s%u with stride %d:\n", names[n], group, kind, stride);
    for (int side = 0; side < 2; ++side) {
        const answers *const of = side ? b : a;

        printf("  %s", side ? "ours     " : "reference");
        for (int i = 0; i < 4; ++i)
            printf("  %d %.9g %.17g %d", of->integer[n][i], (double)of->number[n][i],
                   of->wide[n][i], of->truth[n][i]);
        printf("\n");
    }
}

static answers answer[LIBRARIES];
static unsigned char pixels[LIBRARIES][WINDOW * WINDOW * 4];

int main(int count, char **argument)
{
    random_source r = random_seed(count > 2 ? strtoull(argument[2], NULL, 10) : 1);
    const unsigned calls = count > 3 ? (unsigned)strtoul(argument[3], NULL, 10) : 3000;
    library libraries[LIBRARIES];
    unsigned passed = 0, failed = 0;

    if (count < 2 || !load_libraries(argument[1], libraries))
        return 2;
    for (int l = 0; l < LIBRARIES; ++l) {
        library *const gl = &libraries[l];

        gl->context = gl->OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 16, NULL);
        gl->OSMesaMakeCurrent(gl->context, pixels[l], GL_UNSIGNED_BYTE, WINDOW, WINDOW);
    }
    for (unsigned n = 0; n <= calls && failed < 20; ++n) {
        const call_group *const group = choose_group(&r);
        const unsigned kind = random_below(&r, group->kinds);
        GLenum error[LIBRARIES];
        GLint returned[LIBRARIES] = {0};
        arguments a;
        bool equal = true;

        choose_arguments(&r, &a);
        for (int l = 0; l < LIBRARIES; ++l) {
            if (n > 0)
                returned[l] = call_of_group(&libraries[l], group, kind, &a);
            error[l] = libraries[l].GetError();
            ask(&libraries[l], &answer[l]);
        }
        if (error[0] != error[1]) {
            printf(
                "call %s%u(%#x, %#x; switch %#x; %d, %d, %d, %d; %g, %g): error %#x beside %#x\n",
                group->name, kind, a.e[0], a.e[1], a.name, a.i[0], a.i[1], a.i[2], a.i[3],
                (double)a.f[0], (double)a.f[1], error[0], error[1]);
            equal = false;
        }
        if (returned[0] != returned[1]) {
            printf("call %s%u(%d, %d, %d, %d) returns %d beside %d\n", group->name, kind, a.i[0],
                   a.i[1], a.i[2], a.i[3], returned[0], returned[1]);
            equal = false;
        }
        for (int k = 0; k < NAMES; ++k) {
            if (is_equal(&answer[0], &answer[1], k))
                continue;
            if (equal || n == 0)
                print_difference(&answer[0], &answer[1], k, group->name, kind, a.stride);
            equal = false;
        }
        if (equal &&
            (!are_lights_equal(&answer[0], &answer[1]) ||
             !are_planes_equal(&answer[0], &answer[1]) || !are_maps_equal(&answer[0], &answer[1]) ||
             !are_evaluators_equal(&answer[0], &answer[1]) ||
             !are_renderbuffers_equal(&answer[0], &answer[1]) ||
             !are_textures_equal(&answer[0], &answer[1]) || !are_attachments_equal(libraries))) {
            printf("  after call %s%u\n", group->name, kind);
            equal = false;
        }
        passed += equal;
        failed += !equal;
    }
    printf("osmesa-state: %u passed, %u failed\n", passed, failed);
    return failed != 0;
}
