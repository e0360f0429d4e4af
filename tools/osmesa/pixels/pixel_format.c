/* The tables of formats and types, and the conversion of pixels to floats and back. */
#include "pixel_format.h"

#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "half_float.h"

static const pixel_format formats[] = {
    {GL_RED, 1, {0, 0, 0, 0}},
    {GL_GREEN, 1, {1, 0, 0, 0}},
    {GL_BLUE, 1, {2, 0, 0, 0}},
    {GL_ALPHA, 1, {3, 0, 0, 0}},
    {GL_RGB, 3, {0, 1, 2, 0}},
    {GL_BGR, 3, {2, 1, 0, 0}},
    {GL_RGBA, 4, {0, 1, 2, 3}},
    {GL_BGRA, 4, {2, 1, 0, 3}},
    {GL_ABGR_EXT, 4, {3, 2, 1, 0}},
    {GL_LUMINANCE, 1, {LUMINANCE_CHANNEL, 0, 0, 0}},
    {GL_LUMINANCE_ALPHA, 2, {LUMINANCE_CHANNEL, 3, 0, 0}},
};

/* Packed types: the bits of the components, the first of which is in the highest bits, or with
 * `reversed` in the lowest. */
typedef struct packed_type {
    GLenum name;
    unsigned char size, components;
    bool reversed;
    unsigned char bits[4];
} packed_type;

static const packed_type packed_types[] = {
    {GL_UNSIGNED_BYTE_3_3_2, 1, 3, false, {3, 3, 2, 0}},
    {GL_UNSIGNED_BYTE_2_3_3_REV, 1, 3, true, {3, 3, 2, 0}},
    {GL_UNSIGNED_SHORT_5_6_5, 2, 3, false, {5, 6, 5, 0}},
    {GL_UNSIGNED_SHORT_5_6_5_REV, 2, 3, true, {5, 6, 5, 0}},
    {GL_UNSIGNED_SHORT_4_4_4_4, 2, 4, false, {4, 4, 4, 4}},
    {GL_UNSIGNED_SHORT_4_4_4_4_REV, 2, 4, true, {4, 4, 4, 4}},
    {GL_UNSIGNED_SHORT_5_5_5_1, 2, 4, false, {5, 5, 5, 1}},
    {GL_UNSIGNED_SHORT_1_5_5_5_REV, 2, 4, true, {5, 5, 5, 1}},
    {GL_UNSIGNED_INT_8_8_8_8, 4, 4, false, {8, 8, 8, 8}},
    {GL_UNSIGNED_INT_8_8_8_8_REV, 4, 4, true, {8, 8, 8, 8}},
    {GL_UNSIGNED_INT_10_10_10_2, 4, 4, false, {10, 10, 10, 2}},
    {GL_UNSIGNED_INT_2_10_10_10_REV, 4, 4, true, {10, 10, 10, 2}},
};

static const packed_type *find_packed(GLenum type)
{
    for (size_t i = 0; i < sizeof packed_types / sizeof *packed_types; ++i)
        if (packed_types[i].name == type)
            return &packed_types[i];
    return NULL;
}

const pixel_format *find_pixel_format(GLenum name)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; ++i)
        if (formats[i].name == name)
            return &formats[i];
    return NULL;
}

bool is_packed_type(GLenum type)
{
    return find_packed(type) != NULL;
}

bool is_pixel_type(GLenum type)
{
    return (type >= GL_BYTE && type <= GL_FLOAT) || type == GL_HALF_FLOAT || type == GL_BITMAP ||
           is_packed_type(type);
}

bool is_depth_stencil_type(GLenum type)
{
    return type == GL_UNSIGNED_INT_24_8 || type == GL_FLOAT_32_UNSIGNED_INT_24_8_REV;
}

bool fits_type(const pixel_format *format, GLenum type)
{
    const packed_type *const packed = find_packed(type);

    if (!packed)
        return true;
    return packed->components == 3 ? format->name == GL_RGB : format->components == 4;
}

size_t pixel_element_size(GLenum type)
{
    const packed_type *const packed = find_packed(type);

    if (packed)
        return packed->size;
    switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
    case GL_BITMAP:
        return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
    case GL_HALF_FLOAT:
        return 2;
    case GL_FLOAT_32_UNSIGNED_INT_24_8_REV:
        return 8;
    default:
        return 4;
    }
}

size_t pixel_size(unsigned components, GLenum type)
{
    return pixel_element_size(type) * (is_packed_type(type) ? 1 : components);
}

size_t pixel_row_stride(const pixel_store *store, GLsizei width, unsigned components, GLenum type)
{
    const size_t pixels = (size_t)(store->row_length > 0 ? store->row_length : width);
    const size_t bytes =
        type == GL_BITMAP ? (pixels * components + 7) / 8 : pixels * pixel_size(components, type);
    const size_t alignment = (size_t)store->alignment;

    return (bytes + alignment - 1) / alignment * alignment;
}

size_t pixel_skip(const pixel_store *store, GLsizei width, unsigned components, GLenum type)
{
    return (size_t)store->skip_rows * pixel_row_stride(store, width, components, type) +
           (type == GL_BITMAP ? (size_t)store->skip_pixels / 8
                              : (size_t)store->skip_pixels * pixel_size(components, type));
}

void swap_elements(void *memory, size_t count, GLenum type)
{
    const size_t size = pixel_element_size(type);
    unsigned char *at = memory;

    if (type == GL_FLOAT_32_UNSIGNED_INT_24_8_REV) {
        swap_elements(memory, 2 * count, GL_UNSIGNED_INT);
        return;
    }

    for (size_t i = 0; size > 1 && i < count; ++i, at += size) {
        for (size_t low = 0, high = size - 1; low < high; ++low, --high) {
            const unsigned char byte = at[low];

            at[low] = at[high];
            at[high] = byte;
        }
    }
}

/* Returns the nearest integer of a fraction of `most`, halves to even; NaN becomes 0. */
static double unsigned_of(GLfloat x, double most)
{
    return !(x > 0.0f) ? 0.0 : x >= 1.0f ? most : nearbyint((double)x * most);
}

static double signed_of(GLfloat x, double most)
{
    return !(x > -1.0f) ? -most : x >= 1.0f ? most : nearbyint((double)x * most);
}

/* Integers of 32 bits: as in the reference, products of floats. */
static double wide_unsigned_of(GLfloat x)
{
    return !(x > 0.0f) ? 0.0 : x >= 1.0f ? 4294967295.0 : (double)rintf(x * 4294967296.0f);
}

static double wide_signed_of(GLfloat x)
{
    return !(x > -1.0f) ? -2147483647.0
           : x >= 1.0f  ? 2147483647.0
                        : (double)rintf(x * 2147483648.0f);
}

/* Writes each component as an integer of a type. */
#define PACK(type, value)                                                                          \
    for (size_t i = 0; i < count; ++i) {                                                           \
        const type x = (type)(value);                                                              \
        memcpy((unsigned char *)to + i * sizeof x, &x, sizeof x);                                  \
    }                                                                                              \
    break

void pack_components(void *to, const GLfloat *component, size_t count, GLenum type)
{
    switch (type) {
    case GL_UNSIGNED_BYTE:
        PACK(GLubyte, unsigned_of(component[i], 255.0));
    case GL_BYTE:
        PACK(GLbyte, signed_of(component[i], 127.0));
    case GL_UNSIGNED_SHORT:
        PACK(GLushort, unsigned_of(component[i], 65535.0));
    case GL_SHORT:
        PACK(GLshort, signed_of(component[i], 32767.0));
    case GL_UNSIGNED_INT:
        PACK(GLuint, wide_unsigned_of(component[i]));
    case GL_INT:
        PACK(GLint, wide_signed_of(component[i]));
    case GL_HALF_FLOAT:
        PACK(GLushort, half_of(component[i]));
    default:
        memcpy(to, component, count * sizeof *component);
    }
}

void pack_pixels(void *to, const GLfloat *component, size_t pixels, unsigned components,
                 GLenum type)
{
    const packed_type *const packed = find_packed(type);
    unsigned char *at = to;

    for (size_t i = 0; i < pixels; ++i, component += components, at += packed->size) {
        unsigned place = packed->reversed ? 0 : 8u * packed->size;
        uint32_t pixel = 0;

        for (unsigned c = 0; c < packed->components; ++c) {
            const unsigned bits = packed->bits[c];

            place -= packed->reversed ? 0 : bits;
            pixel |= (uint32_t)unsigned_of(component[c], (double)((1u << bits) - 1)) << place;
            place += packed->reversed ? bits : 0;
        }
        if (packed->size == 1) {
            *at = (unsigned char)pixel;
        } else if (packed->size == 2) {
            const uint16_t two = (uint16_t)pixel;

            memcpy(at, &two, sizeof two);
        } else {
            memcpy(at, &pixel, sizeof pixel);
        }
    }
}

void unpack_components(const unsigned char *element, GLenum type, GLfloat component[4])
{
    const packed_type *const packed = find_packed(type);
    unsigned place = packed->reversed ? 0 : 8u * packed->size;
    uint32_t pixel = 0;

    if (packed->size == 1) {
        pixel = element[0];
    } else if (packed->size == 2) {
        uint16_t two;

        memcpy(&two, element, sizeof two);
        pixel = two;
    } else {
        memcpy(&pixel, element, sizeof pixel);
    }
    for (unsigned c = 0; c < packed->components; ++c) {
        const unsigned bits = packed->bits[c];
        const uint32_t most = (1u << bits) - 1;
        uint32_t value;

        place -= packed->reversed ? 0 : bits;
        value = pixel >> place & most;
        place += packed->reversed ? bits : 0;
        if (bits < 8) {
            uint32_t repeated = value << (8 - bits);

            for (unsigned known = bits; known < 8; known *= 2)
                repeated |= repeated >> known;
            component[c] = (GLfloat)repeated / 255.0f;
        } else {
            component[c] = (GLfloat)value / (GLfloat)most;
        }
    }
}
