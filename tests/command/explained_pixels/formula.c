/* A parser of the report's formulas, by recursive descent, which computes as it reads. */
#include "formula.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A number of the formula. A literal may be a float or an integer: what it meets decides, so it is
 * both. */
typedef enum kind { LITERAL, FLOAT, INTEGER, TRUTH } kind;

typedef struct number {
    kind kind;
    uint32_t as_float, as_integer; /* bits; equal unless it is a literal */
} number;

static const char *at;
static char fault[512];
static uint32_t first_value, last_value;

static number formula(void);

static void set_fault(const char *why, const char *more)
{
    if (!fault[0])
        snprintf(fault, sizeof fault, "%s%.200s", why, more);
}

static number of_bits(kind k, uint32_t bits)
{
    const number n = {k, bits, bits};

    return n;
}

static number of_float(float f)
{
    return of_bits(FLOAT, bits_of_float(f));
}

static bool next_is(const char *token)
{
    while (*at == ' ')
        ++at;
    return strncmp(at, token, strlen(token)) == 0;
}

static bool take(const char *token)
{
    if (!next_is(token))
        return false;
    at += strlen(token);
    return true;
}

static void need(const char *token)
{
    if (!take(token))
        set_fault("this does not continue as a formula: ", at);
}

/* Returns word `n` of bits, which are in hexadecimal with spaces between them. */
static uint32_t bits_in(const char *bits, uint32_t n)
{
    char *end = (char *)(uintptr_t)bits;
    uint32_t word = 0;

    for (uint32_t i = 0; i <= n; ++i)
        word = (uint32_t)strtoul(end, &end, 16);
    return word;
}

/* Finds the last value of this name before the formula. */
static const report_value *find(const char *name)
{
    for (uint32_t n = last_value; n-- > first_value;)
        if (strcmp(report_words(told.values[n].name), name) == 0)
            return &told.values[n];
    return NULL;
}

static kind kind_of_value(const report_value *v)
{
    prose words = {0};
    const char *const told_value = report_words(v->value);

    prose_float(&words, float_of_bits(bits_in(report_words(v->bits), 0)));
    const bool is_float = strcmp(prose_of(&words), told_value) == 0;
    prose_free(&words);
    return strcmp(told_value, "true") == 0 || strcmp(told_value, "false") == 0 ? TRUTH
           : is_float                                                          ? FLOAT
                                                                               : INTEGER;
}

/* An element of a matrix, "m[column][row]", which is told row by row, or a part of a vector. */
static bool find_part(const char *name, number *out)
{
    char whole[128];
    const report_value *v;
    unsigned column, row;
    const char *const bracket = strchr(name, '['), *const dot = strrchr(name, '.');

    if (bracket && sscanf(bracket, "[%u][%u]", &column, &row) == 2 && row < 4) {
        snprintf(whole, sizeof whole, "%.*s row %c", (int)(bracket - name), name, "xyzw"[row]);
        v = find(whole);
        if (v)
            *out = of_bits(FLOAT, bits_in(report_words(v->bits), column));
        return v != NULL;
    }
    if (!dot || !dot[1] || !strchr("xyz", dot[1]))
        return false;
    snprintf(whole, sizeof whole, "%.*s", (int)(dot - name), name);
    v = find(whole);
    if (v)
        *out = of_bits(FLOAT, bits_in(report_words(v->bits), (uint32_t)(dot[1] - 'x')));
    return v != NULL;
}

static number named(const char *name)
{
    const report_value *const v = find(name);
    number out = of_bits(INTEGER, 0);

    if (v && strcmp(report_words(v->value), "true") == 0)
        return of_bits(TRUTH, 1);
    if (v && strcmp(report_words(v->value), "false") == 0)
        return of_bits(TRUTH, 0);
    if (v && *report_words(v->bits))
        return of_bits(kind_of_value(v), bits_in(report_words(v->bits), 0));
    if (!find_part(name, &out))
        set_fault("no value was told with this name: ", name);
    return out;
}

static number literal(void)
{
    char *end;
    const float f = strtof(at, &end);
    number n = {LITERAL, bits_of_float(f), 0};

    n.as_integer = (uint32_t)strtoll(at, NULL, 0);
    if (memchr(at, '.', (size_t)(end - at)) || memchr(at, 'e', (size_t)(end - at)) || isinf(f) ||
        isnan(f))
        n = of_float(f);
    if (strncmp(at, "0x", 2) == 0)
        n = of_bits(INTEGER, (uint32_t)strtoul(at, &end, 16));
    at = end;
    return n;
}

static float as_float(number n)
{
    return float_of_bits(n.as_float);
}

static int32_t as_int(number n)
{
    return (int32_t)n.as_integer;
}

static number integer_of(float f)
{
    return of_bits(INTEGER,
                   f >= -2147483648.0f && f < 2147483648.0f ? (uint32_t)(int32_t)f : 0x80000000u);
}

/* Whether an operation of these is one of floats. */
static bool are_floats(number a, number b)
{
    return a.kind == FLOAT || b.kind == FLOAT;
}

static number lesser(number a, number b, bool greater)
{
    const bool takes_a = are_floats(a, b)
                             ? (greater ? as_float(a) > as_float(b) : as_float(a) < as_float(b))
                             : (greater ? as_int(a) > as_int(b) : as_int(a) < as_int(b));
    number r = takes_a ? a : b;

    if (r.kind == LITERAL && are_floats(a, b))
        r = of_bits(FLOAT, r.as_float);
    return r;
}

static number call(const char *name)
{
    number a[4] = {{INTEGER, 0, 0}, {INTEGER, 0, 0}, {INTEGER, 0, 0}, {INTEGER, 0, 0}};
    int count = 0;

    do {
        a[count] = formula();
    } while (++count < 4 && take(","));
    need(")");
    if (strcmp(name, "sqrt") == 0)
        return of_float(sqrtf(as_float(a[0])));
    if (strcmp(name, "floor") == 0)
        return of_float(floorf(as_float(a[0])));
    if (strcmp(name, "abs") == 0)
        return of_float(fabsf(as_float(a[0])));
    if (strcmp(name, "min") == 0 || strcmp(name, "max") == 0)
        return lesser(a[0], a[1], name[1] == 'a');
    if (strcmp(name, "clamp") == 0)
        return as_int(a[0]) < as_int(a[1]) ? a[1] : as_int(a[0]) > as_int(a[2]) ? a[2] : a[0];
    if (strcmp(name, "int") == 0)
        return integer_of(truncf(as_float(a[0])));
    if (strcmp(name, "round") == 0)
        return integer_of(rintf(as_float(a[0])));
    if (strcmp(name, "int_floor") == 0)
        return integer_of(floorf(as_float(a[0])));
    if (strcmp(name, "float") == 0)
        return of_float((float)as_int(a[0]));
    if (strcmp(name, "byte") == 0)
        return of_float((float)(a[0].as_integer >> 8 * as_int(a[1]) & 255) * (1.0f / 255.0f));
    if (strcmp(name, "to_byte") == 0) {
        const float f = rintf(255.0f * as_float(a[0]));

        return of_bits(INTEGER, !(f > 0.0f) ? 0 : f > 255.0f ? 255 : (uint32_t)f);
    }
    if (strcmp(name, "bytes") == 0)
        return of_bits(INTEGER, a[0].as_integer | a[1].as_integer << 8 | a[2].as_integer << 16 |
                                    a[3].as_integer << 24);
    set_fault("no such function: ", name);
    return a[0];
}

/* A name: letters, digits, _ and dots, then anything in brackets. */
static number name_or_call(void)
{
    char name[128];
    size_t length = 0;

    while (length < sizeof name - 1 &&
           (strspn(at, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUV"
                       "WXYZ0123456789_.") ||
            *at == '[')) {
        const size_t part = *at == '[' ? strcspn(at, "]") + 1 : 1;

        for (size_t i = 0; i < part && *at && length < sizeof name - 1; ++i)
            name[length++] = *at++;
    }
    name[length] = '\0';
    if (strcmp(name, "true") == 0 || strcmp(name, "false") == 0)
        return of_bits(TRUTH, name[0] == 't');
    if (strcmp(name, "nan") == 0 || strcmp(name, "inf") == 0)
        return of_float(name[0] == 'n' ? NAN : INFINITY);
    return take("(") ? call(name) : named(name);
}

static number primary(void)
{
    number n;

    if (take("(")) {
        n = formula();
        need(")");
        return n;
    }
    if (take("!")) {
        n = primary();
        return of_bits(TRUTH, !n.as_integer);
    }
    next_is("");
    if (*at == '-' || strspn(at, "0123456789"))
        return literal();
    if (strspn(at, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_"))
        return name_or_call();
    set_fault("this is no formula: ", at);
    return of_bits(INTEGER, 0);
}

static float float_of(char operation, float x, float y)
{
    return operation == '+' ? x + y : operation == '-' ? x - y : operation == '*' ? x * y : x / y;
}

static uint32_t integer_from(char operation, uint32_t x, uint32_t y)
{
    return operation == '+' ? x + y : operation == '-' ? x - y : x * y;
}

static number computed(char operation, number a, number b)
{
    const uint32_t f = bits_of_float(float_of(operation, as_float(a), as_float(b)));
    const uint32_t i = integer_from(operation, a.as_integer, b.as_integer);
    const number both = {LITERAL, f, i};

    return operation == '/' || are_floats(a, b)     ? of_bits(FLOAT, f)
           : a.kind == LITERAL && b.kind == LITERAL ? both
                                                    : of_bits(INTEGER, i);
}

static number product(void)
{
    number a = primary();

    for (;;)
        if (take("* "))
            a = computed('*', a, primary());
        else if (take("/ "))
            a = computed('/', a, primary());
        else
            return a;
}

static number sum(void)
{
    number a = product();

    for (;;)
        if (take("+ "))
            a = computed('+', a, product());
        else if (take("- "))
            a = computed('-', a, product());
        else
            return a;
}

/* Shifts and the operators of bits: their operands are in parentheses. */
static number of_operators(void)
{
    number a = sum();

    for (;;)
        if (take("<< "))
            a = of_bits(INTEGER, a.as_integer << (sum().as_integer & 31));
        else if (take(">> "))
            a = of_bits(INTEGER, (uint32_t)((int32_t)a.as_integer >> (sum().as_integer & 31)));
        else if (take("& ") && !next_is("&"))
            a = of_bits(INTEGER, a.as_integer & sum().as_integer);
        else if (take("^ "))
            a = of_bits(INTEGER, a.as_integer ^ sum().as_integer);
        else if (take("| "))
            a = of_bits(INTEGER, a.as_integer | sum().as_integer);
        else
            return a;
}

static number comparison(void)
{
    const number a = of_operators();

    if (take("> ")) {
        const number b = of_operators();

        return of_bits(TRUTH, are_floats(a, b) ? as_float(a) > as_float(b) : as_int(a) > as_int(b));
    }
    if (take("<= ")) {
        const number b = of_operators();

        return of_bits(TRUTH, as_float(a) <= as_float(b));
    }
    if (take("== "))
        return of_bits(TRUTH, a.as_integer == of_operators().as_integer);
    return a;
}

static number formula(void)
{
    number a = comparison();

    while (take("&& "))
        a = of_bits(TRUTH, (comparison().as_integer != 0) & (a.as_integer != 0));
    if (take("? ")) {
        const number yes = comparison();

        need(":");
        const number no = formula();
        return a.as_integer ? yes : no;
    }
    return a;
}

static bool has_bits(number n, const report_value *v)
{
    const uint32_t bits = bits_in(report_words(v->bits), 0);

    if (n.kind == TRUTH)
        return strcmp(report_words(v->value), n.as_integer ? "true" : "false") == 0;
    return n.as_float == bits || n.as_integer == bits ||
           (isnan(as_float(n)) && isnan(float_of_bits(bits)));
}

const char *formula_fault(uint32_t first, uint32_t n)
{
    const report_value *const v = &told.values[n];

    fault[0] = '\0';
    at = report_words(v->expression);
    first_value = first;
    last_value = n;
    const number result = formula();

    next_is("");
    if (*at)
        set_fault("this is no formula: ", at);
    if (!fault[0] && !has_bits(result, v))
        set_fault("the formula has another value than is told: ", report_words(v->expression));
    return fault[0] ? fault : NULL;
}
