/* gnomon render --views: every picture is the one that gnomon render draws with the options of its
 * line; names, lines and options that cannot be used are refused before anything is drawn. */
#include "runner.h"

#include <stdio.h>
#include <string.h>

#define LOOK "tent.obj --size 40x30 --shader phong --shadows"

static void write_tent(void)
{
    write_text("tent.obj", "v -1 0 -1\nv 1 0 -1\nv 0 1 0.3\nv -2 -0.5 2\nv 2 -0.5 2\nv 0 -0.5 -2\n"
                           "f 1 2 3\nf 1 3 2\nf 4 5 6\n");
}

/* The text of a file has these views: pictures and depths are those that render draws with the
 * options of each. `others` are the options beside --views. */
static void expect_views(const char *text, const char *others, const char *const *cameras,
                         size_t count)
{
    char words[64];
    write_tent();
    write_text("views.txt", text);
    run r = good("render " LOOK " %s --views views.txt -o v%%02d.png --depth d%%d.png", others);
    assert_string_equal(r.error, "");
    snprintf(words, sizeof words, "v%%02d.png: 40x30, 3 triangles, Phong\n%zu views, ", count);
    expect_printed(&r, words);
    expect_printed(&r, " views a second\n");
    for (size_t i = 0; i < count; ++i) {
        good("render " LOOK " %s -o alone.png --depth alone_d.png", cameras[i]);
        good_shell("cmp alone.png v%02zu.png && cmp alone_d.png d%zu.png", i, i);
    }
    snprintf(words, sizeof words, "v%02zu.png", count);
    assert_false(exists(words));
    good_shell("rm v??.png d?.png");
}

TEST(views_are_single_pictures)
{
    static const char *const cameras[] = {
        "--eye 1,2,6", "--eye 3,1,0 --fov 60", "--orthographic 3 --eye 2,2,2",
        "--target 0,0.5,0 --up 1,0,0 --eye 2,2,2", "--near 2 --far 30 --eye 2,2,2"};
    expect_views("\xef\xbb\xbf# views\n\n--eye 1,2,6\r\n \t\n\t--eye=3,1,0 --fov 60 #x\n"
                 "--orthographic 3\n--target 0,0.5,0 --up 1,0,0  # up\n--near 2 --far 30",
                 "--eye 2,2,2", cameras, COUNT(cameras));
}

/* A line's projection replaces that of the command line. */
TEST(other_options_stay)
{
    static const char *const parallel[] = {"--far 50 --orthographic 3 --up 1,0,0",
                                           "--far 50 --fov 20", "--far 50 --orthographic 4"};
    static const char *const central[] = {"--fov 70 --up 1,0,0", "--orthographic 4"};
    expect_views("--up 1,0,0\n--fov 20\n--orthographic 4\n", "--far 50 --orthographic 3", parallel,
                 COUNT(parallel));
    expect_views("--up 1,0,0\n--orthographic 4\n", "--fov 70", central, COUNT(central));
}

/* A view in which nothing is to be seen is named; the next ones are drawn. */
TEST(empty_views_are_named)
{
    write_tent();
    write_text("two.txt", "--eye 0,0,5 --near 90 --far 99\n--eye 1,2,6\n");
    run r = good("render " LOOK " --views two.txt -o e%%d.ppm");
    assert_int_equal(lines(r.error), 1);
    assert_non_null(strstr(r.error, "gnomon: e0.ppm: warning: nothing was drawn"));
    good("render " LOOK " --eye 1,2,6 -o alone.ppm");
    expect_same_files("alone.ppm", "e1.ppm");
}

TEST(faults_name_line_and_option)
{
    static const struct {
        int status;
        const char *text, *message;
    } faults[] = {
        {2, "", ": has no view"},
        {2, "# nothing\n\n", ": has no view"},
        {2, "\xef\xbb\xbf", ": has no view"},
        {2, "--fov 30\n\xef\xbb\xbf--fov 40\n", ":2: ... not an option of a camera"},
        {2, "--fov 40\n--eye 1,2\n", ":2: --eye: '1,2': not three numbers"},
        {2, "\n--eye", ":2: --eye: no value"},
        {2, "--up # 0,0,1\n", ":1: --up: no value"},
        {2, "--up=\n", ":1: --up: '': not three"},
        {2, "--near x\n", ":1: --near: 'x': not a distance"},
        /* # begins a comment only where a word begins. */
        {2, "--far 9#x\n", ":1: --far: '9#x': not a distance"},
        {2, "--fov 1e99\n", ":1: --fov: ... finite in 32 bits"},
        {2, "--eye 1,2,3 --size 4x4\n", ":1: --size: not an option of a camera"},
        {2, "--nothing=4\n", ":1: --nothing: not an option of a camera"},
        {2, "--eye 1,2,3 4\n", ":1: 4: not an option of a camera"},
        {2, "-eye 1,2,3\n", ":1: -eye: not an option of a camera"},
        {2, "--ey 1,2,3\n", ":1: --ey: not an option of a camera"},
        {2, "--\n", ":1: --: not an option of a camera"},
        {2, "--fov 3 --orthographic 4\n", ":1: --fov: ... together"},
        {1, "--fov 30\n\n--eye 1,1,1 --target 1,1,1\n", ":3: --eye: impossible"},
        {1, "--fov 30\n--up 0,0,0\n", ":2: --up: impossible"},
        {1, "--fov 180\n", ":1: --fov: impossible"},
        {1, "--fov 9\n--near 5 --far 4\n", ":2: --far: impossible"},
    };
    static const char zero[] = "--eye 1,2,3\n--fov 4\0 5\n";
    for (size_t i = 0; i < COUNT(faults); ++i) {
        write_text("wrong.txt", faults[i].text);
        expect(faults[i].status, "render square.obj --views wrong.txt -o v%d.png",
               "gnomon: wrong.txt%s", faults[i].message);
    }
    write_bytes("wrong.txt", zero, sizeof zero - 1);
    expect(2, "render square.obj --views wrong.txt -o v%d.png", "wrong.txt:2: view: ... zero byte");
    /* Of too many views the next fault is not reached. */
    good_shell("yes -- '--fov 9' | head -n 100000 >many.txt");
    expect(1, "render square.obj --views many.txt -o no/v%d.png", "no/v0.png: ... No such file");
    good_shell("echo --fov 9 >>many.txt");
    expect(2, "render square.obj --views many.txt -o no/v%d.png",
           "many.txt:100001: view: more than 100000");
}

TEST(wrong_uses_are_refused)
{
    static const refusal usage[] = {
        {"-o v.png", "-o ... pattern"},
        {"-o -", "-o ... pattern"},
        {"-o v%d%d.png", "v%d%d.png ... one %d"},
        {"-o v%d.png --depth d.png", "--depth ... pattern"},
        {"-o v%d.png --statistics", "--views ... --statistics"},
        {"-o v%d.png --views ''", "--views ... a file name"},
    };
    static const refusal faults[] = {
        {"-o v%d.png --views none.txt", "none.txt: ... No such file"},
        {"none.obj -o v%d.png", "none.obj: ... No such file"},
        {"-o v%d.gif", "v0.gif: ... .png"},
        {"-o v%d.png --depth v%d.png", "v0.png: ... both"},
        {"-o v%d.png --depth d%d.tga", "d0.tga: ... .png"},
        {"-o no/v%d.png", "no/v0.png: ... No such file"},
        {"--texture map_2.ppm -o map_%d.ppm", "map_2.ppm: ... overwritten"},
        /* Names meet at different numbers: v11 is the picture of view 1 and the depth of view 11.
         */
        {"-o v1%d.png --depth v%d.png", "v1 ... both a picture and a depth"},
        {"--views w0.png -o w%d.png", "w0.png: ... overwritten"},
    };
    write_color("map_2.ppm", 1, 2, 3);
    write_text("w0.png", "--eye 1,2,3\n");
    good_shell("yes -- '--eye 1,2,3' | head -n 12 >twelve.txt");
    EXPECT_EACH(2, "render square.obj --views twelve.txt", usage);
    EXPECT_EACH(1, "render square.obj --views twelve.txt", faults);
}
