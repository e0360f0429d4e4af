/* Reads scripts of events. */
#include "view_script.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "report.h"
#include "text_lines.h"

#define MAX_EVENTS 100000
#define MAX_NUMBER 100000

static const struct {
    char word[8];
    window_action action;
    int numbers;
} statements[] = {{"drag", WINDOW_DRAG, 2},     {"pan", WINDOW_DRAG_PAN, 2},
                  {"wheel", WINDOW_WHEEL, 1},   {"key", WINDOW_KEY, 0},
                  {"resize", WINDOW_RESIZE, 2}, {"wait", WINDOW_WAIT, 1}};

/* Reads whole numbers up to the end of the line. */
static bool read_numbers(char *line, int count, int numbers[2])
{
    for (int i = 0; i < count; ++i) {
        const char *word = text_lines_word(&line);
        char *end;
        const long value = word != NULL ? strtol(word, &end, 10) : 0;
        if (word == NULL || *end != '\0' || value < -MAX_NUMBER || value > MAX_NUMBER)
            return false;
        numbers[i] = (int)value;
    }
    return text_lines_word(&line) == NULL;
}

/* Reads one character up to the end of the line. The first # is the key, not a comment. */
static bool read_key(char *line, int *key)
{
    line += strspn(line, " \t");
    *key = *line;
    if (*key <= ' ' || *key >= 127 || (line[1] != '\0' && !isspace((unsigned char)line[1])))
        return false;
    ++line;
    return text_lines_word(&line) == NULL;
}

/* Reads the event that begins with this word; the others are in the line. */
static bool read_event(const char *word, char *line, window_event *event)
{
    for (size_t i = 0; i < sizeof statements / sizeof statements[0]; ++i) {
        int numbers[2] = {0, 0};
        if (strcmp(word, statements[i].word) != 0)
            continue;
        event->action = statements[i].action;
        if (event->action == WINDOW_KEY)
            return read_key(line, &event->key);
        if (!read_numbers(line, statements[i].numbers, numbers))
            return false;
        event->x = statements[i].numbers == 2 || event->action == WINDOW_WAIT ? numbers[0] : 0;
        event->y = statements[i].numbers == 2 ? numbers[1] : numbers[0];
        return (event->action != WINDOW_RESIZE || (event->x > 0 && event->y > 0)) &&
               (event->action != WINDOW_WAIT || event->x >= 0);
    }
    return false;
}

/* Takes a line. Returns null, or what is wrong with it. */
static const char *take_line(char *line, bool has_zero, view_script *s)
{
    window_event event = {WINDOW_NOTHING, 0, 0, 0};
    if (has_zero)
        return "a zero byte is in the line";
    const char *word = text_lines_word(&line);
    if (word == NULL)
        return NULL;
    if (!read_event(word, line, &event))
        return "not an event: drag X Y, pan X Y, wheel N, key C, resize W H or wait MS";
    if (s->count == MAX_EVENTS)
        return "too many events";
    s->events[s->count++] = event;
    return NULL;
}

int view_script_read(const char *path, view_script *result)
{
    text_lines text;
    char *line, what[512];
    memset(result, 0, sizeof *result);
    int fault = text_lines_read(path, &text);
    if (fault == 0)
        result->events = calloc(MAX_EVENTS, sizeof *result->events);
    if (fault == 0 && result->events == NULL)
        fault = report_fault(path, "not enough memory");
    while (fault == 0 && (line = text_lines_next(&text)) != NULL) {
        const char *wrong = take_line(line, text.has_zero, result);
        if (wrong == NULL)
            continue;
        snprintf(what, sizeof what, "%s:%llu", path, (unsigned long long)text.number);
        report_fault(what, "%s", wrong);
        fault = EXIT_USAGE;
    }
    text_lines_free(&text);
    return fault;
}

void view_script_free(view_script *s)
{
    free(s->events);
    memset(s, 0, sizeof *s);
}
