/* Reading the text of a scene, token by token. Each function takes the next token or tokens; if
 * they are not what the function reads, it fails and returns 0. */
#ifndef SCENE_READER_H
#define SCENE_READER_H

#include "scene.h"
#include "scene_text.h"

/* A reader stops at the first fault: every later token is empty. */
typedef struct reader {
    FILE *in;
    unsigned long line;
    char token[64];
    bool failed;
    char *error;
    size_t error_size;
} reader;

/* Stores the reason, after the line's number, as the reader's fault, unless there is one
 * already. */
void scene_reader_fail(reader *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Returns the next token, "" at the end of the input or after a fault. */
const char *scene_reader_next(reader *r);

/* Reads an integer from 0 to largest, in base 10 or 16. */
uint32_t read_number(reader *r, int base, uint32_t largest);
int32_t read_integer(reader *r);
float read_float(reader *r);
void read_floats(reader *r, float *values, size_t count);

/* Reads the values of a keyword of a scene or, if d is not null, of a member of a draw. Returns
 * whether it is such a keyword. */
bool read_keyword(reader *r, const char *keyword, scene *s, scene_draw *d);

/* Reads a name of the set and returns its value. */
int read_name(reader *r, text_names set);

/* Reads count words, each with READ. Memory grows with the words that are there, not with the count
 * that the text promises. The caller frees it. */
uint32_t *read_words(reader *r, size_t count, uint32_t (*read)(reader *r));
uint32_t read_float_word(reader *r);
uint32_t read_hexadecimal_word(reader *r);
uint32_t read_decimal_word(reader *r);

#endif
