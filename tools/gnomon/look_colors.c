/* Colours of vertices. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "look_parts.h"
#include "scene_memory.h"

float look_to_linear(float encoded)
{
    const double e = (double)encoded;
    return (float)(e <= 0.04045 ? e / 12.92 : pow((e + 0.055) / 1.055, 2.4));
}

float look_to_encoded(float linear)
{
    const double l = (double)linear;
    return (float)(l <= 0.0031308 ? 12.92 * l : 1.055 * pow(l, 1.0 / 2.4) - 0.055);
}

void look_set_colors(scene_draw *draw, const look *l, const model_part *part, const part_maps *maps)
{
    const bool has_map = maps->images[MAP_DIFFUSE].texels != NULL;
    const bool is_white = has_map && maps->replaces_color && !part->has_vertex_colors;
    const bool is_opaque = part->surface.alpha == MODEL_OPAQUE || l->options->opaque;
    const bool is_linear = part->surface.has_linear_colors != 0;
    float *const colors = scene_allocate(part->vertex_count, 4 * sizeof *colors);
    memcpy(colors, part->colors, (size_t)part->vertex_count * 4 * sizeof *colors);
    for (size_t v = 0; v < part->vertex_count; ++v) {
        float *const color = colors + 4 * v;
        for (int c = 0; c < 3; ++c)
            color[c] = is_white                     ? 1.0f
                       : l->is_linear && !is_linear ? look_to_linear(color[c])
                       : !l->is_linear && is_linear ? look_to_encoded(color[c])
                                                    : color[c];
        if (is_opaque)
            color[3] = 1.0f;
    }
    scene_set_attribute(draw, GN_ATTRIBUTE_COLOR, colors, 4, part->vertex_count);
    free(colors);
}
