/* Scenes that are drawn to framebuffer objects, and blitted to the window. Colours are not encoded
 * as sRGB, in which the reference is a step off (reference/RULES.md). */
#include <stdlib.h>

#include "scene_parts.h"

enum { MOST_SIDE = 128, HASHES = 3 };

/* A framebuffer object with storage of its own. */
typedef struct framebuffer {
    GLuint name, color, depth;
    int width, height;
    bool has_depth, has_stencil;
} framebuffer;

static const GLenum depth_formats[] = {
    GL_NONE,          GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32F,
    GL_DEPTH_STENCIL, GL_DEPTH24_STENCIL8,  GL_DEPTH32F_STENCIL8, GL_STENCIL_INDEX8};

static bool is_in(GLenum value, const GLenum *list, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        if (list[i] == value)
            return true;
    return false;
}

/* Makes a framebuffer, and binds it. */
static framebuffer create_framebuffer(const library *gl, GLenum color, GLenum depth,
                                      GLsizei samples, int width, int height)
{
    framebuffer f = {.width = width, .height = height};

    f.has_depth = is_in(depth, depth_formats + 1, 6);
    f.has_stencil = is_in(depth, depth_formats + 4, 4);
    gl->GenFramebuffers(1, &f.name);
    gl->BindFramebuffer(GL_FRAMEBUFFER, f.name);
    gl->GenRenderbuffers(1, &f.color);
    gl->BindRenderbuffer(GL_RENDERBUFFER, f.color);
    gl->RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, color, width, height);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, f.color);
    if (depth == GL_NONE)
        return f;
    gl->GenRenderbuffers(1, &f.depth);
    gl->BindRenderbuffer(GL_RENDERBUFFER, f.depth);
    gl->RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, depth, width, height);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER,
                                f.has_depth && f.has_stencil ? GL_DEPTH_STENCIL_ATTACHMENT
                                : f.has_depth                ? GL_DEPTH_ATTACHMENT
                                                             : GL_STENCIL_ATTACHMENT,
                                GL_RENDERBUFFER, f.depth);
    return f;
}

static void delete_framebuffer(const library *gl, const framebuffer *f)
{
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl->DeleteFramebuffers(1, &f->name);
    gl->DeleteRenderbuffers(1, &f->color);
    gl->DeleteRenderbuffers(1, &f->depth);
}

static GLuint hash_of(const void *memory, size_t size)
{
    const unsigned char *const bytes = memory;
    GLuint hash = 2166136261u;

    for (size_t i = 0; i < size; ++i)
        hash = (hash ^ bytes[i]) * 16777619u;
    return hash ^ hash >> 15;
}

/* Shows a framebuffer in the window: its colours as a blit, and hashes of all its values as colours
 * of single pixels. */
static void show(const library *gl, const framebuffer *f, int width, int height)
{
    const size_t pixels = (size_t)f->width * (size_t)f->height;
    float *const values = calloc(pixels, sizeof(float[4]));
    GLuint hash[HASHES] = {0};

    gl->Disable(GL_SCISSOR_TEST);
    gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl->BindFramebuffer(GL_FRAMEBUFFER, f->name);
    gl->ReadPixels(0, 0, f->width, f->height, GL_RGBA, GL_FLOAT, values);
    hash[0] = hash_of(values, pixels * sizeof(float[4]));
    if (f->has_depth) {
        gl->ReadPixels(0, 0, f->width, f->height, GL_DEPTH_COMPONENT, GL_FLOAT, values);
        hash[1] = hash_of(values, pixels * sizeof(float));
    }
    if (f->has_stencil) {
        gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
        gl->ReadPixels(0, 0, f->width, f->height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, values);
        hash[2] = hash_of(values, pixels);
    }
    free(values);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl->BlitFramebuffer(0, 0, f->width, f->height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                        GL_NEAREST);
    gl->Enable(GL_SCISSOR_TEST);
    for (int i = 0; i < HASHES; ++i) {
        gl->Scissor(i, 0, 1, 1);
        gl->ClearColor((float)(hash[i] & 255) / 255.0f, (float)(hash[i] >> 8 & 255) / 255.0f,
                       (float)(hash[i] >> 16 & 255) / 255.0f, 1.0f);
        gl->Clear(GL_COLOR_BUFFER_BIT);
    }
    gl->Disable(GL_SCISSOR_TEST);
}

static GLenum pick_color(random_source *r)
{
    return PICK(r, GL_RGBA8, GL_RGBA8, GL_RGBA, GL_SRGB8_ALPHA8, GL_RGBA32F, GL_RGBA16F, GL_RGB8);
}

static void draw_something(const library *gl, random_source *r, int width, int height)
{
    gl->Viewport(0, 0, width, height);
    switch (random_below(r, 4)) {
    case 0:
        draw_states(gl, r, width, height);
        break;
    case 1:
        draw_alpha(gl, r, width, height);
        break;
    case 2:
        draw_line_patterns(gl, r, width, height);
        break;
    default:
        gl->Enable(GL_DEPTH_TEST);
        draw_lighting(gl, r, width, height);
    }
}

void draw_renderbuffers(const library *gl, random_source *r, int width, int height)
{
    const GLenum color = pick_color(r);
    const GLenum depth = depth_formats[random_below(r, 8)];
    const int columns = random_between(r, 1, MOST_SIDE), rows = random_between(r, 1, MOST_SIDE);
    const framebuffer f = create_framebuffer(gl, color, depth, 0, columns, rows);

    if (color != GL_SRGB8_ALPHA8 && one_in(r, 2))
        gl->Enable(GL_FRAMEBUFFER_SRGB);
    if (one_in(r, 3))
        gl->ClipControl(PICK(r, GL_LOWER_LEFT, GL_UPPER_LEFT),
                        PICK(r, GL_NEGATIVE_ONE_TO_ONE, GL_ZERO_TO_ONE));
    draw_something(gl, r, columns, rows);
    show(gl, &f, width, height);
    delete_framebuffer(gl, &f);
}

/* Four samples a pixel, resolved. Lines and points are left out, as in the contract. */
void draw_multisampled(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_QUADS};
    const GLenum color = pick_color(r);
    const GLenum depth = depth_formats[random_below(r, 8)];
    const int columns = random_between(r, 1, MOST_SIDE), rows = random_between(r, 1, MOST_SIDE);
    const framebuffer f = create_framebuffer(gl, color, depth, 4, columns, rows);
    framebuffer resolved;

    gl->Viewport(0, 0, columns, rows);
    gl->Enable(GL_DEPTH_TEST);
    clear_window(gl, r);
    set_matrices(gl, r);
    if (one_in(r, 3)) {
        gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        gl->Enable(GL_BLEND);
    }
    draw_primitives(gl, r, modes, 3);
    resolved = create_framebuffer(gl, color, depth, 0, columns, rows);
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, f.name);
    gl->BlitFramebuffer(0, 0, columns, rows, 0, 0, columns, rows,
                        GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT,
                        GL_NEAREST);
    show(gl, &resolved, width, height);
    delete_framebuffer(gl, &f);
    delete_framebuffer(gl, &resolved);
}

/* Blits from a framebuffer to the window, and from one framebuffer to another: moved, mirrored,
 * scaled. */
void draw_blits(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_TRIANGLES};
    const GLenum depth = one_in(r, 2) ? GL_DEPTH24_STENCIL8 : GL_DEPTH32F_STENCIL8;
    const int columns = random_between(r, 8, MOST_SIDE), rows = random_between(r, 8, MOST_SIDE);
    const GLenum color = PICK(r, GL_RGBA8, GL_RGBA32F, GL_RGBA16F, GL_RGB8);
    const framebuffer f = create_framebuffer(gl, color, depth, 0, columns, rows);
    framebuffer to;

    gl->Viewport(0, 0, columns, rows);
    gl->Enable(GL_DEPTH_TEST);
    clear_window(gl, r);
    set_matrices(gl, r);
    draw_primitives(gl, r, modes, 1);
    to = create_framebuffer(gl, one_in(r, 2) ? color : GL_RGBA32F, depth, 0, width, height);
    clear_window(gl, r);
    for (int i = 0; i < 3; ++i) {
        const int x0 = random_between(r, 0, columns), y0 = random_between(r, 0, rows);
        const int x1 = random_between(r, 0, columns), y1 = random_between(r, 0, rows);
        const int to_x0 = random_between(r, -9, width), to_y0 = random_between(r, -9, height);
        const bool scales = one_in(r, 2);
        const int to_x1 = scales ? random_between(r, -9, width) : to_x0 + x1 - x0;
        const int to_y1 = scales ? random_between(r, -9, height) : to_y0 + y1 - y0;
        const GLenum filter = one_in(r, 2) ? GL_NEAREST : GL_LINEAR;

        gl->BindFramebuffer(GL_READ_FRAMEBUFFER, f.name);
        gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, one_in(r, 3) ? 0 : to.name);
        if (one_in(r, 3)) {
            const int x = random_between(r, -9, width), y = random_between(r, -9, height);

            gl->Scissor(x, y, random_between(r, 0, width), random_between(r, 0, height));
            gl->Enable(GL_SCISSOR_TEST);
        }
        gl->BlitFramebuffer(x0, y0, x1, y1, to_x0, to_y0, to_x1, to_y1,
                            filter == GL_LINEAR || one_in(r, 2)
                                ? GL_COLOR_BUFFER_BIT
                                : GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT,
                            filter);
    }
    show(gl, &to, width, height);
    delete_framebuffer(gl, &f);
    delete_framebuffer(gl, &to);
}

/* Draws to a level of a texture, then with the texture to the window. */
void draw_to_texture(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_TRIANGLES, GL_QUADS};
    const int side = 1 << random_between(r, 2, 6), level = (int)random_below(r, 2);
    const GLint internal = (GLint)PICK(r, GL_RGBA8, GL_RGB8, GL_RGBA32F_ARB);
    GLuint texture, name;

    gl->GenTextures(1, &texture);
    gl->BindTexture(GL_TEXTURE_2D, texture);
    for (int l = 0; l < 2; ++l)
        gl->TexImage2D(GL_TEXTURE_2D, l, internal, side >> l, side >> l, 0, GL_RGBA, GL_FLOAT,
                       NULL);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, level);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level);
    gl->GenFramebuffers(1, &name);
    gl->BindFramebuffer(GL_FRAMEBUFFER, name);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, level);
    gl->Viewport(0, 0, side >> level, side >> level);
    clear_window(gl, r);
    set_matrices(gl, r);
    if (internal == GL_RGBA8 && one_in(r, 2)) {
        gl->BlendFunc(GL_DST_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        gl->Enable(GL_BLEND);
    }
    draw_primitives(gl, r, modes, 2);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl->Viewport(0, 0, width, height);
    clear_window(gl, r);
    gl->Disable(GL_BLEND);
    gl->Enable(GL_TEXTURE_2D);
    gl->Begin(GL_TRIANGLES);
    for (int i = 0; i < 6; ++i) {
        const float x = between(r, -1.0f, 1.0f), y = between(r, -1.0f, 1.0f);
        const float s = between(r, 0.0f, 1.0f), t = between(r, 0.0f, 1.0f);

        set_color(gl, r);
        gl->TexCoord2f(s, t);
        gl->Vertex3f(x, y, between(r, -0.6f, 0.6f));
    }
    gl->End();
    gl->DeleteFramebuffers(1, &name);
    gl->DeleteTextures(1, &texture);
}

/* Draws to faces of a cube or to slices of a 3D texture, then with the texture to the window. */
void draw_to_layers(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_TRIANGLES, GL_QUADS};
    const bool is_cube = one_in(r, 2);
    const GLenum target = is_cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_3D;
    const int side = 1 << random_between(r, 2, 5);
    const GLint internal = (GLint)PICK(r, GL_RGBA8, GL_RGB8, GL_RGBA32F_ARB);
    GLuint texture, name;

    gl->GenTextures(1, &texture);
    gl->BindTexture(target, texture);
    for (GLenum face = 0; is_cube && face < 6; ++face)
        gl->TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, internal, side, side, 0, GL_RGBA,
                       GL_FLOAT, NULL);
    if (!is_cube)
        gl->TexImage3D(target, 0, internal, side, side, 4, 0, GL_RGBA, GL_FLOAT, NULL);
    gl->TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
    gl->GenFramebuffers(1, &name);
    gl->BindFramebuffer(GL_FRAMEBUFFER, name);
    gl->Viewport(0, 0, side, side);
    for (GLint layer = 0; layer < (is_cube ? 6 : 4); ++layer) {
        if (one_in(r, 2))
            gl->FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture, 0, layer);
        else if (is_cube)
            gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                     GL_TEXTURE_CUBE_MAP_POSITIVE_X + (GLenum)layer, texture, 0);
        else
            gl->FramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, texture, 0,
                                     layer);
        clear_window(gl, r);
        set_matrices(gl, r);
        draw_primitives(gl, r, modes, 2);
    }
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl->Viewport(0, 0, width, height);
    clear_window(gl, r);
    gl->Enable(target);
    gl->Begin(GL_TRIANGLES);
    for (int i = 0; i < 9; ++i) {
        const float x = between(r, -1.0f, 1.0f), y = between(r, -1.0f, 1.0f);
        const float s = between(r, -1.0f, 1.0f), t = between(r, -1.0f, 1.0f);

        set_color(gl, r);
        gl->TexCoord3f(s, t, between(r, -1.0f, 1.0f));
        gl->Vertex3f(x, y, between(r, -0.6f, 0.6f));
    }
    gl->End();
    gl->DeleteFramebuffers(1, &name);
    gl->DeleteTextures(1, &texture);
}
