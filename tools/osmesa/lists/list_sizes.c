/* How long what the pointers of recorded calls refer to is. */
#include <gl_registry.h>

#include "../vertices/buffer_objects.h"
#include "list_record.h"
#include "../pixels/pixel_format.h"

size_t parameter_count(GLenum name)
{
    switch (name) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_SPECULAR:
    case GL_EMISSION:
    case GL_AMBIENT_AND_DIFFUSE:
    case GL_POSITION:
    case GL_LIGHT_MODEL_AMBIENT:
    case GL_FOG_COLOR:
    case GL_TEXTURE_ENV_COLOR:
    case GL_TEXTURE_BORDER_COLOR:
    case GL_TEXTURE_SWIZZLE_RGBA:
    case GL_OBJECT_PLANE:
    case GL_EYE_PLANE:
        return 4;
    case GL_SPOT_DIRECTION:
    case GL_COLOR_INDEXES:
    case GL_POINT_DISTANCE_ATTENUATION:
        return 3;
    default:
        return 1;
    }
}

size_t name_bytes(GLsizei count, GLenum type)
{
    const size_t n = count < 0 ? 0 : (size_t)count;

    switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
        return n;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
    case GL_2_BYTES:
        return 2 * n;
    case GL_3_BYTES:
        return 3 * n;
    case GL_INT:
    case GL_UNSIGNED_INT:
    case GL_FLOAT:
    case GL_4_BYTES:
        return 4 * n;
    default:
        return 0;
    }
}

bool is_proxy(GLenum target)
{
    return target == GL_PROXY_TEXTURE_1D || target == GL_PROXY_TEXTURE_2D ||
           target == GL_PROXY_TEXTURE_3D || target == GL_PROXY_TEXTURE_CUBE_MAP;
}

/* Pixels */

static unsigned components_of(GLenum format)
{
    const pixel_format *const color = find_pixel_format(format);

    if (color)
        return color->components;
    return format == GL_COLOR_INDEX || format == GL_STENCIL_INDEX || format == GL_DEPTH_COMPONENT ||
                   format == GL_DEPTH_STENCIL
               ? 1
               : 0;
}

/* Bits from the first of `rows` rows to the end of the last. */
static size_t bits_of_rows(const pixel_store *store, GLsizei width, size_t rows)
{
    const size_t length = (size_t)(store->row_length > 0 ? store->row_length : width);
    const size_t alignment = (size_t)store->alignment, bytes = (length + 7) / 8;
    const size_t stride = (bytes + alignment - 1) / alignment * alignment;

    return ((size_t)store->skip_rows + rows - 1) * stride * 8 + (size_t)store->skip_pixels +
           (size_t)width;
}

size_t bitmap_bytes(GLsizei width, GLsizei height)
{
    const context *const gl = current_context();

    if (width <= 0 || height <= 0)
        return 0;
    return (bits_of_rows(&gl->unpack, width, (size_t)height) + 7) / 8;
}

size_t image_bytes(GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLenum type)
{
    const pixel_store *const store = &current_context()->unpack;
    const unsigned components = components_of(format);
    const size_t image_rows =
        (size_t)(store->image_height > 0 && depth > 1 ? store->image_height : height);
    size_t stride, images, skipped;

    if (width <= 0 || height <= 0 || depth <= 0)
        return 0;
    if (type == GL_BITMAP)
        return components == 1 ? bitmap_bytes(width, height) : 0;
    if (!components || (!is_pixel_type(type) && !is_depth_stencil_type(type)))
        return 0;
    stride = pixel_row_stride(store, width, components, type);
    skipped = pixel_skip(store, width, components, type);
    images = depth > 1 ? (size_t)store->skip_images + (size_t)depth - 1 : 0;
    return skipped + (images * image_rows + (size_t)height - 1) * stride +
           (size_t)width * pixel_size(components, type);
}

recorded_unpack current_unpack(void)
{
    return (recorded_unpack){current_context()->unpack, NULL, 0};
}

void swap_unpack(recorded_unpack *unpack)
{
    context *const gl = current_context();
    const recorded_unpack kept = {gl->unpack, gl->arrays.unpack_buffer,
                                  gl->arrays.unpack_buffer_name};

    gl->unpack = unpack->store;
    gl->arrays.unpack_buffer = unpack->buffer;
    gl->arrays.unpack_buffer_name = unpack->buffer_name;
    *unpack = kept;
}

void *record_image(const void *pixels, size_t size)
{
    const buffer_object *const buffer = current_context()->arrays.unpack_buffer;
    const size_t offset = (size_t)(uintptr_t)pixels;

    if (!buffer)
        return record_memory(pixels, size);
    if (!buffer->data || offset > (size_t)buffer->size || size > (size_t)buffer->size - offset)
        return NULL;
    return record_memory(buffer->data + offset, size);
}
