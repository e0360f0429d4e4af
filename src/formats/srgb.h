/* Encodes linear colours as bytes of sRGB, by a table of steps. */
#ifndef GN_FORMATS_SRGB_H
#define GN_FORMATS_SRGB_H

#include <stdint.h>

/* Let a float in 0 to 1 have the upper half h and the lower half l. Its byte, by sRGB's transfer
 * function (OpenGL 4.5 section 17.3.7) and rounding to nearest, is (entry + l) >> 16 for the entry
 * h - GN_SRGB_FIRST, or for entry 0 if h is less. No two bytes begin between floats of equal upper
 * halves, so an entry knows one byte and where the next begins. */
#define GN_SRGB_FIRST 0x391E
#define GN_SRGB_STEPS (0x3F80 - GN_SRGB_FIRST + 1)

extern const int32_t gni_srgb_steps[GN_SRGB_STEPS];

#endif
