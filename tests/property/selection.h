/* Which properties run: those that `--only` chooses by name. The suites call property_run() for
 * each property, and property_run() asks here. So the names are known after the suites were called
 * once without running anything. */
#ifndef SELECTION_H
#define SELECTION_H

#include <stdbool.h>
#include <stdio.h>

/* Whether property_run() runs the property of this name. Until selection_choose() is called, no
 * property is included, and each name that is asked for is remembered. */
bool selection_includes(const char *name);

/* Chooses, among the names remembered, the one that equals `only`; if none does, all that contain
 * it. A null `only` chooses all. Returns how many it chose. */
size_t selection_choose(const char *only);

/* Prints the chosen names, one a line. */
void selection_print(FILE *file);

/* Prints, in one line, up to four of the remembered names that have most in common with `only`. */
void selection_print_near(const char *only, FILE *file);

#endif
