/* Where models are drawn and how: transformations, clipping planes, culling, points, several
 * models. Every picture here is compared with the reference's too. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <stdio.h>
#include <string.h>

/* A triangle in front of the square's lower left half, and one whose corners turn clockwise. */
static const char near_obj[] = "v -1 -1 0.5\nv 1 -1 0.5\nv -1 1 0.5\nf 1 2 3\n";
static const char back_obj[] = "v -1 -1 0\nv 1 -1 0\nv -1 1 0\nf 1 3 2\n";

#define WHITE "--shader unlit --background 000000ff --size 16x16 " FRONT
static const uint32_t background = 0x000000ff;

/* Draws, and compares with the reference. */
static picture drawn(const char *arguments)
{
    run r = gnomon("render %s " WHITE " -o p.png", arguments);
    if (r.status != 0)
        fail_msg("render %s: %s", arguments, r.error);
    r = gnomon("compare %s " WHITE " -o c.png", arguments);
    if (r.status != 0)
        fail_msg("compare %s: %s%s", arguments, r.out, r.error);
    return picture_read("p.png");
}

/* The pixels that are drawn are those for which `is_inside` holds, of 16x16, y up. */
typedef bool region(int x, int y);

static void expect_region(const char *arguments, region *is_inside)
{
    picture p = drawn(arguments);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            if ((pixel(&p, (uint32_t)x, (uint32_t)(15 - y)) != background) != is_inside(x, y))
                fail_msg("%s: pixel %d, %d", arguments, x, y);
    picture_free(&p);
}

static bool everywhere(int x, int y)
{
    (void)x;
    (void)y;
    return true;
}

static bool nowhere(int x, int y)
{
    (void)x;
    (void)y;
    return false;
}

static bool right_half(int x, int y)
{
    (void)y;
    return x >= 8;
}

static bool left_half(int x, int y)
{
    return !right_half(x, y);
}

static bool middle(int x, int y)
{
    return x >= 4 && x < 12 && y >= 4 && y < 12;
}

static bool upper_right(int x, int y)
{
    return x >= 8 && y >= 8;
}

static bool both_halves_of_row(int x, int y)
{
    (void)x;
    return y >= 4 && y < 12;
}

TEST(models_are_transformed_in_order)
{
    write_text("square.obj", square_obj);
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
    write_text("square.obj", square_obj);
    expect_region("square.obj --translate 5,0,0 square.obj --translate 1,0,0", right_half);
    expect_region("square.obj square.obj --translate 5,0,0", everywhere);
    expect_region("--scale 0.5 square.obj square.obj", middle);
    /* What stands before the first model comes first. */
    expect_region("--scale 0.5 square.obj --translate -.5,0,0 square.obj --translate .5,0,0",
                  both_halves_of_row);
    run r = gnomon("render square.obj -o p.png square.obj --size 8x8");
    assert_non_null(strstr(r.out, "8x8, 4 triangles"));
    expect(1, "render square.obj nothing.obj -o a.png", "nothing.obj", "No such file");
    expect(1, "render nothing.obj square.obj -o ./square.obj", "square.obj", "overwritten");
}

/* The camera frames the models where they are placed. */
TEST(cameras_frame_what_is_placed)
{
    write_text("square.obj", square_obj);
    run r = shell("set -e; draw() { \"$GNOMON\" render square.obj --size 64x64 \"$@\"; }; "
                  "draw -o a.png; draw -o b.png --translate 512,256,-1024; cmp a.png b.png; "
                  "draw -o b.png --scale 4; cmp a.png b.png; draw -o b.png --rotate z,90; "
                  "draw -o c.png --rotate z,-270; cmp b.png c.png");
    if (r.status != 0)
        fail_msg("%s%s", r.out, r.error);
}

/* A square at distance 5. */
TEST(planes_clip)
{
    write_text("square.obj", square_obj);
    expect_region("square.obj --near 4.5 --far 5.5", everywhere);
    expect_region("square.obj --near 4.5", everywhere);
    expect_region("square.obj --far 5.5", everywhere);
    expect_region("square.obj --near 5.5", nowhere);
    expect_region("square.obj --far 4.5", nowhere);
    expect_region("square.obj --near -1 --far 5.5", everywhere);
    /* Turned by 45 degrees, its left side is nearer than 5. */
    expect_region("square.obj --rotate y,45 --scale 2,1,1 --near 5", right_half);
    run r = gnomon("render square.obj -o p.png --eye 0,0,5 --far 4 --size 8x8");
    assert_int_equal(r.status, 0);
    assert_non_null(strstr(r.error, "nothing was drawn: all 2 triangles lie outside"));
    r = gnomon("compare square.obj -o p.png --eye 0,0,5 --near 7 --size 8x8");
    assert_int_equal(r.status, 0);
}

/* The depth picture spans the planes: 5 of 4..6 is the middle. */
TEST(depths_span_the_planes)
{
    write_text("square.obj", square_obj);
    run r = gnomon("render square.obj -o p.png --depth d.png --near 4 --far 6 " WHITE);
    assert_int_equal(r.status, 0);
    picture p = picture_read_grey16("d.png");
    assert_in_range(p.grey[100], 32766, 32769);
    picture_free(&p);
}

TEST(sides_are_culled)
{
    write_text("square.obj", square_obj);
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
    write_text("square.obj", square_obj);
    write_text("near.obj", near_obj);
    write_text("back.obj", back_obj);
    run r = shell(
        "set -e; draw() { \"$GNOMON\" render \"$@\" --size 16x16 --shader normals " FRONT "; }; "
        "draw square.obj -o square.png; draw square.obj near.obj --rotate x,180 --translate "
        "0,0,1 -o two.png; draw near.obj --rotate x,180 --translate 0,0,1 square.obj "
        "--no-depth-test -o covered.png; cmp covered.png square.png; ! cmp -s two.png "
        "square.png");
    if (r.status != 0)
        fail_msg("%s%s", r.out, r.error);
    picture p = drawn("near.obj square.obj --no-depth-test");
    picture_free(&p);
    r = gnomon("render square.obj -o p.png --no-depth-test --size 8x8");
    assert_string_equal(r.error, "");
    r = gnomon(
        "render square.obj -o p.png --no-depth-test --size 8x8 --translate 0,0,9 --near 1 " FRONT);
    assert_int_equal(r.status, 0);
    assert_non_null(strstr(r.error, "nothing was drawn"));
}

static bool corners(int x, int y)
{
    return (x == 3 || x == 4 || x == 11 || x == 12) && (y == 3 || y == 4 || y == 11 || y == 12);
}

TEST(vertices_are_points)
{
    write_text("square.obj", square_obj);
    expect_region("square.obj --scale 0.5 --points=2", corners);
    picture p = drawn("square.obj --scale 0.5 --points");
    int count = 0;
    for (uint32_t i = 0; i < 256; ++i)
        count += pixel(&p, i % 16, i / 16) != background;
    assert_int_equal(count, 4);
    picture_free(&p);
    p = drawn("square.obj --scale 0.5 --points=5 --samples 4");
    picture_free(&p);
    expect_region("square.obj --scale 0.5 --points=2 --cull front", nowhere);
}

/* Every lit shader, with shadows and mirrored, as the reference draws it. */
TEST(lit_models_equal_the_reference)
{
    static const char shaders[][12] = {"flat",  "gouraud",     "toon",
                                       "phong", "blinn-phong", "normals"};
    write_text("square.obj", square_obj);
    write_text("near.obj", near_obj);
    for (int i = 0; i < 6; ++i) {
        run r = gnomon("compare near.obj --translate .5,0,.3 square.obj --rotate 1,1,0,30 --scale "
                       "1,-2,.5 --shader %s %s --size 96x80 --samples %d -o c.png",
                       shaders[i], i < 5 && i != 1 ? "--shadows" : "", i % 2 == 0 ? 1 : 4);
        if (r.status != 0)
            fail_msg("%s: %s%s", shaders[i], r.out, r.error);
    }
}

/* A half turn and its light give the same picture as neither, since normals turn too. */
TEST(normals_turn_with_models)
{
    write_text("square.obj", square_obj);
    run r =
        shell("set -e; draw() { \"$GNOMON\" render square.obj --size 32x32 --shader phong \"$@\"; "
              "}; draw -o a.png --light 1,2,3 --eye 1,2,5; draw -o b.png --rotate y,180 --light "
              "-1,2,-3 --eye -1,2,-5; cmp a.png b.png; draw -o c.png --rotate y,180 --light "
              "1,2,3 --eye -1,2,-5; ! cmp -s a.png c.png");
    if (r.status != 0)
        fail_msg("%s%s", r.out, r.error);
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
    write_text("square.obj", square_obj);
    write_bytes("map.ppm", map, sizeof map - 1);
    for (int i = 0; i < 4; ++i) {
        const double *f = factors[i];
        char line[1024];
        write_scaled("scaled.obj", f[0], f[1], f[2]);
        snprintf(line, sizeof line,
                 "set -e; draw() { \"$GNOMON\" render --size 48x48 --shader phong --exponent 4 "
                 "--light 1,2,3 --shadows --normal-map tangent:map.ppm --eye 1,2,9 --target 0,0,0 "
                 "\"$@\"; }; draw scaled.obj -o a.png; draw square.obj --scale %g,%g,%g -o b.png; "
                 "\"$GNOMON\" diff a.png b.png",
                 f[0], f[1], f[2]);
        run r = shell(line);
        if (r.status != 0)
            fail_msg("scaled by %g, %g, %g: %s%s", f[0], f[1], f[2], r.out, r.error);
    }
}

TEST(version_is_printed)
{
    run r = gnomon("--version");
    unsigned int part[3];
    char back_end[32];
    assert_int_equal(r.status, 0);
    assert_int_equal(
        sscanf(r.out, "gnomon %u.%u.%u, back end %31s", part, part + 1, part + 2, back_end), 4);
    write_text("square.obj", square_obj);
    r = gnomon("render square.obj -o p.png --size 8x8 --backend %s", back_end);
    assert_int_equal(r.status, 0);
}
