/* Scenes with textures of every target, several units, shadows, and levels that are generated. */
#include "scene_parts.h"

enum { MOST_TEXELS = 32 * 32 * 32, MOST_SIDE = 5 /* 2^5 */ };

static GLubyte bytes[4 * MOST_TEXELS];
static GLfloat floats[MOST_TEXELS];

/* Sets all levels of one image of a texture, of random bytes. */
static void set_images(const library *gl, random_source *r, GLenum target, GLint internal,
                       const GLsizei first[3], bool has_levels)
{
    GLsizei size[3] = {first[0], first[1], first[2]};

    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (GLint level = 0;; ++level) {
        fill_bytes(r, bytes, 4u * (uint32_t)(size[0] * size[1] * size[2]));
        if (target == GL_TEXTURE_3D)
            gl->TexImage3D(target, level, internal, size[0], size[1], size[2], 0, GL_RGBA,
                           GL_UNSIGNED_BYTE, bytes);
        else if (target == GL_TEXTURE_1D)
            gl->TexImage1D(target, level, internal, size[0], 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
        else
            gl->TexImage2D(target, level, internal, size[0], size[1], 0, GL_RGBA, GL_UNSIGNED_BYTE,
                           bytes);
        if (!has_levels || (size[0] == 1 && size[1] == 1 && size[2] == 1))
            return;
        for (int i = 0; i < 3; ++i)
            size[i] = size[i] > 1 ? size[i] / 2 : 1;
    }
}

static void bind_new_texture(const library *gl, GLenum target)
{
    GLuint name;

    gl->GenTextures(1, &name);
    gl->BindTexture(target, name);
    gl->Enable(target);
}

/* Depths of random values, compared or not. */
static void set_depth_texture(const library *gl, random_source *r)
{
    const GLint internal =
        (GLint)PICK(r, GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24,
                    GL_DEPTH_COMPONENT32, GL_DEPTH_COMPONENT32F);
    const GLenum type = PICK(r, GL_FLOAT, GL_UNSIGNED_INT, GL_UNSIGNED_SHORT, GL_UNSIGNED_BYTE);
    const GLsizei width = 1 << random_below(r, 5), height = 1 << random_below(r, 5);

    bind_new_texture(gl, GL_TEXTURE_2D);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    fill_bytes(r, bytes, 4u * (uint32_t)(width * height));
    for (int i = 0; i < width * height; ++i)
        floats[i] = between(r, -0.1f, 1.1f);
    gl->TexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, GL_DEPTH_COMPONENT, type,
                   type == GL_FLOAT ? (const void *)floats : bytes);
    set_texture_sampling(gl, r, GL_TEXTURE_2D);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, (GLint)PICK(r, GL_NEAREST, GL_LINEAR));
    gl->TexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE,
                      (GLint)PICK(r, GL_LUMINANCE, GL_INTENSITY, GL_ALPHA));
    if (!one_in(r, 4))
        gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC,
                      (GLint)(GL_NEVER + random_below(r, 8)));
    set_texture_environment(gl, r);
}

void draw_shadows(const library *gl, random_source *r, int width, int height)
{
    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    set_depth_texture(gl, r);
    if (one_in(r, 3)) {
        set_texture_generation(gl, r);
        gl->Enable(GL_TEXTURE_GEN_R);
    }
    set_later_states(gl, r);
    draw_textured_vertices(gl, r, true, true);
}

static void set_cube(const library *gl, random_source *r)
{
    const GLint internal = (GLint)PICK(r, GL_RGBA, GL_RGB, GL_LUMINANCE, GL_ALPHA, GL_INTENSITY);
    const GLsizei side = one_in(r, 4) ? random_between(r, 1, 20) : 1 << random_below(r, 6);

    bind_new_texture(gl, GL_TEXTURE_CUBE_MAP);
    for (GLenum face = 0; face < 6; ++face)
        set_images(gl, r, GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, internal,
                   (const GLsizei[]){side, side, 1}, true);
    if (one_in(r, 3))
        gl->TexSubImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                          bytes);
    set_texture_sampling(gl, r, GL_TEXTURE_CUBE_MAP);
    gl->TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_R,
                      (GLint)PICK(r, GL_REPEAT, GL_CLAMP_TO_EDGE));
    set_texture_environment(gl, r);
}

void draw_cubes(const library *gl, random_source *r, int width, int height)
{
    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    set_cube(gl, r);
    if (one_in(r, 2)) {
        const GLint mode = (GLint)PICK(r, GL_REFLECTION_MAP, GL_NORMAL_MAP);

        for (GLenum i = 0; i < 3; ++i) {
            gl->TexGeni(GL_S + i, GL_TEXTURE_GEN_MODE, mode);
            gl->Enable(GL_TEXTURE_GEN_S + i);
        }
    }
    if (one_in(r, 4))
        set_texture_matrix(gl, r);
    set_later_states(gl, r);
    draw_textured_vertices(gl, r, true, true);
}

void draw_seamless_cubes(const library *gl, random_source *r, int width, int height)
{
    gl->Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    draw_cubes(gl, r, width, height);
}

static void set_volume(const library *gl, random_source *r)
{
    const GLint internal = (GLint)PICK(r, GL_RGBA, GL_RGB, GL_LUMINANCE, GL_ALPHA, GL_INTENSITY);
    const GLsizei size[3] = {one_in(r, 4) ? 5 : 1 << random_below(r, MOST_SIDE),
                             1 << random_below(r, MOST_SIDE), 1 << random_below(r, MOST_SIDE)};

    bind_new_texture(gl, GL_TEXTURE_3D);
    set_images(gl, r, GL_TEXTURE_3D, internal, size, true);
    if (one_in(r, 3))
        gl->TexSubImage3D(GL_TEXTURE_3D, 0, size[0] - 1, 0, size[2] - 1, 1, 1, 1, GL_RGBA,
                          GL_UNSIGNED_BYTE, bytes);
    set_texture_sampling(gl, r, GL_TEXTURE_3D);
    gl->TexParameteri(
        GL_TEXTURE_3D, GL_TEXTURE_WRAP_R,
        (GLint)PICK(r, GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT, GL_CLAMP_TO_BORDER));
    set_texture_environment(gl, r);
}

void draw_volumes(const library *gl, random_source *r, int width, int height)
{
    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    set_volume(gl, r);
    if (one_in(r, 4))
        gl->CopyTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, 1, 2, 1, 1);
    if (one_in(r, 4))
        set_texture_matrix(gl, r);
    set_later_states(gl, r);
    draw_textured_vertices(gl, r, true, true);
}

/* Textures of every target in up to four units. */
void draw_units(const library *gl, random_source *r, int width, int height)
{
    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    for (GLenum unit = 0; unit < 4; ++unit) {
        const uint32_t kind = random_below(r, 6);

        gl->ActiveTexture(GL_TEXTURE0 + unit);
        if (kind < 2)
            set_texture(gl, r);
        else if (kind == 2)
            set_depth_texture(gl, r);
        else if (kind == 3)
            set_cube(gl, r);
        else if (kind == 4)
            set_volume(gl, r);
        if (one_in(r, 3))
            set_texture_generation(gl, r);
        if (one_in(r, 4))
            set_texture_matrix(gl, r);
        gl->MultiTexCoord4f(GL_TEXTURE0 + unit, between(r, -1.0f, 1.0f), between(r, -1.0f, 1.0f),
                            between(r, 0.0f, 1.0f), 1.0f);
    }
    set_later_states(gl, r);
    draw_textured_vertices(gl, r, true, true);
}

/* A size of a texture, which is a power of two half the time. */
static GLsizei random_size(random_source *r, uint32_t bits)
{
    return one_in(r, 2) ? 1 << random_below(r, bits) : (GLsizei)(1 + random_below(r, 1u << bits));
}

/* Levels that are made from the first. */
void draw_generated_levels(const library *gl, random_source *r, int width, int height)
{
    static const GLenum targets[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_2D, GL_TEXTURE_3D};
    const GLenum target = pick(r, targets, 4);
    const GLint internal =
        (GLint)PICK(r, GL_RGBA, GL_RGB, GL_LUMINANCE, GL_ALPHA, GL_INTENSITY, GL_LUMINANCE_ALPHA);
    GLsizei size[3] = {1, 1, 1};

    size[0] = random_size(r, 6);
    if (target != GL_TEXTURE_1D)
        size[1] = random_size(r, 6);
    if (target == GL_TEXTURE_3D)
        size[2] = random_size(r, 4);
    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    bind_new_texture(gl, target);
    if (one_in(r, 2)) {
        gl->TexParameteri(target, GL_GENERATE_MIPMAP, GL_TRUE);
        set_images(gl, r, target, internal, size, false);
    } else {
        set_images(gl, r, target, internal, size, false);
        gl->GenerateMipmap(target);
    }
    set_texture_sampling(gl, r, target);
    gl->TexParameteri(target, GL_TEXTURE_MIN_FILTER,
                      (GLint)PICK(r, GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_LINEAR));
    gl->TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    draw_textured_vertices(gl, r, false, true);
}

void draw_srgb(const library *gl, random_source *r, int width, int height)
{
    const GLint internal =
        (GLint)PICK(r, GL_SRGB, GL_SRGB8, GL_SRGB_ALPHA, GL_SRGB8_ALPHA8, GL_SLUMINANCE,
                    GL_SLUMINANCE_ALPHA, GL_SLUMINANCE8, GL_SLUMINANCE8_ALPHA8);
    const GLsizei size[3] = {1 << random_below(r, 6), 1 << random_below(r, 6), 1};

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    bind_new_texture(gl, GL_TEXTURE_2D);
    set_images(gl, r, GL_TEXTURE_2D, internal, size, true);
    set_texture_sampling(gl, r, GL_TEXTURE_2D);
    set_texture_environment(gl, r);
    draw_textured_vertices(gl, r, false, false);
}

/* Biases and limits of the level of detail. With a base level above the last one, the reference
 * crashes, or reads texels that the texture does not have. */
void draw_lod_limits(const library *gl, random_source *r, int width, int height)
{
    static const GLenum targets[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D};
    const GLenum target = pick(r, targets, 3);
    const GLint base = one_in(r, 3) ? (GLint)random_below(r, 4) : 0;
    const GLsizei size[3] = {1 << random_below(r, 6),
                             target == GL_TEXTURE_1D ? 1 : 1 << random_below(r, 6),
                             target == GL_TEXTURE_3D ? 1 << random_below(r, 4) : 1};

    (void)width;
    (void)height;
    clear_window(gl, r);
    set_matrices(gl, r);
    bind_new_texture(gl, target);
    set_images(gl, r, target, GL_RGBA, size, true);
    set_texture_sampling(gl, r, target);
    if (one_in(r, 2))
        gl->TexParameterf(target, GL_TEXTURE_MIN_LOD, between(r, -2.0f, 4.0f));
    if (one_in(r, 2))
        gl->TexParameterf(target, GL_TEXTURE_MAX_LOD, between(r, -2.0f, 4.0f));
    if (one_in(r, 2))
        gl->TexParameterf(target, GL_TEXTURE_LOD_BIAS, between(r, -2.0f, 2.0f));
    if (one_in(r, 2))
        gl->TexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, between(r, -2.0f, 2.0f));
    gl->TexParameteri(target, GL_TEXTURE_BASE_LEVEL, base);
    if (one_in(r, 3))
        gl->TexParameteri(target, GL_TEXTURE_MAX_LEVEL, base + (GLint)random_below(r, 6));
    set_texture_environment(gl, r);
    draw_textured_vertices(gl, r, false, true);
}
