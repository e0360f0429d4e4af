/* The command draws the square from every format that it names. Assimp writes the files, except
 * binary FBX, whose writer leaves out ends that its reader needs. */
#include "runner.h"

#include <assimp/cexport.h>
#include <assimp/cimport.h>
#include <assimp/scene.h>
#include <stdio.h>
#include <stdlib.h>
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
    run r = gnomon("render %s -o a.png %s --size 16x8 --shader flat", name,
                   strstr(name, ".3ds") != NULL ? ABOVE : FRONT);
    /* Assimp 5.4 lists extensions of glTF that the file does not use, which is warned of. */
    const bool warned = strstr(name, ".gl") != NULL && strstr(r.error, "/extensionsUsed/") != NULL;
    if (r.status != 0 || (r.error[0] != '\0' && !warned) ||
        strstr(r.out, "2 triangles, flat") == NULL)
        fail_msg("%s: status %d, %s%s", name, r.status, r.out, r.error);
    picture p = picture_read("a.png");
    for (uint32_t y = 0; y < 8; ++y) {
        for (uint32_t x = 0; x < 16; ++x) {
            bool inside = x >= 4 && x < 12;
            if ((pixel(&p, x, y) != 0xedeeefff) != inside)
                fail_msg("%s: %08x at %u, %u", name, (unsigned)pixel(&p, x, y), (unsigned)x,
                         (unsigned)y);
        }
    }
    picture_free(&p);
}

TEST(formats_are_read)
{
    char original[512];
    write_text("original.obj", square_obj);
    snprintf(original, sizeof original, "%s", path_of("original.obj"));
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

/* A binary FBX file, version 7400. A node has the position of its end, the number and size of its
 * properties, its name, these properties, and the nodes within it, which end with 13 zeros. */
static struct {
    uint8_t bytes[4096];
    size_t size;
} fbx;

static void put(const void *bytes, size_t size)
{
    memcpy(fbx.bytes + fbx.size, bytes, size);
    fbx.size += size;
}

static void put_32(uint32_t value)
{
    const uint8_t bytes[4] = {(uint8_t)value, (uint8_t)(value >> 8), (uint8_t)(value >> 16),
                              (uint8_t)(value >> 24)};
    put(bytes, 4);
}

static void set_32(size_t place, uint32_t value)
{
    size_t size = fbx.size;
    fbx.size = place;
    put_32(value);
    fbx.size = size;
}

static size_t node_begin(const char *name)
{
    size_t start = fbx.size;
    uint8_t length = (uint8_t)strlen(name);
    put("\0\0\0\0\0\0\0\0\0\0\0\0", 12);
    put(&length, 1);
    put(name, length);
    return start;
}

/* Behind the last property. */
static void properties_end(size_t start, uint32_t count)
{
    set_32(start + 4, count);
    set_32(start + 8, (uint32_t)(fbx.size - start - 13 - fbx.bytes[start + 12]));
}

static void node_end(size_t start, bool has_nodes)
{
    static const uint8_t zeros[13];
    if (has_nodes)
        put(zeros, sizeof zeros);
    set_32(start, (uint32_t)fbx.size);
}

static void put_string(const char *text, size_t length)
{
    put("S", 1);
    put_32((uint32_t)length);
    put(text, length);
}

static void put_id(uint32_t id)
{
    put("L", 1);
    put_32(id);
    put_32(0);
}

static void put_int(uint32_t value)
{
    put("I", 1);
    put_32(value);
}

TEST(binary_fbx_is_read)
{
    static const double corners[12] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
    static const uint32_t indices[6] = {0, 1, (uint32_t)-3, 0, 2, (uint32_t)-4};
    fbx.size = 0;
    put("Kaydara FBX Binary  \0\x1a\0", 23);
    put_32(7400);
    size_t header = node_begin("FBXHeaderExtension");
    properties_end(header, 0);
    size_t version = node_begin("FBXVersion");
    put_int(7400);
    properties_end(version, 1);
    node_end(version, false);
    node_end(header, true);
    size_t objects = node_begin("Objects");
    properties_end(objects, 0);
    size_t geometry = node_begin("Geometry");
    put_id(1);
    put_string("square\0\1Geometry", 16);
    put_string("Mesh", 4);
    properties_end(geometry, 3);
    size_t vertices = node_begin("Vertices");
    put("d", 1);
    put_32(12);
    put_32(0);
    put_32(sizeof corners);
    for (int i = 0; i < 12; ++i) {
        uint64_t bits;
        memcpy(&bits, corners + i, sizeof bits);
        put_32((uint32_t)bits);
        put_32((uint32_t)(bits >> 32));
    }
    properties_end(vertices, 1);
    node_end(vertices, false);
    size_t polygons = node_begin("PolygonVertexIndex");
    put("i", 1);
    put_32(6);
    put_32(0);
    put_32(24);
    for (int i = 0; i < 6; ++i)
        put_32(indices[i]);
    properties_end(polygons, 1);
    node_end(polygons, false);
    node_end(geometry, true);
    size_t model = node_begin("Model");
    put_id(2);
    put_string("square\0\1Model", 13);
    put_string("Mesh", 4);
    properties_end(model, 3);
    size_t model_version = node_begin("Version");
    put_int(232);
    properties_end(model_version, 1);
    node_end(model_version, false);
    node_end(model, true);
    node_end(objects, true);
    size_t connections = node_begin("Connections");
    properties_end(connections, 0);
    for (uint32_t i = 1; i <= 2; ++i) {
        size_t connection = node_begin("C");
        put_string("OO", 2);
        put_id(i);
        put_id(i == 1 ? 2 : 0);
        properties_end(connection, 3);
        node_end(connection, false);
    }
    node_end(connections, true);
    put("\0\0\0\0\0\0\0\0\0\0\0\0\0", 13);
    write_bytes("binary.fbx", fbx.bytes, fbx.size);
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
