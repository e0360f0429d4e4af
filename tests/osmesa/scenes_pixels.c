/* Scenes with raster positions, bitmaps and rectangles of pixels. */
#include "scene_parts.h"

enum { MOST_BYTES = 4096 };

static void fill(random_source *r, GLubyte *bytes, uint32_t count)
{
    for (uint32_t i = 0; i < count; ++i)
        bytes[i] = (GLubyte)random_below(r, 256);
}

/* Where the program's pixels lie in its memory. */
static void set_unpacking(const library *gl, random_source *r)
{
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1 << random_below(r, 4));
    gl->PixelStorei(GL_UNPACK_ROW_LENGTH, one_in(r, 2) ? 0 : random_between(r, 20, 32));
    gl->PixelStorei(GL_UNPACK_SKIP_PIXELS, one_in(r, 2) ? 0 : random_between(r, 0, 11));
    gl->PixelStorei(GL_UNPACK_SKIP_ROWS, one_in(r, 2) ? 0 : random_between(r, 0, 3));
    gl->PixelStorei(GL_UNPACK_LSB_FIRST, one_in(r, 3));
    gl->PixelStorei(GL_UNPACK_SWAP_BYTES, one_in(r, 4));
}

/* A raster position in the window, or by the matrices. */
static void set_position(const library *gl, random_source *r, int width, int height)
{
    const float x = between(r, -1.0f, 1.0f), y = between(r, -1.0f, 1.0f);
    const float z = between(r, -0.6f, 0.6f);

    set_color(gl, r);
    switch (random_below(r, 5)) {
    case 0:
        gl->WindowPos2i(random_between(r, -9, width), random_between(r, -9, height));
        break;
    case 1: {
        const float column = between(r, -9.0f, (float)width);
        const float row = between(r, -9.0f, (float)height);

        gl->WindowPos3f(column, row, z + 0.5f);
        break;
    }
    case 2:
        gl->RasterPos2f(x, y);
        break;
    case 3:
        gl->RasterPos4f(x, y, z, between(r, 0.7f, 1.3f));
        break;
    default:
        gl->RasterPos3f(x, y, z);
    }
}

/* State of fragments. No fog with lights: in one scene of some hundreds the reference then draws
 * nothing, for a reason that is not known. */
static void set_fragment_state(const library *gl, random_source *r, int width, int height)
{
    const int x = random_between(r, -10, width), y = random_between(r, -10, height);

    if (one_in(r, 3)) {
        gl->Scissor(x, y, random_between(r, 0, width), random_between(r, 0, height));
        gl->Enable(GL_SCISSOR_TEST);
    }
    if (one_in(r, 2))
        gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(PICK(r, GL_LESS, GL_GEQUAL, GL_ALWAYS, GL_NOTEQUAL));
    if (one_in(r, 3)) {
        gl->AlphaFunc(PICK(r, GL_LESS, GL_GREATER), between(r, 0.0f, 1.0f));
        gl->Enable(GL_ALPHA_TEST);
    }
    if (one_in(r, 3)) {
        gl->StencilFunc(PICK(r, GL_LESS, GL_GEQUAL, GL_ALWAYS), (GLint)random_below(r, 256), 255);
        gl->StencilOp(GL_KEEP, GL_INCR, GL_INVERT);
        gl->Enable(GL_STENCIL_TEST);
    }
    if (one_in(r, 3)) {
        const GLboolean red = one_in(r, 2), green = one_in(r, 2);

        gl->ColorMask(red, green, one_in(r, 2), GL_TRUE);
    }
    if (one_in(r, 3)) {
        gl->BlendFunc(PICK(r, GL_ONE, GL_SRC_ALPHA, GL_DST_COLOR),
                      PICK(r, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA, GL_ONE));
        gl->Enable(GL_BLEND);
    }
    if (one_in(r, 5))
        gl->DepthRange((GLdouble)between(r, 0.0f, 1.0f), 0.7);
    if (one_in(r, 5) && !gl->IsEnabled(GL_LIGHTING)) {
        const float color[4] = {0.3f, 0.7f, 0.1f, 0.5f};

        gl->Fogfv(GL_FOG_COLOR, color);
        gl->Enable(GL_FOG);
    }
    if (one_in(r, 5))
        gl->Enable(GL_COLOR_SUM);
    if (one_in(r, 5))
        gl->Enable(GL_CULL_FACE);
}

void draw_bitmaps(const library *gl, random_source *r, int width, int height)
{
    static GLubyte bytes[MOST_BYTES];
    const uint32_t bitmaps = 1 + random_below(r, 5);

    clear_window(gl, r);
    set_matrices(gl, r);
    if (one_in(r, 2))
        set_lit_state(gl, r);
    set_fragment_state(gl, r, width, height);
    fill(r, bytes, MOST_BYTES);
    for (uint32_t i = 0; i < bitmaps; ++i) {
        const float x_origin = one_in(r, 2) ? 0.0f : between(r, -3.0f, 9.0f);
        const float x_move = between(r, -9.0f, 20.0f), y_move = between(r, -9.0f, 9.0f);
        const GLsizei columns = random_between(r, 0, 40), rows = random_between(r, 0, 24);

        set_unpacking(gl, r);
        if (i == 0 || one_in(r, 2))
            set_position(gl, r, width, height);
        gl->Bitmap(columns, rows, x_origin, one_in(r, 2) ? 0.0f : 2.5f, x_move, y_move, bytes);
        gl->Flush();
    }
}

/* Colours in every format, of bytes and floats, and depths, with zooms. Without fog: the
 * reference's fog is that of other coordinates than the raster position's. */
void draw_pixels(const library *gl, random_source *r, int width, int height)
{
    static GLfloat floats[MOST_BYTES];
    static GLubyte bytes[4 * MOST_BYTES];
    const uint32_t rectangles = 1 + random_below(r, 4);

    clear_window(gl, r);
    set_matrices(gl, r);
    set_fragment_state(gl, r, width, height);
    gl->Disable(GL_FOG);
    fill(r, bytes, sizeof bytes);
    for (uint32_t i = 0; i < MOST_BYTES; ++i)
        floats[i] = between(r, -0.1f, 1.1f);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1 << random_below(r, 4));
    gl->PixelStorei(GL_UNPACK_SKIP_PIXELS, one_in(r, 2) ? 0 : random_between(r, 0, 5));
    for (uint32_t i = 0; i < rectangles; ++i) {
        const GLsizei columns = random_between(r, 0, 30), rows = random_between(r, 0, 24);
        const bool has_floats = one_in(r, 3), is_depth = one_in(r, 4);
        const GLenum format = PICK(r, GL_RGBA, GL_RGBA, GL_BGRA, GL_RGB, GL_LUMINANCE,
                                   GL_LUMINANCE_ALPHA, GL_ALPHA, GL_RED);
        const GLenum type = has_floats ? GL_FLOAT
                            : is_depth ? PICK(r, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT)
                                       : PICK(r, GL_UNSIGNED_BYTE, GL_BYTE);

        set_position(gl, r, width, height);
        if (one_in(r, 2))
            gl->PixelZoom(between(r, -2.0f, 3.0f), between(r, -2.0f, 3.0f));
        gl->DrawPixels(columns, rows, is_depth ? GL_DEPTH_COMPONENT : format, type,
                       has_floats ? (const void *)floats : bytes);
        gl->Flush();
    }
}
