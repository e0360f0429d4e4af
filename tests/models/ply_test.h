/* What the tests of PLY files share: texts that are read well, with a warning or not at all, and
 * binary files in the making. */
#ifndef PLY_TEST_H
#define PLY_TEST_H

#include <math.h>
#include <stdlib.h>

#include "model_test.h"

#define XYZ "property float x\nproperty float y\nproperty float z\n"
#define SQUARE_POINTS "-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n"
#define INDICES "property list uchar int vertex_indices\n"
#define SQUARE                                                                                     \
    "ply\nformat ascii 1.0\nelement vertex 4\n" XYZ "element face 1\n" INDICES                     \
    "end_header\n" SQUARE_POINTS "4 0 1 2 3\n"

static inline bool read_text(const char *text)
{
    return read_bytes(MODEL_PLY, "x.ply", text, strlen(text), NULL);
}

/* Requires a model to be read without a warning. */
static inline void read_well(const char *text)
{
    const bool good = read_text(text);
    if (!good || read_messages.warning_count > 0)
        print_messages();
    assert_true(good);
    assert_int_equal(read_messages.warning_count, 0);
}

static inline void read_warned(const char *text, const char *warning)
{
    const bool good = read_text(text);
    if (!good || !has_warning(warning) || read_messages.warning_count != 1)
        print_messages();
    assert_true(good);
    assert_true(has_warning(warning));
    assert_int_equal(read_messages.warning_count, 1);
}

static inline void refuse(const char *text, const char *fault)
{
    assert_false(read_text(text));
    assert_string_equal(read_messages.fault_file, "x.ply");
    assert_string_equal(read_messages.fault, fault);
    assert_int_equal(read_model.part_count, 0);
}

/* Twice the area in the plane of x and y; negative if the winding is clockwise. */
static inline double triangle_area(const model_part *p, size_t triangle)
{
    const float *v[3];
    for (size_t k = 0; k < 3; ++k)
        v[k] = p->positions + 3 * (size_t)p->indices[3 * triangle + k];
    return (double)(v[1][0] - v[0][0]) * (double)(v[2][1] - v[0][1]) -
           (double)(v[1][1] - v[0][1]) * (double)(v[2][0] - v[0][0]);
}

/* Requires triangles in the plane of x and y, all counter-clockwise, with this area together. */
static inline void require_area(const model_part *p, size_t triangles, double area)
{
    double sum = 0.0;
    assert_int_equal(p->kind, MODEL_TRIANGLES);
    assert_int_equal(p->index_count, 3 * triangles);
    for (size_t t = 0; t < triangles; ++t) {
        assert_true(triangle_area(p, t) > 0.0);
        sum += triangle_area(p, t) / 2.0;
    }
    assert_true(fabs(sum - area) < 1e-6);
}

static inline void require_color(const model_part *p, size_t vertex, double r, double g, double b,
                                 double a)
{
    const double expected[4] = {r, g, b, a};
    for (size_t c = 0; c < 4; ++c)
        assert_true(fabs((double)p->colors[4 * vertex + c] - expected[c]) < 1e-6);
}

/* A binary file in the making. */
typedef struct writer {
    uint8_t bytes[2048];
    size_t size;
    bool is_big;
} writer;

static inline void write_bits(writer *w, uint64_t bits, size_t size)
{
    for (size_t i = 0; i < size; ++i)
        w->bytes[w->size++] = (uint8_t)(bits >> 8 * (w->is_big ? size - 1 - i : i));
}

static inline void write_float(writer *w, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    write_bits(w, bits, sizeof bits);
}

static inline void write_double(writer *w, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    write_bits(w, bits, sizeof bits);
}

static inline void write_header(writer *w, bool is_big, const char *text)
{
    w->is_big = is_big;
    w->size = (size_t)sprintf((char *)w->bytes, "ply%sformat binary_%s_endian 1.0\n%s",
                              strstr(text, "\r\n") != NULL ? "\r\n" : "\n",
                              is_big ? "big" : "little", text);
}

static inline bool read_written(const writer *w)
{
    /* Exactly as long as the file, so that sanitizers see what reads beyond its end. */
    uint8_t *const exact = malloc(w->size);
    memcpy(exact, w->bytes, w->size);
    const bool good = read_bytes(MODEL_PLY, "x.ply", exact, w->size, NULL);
    free(exact);
    return good;
}

#endif
