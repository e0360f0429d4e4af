/* Finds equal vertices with a hash table. */
#include "shared_vertices.h"

#include <stdlib.h>
#include <string.h>

enum { EMPTY = 0 }; /* an entry is the number of a kept vertex, and 1 */

/* Returns a hash of the bits of floats (FNV-1a of words, with the high bits mixed in). */
static uint32_t hash_of(const float *vertex, uint32_t stride)
{
    uint32_t hash = 2166136261u;

    for (uint32_t i = 0; i < stride; ++i) {
        uint32_t bits;

        memcpy(&bits, &vertex[i], sizeof bits);
        hash = (hash ^ bits) * 16777619u;
        hash ^= hash >> 15;
    }
    return hash;
}

uint32_t share_vertices(float *vertex, uint32_t count, uint32_t stride, uint32_t *number)
{
    const size_t bytes = stride * sizeof *vertex;
    uint32_t kept = 0;
    size_t entries = 16;
    uint32_t *table;

    while (entries < 2 * (size_t)count)
        entries *= 2;
    table = calloc(entries, sizeof *table);
    if (!table)
        return 0;
    for (uint32_t v = 0; v < count; ++v) {
        const float *const from = vertex + (size_t)v * stride;
        size_t at = hash_of(from, stride) & (entries - 1);

        while (table[at] != EMPTY &&
               memcmp(vertex + (size_t)(table[at] - 1) * stride, from, bytes) != 0)
            at = (at + 1) & (entries - 1);
        if (table[at] == EMPTY) {
            memmove(vertex + (size_t)kept * stride, from, bytes);
            table[at] = ++kept;
        }
        number[v] = table[at] - 1;
    }
    free(table);
    return kept;
}
