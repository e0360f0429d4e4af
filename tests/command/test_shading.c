/* The shaders of the gnomon command: pictures that follow from maps and light, and the teapot in
 * every shader beside OSMesa's. */
#include "runner.h"

#include <stb/stb_image_write.h>
#include <stdio.h>
#include <string.h>

/* The square with other texture coordinates at its corners. */
static void write_mapped(const char *name, const char *texcoords)
{
    char text[512];
    snprintf(text, sizeof text, "%.*s%s%s", (int)(strstr(square_obj, "vt") - square_obj),
             square_obj, texcoords, strstr(square_obj, "vn"));
    write_text(name, text);
}

#define FIRST " --shader normals --normal-map tangent:first.png"
#define SECOND " --shader normals --normal-map tangent:second.png"

/* A texel (1, 0.5, 0.5) is the first axis of its space, (0.5, 1, 0.5) the second. As colours of the
 * picture they show where these axes point. */
TEST(normal_maps_have_their_axes)
{
    /* s goes up and t to the left: the tangent is +y, the bitangent -x. */
    write_mapped("turned.obj", "vt 0 1\nvt 0 0\nvt 1 0\nvt 1 1\n");
    /* s goes to the left, t up. */
    write_mapped("mirrored.obj", "vt 1 0\nvt 0 0\nvt 0 1\nvt 1 1\n");
    write_color("first.png", 255, 128, 128);
    write_color("second.png", 128, 255, 128);
    expect_color("square.obj --shader normals", 0x8080ffff);
    expect_color("square.obj" FIRST, 0xff8080ff);
    expect_color("square.obj" SECOND, 0x80ff80ff);
    expect_color("turned.obj" FIRST, 0x80ff80ff);
    expect_color("turned.obj" SECOND, 0x008080ff);
    expect_color("mirrored.obj" FIRST, 0x008080ff);
    expect_color("mirrored.obj" SECOND, 0x80ff80ff);
    expect_color("turned.obj --shader normals --normal-map world:first.png", 0xff8080ff);
    expect_color("turned.obj --shader normals --normal-map none", 0x8080ffff);
}

/* A kind of normal map is asked for as a file is: with a shader that takes normal maps. */
TEST(kinds_of_normal_maps_need_a_shader)
{
    static const refusal kinds[] = {
        {"render kind.obj -o k.png --normal-map tangent --shader flat",
         "--normal-map ... --shader flat, which has no such map"},
        {"spin kind.obj -o k.png --normal-map world --shader toon",
         "--normal-map ... --shader toon"},
        {"demo --normal-map tangent --shader gouraud", "--normal-map ... --shader gouraud"},
        {"demo --normal-map world", "--normal-map ... the default shader"},
        {"demo --normal-map any --shader phong", "--normal-map 'any': not tangent, world or none"},
    };
    write_text("kind.obj", square_obj);
    write_color("kind_nm_tangent.png", 128, 128, 255);
    EXPECT_EACH(2, "", kinds);
    expect_color("kind.obj --shader flat --light 0,0,1 --normal-map none", 0xccccccff);
    expect_color("kind.obj --shader flat --light 0,0,1 --normal-map any", 0xccccccff);
    expect_color("kind.obj --shader normals --normal-map tangent", 0x8080ffff);
    remove_file("kind_nm_tangent.png");
}

/* The shader that is taken without --shader. */
TEST(the_default_shader_is_as_told)
{
    static const char *const defaults[][2] = {
        {"render square.obj", "s, Phong"},       {"render square.obj --shadows", "s, Phong"},
        {"render mapped.obj", "s, Phong"},       {"spin square.obj --frames 1", "s, Phong"},
        {"spin --frames 1", ", vertex colours"}, {"spin --frames 1 --shadows", ", Phong"},
        {"demo --tessellation 2", "s, Gouraud"}, {"demo --tessellation 2 --shadows", "s, Phong"},
    };
    write_text("mapped.obj", square_obj);
    write_color("mapped_diffuse.png", 0, 0, 255);
    for (size_t i = 0; i < COUNT(defaults); ++i) {
        char words[64];
        run r = good("%s --size 16x16 -o a.png", defaults[i][0]);
        snprintf(words, sizeof words, " triangle%s\n", defaults[i][1]);
        expect_printed(&r, words);
    }
    remove_file("mapped_diffuse.png");
}

/* In full light a surface has the texture's colour: ambient 0.25 and diffuse 0.75. */
TEST(maps_make_the_colors)
{
    write_color("blue.png", 0, 0, 128);
    write_color("green.png", 0, 128, 0);
    write_color("away.png", 128, 128, 0);
    expect_color("square.obj --shader unlit --texture blue.png", 0x000080ff);
    expect_color("square.obj --shader vertex-color", 0xccccccff);
    expect_color("square.obj --shader flat --light 0,0,1 --texture blue.png", 0x000080ff);
    expect_color("square.obj --shader phong --light 1,0,0 --texture blue.png", 0x000020ff);
    expect_color("square.obj --shader phong --light 1,0,0 --texture blue.png --glow-map green.png",
                 0x008020ff);
    /* Two bands: all or nothing, from an angle of 60 degrees on. */
    expect_color("square.obj --shader toon --bands 2 --light 0,1,1 --texture blue.png", 0x000080ff);
    expect_color("square.obj --shader toon --bands 2 --light 0,2,1 --texture blue.png", 0x000020ff);
    /* A normal that points away from the light. */
    expect_color("square.obj --shader blinn-phong --light 0,0,1 --texture blue.png --normal-map "
                 "world:away.png",
                 0x000020ff);
    /* The square is in the middle between the planes. */
    expect_color("square.obj --shader depth", 0x808080ff);
}

/* Expects how far apart the pixels of a picture of black and white texels are, and how far they are
 * from one of the two colours: each at least and at most. */
static void expect_greys(const char *flags, int least_range, int most_range, int least_mixed,
                         int most_mixed)
{
    int low = 255, high = 0, mixed = 0;
    picture p = drawn("square.obj " FRONT " --size 9x9 --shader unlit --texture %s", flags);
    for (uint32_t i = 0; i < 81; ++i) {
        const int grey = (int)(pixel(&p, i % 9, i / 9) >> 8 & 255);
        const int distance = grey < 128 ? grey : 255 - grey;
        low = grey < low ? grey : low;
        high = grey > high ? grey : high;
        mixed = distance > mixed ? distance : mixed;
    }
    if (high - low < least_range || high - low > most_range || mixed < least_mixed ||
        mixed > most_mixed)
        fail_msg("%s: range %d, mixed %d", flags, high - low, mixed);
    picture_free(&p);
}

TEST(filters_are_what_was_asked_for)
{
    uint8_t texels[64 * 64];
    for (int i = 0; i < 64 * 64; ++i)
        texels[i] = (i % 64 + i / 64) % 2 == 0 ? 0 : 255;
    stbi_write_png(path_of("small.png"), 64, 64, 1, texels, 0);
    stbi_write_png(path_of("large.png"), 2, 2, 1, texels, 64);
    expect_greys("small.png --filter nearest", 255, 255, 0, 0);
    expect_greys("small.png --filter linear", 51, 255, 51, 128);
    expect_greys("small.png --filter mipmap", 0, 2, 121, 128);
    expect_greys("small.png", 0, 2, 121, 128);
    /* Texels larger than pixels. */
    expect_greys("large.png --filter nearest", 255, 255, 0, 0);
    expect_greys("large.png --filter linear", 0, 255, 101, 128);
    expect_greys("large.png --filter mipmap", 0, 255, 101, 128);
}

TEST(highlights_have_their_map_and_exponent)
{
    write_color("black.png", 0, 0, 0);
    write_color("green.png", 0, 255, 0);
    static const char flags[] = "--eye 0,0,5 --target 0,0,0 --orthographic 2 --size 65x65"
                                " --light 0,0,1 --shader phong --texture black.png";
    uint32_t bright[2];
    for (int i = 0; i < 2; ++i) {
        picture p =
            drawn("square.obj %s --specular-map green.png --exponent %d", flags, i == 0 ? 5 : 500);
        assert_int_equal(pixel(&p, 32, 32), 0x004000ff); /* a quarter is the default */
        bright[i] = 0;
        for (uint32_t k = 0; k < 65 * 65; ++k)
            bright[i] += (pixel(&p, k % 65, k / 65) >> 16 & 255) > 32;
        picture_free(&p);
    }
    assert_true(bright[0] == 65 * 65 && bright[1] > 10 && bright[1] < 1000);
    expect_color(
        "square.obj --light 0,0,1 --shader phong --texture black.png --specular-map black.png",
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
        picture p = drawn("lid.obj %s %s", flags, shadows ? "--shadows" : "");
        /* Lit: 0.8; in shadow a quarter of it. The lid itself is over -1 to 1 along x, its shadow
         * over -3 to -1: columns 10 to 30. */
        static const uint32_t lit[][2] = {{40, 40}, {7, 40}, {20, 27}, {60, 40}};
        for (size_t i = 0; i < COUNT(lit); ++i)
            assert_int_equal(pixel(&p, lit[i][0], lit[i][1]), 0xccccccff);
        assert_int_equal(pixel(&p, 20, 40), shadows ? 0x333333ff : 0xccccccff);
        assert_int_equal(pixel(&p, 12, 32), shadows ? 0x333333ff : 0xccccccff);
        picture_free(&p);
    }
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
    for (size_t i = 0; i < 2 * COUNT(looks); ++i) {
        run r = good("demo --size 97x71 --tessellation 5 --shader %s --samples %d", looks[i / 2],
                     i % 2 == 0 ? 1 : 4);
        expect_printed(&r, "colour: 0 of ");
        expect_printed(&r, "depth:  0 of ");
        expect_printed(&r, i % 2 == 0 ? "" : "samples: 0 of ");
        expect_printed(&r, strstr(looks[i / 2], "--shadows") != NULL ? "shadow map: 0 of " : "");
    }
}
