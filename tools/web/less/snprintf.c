/* Stands in for the C library's snprintf, which contains its streams: they import functions of the
 * system. Has the conversions of tools/models: c, d, u, s and g, with l, ll, z and precisions, but
 * no widths and flags. What is behind another conversion is written as it stands. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "decimal.h"

typedef struct output {
    char *to;
    size_t size, length; /* as if there were room for everything */
} output;

static void put(output *o, char c)
{
    if (o->length + 1 < o->size)
        o->to[o->length] = c;
    ++o->length;
}

static void put_text(output *o, const char *text, int most)
{
    for (int i = 0; text[i] != '\0' && (most < 0 || i < most); ++i)
        put(o, text[i]);
}

static void put_whole(output *o, uint64_t value, int least)
{
    char digits[20];
    int count = 0;
    for (; value > 0 || count < least; value /= 10)
        digits[count++] = (char)('0' + value % 10);
    while (count > 0)
        put(o, digits[--count]);
}

/* All digits of a positive number. */
static void set_digits(decimal *d, double value)
{
    int exponent;
    uint64_t whole = (uint64_t)ldexp(frexp(value, &exponent), 53);
    d->count = d->point = 20;
    d->has_more = false;
    for (int i = 19; i >= 0; --i, whole /= 10)
        d->digits[i] = (uint8_t)(whole % 10);
    decimal_trim(d);
    decimal_scale(d, exponent - 53);
}

/* Rounds to so many digits, from a middle to the even digit. */
static void round_digits(decimal *d, int count)
{
    if (d->count <= count)
        return;
    const uint8_t *const next = d->digits + count;
    const bool is_middle = *next == 5 && d->count == count + 1;
    const bool is_up = is_middle ? (next[-1] & 1) != 0 : *next >= 5;
    d->count = count;
    for (int i = count - 1; is_up && ++d->digits[i] == 10; --i) {
        d->digits[i] = 0;
        if (i == 0) {
            d->digits[0] = 1;
            ++d->point;
            break;
        }
    }
    decimal_trim(d);
}

/* As %g. */
static void put_number(output *o, double value, int precision)
{
    static decimal d;
    const int most = precision > 0 ? precision : precision < 0 ? 6 : 1;
    if (signbit(value))
        put(o, '-');
    if (!isfinite(value)) {
        put_text(o, isnan(value) ? "nan" : "inf", -1);
        return;
    }
    set_digits(&d, fabs(value));
    round_digits(&d, most);
    const int exponent = d.count > 0 ? d.point - 1 : 0;
    const bool has_exponent = exponent < -4 || exponent >= most;
    const int point = has_exponent || d.count == 0 ? 1 : d.point;
    for (int i = point < 1 ? point - 1 : 0; i < d.count || i < point; ++i) {
        if (i == point)
            put(o, '.');
        put(o, i >= 0 && i < d.count ? (char)('0' + d.digits[i]) : '0');
    }
    if (!has_exponent)
        return;
    put_text(o, exponent < 0 ? "e-" : "e+", -1);
    put_whole(o, (uint64_t)(exponent < 0 ? -exponent : exponent), 2);
}

/* A precision: digits behind a point, or a star for an argument; -1: none is given. */
static int read_precision(const char **at, va_list *values)
{
    int precision = -1;
    if (**at != '.')
        return precision;
    ++*at;
    if (**at == '*') {
        ++*at;
        return va_arg(*values, int);
    }
    for (precision = 0; **at >= '0' && **at <= '9' && precision < 10000; ++*at)
        precision = 10 * precision + (**at - '0');
    return precision;
}

/* The size of whole numbers that a conversion's letters state. */
static size_t read_length(const char **at)
{
    if (**at == 'z') {
        ++*at;
        return sizeof(size_t);
    }
    int count = 0;
    for (; **at == 'l'; ++*at)
        ++count;
    return count == 0 ? sizeof(int) : count == 1 ? sizeof(long) : sizeof(long long);
}

/* Writes a conversion, which begins behind its %. Returns false if it is none of those here. */
static bool convert(output *o, const char **at, va_list *values)
{
    const int precision = read_precision(at, values);
    const size_t size = read_length(at);
    const char kind = *(*at)++;
    switch (kind) {
    case '%':
        put(o, '%');
        return true;
    case 'c':
        put(o, (char)va_arg(*values, int));
        return true;
    case 's':
        put_text(o, va_arg(*values, const char *), precision);
        return true;
    case 'g':
        put_number(o, va_arg(*values, double), precision);
        return true;
    case 'u':
        put_whole(o,
                  size == sizeof(unsigned) ? va_arg(*values, unsigned)
                                           : va_arg(*values, unsigned long long),
                  1);
        return true;
    case 'd': {
        const long long value =
            size == sizeof(int) ? va_arg(*values, int) : va_arg(*values, long long);
        if (value < 0)
            put(o, '-');
        put_whole(o, value < 0 ? 0 - (uint64_t)value : (uint64_t)value, 1);
        return true;
    }
    default:
        return false;
    }
}

int vsnprintf(char *restrict to, size_t size, const char *restrict format, va_list values)
{
    output o = {to, size, 0};
    bool good = true;
    va_list left;
    va_copy(left, values);
    for (const char *at = format; *at != '\0';) {
        if (*at != '%' || !good) {
            put(&o, *at++);
            continue;
        }
        const char *behind = at + 1;
        good = convert(&o, &behind, &left);
        if (good)
            at = behind;
    }
    va_end(left);
    if (size > 0)
        to[o.length < size ? o.length : size - 1] = '\0';
    return (int)o.length;
}

int snprintf(char *restrict to, size_t size, const char *restrict format, ...)
{
    va_list values;
    va_start(values, format);
    const int length = vsnprintf(to, size, format, values);
    va_end(values);
    return length;
}
