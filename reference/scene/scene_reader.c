/* Reading the text of a scene, token by token. */
#include "scene_reader.h"

#include <ctype.h>
#include <errno.h>
#include <inttypes.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "scene_memory.h"

void scene_reader_fail(reader *r, const char *format, ...)
{
    if (!r->failed && r->error_size) {
        const int used = snprintf(r->error, r->error_size, "line %lu: ", r->line);
        va_list arguments;

        va_start(arguments, format);
        if (used >= 0 && (size_t)used < r->error_size)
            vsnprintf(r->error + used, r->error_size - (size_t)used, format, arguments);
        va_end(arguments);
    }
    r->failed = true;
    r->token[0] = '\0';
}

const char *scene_reader_next(reader *r)
{
    size_t length = 0;
    int c = ' ';

    if (r->failed)
        return "";
    while (c == '#' || isspace(c)) {
        while (c == '#' && (c = getc(r->in)) != '\n' && c != EOF)
            c = '#';
        r->line += c == '\n';
        if (c != EOF)
            c = getc(r->in);
    }
    while (c != EOF && !isspace(c) && c != '#') {
        if (length + 1 == sizeof r->token) {
            scene_reader_fail(r, "a word of more than %d characters", (int)sizeof r->token - 1);
            return "";
        }
        r->token[length++] = (char)c;
        c = getc(r->in);
    }
    if (c != EOF)
        ungetc(c, r->in);
    r->token[length] = '\0';
    return r->token;
}

uint32_t read_number(reader *r, int base, uint32_t largest)
{
    const char *text = scene_reader_next(r);
    unsigned long long value;
    char *end;

    errno = 0;
    value = strtoull(text, &end, base);
    if (!isxdigit((unsigned char)*text) || *end || errno || value > largest) {
        scene_reader_fail(r, "a number from 0 to %" PRIu32 " expected, not '%s'", largest, text);
        return 0;
    }
    return (uint32_t)value;
}

int32_t read_integer(reader *r)
{
    const char *text = scene_reader_next(r);
    long long value;
    char *end;

    errno = 0;
    value = strtoll(text, &end, 10);
    if (end == text || *end || errno || value < INT32_MIN || value > INT32_MAX) {
        scene_reader_fail(r, "an integer of 32 bits expected, not '%s'", text);
        return 0;
    }
    return (int32_t)value;
}

int read_name(reader *r, text_names set)
{
    const char *text = scene_reader_next(r);
    const int value = text_value(set, text);

    if (value < 0) {
        scene_reader_fail(r, "'%s' is none of the values here, such as %s", text,
                          text_name(set, 0));
        return 0;
    }
    return value;
}

float read_float(reader *r)
{
    const char *text = scene_reader_next(r);
    char *end;
    float f;

    if (!strncmp(text, "nan:", 4)) {
        const uint32_t bits = (uint32_t)strtoul(text + 4, &end, 16);

        if (end == text + 12 && !*end) {
            memcpy(&f, &bits, sizeof f);
            return f;
        }
    } else {
        f = strtof(text, &end);
        if (end != text && !*end)
            return f;
    }
    scene_reader_fail(r, "a number expected, not '%s'", text);
    return 0.0f;
}

void read_floats(reader *r, float *values, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        values[i] = read_float(r);
}

uint32_t *read_words(reader *r, size_t count, uint32_t (*read)(reader *r))
{
    size_t capacity = 0;
    uint32_t *words = scene_allocate(1, sizeof *words);

    for (size_t i = 0; i < count && !r->failed; ++i) {
        if (i == capacity) {
            capacity = capacity ? 2 * capacity : 64;
            capacity = capacity < count ? capacity : count;
            words = scene_reallocate(words, capacity, sizeof *words);
        }
        words[i] = read(r);
    }
    return words;
}

uint32_t read_float_word(reader *r)
{
    const float f = read_float(r);
    uint32_t bits;

    memcpy(&bits, &f, sizeof bits);
    return bits;
}

uint32_t read_hexadecimal_word(reader *r)
{
    return read_number(r, 16, UINT32_MAX);
}

uint32_t read_decimal_word(reader *r)
{
    return read_number(r, 10, UINT32_MAX);
}
