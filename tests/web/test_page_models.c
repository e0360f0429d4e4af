/* Models that are dropped on the page, without a browser: files, maps, and what is drawn of them.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../unit/unit.h"
#include "page.h"
#include "page_parts.h"
#include "page_text.h"

static void build(const char *state)
{
    assert_int_equal(page_set_state(state), 0);
    assert_int_equal(page_build(), 0);
}

static void add_file(const char *name, const char *contents)
{
    const size_t length = strlen(contents);
    uint8_t *const bytes = page_model_file(name, (uint32_t)length);
    assert_non_null(bytes);
    memcpy(bytes, contents, length);
}

/* Begins a model of one file. */
static void begin_file(const char *name, const char *contents)
{
    page_model_begin();
    add_file(name, contents);
}

static void must_read(void)
{
    if (page_model_read() != 0)
        fail_msg("%s", page_message());
}

static void must_end(void)
{
    if (page_model_end() != 0)
        fail_msg("%s", page_message());
}

#define QUAD                                                                                       \
    "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"                                                     \
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
#define MAPPED "f 1/1 2/2 3/3 4/4\n"

/* Drops a model without maps and builds its scene. */
static void drop(const char *name, const char *contents)
{
    begin_file(name, contents);
    must_read();
    must_end();
    build("model=dropped&size=32x32");
}

static const gn_mesh *mesh_of(size_t draw)
{
    return &page_scene()->draws[draw].mesh;
}

static void normals_and_tangents_are_completed(void **state)
{
    drop("quad.obj", QUAD MAPPED);
    const float *const normal = mesh_of(0)->attribute[GN_ATTRIBUTE_NORMAL].data;
    const float *const tangent = mesh_of(0)->attribute[GN_ATTRIBUTE_TANGENT].data;
    static const float up[3] = {0, 0, 1}, along[4] = {1, 0, 0, 1};
    for (size_t v = 0; v < 4; ++v) {
        assert_memory_equal(normal + 3 * v, up, sizeof up);
        assert_memory_equal(tangent + 4 * v, along, sizeof along);
    }
}

/* In a mirrored map t grows against normal x tangent. */
static void tangents_know_mirrored_maps(void **state)
{
    static const float along[4] = {-1, 0, 0, -1};
    drop("quad.obj", QUAD "f 1/2 2/1 3/4 4/3\n");
    const float *const t = mesh_of(0)->attribute[GN_ATTRIBUTE_TANGENT].data;
    for (size_t v = 0; v < 4; ++v)
        for (size_t c = 0; c < 4; ++c)
            assert_true(t[4 * v + c] == along[c]);
}

static void a_model_without_coordinates_has_no_tangents(void **state)
{
    drop("quad.obj", QUAD "f 1 2 3 4\n");
    build("model=dropped&size=32x32&samples=4&shadows=on");
    assert_null(mesh_of(0)->attribute[GN_ATTRIBUTE_TANGENT].data);
    assert_int_equal(page_draw(0, 32), 0);
}

static void wrong_models_are_refused(void **state)
{
    static const struct {
        char name[12], text[64], message[96];
    } rows[] = {
        {"a.obj", "v 0 0 0\nf 1 2 3\n", "a.obj: line 2: f names v 2, but there is only 1"},
        {"b.obj", "", "b.obj: it is empty"},
        {"c.ply", "ply\nformat ascii 1.0\n", "c.ply: "},
        {"d.stl", "solid\nfacet normal 0 0 1\n", "d.stl: "},
        {"e.gltf", "{\"asset\": {\"version\": \"1.0\"}}", "e.gltf: "},
        {"f.glb", "glTF", "f.glb: "},
        {"g.txt", "v 0 0 0\n", "g.txt: there is no model among these files"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i) {
        begin_file(rows[i].name, rows[i].text);
        assert_int_equal(page_model_read(), 1);
        const char *const message = page_message();
        if (strncmp(message, rows[i].message, strlen(rows[i].message)) != 0)
            fail_msg("%s", message);
        assert_int_equal(page_model_end(), 1);
        assert_string_equal(page_model_describe(), "");
        assert_int_equal(page_set_state("model=dropped"), 0);
        assert_int_equal(page_build(), 1);
        assert_null(page_scene());
    }
    page_model_begin();
    assert_int_equal(page_model_read(), 1);
    assert_non_null(strstr(page_message(), "nothing: there is no model"));
    begin_file("a.obj", QUAD MAPPED);
    add_file("b.STL", "");
    assert_int_equal(page_model_read(), 1);
    assert_string_equal(page_message(), "a.obj, b.STL: drop one model at a time");
}

static void calls_in_another_order_are_refused(void **state)
{
    page_model_begin();
    assert_int_equal(page_model_end(), 1);
    assert_null(page_model_image(0, 2, 2));
    begin_file("quad.obj", QUAD MAPPED);
    must_read();
    assert_int_equal(page_model_read(), 1);
    assert_int_equal(page_set_state("model=dropped"), 0);
    assert_int_equal(page_build(), 1);
    must_end();
    assert_int_equal(page_model_end(), 1);
    assert_string_equal(page_message(), "no model has been read");
    build("model=dropped&size=8x8");
}

/* Parts are MAX_PARTS of page_model.c at most: here every one has highlights of its own. */
static void too_many_parts_are_refused(void **state)
{
    text faces = {0}, materials = {0};
    text_add(&faces, "mtllib many.mtl\n" QUAD);
    for (uint32_t i = 0; i <= 4096; ++i) {
        char lines[64];
        sprintf(lines, "usemtl m%u\nf 1 2 3\n", (unsigned)i);
        text_add(&faces, lines);
        sprintf(lines, "newmtl m%u\nKs 0.%04u\n", (unsigned)i, (unsigned)i);
        text_add(&materials, lines);
    }
    begin_file("many.obj", text_of(&faces));
    add_file("many.mtl", text_of(&materials));
    free(faces.chars);
    free(materials.chars);
    assert_int_equal(page_model_read(), 1);
    assert_string_equal(page_message(), "many.obj: parts are at most 4096 on this page, not 4097");
}

static bool says(const char *words)
{
    const bool found = strstr(page_model_describe(), words) != NULL;
    if (!found)
        print_error("%s is not in %s\n", words, page_model_describe());
    return found;
}

static void files_are_found_without_folders_and_case(void **state)
{
    page_model_begin();
    add_file("Models/QUAD.MTL", "newmtl red\nKd 1 0 0\n");
    add_file("quad.obj", "mtllib lib\\quad.mtl\n" QUAD "usemtl red\n" MAPPED);
    must_read();
    assert_true(says("\"warnings\": []"));
    must_end();
    build("model=dropped&size=8x8");
    static const float red[4] = {1, 0, 0, 1};
    assert_memory_equal(mesh_of(0)->attribute[GN_ATTRIBUTE_COLOR].data, red, sizeof red);
}

static void lights_are_warned_of(void **state)
{
    begin_file(
        "lit.gltf",
        "{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"mesh\":0,\"extensions\":{\"KHR_lights_"
        "punctual\":"
        "{\"light\":0}}}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"mode\":0}"
        "]}],"
        "\"accessors\":[{\"componentType\":5126,\"count\":1,\"type\":\"VEC3\"}],\"extensions\":{"
        "\"KHR_lights_punctual\":{\"lights\":[{\"type\":\"point\"}]}}}");
    must_read();
    assert_true(says("lit.gltf: its lights are not used"));
}

/* Begins a model whose material has these statements, with names of images. */
static void begin_mapped(const char *statements, const char *first, const char *second)
{
    char material[256];
    sprintf(material, "newmtl m\nKd 1 1 1\n%s", statements);
    begin_file("quad.obj", "mtllib quad.mtl\n" QUAD "usemtl m\n" MAPPED);
    add_file("quad.mtl", material);
    if (first != NULL)
        add_file(first, "");
    if (second != NULL)
        add_file(second, "");
    must_read();
}

/* Sets an image of one row. */
static void give(uint32_t number, uint32_t width, const uint8_t *texels)
{
    uint32_t *const to = page_model_image(number, width, 1);
    assert_non_null(to);
    memcpy(to, texels, (size_t)4 * width);
}

/* The texels of the diffuse map that is drawn. */
static const uint32_t *drawn_texels(void)
{
    must_end();
    build("model=dropped&size=8x8&filter=nearest");
    return page_scene()->draws[0].uniforms.texture.level[0].texels;
}

static void maps_are_wanted_and_turned(void **state)
{
    static const uint8_t upper[8] = {1, 2, 3, 255, 4, 5, 6, 255};
    begin_mapped("map_Kd tex\\Wood.png\nmap_Ks none.png\n", "other.png", "wood.PNG");
    assert_true(says("\"images\": [{\"number\": 0, \"name\": \"wood.PNG\", \"file\": 3}]"));
    assert_true(says("quad.obj: its specular map 'none.png' cannot be read: it was not dropped "
                     "with the model; it is left out"));
    assert_null(page_model_image(1, 2, 2));
    assert_null(page_model_image(99, 2, 2));
    assert_null(page_model_image(0, 0, 2));
    assert_null(page_model_image(0, 2, 8193));
    memcpy(page_model_image(0, 1, 2), upper, sizeof upper);
    const uint32_t *const texels = drawn_texels();
    assert_int_equal(texels[0], 0xff060504);
    assert_int_equal(texels[1], 0xff030201);
}

/* As the command finds MODEL_diffuse: the map takes the place of the material's colour. */
static void maps_are_found_by_the_name_of_the_model(void **state)
{
    static const uint8_t texel[4] = {9, 8, 7, 255};
    static const float white[4] = {1, 1, 1, 1};
    begin_file("quad.obj", QUAD MAPPED);
    add_file("Quad_Diffuse.png", "");
    must_read();
    assert_true(says("\"name\": \"Quad_Diffuse.png\", \"file\": 1}"));
    give(0, 1, texel);
    assert_int_equal(drawn_texels()[0], 0xff070809);
    assert_memory_equal(mesh_of(0)->attribute[GN_ATTRIBUTE_COLOR].data, white, sizeof white);
}

static void an_image_that_is_not_given_is_left_out(void **state)
{
    begin_mapped("map_Kd wood.png\n", "wood.png", NULL);
    must_end();
    build("model=dropped&size=8x8");
    assert_null(page_scene()->draws[0].uniforms.texture.level[0].texels);
}

/* MTL: alpha in map_Kd has no meaning, and map_d is the opacity: its alpha if it has some,
 * otherwise its luminance. */
static void alpha_is_opacity_only_where_the_material_says_so(void **state)
{
    static const uint8_t colors[8] = {10, 20, 30, 40, 50, 60, 70, 255};
    static const uint8_t levels[8] = {255, 255, 255, 255, 0, 0, 0, 255};
    begin_mapped("map_Kd c.png\n", "c.png", NULL);
    give(0, 2, colors);
    const uint32_t *opaque = drawn_texels();
    assert_int_equal(opaque[0], 0xff1e140a);
    assert_int_equal(opaque[1], 0xff463c32);
    assert_false(page_scene()->draws[0].state.color.blend[0].enabled);
    assert_true(says("quad.obj: alpha in its diffuse map is not drawn: the material is opaque"));

    begin_mapped("map_Kd c.png\nmap_d d.png\n", "c.png", "d.png");
    assert_true(says("\"c.png\"") && says("\"d.png\""));
    give(0, 2, colors);
    give(1, 2, levels);
    const uint32_t *const seen_through = drawn_texels();
    assert_int_equal(seen_through[0], 0xff1e140a);
    assert_int_equal(seen_through[1], 0x00463c32);
    assert_true(page_scene()->draws[0].state.color.blend[0].enabled);
}

static void heights_are_no_normals(void **state)
{
    static const uint8_t grey[8] = {7, 7, 7, 255, 200, 200, 200, 255};
    begin_mapped("bump h.png\n", "h.png", NULL);
    give(0, 2, grey);
    must_end();
    assert_true(says("quad.obj: its normal map holds heights, not normals; it is left out"));
    build("model=dropped&size=8x8");
    assert_null(page_scene()->draws[0].surface.map[SCENE_NORMAL_MAP].level[0].texels);
}

static void points_and_lines_are_drawn(void **state)
{
    drop("few.obj", QUAD "l 1 2 3\np 4\n");
    assert_true(says("\"triangles\": 0, \"lines\": 2, \"points\": 1"));
    assert_int_equal(page_scene()->draw_count, 2);
    for (size_t i = 0; i < 2; ++i) {
        const scene_draw *const d = page_scene()->draws + i;
        assert_int_equal(d->mesh.count, d->state.raster.topology == GN_LINES ? 4 : 1);
    }
    assert_int_equal(page_draw(0, 32), 0);
}

/* Two walls of glass, at z = 1 and z = -1, behind and before one that is opaque. */
static void what_blends_is_drawn_from_back_to_front(void **state)
{
    static const char walls[] = "mtllib g.mtl\n"
                                "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\n"
                                "v -1 -1 0\nv 1 -1 0\nv 1 1 0\n"
                                "usemtl near\nf 1 2 3\nusemtl far\nf 4 5 6\nusemtl wall\nf 7 8 9\n";
    static const char *const views[2] = {"eye=0,0,9&target=0,0,0", "eye=0,0,-9&target=0,0,0"};
    begin_file("g.obj", walls);
    add_file("g.mtl", "newmtl near\nd 0.5\nnewmtl far\nd 0.25\nnewmtl wall\nKd 1 0 0\n");
    must_read();
    must_end();
    for (int i = 0; i < 2; ++i) {
        char words[96];
        sprintf(words, "model=dropped&size=32x32&%s", views[i]);
        build(words);
        const scene_draw *const draws = page_scene()->draws;
        assert_int_equal(page_scene()->draw_count, 3);
        assert_false(draws[0].state.color.blend[0].enabled);
        assert_true(draws[1].state.color.blend[0].enabled && draws[1].state.depth.write_disabled);
        const float *const farther = mesh_of(1)->attribute[GN_ATTRIBUTE_POSITION].data;
        const float *const nearer = mesh_of(2)->attribute[GN_ATTRIBUTE_POSITION].data;
        assert_true(farther[2] == (i == 0 ? -1.0f : 1.0f));
        assert_true(nearer[2] == (i == 0 ? 1.0f : -1.0f));
        /* Numbers that other renderers know the meshes by stay. */
        assert_true(page_mesh_of_draw(1) == (nearer[2] > 0.0f ? 1u : 0u));
        assert_int_equal(page_mesh_of_draw(0), 2);
        assert_int_equal(page_draw(0, 32), 0);
    }
}

/* A node of glTF moves its mesh. */
static void parts_are_where_their_file_places_them(void **state)
{
    static const char gltf[] =
        "{\"asset\": {\"version\": \"2.0\"}, \"scene\": 0, \"scenes\": [{\"nodes\": [0]}],"
        "\"nodes\": [{\"mesh\": 0, \"translation\": [5, 0, 0]}],"
        "\"meshes\": [{\"primitives\": [{\"attributes\": {\"POSITION\": 0}}]}],"
        "\"accessors\": [{\"bufferView\": 0, \"componentType\": 5126, \"count\": 3,"
        "\"type\": \"VEC3\", \"min\": [0, 0, 0], \"max\": [1, 1, 0]}],"
        "\"bufferViews\": [{\"buffer\": 0, \"byteLength\": 36}],"
        "\"buffers\": [{\"byteLength\": 36, \"uri\": \"data:application/octet-stream;base64,"
        "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA\"}]}";
    drop("t.gltf", gltf);
    assert_true(fabsf(page_camera()->target.x - 5.5f) < 1e-6f);
    const float *const p = mesh_of(0)->attribute[GN_ATTRIBUTE_POSITION].data;
    static const float corners[9] = {5, 0, 0, 6, 0, 0, 5, 1, 0};
    for (size_t i = 0; i < 3; ++i) {
        const gn_vec4 place =
            gn_mat4_multiply_vec4(&page_scene()->draws[0].surface.world_from_model,
                                  (gn_vec4){p[3 * i], p[3 * i + 1], p[3 * i + 2], 1.0f});
        assert_memory_equal(&place, corners + 3 * i, 3 * sizeof(float));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normals_and_tangents_are_completed),
        cmocka_unit_test(tangents_know_mirrored_maps),
        cmocka_unit_test(a_model_without_coordinates_has_no_tangents),
        cmocka_unit_test(wrong_models_are_refused),
        cmocka_unit_test(calls_in_another_order_are_refused),
        cmocka_unit_test(too_many_parts_are_refused),
        cmocka_unit_test(files_are_found_without_folders_and_case),
        cmocka_unit_test(lights_are_warned_of),
        cmocka_unit_test(maps_are_wanted_and_turned),
        cmocka_unit_test(maps_are_found_by_the_name_of_the_model),
        cmocka_unit_test(an_image_that_is_not_given_is_left_out),
        cmocka_unit_test(alpha_is_opacity_only_where_the_material_says_so),
        cmocka_unit_test(heights_are_no_normals),
        cmocka_unit_test(points_and_lines_are_drawn),
        cmocka_unit_test(what_blends_is_drawn_from_back_to_front),
        cmocka_unit_test(parts_are_where_their_file_places_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
