/* Threads that share the work of a context's draws. The environment's GNOMON_THREADS says how many,
 * 1 to 64; the program's own thread is one of them. Pixels do not depend on it. */
#ifndef OSMESA_DRAW_THREADS_H
#define OSMESA_DRAW_THREADS_H

#include <gnomon.h>

/* Starts the threads with the first draw of a workspace. Without them the program's thread draws
 * alone. */
void start_draw_threads(gn_workspace *workspace);

/* Ends the workspace's threads. */
void end_draw_threads(gn_workspace *workspace);

#endif
