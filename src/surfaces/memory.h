/* Memory of surfaces, copied as it is or filled with a repeated value. */
#ifndef GN_SURFACES_MEMORY_H
#define GN_SURFACES_MEMORY_H

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

/* From this many words on a string instruction is faster: it fills whole cache lines without
 * reading them, at up to twice the speed of 16-byte stores, after a start of 30 ns. */
#define STRING_WORDS 1024

/* The words of a pattern that is filled in: whole lanes, and at least a pixel of four words. */
#define PATTERN_WORDS (GN_LANES < 4 ? 4 : GN_LANES)

/* Fills memory with `pattern`, which repeats every four words. */
static inline void fill_words(stored_word *memory, size_t count,
                              const int32_t pattern[PATTERN_WORDS])
{
    size_t i = 0;

#if defined(__GNUC__) && (defined(__x86_64__) || defined(__i386__))
    if (count >= STRING_WORDS && pattern[0] == pattern[1] && pattern[0] == pattern[2] &&
        pattern[0] == pattern[3]) {
        __asm__ volatile("rep stosl" : "+D"(memory), "+c"(count) : "a"(pattern[0]) : "memory");
        return;
    }
#endif
#if GN_LANES == 1
    const int32_t a = pattern[0], b = pattern[1], c = pattern[2], d = pattern[3];

    for (; i + 4 <= count; i += 4) {
        memory[i] = a;
        memory[i + 1] = b;
        memory[i + 2] = c;
        memory[i + 3] = d;
    }
#else
    const lanes_i value = lanes_i_load(pattern);

    for (; i + GN_LANES <= count; i += GN_LANES)
        lanes_i_store(memory + i, value);
#endif
    for (; i < count; ++i)
        memory[i] = pattern[i % PATTERN_WORDS];
}

#endif
