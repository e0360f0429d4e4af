/* Models and pictures that are drawn differently from what they say, or are cut short: the command
 * names what is odd about them. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <stb/stb_image_write.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Draws and expects one warning that holds both texts, or no warning if `first` is null. A model of
 * which nothing can be seen has a second warning. */
static void expect_warning(const char *arguments, const char *first, const char *second)
{
    run r = good("render %s -o a.png --size 8x8", arguments);
    const bool is_empty = first != NULL && strstr(r.error, "warning: nothing was drawn: ") != NULL;
    bool is_good = lines(r.error) == (first != NULL) + is_empty;
    if (is_good && first != NULL)
        is_good = strncmp(r.error, "gnomon: ", 8) == 0 && strstr(r.error, ": warning: ") != NULL &&
                  strstr(r.error, first) != NULL && strstr(r.error, second) != NULL;
    if (!is_good)
        fail_run(&r);
}

/* Writes the square with other words in one place. */
static void write_odd(const char *name, const char *from, const char *to)
{
    char text[1024];
    const char *place = strstr(square_obj, from);
    assert_non_null(place);
    snprintf(text, sizeof text, "%.*s%s%s", (int)(place - square_obj), square_obj, to,
             place + strlen(from));
    write_text(name, text);
}

/* Numbers that are not finite, and triangles without area. */
TEST(odd_statements_are_named)
{
    static const char *const statements[] = {"Kd nan 0 0", "Kd 0 inf 0", "Ks 0 0 nan", "Ns nan",
                                             "Ns inf"};
    static const char *const squares[][3] = {
        {"vn 0 0 1", "vn 0 nan 1", "4 vertices have normals that"},
        {"vn 0 0 1", "vn inf 0 1", "normals"},
        {"vt 1 0", "vt nan 0", "1 vertex has texture coordinates"},
        {"vt 1 0", "vt 1 1e39", "texture coordinates"},
        {"v 1 -1 0", "v 1 -1 0 1 nan 1", "colour"},
        {"f 1/1/1 2/2/1 3/3/1", "f 1/1/1 2/2/1 1/1/1", "1 triangle has no area"},
        {"v 1 1 0", "v -1 -1 0", "2 triangles have no area"},
        {"v -1 -1 0\nv 1 -1 0", "v 1 1 0\nv 1 1 0", "no area"}};
    expect_warning("square.obj", NULL, "");
    for (size_t i = 0; i < COUNT(squares); ++i) {
        write_odd("odd.obj", squares[i][0], squares[i][1]);
        expect_warning("odd.obj", "odd.obj", squares[i][2]);
    }
    write_square("named.obj", "mtllib skin.mtl\nusemtl skin\n");
    for (size_t i = 0; i < COUNT(statements); ++i) {
        char text[64];
        snprintf(text, sizeof text, "newmtl skin\nKd 1 1 1\n%s\n", statements[i]);
        write_text("skin.mtl", text);
        expect_warning("named.obj", "skin.mtl: warning: line 3: ", "this is not a number");
    }
}

/* Models are drawn as if the numbers that are not finite were not there. */
TEST(what_is_drawn_instead_is_finite)
{
    write_odd("odd.obj", "vn 0 0 1", "vn nan nan nan");
    write_color("map.png", 200, 150, 255);
    good("render square.obj -o even.png " FRONT " --size 16x16 --normal-map tangent:map.png");
    good("render odd.obj -o odd.png " FRONT " --size 16x16 --normal-map tangent:map.png");
    expect_same_files("even.png", "odd.png");
}

TEST(missing_material_files_are_named)
{
    write_square("named.obj", "mtllib gone.mtl\nusemtl skin\n");
    expect_warning("named.obj", "'gone.mtl'", "No such file");
    write_text("gone.mtl", "newmtl skin\nKd 1 0 0\n");
    expect_warning("named.obj", NULL, "");
    write_text("gone.mtl", "newmtl skins\nKd 1 0 0\n");
    expect_warning("named.obj", "no material file has the material", "'skin'");
    assert_int_equal(chmod(path_of("gone.mtl"), 0), 0);
    if (access(path_of("gone.mtl"), R_OK) != 0)
        expect_warning("named.obj", "'gone.mtl'", "Permission denied");
    remove_file("gone.mtl");
}

/* Expects the fault of a model whose material names this map. */
static void expect_map_fault(const char *map, const char *words)
{
    char text[128];
    snprintf(text, sizeof text, "newmtl skin\nKd 1 1 1\nmap_Kd %s\n", map);
    write_text("skin.mtl", text);
    expect(1, "render named.obj -o b.png --size 8x8", "named.obj: its texture ... %s", words);
}

/* A map that is not there: the message names the file that may have been meant. */
TEST(missing_maps_have_near_names)
{
    write_square("named.obj", "mtllib skin.mtl\nusemtl skin\n");
    write_color("wood.png", 1, 2, 3);
    write_color("my map.png", 1, 2, 3);
    expect_map_fault("Wood.PNG", "'Wood.PNG' cannot be read: No such file or directory; there is "
                                 "'wood.png' in that folder (go on without it: --texture none)");
    expect_map_fault("my%20map.png", "there is 'my map.png' in that folder");
    expect_map_fault("wood.jpg", "there is 'wood.png' in that folder");
    expect_map_fault("woood.png", "there is 'wood.png' in that folder");
    expect_map_fault("C:\\maps\\wood.png", "there is 'wood.png' beside the model");
    expect_map_fault("/nowhere/Wood.png", "there is 'wood.png' beside the model");
    expect_map_fault("stone.png", "No such file or directory (go on");
    expect(1, "render square.obj -o b.png --texture Wood.png",
           "Wood.png: cannot be read ... ; there is 'wood.png' in that folder (go on");
    write_text("skin.mtl", "newmtl skin\nKd 1 1 1\nmap_Kd Wood.png\n");
    run r = gnomon("info named.obj");
    expect_printed(&r, "diffuse Wood.png (cannot be read: No such file or directory; "
                       "there is 'wood.png' in that folder)\n");
    /* A file that is there and cannot be read has no other name. */
    write_text("wood.tga", "");
    expect_map_fault("wood.tga", "the file is empty (go on");
    good_shell("rm wood.* 'my map.png' skin.mtl");
}

/* A camera's orientation in a JPEG is named and not applied. */
TEST(orientations_are_named)
{
    static const uint8_t exif[] = "\xff\xe1\0\x22"
                                  "Exif\0\0MM\0*\0\0\0\x08\0\1\1\x12\0\3\0\0\0\1\0\6\0\0\0\0\0";
    static const uint8_t texels[16 * 8 * 3] = {255, 255, 255};
    uint8_t plain[4096], turned[sizeof plain + sizeof exif];
    stbi_write_jpg(path_of("plain.jpg"), 16, 8, 3, texels, 95);
    const size_t size = read_file("plain.jpg", plain, sizeof plain);
    memcpy(turned, plain, 2);
    memcpy(turned + 2, exif, sizeof exif - 1);
    memcpy(turned + 2 + sizeof exif - 1, plain + 2, size - 2);
    write_bytes("turned.jpg", turned, size + sizeof exif - 1);
    expect_warning("square.obj --texture plain.jpg", NULL, "");
    expect_warning("square.obj --texture turned.jpg", "turned.jpg: warning",
                   "orientation 6, which is not applied");
    good_shell("set -e; for i in plain turned; do gnomon render square.obj --texture $i.jpg "
               "-o $i.png --size 8x8; done; cmp plain.png turned.png");
    run r = gnomon("info turned.jpg");
    expect_good(&r);
    expect_printed(&r, "size        16x8\n");
    expect_printed(&r, "orientation 6 in its Exif data, which is not applied\n");
    r = gnomon("info plain.jpg");
    assert_null(strstr(r.out, "orientation"));
    /* Once, though two materials and two kinds of maps name it. */
    write_text("skin.mtl", "newmtl a\nmap_Kd turned.jpg\nmap_Ks turned.jpg\n"
                           "newmtl b\nmap_Kd turned.jpg\nKd 1 0 0\n");
    write_odd("named.obj", "f 1/1/1 2",
              "mtllib skin.mtl\nusemtl a\nf 1/1/1 3/3/1 2/2/1\nusemtl b\nf 1/1/1 2");
    expect_warning("named.obj", "turned.jpg: warning", "not applied");
    remove_file("skin.mtl");
}

/* The beginning of a file is refused as cut short, drawn with a warning, or complete. Tests every
 * seventh length, and all lengths that end within the faces. */
TEST(cut_models_are_named)
{
    static const char text[] = "# a model\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
                               "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
                               "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\n";
    static const char nul[] = "v 0 0 0\nv 1 0 0\nv \0 1 0\nf 1 2 3\n";
    for (size_t size = 0; size < sizeof text; size += size + 45 < sizeof text ? 7 : 1) {
        write_bytes("cut.obj", text, size);
        run r = gnomon("render cut.obj -o a.png --size 8x8");
        const size_t whole = (size_t)(strstr(text, "f 1") - text) + strlen("f 1/1/1 2/2/1 3/3");
        /* Vertices alone are points, and two corners a line, with a warning. */
        if (r.status == 0 ? size <= whole && lines(r.error) != 1
                          : lines(r.error) != 1 || strstr(r.error, "cut.obj: ") == NULL)
            fail_msg("%zu bytes: status %d, %s", size, r.status, r.error);
    }
    write_text("cut.obj", "v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n");
    expect(1, "render cut.obj -o b.png",
           "cut.obj ... line 2: v takes 3, 4, 6, 7 or 8 numbers, not 2");
    write_bytes("cut.obj", nul, sizeof nul - 1);
    expect(1, "render cut.obj -o b.png", "cut.obj ... it has a NUL byte");
    write_text("cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty "
                          "float y\nproperty float z\nend_header\n0 0 0\n1 0 0\n0 1");
    expect(1, "render cut.ply -o b.png", "cut.ply ... cut short");
    write_text("cut.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                          "vertex 0 1 0\nendloop\nendfacet\n");
    expect_warning("cut.stl", "endsolid", "cut short");
}

/* The formats, each with its own ending, at a few dozen lengths. */
TEST(cut_pictures_are_named)
{
    static const char names[][8] = {"t.png", "t.jpg", "t.tga", "t.bmp"};
    uint8_t texels[32 * 32 * 3], bytes[8192];
    for (int i = 0; i < 32 * 32 * 3; ++i)
        texels[i] = (uint8_t)(i * 37 + i / 96 * 5);
    stbi_write_png(path_of("t.png"), 32, 32, 3, texels, 0);
    stbi_write_jpg(path_of("t.jpg"), 32, 32, 3, texels, 95);
    stbi_write_tga(path_of("t.tga"), 32, 32, 3, texels);
    stbi_write_bmp(path_of("t.bmp"), 32, 32, 3, texels);
    for (int i = 0; i < 4; ++i) {
        const size_t size = read_file(names[i], bytes, sizeof bytes);
        write_bytes("cut.map", bytes, size);
        expect_warning("square.obj --texture cut.map", NULL, "");
        for (size_t k = 1; k < 24; k += k < 20 ? 2 : 1) {
            size_t length = k < 10 ? k * k : k < 20 ? size * (k - 9) / 11 : size - (24 - k) * 4;
            /* A JPEG without its last marker is complete. A TGA shorter than its header is
             * not recognised as one. */
            if ((i == 1 && length + 3 > size) || (i == 2 && length < 18))
                continue;
            write_bytes("cut.map", bytes, length);
            expect(1, "render square.obj -o b.png --texture cut.map",
                   "cut.map ... the file is cut short");
        }
    }
    write_bytes("cut.map", "", 0);
    expect(1, "render square.obj -o b.png --texture cut.map", "cut.map ... the file is empty");
}

/* A byte order mark, with which some editors begin a text. */
TEST(byte_order_marks_are_accepted)
{
    write_text("marked.mtl", "\xef\xbb\xbfnewmtl skin\nKd 1 0 0\n");
    write_square("marked.obj", "\xef\xbb\xbfmtllib marked.mtl\nusemtl skin\n");
    expect_color("marked.obj --shader vertex-color", 0xff0000ff);
    write_text("marked.ply",
               "\xef\xbb\xbfply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
               "property float y\nproperty float z\nelement face 1\nproperty list "
               "uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    expect_warning("marked.ply", NULL, "");
}

/* Names come from files, and a terminal must not act on them. */
TEST(bytes_are_escaped)
{
    expect(1, "render \"$(printf 'a\\033[31m\\n\\377\\302\\205\\303\\274.obj')\" -o a.png",
           "a\\x1b[31m\\x0a\\xff\\xc2\\x85\xc3\xbc.obj ... No such file");
    write_square("named.obj", "mtllib a\033[2J.mtl\n");
    expect_warning("named.obj", "'a\\x1b[2J.mtl'", "No such file");
    /* On standard output too. */
    write_color("m\033.png", 1, 2, 3);
    run r = good("render square.obj --texture \"$(printf 'm\\033.png')\" -o \"$(printf "
                 "'o\\007.png')\" --size 8x8");
    expect_printed(&r, "o\\x07.png: 8x8");
    expect_printed(&r, "maps: diffuse m\\x1b.png\n");
    r = good("compare square.obj -o \"$(printf 'o\\007.png')\" --size 8x8");
    expect_printed(&r, "\no\\x07.png: Gnomon");
}
