/* What the command draws of model files: opacity, maps, points, lines, far coordinates. The values
 * are those of the formats' specifications; how files are read is tested in tests/models. */
#include "runner.h"

#include <stb/stb_image_write.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A square at z = 0 and one behind it at z = -1, each with its material. */
static const char two_squares[] =
    "mtllib a.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\n"
    "v -1 1 -1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
    "usemtl front\nf 1/1/1 2/2/1 3/3/1 4/4/1\nusemtl back\nf 5/1/1 6/2/1 7/3/1 8/4/1\n";

static picture drawn(const char *model, const char *options)
{
    const run r = gnomon("render %s -o a.png --size 64x64 " FRONT " %s", model, options);
    if (r.status != 0)
        fail_msg("%s %s: status %d, %s", model, options, r.status, r.error);
    return picture_read("a.png");
}

/* Whether each channel of a pixel differs by at most `most` from 0xrrggbbaa. */
static void expect_pixel(const picture *p, uint32_t x, uint32_t y, uint32_t expected, int most)
{
    const uint32_t found = pixel(p, x, y);
    for (int shift = 0; shift < 32; shift += 8)
        if (abs((int)(found >> shift & 255) - (int)(expected >> shift & 255)) > most)
            fail_msg("pixel %u,%u is %08x, not %08x", (unsigned)x, (unsigned)y, (unsigned)found,
                     (unsigned)expected);
}

static void expect_color(const char *model, const char *options, uint32_t expected)
{
    picture p = drawn(model, options);
    expect_pixel(&p, 32, 32, expected, 1);
    picture_free(&p);
}

TEST(translucent_materials_are_blended)
{
    write_text("a.obj", two_squares);
    write_text("a.mtl", "newmtl front\nKd 1 0 0\nd 0.5\nnewmtl back\nKd 0 0 1\n");
    expect_color("a.obj", "--shader unlit", 0x800080ff);
    expect_color("a.obj", "--shader unlit --opaque", 0xff0000ff);
    write_text("a.mtl", "newmtl front\nKd 1 0 0\nTr 0.75\nnewmtl back\nKd 0 0 1\n");
    expect_color("a.obj", "--shader unlit", 0x4000bfff);
    /* The opaque square is drawn first although the file has it last; two translucent ones are
     * blended from back to front: half of red over half of blue over white. */
    write_text("a.mtl", "newmtl front\nKd 1 0 0\nd 0.5\nnewmtl back\nKd 0 0 1\nd 0.5\n");
    expect_color("a.obj", "--shader unlit --background ffffff", 0xbf407fff);
    expect_color("a.obj", "--shader unlit --background ffffff --eye 0,0,-5", 0x8040bfff);
    /* Alpha of the picture: what is behind shows through half and half again. */
    expect_color("a.obj", "--shader unlit --background 00000000", 0x800040bf);
}

/* The triangles of one part are sorted too: the nearer one comes first in the file. */
TEST(triangles_are_sorted)
{
    write_text("b.obj", "mtllib b.mtl\nusemtl glass\n"
                        "v -1 -1 0 1 0 0\nv 3 -1 0 1 0 0\nv -1 3 0 1 0 0\n"
                        "v -1 -1 -1 0 0 1\nv 3 -1 -1 0 0 1\nv -1 3 -1 0 0 1\nf 1 2 3\nf 4 5 6\n");
    write_text("b.mtl", "newmtl glass\nKd 1 1 1\nd 0.5\n");
    expect_color("b.obj", "--shader unlit --background ffffff", 0xbf407fff);
    expect_color("b.obj", "--shader unlit --background ffffff --eye 0,0,-5", 0x8040bfff);
    /* In perspective, and of a turned model. */
    const run r = gnomon("render b.obj --rotate y,180 -o a.png --size 64x64 --shader unlit "
                         "--background ffffff --eye 0,0,-5 --target 0,0,0 --fov 10");
    assert_int_equal(r.status, 0);
    picture p = picture_read("a.png");
    expect_pixel(&p, 32, 32, 0xbf407fff, 1);
    picture_free(&p);
}

/* A map of opacity, its channel, and alpha in a map of colours, which MTL does not know. */
TEST(maps_of_opacity_are_drawn)
{
    static const uint8_t half[2] = {128, 128}, red[4] = {255, 0, 0, 0};
    static const uint8_t channels[3] = {0, 255, 0};
    write_text("a.obj", two_squares);
    stbi_write_png(path_of("half.png"), 1, 2, 1, half, 0);
    stbi_write_png(path_of("red.png"), 1, 1, 4, red, 0);
    stbi_write_png(path_of("channels.png"), 1, 1, 3, channels, 0);
    write_text("a.mtl", "newmtl front\nKd 1 0 0\nmap_d half.png\nnewmtl back\nKd 0 0 1\n");
    expect_color("a.obj", "--shader unlit", 0x80007fff);
    write_text("a.mtl",
               "newmtl front\nmap_Kd red.png\nmap_d half.png\nKd 1 1 1\nnewmtl back\nKd 0 0 1\n");
    expect_color("a.obj", "--shader unlit", 0x80007fff);
    write_text("a.mtl", "newmtl front\nKd 1 0 0\nmap_d -imfchan r channels.png\n"
                        "newmtl back\nKd 0 0 1\n");
    expect_color("a.obj", "--shader unlit", 0x0000ffff);
    write_text("a.mtl", "newmtl front\nKd 1 0 0\nmap_d -imfchan g channels.png\n"
                        "newmtl back\nKd 0 0 1\n");
    expect_color("a.obj", "--shader unlit", 0xff0000ff);
    /* No hole: the alpha of the picture is the target's. */
    write_text("a.mtl", "newmtl front\nKd 1 1 1\nmap_Kd red.png\nnewmtl back\nKd 0 0 1\n");
    const run r = gnomon("render a.obj -o a.png --size 64x64 " FRONT " --shader unlit");
    assert_int_equal(r.status, 0);
    assert_non_null(strstr(r.error, "a.obj: warning: alpha in its diffuse map is not drawn"));
    assert_int_equal(lines(r.error), 1);
    picture p = picture_read("a.png");
    expect_pixel(&p, 32, 32, 0xff0000ff, 0);
    picture_free(&p);
}

/* The material's colour times the map's; but a map that the user names takes its place. */
TEST(maps_are_multiplied_by_the_material)
{
    static const uint8_t yellow[3] = {255, 255, 0};
    stbi_write_png(path_of("yellow.png"), 1, 1, 3, yellow, 0);
    write_text("a.obj", two_squares);
    write_text("a.mtl", "newmtl front\nKd 1 0.5 1\nmap_Kd yellow.png\nnewmtl back\nKd 0 0 1\n");
    expect_color("a.obj", "--shader unlit", 0xff8000ff);
    expect_color("a.obj", "--shader unlit --texture yellow.png", 0xffff00ff);
    expect_color("a.obj", "--shader unlit --texture none", 0xff80ffff);
}

/* Beside a map that does not repeat is the material's colour (MTL 4.2, -clamp on). */
TEST(clamped_maps_are_there_once)
{
    static const uint8_t green[3] = {0, 255, 0};
    stbi_write_png(path_of("green.png"), 1, 1, 3, green, 0);
    write_text("c.obj", "mtllib c.mtl\nusemtl m\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
                        "vt 0 0\nvt 2 0\nvt 2 2\nvt 0 2\nf 1/1 2/2 3/3 4/4\n");
    write_text("c.mtl", "newmtl m\nKd 1 1 1\nmap_Kd -clamp on green.png\n");
    picture p = drawn("c.obj", "--shader unlit --filter nearest");
    expect_pixel(&p, 16, 48, 0x00ff00ff, 0);
    expect_pixel(&p, 48, 48, 0xffffffff, 0);
    expect_pixel(&p, 48, 16, 0xffffffff, 0);
    picture_free(&p);
    write_text("c.mtl", "newmtl m\nKd 1 1 1\nmap_Kd green.png\n");
    expect_color("c.obj", "--shader unlit --filter nearest", 0x00ff00ff);
}

TEST(points_and_lines_are_drawn)
{
    write_text("p.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                        "property float y\nproperty float z\nproperty uchar red\n"
                        "property uchar green\nproperty uchar blue\nend_header\n"
                        "0 0 0 255 0 0\n0.5 0.5 0 0 0 255\n");
    picture p = drawn("p.ply", "--points=4");
    expect_pixel(&p, 32, 32, 0xff0000ff, 0);
    expect_pixel(&p, 48, 16, 0x0000ffff, 0);
    expect_pixel(&p, 16, 48, 0xedeeefff, 0);
    picture_free(&p);
    run r = gnomon("render p.ply -o a.png --size 64x64 " FRONT);
    assert_non_null(strstr(r.out, "a.png: 64x64, 2 points, "));
    assert_string_equal(r.error, "");
    r = gnomon("info p.ply");
    assert_non_null(strstr(r.out, "\n  points      2\n"));

    write_text("l.obj", "v -1 0 0 0 0 1\nv 1 0 0 0 0 1\nl 1 2\n");
    p = drawn("l.obj", "--points=4");
    expect_pixel(&p, 10, 32, 0x0000ffff, 0);
    expect_pixel(&p, 50, 32, 0x0000ffff, 0);
    expect_pixel(&p, 32, 10, 0xedeeefff, 0);
    picture_free(&p);
    r = gnomon("compare l.obj -o b.png --size 64x64 " FRONT);
    assert_int_equal(r.status, 0);
}

/* A disc of 8 triangles around a place, in steps that floats near that place do not have. */
static void write_disc(const char *name, double x, double y)
{
    char text[2048];
    static const double corners[8][2] = {{1, 0},  {0.71, 0.71},   {0, 1},  {-0.71, 0.71},
                                         {-1, 0}, {-0.71, -0.71}, {0, -1}, {0.71, -0.71}};
    size_t length = (size_t)snprintf(text, sizeof text, "v %.4f %.4f 120\n", x, y);
    for (int i = 0; i < 8; ++i)
        length += (size_t)snprintf(text + length, sizeof text - length, "v %.4f %.4f 120\n",
                                   x + corners[i][0], y + corners[i][1]);
    for (int i = 0; i < 8; ++i)
        length += (size_t)snprintf(text + length, sizeof text - length, "f 1 %d %d\n", 2 + i,
                                   2 + (i + 1) % 8);
    write_text(name, text);
}

/* Where 32-bit floats have steps of half a unit, models are drawn as at the origin. */
TEST(far_coordinates_are_exact)
{
    write_disc("near.obj", 0, 0);
    write_disc("far.obj", 500000, 4500000);
    assert_int_equal(gnomon("render near.obj -o near.png --size 64x64 --shader unlit").status, 0);
    run r = gnomon("render far.obj -o far.png --size 64x64 --shader unlit");
    assert_int_equal(r.status, 0);
    assert_string_equal(r.error, "");
    assert_int_equal(shell("cmp near.png far.png").status, 0);
    /* A camera in the model's coordinates, with a fraction that floats do not have there. */
    r = gnomon("render near.obj -o near.png --size 64x64 --eye 0.25,0.1,125 --target 0.25,0.1,0 "
               "--up 0,1,0");
    assert_int_equal(r.status, 0);
    r = gnomon("render far.obj -o far.png --size 64x64 --eye 500000.25,4500000.1,125 --target "
               "500000.25,4500000.1,0 --up 0,1,0");
    assert_int_equal(r.status, 0);
    r = gnomon("diff near.png far.png");
    assert_true(r.status == 0);
    /* Two models keep their distance. */
    write_disc("right.obj", 500002.5, 4500000);
    r = gnomon("render far.obj right.obj -o both.png --size 64x64");
    assert_int_equal(r.status, 0);
    r = gnomon("info far.obj");
    assert_non_null(strstr(r.out, "bounds      499999 4499999 120 to 500001 4500001 120"));
}

/* KHR_materials_unlit, and colours that are multiplied (glTF 2.0, section 3.7.2.1). */
TEST(materials_of_gltf_are_drawn)
{
    /* A triangle that covers the view, as three floats a vertex. */
    static const char head[] =
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
        "\"nodes\":[{\"mesh\":0}],\"buffers\":[{\"byteLength\":36,\"uri\":\"data:application/"
        "octet-stream;base64,AACAvwAAgL8AAAAAAABAQAAAgL8AAAAAAACAvwAAQEAAAAAA\"}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,"
        "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],\"meshes\":[{\"primitives\":[{"
        "\"attributes\":{\"POSITION\":0},\"material\":0}]}],\"materials\":[";
    static const struct {
        const char *material;
        const char *options;
        uint32_t expected;
    } rows[] = {
        {"{\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0,0,1]},"
         "\"extensions\":{\"KHR_materials_unlit\":{}}}",
         "", 0xff0000ff},
        {"{\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0,0,0.5]},\"alphaMode\":\"BLEND\"}",
         "--shader unlit --background 0000ff", 0x80007fff},
        {"{\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0,0,0.5]}}",
         "--shader unlit --background 0000ff", 0xff0000ff},
        {"{\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0,0,0.5]},\"alphaMode\":\"BLEND\"}",
         "--shader unlit --background 0000ff --opaque", 0xff0000ff},
    };
    char text[4096];
    for (size_t i = 0; i < COUNT(rows); ++i) {
        snprintf(text, sizeof text, "%s%s],\"extensionsUsed\":[\"KHR_materials_unlit\"]}", head,
                 rows[i].material);
        write_text("m.gltf", text);
        expect_color("m.gltf", rows[i].options, rows[i].expected);
    }
}

/* Writes a triangle that covers the view, of a white dielectric as rough as can be, under a number
 * of directional lights that are turned by a quaternion. */
static void write_lit(int lights, const char *rotation)
{
    char text[4096], nodes[2048] = "", numbers[64] = "";
    for (int i = 0; i < lights; ++i) {
        char *const end = nodes + strlen(nodes);
        snprintf(end, sizeof nodes - (size_t)(end - nodes),
                 ",{\"rotation\":[%s],\"extensions\":{\"KHR_lights_punctual\":{\"light\":0}}}",
                 rotation);
        sprintf(numbers + strlen(numbers), ",%d", i + 1);
    }
    snprintf(
        text, sizeof text,
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0%s]}],"
        "\"nodes\":[{\"mesh\":0}%s],\"buffers\":[{\"byteLength\":36,\"uri\":\"data:application/"
        "octet-stream;base64,AACAvwAAgL8AAAAAAABAQAAAgL8AAAAAAACAvwAAQEAAAAAA\"}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,"
        "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],\"meshes\":[{\"primitives\":[{"
        "\"attributes\":{\"POSITION\":0},\"material\":0}]}],\"materials\":[{"
        "\"pbrMetallicRoughness\":{\"metallicFactor\":0}}],"
        "\"extensionsUsed\":[\"KHR_lights_punctual\"],\"extensions\":{\"KHR_lights_punctual\":"
        "{\"lights\":[{\"type\":\"directional\",\"intensity\":7}]}}}",
        numbers, nodes);
    write_text("lit.gltf", text);
}

static void expect_words(const char *options, const char *words)
{
    const run r = gnomon("render lit.gltf -o a.png --size 64x64 " FRONT " %s", options);
    assert_int_equal(r.status, 0);
    if (strcmp(r.error, words) != 0)
        fail_msg("%s: %s", options, r.error);
}

/* The lights of the file take the place of the command's. Together they are as bright as it is at
 * the middle of the model: 0.75 pi, beside the ambient 0.25. By appendix B, at roughness 1, a light
 * along the normal N gives 0.75 * (0.96 + 0.04 / 4), one at 60 degrees half of 0.75 * (0.96 + 0.04
 * / 3), and the ambient light 0.25 * 1.04; then sRGB. */
TEST(lights_of_gltf_are_drawn)
{
    write_lit(1, "0,0,0,1");
    expect_color("lit.gltf", "", 0xfefefeff);
    write_lit(1, "0.5,0,0,0.8660254");
    expect_color("lit.gltf", "", 0xcfcfcfff);
    expect_words("", "");
    write_lit(1, "1,0,0,0");
    expect_color("lit.gltf", "", 0x8b8b8bff);
    expect_color("lit.gltf", "--light 0,0,1", 0xfefefeff);
    write_lit(8, "0.5,0,0,0.8660254");
    expect_color("lit.gltf", "", 0xcfcfcfff);
    expect_words("", "");
    write_lit(10, "0.5,0,0,0.8660254");
    expect_color("lit.gltf", "", 0xcfcfcfff);
    expect_words("", "gnomon: lit.gltf: warning: only the first 8 of its 10 lights are used\n");
    expect_words("--shader phong", "gnomon: lit.gltf: warning: its lights are not used: only "
                                   "--shader metallic-roughness takes them\n");
    expect_words("--shader phong --light 0,0,1", "");
    expect_words("--shader unlit", "");
}
