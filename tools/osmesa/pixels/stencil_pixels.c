/* Reads stencil indices, with depths or without, and writes those that the masks leave. */
#include "stencil_pixels.h"

#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "../context/gl_errors.h"
#include "../framebuffer/framebuffer_view.h"
#include "../vertices/buffer_objects.h"
#include "half_float.h"
#include "pixel_format.h"
#include "pixel_rectangle.h"
#include "../render_mode/feedback.h"
#include "pixel_transfer.h"

/* Returns a float as an index; those that are none become 0. */
static unsigned index_of_float(GLfloat x)
{
    return x > -2147483648.0f && x < 4294967296.0f ? (unsigned)(GLint64)x : 0;
}

/* Reads an index of stencil. */
static unsigned read_index(const unsigned char *element, GLenum type, bool swaps_bytes)
{
    unsigned char own[4] = {0};
    GLushort two;
    GLuint four;
    GLfloat number;

    memcpy(own, element, pixel_element_size(type));
    if (swaps_bytes)
        swap_elements(own, 1, type);
    memcpy(&two, own, sizeof two);
    memcpy(&four, own, sizeof four);
    memcpy(&number, own, sizeof number);
    switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
        return own[0];
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
        return two;
    case GL_HALF_FLOAT:
        return index_of_float(float_of_half(two));
    case GL_FLOAT:
        return index_of_float(number);
    default:
        return four;
    }
}

static unsigned read_bit(const unsigned char *row, unsigned bit, bool lsb_first)
{
    return (unsigned)row[bit / 8] >> (lsb_first ? bit % 8 : 7 - bit % 8) & 1u;
}

/* Reads a depth with stencil. One of 24 bits that is transferred becomes 24 bits again by
 * truncation. */
static GLfloat read_depth(const context *gl, const unsigned char *element, GLenum type)
{
    const unsigned word = read_index(element, GL_UNSIGNED_INT, gl->unpack.swap_bytes);
    unsigned integer = word >> 8;
    GLfloat depth;

    if (type == GL_FLOAT_32_UNSIGNED_INT_24_8_REV) {
        memcpy(&depth, &word, sizeof depth);
        depth = transfers_depths(gl) ? transfer_depth(gl, depth) : depth;
        return depth > 0.0f ? depth < 1.0f ? depth : 1.0f : 0.0f;
    }
    if (transfers_depths(gl))
        integer =
            (unsigned)(transfer_depth(gl, (GLfloat)integer * (1.0f / 16777215.0f)) * 16777215.0f);
    return (GLfloat)integer * (1.0f / 16777215.0f);
}

/* Reads an index at a place of a row. One with a depth is in the last word. */
static unsigned index_at(const context *gl, const unsigned char *row, GLenum type, unsigned x)
{
    const size_t size = pixel_element_size(type);
    const unsigned char *const element = row + x * size;

    if (type == GL_BITMAP)
        return read_bit(row, (unsigned)gl->unpack.skip_pixels % 8 + x, gl->unpack.lsb_first);
    if (is_depth_stencil_type(type))
        return read_index(element + size - sizeof(uint32_t), GL_UNSIGNED_INT,
                          gl->unpack.swap_bytes) &
               0xFFu;
    return read_index(element, type, gl->unpack.swap_bytes);
}

/* Writes indices and depths as colours. As in the reference, shift and offset do not apply, and the
 * map does not apply to bytes, nor to depths of 24 bits with stencil unless they are transferred.
 */
static void unpack(const context *gl, const unsigned char *from, size_t row_stride, GLenum type,
                   GLsizei width, GLsizei height, GLfloat (*to)[4])
{
    const bool has_depth = is_depth_stencil_type(type);
    const bool maps =
        type == GL_UNSIGNED_INT_24_8 ? transfers_depths(gl) : type != GL_UNSIGNED_BYTE;

    for (GLsizei y = 0; y < height; ++y, from += row_stride) {
        for (GLsizei x = 0; x < width; ++x, ++to) {
            const unsigned index = index_at(gl, from, type, (unsigned)x);

            (*to)[0] = (GLfloat)(maps ? transfer_stencil(gl, index, false) : index & 0xFFu);
            (*to)[1] = has_depth ? read_depth(gl, from + (size_t)x * pixel_element_size(type), type)
                                 : 0.0f;
            (*to)[2] = 0.0f;
            (*to)[3] = 1.0f;
        }
    }
}

/* Returns the error of a format and a type, and of what the framebuffer lacks. */
static GLenum error_of(const framebuffer_view *view, GLenum format, GLenum type)
{
    if (format == GL_STENCIL_INDEX && (is_packed_type(type) || is_depth_stencil_type(type)))
        return GL_INVALID_OPERATION;
    if (format == GL_DEPTH_STENCIL ? !is_depth_stencil_type(type) : !is_pixel_type(type))
        return GL_INVALID_ENUM;
    return !view->bits[5] || (format == GL_DEPTH_STENCIL && !view->bits[4]) ? GL_INVALID_OPERATION
                                                                            : GL_NO_ERROR;
}

void draw_stencil_pixels(context *gl, GLsizei width, GLsizei height, GLenum format, GLenum type,
                         const void *pixels, const char *function)
{
    const size_t stride = pixel_row_stride(&gl->unpack, width, 1, type);
    const size_t skip = pixel_skip(&gl->unpack, width, 1, type);
    const size_t last = type == GL_BITMAP
                            ? ((size_t)gl->unpack.skip_pixels % 8 + (size_t)width + 7) / 8
                            : (size_t)width * pixel_element_size(type);
    pixel_rectangle rectangle = rectangle_at_raster_position(gl, RECTANGLE_STENCIL, width, height);
    const unsigned char *from;
    framebuffer_view view;
    GLfloat(*to)[4];
    GLenum error;

    if (!is_drawable_framebuffer(gl, &view, function))
        return;
    error = error_of(&view, format, type);
    if (error) {
        gl_error(gl, error, function);
        return;
    }
    if (!gl->raster_position.is_valid)
        return;
    feed_raster_position(gl, GL_DRAW_PIXEL_TOKEN);
    if (gl->render_mode != GL_RENDER || !width || !height)
        return;
    from = unpacked_pixels(gl, pixels, skip + (size_t)(height - 1) * stride + last, function);
    to = from ? scratch_memory(gl, &gl->pixels, (size_t)width * (size_t)height * sizeof *to,
                               function)
              : NULL;
    if (!to)
        return;
    unpack(gl, from + skip, stride, type, width, height, to);
    rectangle.pixels = to;
    rectangle.sets_depth = format == GL_DEPTH_STENCIL;
    draw_pixel_rectangle(gl, &rectangle, function);
}
