/* Words and numbers of a text. */
#include "text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

static bool is_line_end(char c)
{
    return c == '\n' || c == '\r';
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

text_cursor text_begin(const uint8_t *bytes, size_t size)
{
    text_cursor t = {(const char *)bytes, (const char *)bytes + size, 1, '\0', false, 1};
    if (size >= 3 && memcmp(bytes, "\xef\xbb\xbf", 3) == 0)
        t.at += 3;
    return t;
}

/* Steps over the end of a line, at which the cursor is. */
static void pass_line_end(text_cursor *t)
{
    if (*t->at == '\r' && t->end - t->at > 1 && t->at[1] == '\n')
        ++t->at;
    ++t->at;
    ++t->line;
}

/* Whether a backslash here continues the line. Blanks may stand behind it. */
static bool continues_here(const text_cursor *t)
{
    const char *c = t->at;
    if (!t->continues || *c != '\\')
        return false;
    for (++c; c < t->end && is_blank(*c);)
        ++c;
    return c == t->end || is_line_end(*c);
}

/* Steps over a backslash and the end of its line. */
static void pass_continuation(text_cursor *t)
{
    while (t->at < t->end && !is_line_end(*t->at))
        ++t->at;
    if (t->at < t->end)
        pass_line_end(t);
}

static void pass_blanks(text_cursor *t)
{
    for (;;) {
        while (t->at < t->end && is_blank(*t->at))
            ++t->at;
        if (t->at == t->end || !continues_here(t))
            return;
        pass_continuation(t);
    }
}

/* Whether the line ends here, blanks having been passed: at its end or at a comment. */
static bool ends_here(const text_cursor *t)
{
    return t->at == t->end || is_line_end(*t->at) || (t->comment != '\0' && *t->at == t->comment);
}

bool text_next_line(text_cursor *t)
{
    for (;;) {
        pass_blanks(t);
        if (t->at == t->end)
            return false;
        if (!ends_here(t)) {
            t->statement = t->line;
            return true;
        }
        while (t->at < t->end && !is_line_end(*t->at))
            ++t->at;
        if (t->at < t->end)
            pass_line_end(t);
    }
}

bool text_next_word(text_cursor *t, text_word *word)
{
    pass_blanks(t);
    word->start = t->at;
    word->length = 0;
    if (ends_here(t))
        return false;
    while (t->at < t->end && !is_blank(*t->at) && !is_line_end(*t->at) &&
           !(*t->at == '\\' && continues_here(t)))
        ++t->at;
    word->length = (size_t)(t->at - word->start);
    return true;
}

void text_pass_line(text_cursor *t)
{
    text_word word;
    while (t->at < t->end && !is_line_end(*t->at) && *t->at != '\\' && *t->at != t->comment)
        ++t->at;
    if (t->at < t->end && !is_line_end(*t->at))
        while (text_next_word(t, &word))
            ;
}

text_word text_rest(text_cursor *t)
{
    text_word word, rest;
    if (!text_next_word(t, &rest))
        return rest;
    while (text_next_word(t, &word))
        rest.length = (size_t)(word.start + word.length - rest.start);
    return rest;
}

bool text_is(text_word word, const char *expected)
{
    return strlen(expected) == word.length && memcmp(word.start, expected, word.length) == 0;
}

bool text_is_any_case(text_word word, const char *expected)
{
    if (strlen(expected) != word.length)
        return false;
    for (size_t i = 0; i < word.length; ++i)
        if (lower(word.start[i]) != lower(expected[i]))
            return false;
    return true;
}

/* The parts of a decimal number. */
typedef struct decimal {
    bool is_negative;
    uint64_t digits;  /* the first 19 significant ones, as a number */
    bool has_more;    /* digits were left out, not all 0 */
    int64_t exponent; /* the number is digits * 10^exponent */
} decimal;

/* Reads digits with or without a point. Returns the end, or null if there are none. */
static const char *read_digits(const char *at, const char *end, decimal *d)
{
    int64_t behind_point = 0;
    bool has_point = false, has_digits = false;
    for (; at < end && (is_digit(*at) || (*at == '.' && !has_point)); ++at) {
        if (*at == '.') {
            has_point = true;
            continue;
        }
        has_digits = true;
        if (d->digits < UINT64_C(1000000000000000000)) {
            d->digits = d->digits * 10 + (uint64_t)(*at - '0');
            behind_point += has_point;
        } else {
            d->has_more = d->has_more || *at != '0';
            behind_point -= !has_point;
        }
    }
    d->exponent = -behind_point;
    return has_digits ? at : NULL;
}

/* Reads an exponent, whose letter is at `at`. Returns null if there are no digits. */
static const char *read_exponent(const char *at, const char *end, decimal *d)
{
    int64_t exponent = 0;
    ++at;
    const bool is_negative = at < end && *at == '-';
    if (at < end && (*at == '-' || *at == '+'))
        ++at;
    if (at == end || !is_digit(*at))
        return NULL;
    for (; at < end && is_digit(*at); ++at)
        if (exponent < 100000)
            exponent = exponent * 10 + (*at - '0');
    d->exponent += is_negative ? -exponent : exponent;
    return at;
}

/* The C library's conversion, for what the quick one does not round correctly. If a word is too
 * long for it, as no program writes, its first 19 digits count. */
static double convert_slowly(text_word word, const decimal *d)
{
    char buffer[512];
    if (word.length >= sizeof buffer)
        snprintf(buffer, sizeof buffer, "%s%llue%lld", d->is_negative ? "-" : "",
                 (unsigned long long)d->digits, (long long)d->exponent);
    else
        snprintf(buffer, sizeof buffer, "%.*s", (int)word.length, word.start);
    for (char *c = buffer; *c != '\0'; ++c)
        if (*c == 'd' || *c == 'D')
            *c = 'e';
    return strtod(buffer, NULL);
}

/* Whether this is a spelling of a number that is none, behind its sign: inf, infinity, nan,
 * nan(...), 1.#INF, 1.#IND, 1.#QNAN, 1.#SNAN, with digits behind them. */
static bool is_nan_spelling(text_word w)
{
    static const char *const names[] = {"inf", "infinity", "nan"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i)
        if (text_is_any_case(w, names[i]))
            return true;
    if (w.length > 5 && text_is_any_case((text_word){w.start, 4}, "nan(") &&
        w.start[w.length - 1] == ')')
        return true;
    return w.length >= 6 && memcmp(w.start, "1.#", 3) == 0 &&
           (lower(w.start[3]) == 'i' || lower(w.start[3]) == 'q' || lower(w.start[3]) == 's');
}

bool text_number(text_word word, bool may_be_nan, double *value)
{
    /* Powers of ten that are exact; so is a product or quotient of one and a number below 2^53. */
    static const double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                    1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                    1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    const char *at = word.start;
    const char *const end = word.start + word.length;
    decimal d = {false, 0, false, 0};
    if (at < end && (*at == '-' || *at == '+')) {
        d.is_negative = *at == '-';
        ++at;
    }
    const text_word behind_sign = {at, (size_t)(end - at)};
    at = read_digits(at, end, &d);
    if (at != NULL && at < end && (lower(*at) == 'e' || lower(*at) == 'd'))
        at = read_exponent(at, end, &d);
    if (at != end) {
        *value = NAN;
        return may_be_nan && is_nan_spelling(behind_sign);
    }
    if (!d.has_more && d.digits < UINT64_C(1) << 53 && d.exponent >= -22 && d.exponent <= 22) {
        const double number = (double)d.digits;
        const double size =
            d.exponent < 0 ? number / powers[-d.exponent] : number * powers[d.exponent];
        *value = d.is_negative ? -size : size;
        return true;
    }
    *value = convert_slowly(word, &d);
    return isfinite(*value) || may_be_nan;
}

bool text_integer(text_word word, int64_t *value)
{
    const char *at = word.start;
    const char *const end = word.start + word.length;
    const bool is_negative = at < end && *at == '-';
    int64_t result = 0;
    if (at < end && (*at == '-' || *at == '+'))
        ++at;
    if (at == end)
        return false;
    for (; at < end; ++at) {
        if (!is_digit(*at) || result > (INT64_MAX - 9) / 10)
            return false;
        result = result * 10 + (*at - '0');
    }
    *value = is_negative ? -result : result;
    return true;
}

int text_hexadecimal(char c)
{
    return is_digit(c)            ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

const char *text_copy(text_word word, char *buffer, size_t size)
{
    const bool is_cut = word.length > size - 1;
    const size_t length = is_cut ? size - 4 : word.length;
    memcpy(buffer, word.start, length);
    memcpy(buffer + length, is_cut ? "..." : "", is_cut ? 4 : 1);
    return buffer;
}
