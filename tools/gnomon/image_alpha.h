/* What the texels of maps mean: heights or colours, and opacity in a diffuse map. */
#ifndef IMAGE_ALPHA_H
#define IMAGE_ALPHA_H

#include "image.h"

/* Whether an image is grey: as a map of normals it holds heights, which no shader takes. */
bool image_is_grey(const image *i);

/* Sets every alpha to 255. Returns whether one was not. */
bool image_make_opaque(image *i);

/* Sets the image's alpha from another image of any size; an image without texels becomes white, of
 * the other's size. The channel is one of MTL's -imfchan: r, g, b, m (alpha) or l (luminance). For
 * any other one it is alpha if the other image has an alpha below 255, which is what exporters mean
 * that give the same file for colours and opacity, and luminance otherwise. Returns false if there
 * is not enough memory. */
bool image_set_alpha(image *i, const image *opacity, char channel);

/* Settles what alpha a diffuse map has: that of a map of opacity, if it has texels and the material
 * is translucent; its own, if the material says so; or none. Sets *left_out to whether the map has
 * alpha that nobody asked for. Returns false if there is not enough memory. */
bool image_settle_alpha(image *diffuse, const image *opacity, char channel, bool is_opaque,
                        bool has_opacity, bool *left_out);

#endif
