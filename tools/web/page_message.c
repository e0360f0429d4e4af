/* The reason why the last call failed. */
#include "page_parts.h"

#include <stdarg.h>

#include "page_text.h"

static text message;

void page_begin(void)
{
    text_clear(&message);
}

int page_fail(const char *first, ...)
{
    va_list more;
    text_clear(&message);
    va_start(more, first);
    for (const char *part = first; part != NULL; part = va_arg(more, const char *))
        text_add(&message, part);
    va_end(more);
    return 1;
}

const char *page_message(void)
{
    return message.failed ? "there is not enough memory" : text_of(&message);
}
