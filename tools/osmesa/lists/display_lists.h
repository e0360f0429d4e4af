/* Display lists: calls in the order in which they were recorded, in memory that grows and does not
 * move (OpenGL 2.1 section 5.4). Begin and end with nothing but vertices between become meshes. */
#ifndef OSMESA_DISPLAY_LISTS_H
#define OSMESA_DISPLAY_LISTS_H

#include "list_record.h"

enum { LIST_NESTING = 64 };

typedef struct list_call {
    struct list_call *next;
    replay_function *replay;
    call_kind kind;
} list_call;

typedef struct list_block list_block;

struct display_list {
    list_call *first, *last;
    list_block *blocks;
    size_t used; /* of the latest block */
};

/* Returns an empty list; null if memory is short. */
display_list *create_list(void);
void destroy_list(void *list);

/* Returns aligned memory of a list; null if memory is short. */
void *list_memory(display_list *list, size_t size);

/* Appends a call after `last`, where it is null at the beginning. Returns its arguments. */
void *append_call(display_list *list, replay_function *replay, size_t size, call_kind kind);

static inline void *arguments_of(list_call *call)
{
    return call + 1;
}

/* Executes all calls of a list. */
void replay_list(display_list *list);

/* What is known of the list that a context compiles. */
typedef struct list_compiler list_compiler;

/* Returns null if memory is short. */
list_compiler *create_compiler(void);
void destroy_compiler(list_compiler *compiler);

/* Tells that a call of this kind is about to be appended, CALL_OTHER at the end of the list. Turns
 * the primitives before it into meshes, if they are complete. */
void before_call(context *gl, call_kind kind);

#endif
