/* Encodes linear colours as bytes of sRGB, by thresholds. */
#ifndef GN_FORMATS_SRGB_H
#define GN_FORMATS_SRGB_H

#include <stdint.h>

/* Entry n holds the bits of the least float that is encoded as byte n or more, by sRGB's transfer
 * function (OpenGL 4.5 section 17.3.7) and rounding to nearest. Entry 0 is 0. */
extern const int32_t gn_srgb_thresholds[256];

#endif
