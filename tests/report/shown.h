/* Frames as pictures of red, green and blue bytes, whatever their formats are. */
#ifndef REPORT_SHOWN_H
#define REPORT_SHOWN_H

#include <stdint.h>

#include "scene.h"

/* The attachment of a scene that is shown: its first colour, or SHOWN_DEPTH if it has no colour. */
#define SHOWN_DEPTH (-1)
int shown_attachment(const scene *s);

/* Writes the colour of pixel i of the frame, counted as in the frame's memory. Channels of integers
 * are scaled to 0..255, those of sRGB are shown as they are stored, those of floats are clamped to
 * 0..1 and NaN is 0. One channel is shown as grey, two as red and green. A depth is grey: 0 black,
 * 1 white; a stencil value is grey too. */
void shown_pixel(const scene_frame *frame, int attachment, size_t i, uint8_t rgb[3]);

/* The first pixel of row y, counted from the top, of the image that is shown: with several samples,
 * of the resolved image. */
size_t shown_row(const scene_frame *frame, uint32_t y);

/* Returns the number of different colours in the shown image; 0 if there is no memory. */
size_t shown_colors(const scene_frame *frame, int attachment);

/* Whether pixel i of the shown image counts as different in scene_compare: in any attachment, depth
 * or stencil of any sample or of the resolved image. */
bool shown_differs(const scene *s, const scene_frame *ours, const scene_frame *theirs, size_t i);

/* Changes every byte of the pixel in the middle of the shown image: for tests of the report. */
void shown_break(scene_frame *frame, int attachment);

#endif
