/* TGA files (Truevision TGA File Format Specification, version 2.0). */
#ifndef IMAGE_TGA_H
#define IMAGE_TGA_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct tga_header {
    uint32_t width, height;
    uint32_t channels;  /* that have a meaning: 1 grey, 2 grey and alpha, 3 colours, 4 and alpha */
    uint32_t bits;      /* of a pixel in the file */
    bool is_compressed; /* by run lengths */
    bool is_mapped;     /* pixels are indices of the colour map */
    bool is_right_to_left, is_top_down;
    bool is_premultiplied;          /* colours are multiplied by alpha */
    uint32_t map_first, map_length; /* the first index, and the number of entries */
    uint32_t map_bits;              /* of an entry */
    size_t map_position;            /* bytes before the colour map */
    size_t pixel_position;          /* bytes before the pixels */
    uint64_t least_size;            /* bytes of the shortest file with this header */
} tga_header;

/* Whether the bytes begin with a plausible header; a TGA has no mark. */
bool image_is_tga(const uint8_t *bytes, size_t size);

/* Reads the header, and from the extension area whether alpha has a meaning. Returns null, or why
 * the file cannot be read, valid until the next call. */
const char *image_tga_header(const uint8_t *bytes, size_t size, tga_header *result);

/* Writes the pixels as red, green, blue, alpha, with colours that are not multiplied by alpha.
 * Without attribute bits alpha is 255. Returns null, or what is wrong with the file, valid until
 * the next call; `result` then holds some of the pixels. */
const char *image_tga_pixels(const uint8_t *bytes, size_t size, const tga_header *header,
                             bool bottom_first, uint8_t *result);

#endif
