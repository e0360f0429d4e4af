/* Reads TGA files. The specification's fields are numbered as in its chapter on the file format. */
#include "image_tga.h"

#include <stdio.h>
#include <string.h>

enum { HEADER_SIZE = 18, FOOTER_SIZE = 26, EXTENSION_SIZE = 495, ATTRIBUTES_TYPE = 494 };

/* Field 3, the image type: one of these, plus COMPRESSED. */
enum { MAPPED = 1, TRUE_COLOR = 2, GREY = 3, COMPRESSED = 8 };

/* Field 24, the attributes type: what alpha means. Smaller values say that it means nothing. */
enum { ALPHA_IS_USEFUL = 3, ALPHA_IS_PREMULTIPLIED = 4 };

/* A packet of run lengths has at most this many pixels, behind one byte. */
enum { PACKET_PIXELS = 128 };

static const char cut_short[] = "the file is cut short";
static char reason_text[128];

static uint32_t little_endian_16(const uint8_t *b)
{
    return b[0] | (uint32_t)b[1] << 8;
}

/* The bytes of a pixel or an entry. */
static uint32_t bytes_of(uint32_t bits)
{
    return (bits + 7) / 8;
}

bool image_is_tga(const uint8_t *bytes, size_t size)
{
    if (size < HEADER_SIZE || bytes[1] > 1)
        return false;
    const uint32_t type = bytes[2], kind = type & ~(uint32_t)COMPRESSED;
    const uint32_t bits = bytes[16];
    return kind >= MAPPED && kind <= GREY && (kind != MAPPED || bytes[1] == 1) &&
           (bits == 8 || bits == 15 || bits == 16 || bits == 24 || bits == 32);
}

/* Whether a color has these bits: of a pixel, or of an entry of the colour map. */
static bool are_color_bits(uint32_t bits)
{
    return bits == 15 || bits == 16 || bits == 24 || bits == 32;
}

/* Returns null, or what is not read of the header. */
static const char *header_fault(uint32_t kind, const uint8_t *bytes, const tga_header *h)
{
    const char *what = "a pixel";
    uint32_t bits = h->bits;
    bool good = kind == TRUE_COLOR ? are_color_bits(bits) : bits == 8 || bits == 16;
    if (good && kind == MAPPED) {
        what = "an entry of the colour map";
        bits = h->map_bits;
        good = are_color_bits(bits);
    }
    if (!good) {
        snprintf(reason_text, sizeof reason_text, "a TGA of type %u with %u bits %s is not read",
                 (unsigned)bytes[2], (unsigned)bits, what);
        return reason_text;
    }
    /* Version 1 of the format allows rows in another order here; version 2 requires 0. */
    return (bytes[17] & 0xc0) != 0 ? "a TGA with interleaved rows is not read" : NULL;
}

/* Returns field 24, or ALPHA_IS_USEFUL if the file has no extension area. */
static uint32_t attributes_type(const uint8_t *bytes, size_t size)
{
    static const char mark[] = "TRUEVISION-XFILE.";
    if (size < HEADER_SIZE + FOOTER_SIZE ||
        memcmp(bytes + size - sizeof mark, mark, sizeof mark) != 0)
        return ALPHA_IS_USEFUL;
    const uint8_t *footer = bytes + size - FOOTER_SIZE;
    const uint64_t at = little_endian_16(footer) | (uint64_t)little_endian_16(footer + 2) << 16;
    if (at < HEADER_SIZE || at + EXTENSION_SIZE > size ||
        little_endian_16(bytes + at) < EXTENSION_SIZE)
        return ALPHA_IS_USEFUL;
    return bytes[at + ATTRIBUTES_TYPE];
}

const char *image_tga_header(const uint8_t *bytes, size_t size, tga_header *result)
{
    memset(result, 0, sizeof *result);
    if (size < HEADER_SIZE)
        return cut_short;
    const uint32_t kind = bytes[2] & ~(uint32_t)COMPRESSED;
    tga_header h = {.width = little_endian_16(bytes + 12),
                    .height = little_endian_16(bytes + 14),
                    .bits = bytes[16],
                    .is_compressed = (bytes[2] & COMPRESSED) != 0,
                    .is_mapped = kind == MAPPED,
                    .is_right_to_left = (bytes[17] & 0x10) != 0,
                    .is_top_down = (bytes[17] & 0x20) != 0,
                    .map_first = little_endian_16(bytes + 3),
                    .map_bits = bytes[7],
                    .map_position = (size_t)HEADER_SIZE + bytes[0]};
    h.map_length = bytes[1] == 1 ? little_endian_16(bytes + 5) : 0;
    h.pixel_position = h.map_position + h.map_length * (size_t)bytes_of(h.map_bits);
    const char *reason = header_fault(kind, bytes, &h);
    if (reason != NULL)
        return reason;
    const uint32_t type = attributes_type(bytes, size);
    const uint32_t color_bits = h.is_mapped ? h.map_bits : h.bits;
    const bool has_alpha =
        (bytes[17] & 15) != 0 && type >= ALPHA_IS_USEFUL && (color_bits == 16 || color_bits == 32);
    h.channels = (kind == GREY ? 1 : 3) + has_alpha;
    h.is_premultiplied = has_alpha && type == ALPHA_IS_PREMULTIPLIED;
    const uint64_t pixels = (uint64_t)h.width * h.height;
    h.least_size = h.pixel_position + (h.is_compressed ? (pixels + PACKET_PIXELS - 1) /
                                                             PACKET_PIXELS * (1 + bytes_of(h.bits))
                                                       : pixels * bytes_of(h.bits));
    *result = h;
    return NULL;
}

/* The nearest of 0 to 255 to a value of 0 to 31 on the same scale. */
static uint8_t from_five_bits(uint32_t value)
{
    return (uint8_t)(((value & 31) * 255 + 15) / 31);
}

/* Writes one pixel from its grey level or its colour. 16 bits are, from the highest: one of alpha,
 * five of red, of green and of blue. */
static void put_pixel(const tga_header *h, uint32_t bits, const uint8_t *from, uint8_t to[4])
{
    const bool is_grey = h->channels < 3;
    to[3] = 255;
    if (is_grey) {
        to[0] = to[1] = to[2] = from[0];
        if (h->channels == 2)
            to[3] = from[1];
    } else if (bits <= 16) {
        const uint32_t word = little_endian_16(from);
        to[0] = from_five_bits(word >> 10);
        to[1] = from_five_bits(word >> 5);
        to[2] = from_five_bits(word);
        if (h->channels == 4)
            to[3] = word >> 15 ? 255 : 0;
    } else {
        to[0] = from[2];
        to[1] = from[1];
        to[2] = from[0];
        if (h->channels == 4)
            to[3] = from[3];
    }
    for (int c = 0; c < 3 && h->is_premultiplied; ++c) {
        const uint32_t value = to[3] > 0 ? (to[c] * 255u + to[3] / 2) / to[3] : 0;
        to[c] = (uint8_t)(value < 255 ? value : 255);
    }
}

/* Writes one pixel of the file. Returns null, or what is wrong with it. */
static const char *decode_pixel(const uint8_t *bytes, const tga_header *h, const uint8_t *from,
                                uint8_t to[4])
{
    if (!h->is_mapped) {
        put_pixel(h, h->bits, from, to);
        return NULL;
    }
    const uint32_t index = h->bits == 16 ? little_endian_16(from) : from[0];
    /* Below the first index the difference wraps around to a large number. */
    if (index - h->map_first >= h->map_length) {
        snprintf(reason_text, sizeof reason_text,
                 "a pixel of the TGA names entry %u of a colour map with %u entries from %u on",
                 (unsigned)index, (unsigned)h->map_length, (unsigned)h->map_first);
        return reason_text;
    }
    const size_t entry = (size_t)(index - h->map_first) * bytes_of(h->map_bits);
    put_pixel(h, h->map_bits, bytes + h->map_position + entry, to);
    return NULL;
}

const char *image_tga_pixels(const uint8_t *bytes, size_t size, const tga_header *header,
                             bool bottom_first, uint8_t *result)
{
    const tga_header *h = header;
    const size_t width = h->width, pixel_size = bytes_of(h->bits);
    const bool rows_turn = h->is_top_down == bottom_first;
    size_t at = h->pixel_position;
    uint32_t left = 0; /* pixels of the packet */
    bool is_run = false;
    for (uint32_t row = 0; row < h->height; ++row) {
        uint8_t *to = result + 4 * width * (rows_turn ? h->height - 1 - row : row);
        for (size_t column = 0; column < width; ++column) {
            if (h->is_compressed && left == 0) {
                if (at >= size)
                    return cut_short;
                left = (bytes[at] & 127u) + 1;
                is_run = bytes[at] > 127;
                ++at;
            }
            if (at > size || size - at < pixel_size)
                return cut_short;
            const char *reason = decode_pixel(
                bytes, h, bytes + at, to + 4 * (h->is_right_to_left ? width - 1 - column : column));
            if (reason != NULL)
                return reason;
            left -= h->is_compressed;
            if (!is_run || left == 0)
                at += pixel_size;
        }
    }
    return NULL;
}
