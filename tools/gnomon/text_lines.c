/* Reads texts of lines and words. */
#include "text_lines.h"

#include <stdlib.h>
#include <string.h>

#include "files.h"
#include "report.h"

static const char blanks[] = " \t\r\v\f";

int text_lines_read(const char *path, text_lines *result)
{
    static const char mark[] = "\xef\xbb\xbf";
    const char *reason;
    memset(result, 0, sizeof *result);
    char *bytes = (char *)files_read(path, &result->size, &reason);
    result->bytes = bytes != NULL ? realloc(bytes, result->size + 1) : NULL;
    if (result->bytes == NULL) {
        if (bytes != NULL)
            reason = "not enough memory";
        free(bytes);
        return report_fault(path, "cannot be read: %s", reason);
    }
    result->bytes[result->size] = '\0';
    if (strncmp(result->bytes, mark, sizeof mark - 1) == 0)
        result->next = sizeof mark - 1;
    return 0;
}

char *text_lines_next(text_lines *t)
{
    if (t->next >= t->size)
        return NULL;
    char *line = t->bytes + t->next;
    const char *end = memchr(line, '\n', t->size - t->next);
    const size_t length = end != NULL ? (size_t)(end - line) : t->size - t->next;
    line[length] = '\0';
    t->next += length + 1;
    ++t->number;
    t->has_zero = strlen(line) != length;
    return line;
}

char *text_lines_word(char **line)
{
    char *word = *line + strspn(*line, blanks);
    if (*word == '\0' || *word == '#')
        return NULL;
    *line = word + strcspn(word, blanks);
    if (**line != '\0')
        *(*line)++ = '\0';
    return word;
}

void text_lines_free(text_lines *t)
{
    free(t->bytes);
    memset(t, 0, sizeof *t);
}
