/* Levels generated as by glGenerateMipmap. */
#include "texels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene_pixel.h"

typedef struct level_case {
    gn_texture_target target;
    gn_format format;
    uint32_t size[3]; /* the last is 6 of cubes, layers of arrays */
} level_case;

static uint32_t halved(uint32_t size, uint32_t level)
{
    return size >> level > 0 ? size >> level : 1;
}

static void level_size(const level_case *c, uint32_t level, uint32_t size[3])
{
    size[0] = halved(c->size[0], level);
    size[1] = halved(c->size[1], level);
    size[2] = c->target == GN_TEXTURE_3D ? halved(c->size[2], level) : c->size[2];
}

static size_t level_texels(const level_case *c, uint32_t level)
{
    uint32_t size[3];

    level_size(c, level, size);
    return (size_t)size[0] * size[1] * size[2];
}

/* Every second of the first cases of a target and format has one of all small sizes. The other
 * sizes are random, most of them small too, to test the ends of rows. */
static level_case make_case(random_source *r, gn_texture_target target, gn_format format,
                            uint64_t number)
{
    const uint32_t largest = target == GN_TEXTURE_3D || target == GN_TEXTURE_CUBE ? 24 : 80;
    level_case c = {target, format, {1, 1, 1}};

    for (int n = 0; n < 3; ++n)
        c.size[n] = 1 + random_below(r, random_chance(r, 75) ? largest : 3 * largest);
    if (number < 72 && number % 2 == 0) {
        c.size[0] = 1 + (uint32_t)number / 2 % 6;
        c.size[1] = 1 + (uint32_t)number / 12;
        c.size[2] = 1 + random_below(r, 9);
    }
    if (target == GN_TEXTURE_1D)
        c.size[1] = 1;
    if (target == GN_TEXTURE_1D || target == GN_TEXTURE_2D)
        c.size[2] = 1;
    if (target == GN_TEXTURE_CUBE) {
        c.size[1] = c.size[0];
        c.size[2] = 6;
    }
    if (target == GN_TEXTURE_2D_ARRAY)
        c.size[2] = 1 + c.size[2] % 4;
    return c;
}

/* The target in OpenGL: a texture of two dimensions is an array of one layer there, so that Mesa
 * makes its levels with the rasterizer that the contract is about
 * (reference/osmesa/framebuffers.c). */
static gn_texture_target opengl_target(const level_case *c)
{
    return c->target == GN_TEXTURE_2D ? GN_TEXTURE_2D_ARRAY : c->target;
}

/* Reads a level of the bound texture. */
static void read_level(const level_case *c, uint32_t level, unsigned char *texels)
{
    const reference_image_format f = reference_image_format_of(c->format);
    const size_t face = level_texels(c, level) / 6 * gn_format_size(c->format);

    if (c->target != GN_TEXTURE_CUBE)
        glGetTexImage(reference_texture_target(opengl_target(c)), (GLint)level, f.format, f.type,
                      texels);
    for (GLenum n = 0; c->target == GN_TEXTURE_CUBE && n < 6; ++n)
        glGetTexImage(GL_TEXTURE_CUBE_MAP_POSITIVE_X + n, (GLint)level, f.format, f.type,
                      texels + n * face);
    reference_turn_pixels(c->format, texels, level_texels(c, level), false);
}

/* Whether two texels are equal; a NaN equals any other, and sRGB channels may be a step apart. */
static bool are_equal(gn_format format, const unsigned char *a, const unsigned char *b, tally *t)
{
    uint32_t x[4], y[4];

    t->encoded += format == GN_FORMAT_SRGB8_A8;
    if (memcmp(a, b, gn_format_size(format)) == 0)
        return true;
    if (format == GN_FORMAT_SRGB8_A8) {
        ++t->steps;
        return abs(a[0] - b[0]) <= 1 && abs(a[1] - b[1]) <= 1 && abs(a[2] - b[2]) <= 1 &&
               a[3] == b[3];
    }
    const int count = scene_pixel_channels(a, format, 0, x);
    scene_pixel_channels(b, format, 0, y);
    for (int c = 0; c < count; ++c)
        if (x[c] != y[c] && !(isnan(scene_channel_value(format, c, x[c])) &&
                              isnan(scene_channel_value(format, c, y[c]))))
            return false;
    return true;
}

static uint64_t compare_level(const level_case *c, uint32_t level, const unsigned char *ours,
                              const unsigned char *theirs, tally *t)
{
    const size_t bytes = gn_format_size(c->format);
    const size_t count = level_texels(c, level);
    uint64_t differ = 0;
    uint32_t size[3];

    level_size(c, level, size);
    for (size_t i = 0; i < count; ++i) {
        if (are_equal(c->format, ours + i * bytes, theirs + i * bytes, t) || differ++ > 0)
            continue;
        fprintf(stderr, "level %u of %s %s %ux%ux%u, texel %zu of %ux%ux%u: ours", (unsigned)level,
                text_name(TEXT_TEXTURE_TARGET, (int)c->target),
                text_name(TEXT_FORMAT, (int)c->format), (unsigned)c->size[0], (unsigned)c->size[1],
                (unsigned)c->size[2], i, (unsigned)size[0], (unsigned)size[1], (unsigned)size[2]);
        for (size_t n = 0; n < bytes; ++n)
            fprintf(stderr, " %02x", ours[i * bytes + n]);
        fprintf(stderr, ", theirs");
        for (size_t n = 0; n < bytes; ++n)
            fprintf(stderr, " %02x", theirs[i * bytes + n]);
        fprintf(stderr, "\n");
    }
    t->texels += count;
    return differ;
}

/* Generates levels from the reference's level `level`. Compares level + 1 and all later levels, but
 * for sRGB only level + 1, since its steps would add up. */
static bool compare_from(const level_case *c, uint32_t level, uint32_t count,
                         unsigned char *const theirs[], tally *t, uint64_t *differ)
{
    const bool is_one = c->format == GN_FORMAT_SRGB8_A8 && level + 2 < count;
    const uint32_t end = is_one ? level + 2 : count;
    gn_texture texture;
    uint32_t size[3];
    gn_status status;

    level_size(c, level, size);
    status = gn_texture_packed(c->target, c->format, size[0], size[1], size[2], 1, theirs[level],
                               &texture);
    const size_t bytes =
        gn_texture_memory_size(c->target, c->format, size[0], size[1], size[2], count - level) -
        level_texels(c, level) * gn_format_size(c->format);
    unsigned char *const memory = malloc(bytes + 1);

    if (!status && memory)
        status = gn_texture_generate_levels(&texture, memory, bytes);
    for (uint32_t n = level + 1; !status && memory && n < end; ++n)
        *differ += compare_level(c, n, texture.level[n - level].texels, theirs[n], t);
    free(memory);
    return !status && memory && texture.level_count == count - level;
}

static bool compare_case(random_source *r, const level_case *c, tally *t, char *error,
                         size_t error_size)
{
    const GLenum target = reference_texture_target(opengl_target(c));
    unsigned char *theirs[GN_MAX_LEVELS] = {NULL};
    uint32_t count = 1;
    uint64_t differ = 0;
    bool fine = true;
    GLuint name;

    for (uint32_t largest = c->size[0] > c->size[1] ? c->size[0] : c->size[1];
         largest >> count > 0 || (c->target == GN_TEXTURE_3D && c->size[2] >> count > 0);)
        ++count;
    for (uint32_t n = 0; n < count && fine; ++n) {
        theirs[n] = malloc(level_texels(c, n) * gn_format_size(c->format));
        fine = theirs[n] != NULL;
    }
    if (!fine)
        return reference_fail(error, error_size, "out of memory");
    fill_texels(r, c->format, random_chance(r, 10), theirs[0], level_texels(c, 0));

    glGenTextures(1, &name);
    glBindTexture(target, name);
    upload_level(opengl_target(c), c->format, 0, c->size, theirs[0]);
    glGenerateMipmap(target);
    for (uint32_t n = 1; n < count; ++n)
        read_level(c, n, theirs[n]);
    glDeleteTextures(1, &name);
    fine = reference_check("generating levels", error, error_size);

    if (fine && !compare_from(c, 0, count, theirs, t, &differ))
        fine = reference_fail(error, error_size, "the library generates no levels");
    for (uint32_t n = 1; fine && c->format == GN_FORMAT_SRGB8_A8 && n + 1 < count; ++n)
        fine = compare_from(c, n, count, theirs, t, &differ);
    ++t->cases;
    t->failed += differ > 0;
    t->differ += differ;
    for (uint32_t n = 0; n < count; ++n)
        free(theirs[n]);
    return fine;
}

bool compare_levels(uint64_t seed, uint64_t textures, tally *t, char *error, size_t error_size)
{
    for (size_t f = 0; f < SCENE_COLOR_FORMATS; ++f) {
        const gn_format format = scene_color_formats[f];

        for (int target = GN_TEXTURE_2D; target <= GN_TEXTURE_CUBE; ++target) {
            random_source r = random_seed(seed + (f << 8) + (uint64_t)target);

            for (uint64_t n = 0; n < textures; ++n) {
                const level_case c = make_case(&r, (gn_texture_target)target, format, n);

                if (!compare_case(&r, &c, t, error, error_size))
                    return false;
            }
        }
    }
    return true;
}
