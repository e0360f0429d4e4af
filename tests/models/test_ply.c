/* PLY files: what vertices, faces, strips and edges become. */
#include "ply_test.h"

/* Pairs of triangles of width 1, one above the other at x = 0, 1 and 2. */
#define PAIRS "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n"

static void test_elements(void **state)
{
    static const struct {
        const char *text, *warning;
        model_kind kind;
        size_t vertices, indices;
        double area;
    } cases[] = {
        {SQUARE, NULL, MODEL_TRIANGLES, 4, 6, 4},
        /* An arrow head whose reflex corner comes first, and an L. */
        {VERTICES("10") FACES("2") END
         "2 1 0\n4 0 0\n2 4 0\n0 0 0\n10 0 0\n13 0 0\n13 1 0\n11 1 0\n11 3 0\n10 3 0\n"
         "4 0 1 2 3\n6 4 5 6 7 8 9\n",
         NULL, MODEL_TRIANGLES, 10, 18, 11},
        {VERTICES("3") FACES("4") END TRIANGLE_POINTS "0\n2 0 1\n3 0 1 2\n1 0\n",
         "line 13: a face with fewer than 3 corners is not drawn (3)", MODEL_TRIANGLES, 3, 3, 0.5},
        /* Vertices beside faces are no points. */
        {VERTICES("4") FACES("1") END "0 0 0\n9 9 nan\n1 0 0\n0 1 0\n3 0 2 3\n", NULL,
         MODEL_TRIANGLES, 3, 3, 0.5},
        /* A strip, mirrored, so that its first triangle is counter-clockwise. */
        {VERTICES("6") STRIPS("1", "int") END PAIRS "6 1 0 3 2 5 4\n", NULL, MODEL_TRIANGLES, 6, 12,
         2},
        /* A new strip begins with its own winding; vertices that are named twice join two others.
         */
        {VERTICES("6") STRIPS("3", "int") END PAIRS
         "10 1 0 3 -1 0 2 3 -1 -1 3\n8 3 2 5 5 2 2 3 5\n4 1 0 1 2\n",
         NULL, MODEL_TRIANGLES, 5, 15, 2.5},
        {VERTICES("6") STRIPS("1", "uint") END PAIRS "7 0 2 3 4294967295 0 3 1\n", NULL,
         MODEL_TRIANGLES, 4, 6, 1},
        {VERTICES("4") EDGES("2") END SQUARE_POINTS "0 1\n1 3\n", NULL, MODEL_LINES, 3, 4, 0},
        /* The shortest text, without an end of its last line. */
        {VERTICES("3") END "0 0 0\n1 0 0\n0 1 0", NULL, MODEL_POINTS, 3, 3, 0},
        /* Elements that are announced, but not there, need no properties. */
        {VERTICES("1") "element face 0\nelement tristrips 0\nelement edge 0\n" END "0 0 0\n", NULL,
         MODEL_POINTS, 1, 1, 0},
        /* Scanners write NaN where they saw nothing. */
        {VERTICES("3") END "nan nan nan\n1 2 3\n0 inf 0\n",
         "2 points are not finite and not drawn (1)", MODEL_POINTS, 1, 1, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char warning[128];
        snprintf(warning, sizeof warning, "x.ply: %s",
                 cases[i].warning != NULL ? cases[i].warning : "");
        const model_part *const p =
            part_of(cases[i].text, cases[i].warning != NULL ? warning : NULL);
        assert_int_equal(read_model.part_count, 1);
        expect_sizes(p, cases[i].kind, cases[i].vertices, cases[i].indices);
        if (cases[i].kind == MODEL_TRIANGLES)
            expect_area(p, cases[i].indices / 3, cases[i].area);
        assert_false(p->has_normals || p->has_texcoords || p->has_vertex_colors);
        assert_int_equal(p->surface.alpha, MODEL_OPAQUE);
        expect_color(p, 0, 0.8f, 0.8f, 0.8f, 1.0f);
        if (p->kind == MODEL_TRIANGLES)
            assert_true(p->normals[2] == 1.0f);
    }
    assert_true(read_model.origin[0] + (double)read_model.parts->positions[0] == 1.0);
    refuse(VERTICES("6") STRIPS("1", "int") END PAIRS "4 0 1 2 6\n",
           "line 16: tristrips 0 names vertex 6, but there are only 6");
    refuse(VERTICES("4") EDGES("1") END SQUARE_POINTS "0 4\n",
           "line 15: edge 0 names vertex 4, but there are only 4");
    refuse(VERTICES("4") "element edge 1\nproperty int vertex1\n" END SQUARE_POINTS "0\n",
           "element edge has no properties vertex1 and vertex2");
}

static void test_points_with_colors(void **state)
{
    const model_part *p =
        part_of(VERTICES("2") RGB FACES("0") END "0 0 0 255 0 51\n1 2 3 0 255 102\n", NULL);
    expect_sizes(p, MODEL_POINTS, 2, 2);
    assert_true(p->has_vertex_colors);
    expect_color(p, 0, 1.0f, 0.0f, 0.2f, 1.0f);
    expect_color(p, 1, 0.0f, 1.0f, 0.4f, 1.0f);
    assert_true(p->positions[3] == 1.0f && p->positions[4] == 2.0f && p->positions[5] == 3.0f);
    /* Strips before faces with colours: each has its own. */
    p = part_of(VERTICES("6") STRIPS("1", "int") FACES("1") RGB END PAIRS
                "3 0 2 3\n3 0 3 1 255 0 0\n",
                NULL);
    expect_area(p, 2, 1.0);
    assert_int_equal(p->vertex_count, 6);
    expect_color(p, p->indices[0], 1.0f, 0.0f, 0.0f, 1.0f);
    expect_color(p, p->indices[3], 0.8f, 0.8f, 0.8f, 1.0f);
}

static void test_splats(void **state)
{
    const model_part *const p = part_of(
        VERTICES("1") "property float nx\nproperty float ny\nproperty float nz\n"
                      "property float f_dc_0\nproperty float f_dc_1\nproperty float f_dc_2\n"
                      "property float f_rest_0\nproperty float opacity\nproperty float scale_0\n"
                      "property float scale_1\nproperty float scale_2\nproperty float rot_0\n"
                      "property float rot_1\nproperty float rot_2\nproperty float rot_3\n" END
                      "1 2 3 0 0 0 1 0 -9 .1 5 -3 -3 -3 1 0 0 0\n",
        "x.ply: Gaussian splats are drawn as points of one colour (1)");
    assert_int_equal(p->kind, MODEL_POINTS);
    expect_color(p, 0, 0.78209479f, 0.5f, 0.0f, 1.0f); /* 0.5 + 1 / (2 sqrt(pi)) */
}

/* Reads a triangle whose three vertices have these properties and values. */
static const model_part *read_attributes(const char *properties, const char *values,
                                         const char *warning)
{
    char text[1024];
    snprintf(text, sizeof text,
             VERTICES("3") "%s" FACES("1") END "0 0 0 %s\n1 0 0 %s\n0 1 0 %s\n3 0 1 2\n",
             properties, values, values, values);
    return part_of(text, warning);
}

static void test_colors(void **state)
{
    static const char *const names[][4] = {
        {"red", "green", "blue", "alpha"},
        {"r", "g", "b", "a"},
        {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"}};
    static const struct {
        const char *type, *values;
    } types[] = {{"uchar", "51 102 153 204"},  {"ushort", "13107 26214 39321 52428"},
                 {"float", "0.2 0.4 0.6 0.8"}, {"double", ".2 .4 .6 .8"},
                 {"int", "51 102 153 204"},    {"uint32", "51 102 153 204"}};
    const model_part *p;
    for (size_t n = 0; n < 3; ++n)
        for (size_t t = 0; t < 6; ++t) {
            char properties[256] = "";
            for (size_t i = 0; i < 4; ++i)
                snprintf(properties + strlen(properties), sizeof properties - strlen(properties),
                         "property %s %s\n", types[t].type, names[n][i]);
            p = read_attributes(properties, types[t].values, NULL);
            expect_color(p, 2, 0.2f, 0.4f, 0.6f, 0.8f);
            assert_int_equal(p->surface.alpha, MODEL_BLEND);
            assert_true(p->has_vertex_colors);
        }
    p = read_attributes(RGB "property uchar alpha\n", "51 102 153 0",
                        "x.ply: alpha is 0 everywhere; it is drawn opaque (1)");
    expect_color(p, 0, 0.2f, 0.4f, 0.6f, 1.0f);
    assert_int_equal(p->surface.alpha, MODEL_OPAQUE);
    p = read_attributes("property uchar red\nproperty uchar blue\n", "51 102",
                        "x.ply: colours of vertex are not drawn: a property is missing (1)");
    expect_color(p, 0, 0.8f, 0.8f, 0.8f, 1.0f);
}

static void test_normals_and_texcoords(void **state)
{
    static const char *const names[][2] = {
        {"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}};
    const model_part *p = read_attributes(
        "property float nx\nproperty float ny\nproperty double nz\n", "1 0 0.5", NULL);
    assert_true(p->has_normals && p->normals[3] == 1.0f && p->normals[5] == 0.5f);
    p = read_attributes("property float nx\nproperty float ny\nproperty float nz\n", "nan 0 0",
                        "x.ply: 3 vertices have normals that are not finite; they are computed "
                        "from the triangles (1)");
    assert_true(p->normals[2] == 1.0f);
    read_attributes("property float nx\nproperty float ny\n", "1 0",
                    "x.ply: normals of vertex are not drawn: a property is missing (1)");
    for (size_t n = 0; n < 4; ++n) {
        char properties[128];
        snprintf(properties, sizeof properties, "property float %s\nproperty float %s\n",
                 names[n][0], names[n][1]);
        p = read_attributes(properties, "0.25 0.75", NULL);
        assert_true(p->has_texcoords && p->has_tangents);
        assert_true(p->texcoords[4] == 0.25f && p->texcoords[5] == 0.75f);
        assert_int_equal(read_model.image_count, 0);
    }
}

static void test_wedges(void **state)
{
    const model_part *p = part_of(
        "ply\nformat ascii 1.0\ncomment TextureFile a picture.png\nelement vertex 4\n" XYZ FACES(
            "2") TEXCOORDS END SQUARE_POINTS "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0 0 1 1 0.5 1\n",
        NULL);
    expect_area(p, 2, 4.0);
    /* Vertices 0 and 2 have the same coordinates in both faces. */
    assert_int_equal(p->vertex_count, 4);
    assert_true(p->has_texcoords);
    assert_true(p->texcoords[2 * p->indices[5]] == 0.5f);
    assert_int_equal(p->maps[MAP_DIFFUSE].image, 0);
    assert_string_equal(read_model.images[0].name, "a picture.png");
    assert_int_equal(read_model.material_count, 1);
    expect_color(p, 0, 1.0f, 1.0f, 1.0f, 1.0f);
    /* Other coordinates in the second face, which is a polygon. */
    p = part_of(VERTICES("6") FACES("2") TEXCOORDS END SQUARE_POINTS
                "3 -1 0\n3 1 0\n4 0 1 2 3 8 0 0 1 0 1 1 0 1\n4 1 4 5 2 8 .1 .2 .3 .4 .5 .6 .7 .8\n",
                NULL);
    expect_area(p, 4, 8.0);
    assert_int_equal(p->vertex_count, 8);
    for (size_t i = 6; i < 12; ++i) {
        const uint32_t v = p->indices[i];
        const bool is_right = p->positions[3 * v] == 3.0f,
                   is_upper = p->positions[3 * v + 1] > 0.0f;
        const float s = is_right ? (is_upper ? 0.5f : 0.3f) : (is_upper ? 0.7f : 0.1f);
        assert_true(p->texcoords[2 * v] == s);
        assert_true(fabs((double)p->texcoords[2 * v + 1] - (double)s - 0.1) < 1e-6);
    }
    part_of(VERTICES("3") FACES("1") TEXCOORDS END TRIANGLE_POINTS "3 0 1 2 5 1 1 1 1 1\n",
            "x.ply: line 14: texcoord has not two numbers for each corner; 0 is used (1)");
    p = part_of(VERTICES("3") FACES("1") TEXCOORDS END TRIANGLE_POINTS "3 0 1 2 0\n", NULL);
    assert_true(p->texcoords[0] == 0.0f);
}

static void test_textures(void **state)
{
    static const struct {
        uint32_t indices;
        const char *image;
    } parts[] = {{3, "a.png"}, {6, "b.png"}, {3, NULL}};
    part_of("ply\nformat ascii 1.0\ncomment TextureFile a.png\ncomment TextureFile b.png\n"
            "element vertex 4\n" XYZ FACES("4") TEXCOORDS
            "property int texnumber\n" END SQUARE_POINTS
            "3 0 1 2 6 0 0 1 0 1 1 1\n3 0 2 3 6 0 0 1 1 0 1 0\n"
            "3 0 1 3 6 0 0 1 0 1 1 -1\n3 1 2 3 6 0 0 1 1 0 1 1\n",
            NULL);
    assert_int_equal(read_model.part_count, 3);
    for (size_t i = 0; i < 3; ++i) {
        const uint32_t image = read_model.parts[i].maps[MAP_DIFFUSE].image;
        assert_int_equal(read_model.parts[i].index_count, parts[i].indices);
        assert_int_equal(image == MODEL_NO_IMAGE, parts[i].image == NULL);
        if (parts[i].image != NULL)
            assert_string_equal(read_model.images[image].name, parts[i].image);
    }
    expect_color(read_model.parts + 2, 0, 0.8f, 0.8f, 0.8f, 1.0f);
    part_of("ply\nformat ascii 1.0\ncomment TextureFile a.png\nelement vertex 3\n" XYZ FACES("1")
                END TRIANGLE_POINTS "3 0 1 2\n",
            "x.ply: TextureFile a.png is not drawn: no face has texture coordinates (1)");
}

static void test_face_colors(void **state)
{
    const model_part *const p = part_of(VERTICES("4") FACES("3") RGB END SQUARE_POINTS
                                        "3 0 1 2 255 0 0\n3 0 2 3 0 255 0\n3 0 1 3 255 0 0\n",
                                        NULL);
    /* Red ones of four vertices, green ones of three. */
    expect_sizes(p, MODEL_TRIANGLES, 7, 9);
    for (size_t i = 0; i < 9; ++i)
        expect_color(p, p->indices[i], i / 3 != 1, i / 3 == 1, 0.0f, 1.0f);
}

/* A vertex in more combinations than are compared is repeated, and nothing else. */
static void test_many_wedges(void **state)
{
    static char text[40000];
    char *to = text;
    to += sprintf(to, VERTICES("3") FACES("300") TEXCOORDS END TRIANGLE_POINTS);
    for (int i = 0; i < 300; ++i)
        to += sprintf(to, "3 0 1 2 6 %d 0 %d 0 %d 0\n", i, i, i);
    const model_part *const p = part_of(text, NULL);
    expect_area(p, 300, 150.0);
    assert_int_equal(p->vertex_count, 900);
    for (size_t i = 0; i < 900; ++i)
        assert_true(p->texcoords[2 * p->indices[i]] == (float)(i / 3));
}

static void test_far_coordinates(void **state)
{
    writer w;
    static const double corners[4][2] = {
        {499999.9, 4499999.9}, {500000.1, 4499999.9}, {500000.1, 4500000.1}, {499999.9, 4500000.1}};
    write_header(
        &w, true,
        "element vertex 5\nproperty double x\nproperty double y\nproperty double z\n" FACES("1")
            END);
    for (int v = 0; v < 5; ++v) {
        /* One that no face uses does not count. */
        for (int c = 0; c < 3; ++c)
            write_double(&w, v < 4 && c < 2 ? corners[v][c] : 0.0);
    }
    write_bits(&w, 4, 1);
    for (uint32_t i = 0; i < 4; ++i)
        write_bits(&w, i, 4);
    expect_read(read_written(&w), NULL);
    expect_area(read_model.parts, 2, 0.04);
    for (size_t v = 0; v < 4; ++v)
        for (size_t c = 0; c < 2; ++c)
            assert_true(fabs(read_model.origin[c] + (double)read_model.parts->positions[3 * v + c] -
                             corners[v][c]) < 1e-8);
    /* The same as a text whose type says float. */
    part_of(VERTICES("3") FACES("1") END
            "500000.25 4500000.5 0\n500001.25 4500000.5 0\n500000.25 4500001.5 0\n"
            "3 0 1 2\n",
            NULL);
    expect_area(read_model.parts, 1, 0.5);
    assert_true(read_model.origin[0] == 500000.75 && read_model.origin[1] == 4500001.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_elements),
        cmocka_unit_test(test_points_with_colors),
        cmocka_unit_test(test_splats),
        cmocka_unit_test(test_colors),
        cmocka_unit_test(test_normals_and_texcoords),
        cmocka_unit_test(test_wedges),
        cmocka_unit_test(test_textures),
        cmocka_unit_test(test_face_colors),
        cmocka_unit_test(test_many_wedges),
        cmocka_unit_test(test_far_coordinates),
    };
    return cmocka_run_group_tests(tests, NULL, forget_last_model);
}
