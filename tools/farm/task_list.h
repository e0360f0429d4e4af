/* The list of tasks: lines of a name, a tab and a shell command. */
#ifndef TASK_LIST_H
#define TASK_LIST_H

#include <stdbool.h>
#include <stddef.h>

typedef struct task {
    const char *name, *command;
    bool done; /* the file of results has its line already */
} task;

typedef struct task_list {
    char *text; /* the lines, whose tabs and line ends have become '\0' */
    task *tasks;
    task **by_name; /* sorted */
    size_t count;
} task_list;

enum { REASON_SIZE = 512 };

/* Reads a file. Returns its bytes with a '\0' behind them, which the caller frees, or null with the
 * reason. */
char *read_whole(const char *path, size_t *size, char reason[REASON_SIZE]);

/* Makes the list of its text of `size` bytes, which the list owns from now on. Empty lines, and
 * lines that begin with '#', are left out. Returns false with the reason, which names the line, if
 * a line has no name or no command, a name occurs twice, or the text has a byte 0. */
bool task_list_begin(task_list *list, char *text, size_t size, char reason[REASON_SIZE]);

/* Returns the task of this name, or null. */
task *task_list_find(const task_list *list, const char *name, size_t length);

void task_list_end(task_list *list);

#endif
