/* Runs the command of a task as a process beside this one. */
#ifndef TASK_RUN_H
#define TASK_RUN_H

#include <stdbool.h>
#include <stdint.h>
#include <sys/types.h>

#include "task_list.h"

/* Longer lines are no results. */
enum { LINE_MOST = 65535 };

typedef struct task_run {
    pid_t process; /* 0: no task is running */
    int output;
    int keeper;
    uint32_t rank;
    const task *task;
    char line[LINE_MOST + 1]; /* what has come of the current line */
    size_t length;            /* of it; above LINE_MOST if the line is too long */
    bool has_result;
    char result[LINE_MOST + 1]; /* the last line that is a result of the task */
    char ended[64];             /* "exit status 1", "signal 9" */
} task_run;

/* Starts the task. Its standard input is empty, its standard error is this process's, and its
 * standard output is read. Its environment has FARM_RANK, the rank's number, and not the variables
 * by which programs of MPI find their launcher. Returns false with the reason. */
bool task_start(task_run *run, const task *started, uint32_t rank, char reason[REASON_SIZE]);

/* Waits at most this time for the task to print something or to end. Returns whether it has ended.
 */
bool task_has_ended(task_run *run, int milliseconds);

#endif
