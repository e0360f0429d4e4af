/* Text that grows: words and numbers, written without the C library's formatted output, so that the
 * page's module needs none. If memory runs out the text ends early and `failed` is set. */
#ifndef EXPLAIN_PROSE_H
#define EXPLAIN_PROSE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct prose {
    char *at; /* ends with a zero; null while nothing was written */
    size_t length, room;
    bool failed;
} prose;

/* Returns the text, "" if nothing was written. */
const char *prose_of(const prose *t);

void prose_free(prose *t);

/* Empties the text but keeps its memory. */
void prose_clear(prose *t);

void prose_character(prose *t, char c);
void prose_put(prose *t, const char *words);

/* Writes words, then spaces until they fill `width` characters. */
void prose_padded(prose *t, const char *words, size_t width);

void prose_integer(prose *t, int64_t n);

/* Writes `digits` hexadecimal digits. */
void prose_hexadecimal(prose *t, uint32_t n, int digits);

/* Writes the shortest decimal number that no other float is nearer to: it restores the float's
 * bits. NaN is "nan", infinity "inf". */
void prose_float(prose *t, float f);

/* Writes numerator / denominator with `places` decimal places, rounded to nearest. Preconditions:
 * the denominator is above 0; both are below 2^60 / 10^places in magnitude. */
void prose_fraction(prose *t, int64_t numerator, int64_t denominator, int places);

/* Writes words as a JSON string with its quotes. */
void prose_json(prose *t, const char *words);

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
