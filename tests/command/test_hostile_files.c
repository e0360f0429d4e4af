/* Small files that make importers hang, crash or use all memory: each is refused within the limits,
 * in one line that names it. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A model whose material has this statement. */
static void write_material(const char *statement)
{
    char text[512];
    write_square("skin.obj", "mtllib skin.mtl\nusemtl skin\n");
    snprintf(text, sizeof text, "newmtl skin\nKd 1 1 1\n%s\n", statement);
    write_text("skin.mtl", text);
}

#define GLTF_MESH                                                                                  \
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"nodes\":[{\"mesh\":0}],"  \
    "\"scenes\":[{\"nodes\":[0]}],\"scene\":0}"

/* Headers that announce thousands of millions of elements, or have no end. */
TEST(announced_counts_are_checked)
{
    static const uint8_t stl[84] = {[80] = 0xff, 0xff, 0xff, 0xff};
    static const char many[] = "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n"
                               "property float x\nproperty float y\nproperty float z\nend_header\n";
    static const char too_many[] = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                                   "element face 18446744073709551615\nend_header\n1\n2\n3\n";
    static const char endless[] = "ply\ncomment end_header\nformat ascii 1.0\nend_header_\n";
    /* Of a buffer that the file does not have. */
    static const char gltf[] =
        "{\"asset\":{\"version\":\"2.0\"},\"accessors\":[{\"componentType\":5126,"
        "\"count\":4000000000,\"type\":\"VEC3\"}]," GLTF_MESH;
    static const struct {
        const char *name;
        const void *bytes;
        size_t size;
        const char *message;
    } files[] = {
        {"a.ply", many, sizeof many - 1, "cut short: it ends in vertex 0, and has 4000000000"},
        {"a.ply", too_many, sizeof too_many - 1, "line 5: the number of elements is wrong"},
        {"a.ply", endless, sizeof endless - 1, "cut short: its header has no end_header"},
        {"a.stl", stl, 84, "cut short: 4294967295 triangles take 214748364834 bytes"},
        {"a.stl", stl, 40, "neither binary STL nor a text"},
        {"a.glb", "glTF\2\0\0\0\xff\xff\xff\x7f", 12,
         "cut short: the header says that it has 2147483647 bytes"},
        {"a.3ds", "\x4d\x4d\xff\xff\xff\x7f", 6, "cut short: it announces 2147483647 bytes"},
        {"a.gltf", gltf, sizeof gltf - 1, "4000000000 elements without a bufferView"},
    };
    for (size_t i = 0; i < COUNT(files); ++i) {
        char line[64];
        write_bytes(files[i].name, files[i].bytes, files[i].size);
        snprintf(line, sizeof line, "render %s -o a.png", files[i].name);
        expect(1, line, "%s: ... %s", files[i].name, files[i].message);
    }
}

/* A Collada file whose import takes long enough to be interrupted. */
static const char slow_collada[] =
    "{ echo '<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">"
    "<library_geometries><geometry id=\"g\"><mesh><source id=\"s\"><float_array id=\"a\" "
    "count=\"1800000\">'; seq 1800000; echo '</float_array><technique_common><accessor "
    "source=\"#a\" count=\"600000\" stride=\"3\"><param name=\"X\" type=\"float\"/><param "
    "name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/></accessor></technique_common>"
    "</source><vertices id=\"v\"><input semantic=\"POSITION\" source=\"#s\"/></vertices>"
    "<triangles count=\"200000\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>'; "
    "seq 0 599999; echo '</p></triangles></mesh></geometry></library_geometries>"
    "<library_visual_scenes><visual_scene id=\"w\"><node><instance_geometry url=\"#g\"/></node>"
    "</visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#w\"/></scene>"
    "</COLLADA>'; } >slow.dae";

/* The importing process ends as if a library had given up. */
TEST(crashes_are_named)
{
    good_shell("%s", slow_collada);
    run r = shell("gnomon render slow.dae -o a.png & p=$!; c=; while [ -z \"$c\" ]; do "
                  "{ read -r c </proc/$p/task/$p/children; } 2>/dev/null || :; done; "
                  "sleep 0.1; kill -ABRT $c; wait $p");
    if (r.status != 1 || lines(r.error) != 1 || strstr(r.error, "(Aborted)") == NULL ||
        strstr(r.error, "slow.dae: cannot be imported: the importer crashed") == NULL)
        fail_run(&r);
    assert_false(exists("a.png"));
}

/* Arrays within arrays, two hundred thousand levels deep. */
TEST(deep_nesting_is_survived)
{
    enum { DEPTH = 200000 };
    static char text[2 * DEPTH + 64];
    strcpy(text, "{\"asset\":{\"version\":\"2.0\"},\"extras\":");
    size_t length = strlen(text);
    memset(text + length, '[', DEPTH);
    memset(text + length + DEPTH, ']', DEPTH);
    strcpy(text + length + 2 * DEPTH, "}");
    write_text("deep.gltf", text);
    expect(1, "render deep.gltf -o a.png --import-seconds 20", "deep.gltf");
}

/* A file that is not regular is neither read nor waited for, whoever names it. */
TEST(regular_files_alone_are_read)
{
    static const char maps[][12] = {"map_Kd", "map_Ks", "map_Ke", "map_Bump", "norm"};
    static const char options[][24] = {"--texture ", "--specular-map ", "--glow-map ",
                                       "--normal-map world:"};
    static const char names[][2][16] = {{"/dev/zero", "device"},
                                        {"pipe.png", "pipe"},
                                        {"link.png", "pipe"},
                                        {"folder", "directory"}};
    char line[512], text[1024];
    good_shell("mkfifo pipe.png; mkdir folder; ln -s pipe.png link.png");
    for (int n = 0; n < 4; ++n) {
        const char *name = names[n][0], *kind = names[n][1];
        for (size_t i = 0; i < COUNT(maps); ++i) {
            snprintf(line, sizeof line, "%s %s", maps[i], name);
            write_material(line);
            expect(1, "render skin.obj -o a.png --shader phong", "%s ... %s", name, kind);
        }
        write_material("");
        for (size_t i = 0; i < COUNT(options); ++i) {
            snprintf(line, sizeof line, "render skin.obj -o a.png --shader phong %s%s", options[i],
                     name);
            expect(1, line, "%s ... %s", name, kind);
        }
        snprintf(line, sizeof line, "render %s -o a.png", name);
        expect(1, line, "%s ... %s", name, kind);
        /* What the model names. */
        snprintf(
            text, sizeof text,
            "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":36,\"uri\":\"%s\"}],"
            "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],\"accessors\":[{"
            "\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}]," GLTF_MESH,
            name);
        write_text("named.gltf", text);
        expect(1, "render named.gltf -o a.png", "named.gltf ... %s", kind);
        snprintf(text, sizeof text, "mtllib %s\n", name);
        write_square("named.obj", text);
        run r = good("render named.obj -o b.png --size 8x8");
        if (lines(r.error) != 1 || strstr(r.error, "named.obj: warning") == NULL ||
            strstr(r.error, name) == NULL || strstr(r.error, kind) == NULL)
            fail_run(&r);
    }
    /* Beside the model, found by its name. */
    good_shell("mkfifo skin_diffuse.tga pipe.obj");
    expect(1, "render skin.obj -o a.png", "skin_diffuse.tga ... pipe");
    expect(1, "render pipe.obj -o a.png", "pipe.obj ... pipe");
    good_shell("rm skin_diffuse.tga pipe.obj");
}

/* The header of a PNG and a few bytes of pixels. */
static void write_png_header(const char *name, uint16_t size, uint8_t bits, uint8_t type)
{
    const uint8_t high = (uint8_t)(size >> 8), low = (uint8_t)size;
    const uint8_t png[] = {0x89, 'P',  'N', 'G', '\r', '\n', 0x1a, '\n', 0, 0, 0,    13,
                           'I',  'H',  'D', 'R', 0,    0,    high, low,  0, 0, high, low,
                           bits, type, 0,   0,   0,    0,    0,    0,    0, 0, 0,    4,
                           'I',  'D',  'A', 'T', 1,    2,    3,    4,    0, 0, 0,    0,
                           0,    0,    0,   0,   'I',  'E',  'N',  'D',  0, 0, 0,    0};
    write_bytes(name, png, sizeof png);
}

/* Picture files with a header for 16384x16384 pixels and hardly any data are refused for their
 * size, and for another reason once the budget of pixels is raised. */
TEST(pictures_are_sized_first)
{
    static const uint8_t tga[18] = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x40, 0, 0x40, 24, 0};
    static const uint8_t runs[24] = {0, 0,    10, 0,    0,  0, 0,    0, 0, 0, 0,    0,
                                     0, 0x40, 0,  0x40, 24, 0, 0xff, 1, 2, 3, 0xff, 1};
    static const uint8_t bmp[54] = {'B', 'M', 102, 0, 0,    0, 0, 0, 0,    0, 54, 0, 0, 0,  40,
                                    0,   0,   0,   0, 0x40, 0, 0, 0, 0x40, 0, 0,  1, 0, 24, 0};
    static const char names[][8] = {"a.tga", "b.tga", "a.bmp", "a.map"};
    write_material("");
    write_bytes("a.tga", tga, sizeof tga);
    write_bytes("b.tga", runs, sizeof runs);
    write_bytes("a.bmp", bmp, sizeof bmp);
    write_png_header("a.map", 16384, 8, 6);
    for (size_t i = 0; i < COUNT(names); ++i) {
        char line[160];
        snprintf(line, sizeof line, "render skin.obj -o a.png --texture %s", names[i]);
        expect(1, line, "%s ... 16384x16384 pixels, more than --map-pixels 64", names[i]);
        strcat(line, " --map-pixels 256 --import-output 1000");
        expect(1, line, "%s ... --import-output", names[i]);
        /* Without the memory that decoding would need. */
        strcpy(strstr(line, "1000"), "2000 --import-memory 100");
        expect(1, line, "%s ... cut short", names[i]);
    }
}

/* A PNG whose size or bits the decoder cannot hold is sound, and is refused for that reason. */
TEST(large_pngs_are_not_called_damaged)
{
    static const char cannot[] =
        "16384x16384 pixels of 16 bits a channel, more than can be decoded";
    static const struct {
        uint16_t size;
        uint8_t bits, type;
        const char *message;
    } files[] = {{20000, 8, 6, "larger than 16384 pixels"},
                 {65535, 16, 2, "larger than 16384 pixels"},
                 {0, 8, 2, "or empty"},
                 {16384, 16, 6, cannot},
                 {16384, 16, 2, cannot},
                 /* Grey takes less, and so does a smaller size. */
                 {16384, 16, 0, "cut short"},
                 {16383, 16, 6, "cut short"}};
    write_material("");
    for (size_t i = 0; i < COUNT(files); ++i) {
        write_png_header("a.map", files[i].size, files[i].bits, files[i].type);
        expect(1, "info a.map --map-pixels 256 --import-output 4000", "a.map ... %s",
               files[i].message);
        if (files[i].message == cannot)
            expect(1,
                   "render skin.obj -o a.png --texture a.map --map-pixels 256 --import-output 4000",
                   "a.map ... %s", cannot);
    }
}

TEST(other_pictures_are_refused)
{
    static const struct {
        uint8_t bytes[40];
        size_t size;
    } files[] = {
        {"GIF89a\0\x40\0\x40\x80\0\0\0\0\0\xff\xff\xff,\0\0\0\0\0\x40\0\x40\0\2\2\x44\1\0;", 35},
        {"8BPS\0\1\0\0\0\0\0\0\0\3\0\0\x40\0\0\0\x40\0\0\x08\0\3\0\0\0\0\0\0\0\0\0\0\0\0\0\1", 40},
        {"#?RADIANCE\n\n-Y 16384 +X 16384\n", 30},
        {"\x53\x80\xf6\x34", 4}};
    write_material("");
    for (size_t i = 0; i < COUNT(files); ++i) {
        write_bytes("other.map", files[i].bytes, files[i].size);
        expect(1, "render skin.obj -o a.png --texture other.map",
               "other.map ... it is not a PNG, JPEG, TGA, BMP or PPM");
    }
}

/* All black, one bit per pixel: a few kilobytes. */
static void write_black_png(const char *name, uint32_t width, uint32_t height)
{
    FILE *file = fopen(path_of(name), "wb");
    assert_non_null(file);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    png_bytep row = calloc(width / 8, 1);
    if (setjmp(png_jmpbuf(png)) != 0)
        fail_msg("%s cannot be written", name);
    png_init_io(png, file);
    png_set_IHDR(png, info, width, height, 1, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (uint32_t y = 0; y < height; ++y)
        png_write_row(png, row);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    free(row);
    fclose(file);
}

/* Importing that takes seconds and gigabytes ends at the limit. */
TEST(time_is_limited)
{
    write_material("map_Kd black.png");
    write_black_png("black.png", 16384, 16384);
    expect(1,
           "render skin.obj -o a.png --map-pixels 256 --import-output 2000 --import-memory 4000 "
           "--import-seconds 1",
           "skin.obj: cannot be imported: it takes longer than --import-seconds 1 ... over "
           "'black.png'");
    if (little_memory_works())
        expect(1,
               "render skin.obj -o a.png --map-pixels 256 --import-output 2000 --import-memory 200",
               "black.png ... not enough memory (--import-memory)");
}

/* Options decide whether the same files are refused or read. */
TEST(limits_are_raised)
{
    static const refusal low[] = {
        {"skin.obj --texture black.png --map-pixels 1", "black.png ... more than --map-pixels 1"},
        {"skin.obj --texture black.png --import-output 8",
         "black.png ... take 8 MiB, and --import-output leaves 7"},
        /* 40000 vertices of 40 bytes, 79202 triangles of 12. */
        {"grid.obj --import-output 2",
         "grid.obj ... takes 3 MiB when it is imported, more than --import-output 2"},
    };
    write_material("");
    write_black_png("black.png", 2048, 1024);
    write_grid("grid.obj", 200);
    EXPECT_EACH(1, "render -o a.png", low);
    if (little_memory_works())
        expect(1, "render grid.obj -o a.png --import-memory 4", "grid.obj ... --import-memory");
    good(
        "render skin.obj -o b.png --texture black.png --map-pixels 2 --import-output 9 --size 8x8");
    good("render grid.obj -o b.png --size 8x8 --import-output 3 --import-memory 200");
}

/* The importing process ends with the process that started it. Its new parent may leave it as a
 * zombie. */
TEST(nothing_is_left_running)
{
    write_material("map_Kd black.png");
    write_black_png("black.png", 16384, 16384);
    good_shell("gnomon render skin.obj -o a.png --map-pixels 256 --import-output 2000 "
               "--import-memory 4000 & sleep 0.3; "
               "child=$(grep -l \"^PPid:.$!\\$\" /proc/[0-9]*/status | cut -d / -f 3); "
               "kill -KILL $!; wait $!; sleep 0.2; [ -n \"$child\" ] && "
               "! grep -q \"^State:.[^Z]\" /proc/$child/status");
}
