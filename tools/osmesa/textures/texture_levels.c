/* Levels that are made from the base level: GL_GENERATE_MIPMAP and glGenerateMipmap (OpenGL 2.1
 * section 3.8.8, OpenGL 3.0 section 3.8.10). */
#include <gl_registry.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../context/gl_errors.h"
#include "texel_pixels.h"

static GLint halved(GLint size)
{
    return size > 1 ? size / 2 : 1;
}

/* Returns how many levels an image has down to one texel. */
static uint32_t level_count_of(const texture_image *base)
{
    GLint size = base->width > base->height ? base->width : base->height;
    uint32_t count = 1;

    for (size = base->depth > size ? base->depth : size; size > 1; size /= 2)
        ++count;
    return count;
}

/* Where the columns or rows of a level lie among those of the level before: their coordinates are a
 * plane through the far corner of the new level. */
typedef struct level_axis {
    GLint texels; /* of the level before */
    float step, origin;
} level_axis;

/* Returns the axis of a level with `size` columns or rows, and `other_size` in the other dimension,
 * which rounds the step. */
static level_axis axis_of(GLint texels, GLint size, GLint other_size)
{
    const float length = (float)size, other = (float)other_size;
    const float step = other * (1.0f / (length * other));

    return (level_axis){texels, step, 1.0f - step * (length - 0.5f)};
}

/* A place between two columns or rows. */
typedef struct mixed_place {
    GLint first, second;
    float weight; /* of the second */
} mixed_place;

static mixed_place place_on(const level_axis *axis, GLint i)
{
    const float most = (float)axis->texels;
    const float at = (axis->step * (float)i + axis->origin) * most;
    const float c = (at < most ? at : most) - 0.5f;
    const float place = c > 0.0f ? c : 0.0f;
    const GLint first = (GLint)place < axis->texels ? (GLint)place : axis->texels - 1;

    return (mixed_place){first, first + 1 < axis->texels ? first + 1 : first, place - (float)first};
}

static float mixed_byte(const unsigned char *a, const unsigned char *b, float weight)
{
    const float low = (float)*a * (1.0f / 255.0f), high = (float)*b * (1.0f / 255.0f);

    return low + weight * (high - low);
}

/* Makes a level of four bytes a texel from the level before. */
static void halve_bytes(const texture_image *from, texture_image *to)
{
    const level_axis s = axis_of(from->width, to->width, to->height);
    const level_axis t = axis_of(from->height, to->height, to->width);
    unsigned char *out = to->texels;

    for (GLint y = 0; y < to->height; ++y) {
        const mixed_place row = place_on(&t, y);
        const unsigned char *const rows[2] = {texel_at(from, 0, row.first, 0),
                                              texel_at(from, 0, row.second, 0)};

        for (GLint x = 0; x < to->width; ++x) {
            const mixed_place column = place_on(&s, x);
            const size_t a = 4 * (size_t)column.first, b = 4 * (size_t)column.second;

            for (size_t c = 0; c < 4; ++c) {
                const float low = mixed_byte(rows[0] + a + c, rows[0] + b + c, column.weight);
                const float high = mixed_byte(rows[1] + a + c, rows[1] + b + c, column.weight);

                *out++ = (unsigned char)rintf((low + row.weight * (high - low)) * 255.0f);
            }
        }
    }
}

/* Whether the reference draws the levels of an image as rectangles, with one plane of coordinates,
 * and not as two triangles, with two, as gn_texture_generate_levels does: it does so where it draws
 * into a texture of two dimensions with four bytes a texel. Between powers of two, the planes are
 * equal. */
static bool is_drawn_as_rectangles(const texture_object *texture, const texture_image *base)
{
    const bool are_powers =
        (base->width & (base->width - 1)) == 0 && (base->height & (base->height - 1)) == 0;

    return texture->target == GL_TEXTURE_2D && base->format == GN_FORMAT_RGBA8 && !are_powers &&
           (base->base_format == GL_RGB || base->base_format == GL_RGBA);
}

/* Makes images of levels 1 to `count` - 1, up to max_level: copies those that the library has made,
 * or, if `levels` is null, draws them as rectangles. Returns false if memory is short. */
static bool store_levels(texture_object *texture, int face, uint32_t count,
                         const gn_texture *levels)
{
    texture_image *const image = &texture->image[face][texture->base_level];
    const GLint most = texture->max_level < GN_MAX_LEVELS ? texture->max_level : GN_MAX_LEVELS - 1;

    for (GLint n = 1; n < (GLint)count && texture->base_level + n <= most; ++n) {
        texture_image next = image[n - 1];
        size_t size;

        next.width = halved(next.width);
        next.height = halved(next.height);
        next.depth = halved(next.depth);
        size = (size_t)next.width * (size_t)next.height * (size_t)next.depth *
               gn_format_size(next.format);
        next.texels = malloc(size);
        if (!next.texels)
            return false;
        if (levels)
            memcpy(next.texels, levels->level[n].texels, size);
        else
            halve_bytes(&image[n - 1], &next);
        free(image[n].texels);
        image[n] = next;
    }
    return true;
}

static bool generate_face(texture_object *texture, int face)
{
    const texture_image *const base = &texture->image[face][texture->base_level];
    const gn_texture_target target = texture->target == GL_TEXTURE_3D   ? GN_TEXTURE_3D
                                     : texture->target == GL_TEXTURE_1D ? GN_TEXTURE_1D
                                                                        : GN_TEXTURE_2D;
    const uint32_t width = (uint32_t)base->width, height = (uint32_t)base->height;
    const uint32_t depth = (uint32_t)base->depth, count = level_count_of(base);
    const size_t first = gn_texture_memory_size(target, base->format, width, height, depth, 1);
    const size_t all = gn_texture_memory_size(target, base->format, width, height, depth, count);
    gn_texture levels;
    void *memory;
    bool done;

    if (count < 2)
        return true;
    if (is_drawn_as_rectangles(texture, base))
        return store_levels(texture, face, count, NULL);
    if (gn_texture_packed(target, base->format, width, height, depth, 1, base->texels, &levels))
        return false;
    memory = malloc(all - first);
    done = memory && gn_texture_generate_levels(&levels, memory, all - first) == GN_OK &&
           store_levels(texture, face, count, &levels);
    free(memory);
    return done;
}

static bool has_colors(const texture_object *texture, int face)
{
    const texture_image *const base =
        texture->base_level < GN_MAX_LEVELS ? &texture->image[face][texture->base_level] : NULL;

    return base && base->texels && !is_depth_format(base->base_format);
}

bool generate_levels(texture_object *texture)
{
    const int faces = texture->target == GL_TEXTURE_CUBE_MAP ? CUBE_FACES : 1;

    texture->cube_is_old = true;
    for (int face = 0; face < faces; ++face)
        if (has_colors(texture, face) && !generate_face(texture, face))
            return false;
    return true;
}

void texture_changed(context *gl, const image_target *target, GLint level, const char *function)
{
    texture_object *const texture = target->texture;

    texture->cube_is_old = true;
    if (texture->generates_levels && level == texture->base_level && !target->is_proxy &&
        has_colors(texture, target->face) && !generate_face(texture, target->face))
        gl_error(gl, GL_OUT_OF_MEMORY, function);
}

/* Whether all faces of a cube have base levels of one size and format. */
static bool is_cube_complete(const texture_object *texture)
{
    const texture_image *const first = &texture->image[0][texture->base_level];

    for (int face = 0; face < CUBE_FACES; ++face) {
        const texture_image *const other = &texture->image[face][texture->base_level];

        if (!other->texels || other->width != first->width ||
            other->internal_format != first->internal_format)
            return false;
    }
    return true;
}

void glGenerateMipmap(GLenum target)
{
    context *const gl = enter(__func__);
    texture_object *const texture = gl ? bound_texture(gl, target, __func__) : NULL;

    if (!texture || texture->base_level >= GN_MAX_LEVELS)
        return;
    if (target == GL_TEXTURE_CUBE_MAP && !is_cube_complete(texture))
        gl_error(gl, GL_INVALID_OPERATION, __func__);
    else if (!generate_levels(texture))
        gl_error(gl, GL_OUT_OF_MEMORY, __func__);
}
