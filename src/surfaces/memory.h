/* Memory of surfaces, copied as it is or filled with a repeated pixel. */
#ifndef GN_SURFACES_MEMORY_H
#define GN_SURFACES_MEMORY_H

#include "../formats/pixel_memory.h"

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

/* Pixels of every size repeat in as many whole words, and these in three times 16 lanes. */
#define PATTERN_WORDS 12

/* Fills memory with the words of a pattern, which are all the same if the first four are. */
static inline void fill_words(stored_word *memory, size_t count,
                              const int32_t pattern[PATTERN_WORDS])
{
    const int32_t a = pattern[0];
    const bool is_one = a == pattern[1] && a == pattern[2] && a == pattern[3];
    size_t i = 0;

#if defined(__GNUC__) && (defined(__x86_64__) || defined(__i386__))
    if (count >= STRING_WORDS && is_one) {
        __asm__ volatile("rep stosl" : "+D"(memory), "+c"(count) : "a"(a) : "memory");
        return;
    }
#endif
#if GN_LANES == 1 || !GN_HAVE_REGISTERS
    for (; is_one && i + 4 <= count; i += 4) {
        memory[i] = a;
        memory[i + 1] = a;
        memory[i + 2] = a;
        memory[i + 3] = a;
    }
#else
    if (is_one) {
        for (; i + GN_LANES <= count; i += GN_LANES)
            lanes_i_store(memory + i, lanes_i_splat(a));
    } else if (count >= 3 * GN_LANES) {
        int32_t words[3 * GN_LANES];

        for (int n = 0; n < 3 * GN_LANES; ++n)
            words[n] = pattern[n % PATTERN_WORDS];
        const lanes_i first = lanes_i_load(words), second = lanes_i_load(words + GN_LANES),
                      third = lanes_i_load(words + 2 * GN_LANES);
        for (; i + 3 * GN_LANES <= count; i += 3 * GN_LANES) {
            lanes_i_store(memory + i, first);
            lanes_i_store(memory + i + GN_LANES, second);
            lanes_i_store(memory + i + 2 * GN_LANES, third);
        }
    }
#endif
    for (; i < count; ++i)
        memory[i] = pattern[i % PATTERN_WORDS];
}

/* A pixel's bytes as they lie in memory. */
typedef union pixel_bytes {
    unsigned char byte[LAYOUT_MOST_BYTES];
    int32_t word[LAYOUT_MOST_BYTES / 4];
} pixel_bytes;

/* Sets the words that pixels of `size` bytes make from byte `first` of a pixel on. */
static inline void set_pattern(const pixel_bytes *pixel, uint32_t size, uint32_t first,
                               int32_t pattern[PATTERN_WORDS])
{
    const uint32_t period = size % 4 == 0 ? size : size < 3 ? 4 : 12; /* in bytes */
    pixel_bytes repeated;

    if (first == 0 && period == size) {
        for (uint32_t n = 0; n < size / 4; ++n)
            repeated.word[n] = pixel->word[n];
    } else {
        for (uint32_t b = 0; b < period; ++b) {
            repeated.byte[b] = pixel->byte[first];
            first = first + 1 == size ? 0 : first + 1;
        }
    }
    for (uint32_t i = 0, n = 0; i < PATTERN_WORDS; ++i) {
        pattern[i] = repeated.word[n];
        n = n + 1 == period / 4 ? 0 : n + 1;
    }
}

/* Fills `size` bytes, which are whole pixels of `pixel_size` bytes. */
static inline void fill_pixels(unsigned char *memory, size_t size, const pixel_bytes *pixel,
                               uint32_t pixel_size)
{
    int32_t pattern[PATTERN_WORDS];
    size_t head = (0 - (uintptr_t)memory) % 4;

    head = head < size ? head : size;
    set_pattern(pixel, pixel_size, (uint32_t)head % pixel_size, pattern);
    for (size_t i = 0; i < head; ++i)
        memory[i] = pixel->byte[i % pixel_size];

    const size_t count = (size - head) / 4;
    fill_words((stored_word *)(void *)(memory + head), count, pattern);
    for (size_t i = head + 4 * count; i < size; ++i)
        memory[i] = pixel->byte[i % pixel_size];
}

#endif
