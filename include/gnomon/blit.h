/* Blits: a rectangle of one surface onto a rectangle of another (OpenGL's BlitFramebuffer),
 * moved, mirrored, scaled and converted to the other's format.
 *
 * A zeroed gn_blit_options is OpenGL's default:
 *
 *   field          OpenGL name            zero value
 *   filter         the argument of that   GN_BLIT_NEAREST
 *   scissor        SCISSOR_TEST           nothing is cut off
 *   keeps_depth    DEPTH_BUFFER_BIT       depth is blitted
 *   keeps_stencil  STENCIL_BUFFER_BIT     stencil is blitted
 *
 * FRAMEBUFFER_SRGB counts as enabled: colours of GN_FORMAT_SRGB8_A8 are decoded where they are read
 * and encoded where they are written. Without it, say GN_FORMAT_RGBA8 of the same memory. */
#ifndef GNOMON_BLIT_H
#define GNOMON_BLIT_H

#include <stdbool.h>

#include "pipeline.h"
#include "surface.h"

/* The pixels between two corners, from -GN_MAX_SIZE to GN_MAX_SIZE each. Where x0 is above x1, or
 * y0 above y1, it is the same rectangle read or written backwards. */
typedef struct gn_rectangle {
    int32_t x0, y0;
    int32_t x1, y1;
} gn_rectangle;

typedef enum gn_blit_filter {
    GN_BLIT_NEAREST = 0,
    GN_BLIT_LINEAR /* of colours alone */
} gn_blit_filter;

typedef struct gn_blit_options {
    gn_blit_filter filter;
    gn_scissor scissor;
    bool keeps_depth;   /* the depth of the destination stays */
    bool keeps_stencil; /* its stencil stays */
} gn_blit_options;

GN_BEGIN

/* Blits rectangle `from` of the source onto rectangle `to` of the destination, which may differ in
 * size; null stands for the whole surface, null options for zeroed ones. With two null rectangles
 * and surfaces of one size it converts one format to another.
 *
 * What of `to` lies outside the destination or the scissor, and what lies outside the source, is
 * cut off together with its counterpart; where the sizes differ, to whole pixels of the
 * destination, and texels keep their places. A linear filter mixes the four texels around the
 * centre of a pixel, also such beyond `from`, and at the sides of the source repeats its last.
 * Where neither is scaled, each pixel has one texel, whatever the filter.
 *
 * Pixels of one format that are not mixed keep their bits. Otherwise a texel's channels become
 * floats, those that its format lacks 0, 0, 0 and 1, and are written as a fragment's are
 * (gn_draw), every NaN as 0x7FC00000 or 0x7E00. Every operation is the reference rasterizer's
 * (reference/RULES.md).
 *
 * On a fault nothing is written. The first, in this order: a null surface (GN_NULL_POINTER); a
 * filter that is none (GN_INVALID_ENUM); what gn_target_check says of the destination, of the
 * source; several samples in either (GN_INVALID_SAMPLES; gn_resolve makes one of them); formats of
 * colours and of depth or stencil, or two of the latter that
 * differ, or a linear filter of those (GN_INVALID_FORMAT); a corner out of range
 * (GN_OUT_OF_RANGE); memory of pixels that are read and of pixels that may be written
 * overlaps (GN_OVERLAP), unless both surfaces are views of one image (equal pixels, stride and
 * format) and the rectangles, that read from by one texel wider for a linear filter, have no
 * pixel in common. Empty rectangles are no fault. */
GN_API gn_status gn_blit(const gn_surface *destination, const gn_rectangle *to,
                         const gn_surface *source, const gn_rectangle *from,
                         const gn_blit_options *options);

GN_END

#endif
