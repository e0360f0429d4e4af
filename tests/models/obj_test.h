/* What the tests of OBJ, MTL and polygons share. */
#ifndef OBJ_TEST_H
#define OBJ_TEST_H

#include "model_test.h"

/* Reads an OBJ text called x.obj. */
static inline bool read_obj_text(const char *text, const test_file *files)
{
    return read_bytes(MODEL_OBJ, "x.obj", text, strlen(text), files);
}

/* The area of a part's triangles seen from +z; of those that turn right it is negative. Also
 * returns the smallest triangle's. */
static inline double signed_area(const model_part *part, double *smallest)
{
    double sum = 0.0;
    *smallest = INFINITY;
    for (size_t i = 0; i < part->index_count; i += 3) {
        const float *const a = part->positions + 3 * (size_t)part->indices[i];
        const float *const b = part->positions + 3 * (size_t)part->indices[i + 1];
        const float *const c = part->positions + 3 * (size_t)part->indices[i + 2];
        const double area = 0.5 * (((double)b[0] - (double)a[0]) * ((double)c[1] - (double)a[1]) -
                                   ((double)b[1] - (double)a[1]) * ((double)c[0] - (double)a[0]));
        sum += area;
        *smallest = area < *smallest ? area : *smallest;
    }
    return sum;
}

static inline void expect_color(const model_part *part, uint32_t v, float red, float green,
                                float blue, float alpha)
{
    const float *const color = part->colors + 4 * (size_t)v;
    assert_float_equal(color[0], red, 1e-7f);
    assert_float_equal(color[1], green, 1e-7f);
    assert_float_equal(color[2], blue, 1e-7f);
    assert_float_equal(color[3], alpha, 1e-7f);
}

#endif
