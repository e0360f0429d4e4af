/* Images read from files, for textures. */
#ifndef IMAGE_H
#define IMAGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define IMAGE_FORMATS_IN_WORDS "PNG, JPEG, TGA or BMP"

/* Texels as GN_FORMAT_RGBA8, bottom row first, tightly packed. */
typedef struct image {
    uint32_t width, height;
    uint32_t *texels;
} image;

/* What images may take. */
typedef struct image_budget {
    uint32_t megapixels; /* of one image, in units of 2^20 pixels */
    uint64_t bytes_left; /* for the texels of all; each image that is read takes its share */
} image_budget;

/* Reads a PNG, JPEG, TGA or BMP. Its header is read first: an image that is larger than the budget
 * or a texture may be, or whose file is too short for its size, is not decoded. False with the
 * reason (good until the next call) otherwise. */
bool image_read(const char *path, image_budget *budget, image *result, const char **reason);

/* The same from memory. */
bool image_decode(const uint8_t *bytes, size_t size, image_budget *budget, image *result,
                  const char **reason);

void image_free(image *i);

#endif
