/* Error lines on standard error. */
#include "report.h"

#include <stdarg.h>
#include <stdio.h>

/* Longer than any path with a reason behind it; what is longer is cut. */
#define LINE_SIZE 8192

static void print_line(const char *prefix, const char *what, const char *suffix, const char *format,
                       va_list arguments)
{
    char reason[LINE_SIZE];
    char line[2 * LINE_SIZE];
    vsnprintf(reason, sizeof reason, format, arguments);
    snprintf(line, sizeof line, "%s%s: %s%s", prefix, what, reason, suffix);
    for (char *c = line; *c != '\0'; c++) {
        if ((unsigned char)*c < 0x20 || *c == 0x7f)
            *c = ' ';
    }
    fprintf(stderr, "%s\n", line);
}

int report_fault(const char *what, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print_line("gnomon: ", what, "", format, arguments);
    va_end(arguments);
    return EXIT_FAULT;
}

int report_usage(const char *command, const char *format, ...)
{
    char suffix[64] = "";
    if (*command != '\0')
        snprintf(suffix, sizeof suffix, " (see gnomon %s --help)", command);
    else
        snprintf(suffix, sizeof suffix, " (see gnomon --help)");
    va_list arguments;
    va_start(arguments, format);
    print_line(*command != '\0' ? "gnomon " : "gnomon", command, suffix, format, arguments);
    va_end(arguments);
    return EXIT_USAGE;
}
