/* gnomon render --views: every picture is the one that gnomon render draws with the options of its
 * line; names and options that cannot be used are refused before anything is drawn. */
#include "runner.h"

#include <stdio.h>
#include <string.h>

#define LOOK "--size 40x30 --shader phong --shadows"

static const char tent[] = "v -1 0 -1\nv 1 0 -1\nv 0 1 0.3\nv -2 -0.5 2\nv 2 -0.5 2\nv 0 -0.5 -2\n"
                           "f 1 2 3\nf 1 3 2\nf 4 5 6\n";

static const char *const cameras[] = {"--eye 1,2,6", "--eye 3,1,0 --fov 60", "--orthographic 3",
                                      "--target 0,0.5,0 --up 1,0,0", "--near 2 --far 30"};
#define CAMERA_COUNT (COUNT(cameras))

static void write_views(void)
{
    char text[512] = "# views\n\n";
    for (size_t i = 0; i < CAMERA_COUNT; ++i)
        snprintf(text + strlen(text), sizeof text - strlen(text), "%s   # %zu\n", cameras[i], i);
    write_text("views.txt", text);
    write_text("tent.obj", tent);
}

static void expect_equal(const char *first, const char *second)
{
    char line[256];
    snprintf(line, sizeof line, "cmp %s %s", first, second);
    run r = shell(line);
    if (r.status != 0)
        fail_msg("%s%s", r.out, r.error);
}

TEST(views_are_single_pictures)
{
    char name[64];
    write_views();
    run r = gnomon("render tent.obj " LOOK " --eye 2,2,2 --views views.txt -o v%%02d.png --depth "
                   "d%%d.png");
    assert_int_equal(r.status, 0);
    assert_string_equal(r.error, "");
    assert_non_null(strstr(r.out, "v%02d.png: 40x30, 3 triangles, Phong\n5 views, "));
    assert_non_null(strstr(r.out, " views a second\n"));
    for (size_t i = 0; i < CAMERA_COUNT; ++i) {
        const char *eye = strstr(cameras[i], "--eye") != NULL ? "" : "--eye 2,2,2";
        r = gnomon("render tent.obj " LOOK " %s %s -o alone.png --depth alone_d.png", eye,
                   cameras[i]);
        assert_int_equal(r.status, 0);
        snprintf(name, sizeof name, "v%02zu.png", i);
        expect_equal("alone.png", name);
        snprintf(name, sizeof name, "d%zu.png", i);
        expect_equal("alone_d.png", name);
    }
    assert_false(exists("v05.png") || exists("d5.png"));
}

/* A view in which nothing is to be seen is named; the next ones are drawn. */
TEST(empty_views_are_named)
{
    write_text("tent.obj", tent);
    write_text("two.txt", "--eye 0,0,5 --near 90 --far 99\n--eye 1,2,6\n");
    run r = gnomon("render tent.obj " LOOK " --views two.txt -o e%%d.ppm");
    assert_int_equal(r.status, 0);
    assert_int_equal(lines(r.error), 1);
    assert_non_null(strstr(r.error, "gnomon: e0.ppm: warning: nothing was drawn"));
    r = gnomon("render tent.obj " LOOK " --eye 1,2,6 -o alone.ppm");
    assert_int_equal(r.status, 0);
    expect_equal("alone.ppm", "e1.ppm");
}

TEST(wrong_uses_are_refused)
{
    write_views();
    write_text("map_2.ppm", "P6 1 1 255\nabc");
    write_text("bad.txt", "--eye 1,2,3\n--fov x\n");
    write_text("impossible.txt", "--eye 1,2,3\n\n--fov 190\n");
    runner_mark();
    expect(2, "render tent.obj --views views.txt -o v.png", "-o", "pattern");
    expect(2, "render tent.obj --views views.txt -o -", "-o", "pattern");
    expect(2, "render tent.obj --views views.txt -o v%d%d.png", "v%d%d.png", "one %d");
    expect(2, "render tent.obj --views views.txt -o v%d.png --depth d.png", "--depth", "pattern");
    expect(2, "render tent.obj --views views.txt -o v%d.png --statistics", "--views",
           "--statistics");
    expect(2, "render tent.obj --views '' -o v%d.png", "--views", "a file name");
    expect(2, "compare tent.obj --views views.txt", "--views", "unknown option");
    expect(2, "render tent.obj --views bad.txt -o v%d.png", "bad.txt:2: --fov", "degrees");
    expect(1, "render tent.obj --views impossible.txt -o v%d.png", "impossible.txt:3: --fov",
           "180 degrees");
    expect(1, "render tent.obj --views none.txt -o v%d.png", "none.txt", "No such file");
    expect(1, "render none.obj --views views.txt -o v%d.png", "none.obj", "No such file");
    expect(1, "render tent.obj --views views.txt -o v%d.gif", "v0.gif", ".png");
    expect(1, "render tent.obj --views views.txt -o v%d.png --depth v%d.png", "v0.png", "both");
    expect(1, "render tent.obj --views views.txt -o v%d.png --depth d%d.tga", "d0.tga", ".png");
    expect(1, "render tent.obj --views views.txt -o no/v%d.png", "no/v0.png", "No such file");
    expect(1, "render tent.obj --views views.txt --texture map_2.ppm -o map_%d.ppm", "map_2.ppm",
           "overwritten");
}

/* Names meet at different numbers: view_11 is the picture of view 1 and the depth of view 11. */
TEST(names_of_different_views_differ)
{
    char text[512] = "";
    write_text("tent.obj", tent);
    for (int i = 0; i < 12; ++i)
        strcat(text, "--eye 1,2,3\n");
    write_text("twelve.txt", text);
    runner_mark();
    expect(1, "render tent.obj --views twelve.txt -o v1%d.png --depth v%d.png", "v1",
           "both a picture and a depth");
    write_text("v0.png", "--eye 1,2,3\n");
    runner_mark();
    expect(1, "render tent.obj --views v0.png -o v%d.png", "v0.png", "overwritten");
}
