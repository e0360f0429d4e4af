/* Memory for scenes: an allocation that fails ends the program. */
#ifndef SCENE_MEMORY_H
#define SCENE_MEMORY_H

#include <stddef.h>

/* Returns count zeroed elements of size bytes; at least one byte, so never null. */
void *scene_allocate(size_t count, size_t size);

/* Returns the memory grown or shrunk to count elements of size bytes. */
void *scene_reallocate(void *memory, size_t count, size_t size);

#endif
