/* PLY files: their encodings, elements in any order, and what is wrong in a file. */
#include "ply_test.h"

static void test_ends_of_lines(void **state)
{
    static const char *const ends[] = {"\r\n", "\r"};
    (void)state;
    for (size_t e = 0; e < 2; ++e) {
        char text[1024];
        end_lines(SQUARE, ends[e], text);
        read_well(text);
        require_area(read_model.parts, 2, 4.0);
    }
    /* No end at the last line; a list that goes on on the next line; empty lines. */
    read_well("ply\nformat ascii 1.0\ncomment c\nobj_info i\nelement vertex 4\n" XYZ
              "element face 1\nproperty list uint8 uint32 vertex_index\nend_header\n\n-1 -1 0\n"
              "1 -1 0\n1 1 0\n\n-1 1 0\n4 0 1\n2 3");
    require_area(read_model.parts, 2, 4.0);
}

/* A triangle with positions of three types, colours of three, and a list of another. */
static void write_all_types(writer *w, bool is_big, const char *const names[8])
{
    static const int xyz[3][3] = {{-1, -200, 3}, {100, -200, 3}, {-1, 300, 3}};
    char header[1024];
    snprintf(header, sizeof header,
             "element other 1\nproperty list %s %s some\nproperty %s more\n"
             "element vertex 3\nproperty %s x\nproperty %s y\nproperty %s z\n"
             "property %s red\nproperty %s green\nproperty %s blue\nproperty %s alpha\n"
             "element face 1\nproperty list %s %s vertex_indices\nend_header\n",
             names[3], names[2], names[4], names[0], names[2], names[7], names[6], names[3],
             names[1], names[5], names[4], names[0]);
    write_header(w, is_big, header);
    write_bits(w, 2, 2);
    write_bits(w, 0xffff, 2);
    write_bits(w, 7, 2);
    write_bits(w, 0xfffffff0, 4);
    for (int v = 0; v < 3; ++v) {
        write_bits(w, (uint8_t)xyz[v][0], 1);
        write_bits(w, (uint16_t)xyz[v][1], 2);
        write_double(w, xyz[v][2]);
        write_float(w, 0.5f);
        write_bits(w, 13107, 2);
        write_bits(w, 51, 1);
        write_bits(w, 255, 4);
    }
    write_bits(w, 3, 4);
    write_bits(w, 0, 1);
    write_bits(w, 1, 1);
    write_bits(w, 2, 1);
}

static void test_types(void **state)
{
    static const char *const old[8] = {"char", "uchar", "short", "ushort",
                                       "int",  "uint",  "float", "double"};
    static const char *const sized[8] = {"int8",  "uint8",  "int16",   "uint16",
                                         "int32", "uint32", "float32", "float64"};
    (void)state;
    for (int i = 0; i < 4; ++i) {
        writer w;
        write_all_types(&w, i & 1, i & 2 ? sized : old);
        assert_true(read_written(&w));
        assert_true(has_warning("x.ply: element other is not drawn (1)"));
        assert_int_equal(read_messages.warning_count, 1);
        const model_part *const p = read_model.parts;
        assert_int_equal(p->index_count, 3);
        assert_true(p->positions[0] == -1.0f && p->positions[1] == -200.0f &&
                    p->positions[2] == 3.0f);
        assert_true(p->positions[3] == 100.0f && p->positions[7] == 300.0f);
        /* 13107 = 65535 / 5, and 51 = 255 / 5. */
        require_color(p, 0, 0.5, 0.2, 0.2, 1.0);
    }
    refuse("ply\nformat ascii 1.0\nelement vertex 1\nproperty int64 x\nend_header\n1\n",
           "line 4: int64 is not a type of PLY's properties");
    refuse("ply\nformat ascii 1.0\nelement vertex 1\nproperty list float int x\nend_header\n1\n",
           "line 4: the length of a list cannot be a float");
}

/* A file is read alike whatever the end of the header is, and bytes behind it that look like ends
 * of lines are numbers. */
static void test_binary_behind_header(void **state)
{
    static const char *const headers[] = {
        "element vertex 1\nproperty uchar x\nproperty uchar y\nproperty uchar z\nend_header\n",
        "element vertex 1\r\nproperty uchar x\r\nproperty uchar y\r\nproperty uchar z\r\n"
        "end_header\r\n"};
    writer w;
    (void)state;
    for (int i = 0; i < 3; ++i) {
        write_header(&w, false, headers[i & 1]);
        for (size_t c = 0; c < w.size && i == 2; ++c)
            if (w.bytes[c] == '\n')
                w.bytes[c] = '\r';
        write_bits(&w, '\n', 1);
        write_bits(&w, '\r', 1);
        write_bits(&w, '\n', 1);
        assert_true(read_written(&w));
        const double *const o = read_model.origin;
        assert_true(o[0] == 10.0 && o[1] == 13.0 && o[2] == 10.0);
        assert_int_equal(read_messages.warning_count, 0);
    }
}

static void test_indices_out_of_range(void **state)
{
    static const struct {
        const char *face, *fault;
    } cases[] = {
        {"3 1 2 9", "line 15: face 1 names vertex 9, but there are only 4"},
        {"3 0 1 -1", "line 15: face 1 names vertex -1, but there are only 4"},
        {"3 0 1 4", "line 15: face 1 names vertex 4, but there are only 4"},
        {"3 0 1 1.5", "line 15: face 1 names vertex 1.5, but there are only 4"},
        {"3 0 nan 1", "line 15: face 1 names vertex nan, but there are only 4"},
        {"3 0 4294967297 1", "line 15: face 1 names vertex 4294967297, but there are only 4"},
        {"5 0 1 2 3 9", "line 15: face 1 names vertex 9, but there are only 4"},
        {"-3 0 1 2", "line 15: vertex_indices of face 1 cannot have -3 numbers"},
        {"2.5 0 1 2", "line 15: vertex_indices of face 1 cannot have 2.5 numbers"},
        {"3 0 x 2", "line 15: vertex_indices of face 1 is not a number: x"},
        {"99 0 1 2", "line 15: it is cut short: vertex_indices of face 1 has 99 numbers, but only "
                     "7 bytes follow"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char text[512];
        snprintf(text, sizeof text,
                 "ply\nformat ascii 1.0\nelement vertex 4\n" XYZ "element face 2\n"
                 "property list int int vertex_indices\nend_header\n%s3 0 1 2\n%s\n",
                 "-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n", cases[i].face);
        refuse(text, cases[i].fault);
    }
    refuse("ply\nformat ascii 1.0\nelement vertex 4\n" XYZ
           "element face 1\nproperty list uchar float vertex_indices\nend_header\n" SQUARE_POINTS
           "3 0 1 2\n",
           "property vertex_indices of face is a list of floats; indices are integers");
    refuse("ply\nformat ascii 1.0\nelement vertex 4\n" XYZ
           "element face 1\nproperty int vertex_indices\nend_header\n" SQUARE_POINTS "3\n",
           "element face has no list vertex_indices");
    /* Binary: no line. */
    writer w;
    write_header(&w, false,
                 "element vertex 1\nproperty char x\nproperty char y\nproperty char z\n"
                 "element face 1\nproperty list char int vertex_index\nend_header\n");
    write_bits(&w, 0, 3);
    const size_t size = w.size;
    write_bits(&w, 0xff, 1);
    assert_false(read_written(&w));
    assert_string_equal(read_messages.fault, "vertex_index of face 0 cannot have -1 numbers");
    w.size = size;
    write_bits(&w, 3, 1);
    write_bits(&w, 0, 4);
    write_bits(&w, 0, 4);
    write_bits(&w, 0xfffffffe, 4);
    assert_false(read_written(&w));
    assert_string_equal(read_messages.fault, "face 0 names vertex -2, but there are only 1");
}

static void test_faulty_headers(void **state)
{
    (void)state;
    refuse("plyx\n", "it does not begin with the line \"ply\", so it is no PLY file");
    refuse("ply\nformat ascii 1.0\nelement vertex 1\n",
           "it is cut short: its header has no end_header");
    refuse("ply\nelement vertex 1\n" XYZ "end_header\n0 0 0\n", "its header has no format");
    refuse("ply\nformat binary_middle 1.0\nend_header\n",
           "line 2: format binary_middle is not read");
    refuse("ply\nformat ascii 2.0\nend_header\n",
           "line 2: version 2.0 of PLY is not read, only 1.0");
    refuse("ply\nformat ascii 1.0\nelement vertex -1\n",
           "line 3: the number of elements is wrong: -1");
    refuse("ply\nformat ascii 1.0\nelement vertex 18446744073709551616\n",
           "line 3: the number of elements is wrong: 18446744073709551616");
    refuse("ply\nformat ascii 1.0\nelement\n", "line 3: element has no name");
    refuse("ply\nformat ascii 1.0\nelement vertex\n", "line 3: the number of elements is wrong: ");
    refuse("ply\nformat ascii 1.0\nproperty int x\n", "line 3: property stands before any element");
    refuse("ply\nformat ascii 1.0\nelement vertex 1\nproperty int\n",
           "line 4: property has no name");
    refuse("ply\nformat ascii 1.0\nelement vertex 1\nproperty\n", "line 4: property has no type");
    refuse("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
           "end_header\n0 0\n",
           "element vertex has no property z");
    refuse("ply\nformat ascii 1.0\nelement face 0\nend_header\n",
           "its header has no element vertex");
    refuse("ply\nformat ascii 1.0\nelement vertex 0\n" XYZ "end_header\n", "it has no vertices");
}

static void test_cut_short(void **state)
{
    (void)state;
    refuse("ply\nformat ascii 1.0\nelement vertex 4\n" XYZ "end_header\n0 0 0\n1 1\n",
           "it is cut short: it ends in vertex 1, and has 4 by its header");
    refuse("ply\nformat ascii 1.0\nelement vertex 9000000000000000000\n" XYZ
           "end_header\n0 0 0\n1 1 1\n",
           "it is cut short: it ends in vertex 2, and has 9000000000000000000 by its header");
    refuse("ply\nformat ascii 1.0\nelement vertex 3\n" XYZ "element face 2\n" INDICES
           "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
           "it is cut short: it ends in face 1, and has 2 by its header");
    refuse("ply\nformat ascii 1.0\nelement vertex 1\n" XYZ "end_header\n0 0 a\n",
           "line 8: z of vertex 0 is not a number: a");
    /* Every file that is cut off before its end is refused. */
    writer w;
    write_header(&w, true,
                 "element vertex 3\nproperty char x\nproperty char y\nproperty char z\n"
                 "element face 1\nproperty list uchar ushort vertex_index\nend_header\n");
    const size_t size = w.size;
    write_bits(&w, 0, 3);
    write_bits(&w, 1, 3);
    write_bits(&w, 256, 3);
    write_bits(&w, 3, 1);
    write_bits(&w, 1, 2);
    write_bits(&w, 0, 2);
    write_bits(&w, 2, 2);
    assert_true(read_written(&w));
    while (--w.size > size) {
        char expected[128];
        const size_t vertex = (w.size - size) / 3;
        assert_false(read_written(&w));
        snprintf(expected, sizeof expected,
                 "it is cut short: it ends in vertex %zu, and has 3 by its header", vertex);
        if (vertex < 3)
            assert_string_equal(read_messages.fault, expected);
        assert_non_null(strstr(read_messages.fault, "it is cut short: "));
    }
}

static void test_more_than_announced(void **state)
{
    (void)state;
    read_warned("ply\nformat ascii 1.0\nelement vertex 3\n" XYZ "element face 1\n" INDICES
                "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n\n3 0 1 2\n",
                "x.ply: line 15: 8 bytes behind the last element are left out (1)");
    read_warned("ply\nformat ascii 1.0\nelement vertex 3\n" XYZ "element face 1\n" INDICES
                "end_header\n0 0 0\n1 0 0 7 8\n0 1 0\n3 0 1 2\n\n",
                "x.ply: line 11: vertex has more numbers on its line than properties; they are "
                "left out (1)");
    require_area(read_model.parts, 1, 0.5);
    writer w;
    write_header(&w, false,
                 "element vertex 1\nproperty char x\nproperty char y\nproperty char z\n"
                 "end_header\n");
    write_bits(&w, 0, 5);
    assert_true(read_written(&w));
    assert_true(has_warning("x.ply: 2 bytes behind the last element are left out (1)"));
}

static void test_not_finite(void **state)
{
    (void)state;
    refuse("ply\nformat ascii 1.0\nelement vertex 3\n" XYZ "element face 1\n" INDICES
           "end_header\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n",
           "the position of a vertex is not a finite number");
}

static void test_other_elements(void **state)
{
    (void)state;
    read_warned("ply\nformat ascii 1.0\nelement camera 1\nproperty float view_px\n"
                "property float view_py\nelement vertex 4\n" XYZ "element face 1\n" INDICES
                "end_header\n0 0\n" SQUARE_POINTS "4 0 1 2 3\n",
                "x.ply: element camera is not drawn (1)");
    require_area(read_model.parts, 2, 4.0);
    read_warned("ply\nformat ascii 1.0\nelement vertex 4\n" XYZ "element foo 2\n"
                "property list int float a\nproperty int b\nelement face 1\n" INDICES
                "end_header\n" SQUARE_POINTS "2 1.5 2.5 7\n0 8\n4 0 1 2 3\n",
                "x.ply: element foo is not drawn (1)");
    require_area(read_model.parts, 2, 4.0);
    /* Elements without properties have no lines. */
    read_warned("ply\nformat ascii 1.0\nelement none 9000000000000000000\nelement vertex 4\n" XYZ
                "element face 1\n" INDICES "end_header\n" SQUARE_POINTS "4 0 1 2 3\n",
                "x.ply: element none is not drawn (1)");
    assert_true(read_text("ply\nformat ascii 1.0\nelement vertex 4\n" XYZ
                          "property float confidence\nproperty list uchar int some\n"
                          "element face 1\n" INDICES "end_header\n-1 -1 0 9 0\n1 -1 0 9 1 5\n"
                          "1 1 0 9 2 5 6\n-1 1 0 9 0\n4 0 1 2 3\n"));
    assert_true(has_warning("x.ply: property confidence of vertex is not drawn (1)"));
    assert_true(has_warning("x.ply: property some of vertex is not drawn (1)"));
    assert_int_equal(read_messages.warning_count, 2);
    require_area(read_model.parts, 2, 4.0);
    read_warned("ply\nformat ascii 1.0\nsurprise 1 2\nelement vertex 3\n" XYZ
                "element face 1\n" INDICES "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                "x.ply: line 3: surprise is not known in a header (1)");
}

static void test_any_order(void **state)
{
    (void)state;
    /* Faces and edges before the vertices; properties in another order. */
    read_well("ply\nformat ascii 1.0\nelement edge 1\nproperty uchar red\nproperty int vertex2\n"
              "property int vertex1\nproperty uchar green\nproperty uchar blue\n"
              "element face 1\nproperty uchar green\n" INDICES
              "property uchar blue\nproperty uchar red\n"
              "element vertex 4\nproperty float z\nproperty float y\nproperty float x\nend_header\n"
              "51 3 1 102 153\n255 4 0 1 2 3 51 102\n0 -1 -1\n0 -1 1\n0 1 1\n0 1 -1\n");
    assert_int_equal(read_model.part_count, 2);
    require_area(read_model.parts, 2, 4.0);
    require_color(read_model.parts, 0, 0.4, 1.0, 0.2, 1.0);
    const model_part *const lines = read_model.parts + 1;
    assert_int_equal(lines->kind, MODEL_LINES);
    assert_int_equal(lines->index_count, 2);
    assert_int_equal(lines->vertex_count, 2);
    assert_true(lines->positions[3 * lines->indices[0]] == 1.0f);
    assert_true(lines->positions[3 * lines->indices[0] + 1] == -1.0f);
    assert_true(lines->positions[3 * lines->indices[1]] == -1.0f);
    assert_true(lines->positions[3 * lines->indices[1] + 1] == 1.0f);
    require_color(lines, 0, 0.2, 0.4, 0.6, 1.0);
}

static void test_little_memory(void **state)
{
    (void)state;
    require_within_budget(
        MODEL_PLY, "x.ply",
        "ply\nformat ascii 1.0\ncomment TextureFile a.png\ncomment TextureFile b.png\n"
        "element vertex 4\n" XYZ "property float nx\nproperty float ny\nproperty float nz\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float s\n"
        "property float t\nelement face 2\n" INDICES "property list uchar float texcoord\n"
        "property int texnumber\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
        "element tristrips 1\nproperty list int int vertex_indices\n"
        "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
        "2 1 0 0 0 1 1 2 3 0 0\n4 0 0 0 0 1 1 2 3 0 0\n2 4 0 0 0 1 1 2 3 0 0\n"
        "0 0 0 0 0 1 1 2 3 0 0\n4 0 1 2 3 8 1 2 3 4 5 6 7 8 1 9 9 9\n"
        "3 0 1 2 6 1 2 3 4 5 6 0 8 8 8\n3 0 1 2\n0 1\n");
    assert_int_equal(read_model.part_count, 4); /* two textures, none, and lines */
    require_within_budget(MODEL_PLY, "x.ply",
                          "ply\nformat ascii 1.0\nelement vertex 1\n" XYZ "end_header\n0 0 0\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ends_of_lines),        cmocka_unit_test(test_types),
        cmocka_unit_test(test_binary_behind_header), cmocka_unit_test(test_indices_out_of_range),
        cmocka_unit_test(test_faulty_headers),       cmocka_unit_test(test_cut_short),
        cmocka_unit_test(test_more_than_announced),  cmocka_unit_test(test_not_finite),
        cmocka_unit_test(test_other_elements),       cmocka_unit_test(test_any_order),
        cmocka_unit_test(test_little_memory),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    forget_model();
    return failed;
}
