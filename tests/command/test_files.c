/* gnomon diff and gnomon info: counts worked by hand, files of all formats, and files that are
 * refused. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* A PPM of 3x2 pixels: black but for one. */
static void write_ppm(const char *name, int red, int green, int blue)
{
    uint8_t bytes[11 + 18] = "P6\n3 2\n255\n";
    bytes[11 + 12] = (uint8_t)red;
    bytes[11 + 13] = (uint8_t)green;
    bytes[11 + 14] = (uint8_t)blue;
    write_bytes(name, bytes, sizeof bytes);
}

static void expect_out(const run *r, int status, const char *text)
{
    if (r->status != status || strstr(r->out, text) == NULL || r->error[0] != '\0')
        fail_msg("status %d, expected %d and\n%s\ngot\n%s%s", r->status, status, text, r->out,
                 r->error);
}

TEST(differences_are_counted)
{
    write_ppm("a.ppm", 0, 0, 0);
    write_ppm("b.ppm", 255, 6, 0);
    run r = gnomon("diff a.ppm a.ppm");
    expect_out(&r, 0, "0 of 6 pixels differ\n");
    assert_int_equal(lines(r.out), 1);
    for (int i = 0; i < 2; ++i) {
        r = gnomon(i == 0 ? "diff a.ppm b.ppm" : "diff b.ppm a.ppm");
        expect_out(&r, 1,
                   "1 of 6 pixels differ\n"
                   "channel      pixels     largest        mean, in steps of 1/255\n"
                   "red               1         255        42.5\n"
                   "green             1           6           1\n"
                   "blue              0           0           0\n"
                   "alpha             0           0           0\n"
                   "first difference at x 1, y 1 (from the upper left)\n");
    }
}

TEST(heat_shows_differences)
{
    write_ppm("a.ppm", 0, 0, 0);
    write_ppm("b.ppm", 0, 0, 255);
    write_ppm("c.ppm", 0, 1, 0);
    run r = gnomon("diff a.ppm b.ppm -o heat.png");
    expect_out(&r, 1, "1 of 6 pixels differ");
    picture p = picture_read("heat.png");
    assert_int_equal(p.width, 3);
    assert_int_equal(p.height, 2);
    for (uint32_t i = 0; i < 6; ++i)
        assert_int_equal(pixel(&p, i % 3, i / 3), i == 4 ? 0xffffffff : 0x000000ff);
    picture_free(&p);
    r = gnomon("diff a.ppm c.ppm -o heat.png");
    p = picture_read("heat.png");
    const uint32_t least = pixel(&p, 1, 1);
    assert_true(least >> 24 > 150 && (least & 0xffff00) == 0);
    picture_free(&p);
    r = shell("set -e; \"$GNOMON\" diff a.ppm a.ppm -o heat.tga; \"$GNOMON\" diff a.ppm a.ppm -o - "
              "--format ppm | cmp - a.ppm");
    assert_int_equal(r.status, 0);
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
    run r = gnomon("diff d.png e.png");
    expect_out(&r, 1, "in steps of 1/65535\nred               1           1         0.5\n");
    r = gnomon("diff d.png f.pgm");
    expect_out(&r, 0, "0 of 2 pixels differ\n");
    r = gnomon("info d.png f.pgm");
    expect_out(&r, 0,
               "d.png: PNG picture\n  size        2x1\n  channels    1: grey\n"
               "  bits        16 a channel\n"
               "f.pgm: PPM picture\n  size        2x1\n  channels    1: grey\n"
               "  bits        8 a channel\n");
}

/* What render writes in each format is read again. */
TEST(written_pictures_are_read)
{
    write_text("square.obj", square_obj);
    run r = shell("set -e; for f in png tga ppm; do \"$GNOMON\" render square.obj -o p.$f --size "
                  "33x20 --shader normals --rotate 1,2,3,40; done; \"$GNOMON\" diff p.png p.tga; "
                  "\"$GNOMON\" diff p.ppm p.tga; \"$GNOMON\" info p.tga");
    expect_out(&r, 0, "channels    4: red, green, blue, alpha");
    assert_non_null(strstr(r.out, "p.tga: TGA picture\n  size        33x20\n"));
    r = gnomon("render square.obj -o p.png --size 33x20 --background 11223344");
    r = gnomon("render square.obj -o q.png --size 33x20 --background 11223345");
    r = gnomon("diff p.png q.png");
    assert_int_equal(r.status, 1);
    assert_non_null(strstr(r.out, "red               0 "));
    assert_null(strstr(r.out, "alpha             0 "));
}

TEST(pictures_that_cannot_be_compared_are_status_2)
{
    write_ppm("a.ppm", 0, 0, 0);
    write_bytes("wide.ppm", "P6 6 1 255\n", 11);
    write_text("noise.png", "this is no picture");
    write_text("empty.png", "");
    write_text("sixteen.ppm", "P6 1 1 65535\n123456");
    write_text("huge.ppm", "P6 16384 16384 255\n");
    write_text("larger.ppm", "P6 99999999999999999999 1 255\n1");
    write_text("wrong.ppm", "P6 x 1 255\n1");
    write_text("short.ppm", "P6 1");
    expect(2, "diff a.ppm", "two pictures", "not 1");
    expect(2, "diff a.ppm a.ppm a.ppm", "two pictures", "not 3");
    expect(2, "diff a.ppm a.ppm --size 3x2", "--size", "unknown option");
    expect(2, "diff a.ppm a.ppm --format png", "--format", "-o");
    expect(2, "diff a.ppm nothing.png", "nothing.png", "No such file");
    expect(2, "diff nothing.png a.ppm", "nothing.png", "No such file");
    expect(2, "diff a.ppm noise.png", "noise.png", "PNG, JPEG, TGA, BMP or PPM");
    expect(2, "diff a.ppm empty.png", "empty.png", "empty");
    expect(2, "diff a.ppm wide.ppm", "wide.ppm", "cut short");
    expect(2, "diff a.ppm short.ppm", "short.ppm", "cut short");
    expect(2, "diff a.ppm wrong.ppm", "wrong.ppm", "damaged");
    expect(2, "diff a.ppm sixteen.ppm", "sixteen.ppm", "255");
    expect(2, "diff a.ppm huge.ppm", "huge.ppm", "--map-pixels 64");
    expect(2, "diff a.ppm huge.ppm --map-pixels 256 --import-output 4000", "huge.ppm", "cut short");
    expect(2, "diff a.ppm larger.ppm", "larger.ppm", "larger than 16384");
    expect(2, "diff a.ppm . ", ".", "directory");
    expect(2, "diff a.ppm /dev/zero", "/dev/zero", "a device");
    expect(2, "diff a.ppm a.ppm -o ./a.ppm", "a.ppm", "overwritten");
    expect(2, "diff a.ppm a.ppm -o heat.jpg", "heat.jpg", ".png, .tga or .ppm");
    expect(2, "diff nothing.ppm a.ppm -o nowhere/heat.png", "nowhere/heat.png", "No such file");
    expect(2, "diff a.ppm a.ppm -o /dev/full", "/dev/full", "No space");
    write_bytes("wide.ppm", "P6 6 1 255\n123456789012345678", 29);
    expect(2, "diff a.ppm wide.ppm -o heat.png", "wide.ppm", "has 6x1 pixels, and 'a.ppm' has 3x2");
    run r = shell("\"$GNOMON\" diff a.ppm a.ppm >/dev/full");
    assert_int_equal(r.status, 2);
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
    run r = gnomon("info two.obj");
    expect_out(&r, 0,
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
    r = gnomon("info two.obj");
    expect_out(&r, 0,
               "  maps        diffuse red.ppm (cannot be read: No such file or directory)\n");
    write_text("red.ppm", "noise");
    write_bytes("two_glow.png", "", 0);
    r = gnomon("info two.obj");
    expect_out(&r, 0,
               "  maps        diffuse red.ppm (cannot be read: it is not a PNG, JPEG, TGA, BMP or "
               "PPM), glow two_glow.png (cannot be read: the file is empty)\n");
    remove_file("two_glow.png");
    write_text("bare.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                           "property float y\nproperty float z\nproperty uchar red\n"
                           "property uchar green\nproperty uchar blue\nelement face 1\n"
                           "property list uchar int vertex_indices\nend_header\n"
                           "0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n3 0 1 2\n");
    r = gnomon("info bare.ply");
    expect_out(&r, 0, "bare.ply: PLY model\n  triangles   1\n  vertices    3\n");
    assert_non_null(strstr(r.out, "attributes  positions, vertex colours\n"));
    assert_non_null(strstr(r.out, "maps        none\n"));
}

/* A file that cannot be read does not hide the others. */
TEST(files_that_cannot_be_read_are_named)
{
    write_text("square.obj", square_obj);
    write_text("noise.txt", "noise");
    expect(2, "info", "no file", "info --help");
    expect(2, "info square.obj -o a.png", "'-o'", "unknown option");
    expect(1, "info noise.txt", "noise.txt", "not a PNG");
    expect(1, "info nothing.obj", "nothing.obj", "No such file");
    run r = gnomon("info nothing.obj square.obj noise.txt");
    assert_int_equal(r.status, 1);
    assert_int_equal(lines(r.error), 2);
    assert_non_null(strstr(r.out, "square.obj: OBJ model\n  triangles   2\n"));
    if (!little_memory_works())
        return;
    static char many[1 << 20];
    for (size_t i = 0; i + 10 < sizeof many; i += 10)
        memcpy(many + i, "v 0 0 100\n", 11);
    write_text("many.obj", many);
    r = gnomon("info many.obj --import-memory 1");
    assert_int_equal(r.status, 1);
    assert_int_equal(lines(r.error), 1);
    assert_non_null(strstr(r.error, "--import-memory"));
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
    write_text("square.obj", square_obj);
    run r = gnomon("info down.bmp");
    expect_out(&r, 0, "down.bmp: BMP picture\n  size        2x3\n");
    r = gnomon("diff up.bmp down.bmp");
    expect_out(&r, 0, "0 of 6 pixels differ\n");
    r = shell(
        "for i in up down; do \"$GNOMON\" render square.obj --texture $i.bmp -o $i.png --size "
        "8x8 || exit; done; cmp up.png down.png");
    assert_int_equal(r.status, 0);
    /* -2^31 has no magnitude of 32 bits with a sign. */
    bmp[22] = bmp[23] = bmp[24] = 0;
    bmp[25] = 128;
    write_bytes("down.bmp", bmp, sizeof bmp);
    expect(1, "info down.bmp", "down.bmp", "larger than 16384");
}

/* The first pixel of a TGA may be in any corner, and alpha without attribute bits has no meaning
 * (Truevision TGA 2.0, field 5.6). */
TEST(tga_may_begin_in_any_corner)
{
    static const uint8_t ppm[] = "P6 2 2 255\n\1\2\3\4\5\6\7\10\11\12\13\14";
    static const uint8_t orders[4][4] = {{2, 3, 0, 1}, {3, 2, 1, 0}, {0, 1, 2, 3}, {1, 0, 3, 2}};
    uint8_t tga[18 + 16] = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, 32};
    write_bytes("corners.ppm", ppm, sizeof ppm - 1);
    for (int corner = 0; corner < 4; ++corner) {
        tga[17] = (uint8_t)(corner << 4);
        for (int i = 0; i < 4; ++i)
            for (int c = 0; c < 3; ++c)
                tga[18 + 4 * i + c] = (uint8_t)(3 * orders[corner][i] + 3 - c);
        write_bytes("corners.tga", tga, sizeof tga);
        run r = gnomon("diff corners.ppm corners.tga");
        expect_out(&r, 0, "0 of 4 pixels differ\n");
    }
    run r = gnomon("info corners.tga");
    expect_out(&r, 0, "  channels    3: red, green, blue\n");
    tga[17] |= 8;
    write_bytes("corners.tga", tga, sizeof tga);
    r = gnomon("info corners.tga");
    expect_out(&r, 0, "  channels    4: red, green, blue, alpha\n");
    r = gnomon("diff corners.ppm corners.tga");
    assert_int_equal(r.status, 1);
}

/* A map may be a PPM; its upper row is the texture's upper row. */
TEST(maps_may_be_ppm)
{
    static const uint8_t map[] = "P6 1 2 255\n\377\0\0\0\0\377";
    write_text("square.obj", square_obj);
    write_bytes("map.ppm", map, sizeof map - 1);
    run r = gnomon("render square.obj --texture map.ppm --filter nearest --shader unlit -o p.png "
                   "--size 8x8 " FRONT);
    assert_int_equal(r.status, 0);
    picture p = picture_read("p.png");
    const uint32_t above = pixel(&p, 4, 1), below = pixel(&p, 4, 6);
    assert_true(above >> 24 > 0 && (above & 0xffff00) == 0);
    assert_true((below >> 8 & 255) > 0 && below >> 16 == 0);
    picture_free(&p);
}
