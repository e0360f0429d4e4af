/* What the command draws of model files: opacity, maps, points, lines, far coordinates. The values
 * are those of the formats' specifications; how files are read is tested in tests/models. */
#include "runner.h"

#include <stb/stb_image_write.h>
#include <stdio.h>
#include <string.h>

/* A square at z = 0 and one behind it at z = -1, each with its material. */
static const char two_squares[] =
    "mtllib a.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\n"
    "v -1 1 -1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
    "usemtl front\nf 1/1/1 2/2/1 3/3/1 4/4/1\nusemtl back\nf 5/1/1 6/2/1 7/3/1 8/4/1\n";

TEST(translucent_materials_are_blended)
{
    write_text("a.obj", two_squares);
    write_text("a.mtl", "newmtl front\nKd 1 0 0\nd 0.5\nnewmtl back\nKd 0 0 1\n");
    expect_color("a.obj --shader unlit", 0x800080ff);
    expect_color("a.obj --shader unlit --opaque", 0xff0000ff);
    write_text("a.mtl", "newmtl front\nKd 1 0 0\nTr 0.75\nnewmtl back\nKd 0 0 1\n");
    expect_color("a.obj --shader unlit", 0x4000bfff);
    /* The opaque square is drawn first although the file has it last; two translucent ones are
     * blended from back to front: half of red over half of blue over white. */
    write_text("a.mtl", "newmtl front\nKd 1 0 0\nd 0.5\nnewmtl back\nKd 0 0 1\nd 0.5\n");
    expect_color("a.obj --shader unlit --background ffffff", 0xbf407fff);
    expect_color("a.obj --shader unlit --background ffffff --eye 0,0,-5", 0x8040bfff);
    /* Alpha of the picture: what is behind shows through half and half again. */
    expect_color("a.obj --shader unlit --background 00000000", 0x800040bf);
}

/* The triangles of one part are sorted too: the nearer one comes first in the file. */
TEST(triangles_are_sorted)
{
    write_text("b.obj", "mtllib b.mtl\nusemtl glass\n"
                        "v -1 -1 0 1 0 0\nv 3 -1 0 1 0 0\nv -1 3 0 1 0 0\n"
                        "v -1 -1 -1 0 0 1\nv 3 -1 -1 0 0 1\nv -1 3 -1 0 0 1\nf 1 2 3\nf 4 5 6\n");
    write_text("b.mtl", "newmtl glass\nKd 1 1 1\nd 0.5\n");
    expect_color("b.obj --shader unlit --background ffffff", 0xbf407fff);
    expect_color("b.obj --shader unlit --background ffffff --eye 0,0,-5", 0x8040bfff);
    /* In perspective, and of a turned model. */
    picture p = drawn("b.obj --rotate y,180 --size 64x64 --shader unlit --background ffffff "
                      "--eye 0,0,-5 --target 0,0,0 --fov 10");
    expect_near(pixel(&p, 32, 32), 0xbf407fff, 1);
    picture_free(&p);
}

/* A map of opacity, its channel, and alpha in a map of colours, which MTL does not know. */
TEST(maps_of_opacity_are_drawn)
{
    static const struct {
        const char *front;
        uint32_t color;
    } materials[] = {{"Kd 1 0 0\nmap_d half.ppm", 0x80007fff},
                     {"map_Kd red.png\nmap_d half.ppm\nKd 1 1 1", 0x80007fff},
                     {"Kd 1 0 0\nmap_d -imfchan r green.ppm", 0x0000ffff},
                     {"Kd 1 0 0\nmap_d -imfchan g green.ppm", 0xff0000ff}};
    static const uint8_t red[4] = {255, 0, 0, 0};
    write_text("a.obj", two_squares);
    write_color("half.ppm", 128, 128, 128);
    write_color("green.ppm", 0, 255, 0);
    stbi_write_png(path_of("red.png"), 1, 1, 4, red, 0);
    for (size_t i = 0; i < COUNT(materials); ++i) {
        char text[128];
        snprintf(text, sizeof text, "newmtl front\n%s\nnewmtl back\nKd 0 0 1\n",
                 materials[i].front);
        write_text("a.mtl", text);
        expect_color("a.obj --shader unlit", materials[i].color);
    }
    /* No hole: the alpha of the picture is the target's. */
    write_text("a.mtl", "newmtl front\nKd 1 1 1\nmap_Kd red.png\nnewmtl back\nKd 0 0 1\n");
    const run r = good("render a.obj -o a.png --size 8x8 " FRONT " --shader unlit");
    assert_non_null(strstr(r.error, "a.obj: warning: alpha in its diffuse map is not drawn"));
    assert_int_equal(lines(r.error), 1);
    picture p = picture_read("a.png");
    expect_inside(&p, RECTANGLE(0, 0, 8, 8), 0xff0000ff, 0);
    picture_free(&p);
}

/* The material's colour times the map's; but a map that the user names takes its place. */
TEST(maps_are_multiplied_by_the_material)
{
    write_color("yellow.png", 255, 255, 0);
    write_text("a.obj", two_squares);
    write_text("a.mtl", "newmtl front\nKd 1 0.5 1\nmap_Kd yellow.png\nnewmtl back\nKd 0 0 1\n");
    expect_color("a.obj --shader unlit", 0xff8000ff);
    expect_color("a.obj --shader unlit --texture yellow.png", 0xffff00ff);
    expect_color("a.obj --shader unlit --texture none", 0xff80ffff);
}

/* Beside a map that does not repeat is the material's colour (MTL 4.2, -clamp on). */
TEST(clamped_maps_are_there_once)
{
    write_color("green.png", 0, 255, 0);
    write_text("c.obj", "mtllib c.mtl\nusemtl m\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
                        "vt 0 0\nvt 2 0\nvt 2 2\nvt 0 2\nf 1/1 2/2 3/3 4/4\n");
    write_text("c.mtl", "newmtl m\nKd 1 1 1\nmap_Kd -clamp on green.png\n");
    expect_rectangle("c.obj " FRONT " --size 64x64 --shader unlit --filter nearest",
                     RECTANGLE(0, 32, 32, 64), 0x00ff00ff, 0xffffffff);
    write_text("c.mtl", "newmtl m\nKd 1 1 1\nmap_Kd green.png\n");
    expect_color("c.obj --shader unlit --filter nearest", 0x00ff00ff);
}

TEST(points_and_lines_are_drawn)
{
    write_text("p.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                        "property float y\nproperty float z\nproperty uchar red\n"
                        "property uchar green\nproperty uchar blue\nend_header\n"
                        "0 0 0 255 0 0\n0.5 0.5 0 0 0 255\n");
    picture p = drawn("p.ply --points=4 --size 64x64 " FRONT);
    assert_int_equal(pixel(&p, 32, 32), 0xff0000ff);
    assert_int_equal(pixel(&p, 48, 16), 0x0000ffff);
    assert_int_equal(pixel(&p, 16, 48), BACKGROUND);
    picture_free(&p);
    run r = good("render p.ply -o a.png --size 64x64 " FRONT);
    expect_printed(&r, "a.png: 64x64, 2 points, ");
    assert_string_equal(r.error, "");
    r = good("info p.ply");
    expect_printed(&r, "\n  points      2\n");

    write_text("l.obj", "v -1 0 0 0 0 1\nv 1 0 0 0 0 1\nl 1 2\n");
    expect_rectangle("l.obj --points=4 --size 64x64 " FRONT, RECTANGLE(0, 30, 64, 34), 0x0000ffff,
                     BACKGROUND);
    good("compare l.obj -o b.png --size 64x64 " FRONT);
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
    good("render near.obj -o near.png --size 64x64 --shader unlit");
    run r = good("render far.obj -o far.png --size 64x64 --shader unlit");
    assert_string_equal(r.error, "");
    expect_same_files("near.png", "far.png");
    /* A camera in the model's coordinates, with a fraction that floats do not have there. */
    good("render near.obj -o near.png --size 64x64 --eye 0.25,0.1,125 --target 0.25,0.1,0 "
         "--up 0,1,0");
    good("render far.obj -o far.png --size 64x64 --eye 500000.25,4500000.1,125 --target "
         "500000.25,4500000.1,0 --up 0,1,0");
    good("diff near.png far.png");
    /* Two models keep their distance. */
    write_disc("right.obj", 500002.5, 4500000);
    good("render far.obj right.obj -o both.png --size 64x64");
    r = good("info far.obj");
    expect_printed(&r, "bounds      499999 4499999 120 to 500001 4500001 120");
}

/* Writes a triangle that covers the view, with this material, nodes beside its own, the numbers of
 * these in the scene, and lights of the document. */
static void write_gltf(const char *name, const char *material, const char *nodes,
                       const char *numbers)
{
    char text[4096];
    snprintf(
        text, sizeof text,
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0%s]}],"
        "\"nodes\":[{\"mesh\":0}%s],\"buffers\":[{\"byteLength\":36,\"uri\":\"data:application/"
        "octet-stream;base64,AACAvwAAgL8AAAAAAABAQAAAgL8AAAAAAACAvwAAQEAAAAAA\"}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,"
        "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],\"meshes\":[{\"primitives\":[{"
        "\"attributes\":{\"POSITION\":0},\"material\":0}]}],\"materials\":[%s],"
        "\"extensionsUsed\":[\"KHR_materials_unlit\",\"KHR_lights_punctual\"],\"extensions\":{"
        "\"KHR_lights_punctual\":{\"lights\":[{\"type\":\"directional\",\"intensity\":7}]}}}",
        numbers, nodes, material);
    write_text(name, text);
}

/* KHR_materials_unlit, and colours that are multiplied (glTF 2.0, section 3.7.2.1). */
TEST(materials_of_gltf_are_drawn)
{
    static const char blended[] =
        "{\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0,0,0.5]},\"alphaMode\":\"BLEND\"}";
    write_gltf("m.gltf",
               "{\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0,0,1]},"
               "\"extensions\":{\"KHR_materials_unlit\":{}}}",
               "", "");
    expect_color("m.gltf", 0xff0000ff);
    write_gltf("m.gltf", "{\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0,0,0.5]}}", "", "");
    expect_color("m.gltf --shader unlit --background 0000ff", 0xff0000ff);
    write_gltf("m.gltf", blended, "", "");
    expect_color("m.gltf --shader unlit --background 0000ff", 0x80007fff);
    expect_color("m.gltf --shader unlit --background 0000ff --opaque", 0xff0000ff);
}

/* A white dielectric as rough as can be, under a number of directional lights that are turned by a
 * quaternion. The picture has this grey, and the warning follows. */
static void expect_lit(int lights, const char *rotation, const char *options, uint32_t color,
                       const char *warning)
{
    char nodes[2048] = "", numbers[64] = "";
    for (int i = 0; i < lights; ++i) {
        char *const end = nodes + strlen(nodes);
        snprintf(end, sizeof nodes - (size_t)(end - nodes),
                 ",{\"rotation\":[%s],\"extensions\":{\"KHR_lights_punctual\":{\"light\":0}}}",
                 rotation);
        sprintf(numbers + strlen(numbers), ",%d", i + 1);
    }
    write_gltf("lit.gltf", "{\"pbrMetallicRoughness\":{\"metallicFactor\":0}}", nodes, numbers);
    const run r = good("render lit.gltf -o b.png --size 8x8 " FRONT " %s", options);
    if (strcmp(r.error, warning) != 0)
        fail_run(&r);
    picture p = picture_read("b.png");
    expect_near(pixel(&p, 4, 4), color, color != 0 ? 1 : 255);
    picture_free(&p);
}

/* The lights of the file take the place of the command's. Together they are as bright as it is at
 * the middle of the model: 0.75 pi, beside the ambient 0.25. By appendix B, at roughness 1, a light
 * along the normal N gives 0.75 * (0.96 + 0.04 / 4), one at 60 degrees half of 0.75 * (0.96 + 0.04
 * / 3), and the ambient light 0.25 * 1.04; then sRGB. */
TEST(lights_of_gltf_are_drawn)
{
    static const char sixty[] = "0.5,0,0,0.8660254";
    static const char unused[] =
        "gnomon: lit.gltf: warning: its lights are not used: only --shader "
        "metallic-roughness takes them\n";
    expect_lit(1, "0,0,0,1", "", 0xfefefeff, "");
    expect_lit(1, sixty, "", 0xcfcfcfff, "");
    expect_lit(1, "1,0,0,0", "", 0x8b8b8bff, "");
    expect_lit(1, "1,0,0,0", "--light 0,0,1", 0xfefefeff, "");
    expect_lit(8, sixty, "", 0xcfcfcfff, "");
    expect_lit(10, sixty, "", 0xcfcfcfff,
               "gnomon: lit.gltf: warning: only the first 8 of its 10 lights are used\n");
    expect_lit(10, sixty, "--shader phong", 0, unused);
    expect_lit(10, sixty, "--shader phong --light 0,0,1", 0, "");
    expect_lit(10, sixty, "--shader unlit", 0, "");
}
