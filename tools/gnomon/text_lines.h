/* Texts of lines and words, in which # at the beginning of a word begins a comment: files of views
 * and scripts of events. A byte-order mark at the beginning is skipped. */
#ifndef TEXT_LINES_H
#define TEXT_LINES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct text_lines {
    char *bytes; /* the file, and a zero */
    size_t size;
    size_t next;     /* where the next line begins */
    uint64_t number; /* of the line that was read last, from 1 on */
    bool has_zero;   /* a zero byte is in that line */
} text_lines;

/* Reads a file. Returns 0, or EXIT_FAULT with the reason printed; free either way. */
int text_lines_read(const char *path, text_lines *result);

/* The next line, which may be changed; null at the end. */
char *text_lines_next(text_lines *t);

/* Ends the word at the beginning of *line, which is moved behind it. Returns the word, or null at
 * the end of the line and before a comment. */
char *text_lines_word(char **line);

void text_lines_free(text_lines *t);

#endif
