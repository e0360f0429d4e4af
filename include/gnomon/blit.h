/** @file
 * Blits: copy a rectangle of one surface to a rectangle of another (OpenGL's BlitFramebuffer). A
 * blit can move, mirror, scale, and convert to the other surface's format.
 *
 * A zeroed gn_blit_options is OpenGL's default:
 *
 *     field             OpenGL name              zero value
 *     filter            filter argument          GN_BLIT_NEAREST
 *     scissor           SCISSOR_TEST             nothing is cut off
 *     depth_disabled    not DEPTH_BUFFER_BIT     depth is blitted
 *     stencil_disabled  not STENCIL_BUFFER_BIT   stencil is blitted
 *
 * Blits behave as if FRAMEBUFFER_SRGB were enabled: colours of GN_FORMAT_SRGB8_A8 are decoded when
 * they are read and encoded when they are written. To leave them as stored, describe the same
 * memory as GN_FORMAT_RGBA8. */
#ifndef GNOMON_BLIT_H
#define GNOMON_BLIT_H

#include <stdbool.h>

#include "pipeline.h"
#include "surface.h"

/** The pixels between two corners, whose coordinates are from -GN_MAX_SIZE to GN_MAX_SIZE. If x0 is
 * above x1, or y0 above y1, the same rectangle is read or written backwards. */
typedef struct gn_rectangle {
    int32_t x0, y0;
    int32_t x1, y1;
} gn_rectangle;

/** Which pixels of the source a pixel is made of. */
typedef enum gn_blit_filter {
    GN_BLIT_NEAREST = 0, /**< the nearest one */
    GN_BLIT_LINEAR       /**< the four around it, weighted by distance; for colours only */
} gn_blit_filter;

/** What a blit does besides copying. */
typedef struct gn_blit_options {
    gn_blit_filter filter;
    gn_scissor scissor;
    bool depth_disabled;   /**< the destination keeps its depth */
    bool stencil_disabled; /**< the destination keeps its stencil */
} gn_blit_options;

GN_BEGIN

/** Blits rectangle `from` of the source to rectangle `to` of the destination. The rectangles may
 * differ in size. A null rectangle means the whole surface; null options mean zeroed options. With
 * two null rectangles and surfaces of equal size, the blit converts one format to another.
 *
 * Parts of `to` outside the destination or the scissor, and parts of `from` outside the source, are
 * cut off together with their counterparts. If the sizes differ, the edge of the cut is rounded to
 * whole pixels of the destination. The pixels that are left read the same texels as without the
 * cut. A pixel whose centre falls between two texels may read either of them, with or without a
 * cut.
 *
 * A linear filter mixes the four texels around the centre of a pixel, including texels outside
 * `from`; at the sides of the source it repeats the last texel. If neither direction is scaled,
 * each pixel reads one texel, whatever the filter.
 *
 * If source and destination have the same format and no texels are mixed, pixels keep their bits.
 * Otherwise the channels of a texel become floats (channels that its format lacks are 0, 0, 0 and
 * 1), and are written as a fragment's channels are (gn_draw), with every NaN as
 * gnomon/backend.h says. Every operation is the reference's.
 *
 * On a fault nothing is written. Returns the first fault, in this order:
 * - GN_NULL_POINTER: a surface is null;
 * - GN_INVALID_ENUM: the filter is not a gn_blit_filter;
 * - what gn_target_check returns for the destination, then for the source;
 * - GN_INVALID_SAMPLES: either surface has several samples (gn_resolve makes one of them);
 * - GN_INVALID_FORMAT: one format is of colours and the other of depth or stencil; or both are of
 *   depth or stencil and differ, or are blitted with a linear filter;
 * - GN_NOT_COMPILED: a GN_BASIC library does not write the destination's colours (formats other
 *   than RGBA8, RGBA32F, RGB565 and RGB565_SWAPPED), and the formats differ or the filter is
 * linear;
 * - GN_OUT_OF_RANGE: a corner is out of range;
 * - GN_OVERLAP: the memory from the first to the last pixel that is read overlaps the memory from
 *   the first to the last pixel that may be written. So a blit from a view of the left half of an
 *   image to a view of the right half is refused. Describe the whole image twice instead, and
 *   name the halves by rectangles: surfaces with equal pixels, stride and format are allowed if
 *   the rectangles have no pixel in common. If the filter is linear, or `to` is wider or higher
 *   than `from`, `from` counts as one texel wider on each side: those texels may be read.
 *
 * Empty rectangles are no fault. */
GN_API gn_status gn_blit(const gn_surface *destination, const gn_rectangle *to,
                         const gn_surface *source, const gn_rectangle *from,
                         const gn_blit_options *options);

GN_END

#endif
