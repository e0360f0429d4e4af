/* Scenes with pixel transfer, rectangles of stencil, and copies within the window. */
#include "scene_parts.h"

enum { MOST_VALUES = 4096, MAP_SIZE = 256, MOST_PIXELS = 128 * 128 };

static void set_maps(const library *gl, random_source *r)
{
    static GLfloat values[MAP_SIZE];

    for (GLenum map = GL_PIXEL_MAP_R_TO_R; map <= GL_PIXEL_MAP_A_TO_A; ++map) {
        const GLsizei size =
            one_in(r, 2) ? 1 << random_below(r, 9) : random_between(r, 1, MAP_SIZE);

        for (GLsizei i = 0; i < size; ++i)
            values[i] = between(r, 0.0f, 1.0f);
        gl->PixelMapfv(map, size, values);
    }
    for (int i = 0; i < MAP_SIZE; ++i)
        values[i] = between(r, 0.0f, 300.0f);
    gl->PixelMapfv(GL_PIXEL_MAP_S_TO_S, 1 << random_below(r, 9), values);
}

/* With maps of colours, blue and alpha that the reference draws are those of another pixel: a
 * defect. */
static bool set_transfer(const library *gl, random_source *r)
{
    const bool maps_colors = one_in(r, 3);

    static const GLenum scales[] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE};
    static const GLenum biases[] = {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS};

    for (int c = 0; c < 4; ++c) {
        gl->PixelTransferf(scales[c], one_in(r, 2) ? 1.0f : between(r, 0.0f, 2.0f));
        gl->PixelTransferf(biases[c], one_in(r, 2) ? 0.0f : between(r, -0.5f, 0.5f));
    }
    gl->PixelTransferf(GL_DEPTH_SCALE, one_in(r, 2) ? 1.0f : between(r, 0.5f, 1.3f));
    gl->PixelTransferf(GL_DEPTH_BIAS, one_in(r, 2) ? 0.0f : between(r, -0.2f, 0.2f));
    gl->PixelTransferi(GL_INDEX_SHIFT, one_in(r, 2) ? 0 : random_between(r, -4, 4));
    gl->PixelTransferi(GL_INDEX_OFFSET, one_in(r, 2) ? 0 : random_between(r, -300, 300));
    gl->PixelTransferi(GL_MAP_COLOR, maps_colors);
    gl->PixelTransferi(GL_MAP_STENCIL, one_in(r, 3));
    set_maps(gl, r);
    return maps_colors;
}

static void reset_transfer(const library *gl)
{
    gl->PushAttrib(GL_PIXEL_MODE_BIT);
    for (GLenum name = GL_RED_SCALE; name <= GL_DEPTH_BIAS; ++name)
        if (name != GL_ZOOM_X && name != GL_ZOOM_Y)
            gl->PixelTransferf(name, (name - GL_RED_SCALE) % 2 ? 0.0f : 1.0f);
    gl->PixelTransferf(GL_RED_SCALE, 1.0f);
    gl->PixelTransferf(GL_RED_BIAS, 0.0f);
    gl->PixelTransferi(GL_INDEX_SHIFT, 0);
    gl->PixelTransferi(GL_INDEX_OFFSET, 0);
    gl->PixelTransferi(GL_MAP_COLOR, 0);
    gl->PixelTransferi(GL_MAP_STENCIL, 0);
}

static void set_zoom(const library *gl, random_source *r)
{
    if (one_in(r, 2))
        gl->PixelZoom(1.0f, 1.0f);
    else
        gl->PixelZoom(between(r, -2.0f, 3.0f), between(r, -2.0f, 3.0f));
}

/* A rectangle of random colours, depths or stencil of random types. */
static void draw_rectangle(const library *gl, random_source *r, int width, int height)
{
    static GLubyte bytes[16 * MOST_VALUES];
    static GLfloat floats[MOST_VALUES];
    const GLsizei columns = random_between(r, 0, 30), rows = random_between(r, 0, 24);
    const uint32_t kind = random_below(r, 4);

    fill_bytes(r, bytes, sizeof bytes);
    for (uint32_t i = 0; i < MOST_VALUES; ++i)
        floats[i] = kind == 2 ? between(r, -2.0f, 300.0f) : between(r, -0.1f, 1.1f);
    gl->WindowPos3f(between(r, -9.0f, (float)width), between(r, -9.0f, (float)height), 0.5f);
    set_zoom(gl, r);
    if (kind == 0 && one_in(r, 2))
        gl->DrawPixels(columns, rows, GL_RGBA, GL_FLOAT, floats);
    else if (kind == 0)
        gl->DrawPixels(columns, rows, PICK(r, GL_RGBA, GL_BGRA, GL_LUMINANCE, GL_RGB, GL_ALPHA),
                       GL_UNSIGNED_BYTE, bytes);
    else if (kind == 1 && one_in(r, 2))
        gl->DrawPixels(columns, rows, GL_DEPTH_COMPONENT, GL_FLOAT, floats);
    else if (kind == 1)
        gl->DrawPixels(columns, rows, GL_DEPTH_COMPONENT,
                       PICK(r, GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT), bytes);
    else if (kind == 2 && one_in(r, 3))
        gl->DrawPixels(columns, rows, GL_STENCIL_INDEX, GL_FLOAT, floats);
    else if (kind == 2)
        gl->DrawPixels(columns, rows, GL_STENCIL_INDEX,
                       PICK(r, GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT,
                            GL_SHORT, GL_INT),
                       bytes);
    else if (one_in(r, 2))
        gl->DrawPixels(columns, rows, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, bytes);
    else
        gl->DrawPixels(columns / 2, rows, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV,
                       floats);
    gl->Flush();
}

static void set_tests(const library *gl, random_source *r, int width, int height)
{
    if (one_in(r, 3)) {
        gl->Scissor(random_between(r, -10, width), random_between(r, -10, height),
                    random_between(r, 0, width), random_between(r, 0, height));
        gl->Enable(GL_SCISSOR_TEST);
    }
    if (one_in(r, 2))
        gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(PICK(r, GL_LESS, GL_GEQUAL, GL_ALWAYS, GL_NOTEQUAL));
    gl->DepthMask(!one_in(r, 4));
    if (one_in(r, 3))
        gl->StencilMask(random_below(r, 256));
    if (one_in(r, 3)) {
        gl->StencilFunc(PICK(r, GL_LESS, GL_GEQUAL, GL_ALWAYS), (GLint)random_below(r, 256), 255);
        if (one_in(r, 2))
            gl->StencilOp(GL_KEEP, GL_INCR, GL_INVERT);
        gl->Enable(GL_STENCIL_TEST);
    }
    if (one_in(r, 4))
        gl->ColorMask(one_in(r, 2), one_in(r, 2), one_in(r, 2), GL_TRUE);
}

void draw_transferred(const library *gl, random_source *r, int width, int height)
{
    const uint32_t rectangles = 1 + random_below(r, 4);
    bool maps_colors;

    clear_window(gl, r);
    maps_colors = set_transfer(gl, r);
    set_tests(gl, r, width, height);
    if (maps_colors)
        gl->ColorMask(GL_TRUE, GL_TRUE, GL_FALSE, GL_FALSE);
    for (uint32_t i = 0; i < rectangles; ++i)
        draw_rectangle(gl, r, width, height);
    reset_transfer(gl);
}

/* What is read under transfer becomes visible as colours. No colours as integers of 32 bits: of 1,
 * the reference makes 0. */
void draw_read_pixels(const library *gl, random_source *r, int width, int height)
{
    static GLubyte bytes[16 * MOST_PIXELS];
    const uint32_t reads = 1 + random_below(r, 4);

    clear_window(gl, r);
    for (int i = 0; i < 4; ++i)
        draw_rectangle(gl, r, width, height);
    set_transfer(gl, r);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (uint32_t i = 0; i < reads; ++i) {
        const GLsizei columns = random_between(r, 1, 40), rows = random_between(r, 1, 40);
        const GLenum format = PICK(r, GL_RGBA, GL_RGB, GL_BGRA, GL_LUMINANCE, GL_ALPHA,
                                   GL_DEPTH_COMPONENT, GL_STENCIL_INDEX, GL_DEPTH_STENCIL);
        const GLenum type =
            format == GL_DEPTH_STENCIL
                ? PICK(r, GL_UNSIGNED_INT_24_8, GL_FLOAT_32_UNSIGNED_INT_24_8_REV)
            : format == GL_DEPTH_COMPONENT || format == GL_STENCIL_INDEX
                ? PICK(r, GL_UNSIGNED_BYTE, GL_FLOAT, GL_SHORT, GL_UNSIGNED_INT, GL_INT)
                : PICK(r, GL_UNSIGNED_BYTE, GL_FLOAT, GL_UNSIGNED_SHORT, GL_BYTE, GL_SHORT);

        for (int b = 0; b < 16 * 1600; ++b)
            bytes[b] = 0;
        gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
        gl->ReadPixels(random_between(r, 0, width - 1), random_between(r, 0, height - 1), columns,
                       rows, format, type, bytes);
        reset_transfer(gl);
        gl->WindowPos3f(between(r, 0.0f, (float)width), between(r, 0.0f, (float)height), 0.5f);
        gl->PixelZoom(1.0f, 1.0f);
        gl->DrawPixels(40, rows, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
        gl->Flush();
        gl->PopAttrib();
    }
    reset_transfer(gl);
}

/* Textures whose images are transferred, or copied under transfer. */
void draw_transferred_textures(const library *gl, random_source *r, int width, int height)
{
    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    set_transfer(gl, r);
    set_texture(gl, r);
    reset_transfer(gl);
    draw_textured_vertices(gl, r, false, false);
}

void draw_copies(const library *gl, random_source *r, int width, int height)
{
    const uint32_t copies = 1 + random_below(r, 4);
    bool maps_colors = false;

    clear_window(gl, r);
    for (int i = 0; i < 4; ++i)
        draw_rectangle(gl, r, width, height);
    if (one_in(r, 2))
        maps_colors = set_transfer(gl, r);
    set_tests(gl, r, width, height);
    if (maps_colors)
        gl->ColorMask(GL_TRUE, GL_TRUE, GL_FALSE, GL_FALSE);
    if (!maps_colors && one_in(r, 3)) {
        gl->AlphaFunc(PICK(r, GL_LESS, GL_GREATER), between(r, 0.0f, 1.0f));
        gl->Enable(GL_ALPHA_TEST);
    }
    if (!maps_colors && one_in(r, 3)) {
        gl->BlendFunc(PICK(r, GL_ONE, GL_SRC_ALPHA), PICK(r, GL_ZERO, GL_ONE));
        gl->Enable(GL_BLEND);
    }
    for (uint32_t i = 0; i < copies; ++i) {
        const int x = random_between(r, 0, width - 1), y = random_between(r, 0, height - 1);

        set_color(gl, r);
        gl->WindowPos3f(between(r, -9.0f, (float)width), between(r, -9.0f, (float)height),
                        between(r, 0.0f, 1.0f));
        set_zoom(gl, r);
        gl->CopyPixels(x, y, random_between(r, 0, width - x), random_between(r, 0, height - y),
                       PICK(r, GL_COLOR, GL_COLOR, GL_DEPTH, GL_STENCIL, GL_DEPTH_STENCIL));
        gl->Flush();
    }
    reset_transfer(gl);
}
