/* Error lines on standard error, and the check that standard output took everything. */
#define _POSIX_C_SOURCE 200809L
#include "report.h"

#include <errno.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Longer than any path followed by a reason; longer lines are cut. */
#define LINE_SIZE 8192

static report_sink *sink_of_lines;

/* What lines of faults and warnings begin with; whether this is a rank above 0. */
static char beginning[32] = "gnomon: ";
static bool follows;

/* Null, or what stands between the beginning and the fault. */
static const char *place_of_faults;

/* Bytes of the character at `c` if it is well-formed UTF-8 (Unicode 15, table 3-7) and not a
 * control character; otherwise 0. */
static size_t character_length(const unsigned char *c)
{
    size_t length = c[0] < 0x80 ? 1 : c[0] < 0xe0 ? 2 : c[0] < 0xf0 ? 3 : 4;
    if (length == 1)
        return c[0] >= 0x20 && c[0] != 0x7f ? 1 : 0;
    unsigned char least = c[0] == 0xc2 ? 0xa0 : c[0] == 0xe0 ? 0xa0 : c[0] == 0xf0 ? 0x90 : 0x80;
    unsigned char most = c[0] == 0xed ? 0x9f : c[0] == 0xf4 ? 0x8f : 0xbf;
    if (c[0] < 0xc2 || c[0] > 0xf4 || c[1] < least || c[1] > most)
        return 0;
    for (size_t i = 2; i < length; ++i)
        if (c[i] < 0x80 || c[i] > 0xbf)
            return 0;
    return length;
}

/* Escapes as much of the text as fits. */
static void escape(const char *text, char *result, size_t size)
{
    const unsigned char *c = (const unsigned char *)text;
    size_t used = 0;
    while (*c != '\0' && used + 5 <= size) {
        size_t length = character_length(c);
        if (length == 0)
            used += (size_t)snprintf(result + used, size - used, "\\x%02x", (unsigned)*c++);
        for (; length > 0; --length)
            result[used++] = (char)*c++;
    }
    result[used] = '\0';
}

/* Whether standard error shows colours and the user wants them (no-color.org). */
static bool has_colors(void)
{
    const char *unwanted = getenv("NO_COLOR"), *terminal = getenv("TERM");
    return isatty(STDERR_FILENO) && (unwanted == NULL || *unwanted == '\0') &&
           (terminal == NULL || strcmp(terminal, "dumb") != 0);
}

void report_line(const char *line)
{
    /* Bold red, bold magenta for warnings, and back (ECMA-48, SGR). */
    static const char error[] = "\033[1;31m", warning[] = "\033[1;35m", plain[] = "\033[0m";
    const bool colored = has_colors();
    const char *start = strstr(line, ": warning: ") != NULL ? warning : error;
    char escaped[8 * LINE_SIZE];
    escape(line, escaped, sizeof escaped);
    fprintf(stderr, "%s%s%s\n", colored ? start : "", escaped, colored ? plain : "");
}

void report_to(report_sink *sink)
{
    sink_of_lines = sink;
}

void report_as_rank(unsigned int number)
{
    snprintf(beginning, sizeof beginning, "gnomon, rank %u: ", number);
    follows = number > 0;
}

void report_where(const char *place)
{
    place_of_faults = place;
}

void report_print(FILE *file, const char *text)
{
    const unsigned char *c = (const unsigned char *)text;
    while (*c != '\0') {
        size_t length = character_length(c);
        if (length == 0)
            fprintf(file, "\\x%02x", (unsigned)*c++);
        for (; length > 0; --length)
            fputc(*c++, file);
    }
}

static void print_line(const char *prefix, const char *what, const char *suffix, const char *format,
                       va_list arguments)
{
    char reason[LINE_SIZE];
    char line[4 * LINE_SIZE];
    vsnprintf(reason, sizeof reason, format, arguments);
    const char *place = place_of_faults != NULL ? place_of_faults : "";
    snprintf(line, sizeof line, "%s%s%s%s: %s%s", prefix, place, *place != '\0' ? ": " : "", what,
             reason, suffix);
    if (sink_of_lines != NULL)
        sink_of_lines(line);
    else
        report_line(line);
}

int report_fault(const char *what, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print_line(beginning, what, "", format, arguments);
    va_end(arguments);
    return EXIT_FAULT;
}

void report_warning(const char *what, const char *format, ...)
{
    char warning[LINE_SIZE];
    va_list arguments;
    snprintf(warning, sizeof warning, "%s: warning", what);
    va_start(arguments, format);
    print_line(beginning, warning, "", format, arguments);
    va_end(arguments);
}

int report_usage(const char *command, const char *format, ...)
{
    if (follows)
        return EXIT_USAGE;
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

/* Why standard output lost something; 0: nothing, as far as is known. */
static int reason_of_loss;

void flush_output(void)
{
    if (fflush(stdout) != 0 && reason_of_loss == 0)
        reason_of_loss = errno;
}

int finish_output(int status)
{
    flush_output();
    if (reason_of_loss != 0)
        return report_fault("standard output", "cannot be written: %s", strerror(reason_of_loss));
    return ferror(stdout) == 0
               ? status
               : report_fault("standard output", "cannot be written: a part of it is lost");
}
