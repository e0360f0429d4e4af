/* Surfaces: images in the caller's memory that draws and clears write to.
 *
 * Row 0 is the bottom row, as in OpenGL. The row stride is signed, so that a
 * top-down image is the same surface: point `pixels` at the image's last row
 * and give a negative stride.
 *
 * A pixel is made of values, never of their bytes, so that a surface means the same on
 * every byte order:
 *
 *   format             element      bits
 *   GN_FORMAT_RGBA8    uint32_t     red 0-7, green 8-15, blue 16-23, alpha 24-31
 *   GN_FORMAT_RGBA32F  4 x float    red, green, blue, alpha
 *   GN_FORMAT_D16      uint16_t     depth * 65535
 *   GN_FORMAT_D24      uint32_t     depth * 16777215 in bits 0-23, the rest 0
 *   GN_FORMAT_D32F     float        depth
 *   GN_FORMAT_D24S8    uint32_t     depth * 16777215 in bits 0-23, stencil in bits 24-31
 *   GN_FORMAT_D32FS8   float,       depth,
 *                      uint32_t     stencil in bits 0-7, the rest 0
 *   GN_FORMAT_S8       uint8_t      stencil
 *   GN_FORMAT_BGRA8    uint32_t     blue 0-7, green 8-15, red 16-23, alpha 24-31
 *   GN_FORMAT_R8       uint8_t      red
 *   GN_FORMAT_RG8      uint16_t     red 0-7, green 8-15
 *   GN_FORMAT_RGB8     3 x uint8_t  red, green, blue
 *   GN_FORMAT_RGB565   uint16_t     blue 0-4, green 5-10, red 11-15
 *   GN_FORMAT_RGB5_A1  uint16_t     alpha 0, blue 1-5, green 6-10, red 11-15
 *   GN_FORMAT_RGBA4    uint16_t     alpha 0-3, blue 4-7, green 8-11, red 12-15
 *   GN_FORMAT_R16      uint16_t     red
 *   GN_FORMAT_RGBA16   4 x uint16_t red, green, blue, alpha
 *   GN_FORMAT_R32F     float        red
 *   GN_FORMAT_RGBA16F  4 x uint16_t red, green, blue, alpha as IEEE binary16
 *   GN_FORMAT_SRGB8_A8 uint32_t     as RGBA8; red, green and blue encoded as sRGB
 *
 * Colours other than floats are fractions of their largest value, and channels that a format
 * lacks are not kept. Pixels and strides are aligned to their element.
 * On a little-endian machine GN_FORMAT_RGBA8 is the bytes R, G, B, A. */
#ifndef GNOMON_SURFACE_H
#define GNOMON_SURFACE_H

#include <stddef.h>
#include <stdint.h>

#include "api.h"
#include "status.h"

/* The largest width or height of a surface, texture or viewport, in pixels. */
#define GN_MAX_SIZE 16384

typedef enum gn_format {
    GN_FORMAT_NONE = 0, /* no surface here */
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
    GN_FORMAT_SRGB8_A8
} gn_format;

typedef struct gn_surface {
    void *pixels;         /* the leftmost pixel of row 0, the bottom row */
    ptrdiff_t row_stride; /* bytes from a row to the one above it */
    uint32_t width;       /* in pixels, 1 to GN_MAX_SIZE */
    uint32_t height;
    gn_format format; /* GN_FORMAT_NONE: an absent surface, the rest is not looked at */

    /* Of a multisampled surface; pixels and row_stride are those of its sample 0. */
    uint32_t samples;        /* of a pixel: 0 and 1 mean one, otherwise GN_SAMPLES */
    ptrdiff_t sample_stride; /* bytes from a pixel's sample to its next; with one not looked at */
} gn_surface;

/* Samples of a pixel of a multisampled surface. Each is a plane of its own, as a surface of one
 * sample has it. They lie in the pixel, from its lower left corner, at (0.375, 0.125), (0.875,
 * 0.375), (0.125, 0.625) and (0.625, 0.875). */
#define GN_SAMPLES 4

/* Colours that a draw writes at once: COLOR_ATTACHMENT0 and so on. */
#define GN_MAX_COLORS 8

/* What a draw writes to.
 *
 *   field   OpenGL                                       zero value
 *   color   DrawBuffer of COLOR_ATTACHMENT0 and so on    NONE
 *   depth   DEPTH_ATTACHMENT, STENCIL_ATTACHMENT or both none
 *
 * A zeroed member is an absent surface; at least one
 * must be there, and all have the same size and number of samples. No two may overlap. */
typedef struct gn_target {
    gn_surface color[GN_MAX_COLORS]; /* any formats of colours, some absent: holes */
    gn_surface depth;                /* depth, stencil or both: GN_FORMAT_D16 to GN_FORMAT_S8 */
} gn_target;

GN_BEGIN

/* Bytes of one pixel of a format; 0 for GN_FORMAT_NONE and for no format. */
GN_API size_t gn_format_size(gn_format format);

/* A surface over tightly packed memory, row 0 first. Nothing is checked here. */
GN_API gn_surface gn_surface_bottom_up(void *memory, gn_format format, uint32_t width,
                                       uint32_t height);

/* The same over memory whose first row is the top one, as image files have it. */
GN_API gn_surface gn_surface_top_down(void *memory, gn_format format, uint32_t width,
                                      uint32_t height);

/* Rows first to first + count - 1 of a surface, as a surface of its own: what divides a clear
 * among threads. Of rows the surface does not have, and of a null pointer, a zeroed surface,
 * which is absent. */
GN_API gn_surface gn_surface_rows(const gn_surface *surface, uint32_t first, uint32_t count);

/* A multisampled surface over GN_SAMPLES tightly packed images, one after the other, each as
 * `image` is laid out, which is that of sample 0. Of a null pointer, a zeroed surface. */
GN_API gn_surface gn_surface_multisampled(const gn_surface *image);

/* One sample of a surface, as a surface of one sample of its own: to read, clear or draw to it
 * alone. Of samples the surface does not have, and of a null pointer, a zeroed surface. */
GN_API gn_surface gn_surface_sample(const gn_surface *surface, uint32_t sample);

/* The first fault of a target, in this order: a null pointer (GN_NULL_POINTER),
 * no surface at all (GN_NO_SURFACE); then for each colour and for depth: a format
 * that does not belong there (GN_INVALID_FORMAT), a size of 0 or above
 * GN_MAX_SIZE (GN_INVALID_SIZE), null pixels (GN_NULL_POINTER), pixels or stride
 * not aligned (GN_MISALIGNED), a stride shorter than a row, or so long that the rows
 * do not fit memory (GN_INVALID_STRIDE; with one row the stride does not matter), a number of
 * samples that is not 0, 1 or GN_SAMPLES (GN_INVALID_SAMPLES) or is above 1 in a library compiled
 * without samples (GN_NOT_COMPILED), a stride of samples that is not
 * aligned or so long that they do not fit memory or shorter than a row (GN_MISALIGNED,
 * GN_INVALID_STRIDE; that samples do not overlap otherwise is not checked); last, sizes or numbers
 * of samples that differ (GN_SIZE_MISMATCH). */
GN_API gn_status gn_target_check(const gn_target *target);

/* The same fault in words that name the field, such as "depth.width is not in 1 to GN_MAX_SIZE",
 * in static storage; null where there is none. */
GN_API const char *gn_target_fault(const gn_target *target);

/* Fills a colour surface, all its samples, with one colour (OpenGL 4.5 section 17.4.3). Where a
 * channel has n bits, it is c * (2^n - 1), the product being rounded to binary32 and then to the
 * nearest integer, halves to even with 8 bits and up otherwise; 0 below 0 and for NaN, 2^n - 1 from
 * 1 up. Floats of 32 bits are stored as they are, those of 16 rounded toward zero, and every NaN as
 * gnomon/backend.h says. Red, green
 * and blue of GN_FORMAT_SRGB8_A8 are the nearest that sRGB has, exactly.
 * A bad surface gives the statuses of gn_target_check, a format that the library was compiled
 * without GN_NOT_COMPILED. */
GN_API gn_status gn_clear_color(const gn_surface *surface, float red, float green, float blue,
                                float alpha);

/* Fills a depth surface with one depth, clamped to 0..1 (NaN becomes 0).
 * GN_FORMAT_D16 and D24 hold round-half-even(depth * (2^n - 1)), computed exactly.
 * Stencil stays. A bad surface, or one without depth, gives the statuses of gn_target_check. */
GN_API gn_status gn_clear_depth(const gn_surface *surface, float depth);

/* Fills the stencil of a surface; depth stays. A bad surface, or one without stencil, gives
 * the statuses of gn_target_check. */
GN_API gn_status gn_clear_stencil(const gn_surface *surface, uint8_t stencil);

/* Both at once, of what the surface has: faster than one after the other. */
GN_API gn_status gn_clear_depth_stencil(const gn_surface *surface, float depth, uint8_t stencil);

/* Makes one sample a pixel of several (OpenGL's BlitFramebuffer from a multisampled framebuffer).
 * Colours are averaged: ((s0 + s1) + s2 + s3) / 4 in binary32, of sRGB in linear colours, and
 * converted as a fragment's colour is. Of depth and stencil sample 0 is taken. A surface with one
 * sample is copied. Faults: those of gn_target_check of one surface and the other,
 * GN_INVALID_SAMPLES where `to` has more than one sample, GN_INVALID_FORMAT where the formats
 * differ, GN_SIZE_MISMATCH, GN_NOT_COMPILED. The surfaces must not overlap, but `to` may be sample
 * 0 of `from`. */
GN_API gn_status gn_resolve(const gn_surface *to, const gn_surface *from);

GN_END

#endif
