/* The calls of display lists and their memory. */
#include <stdlib.h>
#include <string.h>

#include "display_lists.h"

/* Blocks of this many bytes, or of as many as are asked for at once. */
enum { BLOCK_SIZE = 8192, ALIGNMENT = 16 };

struct list_block {
    list_block *next;
    size_t size;
};

display_list *create_list(void)
{
    return calloc(1, sizeof(display_list));
}

void destroy_list(void *memory)
{
    display_list *const list = memory;

    for (list_block *block = list->blocks; block;) {
        list_block *const next = block->next;

        free(block);
        block = next;
    }
    free(list);
}

void *list_memory(display_list *list, size_t size)
{
    const size_t aligned = (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    unsigned char *memory;

    if (aligned < size)
        return NULL;
    if (!list->blocks || aligned > list->blocks->size - list->used) {
        const size_t capacity = aligned > BLOCK_SIZE ? aligned : BLOCK_SIZE;
        list_block *const block =
            capacity > SIZE_MAX - ALIGNMENT ? NULL : malloc(ALIGNMENT + capacity);

        if (!block)
            return NULL;
        block->next = list->blocks;
        block->size = capacity;
        list->blocks = block;
        list->used = 0;
    }
    memory = (unsigned char *)list->blocks + ALIGNMENT + list->used;
    list->used += aligned;
    return memory;
}

void *append_call(display_list *list, replay_function *replay, size_t size, call_kind kind)
{
    list_call *const call = list_memory(list, sizeof *call + size);

    if (!call)
        return NULL;
    *call = (list_call){NULL, replay, kind};
    if (list->last)
        list->last->next = call;
    else
        list->first = call;
    list->last = call;
    return arguments_of(call);
}

/* As in the reference, attributes of lists that are set outside primitives do not become those of
 * the vertices that wait. */
void replay_list(display_list *list)
{
    for (list_call *call = list->first; call; call = call->next) {
        if (call->kind == CALL_VERTEX)
            flush_vertices(current_context());
        call->replay(arguments_of(call));
    }
}
