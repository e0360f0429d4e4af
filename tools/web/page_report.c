/* Stands in for tools/gnomon/report.c in the page: what the command prints as a fault is the page's
 * message. */
#include <stdarg.h>
#include <string.h>

#include "page_parts.h"
#include "page_text.h"
#include "report.h"

/* Formats what the shared files format: %s, %u and %d. */
static void add_formatted(text *t, const char *format, va_list arguments)
{
    for (; *format != '\0'; ++format) {
        if (*format != '%') {
            text_add_part(t, format, 1);
            continue;
        }
        ++format;
        if (*format == 's') {
            text_add(t, va_arg(arguments, const char *));
        } else {
            /* No number in these messages is negative. */
            text_add_whole(t, va_arg(arguments, unsigned));
        }
    }
}

int report_fault(const char *what, const char *format, ...)
{
    static text line;
    va_list arguments;
    text_clear(&line);
    text_add(&line, strncmp(what, "--", 2) == 0 ? what + 2 : what);
    text_add(&line, ": ");
    va_start(arguments, format);
    add_formatted(&line, format, arguments);
    va_end(arguments);
    return page_fail(text_of(&line), (const char *)NULL);
}
