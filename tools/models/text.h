/* A text as lines of words and numbers: OBJ, MTL, and PLY and STL where they are texts. */
#ifndef TEXT_H
#define TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A word: bytes of the text, not terminated. */
typedef struct text_word {
    const char *start;
    size_t length;
} text_word;

/* Where reading is. All words lie between blanks and tabs; lines end with \n, \r\n or \r. */
typedef struct text_cursor {
    const char *at, *end;
    uint64_t line;      /* the number of the line at `at`, from 1 */
    char comment;       /* begins a comment where a word could begin; 0: there are none */
    bool continues;     /* a backslash at the end of a line continues it */
    uint64_t statement; /* the line on which text_next_line's line begins */
} text_cursor;

/* Starts at the beginning of a text; a byte-order mark is skipped. */
text_cursor text_begin(const uint8_t *bytes, size_t size);

/* Moves to the beginning of the next line that has a word, and sets `statement`. Returns false at
 * the end of the text. The first call finds the first line. */
bool text_next_line(text_cursor *t);

/* The next word of the line. Returns false, with an empty word, at the end of the line. */
bool text_next_word(text_cursor *t, text_word *word);

/* Moves to the end of the line. */
void text_pass_line(text_cursor *t);

/* The rest of the line without its comment, and without blanks at either end. */
text_word text_rest(text_cursor *t);

/* Whether the word is this one; the second function takes upper and lower case as equal. */
bool text_is(text_word word, const char *expected);
bool text_is_any_case(text_word word, const char *expected);

/* A finite decimal number: digits with or without a point and an exponent (.5, 5., -1e3; d is
 * taken for e). Returns false if the word as a whole is none. The spellings of infinity and NaN
 * that C libraries write, 1.#IND too, are numbers as well if `may_be_nan`; they give NaN. */
bool text_number(text_word word, bool may_be_nan, double *value);

/* A decimal integer that fits. */
bool text_integer(text_word word, int64_t *value);

/* The value of a hexadecimal digit; -1 for any other character. */
int text_hexadecimal(char c);

/* Copies a word for a message: at most size - 1 bytes; what was cut ends in "...". */
const char *text_copy(text_word word, char *buffer, size_t size);

#endif
