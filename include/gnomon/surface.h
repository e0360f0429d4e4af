/** @file
 * Surfaces: images in the caller's memory that draws and clears write to.
 *
 * Row 0 is the bottom row, as in OpenGL. The row stride is signed, so that a top-down image is the
 * same surface: point `pixels` at the image's last row and give a negative stride.
 *
 * A pixel is defined by the values of its elements, not by their bytes, so that a surface means the
 * same on every byte order:
 *
 *     format             element      bits
 *     GN_FORMAT_RGBA8    uint32_t     red 0-7, green 8-15, blue 16-23, alpha 24-31
 *     GN_FORMAT_RGBA32F  4 x float    red, green, blue, alpha
 *     GN_FORMAT_D16      uint16_t     depth * 65535
 *     GN_FORMAT_D24      uint32_t     depth * 16777215 in bits 0-23, the rest 0
 *     GN_FORMAT_D32F     float        depth
 *     GN_FORMAT_D24S8    uint32_t     depth * 16777215 in bits 0-23, stencil in bits 24-31
 *     GN_FORMAT_D32FS8   float,       depth,
 *                        uint32_t     stencil in bits 0-7, the rest 0
 *     GN_FORMAT_S8       uint8_t      stencil
 *     GN_FORMAT_BGRA8    uint32_t     blue 0-7, green 8-15, red 16-23, alpha 24-31
 *     GN_FORMAT_R8       uint8_t      red
 *     GN_FORMAT_RG8      uint16_t     red 0-7, green 8-15
 *     GN_FORMAT_RGB8     3 x uint8_t  red, green, blue
 *     GN_FORMAT_RGB565   uint16_t     blue 0-4, green 5-10, red 11-15
 *     GN_FORMAT_RGB5_A1  uint16_t     alpha 0, blue 1-5, green 6-10, red 11-15
 *     GN_FORMAT_RGBA4    uint16_t     alpha 0-3, blue 4-7, green 8-11, red 12-15
 *     GN_FORMAT_R16      uint16_t     red
 *     GN_FORMAT_RGBA16   4 x uint16_t red, green, blue, alpha
 *     GN_FORMAT_R32F     float        red
 *     GN_FORMAT_RGBA16F  4 x uint16_t red, green, blue, alpha as IEEE binary16
 *     GN_FORMAT_SRGB8_A8 uint32_t     as RGBA8; red, green and blue encoded as sRGB
 *     GN_FORMAT_RG16F    uint32_t     red 0-15, green 16-31 as IEEE binary16
 *     GN_FORMAT_RGB565_SWAPPED
 *                        2 x uint8_t  as RGB565, with bits 8-15 in the first byte and 0-7 in the
 *                                     second: the order that displays on SPI take
 *     GN_FORMAT_RGB10_A2 uint32_t     red 0-9, green 10-19, blue 20-29, alpha 30-31
 *     GN_FORMAT_R11F_G11F_B10F
 *                        uint32_t     red 0-10, green 11-21, blue 22-31, as floats without
 *                                     sign: 6, 6 and 5 bits of fraction, and above them 5 bits
 *                                     of exponent, as in IEEE binary16
 *     GN_FORMAT_RGB32F   3 x float    red, green, blue
 *
 * A channel that is not a float holds a fraction of its largest value. Channels that a format lacks
 * are not stored. Pixels and strides are aligned to the size of an element. On a little-endian
 * machine GN_FORMAT_RGBA8 is the bytes R, G, B, A. */
#ifndef GNOMON_SURFACE_H
#define GNOMON_SURFACE_H

#include <stddef.h>
#include <stdint.h>

#include "api.h"
#include "status.h"

/** The largest width or height of a surface, texture or viewport, in pixels. */
#define GN_MAX_SIZE 16384

/** The formats of pixels; the table at the top describes them. */
typedef enum gn_format {
    GN_FORMAT_NONE = 0, /**< no surface */
    GN_FORMAT_RGBA8,
    GN_FORMAT_RGBA32F,
    GN_FORMAT_D16,
    GN_FORMAT_D24,
    GN_FORMAT_D32F,
    GN_FORMAT_D24S8,
    GN_FORMAT_D32FS8,
    GN_FORMAT_S8,
    GN_FORMAT_BGRA8,
    GN_FORMAT_R8,
    GN_FORMAT_RG8,
    GN_FORMAT_RGB8,
    GN_FORMAT_RGB565,
    GN_FORMAT_RGB5_A1,
    GN_FORMAT_RGBA4,
    GN_FORMAT_R16,
    GN_FORMAT_RGBA16,
    GN_FORMAT_R32F,
    GN_FORMAT_RGBA16F,
    GN_FORMAT_SRGB8_A8,
    GN_FORMAT_RG16F,
    GN_FORMAT_RGB565_SWAPPED,
    GN_FORMAT_RGB10_A2,
    GN_FORMAT_R11F_G11F_B10F,
    GN_FORMAT_RGB32F
} gn_format;

/** An image in the caller's memory. */
typedef struct gn_surface {
    void *pixels;         /**< the leftmost pixel of row 0, the bottom row */
    ptrdiff_t row_stride; /**< bytes from a row to the one above it */
    uint32_t width;       /**< in pixels, 1 to GN_MAX_SIZE */
    uint32_t height;      /**< in pixels, 1 to GN_MAX_SIZE */
    gn_format format;     /**< GN_FORMAT_NONE: no surface, the other members are ignored */

    /** For a multisampled surface; pixels and row_stride are then those of sample 0. */
    uint32_t samples;        /**< per pixel: 0 and 1 mean one, otherwise GN_SAMPLES */
    ptrdiff_t sample_stride; /**< bytes from a sample to the next; ignored with one sample */
} gn_surface;

/** Samples per pixel of a multisampled surface. Each sample is a plane of its own, laid out as a
 * surface with one sample. Measured from the pixel's lower left corner, samples 0 to 3 lie at
 * (0.375, 0.125), (0.875, 0.375), (0.125, 0.625) and (0.625, 0.875). */
#define GN_SAMPLES 4

/** Colours that a draw can write at once: COLOR_ATTACHMENT0 and so on. */
#define GN_MAX_COLORS 8

/**
 * The surfaces that a draw writes to.
 *
 *     field   OpenGL                                       zero value
 *     color   DrawBuffer of COLOR_ATTACHMENT0 and so on    NONE
 *     depth   DEPTH_ATTACHMENT, STENCIL_ATTACHMENT or both none
 *
 * A zeroed member is an absent surface. At least one surface must be present. All surfaces have the
 * same size and number of samples, and no two may overlap. */
typedef struct gn_target {
    gn_surface color[GN_MAX_COLORS]; /**< any formats of colours; some may be absent */
    gn_surface depth;                /**< depth, stencil or both: GN_FORMAT_D16 to GN_FORMAT_S8 */
} gn_target;

GN_BEGIN

/** Returns the bytes of one pixel of a format; 0 for GN_FORMAT_NONE and for a value that is no
 * gn_format. */
GN_API size_t gn_format_size(gn_format format);

/** Returns a surface over tightly packed memory whose first row is row 0. Nothing is checked. */
GN_API gn_surface gn_surface_bottom_up(void *memory, gn_format format, uint32_t width,
                                       uint32_t height);

/** Returns a surface over tightly packed memory whose first row is the top row, as image files have
 * it. Nothing is checked. */
GN_API gn_surface gn_surface_top_down(void *memory, gn_format format, uint32_t width,
                                      uint32_t height);

/** Returns rows first to first + count - 1 of a surface as a surface of its own, for example to
 * divide a clear among threads. For no rows, for rows that the surface does not have, for null
 * pixels and for a null pointer, returns a zeroed surface, which is absent. */
GN_API gn_surface gn_surface_rows(const gn_surface *surface, uint32_t first, uint32_t count);

/** Returns a multisampled surface over GN_SAMPLES tightly packed images, one after the other.
 * `image` is the image of sample 0; the others are laid out like it. For a null pointer returns a
 * zeroed surface. */
GN_API gn_surface gn_surface_multisampled(const gn_surface *image);

/** Returns one sample of a surface as a surface with one sample, to read, clear or draw to that
 * sample only. For samples that the surface does not have, and for a null pointer, returns a zeroed
 * surface. */
GN_API gn_surface gn_surface_sample(const gn_surface *surface, uint32_t sample);

/** Returns the first fault of a target, in this order: a null pointer (GN_NULL_POINTER); no surface
 * at all (GN_NO_SURFACE); then the faults of each colour in turn and of depth; then sizes or
 * numbers of samples that differ (GN_SIZE_MISMATCH); last GN_NOT_COMPILED: in a GN_BASIC library a
 * first colour other than RGBA8, RGBA32F, RGB565 and RGB565_SWAPPED, a second colour, or stencil.
 * The faults of a surface, in this order:
 * - GN_INVALID_FORMAT: a format that does not belong there;
 * - GN_INVALID_SIZE: a width or height of 0 or above GN_MAX_SIZE;
 * - GN_NULL_POINTER: null pixels;
 * - GN_MISALIGNED: pixels not aligned, or a row stride that is not, even of one row;
 * - GN_INVALID_STRIDE: a row stride shorter than a row, or so long that the rows do not fit memory
 *   (with one row any length is allowed);
 * - GN_INVALID_SAMPLES: a number of samples that is not 0, 1 or GN_SAMPLES;
 * - GN_NOT_COMPILED: several samples in a library compiled without them;
 * - GN_MISALIGNED: a sample stride that is not aligned;
 * - GN_INVALID_STRIDE: a sample stride shorter than a row, or so long that the samples do not fit
 *   memory. Other overlaps of samples are not checked. */
GN_API gn_status gn_target_check(const gn_target *target);

/** Fills a colour surface, all its samples, with one colour (OpenGL 4.5 section 17.4.3). In a
 * channel of n bits, c is stored as c * (2^n - 1): the product is rounded to binary32. It is
 * then rounded to the nearest integer, halves to even. Values below 0 and NaN are stored as 0,
 * values from 1 up as 2^n - 1. Floats of 32 bits are stored as they are, those of 16 bits are
 * rounded toward zero, those of 11 and 10 bits to nearest, halves to even. Every NaN is stored as
 * gnomon/backend.h says. Red, green and blue of GN_FORMAT_SRGB8_A8 are exactly the nearest values
 * of sRGB. A bad surface returns the statuses of gn_target_check; a format that the library was
 * compiled without returns GN_NOT_COMPILED. */
GN_API gn_status gn_clear_color(const gn_surface *surface, float red, float green, float blue,
                                float alpha);

/** Fills a depth surface with one depth, clamped to 0..1 (NaN becomes 0). GN_FORMAT_D16 and D24
 * hold round-half-even(depth * (2^n - 1)), computed exactly. Stencil keeps its values. A surface
 * that is bad or has no depth returns the statuses of gn_target_check. This clear and the next two
 * return GN_NOT_COMPILED for formats with stencil in a GN_BASIC library. */
GN_API gn_status gn_clear_depth(const gn_surface *surface, float depth);

/** Fills the stencil of a surface; depth keeps its values. A surface that is bad or has no stencil
 * returns the statuses of gn_target_check. */
GN_API gn_status gn_clear_stencil(const gn_surface *surface, uint8_t stencil);

/** Fills depth and stencil at once, which is faster than two clears. If the surface has only one of
 * the two, fills that one. A surface that is bad or has neither returns the statuses of
 * gn_target_check. */
GN_API gn_status gn_clear_depth_stencil(const gn_surface *surface, float depth, uint8_t stencil);

/** Reduces a surface with several samples, `from`, to one sample per pixel, in `to` (OpenGL's
 * BlitFramebuffer from a multisampled framebuffer). Colours are averaged: (s0 + s1 + s2 + s3) / 4
 * in binary32, added from left to right, for sRGB in linear colours, and converted as a
 * fragment's colour is. For depth and stencil, sample 0 is taken. A surface with one sample is
 * copied. Returns the faults of gn_target_check for each of the two surfaces, GN_INVALID_SAMPLES if
 * `to` has more than one sample, GN_INVALID_FORMAT if the formats differ, GN_SIZE_MISMATCH. A
 * GN_BASIC library returns GN_NULL_POINTER or GN_NOT_COMPILED. The surfaces must not overlap,
 * except that `to` may be sample 0 of `from`. */
GN_API gn_status gn_resolve(const gn_surface *to, const gn_surface *from);

GN_END

#endif
