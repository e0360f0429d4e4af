/* The pattern of polygons (OpenGL 2.1 section 3.5.2), in the program's memory as a bitmap. */
#include <gl_registry.h>
#include <string.h>

#include "../context/gl_context.h"
#include "../pixels/pixel_format.h"
#include "../vertices/buffer_objects.h"

/* Where the bitmap's rows lie. */
typedef struct bitmap_rows {
    size_t skip, stride, size;
    unsigned first; /* bit of the first byte */
    bool lsb_first;
} bitmap_rows;

static bitmap_rows rows_of(const pixel_store *store)
{
    bitmap_rows rows = {.skip = pixel_skip(store, STIPPLE_SIZE, 1, GL_BITMAP),
                        .stride = pixel_row_stride(store, STIPPLE_SIZE, 1, GL_BITMAP),
                        .first = (unsigned)store->skip_pixels % 8,
                        .lsb_first = store->lsb_first};

    rows.size = rows.skip + (STIPPLE_SIZE - 1) * rows.stride + (rows.first + STIPPLE_SIZE + 7) / 8;
    return rows;
}

void glPolygonStipple(const GLubyte *pattern)
{
    context *const gl = enter(__func__);
    const unsigned char *bytes;
    bitmap_rows rows;

    if (!gl)
        return;
    rows = rows_of(&gl->unpack);
    bytes = unpacked_pixels(gl, pattern, rows.size, __func__);
    if (!bytes)
        return;
    for (int y = 0; y < STIPPLE_SIZE; ++y) {
        const unsigned char *const row = bytes + rows.skip + (size_t)y * rows.stride;

        gl->polygon_pattern[y] = 0;
        for (unsigned x = 0; x < STIPPLE_SIZE; ++x) {
            const unsigned bit = rows.first + x, place = rows.lsb_first ? bit % 8 : 7 - bit % 8;

            gl->polygon_pattern[y] |= (row[bit / 8] >> place & 1u) << x;
        }
    }
}

void glGetPolygonStipple(GLubyte *pattern)
{
    context *const gl = enter(__func__);
    unsigned char *bytes;
    bitmap_rows rows;

    if (!gl)
        return;
    rows = rows_of(&gl->pack);
    bytes = packed_pixels(gl, pattern, rows.size, __func__);
    for (int y = 0; bytes && y < STIPPLE_SIZE; ++y) {
        unsigned char *const row = bytes + rows.skip + (size_t)y * rows.stride;

        /* The reference clears the bits before and after the row in its bytes, too. */
        memset(row, 0, (rows.first + STIPPLE_SIZE + 7) / 8);
        for (unsigned x = 0; x < STIPPLE_SIZE; ++x) {
            const unsigned bit = rows.first + x, place = rows.lsb_first ? bit % 8 : 7 - bit % 8;

            row[bit / 8] |= (unsigned char)((gl->polygon_pattern[y] >> x & 1u) << place);
        }
    }
}
