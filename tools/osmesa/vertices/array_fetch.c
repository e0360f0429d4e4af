/* Reads elements of arrays, and gathers them for a mesh. */
#include "array_fetch.h"

#include <gl_registry.h>
#include <string.h>

#include "buffer_objects.h"
#include "immediate.h"

static size_t type_size(GLenum type)
{
    switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
        return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
        return 2;
    case GL_DOUBLE:
        return 8;
    default:
        return 4;
    }
}

static size_t element_size(const vertex_array *array)
{
    return (size_t)array->size * type_size(array->type);
}

const unsigned char *array_start(const vertex_array *array)
{
    if (array->buffer)
        return array->buffer->data + (uintptr_t)array->pointer;
    return array->pointer;
}

size_t array_stride(const vertex_array *array)
{
    return array->stride ? (size_t)array->stride : element_size(array);
}

bool array_holds(const vertex_array *array, size_t last)
{
    const size_t size = array->buffer ? (size_t)array->buffer->size : 0;
    const size_t offset = (size_t)(uintptr_t)array->pointer, element = element_size(array);

    if (!array->buffer)
        return array->pointer != NULL;
    return array->buffer->data && offset <= size && element <= size - offset &&
           last <= (size - offset - element) / array_stride(array);
}

bool is_fraction_array(enum array_name name)
{
    return name == NORMAL_ARRAY || name == COLOR_ARRAY || name == SECONDARY_COLOR_ARRAY;
}

/* Reads `size` numbers of one type and converts each by an expression of x. */
#define FETCH(type, expression)                                                                    \
    for (GLint i = 0; i < size; ++i) {                                                             \
        type x;                                                                                    \
        memcpy(&x, at + (size_t)i * sizeof x, sizeof x);                                           \
        value[i] = expression;                                                                     \
    }                                                                                              \
    break

/* A signed fraction: -1 and 1 are exact, and the least integer counts as -1. */
static GLfloat signed_fraction(GLfloat fraction)
{
    return fraction < -1.0f ? -1.0f : fraction;
}

static void fetch_fraction(GLenum type, GLint size, const unsigned char *at, GLfloat value[4])
{
    switch (type) {
    case GL_BYTE:
        FETCH(GLbyte, signed_fraction((GLfloat)x * (1.0f / 127.0f)));
    case GL_UNSIGNED_BYTE:
        FETCH(GLubyte, (GLfloat)x * (1.0f / 255.0f));
    case GL_SHORT:
        FETCH(GLshort, signed_fraction((GLfloat)x * (1.0f / 32767.0f)));
    case GL_UNSIGNED_SHORT:
        FETCH(GLushort, (GLfloat)x * (1.0f / 65535.0f));
    case GL_INT:
        FETCH(GLint, signed_fraction((GLfloat)((GLdouble)x * (1.0 / 2147483647.0))));
    case GL_UNSIGNED_INT:
        /* The reference keeps the highest 23 bits, in the mantissa of a float. */
        FETCH(GLuint, ((GLfloat)(x >> 9) * 0x1p-23f) * (8388608.0f / 8388607.0f));
    case GL_DOUBLE:
        FETCH(GLdouble, (GLfloat)x);
    default:
        FETCH(GLfloat, x);
    }
}

static void fetch_number(GLenum type, GLint size, const unsigned char *at, GLfloat value[4])
{
    switch (type) {
    case GL_UNSIGNED_BYTE:
        FETCH(GLubyte, (GLfloat)x);
    case GL_SHORT:
        FETCH(GLshort, (GLfloat)x);
    case GL_INT:
        FETCH(GLint, (GLfloat)x);
    case GL_DOUBLE:
        FETCH(GLdouble, (GLfloat)x);
    default:
        FETCH(GLfloat, x);
    }
}

void fetch_element(const vertex_array *array, bool is_fraction, size_t element, GLfloat value[4])
{
    const unsigned char *const at = array_start(array) + element * array_stride(array);

    if (is_fraction)
        fetch_fraction(array->type, array->size, at, value);
    else
        fetch_number(array->type, array->size, at, value);
}

/* Attributes. Those of the secondary colour and the fog coordinate are made of two arrays. */

static enum attribute_name attribute_of(enum array_name name)
{
    switch (name) {
    case VERTEX_ARRAY:
        return POSITION;
    case NORMAL_ARRAY:
        return NORMAL;
    case COLOR_ARRAY:
        return COLOR;
    case SECONDARY_COLOR_ARRAY:
    case FOG_COORDINATE_ARRAY:
        return SECONDARY_AND_FOG;
    case EDGE_FLAG_ARRAY:
    case INDEX_ARRAY:
        return ATTRIBUTES;
    default:
        return (enum attribute_name)((int)TEXTURE_COORDINATE + (int)name -
                                     (int)TEXTURE_COORDINATE_ARRAY);
    }
}

/* Whether the library can read an array where it is. */
static bool is_in_place(const vertex_array *array, enum attribute_name attribute)
{
    return attribute != SECONDARY_AND_FOG && array->type == GL_FLOAT &&
           array_stride(array) % sizeof(GLfloat) == 0 && array_stride(array) <= UINT32_MAX &&
           (uintptr_t)array_start(array) % sizeof(GLfloat) == 0;
}

static void convert_array(context *gl, enum array_name name, size_t first, size_t count,
                          GLfloat (*to)[4])
{
    const vertex_array *const array = &gl->arrays.array[name];

    for (size_t i = 0; i < count; ++i) {
        GLfloat value[4];

        if (name == FOG_COORDINATE_ARRAY) {
            fetch_element(array, false, first + i, value);
            to[i][3] = value[0];
        } else if (name == SECONDARY_COLOR_ARRAY) {
            fetch_element(array, true, first + i, value);
            memcpy(to[i], value, 3 * sizeof *value);
        } else {
            fetch_element(array, is_fraction_array(name), first + i, to[i]);
        }
    }
}

static void fill(GLfloat (*to)[4], size_t count, const GLfloat value[4])
{
    for (size_t i = 0; i < count; ++i)
        memcpy(to[i], value, sizeof *to);
}

bool gather_attributes(context *gl, size_t first, size_t count, gn_mesh *mesh, const char *function)
{
    static const GLfloat lacking[4] = {0.0f, 0.0f, 0.0f, 1.0f};
    const vertex_array *const arrays = gl->arrays.array;
    uint32_t converted = 0;
    size_t attributes = 0;
    GLfloat(*to)[4];

    memset(mesh, 0, sizeof *mesh);
    if (!arrays[VERTEX_ARRAY].enabled || count == 0 || count > UINT32_MAX)
        return false;
    mesh->vertex_count = (uint32_t)count;
    for (int n = 0; n < ARRAYS; ++n) {
        const enum attribute_name a = attribute_of((enum array_name)n);

        if (!arrays[n].enabled || a == ATTRIBUTES)
            continue;
        if (!array_holds(&arrays[n], first + count - 1))
            return false;
        if (is_in_place(&arrays[n], a)) {
            mesh->attribute[a].data =
                (const void *)(array_start(&arrays[n]) + first * array_stride(&arrays[n]));
            mesh->attribute[a].components = (uint32_t)arrays[n].size;
            mesh->attribute[a].stride = (uint32_t)array_stride(&arrays[n]);
        } else if (!(converted >> a & 1u)) {
            converted |= 1u << a;
            ++attributes;
        }
    }
    to = attributes ? scratch_memory(gl, &gl->vertices, attributes * count * sizeof *to, function)
                    : NULL;
    if (attributes && !to)
        return false;
    for (int a = 0; a < ATTRIBUTES; ++a) {
        if (!(converted >> a & 1u))
            continue;
        fill(to, count, a == SECONDARY_AND_FOG ? gl->current.attribute[a] : lacking);
        for (int n = 0; n < ARRAYS; ++n)
            if (arrays[n].enabled && attribute_of((enum array_name)n) == (enum attribute_name)a)
                convert_array(gl, (enum array_name)n, first, count, to);
        mesh->attribute[a].data = (const GLfloat *)to;
        mesh->attribute[a].components = 4;
        mesh->attribute[a].stride = sizeof *to;
        to += count;
    }
    return true;
}

void read_array_element(const context *gl, size_t element, element_values *values)
{
    values->present = 0;
    for (int n = 0; n < ARRAYS; ++n) {
        const vertex_array *const array = &gl->arrays.array[n];
        GLfloat *const value = values->value[n];

        if (!array->enabled || !array_holds(array, element))
            continue;
        value[0] = value[1] = value[2] = 0.0f;
        value[3] = 1.0f;
        fetch_element(array, is_fraction_array((enum array_name)n), element, value);
        values->present |= 1u << n;
        values->size[n] = array->size;
    }
}

void set_array_element(const element_values *values)
{
    context *const gl = current_context();

    for (int n = ARRAYS - 1; n >= 0; --n) {
        const GLfloat *const value = values->value[n];

        if (!(values->present >> n & 1u))
            continue;
        if (n == VERTEX_ARRAY)
            add_vertex(values->size[n], value[0], value[1], value[2], value[3]);
        else if (n == NORMAL_ARRAY)
            set_attribute(NORMAL, 0, 3, 3, value);
        else if (n == COLOR_ARRAY)
            set_attribute(COLOR, 0, 4, values->size[n], value);
        else if (n == SECONDARY_COLOR_ARRAY)
            set_attribute(SECONDARY_AND_FOG, 0, 3, 3, value);
        else if (n == FOG_COORDINATE_ARRAY)
            set_attribute(SECONDARY_AND_FOG, 3, 1, 1, value);
        else if (n == EDGE_FLAG_ARRAY)
            gl->current.edge_flag = value[0] != 0.0f;
        else if (n == INDEX_ARRAY)
            gl->current.index = value[0];
        else
            set_attribute((enum attribute_name)(TEXTURE_COORDINATE + n - TEXTURE_COORDINATE_ARRAY),
                          0, 4, values->size[n], value);
    }
}
