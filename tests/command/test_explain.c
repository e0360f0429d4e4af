/* gnomon explain: a pixel taken apart. Values are compared with those of gnomon transform and of
 * the picture that gnomon render draws with the same options. */
#include "runner.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char triangle[] = "v -1 -1 0\nv 1 -1 0.5\nv 0 1 0\nf 1 2 3\n";

/* A camera that transform can describe: 64x64, from z = 4, 40 degrees, planes at 1 and 10. */
#define CAMERA "--size 64x64 --eye 0,0,4 --target 0,0,0 --fov 40 --near 1 --far 10"

/* What explain printed; the run's own memory is too short for it. */
static char printed[1 << 20];

/* Runs explain, expects success, and keeps what it prints. */
static void explain(const char *arguments)
{
    const run r = good_shell("gnomon explain %s >explained", arguments);
    assert_string_equal(r.error, "");
    printed[read_file("explained", printed, sizeof printed - 1)] = '\0';
    assert_non_null(strstr(printed, "All bits agree"));
    assert_null(strstr(printed, "FAULT"));
}

/* Explains, and expects these words. */
static void expect_told(const char *arguments, const char *words)
{
    explain(arguments);
    if (strstr(printed, words) == NULL)
        fail_msg("%s: no '%s' in:\n%.2000s", arguments, words, printed);
}

/* The number of a value, by its name. */
static double value(const char *name)
{
    char wanted[64];

    snprintf(wanted, sizeof wanted, "\n    %s ", name);
    const char *const line = strstr(printed, wanted);
    if (line == NULL)
        fail_msg("no value %s in:\n%.2000s", name, printed);
    return strtod(line + strlen(wanted), NULL);
}

static void expect_number(const char *name, double wanted)
{
    const double found = value(name);

    if (!(fabs(found - wanted) <= 1e-5 * (1.0 + fabs(wanted))))
        fail_msg("%s is %.9g instead of %.9g", name, found, wanted);
}

/* The numbers after a word in what transform printed of point `n`, from 1 on. */
static void transformed(const char *text, int n, const char *word, int count, double out[4])
{
    const char *at = text;
    char *end;

    for (int i = 0; i < n; ++i) {
        at = strstr(i ? at + 1 : at, word);
        if (at == NULL)
            fail_msg("no %s of point %d in:\n%s", word, n, text);
    }
    at += strlen(word);
    for (int i = 0; i < count; ++i) {
        out[i] = strtod(at, &end);
        at = end;
    }
}

TEST(vertices_are_those_of_transform)
{
    static const struct {
        const char *word, *name;
        int count;
    } stages[] = {{"\n  local ", "position", 3},
                  {"\n  world ", "world", 3},
                  {"\n  view ", "view", 3},
                  {"\n  clip ", "clip", 4},
                  {"\n  NDC ", "ndc", 3}};
    static const char axis[4] = {'x', 'y', 'z', 'w'};
    double wanted[4];
    char name[64];

    write_text("triangle.obj", triangle);
    write_text("setup", "convention opengl\nscreen 64 64\nposition 0 0 4\ntarget 0 0 "
                        "0\nperspective 40\nnear 1\nfar 10\n"
                        "point -1 -1 0\npoint 1 -1 0.5\npoint 0 1 0\n");
    const run r = good("transform setup");
    explain("triangle.obj --samples 1 --pixel 32,32 " CAMERA);
    for (int v = 1; v <= 3; ++v) {
        for (size_t i = 0; i < COUNT(stages); ++i) {
            transformed(r.out, v, stages[i].word, stages[i].count, wanted);
            for (int c = 0; c < stages[i].count; ++c) {
                snprintf(name, sizeof name, "v%d.%s.%c", v, stages[i].name, axis[c]);
                expect_number(name, wanted[c]);
            }
        }
        /* transform counts rows from the bottom too, in OpenGL's convention. */
        transformed(r.out, v, "\n  pixel ", 2, wanted);
        for (int c = 0; c < 2; ++c) {
            snprintf(name, sizeof name, "v%d.window.%c", v, axis[c]);
            expect_number(name, wanted[c]);
            snprintf(name, sizeof name, "v%d.snapped.%c", v, axis[c]);
            assert_true(fabs(value(name) - 256.0 * (wanted[c] - 0.5)) < 0.51);
        }
    }
}

TEST(coordinates_and_interpolation_agree)
{
    write_text("triangle.obj", triangle);
    explain("triangle.obj --samples 1 --pixel 30,40 " CAMERA);
    const double b[3] = {value("barycentric.v1"), value("barycentric.v2"), value("barycentric.v3")};
    assert_true(fabs(b[0] + b[1] + b[2] - 1.0) < 3e-6);
    const double w = b[0] * value("v1.one_over_w") + b[1] * value("v2.one_over_w") +
                     b[2] * value("v3.one_over_w");
    const double depth =
        b[0] * value("v1.window.z") + b[1] * value("v2.window.z") + b[2] * value("v3.window.z");
    /* Coverage is decided on snapped coordinates, which are up to 1/512 pixel away. */
    assert_true(fabs(value("depth") - depth) < 1e-3);
    assert_true(fabs(value("one_over_w") - w) < 1e-3);
    assert_true(fabs(value("w") - 1.0 / value("one_over_w")) < 1e-5);
}

/* The word that explain found, 0xaabbggrr. */
static uint32_t stored_word(void)
{
    static const char before[] = "the stored word is ";
    const char *const at = strstr(printed, before);

    assert_non_null(at);
    return (uint32_t)strtoul(at + sizeof before - 1, NULL, 16);
}

static void expect_pixels_of(const char *options)
{
    static const uint32_t places[][2] = {{0, 0}, {31, 31}, {32, 20}, {20, 50}, {63, 40}, {40, 63}};
    char arguments[512];

    good("render triangle.obj -o p.png " CAMERA " %s", options);
    picture p = picture_read("p.png");
    for (size_t i = 0; i < COUNT(places); ++i) {
        const uint32_t x = places[i][0], y = places[i][1];

        snprintf(arguments, sizeof arguments, "triangle.obj " CAMERA " %s --pixel %u,%u", options,
                 (unsigned)x, (unsigned)y);
        explain(arguments);
        const uint32_t word = stored_word();
        assert_int_equal(pixel(&p, x, y), (word & 255) << 24 | (word >> 8 & 255) << 16 |
                                              (word >> 16 & 255) << 8 | word >> 24);
    }
    picture_free(&p);
}

TEST(words_are_the_pictures_pixels)
{
    write_text("triangle.obj", triangle);
    expect_pixels_of("--shader vertex-color");
    expect_pixels_of("--shader phong --samples 1");
    expect_pixels_of("--shader normals --samples 4");
    expect_pixels_of("--shader depth --wireframe");
    expect_pixels_of("--shader flat --points=9 --shadows");
    expect_pixels_of("--shader toon --near 3.9");
}

TEST(clipping_is_told)
{
    write_text("wide.obj", "v -9 -1 0\nv 9 -1 0\nv 0 9 0\nf 1 2 3\n");
    expect_told("wide.obj --pixel 32,32 " CAMERA, "Clipping at the right plane x = w");
    const double t = value("n1.t");
    assert_true(t > 0.0 && t < 1.0);
    assert_true(fabs(value("n1.clip.x") - value("n1.clip.w")) < 1e-5);
}

TEST(empty_pixels_and_fates)
{
    write_text("triangle.obj", triangle);
    write_text("two.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nv -1 -1 -1\nv 1 -1 -1\nv 0 1 -1\n"
                          "f 1 2 3\nf 4 5 6\n");
    expect_told("triangle.obj --pixel 0,0 " CAMERA, "Nothing covers it");
    expect_told("two.obj --pixel 32,34 --cull front " CAMERA, "Nothing covers it");
    expect_told("two.obj --pixel 32,34 " CAMERA, "1. triangle of primitive 0 of draw 0: written");
    expect_told("two.obj --pixel 32,34 " CAMERA,
                "2. triangle of primitive 1 of draw 0: failed the depth test");
    expect_told("two.obj --pixel 32,34 --no-depth-test " CAMERA,
                "2. triangle of primitive 1 of draw 0: written");
}

/* The pixel's centre is at 0.5, 0.5: before z = 0 one unit is 1 pixel, and x = y = 0 is the middle
 * of the picture. */
TEST(primitives_without_a_fragment)
{
    static const char uncovered[] = "it does not cover the pixel",
                      culled[] = "it is culled for the way it faces";
    static const struct {
        const char *vertices, *options, *reason, *told;
    } cases[] = {
        {"v 2 0 0\nv 9 0 0\nv 2 9 0\n", "", uncovered, "below 0: outside"},
        {"v 0.5 0 0\nv 0.5 9 0\nv -9 0 0\n", "", uncovered,
         "a tie, and the edge is neither a left nor a horizontal bottom edge: outside"},
        {"v 2 0 0\nv 9 0 0\nv 2 9 0\n", "--samples 4", uncovered, "Edges at sample 3: not covered"},
        {"v 0 0 0\nv 9 0 0\nv 0 9 0\n", "--cull front", culled, "above 0: counter-clockwise"},
        {"v 0 0 0\nv 0 9 0\nv 9 0 0\n", "--cull back", culled, "below 0: clockwise"},
        {"v 0 0 0\nv 1 1 0\nv 2 2 0.1\n", "", "it has no area after its vertices have snapped",
         "0: the corners lie on one"},
        {"v 0.6 0.6 0\nv 0.9 0.6 0\nv 0.6 0.9 0\n", "",
         "the smallest upright rectangle around it has no pixel's centre in the picture and the "
         "scissor",
         "extent.x"},
        {"v 0 0 5\nv 9 0 5\nv 0 9 5\n", "",
         "it lies outside the view volume, or on the side of a clip distance that is not drawn",
         "z < near plane"},
        {"v 40 40 0\nv -20 40 0\nv 40 -20 0\n", "",
         "what clipping leaves of it does not cover the pixel", "Clipping at the "},
    };
    char line[512];
    for (size_t i = 0; i < COUNT(cases); ++i) {
        snprintf(line, sizeof line, "%sf 1 2 3\n", cases[i].vertices);
        write_text("missing.obj", line);
        snprintf(line, sizeof line,
                 "missing.obj --size 64x64 --orthographic 64 --eye 0,0,4 --target 0,0,0 --near 1 "
                 "--far 10 --pixel 32,31 --primitive 0,0 --samples 1 %s 2>/dev/null",
                 cases[i].options);
        expect_told(line, "Nothing covers it");
        expect_told(line, cases[i].told);
        snprintf(line + strlen(line) + 1, sizeof line / 2,
                 "\nThe triangle of primitive 0 of draw 0 has no fragment here:\n%s.\n",
                 cases[i].reason);
        expect_told(line, line + strlen(line) + 1);
    }
    write_text("missing.obj", "v 0 0 5\nv 1 0 5\nv 0 1 5\nf 1 2 3\n");
    expect_told("missing.obj --samples 1 --primitive 0,0 --pixel 32,31 " CAMERA,
                "\nit lies behind the eye: no vertex has a w above 0.\n");
    write_text("triangle.obj", triangle);
    expect_told("triangle.obj --samples 1 --pixel 32,32 --primitive 0,0 " CAMERA,
                "1. triangle of primitive 0 of draw 0: written");
    assert_null(strstr(printed, "has no fragment here"));
}

#define CUBE "--state 'model=cube&size=64x48&shader=toon' --pixel 30,24 "

TEST(json_and_states)
{
    char wanted[128];
    explain(CUBE);
    snprintf(wanted, sizeof wanted, "{\"pixel\":[30,23],\"size\":[64,48],\"color\":\"%08x\",",
             (unsigned)stored_word());
    expect_told(CUBE "--json", "\"kind\":\"triangle\",\"result\":\"written\",\"corners\":[[");
    assert_memory_equal(printed, wanted, strlen(wanted));
    assert_non_null(strstr(printed, "{\"name\":\"v1.clip.x\",\"value\":\""));
    assert_null(strstr(printed, "\"missing\""));
    expect_told(CUBE "--primitive 0,4 --json",
                ",\"missing\":{\"draw\":0,\"primitive\":4,\"kind\":\"triangle\",\"result\":\"it ");
    if (has_program("python3", "whether it is JSON"))
        good_shell("python3 -m json.tool explained >/dev/null");
}

TEST(wrong_usage_is_named)
{
    static const refusal usage[] = {
        {"triangle.obj", "no pixel; give one with --pixel X,Y"},
        {"--pixel 1,1", "no model"},
        {"triangle.obj --pixel 1", "--pixel '1': not two whole numbers X,Y"},
        {"triangle.obj --pixel -1,1", "--pixel '-1,1': not two whole numbers"},
        {"triangle.obj --pixel 1,1,1", "--pixel '1,1,1': not two whole numbers"},
        {"triangle.obj --pixel 1,1 --primitive 4", "--primitive '4': ... DRAW,PRIMITIVE"},
        {"triangle.obj --pixel 1,1 --state shader=toon", "--state and a model"},
        /* A state has all that other options would say. */
        {"--pixel 5,5 --state size=10x10 --size 5x5", "--state and --size cannot be used together"},
        {"--rotate x,90 --pixel 5,5 --state size=10x10", "--state and --rotate cannot"},
        {"--pixel 5,5 --shadows --state size=10x10", "--state and --shadows cannot"},
        {"--pixel 5,5 --state size=10x10 --points", "--state and --points cannot"},
        {"--map-pixels 9 --pixel 5,5 --state size=10x10", "--state and --map-pixels cannot"},
    };
    static const refusal faults[] = {
        {"triangle.obj --pixel 1,1 --primitive 1,0", "--primitive: 1,0 ... 0 to 0"},
        {"triangle.obj --pixel 1,1 --primitive 0,1", "--primitive: 0,1 ... 0 to 0"},
        {"--pixel 1,1 --state shader=wood", "--state: ... wood"},
        {"--pixel 1,1 --state model=dropped", "gnomon: --state: no model ... dropped"},
        {"--state 'near=5&far=1' --pixel 0,0", "gnomon: --state: far:  ... beyond --near"},
        {"--state 'eye=0,0,0&target=0,0,0' --pixel 0,0", "gnomon: --state: eye:  ... target"},
        {"--state near=0 --pixel 0,0", "gnomon: --state: near:  ... above 0"},
        /* Pixels are named as typed. */
        {"triangle.obj --size 8x8 --pixel 8,0",
         "gnomon: --pixel: 8,0 lies outside the picture, which is 8x8"},
        {"triangle.obj --size 8x8 --pixel 0,8", "0,8 lies outside the picture"},
        {"triangle.obj --pixel 99999999999,0", "--pixel: 99999999999,0 lies ... 1024x1024"},
        {"nothing.obj --pixel 9,007 --size 4x4", "--pixel: 9,007 lies ... 4x4"},
        {"--pixel 640,1 --state shader=toon", "640,1 lies outside the picture"},
        {"--pixel 0,99999999999 --state shader=toon", "0,99999999999 lies ... 640x480"},
        /* A size that no picture has is at fault before a pixel of it. */
        {"triangle.obj --pixel 0,0 --size 0x0", "--size: ... 16384"},
        {"triangle.obj --size 20000x5 --pixel 0,9", "--size: ... 16384"},
    };
    write_text("triangle.obj", triangle);
    EXPECT_EACH(2, "explain", usage);
    EXPECT_EACH(1, "explain", faults);
    explain("--state size=10x10 --backend portable --pixel 5,5");
}
