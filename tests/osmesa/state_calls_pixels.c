/* Calls of raster positions, bitmaps and framebuffer objects with random arguments. */
#include "state_calls.h"

static GLenum framebuffer_target(GLint i)
{
    return i & 1    ? GL_FRAMEBUFFER
           : i & 2  ? GL_DRAW_FRAMEBUFFER
           : i & 12 ? GL_READ_FRAMEBUFFER
                    : 12345;
}

static GLenum attachment_name(GLint i)
{
    static const GLenum names[] = {GL_COLOR_ATTACHMENT0,        GL_COLOR_ATTACHMENT1,
                                   GL_DEPTH_ATTACHMENT,         GL_STENCIL_ATTACHMENT,
                                   GL_DEPTH_STENCIL_ATTACHMENT, GL_COLOR_ATTACHMENT0,
                                   GL_COLOR_ATTACHMENT9,        12345};

    return names[i & 7];
}

/* Names from GL_MAP_COLOR to GL_DEPTH_BIAS, zooms among them, and a wrong one. */
static GLenum transfer_name(GLint i)
{
    const GLenum name = GL_MAP_COLOR + (GLenum)((unsigned)i % 16u);

    return i & 0x100 ? name : GL_RED_SCALE + (GLenum)((unsigned)i % 15u);
}

static void set_map(const library *gl, const arguments *a)
{
    static GLuint integers[256];
    static GLushort shorts[256];
    static GLfloat floats[256];
    const GLenum map = GL_PIXEL_MAP_I_TO_I + (GLenum)((unsigned)a->i[0] % 11u);
    const GLsizei size = a->i[1] & 1 ? 1 << (a->i[1] >> 1 & 7) : a->i[1] >> 1 & 255;

    for (int i = 0; i < 256; ++i) {
        integers[i] = (GLuint)a->i[i % 4] * 16843009u;
        shorts[i] = (GLushort)((GLuint)a->i[i % 4] * 257u);
        floats[i] = a->f[i % 16];
    }
    if (a->i[2] & 1)
        gl->PixelMapfv(map, size, floats);
    else if (a->i[2] & 2)
        gl->PixelMapuiv(map, size, integers);
    else
        gl->PixelMapusv(map, size, shorts);
}

/* More bytes than a pattern has under any of the rows that are skipped. */
static const void *pattern_of(const arguments *a)
{
    static GLubyte bytes[1 << 17];

    for (size_t i = 0; i < sizeof bytes; ++i)
        bytes[i] = (GLubyte)(a->i[i % 4] + (GLint)i);
    return bytes;
}

bool has_little_storage(const library *gl, GLenum row_length, GLenum skip_rows, GLenum skip_pixels)
{
    GLint length, rows, pixels;

    gl->GetIntegerv(row_length, &length);
    gl->GetIntegerv(skip_rows, &rows);
    gl->GetIntegerv(skip_pixels, &pixels);
    return length <= 1000 && rows <= 100 && pixels <= 1000;
}

/* A framebuffer is drawn to within a call alone: of incomplete ones the reference remembers whether
 * they were of floats, which shows in what glGet clamps. */
void call_pixels(const library *gl, unsigned kind, const arguments *a)
{
    const GLfloat *const f = a->f;

    switch (kind) {
    case 0:
        gl->RasterPos2d(a->d[0], a->d[1]);
        break;
    case 1:
        gl->RasterPos3f(0.2f * f[0], 0.2f * f[1], 0.2f * f[2]);
        break;
    case 2:
        gl->RasterPos4f(f[0], f[1], f[2], 2.0f);
        break;
    case 3:
        gl->WindowPos2i(a->i[0], a->i[1]);
        break;
    case 4:
        gl->WindowPos3f(f[0], f[1], f[2]);
        break;
    case 5:
        gl->BindFramebuffer(a->i[0] & 7 ? GL_READ_FRAMEBUFFER : 12345, (GLuint)a->i[1] & 1);
        break;
    case 6:
        gl->BindRenderbuffer(a->i[0] & 15 ? GL_RENDERBUFFER : 12345, (GLuint)a->i[1] & 1);
        break;
    case 7:
        gl->RenderbufferStorageMultisample(a->i[0] & 15 ? GL_RENDERBUFFER : 12345, a->i[1] & 7,
                                           a->i[2] & 1   ? GL_RGBA8
                                           : a->i[2] & 2 ? GL_DEPTH24_STENCIL8
                                                         : a->e[0],
                                           a->i[3] & 31, a->i[3] >> 5 & 31);
        break;
    case 8:
        gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, (GLuint)a->i[3] >> 1 & 1);
        gl->FramebufferRenderbuffer(framebuffer_target(a->i[0]), attachment_name(a->i[1]),
                                    a->i[2] & 15 ? GL_RENDERBUFFER : 12345, (GLuint)a->i[3] & 1);
        gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        break;
    case 9:
        gl->ReadBuffer(a->i[0] & 1 ? attachment_name(a->i[1]) : a->e[0]);
        break;
    case 10:
        gl->ClipControl(a->i[0] & 1   ? GL_UPPER_LEFT
                        : a->i[0] & 2 ? GL_LOWER_LEFT
                                      : a->e[0],
                        a->i[1] & 1   ? GL_ZERO_TO_ONE
                        : a->i[1] & 2 ? GL_NEGATIVE_ONE_TO_ONE
                                      : a->e[1]);
        break;
    case 11: {
        const GLenum buffers[2] = {attachment_name(a->i[1]), attachment_name(a->i[2])};

        gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, (GLuint)a->i[3] & 1);
        gl->DrawBuffers(a->i[0] & 1 ? 1 : a->i[0] & 2 ? 2 : 0, buffers);
        gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        break;
    }
    case 12: {
        static const GLenum targets[] = {GL_TEXTURE_2D, GL_TEXTURE_2D,
                                         GL_TEXTURE_2D, GL_TEXTURE_1D,
                                         GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y,
                                         12345};

        const GLenum target = targets[(unsigned)a->i[2] % (sizeof targets / sizeof *targets)];
        const GLint level = (a->i[3] >> 3 & 31) - 1, layer = (a->i[3] >> 8 & 7) - 1;

        gl->BindTexture(GL_TEXTURE_2D, 1);
        gl->BindTexture(GL_TEXTURE_2D, 0);
        gl->BindTexture(GL_TEXTURE_3D, 2);
        gl->BindTexture(GL_TEXTURE_3D, 0);
        gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, (GLuint)a->i[3] >> 2 & 1);
        if (a->e[0] & 1)
            gl->FramebufferTexture2D(framebuffer_target(a->i[0]), attachment_name(a->i[1]), target,
                                     (GLuint)a->i[3] & 3, level);
        else if (a->e[0] & 2)
            gl->FramebufferTexture3D(framebuffer_target(a->i[0]), attachment_name(a->i[1]), target,
                                     (GLuint)a->i[3] & 3, level, layer);
        else
            gl->FramebufferTextureLayer(framebuffer_target(a->i[0]), attachment_name(a->i[1]),
                                        (GLuint)a->i[3] & 3, level, layer);
        gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        break;
    }
    case 13:
        gl->PixelZoom(f[0], f[1]);
        break;
    case 14: {
        static const GLenum formats[] = {
            GL_RGBA,          GL_RGB,           GL_BGRA, GL_LUMINANCE, GL_DEPTH_COMPONENT,
            GL_STENCIL_INDEX, GL_DEPTH_STENCIL, 12345};
        static const GLenum types[] = {GL_UNSIGNED_BYTE,
                                       GL_FLOAT,
                                       GL_UNSIGNED_SHORT,
                                       GL_UNSIGNED_SHORT_5_6_5,
                                       GL_HALF_FLOAT,
                                       GL_UNSIGNED_INT_24_8,
                                       GL_FLOAT_32_UNSIGNED_INT_24_8_REV,
                                       GL_INT,
                                       12345};

        gl->DrawPixels(a->i[0] > 200 ? -1 : 0, 1,
                       formats[(unsigned)a->i[1] % (sizeof formats / sizeof *formats)],
                       types[(unsigned)a->i[2] % (sizeof types / sizeof *types)], f);
        break;
    }
    case 15:
        gl->PixelTransferf(transfer_name(a->i[0]), a->i[1] & 3   ? f[0]
                                                   : a->i[1] & 4 ? f[0] * 1e30f
                                                                 : 0.0f);
        break;
    case 16:
        gl->PixelTransferi(transfer_name(a->i[0]), a->i[1]);
        break;
    case 17:
        set_map(gl, a);
        break;
    case 19:
        if (has_little_storage(gl, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS,
                               GL_UNPACK_SKIP_PIXELS))
            gl->PolygonStipple((const GLubyte *)pattern_of(a));
        break;
    case 18: {
        static const GLenum types[] = {GL_COLOR, GL_DEPTH, GL_STENCIL, GL_DEPTH_STENCIL, 12345};

        gl->CopyPixels(a->i[0], a->i[1], a->i[2] > 200 ? -1 : 0, 1, types[(unsigned)a->i[3] % 5]);
        break;
    }
    case 21:
        gl->ClearAccum(f[0], f[1], f[2], f[3]);
        break;
    case 22:
        gl->Accum(a->i[0] & 15 ? GL_ACCUM + (GLenum)((unsigned)a->i[1] % 5u) : a->e[0], f[0]);
        break;
    case 23:
        gl->Clear(a->i[0] & 7 ? GL_ACCUM_BUFFER_BIT : (GLbitfield)a->i[1]);
        break;
    default:
        gl->Bitmap(a->i[0] & 3, a->i[1] > 200 ? -1 : 0, f[0], f[1], f[2], f[3], NULL);
    }
}
