/* Backgrounds of two colours, edges over surfaces, and the grid on the ground. */
#include "runner.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define UPPER 0xff0080ffu
#define LOWER 0x00ff8040u
#define TWO_COLORS "--background '#ff0080,#00ff8040' "

/* The camera looks away from the model. */
#define AWAY "square.obj --eye 0,0,5 --target 0,0,9 "

/* Fails unless each row has one colour, at most half a step from the line between the colours, the
 * top row has the upper one and the bottom row the lower one. */
static void expect_gradient(const picture *p, uint32_t upper, uint32_t lower)
{
    const int64_t steps = p->height > 1 ? p->height - 1 : 1;
    for (uint32_t y = 0; y < p->height; ++y) {
        const uint32_t got = pixel(p, 0, y);
        for (uint32_t x = 1; x < p->width; ++x)
            assert_int_equal(pixel(p, x, y), got);
        for (int shift = 0; shift < 32; shift += 8) {
            const int64_t a = upper >> shift & 255, b = lower >> shift & 255;
            const int64_t exact = a * (steps - y) + b * y; /* times steps */
            assert_true(2 * llabs((int64_t)(got >> shift & 255) * steps - exact) <= steps);
        }
    }
    assert_int_equal(pixel(p, 0, 0), upper);
    if (p->height > 1)
        assert_int_equal(pixel(p, p->width - 1, p->height - 1), lower);
}

TEST(gradients_go_from_the_top_row_to_the_bottom_row)
{
    static const char looks[][64] = {"--size 9x5",
                                     "--size 3x1",
                                     "--size 3x2 --samples 1",
                                     "--size 2x1500 --samples 1",
                                     "--size 5x301 --shader metallic-roughness",
                                     "--size 5x301 --shader metallic-roughness --samples 1",
                                     "--size 20x90 --fov 90 --up 0,-1,0 --backend portable",
                                     "--size 20000x5 --samples 1"};
    for (size_t i = 0; i < COUNT(looks); ++i) {
        good("render " AWAY "-o g.png " TWO_COLORS "%s", looks[i]);
        picture p = picture_read("g.png");
        expect_gradient(&p, UPPER, LOWER);
        picture_free(&p);
    }
    /* Other outputs have the same pixels; PPM has no alpha. */
    good_shell("set -e; for f in png tga raw; do gnomon render " AWAY
               "-o g.$f --size 7x40 " TWO_COLORS "; done; gnomon diff g.png g.tga");
    uint8_t raw[7 * 40 * 4];
    assert_int_equal(read_file("g.raw", raw, sizeof raw), sizeof raw);
    assert_memory_equal(raw, "\xff\x00\x80\xff", 4);
    assert_memory_equal(raw + sizeof raw - 4, "\x00\xff\x80\x40", 4);
    good("spin square.obj -o s%%d.png --frames 2 --size 9x40 --eye 0,0,5 --target 0,0,9 "
         "--background ffffff,102030");
    picture p = picture_read("s1.png");
    expect_gradient(&p, 0xffffffff, 0x102030ff);
    picture_free(&p);
}

/* The model's pixels are as before a plain background. */
TEST(gradients_are_behind_the_model)
{
    picture p = drawn("square.obj --eye 0,0,5 --target 0,0,0 --orthographic 4 --size 40x40 "
                      "--background ffffff,000000");
    picture plain = drawn("square.obj --eye 0,0,5 --target 0,0,0 --orthographic 4 --size 40x40");
    for (uint32_t y = 0; y < 40; ++y)
        for (uint32_t x = 0; x < 40; ++x) {
            const bool is_inside = x >= 10 && x < 30 && y >= 10 && y < 30;
            assert_int_equal(pixel(&p, x, y), is_inside ? pixel(&plain, x, y) : pixel(&p, 0, y));
        }
    picture_free(&p);
    picture_free(&plain);
    const run r = good("compare square.obj -o c.png --size 60x40 --samples 4 " TWO_COLORS);
    expect_printed(&r, "colour: 0 of 2400 pixels differ\n");
    expect_printed(&r, "samples: 0 of 9600 differ\n");
}

/* In the middle half of 41x41 pixels: from 10.25 to 30.75. */
#define HALF "--eye 0,0,5 --target 0,0,0 --orthographic 4 --size 41x41 --light 0,0,1 "

static bool is_on_square(uint32_t x, uint32_t y)
{
    return x >= 10 && x <= 30 && y >= 10 && y <= 30 && (x == 10 || x == 30 || y == 10 || y == 30);
}

/* The border of a square is drawn, and its diagonal is not. All other pixels are as without. */
TEST(edges_are_lines_over_the_surface)
{
    picture p = drawn("square.obj " HALF "--samples 1 --edges=ff0000");
    picture plain = drawn("square.obj " HALF "--samples 1");
    for (uint32_t y = 0; y < 41; ++y)
        for (uint32_t x = 0; x < 41; ++x)
            assert_int_equal(pixel(&p, x, y),
                             is_on_square(x, y) ? 0xff0000ff : pixel(&plain, x, y));
    picture_free(&p);
    picture_free(&plain);
    const run r = good("render square.obj -o e.png --size 20x20 --edges --statistics");
    expect_printed(&r, "2 triangles");
    expect_printed(&r, "\ntriangles                            2\n");
}

/* A roof's ridge is an edge; a fold of half a degree is none. */
TEST(edges_are_where_surfaces_bend)
{
    static const struct {
        const char *back;
        bool is_edge;
    } cases[] = {{"-1", true}, {"-0.1", true}, {"-0.004", false}, {"0", false}};
    for (size_t i = 0; i < COUNT(cases); ++i) {
        char text[256];
        snprintf(text, sizeof text,
                 "v -1 -1 %s\nv 0 -1 0\nv 0 1 0\nv -1 1 %s\nv 1 -1 %s\nv 1 1 %s\n"
                 "f 1 2 3 4\nf 2 5 6 3\n",
                 cases[i].back, cases[i].back, cases[i].back, cases[i].back);
        write_text("roof.obj", text);
        picture p = drawn("roof.obj " HALF "--samples 1 --edges=ff0000");
        assert_int_equal(pixel(&p, 20, 20) == 0xff0000ff, cases[i].is_edge);
        assert_int_equal(pixel(&p, 10, 20), 0xff0000ff);
        assert_int_not_equal(pixel(&p, 15, 20), 0xff0000ff);
        picture_free(&p);
    }
}

/* What lies behind a square from -1 to 1 does not change the picture, with edges or without. */
TEST(hidden_edges_do_not_show)
{
#define SHIELD "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n"
#define BEHIND(z)                                                                                  \
    "v -.5 -.5 " z "\nv .5 -.5 " z "\nv .5 .5 " z "\nv -.5 .5 " z "\nv 0 0 -1\n"                   \
    "f 5 6 9\nf 6 7 9\nf 7 8 9\nf 8 5 9\n"
    static const char cameras[][80] = {
        "--eye 0,0,5 --target 0,0,0", "--eye 0,0,5 --target 0,0,0 --orthographic 2.5",
        "--eye 0,0,5 --target 0,0,0 --samples 1", "--eye 0.5,0.4,5 --target 0,0,0 --samples 1"};
    write_text("far.obj", SHIELD "v 0 0 -1\np 5\n");
    for (size_t i = 0; i < COUNT(cameras); ++i) {
        write_text("hidden.obj", SHIELD BEHIND("-0.05"));
        good_shell("set -e; gnomon render far.obj -o a.png --size 90x90 --edges %s; gnomon render "
                   "hidden.obj -o b.png --size 90x90 --edges %s; gnomon diff a.png b.png",
                   cameras[i], cameras[i]);
    }
    /* In front of the square they show. */
    write_text("hidden.obj", SHIELD BEHIND("0.05"));
    const run r = shell("gnomon render far.obj -o a.png --size 90x90 --edges %s; gnomon render "
                        "hidden.obj -o b.png --size 90x90 --edges %s; gnomon diff a.png b.png",
                        cameras[0], cameras[0]);
    assert_int_equal(r.status, 1);
}

/* Lines are dark on light materials and light on dark ones. */
TEST(edges_stand_out)
{
    static const struct {
        const char *material;
        uint32_t surface, line;
    } cases[] = {{"Kd 1 1 1", 0xffffffff, 0x4d4d4dff}, {"Kd 0 0 0", 0x000000ff, 0xb3b3b3ff}};
    for (size_t i = 0; i < COUNT(cases); ++i) {
        char text[64];
        snprintf(text, sizeof text, "newmtl m\n%s\n", cases[i].material);
        write_text("m.mtl", text);
        write_square("dark.obj", "mtllib m.mtl\nusemtl m\n");
        picture p = drawn("dark.obj " HALF "--samples 1 --shader unlit --edges --background %06x",
                          (unsigned)(cases[i].surface >> 8));
        expect_near(pixel(&p, 20, 20), cases[i].surface, 0);
        expect_near(pixel(&p, 20, 30), cases[i].line, 1);
        picture_free(&p);
    }
}

/* In a picture from above, 80 pixels for 8 units: the radius is sqrt(2), so lines are 0.2 apart,
 * which is 2 pixels, and 1 unit with 20 times the size. */
TEST(grids_have_lines_at_multiples)
{
    write_text("flat.obj", "v -10 -3 -10\nv 10 -3 -10\nv 10 -3 10\nv -10 -3 10\nv 0 5 0\n"
                           "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
    static const char from[] = "flat.obj --from top --orthographic 64 --size 64x64 --samples 1 ";
    picture p = drawn("%s --grid", from), plain = drawn("%s", from);
    const run r = good("render %s -o g.png --grid", from);
    expect_printed(&r, "\ngrid: lines at multiples of 2\n");
    /* Multiples of 2 from the middle, at 32, are even places between pixels: the line fills a
     * column beside it. The pyramid is from 22 to 42. */
    uint32_t columns = 0;
    for (uint32_t x = 0; x < 64; ++x) {
        const bool is_line = pixel(&p, x, 15) != pixel(&plain, x, 15);
        columns += is_line;
        if (x > 1 && is_line)
            assert_true(pixel(&p, x - 1, 15) == pixel(&plain, x - 1, 15) ||
                        pixel(&p, x - 1, 16) == pixel(&plain, x - 1, 16));
    }
    assert_true(columns >= 20);
    for (uint32_t y = 22; y < 42; ++y)
        for (uint32_t x = 22; x < 42; ++x)
            assert_int_equal(pixel(&p, x, y), pixel(&plain, x, y));
    picture_free(&p);
    picture_free(&plain);
}

/* Below the model the grid is hidden by it: where the model is drawn, nothing changes. Depth does
 * not change at all, so the camera is the same. */
TEST(grids_change_nothing_of_the_model)
{
    static const char looks[][64] = {"", "--up 0,0,1", "--orthographic 4", "--opaque --shadows",
                                     "--samples 1 --shader depth"};
    write_text("box.obj", "v -1 0 -1\nv 1 0 -1\nv 1 2 -1\nv -1 2 -1\nv -1 0 1\nv 1 0 1\nv 1 2 1\n"
                          "v -1 2 1\nf 5 6 7 8\nf 1 4 3 2\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\n"
                          "f 4 1 5 8\n");
    for (size_t i = 0; i < COUNT(looks); ++i) {
        good("render box.obj -o a.png --depth ad.png --size 90x70 %s", looks[i]);
        good("render box.obj -o b.png --depth bd.png --size 90x70 --grid %s", looks[i]);
        expect_same_files("ad.png", "bd.png");
        picture a = picture_read("a.png"), b = picture_read("b.png");
        uint32_t changed = 0;
        for (uint32_t y = 0; y < 70; ++y)
            for (uint32_t x = 0; x < 90; ++x) {
                const bool is_same = pixel(&a, x, y) == pixel(&b, x, y);
                changed += !is_same;
                if (x >= 35 && x <= 55 && y >= 25 && y <= 45)
                    assert_true(is_same);
            }
        assert_true(changed > 100);
        picture_free(&a);
        picture_free(&b);
    }
    /* From below it is in front of the bottom. */
    picture a = drawn("box.obj --from bottom --size 90x70");
    picture b = drawn("box.obj --from bottom --size 90x70 --grid");
    uint32_t changed = 0;
    for (uint32_t x = 35; x <= 55; ++x)
        changed += pixel(&a, x, 33) != pixel(&b, x, 33);
    assert_true(changed > 0);
    picture_free(&a);
    picture_free(&b);
    const run r = good("render box.obj -o n.png --size 9x9 --grid --eye 0,9,9 --target 0,18,18");
    assert_non_null(strstr(r.error, "nothing was drawn: all 12 triangles lie behind the camera"));
}

TEST(overlays_are_the_references_too)
{
    static const char looks[][100] = {"--edges", "--grid", "--edges=ff000080 --grid --from bottom",
                                      "--shader metallic-roughness --edges --grid --background "
                                      "ffffff,000000"};
    for (size_t i = 0; i < COUNT(looks); ++i) {
        const run r = good("compare box.obj -o c.png --size 90x70 %s", looks[i]);
        expect_printed(&r, "colour: 0 of 6300 pixels differ\n");
        expect_printed(&r, "depth:  0 of 6300 pixels differ\n");
    }
}

/* A picture of many views, and one that ranks would divide, has the overlays too. */
TEST(overlays_are_in_every_picture)
{
    write_text("views.txt", "--eye 3,4,5\n--eye 3,-4,5\n");
    good_shell(
        "set -e; gnomon render box.obj --edges --grid --background ffffff,9aa4b0 --size 60x50 "
        "--views views.txt -o v%%d.png; for n in 0 1; do e=$(sed -n $((n + 1))p views.txt); "
        "gnomon render box.obj --edges --grid --background ffffff,9aa4b0 --size 60x50 $e -o "
        "w.png; gnomon diff w.png v$n.png; done");
    good_shell(
        "set -e; gnomon spin box.obj --edges --grid --frames 2 --size 60x50 -o t%%d.png; "
        "gnomon render box.obj --edges --grid --size 60x50 -o w.png; gnomon diff w.png t0.png");
}

TEST(wrong_overlays_are_refused)
{
    static const refusal wrong[] = {
        {"--background ffffff,",
         "--background 'ffffff,': not #rrggbb or #rrggbbaa, or two of them"},
        {"--background ,ffffff", "--background ',ffffff': not #rrggbb"},
        {"--background ffffff,12345", "--background 'ffffff,12345': not #rrggbb"},
        {"--background 1,2,3", "--background '1,2,3': not #rrggbb"},
        {"--background fffffffffffffffffff,000000", "': not #rrggbb"},
        {"--edges=red", "--edges 'red': not #rrggbb or #rrggbbaa"},
        {"--edges --wireframe", "--edges and --wireframe cannot be used together"},
        {"--edges --points", "--edges and --points cannot be used together"},
        {"--edges --sort last", "--sort last cannot be used with --edges"},
        {"--grid --sort last", "--sort last cannot be used with --grid"},
        {"--background ffffff,000000 --sort last",
         "--sort last cannot be used with two colours of --background"},
    };
    EXPECT_EACH(2, "render square.obj -o x.png", wrong);
    expect(2, "compare square.obj -o x.png --edges --samples 4",
           "--edges and --samples cannot be used together");
}
