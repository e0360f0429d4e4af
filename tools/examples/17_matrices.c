/* Lesson 17: the matrices in theory. The view is the inverse of the camera's own T R S. A
 * perspective projection is a squeeze, which makes a box of the pyramid that the camera sees, and
 * then the orthographic projection of that box. The library's functions must return the same
 * matrices. */
#include "lesson.h"

static const char help[] = "usage: 17_matrices\n"
                           "Prints view and projection as theory makes them, and how far the\n"
                           "library's own are from them.\n";

/* Rows as in a book: point' = matrix * point. */
static gn_mat4 rows(gn_vec4 a, gn_vec4 b, gn_vec4 c, gn_vec4 d)
{
    const float numbers[16] = {a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w,
                               c.x, c.y, c.z, c.w, d.x, d.y, d.z, d.w};
    gn_mat4 m;

    gn_mat4_from_rows(numbers, &m);
    return m;
}

static gn_mat4 product(gn_mat4 a, gn_mat4 b)
{
    gn_mat4 m;

    gn_mat4_multiply(&a, &b, &m);
    return m;
}

/* The camera stands at `eye` (T), turned so that its axes are right, up and back (the columns of
 * R), and is as large as it is (S = 1). It places what the camera sees into the world. To see the
 * world from the camera, undo this in the opposite order: (T R)^-1 = R^-1 T^-1. A rotation is
 * undone by its transpose, so the axes are now the rows; a translation is undone by the opposite
 * one. */
static gn_mat4 view_by_hand(gn_vec3 eye, gn_vec3 target, gn_vec3 up)
{
    gn_vec3 back, right;
    lesson_check(gn_vec3_normalize(gn_vec3_subtract(eye, target), &back));
    lesson_check(gn_vec3_normalize(gn_vec3_cross(up, back), &right));
    const gn_vec3 above = gn_vec3_cross(back, right);

    const gn_mat4 undo_rotation =
        rows((gn_vec4){right.x, right.y, right.z, 0}, (gn_vec4){above.x, above.y, above.z, 0},
             (gn_vec4){back.x, back.y, back.z, 0}, (gn_vec4){0, 0, 0, 1});
    const gn_mat4 undo_translation = rows((gn_vec4){1, 0, 0, -eye.x}, (gn_vec4){0, 1, 0, -eye.y},
                                          (gn_vec4){0, 0, 1, -eye.z}, (gn_vec4){0, 0, 0, 1});
    return product(undo_rotation, undo_translation);
}

/* At the distance d = -z, x and y become x n / d and y n / d: the far end of the pyramid is
 * squeezed to the size of the near end. The depths n and f stay where they are: z (n + f) + n f,
 * divided by d, is -n for z = -n and -f for z = -f. */
static gn_mat4 squeeze(float n, float f)
{
    return rows((gn_vec4){n, 0, 0, 0}, (gn_vec4){0, n, 0, 0}, (gn_vec4){0, 0, n + f, n * f},
                (gn_vec4){0, 0, -1, 0});
}

/* Moves the middle of the box to the origin, then scales its sides to 2; z is turned, since depth
 * grows away from the camera. */
static gn_mat4 orthographic(float wide, float high, float n, float f)
{
    const gn_mat4 move = rows((gn_vec4){1, 0, 0, 0}, (gn_vec4){0, 1, 0, 0},
                              (gn_vec4){0, 0, 1, (n + f) / 2}, (gn_vec4){0, 0, 0, 1});
    const gn_mat4 scale = rows((gn_vec4){1 / wide, 0, 0, 0}, (gn_vec4){0, 1 / high, 0, 0},
                               (gn_vec4){0, 0, -2 / (f - n), 0}, (gn_vec4){0, 0, 0, 1});

    return product(scale, move);
}

static void print_matrix(const char *name, gn_mat4 m)
{
    float r[16];

    gn_mat4_to_rows(&m, r);
    printf("%s\n", name);
    for (int i = 0; i < 16; i += 4)
        printf("%11.6f %11.6f %11.6f %11.6f\n", (double)r[i], (double)r[i + 1], (double)r[i + 2],
               (double)r[i + 3]);
}

/* Prints the largest difference of two entries; returns whether it is more than rounding. */
static int compare(const char *name, gn_mat4 ours, gn_mat4 librarys)
{
    float largest = 0;

    for (int i = 0; i < 16; ++i) {
        const float difference = ours.m[i / 4][i % 4] - librarys.m[i / 4][i % 4];
        largest = gn_maximum1(largest, difference < 0 ? -difference : difference);
    }
    printf("%s: largest difference %.1g\n", name, (double)largest);
    return largest > 1e-6f;
}

int main(int argc, char **argv)
{
    const gn_vec3 eye = {2, 1, 3}, target = {0, 0.5f, 0}, up = {0, 1, 0};
    const float fov_y = lesson_slider("field of view", 0.8f, 0.3f, 2.5f), aspect = 4.0f / 3;
    const float n = lesson_slider("near plane", 0.5f, 0.1f, 2);
    const float f = lesson_slider("far plane", 10, 3, 100);
    int wrong = 0;
    gn_transform view, projection;

    lesson_help(argc, argv, 0, help);
    const gn_mat4 theory_view = view_by_hand(eye, target, up);
    print_matrix("view = (T R S)^-1", theory_view);
    lesson_check(gn_look_at_rh(eye, target, up, &view));
    wrong += compare("beside gn_look_at_rh", theory_view, view.matrix);

    const float high = n * gn_tan(fov_y / 2), wide = high * aspect; /* of the near end */
    print_matrix("\nsqueeze", squeeze(n, f));
    print_matrix("orthographic", orthographic(wide, high, n, f));
    const gn_mat4 theory_projection = product(orthographic(wide, high, n, f), squeeze(n, f));
    print_matrix("perspective = orthographic * squeeze", theory_projection);
    lesson_check(gn_perspective_rh_no(fov_y, aspect, n, f, &projection));
    wrong += compare("beside gn_perspective_rh_no", theory_projection, projection.matrix);
    return wrong > 0;
}
