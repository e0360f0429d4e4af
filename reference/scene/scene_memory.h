/* Memory for scenes: allocation that ends the program rather than fail. */
#ifndef SCENE_MEMORY_H
#define SCENE_MEMORY_H

#include <stddef.h>

/* count elements of size bytes, zeroed; at least one byte, so never null. */
void *scene_allocate(size_t count, size_t size);

/* The memory grown or shrunk to count elements of size bytes. */
void *scene_reallocate(void *memory, size_t count, size_t size);

#endif
