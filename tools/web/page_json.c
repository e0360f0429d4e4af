/* Writes JSON. */
#include "page_json.h"

#include <math.h>

void page_json_name(text *to, const char *name)
{
    const char *const before = text_of(to);
    if (to->length > 0 && before[to->length - 1] != '{')
        text_add(to, ", ");
    text_add(to, "\"");
    text_add(to, name);
    text_add(to, "\": ");
}

void page_json_whole(text *to, const char *name, uint64_t value)
{
    page_json_name(to, name);
    text_add_whole(to, value);
}

void page_json_address(text *to, const char *name, const void *address)
{
    page_json_whole(to, name, (uint64_t)(uintptr_t)address);
}

static void add_number(text *to, float value)
{
    if (isfinite(value))
        text_add_float(to, value);
    else
        text_add(to, "null");
}

void page_json_float(text *to, const char *name, float value)
{
    page_json_name(to, name);
    add_number(to, value);
}

void page_json_floats(text *to, const char *name, const float *values, size_t count)
{
    page_json_name(to, name);
    for (size_t i = 0; i < count; ++i) {
        text_add(to, i == 0 ? "[" : ",");
        add_number(to, values[i]);
    }
    text_add(to, "]");
}

void page_json_quoted(text *to, const char *value)
{
    text_add(to, "\"");
    for (const char *c = value; *c != '\0'; ++c) {
        if (*c == '"' || *c == '\\')
            text_add(to, "\\");
        text_add_part(to, (unsigned char)*c < 0x20 ? " " : c, 1);
    }
    text_add(to, "\"");
}

void page_json_string(text *to, const char *name, const char *value)
{
    page_json_name(to, name);
    page_json_quoted(to, value);
}

void page_json_truth(text *to, const char *name, bool value)
{
    page_json_name(to, name);
    text_add(to, value ? "true" : "false");
}

void page_json_begin(text *to, const char *name)
{
    page_json_name(to, name);
    text_add(to, "{");
}

void page_json_end(text *to)
{
    text_add(to, "}");
}
