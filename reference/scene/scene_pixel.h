/* Pixels of the colour formats beside RGBA8 and RGBA32F, channel by channel. */
#ifndef SCENE_PIXEL_H
#define SCENE_PIXEL_H

#include "scene.h"

/* The bits of a pixel's channels, red first. Gives how many there are. */
int scene_pixel_channels(const void *pixels, gn_format format, size_t index, uint32_t channel[4]);

/* Stores the pixel that has these values, each that of a pixel of the format. */
void scene_pixel_store(void *pixels, gn_format format, size_t index, const float value[4]);

/* What a clear to `value` makes of channel c, from OpenGL's conversion rules. */
uint32_t scene_clear_channel(gn_format format, int c, float value);

/* Whether two values of channel c are equal: bit for bit, but that two NaN are equal, a denormal
 * float is equal to zero, and one step is allowed to what is encoded as sRGB
 * (reference/RULES.md). */
bool scene_channels_equal(gn_format format, int c, uint32_t a, uint32_t b);

/* The number that a channel's bits stand for, in steps where the format is of integers. */
double scene_channel_value(gn_format format, uint32_t bits);

#endif
