/* The table of commands: what --help, the man page and the completions of shells say of each. */
#ifndef COMMAND_TABLE_H
#define COMMAND_TABLE_H

#include "options.h"

/* In texts, a line that begins with two blanks is shown as it stands; the others are broken where
 * there is room. An empty line begins a paragraph. */
typedef struct command_row {
    command which;
    char name[12];
    const char *words;    /* behind the name, before the options */
    const char *title;    /* what it does, in a few words */
    const char *usage;    /* the same in sentences */
    const char *examples; /* one a line */
    const char *text;     /* what else --help says; null: nothing */
    const char *more;     /* what --help-all and the man page say beyond that; null: nothing */
    const char *statuses; /* the exit status */
} command_row;

extern const command_row command_table[];
extern const size_t command_count;

/* The row of a command; its name as typed. */
const command_row *command_row_of(command which);
const char *command_name(command which);

/* The formats of models; what holds for all pictures of them; what all commands do with results and
 * with outputs; their exit status. */
extern const char command_models[], command_drawing[], command_results[], command_statuses[];

#endif
