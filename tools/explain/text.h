/* Text that grows: words and numbers, written without the C library's formatted output, so that the
 * page's module needs none. If memory runs out the text ends early and `failed` is set. */
#ifndef EXPLAIN_TEXT_H
#define EXPLAIN_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct text {
    char *at; /* ends with a zero; null while nothing was written */
    size_t length, room;
    bool failed;
} text;

/* Returns the text, "" if nothing was written. */
const char *text_of(const text *t);

void text_free(text *t);

/* Empties the text but keeps its memory. */
void text_clear(text *t);

void text_character(text *t, char c);
void text_put(text *t, const char *words);

/* Writes words, then spaces until they fill `width` characters. */
void text_padded(text *t, const char *words, size_t width);

void text_integer(text *t, int64_t n);

/* Writes `digits` hexadecimal digits. */
void text_hexadecimal(text *t, uint32_t n, int digits);

/* Writes the shortest decimal number that no other float is nearer to: it restores the float's
 * bits. NaN is "nan", infinity "inf". */
void text_float(text *t, float f);

/* Writes numerator / denominator with `places` decimal places, rounded to nearest. Preconditions:
 * the denominator is above 0; both are below 2^60 / 10^places in magnitude. */
void text_fraction(text *t, int64_t numerator, int64_t denominator, int places);

/* Writes words as a JSON string with its quotes. */
void text_json(text *t, const char *words);

static inline uint32_t bits_of_float(float f)
{
    union {
        float f;
        uint32_t u;
    } both;

    both.f = f;
    return both.u;
}

static inline float float_of_bits(uint32_t u)
{
    union {
        uint32_t u;
        float f;
    } both;

    both.u = u;
    return both.f;
}

#endif
