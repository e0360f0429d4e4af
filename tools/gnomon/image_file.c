/* Reads the headers of image files. */
#include "image_file.h"

#include <string.h>

#include "image_ppm.h"
#include "image_tga.h"

/* PNG, sections 5.2 and 5.3. */
static const uint8_t png_mark[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
#define PNG_CHUNK_OVERHEAD 12

/* Deflate expands one byte to at most 1032: 258 bytes from two bits (RFC 1951). */
#define DEFLATE_RATIO 1032

#define BMP_HEADER 26 /* bytes up to the bits per pixel, in the shorter kind of header */

/* Whether the file begins with this mark; of a file shorter than the mark, all bytes are
 * compared. */
static bool begins(const uint8_t *bytes, size_t size, const void *mark, size_t length)
{
    return size > 0 && memcmp(bytes, mark, size < length ? size : length) == 0;
}

image_kind image_kind_of(const uint8_t *bytes, size_t size)
{
    if (begins(bytes, size, png_mark, sizeof png_mark))
        return IMAGE_PNG;
    if (begins(bytes, size, "\xff\xd8\xff", 3))
        return IMAGE_JPEG;
    if (begins(bytes, size, "BM", 2))
        return IMAGE_BMP;
    if (image_is_ppm(bytes, size))
        return IMAGE_PPM;
    return image_is_tga(bytes, size) ? IMAGE_TGA : IMAGE_OTHER;
}

const char *image_kind_name(image_kind kind)
{
    static const char names[][8] = {"PNG", "JPEG", "TGA", "BMP", "PPM"};
    return kind < IMAGE_OTHER ? names[kind] : "image";
}

static uint32_t big_endian_32(const uint8_t *b)
{
    return (uint32_t)b[0] << 24 | (uint32_t)b[1] << 16 | (uint32_t)b[2] << 8 | b[3];
}

bool image_png_header(const uint8_t *bytes, size_t size, png_header *result)
{
    if (size < 26)
        return false;
    *result = (png_header){big_endian_32(bytes + 16), big_endian_32(bytes + 20), bytes[24],
                           (bytes[25] & 2) != 0};
    return true;
}

/* Whether the chunks end before IEND does. */
static bool png_chunks_end(const uint8_t *bytes, size_t size)
{
    size_t at = sizeof png_mark;
    for (;;) {
        if (at > size || size - at < PNG_CHUNK_OVERHEAD)
            return true;
        size_t length = big_endian_32(bytes + at);
        if (length > size - at - PNG_CHUNK_OVERHEAD)
            return true;
        if (memcmp(bytes + at + 4, "IEND", 4) == 0)
            return false;
        at += length + PNG_CHUNK_OVERHEAD;
    }
}

/* Bits per pixel by a PNG's header, which is the first chunk: its depth times the channels of its
 * type. */
static uint64_t png_bits(const uint8_t *bytes)
{
    static const uint8_t channels[8] = {1, 0, 3, 1, 2, 0, 4, 0};
    return (uint64_t)bytes[24] * channels[bytes[25] & 7];
}

bool image_is_cut_short(image_kind kind, const uint8_t *bytes, size_t size, uint32_t width,
                        uint32_t height)
{
    const uint64_t pixels = (uint64_t)width * height;
    uint64_t least = 0;
    switch (kind) {
    case IMAGE_PNG:
        if (png_chunks_end(bytes, size))
            return true;
        if (size >= 26)
            least = pixels * png_bits(bytes) / 8 / DEFLATE_RATIO;
        break;
    case IMAGE_TGA: {
        tga_header header;
        if (image_tga_header(bytes, size, &header) == NULL)
            least = header.least_size;
        break;
    }
    case IMAGE_BMP: {
        if (size < BMP_HEADER)
            return true;
        /* Rows are multiples of 32 bits; the header of 1987 is 12 bytes long. */
        size_t bits_at = bytes[14] == 12 ? 24 : 28;
        if (size < bits_at + 2)
            return true;
        least = ((uint64_t)width * bytes[bits_at] + 31) / 32 * 4 * height + BMP_HEADER;
        break;
    }
    case IMAGE_PPM: {
        ppm_header header;
        if (image_ppm_header(bytes, size, &header) == NULL)
            least = header.size + pixels * header.channels;
        break;
    }
    default:
        break;
    }
    return size < least;
}
