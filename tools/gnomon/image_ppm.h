/* PPM and PGM files, the binary kinds with 8 bits a channel (Netpbm's ppm(5) and pgm(5)). */
#ifndef IMAGE_PPM_H
#define IMAGE_PPM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct ppm_header {
    uint32_t width, height;
    uint32_t channels; /* 1 or 3 */
    size_t size;       /* bytes before the pixels */
} ppm_header;

/* Whether the bytes begin as such a file does. */
bool image_is_ppm(const uint8_t *bytes, size_t size);

/* Reads the header. Returns null, or why the file cannot be read. */
const char *image_ppm_header(const uint8_t *bytes, size_t size, ppm_header *result);

/* Writes the pixels as red, green, blue, alpha. The file has as many bytes as the header says. */
void image_ppm_pixels(const uint8_t *bytes, const ppm_header *header, bool bottom_first,
                      uint8_t *result);

#endif
