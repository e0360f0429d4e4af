/* Hashing of instances and the set of argument combinations that have been tried. */
#include "theft_internal.h"

/* FNV-1a, 64 bits (Fowler, Noll, Vo; RFC 9923). */
void theft_hash_init(struct theft_hasher *h)
{
    h->accum = UINT64_C(0xcbf29ce484222325);
}

void theft_hash_sink(struct theft_hasher *h, const uint8_t *data, size_t bytes)
{
    for (size_t i = 0; i < bytes; ++i)
        h->accum = (h->accum ^ data[i]) * UINT64_C(0x100000001b3);
}

theft_hash theft_hash_done(struct theft_hasher *h)
{
    const theft_hash hash = h->accum;
    theft_hash_init(h);
    return hash;
}

theft_hash theft_hash_onepass(const uint8_t *data, size_t bytes)
{
    struct theft_hasher hasher;
    theft_hash_init(&hasher);
    theft_hash_sink(&hasher, data, bytes);
    return theft_hash_done(&hasher);
}

/* Open addressing with linear probing; 0 marks a free slot. Returns the slot that holds `hash` or
 * where it belongs. */
static size_t slot_of(const theft_hash *slots, size_t capacity, theft_hash hash)
{
    uint64_t state = hash;
    size_t slot = (size_t)runner_next_word(&state) & (capacity - 1);
    while (slots[slot] != 0 && slots[slot] != hash)
        slot = (slot + 1) & (capacity - 1);
    return slot;
}

static bool grow(struct hash_set *set)
{
    const size_t capacity = set->capacity == 0 ? 256 : 2 * set->capacity;
    theft_hash *slots = calloc(capacity, sizeof *slots);
    if (slots == NULL)
        return false;
    for (size_t i = 0; i < set->capacity; ++i)
        if (set->slots[i] != 0)
            slots[slot_of(slots, capacity, set->slots[i])] = set->slots[i];
    free(set->slots);
    set->slots = slots;
    set->capacity = capacity;
    return true;
}

enum step runner_hash_set_insert(struct hash_set *set, theft_hash hash)
{
    if (hash == 0)
        hash = 1;
    if (2 * (set->count + 1) > set->capacity && !grow(set))
        return STEP_NO_MEMORY;
    const size_t slot = slot_of(set->slots, set->capacity, hash);
    if (set->slots[slot] == hash)
        return STEP_SEEN;
    set->slots[slot] = hash;
    ++set->count;
    return STEP_NEXT;
}

void runner_hash_set_free(struct hash_set *set)
{
    free(set->slots);
    set->slots = NULL;
    set->capacity = 0;
    set->count = 0;
}
