/* Images read from files, for textures. */
#ifndef IMAGE_H
#define IMAGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define IMAGE_FORMATS_IN_WORDS "PNG, JPEG, TGA, BMP or PPM"

/* Texels as GN_FORMAT_RGBA8, bottom row first, tightly packed. */
typedef struct image {
    uint32_t width, height;
    uint32_t *texels;
    uint32_t orientation; /* of a JPEG or PNG, 1 to 8; not applied (image_exif.h) */
} image;

/* The budget of images. */
typedef struct image_budget {
    uint32_t megapixels; /* of one image, in units of 2^20 pixels */
    uint64_t bytes_left; /* for the texels of all images; each image that is read uses part of it */
} image_budget;

/* A picture as its file has it, top row first: red, green, blue and alpha of each pixel. */
typedef struct image_values {
    uint32_t width, height;
    uint32_t bits;     /* 8 or 16 of each channel: values are uint8_t or uint16_t */
    uint32_t channels; /* of the file: 1 grey, 2 grey and alpha, 3 colours, 4 colours and alpha */
    char format[8];    /* "PNG" */
    void *values;      /* from malloc */
    uint32_t orientation; /* as in `image` */
} image_values;

/* Reads a PNG, JPEG, TGA, BMP or PPM. Its header is read first. The image is not decoded if it is
 * larger than the budget or than a texture may be, or if the file is too short for its size.
 * Returns false with the reason (valid until the next call). */
bool image_read(const char *path, image_budget *budget, image *result, const char **reason);

/* As image_read, from memory. */
bool image_decode(const uint8_t *bytes, size_t size, image_budget *budget, image *result,
                  const char **reason);

/* As image_read, with the values that the file has. */
bool image_read_values(const char *path, image_budget *budget, image_values *result,
                       const char **reason);

void image_free(image *i);

#endif
