/* Copying rows of pixels as they are. */
#ifndef GN_SURFACES_COPY_H
#define GN_SURFACES_COPY_H

#include "../lanes/lanes.h"

/* From this many bytes on a string instruction is faster: it writes whole cache lines without
 * reading them. */
#define STRING_BYTES 1024

/* Copies bytes. The memory must not overlap, unless both are the same. */
static inline void copy_bytes(unsigned char *to, const unsigned char *from, size_t size)
{
    size_t i = 0;

#if defined(__GNUC__) && (defined(__x86_64__) || defined(__i386__))
    if (size >= STRING_BYTES) {
        __asm__ volatile("rep movsb" : "+D"(to), "+S"(from), "+c"(size) : : "memory");
        return;
    }
#endif
    if (((uintptr_t)to | (uintptr_t)from) % 4 == 0)
        for (; i + 4 * GN_LANES <= size; i += 4 * GN_LANES)
            lanes_i_store((stored_word *)(void *)(to + i),
                          lanes_i_load((const stored_word *)(const void *)(from + i)));
    for (; i < size; ++i)
        to[i] = from[i];
}

#endif
