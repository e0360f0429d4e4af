/* Where models are drawn and how: transformations, clipping planes, culling, points, several
 * models. Every picture here is compared with the reference's too. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <stdio.h>
#include <string.h>

/* A triangle in front of the square's lower left half. */
static const char near_obj[] = "v -1 -1 0.5\nv 1 -1 0.5\nv -1 1 0.5\nf 1 2 3\n";

#define WHITE "--shader unlit --background 000000ff --size 16x16 " FRONT
static const uint32_t background = 0x000000ff;

/* Draws, and compares with the reference. */
static picture drawn_by_both(const char *arguments)
{
    good("compare %s " WHITE " -o c.png", arguments);
    good("render --samples 1 %s " WHITE " -o p.png", arguments);
    return picture_read("p.png");
}

/* Expects that exactly the pixels of a rectangle of 16x16 are drawn. */
static void expect_region(const char *arguments, rectangle region)
{
    picture p = drawn_by_both(arguments);
    expect_inside(&p, region, 0, background);
    picture_free(&p);
}

static const rectangle everywhere = {0, 0, 16, 16}, nowhere = {0, 0, 0, 0},
                       right_half = {8, 0, 16, 16}, left_half = {0, 0, 8, 16},
                       middle = {4, 4, 12, 12}, upper_right = {8, 0, 16, 8},
                       both_halves_of_row = {0, 4, 16, 12};

TEST(models_are_transformed_in_order)
{
    expect_region("square.obj", everywhere);
    expect_region("square.obj --translate 1,0,0", right_half);
    expect_region("square.obj --scale 0.5", middle);
    expect_region("square.obj --scale .5 --translate 0.5,0.5,0", upper_right);
    /* The other order moves by half as much. */
    expect_region("square.obj --translate 1,1,0 --scale .5", upper_right);
    expect_region("square.obj --translate 1,0,0 --rotate z,180", left_half);
    expect_region("square.obj --rotate z,180 --translate 1,0,0", right_half);
    expect_region("square.obj --translate 1,0,0 --scale -1,1,1", left_half);
    expect_region("square.obj --rotate y,90", nowhere);
    expect_region("square.obj --rotate 0,2,0,90 --rotate 0,-1,0,90", everywhere);
}

TEST(transformations_belong_to_models)
{
    expect_region("square.obj --translate 5,0,0 square.obj --translate 1,0,0", right_half);
    expect_region("square.obj square.obj --translate 5,0,0", everywhere);
    expect_region("--scale 0.5 square.obj square.obj", middle);
    /* What stands before the first model comes first. */
    expect_region("--scale 0.5 square.obj --translate -.5,0,0 square.obj --translate .5,0,0",
                  both_halves_of_row);
    run r = gnomon("render square.obj -o p.png square.obj --size 8x8");
    expect_printed(&r, "8x8, 4 triangles");
    expect(1, "render square.obj nothing.obj -o a.png", "nothing.obj ... No such file");
    expect(1, "render nothing.obj square.obj -o ./square.obj", "square.obj ... overwritten");
}

/* The camera frames the models where they are placed. */
/* Without highlights, which depend on the rounding of places far from the origin. */
TEST(cameras_frame_what_is_placed)
{
    good_shell("set -e; draw() { gnomon render square.obj --size 64x64 --samples 1 --shader "
               "gouraud \"$@\"; }; "
               "draw -o a.png; draw -o b.png --translate 512,256,-1024; cmp a.png b.png; "
               "draw -o b.png --scale 4; cmp a.png b.png; draw -o b.png --rotate z,90; "
               "draw -o c.png --rotate z,-270; cmp b.png c.png");
}

/* A side is an eye in its direction. An eye replaces it. */
TEST(sides_are_eyes)
{
    static const char *const sides[][2] = {{"front", "0,0,5"}, {"back", "0,0,-5"},
                                           {"left", "-5,0,0"}, {"right", "5,0,0"},
                                           {"top", "0,5,0"},   {"bottom", "0,-5,0"},
                                           {"iso", "5,5,5"},   {"left --eye 0,0,5", "0,0,5"}};
    write_text("solid.obj", "v -1 -1 0\nv 1 -1 -.5\nv 0 1 0\nv 0 -.5 1\n"
                            "f 1 2 3\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    for (size_t i = 0; i < COUNT(sides); ++i)
        good_shell("set -e; draw() { gnomon render solid.obj -o $1.png --shader normals --size "
                   "64x64 --orthographic 4 --target 0,0,0 --near -9 --far 19 $2 $3 $4 $5; }; "
                   "draw side --from %s; draw eye --eye %s; gnomon diff side.png eye.png; "
                   "draw none --eye 0,1,99; ! gnomon diff side.png none.png >none.txt",
                   sides[i][0], sides[i][1]);
    expect(2, "render square.obj -o a.png --from above",
           "--from 'above': not front, back, left, right, top, bottom or iso");
}

/* A square at distance 5. */
TEST(planes_clip)
{
    expect_region("square.obj --near 4.5 --far 5.5", everywhere);
    expect_region("square.obj --near 4.5", everywhere);
    expect_region("square.obj --far 5.5", everywhere);
    expect_region("square.obj --near 5.5", nowhere);
    expect_region("square.obj --far 4.5", nowhere);
    expect_region("square.obj --near -1 --far 5.5", everywhere);
    /* Turned by 45 degrees, its left side is nearer than 5. */
    expect_region("square.obj --rotate y,45 --scale 2,1,1 --near 5", right_half);
    run r = good("render square.obj -o p.png --eye 0,0,5 --far 4 --size 8x8");
    assert_non_null(strstr(r.error, "nothing was drawn: all 2 triangles lie outside"));
    good("compare square.obj -o p.png --eye 0,0,5 --near 7 --size 8x8");
}

/* The depth picture spans the planes: 5 of 4..6 is the middle. */
TEST(depths_span_the_planes)
{
    good("render square.obj -o p.png --depth d.png --near 4 --far 6 " WHITE);
    picture p = picture_read_grey16("d.png");
    assert_in_range(p.grey[100], 32766, 32769);
    picture_free(&p);
}

TEST(sides_are_culled)
{
    expect_region("square.obj --cull none", everywhere);
    expect_region("square.obj --cull back", everywhere);
    expect_region("square.obj --cull front", nowhere);
    expect_region("square.obj --rotate y,180 --cull back", nowhere);
    expect_region("square.obj --rotate y,180 --cull front", everywhere);
    /* A mirrored front is a front. */
    expect_region("square.obj --scale -1,1,1 --cull back", everywhere);
    expect_region("square.obj --scale -1e-13,1e-13,1e-13 --scale 1e13 --cull front", nowhere);
    expect_region("square.obj --scale 1,1,-1 --cull back", nowhere);
}

/* Without the depth test, the square covers the triangle in front of it. */
TEST(order_decides_without_depth_test)
{
    write_text("near.obj", near_obj);
    good_shell("set -e; draw() { gnomon render \"$@\" --size 16x16 --shader normals " FRONT "; }; "
               "draw square.obj -o square.png; draw square.obj near.obj --rotate x,180 --translate "
               "0,0,1 -o two.png; draw near.obj --rotate x,180 --translate 0,0,1 square.obj "
               "--no-depth-test -o covered.png; cmp covered.png square.png; ! cmp -s two.png "
               "square.png");
    picture p = drawn_by_both("near.obj square.obj --no-depth-test");
    picture_free(&p);
    run r = gnomon("render square.obj -o p.png --no-depth-test --size 8x8");
    assert_string_equal(r.error, "");
    r = good(
        "render square.obj -o p.png --no-depth-test --size 8x8 --translate 0,0,9 --near 1 " FRONT);
    assert_non_null(strstr(r.error, "nothing was drawn"));
}

TEST(vertices_are_points)
{
    for (uint32_t size = 1; size <= 2; ++size) {
        picture p = drawn_by_both(size == 1 ? "square.obj --scale 0.5 --points"
                                            : "square.obj --scale 0.5 --points=2");
        uint32_t count = 0;
        for (uint32_t i = 0; i < 256; ++i) {
            const uint32_t x = i % 16, y = i / 16;
            const bool is_corner = (x == 3 || x == 4 || x == 11 || x == 12) &&
                                   (y == 3 || y == 4 || y == 11 || y == 12);
            const bool is_drawn = pixel(&p, x, y) != background;
            assert_true(is_corner || !is_drawn);
            count += is_drawn;
        }
        assert_int_equal(count, 4 * size * size);
        picture_free(&p);
    }
    picture p = drawn_by_both("square.obj --scale 0.5 --points=5 --samples 4");
    picture_free(&p);
    expect_region("square.obj --scale 0.5 --points=2 --cull front", nowhere);
}

/* Every lit shader, with shadows and mirrored, as the reference draws it. */
TEST(lit_models_equal_the_reference)
{
    static const char shaders[][12] = {"flat",  "gouraud",     "toon",
                                       "phong", "blinn-phong", "normals"};
    write_text("near.obj", near_obj);
    for (int i = 0; i < 6; ++i) {
        good("compare near.obj --translate .5,0,.3 square.obj --rotate 1,1,0,30 --scale "
             "1,-2,.5 --shader %s %s --size 96x80 --samples %d -o c.png",
             shaders[i], i < 5 && i != 1 ? "--shadows" : "", i % 2 == 0 ? 1 : 4);
    }
}

/* A half turn and its light give the same picture as neither, since normals turn too. */
TEST(normals_turn_with_models)
{
    good_shell("set -e; draw() { gnomon render square.obj --size 32x32 --shader phong \"$@\"; "
               "}; draw -o a.png --light 1,2,3 --eye 1,2,5; draw -o b.png --rotate y,180 --light "
               "-1,2,-3 --eye -1,2,-5; cmp a.png b.png; draw -o c.png --rotate y,180 --light "
               "1,2,3 --eye -1,2,-5; ! cmp -s a.png c.png");
}

/* The square with each coordinate multiplied by these factors in the file. */
static void write_scaled(const char *name, double x, double y, double z)
{
    FILE *file = fopen(path_of(name), "w");
    assert_non_null(file);
    for (int i = 0; i < 4; ++i)
        fprintf(file, "v %g %g %g\n", x * (i == 1 || i == 2 ? 1 : -1), y * (i < 2 ? -1 : 1), z * 0);
    fputs(strstr(square_obj, "vt"), file);
    assert_int_equal(fclose(file), 0);
}

/* A model that is scaled in its file, by powers of two, and one that the option scales are one
 * picture, with highlights, shadows and normals in tangent space; mirrored too. */
TEST(options_do_what_files_can)
{
    static const uint8_t map[] = "P6 2 1 255\n\344\350\300\100\340\260";
    static const double factors[][3] = {{2, 2, 2}, {-1, 1, 1}, {1, -2, 1}, {0.5, 4, 1}};
    write_bytes("map.ppm", map, sizeof map - 1);
    for (int i = 0; i < 4; ++i) {
        const double *f = factors[i];
        write_scaled("scaled.obj", f[0], f[1], f[2]);
        good_shell(
            "set -e; draw() { gnomon render --size 48x48 --shader phong --exponent 4 "
            "--light 1,2,3 --shadows --normal-map tangent:map.ppm --eye 1,2,9 --target 0,0,0 "
            "\"$@\"; }; draw scaled.obj -o a.png; draw square.obj --scale %g,%g,%g -o b.png; "
            "gnomon diff a.png b.png",
            f[0], f[1], f[2]);
    }
}

TEST(version_is_printed)
{
    run r = good("--version");
    unsigned int part[3];
    char back_end[32];
    assert_int_equal(
        sscanf(r.out, "gnomon %u.%u.%u, back end %31s", part, part + 1, part + 2, back_end), 4);
    good("render square.obj -o p.png --size 8x8 --backend %s", back_end);
}
