/* Clears in all formats but RGBA8 and RGBA32F: the pixel, and memory filled with it. */
#ifndef GN_SURFACES_CLEAR_PIXEL_H
#define GN_SURFACES_CLEAR_PIXEL_H

#include "../formats/encode.h"
#include "../formats/size.h"
#include "fill.h"

/* A pixel's bytes as they lie in memory. */
typedef union clear_pixel_memory {
    unsigned char byte[8];
    uint16_t half[4];
    uint32_t word[2];
} clear_pixel_memory;

typedef struct clear_pixel {
    clear_pixel_memory memory;
    uint32_t size;
} clear_pixel;

/* Returns a channel of a clear in a format whose channels do not have 8 bits: halves are rounded
 * up. */
static inline uint32_t clear_unorm(float c, uint32_t largest)
{
    const float saturated_c = !(c > 0.0f) ? 0.0f : c >= 1.0f ? 1.0f : c;

    return (uint32_t)(saturated_c * (float)largest + 0.5f);
}

/* Writes the pixel of a clear as the words that encode_colors returns. */
static inline void encode_clear(gn_format format, const float c[4], uint32_t word[2])
{
    lanes_f color[4];
    lanes_i encoded[2];
    int32_t first[GN_LANES], second[GN_LANES];

    switch (format) {
    case GN_FORMAT_RGB565:
        word[0] = clear_unorm(c[0], 31) << 11 | clear_unorm(c[1], 63) << 5 | clear_unorm(c[2], 31);
        return;
    case GN_FORMAT_RGB5_A1:
        word[0] = clear_unorm(c[0], 31) << 11 | clear_unorm(c[1], 31) << 6 |
                  clear_unorm(c[2], 31) << 1 | clear_unorm(c[3], 1);
        return;
    case GN_FORMAT_RGBA4:
        word[0] = clear_unorm(c[0], 15) << 12 | clear_unorm(c[1], 15) << 8 |
                  clear_unorm(c[2], 15) << 4 | clear_unorm(c[3], 15);
        return;
    case GN_FORMAT_R16:
    case GN_FORMAT_RGBA16:
        word[0] = clear_unorm(c[0], 65535) | clear_unorm(c[1], 65535) << 16;
        word[1] = clear_unorm(c[2], 65535) | clear_unorm(c[3], 65535) << 16;
        return;
    default:
        break;
    }
    /* The other formats are converted as fragments are, except that bytes saturate before they are
     * rounded. */
    const bool is_float = format == GN_FORMAT_R32F || format == GN_FORMAT_RGBA16F;

    for (int i = 0; i < 4; ++i)
        color[i] = is_float ? lanes_splat(c[i]) : saturated(lanes_splat(c[i]));
    encode_colors(format, color, encoded);
    lanes_i_store(first, encoded[0]);
    lanes_i_store(second, encoded[1]);
    word[0] = (uint32_t)first[0];
    word[1] = (uint32_t)second[0];
}

static inline void set_clear_pixel(clear_pixel *pixel, gn_format format, const float c[4])
{
    uint32_t word[2] = {0, 0};

    encode_clear(format, c, word);
    pixel->size = format_size(format);
    switch (pixel->size) {
    case 2:
        pixel->memory.half[0] = (uint16_t)word[0];
        break;
    case 4:
        pixel->memory.word[0] = word[0];
        break;
    case 8:
        for (int i = 0; i < 4; ++i)
            pixel->memory.half[i] = (uint16_t)(word[i / 2] >> i % 2 * 16);
        break;
    default:
        for (int i = 0; i < 3; ++i)
            pixel->memory.byte[i] = (unsigned char)(word[0] >> 8 * i);
        break;
    }
}

/* Bytes after which the pattern of every pixel size repeats in whole words. */
#define CLEAR_PATTERN 24

/* Fills `size` bytes, which are whole pixels. */
static inline void fill_pixels(unsigned char *memory, size_t size, const clear_pixel *pixel)
{
    union {
        unsigned char byte[CLEAR_PATTERN];
        int32_t word[CLEAR_PATTERN / 4];
    } pattern;
    int32_t words[GN_LANES];
    size_t head = (0 - (uintptr_t)memory) % 4;
    size_t i = 0;

    head = head < size ? head : size;
    for (uint32_t b = 0; b < CLEAR_PATTERN; ++b)
        pattern.byte[b] = pixel->memory.byte[(head + b) % pixel->size];
    for (; i < head; ++i)
        memory[i] = pixel->memory.byte[i % pixel->size];

    stored_word *const whole = (stored_word *)(void *)(memory + head);
    const size_t count = (size - head) / 4;
    if (pixel->size == 3) {
        for (size_t w = 0, n = 0; w < count; ++w) {
            whole[w] = pattern.word[n];
            n = n == 2 ? 0 : n + 1;
        }
    } else {
        GN_EACH_LANE (l)
            words[l] = pattern.word[l % 4];
        fill_words(whole, count, words);
    }
    for (i = head + 4 * count; i < size; ++i)
        memory[i] = pixel->memory.byte[i % pixel->size];
}

#endif
