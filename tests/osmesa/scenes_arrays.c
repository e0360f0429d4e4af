/* Scenes of arrays of every type, in the program's memory and in buffer objects, with and without
 * indices. */
#include <stdlib.h>
#include <string.h>

#include "scene_parts.h"

enum { VERTICES = 40, MOST_INDICES = 90, ELEMENT = 4 * 8 };

static size_t size_of(GLenum type)
{
    return type == GL_DOUBLE                               ? 8
           : type == GL_BYTE || type == GL_UNSIGNED_BYTE   ? 1
           : type == GL_SHORT || type == GL_UNSIGNED_SHORT ? 2
                                                           : 4;
}

/* Writes a number as one of a type; integers are whole multiples of `one`. */
static void put(unsigned char *to, GLenum type, float value, float one)
{
    const GLdouble wide = (GLdouble)value;
    const GLint64 whole = (GLint64)(value * one);
    const GLbyte b = (GLbyte)whole;
    const GLshort s = (GLshort)whole;
    const GLint i = (GLint)whole;
    const void *const from = type == GL_DOUBLE    ? (const void *)&wide
                             : type == GL_FLOAT   ? (const void *)&value
                             : size_of(type) == 1 ? (const void *)&b
                             : size_of(type) == 2 ? (const void *)&s
                                                  : (const void *)&i;

    memcpy(to, from, size_of(type));
}

/* An array of random numbers: `one` is the integer that stands for 1. */
typedef struct random_array {
    unsigned char data[VERTICES * (ELEMENT + 2 * 8)];
    GLint size;
    GLenum type;
    GLsizei stride;
} random_array;

static void fill(random_array *a, random_source *r, GLint size, GLenum type, float low, float high,
                 float one)
{
    const size_t element = (size_t)size * size_of(type);
    const size_t padding = one_in(r, 2) ? 0 : size_of(type) * random_below(r, 3);

    a->size = size;
    a->type = type;
    a->stride = padding || one_in(r, 2) ? (GLsizei)(element + padding) : 0;
    for (size_t v = 0; v < VERTICES; ++v)
        for (size_t c = 0; c < (size_t)size; ++c)
            put(a->data + v * (element + padding) + c * size_of(type), type,
                c == 3 ? 1.0f : between(r, low, high), one);
}

static float one_of_type(GLenum type)
{
    switch (type) {
    case GL_BYTE:
        return 127.0f;
    case GL_UNSIGNED_BYTE:
        return 255.0f;
    case GL_SHORT:
        return 32767.0f;
    case GL_UNSIGNED_SHORT:
        return 65535.0f;
    case GL_INT:
        return 2147483520.0f;
    default:
        return 4294967040.0f;
    }
}

/* Returns what a pointer function is given: the data, or an offset in the bound buffer. */
static const void *place(const library *gl, random_source *r, random_array *a, GLuint buffer)
{
    (void)r;
    gl->BindBuffer(GL_ARRAY_BUFFER, buffer);
    if (!buffer)
        return a->data;
    gl->BufferData(GL_ARRAY_BUFFER, sizeof a->data, a->data, GL_STATIC_DRAW);
    return NULL;
}

void draw_arrays(const library *gl, random_source *r, int width, int height)
{
    static random_array position, color;
    static GLuint indices[MOST_INDICES];
    const GLenum mode = PICK(r, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_LINES);
    const GLenum type = PICK(r, GL_SHORT, GL_INT, GL_FLOAT, GL_FLOAT, GL_DOUBLE);
    const GLenum color_type = PICK(r, GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT,
                                   GL_INT, GL_UNSIGNED_INT, GL_FLOAT, GL_DOUBLE);
    const bool in_buffers = one_in(r, 2), has_indices = one_in(r, 2);
    const GLint first = (GLint)random_below(r, 10);
    const float least =
        color_type == GL_BYTE || color_type == GL_SHORT || color_type == GL_INT ? -0.3f : 0.0f;
    const GLint size = 2 + (GLint)random_below(r, 3), colors = 3 + (GLint)random_below(r, 2);
    GLuint names[3] = {0, 0, 0};

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    set_color(gl, r);
    fill(&position, r, size, type, -1.5f, 1.5f, 9.0f);
    fill(&color, r, colors, color_type, least, 1.0f, one_of_type(color_type));
    for (int i = 0; i < MOST_INDICES; ++i)
        indices[i] = random_below(r, VERTICES);
    if (type == GL_SHORT || type == GL_INT)
        gl->Scalef(0.11f, 0.11f, 0.11f);
    if (in_buffers)
        gl->GenBuffers(3, names);
    gl->EnableClientState(GL_VERTEX_ARRAY);
    gl->VertexPointer(size, type, position.stride, place(gl, r, &position, names[0]));
    if (!one_in(r, 4)) {
        gl->EnableClientState(GL_COLOR_ARRAY);
        gl->ColorPointer(colors, color_type, color.stride, place(gl, r, &color, names[1]));
    }
    if (has_indices) {
        const GLenum index_type = PICK(r, GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT);
        static unsigned char data[sizeof indices];

        for (int i = 0; i < MOST_INDICES; ++i)
            put(data + (size_t)i * size_of(index_type), index_type, (float)indices[i], 1.0f);
        gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[2]);
        if (in_buffers)
            gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof data, data, GL_STATIC_DRAW);
        gl->DrawElements(mode, MOST_INDICES, index_type, in_buffers ? NULL : data);
    } else {
        gl->DrawArrays(mode, first, VERTICES - first);
    }
    gl->Finish();
    gl->DeleteBuffers(3, names);
}
