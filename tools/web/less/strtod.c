/* Stands in for the C library's strtod, which contains its streams: they import functions of the
 * system. Reads decimal numbers only, correctly rounded. */
#include <math.h>
#include <stdlib.h>

#include "decimal.h"

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* Reads digits with or without a point. Returns false if there are none. */
static bool read_digits(const char **at, decimal *d)
{
    bool behind_point = false, any = false;
    for (; is_digit(**at) || (**at == '.' && !behind_point); ++*at) {
        if (**at == '.') {
            behind_point = true;
            continue;
        }
        any = true;
        d->point += !behind_point;
        if (d->count < DECIMAL_DIGITS)
            d->digits[d->count++] = (uint8_t)(**at - '0');
        else
            d->has_more = d->has_more || **at != '0';
    }
    return any;
}

static void read_exponent(const char **at, decimal *d)
{
    const char *c = *at + 1;
    const bool is_negative = *c == '-';
    int exponent = 0;
    c += *c == '-' || *c == '+';
    if (!is_digit(*c))
        return;
    for (; is_digit(*c); ++c)
        if (exponent < 100000)
            exponent = 10 * exponent + (*c - '0');
    d->point += is_negative ? -exponent : exponent;
    *at = c;
}

/* The nearest double: the decimal becomes a number from 1/2 to 1 times a power of two. */
static double nearest(decimal *d)
{
    int exponent = 0;
    if (d->count == 0 || d->point < -330)
        return 0.0;
    if (d->point > 310)
        return HUGE_VAL;
    /* 2^27 is below 10^9. */
    while (d->point > 0) {
        const int bits = d->point > 9 ? 27 : 1;
        decimal_scale(d, -bits);
        exponent += bits;
    }
    while (d->point < 0 || d->digits[0] < 5) {
        const int bits = d->point < -9 ? 27 : 1;
        decimal_scale(d, bits);
        exponent -= bits;
    }
    /* Below 2^-1022 doubles are multiples of 2^-1074. */
    const int kept = exponent < -1021 ? 1074 + exponent : 53;
    if (kept < 0)
        return 0.0;
    decimal_scale(d, kept);
    return ldexp((double)decimal_round(d), exponent - kept);
}

double strtod(const char *restrict text, char **restrict end)
{
    static decimal d;
    const char *at = text;
    const bool is_negative = *at == '-';
    d.count = d.point = 0;
    d.has_more = false;
    at += *at == '-' || *at == '+';
    if (!read_digits(&at, &d))
        at = text;
    else if (*at == 'e' || *at == 'E')
        read_exponent(&at, &d);
    if (end != NULL)
        *end = (char *)at;
    decimal_trim(&d);
    const double size = nearest(&d);
    return is_negative ? -size : size;
}
