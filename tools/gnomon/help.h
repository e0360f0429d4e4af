/* What the command says about itself, from the tables of commands and options. */
#ifndef HELP_H
#define HELP_H

#include "options.h"

/* Prints --help of a command, one line an option, or --help-all. Returns the exit status. */
int help_print(command which, bool all);

/* Prints the overview of all commands. Returns the exit status. */
int help_print_overview(void);

#endif
