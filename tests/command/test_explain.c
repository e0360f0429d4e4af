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
    char line[1024];

    const run r = shell("gnomon explain %s >explained", arguments);
    if (r.status != 0 || strcmp(r.error, "") != 0)
        fail_msg("%s: status %d, %s", arguments, r.status, r.error);
    FILE *const file = fopen(path_of("explained"), "r");
    assert_non_null(file);
    printed[fread(printed, 1, sizeof printed - 1, file)] = '\0';
    fclose(file);
    assert_non_null(strstr(printed, "All bits agree"));
    assert_null(strstr(printed, "FAULT"));
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

static void expect_near(const char *name, double wanted)
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
    explain("triangle.obj --pixel 32,32 " CAMERA);
    for (int v = 1; v <= 3; ++v) {
        for (size_t i = 0; i < COUNT(stages); ++i) {
            transformed(r.out, v, stages[i].word, stages[i].count, wanted);
            for (int c = 0; c < stages[i].count; ++c) {
                snprintf(name, sizeof name, "v%d.%s.%c", v, stages[i].name, axis[c]);
                expect_near(name, wanted[c]);
            }
        }
        /* transform counts rows from the bottom too, in OpenGL's convention. */
        transformed(r.out, v, "\n  pixel ", 2, wanted);
        for (int c = 0; c < 2; ++c) {
            snprintf(name, sizeof name, "v%d.window.%c", v, axis[c]);
            expect_near(name, wanted[c]);
            snprintf(name, sizeof name, "v%d.snapped.%c", v, axis[c]);
            assert_true(fabs(value(name) - 256.0 * (wanted[c] - 0.5)) < 0.51);
        }
    }
}

TEST(coordinates_and_interpolation_agree)
{
    write_text("triangle.obj", triangle);
    explain("triangle.obj --pixel 30,40 " CAMERA);
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

    snprintf(arguments, sizeof arguments, "render triangle.obj -o p.png " CAMERA " %s", options);
    assert_int_equal(gnomon("%s", arguments).status, 0);
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
    expect_pixels_of("--shader phong --samples 4");
    expect_pixels_of("--shader depth --wireframe");
    expect_pixels_of("--shader flat --points=9 --shadows");
    expect_pixels_of("--shader toon --near 3.9");
}

TEST(clipping_is_told)
{
    write_text("wide.obj", "v -9 -1 0\nv 9 -1 0\nv 0 9 0\nf 1 2 3\n");
    explain("wide.obj --pixel 32,32 " CAMERA);
    assert_non_null(strstr(printed, "Clipping at the right plane x = w"));
    const double t = value("n1.t");
    assert_true(t > 0.0 && t < 1.0);
    assert_true(fabs(value("n1.clip.x") - value("n1.clip.w")) < 1e-5);
}

TEST(empty_pixels_and_fates)
{
    write_text("triangle.obj", triangle);
    explain("triangle.obj --pixel 0,0 " CAMERA);
    assert_non_null(strstr(printed, "Nothing covers it"));
    write_text("two.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nv -1 -1 -1\nv 1 -1 -1\nv 0 1 -1\n"
                          "f 1 2 3\nf 4 5 6\n");
    explain("two.obj --pixel 32,34 " CAMERA);
    assert_non_null(strstr(printed, "1. triangle of primitive 0 of draw 0: written"));
    assert_non_null(strstr(printed, "2. triangle of primitive 1 of draw 0: failed the depth test"));
    explain("two.obj --pixel 32,34 --no-depth-test " CAMERA);
    assert_non_null(strstr(printed, "2. triangle of primitive 1 of draw 0: written"));
    explain("two.obj --pixel 32,34 --cull front " CAMERA);
    assert_non_null(strstr(printed, "Nothing covers it"));
}

/* Explains a pixel that the triangle of a model does not cover, and expects the reason. */
static void expect_missing(const char *vertices, const char *options, const char *reason,
                           const char *told)
{
    char line[512];

    snprintf(line, sizeof line, "%sf 1 2 3\n", vertices);
    write_text("missing.obj", line);
    /* Before z = 0 one unit is 1 pixel, and x = y = 0 is the middle of the picture. */
    snprintf(line, sizeof line,
             "missing.obj --size 64x64 --orthographic 64 --eye 0,0,4 --target 0,0,0 --near 1 --far "
             "10 --pixel 32,31 --primitive 0,0 %s 2>/dev/null",
             options);
    explain(line);
    assert_non_null(strstr(printed, "Nothing covers it"));
    snprintf(line, sizeof line,
             "\nThe triangle of primitive 0 of draw 0 has no fragment here:\n%s.\n", reason);
    if (strstr(printed, line) == NULL || strstr(printed, told) == NULL)
        fail_msg("%s: no '%s' or no '%s' in:\n%s", vertices, reason, told, printed);
}

/* The pixel's centre is at 0.5, 0.5. */
TEST(primitives_without_a_fragment)
{
    expect_missing("v 2 0 0\nv 9 0 0\nv 2 9 0\n", "", "it does not cover the pixel",
                   "below 0: outside");
    expect_missing("v 0.5 0 0\nv 0.5 9 0\nv -9 0 0\n", "", "it does not cover the pixel",
                   "a tie, and the edge is neither a left nor a horizontal bottom edge: outside");
    expect_missing("v 2 0 0\nv 9 0 0\nv 2 9 0\n", "--samples 4", "it does not cover the pixel",
                   "Edges at sample 3: not covered");
    expect_missing("v 0 0 0\nv 9 0 0\nv 0 9 0\n", "--cull front",
                   "it is culled for the way it faces", "above 0: counter-clockwise");
    expect_missing("v 0 0 0\nv 0 9 0\nv 9 0 0\n", "--cull back",
                   "it is culled for the way it faces", "below 0: clockwise");
    expect_missing("v 0 0 0\nv 1 1 0\nv 2 2 0.1\n", "",
                   "it has no area after its vertices have snapped", "0: the corners lie on one");
    expect_missing("v 0.6 0.6 0\nv 0.9 0.6 0\nv 0.6 0.9 0\n", "",
                   "the smallest upright rectangle around it has no pixel's centre in the picture "
                   "and the scissor",
                   "extent.x");
    expect_missing("v 0 0 5\nv 9 0 5\nv 0 9 5\n", "",
                   "it lies outside the view volume, or on the side of a clip distance that is not "
                   "drawn",
                   "z < near plane");
    expect_missing("v 40 40 0\nv -20 40 0\nv 40 -20 0\n", "",
                   "what clipping leaves of it does not cover the pixel", "Clipping at the ");
    write_text("missing.obj", "v 0 0 5\nv 1 0 5\nv 0 1 5\nf 1 2 3\n");
    explain("missing.obj --primitive 0,0 --pixel 32,31 " CAMERA);
    assert_non_null(strstr(printed, "\nit lies behind the eye: no vertex has a w above 0.\n"));
    write_text("triangle.obj", triangle);
    explain("triangle.obj --pixel 32,32 --primitive 0,0 " CAMERA);
    assert_non_null(strstr(printed, "1. triangle of primitive 0 of draw 0: written"));
    assert_null(strstr(printed, "has no fragment here"));
}

/* Returns what follows a JSON value, null if it is none. */
static const char *after_json(const char *at)
{
    if (*at == '"') {
        for (++at; *at != '"'; ++at) {
            if ((unsigned char)*at < 32)
                return NULL;
            at += *at == '\\';
        }
        return at + 1;
    }
    if (*at == '{' || *at == '[') {
        const char end = *at == '{' ? '}' : ']';

        for (++at; *at != end; at += *at == ',') {
            if (end == '}') {
                at = *at == '"' ? after_json(at) : NULL;
                at = at != NULL && *at == ':' ? at + 1 : NULL;
            }
            at = at != NULL ? after_json(at) : NULL;
            if (at == NULL || (*at != ',' && *at != end))
                return NULL;
        }
        return at + 1;
    }
    const size_t length = strspn(at, "-0123456789");
    return length > 0 ? at + length : NULL;
}

TEST(json_and_states)
{
    char wanted[128];

    explain("--state 'model=cube&size=64x48&shader=toon' --pixel 30,24");
    const uint32_t word = stored_word();
    explain("--state 'model=cube&size=64x48&shader=toon' --pixel 30,24 --json");
    const char *const end = after_json(printed);
    if (end == NULL || strcmp(end, "\n") != 0)
        fail_msg("no JSON: %.2000s", printed);
    snprintf(wanted, sizeof wanted, "{\"pixel\":[30,23],\"size\":[64,48],\"color\":\"%08x\",",
             (unsigned)word);
    assert_memory_equal(printed, wanted, strlen(wanted));
    assert_non_null(strstr(printed, "\"kind\":\"triangle\",\"result\":\"written\",\"corners\":[["));
    assert_non_null(strstr(printed, "{\"name\":\"v1.clip.x\",\"value\":\""));
    assert_null(strstr(printed, "\"missing\""));
    explain("--state 'model=cube&size=64x48&shader=toon' --pixel 30,24 --primitive 0,4 --json");
    assert_string_equal(after_json(printed), "\n");
    assert_non_null(strstr(printed,
                           ",\"missing\":{\"draw\":0,\"primitive\":4,\"kind\":\"triangle\","
                           "\"result\":\"it "));
}

TEST(wrong_usage_is_named)
{
    write_text("triangle.obj", triangle);
    runner_mark();
    expect(2, "explain triangle.obj", "explain ... no pixel");
    expect(2, "explain --pixel 1,1", "explain ... no model");
    expect(2, "explain triangle.obj --pixel 1", "--pixel ... two whole numbers");
    expect(2, "explain triangle.obj --pixel -1,1", "--pixel ... two whole numbers");
    expect(2, "explain triangle.obj --pixel 1,1,1", "--pixel ... two whole numbers");
    expect(2, "explain triangle.obj --pixel 1,1 --primitive 4", "--primitive ... DRAW,PRIMITIVE");
    expect(2, "render triangle.obj -o p.png --primitive 0,0", "render ... --primitive");
    expect(1, "explain triangle.obj --pixel 1,1 --primitive 1,0", "--primitive: 1,0 ... 0 to 0");
    expect(1, "explain triangle.obj --pixel 1,1 --primitive 0,1", "--primitive: 0,1 ... 0 to 0");
    expect(2, "explain triangle.obj --pixel 1,1 --state shader=toon", "--state ... together");
    expect(1, "explain --pixel 1,1 --state shader=wood", "--state ... wood");
    expect(1, "explain --pixel 1,1 --state model=dropped", "gnomon: --state: no model ... dropped");
}

TEST(pixels_outside_are_named_as_typed)
{
    write_text("triangle.obj", triangle);
    runner_mark();
    expect(1, "explain triangle.obj --size 8x8 --pixel 8,0",
           "gnomon: --pixel: 8,0 ... outside the picture, which is 8x8");
    expect(1, "explain triangle.obj --size 8x8 --pixel 0,8", "0,8 ... outside the picture");
    expect(1, "explain triangle.obj --pixel 99999999999,0",
           "--pixel: 99999999999,0 lies ... 1024x1024");
    expect(1, "explain nothing.obj --pixel 9,007 --size 4x4", "--pixel: 9,007 lies ... 4x4");
    expect(1, "explain --pixel 640,1 --state shader=toon", "640,1 ... outside the picture");
    expect(1, "explain --pixel 0,99999999999 --state shader=toon",
           "0,99999999999 lies ... 640x480");
    /* A size that no picture has is at fault before a pixel of it. */
    expect(1, "explain triangle.obj --pixel 0,0 --size 0x0", "--size ... 16384");
    expect(1, "explain triangle.obj --size 20000x5 --pixel 0,9", "--size ... 16384");
}

TEST(cameras_of_states_are_checked)
{
    runner_mark();
    expect(1, "explain --state 'near=5&far=1' --pixel 0,0",
           "gnomon: --state: far:  ... beyond --near");
    expect(1, "explain --state 'eye=0,0,0&target=0,0,0' --pixel 0,0",
           "gnomon: --state: eye:  ... target");
    expect(1, "explain --state near=0 --pixel 0,0", "gnomon: --state: near:  ... above 0");
}

/* A state has all that these options would say. */
TEST(states_stand_alone)
{
    static const char *const others[] = {"--size 5x5",
                                         "--eye 1,2,3",
                                         "--target 0,0,0",
                                         "--up 0,1,0",
                                         "--fov 30",
                                         "--orthographic 2",
                                         "--near 1",
                                         "--far 9",
                                         "--rotate x,90",
                                         "--scale 2",
                                         "--translate 1,2,3",
                                         "--shader toon",
                                         "--light 1,2,3",
                                         "--shadows",
                                         "--exponent 9",
                                         "--bands 3",
                                         "--texture none",
                                         "--normal-map none",
                                         "--specular-map none",
                                         "--glow-map none",
                                         "--filter linear",
                                         "--wireframe",
                                         "--points",
                                         "--cull back",
                                         "--no-depth-test",
                                         "--samples 4",
                                         "--background 000000",
                                         "--import-seconds 9",
                                         "--import-memory 99",
                                         "--import-output 99",
                                         "--map-pixels 9"};
    char line[128], name[32];

    runner_mark();
    for (size_t i = 0; i < COUNT(others); ++i) {
        snprintf(name, sizeof name, "%.*s ", (int)strcspn(others[i], " "), others[i]);
        snprintf(line, sizeof line, "explain --pixel 5,5 --state size=10x10 %s", others[i]);
        expect(2, line, "%s ... --state", name);
        snprintf(line, sizeof line, "explain %s --state size=10x10 --pixel 5,5", others[i]);
        expect(2, line, "%s ... together", name);
    }
    explain("--state size=10x10 --backend portable --pixel 5,5");
}
