/* Scenes with textures and generated texture coordinates. */
#include "scene_parts.h"

enum { MOST_TEXELS = 64 * 64 };

void fill_bytes(random_source *r, GLubyte *texels, uint32_t count)
{
    for (uint32_t i = 0; i < count; ++i)
        texels[i] = (GLubyte)random_below(r, 256);
}

/* Sets the levels of a texture down to one texel. */
static void set_levels(const library *gl, random_source *r, GLenum target, GLint internal)
{
    static GLubyte bytes[4 * MOST_TEXELS];
    static GLfloat floats[4 * MOST_TEXELS];
    const GLenum format =
        PICK(r, GL_RGBA, GL_RGBA, GL_BGRA, GL_RGB, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_ALPHA);
    const bool has_floats = one_in(r, 3);
    const GLenum type = has_floats ? GL_FLOAT : GL_UNSIGNED_BYTE;
    const void *const texels = has_floats ? (const void *)floats : bytes;
    GLsizei width = 1 << random_below(r, 7), height = 1 << random_below(r, 7);
    GLint level = 0;

    if (one_in(r, 4))
        width = random_between(r, 1, 60);
    height = target == GL_TEXTURE_1D ? 1 : height;
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (;; ++level) {
        const uint32_t count = 4u * (uint32_t)(width * height);

        fill_bytes(r, bytes, count);
        for (uint32_t i = 0; i < count; ++i)
            floats[i] = between(r, -0.1f, 1.1f);
        if (target == GL_TEXTURE_1D)
            gl->TexImage1D(target, level, internal, width, 0, format, type, texels);
        else
            gl->TexImage2D(target, level, internal, width, height, 0, format, type, texels);
        if (width == 1 && height == 1)
            break;
        width = width > 1 ? width / 2 : 1;
        height = height > 1 ? height / 2 : 1;
    }
    if (target == GL_TEXTURE_2D && one_in(r, 3)) {
        fill_bytes(r, bytes, 4);
        gl->TexSubImage2D(target, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    }
}

void set_texture_sampling(const library *gl, random_source *r, GLenum target)
{
    static const GLenum wraps[] = {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT,
                                   GL_CLAMP_TO_BORDER};
    float border[4];

    for (int i = 0; i < 4; ++i)
        border[i] = between(r, 0.0f, 1.0f);
    gl->TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, border);
    gl->TexParameteri(target, GL_TEXTURE_WRAP_S, (GLint)pick(r, wraps, 4));
    gl->TexParameteri(target, GL_TEXTURE_WRAP_T, (GLint)pick(r, wraps, 4));
    gl->TexParameteri(target, GL_TEXTURE_MAG_FILTER, (GLint)PICK(r, GL_NEAREST, GL_LINEAR));
    gl->TexParameteri(target, GL_TEXTURE_MIN_FILTER,
                      (GLint)PICK(r, GL_NEAREST, GL_LINEAR, GL_NEAREST_MIPMAP_NEAREST,
                                  GL_LINEAR_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR,
                                  GL_LINEAR_MIPMAP_LINEAR));
}

void set_texture_environment(const library *gl, random_source *r)
{
    float color[4];

    for (int i = 0; i < 4; ++i)
        color[i] = between(r, -0.1f, 1.1f);
    gl->TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
    gl->TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
                (GLint)PICK(r, GL_MODULATE, GL_REPLACE, GL_DECAL, GL_BLEND, GL_ADD));
}

/* Sets a texture of the active unit. */
void set_texture(const library *gl, random_source *r)
{
    const GLint internal =
        (GLint)PICK(r, GL_RGBA, GL_RGBA8, GL_RGB, GL_RGB8, GL_LUMINANCE, GL_LUMINANCE_ALPHA,
                    GL_ALPHA, GL_INTENSITY, 3, 4, GL_LUMINANCE8, GL_RGBA32F_ARB,
                    GL_COMPRESSED_INTENSITY, GL_COMPRESSED_ALPHA);
    const GLenum target = one_in(r, 4) ? GL_TEXTURE_1D : GL_TEXTURE_2D;
    GLuint name;

    gl->GenTextures(1, &name);
    gl->BindTexture(target, name);
    set_levels(gl, r, target, internal);
    set_texture_sampling(gl, r, target);
    set_texture_environment(gl, r);
    gl->Enable(target);
}

void set_texture_matrix(const library *gl, random_source *r)
{
    gl->MatrixMode(GL_TEXTURE);
    gl->LoadIdentity();
    gl->Translatef(between(r, -1.0f, 1.0f), between(r, -1.0f, 1.0f), 0.0f);
    gl->Rotatef(between(r, -90.0f, 90.0f), 0.0f, 0.0f, 1.0f);
    gl->Scalef(between(r, 0.5f, 2.0f), between(r, 0.5f, 2.0f), 1.0f);
    gl->MatrixMode(GL_MODELVIEW);
}

/* Sums of colours and fog, which come after textures. */
void set_later_states(const library *gl, random_source *r)
{
    if (one_in(r, 3)) {
        gl->Enable(GL_COLOR_SUM);
        gl->SecondaryColor3f(between(r, 0.0f, 0.5f), between(r, 0.0f, 0.5f), 0.1f);
    }
    if (one_in(r, 4)) {
        gl->Enable(GL_FOG);
        gl->Fogf(GL_FOG_DENSITY, between(r, 0.0f, 0.4f));
    }
}

void draw_textured_vertices(const library *gl, random_source *r, bool has_normals, bool has_r)
{
    const GLenum mode = PICK(r, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS);
    const uint32_t vertices = 8 + random_below(r, 16);
    const float scale = one_in(r, 2) ? 1.5f : 12.0f;
    const bool has_q = one_in(r, 4), has_coordinates = !one_in(r, 8);

    set_color(gl, r);
    gl->Begin(mode);
    for (uint32_t i = 0; i < vertices; ++i) {
        const float x = between(r, -1.0f, 1.0f), y = between(r, -1.0f, 1.0f);
        const float s = between(r, -scale, scale), t = between(r, -scale, scale);

        if (!one_in(r, 3))
            set_color(gl, r);
        if (has_normals)
            gl->Normal3f(x, between(r, -1.0f, 1.0f), between(r, 0.0f, 1.0f));
        if (has_coordinates && has_q)
            gl->TexCoord4f(s, t, 0.3f, between(r, 0.7f, 1.5f));
        else if (has_coordinates && has_r)
            gl->TexCoord3d((GLdouble)s, (GLdouble)t, (GLdouble)between(r, -scale, scale));
        else if (has_coordinates)
            gl->TexCoord2f(s, t);
        gl->Vertex3f(x, y, between(r, -0.6f, 0.6f));
    }
    gl->End();
}

void draw_textures(const library *gl, random_source *r, int width, int height)
{
    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    set_texture(gl, r);
    if (one_in(r, 4))
        set_texture_matrix(gl, r);
    if (one_in(r, 5)) {
        gl->ActiveTexture(GL_TEXTURE1);
        set_texture(gl, r);
        gl->MultiTexCoord4f(GL_TEXTURE1, between(r, -1.0f, 1.0f), 0.4f, 0.0f, 1.0f);
    }
    set_later_states(gl, r);
    draw_textured_vertices(gl, r, false, false);
}

/* Reads the bound texture and sets it again in another format. */
static void set_read_texture(const library *gl, random_source *r)
{
    static GLfloat pixels[16 * 16 * 4];
    const GLenum format =
        PICK(r, GL_RGBA, GL_BGRA, GL_RGB, GL_RED, GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA);
    const GLenum type = PICK(r, GL_UNSIGNED_BYTE, GL_FLOAT, GL_UNSIGNED_SHORT);
    GLint width = 0;

    gl->GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    if (width != 16)
        return;
    gl->GetTexImage(GL_TEXTURE_2D, 0, format, type, pixels);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, width, 0, format, type, pixels);
}

/* Copies from the window, which is drawn to before. */
void draw_copied_texture(const library *gl, random_source *r, int width, int height)
{
    static const GLenum modes[] = {GL_TRIANGLES, GL_QUADS};
    const GLenum internal = PICK(r, GL_RGBA, GL_RGB, GL_LUMINANCE, GL_ALPHA, GL_INTENSITY);
    const int x = random_between(r, 0, width - 16), y = random_between(r, 0, height - 16);

    clear_window(gl, r);
    set_matrices(gl, r);
    draw_primitives(gl, r, modes, 2);
    gl->CopyTexImage2D(GL_TEXTURE_2D, 0, internal, x, y, 16, 16, 0);
    gl->CopyTexSubImage2D(GL_TEXTURE_2D, 0, 3, 4, random_between(r, 0, width - 8),
                          random_between(r, 0, height - 8), 8, 8);
    if (one_in(r, 2))
        set_read_texture(gl, r);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, (GLint)PICK(r, GL_NEAREST, GL_LINEAR));
    set_texture_environment(gl, r);
    gl->Enable(GL_TEXTURE_2D);
    draw_textured_vertices(gl, r, false, false);
}

void set_texture_generation(const library *gl, random_source *r)
{
    static const GLenum modes[4][5] = {
        {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_REFLECTION_MAP, GL_NORMAL_MAP},
        {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_REFLECTION_MAP, GL_NORMAL_MAP},
        {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_REFLECTION_MAP, GL_NORMAL_MAP, GL_EYE_LINEAR},
        {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_EYE_LINEAR}};

    for (GLenum i = 0; i < 4; ++i) {
        float plane[4];

        for (int c = 0; c < 4; ++c)
            plane[c] = between(r, -1.5f, 1.5f);
        plane[3] += i == 3 ? 3.0f : 0.0f;
        gl->TexGeni(GL_S + i, GL_TEXTURE_GEN_MODE, (GLint)pick(r, modes[i], 5));
        gl->TexGenfv(GL_S + i, GL_OBJECT_PLANE, plane);
        gl->TexGenfv(GL_S + i, GL_EYE_PLANE, plane);
        if (one_in(r, i < 2 ? 1 : 4))
            gl->Enable(GL_TEXTURE_GEN_S + i);
    }
}

void draw_generated_coordinates(const library *gl, random_source *r, int width, int height)
{
    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    set_texture(gl, r);
    set_texture_generation(gl, r);
    if (one_in(r, 3))
        set_texture_matrix(gl, r);
    if (one_in(r, 2))
        gl->Enable(one_in(r, 2) ? GL_NORMALIZE : GL_RESCALE_NORMAL);
    set_later_states(gl, r);
    if (one_in(r, 3)) {
        gl->Enable(GL_LIGHTING);
        gl->Enable(GL_LIGHT0);
    }
    draw_textured_vertices(gl, r, true, false);
}

/* Lights of all kinds, textures and generated coordinates together. */
void draw_mixed(const library *gl, random_source *r, int width, int height)
{
    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    set_lit_state(gl, r);
    set_texture(gl, r);
    if (one_in(r, 2))
        set_texture_generation(gl, r);
    if (one_in(r, 3)) {
        gl->ActiveTexture(GL_TEXTURE1);
        set_texture(gl, r);
        set_texture_generation(gl, r);
    }
    if (one_in(r, 4))
        set_texture_matrix(gl, r);
    if (one_in(r, 3)) {
        gl->ColorMaterial(GL_FRONT_AND_BACK, PICK(r, GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE));
        gl->Enable(GL_COLOR_MATERIAL);
    }
    set_later_states(gl, r);
    if (one_in(r, 3)) {
        gl->AlphaFunc(GL_GREATER, between(r, 0.1f, 0.6f));
        gl->Enable(GL_ALPHA_TEST);
    }
    if (one_in(r, 3))
        gl->Enable(GL_DEPTH_TEST);
    draw_textured_vertices(gl, r, true, false);
}
