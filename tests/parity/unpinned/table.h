/* The distances of groups of classes as a table. */
#ifndef DISTANCE_TABLE_H
#define DISTANCE_TABLE_H

#include "generate.h"
#include "measure.h"

/* Prints tables in Markdown: if `by_class`, one with a row for each class; then one with a row for
 * each group of classes, and the sum. */
void table_print(const distance of_class[CLASS_COUNT], bool by_class, const distance *all);

#endif
