/* OBJ: statements, indices, numbers, colours, smoothing and messages. */
#include "model_test.h"

#define SQUARE "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"

/* Reads the square's vertices and what stands behind them. */
static bool read_square(const char *rest)
{
    char text[2048];
    snprintf(text, sizeof text, SQUARE "%s", rest);
    return read_obj_text(text, NULL);
}

/* Requires a read model to be the square from -1 to 1: two triangles that turn left, of area 4. */
static void expect_square(bool good, const char *warning)
{
    expect_read(good, warning);
    assert_int_equal(read_model.part_count, 1);
    expect_area(read_model.parts, 2, 4.0);
}

static void test_forms_of_lines(void **state)
{
    static const char *const faces[] = {
        "f 1 2 3 4",        "f 1 2 3 4 # a square",    "f 1 2 3 4# a square",
        "f 1 2 3 4\r\n",    "f 1 2 3 4\r# more\r",     " \tf\t1  2 3\t4 \t",
        "f 1 2 \\\n3 4",    "f 1 2 \\\r\n 3 4\n",      "f -4 -3 -2 -1",
        "f +1 2 3 4",       "f 1/ 2/ 3/ 4/",           "f 1// 2// 3// 4//",
        "f 1 2 3\nf 1 3 4", "f 1 2 3\n f 1 3 4",       "g a\no b c\nf 1 2 3 4\n",
        "f 1 1 2 3 4 4",    "f -4 -3 -2 -1\nv 5 5 5\n"};
    static const char *const texts[] = {
        "\xef\xbb\xbfv -1 -1 0\rv 1 -1 0 #2\rv 1 1 0#3\r\tv -1 1 0\rf 1 2 3 4",
        /* A face may name vertices that come later. */
        "f 1 2 3 4\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n",
        "v -1. -1e0 .0\nv +1 -10e-1 -.0\nv 1d0 0.1E1 0\nv -1 1 0.\nf 1 2 3 4"};
    for (size_t i = 0; i < sizeof faces / sizeof faces[0]; ++i)
        expect_square(read_square(faces[i]), NULL);
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; ++i)
        expect_square(read_obj_text(texts[i], NULL), NULL);
}

/* What stands behind the square's four vertices, and the fault. */
static void test_faults(void **state)
{
#define NO_CORNER "behind f is not v, v/vt, v//vn or v/vt/vn"
#define NO_VERTEX_COUNT "line 5: v takes 3, 4, 6, 7 or 8 numbers, not "
    static const struct {
        const char *rest, *fault;
    } cases[] = {
        {"f 1 2 5\n", "line 5: f names v 5, but there are only 4"},
        {"\nf 1 2 \\\n 5\n", "line 6: f names v 5, but there are only 4"},
        {"f 0 1 2\n", "line 5: f names v 0, but the first is 1"},
        {"f -5 1 2\n", "line 5: f names v -5, but there are only 4 before it"},
        /* Relative indices count from their own line. */
        {"f -5 -4 -3\nv 0 0 0\n", "line 5: f names v -5, but there are only 4 before it"},
        {"f 1/1 2/1 3/1", "line 5: f names vt 1, but there are none"},
        {"vn 0 0 1\nf 1//1 2//1 3//2", "line 6: f names vn 2, but there is only 1"},
        {"l 1 9\n", "line 5: l names v 9, but there are only 4"},
        {"p 9\n", "line 5: p names v 9, but there are only 4"},
        {"f 1 2 99999999999999999999999\n",
         "line 5: f names v 999999999999999999, but there are only 4"},
        {"f 1 2 x", "line 5: \"x\" " NO_CORNER},
        {"f 1 2 1/2/3/4", "line 5: \"1/2/3/4\" " NO_CORNER},
        {"f 1 2 -", "line 5: \"-\" " NO_CORNER},
        {"f 1 2 3.0", "line 5: \"3.0\" " NO_CORNER},
        {"f 1 2 /1", "line 5: \"/1\" " NO_CORNER},
        {"vt 0 0\nf 1/1 2 3/1", "line 6: the corners of f do not have one form: \"2\" differs"},
        {"f 1", "line 5: f takes at least 3 corners, not 1"},
        {"f # 1 2 3", "line 5: f takes at least 3 corners, not 0"},
        {"l 1", "line 5: l takes at least 2 corners, not 1"},
        {"p", "line 5: p takes at least 1 corner, not 0"},
        {"v 1 2\n", NO_VERTEX_COUNT "2"},
        {"v 1 2 3 4 5\n", NO_VERTEX_COUNT "5"},
        {"v 1 2 3 4 5 6 7 8 9\n", NO_VERTEX_COUNT "9"},
        {"v 1,5 2 3\n", "line 5: \"1,5\" behind v is not a number"},
        {"v 1 2 three\n", "line 5: \"three\" behind v is not a number"},
        {"v 1 2 nano\n", "line 5: \"nano\" behind v is not a number"},
        {"vt 1 2 3 4\n", "line 5: vt takes 1 to 3 numbers, not 4"},
        {"vt\n", "line 5: vt takes 1 to 3 numbers, not 0"},
        {"vn 0 1\n", "line 5: vn takes 3 numbers, not 2"}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        expect_fault(read_square(cases[i].rest), cases[i].fault);
        assert_string_equal(read_messages.fault_file, "x.obj");
    }
    expect_fault(read_bytes(MODEL_OBJ, "x.obj", "v 0 0 0\nv 1 0 0\nv \0 1 0\nf 1 2 3\n", 33, NULL),
                 "it has a NUL byte, so it is not a text");
    expect_fault(read_obj_text("vn 0 0 1\n", NULL),
                 "there are no triangles, lines or points in it");
}

/* A file of vertices alone is a cloud of points, each with its colour. */
static void test_clouds(void **state)
{
    expect_read(read_obj_text("v 0 0 0 1 0 0\nv 1 2 3 0 0 1\nv nan 0 0 1 1 1\n", NULL),
                "x.obj: it has no faces, lines or points: its vertices are drawn as points (1)");
    assert_int_equal(read_model.part_count, 1);
    const model_part *const part = read_model.parts;
    expect_sizes(part, MODEL_POINTS, 2, 2);
    expect_color(part, part->indices[0], 1, 0, 0, 1);
    expect_color(part, part->indices[1], 0, 0, 1, 1);
    assert_true(part->positions[3 * part->indices[1] + 1] == 2.0f);
    /* Not beside a face. */
    expect_square(read_square("v 9 9 9\nf 1 2 3 4\n"), NULL);
}

static void test_numbers_that_are_not_finite(void **state)
{
    static const char *const spellings[] = {"nan",      "-NaN",      "-nan(ind)", "nan(snan)",
                                            "inf",      "-Infinity", "1.#INF",    "-1.#IND",
                                            "1.#IND00", "1.#QNAN",   "1e400",     "1e39"};
    char text[256];
    for (size_t i = 0; i < sizeof spellings / sizeof spellings[0]; ++i) {
        snprintf(text, sizeof text, "v 0 %s 0\nf 1 2 3 5\n", spellings[i]);
        expect_fault(read_square(text),
                     "line 6: the position of a vertex is not a finite number: that of v 5");
        /* No face names it. */
        snprintf(text, sizeof text, "v 0 %s 0\nf 1 2 3 4\n", spellings[i]);
        expect_square(read_square(text), NULL);
    }
    expect_square(read_square("vn 0 nan 1\nf 1//1 2//1 3//1 4//1\n"),
                  "x.obj: 4 vertices have normals that are not finite; they are computed from the "
                  "triangles (1)");
    assert_float_equal(read_model.parts[0].normals[2], 1.0f, 0.0f);
    assert_true(read_square("vt 1.#QNAN 1\nf 1/1 2/1 3/1 4/1\n"));
    assert_int_equal(read_messages.warning_count, 1);
    assert_float_equal(read_model.parts[0].texcoords[0], 0.0f, 0.0f);
}

/* Three forms: x y z r g b, with alpha, with a weight too. A colour that is no number leaves the
 * vertex opaque. Colours above 1 are bytes. */
static void test_colors(void **state)
{
    static const struct {
        const char *text, *warning;
        float colors[3][4];
    } cases[] = {
        {"v 0 0 0 1 0 0\nv 1 0 0 0 1 0 0.5\nv 0 1 0 2 0 0 1 0.25\nf 1 2 3\n",
         "x.obj: line 3: the weight of v, its fourth number, is for curves and is not used (1)",
         {{1, 0, 0, 1}, {0, 1, 0, 0.5f}, {0, 0, 1, 0.25f}}},
        {"v 0 0 0 1 nan 1\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\nf 1 2 3",
         "x.obj: line 1: the colour of v is not a finite number; 0 is used (1)",
         {{1, 0, 1, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}}},
        {"v 0 0 0 255 0 51\nv 1 0 0 0 1 0\nv 0 1 0 0 0 0\nf 1 2 3",
         "x.obj: line 1: colours of v are above 1: all are divided by 255 (1)",
         {{1, 0, 0.2f, 1}, {0, 1.0f / 255.0f, 0, 1}, {0, 0, 0, 1}}},
        {"v 0 0 0 255 0 0 255\nv 1 0 0 0 1 0\nv 0 1 0\nf 1 2 3",
         "x.obj: line 1: colours of v are above 1: all are divided by 255 (1)",
         {{1, 0, 0, 1}, {0, 1.0f / 255.0f, 0, 1}, {0.8f, 0.8f, 0.8f, 1}}}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        expect_read(read_obj_text(cases[i].text, NULL), cases[i].warning);
        const model_part *const part = read_model.parts;
        assert_true(read_model.part_count == 1 && part->has_vertex_colors);
        assert_int_equal(part->surface.alpha, i == 0 ? MODEL_BLEND : MODEL_OPAQUE);
        assert_float_equal(part->positions[7], 1.0f, 0.0f);
        expect_floats(part->colors, cases[i].colors[0], 12);
    }
    assert_true(read_obj_text("v 0 0 0 -1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", NULL));
    assert_true(has_warning("x.obj: line 1: a colour of v lies outside 0 to 255 (1)"));
    /* Faces with and without colours are parts of their own; nothing becomes transparent. */
    expect_read(read_obj_text("v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\n"
                              "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 4 5 6\nf 1 2 6",
                              NULL),
                NULL);
    assert_int_equal(read_model.part_count, 2);
    const model_part *const part = read_model.parts;
    assert_true(part[0].has_vertex_colors && !part[1].has_vertex_colors);
    expect_sizes(part, MODEL_TRIANGLES, 4, 6);
    expect_color(part, 0, 1.0f, 0.0f, 0.0f, 1.0f);
    expect_color(part, 3, 0.8f, 0.8f, 0.8f, 1.0f);
    expect_color(part + 1, 0, 0.8f, 0.8f, 0.8f, 1.0f);
    assert_int_equal(part->surface.alpha, MODEL_OPAQUE);
}

static void test_texcoords(void **state)
{
    expect_square(read_square("vt .5\nvt 1 0.25 7\nf 1/1 2/2 3/2 4/1"), NULL);
    const model_part *const part = read_model.parts;
    assert_true(part->has_texcoords && part->has_tangents && !part->has_normals);
    for (uint32_t v = 0; v < part->vertex_count; ++v) {
        const bool is_left = part->positions[3 * v] < 0.0f;
        assert_float_equal(part->texcoords[2 * v], is_left ? 0.5f : 1.0f, 0.0f);
        assert_float_equal(part->texcoords[2 * v + 1], is_left ? 0.0f : 0.25f, 0.0f);
    }
    /* Vertices that corners share are one; others are not. */
    expect_read(read_square("vt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/1 3/1 4/1\nf 1/2 3/1 4/1\n"), NULL);
    assert_int_equal(read_model.parts[0].vertex_count, 5);
}

static void test_kinds(void **state)
{
    expect_read(read_square("l 1 2 3\np 1 4\np 2\nf 1 2 3\nl 3/1 4/1\nvt 0 0\n"), NULL);
    assert_int_equal(read_model.part_count, 4);
    assert_int_equal(model_primitive_count(&read_model, MODEL_LINES), 3);
    assert_int_equal(model_primitive_count(&read_model, MODEL_POINTS), 3);
    assert_int_equal(model_primitive_count(&read_model, MODEL_TRIANGLES), 1);
    const model_part *const lines = read_model.parts;
    expect_sizes(lines, MODEL_LINES, 3, 4);
    assert_int_equal(lines->indices[1], lines->indices[2]);
    assert_float_equal(lines->positions[3 * lines->indices[3]], 1.0f, 0.0f);
    assert_float_equal(lines->positions[3 * lines->indices[3] + 1], 1.0f, 0.0f);
    /* Exporters write edges as faces of two corners. */
    expect_read(read_square("f 1 2\nf 2 3\nf 1 2 3"),
                "x.obj: line 5: f has only 2 corners, and is drawn as a line (2)");
    assert_int_equal(model_primitive_count(&read_model, MODEL_LINES), 2);
}

static void test_statements_that_are_not_drawn(void **state)
{
    static const char *const statements[] = {
        "vp",         "cstype",    "deg",   "bmat",     "step",     "curv", "curv2",  "surf",
        "parm",       "trim",      "hole",  "scrv",     "sp",       "end",  "con",    "call",
        "csh",        "mg",        "bevel", "c_interp", "d_interp", "lod",  "maplib", "usemap",
        "shadow_obj", "trace_obj", "ctech", "stech",    "anything"};
    for (size_t i = 0; i < sizeof statements / sizeof statements[0]; ++i) {
        char text[256], warning[256];
        snprintf(text, sizeof text, "%s 1 2\nf 1 2 3 4\n%s 3\n", statements[i], statements[i]);
        snprintf(warning, sizeof warning, "x.obj: line 5: %s is not drawn (2)", statements[i]);
        expect_square(read_square(text), warning);
    }
}

/* Two rectangles meet at a right angle along the y axis. Their normals at this ridge are those of
 * the two sides, or one upwards. Normals of the file go before smoothing. */
static void test_smoothing(void **state)
{
    static const struct {
        const char *faces;
        double crease;
        bool is_smooth;
    } cases[] = {{"f 1 2 3 4\nf 2 5 6 3\n", 91.0, true},
                 {"f 1 2 3 4\nf 2 5 6 3\n", 89.0, false},
                 {"s 1\nf 1 2 3 4\nf 2 5 6 3\n", 40.0, true},
                 {"s on\nf 1 2 3 4\nf 2 5 6 3\n", 40.0, true},
                 {"s off\nf 1 2 3 4\nf 2 5 6 3\n", 180.0, false},
                 {"s 0\nf 1 2 3 4\nf 2 5 6 3\n", 180.0, false},
                 {"s 1\nf 1 2 3 4\ns 2\nf 2 5 6 3\n", 180.0, false},
                 {"s 1\nf 1 2 3 4\ns off\nf 2 5 6 3\n", 180.0, false},
                 {"f 1 2 3 4\ns off\nf 2 5 6 3\n", 180.0, false},
                 {"vn 0 0 1\ns off\nf 1//1 2//1 3//1 4//1\nf 2//1 5//1 6//1 3//1\n", 40.0, true}};
    const float half = sqrtf(0.5f);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char text[512];
        bool sees_left = false, sees_right = false;
        snprintf(text, sizeof text,
                 "v -1 0 -1\nv 0 0 0\nv 0 1 0\nv -1 1 -1\nv 1 0 -1\nv 1 1 -1\n%s", cases[i].faces);
        read_crease = cases[i].crease;
        expect_read(read_obj_text(text, NULL), NULL);
        const model_part *const part = read_model.parts;
        assert_int_equal(read_model.part_count, 1);
        assert_int_equal(part->has_normals, i == 9);
        assert_int_equal(part->vertex_count, cases[i].is_smooth ? 6 : 8);
        for (uint32_t v = 0; v < part->vertex_count; ++v) {
            const float *const normal = part->normals + 3 * v;
            if (part->positions[3 * v] != 0.0f)
                continue;
            const float side = cases[i].is_smooth ? 0.0f : normal[0] < 0.0f ? -half : half;
            const float expected[3] = {side, 0.0f, cases[i].is_smooth ? 1.0f : half};
            expect_floats(normal, expected, 3);
            sees_left = sees_left || side < 0.0f;
            sees_right = sees_right || side > 0.0f;
        }
        assert_true(cases[i].is_smooth || (sees_left && sees_right));
    }
    read_crease = MODEL_CREASE_DEGREES;
    expect_square(read_square("s x\nf 1 2 3 4"), "x.obj: line 5: s x names no smoothing group (1)");
}

static void test_far_coordinates(void **state)
{
    expect_read(read_obj_text("v 500000.25 4500000.5 10\nv 500001.75 4500000.5 10\n"
                              "v 500001.75 4500002.25 10\nv 1e9 1e9 1e9\nf 1 2 3\n",
                              NULL),
                NULL);
    const double *const origin = read_model.origin;
    assert_true(origin[0] == 500001.0 && origin[1] == 4500001.375 && origin[2] == 10.0);
    const float *const p = read_model.parts[0].positions;
    assert_true((double)p[0] + origin[0] == 500000.25 && (double)p[1] + origin[1] == 4500000.5);
    assert_true((double)p[6] + origin[0] == 500001.75 && (double)p[7] + origin[1] == 4500002.25);
}

static void test_little_memory(void **state)
{
    static const test_file materials[] = {
        {"a.mtl", "newmtl m\nKd 1 0 0\nmap_Kd a.png\nmap_d b.png\nnewmtl n\nKd 0\n", 0},
        {NULL, NULL, 0}};
    require_within_budget(MODEL_OBJ, "x.obj",
                          SQUARE "mtllib a.mtl\nf 1 2 3 4\ns off\nl 1 2\nf 1 4 3 3 2\ns 1\n"
                                 "usemtl m\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 1/1 2/1 3/1\n",
                          materials);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_forms_of_lines), cmocka_unit_test(test_faults),
        cmocka_unit_test(test_clouds),         cmocka_unit_test(test_numbers_that_are_not_finite),
        cmocka_unit_test(test_colors),         cmocka_unit_test(test_texcoords),
        cmocka_unit_test(test_kinds),          cmocka_unit_test(test_statements_that_are_not_drawn),
        cmocka_unit_test(test_smoothing),      cmocka_unit_test(test_far_coordinates),
        cmocka_unit_test(test_little_memory),
    };
    return cmocka_run_group_tests(tests, NULL, forget_last_model);
}
