/* Pixels of the colour formats, channel by channel. */
#ifndef SCENE_PIXEL_H
#define SCENE_PIXEL_H

#include "scene.h"

/* Extracts the bits of a pixel's channels, red first. Returns the number of channels. */
int scene_pixel_channels(const void *pixels, gn_format format, size_t index, uint32_t channel[4]);

/* Stores the pixel with these values; each is the bits of a channel of the format. */
void scene_pixel_store(void *pixels, gn_format format, size_t index, const float value[4]);

/* The value of channel c after a clear to `value`, from OpenGL's conversion rules. */
uint32_t scene_clear_channel(gn_format format, int c, float value);

/* Whether two values of channel c are equal: bit for bit, except that two NaN are equal, a denormal
 * float is equal to zero, and channels encoded as sRGB may differ by one step
 * (reference/RULES.md). */
bool scene_channels_equal(gn_format format, int c, uint32_t a, uint32_t b);

/* The number that the bits of channel c stand for, in steps where the format is of integers. */
double scene_channel_value(gn_format format, int c, uint32_t bits);

#endif
