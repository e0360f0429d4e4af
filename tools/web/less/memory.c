/* malloc, realloc and free in a tenth of the C library's code: one list of free blocks in the order
 * of their addresses, of which the first one that fits is taken (Kernighan and Ritchie, The C
 * Programming Language, section 8.7). The module that explains pixels has few blocks at a time. */
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define PAGE_BYTES 65536u

/* Before every block; blocks are multiples of 16 bytes, these ones included. */
typedef struct block {
    _Alignas(16) struct block *next; /* of the free blocks */
    size_t bytes;
} block;

extern unsigned char __heap_base;

static block *first;
static uintptr_t end; /* of the memory that blocks were made of; 0 before the first call */

/* Puts a block into the list, and joins it with its neighbours. */
static void release(block *b)
{
    block **at = &first;

    while (*at != NULL && *at < b && (char *)*at + (*at)->bytes != (char *)b)
        at = &(*at)->next;
    if (*at != NULL && *at < b) { /* it continues a free block */
        (*at)->bytes += b->bytes;
        b = *at;
    } else {
        b->next = *at;
        *at = b;
    }
    if (b->next != NULL && (char *)b + b->bytes == (char *)b->next) {
        b->bytes += b->next->bytes;
        b->next = b->next->next;
    }
}

/* Makes a free block of at least so many bytes at the end of memory. */
static int extend(size_t bytes)
{
    const uintptr_t from = end != 0 ? end : ((uintptr_t)&__heap_base + 15) & ~(uintptr_t)15;
    const uintptr_t have = (uintptr_t)__builtin_wasm_memory_size(0) * PAGE_BYTES;
    block *const b = (block *)from;

    if (bytes > UINTPTR_MAX - from - PAGE_BYTES)
        return 0;
    if (from + bytes > have) {
        const size_t pages = (from + bytes - have + PAGE_BYTES - 1) / PAGE_BYTES;

        if (__builtin_wasm_memory_grow(0, pages) == (size_t)-1)
            return 0;
    }
    end = from + bytes;
    b->bytes = bytes;
    release(b);
    return 1;
}

void *malloc(size_t bytes)
{
    const size_t needed = ((bytes + 15) & ~(size_t)15) + sizeof(block);

    if (needed < bytes)
        return NULL;
    for (;;) {
        for (block **at = &first; *at != NULL; at = &(*at)->next) {
            block *const b = *at;

            if (b->bytes < needed)
                continue;
            if (b->bytes >= needed + 2 * sizeof(block)) {
                block *const rest = (block *)((char *)b + needed);

                rest->next = b->next;
                rest->bytes = b->bytes - needed;
                *at = rest;
                b->bytes = needed;
            } else {
                *at = b->next;
            }
            return b + 1;
        }
        if (!extend(needed))
            return NULL;
    }
}

void free(void *memory)
{
    if (memory != NULL)
        release((block *)memory - 1);
}

void *calloc(size_t count, size_t size)
{
    if (size != 0 && count > SIZE_MAX / size)
        return NULL;
    void *const memory = malloc(count * size);

    if (memory != NULL)
        memset(memory, 0, count * size);
    return memory;
}

void *realloc(void *memory, size_t bytes)
{
    void *const grown = malloc(bytes);

    if (memory != NULL && grown != NULL) {
        const size_t had = ((block *)memory - 1)->bytes - sizeof(block);

        memcpy(grown, memory, had < bytes ? had : bytes);
        free(memory);
    }
    return grown;
}
