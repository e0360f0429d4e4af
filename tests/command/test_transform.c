/* gnomon transform with setups worked by hand. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* One point of the output: rows as printed, or the text in place of NDC and pixel. */
typedef struct expected {
    float world[3], view[3], clip[4], ndc[3], pixel[3];
} expected;

static run transform(const char *text, const char *options)
{
    write_text("setup.txt", text);
    return shell(options[0] != '\0' ? "\"$GNOMON\" transform --matrices < setup.txt"
                                    : "\"$GNOMON\" transform < setup.txt");
}

/* The text from the line "point NUMBER" to the next such line. */
static void section(const char *out, int number, char *result, size_t size)
{
    char heading[32];
    snprintf(heading, sizeof heading, "\npoint %d\n", number);
    const char *start = strstr(out, heading);
    if (start == NULL)
        fail_msg("no point %d in\n%s", number, out);
    const char *end = strstr(start + 2, "\npoint ");
    size_t length = end != NULL ? (size_t)(end - start) + 1 : strlen(start);
    assert_true(length < size);
    memcpy(result, start, length);
    result[length] = '\0';
}

/* The numbers after a name at the beginning of a line are these, within a few roundings. */
static void expect_row(const char *text, const char *name, const float *values, int count)
{
    char start[32];
    snprintf(start, sizeof start, "\n  %-5s ", name);
    const char *row = strstr(text, start);
    if (row == NULL)
        fail_msg("no %s in\n%s", name, text);
    char *number = (char *)(uintptr_t)(row + strlen(start));
    for (int i = 0; i < count; ++i) {
        double got = strtod(number, &number);
        if (!(fabs(got - (double)values[i]) <= 4e-7 * (1.0 + fabs((double)values[i]))))
            fail_msg("%s: number %d is %.9g, not %.9g, in\n%s", name, i + 1, got, (double)values[i],
                     text);
    }
}

static void expect_point(const run *r, int number, const expected *e)
{
    char text[1024];
    section(r->out, number, text, sizeof text);
    expect_row(text, "world", e->world, 3);
    expect_row(text, "view", e->view, 3);
    expect_row(text, "clip", e->clip, 4);
    expect_row(text, "NDC", e->ndc, 3);
    expect_row(text, "pixel", e->pixel, 3);
}

/* The text in place of NDC and pixel, or after them. */
static void expect_words(const run *r, int number, const char *words, bool divided)
{
    char text[1024];
    section(r->out, number, text, sizeof text);
    if (strstr(text, words) == NULL)
        fail_msg("no '%s' in\n%s", words, text);
    assert_int_equal(strstr(text, "\n  NDC  ") != NULL, divided);
    assert_int_equal(strstr(text, "\n  pixel") != NULL, divided);
}

/* A right angle of view in a square of 100x100 pixels, near 1, far 3. OpenGL's camera at (0, 0, 10)
 * looks along -z: view = world - (0, 0, 10); d = -view z;
 * clip = (x, y, -2 z - 3, -z): NDC z is -1 at d = 1, 0 at d = 1.5, 1 at d = 3.
 * Direct3D's camera at (0, 0, -10) looks along +z: clip = (x, y, 1.5 z - 1.5, z): NDC z is 0 at 1,
 * 0.5 at 1.5. Vulkan's camera is OpenGL's with clip = (x, -y, -1.5 z - 1.5, -z). */
#define CAMERA "screen 100 100\nperspective 90\nnear 1\nfar 3\n"

TEST(opengl)
{
    static const expected axis = {
        {0, 0, 8.5f}, {0, 0, -1.5f}, {0, 0, 0, 1.5f}, {0, 0, 0}, {50, 50, 0.5f}};
    /* The corner right, top, near: x = y = d = 1. */
    static const expected corner = {
        {1, 1, 9}, {1, 1, -1}, {1, 1, -1, 1}, {1, 1, -1}, {100, 100, 0}};
    /* The corner left, bottom, far: x = y = -3. */
    static const expected far_corner = {
        {-3, -3, 7}, {-3, -3, -3}, {-3, -3, 3, 3}, {-1, -1, 1}, {0, 0, 1}};
    /* d = 2: clip z = 4 - 3 = 1, NDC (0.5, 0.25, 0.5). */
    static const expected inside = {
        {1, 0.5f, 8}, {1, 0.5f, -2}, {1, 0.5f, 1, 2}, {0.5f, 0.25f, 0.5f}, {75, 62.5f, 0.75f}};
    /* d = 4, x = 8: clip z = 8 - 3 = 5, NDC (2, 0, 1.25). */
    static const expected beyond = {
        {8, 0, 6}, {8, 0, -4}, {8, 0, 5, 4}, {2, 0, 1.25f}, {150, 50, 1.125f}};
    run r = transform("convention opengl\nposition 0 0 10\n" CAMERA
                      "point 0 0 8.5\npoint 1 1 9\npoint -3 -3 7\npoint 1 0.5 8\n"
                      "point 8 0 6\npoint 0 0 12\npoint 5 6 10\npoint 0 -0.6 9.5\n",
                      "");
    expect_good(&r);
    expect_point(&r, 1, &axis);
    expect_words(&r, 1, "in column 50, row 50\n", true);
    expect_point(&r, 2, &corner);
    expect_point(&r, 3, &far_corner);
    expect_words(&r, 3, "in column 0, row 0\n", true);
    expect_point(&r, 4, &inside);
    expect_words(&r, 4, "in column 75, row 62\n", true);
    expect_point(&r, 5, &beyond);
    expect_words(&r, 5, "outside the view volume: right, far\n", true);
    expect_words(&r, 6, "behind the eye, w < 0", false);
    expect_words(&r, 7, "in the plane of the eye, w = 0", false);
    expect_words(&r, 8, "outside the view volume: bottom, near\n", true);
    for (int i = 1; i <= 4; ++i) {
        char text[1024];
        section(r.out, i, text, sizeof text);
        assert_null(strstr(text, "outside"));
        assert_int_equal(strstr(text, "in column") == NULL, i == 2); /* on the window's edge */
    }
}

TEST(direct3d)
{
    static const expected axis = {
        {0, 0, -8.5f}, {0, 0, 1.5f}, {0, 0, 0.75f, 1.5f}, {0, 0, 0.5f}, {50, 50, 0.5f}};
    /* Right, top, near: the upper right of the screen, where rows go down. */
    static const expected corner = {{1, 1, -9}, {1, 1, 1}, {1, 1, 0, 1}, {1, 1, 0}, {100, 0, 0}};
    static const expected far_corner = {
        {-3, -3, -7}, {-3, -3, 3}, {-3, -3, 3, 3}, {-1, -1, 1}, {0, 100, 1}};
    /* z = 2: clip z = 3 - 1.5 = 1.5. */
    static const expected inside = {
        {1, 0.5f, -8}, {1, 0.5f, 2}, {1, 0.5f, 1.5f, 2}, {0.5f, 0.25f, 0.75f}, {75, 37.5f, 0.75f}};
    run r = transform("convention direct3d\nposition 0 0 -10\n" CAMERA
                      "point 0 0 -8.5\npoint 1 1 -9\npoint -3 -3 -7\npoint 1 0.5 -8\n"
                      "point 0 3 -9.5\npoint 0 0 -12\npoint 0 0 -10\n",
                      "");
    expect_good(&r);
    expect_point(&r, 1, &axis);
    expect_point(&r, 2, &corner);
    expect_point(&r, 3, &far_corner);
    expect_point(&r, 4, &inside);
    expect_words(&r, 4, "in column 75, row 37\n", true);
    expect_words(&r, 5, "outside the view volume: top, near\n", true);
    expect_words(&r, 6, "behind the eye", false);
    expect_words(&r, 7, "in the plane of the eye", false);
}

TEST(vulkan)
{
    static const expected corner = {{1, 1, 9}, {1, 1, -1}, {1, -1, 0, 1}, {1, -1, 0}, {100, 0, 0}};
    static const expected inside = {{1, 0.5f, 8},
                                    {1, 0.5f, -2},
                                    {1, -0.5f, 1.5f, 2},
                                    {0.5f, -0.25f, 0.75f},
                                    {75, 37.5f, 0.75f}};
    run r = transform("convention vulkan\nposition 0 0 10\n" CAMERA
                      "point 1 1 9\npoint 1 0.5 8\npoint 0 5 8\npoint 0 -5 8\npoint 0 0 11\n",
                      "");
    expect_good(&r);
    expect_point(&r, 1, &corner);
    expect_point(&r, 2, &inside);
    expect_words(&r, 3, "outside the view volume: top\n", true);
    expect_words(&r, 4, "outside the view volume: bottom\n", true);
    expect_words(&r, 5, "behind the eye", false);
}

/* (1, 0, 0) becomes (2, 0, 0) when scaled by (2, 3, 4), (0, 2, 0) when turned by 90 degrees about
 * z, (0, 0, 2) when turned about x, (5, 6, 9) when moved by (5, 6, 7). (0, 1, 1) becomes (0, 3, 4),
 * (-3, 0, 4), (-3, -4, 0), (2, 2, 7). The camera is at (5, 6, 19). Orthographic: 10 wide, 20 high,
 * 4 to 14: NDC x = view x / 5, y = view y / 10, z = (-2 z - 18) / 10. */
TEST(models_and_boxes)
{
    static const expected first = {
        {5, 6, 9}, {0, 0, -10}, {0, 0, 0.2f, 1}, {0, 0, 0.2f}, {100, 50, 0.6f}};
    static const expected second = {
        {2, 2, 7}, {-3, -4, -12}, {-0.6f, -0.4f, 0.6f, 1}, {-0.6f, -0.4f, 0.6f}, {40, 30, 0.8f}};
    run r = transform("convention opengl\nscreen 200 100\nscale 2 3 4\nrotate 0 0 1 90\n"
                      "rotate 2 0 0 90\ntranslate 5 6 7\nposition 5 6 19\n"
                      "orthographic -5 5 -10 10\nnear 4\nfar 14\npoint 1 0 0\npoint 0 1 1\n"
                      "point 0 0 100\n",
                      "");
    expect_good(&r);
    expect_point(&r, 1, &first);
    expect_point(&r, 2, &second);
    /* (0, 0, 400), (0, 0, 400), (0, -400, 0): far below. No w is below 1. */
    expect_words(&r, 3, "outside the view volume: bottom\n", true);

    /* A quarter turn about -y takes x to z; 30 degrees about z, x to (cos 30, sin 30). */
    static const expected third = {
        {0, 2, 1}, {0, 2, -10}, {0, 0.2f, 0.2f, 1}, {0, 0.2f, 0.2f}, {100, 60, 0.6f}};
    static const expected fourth = {{0.8660254f, 0.5f, 1},
                                    {0.8660254f, 0.5f, -10},
                                    {0.17320508f, 0.05f, 0.2f, 1},
                                    {0.17320508f, 0.05f, 0.2f},
                                    {117.320508f, 52.5f, 0.6f}};
    r = transform("convention opengl\nscreen 200 100\nrotate 0 -1 0 450\nposition 0 0 11\n"
                  "orthographic -5 5 -10 10\nnear 4\nfar 14\npoint 1 2 0\n",
                  "");
    expect_good(&r);
    expect_point(&r, 1, &third);
    r = transform("convention opengl\nscreen 200 100\nrotate 0 0 2 30\nposition 0 0 11\n"
                  "orthographic -5 5 -10 10\nnear 4\nfar 14\npoint 1 0 1\n",
                  "");
    expect_good(&r);
    expect_point(&r, 1, &fourth);
}

/* One camera, set by target, by axes of other lengths, and in a left-handed world: at (4, 0, 0),
 * looking along -x. The point (2, 1, -1) is 2 ahead and 1 up. The right is -z in a right-handed
 * world, +z in a left-handed one. */
TEST(cameras)
{
    static const char *const setups[] = {
        "convention opengl\nposition 4 0 0\ntarget -9 0 0\n",
        "convention opengl\nposition 4 0 0\nright 0 0 -0.5\nup 0 3 0\nforward -7 0 0\n",
        "convention direct3d\nposition 4 0 0\ntarget -9 0 0\n",
        "convention direct3d\nposition 4 0 0\nforward -1 0 0\nright 0 0 1\nup 0 1 0\n",
    };
    static const expected points[2] = {
        {{2, 1, -1}, {1, 1, -2}, {1, 1, 1, 2}, {0.5f, 0.5f, 0.5f}, {75, 75, 0.75f}},
        {{2, 1, -1}, {-1, 1, 2}, {-1, 1, 1.5f, 2}, {-0.5f, 0.5f, 0.75f}, {25, 25, 0.75f}},
    };
    for (int i = 0; i < 4; ++i) {
        char text[512];
        snprintf(text, sizeof text, "%s" CAMERA "point 2 1 -1\n", setups[i]);
        run r = transform(text, "");
        expect_good(&r);
        expect_point(&r, 1, &points[i / 2]);
    }
}

/* Infinite: OpenGL's clip z = -z - 2 near, at d = 2 then 2 - 2 = 0; Direct3D reversed and
 * infinite: clip z = near = 1, NDC 1 / 2. Reversed with far 3: z' = w - (1.5 z - 1.5) =
 * -0.5 z + 1.5, at z = 2 then 0.5, NDC 0.25; at z = 4 beyond far, though z < 0. */
TEST(infinite_and_reversed)
{
    static const expected infinite = {
        {0, 1, -2}, {0, 1, -2}, {0, 1, 0, 2}, {0, 0.5f, 0}, {50, 75, 0.5f}};
    static const expected both = {
        {0, 1, 2}, {0, 1, 2}, {0, 1, 1, 2}, {0, 0.5f, 0.5f}, {50, 25, 0.5f}};
    static const expected reversed = {
        {0, 1, 2}, {0, 1, 2}, {0, 1, 0.5f, 2}, {0, 0.5f, 0.25f}, {50, 25, 0.25f}};
    run r = transform("convention opengl\nscreen 100 100\nfrustum -1 1 -1 1\nnear 1\n"
                      "far infinite\npoint 0 1 -2\npoint 0 0 -1e30\n",
                      "");
    expect_good(&r);
    expect_point(&r, 1, &infinite);
    assert_null(strstr(r.out, "outside"));
    r = transform("convention direct3d\nscreen 100 100\nperspective 90\nnear 1\nfar infinite\n"
                  "depth reversed\npoint 0 1 2\npoint 0 0 0.5\n",
                  "");
    expect_good(&r);
    expect_point(&r, 1, &both);
    expect_words(&r, 2, "outside the view volume: near\n", true);
    r = transform("convention direct3d\ndepth reversed\n" CAMERA
                  "point 0 1 2\npoint 0 0 4\npoint 0 0 0.5\n",
                  "");
    expect_good(&r);
    expect_point(&r, 1, &reversed);
    expect_words(&r, 2, "outside the view volume: far\n", true);
    expect_words(&r, 3, "outside the view volume: near\n", true);
}

/* Sixteen numbers, line by line, after the line of the name. */
static void expect_matrix(const char *out, const char *name, const float values[16])
{
    char heading[64];
    snprintf(heading, sizeof heading, "\n%s\n", name);
    const char *at = strstr(out, heading);
    if (at == NULL)
        fail_msg("no %s in\n%s", name, out);
    at += strlen(heading);
    for (int row = 0; row < 4; ++row) {
        char *number = (char *)(uintptr_t)at;
        for (int column = 0; column < 4; ++column) {
            double got = strtod(number, &number);
            if (!(fabs(got - (double)values[4 * row + column]) <= 4e-7))
                fail_msg("%s: row %d, column %d is %.9g, not %.9g", name, row + 1, column + 1, got,
                         (double)values[4 * row + column]);
        }
        assert_int_equal(*number, '\n');
        at = number + 1;
    }
}

/* The cameras above. With OpenGL's numbers the inverse is: z = -w', 1 = (2 w' - z') / 3. */
TEST(matrices)
{
    static const float view[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -10, 0, 0, 0, 1};
    static const float back[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 10, 0, 0, 0, 1};
    static const float projection[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, -3, 0, 0, -1, 0};
    static const float inverse[16] = {1, 0, 0, 0,  0, 1, 0,         0,
                                      0, 0, 0, -1, 0, 0, -1.0f / 3, 2.0f / 3};
    static const float d3d_view[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 10, 1};
    static const float d3d_back[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -10, 1};
    static const float d3d_projection[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1.5f, 1, 0, 0, -1.5f, 0};
    static const float d3d_inverse[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, -2.0f / 3, 0, 0, 1, 1};
    static const float vulkan_projection[16] = {1, 0, 0,     0,     0, -1, 0,  0,
                                                0, 0, -1.5f, -1.5f, 0, 0,  -1, 0};
    run r = transform("convention opengl\nposition 0 0 10\n" CAMERA, "--matrices");
    expect_good(&r);
    assert_non_null(strstr(r.out, "column vectors"));
    expect_matrix(r.out, "view", view);
    expect_matrix(r.out, "inverse of view", back);
    expect_matrix(r.out, "projection", projection);
    expect_matrix(r.out, "inverse of projection", inverse);
    r = transform("convention direct3d\nposition 0 0 -10\n" CAMERA "point 0 0 0\n", "--matrices");
    expect_good(&r);
    assert_non_null(strstr(r.out, "row vectors"));
    expect_matrix(r.out, "view", d3d_view);
    expect_matrix(r.out, "inverse of view", d3d_back);
    expect_matrix(r.out, "projection", d3d_projection);
    expect_matrix(r.out, "inverse of projection", d3d_inverse);
    assert_non_null(strstr(r.out, "\npoint 1\n"));
    r = transform("convention vulkan\n" CAMERA, "--matrices");
    expect_good(&r);
    expect_matrix(r.out, "projection", vulkan_projection);
}

/* OpenGL's camera above and a model scaled by 2 and moved by (1, 2, 3): view z is 2 z - 7, so
 * clip = (2 x + 1, 2 y + 2, 11 - 4 z, 7 - 2 z). Inverted: 1 = (2 w' - z') / 3, z = (7 - w') / 2. */
TEST(all_matrices)
{
    static const float model[16] = {2, 0, 0, 1, 0, 2, 0, 2, 0, 0, 2, 3, 0, 0, 0, 1};
    static const float unmodel[16] = {.5f, 0, 0, -.5f, 0, .5f, 0, -1, 0, 0, .5f, -1.5f, 0, 0, 0, 1};
    static const float viewport[16] = {50, 0, 0, 50, 0, 50, 0, 50, 0, 0, .5f, .5f, 0, 0, 0, 1};
    static const float unviewport[16] = {.02f, 0, 0, -1, 0, .02f, 0, -1, 0, 0, 2, -1, 0, 0, 0, 1};
    static const float combined[16] = {2, 0, 0, 1, 0, 2, 0, 2, 0, 0, -4, 11, 0, 0, -2, 7};
    static const float uncombined[16] = {.5f, 0, 1 / 6.f,  -1 / 3.f, 0, .5f, 1 / 3.f,  -2 / 3.f,
                                         0,   0, -7 / 6.f, 11 / 6.f, 0, 0,   -1 / 3.f, 2 / 3.f};
    static const float d3d_model[16] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 1, 2, 3, 1};
    static const float d3d_viewport[16] = {50, 0, 0, 0, 0, -50, 0, 0, 0, 0, 1, 0, 50, 50, 0, 1};
    static const float d3d_unviewport[16] = {.02f, 0, 0, 0, 0,  -.02f, 0, 0,
                                             0,    0, 1, 0, -1, 1,     0, 1};
    /* View z is 2 z + 13: clip = (2 x + 1, 2 y + 2, 3 z + 18, 2 z + 13). */
    static const float d3d_combined[16] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3, 2, 1, 2, 18, 13};
    run r = transform("convention opengl\nposition 0 0 10\nscale 2\ntranslate 1 2 3\n" CAMERA,
                      "--matrices");
    expect_good(&r);
    expect_matrix(r.out, "model", model);
    expect_matrix(r.out, "inverse of model", unmodel);
    expect_matrix(r.out, "viewport", viewport);
    expect_matrix(r.out, "inverse of viewport", unviewport);
    expect_matrix(r.out, "combined, from local to clip", combined);
    expect_matrix(r.out, "inverse of combined, from clip to local", uncombined);
    r = transform("convention direct3d\nposition 0 0 -10\nscale 2\ntranslate 1 2 3\n" CAMERA,
                  "--matrices");
    expect_good(&r);
    expect_matrix(r.out, "model", d3d_model);
    expect_matrix(r.out, "viewport", d3d_viewport);
    expect_matrix(r.out, "inverse of viewport", d3d_unviewport);
    expect_matrix(r.out, "combined, from local to clip", d3d_combined);
    r = transform("convention opengl\nscreen 9 9\nscale 1e30\nperspective 1e-7\nnear 1\nfar 2\n",
                  "--matrices");
    expect_good(&r);
    assert_non_null(strstr(r.out, "\ncombined: a number of it or of its inverse is too large"));
    assert_null(strstr(r.out, "inf"));
}

/* With nine digits 0.1 as a float and its neighbour differ, and columns have a space between
 * them. */
TEST(numbers_give_the_float_back)
{
    run r = transform("convention opengl\n" CAMERA "point 0.1 0.10000001 -1.17549435e-38\n", "");
    expect_good(&r);
    assert_non_null(strstr(r.out, "local      0.100000001      0.100000009  -1.17549435e-38\n"));
    /* This point is so near to the plane of the eye that 0.1 / 2^-126 * 50 exceeds the largest
     * float. */
    expect_words(&r, 1, "too large for 32-bit numbers\n", false);
    assert_null(strstr(r.out, "nan"));
    assert_null(strstr(r.out, "inf"));
}

/* Orthographic planes may be behind the camera, and a picture may be mirrored: left, right, bottom
 * and top are then those of the picture. With depth reversed the near plane has depth 1. */
TEST(mirrored_boxes)
{
    run r = transform("convention opengl\nscreen 100 100\northographic 2 -2 1 -1\nnear -1\nfar 3\n"
                      "point 1 0 0\npoint 3 0 0\npoint 0 2 0\npoint 0 0 2\npoint 0 0 -4\n",
                      "");
    static const expected inside = {
        {1, 0, 0}, {1, 0, 0}, {-0.5f, 0, -0.5f, 1}, {-0.5f, 0, -0.5f}, {25, 50, 0.25f}};
    expect_good(&r);
    expect_point(&r, 1, &inside);
    expect_words(&r, 2, "outside the view volume: left\n", true);
    expect_words(&r, 3, "outside the view volume: bottom\n", true);
    expect_words(&r, 4, "outside the view volume: near\n", true);
    expect_words(&r, 5, "outside the view volume: far\n", true);
    r = transform("convention opengl\nscreen 100 100\northographic -2 2 -1 1\nnear -1\nfar 3\n"
                  "depth reversed\npoint 1 0 0\npoint 0 0 2\npoint 0 0 -4\n",
                  "");
    static const expected reversed = {
        {1, 0, 0}, {1, 0, 0}, {0.5f, 0, 0.5f, 1}, {0.5f, 0, 0.5f}, {75, 50, 0.75f}};
    expect_good(&r);
    expect_point(&r, 1, &reversed);
    expect_words(&r, 2, "outside the view volume: near\n", true);
    expect_words(&r, 3, "outside the view volume: far\n", true);
}
