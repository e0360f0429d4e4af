/* Events from a text, for gnomon view --script: one a line. */
#ifndef VIEW_SCRIPT_H
#define VIEW_SCRIPT_H

#include <stddef.h>

#include "window.h"

typedef struct view_script {
    window_event *events;
    size_t count;
} view_script;

/* Reads "drag X Y", "pan X Y", "wheel STEPS", "key CHARACTER", "resize WIDTH HEIGHT" and "wait
 * MILLISECONDS"; # begins a comment, except as the character of a key. Returns 0, EXIT_FAULT if the
 * file cannot be read, or EXIT_USAGE, with the reason printed; free either way. */
int view_script_read(const char *path, view_script *result);

void view_script_free(view_script *s);

#endif
