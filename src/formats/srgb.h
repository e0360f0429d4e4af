/* Linear colours to the bytes of sRGB. */
#ifndef GN_FORMATS_SRGB_H
#define GN_FORMATS_SRGB_H

#include <stdint.h>

/* Entry n holds the bits of the least float that sRGB's transfer function (OpenGL 4.5 section
 * 17.3.7) and rounding to nearest take to byte n or more; entry 0, 0. */
extern const int32_t gn_srgb_thresholds[256];

#endif
