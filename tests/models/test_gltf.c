/* glTF: container, version, buffers, accessors and primitives. Sections are those of the glTF 2.0
 * specification. */
#include "gltf_test.h"

#define AT "/meshes/0/primitives/0/"
#define POSITION(number) GLTF_MESH("'attributes':{'POSITION':" number "}")
#define INDEXED(number) GLTF_MESH("'indices':" number ",'attributes':{'POSITION':0}")
#define WRONG_TYPE "its accessor is of a type that the attribute cannot have"

static void test_triangle(void **state)
{
    const float white[4] = {1, 1, 1, 1};
    gltf_begin_triangle();
    expect_read(gltf_read(GLTF_TRIANGLE), NULL);
    const model_part *const p = read_model.parts;
    assert_int_equal(read_model.part_count, 1);
    expect_sizes(p, MODEL_TRIANGLES, 3, 3);
    expect_floats(p->positions, gltf_corner, 9);
    expect_floats(p->normals, gltf_up, 9);
    assert_true(p->has_normals && !p->has_texcoords && !p->has_tangents && !p->has_vertex_colors);
    /* Section 3.9.2: the default material is white, all metal and rough. */
    expect_floats(p->colors, white, 4);
    assert_true(p->surface.is_metallic_roughness && p->surface.metallic == 1.0f &&
                p->surface.roughness == 1.0f);
    assert_int_equal(read_model.material_count, 0);
}

/* Section 3.2: minor versions can be read if minVersion does not forbid it. */
static void test_no_gltf(void **state)
{
    static const refusal cases[] = {
        {"{", "line 1: the text ends within a value"},
        {"[]", "is not a glTF file: it does not begin with {"},
        {"{}", "/asset/version: there is none, so that this is no glTF 2.0"},
        {"{'asset':{'version':'1.0'}}",
         "/asset/version: this is glTF 1.0, but only glTF 2.0 is read"},
        {"{'asset':{'version':'3.0'}}",
         "/asset/version: this is glTF 3.0, but only glTF 2.0 is read"},
        {"{'asset':{'version':'2.1','minVersion':'2.1'}}",
         "/asset/minVersion: this is glTF 2.1, but only glTF 2.0 is read"},
        {"{'asset':{'version':'2.1','minVersion':'2.0'}}",
         "there are no triangles, lines or points in it"},
        {"{'asset':{'version':'2.0'},'meshes':{}}", "/meshes: is no array"},
        {"{'asset':{'version':'2.0'},'meshes':[1]}", "/meshes/0: is no object"}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        snprintf(gltf_text, sizeof gltf_text, "%s", cases[i].rest);
        gltf_quotes(gltf_text);
        expect_fault(gltf_read_again(NULL), cases[i].fault);
    }
}

static void put_word(uint8_t *to, size_t word)
{
    for (int i = 0; i < 4; ++i)
        to[i] = (uint8_t)(word >> 8 * i);
}

/* Writes the container of the text and the buffer (section 4.4). Returns its size. */
static size_t make_container(uint8_t *to)
{
    size_t text = strlen(gltf_text), bytes = (gltf_size + 3) / 4 * 4;
    do
        gltf_text[text++] = ' ';
    while (text % 4 != 0);
    gltf_text[text] = '\0';
    const size_t size = 12 + 8 + text + 8 + bytes;
    memset(to, 0, size);
    memcpy(to, "glTF", 4);
    put_word(to + 4, 2);
    put_word(to + 8, size);
    put_word(to + 12, text);
    memcpy(to + 16, "JSON", 4);
    memcpy(to + 20, gltf_text, text);
    put_word(to + 20 + text, bytes);
    memcpy(to + 24 + text, "BIN\0", 4);
    memcpy(to + 28 + text, gltf_bytes, gltf_size);
    return size;
}

static void test_container(void **state)
{
    static uint8_t file[16384];
    gltf_begin_triangle();
    /* One byte less than a multiple of 4: the chunk is padded. */
    gltf_view("abc", 3);
    gltf_write(GLTF_TRIANGLE, NULL);
    const size_t size = make_container(file), text = strlen(gltf_text);
    expect_read(read_bytes(MODEL_GLB, "a.glb", file, size, NULL), NULL);
    expect_floats(read_model.parts->positions, gltf_corner, 9);
    /* The contents decide, not the extension. */
    expect_read(read_bytes(MODEL_GLTF, "a.gltf", file, size, NULL), NULL);
    for (size_t less = 1; less < size; ++less) {
        assert_false(read_bytes(MODEL_GLB, "a.glb", file, less, NULL));
        assert_string_not_equal(read_messages.fault, "");
    }
    expect_fault(read_bytes(MODEL_GLB, "a.glb", file + 20, size - 20, NULL),
                 "this is no binary glTF: it does not begin with 'glTF'");
    expect_read(read_bytes(MODEL_GLB, "a.glb", file, size + 4, NULL),
                "a.glb: bytes behind the end that the header names are left out (1)");
    for (size_t i = 20 + text; file[i - 1] == ' '; --i)
        file[i - 1] = '\0';
    expect_read(read_bytes(MODEL_GLB, "a.glb", file, size, NULL), NULL);
    put_word(file + 20 + text, 80);
    expect_fault(read_bytes(MODEL_GLB, "a.glb", file, size, NULL),
                 "chunk 1 has 80 bytes, but only 76 follow");
    file[16] = 'X';
    expect_fault(read_bytes(MODEL_GLB, "a.glb", file, size, NULL),
                 "the first chunk is not the JSON");
    put_word(file + 4, 1);
    expect_fault(read_bytes(MODEL_GLB, "a.glb", file, size, NULL),
                 "this is binary glTF of version 1, but only version 2 is read");
}

static void test_extensions(void **state)
{
    gltf_begin_triangle();
    gltf_refuse(GLTF_TRIANGLE ",'extensionsRequired':['KHR_draco_mesh_compression']",
                "/extensionsRequired/0: the file requires the extension "
                "KHR_draco_mesh_compression, which is not read");
    expect_warnings(
        gltf_read(GLTF_TRIANGLE ",'extensionsRequired':['KHR_mesh_quantization'],"
                                "'extensionsUsed':['KHR_materials_sheen',"
                                "'KHR_mesh_quantization','KHR_materials_volume']"),
        2, "a.gltf: /extensionsUsed/0: the extension KHR_materials_sheen is not drawn (1)");
    assert_true(has_warning(
        "a.gltf: /extensionsUsed/2: the extension KHR_materials_volume is not drawn (1)"));
}

/* Files beside the model. Section 3.6.1.1: data: URIs. Of the buffer's three indices 1, 2 and 3,
 * the first vertex is not needed. */
static void test_buffers(void **state)
{
    static const test_file files[] = {
        {"a b.bin", "\1\2\3", 3}, {"short.bin", "\1\2", 2}, {NULL, NULL, 0}};
    static const struct {
        const char *uri, *fault;
    } cases[] = {
        {"a%20b.bin", NULL},
        {"a\\u0020b.bin", NULL},
        {"short.bin", "/buffers/0: has 2 bytes, but its byteLength is 3"},
        {"c.bin", "/buffers/0/uri: the file 'c.bin' cannot be read: No such file or directory"},
        {"a%00b", "/buffers/0/uri: names no file"},
        {NULL, "/buffers/0: has no uri"},
        {"data:;base64,AQID", NULL},
        {"data:text/plain;base64,AQID+/8=", NULL},
        {"data:;base64,AQIDBA", NULL},
        {"data:;base64,AQIDBA==", NULL},
        {"data:;base64,AQI\\u0044", NULL},
        {"data:,%01%02%03", NULL},
        {"data:x4,%01%02%03", NULL},
        {"data:;base64,AQ*D", "/buffers/0/uri: is a data: URI whose base64 is wrong"},
        {"data:;base64,AQIDB", "/buffers/0/uri: is a data: URI whose base64 is wrong"},
        {"data:;base64", "/buffers/0/uri: is a data: URI without a comma"},
        {"data:;base64,AQI=", "/buffers/0: has 2 bytes, but its byteLength is 3"}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        gltf_begin();
        gltf_array("SCALAR", T_U8, 3, "\1\2\3", 3);
        gltf_accessor("VEC3", T_F32, 4, "");
        gltf_write(GLTF_MESH("'mode':0,'indices':0,'attributes':{'POSITION':1}"), cases[i].uri);
        const bool good = gltf_read_again(files);
        if (cases[i].fault != NULL) {
            expect_fault(good, cases[i].fault);
            continue;
        }
        expect_read(good, NULL);
        assert_int_equal(read_model.parts->vertex_count, 3);
    }
}

/* A view may end behind its buffer, also where the sum does not fit 64 bits. A small file cannot
 * ask for work without end. */
static void test_accessor_faults(void **state)
{
    static const struct {
        const char *members, *fault;
    } cases[] = {
#define VECTORS "'type':'VEC3','componentType':5126,'count':"
        {VECTORS "3,'bufferView':1", "/bufferView: is 1, but there are 1 bufferViews"},
        {VECTORS "3,'bufferView':0,'byteOffset':4",
         ": its 3 elements end at byte 40, but the bufferView has only 36"},
        {VECTORS "3,'bufferView':0,'byteOffset':9007199254740992",
         ": its 3 elements end at byte 9007199254741028, but the bufferView has only 36"},
        {VECTORS "3,'bufferView':0,'byteOffset':-1",
         "/byteOffset: is no integer from 0 to 9007199254740992"},
        {VECTORS "3,'bufferView':0.5", "/bufferView: is no integer from 0 to 4294967294"},
        {"'type':'VEC3','componentType':5124,'count':3,'bufferView':0",
         ": componentType is 5124, which is none"},
        {"'type':'VEC5','componentType':5126,'count':3",
         ": its type is none of SCALAR, VEC2, VEC3, VEC4 and MAT4"},
        {VECTORS "0", ": has no elements"},
        {VECTORS "4294967295,'bufferView':0",
         ": its 4294967295 elements end at byte 51539607540, but the bufferView has only 36"}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char fault[256];
        gltf_begin();
        gltf_view(gltf_corner, sizeof gltf_corner);
        gltf_append(gltf_accessors, sizeof gltf_accessors, "{%s}", cases[i].members);
        snprintf(fault, sizeof fault, "/accessors/0%s", cases[i].fault);
        gltf_refuse(GLTF_POSITIONS, fault);
    }
    gltf_begin();
    gltf_append(gltf_views, sizeof gltf_views,
                "{'buffer':0,'byteOffset':9007199254740992,'byteLength':9007199254740992}");
    gltf_accessor("VEC3", T_F32, 3, "'bufferView':0");
    gltf_refuse(GLTF_POSITIONS,
                "/bufferViews/0: ends at byte 18014398509481984, but its buffer has only 0");
    gltf_accessor("VEC3", T_F32, 4294967295U, "");
    gltf_refuse(POSITION("1"), AT "attributes/POSITION: has 4294967295 elements without a "
                                  "bufferView; at most 65536 are read");
    gltf_begin();
    gltf_accessor("VEC3", T_F32, 65536, "");
    assert_int_equal(gltf_part(GLTF_MESH("'mode':0,'attributes':{'POSITION':0}"))->vertex_count,
                     65536);
}

static void test_stride(void **state)
{
    /* Positions with a float between them, which begin behind one. */
    static const float spread[] = {9, 0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0};
    gltf_begin();
    memcpy(gltf_bytes, spread, sizeof spread);
    gltf_size = sizeof spread;
    gltf_append(gltf_views, sizeof gltf_views,
                "{'buffer':0,'byteLength':48,'byteStride':16},"
                "{'buffer':0,'byteLength':48,'byteStride':8}");
    gltf_accessor("VEC3", T_F32, 3, "'bufferView':0,'byteOffset':4");
    gltf_accessor("VEC3", T_F32, 3, "'bufferView':1");
    expect_floats(gltf_part(GLTF_POSITIONS)->positions, gltf_corner, 9);
    gltf_refuse(POSITION("1"), "/bufferViews/1: byteStride is 8, but elements have 12 bytes");
}

/* Section 3.6.2.3: of an array of zeros, elements 1 and 2 are replaced. */
static void test_sparse(void **state)
{
    static const float values[] = {1, 0, 0, 0, 1, 0};
    static const uint16_t indices[] = {1, 2, 2, 1, 1, 3};
    static const char *const faults[] = {
        NULL, "/accessors/0/sparse/indices: an index is 1, which does not grow or is not below 3",
        "/accessors/0/sparse/indices: an index is 3, which does not grow or is not below 3"};
    for (int i = 0; i < 3; ++i) {
        char more[256];
        gltf_begin();
        const unsigned first = gltf_view(indices + 2 * i, 4), second = gltf_view(values, 24);
        snprintf(more, sizeof more,
                 "'sparse':{'count':2,'indices':{'bufferView':%u,'componentType':5123},"
                 "'values':{'bufferView':%u}}",
                 first, second);
        gltf_accessor("VEC3", T_F32, 3, more);
        if (faults[i] != NULL)
            gltf_refuse(GLTF_POSITIONS, faults[i]);
        else
            expect_floats(gltf_part(GLTF_POSITIONS)->positions, gltf_corner, 9);
    }
}

/* Section 3.6.2.2: f = c / 255, c / 65535, max(c / 127, -1), max(c / 32767, -1).
 * KHR_mesh_quantization: integers as they are. */
static void test_component_types(void **state)
{
    static const int8_t bytes[9] = {-128, -127, 0, 127, 64, 1, 0, 127, 0};
    static const uint8_t colors[12] = {255, 0, 51, 255, 102, 255, 0, 0, 0, 0, 0, 255};
    static const int16_t shorts[9] = {-32768, -32767, 0, 32767, 16384, 1, 0, 32767, 0};
    static const uint16_t texcoords[6] = {65535, 0, 0, 65535, 13107, 0};
    static const uint16_t positions[9] = {0, 0, 0, 1000, 0, 0, 0, 65535, 0};
    const float position[6] = {-1, -1, 0, 1, 64.0f / 127.0f, 1.0f / 127.0f};
    const float normal[6] = {-1, -1, 0, 1, 16384.0f / 32767.0f, 1.0f / 32767.0f};
    const float color[8] = {1, 0, 0.2f, 1, 0.4f, 1, 0, 0};
    const float texcoord[6] = {1, 1, 0, 0, 0.2f, 1}; /* t = 1 - v */
    const float integers[9] = {0, 0, 0, 1000, 0, 0, 0, 65535, 0};
    gltf_begin();
    GLTF_FRACTIONS("VEC3", T_I8, 3, bytes);
    GLTF_FRACTIONS("VEC4", T_U8, 3, colors);
    GLTF_FRACTIONS("VEC3", T_I16, 3, shorts);
    GLTF_FRACTIONS("VEC2", T_U16, 3, texcoords);
    GLTF_ARRAY("VEC3", T_U16, 3, positions);
    const model_part *p = gltf_part("'materials':[{'alphaMode':'BLEND'}]," GLTF_MESH(
        "'material':0,'attributes':{'POSITION':0,'NORMAL':2,'COLOR_0':1,'TEXCOORD_0':3}"));
    expect_floats(p->positions, position, 6);
    expect_floats(p->normals, normal, 6);
    expect_floats(p->colors, color, 8);
    expect_floats(p->texcoords, texcoord, 6);
    p = gltf_part(POSITION("4"));
    expect_floats(p->positions, integers, 9);
}

static void test_attribute_faults(void **state)
{
    static const refusal cases[] = {
        {GLTF_ATTRIBUTES(",'NORMAL':2"),
         AT "attributes/NORMAL: has 2 elements, but POSITION has 3"},
        {POSITION("3"), AT "attributes/POSITION: " WRONG_TYPE},
        {POSITION("4"), AT "attributes/POSITION: " WRONG_TYPE},
        {POSITION("9"), AT "attributes/POSITION: is 9, but there are 5 accessors"},
        {"'nodes':[{'mesh':0}],'meshes':[{'primitives':{}}]", "/meshes/0/primitives: is no array"}};
    gltf_begin_triangle();
    gltf_array("VEC3", T_F32, 2, gltf_corner, 24);
    gltf_array("VEC2", T_F32, 3, gltf_corner, 24);
    gltf_array("VEC3", T_U32, 3, gltf_corner, 36);
    GLTF_REFUSE_ALL(cases);
    expect_warnings(
        gltf_read(GLTF_ATTRIBUTES(",'NORMAL':1,'_ID':0,'COLOR_1':1,'FOO':0") ",'extras'"
                                                                             ":{'a':[1]}"),
        2, "a.gltf: /meshes/0/primitives/0/attributes: COLOR_1 is not drawn (1)");
    assert_true(has_warning("a.gltf: /meshes/0/primitives/0/attributes: FOO is not drawn (1)"));
    assert_false(gltf_read(GLTF_MESH("'attributes':{'NORMAL':1}")));
    assert_true(
        has_warning("a.gltf: /meshes/0/primitives/0: has no POSITION and is not drawn (1)"));
}

static void test_index_faults(void **state)
{
    static const uint32_t words[3] = {0, 1, 4000000000U};
    static const refusal cases[] = {
        {INDEXED("2"), AT "indices: an index is 9, but POSITION has 3 vertices"},
        {INDEXED("3"), AT "indices: an index is 255, the value that restarts primitives elsewhere "
                          "and is not allowed"},
        {INDEXED("4"), AT "indices: an index is 4000000000, but POSITION has 3 vertices"},
        {INDEXED("0"), AT "indices: its accessor has no single unsigned integers"},
        {GLTF_MESH("'mode':7,'attributes':{'POSITION':0}"), AT "mode: is no integer from 0 to 6"}};
    gltf_begin_triangle();
    gltf_array("SCALAR", T_U8, 3, "\0\1\11", 3);
    gltf_array("SCALAR", T_U8, 3, "\0\1\377", 3);
    GLTF_ARRAY("SCALAR", T_U32, 3, words);
    GLTF_REFUSE_ALL(cases);
}

/* Section 3.7.2.1: what five vertices are in each mode; triangles without a mode. */
static void test_modes(void **state)
{
    static const struct {
        model_kind kind;
        uint32_t count, indices[12];
    } cases[] = {{MODEL_POINTS, 5, {0, 1, 2, 3, 4}},
                 {MODEL_LINES, 4, {0, 1, 2, 3}},
                 {MODEL_LINES, 10, {0, 1, 1, 2, 2, 3, 3, 4, 4, 0}},
                 {MODEL_LINES, 8, {0, 1, 1, 2, 2, 3, 3, 4}},
                 {MODEL_TRIANGLES, 3, {0, 1, 2}},
                 {MODEL_TRIANGLES, 9, {0, 1, 2, 1, 3, 2, 2, 3, 4}},
                 {MODEL_TRIANGLES, 9, {1, 2, 0, 2, 3, 0, 3, 4, 0}},
                 {MODEL_TRIANGLES, 3, {0, 1, 2}}};
    static const float positions[15] = {0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1, 0, 2, 1};
    gltf_begin();
    GLTF_ARRAY("VEC3", T_F32, 5, positions);
    for (int i = 0; i < 8; ++i) {
        char mode[32] = "", text[256];
        if (i < 7)
            snprintf(mode, sizeof mode, "'mode':%d,", i);
        snprintf(text, sizeof text, GLTF_MESH("%s'attributes':{'POSITION':0,'NORMAL':0}"), mode);
        const bool has_rest = i == 1 || i == 4 || i == 7;
        expect_read(gltf_read(text), has_rest ? "a.gltf: /meshes/0/primitives/0: the last indices "
                                                "are no whole primitive; they are left out (1)"
                                              : NULL);
        const model_part *const p = read_model.parts;
        expect_sizes(p, cases[i].kind, p->vertex_count, cases[i].count);
        assert_memory_equal(p->indices, cases[i].indices, cases[i].count * sizeof(uint32_t));
    }
}

/* Indices name a range of the vertices; strips are joined by triangles without area. */
static void test_indices(void **state)
{
    static const float positions[18] = {9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 9, 9, 9};
    static const uint8_t indices[8] = {1, 2, 3, 3, 4, 4, 2, 3};
    static const uint32_t expected[6] = {0, 1, 2, 3, 2, 1};
    gltf_begin();
    GLTF_ARRAY("VEC3", T_F32, 6, positions);
    GLTF_ARRAY("SCALAR", T_U8, 8, indices);
    gltf_array("SCALAR", T_U8, 3, "\1\2\3", 3);
    const model_part *p =
        gltf_part(GLTF_MESH("'mode':5,'indices':1,'attributes':{'POSITION':0,'NORMAL':0}"));
    assert_int_equal(read_messages.warning_count, 0);
    expect_sizes(p, MODEL_TRIANGLES, 4, 6);
    expect_floats(p->positions, positions + 3, 12);
    /* The triangle of the last three, 4, 2 and 3, is number 5: its last corners are exchanged. */
    assert_memory_equal(p->indices, expected, sizeof expected);
    /* Without normals vertices are not shared. */
    p = gltf_part(INDEXED("2"));
    expect_floats(p->positions, gltf_corner, 9);
    expect_floats(p->normals, gltf_up, 9);
}

/* Section 3.7.2.1: without normals they are flat, and vertices are not shared. TANGENT is then
 * ignored. */
static void test_flat_normals(void **state)
{
    static const float positions[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const float tangents[16] = {0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1};
    static const uint16_t indices[6] = {0, 1, 2, 0, 2, 3};
    static const float expected[18] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 1, 0, 0};
    static const float corners[18] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1};
    static const uint32_t numbers[6] = {0, 1, 2, 3, 4, 5};
    gltf_begin();
    GLTF_ARRAY("VEC3", T_F32, 4, positions);
    GLTF_ARRAY("SCALAR", T_U16, 6, indices);
    GLTF_ARRAY("VEC4", T_F32, 4, tangents);
    gltf_array("VEC2", T_F32, 4, positions, 32);
    const model_part *const p =
        gltf_part(GLTF_MESH("'indices':1,'attributes':{'POSITION':0,'TANGENT':2,'TEXCOORD_0':3}"));
    assert_false(p->has_normals);
    assert_int_equal(p->vertex_count, 6);
    expect_floats(p->positions, corners, 18);
    expect_floats(p->normals, expected, 18);
    assert_memory_equal(p->indices, numbers, sizeof numbers);
    for (int i = 0; i < 3; ++i)
        assert_true(p->tangents[4 * i + 1] < 0.9f);
}

/* More triangles than are worked on at a time. */
static void test_many_vertices(void **state)
{
    static float positions[3 * 300];
    gltf_begin();
    for (int i = 0; i < 100; ++i) {
        memcpy(positions + 9 * i, gltf_corner, sizeof gltf_corner);
        positions[9 * i + 2] = positions[9 * i + 5] = positions[9 * i + 8] = (float)i;
    }
    GLTF_ARRAY("VEC3", T_F32, 300, positions);
    const model_part *const p = gltf_part(GLTF_POSITIONS);
    expect_floats(p->positions, positions, 900);
    for (size_t i = 0; i < 300; ++i)
        expect_floats(p->normals + 3 * i, gltf_up, 3);
}

static void test_numbers_that_are_not_finite(void **state)
{
    static const uint32_t bits[9] = {0, 0, 0, 0x3f800000, 0, 0, 0, 0x7fc00000, 0};
    const float normals[9] = {0, 0, 1, 1, 0, 0, 0, 0, 1};
    gltf_begin_triangle();
    GLTF_ARRAY("VEC3", T_F32, 3, bits);
    gltf_refuse(POSITION("2"), "the position of a vertex is not a finite number");
    /* A normal of length 0 and one that is none are computed. */
    expect_read(gltf_read(GLTF_ATTRIBUTES(",'NORMAL':2")),
                "a.gltf: 1 vertex has a normal that is not finite; it is computed from the "
                "triangles (1)");
    expect_floats(read_model.parts->normals, normals, 9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_triangle),        cmocka_unit_test(test_no_gltf),
        cmocka_unit_test(test_container),       cmocka_unit_test(test_extensions),
        cmocka_unit_test(test_buffers),         cmocka_unit_test(test_accessor_faults),
        cmocka_unit_test(test_stride),          cmocka_unit_test(test_sparse),
        cmocka_unit_test(test_component_types), cmocka_unit_test(test_attribute_faults),
        cmocka_unit_test(test_index_faults),    cmocka_unit_test(test_modes),
        cmocka_unit_test(test_indices),         cmocka_unit_test(test_flat_normals),
        cmocka_unit_test(test_many_vertices),   cmocka_unit_test(test_numbers_that_are_not_finite),
    };
    return cmocka_run_group_tests(tests, NULL, forget_last_model);
}
