/* gnomon transform with setups worked by hand. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What is printed of a point: rows of numbers, each behind its name, as in "world 1 2 3 view 1 2
 * 3"; and words in place of NDC and pixel, or after them. Null: these are not looked at. */
typedef struct point {
    const char *rows, *words;
} point;

static run transform(const char *setup, const char *options)
{
    write_text("setup.txt", setup);
    run r = good("transform %s setup.txt", options);
    assert_string_equal(r.error, "");
    return r;
}

/* Expects numbers at `at`, divided by blanks and ends of lines, within a few roundings. Returns
 * what follows them in `values`. */
static const char *expect_numbers(const char *at, const char *values, const char *where)
{
    char *number = (char *)(uintptr_t)at;
    while (*values != '\0' && !isalpha((unsigned char)*values)) {
        char *end;
        const double wanted = strtod(values, &end), got = strtod(number, &number);
        if (!(fabs(got - wanted) <= 4e-7 * (1.0 + fabs(wanted))))
            fail_msg("%s: %.9g is not %.9g in\n%.400s", where, got, wanted, at);
        values = end + strspn(end, " ");
    }
    assert_true(*number == '\n' || strncmp(number, "   in column ", 13) == 0);
    return values;
}

/* The text of a point, from 1 on; valid until the next call. */
static const char *section(const char *out, size_t number)
{
    static char text[1024];
    char heading[32];
    snprintf(heading, sizeof heading, "\npoint %zu\n", number);
    const char *start = strstr(out, heading);
    if (start == NULL)
        fail_msg("no point %zu in\n%s", number, out);
    const char *end = strstr(start + 2, "\npoint ");
    snprintf(text, sizeof text, "%.*s", (int)(end != NULL ? end - start + 1 : 1023), start);
    return text;
}

static void expect_points(const char *setup, const point *points, size_t count)
{
    const run r = transform(setup, "");
    for (size_t i = 0; i < count; ++i) {
        const char *text = section(r.out, i + 1), *words = points[i].words;
        for (const char *rows = points[i].rows; rows != NULL && *rows != '\0';) {
            char start[16];
            const int length = (int)strcspn(rows, " ");
            snprintf(start, sizeof start, "\n  %-5.*s ", length, rows);
            const char *row = strstr(text, start);
            if (row == NULL)
                fail_msg("no %s in\n%s", start, text);
            rows = expect_numbers(row + strlen(start), rows + length + 1, start);
        }
        if (words == NULL)
            continue;
        const bool is_inside = strncmp(words, "in column", 9) == 0;
        const bool divided = is_inside || strncmp(words, "outside", 7) == 0;
        if (strstr(text, words) == NULL || (strstr(text, "\n  NDC  ") != NULL) != divided ||
            (strstr(text, "\n  pixel") != NULL) != divided ||
            (is_inside && strstr(text, "outside") != NULL))
            fail_msg("'%s' and\n%s", words, text);
    }
}

/* A right angle of view in a square of 100x100 pixels, near 1, far 3. OpenGL's camera at (0, 0, 10)
 * looks along -z: view = world - (0, 0, 10); d = -view z;
 * clip = (x, y, -2 z - 3, -z): NDC z is -1 at d = 1, 0 at d = 1.5, 1 at d = 3.
 * Direct3D's camera at (0, 0, -10) looks along +z: clip = (x, y, 1.5 z - 1.5, z): NDC z is 0 at 1,
 * 0.5 at 1.5. Vulkan's camera is OpenGL's with clip = (x, -y, -1.5 z - 1.5, -z). */
#define CAMERA "screen 100 100\nperspective 90\nnear 1\nfar 3\n"
#define OPENGL "convention opengl\nposition 0 0 10\n" CAMERA
#define DIRECT3D "convention direct3d\nposition 0 0 -10\n" CAMERA
#define VULKAN "convention vulkan\nposition 0 0 10\n" CAMERA

TEST(opengl)
{
    static const point points[] = {
        {"world 0 0 8.5 view 0 0 -1.5 clip 0 0 0 1.5 NDC 0 0 0 pixel 50 50 0.5",
         "in column 50, row 50\n"},
        /* The corner right, top, near: x = y = d = 1; on the window's edge. */
        {"world 1 1 9 view 1 1 -1 clip 1 1 -1 1 NDC 1 1 -1 pixel 100 100 0", NULL},
        /* The corner left, bottom, far: x = y = -3. */
        {"world -3 -3 7 view -3 -3 -3 clip -3 -3 3 3 NDC -1 -1 1 pixel 0 0 1",
         "in column 0, row 0\n"},
        /* d = 2: clip z = 4 - 3 = 1, NDC (0.5, 0.25, 0.5). */
        {"world 1 0.5 8 view 1 0.5 -2 clip 1 0.5 1 2 NDC 0.5 0.25 0.5 pixel 75 62.5 0.75",
         "in column 75, row 62\n"},
        /* d = 4, x = 8: clip z = 8 - 3 = 5, NDC (2, 0, 1.25). */
        {"world 8 0 6 view 8 0 -4 clip 8 0 5 4 NDC 2 0 1.25 pixel 150 50 1.125",
         "outside the view volume: right, far\n"},
        {NULL, "behind the eye, w < 0"},
        {NULL, "in the plane of the eye, w = 0"},
        {NULL, "outside the view volume: bottom, near\n"},
    };
    expect_points(OPENGL "point 0 0 8.5\npoint 1 1 9\npoint -3 -3 7\npoint 1 0.5 8\npoint 8 0 6\n"
                         "point 0 0 12\npoint 5 6 10\npoint 0 -0.6 9.5\n",
                  points, COUNT(points));
    const run r = transform(OPENGL "point 1 1 9\n", "");
    assert_null(strstr(r.out, "outside"));
    assert_null(strstr(r.out, "in column"));
}

TEST(direct3d)
{
    static const point points[] = {
        {"world 0 0 -8.5 view 0 0 1.5 clip 0 0 0.75 1.5 NDC 0 0 0.5 pixel 50 50 0.5", NULL},
        /* Right, top, near: the upper right of the screen, where rows go down. */
        {"world 1 1 -9 view 1 1 1 clip 1 1 0 1 NDC 1 1 0 pixel 100 0 0", NULL},
        {"world -3 -3 -7 view -3 -3 3 clip -3 -3 3 3 NDC -1 -1 1 pixel 0 100 1", NULL},
        /* z = 2: clip z = 3 - 1.5 = 1.5. */
        {"world 1 0.5 -8 view 1 0.5 2 clip 1 0.5 1.5 2 NDC 0.5 0.25 0.75 pixel 75 37.5 0.75",
         "in column 75, row 37\n"},
        {NULL, "outside the view volume: top, near\n"},
        {NULL, "behind the eye"},
        {NULL, "in the plane of the eye"},
    };
    expect_points(DIRECT3D "point 0 0 -8.5\npoint 1 1 -9\npoint -3 -3 -7\npoint 1 0.5 -8\n"
                           "point 0 3 -9.5\npoint 0 0 -12\npoint 0 0 -10\n",
                  points, COUNT(points));
}

TEST(vulkan)
{
    static const point points[] = {
        {"world 1 1 9 view 1 1 -1 clip 1 -1 0 1 NDC 1 -1 0 pixel 100 0 0", NULL},
        {"world 1 0.5 8 view 1 0.5 -2 clip 1 -0.5 1.5 2 NDC 0.5 -0.25 0.75 pixel 75 37.5 0.75",
         NULL},
        {NULL, "outside the view volume: top\n"},
        {NULL, "outside the view volume: bottom\n"},
        {NULL, "behind the eye"},
    };
    expect_points(VULKAN "point 1 1 9\npoint 1 0.5 8\npoint 0 5 8\npoint 0 -5 8\npoint 0 0 11\n",
                  points, COUNT(points));
}

/* (1, 0, 0) becomes (2, 0, 0) when scaled by (2, 3, 4), (0, 2, 0) when turned by 90 degrees about
 * z, (0, 0, 2) when turned about x, (5, 6, 9) when moved by (5, 6, 7). (0, 1, 1) becomes (0, 3, 4),
 * (-3, 0, 4), (-3, -4, 0), (2, 2, 7). The camera is at (5, 6, 19). Orthographic: 10 wide, 20 high,
 * 4 to 14: NDC x = view x / 5, y = view y / 10, z = (-2 z - 18) / 10. */
TEST(models_and_boxes)
{
#define BOX "convention opengl\nscreen 200 100\northographic -5 5 -10 10\nnear 4\nfar 14\n"
    static const point points[] = {
        {"world 5 6 9 view 0 0 -10 clip 0 0 0.2 1 NDC 0 0 0.2 pixel 100 50 0.6", NULL},
        {"world 2 2 7 view -3 -4 -12 clip -0.6 -0.4 0.6 1 NDC -0.6 -0.4 0.6 pixel 40 30 0.8", NULL},
        /* (0, 0, 400), (0, 0, 400), (0, -400, 0): far below. No w is below 1. */
        {NULL, "outside the view volume: bottom\n"},
    };
    /* A quarter turn about -y takes x to z; 30 degrees about z, x to (cos 30, sin 30). */
    static const point quarter[] = {
        {"world 0 2 1 view 0 2 -10 clip 0 0.2 0.2 1 NDC 0 0.2 0.2 pixel 100 60 0.6", NULL}};
    static const point turned[] = {
        {"world 0.8660254 0.5 1 view 0.8660254 0.5 -10 clip 0.17320508 0.05 0.2 1 "
         "NDC 0.17320508 0.05 0.2 pixel 117.320508 52.5 0.6",
         NULL}};
    expect_points(BOX "scale 2 3 4\nrotate 0 0 1 90\nrotate 2 0 0 90\ntranslate 5 6 7\n"
                      "position 5 6 19\npoint 1 0 0\npoint 0 1 1\npoint 0 0 100\n",
                  points, 3);
    expect_points(BOX "rotate 0 -1 0 450\nposition 0 0 11\npoint 1 2 0\n", quarter, 1);
    expect_points(BOX "rotate 0 0 2 30\nposition 0 0 11\npoint 1 0 1\n", turned, 1);
}

/* One camera, set by target, by axes of other lengths, and in a left-handed world: at (4, 0, 0),
 * looking along -x. The point (2, 1, -1) is 2 ahead and 1 up. The right is -z in a right-handed
 * world, +z in a left-handed one. */
TEST(cameras)
{
    static const point right[] = {
        {"world 2 1 -1 view 1 1 -2 clip 1 1 1 2 NDC 0.5 0.5 0.5 pixel 75 75 0.75", NULL}};
    static const point left[] = {
        {"world 2 1 -1 view -1 1 2 clip -1 1 1.5 2 NDC -0.5 0.5 0.75 pixel 25 25 0.75", NULL}};
#define AT CAMERA "position 4 0 0\npoint 2 1 -1\n"
    expect_points("convention opengl\n" AT "target -9 0 0\n", right, 1);
    expect_points("convention opengl\n" AT "right 0 0 -0.5\nup 0 3 0\nforward -7 0 0\n", right, 1);
    expect_points("convention direct3d\n" AT "target -9 0 0\n", left, 1);
    expect_points("convention direct3d\n" AT "forward -1 0 0\nright 0 0 1\nup 0 1 0\n", left, 1);
}

/* Infinite: OpenGL's clip z = -z - 2 near, at d = 2 then 2 - 2 = 0; Direct3D reversed and
 * infinite: clip z = near = 1, NDC 1 / 2. Reversed with far 3: z' = w - (1.5 z - 1.5) =
 * -0.5 z + 1.5, at z = 2 then 0.5, NDC 0.25; at z = 4 beyond far, though z < 0. */
TEST(infinite_and_reversed)
{
    static const point infinite[] = {
        {"world 0 1 -2 view 0 1 -2 clip 0 1 0 2 NDC 0 0.5 0 pixel 50 75 0.5",
         "in column 50, row 75"},
        {NULL, "in column 50, row 50"}};
    static const point both[] = {
        {"world 0 1 2 view 0 1 2 clip 0 1 1 2 NDC 0 0.5 0.5 pixel 50 25 0.5", NULL},
        {NULL, "outside the view volume: near\n"}};
    static const point reversed[] = {
        {"world 0 1 2 view 0 1 2 clip 0 1 0.5 2 NDC 0 0.5 0.25 pixel 50 25 0.25", NULL},
        {NULL, "outside the view volume: far\n"},
        {NULL, "outside the view volume: near\n"}};
    expect_points("convention opengl\nscreen 100 100\nfrustum -1 1 -1 1\nnear 1\nfar infinite\n"
                  "point 0 1 -2\npoint 0 0 -1e30\n",
                  infinite, 2);
    expect_points("convention direct3d\nscreen 100 100\nperspective 90\nnear 1\nfar infinite\n"
                  "depth reversed\npoint 0 1 2\npoint 0 0 0.5\n",
                  both, 2);
    expect_points("convention direct3d\ndepth reversed\n" CAMERA
                  "point 0 1 2\npoint 0 0 4\npoint 0 0 0.5\n",
                  reversed, 3);
}

/* Orthographic planes may be behind the camera, and a picture may be mirrored: left, right, bottom
 * and top are then those of the picture. With depth reversed the near plane has depth 1. */
TEST(mirrored_boxes)
{
    static const point mirrored[] = {
        {"world 1 0 0 view 1 0 0 clip -0.5 0 -0.5 1 NDC -0.5 0 -0.5 pixel 25 50 0.25", NULL},
        {NULL, "outside the view volume: left\n"},
        {NULL, "outside the view volume: bottom\n"},
        {NULL, "outside the view volume: near\n"},
        {NULL, "outside the view volume: far\n"}};
    static const point reversed[] = {
        {"world 1 0 0 view 1 0 0 clip 0.5 0 0.5 1 NDC 0.5 0 0.5 pixel 75 50 0.75", NULL},
        {NULL, "outside the view volume: near\n"},
        {NULL, "outside the view volume: far\n"}};
    expect_points("convention opengl\nscreen 100 100\northographic 2 -2 1 -1\nnear -1\nfar 3\n"
                  "point 1 0 0\npoint 3 0 0\npoint 0 2 0\npoint 0 0 2\npoint 0 0 -4\n",
                  mirrored, 5);
    expect_points("convention opengl\nscreen 100 100\northographic -2 2 -1 1\nnear -1\nfar 3\n"
                  "depth reversed\npoint 1 0 0\npoint 0 0 2\npoint 0 0 -4\n",
                  reversed, 3);
}

/* Sixteen numbers, line by line, after the line of the name. */
typedef struct matrix {
    const char *name, *numbers;
} matrix;

static void expect_matrices(const char *setup, const char *words, const matrix *matrices,
                            size_t count)
{
    const run r = transform(setup, "--matrices");
    expect_printed(&r, words);
    for (size_t i = 0; i < count; ++i) {
        char heading[64];
        snprintf(heading, sizeof heading, "\n%s\n", matrices[i].name);
        const char *at = strstr(r.out, heading);
        if (at == NULL)
            fail_msg("no %s in\n%s", matrices[i].name, r.out);
        expect_numbers(at + strlen(heading), matrices[i].numbers, matrices[i].name);
    }
}

/* The cameras above. With OpenGL's numbers the inverse is: z = -w', 1 = (2 w' - z') / 3. */
TEST(matrices)
{
    static const matrix opengl_matrices[] = {
        {"view", "1 0 0 0 0 1 0 0 0 0 1 -10 0 0 0 1"},
        {"inverse of view", "1 0 0 0 0 1 0 0 0 0 1 10 0 0 0 1"},
        {"projection", "1 0 0 0 0 1 0 0 0 0 -2 -3 0 0 -1 0"},
        {"inverse of projection", "1 0 0 0 0 1 0 0 0 0 0 -1 0 0 -.333333333 .666666667"}};
    static const matrix direct3d_matrices[] = {
        {"view", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 10 1"},
        {"inverse of view", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 -10 1"},
        {"projection", "1 0 0 0 0 1 0 0 0 0 1.5 1 0 0 -1.5 0"},
        {"inverse of projection", "1 0 0 0 0 1 0 0 0 0 0 -.666666667 0 0 1 1"}};
    static const matrix vulkan_matrices[] = {
        {"projection", "1 0 0 0 0 -1 0 0 0 0 -1.5 -1.5 0 0 -1 0"}};
    expect_matrices(OPENGL, "column vectors", opengl_matrices, COUNT(opengl_matrices));
    expect_matrices(DIRECT3D "point 0 0 0\n", "row vectors", direct3d_matrices,
                    COUNT(direct3d_matrices));
    expect_matrices(DIRECT3D "point 0 0 0\n", "\npoint 1\n", NULL, 0);
    expect_matrices(VULKAN, "", vulkan_matrices, COUNT(vulkan_matrices));
}

/* OpenGL's camera above and a model scaled by 2 and moved by (1, 2, 3): view z is 2 z - 7, so
 * clip = (2 x + 1, 2 y + 2, 11 - 4 z, 7 - 2 z). Inverted: 1 = (2 w' - z') / 3, z = (7 - w') / 2.
 * Direct3D: view z is 2 z + 13: clip = (2 x + 1, 2 y + 2, 3 z + 18, 2 z + 13). */
TEST(all_matrices)
{
    static const matrix opengl_matrices[] = {
        {"model", "2 0 0 1 0 2 0 2 0 0 2 3 0 0 0 1"},
        {"inverse of model", ".5 0 0 -.5 0 .5 0 -1 0 0 .5 -1.5 0 0 0 1"},
        {"viewport", "50 0 0 50 0 50 0 50 0 0 .5 .5 0 0 0 1"},
        {"inverse of viewport", ".02 0 0 -1 0 .02 0 -1 0 0 2 -1 0 0 0 1"},
        {"combined, from local to clip", "2 0 0 1 0 2 0 2 0 0 -4 11 0 0 -2 7"},
        {"inverse of combined, from clip to local",
         ".5 0 .166666667 -.333333333 0 .5 .333333333 -.666666667 0 0 -1.16666667 1.83333333 "
         "0 0 -.333333333 .666666667"}};
    static const matrix direct3d_matrices[] = {
        {"model", "2 0 0 0 0 2 0 0 0 0 2 0 1 2 3 1"},
        {"viewport", "50 0 0 0 0 -50 0 0 0 0 1 0 50 50 0 1"},
        {"inverse of viewport", ".02 0 0 0 0 -.02 0 0 0 0 1 0 -1 1 0 1"},
        {"combined, from local to clip", "2 0 0 0 0 2 0 0 0 0 3 2 1 2 18 13"}};
    expect_matrices(OPENGL "scale 2\ntranslate 1 2 3\n", "", opengl_matrices,
                    COUNT(opengl_matrices));
    expect_matrices(DIRECT3D "scale 2\ntranslate 1 2 3\n", "", direct3d_matrices,
                    COUNT(direct3d_matrices));
    const run r = transform("convention opengl\nscreen 9 9\nscale 1e30\nperspective 1e-7\nnear 1\n"
                            "far 2\n",
                            "--matrices");
    expect_printed(&r, "\ncombined: a number of it or of its inverse is too large");
    assert_null(strstr(r.out, "inf"));
}

/* With nine digits 0.1 as a float and its neighbour differ, and columns have a space between them.
 * This point is so near to the plane of the eye that 0.1 / 2^-126 * 50 exceeds the largest float.
 */
TEST(numbers_give_the_float_back)
{
    static const char setup[] =
        "convention opengl\n" CAMERA "point 0.1 0.10000001 -1.17549435e-38\n";
    static const point points[] = {{NULL, "too large for 32-bit numbers\n"}};
    const run r = transform(setup, "");
    expect_printed(&r, "local      0.100000001      0.100000009  -1.17549435e-38\n");
    assert_null(strstr(r.out, "nan"));
    assert_null(strstr(r.out, "inf"));
    expect_points(setup, points, 1);
}
