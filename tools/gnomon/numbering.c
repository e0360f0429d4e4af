/* Names of numbered files. */
#include "numbering.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Digits of a 32-bit number, or the largest width. */
#define MAX_DIGITS 10

bool numbering_is_pattern(const char *name)
{
    return strchr(name, '%') != NULL;
}

/* Reads what follows a percent sign: d, or 0, a digit and d. Returns null for anything else;
 * otherwise what follows, and the width. */
static const char *read_number(const char *text, int *width)
{
    *width = 1;
    if (text[0] == '0' && text[1] >= '1' && text[1] <= '9') {
        *width = text[1] - '0';
        text += 2;
    }
    return *text == 'd' ? text + 1 : NULL;
}

bool numbering_is_valid(const char *pattern)
{
    int numbers = 0, width;
    while (*pattern != '\0') {
        if (*pattern++ != '%')
            continue;
        if (*pattern == '%') {
            ++pattern;
            continue;
        }
        pattern = read_number(pattern, &width);
        if (pattern == NULL)
            return false;
        ++numbers;
    }
    return numbers == 1;
}

char *numbering_name(const char *pattern, uint32_t number)
{
    char *name = malloc(strlen(pattern) + MAX_DIGITS + 1);
    char *to = name;
    int width;
    while (name != NULL && *pattern != '\0') {
        if (*pattern != '%') {
            *to++ = *pattern++;
        } else if (pattern[1] == '%') {
            *to++ = '%';
            pattern += 2;
        } else {
            pattern = read_number(pattern + 1, &width);
            to += sprintf(to, "%0*u", width, (unsigned)number);
        }
    }
    if (name != NULL)
        *to = '\0';
    return name;
}
