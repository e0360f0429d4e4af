/* The pictures of the gnomon command, read back, and what is counted of them. Expected values
 * follow from the models. */
#include "runner.h"

#include <stb/stb_image_write.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A square whose vertices have a colour. */
static const char red_square[] = "v -1 -1 0 1 0 0\nv 1 -1 0 1 0 0\nv 1 1 0 1 0 0\nv -1 1 0 1 0 0\n"
                                 "f 1 2 3\nf 1 3 4\n";

TEST(vertex_colors_fill_the_picture)
{
    write_text("red.obj", red_square);
    expect_rectangle("red.obj " FRONT " --shader vertex-color --size 37x37",
                     RECTANGLE(0, 0, 37, 37), 0xff0000ff, 0);
    /* 16 wide is twice the square: a quarter of the width on either side is empty. */
    expect_rectangle("red.obj " FRONT " --light 0,0,1 --size 16x8 --shader flat",
                     RECTANGLE(4, 0, 12, 8), 0xff0000ff, BACKGROUND);
}

/* The square from 10.25 to 30.75 pixels in both directions, divided by the diagonal that goes up to
 * the right. */
TEST(wireframe_draws_the_edges)
{
    write_text("red.obj", red_square);
    picture p = drawn("red.obj --eye 0,0,5 --target 0,0,0 --orthographic 4 --shader vertex-color "
                      "--size 41x41 --wireframe");
    for (uint32_t x = 0; x < 41; ++x) {
        const bool is_drawn = x == 10 || x == 14 || x == 30;
        assert_int_equal(pixel(&p, x, 26), is_drawn ? 0xff0000ff : BACKGROUND);
    }
    assert_int_equal(pixel(&p, 20, 10), 0xff0000ff);
    assert_int_equal(pixel(&p, 20, 30), 0xff0000ff);
    picture_free(&p);
}

/* The square from 10.25 to 30.75. Samples at 0.375, 0.875, 0.125 and 0.625 of a pixel along x and
 * 0.125, 0.375, 0.625 and 0.875 along y decide how much of a pixel at its sides is red. */
TEST(samples_smooth_edges)
{
    static const char from[] = "red.obj --eye 0,0,5 --target 0,0,0 --orthographic 4 --size 41x41 "
                               "--shader vertex-color --background 000000 --samples";
    static const struct {
        uint32_t x, y, color;
    } pixels[] = {{9, 20, 0xff},        {10, 20, 0xbf0000ff}, {20, 20, 0xff0000ff},
                  {30, 20, 0xbf0000ff}, {20, 10, 0xbf0000ff}, {20, 30, 0xbf0000ff}};
    write_text("red.obj", red_square);
    picture p = drawn("%s 1", from);
    assert_int_equal(pixel(&p, 10, 20), 0xff0000ff);
    assert_int_equal(pixel(&p, 30, 20), 0xff0000ff);
    picture_free(&p);
    p = drawn("%s 4 --depth d.png", from);
    for (size_t i = 0; i < COUNT(pixels); ++i)
        assert_int_equal(pixel(&p, pixels[i].x, pixels[i].y), pixels[i].color);
    picture_free(&p);
    /* Depth is that of the first sample, 0.375 along x and 0.125 along y from below. */
    p = picture_read_grey16("d.png");
    assert_true(p.grey[20 * 41 + 10] < 65535 && p.grey[20 * 41 + 30] < 65535);
    assert_int_equal(p.grey[30 * 41 + 20], 65535);
    picture_free(&p);
    run r = good("compare red.obj --size 50x40 --samples 4");
    expect_printed(&r, "colour: 0 of 2000 pixels differ\n");
    expect_printed(&r, "samples: 0 of 8000 differ\n");
}

/* Pictures to look at are smooth by default, those to compare are not. */
TEST(pictures_to_look_at_are_smooth)
{
    write_text("red.obj", red_square);
    good_shell(
        "set -e; gnomon render red.obj --size 41x41 -o a.png; gnomon render red.obj --size "
        "41x41 --samples 4 -o b.png; cmp a.png b.png; gnomon render red.obj --size 41x41 "
        "--samples 1 -o b.png; ! cmp -s a.png b.png; gnomon spin red.obj --size 41x41 --frames "
        "1 -o s%%d.png; gnomon diff s0.png a.png");
    run r = good("compare red.obj --size 50x40 -o c.png");
    assert_null(strstr(r.out, "samples"));
}

TEST(background_is_what_was_asked_for)
{
    static const struct {
        const char *typed;
        uint32_t color;
    } backgrounds[] = {{"'#12345678'", 0x12345678}, {"ABCDEF", 0xabcdefff}};
    write_text("red.obj", red_square);
    for (size_t i = 0; i < COUNT(backgrounds); ++i) {
        good("render red.obj -o b.png --eye 0,0,5 --target 0,0,9 --size 9x5 --background %s",
             backgrounds[i].typed);
        picture p = picture_read("b.png");
        expect_inside(&p, RECTANGLE(0), 0, backgrounds[i].color);
        picture_free(&p);
    }
}

TEST(top_row_is_the_top)
{
#define UPPER "upper.obj --shader vertex-color --size 20x20 --background ffffff "
    write_text("upper.obj", "v -1 0 0 0 0 1\nv 0 0 0 0 0 1\nv 0 1 0 0 0 1\nv -1 1 0 0 0 1\n"
                            "f 1 2 3\nf 1 3 4\n");
    expect_rectangle(UPPER FRONT, RECTANGLE(0, 0, 10, 10), 0x0000ffff, 0xffffffff);
    /* Seen from behind, left and right are exchanged; with up reversed, top and bottom are. */
    expect_rectangle(UPPER "--eye 0,0,-5 --target 0,0,0 --orthographic 2", RECTANGLE(10, 0, 20, 10),
                     0x0000ffff, 0xffffffff);
    expect_rectangle(UPPER FRONT " --up 0,-1,0", RECTANGLE(10, 10, 20, 20), 0x0000ffff, 0xffffffff);
}

/* From distance 2, 90 degrees see 4 units: the square is the middle half. */
TEST(perspective_sees_the_angle_asked_for)
{
    write_text("red.obj", red_square);
    expect_rectangle(
        "red.obj --eye 0,0,2 --target 0,0,0 --fov 90 --shader vertex-color --size 40x40",
        RECTANGLE(10, 10, 30, 30), 0xff0000ff, BACKGROUND);
}

TEST(framing_shows_the_whole_model)
{
    static const char flags[][64] = {"--size 60x60", "--size 120x40", "--size 40x120",
                                     "--size 60x60 --fov 120", "--size 60x60 --up 0,0,1"};
    /* Far from the origin and small, so that only framing finds it. */
    write_text("cube.obj", "v 99 49 -3\nv 101 49 -3\nv 101 51 -3\nv 99 51 -3\n"
                           "v 99 49 -1\nv 101 49 -1\nv 101 51 -1\nv 99 51 -1\n"
                           "f 5 6 7 8\nf 1 4 3 2\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    for (int i = 0; i < 5; ++i) {
        picture p = drawn("cube.obj %s", flags[i]);
        uint32_t count = 0;
        for (uint32_t y = 0; y < p.height; ++y) {
            for (uint32_t x = 0; x < p.width; ++x) {
                if (pixel(&p, x, y) == 0xedeeefff)
                    continue;
                ++count;
                assert_true(x > 0 && y > 0 && x + 1 < p.width && y + 1 < p.height);
            }
        }
        assert_int_not_equal(pixel(&p, p.width / 2, p.height / 2), 0xedeeefff);
        uint32_t least = p.width < p.height ? p.width : p.height;
        assert_true(count > least * least / 8);
        picture_free(&p);
    }
}

TEST(depth_is_16_bit_grey)
{
    write_text("red.obj", red_square);
    good("render red.obj -o a.png --depth d.png " FRONT " --size 12x10");
    picture p = picture_read_grey16("d.png");
    assert_int_equal(p.width, 12);
    assert_int_equal(p.height, 10);
    /* The square is in the middle between the planes; beside it is the clear value. */
    for (uint32_t y = 0; y < 10; ++y) {
        assert_int_equal(p.grey[y * 12], 65535);
        assert_true(abs((int)p.grey[y * 12 + 6] - 32768) <= 2);
    }
    picture_free(&p);
    /* Nearer is darker, and the top row is the top: the left half is in front. */
    write_text("steps.obj", "v -1 -1 1 1 1 0\nv 0 -1 1 1 1 0\nv 0 1 1 1 1 0\nv -1 1 1 1 1 0\n"
                            "v -1 -1 -1 0 1 1\nv 1 -1 -1 0 1 1\nv 1 1 -1 0 1 1\nv -1 1 -1 0 1 1\n"
                            "f 1 2 3 4\nf 5 6 7 8\n");
    good("render steps.obj -o a.png --depth d.png --shader vertex-color " FRONT " --size 8x8");
    p = picture_read_grey16("d.png");
    /* z = 1 and -1 in a sphere of radius sqrt(3) and 1 % more: 0.5 -+ 1/(2*1.7494). */
    assert_true(abs((int)p.grey[8 * 3 + 1] - 14037) <= 2);
    assert_true(abs((int)p.grey[8 * 3 + 6] - 51498) <= 2);
    picture_free(&p);
    p = picture_read("a.png");
    assert_int_equal(pixel(&p, 1, 3), 0xffff00ff);
    assert_int_equal(pixel(&p, 6, 3), 0x00ffffff);
    picture_free(&p);
}

/* In full light and without highlights. */
#define LIT "square.obj " FRONT " --light 0,0,1 --size 100x100 --shader gouraud "

/* 64x64, top left red, top right green, bottom left blue, bottom right white. */
static const uint32_t quadrants[4] = {0xff0000ff, 0x00ff00ff, 0x0000ffff, 0xffffffff};

static void expect_quadrants(const char *arguments, int tolerance)
{
    picture p = drawn("%s", arguments);
    for (uint32_t i = 0; i < 4; ++i)
        expect_near(pixel(&p, i % 2 * 50 + 25, i / 2 * 50 + 25), quadrants[i], tolerance);
    picture_free(&p);
}

TEST(textures_stand_upright)
{
    uint8_t texels[64 * 64 * 3];
    for (int i = 0; i < 64 * 64 * 3; ++i) {
        const uint32_t color = quadrants[(i / 3 / 64 < 32 ? 0 : 2) + (i / 3 % 64 < 32 ? 0 : 1)];
        texels[i] = (uint8_t)(color >> (24 - i % 3 * 8));
    }
    stbi_write_png(path_of("t.png"), 64, 64, 3, texels, 0);
    stbi_write_jpg(path_of("t.jpg"), 64, 64, 3, texels, 95);
    stbi_write_tga(path_of("t.tga"), 64, 64, 3, texels);
    expect_quadrants(LIT "--texture t.png", 0);
    expect_quadrants(LIT "--texture t.tga", 0);
    expect_quadrants(LIT "--texture t.jpg", 8);

    /* Without --texture and without a material: the map is found by the model's name. */
    expect_color("square.obj --light 0,0,1 --shader gouraud", 0xccccccff);
    good_shell("mv t.tga square_diffuse.tga");
    expect_quadrants(LIT, 0);
    expect_quadrants("square.obj " FRONT " --shader unlit --size 100x100", 0);
    expect_quadrants(LIT "--filter nearest", 0);
    expect_color("square.obj --light 0,0,1 --shader gouraud --texture none", 0xccccccff);
    remove_file("square_diffuse.tga");
}

static void expect_maps(const char *arguments, const char *maps)
{
    run r = good("render %s -o a.png --size 8x8", arguments);
    const char *line = strstr(r.out, "\nmaps: ");
    if (maps[0] == '\0' ? line != NULL : line == NULL || strcmp(line + 7, maps) != 0)
        fail_msg("%s: expected '%s' of\n%s", arguments, maps, r.out);
}

#define TANGENT "tangent-space normals face_nm_tangent.jpg"

TEST(maps_are_found_by_name)
{
    write_text("face.obj", square_obj);
    expect_maps("face.obj", "");
    write_color("face_nm.png", 128, 255, 128);
    expect_maps("face.obj", "world-space normals face_nm.png\n");
    write_color("face_nm_tangent.jpg", 128, 128, 255);
    expect_maps("face.obj", TANGENT "\n");
    expect_maps("face.obj --normal-map world", "world-space normals face_nm.png\n");
    expect_maps("face.obj --normal-map none", "");
    expect_maps("face.obj --shader unlit", "");
    write_color("face_diffuse.tga", 0, 255, 0);
    write_color("face_spec.png", 9, 9, 9);
    write_color("face_glow.png", 9, 9, 9);
    expect_maps("face.obj", "diffuse face_diffuse.tga, " TANGENT
                            ", specular face_spec.png, glow face_glow.png\n");
    expect_maps("./face.obj --texture none --glow-map face_spec.png --specular-map none",
                "tangent-space normals ./face_nm_tangent.jpg, glow face_spec.png\n");
    expect_maps("face.obj --shader toon", "diffuse face_diffuse.tga\n");
    expect_maps("face.obj --shader normals", TANGENT "\n");
    expect_maps("face.obj --shader normals --normal-map tangent:face_spec.png",
                "tangent-space normals face_spec.png\n");
    expect_maps("face.obj --shader vertex-color", "");
    good_shell("rm face_*");
}

TEST(maps_are_found_by_material)
{
    write_text("coat.mtl", "newmtl coat\nKd 1 1 1\nmap_Kd c1.png\nmap_Ks c2.png\nmap_Ke c3.png\n"
                           "map_Bump c4.png\n");
    write_color("c1.png", 99, 99, 99);
    good_shell("cp c1.png c2.png; cp c1.png c3.png");
    write_color("c4.png", 120, 130, 255);
    write_square("coat.obj", "mtllib coat.mtl\nusemtl coat\n");
    expect_maps("coat.obj", "diffuse c1.png, tangent-space normals c4.png, specular c2.png, "
                            "glow c3.png\n");
    /* A grey map holds heights. */
    write_color("c4.png", 120, 120, 120);
    expect_maps("coat.obj", "diffuse c1.png, (heights, not used) c4.png, specular c2.png, "
                            "glow c3.png\n");
    /* Given by an option instead. */
    expect_maps("coat.obj --normal-map tangent:c3.png --texture c2.png",
                "diffuse c2.png, tangent-space normals c3.png, specular c2.png, glow c3.png\n");
}

/* A glTF file with everything inside: the square, and a texture of two texels, red above
 * green. */
static const char square_gltf[] =
    "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
    "\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,"
    "\"TEXCOORD_0\":1},\"indices\":2,\"material\":0}]}],\"materials\":[{"
    "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}],"
    "\"textures\":[{\"source\":0}],\"images\":[{\"mimeType\":\"image/png\",\"uri\":"
    "\"data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAACCAIAAAAW4yFwAAAADklEQVR4nGP4zwAE/xkACP8B/0AhLC4AAAAASUVO"
    "RK5CYII="
    "\"}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\","
    "\"min\":[-1,-1,0],\"max\":[1,1,0]},{\"bufferView\":1,\"componentType\":5126,\"count\":4,"
    "\"type\":\"VEC2\"},{\"bufferView\":2,\"componentType\":5123,\"count\":6,"
    "\"type\":\"SCALAR\"}],\"bufferViews\":[{\"buffer\":0,\"byteOffset\":0,\"byteLength\":48},"
    "{\"buffer\":0,\"byteOffset\":48,\"byteLength\":32},{\"buffer\":0,\"byteOffset\":80,"
    "\"byteLength\":12}],\"buffers\":[{\"byteLength\":92,\"uri\":"
    "\"data:application/octet-stream;base64,"
    "AACAvwAAgL8AAAAAAACAPwAAgL8AAAAAAACAPwAAgD8AAAAAAACAvwAAgD8AAAAAAAAAAAAAgD8AAIA/AACAPwAA"
    "gD8AAAAAAAAAAAAAAAAAAAEAAgAAAAIAAwA="
    "\"}]}";

TEST(textures_inside_the_model_are_used)
{
    write_text("square.gltf", square_gltf);
    picture p = drawn("square.gltf " FRONT " --light 0,0,1 --size 40x40 --shader gouraud");
    expect_near(pixel(&p, 20, 10), 0xff0000ff, 8);
    expect_near(pixel(&p, 20, 30), 0x00ff00ff, 8);
    picture_free(&p);
}

/* The left half has a colour, the right half a texture, whose path has a backslash. */
TEST(materials_are_followed)
{
    good_shell("mkdir -p skins");
    write_color("skins/green.png", 0, 255, 0);
    write_text("two.mtl", "newmtl plain\nKd 1 0 1\nnewmtl skin\nKd 1 1 1\n"
                          "map_Kd skins\\green.png\n");
    write_text("two.obj", "mtllib two.mtl\n"
                          "v -1 -1 0\nv 0 -1 0\nv 0 1 0\nv -1 1 0\nv 1 -1 0\nv 1 1 0\n"
                          "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
                          "usemtl plain\nf 1/1/1 2/2/1 3/3/1 4/4/1\n"
                          "usemtl skin\nf 2/1/1 5/2/1 6/3/1 3/4/1\n");
    expect_rectangle("two.obj " FRONT " --light 0,0,1 --size 10x10", RECTANGLE(0, 0, 5, 10),
                     0xff00ffff, 0x00ff00ff);
}

TEST(missing_normals_are_computed)
{
    /* If corners are weighted by angle, the corner normals of a cube are its diagonals, however its
     * faces are cut into triangles; here the top is cut the other way. */
#define BEHIND "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\n"
#define BEFORE "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    static const char shared[] =
        BEHIND BEFORE "f 5 6 7\nf 5 7 8\nf 1 4 3\nf 1 3 2\nf 1 2 6\nf 1 6 5\n"
                      "f 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n";
    /* The front face above, with vertices of its own. */
    static const char split[] = BEHIND BEFORE BEFORE "f 9 10 11 12\nf 1 4 3 2\nf 1 2 6 5\n"
                                                     "f 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    write_text("shared.obj", shared);
    write_text("split.obj", split);
    for (int i = 0; i < 2; ++i) {
        static const char looks[] = FRONT " --light 1,1,1 --size 256x256 --shader gouraud";
        const char *const name = i == 0 ? "shared.obj" : "split.obj";
        picture p = drawn("%s %s --crease 180", name, looks);
        /* Grey 0.8 times ambient 0.25 + diffuse 0.75 * N.L, with N.L = 1, 1/3, 1/3, < 0. */
        expect_near(pixel(&p, 255, 0), 0xccccccff, 2);
        expect_near(pixel(&p, 0, 0), 0x666666ff, 2);
        expect_near(pixel(&p, 255, 255), 0x666666ff, 2);
        expect_near(pixel(&p, 0, 255), 0x333333ff, 2);
        picture_free(&p);
        /* Edges of 90 degrees are creases: the front has one normal, N.L = sqrt(1/3). */
        p = drawn("%s %s", name, looks);
        expect_inside(&p, RECTANGLE(0, 0, 256, 256), 0x8b8b8bff, 0);
        picture_free(&p);
        p = drawn("%s %s --crease 89.9", name, looks);
        expect_inside(&p, RECTANGLE(0, 0, 256, 256), 0x8b8b8bff, 0);
        picture_free(&p);
    }
}

/* A roof: two faces at right angles that share an edge, seen from the front. */
TEST(flat_shows_facets)
{
    write_text("roof.obj", "v -1 -1 -1\nv 0 -1 0\nv 0 1 0\nv -1 1 -1\nv 1 -1 -1\nv 1 1 -1\n"
                           "f 1 2 3 4\nf 2 5 6 3\n");
    expect_rectangle("roof.obj " FRONT " --light -1,0,1 --size 20x20 --shader flat",
                     RECTANGLE(0, 0, 10, 20), 0xccccccff, 0x333333ff);
    /* Gouraud uses the ridge's mean normal instead: (0, 0, 1), N.L = sqrt(1/2). */
    picture p =
        drawn("roof.obj " FRONT " --light -1,0,1 --size 200x200 --shader gouraud --crease 91");
    expect_near(pixel(&p, 100, 100), 0x9f9f9fff, 3);
    picture_free(&p);
}

TEST(summary_says_what_was_drawn)
{
    write_text("red.obj", red_square);
    run r = good("render red.obj -o a.png --size 12x34");
    assert_string_equal(r.out, "a.png: 12x34, 2 triangles, Phong\n");
    write_text("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    r = good("render one.obj -o a.png --size 9x9 --shader flat");
    assert_string_equal(r.out, "a.png: 9x9, 1 triangle, flat\n");
}

/* Expects that the left part of a comparison is a picture, and that its other parts are equal and
 * black. */
static void expect_equal_parts(const char *comparison, const char *alone)
{
    picture c = picture_read(comparison), p = picture_read(alone);
    uint32_t count = 0;
    assert_int_equal(c.width, 3 * p.width);
    assert_int_equal(c.height, p.height);
    for (uint32_t y = 0; y < p.height; ++y) {
        for (uint32_t x = 0; x < p.width; ++x) {
            count += pixel(&p, x, y) != pixel(&p, 0, 0);
            assert_int_equal(pixel(&c, x, y), pixel(&p, x, y));
            assert_int_equal(pixel(&c, p.width + x, y), pixel(&p, x, y));
            assert_int_equal(pixel(&c, 2 * p.width + x, y), 0x000000ff);
        }
    }
    assert_true(count > 200);
    picture_free(&c);
    picture_free(&p);
}

TEST(compare_finds_equal_pictures)
{
    write_text("red.obj", red_square);
    run r = good("compare red.obj --size 50x40 -o c.png");
    expect_printed(&r, "colour: 0 of 2000 pixels differ\n");
    expect_printed(&r, "depth:  0 of 2000 pixels differ\n");
    expect_printed(&r, "OSMesa");
    expect_printed(&r, "\nc.png: Gnomon, OSMesa, difference\n");
    good("render red.obj --size 50x40 --samples 1 -o a.png");
    expect_equal_parts("c.png", "a.png");
}

TEST(compare_names_its_picture_after_the_model)
{
    good_shell("mkdir -p models.d");
    write_text("models.d/red.v2.obj", red_square);
    run r = good("compare models.d/red.v2.obj --size 20x10");
    expect_printed(&r, "\nred.v2_compared.png: Gnomon, OSMesa, difference\n");
    assert_false(exists("models.d/red.v2_compared.png"));
    picture p = picture_read("red.v2_compared.png");
    assert_int_equal(p.width, 60);
    picture_free(&p);
    /* With -o only that picture is written. */
    remove_file("red.v2_compared.png");
    good("compare models.d/red.v2.obj --size 20x10 -o c.png");
    assert_false(exists("red.v2_compared.png"));
}

TEST(demo_needs_no_file)
{
    run r = good("demo --size 160x120 --picture pot.png --tessellation 5");
    expect_printed(&r, "colour: 0 of 19200 pixels differ\n");
    expect_printed(&r, "depth:  0 of 19200 pixels differ\n");
    expect_equal_parts("gnomon-demo.png", "pot.png");
}

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
    run r = good("render square.obj -o a.png --size 16x16 --samples 1 " FRONT);
    assert_null(strstr(r.out, "covered"));
    r = good("render square.obj -o b.png --size 16x16 --samples 1 --statistics " FRONT);
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
    r = good_shell("gnomon render square.obj --size 16x16 --samples 1 --statistics " FRONT
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
