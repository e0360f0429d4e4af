/* Hashes of values, equal on every machine: FNV-1a with 64 bits. */
#ifndef PORTABILITY_HASH_H
#define PORTABILITY_HASH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

typedef uint64_t hash;

#define HASH_EMPTY UINT64_C(0xCBF29CE484222325)

static inline void add_byte(hash *h, uint32_t byte)
{
    *h = (*h ^ byte) * UINT64_C(0x100000001B3);
}

static inline void add_word(hash *h, uint32_t word)
{
    for (int i = 0; i < 4; ++i)
        add_byte(h, word >> 8 * i & 255);
}

/* Hashes words in the order of memory, each by its value. */
static inline void add_words(hash *h, const void *memory, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        uint32_t word;
        memcpy(&word, (const char *)memory + 4 * i, sizeof word);
        add_word(h, word);
    }
}

/* NaN counts as one number: compilers give the macro NAN either sign. */
static inline void add_float_bits(hash *h, uint32_t bits)
{
    add_word(h, (bits & 0x7FFFFFFFu) > 0x7F800000u ? 0x7FC00000u : bits);
}

/* Hashes bytes of floats, each float by its bits, but every NaN as one. */
static inline void add_floats(hash *h, const void *memory, size_t bytes)
{
    for (size_t i = 0; i < bytes / 4; ++i) {
        uint32_t bits;
        memcpy(&bits, (const char *)memory + 4 * i, sizeof bits);
        add_float_bits(h, bits);
    }
}

/* Prints a line: what was hashed, by what, the hash. The C library may lack formats of 64 bits. */
static inline void print_hash(const char *prefix, const char *name, const char *by, hash h)
{
    printf("%s%s %s %08lx%08lx\n", prefix, name, by, (unsigned long)(h >> 32),
           (unsigned long)(h & 0xFFFFFFFFu));
}

#endif
