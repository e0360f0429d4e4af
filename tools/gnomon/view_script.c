/* Reads scripts of events. */
#include "view_script.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"
#include "report.h"

#define LONGEST_LINE 80
#define MAX_EVENTS 100000
#define MAX_NUMBER 100000

static const struct {
    char word[8];
    window_action action;
    int numbers;
} statements[] = {{"drag", WINDOW_DRAG, 2},     {"pan", WINDOW_DRAG_PAN, 2},
                  {"wheel", WINDOW_WHEEL, 1},   {"key", WINDOW_KEY, 0},
                  {"resize", WINDOW_RESIZE, 2}, {"wait", WINDOW_WAIT, 1}};

/* Reads whole numbers up to the end of the text. */
static bool read_numbers(const char *text, int count, int numbers[2])
{
    for (int i = 0; i < count; ++i) {
        char *end;
        const long value = strtol(text, &end, 10);
        if (end == text || value < -MAX_NUMBER || value > MAX_NUMBER)
            return false;
        numbers[i] = (int)value;
        text = end;
    }
    return *text == '\0';
}

static bool read_event(const char *line, window_event *event)
{
    for (size_t i = 0; i < sizeof statements / sizeof statements[0]; ++i) {
        const size_t length = strlen(statements[i].word);
        const char *rest = line + length;
        int numbers[2] = {0, 0};
        if (strncmp(line, statements[i].word, length) != 0 || *rest != ' ')
            continue;
        event->action = statements[i].action;
        if (event->action == WINDOW_KEY) {
            event->key = rest[1];
            return rest[1] > ' ' && rest[1] < 127 && rest[2] == '\0';
        }
        if (!read_numbers(rest, statements[i].numbers, numbers))
            return false;
        event->x = statements[i].numbers == 2 || event->action == WINDOW_WAIT ? numbers[0] : 0;
        event->y = statements[i].numbers == 2 ? numbers[1] : numbers[0];
        return (event->action != WINDOW_RESIZE || (event->x > 0 && event->y > 0)) &&
               (event->action != WINDOW_WAIT || event->x >= 0);
    }
    return false;
}

static int add_line(const char *path, unsigned long number, const char *line, view_script *s)
{
    window_event event = {WINDOW_NOTHING, 0, 0, 0};
    char what[512];
    if (*line == '\0' || *line == '#')
        return 0;
    snprintf(what, sizeof what, "%s:%lu", path, number);
    if (!read_event(line, &event) || s->count == MAX_EVENTS) {
        report_fault(what, s->count == MAX_EVENTS
                               ? "too many events"
                               : "not an event: drag X Y, pan X Y, wheel N, key C, resize W H or "
                                 "wait MS");
        return EXIT_USAGE;
    }
    s->events[s->count++] = event;
    return 0;
}

int view_script_read(const char *path, view_script *result)
{
    size_t size, at = 0;
    const char *reason;
    char line[LONGEST_LINE + 1];
    memset(result, 0, sizeof *result);
    char *text = (char *)files_read(path, &size, &reason);
    if (text == NULL)
        return report_fault(path, "cannot be read: %s", reason);
    result->events = calloc(MAX_EVENTS, sizeof *result->events);
    int fault = result->events != NULL ? 0 : report_fault(path, "not enough memory");
    for (unsigned long number = 1; at < size && fault == 0; ++number) {
        const char *end = memchr(text + at, '\n', size - at);
        const size_t length = end != NULL ? (size_t)(end - (text + at)) : size - at;
        snprintf(line, sizeof line, "%.*s", (int)(length < sizeof line ? length : sizeof line),
                 text + at);
        fault = add_line(path, number, length <= LONGEST_LINE ? line : "too long", result);
        at += length + 1;
    }
    free(text);
    return fault;
}

void view_script_free(view_script *s)
{
    free(s->events);
    memset(s, 0, sizeof *s);
}
