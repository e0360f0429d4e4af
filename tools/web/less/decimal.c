/* Decimal numbers times powers of two, digit by digit. */
#include "decimal.h"

#include <string.h>

/* The bits of one step: a digit times 2^STEP, and ten times what is below 2^STEP, fit 64 bits. */
#define STEP 27

void decimal_trim(decimal *d)
{
    int zeros = 0;
    while (d->count > 0 && d->digits[d->count - 1] == 0)
        --d->count;
    while (zeros < d->count && d->digits[zeros] == 0)
        ++zeros;
    memmove(d->digits, d->digits + zeros, (size_t)(d->count - zeros));
    d->count -= zeros;
    d->point = d->count > 0 ? d->point - zeros : 0;
}

/* Divides by 2^bits, from the first digit to the last. */
static void divide(decimal *d, int bits)
{
    const uint64_t below = (UINT64_C(1) << bits) - 1;
    const decimal from = *d;
    uint64_t rest = 0;
    d->count = 0;
    for (int i = 0; i < from.count || rest != 0; ++i) {
        rest = 10 * rest + (i < from.count ? from.digits[i] : 0);
        if (d->count < DECIMAL_DIGITS)
            d->digits[d->count++] = (uint8_t)(rest >> bits);
        else
            d->has_more = d->has_more || rest >> bits != 0;
        rest &= below;
    }
    decimal_trim(d);
}

/* Multiplies by 2^bits, from the last digit to the first. */
static void multiply(decimal *d, int bits)
{
    uint8_t before[DECIMAL_DIGITS];
    uint64_t carry = 0;
    int more = 0;
    for (int i = d->count - 1; i >= 0; --i) {
        carry += (uint64_t)d->digits[i] << bits;
        d->digits[i] = (uint8_t)(carry % 10);
        carry /= 10;
    }
    for (uint64_t c = carry; c > 0; c /= 10)
        ++more;
    memcpy(before, d->digits, (size_t)d->count);
    for (int i = more - 1; i >= 0; --i, carry /= 10)
        d->digits[i] = (uint8_t)(carry % 10);
    for (int i = 0; i < d->count; ++i)
        if (i + more < DECIMAL_DIGITS)
            d->digits[i + more] = before[i];
        else
            d->has_more = d->has_more || before[i] != 0;
    d->count = d->count + more < DECIMAL_DIGITS ? d->count + more : DECIMAL_DIGITS;
    d->point += more;
    decimal_trim(d);
}

void decimal_scale(decimal *d, int bits)
{
    while (bits != 0) {
        const int step = bits > STEP ? STEP : bits < -STEP ? -STEP : bits;
        if (step > 0)
            multiply(d, step);
        else
            divide(d, -step);
        bits -= step;
    }
}

uint64_t decimal_round(const decimal *d)
{
    uint64_t whole = 0;
    for (int i = 0; i < d->point; ++i)
        whole = 10 * whole + (i < d->count ? d->digits[i] : 0);
    if (d->point < 0 || d->point >= d->count)
        return whole;
    const uint8_t next = d->digits[d->point];
    const bool is_middle = next == 5 && d->point + 1 == d->count && !d->has_more;
    return whole + (is_middle ? whole & 1 : next >= 5);
}
