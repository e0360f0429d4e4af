/* Converts depths between the program's types and texels. */
#include "depth_texel.h"

#include <gl_registry.h>
#include <string.h>

#include "../pixels/depth_stencil.h"
#include "../pixels/half_float.h"
#include "../pixels/pixel_format.h"
#include "../pixels/pixel_transfer.h"
#include "texel_format.h"

enum { BYTES_24 = 0xFFFFFF };

/* Reads an element as a depth, which floats and signed integers may have beyond 0 to 1. */
static GLfloat read_any_depth(const unsigned char *element, GLenum type)
{
    uint32_t four;

    if (type == GL_UNSIGNED_INT_24_8) {
        memcpy(&four, element, sizeof four);
        return (GLfloat)(four >> 8) / (GLfloat)BYTES_24;
    }
    if (type == GL_UNSIGNED_INT) {
        memcpy(&four, element, sizeof four);
        return (GLfloat)(four * (1.0 / 4294967295.0));
    }
    if (type == GL_UNSIGNED_BYTE)
        return (GLfloat)element[0] / 255.0f;
    return read_element(element, type == GL_FLOAT_32_UNSIGNED_INT_24_8_REV ? GL_FLOAT : type);
}

static GLfloat read_depth(const unsigned char *element, GLenum type)
{
    const GLfloat depth = read_any_depth(element, type);

    return depth > 0.0f ? depth < 1.0f ? depth : 1.0f : 0.0f;
}

/* Depths are truncated. Integers of the same or of more bits are cut, but not 32 bits to 24: those
 * pass through a float. */
static uint32_t integer_depth(const unsigned char *element, GLenum type, uint32_t most)
{
    uint32_t four = 0;
    uint16_t two;

    if (type == GL_UNSIGNED_SHORT && most == 0xFFFF) {
        memcpy(&two, element, sizeof two);
        return two;
    }
    if (type == GL_UNSIGNED_INT || type == GL_UNSIGNED_INT_24_8)
        memcpy(&four, element, sizeof four);
    if (type == GL_UNSIGNED_INT && most == 0xFFFF)
        return four >> 16;
    if (type == GL_UNSIGNED_INT_24_8 && most == BYTES_24)
        return four >> 8;
    return (uint32_t)(read_depth(element, type) * (GLfloat)most);
}

/* Returns a depth of 32 bits as the reference reads it: the highest 23 of them. */
static GLfloat fixed_depth(const unsigned char *element, GLenum type)
{
    static const GLfloat scale = 8388608.0f / 8388607.0f;
    uint32_t four;
    uint16_t two;

    if (type == GL_UNSIGNED_INT) {
        memcpy(&four, element, sizeof four);
    } else if (type == GL_UNSIGNED_SHORT) {
        memcpy(&two, element, sizeof two);
        four = (uint32_t)two << 16 | two;
    } else {
        four = (uint32_t)((GLdouble)read_depth(element, type) * 4294967295.0);
    }
    return (GLfloat)(four >> 9) / 8388608.0f * scale;
}

void put_depth(const unsigned char *element, GLenum type, bool swaps_bytes, const context *transfer,
               const texture_image *image, unsigned char *texel)
{
    unsigned char own[8] = {0}, stencil;
    uint32_t four;
    uint16_t two;
    GLfloat depth;

    memcpy(own, element, pixel_element_size(type));
    if (swaps_bytes)
        swap_elements(own, 1, type);
    memcpy(&four, type == GL_FLOAT_32_UNSIGNED_INT_24_8_REV ? own + 4 : own, sizeof four);
    stencil = (unsigned char)four;
    if (transfer) {
        depth = transfer_depth(transfer, read_any_depth(own, type));
        memcpy(own, &depth, sizeof depth);
    }
    const GLenum own_type = transfer ? GL_FLOAT : type;

    switch (image->format) {
    case GN_FORMAT_D16:
        two = (uint16_t)integer_depth(own, own_type, 0xFFFF);
        memcpy(texel, &two, sizeof two);
        break;
    case GN_FORMAT_D24:
    case GN_FORMAT_D24S8:
        four = integer_depth(own, own_type, BYTES_24);
        if (image->format == GN_FORMAT_D24S8 && is_depth_stencil_type(type))
            four |= (uint32_t)stencil << 24;
        memcpy(texel, &four, sizeof four);
        break;
    default:
        depth = image->is_fixed_depth ? fixed_depth(own, own_type) : read_depth(own, own_type);
        memcpy(texel, &depth, sizeof depth);
        if (image->format == GN_FORMAT_D32FS8 && is_depth_stencil_type(type))
            texel[4] = stencil;
    }
}

/* Returns a texel as a fraction. */
static GLfloat depth_of(const unsigned char *texel, gn_format format)
{
    uint32_t four;
    uint16_t two;
    GLfloat depth;

    switch (format) {
    case GN_FORMAT_D16:
        memcpy(&two, texel, sizeof two);
        return (GLfloat)two * (1.0f / 65535.0f);
    case GN_FORMAT_D24:
    case GN_FORMAT_D24S8:
        memcpy(&four, texel, sizeof four);
        return (GLfloat)((four & BYTES_24) * (1.0 / BYTES_24));
    default:
        memcpy(&depth, texel, sizeof depth);
        return depth;
    }
}

static uint32_t stencil_of(const unsigned char *texel, gn_format format)
{
    uint32_t four;

    memcpy(&four, format == GN_FORMAT_D32FS8 ? texel + 4 : texel, sizeof four);
    return format == GN_FORMAT_D24S8 ? four >> 24 : format == GN_FORMAT_D32FS8 ? four & 0xFF : 0;
}

void get_depth(const unsigned char *texel, gn_format format, GLenum type, unsigned char *element)
{
    const GLfloat depth = depth_of(texel, format);
    uint32_t four = 0;

    if (type == GL_UNSIGNED_INT && (format == GN_FORMAT_D24 || format == GN_FORMAT_D24S8)) {
        memcpy(&four, texel, sizeof four);
        four = four << 8 | (four >> 16 & 0xFF);
        memcpy(element, &four, sizeof four);
    } else if (type == GL_UNSIGNED_INT_24_8) {
        if (format == GN_FORMAT_D24 || format == GN_FORMAT_D24S8) {
            memcpy(&four, texel, sizeof four);
            four = four << 8 | (format == GN_FORMAT_D24S8 ? four >> 24 : 0);
        } else {
            four = (uint32_t)(depth * (GLfloat)BYTES_24) << 8 | stencil_of(texel, format);
        }
        memcpy(element, &four, sizeof four);
    } else if (type == GL_FLOAT_32_UNSIGNED_INT_24_8_REV) {
        four = stencil_of(texel, format);
        memcpy(element, &depth, sizeof depth);
        memcpy(element + sizeof depth, &four, sizeof four);
    } else {
        pack_depth(element, depth, type);
    }
}
