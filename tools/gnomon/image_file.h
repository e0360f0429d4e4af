/* Image files as bytes: their format, and whether they are complete. */
#ifndef IMAGE_FILE_H
#define IMAGE_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum image_kind {
    IMAGE_PNG,
    IMAGE_JPEG,
    IMAGE_TGA,
    IMAGE_BMP,
    IMAGE_PPM,
    IMAGE_OTHER
} image_kind;

/* The format by the first bytes. A TGA has no mark and is recognised by a plausible header. */
image_kind image_kind_of(const uint8_t *bytes, size_t size);

/* The format's name, such as "PNG". */
const char *image_kind_name(image_kind kind);

/* What a PNG's header says. */
typedef struct png_header {
    uint32_t width, height;
    uint32_t bits;   /* of each channel */
    bool has_colors; /* otherwise grey */
} png_header;

/* Returns false if the file ends before that. */
bool image_png_header(const uint8_t *bytes, size_t size, png_header *result);

/* Whether the file ends too early, as far as can be seen without decoding: a PNG by its chunks,
 * other files because their bytes cannot hold as many pixels. */
bool image_is_cut_short(image_kind kind, const uint8_t *bytes, size_t size, uint32_t width,
                        uint32_t height);

#endif
