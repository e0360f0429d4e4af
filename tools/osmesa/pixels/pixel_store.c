/* glPixelStore (OpenGL 2.1 sections 3.6.1 and 4.3.2). */
#include <gl_registry.h>

#include "../context/gl_context.h"
#include "../context/gl_errors.h"

/* Returns where a number is kept, null for a name that is none. */
static GLint *find_number(context *gl, GLenum name)
{
    switch (name) {
    case GL_PACK_ROW_LENGTH:
        return &gl->pack.row_length;
    case GL_PACK_IMAGE_HEIGHT:
        return &gl->pack.image_height;
    case GL_PACK_SKIP_PIXELS:
        return &gl->pack.skip_pixels;
    case GL_PACK_SKIP_ROWS:
        return &gl->pack.skip_rows;
    case GL_PACK_SKIP_IMAGES:
        return &gl->pack.skip_images;
    case GL_UNPACK_ROW_LENGTH:
        return &gl->unpack.row_length;
    case GL_UNPACK_IMAGE_HEIGHT:
        return &gl->unpack.image_height;
    case GL_UNPACK_SKIP_PIXELS:
        return &gl->unpack.skip_pixels;
    case GL_UNPACK_SKIP_ROWS:
        return &gl->unpack.skip_rows;
    case GL_UNPACK_SKIP_IMAGES:
        return &gl->unpack.skip_images;
    default:
        return NULL;
    }
}

void glPixelStorei(GLenum name, GLint value)
{
    context *const gl = enter(__func__);
    GLint *const number = gl ? find_number(gl, name) : NULL;

    if (!gl)
        return;
    if (number) {
        if (value < 0)
            gl_error(gl, GL_INVALID_VALUE, __func__);
        else
            *number = value;
        return;
    }
    switch (name) {
    case GL_PACK_SWAP_BYTES:
        gl->pack.swap_bytes = value != 0;
        break;
    case GL_PACK_LSB_FIRST:
        gl->pack.lsb_first = value != 0;
        break;
    case GL_UNPACK_SWAP_BYTES:
        gl->unpack.swap_bytes = value != 0;
        break;
    case GL_UNPACK_LSB_FIRST:
        gl->unpack.lsb_first = value != 0;
        break;
    case GL_PACK_ALIGNMENT:
    case GL_UNPACK_ALIGNMENT:
        if (value != 1 && value != 2 && value != 4 && value != 8)
            gl_error(gl, GL_INVALID_VALUE, __func__);
        else if (name == GL_PACK_ALIGNMENT)
            gl->pack.alignment = value;
        else
            gl->unpack.alignment = value;
        break;
    default:
        gl_error(gl, GL_INVALID_ENUM, __func__);
    }
}

void glPixelStoref(GLenum name, GLfloat value)
{
    const GLfloat rounded = value >= 0.0f ? value + 0.5f : value - 0.5f;

    glPixelStorei(name, !(rounded > -2147483648.0f) ? INT32_MIN
                        : rounded >= 2147483648.0f  ? INT32_MAX
                                                    : (GLint)rounded);
}
