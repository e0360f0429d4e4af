/* STL files: texts and binary ones told apart, vertices shared, normals completed, and what is
 * wrong in a file. */
#include "model_test.h"

#define FACET(normal, a, b, c)                                                                     \
    " facet " normal "\n  outer loop\n   vertex " a "\n   vertex " b "\n   vertex " c              \
    "\n  endloop\n endfacet\n"
#define UP "normal 0 0 1"
#define LOWER(normal) FACET(normal, "-1 -1 0", "1 -1 0", "1 1 0")
#define UPPER(normal) FACET(normal, "-1 -1 0", "1 1 0", "-1 1 0")
#define FACETS(normal) LOWER(normal) UPPER(normal)
#define SQUARE "solid x\n" FACETS(UP) "endsolid x\n"
#define OPEN_FACET "solid x\nfacet " UP "\n"
#define CUT_SHORT "it ends without endsolid; it may be cut short"

static bool read_data(const void *data, size_t size)
{
    return read_bytes(MODEL_STL, "x.stl", data, size, NULL);
}

static bool read_text(const char *text)
{
    return read_data(text, strlen(text));
}

/* Requires the square: two triangles of four vertices whose normals are (0, 0, 1), and this
 * warning, once; null: none. */
static void require_square(bool is_read, const char *text)
{
    static const float expected[6][3] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
    static const float up[3] = {0, 0, 1};
    char warning[256];
    snprintf(warning, sizeof warning, "x.stl: %s (1)", text != NULL ? text : "");
    expect_read(is_read, text != NULL ? warning : NULL);
    assert_int_equal(read_model.part_count, 1);
    const model_part *const p = read_model.parts;
    expect_sizes(p, MODEL_TRIANGLES, 4, 6);
    for (size_t i = 0; i < 6; ++i) {
        expect_floats(p->positions + 3 * p->indices[i], expected[i], 3);
        expect_floats(p->normals + 3 * p->indices[i], up, 3);
    }
}

static void write_facet(writer *w, const float *numbers, uint32_t attribute)
{
    for (int i = 0; i < 12; ++i)
        write_float(w, numbers[i]);
    write_bits(w, attribute, 2);
}

/* The square, whose header begins with a text. */
static void write_square(writer *w, const char *header, uint32_t first, uint32_t second)
{
    static const float facets[2][12] = {{0, 0, 1, -1, -1, 0, 1, -1, 0, 1, 1, 0},
                                        {0, 0, 1, -1, -1, 0, 1, 1, 0, -1, 1, 0}};
    memset(w, 0, sizeof *w);
    strcpy((char *)w->bytes, header);
    w->size = 80;
    write_bits(w, 2, 4);
    write_facet(w, facets[0], first);
    write_facet(w, facets[1], second);
}

static bool read_written(const writer *w)
{
    return read_data(w->bytes, w->size);
}

static void test_texts(void **state)
{
    static const struct {
        const char *text, *warning;
    } cases[] = {
        /* What writers put before "solid", and how they write keywords. */
        {"\xef\xbb\xbf" SQUARE, NULL},
        {"\n\n  \t" SQUARE, NULL},
        {"SOLID X\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX -1 -1 0\nVERTEX 1 -1 0\n"
         "VERTEX 1 1 0\nENDLOOP\nENDFACET\nFACET NORMAL 0 0 1\nOUTER LOOP\n"
         "VERTEX -1 -1 0\nVERTEX 1 1 0\nVERTEX -1 1 0\nENDLOOP\nENDFACET\nENDSOLID\n",
         NULL},
        /* Names may be anything, or absent; a file may hold several solids. */
        {"solid facet normal 1 2 vertex\n" FACETS(UP) "endsolid facet vertex\n", NULL},
        {"solid\n" LOWER(UP) "endsolid\nsolid two\n" UPPER(UP) "endsolid two\n", NULL},
        /* Blanks and ends of lines have one meaning inside a facet. */
        {"solid x\nfacet normal 0 0 1 outer loop vertex -1 -1 0 vertex 1 -1 0 vertex 1 1 0 "
         "endloop endfacet facet normal 0 0 1 outer loop vertex -1\n-1 0\nvertex\n1 1 0 "
         "vertex -1.0e0 +1 -0 endloop endfacet\nendsolid",
         NULL},
        {"solid x\ncolor 1 0 0\n" FACETS(UP) "endsolid x\n", "line 2: color is not known"},
        {"solid x\n" FACETS(UP), "line 16: " CUT_SHORT},
        {"solid x\n" LOWER(UP) " facet " UP "\n  outer loop\n   vertex -1 -1 0\n   vertex 1 1 0\n"
                               "   vertex -1 1 0\n  endloop\n",
         "line 15: " CUT_SHORT},
        {SQUARE, NULL}};
    static const char *const ends[] = {"\r\n", "\r"};
    static const float grey[4] = {0.8f, 0.8f, 0.8f, 1};
    for (size_t e = 0; e < 2; ++e) {
        char text[1024];
        end_lines(SQUARE, ends[e], text);
        require_square(read_text(text), NULL);
    }
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
        require_square(read_text(cases[i].text), cases[i].warning);
    expect_floats(read_model.parts->colors, grey, 4);
    assert_true(read_model.parts->has_normals && !read_model.parts->has_vertex_colors);
}

/* A normal of zeros, or none, asks for computing. Any other normal stays as it is, of whatever
 * length. */
static void test_normals(void **state)
{
    static const char *const not_finite[] = {"normal -nan(ind) -nan(ind) -nan(ind)",
                                             "normal 1.#QNAN 1.#QNAN 1.#QNAN",
                                             "normal nan NAN -nan",
                                             "normal 0 0 inf",
                                             "normal 0 0 x",
                                             "normal 0 0"};
    static const char *const computed[] = {"normal 0 0 0", "normal -0 0 -0", ""};
    static const float slanted[3] = {0, 3, 4};
    char text[1024];
    writer w;
    for (size_t i = 0; i < 9; ++i) {
        const char *const normal = i < 6 ? not_finite[i] : computed[i - 6];
        snprintf(text, sizeof text, "solid x\n" FACETS("%s") "endsolid\n", normal, normal);
        require_square(read_text(text), i < 6 ? "2 facets have normals that are not finite; they "
                                                "are computed from the corners"
                                              : NULL);
    }
    expect_read(read_text("solid x\n" FACETS("normal 0 3 4") "endsolid\n"), NULL);
    expect_floats(read_model.parts->normals, slanted, 3);
    /* A binary one, with zeros and with NaN. */
    write_square(&w, "", 0, 0);
    memset(w.bytes + 84, 0, 12);
    memset(w.bytes + 134, 0xff, 12);
    require_square(read_written(&w), "1 facet has a normal that is not finite; it is computed from "
                                     "the corners");
}

/* Zeros of both signs are equal; another normal makes another vertex. */
static void test_sharing(void **state)
{
    expect_read(read_text("solid x\n" FACET("normal 0 0 1", "0 0 0", "1 0 0", "0 1 0")
                              FACET("normal -0 -0 1", "-0 -0 0", "0 1 -0", "-1 0 0")
                                  FACET("normal 0 -1 0", "0 0 0", "0 0 -1", "1 0 0") "endsolid\n"),
                NULL);
    const model_part *const p = read_model.parts;
    expect_sizes(p, MODEL_TRIANGLES, 4 + 3, 9);
    assert_int_equal(p->indices[0], p->indices[3]);
    assert_int_equal(p->indices[2], p->indices[4]);
    assert_true(p->indices[6] != p->indices[0]);
    assert_true(p->normals[3 * p->indices[6] + 1] == -1.0f);
}

/* A grid of 40 x 40 squares has 41 x 41 vertices. */
static void test_large_grid(void **state)
{
    enum { SIDE = 40, SIZE = 84 + 50 * 2 * SIDE * SIDE };
    static uint8_t bytes[SIZE];
    memset(bytes, 0, sizeof bytes);
    for (uint32_t i = 0; i < 2 * SIDE * SIDE; ++i) {
        const float x = (float)(i / 2 % SIDE), y = (float)(i / 2 / SIDE);
        const float lower[12] = {0, 0, 1, x, y, 0, x + 1, y, 0, x + 1, y + 1, 0};
        const float upper[12] = {0, 0, 1, x, y, 0, x + 1, y + 1, 0, x, y + 1, 0};
        writer w = {.size = 0};
        write_bits(&w, 2 * SIDE * SIDE, 4);
        write_facet(&w, i % 2 ? upper : lower, 0);
        memcpy(bytes + 80, w.bytes, 4);
        memcpy(bytes + 84 + 50 * i, w.bytes + 4, 50);
    }
    expect_read(read_data(bytes, sizeof bytes), NULL);
    const model_part *const p = read_model.parts;
    expect_sizes(p, MODEL_TRIANGLES, (SIDE + 1) * (SIDE + 1), 6 * SIDE * SIDE);
    for (size_t i = 0; i < p->index_count; i += 6) {
        const float *const v = p->positions + 3 * p->indices[i];
        assert_true(v[0] == (float)(i / 6 % SIDE) && v[1] == (float)(i / 6 / SIDE));
    }
}

/* Headers begin with anything, "solid" too. */
static void test_binary(void **state)
{
    static const char *const headers[] = {"", "part", "solid", "solid x\nfacet normal 0 0 1\n",
                                          " SOLID a\n"};
    static const struct {
        size_t size;
        const char *fault;
    } cases[] = {{182, "it is cut short: 2 triangles take 184 bytes, but it has 182"},
                 {84, "it is cut short: 2 triangles take 184 bytes, but it has 84"},
                 {83, "it is neither binary STL nor a text that begins with \"solid\""}};
    writer w;
    for (size_t i = 0; i < sizeof headers / sizeof headers[0]; ++i) {
        write_square(&w, headers[i], 0, 0);
        require_square(read_written(&w), NULL);
    }
    write_square(&w, "solid part", 0, 0);
    write_bits(&w, 0, 2);
    require_square(read_written(&w), "2 bytes behind the last triangle are left out");
    for (size_t i = 0; i < 3; ++i) {
        w.size = cases[i].size;
        expect_fault(read_written(&w), cases[i].fault);
    }
    memset(w.bytes + 80, 0, 4);
    w.size = 84;
    expect_fault(read_written(&w), "there are no triangles, lines or points in it");
    write_square(&w, "", 0, 0);
    memset(w.bytes + 84 + 12, 0xff, 4);
    expect_fault(read_written(&w), "the position of a vertex is not a finite number");
}

/* VisCAM and SolidView: blue in the lowest five bits, bit 15 says that there is a colour. Magics:
 * red in the lowest bits; bit 15 says that the header's colour is meant. Other bytes mean something
 * else. */
static void test_colors(void **state)
{
    static const struct {
        size_t at;
        const char *header;
        uint32_t first, second;
        const char *warning;
        float colors[2][4];
    } cases[] = {{0,
                  "",
                  0x8000 | 31 << 10 | 0 << 5 | 15,
                  0x7fff,
                  NULL,
                  {{1, 0, 15.0f / 31.0f, 1}, {0.8f, 0.8f, 0.8f, 1}}},
                 {0,
                  "COLOR=\x33\x66\x99\xff,MATERIAL=",
                  0x8000,
                  31 << 10 | 0 << 5 | 15,
                  NULL,
                  {{0.2f, 0.4f, 0.6f, 1}, {15.0f / 31.0f, 0, 1, 1}}},
                 {70,
                  "COLOR=\x33\x66\x99\x80",
                  0x8000,
                  0x8000,
                  "x.stl: the alpha of COLOR= is not drawn (1)",
                  {{0.2f, 0.4f, 0.6f, 1}, {0.2f, 0.4f, 0.6f, 1}}},
                 {0,
                  "",
                  7,
                  0,
                  "x.stl: the attribute bytes of triangles are not drawn (1)",
                  {{0.8f, 0.8f, 0.8f, 1}, {0.8f, 0.8f, 0.8f, 1}}}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        writer w;
        write_square(&w, "", cases[i].first, cases[i].second);
        memcpy(w.bytes + cases[i].at, cases[i].header, strlen(cases[i].header));
        expect_read(read_written(&w), cases[i].warning);
        const model_part *const p = read_model.parts;
        assert_int_equal(p->vertex_count, i < 2 ? 6 : 4);
        assert_int_equal(p->has_vertex_colors, i < 3);
        for (int k = 0; k < 2; ++k)
            expect_floats(p->colors + 4 * p->indices[k == 0 ? 0 : 5], cases[i].colors[k], 4);
    }
}

static void test_far_coordinates(void **state)
{
    static const double expected[3][3] = {
        {500000.25, 4500000.5, 7}, {500001.25, 4500000.5, 7}, {500000.25, 4500001.5, 7}};
    expect_read(read_text("solid x\n" FACET(UP, "500000.25 4500000.5 7", "500001.25 4500000.5 7",
                                            "500000.25 4500001.5 7") "endsolid x\n"),
                NULL);
    for (size_t v = 0; v < 3; ++v)
        for (size_t c = 0; c < 3; ++c)
            assert_true(read_model.origin[c] + (double)read_model.parts->positions[3 * v + c] ==
                        expected[v][c]);
}

static void test_faults(void **state)
{
    static const struct {
        const char *text, *fault;
    } cases[] = {
        {"solid x\n" LOWER(UP) " facet " UP "\n  outer loop\n   vertex -1 -1 0\n   vertex 1 1 0\n",
         "line 13: it is cut short: the last facet has only 2 of 3 vertices"},
        {OPEN_FACET "outer loop\nvertex 1 2", "line 4: it is cut short: it ends in a vertex"},
        {"solid x\nendsolid x\n", "there are no triangles, lines or points in it"},
        {"solid", "there are no triangles, lines or points in it"},
        {"solid x\n" FACET(UP, "0 0 0", "1 0 zero", "0 1 0") "endsolid\n",
         "line 5: z of vertex is not a number: zero"},
        {"solid x\n" FACET(UP, "0 0 0", "1 nan 0", "0 1 0") "endsolid\n",
         "line 5: y of vertex is not a number: nan"},
        {"solid x\n" FACET(UP, "0 0 0", "1 0", "0 1 0") "endsolid\n",
         "line 6: z of vertex is not a number: vertex"},
        {OPEN_FACET "outer loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\n",
         "line 7: the facet has 2 vertices, not 3"},
        {"solid x\n" FACET(UP, "0 0 0", "1 0 0", "0 1 0\nvertex 0 0 0") "endsolid\n",
         "line 7: the facet has more than 3 vertices"},
        {"solid x\nvertex 0 0 0\n", "line 2: vertex stands outside a facet"},
        {"solid x\nendfacet\n", "line 2: endfacet stands outside a facet"},
        {OPEN_FACET "facet " UP "\n",
         "line 3: facet begins in another facet, which has no endfacet"},
        {OPEN_FACET "endsolid\n", "line 3: endsolid stands in a facet, which has no endfacet"},
        {"some text that is long enough to hold the header of a binary file but is none, since it "
         "has no zeros",
         "it is neither binary STL nor a text that begins with \"solid\""}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        expect_fault(read_text(cases[i].text), cases[i].fault);
        assert_string_equal(read_messages.fault_file, "x.stl");
    }
    expect_read(read_text("solid x\n" FACETS("normal 0 0 0")
                              FACET("normal 0 0 0", "5 5 0", "5 5 0", "6 6 0") "endsolid\n"),
                "x.stl: 1 triangle has no area and cannot be seen (1)");
    assert_int_equal(read_model.parts->index_count, 9);
    require_within_budget(MODEL_STL, "x.stl", SQUARE, NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_texts),           cmocka_unit_test(test_normals),
        cmocka_unit_test(test_sharing),         cmocka_unit_test(test_large_grid),
        cmocka_unit_test(test_binary),          cmocka_unit_test(test_colors),
        cmocka_unit_test(test_far_coordinates), cmocka_unit_test(test_faults),
    };
    return cmocka_run_group_tests(tests, NULL, forget_last_model);
}
