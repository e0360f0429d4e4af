/* Text that grows, and numbers as text with as many digits as restore their bits. The page's
 * modules have no stdio, whose conversions are larger than everything here. */
#ifndef PAGE_TEXT_H
#define PAGE_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct text {
    char *chars; /* ends on '\0'; null before the first addition */
    size_t length, capacity;
    bool failed; /* there was not enough memory; the text is cut off */
} text;

/* Empties a text; its memory stays. A zeroed text is empty. */
void text_clear(text *t);

void text_add(text *t, const char *added);
void text_add_part(text *t, const char *added, size_t length);
void text_add_whole(text *t, uint64_t number);

/* Adds the shortest decimal number, of up to 9 digits, from which text_read_float restores the
 * float. It must be finite. */
void text_add_float(text *t, float number);

/* Returns the text; "" if nothing was added. */
const char *text_of(const text *t);

/* Reads a decimal number, such as "-1.5e-3", at *from and moves *from behind it. Returns false if
 * there is none, or if it is beyond the largest float. Numbers are correct to a few units in the
 * last place of a double before they are rounded to a float. */
bool text_read_float(const char **from, float *result);

/* Reads digits at *from and moves *from behind them. Returns false if there are none, or if the
 * number is above `largest`. */
bool text_read_whole(const char **from, uint32_t largest, uint32_t *result);

#endif
