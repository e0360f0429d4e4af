/* Work on files that may be hostile: they may make their readers, Assimp and stb_image, crash, hang
 * or use all memory. So a child process reads them under limits, and sends the contents to this
 * process. */
#ifndef CONFINED_H
#define CONFINED_H

#include "handover.h"

/* The child's side: reads, and sends the last record, HANDOVER_RESULT with what follows it or
 * HANDOVER_FAULT. Lines that it reports are printed by the parent. Returns false if the pipe is
 * closed. */
typedef bool confined_work(int descriptor, const void *context);

/* The parent's side: receives what follows HANDOVER_RESULT, whose text is passed in. Returns false
 * with the reason in the state. */
typedef bool confined_receive(handover *h, const char *text, void *result);

/* Runs the work on the file of this path and receives its result. Returns 0, or EXIT_FAULT with the
 * reason printed, which names the file and, if a limit was reached, the option that raises it; free
 * the result either way. Call it before threads are started. */
int confined_run(const char *path, const import_limits *limits, confined_work *work,
                 const void *context, confined_receive *receive, void *result);

/* Whether the limit of memory holds. It does not with AddressSanitizer, which reserves terabytes of
 * address space for itself. If it cannot map more, it ends the process or waits for ever, where
 * malloc would return null. */
bool confined_limits_memory(void);

#endif
