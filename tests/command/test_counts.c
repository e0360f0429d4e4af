/* What became of triangles: the counts of --statistics, and the warning when nothing is drawn. */
#include "runner.h"

#include <stdio.h>
#include <string.h>

/* The line of `name` in the counts that a run printed; fails if it has another number. */
static void expect_count(const char *printed, const char *name, unsigned count)
{
    const char *const line = strstr(printed, name);
    unsigned found;

    if (line == NULL || sscanf(line + strlen(name), "%u", &found) != 1 || found != count)
        fail_msg("not %s %u in:\n%s", name, count, printed);
}

TEST(counts_are_printed)
{
    run r = good("render square.obj -o a.png --size 16x16 " FRONT);
    assert_null(strstr(r.out, "covered"));
    r = good("render square.obj -o b.png --size 16x16 --statistics " FRONT);
    assert_string_equal(r.error, "");
    expect_count(r.out, "\ntriangles", 2);
    expect_count(r.out, "\n  drawn", 2);
    expect_count(r.out, "of these clipped:", 0);
    expect_count(r.out, "\n  outside the view", 0);
    expect_count(r.out, "\npixels covered", 256);
    expect_count(r.out, "\n  passed the depth test", 256);
    expect_same_files("a.png", "b.png"); /* draws that count draw the same */
    r = gnomon("render square.obj -o c.png --size 16x16 --samples 4 --statistics " FRONT);
    expect_count(r.out, "\nsamples covered", 1024);
    r = gnomon("render square.obj -o c.png --size 16x16 --statistics --eye 0,0,5 --target 0,0,0 "
               "--orthographic 1");
    expect_count(r.out, "of these clipped:", 2);
    /* Where the picture goes to standard output, they go with the other words. */
    r = good_shell("gnomon render square.obj --size 16x16 --statistics " FRONT
                   " -o - >s.png && cmp s.png a.png");
    expect_count(r.error, "\npixels covered", 256);
    r = good("compare square.obj --size 16x16 --statistics -o d.png " FRONT);
    expect_count(r.out, "\npixels covered", 256);
    r = good("demo --size 32x24 --statistics -o d.png");
    expect_printed(&r, "\n  outside the view");
}

TEST(nothing_drawn_has_a_reason)
{
    static const char *const cases[][2] = {
        {"square.obj --eye 0,0,5 --target 0,0,10", "all 2 triangles lie behind the camera"},
        {"triangle.obj --eye 0,0,5 --target 0,0,10", "the only triangle lies behind the camera"},
        {"square.obj --eye 0,0,5 --target 0,0,10 --statistics",
         "all 2 triangles lie behind the camera"},
        {"square.obj --samples 4 --eye 0,0,5 --target 5,0,5",
         "all 2 triangles lie outside the view volume"},
        {"square.obj --eye 5,0,0 --target 0,0,0", "all 2 triangles have no area in this view"},
        {"two.obj --eye 0,0,50 --target 30,0,49",
         "of 2 triangles 1 lies behind the camera, 1 lies outside the view volume"}};
    write_text("triangle.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nf 1 2 3\n");
    write_text("two.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nf 1 2 3\n"
                          "v -1 -1 99\nv 1 -1 99\nv 1 1 99\nf 4 5 6\n");
    for (size_t i = 0; i < COUNT(cases); ++i) {
        char wanted[256];
        remove_file("n.png");
        const run r = good("render %s -o n.png --size 16x16", cases[i][0]);
        snprintf(wanted, sizeof wanted, "gnomon: n.png: warning: nothing was drawn: %s\n",
                 cases[i][1]);
        if (strcmp(r.error, wanted) != 0 || !exists("n.png"))
            fail_run(&r);
    }
    const run r = good("compare square.obj -o e.png --size 16x16 --eye 0,0,5 --target 0,0,10");
    assert_non_null(strstr(r.error, "gnomon: e.png: warning: nothing was drawn: all 2 triangles"));
}

/* What covers the background's colour with the same colour is drawn. */
TEST(what_cannot_be_seen_is_drawn)
{
    write_text("white.obj", "v -1 -1 0 1 1 1\nv 1 -1 0 1 1 1\nv 1 1 0 1 1 1\nf 1 2 3\n");
    picture p = drawn("white.obj --size 16x16 --shader vertex-color --background ffffff " FRONT);
    picture_free(&p);
}
