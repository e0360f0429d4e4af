/* PLY files: their encodings, elements in any order, and what is wrong in a file. */
#include "ply_test.h"

static void test_ends_of_lines(void **state)
{
    static const char *const ends[] = {"\r\n", "\r"};
    for (size_t e = 0; e < 2; ++e) {
        char text[1024];
        end_lines(SQUARE, ends[e], text);
        expect_area(part_of(text, NULL), 2, 4.0);
    }
    /* No end at the last line; a list that goes on on the next line; empty lines. */
    expect_area(part_of("ply\nformat ascii 1.0\ncomment c\nobj_info i\nelement vertex 4\n" XYZ
                        "element face 1\nproperty list uint8 uint32 vertex_index\nend_header\n\n"
                        "-1 -1 0\n1 -1 0\n1 1 0\n\n-1 1 0\n4 0 1\n2 3",
                        NULL),
                2, 4.0);
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
    static const char *const names[2][8] = {
        {"char", "uchar", "short", "ushort", "int", "uint", "float", "double"},
        {"int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"}};
    for (int i = 0; i < 4; ++i) {
        writer w;
        write_all_types(&w, i & 1, names[i / 2]);
        expect_read(read_written(&w), "x.ply: element other is not drawn (1)");
        const model_part *const p = read_model.parts;
        assert_int_equal(p->index_count, 3);
        assert_true(p->positions[0] == -1.0f && p->positions[1] == -200.0f &&
                    p->positions[2] == 3.0f);
        assert_true(p->positions[3] == 100.0f && p->positions[7] == 300.0f);
        /* 13107 = 65535 / 5, and 51 = 255 / 5. */
        expect_color(p, 0, 0.5f, 0.2f, 0.2f, 1.0f);
    }
}

#define CHARS "property char x\nproperty char y\nproperty char z\n"

/* A file is read alike whatever the end of the header is, and bytes behind it that look like ends
 * of lines are numbers. */
static void test_binary_behind_header(void **state)
{
    writer w;
    for (int i = 0; i < 3; ++i) {
        char header[128];
        end_lines("element vertex 1\n" CHARS END, i & 1 ? "\r\n" : "\n", header);
        write_header(&w, false, header);
        for (size_t c = 0; c < w.size && i == 2; ++c)
            if (w.bytes[c] == '\n')
                w.bytes[c] = '\r';
        write_bits(&w, '\n', 1);
        write_bits(&w, '\r', 1);
        write_bits(&w, '\n', 1);
        expect_read(read_written(&w), NULL);
        const double *const o = read_model.origin;
        assert_true(o[0] == 10.0 && o[1] == 13.0 && o[2] == 10.0);
    }
}

static void test_faulty_indices(void **state)
{
    static const struct {
        const char *face, *fault;
    } cases[] = {{"3 1 2 9", "names vertex 9, but there are only 4"},
                 {"3 0 1 -1", "names vertex -1, but there are only 4"},
                 {"3 0 1 4", "names vertex 4, but there are only 4"},
                 {"3 0 1 1.5", "names vertex 1.5, but there are only 4"},
                 {"3 0 nan 1", "names vertex nan, but there are only 4"},
                 {"3 0 4294967297 1", "names vertex 4294967297, but there are only 4"},
                 {"5 0 1 2 3 9", "names vertex 9, but there are only 4"}};
    writer w;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char text[512], fault[128];
        snprintf(
            text, sizeof text,
            VERTICES("4") "element face 2\nproperty list int int vertex_indices\n" END SQUARE_POINTS
                          "3 0 1 2\n%s\n",
            cases[i].face);
        snprintf(fault, sizeof fault, "line 15: face 1 %s", cases[i].fault);
        refuse(text, fault);
    }
    /* Binary: no line. */
    write_header(&w, false,
                 "element vertex 1\n" CHARS
                 "element face 1\nproperty list char int vertex_index\n" END);
    write_bits(&w, 0, 3);
    const size_t size = w.size;
    write_bits(&w, 0xff, 1);
    expect_fault(read_written(&w), "vertex_index of face 0 cannot have -1 numbers");
    w.size = size;
    write_bits(&w, 3, 1);
    write_bits(&w, 0, 8);
    write_bits(&w, 0xfffffffe, 4);
    expect_fault(read_written(&w), "face 0 names vertex -2, but there are only 1");
}

#define PLY "ply\nformat ascii 1.0\n"
#define LISTS                                                                                      \
    VERTICES("4") "element face 1\nproperty list int int vertex_indices\n" END SQUARE_POINTS

static void test_faults(void **state)
{
    static const struct {
        const char *text, *fault;
    } cases[] = {
        {"plyx\n", "it does not begin with the line \"ply\", so it is no PLY file"},
        {PLY "element vertex 1\n", "it is cut short: its header has no end_header"},
        {"ply\nelement vertex 1\n" XYZ END "0 0 0\n", "its header has no format"},
        {"ply\nformat binary_middle 1.0\n" END, "line 2: format binary_middle is not read"},
        {"ply\nformat ascii 2.0\n" END, "line 2: version 2.0 of PLY is not read, only 1.0"},
        {PLY "element vertex -1\n", "line 3: the number of elements is wrong: -1"},
        {PLY "element vertex 18446744073709551616\n",
         "line 3: the number of elements is wrong: 18446744073709551616"},
        {PLY "element\n", "line 3: element has no name"},
        {PLY "element vertex\n", "line 3: the number of elements is wrong: "},
        {PLY "property int x\n", "line 3: property stands before any element"},
        {PLY "element vertex 1\nproperty int\n", "line 4: property has no name"},
        {PLY "element vertex 1\nproperty\n", "line 4: property has no type"},
        {PLY "element vertex 1\nproperty int64 x\n" END "1\n",
         "line 4: int64 is not a type of PLY's properties"},
        {PLY "element vertex 1\nproperty list float int x\n" END "1\n",
         "line 4: the length of a list cannot be a float"},
        {PLY "element vertex 1\nproperty float x\nproperty float y\n" END "0 0\n",
         "element vertex has no property z"},
        {PLY "element face 0\n" END, "its header has no element vertex"},
        {VERTICES("0") END, "it has no vertices"},
        {VERTICES(
             "4") "element face 1\nproperty list uchar float vertex_indices\n" END SQUARE_POINTS
                  "3 0 1 2\n",
         "property vertex_indices of face is a list of floats; indices are integers"},
        {VERTICES("4") "element face 1\nproperty int vertex_indices\n" END SQUARE_POINTS "3\n",
         "element face has no list vertex_indices"},
        {LISTS "-3 0 1 2\n", "line 14: vertex_indices of face 0 cannot have -3 numbers"},
        {LISTS "2.5 0 1 2\n", "line 14: vertex_indices of face 0 cannot have 2.5 numbers"},
        {LISTS "3 0 x 2\n", "line 14: vertex_indices of face 0 is not a number: x"},
        {LISTS "99 0 1 2\n",
         "line 14: it is cut short: vertex_indices of face 0 has 99 numbers, but "
         "only 7 bytes follow"},
        {VERTICES("4") END "0 0 0\n1 1\n",
         "it is cut short: it ends in vertex 1, and has 4 by its header"},
        {VERTICES("9000000000000000000") END "0 0 0\n1 1 1\n",
         "it is cut short: it ends in vertex 2, and has 9000000000000000000 by its header"},
        {VERTICES("3") FACES("2") END TRIANGLE_POINTS "3 0 1 2\n",
         "it is cut short: it ends in face 1, and has 2 by its header"},
        {VERTICES("1") END "0 0 a\n", "line 8: z of vertex 0 is not a number: a"},
        {VERTICES("3") FACES("1") END "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n",
         "the position of a vertex is not a finite number"}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
        refuse(cases[i].text, cases[i].fault);
}

/* Every file that is cut off before its end is refused. */
static void test_cut_short(void **state)
{
    writer w;
    write_header(&w, true,
                 "element vertex 3\n" CHARS
                 "element face 1\nproperty list uchar ushort vertex_index\n" END);
    const size_t size = w.size;
    write_bits(&w, 0, 3);
    write_bits(&w, 1, 3);
    write_bits(&w, 256, 3);
    write_bits(&w, 3, 1);
    write_bits(&w, 1, 2);
    write_bits(&w, 0, 2);
    write_bits(&w, 2, 2);
    expect_read(read_written(&w), NULL);
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

/* Elements and properties that are not drawn, and more bytes than announced. The triangles are
 * there all the same. */
static void test_warnings(void **state)
{
    static const struct {
        const char *text, *warning;
        double area;
    } cases[] = {
        {VERTICES("3") FACES("1") END TRIANGLE_POINTS "3 0 1 2\n\n3 0 1 2\n",
         "line 15: 8 bytes behind the last element are left out", 0.5},
        {VERTICES("3") FACES("1") END "0 0 0\n1 0 0 7 8\n0 1 0\n3 0 1 2\n\n",
         "line 11: vertex has more numbers on its line than properties; they are left out", 0.5},
        {PLY
         "element camera 1\nproperty float view_px\nproperty float view_py\nelement vertex 4\n" XYZ
             FACES("1") END "0 0\n" SQUARE_POINTS "4 0 1 2 3\n",
         "element camera is not drawn", 4.0},
        {VERTICES("4") "element foo 2\nproperty list int float a\nproperty int b\n" FACES("1")
             END SQUARE_POINTS "2 1.5 2.5 7\n0 8\n4 0 1 2 3\n",
         "element foo is not drawn", 4.0},
        /* Elements without properties have no lines. */
        {PLY "element none 9000000000000000000\nelement vertex 4\n" XYZ FACES("1") END SQUARE_POINTS
         "4 0 1 2 3\n",
         "element none is not drawn", 4.0},
        {PLY "surprise 1 2\nelement vertex 3\n" XYZ FACES("1") END TRIANGLE_POINTS "3 0 1 2\n",
         "line 3: surprise is not known in a header", 0.5}};
    writer w;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char warning[256];
        snprintf(warning, sizeof warning, "x.ply: %s (1)", cases[i].warning);
        expect_area(part_of(cases[i].text, warning), cases[i].area > 1.0 ? 2 : 1, cases[i].area);
    }
    expect_warnings(read_text(VERTICES("4") "property float confidence\n"
                                            "property list uchar int some\n" FACES("1") END
                              "-1 -1 0 9 0\n1 -1 0 9 1 5\n1 1 0 9 2 5 6\n-1 1 0 9 0\n4 0 1 2 3\n"),
                    2, "x.ply: property confidence of vertex is not drawn (1)");
    assert_true(has_warning("x.ply: property some of vertex is not drawn (1)"));
    expect_area(read_model.parts, 2, 4.0);
    write_header(&w, false, "element vertex 1\n" CHARS END);
    write_bits(&w, 0, 5);
    expect_read(read_written(&w), "x.ply: 2 bytes behind the last element are left out (1)");
}

/* Faces and edges before the vertices; properties in another order. */
static void test_any_order(void **state)
{
    part_of(PLY "element edge 1\nproperty uchar red\nproperty int vertex2\nproperty int vertex1\n"
                "property uchar green\nproperty uchar blue\n"
                "element face 1\nproperty uchar green\n" INDICES
                "property uchar blue\nproperty uchar red\n"
                "element vertex 4\nproperty float z\nproperty float y\nproperty float x\n" END
                "51 3 1 102 153\n255 4 0 1 2 3 51 102\n0 -1 -1\n0 -1 1\n0 1 1\n0 1 -1\n",
            NULL);
    assert_int_equal(read_model.part_count, 2);
    expect_area(read_model.parts, 2, 4.0);
    expect_color(read_model.parts, 0, 0.4f, 1.0f, 0.2f, 1.0f);
    const model_part *const lines = read_model.parts + 1;
    expect_sizes(lines, MODEL_LINES, 2, 2);
    for (int i = 0; i < 2; ++i) {
        const float *const p = lines->positions + 3 * lines->indices[i];
        assert_true(p[0] == (i == 0 ? 1.0f : -1.0f) && p[1] == -p[0]);
    }
    expect_color(lines, 0, 0.2f, 0.4f, 0.6f, 1.0f);
}

static void test_little_memory(void **state)
{
    require_within_budget(MODEL_PLY, "x.ply",
                          PLY "comment TextureFile a.png\ncomment TextureFile b.png\n"
                              "element vertex 4\n" XYZ
                              "property float nx\nproperty float ny\nproperty float nz\n" RGB
                              "property float s\nproperty float t\n" FACES("2") TEXCOORDS
                          "property int texnumber\n" RGB STRIPS("1", "int") EDGES("1") END
                          "2 1 0 0 0 1 1 2 3 0 0\n4 0 0 0 0 1 1 2 3 0 0\n2 4 0 0 0 1 1 2 3 0 0\n"
                          "0 0 0 0 0 1 1 2 3 0 0\n4 0 1 2 3 8 1 2 3 4 5 6 7 8 1 9 9 9\n"
                          "3 0 1 2 6 1 2 3 4 5 6 0 8 8 8\n3 0 1 2\n0 1\n",
                          NULL);
    assert_int_equal(read_model.part_count, 4); /* two textures, none, and lines */
    require_within_budget(MODEL_PLY, "x.ply", VERTICES("1") END "0 0 0\n", NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ends_of_lines),
        cmocka_unit_test(test_types),
        cmocka_unit_test(test_binary_behind_header),
        cmocka_unit_test(test_faulty_indices),
        cmocka_unit_test(test_faults),
        cmocka_unit_test(test_cut_short),
        cmocka_unit_test(test_warnings),
        cmocka_unit_test(test_any_order),
        cmocka_unit_test(test_little_memory),
    };
    return cmocka_run_group_tests(tests, NULL, forget_last_model);
}
