/* What the tests of the glTF reader share: building small files. Their texts are written with ' for
 * ". A test fills views of one buffer and accessors, and writes the rest of the JSON. */
#ifndef GLTF_TEST_H
#define GLTF_TEST_H

#include "model_test.h"

enum { T_I8 = 5120, T_U8 = 5121, T_I16 = 5122, T_U16 = 5123, T_U32 = 5125, T_F32 = 5126 };

static uint8_t gltf_bytes[4096];
static size_t gltf_size, gltf_view_count, gltf_accessor_count;
static char gltf_views[4096], gltf_accessors[8192], gltf_text[65536];

static inline void gltf_begin(void)
{
    gltf_size = gltf_view_count = gltf_accessor_count = 0;
    gltf_views[0] = gltf_accessors[0] = '\0';
}

static inline void gltf_append(char *text, size_t size, const char *format, ...)
{
    const size_t length = strlen(text);
    va_list values;
    va_start(values, format);
    vsnprintf(text + length, size - length, format, values);
    va_end(values);
}

/* Appends bytes to the buffer, as a view of them. Returns the view. */
static inline unsigned gltf_view(const void *bytes, size_t size)
{
    assert_true(gltf_size + size <= sizeof gltf_bytes);
    memcpy(gltf_bytes + gltf_size, bytes, size);
    gltf_append(gltf_views, sizeof gltf_views, "%s{'buffer':0,'byteOffset':%zu,'byteLength':%zu}",
                gltf_view_count > 0 ? "," : "", gltf_size, size);
    gltf_size += size;
    return (unsigned)gltf_view_count++;
}

/* Appends an accessor with the members of `more`. Returns its number. */
static inline unsigned gltf_accessor(const char *type, int component, unsigned count,
                                     const char *more)
{
    gltf_append(gltf_accessors, sizeof gltf_accessors,
                "%s{'type':'%s','componentType':%d,'count':%u%s%s}",
                gltf_accessor_count > 0 ? "," : "", type, component, count,
                more[0] != '\0' ? "," : "", more);
    return (unsigned)gltf_accessor_count++;
}

/* Appends an accessor of a view of its own. */
static inline unsigned gltf_array(const char *type, int component, unsigned count,
                                  const void *bytes, size_t size)
{
    char more[64];
    snprintf(more, sizeof more, "'bufferView':%u", gltf_view(bytes, size));
    return gltf_accessor(type, component, count, more);
}

static inline unsigned gltf_fractions(const char *type, int component, unsigned count,
                                      const void *bytes, size_t size)
{
    char more[64];
    snprintf(more, sizeof more, "'bufferView':%u,'normalized':true", gltf_view(bytes, size));
    return gltf_accessor(type, component, count, more);
}

static inline void gltf_quotes(char *text)
{
    for (; *text != '\0'; ++text)
        if (*text == '\'')
            *text = '"';
}

static inline void gltf_base64(char *to)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < gltf_size; i += 3) {
        unsigned long bits = (unsigned long)gltf_bytes[i] << 16;
        bits |= i + 1 < gltf_size ? (unsigned long)gltf_bytes[i + 1] << 8 : 0;
        bits |= i + 2 < gltf_size ? gltf_bytes[i + 2] : 0;
        for (int k = 0; k < 4; ++k)
            *to++ = digits[bits >> (18 - 6 * k) & 63];
        if (i + 1 >= gltf_size)
            to[-2] = '=';
        if (i + 2 >= gltf_size)
            to[-1] = '=';
    }
    *to = '\0';
}

/* Writes the text whose buffer has this URI; null: none. */
static inline void gltf_write(const char *rest, const char *uri)
{
    snprintf(gltf_text, sizeof gltf_text,
             "{'asset':{'version':'2.0'},'buffers':[{'byteLength':%zu%s%s%s}],"
             "'bufferViews':[%s],'accessors':[%s]%s%s}",
             gltf_size, uri != NULL ? ",'uri':'" : "", uri != NULL ? uri : "",
             uri != NULL ? "'" : "", gltf_views, gltf_accessors, rest[0] != '\0' ? "," : "", rest);
    gltf_quotes(gltf_text);
}

/* Reads the file whose JSON has also these members. */
static inline bool gltf_read(const char *rest)
{
    static char uri[8192];
    strcpy(uri, "data:application/octet-stream;base64,");
    gltf_base64(uri + strlen(uri));
    gltf_write(rest, uri);
    return read_bytes(MODEL_GLTF, "a.gltf", gltf_text, strlen(gltf_text), NULL);
}

/* Reads a text as it is, but for its quotes. */
static inline bool gltf_read_text(const char *text)
{
    snprintf(gltf_text, sizeof gltf_text, "%s", text);
    gltf_quotes(gltf_text);
    return read_bytes(MODEL_GLTF, "a.gltf", gltf_text, strlen(gltf_text), NULL);
}

static inline void gltf_assert_fault(const char *expected)
{
    if (strcmp(read_messages.fault, expected) != 0)
        print_messages();
    assert_string_equal(read_messages.fault, expected);
}

/* Fails unless the file is read. */
static inline const model_part *gltf_part(const char *rest)
{
    const bool good = gltf_read(rest);
    if (!good)
        print_messages();
    assert_true(good);
    return read_model.parts;
}

static inline void gltf_assert_floats(const float *values, const float *expected, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        assert_float_equal(values[i], expected[i], 1e-6f);
}

/* The lower left half of the unit square. */
static const float gltf_corner[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
static const float gltf_up[9] = {0, 0, 1, 0, 0, 1, 0, 0, 1};

/* Begins with the triangle above as accessor 0, and its normals as accessor 1. */
static inline void gltf_begin_triangle(void)
{
    gltf_begin();
    gltf_array("VEC3", T_F32, 3, gltf_corner, sizeof gltf_corner);
    gltf_array("VEC3", T_F32, 3, gltf_up, sizeof gltf_up);
}

/* One mesh of one primitive with these members, at a node. */
#define GLTF_MESH(primitive) "'nodes':[{'mesh':0}],'meshes':[{'primitives':[{" primitive "}]}]"
#define GLTF_TRIANGLE GLTF_MESH("'attributes':{'POSITION':0,'NORMAL':1}")

#endif
