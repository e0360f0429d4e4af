/* Options of the benchmarks' command lines. */
#ifndef BENCH_OPTIONS_H
#define BENCH_OPTIONS_H

#include <stdbool.h>

typedef enum option_kind {
    OPTION_TEXT,    /* to: const char * */
    OPTION_NUMBER,  /* to: int, 1 to `most` */
    OPTION_BACKEND, /* to: gn_backend, one that this machine has */
    OPTION_FLAG     /* to: bool; the option has no value */
} option_kind;

typedef struct option {
    const char *name; /* null after the last one */
    option_kind kind;
    void *to;
    int most; /* of texts: how many the option may give, one after the other from `to`; 0 is 1 */
} option;

/* The program's name in messages, and the option that helps. */
extern const char *option_program, *option_help;

/* Prints a message on standard error and returns the exit status of a wrong command line. */
int usage_error(const char *what, const char *value);

/* Prints the help and returns true if a word of the command line is --help. */
bool options_help(int argc, char **argv, const char *help);

/* Reads the words of a command line into what the options point to; later values of one option go
 * behind the earlier ones if it may be given several times. Returns 0, or what usage_error
 * returns. */
int options_read(int argc, char **argv, const option *options);

#endif
