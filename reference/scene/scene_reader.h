/* Reading the text of a scene, token by token: each function takes the next token or tokens, and
 * fails where they are not what it reads, giving 0. */
#ifndef SCENE_READER_H
#define SCENE_READER_H

#include "scene.h"
#include "scene_text.h"

/* A reader stops at the first fault: from then on every token is empty. */
typedef struct reader {
    FILE *in;
    unsigned long line;
    char token[64];
    bool failed;
    char *error;
    size_t error_size;
} reader;

/* Puts the reason, after the line's number, where the first fault goes. */
void reader_fail(reader *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The next token, "" at the end of the input or after a fault. */
const char *reader_next(reader *r);

/* 0 to largest, in base 10 or 16. */
uint32_t read_number(reader *r, int base, uint32_t largest);
int32_t read_integer(reader *r);
float read_float(reader *r);
void read_floats(reader *r, float *values, size_t count);
gn_vec3 read_vec3(reader *r);

/* The value of a name of the set. */
int read_name(reader *r, text_names set);

/* count words, each by READ; memory grows with what is there, not with what is promised. The
 * caller frees it. */
uint32_t *read_words(reader *r, size_t count, uint32_t (*read)(reader *r));
uint32_t read_float_word(reader *r);
uint32_t read_hexadecimal_word(reader *r);
uint32_t read_decimal_word(reader *r);

#endif
