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
static inline unsigned gltf_array_of(const char *type, int component, unsigned count,
                                     const void *bytes, size_t size, const char *more)
{
    char members[64];
    snprintf(members, sizeof members, "'bufferView':%u%s", gltf_view(bytes, size), more);
    return gltf_accessor(type, component, count, members);
}

static inline unsigned gltf_array(const char *type, int component, unsigned count,
                                  const void *bytes, size_t size)
{
    return gltf_array_of(type, component, count, bytes, size, "");
}

/* The same for a whole array. */
#define GLTF_ARRAY(type, component, count, array)                                                  \
    gltf_array(type, component, count, array, sizeof(array))
#define GLTF_FRACTIONS(type, component, count, array)                                              \
    gltf_array_of(type, component, count, array, sizeof(array), ",'normalized':true")

static inline void gltf_quotes(char *text)
{
    for (; *text != '\0'; ++text)
        if (*text == '\'')
            *text = '"';
}

/* Reads the text that was written last. */
static inline bool gltf_read_again(const test_file *files)
{
    return read_bytes(MODEL_GLTF, "a.gltf", gltf_text, strlen(gltf_text), files);
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
    const test_file files[] = {{"a.bin", (const char *)gltf_bytes, gltf_size}, {NULL, NULL, 0}};
    gltf_write(rest, gltf_size > 0 ? "a.bin" : "data:;base64,");
    return gltf_read_again(files);
}

static inline void gltf_refuse(const char *rest, const char *fault)
{
    expect_fault(gltf_read(rest), fault);
}

typedef struct refusal {
    const char *rest, *fault;
} refusal;

#define GLTF_REFUSE_ALL(cases)                                                                     \
    do {                                                                                           \
        for (size_t i_ = 0; i_ < sizeof(cases) / sizeof *(cases); ++i_)                            \
            gltf_refuse(cases[i_].rest, cases[i_].fault);                                          \
    } while (0)

/* Fails unless the file is read. */
static inline const model_part *gltf_part(const char *rest)
{
    const bool good = gltf_read(rest);
    if (!good)
        print_messages();
    assert_true(good);
    return read_model.parts;
}

/* The lower left half of the unit square. */
static const float gltf_corner[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
static const float gltf_up[9] = {0, 0, 1, 0, 0, 1, 0, 0, 1};

/* Begins with the triangle above as accessor 0, and its normals as accessor 1. */
static inline void gltf_begin_triangle(void)
{
    gltf_begin();
    GLTF_ARRAY("VEC3", T_F32, 3, gltf_corner);
    GLTF_ARRAY("VEC3", T_F32, 3, gltf_up);
}

/* One mesh of one primitive with these members, at a node. */
#define GLTF_MESH(primitive) "'nodes':[{'mesh':0}],'meshes':[{'primitives':[{" primitive "}]}]"
#define GLTF_ATTRIBUTES(rest) GLTF_MESH("'attributes':{'POSITION':0" rest "}")
#define GLTF_POSITIONS GLTF_ATTRIBUTES("")
#define GLTF_TRIANGLE GLTF_ATTRIBUTES(",'NORMAL':1")

#endif
