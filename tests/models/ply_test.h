/* What the tests of PLY files share: texts that are read well, with a warning or not at all, and
 * binary files in the making. */
#ifndef PLY_TEST_H
#define PLY_TEST_H

#include "model_test.h"

#define XYZ "property float x\nproperty float y\nproperty float z\n"
#define RGB "property uchar red\nproperty uchar green\nproperty uchar blue\n"
#define VERTICES(count) "ply\nformat ascii 1.0\nelement vertex " count "\n" XYZ
#define INDICES "property list uchar int vertex_indices\n"
#define FACES(count) "element face " count "\n" INDICES
#define STRIPS(count, type)                                                                        \
    "element tristrips " count "\nproperty list int " type " vertex_indices\n"
#define EDGES(count) "element edge " count "\nproperty int vertex1\nproperty int vertex2\n"
#define TEXCOORDS "property list uchar float texcoord\n"
#define END "end_header\n"
#define SQUARE_POINTS "-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n"
#define TRIANGLE_POINTS "0 0 0\n1 0 0\n0 1 0\n"
#define SQUARE VERTICES("4") FACES("1") END SQUARE_POINTS "4 0 1 2 3\n"

static inline bool read_text(const char *text)
{
    return read_bytes(MODEL_PLY, "x.ply", text, strlen(text), NULL);
}

/* Requires a model to be read with this warning, "x.ply: text (count)"; null: with none. */
static inline const model_part *part_of(const char *text, const char *warning)
{
    expect_read(read_text(text), warning);
    return read_model.parts;
}

static inline void refuse(const char *text, const char *fault)
{
    expect_fault(read_text(text), fault);
    assert_string_equal(read_messages.fault_file, "x.ply");
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
    return read_bytes(MODEL_PLY, "x.ply", w->bytes, w->size, NULL);
}

#endif
