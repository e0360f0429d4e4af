/* Names of numbered files: a pattern with one %d, or %04d for at least four digits. %% stands for a
 * percent sign. */
#ifndef NUMBERING_H
#define NUMBERING_H

#include <stdbool.h>
#include <stdint.h>

/* Whether a name is meant as a pattern: it has a percent sign. */
bool numbering_is_pattern(const char *name);

/* Whether a pattern has exactly one number, of at most nine digits, and nothing else after a
 * percent sign. */
bool numbering_is_valid(const char *pattern);

/* Returns the name with this number, allocated; null if there is not enough memory. The pattern is
 * valid. */
char *numbering_name(const char *pattern, uint32_t number);

#endif
