/* Animated PNG files: a PNG whose frames follow one another without end (PNG, third edition, chunks
 * acTL, fcTL and fdAT). Programs that do not know animations show the first frame. */
#ifndef APNG_WRITE_H
#define APNG_WRITE_H

#include "png_write.h"

typedef struct apng apng;

/* Begins a file of `frames` frames of red, green, blue and alpha, 8 bits each, `rate` of which are
 * shown a second, in an open output, which stays open. Returns null with the reason printed on
 * failure. The numbers are 1 to 2^31 - 1; the rate is at most 65535. */
apng *apng_begin(output *o, uint32_t width, uint32_t height, uint32_t frames, uint32_t rate);

/* Compresses a frame, which no other frame depends on. Returns 0 with bytes from malloc, or
 * EXIT_FAULT with the reason printed, which names the output by its path. */
int apng_compress(const char *path, uint32_t width, uint32_t height, png_row *row,
                  const void *context, uint8_t **bytes, uint64_t *size);

/* Writes the next frame, as apng_compress has made it; after the last one, the file is complete.
 * Returns 0, or EXIT_FAULT with the reason printed. */
int apng_add(apng *a, const uint8_t *bytes, uint64_t size);

/* Frees what writing needed; null is allowed. */
void apng_free(apng *a);

#endif
