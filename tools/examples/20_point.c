/* Lesson 20: the way of a point from its model to its pixel, in the conventions of OpenGL and of
 * Direct3D. Both put the same point into the same place of the window, if the worlds mirror each
 * other; but the numbers on the way differ. */
#include "lesson.h"

enum { MOST_POINTS = 64 };

static const char help[] =
    "usage: 20_point < SETUP\n"
    "Prints every stage of the way of points. A line of the setup is a word and its numbers:\n"
    "screen WIDTH HEIGHT; perspective DEGREES; near DISTANCE; far DISTANCE; point X Y Z;\n"
    "scale, translate, position, target, up X Y Z; rotate X Y Z DEGREES, in the order of lines.\n"
    "`gnomon transform` takes the same words. An empty setup shows an example.\n";

typedef struct setup {
    float screen[2], perspective, near_plane, far_plane;
    gn_vec3 scale, translate, position, target, up;
    gn_transform rotation;
    gn_vec3 point[MOST_POINTS];
    int points;
} setup;

static int wrong(int line, const char *what)
{
    fprintf(stderr, "20_point: line %d: %s\n", line, what);
    return 2;
}

/* Reads one statement of the words above; returns 0, or what `wrong` returns. */
static int read_statement(setup *s, const char *word, const float n[4], int count, int line)
{
    const struct {
        const char *word;
        int count;
        float *to;
    } plain[] = {{"screen", 2, s->screen},
                 {"perspective", 1, &s->perspective},
                 {"near", 1, &s->near_plane},
                 {"far", 1, &s->far_plane},
                 {"scale", 3, &s->scale.x},
                 {"translate", 3, &s->translate.x},
                 {"position", 3, &s->position.x},
                 {"target", 3, &s->target.x},
                 {"up", 3, &s->up.x}};
    gn_transform turn;

    for (size_t i = 0; i < sizeof plain / sizeof *plain; ++i) {
        if (strcmp(word, plain[i].word) == 0 && count == plain[i].count) {
            memcpy(plain[i].to, n, (size_t)count * sizeof *n);
            return 0;
        }
    }
    if (strcmp(word, "rotate") == 0 && count == 4) {
        if (gn_rotate_axis((gn_vec3){n[0], n[1], n[2]}, gn_radians(n[3]), &turn) != GN_OK)
            return wrong(line, "rotate needs an axis that is not 0 0 0");
        gn_transform_compose(&turn, &s->rotation, &s->rotation);
        return 0;
    }
    if (strcmp(word, "point") == 0 && count == 3 && s->points < MOST_POINTS) {
        s->point[s->points++] = (gn_vec3){n[0], n[1], n[2]};
        return 0;
    }
    return wrong(line, "no known word with that many numbers, or more than 64 points");
}

static int read_setup(FILE *file, setup *s)
{
    char line[1024], word[32];
    int number = 0, fault = 0;

    while (!fault && fgets(line, sizeof line, file)) {
        float n[4];
        const int found = sscanf(line, "%31s %f %f %f %f", word, &n[0], &n[1], &n[2], &n[3]) - 1;

        ++number;
        if (found >= 0 && word[0] != '#')
            fault = read_statement(s, word, n, found, number);
    }
    return fault;
}

static void print_stage(const char *name, gn_vec3 v)
{
    printf("  %-6s %16.9g %16.9g %16.9g\n", name, (double)v.x, (double)v.y, (double)v.z);
}

/* OpenGL: right-handed, the camera looks along -z, depth in clip space is -w..w, rows from the
 * bottom. Direct3D: left-handed, along +z, 0..w, rows from the top. */
static gn_status make_matrices(const setup *s, bool direct3d, gn_transform stage[4])
{
    const float fov = gn_radians(s->perspective), aspect = s->screen[0] / s->screen[1];
    gn_mat3 rotation;
    gn_status status;

    gn_mat4_upper_left(&s->rotation.matrix, &rotation);
    status = gn_trs(s->translate, &rotation, s->scale, &stage[0]);
    if (!status)
        status =
            (direct3d ? gn_look_at_lh : gn_look_at_rh)(s->position, s->target, s->up, &stage[1]);
    if (!status)
        status = (direct3d ? gn_perspective_lh_zo : gn_perspective_rh_no)(
            fov, aspect, s->near_plane, s->far_plane, &stage[2]);
    if (!status)
        status = (direct3d ? gn_viewport_zo_y_down : gn_viewport_no)(0, 0, s->screen[0],
                                                                     s->screen[1], 0, 1, &stage[3]);
    return status;
}

static void print_way(const gn_transform stage[4], gn_vec3 local)
{
    const gn_vec3 world = gn_mat4_transform_point(&stage[0].matrix, local);
    const gn_vec3 view = gn_mat4_transform_point(&stage[1].matrix, world);
    const gn_vec4 clip = gn_mat4_multiply_vec4(&stage[2].matrix, gn_extend3(view, 1));
    gn_vec3 ndc;

    print_stage("local", local);
    print_stage("world", world);
    print_stage("view", view);
    printf("  %-6s %16.9g %16.9g %16.9g %16.9g\n", "clip", (double)clip.x, (double)clip.y,
           (double)clip.z, (double)clip.w);
    if (gn_clip_to_ndc(clip, &ndc) != GN_OK) {
        printf("  behind the eye\n");
        return;
    }
    print_stage("NDC", ndc);
    print_stage("pixel", gn_mat4_transform_point(&stage[3].matrix, ndc));
}

int main(int argc, char **argv)
{
    const float perspective = lesson_slider("perspective in degrees", 60, 10, 150);
    const float near_plane = lesson_slider("near plane", 0.1f, 0.01f, 2);
    const float distance = lesson_slider("distance of the camera", 3, 0.5f, 20);
    setup s = {.screen = {640, 480},
               .perspective = perspective,
               .near_plane = near_plane,
               .far_plane = 100,
               .scale = {1, 1, 1},
               .position = {0, 0, distance},
               .up = {0, 1, 0}};
    gn_transform stage[4];

    lesson_help(argc, argv, 0, help);
    gn_transform_identity(&s.rotation);
    if (read_setup(stdin, &s) != 0)
        return 2;
    if (s.points == 0)
        s.point[s.points++] = (gn_vec3){1, 0.5f, 0.25f};
    for (int direct3d = 0; direct3d < 2; ++direct3d) {
        const gn_status status = make_matrices(&s, direct3d, stage);
        if (status != GN_OK) {
            fprintf(stderr, "20_point: impossible setup: %s\n", gn_status_text(status));
            return 2;
        }
        for (int i = 0; i < s.points; ++i) {
            printf("%s, point %d\n", direct3d ? "Direct3D" : "OpenGL", i + 1);
            print_way(stage, s.point[i]);
        }
    }
    return 0;
}
