/* Reads the text of gnomon transform: one statement per line. */
#include "transform.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "report.h"

enum { LINE_SIZE = 1024, MAX_WORDS = 8 };

/* Statements that have only numbers, and how many: at least and at most. */
static const struct {
    char word[16];
    int least, most;
} keywords[KEYWORD_COUNT] = {
    {"screen", 2, 2},      {"scale", 1, 3},        {"translate", 3, 3}, {"position", 3, 3},
    {"target", 3, 3},      {"right", 3, 3},        {"up", 3, 3},        {"forward", 3, 3},
    {"perspective", 1, 1}, {"orthographic", 4, 4}, {"frustum", 4, 4},   {"near", 1, 1},
    {"far", 1, 1},         {"convention", 1, 1},   {"depth", 1, 1},
};

/* One line, cut into words. */
typedef struct words {
    unsigned long line;
    int count;
    char *word[MAX_WORDS];
} words;

const char *transform_keyword(keyword which)
{
    return keywords[which].word;
}

int transform_fault(const char *file, unsigned long line, const char *format, ...)
{
    char what[LINE_SIZE], why[2 * LINE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(why, sizeof why, format, arguments);
    va_end(arguments);
    if (line > 0)
        snprintf(what, sizeof what, "%s:%lu", file, line);
    else
        snprintf(what, sizeof what, "%s", file);
    report_fault(what, "%s", why);
    return EXIT_USAGE;
}

static int read_number(const setup *s, const words *w, int index, float *result)
{
    char *end;
    const char *text = w->word[index];
    *result = strtof(text, &end);
    if (end == text || *end != '\0')
        return transform_fault(s->file, w->line, "%s: '%s' is not a number", w->word[0], text);
    if (!isfinite(*result))
        return transform_fault(s->file, w->line, "%s: '%s' is not a finite 32-bit number",
                               w->word[0], text);
    return 0;
}

static int read_numbers(const setup *s, const words *w, int least, int most, statement *result)
{
    int given = w->count - 1, fault = 0;
    if (given != least && given != most) {
        char or_least[16] = "";
        if (least != most)
            snprintf(or_least, sizeof or_least, "%d or ", least);
        return transform_fault(s->file, w->line, "%s takes %s%d number%s, not %d", w->word[0],
                               or_least, most, most == 1 ? "" : "s", given);
    }
    for (int i = 0; i < given && fault == 0; ++i)
        fault = read_number(s, w, i + 1, &result->number[i]);
    for (int i = given; i < most; ++i)
        result->number[i] = result->number[0];
    result->line = w->line;
    return fault;
}

/* A statement that may occur any number of times. */
static int add_numbers(const setup *s, const words *w, int count, statements *list)
{
    if ((list->count & (list->count - 1)) == 0) { /* full: the capacity is a power of two */
        size_t capacity = list->count == 0 ? 1 : 2 * list->count;
        statement *grown = realloc(list->all, capacity * sizeof *grown);
        if (grown == NULL)
            return report_fault(s->file, "not enough memory");
        list->all = grown;
    }
    memset(&list->all[list->count], 0, sizeof *list->all);
    return read_numbers(s, w, count, count, &list->all[list->count++]);
}

static int read_name(const setup *s, const words *w, const char *const *names, int count,
                     int *result)
{
    char known[64] = "";
    for (int i = 0; i < count && w->count == 2; ++i) {
        if (strcmp(w->word[1], names[i]) == 0) {
            *result = i;
            return 0;
        }
    }
    for (int i = 0; i < count; ++i) {
        strcat(known, i == 0 ? "" : i + 1 < count ? ", " : " or ");
        strcat(known, names[i]);
    }
    return transform_fault(s->file, w->line, "%s is %s", w->word[0], known);
}

static int read_single(setup *s, const words *w, keyword which)
{
    static const char *const conventions[] = {"opengl", "direct3d", "vulkan"};
    static const char *const depths[] = {"plain", "reversed"};
    statement *to = &s->given[which];
    int value = 0, fault;
    if (to->line > 0)
        return transform_fault(s->file, w->line, "%s is already in line %lu", w->word[0], to->line);
    to->line = w->line;
    switch (which) {
    case KEYWORD_CONVENTION:
        fault = read_name(s, w, conventions, 3, &value);
        s->convention = (convention_option)value;
        return fault;
    case KEYWORD_DEPTH:
        fault = read_name(s, w, depths, 2, &value);
        s->reversed = value == 1;
        return fault;
    case KEYWORD_FAR:
        s->infinite = w->count == 2 && strcmp(w->word[1], "infinite") == 0;
        return s->infinite ? 0 : read_numbers(s, w, 1, 1, to);
    default:
        return read_numbers(s, w, keywords[which].least, keywords[which].most, to);
    }
}

static int read_statement(setup *s, const words *w)
{
    if (strcmp(w->word[0], "point") == 0)
        return add_numbers(s, w, 3, &s->points);
    if (strcmp(w->word[0], "rotate") == 0)
        return add_numbers(s, w, 4, &s->rotations);
    for (int i = 0; i < KEYWORD_COUNT; ++i)
        if (strcmp(w->word[0], keywords[i].word) == 0)
            return read_single(s, w, (keyword)i);
    return transform_fault(s->file, w->line, "'%s' is not a statement", w->word[0]);
}

/* Cuts the line into words; # ends it. */
static int cut(const setup *s, char *text, words *w)
{
    char *c = text;
    text[strcspn(text, "#")] = '\0';
    for (w->count = 0;;) {
        while (isspace((unsigned char)*c))
            *c++ = '\0';
        if (*c == '\0')
            return 0;
        if (w->count == MAX_WORDS)
            return transform_fault(s->file, w->line, "%s: too many words", w->word[0]);
        w->word[w->count++] = c;
        while (*c != '\0' && !isspace((unsigned char)*c))
            ++c;
    }
}

/* Checks the camera's axes, which replace target: all three, or none. `up` alone is not one. */
static int check_axes(const setup *s)
{
    static const keyword axes[3] = {KEYWORD_RIGHT, KEYWORD_UP, KEYWORD_FORWARD};
    const statement *g = s->given;
    const unsigned long line =
        g[KEYWORD_RIGHT].line > 0 ? g[KEYWORD_RIGHT].line : g[KEYWORD_FORWARD].line;
    const char *missing[3];
    int count = 0;
    if (line == 0)
        return 0;
    if (g[KEYWORD_TARGET].line > 0)
        return transform_fault(s->file, g[KEYWORD_TARGET].line,
                               "target, but line %lu gives the camera's axes", line);
    for (int i = 0; i < 3; ++i)
        if (g[axes[i]].line == 0)
            missing[count++] = keywords[axes[i]].word;
    if (count == 0)
        return 0;
    return transform_fault(
        s->file, line, "the camera's axes are right, up and forward; %s%s%s %s missing", missing[0],
        count > 1 ? " and " : "", count > 1 ? missing[1] : "", count > 1 ? "are" : "is");
}

/* Checks the text as a whole: missing statements, and statements that exclude each other. */
static int check(const setup *s)
{
    static const keyword needed[] = {KEYWORD_CONVENTION, KEYWORD_SCREEN, KEYWORD_NEAR, KEYWORD_FAR};
    const statement *g = s->given;
    keyword projection = KEYWORD_COUNT;
    for (size_t i = 0; i < sizeof needed / sizeof needed[0]; ++i)
        if (g[needed[i]].line == 0)
            return transform_fault(s->file, 0, "no %s", keywords[needed[i]].word);
    for (int i = KEYWORD_PERSPECTIVE; i <= KEYWORD_FRUSTUM; ++i) {
        if (g[i].line > 0 && projection != KEYWORD_COUNT)
            return transform_fault(s->file, g[i].line, "%s: line %lu already has %s",
                                   keywords[i].word, g[projection].line, keywords[projection].word);
        if (g[i].line > 0)
            projection = (keyword)i;
    }
    if (projection == KEYWORD_COUNT)
        return transform_fault(s->file, 0, "no perspective, orthographic or frustum");
    if (projection == KEYWORD_ORTHOGRAPHIC && s->infinite)
        return transform_fault(s->file, g[KEYWORD_FAR].line,
                               "far: orthographic cannot be infinite");
    for (int i = 0; i < 2; ++i) {
        float size = g[KEYWORD_SCREEN].number[i];
        if (!(size >= 1.0f && size <= (float)GN_MAX_SIZE) || size != floorf(size))
            return transform_fault(s->file, g[KEYWORD_SCREEN].line,
                                   "screen: width and height are 1 to %d pixels", GN_MAX_SIZE);
    }
    return check_axes(s);
}

/* The result of reading a line. */
typedef enum line_result { LINE_READ, LINE_NONE, LINE_TOO_LONG, LINE_HAS_NUL } line_result;

/* Reads a line without its end. */
static line_result read_line(FILE *in, char text[LINE_SIZE])
{
    size_t length = 0;
    int c;
    while ((c = getc(in)) != EOF && c != '\n') {
        if (c == '\0')
            return LINE_HAS_NUL;
        if (length == LINE_SIZE - 1)
            return LINE_TOO_LONG;
        text[length++] = (char)c;
    }
    text[length] = '\0';
    return c == EOF && length == 0 ? LINE_NONE : LINE_READ;
}

int transform_read(FILE *in, const char *file, setup *result)
{
    static const char mark[] = "\xef\xbb\xbf";
    char text[LINE_SIZE];
    words w = {0, 0, {NULL}};
    line_result got;
    int fault = 0;
    result->file = file;
    while (fault == 0 && (got = read_line(in, text)) != LINE_NONE) {
        ++w.line;
        if (got == LINE_TOO_LONG)
            return transform_fault(file, w.line, "a line of more than %d characters",
                                   LINE_SIZE - 1);
        if (got == LINE_HAS_NUL)
            return transform_fault(file, w.line, "a NUL byte, which a text cannot contain");
        bool marked = w.line == 1 && strncmp(text, mark, sizeof mark - 1) == 0;
        fault = cut(result, marked ? text + sizeof mark - 1 : text, &w);
        if (fault == 0 && w.count > 0)
            fault = read_statement(result, &w);
    }
    if (fault == 0 && ferror(in))
        return report_fault(file, "cannot be read: %s", strerror(errno));
    return fault != 0 ? fault : check(result);
}

void transform_setup_free(setup *s)
{
    free(s->rotations.all);
    free(s->points.all);
}
