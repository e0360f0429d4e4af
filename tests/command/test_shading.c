/* The shaders of the gnomon command: pictures that follow from maps and light, and the teapot in
 * every shader beside OSMesa's. */
#include "runner.h"

#include <stb/stb_image_write.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void write_color(const char *name, uint8_t red, uint8_t green, uint8_t blue)
{
    const uint8_t texel[3] = {red, green, blue};
    stbi_write_png(path_of(name), 1, 1, 3, texel, 0);
}

static void expect_color(const char *model, const char *flags, uint32_t color)
{
    run r = gnomon("render %s -o a.png " FRONT " --size 8x8 %s", model, flags);
    if (r.status != 0)
        fail_msg("%s %s: status %d, %s", model, flags, r.status, r.error);
    picture p = picture_read("a.png");
    for (uint32_t i = 0; i < 64; ++i) {
        uint32_t got = pixel(&p, i % 8, i / 8);
        for (int shift = 0; shift < 32; shift += 8) {
            int difference = (int)(got >> shift & 255) - (int)(color >> shift & 255);
            if (abs(difference) > 1)
                fail_msg("%s %s: %08x, expected %08x", model, flags, (unsigned)got,
                         (unsigned)color);
        }
    }
    picture_free(&p);
}

/* The square with s going up and t to the left: its tangent is +y, its bitangent -x. */
static const char turned_obj[] = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
                                 "vt 0 1\nvt 0 0\nvt 1 0\nvt 1 1\n"
                                 "vn 0 0 1\n"
                                 "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\n";

/* The mirrored square: s to the left, t up. */
static const char mirrored_obj[] = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
                                   "vt 1 0\nvt 0 0\nvt 0 1\nvt 1 1\n"
                                   "vn 0 0 1\n"
                                   "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\n";

/* A texel (1, 0.5, 0.5) is the first axis of its space, (0.5, 1, 0.5) the second. As colours of the
 * picture they show where these axes point. */
TEST(normal_maps_have_their_axes)
{
    write_text("square.obj", square_obj);
    write_text("turned.obj", turned_obj);
    write_text("mirrored.obj", mirrored_obj);
    write_color("first.png", 255, 128, 128);
    write_color("second.png", 128, 255, 128);
    static const char first[] = "--shader normals --normal-map tangent:first.png";
    static const char second[] = "--shader normals --normal-map tangent:second.png";
    expect_color("square.obj", "--shader normals", 0x8080ffff);
    expect_color("square.obj", first, 0xff8080ff);
    expect_color("square.obj", second, 0x80ff80ff);
    expect_color("turned.obj", first, 0x80ff80ff);
    expect_color("turned.obj", second, 0x008080ff);
    expect_color("mirrored.obj", first, 0x008080ff);
    expect_color("mirrored.obj", second, 0x80ff80ff);
    expect_color("turned.obj", "--shader normals --normal-map world:first.png", 0xff8080ff);
    expect_color("turned.obj", "--shader normals --normal-map none", 0x8080ffff);
}

/* A kind of normal map is asked for as a file is: with a shader that takes normal maps. */
TEST(kinds_of_normal_maps_need_a_shader)
{
    write_text("kind.obj", square_obj);
    write_color("kind_nm_tangent.png", 128, 128, 255);
    expect(2, "render kind.obj -o k.png --normal-map tangent --shader flat", "--normal-map",
           "--shader flat, which has no such map");
    expect(2, "spin kind.obj -o k.png --normal-map world --shader toon", "--normal-map",
           "--shader toon");
    expect(2, "demo --normal-map tangent --shader gouraud", "--normal-map", "--shader gouraud");
    expect(2, "demo --normal-map world", "--normal-map", "the default shader");
    expect(2, "demo --normal-map any --shader phong", "--normal-map 'any'",
           "tangent, world or none");
    expect(2, "demo --normal-map moon --shader phong", "--normal-map 'moon'",
           "tangent, world or none");
    expect_color("kind.obj", "--shader flat --light 0,0,1 --normal-map none", 0xccccccff);
    expect_color("kind.obj", "--shader flat --light 0,0,1 --normal-map any", 0xccccccff);
    expect_color("kind.obj", "--shader normals --normal-map tangent", 0x8080ffff);
    remove_file("kind_nm_tangent.png");
}

static void expect_summary(const char *arguments, const char *shader)
{
    char words[64];
    run r = gnomon("%s --size 16x16 -o a.png", arguments);
    snprintf(words, sizeof words, " triangle%s, %s\n", strstr(r.out, " 1 triangle,") ? "" : "s",
             shader);
    if (r.status != 0 || strstr(r.out, words) == NULL)
        fail_msg("gnomon %s: status %d, %s%s", arguments, r.status, r.out, r.error);
}

/* What --help-all says of the shader that is taken without --shader. */
TEST(the_default_shader_is_as_told)
{
    write_text("plain.obj", square_obj);
    write_text("mapped.obj", square_obj);
    write_color("mapped_diffuse.png", 0, 0, 255);
    expect_summary("render plain.obj", "Gouraud");
    expect_summary("render plain.obj --shadows", "Phong");
    expect_summary("render mapped.obj", "Phong");
    expect_summary("spin plain.obj --frames 1", "Gouraud");
    expect_summary("spin --frames 1", "vertex colours");
    expect_summary("spin --frames 1 --shadows", "Phong");
    expect_summary("demo --tessellation 2", "Gouraud");
    expect_summary("demo --tessellation 2 --shadows", "Phong");
    remove_file("mapped_diffuse.png");
    static const char helps[][20] = {"render --help", "render --help-all", "spin --help",
                                     "spin --help-all", "demo --help"};
    for (size_t i = 0; i < COUNT(helps); ++i) {
        run r = gnomon("%s", helps[i]);
        const char *told = strstr(strstr(r.out, "--shader NAME"), "default:");
        const char *shadows = told != NULL ? strstr(told, "--shadows") : NULL;
        if (shadows == NULL || shadows > told + 120)
            fail_msg("%s: %.120s", helps[i], told);
        const bool spins = strncmp(helps[i], "spin", 4) == 0;
        assert_true(!spins || strstr(r.out, "triangle's default shader: vertex-color") != NULL);
    }
}

/* In full light a surface has the texture's colour: ambient 0.25 and diffuse 0.75. */
TEST(maps_make_the_colors)
{
    write_text("square.obj", square_obj);
    write_color("blue.png", 0, 0, 128);
    write_color("green.png", 0, 128, 0);
    write_color("away.png", 128, 128, 0);
    expect_color("square.obj", "--shader unlit --texture blue.png", 0x000080ff);
    expect_color("square.obj", "--shader vertex-color", 0xccccccff);
    expect_color("square.obj", "--shader flat --light 0,0,1 --texture blue.png", 0x000080ff);
    expect_color("square.obj", "--shader phong --light 1,0,0 --texture blue.png", 0x000020ff);
    expect_color("square.obj",
                 "--shader phong --light 1,0,0 --texture blue.png "
                 "--glow-map green.png",
                 0x008020ff);
    /* Two bands: all or nothing, from an angle of 60 degrees on. */
    expect_color("square.obj", "--shader toon --bands 2 --light 0,1,1 --texture blue.png",
                 0x000080ff);
    expect_color("square.obj", "--shader toon --bands 2 --light 0,2,1 --texture blue.png",
                 0x000020ff);
    /* A normal that points away from the light. */
    expect_color("square.obj",
                 "--shader blinn-phong --light 0,0,1 --texture blue.png "
                 "--normal-map world:away.png",
                 0x000020ff);
    /* The square is in the middle between the planes. */
    expect_color("square.obj", "--shader depth", 0x808080ff);
}

/* How far apart the pixels of a picture of black and white texels, larger than pixels, are, and how
 * far they are from one of the two colours. */
static void measure_greys(const char *flags, int *range, int *mixed)
{
    int low = 255;
    int high = 0;
    run r = gnomon("render square.obj -o a.png " FRONT " --size 9x9 --shader unlit %s", flags);
    assert_int_equal(r.status, 0);
    picture p = picture_read("a.png");
    *mixed = 0;
    for (uint32_t i = 0; i < 81; ++i) {
        int grey = (int)(pixel(&p, i % 9, i / 9) >> 8 & 255);
        low = grey < low ? grey : low;
        high = grey > high ? grey : high;
        int distance = grey < 128 ? grey : 255 - grey;
        *mixed = distance > *mixed ? distance : *mixed;
    }
    *range = high - low;
    picture_free(&p);
}

TEST(filters_are_what_was_asked_for)
{
    uint8_t texels[64 * 64];
    int range;
    int mixed;
    write_text("square.obj", square_obj);
    for (int i = 0; i < 64 * 64; ++i)
        texels[i] = (i % 64 + i / 64) % 2 == 0 ? 0 : 255;
    stbi_write_png(path_of("chequers.png"), 64, 64, 1, texels, 0);
    measure_greys("--texture chequers.png --filter nearest", &range, &mixed);
    assert_true(range == 255 && mixed == 0);
    measure_greys("--texture chequers.png --filter linear", &range, &mixed);
    assert_true(range > 50 && mixed > 50);
    measure_greys("--texture chequers.png --filter mipmap", &range, &mixed);
    assert_true(range < 3 && mixed > 120);
    measure_greys("--texture chequers.png", &range, &mixed);
    assert_true(range < 3 && mixed > 120);
    /* Texels larger than pixels. */
    texels[1] = texels[2] = 255;
    texels[0] = texels[3] = 0;
    stbi_write_png(path_of("large.png"), 2, 2, 1, texels, 0);
    measure_greys("--texture large.png --filter nearest", &range, &mixed);
    assert_true(range == 255 && mixed == 0);
    measure_greys("--texture large.png --filter linear", &range, &mixed);
    assert_true(mixed > 100);
    measure_greys("--texture large.png --filter mipmap", &range, &mixed);
    assert_true(mixed > 100);
}

TEST(highlights_have_their_map_and_exponent)
{
    write_text("square.obj", square_obj);
    write_color("black.png", 0, 0, 0);
    write_color("green.png", 0, 255, 0);
    write_color("white.png", 255, 255, 255);
    static const char flags[] = "--eye 0,0,5 --target 0,0,0 --orthographic 2 --size 65x65"
                                " --light 0,0,1 --shader phong --texture black.png";
    uint32_t bright[2];
    for (int i = 0; i < 2; ++i) {
        run r = gnomon("render square.obj -o a.png %s --specular-map green.png --exponent %d",
                       flags, i == 0 ? 5 : 500);
        assert_int_equal(r.status, 0);
        picture p = picture_read("a.png");
        assert_int_equal(pixel(&p, 32, 32), 0x004000ff); /* a quarter is the default */
        bright[i] = 0;
        for (uint32_t k = 0; k < 65 * 65; ++k)
            bright[i] += (pixel(&p, k % 65, k / 65) >> 16 & 255) > 32;
        picture_free(&p);
    }
    assert_true(bright[0] == 65 * 65 && bright[1] > 10 && bright[1] < 1000);
    expect_color("square.obj",
                 "--light 0,0,1 --shader phong --texture black.png "
                 "--specular-map black.png",
                 0x000000ff);
}

/* A square above a larger one, with light from above: its shadow is as large as the square. */
TEST(shadows_fall_where_light_is_kept_away)
{
    static const char flags[] =
        "--eye 0,8,0.001 --target 0,0,0 --up 0,0,-1 --orthographic 8 --size "
        "80x80 --shader toon --bands 2 --light 2,2,0 --background ffffff";
    write_text("lid.obj", "v -4 0 -4\nv -4 0 4\nv 4 0 4\nv 4 0 -4\n"
                          "v -1 2 -1\nv -1 2 1\nv 1 2 1\nv 1 2 -1\n"
                          "f 1 2 3 4\nf 5 6 7 8\n");
    for (int shadows = 0; shadows < 2; ++shadows) {
        run r = gnomon("render lid.obj -o a.png %s %s", flags, shadows ? "--shadows" : "");
        assert_int_equal(r.status, 0);
        picture p = picture_read("a.png");
        /* Lit: 0.8; in shadow a quarter of it. The lid itself is over -1 to 1 along x, its shadow
         * over -3 to -1: columns 10 to 30. */
        assert_int_equal(pixel(&p, 40, 40), 0xccccccff);
        assert_int_equal(pixel(&p, 20, 40), shadows ? 0x333333ff : 0xccccccff);
        assert_int_equal(pixel(&p, 12, 32), shadows ? 0x333333ff : 0xccccccff);
        assert_int_equal(pixel(&p, 7, 40), 0xccccccff);
        assert_int_equal(pixel(&p, 20, 27), 0xccccccff);
        assert_int_equal(pixel(&p, 60, 40), 0xccccccff);
        picture_free(&p);
    }
}

/* Draws the teapot and expects `also` in the output. */
static void expect_equal(const char *look, int samples, const char *also)
{
    run r = gnomon("demo --size 97x71 --tessellation 5 --shader %s --samples %d", look, samples);
    if (r.status != 0 || strstr(r.out, "colour: 0 of ") == NULL ||
        strstr(r.out, "depth:  0 of ") == NULL || strstr(r.out, also) == NULL)
        fail_msg("%s, %d samples: status %d\n%s%s", look, samples, r.status, r.out, r.error);
}

TEST(every_shader_is_osmesas_too)
{
    static const char looks[][64] = {"vertex-color",
                                     "unlit",
                                     "unlit --filter nearest",
                                     "flat --shadows",
                                     "gouraud --filter linear",
                                     "toon --bands 6",
                                     "toon --shadows",
                                     "phong",
                                     "phong --normal-map world",
                                     "phong --normal-map none --exponent 3",
                                     "phong --shadows",
                                     "blinn-phong --exponent 77",
                                     "blinn-phong --shadows",
                                     "normals",
                                     "normals --normal-map world",
                                     "depth"};
    for (size_t i = 0; i < COUNT(looks); ++i) {
        bool shadows = strstr(looks[i], "--shadows") != NULL;
        expect_equal(looks[i], 1, shadows ? "shadow map: 0 of " : "");
        expect_equal(looks[i], 4, "samples: 0 of ");
    }
}
