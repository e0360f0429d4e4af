/* Numbers and lists of PLY files, in text and binary. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "ply.h"

const char *ply_place(const ply_source *s)
{
    return s->encoding == PLY_ASCII ? reader_line(s->r, s->line) : NULL;
}

bool ply_fail(const ply_source *s, const char *format, ...)
{
    char text[256];
    va_list values;
    va_start(values, format);
    vsnprintf(text, sizeof text, format, values);
    va_end(values);
    return reader_fail_at(s->r, ply_place(s), "%s", text);
}

static bool fail_cut_short(const ply_source *s)
{
    char name[64];
    return reader_fail(s->r, "it is cut short: it ends in %s %llu, and has %llu by its header",
                       text_copy(s->element->name, name, sizeof name),
                       (unsigned long long)s->number, (unsigned long long)s->element->count);
}

static bool has_word(const ply_source *s)
{
    text_cursor behind = s->at;
    text_word word;
    return text_next_word(&behind, &word);
}

static void pass_line(ply_source *s)
{
    while (s->at.at < s->at.end && *s->at.at != '\n' && *s->at.at != '\r')
        ++s->at.at;
}

bool ply_begin_row(ply_source *s)
{
    if (s->encoding != PLY_ASCII)
        return true;
    if (!text_next_line(&s->at))
        return s->element->property_count == 0 || fail_cut_short(s);
    s->line = s->at.statement;
    return true;
}

void ply_end_row(ply_source *s)
{
    if (s->encoding != PLY_ASCII || !has_word(s))
        return;
    char name[64];
    reader_warn(s->r, reader_line(s->r, s->at.line),
                "%s has more numbers on its line than properties; they are left out",
                text_copy(s->element->name, name, sizeof name));
    pass_line(s);
}

/* The next word of a text, on the next line if this one has no more. */
static bool next_word(ply_source *s, text_word *word)
{
    if (text_next_word(&s->at, word))
        return true;
    return (text_next_line(&s->at) && text_next_word(&s->at, word)) || fail_cut_short(s);
}

static bool read_word(ply_source *s, const ply_property *p, double *value)
{
    char copy[48], name[48], element[48];
    text_word word;
    if (!next_word(s, &word))
        return false;
    if (text_number(word, true, value))
        return true;
    s->line = s->at.line;
    return ply_fail(s, "%s of %s %llu is not a number: %s", text_copy(p->name, name, sizeof name),
                    text_copy(s->element->name, element, sizeof element),
                    (unsigned long long)s->number, text_copy(word, copy, sizeof copy));
}

/* The bits of a number of 1, 2, 4 or 8 bytes. */
static uint64_t read_bits(const uint8_t *bytes, size_t size, bool is_big)
{
    uint64_t bits = 0;
    for (size_t i = 0; i < size; ++i)
        bits |= (uint64_t)bytes[is_big ? size - 1 - i : i] << 8 * i;
    return bits;
}

static double float_of(uint32_t bits)
{
    float value;
    memcpy(&value, &bits, sizeof value);
    return (double)value;
}

static double double_of(uint64_t bits)
{
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* The value of an integer of `count` bits in two's complement. */
static double signed_of(uint64_t bits, int count)
{
    const double value = (double)bits;
    return bits >> (count - 1) != 0 ? value - ldexp(1.0, count) : value;
}

static double decode(const uint8_t *bytes, ply_type type, bool is_big)
{
    switch (type) {
    case PLY_INT8:
        return signed_of(bytes[0], 8);
    case PLY_UINT8:
        return bytes[0];
    case PLY_INT16:
        return signed_of(read_bits(bytes, 2, is_big), 16);
    case PLY_UINT16:
        return (double)read_bits(bytes, 2, is_big);
    case PLY_INT32:
        return signed_of(read_bits(bytes, 4, is_big), 32);
    case PLY_UINT32:
        return (double)read_bits(bytes, 4, is_big);
    case PLY_FLOAT32:
        return float_of((uint32_t)read_bits(bytes, 4, is_big));
    default:
        return double_of(read_bits(bytes, 8, is_big));
    }
}

bool ply_read_number(ply_source *s, const ply_property *p, ply_type type, double *value)
{
    if (s->encoding == PLY_ASCII)
        return read_word(s, p, value);
    const size_t size = ply_type_size(type);
    if ((size_t)(s->at.end - s->at.at) < size)
        return fail_cut_short(s);
    *value = decode((const uint8_t *)s->at.at, type, s->encoding == PLY_BIG_ENDIAN);
    s->at.at += size;
    return true;
}

/* The least bytes of a number: of a text, a digit and what separates it from the one before. */
static size_t least_size(const ply_source *s, ply_type type)
{
    return s->encoding == PLY_ASCII ? 2 : ply_type_size(type);
}

bool ply_read_length(ply_source *s, const ply_property *p, size_t *length)
{
    double value;
    *length = 0;
    if (!ply_read_number(s, p, p->count_type, &value))
        return false;
    const size_t left = (size_t)(s->at.end - s->at.at);
    *length = (size_t)(value >= 0.0 && value <= (double)left ? value : 0.0);
    if (value == (double)*length && *length <= left / least_size(s, p->type))
        return true;
    char name[64], element[64];
    text_copy(p->name, name, sizeof name);
    text_copy(s->element->name, element, sizeof element);
    if (!(value >= 0.0) || value != floor(value))
        return ply_fail(s, "%s of %s %llu cannot have %.9g numbers", name, element,
                        (unsigned long long)s->number, value);
    return ply_fail(s, "it is cut short: %s of %s %llu has %.9g numbers, but only %zu bytes follow",
                    name, element, (unsigned long long)s->number, value, left);
}

/* The least bytes of an element. */
static uint64_t row_size(const ply_source *s, const ply_header *h)
{
    const ply_property *const p = h->properties + s->element->first_property;
    uint64_t size = 0;
    for (size_t i = 0; i < s->element->property_count; ++i)
        size += least_size(s, p[i].is_list ? p[i].count_type : p[i].type);
    return size;
}

uint64_t ply_room(const ply_source *s, const ply_header *h)
{
    const uint64_t size = row_size(s, h), left = (uint64_t)(s->at.end - s->at.at);
    /* The last number of a text may end without a byte behind it. */
    return size > 0 ? (left + (s->encoding == PLY_ASCII)) / size : UINT64_MAX;
}

static bool has_lists(const ply_element *e, const ply_property *p)
{
    for (size_t i = 0; i < e->property_count; ++i)
        if (p[i].is_list)
            return true;
    return false;
}

static bool skip_row(ply_source *s, const ply_property *p)
{
    double value;
    if (!ply_begin_row(s))
        return false;
    for (size_t i = 0; i < s->element->property_count; ++i) {
        size_t length = 1;
        if (p[i].is_list && !ply_read_length(s, p + i, &length))
            return false;
        for (size_t k = 0; k < length; ++k)
            if (!ply_read_number(s, p + i, p[i].type, &value))
                return false;
    }
    ply_end_row(s);
    return true;
}

bool ply_skip(ply_source *s, const ply_header *h)
{
    const ply_property *const p = h->properties + s->element->first_property;
    s->number = 0;
    if (s->element->property_count == 0)
        return true;
    if (s->encoding != PLY_ASCII && !has_lists(s->element, p)) {
        s->number = ply_room(s, h);
        if (s->number < s->element->count)
            return fail_cut_short(s);
        s->at.at += row_size(s, h) * s->element->count;
        return true;
    }
    for (; s->number < s->element->count; ++s->number)
        if (!skip_row(s, p))
            return false;
    return true;
}
