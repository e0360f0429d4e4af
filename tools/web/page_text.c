/* Builds text, and converts numbers. */
#include "page_text.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A float has at most this many significant digits, and a double holds integers of this many. */
#define FLOAT_DIGITS 9
#define MAX_DIGITS 15

void text_clear(text *t)
{
    t->length = 0;
    t->failed = false;
    if (t->chars != NULL)
        t->chars[0] = '\0';
}

void text_add_part(text *t, const char *added, size_t length)
{
    if (t->length + length + 1 > t->capacity) {
        const size_t capacity = 2 * (t->length + length) + 64;
        char *const chars = realloc(t->chars, capacity);
        t->failed = t->failed || chars == NULL;
        if (chars == NULL)
            return;
        t->chars = chars;
        t->capacity = capacity;
    }
    memcpy(t->chars + t->length, added, length);
    t->length += length;
    t->chars[t->length] = '\0';
}

void text_add(text *t, const char *added)
{
    text_add_part(t, added, strlen(added));
}

void text_add_whole(text *t, uint64_t number)
{
    char digits[20];
    size_t first = sizeof digits;
    do {
        digits[--first] = (char)('0' + number % 10);
        number /= 10;
    } while (number > 0);
    text_add_part(t, digits + first, sizeof digits - first);
}

const char *text_of(const text *t)
{
    return t->chars != NULL ? t->chars : "";
}

/* Powers of ten up to 10^22 are exact as doubles, so one multiplication or division rounds once. */
static double scaled(double value, int exponent)
{
    for (; exponent > 0 && value < DBL_MAX; --exponent) {
        double power = 10.0;
        for (int i = 1; i < 22 && exponent > 1; ++i, --exponent)
            power *= 10.0;
        value *= power;
    }
    for (; exponent < 0 && value > 0.0; ++exponent) {
        double power = 10.0;
        for (int i = 1; i < 22 && exponent < -1; ++i, ++exponent)
            power *= 10.0;
        value /= power;
    }
    return value;
}

static float float_of(uint64_t digits, int exponent)
{
    return (float)scaled((double)digits, exponent);
}

/* The power of ten of the first digit; next to a power of ten it may be off by one. */
static int exponent_of(double magnitude)
{
    int exponent = 0;
    for (; magnitude >= 10.0; magnitude /= 10.0)
        ++exponent;
    for (; magnitude < 1.0; magnitude *= 10.0)
        --exponent;
    return exponent;
}

void text_add_float(text *t, float number)
{
    const float magnitude = fabsf(number);
    uint64_t digits = 0;
    int exponent = 0;
    if (signbit(number))
        text_add(t, "-");
    if (magnitude == 0.0f) {
        text_add(t, "0");
        return;
    }
    /* magnitude is digits * 10^exponent; one digit more is tried until its bits are restored. */
    const int highest = exponent_of((double)magnitude);
    for (int count = 1; count <= FLOAT_DIGITS + 1; ++count) {
        exponent = highest - count + 1;
        digits = (uint64_t)(scaled((double)magnitude, -exponent) + 0.5);
        if (float_of(digits, exponent) == magnitude)
            break;
    }
    for (; digits % 10 == 0; digits /= 10)
        ++exponent;
    if (exponent >= 0 && exponent <= MAX_DIGITS - FLOAT_DIGITS) {
        for (; exponent > 0; --exponent)
            digits *= 10;
        text_add_whole(t, digits);
    } else if (exponent < 0 && exponent >= -MAX_DIGITS) {
        char figures[2 * MAX_DIGITS + 2];
        size_t first = sizeof figures;
        for (; exponent < 0; ++exponent, digits /= 10)
            figures[--first] = (char)('0' + digits % 10);
        figures[--first] = '.';
        text_add_whole(t, digits);
        text_add_part(t, figures + first, sizeof figures - first);
    } else {
        text_add_whole(t, digits);
        text_add(t, exponent < 0 ? "e-" : "e");
        text_add_whole(t, (uint64_t)(exponent < 0 ? -exponent : exponent));
    }
}

bool text_read_whole(const char **from, uint32_t largest, uint32_t *result)
{
    const char *c = *from;
    uint64_t number = 0;
    for (; *c >= '0' && *c <= '9' && number <= largest; ++c)
        number = 10 * number + (uint64_t)(*c - '0');
    if (c == *from || number > largest)
        return false;
    *result = (uint32_t)number;
    *from = c;
    return true;
}

/* Reads the figures of a number; digits beyond those that a double holds only count. */
static bool read_figures(const char **from, uint64_t *digits, int *exponent)
{
    bool any = false, behind_point = false;
    *digits = 0;
    *exponent = 0;
    for (;; ++*from) {
        if (**from == '.' && !behind_point) {
            behind_point = true;
            continue;
        }
        if (**from < '0' || **from > '9')
            return any;
        any = true;
        const bool fits = *digits < UINT64_C(100000000000000);
        if (fits)
            *digits = 10 * *digits + (uint64_t)(**from - '0');
        *exponent += (fits ? 0 : 1) - (behind_point ? 1 : 0);
    }
}

bool text_read_float(const char **from, float *result)
{
    const char *c = *from;
    const bool is_negative = *c == '-';
    uint64_t digits;
    int exponent;
    if (*c == '-' || *c == '+')
        ++c;
    if (!read_figures(&c, &digits, &exponent))
        return false;
    if (*c == 'e' || *c == 'E') {
        const char *power = c + 1;
        const bool is_small = *power == '-';
        uint32_t number;
        if (*power == '-' || *power == '+')
            ++power;
        if (!text_read_whole(&power, 9999, &number))
            return false;
        exponent += is_small ? -(int)number : (int)number;
        c = power;
    }
    const double magnitude = digits == 0 ? 0.0 : scaled((double)digits, exponent);
    /* From half a step above the largest float on, rounding gives infinity. */
    if (!(magnitude < 0x1.ffffffp127))
        return false;
    *result = (float)(is_negative ? -magnitude : magnitude);
    *from = c;
    return true;
}
