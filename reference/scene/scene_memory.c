/* Memory for scenes. If there is not enough, the program ends with a line that says how much was
 * asked for. */
#include "scene_memory.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static void out_of_memory(size_t count, size_t size)
{
    fprintf(stderr, "scene: not enough memory for %zu elements of %zu bytes\n", count, size);
    exit(EXIT_FAILURE);
}

void *scene_allocate(size_t count, size_t size)
{
    void *memory = calloc(count ? count : 1, size ? size : 1);

    if (!memory)
        out_of_memory(count, size);
    return memory;
}

void *scene_reallocate(void *memory, size_t count, size_t size)
{
    void *moved = NULL;

    if (!size || count <= SIZE_MAX / size) {
        const size_t bytes = count * size;

        moved = realloc(memory, bytes ? bytes : 1);
    }
    if (!moved)
        out_of_memory(count, size);
    return moved;
}
