/* The file of results, to which rank 0 alone appends whole lines. */
#ifndef RESULT_FILE_H
#define RESULT_FILE_H

#include <stdbool.h>
#include <sys/types.h>

#include "task_list.h"

typedef struct result_file {
    int descriptor;
    off_t size;
} result_file;

/* Whether a line is the result of the task of this name: it begins with the name, and then ends or
 * has a blank or a tab. */
bool is_result(const char *line, const char *name);

/* Opens the file, or creates it, and locks it until this process ends. A line at its end that was
 * cut off is dropped. Marks the tasks that have a line. Returns false with the reason. */
bool result_file_open(result_file *file, const char *path, task_list *list,
                      char reason[REASON_SIZE]);

/* Appends a line, and waits until it is on the disk. Returns false with the reason; the file is
 * then as it was. */
bool result_file_add(result_file *file, const char *line, char reason[REASON_SIZE]);

#endif
