/* Images read from files, for textures. */
#ifndef IMAGE_H
#define IMAGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Texels as GN_FORMAT_RGBA8, bottom row first, tightly packed. */
typedef struct image {
    uint32_t width, height;
    uint32_t *texels;
} image;

/* Reads a PNG, TGA, JPEG or another format stb_image knows. False with the reason (in static
 * storage) otherwise, also where it is larger than a texture may be. */
bool image_read(const char *path, image *result, const char **reason);

/* The same from memory. */
bool image_decode(const uint8_t *bytes, size_t size, image *result, const char **reason);

void image_free(image *i);

#endif
