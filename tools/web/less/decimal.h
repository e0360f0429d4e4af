/* Decimal numbers of any number of digits that a double has, times powers of two: for the
 * conversions between decimal texts and doubles, which are correctly rounded. */
#ifndef LESS_DECIMAL_H
#define LESS_DECIMAL_H

#include <stdbool.h>
#include <stdint.h>

/* No double, and no middle between two, has more than 768 significant digits. */
#define DECIMAL_DIGITS 1024

/* 0.d d d ... times 10^point. The first digit and the last one are not 0; zero has no digits. */
typedef struct decimal {
    uint8_t digits[DECIMAL_DIGITS];
    int count, point;
    bool has_more; /* digits behind the last one, not all 0, were left out */
} decimal;

/* Multiplies by 2^bits; bits may be negative. */
void decimal_scale(decimal *d, int bits);

/* The nearest whole number, of two the even one. The number is below 2^63. */
uint64_t decimal_round(const decimal *d);

/* Removes zeros at both ends. */
void decimal_trim(decimal *d);

#endif
