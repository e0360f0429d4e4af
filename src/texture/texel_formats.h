/* How the texels of each format are loaded and decoded, as rows of a table: the code that serves
 * all formats is there once, and reads its constants from here. */
#ifndef GN_TEXTURE_TEXEL_FORMATS_H
#define GN_TEXTURE_TEXEL_FORMATS_H

#include <gnomon/surface.h>

/* How the texels of a level are loaded: the name says how much is loaded. */
typedef enum texel_access {
    ACCESS_ONE_BY_ONE, /* by columns, rows and layers; all others by indices */
    ACCESS_BYTE,
    ACCESS_TWO_BYTES,
    ACCESS_THREE_BYTES,
    ACCESS_WORD,
    ACCESS_TWO_WORDS,
    ACCESS_FOUR_WORDS
} texel_access;

typedef enum channel_kind {
    CHANNEL_FRACTION, /* of its largest value */
    CHANNEL_WORD,     /* a float of 32 bits */
    CHANNEL_FLOAT,    /* a float of `width` bits: 16, 11 or 10 */
    CHANNEL_SRGB      /* a byte, encoded along sRGB's curve */
} channel_kind;

/* A channel: bits of a word of the texel. A fraction is masked in place and multiplied by `scale`.
 * This rounds as unorm_channel does, because scale and factor differ by a power of two. A number
 * that reaches bit 31 would be negative in place, so `is_high` means that the word is moved down by
 * 16 bits before. A small float is moved to where a half has its exponent, and masked there. */
typedef struct texel_channel {
    int32_t mask;
    float scale;
    unsigned char kind, word, shift, width, is_high;
} texel_channel;

/* Indices count 2^index_shift bytes. Depth formats have one channel, the depth. */
typedef struct texel_format {
    unsigned char access, index_shift, size, channels, has_depth;
    texel_channel channel[4];
} texel_format;

/* By gn_format. Formats that no texture has are 0. */
extern const texel_format gni_texel_formats[];

#endif
