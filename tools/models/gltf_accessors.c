/* Accessors of a glTF: typed arrays in buffers (section 3.6.2). */
#include <stdint.h>
#include <string.h>

#include "gltf.h"

typedef struct element_type {
    char name[8];
    uint32_t components;
} element_type;

/* Nothing that is read is a MAT2 or MAT3, whose columns may have bytes between them. */
static const element_type types[] = {
    {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};

size_t gltf_component_size(uint32_t type)
{
    switch (type) {
    case GLTF_I8:
    case GLTF_U8:
        return 1;
    case GLTF_I16:
    case GLTF_U16:
        return 2;
    case GLTF_U32:
    case GLTF_F32:
        return 4;
    default:
        return 0;
    }
}

/* Finds `count` elements of `size` bytes, `stride` apart, in the view that an object names. */
static bool find_elements(gltf *g, uint32_t object, uint64_t count, size_t size, bool has_stride,
                          const uint8_t **bytes, size_t *stride)
{
    uint32_t view = GLTF_NONE;
    uint64_t offset = 0;
    size_t view_size, view_stride;
    if (!gltf_index(g, object, "bufferView", GLTF_BUFFER_VIEWS, &view) ||
        !gltf_integer(g, object, "byteOffset", UINT64_C(1) << 53, &offset))
        return false;
    if (view == GLTF_NONE)
        return reader_fail_at(g->r, gltf_path(g, object), "has no bufferView");
    if (!gltf_view(g, view, bytes, &view_size, &view_stride))
        return false;
    *stride = has_stride && view_stride != 0 ? view_stride : size;
    if (*stride < size)
        return reader_fail_at(g->r, gltf_path(g, gltf_element(g, GLTF_BUFFER_VIEWS, view)),
                              "byteStride is %llu, but elements have %llu bytes",
                              (unsigned long long)*stride, (unsigned long long)size);
    /* At most 2^32 elements, 252 bytes apart. */
    const uint64_t end = offset + (count - 1) * *stride + size;
    if (end > view_size)
        return reader_fail_at(
            g->r, gltf_path(g, object),
            "its %llu elements end at byte %llu, but the bufferView has only %llu",
            (unsigned long long)count, (unsigned long long)end, (unsigned long long)view_size);
    *bytes += offset;
    return true;
}

static uint32_t integer_at(const uint8_t *bytes, uint32_t type)
{
    if (type == GLTF_U8)
        return bytes[0];
    if (type == GLTF_U16)
        return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8;
    return reader_word(bytes);
}

static bool is_index_type(uint64_t type)
{
    return type == GLTF_U8 || type == GLTF_U16 || type == GLTF_U32;
}

/* Section 3.6.2.3: the elements that replace others, by growing number. */
static bool read_sparse(gltf *g, gltf_accessor *a, size_t element_size)
{
    uint32_t sparse, indices, values;
    uint64_t count = 0, type = 0;
    size_t stride;
    if (!gltf_container(g, a->token, "sparse", JSON_OBJECT, &sparse) ||
        !gltf_container(g, sparse, "indices", JSON_OBJECT, &indices) ||
        !gltf_container(g, sparse, "values", JSON_OBJECT, &values))
        return false;
    if (sparse == JSON_NONE)
        return true;
    if (!gltf_integer(g, sparse, "count", a->count, &count) ||
        !gltf_integer(g, indices, "componentType", UINT32_MAX, &type))
        return false;
    if (count == 0)
        return true;
    if (indices == JSON_NONE || values == JSON_NONE || !is_index_type(type))
        return reader_fail_at(g->r, gltf_path(g, sparse),
                              "has no indices of an unsigned type, or no values");
    const size_t size = gltf_component_size((uint32_t)type);
    if (!find_elements(g, indices, count, size, false, &a->sparse_indices, &stride) ||
        !find_elements(g, values, count, element_size, false, &a->sparse_values, &stride))
        return false;
    a->sparse_count = (uint32_t)count;
    a->sparse_type = (uint32_t)type;
    uint64_t least = 0;
    for (size_t i = 0; i < count; ++i) {
        const uint32_t index = integer_at(a->sparse_indices + i * size, a->sparse_type);
        if (index < least || index >= a->count)
            return reader_fail_at(g->r, gltf_path(g, indices),
                                  "an index is %u, which does not grow or is not below %u",
                                  (unsigned)index, (unsigned)a->count);
        least = (uint64_t)index + 1;
    }
    return true;
}

static const element_type *type_of(gltf *g, uint32_t token)
{
    const uint32_t type = json_member(&g->j, token, "type");
    for (size_t i = 0; i < sizeof types / sizeof types[0]; ++i)
        if (json_is(&g->j, type, types[i].name))
            return types + i;
    reader_fail_at(g->r, gltf_path(g, token),
                   "its type is none of SCALAR, VEC2, VEC3, VEC4 and MAT4");
    return NULL;
}

bool gltf_read_accessor(gltf *g, uint32_t index, gltf_accessor *a)
{
    uint64_t count = 0, component_type = 0;
    memset(a, 0, sizeof *a);
    a->token = gltf_element(g, GLTF_ACCESSORS, index);
    const element_type *const type = type_of(g, a->token);
    if (type == NULL || !gltf_integer(g, a->token, "count", UINT32_MAX, &count) ||
        !gltf_integer(g, a->token, "componentType", UINT32_MAX, &component_type) ||
        !gltf_boolean(g, a->token, "normalized", &a->is_normalized))
        return false;
    a->component_type = (uint32_t)component_type;
    const size_t size = gltf_component_size(a->component_type);
    if (count == 0)
        return reader_fail_at(g->r, gltf_path(g, a->token), "has no elements");
    if (size == 0)
        return reader_fail_at(g->r, gltf_path(g, a->token), "componentType is %llu, which is none",
                              (unsigned long long)component_type);
    a->count = (uint32_t)count;
    a->components = type->components;
    a->is_normalized = a->is_normalized && size < 4;
    const size_t element = a->components * size;
    a->stride = element;
    if (json_member(&g->j, a->token, "bufferView") != JSON_NONE &&
        !find_elements(g, a->token, count, element, true, &a->bytes, &a->stride))
        return false;
    return read_sparse(g, a, element);
}

bool gltf_has_bytes(gltf *g, uint32_t token, const gltf_accessor *a)
{
    const uint32_t most = 1U << 16;
    return a->bytes != NULL || a->count <= most ||
           reader_fail_at(g->r, gltf_path(g, token),
                          "has %u elements without a bufferView; at most %u are read",
                          (unsigned)a->count, (unsigned)most);
}

static int32_t signed_of(uint32_t value, uint32_t bits)
{
    return value < 1U << (bits - 1) ? (int32_t)value : (int32_t)value - (1 << bits);
}

/* Converts an element (section 3.6.2.2, "normalized"). */
static void convert(const gltf_accessor *a, const uint8_t *bytes, float *values)
{
    const float most = a->component_type == GLTF_I8    ? 127.0f
                       : a->component_type == GLTF_U8  ? 255.0f
                       : a->component_type == GLTF_I16 ? 32767.0f
                                                       : 65535.0f;
    for (uint32_t c = 0; c < a->components; ++c) {
        switch (a->component_type) {
        case GLTF_I8:
            values[c] = (float)signed_of(bytes[c], 8);
            break;
        case GLTF_U8:
            values[c] = (float)bytes[c];
            break;
        case GLTF_I16:
            values[c] = (float)signed_of(integer_at(bytes + 2 * (size_t)c, GLTF_U16), 16);
            break;
        case GLTF_U16:
            values[c] = (float)integer_at(bytes + 2 * (size_t)c, GLTF_U16);
            break;
        case GLTF_U32:
            values[c] = (float)integer_at(bytes + 4 * (size_t)c, GLTF_U32);
            break;
        default:
            values[c] = reader_float(bytes + 4 * (size_t)c);
            break;
        }
        if (a->is_normalized) {
            values[c] /= most;
            if (values[c] < -1.0f)
                values[c] = -1.0f;
        }
    }
}

/* The bytes of an element that replaces another, or null. */
static const uint8_t *replacement(const gltf_accessor *a, uint32_t element)
{
    const size_t size = gltf_component_size(a->sparse_type);
    uint32_t low = 0, high = a->sparse_count;
    while (low < high) {
        const uint32_t middle = low + (high - low) / 2;
        const uint32_t index = integer_at(a->sparse_indices + middle * size, a->sparse_type);
        if (index == element)
            return a->sparse_values +
                   (size_t)middle * a->components * gltf_component_size(a->component_type);
        if (index < element)
            low = middle + 1;
        else
            high = middle;
    }
    return NULL;
}

static const uint8_t *element_at(const gltf_accessor *a, uint32_t element)
{
    const uint8_t *const other = a->sparse_count > 0 ? replacement(a, element) : NULL;
    if (other != NULL)
        return other;
    return a->bytes != NULL ? a->bytes + element * a->stride : NULL;
}

void gltf_floats(const gltf_accessor *a, const uint32_t *which, uint32_t first, uint32_t count,
                 float *values)
{
    for (uint32_t i = 0; i < count; ++i, values += a->components) {
        const uint8_t *const bytes = element_at(a, which != NULL ? which[i] : first + i);
        if (bytes == NULL)
            memset(values, 0, a->components * sizeof *values);
        else if (a->component_type == GLTF_F32 && a->components == 3)
            for (size_t c = 0; c < 3; ++c)
                values[c] = reader_float(bytes + 4 * c);
        else
            convert(a, bytes, values);
    }
}

void gltf_integers(const gltf_accessor *a, uint32_t first, uint32_t count, uint32_t *values)
{
    for (uint32_t i = 0; i < count; ++i) {
        const uint8_t *const bytes = element_at(a, first + i);
        values[i] = bytes != NULL ? integer_at(bytes, a->component_type) : 0;
    }
}
