/* Text that grows, and numbers as text. */
#include "prose.h"

#include <stdlib.h>
#include <string.h>

const char *prose_of(const prose *t)
{
    return t->at ? t->at : "";
}

void prose_free(prose *t)
{
    free(t->at);
    memset(t, 0, sizeof *t);
}

void prose_clear(prose *t)
{
    t->length = 0;
    if (t->at)
        t->at[0] = 0;
}

static bool make_room(prose *t, size_t more)
{
    if (t->failed)
        return false;
    if (t->length + more + 1 > t->room) {
        const size_t room = 2 * (t->length + more + 1) + 62;
        char *const at = realloc(t->at, room);

        if (!at) {
            t->failed = true;
            return false;
        }
        t->at = at;
        t->room = room;
    }
    return true;
}

static void put_some(prose *t, const char *words, size_t count)
{
    if (!make_room(t, count))
        return;
    memcpy(t->at + t->length, words, count);
    t->length += count;
    t->at[t->length] = 0;
}

void prose_character(prose *t, char c)
{
    put_some(t, &c, 1);
}

void prose_put(prose *t, const char *words)
{
    put_some(t, words, strlen(words));
}

void prose_padded(prose *t, const char *words, size_t width)
{
    size_t length = strlen(words);

    prose_put(t, words);
    for (; length < width; ++length)
        prose_character(t, ' ');
}

static void put_unsigned(prose *t, uint64_t n)
{
    char digit[20];
    int first = 20;

    do {
        digit[--first] = (char)('0' + n % 10);
        n /= 10;
    } while (n);
    put_some(t, digit + first, (size_t)(20 - first));
}

void prose_integer(prose *t, int64_t n)
{
    if (n < 0)
        prose_character(t, '-');
    put_unsigned(t, n < 0 ? 0 - (uint64_t)n : (uint64_t)n);
}

void prose_hexadecimal(prose *t, uint32_t n, int digits)
{
    while (digits-- > 0)
        prose_character(t, "0123456789abcdef"[n >> 4 * digits & 15]);
}

void prose_fraction(prose *t, int64_t numerator, int64_t denominator, int places)
{
    uint64_t scale = 1;
    const uint64_t magnitude = (uint64_t)(numerator < 0 ? -numerator : numerator);

    for (int i = 0; i < places; ++i)
        scale *= 10;
    const uint64_t d = (uint64_t)denominator;
    const uint64_t n = (magnitude * scale + d / 2) / d;

    if (numerator < 0 && n)
        prose_character(t, '-');
    put_unsigned(t, n / scale);
    if (places > 0)
        prose_character(t, '.');
    for (uint64_t place = scale / 10; place; place /= 10)
        prose_character(t, (char)('0' + n / place % 10));
}

/* Natural numbers of 320 bits, more than any number below needs: floats are multiples of 2^-149
 * below 2^128. The lowest word is first. */
#define BIG_WORDS 10

typedef struct big {
    uint32_t word[BIG_WORDS];
} big;

static void big_multiply(big *a, uint32_t factor)
{
    uint64_t carry = 0;

    for (int i = 0; i < BIG_WORDS; ++i) {
        carry += (uint64_t)a->word[i] * factor;
        a->word[i] = (uint32_t)carry;
        carry >>= 32;
    }
}

static void big_shift(big *a, int count)
{
    for (; count >= 31; count -= 31)
        big_multiply(a, 1u << 31);
    big_multiply(a, 1u << count);
}

static big big_of(uint32_t n)
{
    big a;

    memset(&a, 0, sizeof a);
    a.word[0] = n;
    return a;
}

static big big_sum(const big *a, const big *b)
{
    big sum;
    uint64_t carry = 0;

    for (int i = 0; i < BIG_WORDS; ++i) {
        carry += (uint64_t)a->word[i] + b->word[i];
        sum.word[i] = (uint32_t)carry;
        carry >>= 32;
    }
    return sum;
}

static int big_compare(const big *a, const big *b)
{
    for (int i = BIG_WORDS - 1; i >= 0; --i)
        if (a->word[i] != b->word[i])
            return a->word[i] > b->word[i] ? 1 : -1;
    return 0;
}

/* Precondition: a >= b. */
static void big_subtract(big *a, const big *b)
{
    uint64_t borrow = 0;

    for (int i = 0; i < BIG_WORDS; ++i) {
        const uint64_t take = (uint64_t)b->word[i] + borrow;

        borrow = a->word[i] < take;
        a->word[i] = (uint32_t)(a->word[i] - take);
    }
}

/* Writes the shortest decimal digits of mantissa * 2^exponent that lie within half a step to the
 * neighbouring floats (Steele and White 1990), and returns the power of ten of the first one. The
 * value is r / s; half the steps to the floats above and below are up / s and down / s. */
static int shortest_digits(uint32_t mantissa, int exponent, char digits[12], int *count)
{
    const bool at_power = mantissa == 1u << 23 && exponent > -149;
    const bool even = (mantissa & 1) == 0;
    big r = big_of(mantissa), s = big_of(1), up = big_of(1), down = big_of(1);
    int power = 0;

    /* At a power of two the float below is only half as far away. */
    big_shift(&r, (exponent > 0 ? exponent : 0) + 1 + at_power);
    big_shift(&s, (exponent < 0 ? -exponent : 0) + 1 + at_power);
    big_shift(&up, (exponent > 0 ? exponent : 0) + at_power);
    big_shift(&down, exponent > 0 ? exponent : 0);
    for (;;) {
        const big most = big_sum(&r, &up);
        const int beyond = big_compare(&most, &s);

        if (beyond < 0 || (beyond == 0 && !even))
            break;
        big_multiply(&s, 10);
        ++power;
    }
    for (;;) {
        big tenfold = big_sum(&r, &up);

        big_multiply(&tenfold, 10);
        const int within = big_compare(&tenfold, &s);
        if (within > 0 || (within == 0 && even))
            break;
        big_multiply(&r, 10);
        big_multiply(&up, 10);
        big_multiply(&down, 10);
        --power;
    }
    for (*count = 0;;) {
        int digit = 0;

        big_multiply(&r, 10);
        big_multiply(&up, 10);
        big_multiply(&down, 10);
        while (big_compare(&r, &s) >= 0) {
            big_subtract(&r, &s);
            ++digit;
        }
        const big more = big_sum(&r, &up);
        const int low = big_compare(&r, &down), high = big_compare(&more, &s);
        const bool may_stop = low < 0 || (low == 0 && even);
        const bool may_raise = high > 0 || (high == 0 && even);

        if (may_stop || may_raise) {
            const big twice = big_sum(&r, &r);

            digit += may_raise && (!may_stop || big_compare(&twice, &s) >= 0);
            digits[(*count)++] = (char)('0' + digit);
            return power - 1;
        }
        digits[(*count)++] = (char)('0' + digit);
    }
}

void prose_float(prose *t, float f)
{
    const uint32_t bits = bits_of_float(f);
    const uint32_t field = bits >> 23 & 255, fraction = bits & 0x7FFFFF;
    char digits[12];
    int count;

    if (field == 255) {
        prose_put(t, fraction ? "nan" : bits >> 31 ? "-inf" : "inf");
        return;
    }
    if (bits >> 31)
        prose_character(t, '-');
    if (!field && !fraction) {
        prose_character(t, '0');
        return;
    }
    const int power = shortest_digits(field ? fraction | 1u << 23 : fraction,
                                      field ? (int)field - 150 : -149, digits, &count);

    if (power < -5 || power > 8) {
        prose_character(t, digits[0]);
        if (count > 1)
            prose_character(t, '.');
        put_some(t, digits + 1, (size_t)count - 1);
        prose_character(t, 'e');
        prose_integer(t, power);
        return;
    }
    if (power < 0) {
        prose_put(t, "0.");
        for (int i = -1; i > power; --i)
            prose_character(t, '0');
        put_some(t, digits, (size_t)count);
        return;
    }
    for (int i = 0; i <= power || i < count; ++i) {
        if (i == power + 1)
            prose_character(t, '.');
        prose_character(t, i < count ? digits[i] : '0');
    }
}

void prose_json(prose *t, const char *words)
{
    prose_character(t, '"');
    for (; *words; ++words) {
        const unsigned char c = (unsigned char)*words;

        if (c == '"' || c == '\\') {
            prose_character(t, '\\');
            prose_character(t, (char)c);
        } else if (c == '\n') {
            prose_put(t, "\\n");
        } else if (c < 32) {
            prose_put(t, "\\u");
            prose_hexadecimal(t, c, 4);
        } else {
            prose_character(t, (char)c);
        }
    }
    prose_character(t, '"');
}
