/* PLY files: what vertices, faces, strips and edges become. */
#include "ply_test.h"

static void test_square(void **state)
{
    (void)state;
    read_well(SQUARE);
    assert_int_equal(read_model.part_count, 1);
    const model_part *const p = read_model.parts;
    require_area(p, 2, 4.0);
    assert_int_equal(p->vertex_count, 4);
    assert_false(p->has_normals || p->has_texcoords || p->has_vertex_colors);
    for (size_t v = 0; v < 4; ++v) {
        require_color(p, v, 0.8, 0.8, 0.8, 1.0);
        assert_true(p->normals[3 * v + 2] == 1.0f);
    }
    assert_int_equal(p->surface.alpha, MODEL_OPAQUE);
}

static void test_polygons(void **state)
{
    (void)state;
    /* An arrow head whose reflex corner comes first, and an L. */
    read_well("ply\nformat ascii 1.0\nelement vertex 10\n" XYZ "element face 2\n" INDICES
              "end_header\n2 1 0\n4 0 0\n2 4 0\n0 0 0\n"
              "10 0 0\n13 0 0\n13 1 0\n11 1 0\n11 3 0\n10 3 0\n4 0 1 2 3\n6 4 5 6 7 8 9\n");
    require_area(read_model.parts, 2 + 4, 6.0 + 5.0);
    read_warned("ply\nformat ascii 1.0\nelement vertex 3\n" XYZ "element face 4\n" INDICES
                "end_header\n0 0 0\n1 0 0\n0 1 0\n0\n2 0 1\n3 0 1 2\n1 0\n",
                "x.ply: line 13: a face with fewer than 3 corners is not drawn (3)");
    require_area(read_model.parts, 1, 0.5);
}

static void test_strips(void **state)
{
    static const char vertices[] = "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n";
    char text[1024];
    (void)state;
    /* Four triangles, mirrored, so that the first is counter-clockwise. */
    snprintf(text, sizeof text,
             "ply\nformat ascii 1.0\nelement vertex 6\n" XYZ
             "element tristrips 1\nproperty list int int vertex_indices\nend_header\n%s"
             "6 1 0 3 2 5 4\n",
             vertices);
    read_well(text);
    require_area(read_model.parts, 4, 2.0);
    /* A new strip begins with its own winding; vertices that are named twice join two others. */
    snprintf(text, sizeof text,
             "ply\nformat ascii 1.0\nelement vertex 6\n" XYZ
             "element tristrips 3\nproperty list int int vertex_indices\nend_header\n%s"
             "10 1 0 3 -1 0 2 3 -1 -1 3\n8 3 2 5 5 2 2 3 5\n4 1 0 1 2\n",
             vertices);
    read_well(text);
    require_area(read_model.parts, 5, 2.5);
    snprintf(text, sizeof text,
             "ply\nformat ascii 1.0\nelement vertex 6\n" XYZ
             "element tristrips 1\nproperty list int uint vertex_indices\nend_header\n%s"
             "7 0 2 3 4294967295 0 3 1\n",
             vertices);
    read_well(text);
    require_area(read_model.parts, 2, 1.0);
    snprintf(text, sizeof text,
             "ply\nformat ascii 1.0\nelement vertex 6\n" XYZ
             "element tristrips 1\nproperty list int int vertex_indices\nend_header\n%s"
             "4 0 1 2 6\n",
             vertices);
    refuse(text, "line 16: tristrips 0 names vertex 6, but there are only 6");
    /* Strips before faces with colours: each has its own. */
    snprintf(text, sizeof text,
             "ply\nformat ascii 1.0\nelement vertex 6\n" XYZ
             "element tristrips 1\nproperty list int int vertex_indices\nelement face 1\n" INDICES
             "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n%s"
             "3 0 2 3\n3 0 3 1 255 0 0\n",
             vertices);
    read_well(text);
    const model_part *const p = read_model.parts;
    require_area(p, 2, 1.0);
    assert_int_equal(p->vertex_count, 6);
    require_color(p, p->indices[0], 1.0, 0.0, 0.0, 1.0);
    require_color(p, p->indices[3], 0.8, 0.8, 0.8, 1.0);
}

static void test_edges(void **state)
{
    (void)state;
    read_well(
        "ply\nformat ascii 1.0\nelement vertex 4\n" XYZ
        "element edge 2\nproperty int vertex1\nproperty int vertex2\nend_header\n" SQUARE_POINTS
        "0 1\n1 3\n");
    assert_int_equal(read_model.part_count, 1);
    assert_int_equal(read_model.parts->kind, MODEL_LINES);
    assert_int_equal(read_model.parts->index_count, 4);
    assert_int_equal(read_model.parts->vertex_count, 3);
    refuse("ply\nformat ascii 1.0\nelement vertex 4\n" XYZ
           "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n" SQUARE_POINTS
           "0 4\n",
           "line 15: edge 0 names vertex 4, but there are only 4");
    refuse("ply\nformat ascii 1.0\nelement vertex 4\n" XYZ
           "element edge 1\nproperty int vertex1\nend_header\n" SQUARE_POINTS "0\n",
           "element edge has no properties vertex1 and vertex2");
}

static void test_points(void **state)
{
    (void)state;
    read_well("ply\nformat ascii 1.0\nelement vertex 2\n" XYZ
              "property uchar red\nproperty uchar green\nproperty uchar blue\n"
              "element face 0\n" INDICES "end_header\n0 0 0 255 0 51\n1 2 3 0 255 102\n");
    const model_part *const p = read_model.parts;
    assert_int_equal(read_model.part_count, 1);
    assert_int_equal(p->kind, MODEL_POINTS);
    assert_int_equal(p->index_count, 2);
    assert_true(p->has_vertex_colors);
    require_color(p, 0, 1.0, 0.0, 0.2, 1.0);
    require_color(p, 1, 0.0, 1.0, 0.4, 1.0);
    assert_true(p->positions[3] == 1.0f && p->positions[4] == 2.0f && p->positions[5] == 3.0f);
    /* The shortest text, without an end of its last line. */
    read_well("ply\nformat ascii 1.0\nelement vertex 3\n" XYZ "end_header\n0 0 0\n1 0 0\n0 1 0");
    assert_int_equal(read_model.parts->index_count, 3);
    /* Scanners write NaN where they saw nothing. */
    read_warned("ply\nformat ascii 1.0\nelement vertex 3\n" XYZ "end_header\nnan nan nan\n1 2 3\n"
                "0 inf 0\n",
                "x.ply: 2 points are not finite and not drawn (1)");
    assert_int_equal(read_model.parts->index_count, 1);
    assert_true(read_model.origin[0] + (double)read_model.parts->positions[0] == 1.0);
    /* Elements that are announced, but not there, need no properties. */
    read_well("ply\nformat ascii 1.0\nelement vertex 1\n" XYZ
              "element face 0\nelement tristrips 0\nelement edge 0\nend_header\n0 0 0\n");
    assert_int_equal(read_model.parts->kind, MODEL_POINTS);
    /* Vertices beside faces are no points. */
    read_well("ply\nformat ascii 1.0\nelement vertex 4\n" XYZ "element face 1\n" INDICES
              "end_header\n0 0 0\n9 9 nan\n1 0 0\n0 1 0\n3 0 2 3\n");
    assert_int_equal(read_model.part_count, 1);
    require_area(read_model.parts, 1, 0.5);
    assert_int_equal(read_model.parts->vertex_count, 3);
}

static void test_splats(void **state)
{
    (void)state;
    read_warned("ply\nformat ascii 1.0\nelement vertex 1\n" XYZ
                "property float nx\nproperty float ny\nproperty float nz\nproperty float f_dc_0\n"
                "property float f_dc_1\nproperty float f_dc_2\nproperty float f_rest_0\n"
                "property float opacity\nproperty float scale_0\nproperty float scale_1\n"
                "property float scale_2\nproperty float rot_0\nproperty float rot_1\n"
                "property float rot_2\nproperty float rot_3\nend_header\n"
                "1 2 3 0 0 0 1 0 -9 .1 5 -3 -3 -3 1 0 0 0\n",
                "x.ply: Gaussian splats are drawn as points of one colour (1)");
    assert_int_equal(read_model.parts->kind, MODEL_POINTS);
    /* 0.5 + 1 / (2 sqrt(pi)). */
    require_color(read_model.parts, 0, 0.78209479, 0.5, 0.0, 1.0);
}

/* Reads a triangle whose three vertices have these properties and values. */
static void read_attributes(const char *properties, const char *values)
{
    char text[1024];
    snprintf(text, sizeof text,
             "ply\nformat ascii 1.0\nelement vertex 3\n" XYZ "%s"
             "element face 1\n" INDICES "end_header\n0 0 0 %s\n1 0 0 %s\n0 1 0 %s\n3 0 1 2\n",
             properties, values, values, values);
    assert_true(read_text(text));
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
    (void)state;
    for (size_t n = 0; n < 3; ++n)
        for (size_t t = 0; t < 6; ++t) {
            char properties[256];
            snprintf(properties, sizeof properties,
                     "property %s %s\nproperty %s %s\nproperty %s %s\nproperty %s %s\n",
                     types[t].type, names[n][0], types[t].type, names[n][1], types[t].type,
                     names[n][2], types[t].type, names[n][3]);
            read_attributes(properties, types[t].values);
            assert_int_equal(read_messages.warning_count, 0);
            require_color(read_model.parts, 2, 0.2, 0.4, 0.6, 0.8);
            assert_int_equal(read_model.parts->surface.alpha, MODEL_BLEND);
            assert_true(read_model.parts->has_vertex_colors);
        }
    read_attributes("property uchar red\nproperty uchar green\nproperty uchar blue\n"
                    "property uchar alpha\n",
                    "51 102 153 0");
    assert_true(has_warning("x.ply: alpha is 0 everywhere; it is drawn opaque (1)"));
    require_color(read_model.parts, 0, 0.2, 0.4, 0.6, 1.0);
    assert_int_equal(read_model.parts->surface.alpha, MODEL_OPAQUE);
    read_attributes("property uchar red\nproperty uchar blue\n", "51 102");
    assert_true(has_warning("x.ply: colours of vertex are not drawn: a property is missing (1)"));
    require_color(read_model.parts, 0, 0.8, 0.8, 0.8, 1.0);
}

static void test_normals(void **state)
{
    (void)state;
    read_attributes("property float nx\nproperty float ny\nproperty double nz\n", "1 0 0.5");
    assert_int_equal(read_messages.warning_count, 0);
    assert_true(read_model.parts->has_normals);
    assert_true(read_model.parts->normals[3] == 1.0f && read_model.parts->normals[5] == 0.5f);
    read_attributes("property float nx\nproperty float ny\nproperty float nz\n", "nan 0 0");
    assert_true(has_warning("x.ply: 3 vertices have normals that are not finite; they are computed "
                            "from the triangles (1)"));
    assert_true(read_model.parts->normals[2] == 1.0f);
    read_attributes("property float nx\nproperty float ny\n", "1 0");
    assert_true(has_warning("x.ply: normals of vertex are not drawn: a property is missing (1)"));
}

static void test_texcoords(void **state)
{
    static const char *const names[][2] = {
        {"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}};
    (void)state;
    for (size_t n = 0; n < 4; ++n) {
        char properties[128];
        snprintf(properties, sizeof properties, "property float %s\nproperty float %s\n",
                 names[n][0], names[n][1]);
        read_attributes(properties, "0.25 0.75");
        assert_int_equal(read_messages.warning_count, 0);
        const model_part *const p = read_model.parts;
        assert_true(p->has_texcoords && p->has_tangents);
        assert_true(p->texcoords[4] == 0.25f && p->texcoords[5] == 0.75f);
        assert_int_equal(read_model.image_count, 0);
    }
}

static void test_wedges(void **state)
{
    static const char text[] =
        "ply\nformat ascii 1.0\ncomment TextureFile a picture.png\nelement vertex 4\n" XYZ
        "element face 2\n" INDICES "property list uchar float texcoord\nend_header\n" SQUARE_POINTS
        "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0 0 1 1 0.5 1\n";
    (void)state;
    read_well(text);
    const model_part *p = read_model.parts;
    require_area(p, 2, 4.0);
    /* Vertices 0 and 2 have the same coordinates in both faces. */
    assert_int_equal(p->vertex_count, 4);
    assert_true(p->has_texcoords);
    assert_true(p->texcoords[2 * p->indices[5]] == 0.5f);
    assert_int_equal(p->maps[MAP_DIFFUSE].image, 0);
    assert_string_equal(read_model.images[0].name, "a picture.png");
    assert_int_equal(read_model.material_count, 1);
    require_color(p, 0, 1.0, 1.0, 1.0, 1.0);
    /* Other coordinates in the second face, which is a polygon. */
    read_well("ply\nformat ascii 1.0\nelement vertex 6\n" XYZ "element face 2\n" INDICES
              "property list uchar float texcoord\nend_header\n" SQUARE_POINTS "3 -1 0\n3 1 0\n"
              "4 0 1 2 3 8 0 0 1 0 1 1 0 1\n4 1 4 5 2 8 .1 .2 .3 .4 .5 .6 .7 .8\n");
    p = read_model.parts;
    require_area(p, 4, 8.0);
    assert_int_equal(p->vertex_count, 8);
    for (size_t i = 6; i < 12; ++i) {
        const uint32_t v = p->indices[i];
        const bool is_right = p->positions[3 * v] == 3.0f,
                   is_upper = p->positions[3 * v + 1] > 0.0f;
        const float s = is_right ? (is_upper ? 0.5f : 0.3f) : (is_upper ? 0.7f : 0.1f);
        assert_true(p->texcoords[2 * v] == s);
        assert_true(fabs((double)p->texcoords[2 * v + 1] - (double)s - 0.1) < 1e-6);
    }
    read_warned("ply\nformat ascii 1.0\nelement vertex 3\n" XYZ "element face 1\n" INDICES
                "property list uchar float texcoord\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
                "3 0 1 2 5 1 1 1 1 1\n",
                "x.ply: line 14: texcoord has not two numbers for each corner; 0 is used (1)");
    read_well("ply\nformat ascii 1.0\nelement vertex 3\n" XYZ "element face 1\n" INDICES
              "property list uchar float texcoord\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 0\n");
    assert_true(read_model.parts->texcoords[0] == 0.0f);
}

static void test_textures(void **state)
{
    (void)state;
    read_well(
        "ply\nformat ascii 1.0\ncomment TextureFile a.png\ncomment TextureFile b.png\n"
        "element vertex 4\n" XYZ "element face 4\n" INDICES
        "property list uchar float texcoord\nproperty int texnumber\nend_header\n" SQUARE_POINTS
        "3 0 1 2 6 0 0 1 0 1 1 1\n3 0 2 3 6 0 0 1 1 0 1 0\n3 0 1 3 6 0 0 1 0 1 1 -1\n"
        "3 1 2 3 6 0 0 1 1 0 1 1\n");
    assert_int_equal(read_model.part_count, 3);
    assert_int_equal(read_model.parts[0].index_count, 3);
    assert_int_equal(read_model.parts[1].index_count, 6);
    assert_int_equal(read_model.parts[2].index_count, 3);
    assert_string_equal(read_model.images[read_model.parts[0].maps[MAP_DIFFUSE].image].name,
                        "a.png");
    assert_string_equal(read_model.images[read_model.parts[1].maps[MAP_DIFFUSE].image].name,
                        "b.png");
    assert_true(read_model.parts[2].maps[MAP_DIFFUSE].image == MODEL_NO_IMAGE);
    require_color(read_model.parts + 2, 0, 0.8, 0.8, 0.8, 1.0);
    read_warned("ply\nformat ascii 1.0\ncomment TextureFile a.png\nelement vertex 3\n" XYZ
                "element face 1\n" INDICES "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                "x.ply: TextureFile a.png is not drawn: no face has texture coordinates (1)");
}

static void test_face_colors(void **state)
{
    (void)state;
    read_well(
        "ply\nformat ascii 1.0\nelement vertex 4\n" XYZ "element face 3\n" INDICES
        "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n" SQUARE_POINTS
        "3 0 1 2 255 0 0\n3 0 2 3 0 255 0\n3 0 1 3 255 0 0\n");
    const model_part *const p = read_model.parts;
    assert_int_equal(p->index_count, 9);
    /* Red ones of four vertices, green ones of three. */
    assert_int_equal(p->vertex_count, 7);
    for (size_t i = 0; i < 9; ++i)
        require_color(p, p->indices[i], i / 3 != 1, i / 3 == 1, 0.0, 1.0);
}

/* A vertex in more combinations than are compared is repeated, and nothing else. */
static void test_many_wedges(void **state)
{
    static char text[40000];
    char *to = text;
    (void)state;
    to += sprintf(to, "ply\nformat ascii 1.0\nelement vertex 3\n" XYZ "element face 300\n" INDICES
                      "property list uchar float texcoord\nend_header\n0 0 0\n1 0 0\n0 1 0\n");
    for (int i = 0; i < 300; ++i)
        to += sprintf(to, "3 0 1 2 6 %d 0 %d 0 %d 0\n", i, i, i);
    read_well(text);
    const model_part *const p = read_model.parts;
    require_area(p, 300, 150.0);
    assert_int_equal(p->vertex_count, 900);
    for (size_t i = 0; i < 900; ++i)
        assert_true(p->texcoords[2 * p->indices[i]] == (float)(i / 3));
}

static void test_far_coordinates(void **state)
{
    writer w;
    static const double corners[4][2] = {
        {499999.9, 4499999.9}, {500000.1, 4499999.9}, {500000.1, 4500000.1}, {499999.9, 4500000.1}};
    (void)state;
    write_header(&w, true,
                 "element vertex 5\nproperty double x\nproperty double y\nproperty double z\n"
                 "element face 1\n" INDICES "end_header\n");
    for (int v = 0; v < 5; ++v) {
        /* One that no face uses does not count. */
        write_double(&w, v < 4 ? corners[v][0] : 0.0);
        write_double(&w, v < 4 ? corners[v][1] : 0.0);
        write_double(&w, 0.0);
    }
    write_bits(&w, 4, 1);
    for (uint32_t i = 0; i < 4; ++i)
        write_bits(&w, i, 4);
    assert_true(read_written(&w));
    assert_int_equal(read_messages.warning_count, 0);
    require_area(read_model.parts, 2, 0.04);
    for (size_t v = 0; v < 4; ++v)
        for (size_t c = 0; c < 2; ++c)
            assert_true(fabs(read_model.origin[c] + (double)read_model.parts->positions[3 * v + c] -
                             corners[v][c]) < 1e-8);
    /* The same as a text whose type says float. */
    read_well("ply\nformat ascii 1.0\nelement vertex 3\n" XYZ "element face 1\n" INDICES
              "end_header\n500000.25 4500000.5 0\n500001.25 4500000.5 0\n500000.25 4500001.5 0\n"
              "3 0 1 2\n");
    require_area(read_model.parts, 1, 0.5);
    assert_true(read_model.origin[0] == 500000.75 && read_model.origin[1] == 4500001.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_square),      cmocka_unit_test(test_polygons),
        cmocka_unit_test(test_strips),      cmocka_unit_test(test_edges),
        cmocka_unit_test(test_points),      cmocka_unit_test(test_splats),
        cmocka_unit_test(test_colors),      cmocka_unit_test(test_normals),
        cmocka_unit_test(test_texcoords),   cmocka_unit_test(test_wedges),
        cmocka_unit_test(test_textures),    cmocka_unit_test(test_face_colors),
        cmocka_unit_test(test_many_wedges), cmocka_unit_test(test_far_coordinates),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    forget_model();
    return failed;
}
