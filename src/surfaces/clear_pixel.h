/* Clears in all formats but RGBA8 and RGBA32F: the pixel, and memory filled with it. */
#ifndef GN_SURFACES_CLEAR_PIXEL_H
#define GN_SURFACES_CLEAR_PIXEL_H

#include "../formats/floats.h"
#include "../formats/pixel_memory.h"
#include "../formats/unorm.h"
#include "memory.h"
#include "../kernel/surfaces/row_work.h"

/* A pixel's bytes as they lie in memory. */
typedef union clear_pixel_memory {
    unsigned char byte[16];
    uint16_t half[8];
    uint32_t word[4];
} clear_pixel_memory;

typedef struct clear_pixel {
    clear_pixel_memory memory;
    uint32_t size;
} clear_pixel;

/* Sets the pixel that a clear to a colour stores. A format's first channel tells whether its
 * fractions have 8 bits. */
static inline void set_clear_pixel(clear_pixel *pixel, gn_format format, const float c[4])
{
    const format_fields fields = format_fields_of(format);
    float color[4];

    pixel->size = format_size(format);
    if (format_encoding_of(format) == ENCODING_UNORM && field_width(fields, 0) != 8) {
        int32_t word[4];

        for (int i = 0; i < 4; ++i) /* compilers make no call of memset of this */
            word[i] = 0;
        for (int i = 0; i < 4; ++i)
            word[field_word(fields, i)] |=
                (int32_t)(cleared_unorm(c[i], field_width(fields, i)) << field_shift(fields, i));
        store_pixel(pixel->memory.byte, 0, format_layout(format), word);
        return;
    }
    /* The other formats are converted as fragments are, except that bytes saturate before they are
     * rounded. */
    for (int i = 0; i < 4; ++i)
        color[i] = format_is_float(format) ? cleared_float(c[i], field_width(fields, i))
                   : !(c[i] > 0.0f)        ? 0.0f
                   : c[i] > 1.0f           ? 1.0f
                                           : c[i];
    gni_store_color(format, pixel->memory.byte, color);
}

/* Bytes after which the pattern of every pixel size up to 8 bytes repeats in whole words. */
#define CLEAR_PATTERN 24

/* Fills `size` bytes, which are whole pixels. */
static inline void fill_pixels(unsigned char *memory, size_t size, const clear_pixel *pixel)
{
    union {
        unsigned char byte[CLEAR_PATTERN];
        int32_t word[CLEAR_PATTERN / 4];
    } pattern;
    int32_t words[PATTERN_WORDS];
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
        for (int n = 0; n < PATTERN_WORDS; ++n)
            words[n] = pattern.word[n % 4];
        fill_words(whole, count, words);
    }
    for (i = head + 4 * count; i < size; ++i)
        memory[i] = pixel->memory.byte[i % pixel->size];
}

#endif
