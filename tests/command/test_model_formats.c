/* The command draws the square from every format that it names. Assimp writes the files, except
 * binary FBX: its writer leaves out ends that its reader needs. */
#include "runner.h"

#include <assimp/cexport.h>
#include <assimp/cimport.h>
#include <assimp/scene.h>
#include <stdio.h>
#include <string.h>

/* Assimp's own identifiers. */
static const struct {
    char identifier[12];
    char name[16];
} formats[] = {{"obj", "again.obj"},   {"ply", "text.ply"},       {"plyb", "binary.ply"},
               {"stl", "text.stl"},    {"stlb", "binary.stl"},    {"gltf2", "square.gltf"},
               {"glb2", "square.glb"}, {"collada", "square.dae"}, {"fbxa", "text.fbx"},
               {"3ds", "square.3ds"}};

/* In 3DS files z is up, so the side that faced +z faces +y after Assimp has read the file. */
#define ABOVE "--eye 0,5,0 --up 0,0,-1 --target 0,0,0 --orthographic 2"

static void expect_square(const char *name)
{
    run r = good("render %s -o a.png %s --size 16x8 --shader flat", name,
                 strstr(name, ".3ds") != NULL ? ABOVE : FRONT);
    /* Assimp 5.4 lists extensions of glTF that the file does not use, which is warned of. */
    const bool warned = strstr(name, ".gl") != NULL && strstr(r.error, "/extensionsUsed/") != NULL;
    if (r.error[0] != '\0' && !warned)
        fail_run(&r);
    expect_printed(&r, "2 triangles, flat");
    picture p = picture_read("a.png");
    expect_inside(&p, RECTANGLE(4, 0, 12, 8), 0, BACKGROUND);
    picture_free(&p);
}

TEST(formats_are_read)
{
    char original[512];
    snprintf(original, sizeof original, "%s", path_of("square.obj"));
    const struct aiScene *scene = aiImportFile(original, 0);
    assert_non_null(scene);
    for (size_t i = 0; i < COUNT(formats); ++i) {
        if (aiExportScene(scene, formats[i].identifier, path_of(formats[i].name), 0) != 0)
            fail_msg("%s: %s", formats[i].name, aiGetErrorString());
        expect_square(formats[i].name);
    }
    aiReleaseImport(scene);
}

/* Extensions in capitals mean the same formats. */
TEST(capitals_are_read)
{
    write_text("SQUARE.OBJ", square_obj);
    expect_square("SQUARE.OBJ");
}

/* A binary FBX file, version 7400, compressed: the square as a Geometry with four Vertices and two
 * triangles in PolygonVertexIndex, and a Model of it. */
TEST(binary_fbx_is_read)
{
    good_shell(
        "base64 -d <<END | gzip -d >binary.fbx\n"
        "H4sIAAAAAAACA/NOrExJLEpUcHOKUHDKzEssqlRQYJBieCHDwJDMgABCQHmP1MSU1CLXipLUvOLM/LwwoDAj\n"
        "ELMCMRdQOiy1CCTsCdKKAt4zItjs/klZqcklxW1AMWYgXx2IOdxT83NTS4oqfWAKgwWARHFhaWJRKgMjTDaY\n"
        "BSjom1qcYcoIsTgXpBdoa0lmcmpxCg9UbwLcrg/7UWm4uD0BcXs08f3o4pVQF6iCQiYgP6cyHRgcQIekVnjm\n"
        "paRWZLJB1UlAaZDav////wexmYD4D5QNB4+gwaECCk/f/JTUHB8mWFjwIoUFWAoeEFcZETHADg9+BnwgiQnB\n"
        "5nbOz8sDRgZQV7EeE8QBkiDXOgeDVPn7w+MD7phQrMpgsj4MBAEAMd7yXW8CAAA=\n"
        "END\n");
    expect_square("binary.fbx");
}

/* Assimp reads these too, by extension or contents, but the help does not name them. */
TEST(other_formats_are_refused)
{
    static const char *const names[] = {"square.x",     "square.off", "square.x3d",
                                        "square.blend", "square.dxf", "square",
                                        "square.",      "obj",        ".obj"};
    char line[96];
    for (size_t i = 0; i < COUNT(names); ++i) {
        write_text(names[i], "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
        snprintf(line, sizeof line, "render %s -o b.png", names[i]);
        expect(1, line, "%s ... %s", names[i],
               strcmp(names[i], ".obj") == 0
                   ? "no triangles, lines or points"
                   : "OBJ, PLY, STL, glTF (.gltf, .glb), Collada (.dae), FBX and 3DS");
    }
    /* Contents of such a format under a supported extension are refused too. */
    write_text("text.gltf", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    expect(1, "render text.gltf -o b.png", "text.gltf ... is not a glTF file");
    write_text("text.gltf", "{\"TYPE\":\"irrEdit\", \"x\":\"<mesh xmlns irrmesh>\"}");
    expect(1, "render text.gltf -o b.png", "text.gltf");
}
