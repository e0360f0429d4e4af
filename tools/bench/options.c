/* Reads command lines. */
#include "options.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gnomon/backend.h>

const char *option_program = "bench", *option_help = "--help";

int usage_error(const char *what, const char *value)
{
    fprintf(stderr, "%s: %s %s; see %s\n", option_program, what, value, option_help);
    return 2;
}

bool options_help(int argc, char **argv, const char *help)
{
    bool asked = false;

    for (int i = 0; i < argc; ++i)
        asked = asked || strcmp(argv[i], "--help") == 0;
    if (asked)
        fputs(help, stdout);
    return asked;
}

static int read_number(const option *o, const char *value)
{
    char *end;
    const long number = strtol(value, &end, 10);

    if (end == value || *end || number < 1 || number > o->most) {
        char what[64];

        snprintf(what, sizeof what, "%s takes 1 %s %d, not", o->name, o->most > 2 ? "to" : "or",
                 o->most);
        return usage_error(what, value);
    }
    *(int *)o->to = (int)number;
    return 0;
}

static int read_backend(const option *o, const char *value)
{
    int b = GN_BACKEND_PORTABLE;

    while (b < GN_BACKEND_COUNT && strcmp(value, gn_backend_name((gn_backend)b)) != 0)
        ++b;
    if (b == GN_BACKEND_COUNT || !gn_backend_available((gn_backend)b))
        return usage_error("this machine has no back end", value);
    *(gn_backend *)o->to = (gn_backend)b;
    return 0;
}

static int read_text(const option *o, const char *value)
{
    const char **to = o->to;
    int n = 0;

    while (n + 1 < o->most && to[n])
        ++n;
    if (n > 0 && to[n])
        return usage_error("too many values, with", value);
    to[n] = value;
    return 0;
}

int options_read(int argc, char **argv, const option *options)
{
    int fault = 0;

    for (int i = 0; i < argc && fault == 0; ++i) {
        const option *o = options;

        while (o->name && strcmp(o->name, argv[i]) != 0)
            ++o;
        if (o->name && o->kind == OPTION_FLAG) {
            *(bool *)o->to = true;
            continue;
        }
        if (strncmp(argv[i], "--", 2) != 0 || i + 1 == argc)
            return usage_error("unknown or incomplete option", argv[i]);
        if (!o->name)
            return usage_error("unknown option", argv[i]);
        ++i;
        fault = o->kind == OPTION_NUMBER    ? read_number(o, argv[i])
                : o->kind == OPTION_BACKEND ? read_backend(o, argv[i])
                                            : read_text(o, argv[i]);
    }
    return fault;
}
