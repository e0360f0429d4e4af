/* The documents that are written from the tables of commands and options. */
#ifndef DOCUMENTS_H
#define DOCUMENTS_H

#include <stdbool.h>
#include <stdio.h>

/* Writes the man page: lines of the template, and the parts that its lines with @ name. Returns
 * false if there is no such part. */
bool write_man(FILE *template, FILE *out);

/* Write the completions of bash and zsh. */
void write_bash(FILE *out);
void write_zsh(FILE *out);

#endif
