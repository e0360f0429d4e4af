/* glTF: where nodes, skins, morph targets and instances put meshes, and lights. Sections are those
 * of the glTF 2.0 specification. */
#include "gltf_test.h"

#include <math.h>

#define PRIMITIVE "'meshes':[{'primitives':[{'attributes':{'POSITION':0,'NORMAL':1}}]}]"

static void test_node_hierarchy(void **state)
{
    /* (1, 0, 0) is doubled to (2, 0, 0), turned by a quarter about z to (0, 2, 0), moved to
     * (0, 2, 3), and by its parent to (10, 2, 3). */
    static const float expected[9] = {10, 0, 3, 10, 2, 3, 8, 0, 3};
    (void)state;
    gltf_begin_triangle();
    const model_part *p =
        gltf_part("'scene':0,'scenes':[{'nodes':[1]}],'nodes':[{'mesh':0,'translation':[0,0,3],"
                  "'rotation':[0,0,0.70710678118654752,0.70710678118654752],'scale':[2,2,2]},"
                  "{'children':[0],'matrix':[1,0,0,0,0,1,0,0,0,0,1,0,10,0,0,1]}]," PRIMITIVE);
    gltf_assert_floats(p->positions, expected, 9);
    gltf_assert_floats(p->normals, gltf_up, 9);
    assert_int_equal(read_model.part_count, 1);
    /* A third of a turn about (1, 1, 1) moves x to y, y to z and z to x. */
    p = gltf_part("'nodes':[{'mesh':0,'rotation':[0.5,0.5,0.5,0.5]}]," PRIMITIVE);
    const float turned[9] = {0, 0, 0, 0, 1, 0, 0, 0, 1}, normals[3] = {1, 0, 0};
    gltf_assert_floats(p->positions, turned, 9);
    gltf_assert_floats(p->normals, normals, 3);
    /* The other way round; a quaternion of length 2 turns as one of length 1. */
    p = gltf_part("'nodes':[{'mesh':0,'rotation':[-1,-1,-1,1]}]," PRIMITIVE);
    const float back[9] = {0, 0, 0, 0, 0, 1, 1, 0, 0}, up[3] = {0, 1, 0};
    gltf_assert_floats(p->positions, back, 9);
    gltf_assert_floats(p->normals, up, 3);
}

/* Section 3.5.1: the scene is drawn; without `scene`, the first; without scenes, all root nodes. */
static void test_scenes(void **state)
{
    static const char nodes[] = "'nodes':[{'mesh':0},{'children':[2]},{'mesh':0}]," PRIMITIVE;
    char text[512];
    (void)state;
    gltf_begin_triangle();
    snprintf(text, sizeof text, "'scenes':[{'nodes':[0]},{'nodes':[0,1]}],%s", nodes);
    assert_int_equal(gltf_part(text)->index_count, 3);
    snprintf(text, sizeof text, "'scene':1,'scenes':[{'nodes':[0]},{'nodes':[0,1]}],%s", nodes);
    assert_int_equal(gltf_part(text)->index_count, 6);
    assert_int_equal(gltf_part(nodes)->index_count, 6);
    snprintf(text, sizeof text, "'scene':2,'scenes':[{'nodes':[0]},{'nodes':[0,1]}],%s", nodes);
    assert_false(gltf_read(text));
    gltf_assert_fault("/scene: is 2, but there are 2 scenes");
    snprintf(text, sizeof text, "'scenes':[{}],%s", nodes);
    assert_false(gltf_read(text));
    gltf_assert_fault("there are no triangles, lines or points in it");
}

static void test_cycles(void **state)
{
    (void)state;
    gltf_begin_triangle();
    assert_false(gltf_read("'nodes':[{'mesh':0},{'children':[2]},{'children':[1]}]," PRIMITIVE));
    gltf_assert_fault("/nodes/1: the node is its own descendant, or a descendant of such a node");
    assert_false(gltf_read("'nodes':[{'mesh':0,'children':[0]}]," PRIMITIVE));
    gltf_assert_fault("/nodes/0: the node is its own descendant, or a descendant of such a node");
    assert_false(gltf_read("'nodes':[{'children':[2]},{'children':[2]},{'mesh':0}]," PRIMITIVE));
    gltf_assert_fault("/nodes/2: the node is a child of two nodes, or twice of one");
    assert_false(gltf_read("'nodes':[{'children':[7]}]," PRIMITIVE));
    gltf_assert_fault("/nodes/0/children/0: is 7, but there are 1 nodes");
    assert_false(gltf_read("'nodes':[{'mesh':0,'scale':[1,1]}]," PRIMITIVE));
    gltf_assert_fault("/nodes/0/scale: is no array of 3 numbers");
    assert_false(gltf_read("'nodes':[{'mesh':1}]," PRIMITIVE));
    gltf_assert_fault("/nodes/0/mesh: is 1, but there are 1 meshes");
}

/* A chain of nodes, each moved by 1 from its parent. */
static void test_deep_hierarchy(void **state)
{
    static char text[30000];
    const int depth = 400;
    (void)state;
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
    (void)state;
    gltf_begin_triangle();
    gltf_array("VEC3", T_F32, 3, normals, sizeof normals);
    gltf_array("VEC4", T_F32, 3, tangents, sizeof tangents);
    gltf_array("VEC2", T_F32, 3, gltf_corner, 24);
    const model_part *p =
        gltf_part("'nodes':[{'mesh':0,'scale':[-2,1,1]}],'meshes':[{'primitives':[{'attributes':"
                  "{'POSITION':0,'NORMAL':2,'TANGENT':3,'TEXCOORD_0':4}}]}]");
    const float normal[3] = {-0.5f / length, 0, 1 / length};
    const float tangent[4] = {-2 / other, 0, -1 / other, -1};
    gltf_assert_floats(p->normals, normal, 3);
    gltf_assert_floats(p->tangents, tangent, 4);
    assert_memory_equal(p->indices, expected, sizeof expected);
    /* Flat normals point to the side from which the corners turn to the left. */
    p = gltf_part("'nodes':[{'mesh':0,'scale':[-1,1,1]}],'meshes':[{'primitives':[{'attributes':"
                  "{'POSITION':0}}]}]");
    gltf_assert_floats(p->normals, gltf_up, 9);
    const float corners[9] = {0, 0, 0, 0, 1, 0, -1, 0, 0};
    gltf_assert_floats(p->positions, corners, 9);
}

/* Tangents of the file are kept, also beside others that are computed. */
static void test_tangents(void **state)
{
    static const float tangents[12] = {0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1};
    static const float expected[4] = {1, 0, 0, -1}; /* t grows against y */
    (void)state;
    gltf_begin_triangle();
    gltf_array("VEC4", T_F32, 3, tangents, sizeof tangents);
    gltf_array("VEC2", T_F32, 3, (const float[6]){0, 0, 1, 0, 0, 1}, 24);
    const model_part *const p = gltf_part(
        "'nodes':[{'mesh':0}],'meshes':[{'primitives':[{'attributes':{'POSITION':0,'NORMAL':1,"
        "'TANGENT':2,'TEXCOORD_0':3}},{'attributes':{'POSITION':0,'NORMAL':1,'TEXCOORD_0':3}}]}]");
    assert_int_equal(read_model.part_count, 1);
    gltf_assert_floats(p->tangents, tangents, 12);
    gltf_assert_floats(p->tangents + 12, expected, 4);
}

/* Coordinates of maps: every bit of the difference to the middle is kept. */
static void test_far_coordinates(void **state)
{
    (void)state;
    gltf_begin_triangle();
    const model_part *const p =
        gltf_part("'nodes':[{'mesh':0,'translation':[500000.25,4500000.5,100.125]}]," PRIMITIVE);
    assert_true(read_model.origin[0] == 500000.75 && read_model.origin[1] == 4500001.0 &&
                read_model.origin[2] == 100.125);
    const float expected[9] = {-0.5f, -0.5f, 0, 0.5f, -0.5f, 0, -0.5f, 0.5f, 0};
    gltf_assert_floats(p->positions, expected, 9);
    /* Near coordinates keep their origin: the middle of this one is 9 half sides away. */
    gltf_part("'nodes':[{'mesh':0,'translation':[4,0,0],'scale':[1,1,1]}]," PRIMITIVE);
    assert_true(read_model.origin[0] == 0.0);
}

/* Section 3.7.2.2: the weights of the mesh, overridden by those of a node. */
static void test_morph_targets(void **state)
{
    static const float moves[9] = {0, 0, 4, 0, 0, 0, 0, 0, 8};
    static const float turns[9] = {2, 0, -2, 0, 0, 0, 0, 0, 0};
    static const char mesh[] =
        "'meshes':[{'weights':[0.5,0.25],'primitives':[{'attributes':{'POSITION':0,'NORMAL':1},"
        "'targets':[{'POSITION':2,'NORMAL':3},{'POSITION':3,'COLOR_0':3}]}]}]";
    char text[512];
    (void)state;
    gltf_begin_triangle();
    gltf_array("VEC3", T_F32, 3, moves, sizeof moves);
    gltf_array("VEC3", T_F32, 3, turns, sizeof turns);
    snprintf(text, sizeof text, "'nodes':[{'mesh':0}],%s", mesh);
    const model_part *p = gltf_part(text);
    const float first[9] = {0.5f, 0, 1.5f, 1, 0, 0, 0, 1, 4};
    const float normal[3] = {1, 0, 0};
    gltf_assert_floats(p->positions, first, 9);
    gltf_assert_floats(p->normals, normal, 3);
    assert_true(has_warning("a.gltf: /meshes/0/primitives/0/targets/1: morph targets of COLOR_0 "
                            "are not drawn (1)"));
    snprintf(text, sizeof text, "'nodes':[{'mesh':0,'weights':[0,1]}],%s", mesh);
    p = gltf_part(text);
    const float second[9] = {2, 0, -2, 1, 0, 0, 0, 1, 0};
    gltf_assert_floats(p->positions, second, 9);
    gltf_assert_floats(p->normals, gltf_up, 9);
    snprintf(text, sizeof text, "'nodes':[{'mesh':0,'weights':[0,'a']}],%s", mesh);
    assert_false(gltf_read(text));
    gltf_assert_fault("/nodes/0/weights/1: is no number that fits");
}

/* A small file cannot ask for work without end. */
static void test_bounded_morphs(void **state)
{
    static char text[60000];
    (void)state;
    gltf_begin();
    gltf_accessor("VEC3", T_F32, 65536, "");
    strcpy(text, "'nodes':[{'mesh':0}],'meshes':[{'primitives':[{'mode':0,'attributes':"
                 "{'POSITION':0},'targets':[{}");
    for (int i = 0; i < 16384; ++i)
        gltf_append(text, sizeof text, ",{}");
    gltf_append(text, sizeof text, "]}]}]");
    assert_false(gltf_read(text));
    gltf_assert_fault("/meshes/0/primitives/0: the model has more vertices than can be drawn");
}

/* Section 3.7.3: joint 1 is moved by (0, 0, 2) from its bind pose, joint 0 is not; the vertices
 * follow joint 0, joint 1 and both. The node of the mesh has no influence. */
static const uint8_t joints[12] = {0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0};
static const float weights[12] = {1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0};
/* Inverse bind matrices. The node of joint 1 is at (0, 5, 2) and was bound at (0, 5, 0). */
static const float bind[32] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                               1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -5, 0, 1};

static void begin_skin(void)
{
    gltf_begin_triangle();
    gltf_array("VEC4", T_U8, 3, joints, sizeof joints);
    gltf_array("VEC4", T_F32, 3, weights, sizeof weights);
    gltf_array("MAT4", T_F32, 2, bind, sizeof bind);
}

#define SKINNED                                                                                    \
    "'nodes':[{'mesh':0,'skin':0,'translation':[7,7,7]},{'children':[2],'translation':[0,5,0]},"   \
    "{'translation':[0,0,2]},{}],'meshes':[{'primitives':[{'attributes':{'POSITION':0,"            \
    "'NORMAL':1,'JOINTS_0':2,'WEIGHTS_0':3}}]}]"

static void test_skin(void **state)
{
    static const float expected[9] = {0, 0, 0, 1, 0, 2, 0, 1, 1};
    static const float unbound[9] = {0, 0, 0, 1, 5, 2, 0, 3.5f, 1};
    (void)state;
    begin_skin();
    const model_part *p = gltf_part(SKINNED ",'skins':[{'joints':[3,2],'inverseBindMatrices':4}]");
    gltf_assert_floats(p->positions, expected, 9);
    gltf_assert_floats(p->normals, gltf_up, 9);
    p = gltf_part(SKINNED ",'skins':[{'joints':[3,2]}]");
    gltf_assert_floats(p->positions, unbound, 9);
    assert_false(gltf_read(SKINNED ",'skins':[{'joints':[3]}]"));
    gltf_assert_fault("/meshes/0/primitives/0: a joint of a vertex is 1, but its skin has 1 "
                      "joints");
    assert_false(gltf_read(SKINNED ",'skins':[{'joints':[3,9]}]"));
    gltf_assert_fault("/skins/0/joints/1: is 9, but there are 4 nodes");
    assert_false(gltf_read(SKINNED ",'skins':[{'joints':[3,2,1],'inverseBindMatrices':4}]"));
    gltf_assert_fault("/skins/0/inverseBindMatrices: its accessor has no matrix of floats for each "
                      "of 3 joints");
    /* JOINTS_0 has unsigned integers. */
    assert_false(
        gltf_read("'nodes':[{'mesh':0,'skin':0}],'skins':[{'joints':[0]}],'meshes':[{'primitives':"
                  "[{'attributes':{'POSITION':0,'JOINTS_0':3,'WEIGHTS_0':3}}]}]"));
    gltf_assert_fault("/meshes/0/primitives/0/attributes/JOINTS_0: its accessor is of a type that "
                      "the attribute cannot have");
    assert_false(gltf_read(SKINNED ",'skins':[{}]"));
    gltf_assert_fault("/skins/0: has no joints");
}

/* The second set of joints adds to the first; weights need not sum up to 1. */
static void test_eight_joints(void **state)
{
    static const uint8_t more_joints[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    static const uint8_t more_weights[12] = {255, 0, 0, 0, 0, 0, 0, 0, 255, 0, 0, 0};
    static const float expected[9] = {0, 0, 1, 1, 0, 2, 0, 1, 1.5f};
    (void)state;
    begin_skin();
    gltf_array("VEC4", T_U8, 3, more_joints, sizeof more_joints);
    gltf_fractions("VEC4", T_U8, 3, more_weights, sizeof more_weights);
    const model_part *const p = gltf_part(
        "'nodes':[{'mesh':0,'skin':0},{'translation':[0,5,2]},{}],'skins':[{'joints':[2,1],"
        "'inverseBindMatrices':4}],'meshes':[{'primitives':[{'attributes':{'POSITION':0,"
        "'NORMAL':1,'JOINTS_0':2,'WEIGHTS_0':3,'JOINTS_1':5,'WEIGHTS_1':6}}]}]");
    gltf_assert_floats(p->positions, expected, 9);
}

/* Joints that mirror turn triangles. If all weights of a vertex are 0, it follows its first joint.
 */
static void test_odd_skins(void **state)
{
    static const float expected[9] = {0, 0, 0, -1, 0, 0, 0, 1, 0};
    static const float zeros[12] = {0};
    static const float moved[9] = {0, 0, 5, 1, 0, 5, 0, 1, 5};
    static const uint32_t turned[3] = {0, 2, 1};
    (void)state;
    begin_skin();
    gltf_array("VEC4", T_F32, 3, zeros, sizeof zeros);
    const model_part *p = gltf_part(
        "'nodes':[{'mesh':0,'skin':0},{'scale':[-1,1,1]}],'skins':[{'joints':[1,1]}],'meshes':[{"
        "'primitives':[{'attributes':{'POSITION':0,'NORMAL':1,'JOINTS_0':2,'WEIGHTS_0':3}}]}]");
    gltf_assert_floats(p->positions, expected, 9);
    gltf_assert_floats(p->normals, gltf_up, 9);
    assert_memory_equal(p->indices, turned, sizeof turned);
    p = gltf_part(
        "'nodes':[{'mesh':0,'skin':0},{'translation':[0,0,5]}],'skins':[{'joints':[1,1]}],"
        "'meshes':[{'primitives':[{'attributes':{'POSITION':0,'JOINTS_0':2,'WEIGHTS_0':5}}]}]");
    gltf_assert_floats(p->positions, moved, 9);
    /* First by the inverse bind matrix, (0, -5, 0), then by half a turn about z. */
    p = gltf_part(
        "'nodes':[{'mesh':0,'skin':0},{'rotation':[0,0,1,0]},{}],'skins':[{'joints':[2,1],"
        "'inverseBindMatrices':4}],'meshes':[{'primitives':[{'attributes':{'POSITION':0,"
        "'NORMAL':1,'JOINTS_0':2,'WEIGHTS_0':3}}]}]");
    const float bound[6] = {0, 0, 0, -1, 5, 0};
    gltf_assert_floats(p->positions, bound, 6);
}

/* EXT_mesh_gpu_instancing: each instance is moved, turned and scaled within the node. */
static void test_instances(void **state)
{
    static const float moves[6] = {0, 0, 0, 3, 0, 0};
    static const int8_t turns[8] = {0, 0, 0, 127, 0, 0, 127, 0};
    static const float scales[6] = {1, 1, 1, 2, 2, 2};
    /* The second one is turned by half a turn about z; the node moves all by (0, 0, 1). */
    static const float expected[18] = {0, 0, 1, 1, 0, 1, 0, 1, 1, 3, 0, 1, 1, 0, 1, 3, -2, 1};
    static const uint32_t indices[6] = {0, 1, 2, 3, 4, 5};
    (void)state;
    gltf_begin_triangle();
    gltf_array("VEC3", T_F32, 2, moves, sizeof moves);
    gltf_fractions("VEC4", T_I8, 2, turns, sizeof turns);
    gltf_array("VEC3", T_F32, 2, scales, sizeof scales);
    const model_part *const p =
        gltf_part("'nodes':[{'mesh':0,'translation':[0,0,1],'extensions':{'EXT_mesh_gpu_instancing'"
                  ":{'attributes':{'TRANSLATION':2,'ROTATION':3,'SCALE':4}}}}]," PRIMITIVE);
    assert_int_equal(read_model.part_count, 1);
    gltf_assert_floats(p->positions, expected, 18);
    assert_memory_equal(p->indices, indices, sizeof indices);
    assert_false(
        gltf_read("'nodes':[{'mesh':0,'extensions':{'EXT_mesh_gpu_instancing':{'attributes':"
                  "{'TRANSLATION':2,'SCALE':0}}}}]," PRIMITIVE));
    gltf_assert_fault("/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes: its attributes have "
                      "different counts: 2 and 3");
    /* A small file cannot ask for instances without end. */
    gltf_accessor("VEC3", T_F32, 4000000000U, "");
    assert_false(gltf_read("'nodes':[{'mesh':0,'extensions':{'EXT_mesh_gpu_instancing':"
                           "{'attributes':{'TRANSLATION':5}}}}]," PRIMITIVE));
    gltf_assert_fault("/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/TRANSLATION: has "
                      "4000000000 elements without a bufferView; at most 65536 are read");
    /* A skin decides where its vertices are. */
    gltf_array("VEC4", T_U8, 3, joints, sizeof joints);
    gltf_array("VEC4", T_F32, 3, weights, sizeof weights);
    gltf_part("'nodes':[{'mesh':0,'skin':0,'extensions':{'EXT_mesh_gpu_instancing':{'attributes':"
              "{'TRANSLATION':2}}}}],'skins':[{'joints':[0,0]}],'meshes':[{'primitives':[{"
              "'attributes':{'POSITION':0,'NORMAL':1,'JOINTS_0':6,'WEIGHTS_0':7}}]}]");
    assert_int_equal(read_model.parts->index_count, 3);
    assert_true(has_warning("a.gltf: /nodes/0/extensions/EXT_mesh_gpu_instancing: instances of a "
                            "mesh with a skin are not drawn (1)"));
}

static void test_lights(void **state)
{
    (void)state;
    gltf_begin_triangle();
    gltf_part("'extensionsUsed':['KHR_lights_punctual'],'extensions':{'KHR_lights_punctual':"
              "{'lights':[{'type':'directional'},{'type':'spot','color':[1,0.5,0],'intensity':4,"
              "'range':9,'spot':{'innerConeAngle':0.25,'outerConeAngle':0.5}},{'type':'point'},{'"
              "type':'spot'}]}},"
              "'nodes':[{'mesh':0},"
              "{'extensions':{'KHR_lights_punctual':{'light':0}}},"
              "{'translation':[1,2,3],'rotation':[0.70710678118654752,0,0,0.70710678118654752],"
              "'scale':[3,3,3],'extensions':{'KHR_lights_punctual':{'light':1}}},"
              "{'extensions':{'KHR_lights_punctual':{'light':2}}},"
              "{'extensions':{'KHR_lights_punctual':{'light':3}}}]," PRIMITIVE);
    assert_int_equal(read_messages.warning_count, 0);
    assert_int_equal(read_model.light_count, 4);
    const model_light *const l = read_model.lights;
    const float down[3] = {0, 0, -1}, up[3] = {0, 1, 0}, color[3] = {4, 2, 0}, white[3] = {1, 1, 1};
    assert_int_equal(l[0].kind, GN_LIGHT_DIRECTIONAL);
    gltf_assert_floats(l[0].direction, down, 3);
    gltf_assert_floats(l[0].color, white, 3);
    /* A quarter of a turn about x moves -z to y. */
    assert_int_equal(l[1].kind, GN_LIGHT_SPOT);
    gltf_assert_floats(l[1].direction, up, 3);
    gltf_assert_floats(l[1].color, color, 3);
    assert_true(l[1].position[0] == 1.0 && l[1].position[1] == 2.0 && l[1].position[2] == 3.0);
    assert_true(l[1].range == 9.0f && l[1].inner == 0.25f && l[1].outer == 0.5f);
    assert_int_equal(l[2].kind, GN_LIGHT_POINT);
    assert_true(l[2].range == 0.0f);
    /* The extension's default: a quarter of pi. */
    assert_true(l[3].inner == 0.0f && l[3].outer == 0.785398163f);
    assert_false(gltf_read("'extensions':{'KHR_lights_punctual':{'lights':[{'type':'area'}]}},"
                           "'nodes':[{'extensions':{'KHR_lights_punctual':{'light':0}}}]"));
    gltf_assert_fault("/extensions/KHR_lights_punctual/lights/0: its type is none of directional, "
                      "point and spot");
}

static void test_warnings(void **state)
{
    (void)state;
    gltf_begin_triangle();
    gltf_part("'animations':[{}],'cameras':[{}],'nodes':[{'mesh':0,'matrix':[1,0,0,0.5,0,1,0,0,0,0,"
              "1,0,0,0,0,1]}]," PRIMITIVE);
    assert_int_equal(read_messages.warning_count, 3);
    assert_true(has_warning("a.gltf: /animations: animations are not drawn: the rest pose is (1)"));
    assert_true(has_warning("a.gltf: /cameras: cameras are not used (1)"));
    assert_true(has_warning("a.gltf: /nodes/0: the last row of its matrix is not 0 0 0 1, but is "
                            "taken for it (1)"));
}

/* Meshes with one material make one part; attributes and kind divide. */
static void test_merging(void **state)
{
    (void)state;
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
        cmocka_unit_test(test_cycles),         cmocka_unit_test(test_deep_hierarchy),
        cmocka_unit_test(test_mirror),         cmocka_unit_test(test_far_coordinates),
        cmocka_unit_test(test_tangents),       cmocka_unit_test(test_morph_targets),
        cmocka_unit_test(test_bounded_morphs), cmocka_unit_test(test_skin),
        cmocka_unit_test(test_eight_joints),   cmocka_unit_test(test_odd_skins),
        cmocka_unit_test(test_instances),      cmocka_unit_test(test_lights),
        cmocka_unit_test(test_warnings),       cmocka_unit_test(test_merging),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    forget_model();
    return failed;
}
