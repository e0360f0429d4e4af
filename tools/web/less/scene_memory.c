/* Memory of a module: what the page allocates for its arguments, and stand-ins for functions of the
 * scene whose own forms print to standard error or are not wanted. */
#include <stdlib.h>

#include "page_parts.h"
#include "scene_memory.h"

/* Ends the module, as reference/scene/scene_memory.c ends a program; the page finds the reason in
 * the message. page_build asks for the memory before, so that this is rare. */
static void end_without_memory(void)
{
    page_fail("there is not enough memory; reload the page", (const char *)NULL);
    __builtin_trap();
}

void *scene_allocate(size_t count, size_t size)
{
    void *const memory = calloc(count != 0 ? count : 1, size != 0 ? size : 1);
    if (memory == NULL)
        end_without_memory();
    return memory;
}

void *scene_reallocate(void *memory, size_t count, size_t size)
{
    const bool fits = size == 0 || count <= SIZE_MAX / size;
    const size_t bytes = fits ? count * size : 0;
    void *const moved = fits ? realloc(memory, bytes != 0 ? bytes : 1) : NULL;
    if (moved == NULL)
        end_without_memory();
    return moved;
}
