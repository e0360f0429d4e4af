/* OBJ: statements, indices, polygons, groups and messages. */
#include "model_test.h"

#include <math.h>

#include "obj_test.h"

static const char square[] = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";

/* Reads the square's vertices and what stands behind them. */
static bool read_square(const char *rest)
{
    char text[2048];
    snprintf(text, sizeof text, "%s%s", square, rest);
    return read_obj_text(text, NULL);
}

static void expect_square_fault(const char *rest, const char *expected)
{
    assert_false(read_square(rest));
    assert_string_equal(read_messages.fault_file, "x.obj");
    assert_string_equal(read_messages.fault, expected);
}

/* Whether the model is the square from -1 to 1: two triangles that turn left, of area 4. */
static void expect_square(void)
{
    double smallest;
    assert_int_equal(read_model.part_count, 1);
    assert_int_equal(read_model.parts[0].index_count, 6);
    assert_float_equal(signed_area(read_model.parts, &smallest), 4.0, 0.0);
    assert_true(smallest > 0.0);
}

static void test_forms_of_lines(void **state)
{
    static const char *const faces[] = {
        "f 1 2 3 4",        "f 1 2 3 4 # a square", "f 1 2 3 4# a square",
        "f 1 2 3 4\r\n",    "f 1 2 3 4\r# more\r",  " \tf\t1  2 3\t4 \t",
        "f 1 2 \\\n3 4",    "f 1 2 \\\r\n 3 4\n",   "f -4 -3 -2 -1",
        "f +1 2 3 4",       "f 1/ 2/ 3/ 4/",        "f 1// 2// 3// 4//",
        "f 1 2 3\nf 1 3 4", "f 1 2 3\n f 1 3 4",    "g a\no b c\nf 1 2 3 4\n",
        "f 1 1 2 3 4 4",
    };
    (void)state;
    for (size_t i = 0; i < sizeof faces / sizeof faces[0]; ++i) {
        assert_true(read_square(faces[i]));
        expect_square();
        assert_int_equal(read_messages.warning_count, 0);
    }
    assert_true(read_obj_text(
        "\xef\xbb\xbfv -1 -1 0\rv 1 -1 0 #2\rv 1 1 0#3\r\tv -1 1 0\rf 1 2 3 4", NULL));
    expect_square();
    /* A face may name vertices that come later. */
    assert_true(read_obj_text("f 1 2 3 4\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n", NULL));
    expect_square();
    assert_true(
        read_obj_text("v -1. -1e0 .0\nv +1 -10e-1 -.0\nv 1d0 0.1E1 0\nv -1 1 0.\nf 1 2 3 4", NULL));
    expect_square();
}

static void test_indices(void **state)
{
    (void)state;
    expect_square_fault("f 1 2 5\n", "line 5: f names v 5, but there are only 4");
    expect_square_fault("\nf 1 2 \\\n 5\n", "line 6: f names v 5, but there are only 4");
    expect_square_fault("f 0 1 2\n", "line 5: f names v 0, but the first is 1");
    expect_square_fault("f -5 1 2\n", "line 5: f names v -5, but there are only 4 before it");
    expect_square_fault("f 1/1 2/1 3/1", "line 5: f names vt 1, but there are none");
    expect_square_fault("vn 0 0 1\nf 1//1 2//1 3//2", "line 6: f names vn 2, but there is only 1");
    expect_square_fault("l 1 9\n", "line 5: l names v 9, but there are only 4");
    expect_square_fault("p 9\n", "line 5: p names v 9, but there are only 4");
    expect_square_fault("f 1 2 99999999999999999999999\n",
                        "line 5: f names v 999999999999999999, but there are only 4");
    expect_square_fault("f 1 2 x", "line 5: \"x\" behind f is not v, v/vt, v//vn or v/vt/vn");
    expect_square_fault("f 1 2 1/2/3/4",
                        "line 5: \"1/2/3/4\" behind f is not v, v/vt, v//vn or v/vt/vn");
    expect_square_fault("f 1 2 -", "line 5: \"-\" behind f is not v, v/vt, v//vn or v/vt/vn");
    expect_square_fault("f 1 2 3.0", "line 5: \"3.0\" behind f is not v, v/vt, v//vn or v/vt/vn");
    expect_square_fault("f 1 2 /1", "line 5: \"/1\" behind f is not v, v/vt, v//vn or v/vt/vn");
    expect_square_fault("vt 0 0\nf 1/1 2 3/1",
                        "line 6: the corners of f do not have one form: \"2\" differs");
    expect_square_fault("f 1", "line 5: f takes at least 3 corners, not 1");
    expect_square_fault("f # 1 2 3", "line 5: f takes at least 3 corners, not 0");
    expect_square_fault("l 1", "line 5: l takes at least 2 corners, not 1");
    expect_square_fault("p", "line 5: p takes at least 1 corner, not 0");
    /* Relative indices count from their own line. */
    assert_false(read_obj_text("v -1 -1 0\nf -3 -2 -1\nv 1 -1 0\nv 1 1 0\n", NULL));
    assert_string_equal(read_messages.fault, "line 2: f names v -3, but there is only 1 before it");
    assert_true(
        read_obj_text("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf -4 -3 -2 -1\nv 5 5 5\n", NULL));
    expect_square();
}

/* A file of vertices alone is a cloud of points, each with its colour. */
static void test_clouds(void **state)
{
    (void)state;
    assert_true(read_obj_text("v 0 0 0 1 0 0\nv 1 2 3 0 0 1\nv nan 0 0 1 1 1\n", NULL));
    assert_true(has_warning(
        "x.obj: it has no faces, lines or points: its vertices are drawn as points (1)"));
    assert_int_equal(read_model.part_count, 1);
    const model_part *const part = read_model.parts;
    assert_int_equal(part->kind, MODEL_POINTS);
    assert_int_equal(part->index_count, 2);
    expect_color(part, part->indices[0], 1, 0, 0, 1);
    expect_color(part, part->indices[1], 0, 0, 1, 1);
    assert_true(part->positions[3 * part->indices[1] + 1] == 2.0f);
    /* Not beside a face. */
    assert_true(read_obj_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nf 1 2 3\n", NULL));
    assert_int_equal(read_messages.warning_count, 0);
    assert_int_equal(read_model.part_count, 1);
    assert_false(read_obj_text("vn 0 0 1\n", NULL));
    assert_string_equal(read_messages.fault, "there are no triangles, lines or points in it");
}

static void test_numbers(void **state)
{
    (void)state;
    expect_square_fault("v 1 2\n", "line 5: v takes 3, 4, 6, 7 or 8 numbers, not 2");
    expect_square_fault("v 1 2 3 4 5\n", "line 5: v takes 3, 4, 6, 7 or 8 numbers, not 5");
    expect_square_fault("v 1 2 3 4 5 6 7 8 9\n", "line 5: v takes 3, 4, 6, 7 or 8 numbers, not 9");
    expect_square_fault("v 1,5 2 3\n", "line 5: \"1,5\" behind v is not a number");
    expect_square_fault("v 1 2 three\n", "line 5: \"three\" behind v is not a number");
    expect_square_fault("vt 1 2 3 4\n", "line 5: vt takes 1 to 3 numbers, not 4");
    expect_square_fault("vt\n", "line 5: vt takes 1 to 3 numbers, not 0");
    expect_square_fault("vn 0 1\n", "line 5: vn takes 3 numbers, not 2");
    assert_false(read_bytes(MODEL_OBJ, "x.obj", "v 0 0 0\nv 1 0 0\nv \0 1 0\nf 1 2 3\n", 33, NULL));
    assert_string_equal(read_messages.fault, "it has a NUL byte, so it is not a text");
}

static void test_numbers_that_are_not_finite(void **state)
{
    static const char *const spellings[] = {"nan",     "-NaN",  "inf", "1.#INF",
                                            "-1.#IND", "1e400", "1e39"};
    char text[256];
    (void)state;
    for (size_t i = 0; i < sizeof spellings / sizeof spellings[0]; ++i) {
        snprintf(text, sizeof text, "v 0 %s 0\nf 1 2 3 5\n", spellings[i]);
        expect_square_fault(text,
                            "line 6: the position of a vertex is not a finite number: that of v 5");
        /* No face names it. */
        snprintf(text, sizeof text, "v 0 %s 0\nf 1 2 3 4\n", spellings[i]);
        assert_true(read_square(text));
        expect_square();
    }
    assert_true(read_square("vn 0 nan 1\nf 1//1 2//1 3//1 4//1\n"));
    assert_true(has_warning("x.obj: 4 vertices have normals that are not finite; they are computed "
                            "from the triangles (1)"));
    assert_float_equal(read_model.parts[0].normals[2], 1.0f, 0.0f);
    assert_true(read_square("vt 1.#QNAN 1\nf 1/1 2/1 3/1 4/1\n"));
    assert_int_equal(read_messages.warning_count, 1);
    assert_float_equal(read_model.parts[0].texcoords[0], 0.0f, 0.0f);
    /* A colour that is no number leaves the vertex opaque. */
    assert_true(read_obj_text("v 0 0 0 1 nan 1\nv 1 0 0\nv 0 1 0\nf 1 2 3", NULL));
    assert_true(
        has_warning("x.obj: line 1: the colour of v is not a finite number; 0 is used (1)"));
    expect_color(read_model.parts, 0, 1.0f, 0.0f, 1.0f, 1.0f);
}

static void test_colors(void **state)
{
    (void)state;
    /* Three forms: x y z r g b, with alpha, with a weight too. */
    assert_true(
        read_obj_text("v 0 0 0 1 0 0\nv 1 0 0 0 1 0 0.5\nv 0 1 0 2 0 0 1 0.25\nf 1 2 3\n", NULL));
    assert_int_equal(read_model.part_count, 1);
    const model_part *part = read_model.parts;
    assert_true(part->has_vertex_colors);
    expect_color(part, 0, 1.0f, 0.0f, 0.0f, 1.0f);
    expect_color(part, 1, 0.0f, 1.0f, 0.0f, 0.5f);
    expect_color(part, 2, 0.0f, 0.0f, 1.0f, 0.25f);
    assert_int_equal(part->surface.alpha, MODEL_BLEND);
    assert_float_equal(part->positions[7], 1.0f, 0.0f);
    assert_true(has_warning("x.obj: line 3: the weight of v, its fourth number, is for curves and "
                            "is not used (1)"));

    /* Faces with and without colours are parts of their own; nothing becomes transparent. */
    assert_true(read_obj_text("v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\n"
                              "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 4 5 6\nf 1 2 6",
                              NULL));
    assert_int_equal(read_model.part_count, 2);
    part = read_model.parts;
    assert_true(part[0].has_vertex_colors && !part[1].has_vertex_colors);
    assert_int_equal(part[0].index_count, 6);
    assert_int_equal(part[0].vertex_count, 4);
    expect_color(part, 0, 1.0f, 0.0f, 0.0f, 1.0f);
    expect_color(part, 3, 0.8f, 0.8f, 0.8f, 1.0f);
    expect_color(part + 1, 0, 0.8f, 0.8f, 0.8f, 1.0f);
    assert_int_equal(part->surface.alpha, MODEL_OPAQUE);

    assert_true(read_obj_text("v 0 0 0 255 0 51\nv 1 0 0 0 1 0\nv 0 1 0 0 0 0\nf 1 2 3", NULL));
    assert_true(has_warning("x.obj: line 1: colours of v are above 1: all are divided by 255 (1)"));
    expect_color(read_model.parts, 0, 1.0f, 0.0f, 0.2f, 1.0f);
    expect_color(read_model.parts, 1, 0.0f, 1.0f / 255.0f, 0.0f, 1.0f);
    assert_true(read_obj_text("v 0 0 0 255 0 0 255\nv 1 0 0 0 1 0\nv 0 1 0\nf 1 2 3", NULL));
    expect_color(read_model.parts, 0, 1.0f, 0.0f, 0.0f, 1.0f);
    expect_color(read_model.parts, 1, 0.0f, 1.0f / 255.0f, 0.0f, 1.0f);
    assert_true(read_obj_text("v 0 0 0 -1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", NULL));
    assert_true(has_warning("x.obj: line 1: a colour of v lies outside 0 to 255 (1)"));
}

static void test_texcoords(void **state)
{
    (void)state;
    assert_true(read_square("vt .5\nvt 1 0.25 7\nf 1/1 2/2 3/2 4/1"));
    expect_square();
    const model_part *const part = read_model.parts;
    assert_true(part->has_texcoords && part->has_tangents && !part->has_normals);
    for (uint32_t v = 0; v < part->vertex_count; ++v) {
        const bool is_left = part->positions[3 * v] < 0.0f;
        assert_float_equal(part->texcoords[2 * v], is_left ? 0.5f : 1.0f, 0.0f);
        assert_float_equal(part->texcoords[2 * v + 1], is_left ? 0.0f : 0.25f, 0.0f);
    }
}

static void test_kinds(void **state)
{
    (void)state;
    assert_true(read_square("l 1 2 3\np 1 4\np 2\nf 1 2 3\nl 3/1 4/1\nvt 0 0\n"));
    assert_int_equal(read_messages.warning_count, 0);
    assert_int_equal(read_model.part_count, 4);
    assert_int_equal(model_primitive_count(&read_model, MODEL_LINES), 3);
    assert_int_equal(model_primitive_count(&read_model, MODEL_POINTS), 3);
    assert_int_equal(model_primitive_count(&read_model, MODEL_TRIANGLES), 1);
    const model_part *const lines = read_model.parts;
    assert_int_equal(lines->kind, MODEL_LINES);
    assert_int_equal(lines->vertex_count, 3);
    assert_int_equal(lines->indices[1], lines->indices[2]);
    assert_float_equal(lines->positions[3 * lines->indices[3]], 1.0f, 0.0f);
    assert_float_equal(lines->positions[3 * lines->indices[3] + 1], 1.0f, 0.0f);

    /* Exporters write edges as faces of two corners. */
    assert_true(read_square("f 1 2\nf 2 3\nf 1 2 3"));
    assert_int_equal(model_primitive_count(&read_model, MODEL_LINES), 2);
    assert_true(has_warning("x.obj: line 5: f has only 2 corners, and is drawn as a line (2)"));
}

static void test_statements_that_are_not_drawn(void **state)
{
    static const char *const statements[] = {
        "vp",         "cstype",    "deg",   "bmat",     "step",     "curv", "curv2",  "surf",
        "parm",       "trim",      "hole",  "scrv",     "sp",       "end",  "con",    "call",
        "csh",        "mg",        "bevel", "c_interp", "d_interp", "lod",  "maplib", "usemap",
        "shadow_obj", "trace_obj", "ctech", "stech",    "anything"};
    char text[256];
    (void)state;
    for (size_t i = 0; i < sizeof statements / sizeof statements[0]; ++i) {
        snprintf(text, sizeof text, "%s 1 2\nf 1 2 3 4\n%s 3\n", statements[i], statements[i]);
        assert_true(read_square(text));
        expect_square();
        assert_int_equal(read_messages.warning_count, 1);
        snprintf(text, sizeof text, "x.obj: line 5: %s is not drawn (2)", statements[i]);
        assert_true(has_warning(text));
    }
}

/* A roof: two rectangles that meet at a right angle along the y axis. */
#define ROOF "v -1 0 -1\nv 0 0 0\nv 0 1 0\nv -1 1 -1\nv 1 0 -1\nv 1 1 -1\n"

static void expect_normal(const model_part *part, uint32_t v, float x, float y, float z)
{
    assert_float_equal(part->normals[3 * v], x, 1e-6f);
    assert_float_equal(part->normals[3 * v + 1], y, 1e-6f);
    assert_float_equal(part->normals[3 * v + 2], z, 1e-6f);
}

/* Checks the normals of the roof at its ridge: upwards, or those of the two sides. */
static void expect_ridge(const char *faces, bool is_smooth)
{
    const float half = sqrtf(0.5f);
    char text[512];
    snprintf(text, sizeof text, "%s%s", ROOF, faces);
    assert_true(read_obj_text(text, NULL));
    assert_int_equal(read_messages.warning_count, 0);
    for (size_t p = 0; p < read_model.part_count; ++p) {
        const model_part *const part = read_model.parts + p;
        bool sees_left = false, sees_right = false;
        for (uint32_t v = 0; v < part->vertex_count; ++v) {
            if (part->positions[3 * v] != 0.0f)
                continue;
            if (is_smooth) {
                expect_normal(part, v, 0.0f, 0.0f, 1.0f);
                continue;
            }
            const float side = part->normals[3 * v] < 0.0f ? -half : half;
            expect_normal(part, v, side, 0.0f, half);
            sees_left = sees_left || side < 0.0f;
            sees_right = sees_right || side > 0.0f;
        }
        assert_true(is_smooth || (sees_left && sees_right));
    }
}

static void test_smoothing(void **state)
{
    (void)state;
    expect_ridge("f 1 2 3 4\nf 2 5 6 3\n", true);
    expect_ridge("s 1\nf 1 2 3 4\nf 2 5 6 3\n", true);
    expect_ridge("s on\nf 1 2 3 4\nf 2 5 6 3\n", true);
    expect_ridge("s off\nf 1 2 3 4\nf 2 5 6 3\n", false);
    expect_ridge("s 0\nf 1 2 3 4\nf 2 5 6 3\n", false);
    expect_ridge("s 1\nf 1 2 3 4\ns 2\nf 2 5 6 3\n", false);
    expect_ridge("s 1\nf 1 2 3 4\ns off\nf 2 5 6 3\n", false);
    expect_ridge("f 1 2 3 4\ns off\nf 2 5 6 3\n", false);
    /* Normals of the file go before smoothing. */
    expect_ridge("vn 0 0 1\ns off\nf 1//1 2//1 3//1 4//1\nf 2//1 5//1 6//1 3//1\n", true);
    assert_true(read_model.parts[0].has_normals);
    assert_int_equal(read_model.parts[0].vertex_count, 6);
    assert_true(read_square("s x\nf 1 2 3 4"));
    assert_true(has_warning("x.obj: line 5: s x names no smoothing group (1)"));
}

static void test_far_coordinates(void **state)
{
    (void)state;
    assert_true(read_obj_text("v 500000.25 4500000.5 10\nv 500001.75 4500000.5 10\n"
                              "v 500001.75 4500002.25 10\nv 1e9 1e9 1e9\nf 1 2 3\n",
                              NULL));
    const double *const origin = read_model.origin;
    assert_true(origin[0] == 500001.0 && origin[1] == 4500001.375 && origin[2] == 10.0);
    const float *const p = read_model.parts[0].positions;
    assert_true((double)p[0] + origin[0] == 500000.25 && (double)p[1] + origin[1] == 4500000.5);
    assert_true((double)p[6] + origin[0] == 500001.75 && (double)p[7] + origin[1] == 4500002.25);
    /* Half a side is 1: the middle may be 16 from zero. */
    assert_true(read_obj_text("v 15 -1 0\nv 17 -1 0\nv 17 1 0\nf 1 2 3", NULL));
    assert_true(read_model.origin[0] == 0.0);
    assert_true(read_obj_text("v 15.5 -1 0\nv 17.5 -1 0\nv 17.5 1 0\nf 1 2 3", NULL));
    assert_true(read_model.origin[0] == 16.5);
}

/* Vertices that corners share are one; others are not. */
static void test_sharing(void **state)
{
    (void)state;
    assert_true(read_square("vt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/1 3/1 4/1\nf 1/2 3/1 4/1\n"));
    assert_int_equal(read_model.parts[0].vertex_count, 5);
}

static void test_budget(void **state)
{
    char text[512];
    test_file materials[] = {
        {"a.mtl", "newmtl m\nKd 1 0 0\nmap_Kd a.png\nmap_d b.png\nnewmtl n\nKd 0\n", 0},
        {NULL, NULL, 0}};
    const model_files files = {materials, test_open, test_close};
    (void)state;
    snprintf(text, sizeof text,
             "%smtllib a.mtl\nf 1 2 3 4\ns off\nl 1 2\nf 1 4 3 3 2\ns 1\nusemtl m\n"
             "vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 1/1 2/1 3/1\n",
             square);
    /* Every budget gives a fault or the model, and no leak. */
    bool good = false;
    for (uint64_t budget = 0; !good; budget += 64) {
        forget_model();
        good = model_read_bytes("x.obj", MODEL_OBJ, (const uint8_t *)text, strlen(text), &files,
                                budget, &read_model, &read_messages);
        if (!good)
            assert_string_equal(read_messages.fault, "not enough memory");
        assert_true(budget < 1 << 20);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_forms_of_lines),
        cmocka_unit_test(test_indices),
        cmocka_unit_test(test_clouds),
        cmocka_unit_test(test_numbers),
        cmocka_unit_test(test_numbers_that_are_not_finite),
        cmocka_unit_test(test_colors),
        cmocka_unit_test(test_texcoords),
        cmocka_unit_test(test_kinds),
        cmocka_unit_test(test_statements_that_are_not_drawn),
        cmocka_unit_test(test_smoothing),
        cmocka_unit_test(test_far_coordinates),
        cmocka_unit_test(test_sharing),
        cmocka_unit_test(test_budget),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    forget_model();
    return failed;
}
