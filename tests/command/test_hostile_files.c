/* Small files that make importers hang, crash or use all memory: each is refused within the limits,
 * in one line that names it. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* A triangle with texture coordinates, and a material whose file is "skin.mtl". */
static const char triangle_obj[] = "mtllib skin.mtl\nusemtl skin\n"
                                   "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                                   "vn 0 0 1\nf 1/1/1 2/2/1 3/3/1\n";

static void write_material(const char *statement)
{
    char text[256];
    write_text("skin.obj", triangle_obj);
    snprintf(text, sizeof text, "newmtl skin\nKd 1 1 1\n%s\n", statement);
    write_text("skin.mtl", text);
}

TEST(ply_headers_have_an_end)
{
    static const char *const texts[] = {
        "ply\nformat ascii 1.0\nend_header_\n", "ply\nformat ascii 1.0\nelement vertex 3\n",
        "ply\ncomment end_header\nformat ascii 1.0\n", "ply\nformat ascii 1.0\nxend_header\n",
        "ply\r\nformat ascii 1.0\r\nend_headers\r\n"};
    for (size_t i = 0; i < COUNT(texts); ++i) {
        write_text("a.ply", texts[i]);
        expect(1, "render a.ply -o a.png", "a.ply", "cut short: its header has no end_header");
    }
}

/* 84 bytes of an STL file, or a header of a PLY file, that announce four thousand million
 * elements. */
TEST(announced_counts_are_checked)
{
    uint8_t stl[84] = {0};
    write_text("a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n"
                        "property float x\nproperty float y\nproperty float z\nend_header\n");
    expect(1, "render a.ply -o a.png", "a.ply",
           "cut short: it ends in vertex 0, and has 4000000000");
    write_text("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                        "element face 18446744073709551615\nproperty list uchar int "
                        "vertex_indices\nend_header\n1\n2\n3\n");
    expect(1, "render a.ply -o a.png", "a.ply", "line 5: the number of elements is wrong");
    write_text("a.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nend_header\n");
    expect(1, "render a.ply -o a.png", "a.ply", "element vertex has no property x");
    memset(stl + 80, 0xff, 4);
    write_bytes("a.stl", stl, sizeof stl);
    expect(1, "render a.stl -o a.png", "a.stl",
           "cut short: 4294967295 triangles take 214748364834 bytes");
    write_bytes("a.stl", stl, 40);
    expect(1, "render a.stl -o a.png", "a.stl", "neither binary STL nor a text");
    write_bytes("a.glb", "glTF\2\0\0\0\xff\xff\xff\x7f", 12);
    expect(1, "render a.glb -o a.png", "a.glb",
           "cut short: the header says that it has 2147483647 bytes");
    write_bytes("a.3ds", "\x4d\x4d\xff\xff\xff\x7f", 6);
    expect(1, "render a.3ds -o a.png", "a.3ds", "cut short: it announces 2147483647 bytes");
    /* More elements than exist, of a buffer that a glTF file does not have. */
    write_text("a.gltf", "{\"asset\":{\"version\":\"2.0\"},\"accessors\":[{\"componentType\":5126,"
                         "\"count\":4000000000,\"type\":\"VEC3\"}],\"meshes\":[{\"primitives\":[{"
                         "\"attributes\":{\"POSITION\":0}}]}],\"nodes\":[{\"mesh\":0}],"
                         "\"scenes\":[{\"nodes\":[0]}],\"scene\":0}");
    expect(1, "render a.gltf -o a.png", "a.gltf", "");
}

/* A Collada file whose import takes long enough to be interrupted. */
static void write_slow_collada(const char *name)
{
    enum { COUNT = 600000 };
    FILE *const file = fopen(path_of(name), "w");
    assert_non_null(file);
    fprintf(file,
            "<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">"
            "<library_geometries><geometry id=\"g\"><mesh><source id=\"s\">"
            "<float_array id=\"a\" count=\"%d\">",
            3 * COUNT);
    for (int i = 0; i < COUNT; ++i)
        fprintf(file, "%d %d %d ", i % 7, i % 11, i % 13);
    fprintf(file,
            "</float_array><technique_common><accessor source=\"#a\" count=\"%d\" stride=\"3\">"
            "<param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
            "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source>"
            "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#s\"/></vertices>"
            "<triangles count=\"%d\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>",
            COUNT, COUNT / 3);
    for (int i = 0; i < COUNT / 3 * 3; ++i)
        fprintf(file, "%d ", i);
    fputs("</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>"
          "<visual_scene id=\"w\"><node><instance_geometry url=\"#g\"/></node></visual_scene>"
          "</library_visual_scenes><scene><instance_visual_scene url=\"#w\"/></scene></COLLADA>",
          file);
    assert_int_equal(fclose(file), 0);
}

/* The importing process ends as if a library had given up. */
TEST(crashes_are_named)
{
    write_slow_collada("slow.dae");
    run r = shell("\"$GNOMON\" render slow.dae -o a.png & p=$!; c=; while [ -z \"$c\" ]; do "
                  "{ read -r c </proc/$p/task/$p/children; } 2>/dev/null || :; done; "
                  "sleep 0.1; kill -ABRT $c; wait $p");
    assert_int_equal(r.status, 1);
    if (lines(r.error) != 1)
        fail_msg("%s", r.error);
    assert_non_null(strstr(r.error, "slow.dae: cannot be imported: the importer crashed"));
    assert_non_null(strstr(r.error, "(Aborted)"));
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
    expect(1, "render deep.gltf -o a.png --import-seconds 20", "deep.gltf", "");
}

/* A file that is not regular is neither read nor waited for, whoever names it. */
TEST(regular_files_alone_are_read)
{
    static const char maps[][12] = {"map_Kd", "map_Ks", "map_Ke", "map_Bump", "norm"};
    static const char options[][16] = {"texture", "specular-map", "glow-map", "normal-map"};
    static const char names[][2][32] = {{"/dev/zero", "device"},
                                        {"pipe.png", "pipe"},
                                        {"link.png", "pipe"},
                                        {"folder", "directory"}};
    char line[512];
    assert_int_equal(mkfifo(path_of("pipe.png"), 0600), 0);
    assert_int_equal(mkdir(path_of("folder"), 0700), 0);
    assert_int_equal(symlink("pipe.png", path_of("link.png")), 0);
    for (int n = 0; n < 4; ++n) {
        for (int i = 0; i < 5; ++i) {
            snprintf(line, sizeof line, "%s %s", maps[i], names[n][0]);
            write_material(line);
            expect(1, "render skin.obj -o a.png --shader phong", names[n][0], names[n][1]);
        }
        write_material("");
        for (int i = 0; i < 4; ++i) {
            snprintf(line, sizeof line, "render skin.obj -o a.png --shader phong --%s %s%s",
                     options[i], i == 3 ? "world:" : "", names[n][0]);
            expect(1, line, names[n][0], names[n][1]);
        }
        snprintf(line, sizeof line, "render %s -o a.png", names[n][0]);
        expect(1, line, names[n][0], names[n][1]);
    }
    /* Beside the model, found by its name. */
    assert_int_equal(mkfifo(path_of("skin_diffuse.tga"), 0600), 0);
    expect(1, "render skin.obj -o a.png", "skin_diffuse.tga", "pipe");
    remove_file("skin_diffuse.tga");
    assert_int_equal(mkfifo(path_of("pipe.obj"), 0600), 0);
    expect(1, "render pipe.obj -o a.png", "pipe.obj", "pipe");
    remove_file("pipe.obj");
}

/* A file that the model names. */
TEST(named_files_are_regular)
{
    static const char names[][2][16] = {{"/dev/zero", "device"}, {"pipe.mtl", "pipe"}};
    char text[1024];
    assert_int_equal(mkfifo(path_of("pipe.mtl"), 0600), 0);
    for (int n = 0; n < 2; ++n) {
        snprintf(text, sizeof text, "mtllib %s\n%s", names[n][0], square_obj);
        write_text("named.obj", text);
        run r = gnomon("render named.obj -o a.png --size 8x8");
        assert_int_equal(r.status, 0);
        assert_int_equal(lines(r.error), 1);
        assert_non_null(strstr(r.error, "named.obj: warning"));
        assert_non_null(strstr(r.error, names[n][0]));
        assert_non_null(strstr(r.error, names[n][1]));
        remove_file("a.png");
        snprintf(
            text, sizeof text,
            "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":36,\"uri\":\"%s\"}],"
            "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],\"accessors\":[{"
            "\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
            "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
            "\"nodes\":[{\"mesh\":0}],\"scenes\":[{\"nodes\":[0]}],\"scene\":0}",
            names[n][0]);
        write_text("named.gltf", text);
        expect(1, "render named.gltf -o a.png", "named.gltf", names[n][1]);
    }
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
    static const uint8_t png[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 0, 0, 0,    13,
                                  'I',  'H', 'D', 'R', 0,    0,    0x40, 0,    0, 0, 0x40, 0,
                                  8,    6,   0,   0,   0,    0,    0,    0,    0, 0, 0,    4,
                                  'I',  'D', 'A', 'T', 1,    2,    3,    4,    0, 0, 0,    0,
                                  0,    0,   0,   0,   'I',  'E',  'N',  'D',  0, 0, 0,    0};
    static const struct {
        const uint8_t *bytes;
        size_t size;
        char name[8];
    } files[] = {{tga, sizeof tga, "a.tga"},
                 {runs, sizeof runs, "b.tga"},
                 {bmp, sizeof bmp, "a.bmp"},
                 {png, sizeof png, "a.map"}};
    char line[160];
    write_material("");
    for (size_t i = 0; i < 4; ++i) {
        write_bytes(files[i].name, files[i].bytes, files[i].size);
        snprintf(line, sizeof line, "render skin.obj -o a.png --texture %s", files[i].name);
        expect(1, line, files[i].name, "16384x16384 pixels, more than --map-pixels 64");
        strcat(line, " --map-pixels 256 --import-output 1000");
        expect(1, line, files[i].name, "--import-output");
        /* Without the memory that decoding would need. */
        strcpy(strstr(line, "1000"), "2000 --import-memory 100");
        expect(1, line, files[i].name, "cut short");
    }
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

/* A PNG whose size or bits the decoder cannot hold is sound, and is refused for that reason. */
TEST(large_pngs_are_not_called_damaged)
{
    static const char raised[] = "info a.png --map-pixels 256 --import-output 4000";
    static const char cannot[] =
        "16384x16384 pixels of 16 bits a channel, more than can be decoded";
    write_png_header("a.png", 20000, 8, 6);
    expect(1, "info a.png", "a.png", "larger than 16384 pixels");
    write_png_header("a.png", 65535, 16, 2);
    expect(1, raised, "a.png", "larger than 16384 pixels");
    write_png_header("a.png", 0, 8, 2);
    expect(1, "info a.png", "a.png", "or empty");
    write_png_header("a.png", 16384, 16, 6);
    expect(1, "info a.png", "a.png", "more than --map-pixels 64");
    expect(1, raised, "a.png", cannot);
    write_png_header("a.png", 16384, 16, 2);
    expect(1, raised, "a.png", cannot);
    write_material("");
    expect(1, "render skin.obj -o a.ppm --texture a.png --map-pixels 256 --import-output 4000",
           "a.png", cannot);
    /* Grey takes less, and so does a smaller size. */
    write_png_header("a.png", 16384, 16, 0);
    expect(1, raised, "a.png", "cut short");
    write_png_header("a.png", 16383, 16, 6);
    expect(1, raised, "a.png", "cut short");
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
        expect(1,
               "render skin.obj -o a.png --texture other.map --map-pixels 256 --import-output "
               "4000",
               "other.map", "it is not a PNG, JPEG, TGA, BMP or PPM");
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
           "skin.obj: cannot be imported: it takes longer than --import-seconds 1",
           "over 'black.png'");
    if (little_memory_works())
        expect(1,
               "render skin.obj -o a.png --map-pixels 256 --import-output 2000 --import-memory 200",
               "black.png", "not enough memory (--import-memory)");
}

static void write_grid(const char *name, int size)
{
    FILE *file = fopen(path_of(name), "w");
    assert_non_null(file);
    for (int i = 0; i < size * size; ++i)
        fprintf(file, "v %d %d 0\n", i % size, i / size);
    for (int i = size + 1; i < size * size; ++i)
        if (i % size != 0)
            fprintf(file, "f %d %d %d %d\n", i - size, i - size + 1, i + 1, i);
    assert_int_equal(fclose(file), 0);
}

/* Options decide whether the same files are refused or read. */
TEST(limits_are_raised)
{
    write_material("");
    write_black_png("black.png", 2048, 1024);
    expect(1, "render skin.obj -o a.png --texture black.png --map-pixels 1", "black.png",
           "more than --map-pixels 1");
    expect(1, "render skin.obj -o a.png --texture black.png --import-output 8", "black.png",
           "take 8 MiB, and --import-output leaves 7");
    run r = gnomon("render skin.obj -o a.png --texture black.png --map-pixels 2 --import-output 9 "
                   "--size 8x8");
    assert_int_equal(r.status, 0);
    remove_file("a.png");

    /* 40000 vertices of 40 bytes, 79202 triangles of 12. */
    write_grid("grid.obj", 200);
    expect(1, "render grid.obj -o a.png --import-output 2", "grid.obj",
           "takes 3 MiB when it is imported, more than --import-output 2");
    r = gnomon("render grid.obj -o a.png --size 8x8 --import-output 3");
    assert_int_equal(r.status, 0);
    remove_file("a.png");
    if (little_memory_works())
        expect(1, "render grid.obj -o a.png --import-memory 4", "grid.obj", "--import-memory");
    r = gnomon("render grid.obj -o a.png --size 8x8 --import-memory 200");
    assert_int_equal(r.status, 0);
    remove_file("a.png");

    expect(1, "render skin.obj -o a.png --import-seconds 0", "--import-seconds", "1 to 86400");
    expect(2, "compare skin.obj --import-memory much", "--import-memory 'much'", "MiB");
    expect(1, "render skin.obj -o a.png --import-output -1", "--import-output", "MiB");
    expect(1, "render skin.obj -o a.png --map-pixels 257", "--map-pixels", "1 to 256");
    expect(2, "demo --map-pixels 1", "'--map-pixels'", "unknown option");
    static const char names[][20] = {"--import-seconds", "--import-memory", "--import-output",
                                     "--map-pixels"};
    r = gnomon("render --help");
    for (int i = 0; i < 4; ++i)
        assert_non_null(strstr(r.out, names[i]));
}

/* The importing process ends with the process that started it. Its new parent may leave it as a
 * zombie. */
TEST(nothing_is_left_running)
{
    write_material("map_Kd black.png");
    write_black_png("black.png", 16384, 16384);
    run r = shell("\"$GNOMON\" render skin.obj -o a.png --map-pixels 256 --import-output 2000 "
                  "--import-memory 4000 & sleep 0.3; "
                  "child=$(grep -l \"^PPid:.$!\\$\" /proc/[0-9]*/status | cut -d / -f 3); "
                  "kill -KILL $!; wait $!; sleep 0.2; [ -n \"$child\" ] && "
                  "! grep -q \"^State:.[^Z]\" /proc/$child/status");
    assert_int_equal(r.status, 0);
}
