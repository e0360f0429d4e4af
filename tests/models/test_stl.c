/* STL files: texts and binary ones told apart, vertices shared, normals completed, and what is
 * wrong in a file. */
#include "model_test.h"

#include <math.h>
#include <stdlib.h>

#define FACET(normal, a, b, c)                                                                     \
    " facet " normal "\n  outer loop\n   vertex " a "\n   vertex " b "\n   vertex " c              \
    "\n  endloop\n endfacet\n"
#define UP "normal 0 0 1"
#define SQUARE_FACETS(normal)                                                                      \
    FACET(normal, "-1 -1 0", "1 -1 0", "1 1 0") FACET(normal, "-1 -1 0", "1 1 0", "-1 1 0")
#define SQUARE "solid x\n" SQUARE_FACETS(UP) "endsolid x\n"

static bool read_data(const void *data, size_t size)
{
    /* Exactly as long as the file, so that sanitizers see what reads beyond its end. */
    uint8_t *const exact = malloc(size);
    memcpy(exact, data, size);
    const bool good = read_bytes(MODEL_STL, "x.stl", exact, size, NULL);
    free(exact);
    return good;
}

/* Requires the square: two triangles of four vertices whose normals are (0, 0, 1), and this
 * warning, or none. */
static void require_square(bool is_read, const char *warning)
{
    if (!is_read || read_messages.warning_count > (warning != NULL))
        print_messages();
    assert_true(is_read);
    assert_int_equal(read_messages.warning_count, warning != NULL);
    if (warning != NULL && !has_warning(warning))
        print_messages();
    assert_true(warning == NULL || has_warning(warning));
    assert_int_equal(read_model.part_count, 1);
    const model_part *const p = read_model.parts;
    static const float expected[6][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
    assert_int_equal(p->kind, MODEL_TRIANGLES);
    assert_int_equal(p->index_count, 6);
    assert_int_equal(p->vertex_count, 4);
    for (size_t i = 0; i < 6; ++i) {
        const float *const position = p->positions + 3 * p->indices[i];
        assert_true(position[0] == expected[i][0] && position[1] == expected[i][1] &&
                    position[2] == 0.0f);
    }
    for (size_t v = 0; v < 4; ++v)
        assert_true(p->normals[3 * v] == 0.0f && p->normals[3 * v + 1] == 0.0f &&
                    p->normals[3 * v + 2] == 1.0f);
}

static void read_square(const char *text, const char *warning)
{
    require_square(read_data(text, strlen(text)), warning);
}

static void refuse(const char *text, const char *fault)
{
    assert_false(read_data(text, strlen(text)));
    assert_string_equal(read_messages.fault_file, "x.stl");
    assert_string_equal(read_messages.fault, fault);
}

/* A binary file in the making. */
typedef struct writer {
    uint8_t bytes[2048];
    size_t size;
} writer;

static void write_bits(writer *w, uint32_t bits, size_t size)
{
    for (size_t i = 0; i < size; ++i)
        w->bytes[w->size++] = (uint8_t)(bits >> 8 * i);
}

static void write_facet(writer *w, const float *numbers, uint32_t attribute)
{
    for (int i = 0; i < 12; ++i) {
        uint32_t bits;
        memcpy(&bits, numbers + i, sizeof bits);
        write_bits(w, bits, 4);
    }
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
    (void)state;
    read_square(SQUARE, NULL);
    for (int c = 0; c < 4; ++c)
        assert_true(fabs((double)read_model.parts->colors[c] - (c < 3 ? 0.8 : 1.0)) < 1e-6);
    assert_true(read_model.parts->has_normals);
    assert_false(read_model.parts->has_vertex_colors);
    /* What writers put before "solid", and how they write keywords. */
    read_square("\xef\xbb\xbf" SQUARE, NULL);
    read_square("\n\n  \t" SQUARE, NULL);
    read_square("SOLID X\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX -1 -1 0\nVERTEX 1 -1 0\n"
                "VERTEX 1 1 0\nENDLOOP\nENDFACET\nFACET NORMAL 0 0 1\nOUTER LOOP\n"
                "VERTEX -1 -1 0\nVERTEX 1 1 0\nVERTEX -1 1 0\nENDLOOP\nENDFACET\nENDSOLID\n",
                NULL);
    /* Names may be anything, or absent; a file may hold several solids. */
    read_square("solid facet normal 1 2 vertex\n" SQUARE_FACETS(UP) "endsolid facet vertex\n",
                NULL);
    read_square("solid\n" FACET(UP, "-1 -1 0", "1 -1 0", "1 1 0") "endsolid\nsolid two\n" FACET(
                    UP, "-1 -1 0", "1 1 0", "-1 1 0") "endsolid two\n",
                NULL);
    /* Blanks and ends of lines have one meaning inside a facet. */
    read_square("solid x\nfacet normal 0 0 1 outer loop vertex -1 -1 0 vertex 1 -1 0 vertex 1 1 0 "
                "endloop endfacet facet normal 0 0 1 outer loop vertex -1\n-1 0\nvertex\n1 1 0 "
                "vertex -1.0e0 +1 -0 endloop endfacet\nendsolid",
                NULL);
    read_square("solid x\ncolor 1 0 0\n" SQUARE_FACETS(UP) "endsolid x\n",
                "x.stl: line 2: color is not known (1)");
}

static void test_ends_of_lines(void **state)
{
    static const char *const ends[] = {"\r\n", "\r"};
    (void)state;
    for (size_t e = 0; e < 2; ++e) {
        char text[1024];
        end_lines(SQUARE, ends[e], text);
        read_square(text, NULL);
    }
}

static void test_normals(void **state)
{
    static const char *const warning =
        "x.stl: 2 facets have normals that are not finite; they are computed from the corners (1)";
    (void)state;
    read_square("solid x\n" SQUARE_FACETS("normal -nan(ind) -nan(ind) -nan(ind)") "endsolid\n",
                warning);
    read_square("solid x\n" SQUARE_FACETS("normal 1.#QNAN 1.#QNAN 1.#QNAN") "endsolid\n", warning);
    read_square("solid x\n" SQUARE_FACETS("normal nan NAN -nan") "endsolid\n", warning);
    read_square("solid x\n" SQUARE_FACETS("normal 0 0 inf") "endsolid\n", warning);
    read_square("solid x\n" SQUARE_FACETS("normal 0 0 x") "endsolid\n", warning);
    read_square("solid x\n" SQUARE_FACETS("normal 0 0") "endsolid\n", warning);
    /* A normal of zeros, or none, asks for computing. */
    read_square("solid x\n" SQUARE_FACETS("normal 0 0 0") "endsolid\n", NULL);
    read_square("solid x\n" SQUARE_FACETS("normal -0 0 -0") "endsolid\n", NULL);
    read_square("solid x\n" SQUARE_FACETS("") "endsolid\n", NULL);
    /* Any other normal stays as it is, of whatever length. */
    static const char slanted[] = "solid x\n" SQUARE_FACETS("normal 0 3 4") "endsolid\n";
    assert_true(read_data(slanted, sizeof slanted - 1));
    assert_true(read_model.parts->normals[1] == 3.0f && read_model.parts->normals[2] == 4.0f);
    /* A binary one, with zeros and with NaN. */
    writer w;
    write_square(&w, "", 0, 0);
    memset(w.bytes + 84, 0, 12);
    memset(w.bytes + 134, 0xff, 12);
    require_square(read_written(&w), "x.stl: 1 facet has a normal that is not finite; it is "
                                     "computed from the corners (1)");
}

static void test_sharing(void **state)
{
    static const char text[] = "solid x\n" FACET("normal 0 0 1", "0 0 0", "1 0 0", "0 1 0")
        FACET("normal -0 -0 1", "-0 -0 0", "0 1 -0", "-1 0 0")
            FACET("normal 0 -1 0", "0 0 0", "0 0 -1", "1 0 0") "endsolid\n";
    (void)state;
    assert_true(read_data(text, sizeof text - 1));
    assert_int_equal(read_messages.warning_count, 0);
    const model_part *const p = read_model.parts;
    assert_int_equal(p->index_count, 9);
    /* Zeros of both signs are equal; another normal makes another vertex. */
    assert_int_equal(p->vertex_count, 4 + 3);
    assert_int_equal(p->indices[0], p->indices[3]);
    assert_int_equal(p->indices[2], p->indices[4]);
    assert_true(p->indices[6] != p->indices[0]);
    assert_true(p->normals[3 * p->indices[6] + 1] == -1.0f);
}

/* A grid of 40 x 40 squares has 41 x 41 vertices. */
static void test_large_grid(void **state)
{
    enum { SIDE = 40, SIZE = 84 + 50 * 2 * SIDE * SIDE };
    static writer w;
    static uint8_t bytes[SIZE];
    (void)state;
    size_t at = 84;
    memset(bytes, 0, sizeof bytes);
    for (uint32_t i = 0; i < 2 * SIDE * SIDE; ++i) {
        const float x = (float)(i / 2 % SIDE), y = (float)(i / 2 / SIDE);
        const float lower[12] = {0, 0, 1, x, y, 0, x + 1, y, 0, x + 1, y + 1, 0};
        const float upper[12] = {0, 0, 1, x, y, 0, x + 1, y + 1, 0, x, y + 1, 0};
        w.size = 0;
        write_facet(&w, i % 2 ? upper : lower, 0);
        memcpy(bytes + at, w.bytes, 50);
        at += 50;
    }
    w.size = 0;
    write_bits(&w, 2 * SIDE * SIDE, 4);
    memcpy(bytes + 80, w.bytes, 4);
    assert_true(read_data(bytes, sizeof bytes));
    const model_part *const p = read_model.parts;
    assert_int_equal(p->vertex_count, (SIDE + 1) * (SIDE + 1));
    assert_int_equal(p->index_count, 6 * SIDE * SIDE);
    for (size_t i = 0; i < p->index_count; i += 6) {
        const float *const v = p->positions + 3 * p->indices[i];
        assert_true(v[0] == (float)(i / 6 % SIDE) && v[1] == (float)(i / 6 / SIDE));
    }
}

static void test_binary(void **state)
{
    /* Headers begin with anything, "solid" too. */
    static const char *const headers[] = {"", "part", "solid", "solid x\nfacet normal 0 0 1\n",
                                          " SOLID a\n"};
    writer w;
    (void)state;
    for (size_t i = 0; i < sizeof headers / sizeof headers[0]; ++i) {
        write_square(&w, headers[i], 0, 0);
        require_square(read_written(&w), NULL);
    }
    write_square(&w, "solid part", 0, 0);
    write_bits(&w, 0, 2);
    require_square(read_written(&w), "x.stl: 2 bytes behind the last triangle are left out (1)");
    write_square(&w, "part", 0, 0);
    w.size -= 2;
    assert_false(read_written(&w));
    assert_string_equal(read_messages.fault,
                        "it is cut short: 2 triangles take 184 bytes, but it has 182");
    write_square(&w, "solid part", 0, 0);
    w.size = 84;
    assert_false(read_written(&w));
    assert_string_equal(read_messages.fault,
                        "it is cut short: 2 triangles take 184 bytes, but it has 84");
    w.size = 83;
    assert_false(read_written(&w));
    assert_string_equal(read_messages.fault,
                        "it is neither binary STL nor a text that begins with \"solid\"");
}

static void require_color(uint32_t index, double r, double g, double b)
{
    const double expected[4] = {r, g, b, 1.0};
    const model_part *const p = read_model.parts;
    for (size_t c = 0; c < 4; ++c)
        assert_true(fabs((double)p->colors[4 * p->indices[index] + c] - expected[c]) < 1e-6);
}

static void test_colors(void **state)
{
    writer w;
    (void)state;
    /* VisCAM and SolidView: blue in the lowest five bits, bit 15 says that there is a colour. */
    write_square(&w, "", 0x8000 | 31 << 10 | 0 << 5 | 15, 0x7fff);
    assert_true(read_written(&w));
    assert_int_equal(read_messages.warning_count, 0);
    assert_true(read_model.parts->has_vertex_colors);
    assert_int_equal(read_model.parts->vertex_count, 6);
    require_color(0, 1.0, 0.0, 15.0 / 31.0);
    require_color(3, 0.8, 0.8, 0.8);
    /* Magics: red in the lowest bits; bit 15 says that the header's colour is meant. */
    write_square(&w, "COLOR=\x33\x66\x99\xff,MATERIAL=", 0x8000, 31 << 10 | 0 << 5 | 15);
    assert_true(read_written(&w));
    assert_int_equal(read_messages.warning_count, 0);
    require_color(0, 0.2, 0.4, 0.6);
    require_color(3, 15.0 / 31.0, 0.0, 1.0);
    write_square(&w, "", 0x8000, 0x8000);
    memcpy(w.bytes + 70, "COLOR=\x33\x66\x99\x80", 10);
    require_square(read_written(&w), "x.stl: the alpha of COLOR= is not drawn (1)");
    require_color(5, 0.2, 0.4, 0.6);
    /* Bytes that mean something else. */
    write_square(&w, "", 7, 0);
    require_square(read_written(&w), "x.stl: the attribute bytes of triangles are not drawn (1)");
    require_color(0, 0.8, 0.8, 0.8);
}

static void test_far_coordinates(void **state)
{
    static const char text[] =
        "solid x\n" FACET(UP, "500000.25 4500000.5 7", "500001.25 4500000.5 7",
                          "500000.25 4500001.5 7") "endsolid x\n";
    (void)state;
    assert_true(read_data(text, sizeof text - 1));
    const float *const p = read_model.parts->positions;
    static const double expected[3][3] = {
        {500000.25, 4500000.5, 7}, {500001.25, 4500000.5, 7}, {500000.25, 4500001.5, 7}};
    for (size_t v = 0; v < 3; ++v)
        for (size_t c = 0; c < 3; ++c)
            assert_true(read_model.origin[c] + (double)p[3 * v + c] == expected[v][c]);
}

static void test_cut_short(void **state)
{
    static const char *const warning =
        "x.stl: line 15: it ends without endsolid; it may be cut short (1)";
    (void)state;
    read_square("solid x\n" SQUARE_FACETS(UP),
                "x.stl: line 16: it ends without endsolid; it may be "
                "cut short (1)");
    read_square(
        "solid x\n" FACET(
            UP, "-1 -1 0", "1 -1 0",
            "1 1 0") " facet " UP
                     "\n  outer loop\n   vertex -1 -1 0\n   vertex 1 1 0\n   vertex -1 1 0\n"
                     "  endloop\n",
        warning);
    refuse("solid x\n" FACET(UP, "-1 -1 0", "1 -1 0",
                             "1 1 0") " facet " UP
                                      "\n  outer loop\n   vertex -1 -1 0\n   vertex 1 1 0\n",
           "line 13: it is cut short: the last facet has only 2 of 3 vertices");
    refuse("solid x\nfacet " UP "\nouter loop\nvertex 1 2",
           "line 4: it is cut short: it ends in a vertex");
    refuse("solid x\nendsolid x\n", "there are no triangles, lines or points in it");
    refuse("solid", "there are no triangles, lines or points in it");
    writer w;
    write_square(&w, "", 0, 0);
    memset(w.bytes + 80, 0, 4);
    w.size = 84;
    assert_false(read_written(&w));
    assert_string_equal(read_messages.fault, "there are no triangles, lines or points in it");
}

static void test_faults(void **state)
{
    (void)state;
    refuse("solid x\n" FACET(UP, "0 0 0", "1 0 zero", "0 1 0") "endsolid\n",
           "line 5: z of vertex is not a number: zero");
    refuse("solid x\n" FACET(UP, "0 0 0", "1 nan 0", "0 1 0") "endsolid\n",
           "line 5: y of vertex is not a number: nan");
    refuse("solid x\n" FACET(UP, "0 0 0", "1 0", "0 1 0") "endsolid\n",
           "line 6: z of vertex is not a number: vertex");
    refuse("solid x\nfacet " UP "\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\n",
           "line 7: the facet has 2 vertices, not 3");
    refuse("solid x\n" FACET(UP, "0 0 0", "1 0 0", "0 1 0\nvertex 0 0 0") "endsolid\n",
           "line 7: the facet has more than 3 vertices");
    refuse("solid x\nvertex 0 0 0\n", "line 2: vertex stands outside a facet");
    refuse("solid x\nendfacet\n", "line 2: endfacet stands outside a facet");
    refuse("solid x\nfacet " UP "\nfacet " UP "\n",
           "line 3: facet begins in another facet, which has no endfacet");
    refuse("solid x\nfacet " UP "\nendsolid\n",
           "line 3: endsolid stands in a facet, which has no endfacet");
    refuse("some text that is long enough to hold the header of a binary file but is none, since "
           "it has no zeros",
           "it is neither binary STL nor a text that begins with \"solid\"");
    /* A binary position that is none. */
    writer w;
    write_square(&w, "", 0, 0);
    memset(w.bytes + 84 + 12, 0xff, 4);
    assert_false(read_written(&w));
    assert_string_equal(read_messages.fault, "the position of a vertex is not a finite number");
}

static void test_flat_triangles(void **state)
{
    static const char text[] = "solid x\n" SQUARE_FACETS("normal 0 0 0")
        FACET("normal 0 0 0", "5 5 0", "5 5 0", "6 6 0") "endsolid\n";
    (void)state;
    assert_true(read_data(text, sizeof text - 1));
    assert_int_equal(read_model.parts->index_count, 9);
    assert_true(has_warning("x.stl: 1 triangle has no area and cannot be seen (1)"));
}

static void test_little_memory(void **state)
{
    (void)state;
    require_within_budget(MODEL_STL, "x.stl", SQUARE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_texts),          cmocka_unit_test(test_ends_of_lines),
        cmocka_unit_test(test_normals),        cmocka_unit_test(test_sharing),
        cmocka_unit_test(test_large_grid),     cmocka_unit_test(test_binary),
        cmocka_unit_test(test_colors),         cmocka_unit_test(test_far_coordinates),
        cmocka_unit_test(test_cut_short),      cmocka_unit_test(test_faults),
        cmocka_unit_test(test_flat_triangles), cmocka_unit_test(test_little_memory),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    forget_model();
    return failed;
}
