/* Checks OBJ files, statement by statement, before Assimp reads them. Assimp's messages for files
 * that are cut short name neither the line nor the reason, and it draws some of these files as if
 * they were complete. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "model_formats.h"
#include "report.h"

/* The state of reading a statement. */
typedef struct statement {
    char keyword[8]; /* the first word, truncated */
    size_t words;    /* number of words after it */
    size_t length;   /* of the word being read */
    char last;       /* its last byte */
    char word[40];   /* the word that is being read, truncated */
    bool infinite;   /* one of the texture coordinates is not a finite float */
    long highest[3]; /* of the vertices, texture coordinates and normals that corners name */
    /* State of a face's corners. */
    unsigned int
        form; /* of this word: two bits per field, 1 for an empty field, 2 for a filled one */
    unsigned int first_form; /* of the first corner; 0: none yet */
    bool forms_differ;
} statement;

static bool is(const statement *s, const char *keyword)
{
    return strcmp(s->keyword, keyword) == 0;
}

static void end_word(statement *s)
{
    if (s->length == 0)
        return;
    char *at = s->word;
    s->word[s->length < sizeof s->word ? s->length : sizeof s->word - 1] = '\0';
    if (s->words > 0 && is(s, "vt")) {
        float value = strtof(at, &at);
        s->infinite = s->infinite || (at != s->word && !isfinite(value));
    }
    for (int i = 0; s->words > 0 && is(s, "f") && i < 3; ++i) {
        long number = strtol(at, &at, 10);
        s->highest[i] = number > s->highest[i] ? number : s->highest[i];
        if (*at++ != '/')
            break;
    }
    if (s->words == 1)
        s->first_form = s->form;
    else if (s->words > 1 && s->form != s->first_form)
        s->forms_differ = true;
    s->length = 0;
}

static void add_byte(statement *s, int c)
{
    if (s->length == 0) {
        s->form = 1;
        if (s->keyword[0] != '\0')
            ++s->words;
    }
    if (s->words == 0 && s->length + 1 < sizeof s->keyword)
        s->keyword[s->length] = (char)c;
    if (c == '/')
        s->form = (s->form << 2 | 1) & 0xff;
    else
        s->form = (s->form & ~3u) | 2;
    if (s->length + 1 < sizeof s->word)
        s->word[s->length] = (char)c;
    ++s->length;
    s->last = (char)c;
}

/* The fewest words that a statement has; 0: not a statement that this file checks. */
static size_t least_words(const statement *s)
{
    if (is(s, "v") || is(s, "vn") || is(s, "f"))
        return 3;
    return is(s, "vt") ? 2 : 0;
}

/* Whether the last statement of a file without a final line end is incomplete. */
static bool is_incomplete(const statement *s)
{
    bool ends_well = (s->last >= '0' && s->last <= '9') || s->last == '.';
    return s->words < least_words(s) || !ends_well || (is(s, "f") && s->forms_differ);
}

/* Returns null, or what is wrong with the statement, as the end of a sentence. */
static const char *fault_of(const statement *s)
{
    if ((is(s, "v") || is(s, "vn")) && s->words < 3)
        return "takes three numbers";
    if (is(s, "vt") && (s->words < 2 || s->words > 3))
        return "takes two or three numbers";
    return NULL;
}

/* Elements that corners can name: their number, and the highest number named, with its line. */
typedef struct named {
    unsigned long count;
    long highest;
    unsigned long line;
} named;

static const char named_keywords[3][4] = {"v", "vt", "vn"};

static void count_named(const statement *s, unsigned long line, named list[3])
{
    for (int i = 0; i < 3; ++i) {
        list[i].count += is(s, named_keywords[i]);
        if (s->highest[i] > list[i].highest) {
            list[i].highest = s->highest[i];
            list[i].line = line;
        }
    }
}

int model_check_obj(const char *path, FILE *file)
{
    named list[3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    statement s;
    unsigned long line = 1;
    unsigned long faces = 0;
    unsigned long infinite = 0;
    unsigned long first_infinite = 0;
    unsigned long unended_line = 0;
    bool comment = false;
    int previous = 0;
    memset(&s, 0, sizeof s);
    for (;;) {
        int c = getc_unlocked(file);
        if (c == '\0')
            return report_fault(path, "line %lu has a NUL byte, which an OBJ file cannot contain",
                                line);
        if (c == '\n' && previous == '\\' && !comment) {
            ++line;
            previous = c;
            end_word(&s);
            continue;
        }
        previous = c == '\r' && previous == '\\' ? previous : c;
        if (c == '#' && s.length == 0)
            comment = true;
        if (c == '\n' || c == EOF) {
            end_word(&s);
            bool unended = c == EOF && !comment && least_words(&s) > 0;
            if (unended && is_incomplete(&s))
                return report_fault(path, "it is cut short: its last line, %lu, is incomplete",
                                    line);
            const char *fault = fault_of(&s);
            if (fault != NULL)
                return report_fault(path, "line %lu: %s %s, not %zu", line, s.keyword, fault,
                                    s.words);
            if (unended)
                unended_line = line;
            if (s.infinite && infinite++ == 0)
                first_infinite = line;
            faces += is(&s, "f");
            count_named(&s, line, list);
            if (c == EOF)
                break;
            memset(&s, 0, sizeof s);
            comment = false;
            ++line;
        } else if (!comment) {
            if (c == ' ' || c == '\t' || c == '\r' || c == '\\')
                end_word(&s);
            else
                add_byte(&s, c);
        }
    }
    if (ferror(file) != 0)
        return report_fault(path, "cannot be read");
    if (faces == 0)
        return report_fault(path, "there are no triangles in it: no line has a face, f%s",
                            unended_line > 0 ? "; and its last one has no end: it is cut short"
                                             : "");
    for (int i = 0; i < 3; ++i) {
        if (list[i].highest > 0 && (unsigned long)list[i].highest > list[i].count)
            return report_fault(path, "line %lu: f names %s %ld, but there are only %lu",
                                list[i].line, named_keywords[i], list[i].highest, list[i].count);
    }
    if (unended_line > 0)
        report_warning(path, "its last line, %lu, has no end: it may be cut short", unended_line);
    /* Assimp itself replaces them by zero. */
    if (infinite > 0)
        report_warning(
            path,
            "%lu of its texture coordinates (vt), the first in line %lu, are not finite; "
            "0 is used",
            infinite, first_infinite);
    return 0;
}
