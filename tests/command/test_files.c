/* gnomon diff and gnomon info: counts worked by hand, files of all formats, and files that are
 * refused. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <png.h>
#include <stdio.h>
#include <string.h>

/* A PPM of 3x2 pixels: black but for one. */
static void write_ppm(const char *name, int red, int green, int blue)
{
    uint8_t bytes[11 + 18] = "P6\n3 2\n255\n";
    bytes[11 + 12] = (uint8_t)red;
    bytes[11 + 13] = (uint8_t)green;
    bytes[11 + 14] = (uint8_t)blue;
    write_bytes(name, bytes, sizeof bytes);
}

/* Runs gnomon and expects this status, the text on standard output, and nothing else. */
static run told(int status, const char *arguments, const char *text)
{
    run r = gnomon("%s", arguments);
    if (r.status != status || strstr(r.out, text) == NULL || r.error[0] != '\0')
        fail_run(&r);
    return r;
}

TEST(differences_are_counted)
{
    static const char *const orders[] = {"diff a.ppm b.ppm", "diff b.ppm a.ppm"};
    write_ppm("a.ppm", 0, 0, 0);
    write_ppm("b.ppm", 255, 6, 0);
    run r = told(0, "diff a.ppm a.ppm", "0 of 6 pixels differ\n");
    assert_int_equal(lines(r.out), 1);
    for (int i = 0; i < 2; ++i)
        told(1, orders[i],
             "1 of 6 pixels differ\n"
             "channel      pixels     largest        mean, in steps of 1/255\n"
             "red               1         255        42.5\n"
             "green             1           6           1\n"
             "blue              0           0           0\n"
             "alpha             0           0           0\n"
             "first difference at x 1, y 1 (from the upper left)\n");
}

TEST(heat_shows_differences)
{
    write_ppm("a.ppm", 0, 0, 0);
    write_ppm("b.ppm", 0, 0, 255);
    write_ppm("c.ppm", 0, 1, 0);
    told(1, "diff a.ppm b.ppm -o heat.png", "1 of 6 pixels differ");
    picture p = picture_read("heat.png");
    assert_true(p.width == 3 && p.height == 2);
    expect_inside(&p, RECTANGLE(1, 1, 2, 2), 0xffffffff, 0x000000ff);
    picture_free(&p);
    told(1, "diff a.ppm c.ppm -o heat.png", "1 of 6 pixels differ");
    p = picture_read("heat.png");
    const uint32_t least = pixel(&p, 1, 1);
    assert_true(least >> 24 > 150 && (least & 0xffff00) == 0);
    picture_free(&p);
    run r = good_shell("set -e; gnomon diff a.ppm a.ppm -o heat.tga; gnomon diff a.ppm a.ppm -o - "
                       "--format ppm | cmp - a.ppm");
    assert_non_null(strstr(r.error, "0 of 6 pixels differ"));
    assert_true(exists("heat.tga"));
}

static void write_deep_png(const char *name, uint16_t value)
{
    const uint8_t bytes[4] = {0, 0, (uint8_t)(value >> 8), (uint8_t)value};
    FILE *file = fopen(path_of(name), "wb");
    assert_non_null(file);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    if (setjmp(png_jmpbuf(png)) != 0)
        fail_msg("%s cannot be written", name);
    png_init_io(png, file);
    png_set_IHDR(png, info, 2, 1, 16, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    png_write_row(png, bytes);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    fclose(file);
}

/* All 16 bits count. A picture of 8 bits is compared on the scale of 16. */
TEST(deep_pictures_keep_their_bits)
{
    static const uint8_t pgm[] = "P5 2 # width and height\n1\n255\n\0\2";
    write_deep_png("d.png", 514);
    write_deep_png("e.png", 513);
    write_bytes("f.pgm", pgm, sizeof pgm - 1);
    told(1, "diff d.png e.png",
         "in steps of 1/65535\nred               1           1         0.5\n");
    told(0, "diff d.png f.pgm", "0 of 2 pixels differ\n");
    told(0, "info d.png f.pgm",
         "d.png: PNG picture\n  size        2x1\n  channels    1: grey\n"
         "  bits        16 a channel\n"
         "f.pgm: PPM picture\n  size        2x1\n  channels    1: grey\n"
         "  bits        8 a channel\n");
}

/* What render writes in each format is read again. */
TEST(written_pictures_are_read)
{
    run r = good_shell("set -e; for f in png tga ppm; do gnomon render square.obj -o p.$f --size "
                       "33x20 --shader normals --rotate 1,2,3,40; done; gnomon diff p.png p.tga; "
                       "gnomon diff p.ppm p.tga; gnomon info p.tga");
    expect_printed(&r, "channels    4: red, green, blue, alpha");
    expect_printed(&r, "p.tga: TGA picture\n  size        33x20\n");
    good("render square.obj -o p.png --size 33x20 --background 11223344");
    good("render square.obj -o q.png --size 33x20 --background 11223345");
    r = told(1, "diff p.png q.png", "red               0 ");
    assert_null(strstr(r.out, "alpha             0 "));
}

TEST(pictures_that_cannot_be_compared_are_status_2)
{
    static const refusal pictures[] = {
        {"", "it takes two pictures, not 1"},
        {"a.ppm a.ppm", "it takes two pictures, not 3"},
        {"a.ppm --size 3x2", "unknown option '--size'"},
        {"a.ppm --format png", "--format ... -o"},
        {"nothing.png", "nothing.png: ... No such file"},
        {"noise.png", "noise.png: ... PNG, JPEG, TGA, BMP or PPM"},
        {"empty.png", "empty.png: ... empty"},
        {"wide.ppm", "wide.ppm: has 6x1 pixels, and 'a.ppm' has 3x2"},
        {"short.ppm", "short.ppm: ... cut short"},
        {"wrong.ppm", "wrong.ppm: ... damaged"},
        {"sixteen.ppm", "sixteen.ppm: ... 255"},
        {"huge.ppm", "huge.ppm: ... --map-pixels 64"},
        {"huge.ppm --map-pixels 256 --import-output 4000", "huge.ppm: ... cut short"},
        {"larger.ppm", "larger.ppm: ... larger than 16384"},
        {". ", ".: ... directory"},
        {"/dev/zero", "/dev/zero: ... a device"},
        {"a.ppm -o ./a.ppm", "a.ppm: ... overwritten"},
        {"a.ppm -o heat.jpg", "heat.jpg: ... .png, .tga or .ppm"},
        {"nothing.ppm -o nowhere/heat.png", "nowhere/heat.png: ... No such file"},
        {"a.ppm -o /dev/full", "/dev/full: ... No space"},
    };
    write_ppm("a.ppm", 0, 0, 0);
    write_text("noise.png", "this is no picture");
    write_text("empty.png", "");
    write_text("sixteen.ppm", "P6 1 1 65535\n123456");
    write_text("huge.ppm", "P6 16384 16384 255\n");
    write_text("larger.ppm", "P6 99999999999999999999 1 255\n1");
    write_text("wrong.ppm", "P6 x 1 255\n1");
    write_text("short.ppm", "P6 1");
    write_text("wide.ppm", "P6 6 1 255\n123456789012345678");
    EXPECT_EACH(2, "diff a.ppm", pictures);
    expect(2, "diff nothing.png a.ppm", "nothing.png ... No such file");
    expect_shell(2, "gnomon diff a.ppm a.ppm >/dev/full", "");
}

TEST(models_are_described)
{
    static const char mtl[] = "newmtl red\nKd 1 0 0\nmap_Kd red.ppm\nnewmtl blue\nKd 0 0 1\n"
                              "newmtl unused\nKd 0 1 0\n";
    static const char obj[] = "mtllib two.mtl\nv -1 0 0\nv 1 0 0\nv 1 2.5 0\nv 0 0 -4\nv 9 9 9\n"
                              "vt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\n"
                              "usemtl red\nf 1/1/1 2/2/1 3/3/1\nusemtl blue\nf 1//1 2//1 4//1\n";
    write_text("two.mtl", mtl);
    write_text("two.obj", obj);
    write_ppm("red.ppm", 255, 0, 0);
    told(0, "info two.obj",
         "two.obj: OBJ model\n"
         "  triangles   2\n"
         "  vertices    6\n"
         "  bounds      -1 0 -4 to 1 2.5 0\n"
         "  size        2 2.5 4\n"
         "  attributes  positions, normals, texture coordinates (of 3 vertices)\n"
         "  materials   2\n"
         "  draws       2\n"
         "  maps        diffuse red.ppm (3x2)\n");
    remove_file("red.ppm");
    told(0, "info two.obj",
         "  maps        diffuse red.ppm (cannot be read: No such file or directory)\n");
    write_text("red.ppm", "noise");
    write_text("two_glow.png", "");
    told(0, "info two.obj",
         "  maps        diffuse red.ppm (cannot be read: it is not a PNG, JPEG, TGA, BMP or "
         "PPM), glow two_glow.png (cannot be read: the file is empty)\n");
    write_text("bare.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                           "property float y\nproperty float z\nproperty uchar red\n"
                           "property uchar green\nproperty uchar blue\nelement face 1\n"
                           "property list uchar int vertex_indices\nend_header\n"
                           "0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n3 0 1 2\n");
    run r = told(0, "info bare.ply", "bare.ply: PLY model\n  triangles   1\n  vertices    3\n");
    expect_printed(&r, "attributes  positions, vertex colours\n");
    expect_printed(&r, "maps        none\n");
}

/* A file that cannot be read does not hide the others. */
TEST(files_that_cannot_be_read_are_named)
{
    write_text("noise.txt", "noise");
    expect(2, "info", "no file ... info --help");
    expect(2, "info square.obj -o a.png", "'-o' ... unknown option");
    expect(1, "info noise.txt", "noise.txt ... not a PNG");
    expect(1, "info nothing.obj", "nothing.obj ... No such file");
    run r = gnomon("info nothing.obj square.obj noise.txt");
    assert_int_equal(r.status, 1);
    assert_int_equal(lines(r.error), 2);
    expect_printed(&r, "square.obj: OBJ model\n  triangles   2\n");
    if (!little_memory_works())
        return;
    write_grid("many.obj", 300);
    expect(1, "info many.obj --import-memory 1", "many.obj ... --import-memory");
}

/* A BMP whose height is negative has its upper row first. */
TEST(bmp_may_begin_at_the_top)
{
    enum { ROW = 8, HEIGHT = 3, HEADER = 54 };
    uint8_t bmp[HEADER + ROW * HEIGHT] = {'B',    'M', sizeof bmp, 0, 0,  0, 0, 0, 0, 0,
                                          HEADER, 0,   0,          0, 40, 0, 0, 0, 2, 0,
                                          0,      0,   HEIGHT,     0, 0,  0, 1, 0, 24};
    uint8_t rows[HEIGHT][ROW] = {{1, 2, 3, 40, 50, 60}, {90, 80, 70}, {0, 0, 0, 200, 0, 100}};
    for (int i = 0; i < HEIGHT; ++i)
        memcpy(bmp + HEADER + ROW * i, rows[HEIGHT - 1 - i], ROW);
    write_bytes("up.bmp", bmp, sizeof bmp);
    bmp[22] = 256 - HEIGHT;
    bmp[23] = bmp[24] = bmp[25] = 255;
    memcpy(bmp + HEADER, rows, sizeof rows);
    write_bytes("down.bmp", bmp, sizeof bmp);
    told(0, "info down.bmp", "down.bmp: BMP picture\n  size        2x3\n");
    told(0, "diff up.bmp down.bmp", "0 of 6 pixels differ\n");
    good_shell("for i in up down; do gnomon render square.obj --texture $i.bmp -o $i.png --size "
               "8x8 || exit; done; cmp up.png down.png");
    /* -2^31 has no magnitude of 32 bits with a sign. */
    bmp[22] = bmp[23] = bmp[24] = 0;
    bmp[25] = 128;
    write_bytes("down.bmp", bmp, sizeof bmp);
    expect(1, "info down.bmp", "down.bmp ... larger than 16384");
}

/* Alpha of a TGA without attribute bits has no meaning (Truevision TGA 2.0, field 5.6). */
TEST(tga_has_the_channels_that_it_says)
{
    uint8_t tga[18 + 4] = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 32};
    write_bytes("one.tga", tga, sizeof tga);
    told(0, "info one.tga", "  channels    3: red, green, blue\n");
    tga[17] = 8;
    write_bytes("two.tga", tga, sizeof tga);
    told(0, "info two.tga", "  channels    4: red, green, blue, alpha\n");
    told(1, "diff one.tga two.tga", "alpha             1         255");
}

/* A map may be a PPM; its upper row is the texture's upper row. */
TEST(maps_may_be_ppm)
{
    write_text("map.ppm", "P6 1 2 255\n\377\1\1\1\1\377");
    picture p =
        drawn("square.obj --texture map.ppm --filter nearest --shader unlit --size 8x8 " FRONT);
    expect_near(pixel(&p, 4, 1), 0xff0101ff, 1);
    expect_near(pixel(&p, 4, 6), 0x0101ffff, 1);
    picture_free(&p);
}
