/* How the channels of each format are decoded, as rows of a table: the code that serves all formats
 * is there once, and reads its constants from here. */
#ifndef GN_FORMATS_DECODE_TABLE_H
#define GN_FORMATS_DECODE_TABLE_H

#include <gnomon/surface.h>

typedef enum channel_kind {
    CHANNEL_FRACTION,    /* of its largest value */
    CHANNEL_FLOAT32,     /* a float of 32 bits */
    CHANNEL_SMALL_FLOAT, /* a float of `width` bits: 16, 11 or 10 */
    CHANNEL_SRGB         /* a byte, encoded along sRGB's curve */
} channel_kind;

/* A channel: bits of a word of the pixel. A fraction is masked in place and multiplied by `scale`,
 * which rounds as the number divided by its largest value does, because both differ by a power of
 * two. A number that reaches bit 31 would be negative in place, so `is_high` means that the word is
 * moved down by 16 bits before. A small float is moved to where a half has its exponent, and masked
 * there. */
typedef struct channel_decoding {
    int32_t mask;
    float scale;
    unsigned char kind, word, shift, width, is_high;
} channel_decoding;

/* Depth formats have one channel, the depth. */
typedef struct format_decoding {
    unsigned char channels, has_depth;
    channel_decoding channel[4];
} format_decoding;

/* By gn_format. The row of GN_FORMAT_NONE is 0. */
extern const format_decoding gni_decodings[];

#endif
