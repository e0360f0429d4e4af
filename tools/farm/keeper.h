/* A process that outlives its rank for a moment: if the rank is killed, so that it can end nothing
 * itself, the keeper ends the task that the rank was running. Otherwise the task would go on, and
 * disturb the run that is started next. */
#ifndef KEEPER_H
#define KEEPER_H

#include <stdbool.h>

/* Starts the keeper. Call it before MPI starts, so that it has no part in MPI. Returns the file
 * descriptor to give to keeper_watch, or -1 with errno set. */
int keeper_begin(void);

/* Called by a task, the leader of its process group, before it executes its command. */
void keeper_watch(int keeper);

/* Called when the task has ended. */
void keeper_forget(int keeper);

/* Ends the keeper. */
void keeper_end(int keeper);

#endif
