/* Numbered tasks, handed out to ranks as they become free. Rank 0 hands them out, and works itself.
 * It looks for questions in tasks_poll, which its tasks call now and then; every other rank asks
 * for its next task before it begins one, so that it need not wait for the answer.
 *
 *   rank 0                      any other rank
 *          <- ask --------------       (one task is being done)
 *          -- task N ---------->
 *          <- result of a task -       (if tasks have results)
 *          <- ask, with how many it has done since the last time
 *          -- no more task ---->
 *          <- ended, with the status --
 *          -- all have ended, with the largest status ->
 *
 * If a task fails, no more tasks are given to anyone. A rank that is killed ends all ranks: the
 * launcher sees to it. */
#ifndef TASKS_H
#define TASKS_H

#include <stdint.h>

typedef struct tasks tasks;

/* What a task has made, from malloc; zeroed: nothing. */
typedef struct task_result {
    uint8_t *bytes;
    uint64_t size;
} task_result;

typedef struct tasks_job {
    uint32_t count; /* tasks are numbered from 0 on */
    void *context;  /* for both functions */

    /* Does a task. Returns 0, or a status with the reason printed. If it takes long, it calls
     * tasks_poll now and then: at rank 0 others may wait until it does. */
    int (*work)(void *context, tasks *t, uint32_t number, task_result *result);

    /* Takes the results at rank 0, in the order of their numbers; the caller frees them. Returns 0,
     * or a status with the reason printed. It may be called from tasks_poll. Null: tasks have no
     * results. At most four results for each rank wait for those before them. */
    int (*take)(void *context, uint32_t number, const task_result *result);
} tasks_job;

/* Collective. Does all tasks, each once, and rank 0 shows the progress of all (progress.h). Returns
 * the largest status of all ranks, at all of them, when nobody works any more; *here is how many
 * tasks this rank has done. A process that is alone does them one after another. */
int tasks_run(const tasks_job *job, uint32_t *here);

/* Answers questions that have come. */
void tasks_poll(tasks *t);

#endif
