/* Command lines of test programs. */
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

/* An option, and where its value goes: one of the three pointers. */
typedef struct command_option {
    const char *name;     /* null after the last option */
    uint64_t *number;     /* a whole number */
    uint64_t least, most; /* its limits; 0: none above */
    bool *flag;           /* becomes true; the option has no value */
    const char **text;
} command_option;

static inline bool command_line_asks_help(int argc, char **argv)
{
    for (int i = 1; i < argc; ++i)
        if (strcmp(argv[i], "--help") == 0)
            return true;
    return false;
}

/* Reads the options of a command line; `operand` gets the last word that is none. It is null for a
 * program that takes no such word. Returns false, after a message, if something is wrong. */
static inline bool command_line_read(const char *program, int argc, char **argv,
                                     const command_option *options, const char **operand)
{
    for (int i = 1; i < argc; ++i) {
        const command_option *o = options;

        while (o->name && strcmp(o->name, argv[i]) != 0)
            ++o;
        if (o->number) {
            if (!option_number(program, o->name, argv[++i], o->least,
                               o->most > 0 ? o->most : UINT64_MAX, o->number))
                return false;
        } else if (o->flag) {
            *o->flag = true;
        } else if (o->text && i + 1 < argc) {
            *o->text = argv[++i];
        } else if (!o->name && operand && strncmp(argv[i], "--", 2) != 0) {
            *operand = argv[i];
        } else {
            fprintf(stderr, "%s: %s %s (--help says more)\n", program,
                    o->name ? "missing value after" : "unknown option", argv[i]);
            return false;
        }
    }
    return true;
}

#endif
