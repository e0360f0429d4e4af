/* Scales, shifts and maps colours on their way. */
#include "pixel_transfer.h"

#include <gl_registry.h>
#include <math.h>

static GLfloat clamped(GLfloat x)
{
    return !(x > 0.0f) ? 0.0f : x > 1.0f ? 1.0f : x;
}

static bool scales_colors(const pixel_transfer_state *t)
{
    for (int c = 0; c < 4; ++c)
        if (t->scale[c] != 1.0f || t->bias[c] != 0.0f)
            return true;
    return false;
}

bool transfers_colors(const context *gl)
{
    return gl->transfer.map_color || scales_colors(&gl->transfer);
}

bool transfers_depths(const context *gl)
{
    return gl->transfer.depth_scale != 1.0f || gl->transfer.depth_bias != 0.0f;
}

static void scale_color(const pixel_transfer_state *t, GLfloat color[4])
{
    if (scales_colors(t))
        for (int c = 0; c < 4; ++c)
            color[c] = color[c] * t->scale[c] + t->bias[c];
}

void transfer_color(const context *gl, GLfloat color[4])
{
    scale_color(&gl->transfer, color);
    for (int c = 0; gl->transfer.map_color && c < 4; ++c) {
        const pixel_map *const map = &gl->map[MAP_R_TO_R + c];

        color[c] = map->value[(int)rintf(clamped(color[c]) * (GLfloat)(map->size - 1))];
    }
}

void transfer_drawn_color(const context *gl, GLfloat color[4])
{
    scale_color(&gl->transfer, color);
    for (int c = 0; gl->transfer.map_color && c < 4; ++c) {
        const pixel_map *const map = &gl->map[MAP_R_TO_R + c];
        const int column = (int)(clamped(color[c]) * (GLfloat)PIXEL_MAP_SIZE);
        const int texel = column < PIXEL_MAP_SIZE ? column : PIXEL_MAP_SIZE - 1;

        color[c] = rintf(map->value[texel * map->size / PIXEL_MAP_SIZE] * 255.0f) * (1.0f / 255.0f);
    }
}

GLfloat transfer_depth(const context *gl, GLfloat depth)
{
    return clamped(depth * gl->transfer.depth_scale + gl->transfer.depth_bias);
}

GLubyte transfer_stencil(const context *gl, unsigned index, bool shifts)
{
    const pixel_transfer_state *const t = &gl->transfer;
    const pixel_map *const map = &gl->map[MAP_S_TO_S];

    if (shifts) {
        const unsigned shift = (unsigned)t->index_shift;
        const unsigned distance = t->index_shift < 0 ? 0u - shift : shift;

        index = distance > 31 ? 0 : t->index_shift < 0 ? index >> distance : index << distance;
        index = (index + (unsigned)t->index_offset) & 0xFFu;
    }
    if (t->map_stencil) {
        const GLfloat value = map->value[index & (unsigned)(map->size - 1)];

        index = fabsf(value) < 0x1p31f ? (unsigned)(GLint)value : 0;
    }
    return (GLubyte)index;
}
