/* glTF: where nodes, skins, morph targets and instances put meshes, and lights. Sections are those
 * of the glTF 2.0 specification. */
#include "gltf_test.h"

#define PRIMITIVE "'meshes':[{'primitives':[{'attributes':{'POSITION':0,'NORMAL':1}}]}]"

/* Reads a file with these nodes and the mesh of the triangle. */
#define NODES(nodes) "'nodes':[" nodes "]," PRIMITIVE

/* The mesh of positions alone, whose normals are flat. */
#define FLAT "'meshes':[{'primitives':[{'attributes':{'POSITION':0}}]}]"

/* A file, and the triangle's corners and normals in the part that is made of it. */
typedef struct placed {
    const char *rest;
    float positions[9], normals[9];
} placed;

static void expect_part(const char *rest, const float positions[9], const float normals[9])
{
    const model_part *const p = gltf_part(rest);
    assert_int_equal(read_model.part_count, 1);
    expect_floats(p->positions, positions, 9);
    expect_floats(p->normals, normals, 9);
}

static void test_node_hierarchy(void **state)
{
    static const placed cases[] = {
        /* (1, 0, 0) is doubled to (2, 0, 0), turned by a quarter about z to (0, 2, 0), moved to
         * (0, 2, 3), and by its parent to (10, 2, 3). */
        {"'scene':0,'scenes':[{'nodes':[1]}]," NODES(
             "{'mesh':0,'translation':[0,0,3],'rotation':[0,0,0.70710678118654752,"
             "0.70710678118654752],'scale':[2,2,2]},"
             "{'children':[0],'matrix':[1,0,0,0,0,1,0,0,0,0,1,0,10,0,0,1]}"),
         {10, 0, 3, 10, 2, 3, 8, 0, 3},
         {0, 0, 1, 0, 0, 1, 0, 0, 1}},
        /* A third of a turn about (1, 1, 1) moves x to y, y to z and z to x. */
        {NODES("{'mesh':0,'rotation':[0.5,0.5,0.5,0.5]}"),
         {0, 0, 0, 0, 1, 0, 0, 0, 1},
         {1, 0, 0, 1, 0, 0, 1, 0, 0}},
        /* The other way round; a quaternion of length 2 turns as one of length 1. */
        {NODES("{'mesh':0,'rotation':[-1,-1,-1,1]}"),
         {0, 0, 0, 0, 0, 1, 1, 0, 0},
         {0, 1, 0, 0, 1, 0, 0, 1, 0}},
        /* Flat normals point to the side from which the corners turn to the left. */
        {"'nodes':[{'mesh':0,'scale':[-1,1,1]}]," FLAT,
         {0, 0, 0, 0, 1, 0, -1, 0, 0},
         {0, 0, 1, 0, 0, 1, 0, 0, 1}},
        /* Near coordinates keep their origin: the middle of this one is 9 half sides away. */
        {NODES("{'mesh':0,'translation':[4,0,0],'scale':[1,1,1]}"),
         {4, 0, 0, 5, 0, 0, 4, 1, 0},
         {0, 0, 1, 0, 0, 1, 0, 0, 1}},
        /* Coordinates of maps: every bit of the difference to the middle is kept. */
        {NODES("{'mesh':0,'translation':[500000.25,4500000.5,100.125]}"),
         {-0.5f, -0.5f, 0, 0.5f, -0.5f, 0, -0.5f, 0.5f, 0},
         {0, 0, 1, 0, 0, 1, 0, 0, 1}}};
    gltf_begin_triangle();
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
        expect_part(cases[i].rest, cases[i].positions, cases[i].normals);
    assert_true(read_model.origin[0] == 500000.75 && read_model.origin[1] == 4500001.0 &&
                read_model.origin[2] == 100.125);
}

/* Section 3.5.1: the scene is drawn; without `scene`, the first; without scenes, all root nodes. */
static void test_scenes(void **state)
{
#define TREE NODES("{'mesh':0},{'children':[2]},{'mesh':0}")
#define SCENES "'scenes':[{'nodes':[0]},{'nodes':[0,1]}],"
    static const refusal cases[] = {
        {"'scene':2," SCENES TREE, "/scene: is 2, but there are 2 scenes"},
        {"'scenes':[{}]," TREE, "there are no triangles, lines or points in it"},
        {NODES("{'mesh':0},{'children':[2]},{'children':[1]}"),
         "/nodes/1: the node is its own descendant, or a descendant of such a node"},
        {NODES("{'mesh':0,'children':[0]}"),
         "/nodes/0: the node is its own descendant, or a descendant of such a node"},
        {NODES("{'children':[2]},{'children':[2]},{'mesh':0}"),
         "/nodes/2: the node is a child of two nodes, or twice of one"},
        {NODES("{'children':[7]}"), "/nodes/0/children/0: is 7, but there are 1 nodes"},
        {NODES("{'mesh':0,'scale':[1,1]}"), "/nodes/0/scale: is no array of 3 numbers"},
        {NODES("{'mesh':1}"), "/nodes/0/mesh: is 1, but there are 1 meshes"}};
    gltf_begin_triangle();
    assert_int_equal(gltf_part(SCENES TREE)->index_count, 3);
    assert_int_equal(gltf_part("'scene':1," SCENES TREE)->index_count, 6);
    assert_int_equal(gltf_part(TREE)->index_count, 6);
    GLTF_REFUSE_ALL(cases);
}

/* A chain of nodes, each moved by 1 from its parent. */
static void test_deep_hierarchy(void **state)
{
    static char text[30000];
    const int depth = 400;
    gltf_begin_triangle();
    strcpy(text, "'scenes':[{'nodes':[0]}],'nodes':[");
    for (int i = 0; i < depth; ++i)
        gltf_append(text, sizeof text, "{'translation':[0,0,1],'children':[%d]},", i + 1);
    gltf_append(text, sizeof text, "{'mesh':0}]," PRIMITIVE);
    const model_part *const p = gltf_part(text);
    assert_true(p->positions[2] + (float)read_model.origin[2] == (float)depth);
}

/* Section 3.7.4: a mirroring node turns the winding. Normals go by the inverse transpose: of
 * (1, 0, 1), scaled by (-2, 1, 1), it is (-1/2, 0, 1). */
static void test_mirror(void **state)
{
    static const float normals[9] = {1, 0, 1, 1, 0, 1, 1, 0, 1};
    static const float tangents[12] = {1, 0, -1, 1, 1, 0, -1, 1, 1, 0, -1, 1};
    static const uint32_t expected[3] = {0, 2, 1};
    const float length = sqrtf(1.25f), other = sqrtf(5.0f);
    const float normal[3] = {-0.5f / length, 0, 1 / length};
    const float tangent[4] = {-2 / other, 0, -1 / other, -1};
    gltf_begin_triangle();
    GLTF_ARRAY("VEC3", T_F32, 3, normals);
    GLTF_ARRAY("VEC4", T_F32, 3, tangents);
    gltf_array("VEC2", T_F32, 3, gltf_corner, 24);
    const model_part *const p =
        gltf_part("'nodes':[{'mesh':0,'scale':[-2,1,1]}],'meshes':[{'primitives':[{'attributes':"
                  "{'POSITION':0,'NORMAL':2,'TANGENT':3,'TEXCOORD_0':4}}]}]");
    expect_floats(p->normals, normal, 3);
    expect_floats(p->tangents, tangent, 4);
    assert_memory_equal(p->indices, expected, sizeof expected);
}

/* Tangents of the file are kept, also beside others that are computed. */
static void test_tangents(void **state)
{
    static const float tangents[12] = {0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1};
    static const float texcoords[6] = {0, 0, 1, 0, 0, 1};
    static const float expected[4] = {1, 0, 0, -1}; /* t grows against y */
    gltf_begin_triangle();
    GLTF_ARRAY("VEC4", T_F32, 3, tangents);
    GLTF_ARRAY("VEC2", T_F32, 3, texcoords);
    const model_part *const p = gltf_part(
        "'nodes':[{'mesh':0}],'meshes':[{'primitives':[{'attributes':{'POSITION':0,'NORMAL':1,"
        "'TANGENT':2,'TEXCOORD_0':3}},{'attributes':{'POSITION':0,'NORMAL':1,'TEXCOORD_0':3}}]}]");
    assert_int_equal(read_model.part_count, 1);
    expect_floats(p->tangents, tangents, 12);
    expect_floats(p->tangents + 12, expected, 4);
}

/* Section 3.7.2.2: the weights of the mesh, overridden by those of a node. */
static void test_morph_targets(void **state)
{
#define MORPHED                                                                                    \
    "'meshes':[{'weights':[0.5,0.25],'primitives':[{'attributes':{'POSITION':0,'NORMAL':1},"       \
    "'targets':[{'POSITION':2,'NORMAL':3},{'POSITION':3,'COLOR_0':3}]}]}]"
    static const float moves[9] = {0, 0, 4, 0, 0, 0, 0, 0, 8};
    static const float turns[9] = {2, 0, -2, 0, 0, 0, 0, 0, 0};
    static const float first[9] = {0.5f, 0, 1.5f, 1, 0, 0, 0, 1, 4}, normal[3] = {1, 0, 0};
    static const float second[9] = {2, 0, -2, 1, 0, 0, 0, 1, 0};
    gltf_begin_triangle();
    GLTF_ARRAY("VEC3", T_F32, 3, moves);
    GLTF_ARRAY("VEC3", T_F32, 3, turns);
    expect_read(gltf_read("'nodes':[{'mesh':0}]," MORPHED),
                "a.gltf: /meshes/0/primitives/0/targets/1: morph targets of COLOR_0 are not drawn "
                "(1)");
    expect_floats(read_model.parts->positions, first, 9);
    expect_floats(read_model.parts->normals, normal, 3);
    expect_part("'nodes':[{'mesh':0,'weights':[0,1]}]," MORPHED, second, gltf_up);
    gltf_refuse("'nodes':[{'mesh':0,'weights':[0,'a']}]," MORPHED,
                "/nodes/0/weights/1: is no number that fits");
}

/* A small file cannot ask for work without end. */
static void test_bounded_morphs(void **state)
{
    static char text[50000];
    gltf_begin();
    gltf_accessor("VEC3", T_F32, 65536, "");
    strcpy(text, "'nodes':[{'mesh':0}],'meshes':[{'primitives':[{'mode':0,'attributes':"
                 "{'POSITION':0},'targets':[{}");
    for (int i = 0; i < 16384; ++i)
        gltf_append(text, sizeof text, ",{}");
    gltf_append(text, sizeof text, "]}]}]");
    gltf_refuse(text, "/meshes/0/primitives/0: the model has more vertices than can be drawn");
}

/* Section 3.7.3: joint 1 is moved by (0, 0, 2) from its bind pose, joint 0 is not; the vertices
 * follow joint 0, joint 1 and both. The node of the mesh has no influence. */
static const uint8_t joints[12] = {0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0};
static const float weights[12] = {1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0};
/* Inverse bind matrices. The node of joint 1 is at (0, 5, 2) and was bound at (0, 5, 0). */
static const float bind[32] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                               1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -5, 0, 1};

#define SKINNED                                                                                    \
    "'meshes':[{'primitives':[{'attributes':{'POSITION':0,'NORMAL':1,'JOINTS_0':2,"                \
    "'WEIGHTS_0':3}}]}]"
#define BONES                                                                                      \
    "'nodes':[{'mesh':0,'skin':0,'translation':[7,7,7]},{'children':[2],'translation':[0,5,0]},"   \
    "{'translation':[0,0,2]},{}]," SKINNED

#define SKIN "'skins':[{'joints':[2,1],'inverseBindMatrices':4}],"

static void test_skins(void **state)
{
    static const uint8_t more_joints[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    static const uint8_t more_weights[12] = {255, 0, 0, 0, 0, 0, 0, 0, 255, 0, 0, 0};
    static const float zeros[12] = {0};
    static const uint32_t turned[3] = {0, 2, 1};
    static const struct {
        const char *rest;
        float positions[9];
    } cases[] = {
        {BONES ",'skins':[{'joints':[3,2],'inverseBindMatrices':4}]", {0, 0, 0, 1, 0, 2, 0, 1, 1}},
        {BONES ",'skins':[{'joints':[3,2]}]", {0, 0, 0, 1, 5, 2, 0, 3.5f, 1}},
        /* The second set of joints adds to the first; weights need not sum up to 1. */
        {"'nodes':[{'mesh':0,'skin':0},{'translation':[0,5,2]},{}]," SKIN
         "'meshes':[{'primitives':[{'attributes':{'POSITION':0,'NORMAL':1,'JOINTS_0':2,"
         "'WEIGHTS_0':3,'JOINTS_1':5,'WEIGHTS_1':6}}]}]",
         {0, 0, 1, 1, 0, 2, 0, 1, 1.5f}},
        /* First by the inverse bind matrix, (0, -5, 0), then by half a turn about z. */
        {"'nodes':[{'mesh':0,'skin':0},{'rotation':[0,0,1,0]},{}]," SKIN SKINNED,
         {0, 0, 0, -1, 5, 0, 0, 2.5f, 0}},
        /* If all weights of a vertex are 0, it follows its first joint. */
        {"'nodes':[{'mesh':0,'skin':0},{'translation':[0,0,5]}],'skins':[{'joints':[1,1]}],"
         "'meshes':[{'primitives':[{'attributes':{'POSITION':0,'JOINTS_0':2,'WEIGHTS_0':7}}]}]",
         {0, 0, 5, 1, 0, 5, 0, 1, 5}},
        /* Joints that mirror turn triangles. */
        {"'nodes':[{'mesh':0,'skin':0},{'scale':[-1,1,1]}],'skins':[{'joints':[1,1]}]," SKINNED,
         {0, 0, 0, -1, 0, 0, 0, 1, 0}}};
    static const refusal faults[] = {
        {BONES ",'skins':[{'joints':[3]}]",
         "/meshes/0/primitives/0: a joint of a vertex is 1, but its skin has 1 joints"},
        {BONES ",'skins':[{'joints':[3,9]}]", "/skins/0/joints/1: is 9, but there are 4 nodes"},
        {BONES ",'skins':[{'joints':[3,2,1],'inverseBindMatrices':4}]",
         "/skins/0/inverseBindMatrices: its accessor has no matrix of floats for each of 3 joints"},
        /* JOINTS_0 has unsigned integers. */
        {"'nodes':[{'mesh':0,'skin':0}],'skins':[{'joints':[0]}],'meshes':[{'primitives':"
         "[{'attributes':{'POSITION':0,'JOINTS_0':3,'WEIGHTS_0':3}}]}]",
         "/meshes/0/primitives/0/attributes/JOINTS_0: its accessor is of a type that the attribute "
         "cannot have"},
        {BONES ",'skins':[{}]", "/skins/0: has no joints"}};
    gltf_begin_triangle();
    GLTF_ARRAY("VEC4", T_U8, 3, joints);
    GLTF_ARRAY("VEC4", T_F32, 3, weights);
    GLTF_ARRAY("MAT4", T_F32, 2, bind);
    GLTF_ARRAY("VEC4", T_U8, 3, more_joints);
    GLTF_FRACTIONS("VEC4", T_U8, 3, more_weights);
    GLTF_ARRAY("VEC4", T_F32, 3, zeros);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        const model_part *const p = gltf_part(cases[i].rest);
        expect_floats(p->positions, cases[i].positions, 9);
        expect_floats(p->normals + 2, gltf_up + 2, 1);
    }
    assert_memory_equal(read_model.parts->indices, turned, sizeof turned);
    GLTF_REFUSE_ALL(faults);
}

#define INSTANCES "/nodes/0/extensions/EXT_mesh_gpu_instancing"
#define AT(attributes) "'extensions':{'EXT_mesh_gpu_instancing':{'attributes':{" attributes "}}}"

/* EXT_mesh_gpu_instancing: each instance is moved, turned and scaled within the node. */
static void test_instances(void **state)
{
    static const float moves[6] = {0, 0, 0, 3, 0, 0};
    static const int8_t turns[8] = {0, 0, 0, 127, 0, 0, 127, 0};
    static const float scales[6] = {1, 1, 1, 2, 2, 2};
    /* The second one is turned by half a turn about z; the node moves all by (0, 0, 1). */
    static const float expected[18] = {0, 0, 1, 1, 0, 1, 0, 1, 1, 3, 0, 1, 1, 0, 1, 3, -2, 1};
    static const uint32_t indices[6] = {0, 1, 2, 3, 4, 5};
    gltf_begin_triangle();
    GLTF_ARRAY("VEC3", T_F32, 2, moves);
    GLTF_FRACTIONS("VEC4", T_I8, 2, turns);
    GLTF_ARRAY("VEC3", T_F32, 2, scales);
    gltf_accessor("VEC3", T_F32, 4000000000U, "");
    GLTF_ARRAY("VEC4", T_U8, 3, joints);
    GLTF_ARRAY("VEC4", T_F32, 3, weights);
    const model_part *const p = gltf_part(
        NODES("{'mesh':0,'translation':[0,0,1]," AT("'TRANSLATION':2,'ROTATION':3,'SCALE':4") "}"));
    assert_int_equal(read_model.part_count, 1);
    expect_floats(p->positions, expected, 18);
    assert_memory_equal(p->indices, indices, sizeof indices);
    gltf_refuse(NODES("{'mesh':0," AT("'TRANSLATION':2,'SCALE':0") "}"),
                INSTANCES "/attributes: its attributes have different counts: 2 and 3");
    /* A small file cannot ask for instances without end. */
    gltf_refuse(NODES("{'mesh':0," AT("'TRANSLATION':5") "}"),
                INSTANCES "/attributes/TRANSLATION: has 4000000000 elements without a bufferView; "
                          "at most 65536 are read");
    /* A skin decides where its vertices are. */
    expect_read(
        gltf_read("'nodes':[{'mesh':0,'skin':0," AT(
            "'TRANSLATION':2") "}],"
                               "'skins':[{'joints':[0,0]}],'meshes':[{'primitives':[{'attributes':"
                               "{'POSITION':0,'NORMAL':1,'JOINTS_0':6,'WEIGHTS_0':7}}]}]"),
        "a.gltf: " INSTANCES ": instances of a mesh with a skin are not drawn (1)");
    assert_int_equal(read_model.parts->index_count, 3);
}

#define LIGHTS(lights) "'extensions':{'KHR_lights_punctual':{'lights':[" lights "]}},"
#define LIT(number) "'extensions':{'KHR_lights_punctual':{'light':" number "}}"

static void test_lights(void **state)
{
    static const float down[3] = {0, 0, -1}, up[3] = {0, 1, 0}, color[3] = {4, 2, 0};
    static const float white[3] = {1, 1, 1};
    gltf_begin_triangle();
    expect_read(
        gltf_read("'extensionsUsed':['KHR_lights_punctual']," LIGHTS(
            "{'type':'directional'},{'type':'spot','color':[1,0.5,0],'intensity':4,'range':9,"
            "'spot':{'innerConeAngle':0.25,'outerConeAngle':0.5}},{'type':'point'},{'type':"
            "'spot'}")
                      NODES("{'mesh':0},{" LIT(
                          "0") "},{'translation':[1,2,3],'rotation':"
                               "[0.70710678118654752,0,0,0.70710678118654752],'scale':[3,3,3]," LIT(
                                   "1") "},{" LIT("2") "},{" LIT("3") "}")),
        NULL);
    assert_int_equal(read_model.light_count, 4);
    const model_light *const l = read_model.lights;
    assert_int_equal(l[0].kind, GN_LIGHT_DIRECTIONAL);
    expect_floats(l[0].direction, down, 3);
    expect_floats(l[0].color, white, 3);
    /* A quarter of a turn about x moves -z to y. */
    assert_int_equal(l[1].kind, GN_LIGHT_SPOT);
    expect_floats(l[1].direction, up, 3);
    expect_floats(l[1].color, color, 3);
    assert_true(l[1].position[0] == 1.0 && l[1].position[1] == 2.0 && l[1].position[2] == 3.0);
    assert_true(l[1].range == 9.0f && l[1].inner == 0.25f && l[1].outer == 0.5f);
    assert_int_equal(l[2].kind, GN_LIGHT_POINT);
    assert_true(l[2].range == 0.0f);
    /* The extension's default: a quarter of pi. */
    assert_true(l[3].inner == 0.0f && l[3].outer == 0.785398163f);
    gltf_refuse(LIGHTS("{'type':'area'}") "'nodes':[{" LIT("0") "}]",
                "/extensions/KHR_lights_punctual/lights/0: its type is none of directional, point "
                "and spot");
}

static void test_warnings(void **state)
{
    gltf_begin_triangle();
    expect_warnings(gltf_read("'animations':[{}],'cameras':[{}]," NODES(
                        "{'mesh':0,'matrix':[1,0,0,0.5,0,1,0,0,0,0,1,0,0,0,0,1]}")),
                    3, "a.gltf: /animations: animations are not drawn: the rest pose is (1)");
    assert_true(has_warning("a.gltf: /cameras: cameras are not used (1)"));
    assert_true(has_warning("a.gltf: /nodes/0: the last row of its matrix is not 0 0 0 1, but is "
                            "taken for it (1)"));
}

/* Meshes with one material make one part; attributes and kind divide. */
static void test_merging(void **state)
{
    gltf_begin_triangle();
    gltf_part("'nodes':[{'mesh':0},{'mesh':1},{'mesh':0}],'materials':[{}],'meshes':["
              "{'primitives':[{'attributes':{'POSITION':0,'NORMAL':1}},"
              "{'material':0,'attributes':{'POSITION':0,'NORMAL':1}}]},"
              "{'primitives':[{'attributes':{'POSITION':0,'NORMAL':1}},"
              "{'attributes':{'POSITION':0,'NORMAL':1,'COLOR_0':1}},"
              "{'mode':0,'attributes':{'POSITION':0}},"
              "{'mode':1,'attributes':{'POSITION':0,'NORMAL':1}}]}]");
    assert_int_equal(read_model.part_count, 5);
    assert_int_equal(read_model.material_count, 1);
    assert_int_equal(read_model.parts[0].index_count, 9);
    assert_int_equal(read_model.parts[1].index_count, 6);
    assert_int_equal(read_model.parts[2].index_count, 3);
    assert_int_equal(read_model.parts[3].kind, MODEL_POINTS);
    assert_true(read_model.parts[2].has_vertex_colors);
    /* Section 3.9.6: points without normals are not lit. */
    assert_true(read_model.parts[3].surface.is_unlit && !read_model.parts[0].surface.is_unlit);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_node_hierarchy), cmocka_unit_test(test_scenes),
        cmocka_unit_test(test_deep_hierarchy), cmocka_unit_test(test_mirror),
        cmocka_unit_test(test_tangents),       cmocka_unit_test(test_morph_targets),
        cmocka_unit_test(test_bounded_morphs), cmocka_unit_test(test_skins),
        cmocka_unit_test(test_instances),      cmocka_unit_test(test_lights),
        cmocka_unit_test(test_warnings),       cmocka_unit_test(test_merging),
    };
    return cmocka_run_group_tests(tests, NULL, forget_last_model);
}
