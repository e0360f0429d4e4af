/* Where the texels of a level lie, and how they are loaded. */
#ifndef GN_TEXTURE_TEXEL_LAYOUT_H
#define GN_TEXTURE_TEXEL_LAYOUT_H

#include <gnomon/lookup.h>

#include "../formats/pixel_layout.h"

/* Where the texels of a level lie, in bytes from the first one. An index is the sum of a column, a
 * row and a layer, each times its unit. The units are 1 if texels are loaded one by one. */
typedef struct texel_layout {
    const unsigned char *texels;
    ptrdiff_t row_stride, layer_stride;
    bool has_layers;
    gn_format format;
    pixel_layout indexed; /* how texels are loaded by indices; LAYOUT_NONE: one by one */
    int32_t unit[3];
    int32_t last_eight; /* of LAYOUT_THREE_BYTES: eight bytes from it on lie within the level */
} texel_layout;

/* Writes the layout of a level of a checked texture. */
void gni_lay_out_texels(const gn_texture *texture, uint32_t level, texel_layout *out);

#endif
