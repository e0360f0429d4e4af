/* Models and pictures that are drawn differently from what they say, or are cut short: the command
 * names what is odd about them. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <stb/stb_image_write.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Draws and expects one warning that holds both texts, or no warning if `first` is null. A model of
 * which nothing can be seen has a second warning. */
static void expect_warning(const char *arguments, const char *first, const char *second)
{
    run r = gnomon("render %s -o a.png --size 8x8", arguments);
    const bool is_empty = first != NULL && strstr(r.error, "warning: nothing was drawn: ") != NULL;
    bool good = r.status == 0 && lines(r.error) == (first != NULL) + is_empty;
    if (good && first != NULL)
        good = strncmp(r.error, "gnomon: ", 8) == 0 && strstr(r.error, ": warning: ") != NULL &&
               strstr(r.error, first) != NULL && strstr(r.error, second) != NULL;
    if (!good)
        fail_msg("%s: status %d, expected '%s' and '%s'\n%s", arguments, r.status,
                 first != NULL ? first : "nothing", second, r.error);
}

static uint8_t *read_whole(const char *name, size_t *size)
{
    uint8_t *bytes = malloc(1 << 20);
    FILE *file = fopen(path_of(name), "rb");
    assert_non_null(file);
    *size = fread(bytes, 1, 1 << 20, file);
    fclose(file);
    return bytes;
}

static void expect_square_warning(const char *from, const char *to, const char *first,
                                  const char *second)
{
    char text[1024];
    const char *place = strstr(square_obj, from);
    assert_non_null(place);
    snprintf(text, sizeof text, "%.*s%s%s", (int)(place - square_obj), square_obj, to,
             place + strlen(from));
    write_text("odd.obj", text);
    expect_warning("odd.obj", first, second);
}

TEST(numbers_that_are_not_finite_are_named)
{
    static const char *const statements[] = {"Kd nan 0 0", "Kd 0 inf 0", "Ks 0 0 nan", "Ns nan",
                                             "Ns inf"};
    char text[512];
    expect_square_warning("vn 0 0 1", "vn 0 0 1", NULL, "");
    expect_square_warning("vn 0 0 1", "vn 0 nan 1", "odd.obj", "4 vertices have normals that");
    expect_square_warning("vn 0 0 1", "vn inf 0 1", "odd.obj", "normals");
    expect_square_warning("vt 1 0", "vt nan 0", "odd.obj", "1 vertex has texture coordinates");
    expect_square_warning("vt 1 0", "vt 1 1e39", "odd.obj", "texture coordinates");
    write_text("odd.ply",
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float "
               "y\nproperty float z\nproperty float s\nproperty float t\nelement face 1\n"
               "property list uchar int vertex_indices\nend_header\n0 0 0 0 0\n1 0 0 nan "
               "0\n0 1 0 0 1\n3 0 1 2\n");
    expect_warning("odd.ply", "odd.ply", "1 vertex has texture coordinates");
    expect_square_warning("v 1 -1 0", "v 1 -1 0 1 nan 1", "odd.obj", "colour");
    for (int i = 0; i < 5; ++i) {
        snprintf(text, sizeof text, "newmtl skin\nKd 1 1 1\n%s\n", statements[i]);
        write_text("skin.mtl", text);
        snprintf(text, sizeof text, "mtllib skin.mtl\nusemtl skin\n%s", square_obj);
        write_text("named.obj", text);
        expect_warning("named.obj", "skin.mtl: warning: line 3: ", "this is not a number");
    }
}

/* Models are drawn as if the numbers that are not finite were not there. */
TEST(what_is_drawn_instead_is_finite)
{
    char text[1024];
    const char *normal = strstr(square_obj, "vn 0 0 1");
    snprintf(text, sizeof text, "%.*svn nan nan nan%s", (int)(normal - square_obj), square_obj,
             normal + strlen("vn 0 0 1"));
    write_text("odd.obj", text);
    write_text("square.obj", square_obj);
    static const uint8_t texel[3] = {200, 150, 255};
    stbi_write_png(path_of("map.png"), 1, 1, 3, texel, 0);
    run r = gnomon("render square.obj -o even.png " FRONT " --size 16x16 --normal-map "
                   "tangent:map.png");
    assert_int_equal(r.status, 0);
    r = gnomon("render odd.obj -o odd.png " FRONT " --size 16x16 --normal-map tangent:map.png");
    assert_int_equal(r.status, 0);
    r = shell("cmp even.png odd.png");
    assert_int_equal(r.status, 0);
}

TEST(missing_material_files_are_named)
{
    char text[1024];
    snprintf(text, sizeof text, "mtllib gone.mtl\nusemtl skin\n%s", square_obj);
    write_text("named.obj", text);
    remove_file("named.mtl");
    expect_warning("named.obj", "'gone.mtl'", "No such file");
    write_text("gone.mtl", "newmtl skin\nKd 1 0 0\n");
    expect_warning("named.obj", NULL, "");
    write_text("gone.mtl", "newmtl skins\nKd 1 0 0\n");
    expect_warning("named.obj", "no material file has the material", "'skin'");
    assert_int_equal(chmod(path_of("gone.mtl"), 0), 0);
    if (access(path_of("gone.mtl"), R_OK) != 0)
        expect_warning("named.obj", "'gone.mtl'", "Permission denied");
    remove_file("gone.mtl");
    remove_file("named.mtl");
}

/* Expects the fault of a model whose material names this map. */
static void expect_map_fault(const char *map, const char *words)
{
    char text[1024];
    snprintf(text, sizeof text, "newmtl skin\nKd 1 1 1\nmap_Kd %s\n", map);
    write_text("skin.mtl", text);
    expect(1, "render named.obj -o b.png --size 8x8", "named.obj: its texture", words);
}

/* A map that is not there: the message names the file that may have been meant. */
TEST(missing_maps_have_near_names)
{
    static const uint8_t texel[3] = {1, 2, 3};
    char text[1024];
    snprintf(text, sizeof text, "mtllib skin.mtl\nusemtl skin\n%s", square_obj);
    write_text("named.obj", text);
    write_text("square.obj", square_obj);
    stbi_write_png(path_of("wood.png"), 1, 1, 3, texel, 0);
    stbi_write_png(path_of("my map.png"), 1, 1, 3, texel, 0);
    expect_map_fault("Wood.PNG", "'Wood.PNG' cannot be read: No such file or directory; there is "
                                 "'wood.png' in that folder (go on without it: --texture none)");
    expect_map_fault("my%20map.png", "there is 'my map.png' in that folder");
    expect_map_fault("wood.jpg", "there is 'wood.png' in that folder");
    expect_map_fault("woood.png", "there is 'wood.png' in that folder");
    expect_map_fault("C:\\maps\\wood.png", "there is 'wood.png' beside the model");
    expect_map_fault("/nowhere/Wood.png", "there is 'wood.png' beside the model");
    expect_map_fault("stone.png", "No such file or directory (go on");
    expect(1, "render square.obj -o b.png --texture Wood.png", "Wood.png: cannot be read",
           "; there is 'wood.png' in that folder (go on");
    write_text("skin.mtl", "newmtl skin\nKd 1 1 1\nmap_Kd Wood.png\n");
    run r = gnomon("info named.obj");
    assert_non_null(strstr(r.out, "diffuse Wood.png (cannot be read: No such file or directory; "
                                  "there is 'wood.png' in that folder)\n"));
    /* A file that is there and cannot be read has no other name. */
    write_text("wood.tga", "");
    expect_map_fault("wood.tga", "the file is empty (go on");
    remove_file("wood.tga");
    remove_file("wood.png");
    remove_file("my map.png");
    remove_file("skin.mtl");
}

/* A camera's orientation in a JPEG is named and not applied. */
TEST(orientations_are_named)
{
    static const uint8_t exif[] = "\xff\xe1\0\x22"
                                  "Exif\0\0MM\0*\0\0\0\x08\0\1\1\x12\0\3\0\0\0\1\0\6\0\0\0\0\0";
    static const uint8_t texels[16 * 8 * 3] = {255, 255, 255};
    uint8_t turned[4096];
    char text[2048];
    write_text("square.obj", square_obj);
    stbi_write_jpg(path_of("plain.jpg"), 16, 8, 3, texels, 95);
    size_t size;
    uint8_t *plain = read_whole("plain.jpg", &size);
    assert_in_range(size, 100, 4000);
    memcpy(turned, plain, 2);
    memcpy(turned + 2, exif, sizeof exif - 1);
    memcpy(turned + 2 + sizeof exif - 1, plain + 2, size - 2);
    write_bytes("turned.jpg", turned, size + sizeof exif - 1);
    free(plain);
    expect_warning("square.obj --texture plain.jpg", NULL, "");
    expect_warning("square.obj --texture turned.jpg", "turned.jpg: warning",
                   "orientation 6, which is not applied");
    run r =
        shell("set -e; for i in plain turned; do \"$GNOMON\" render square.obj --texture $i.jpg "
              "-o $i.png --size 8x8; done; cmp plain.png turned.png");
    assert_int_equal(r.status, 0);
    r = gnomon("info turned.jpg");
    expect_good(&r);
    assert_non_null(strstr(r.out, "size        16x8\n"));
    assert_non_null(strstr(r.out, "orientation 6 in its Exif data, which is not applied\n"));
    r = gnomon("info plain.jpg");
    assert_null(strstr(r.out, "orientation"));
    /* Once, though two materials and two kinds of maps name it. */
    write_text("skin.mtl", "newmtl a\nmap_Kd turned.jpg\nmap_Ks turned.jpg\n"
                           "newmtl b\nmap_Kd turned.jpg\nKd 1 0 0\n");
    snprintf(text, sizeof text, "mtllib skin.mtl\nusemtl a\n%susemtl b\nf 1/1/1 3/3/1 2/2/1\n",
             square_obj);
    write_text("named.obj", text);
    expect_warning("named.obj", "turned.jpg: warning", "not applied");
    remove_file("skin.mtl");
}

TEST(triangles_without_area_are_counted)
{
    expect_square_warning("f 1/1/1 2/2/1 3/3/1", "f 1/1/1 2/2/1 1/1/1", "odd.obj",
                          "1 triangle has no area");
    expect_square_warning("v 1 1 0", "v -1 -1 0", "odd.obj", "2 triangles have no area");
    expect_square_warning("v -1 -1 0\nv 1 -1 0", "v 1 1 0\nv 1 1 0", "odd.obj", "no area");
}

/* The beginning of a file is refused as cut short, drawn with a warning, or complete. Tests every
 * seventh length, and all lengths that end within the faces. */
TEST(cut_models_are_named)
{
    static const char text[] = "# a model\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
                               "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
                               "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\n";
    for (size_t size = 0; size < sizeof text; size += size + 45 < sizeof text ? 7 : 1) {
        char line[32];
        write_bytes("cut.obj", text, size);
        run r = gnomon("render cut.obj -o a.png --size 8x8");
        const size_t whole = (size_t)(strstr(text, "f 1") - text) + strlen("f 1/1/1 2/2/1 3/3");
        const bool has_face = size > whole;
        /* Vertices alone are points, and two corners a line, with a warning. */
        const bool good = r.status == 0 ? has_face || lines(r.error) == 1
                                        : lines(r.error) == 1 && strstr(r.error, "cut.obj: ");
        snprintf(line, sizeof line, "%zu bytes", size);
        if (!good)
            fail_msg("%s: status %d, %s", line, r.status, r.error);
    }
    write_text("cut.obj", "v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n");
    expect(1, "render cut.obj -o b.png", "cut.obj",
           "line 2: v takes 3, 4, 6, 7 or 8 numbers, not 2");
    write_text("cut.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt\nf 1 2 3\n");
    expect(1, "render cut.obj -o b.png", "cut.obj", "line 4: vt takes");
    write_bytes("cut.obj", "v 0 0 0\nv 1 0 0\nv \0 1 0\nf 1 2 3\n", 34);
    expect(1, "render cut.obj -o b.png", "cut.obj", "it has a NUL byte");
    write_text("cut.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\n");
    expect(1, "render cut.obj -o b.png", "cut.obj", "line 5: f names v 4, but there are only 3");
    write_text("cut.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//2\n");
    expect(1, "render cut.obj -o b.png", "cut.obj", "line 5: f names vn 2, but there is only 1");
    /* Lines that continue, comments, blanks. */
    write_text("cut.obj", "v 0 0 0 # here\r\nv 1 \\\n 0 0\nv 0 1 0\n\nf 1 2 \\\n 3\n# the end");
    expect_warning("cut.obj", NULL, "");
    write_text("cut.ply",
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float "
               "y\nproperty float z\nelement face 1\nproperty list uchar int "
               "vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1");
    expect(1, "render cut.ply -o b.png", "cut.ply", "cut short");
    write_text("cut.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                          "vertex 0 1 0\nendloop\nendfacet\n");
    expect_warning("cut.stl", "endsolid", "cut short");
}

/* The formats, each with its own ending, at a few dozen lengths. */
TEST(cut_pictures_are_named)
{
    static const char names[][8] = {"t.png", "t.jpg", "t.tga", "t.bmp"};
    uint8_t texels[32 * 32 * 3];
    for (int i = 0; i < 32 * 32 * 3; ++i)
        texels[i] = (uint8_t)(i * 37 + i / 96 * 5);
    write_text("square.obj", square_obj);
    stbi_write_png(path_of("t.png"), 32, 32, 3, texels, 0);
    stbi_write_jpg(path_of("t.jpg"), 32, 32, 3, texels, 95);
    stbi_write_tga(path_of("t.tga"), 32, 32, 3, texels);
    stbi_write_bmp(path_of("t.bmp"), 32, 32, 3, texels);
    for (int i = 0; i < 4; ++i) {
        size_t size;
        uint8_t *bytes = read_whole(names[i], &size);
        write_bytes("cut.map", bytes, size);
        expect_warning("square.obj --texture cut.map", NULL, "");
        for (size_t k = 1; k < 24; k += k < 20 ? 2 : 1) {
            size_t length = k < 10 ? k * k : k < 20 ? size * (k - 9) / 11 : size - (24 - k) * 4;
            /* A JPEG without its last marker is complete. A TGA shorter than its header is
             * not recognised as one. */
            if ((i == 1 && length + 3 > size) || (i == 2 && length < 18))
                continue;
            write_bytes("cut.map", bytes, length);
            char found[64];
            snprintf(found, sizeof found, "render square.obj -o b.png --texture cut.map");
            expect(1, found, "cut.map", "the file is cut short");
        }
        free(bytes);
    }
    write_bytes("cut.map", "", 0);
    expect(1, "render square.obj -o b.png --texture cut.map", "cut.map", "the file is empty");
}

/* A byte order mark, with which some editors begin a text. */
TEST(byte_order_marks_are_accepted)
{
    char text[1024];
    write_text("square.obj", square_obj);
    write_text("marked.mtl", "\xef\xbb\xbfnewmtl skin\nKd 1 0 0\n");
    snprintf(text, sizeof text, "\xef\xbb\xbf%s", square_obj);
    write_text("marked.obj", text);
    run r = gnomon("render square.obj -o plain.png --size 16x16");
    assert_int_equal(r.status, 0);
    r = gnomon("render marked.obj -o marked.png --size 16x16");
    assert_string_equal(r.error, "");
    r = shell("cmp plain.png marked.png");
    assert_int_equal(r.status, 0);

    snprintf(text, sizeof text, "mtllib marked.mtl\nusemtl skin\n%s", square_obj);
    write_text("red.obj", text);
    r = gnomon("render red.obj -o a.png " FRONT " --size 4x4 --shader vertex-color");
    assert_string_equal(r.error, "");
    picture p = picture_read("a.png");
    assert_int_equal(pixel(&p, 2, 2), 0xff0000ff);
    picture_free(&p);
    write_text("marked.ply",
               "\xef\xbb\xbfply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
               "property float y\nproperty float z\nelement face 1\nproperty list "
               "uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    expect_warning("marked.ply", NULL, "");
}

/* Names come from files, and a terminal must not act on them. */
TEST(bytes_are_escaped)
{
    char text[1024];
    expect(1, "render \"$(printf 'a\\033[31m\\n\\377\\302\\205\\303\\274.obj')\" -o a.png",
           "a\\x1b[31m\\x0a\\xff\\xc2\\x85\xc3\xbc.obj", "No such file");
    snprintf(text, sizeof text, "mtllib a\033[2J.mtl\n%s", square_obj);
    write_text("named.obj", text);
    expect_warning("named.obj", "'a\\x1b[2J.mtl'", "No such file");
    /* On standard output too. */
    static const uint8_t texel[3] = {1, 2, 3};
    write_text("square.obj", square_obj);
    stbi_write_png(path_of("m\033.png"), 1, 1, 3, texel, 0);
    run r = gnomon("render square.obj --texture \"$(printf 'm\\033.png')\" -o \"$(printf "
                   "'o\\007.png')\" --size 8x8");
    assert_int_equal(r.status, 0);
    assert_non_null(strstr(r.out, "o\\x07.png: 8x8"));
    assert_non_null(strstr(r.out, "maps: diffuse m\\x1b.png\n"));
    r = gnomon("compare square.obj -o \"$(printf 'o\\007.png')\" --size 8x8");
    assert_non_null(strstr(r.out, "\no\\x07.png: Gnomon"));
}

TEST(numbers_of_options_are_finite)
{
    static const char names[][16] = {"eye", "target", "up", "light"};
    char line[1024];
    write_text("square.obj", square_obj);
    for (int i = 0; i < 4; ++i) {
        snprintf(line, sizeof line, "render square.obj -o b.png --%s 1e39,0,0", names[i]);
        expect(2, line, names[i],
               "'1e39,0,0': not finite in 32 bits; it takes three numbers X,Y,Z");
        snprintf(line, sizeof line, "render square.obj -o b.png --%s 0,0,nan", names[i]);
        expect(2, line, names[i], "not finite");
        snprintf(line, sizeof line, "render square.obj -o b.png --%s 0,1e39", names[i]);
        expect(2, line, names[i], "not finite");
        snprintf(line, sizeof line, "render square.obj -o b.png --%s 0,0", names[i]);
        expect(2, line, names[i], "not three numbers X,Y,Z");
    }
    expect(2, "render square.obj -o b.png --fov inf", "--fov 'inf'", "not finite");
    expect(2, "render square.obj -o b.png --orthographic 1e99", "--orthographic", "not finite");
}
