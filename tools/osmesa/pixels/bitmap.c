/* glBitmap (OpenGL 2.1 section 3.7). */
#include <gl_registry.h>
#include <math.h>
#include <string.h>

#include "../vertices/buffer_objects.h"
#include "../context/gl_context.h"
#include "../context/gl_errors.h"
#include "pixel_format.h"
#include "pixel_rectangle.h"
#include "../render_mode/feedback.h"

/* Writes a byte, 0 or 255, for each bit of a bitmap in the program's memory. */
static void unpack_bits(const pixel_store *store, const unsigned char *from, size_t row_stride,
                        GLsizei width, GLsizei height, unsigned char *to)
{
    const unsigned first = (unsigned)store->skip_pixels % 8;

    for (GLsizei y = 0; y < height; ++y, from += row_stride) {
        for (GLsizei x = 0; x < width; ++x) {
            const unsigned bit = first + (unsigned)x;
            const unsigned place = store->lsb_first ? bit % 8 : 7 - bit % 8;

            *to++ = from[bit / 8] >> place & 1u ? 255 : 0;
        }
    }
}

/* Returns the first pixel of a bitmap from where it is drawn. As in the reference, a place just
 * below a whole pixel counts as that pixel. */
static GLfloat first_pixel(GLfloat position, GLfloat origin)
{
    return floorf(position + 0.0001f - origin);
}

static void draw_bits(context *gl, GLsizei width, GLsizei height, GLfloat x_origin,
                      GLfloat y_origin, const GLubyte *bitmap, const char *function)
{
    const raster_position_state *const r = &gl->raster_position;
    const size_t stride = pixel_row_stride(&gl->unpack, width, 1, GL_BITMAP);
    const size_t skip = pixel_skip(&gl->unpack, width, 1, GL_BITMAP);
    const size_t last = ((size_t)gl->unpack.skip_pixels % 8 + (size_t)width + 7) / 8;
    const unsigned char *const bits =
        unpacked_pixels(gl, bitmap, skip + (size_t)(height - 1) * stride + last, function);
    pixel_rectangle rectangle = {
        .kind = RECTANGLE_BITS,
        .x = first_pixel(r->position[0], x_origin),
        .y = first_pixel(r->position[1], y_origin),
        .zoom_x = 1.0f,
        .zoom_y = 1.0f,
        .z = r->position[2],
        .width = width,
        .height = height,
        .format = GN_FORMAT_R8,
    };
    unsigned char *const pixels =
        bits ? scratch_memory(gl, &gl->pixels, (size_t)width * (size_t)height, function) : NULL;

    if (!pixels)
        return;
    unpack_bits(&gl->unpack, bits + skip, stride, width, height, pixels);
    rectangle.pixels = pixels;
    memcpy(rectangle.color, r->color, sizeof rectangle.color);
    draw_pixel_rectangle(gl, &rectangle, function);
}

void glBitmap(GLsizei width, GLsizei height, GLfloat x_origin, GLfloat y_origin, GLfloat x_move,
              GLfloat y_move, const GLubyte *bitmap)
{
    context *const gl = enter(__func__);

    if (!gl)
        return;
    if (width < 0 || height < 0) {
        gl_error(gl, GL_INVALID_VALUE, __func__);
        return;
    }
    if (!gl->raster_position.is_valid)
        return;
    feed_raster_position(gl, GL_BITMAP_TOKEN);
    if (gl->render_mode == GL_RENDER && width > 0 && height > 0 &&
        (bitmap || gl->arrays.unpack_buffer))
        draw_bits(gl, width, height, x_origin, y_origin, bitmap, __func__);
    gl->raster_position.position[0] += x_move;
    gl->raster_position.position[1] += y_move;
}
