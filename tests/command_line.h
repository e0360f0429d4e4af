/* Whole numbers on the command lines of test programs. */
#ifndef TESTS_COMMAND_LINE_H
#define TESTS_COMMAND_LINE_H

#include <errno.h>
#include <inttypes.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Reads the value of an option: a whole number from `least` to `most`, decimal or, after 0x,
 * hexadecimal. If `text` is no such number, or null, prints what the option takes, writes nothing
 * and returns false. */
static inline bool option_number(const char *program, const char *option, const char *text,
                                 uint64_t least, uint64_t most, uint64_t *number)
{
    const bool has_digit = text && *text >= '0' && *text <= '9';
    char *end = NULL;

    errno = 0;
    const uint64_t read =
        has_digit ? strtoull(text, &end, strncmp(text, "0x", 2) == 0 ? 16 : 10) : 0;
    if (has_digit && *end == '\0' && errno == 0 && read >= least && read <= most) {
        *number = read;
        return true;
    }
    fprintf(stderr, "%s: %s takes a whole number", program, option);
    if (most < UINT64_MAX)
        fprintf(stderr, " from %" PRIu64 " to %" PRIu64, least, most);
    else if (least > 0)
        fprintf(stderr, " from %" PRIu64 " on", least);
    if (text)
        fprintf(stderr, ", not '%s'", text);
    fputs(" (--help says more)\n", stderr);
    return false;
}

#endif
