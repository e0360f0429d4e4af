/* Threads whose order shows: a draw's tasks on the calling thread, the last one first. */
#ifndef UNIT_BACKWARDS_H
#define UNIT_BACKWARDS_H

#include "unit.h"

/* For gn_workspace.parallel. */
static inline void run_backwards(void *user, gn_task *task, void *context, uint32_t count)
{
    (void)user;
    while (count > 0)
        task(context, --count);
}

#endif
