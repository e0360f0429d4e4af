/* A process that outlives its rank for a moment: if the rank is killed, so that it can neither say
 * nor end anything itself, the keeper says which rank it was, and ends the task that the rank was
 * running. Otherwise the task would go on, and disturb the run that is started next. */
#ifndef KEEPER_H
#define KEEPER_H

#include <stdint.h>

/* Starts the keeper. Call it before MPI starts, so that it has no part in MPI. `name` begins its
 * message. Returns the file descriptor to give to the other functions, or -1 with errno set. */
int keeper_begin(const char *name);

/* Called by a task, the leader of its process group, before it executes its command. */
void keeper_watch(int keeper, uint32_t rank, const char *task);

/* Called when the task has ended. */
void keeper_forget(int keeper, uint32_t rank);

/* Called by a rank that ends at once and has said why. The task is ended then, without a message.
 */
void keeper_be_silent(int keeper);

/* Ends the keeper. */
void keeper_end(int keeper);

#endif
