/* Measures messages between two ranks. */
#ifndef SCALE_MESSAGES_H
#define SCALE_MESSAGES_H

#include <stdbool.h>

/* Measures messages between ranks 0 and 1, and adds their latency and bandwidth to a file of
 * figures. Every rank calls it. Returns false with a message, also if there is one rank. */
bool messages_measure(const char *path);

#endif
