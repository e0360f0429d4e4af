/* What all lookups in a texture with a sampler have in common, worked out once for them. */
#ifndef GN_TEXTURE_LOOKUP_STATE_H
#define GN_TEXTURE_LOOKUP_STATE_H

#include <stddef.h>

#include "../formats/decode_table.h"
#include "lookup_kernels.h"
#include "texel_layout.h"

/* One level: its texels, and its columns, rows and layers. */
typedef struct lookup_level {
    texel_layout layout;
    uint32_t size[3];
} lookup_level;

typedef struct lookup_state {
    const gn_texture *of_texture; /* the caller's */
    const gn_sampler *of_sampler;
    gn_texture texture; /* copies, since the caller may change theirs */
    gn_sampler sampler;
    lookup_kernel kernel;
    masked_words nearest; /* of KERNEL_MASKED_WORDS */
    const format_decoding *decoding;
    int dimensions; /* 1 to 3: the dimensions that are filtered */
    gn_wrap wrap[3];
    bool masks[3];     /* the dimension repeats by a mask */
    bool may_be_inner; /* all dimensions repeat or are clamped to the edge */
    bool has_border;
    bool mixes_border;  /* the border is finite, and not compared: mixed with itself it stays */
    float border[4];    /* if has_border is set */
    gn_compare compare; /* GN_COMPARE_DEFAULT: no comparison, as for colours */
    lookup_level level[GN_MAX_LEVELS]; /* all of the texture */
} lookup_state;

/* The states of a task, in its own memory. Shaders look up few textures, so few states are kept, of
 * 1.6 KB each; fewer where processors have no vector registers, and little stack. */
#if GN_SPECIALISED && GN_HAVE_REGISTERS
#define MOST_LOOKUP_STATES 8
#else
#define MOST_LOOKUP_STATES 2
#endif

struct gn_lookup_memory {
    uint32_t count, next; /* states that are set, and the one that is set next */
    uint32_t capacity;
    lookup_state *state;
    gn_status status; /* the first fault of a texture or sampler */
};

/* Returns whether texture and sampler can be looked up; if not, the memory's status is not GN_OK.
 */
static inline bool may_be_looked_up(gn_lookup_memory *memory, const gn_texture *texture,
                                    const gn_sampler *sampler)
{
    const gn_status of_texture = gn_texture_check(texture);
    const gn_status status = of_texture ? of_texture : gn_sampler_check(sampler);

    memory->status = memory->status ? memory->status : status;
    return status == GN_OK;
}

/* Makes memory for `capacity` states, of which none is set. */
static inline void start_lookup_memory(gn_lookup_memory *memory, lookup_state *state,
                                       uint32_t capacity)
{
    memory->count = memory->next = 0;
    memory->capacity = capacity;
    memory->state = state;
    memory->status = GN_OK;
}

/* Sets a state in the place of an older one, and returns it. Returns null if the texture or the
 * sampler has a fault. */
const lookup_state *gni_add_lookup_state(gn_lookup_memory *memory, const gn_texture *texture,
                                         const gn_sampler *sampler);

/* Words that are compared at once: a vector of GNU C, or one word. */
#if defined(__GNUC__)
typedef uint64_t word_group __attribute__((__vector_size__(16), __aligned__(4), __may_alias__));
typedef uint32_t group_word __attribute__((__may_alias__));
#else
typedef uint32_t word_group, group_word;
#endif

/* Returns the bits in which two stretches of words differ. The last group may overlap the one
 * before it. Stretches shorter than a group are compared word by word. */
static inline word_group differing_bits(const void *a, const void *b, size_t bytes)
{
    const unsigned char *const x = (const unsigned char *)a, *const y = (const unsigned char *)b;
    const bool has_groups = bytes >= sizeof(word_group);
    const size_t last = has_groups ? bytes - sizeof(word_group) : 0;
    word_group bits = {0};

    for (size_t at = 0; at < bytes && !has_groups; at += sizeof(group_word))
        bits |= *(const group_word *)(const void *)(x + at) ^
                *(const group_word *)(const void *)(y + at);
    if (!has_groups)
        return bits;
    bits = *(const word_group *)(const void *)(x + last) ^
           *(const word_group *)(const void *)(y + last);
    for (size_t at = 0; at < last; at += sizeof(word_group))
        bits |= *(const word_group *)(const void *)(x + at) ^
                *(const word_group *)(const void *)(y + at);
    return bits;
}

static inline bool has_bits(word_group bits)
{
#if defined(__GNUC__)
    return (bits[0] | bits[1]) != 0;
#else
    return bits != 0;
#endif
}

/* The bytes from one member of a type up to, but not including, another. */
#define BYTES_BETWEEN(type, from, to) (offsetof(type, to) - offsetof(type, from))

/* Returns whether a state is that of a texture and a sampler. Reads no padding, which may have no
 * value, if enumerations have the size of int. */
static inline bool is_state_of(const lookup_state *state, const gn_texture *texture,
                               const gn_sampler *sampler)
{
    const gn_texture *const t = &state->texture;
    const gn_sampler *const s = &state->sampler;

    if (state->of_texture != texture || state->of_sampler != sampler ||
        t->target != texture->target || t->format != texture->format ||
        t->level_count != texture->level_count ||
        s->lod_clamp_enabled != sampler->lod_clamp_enabled)
        return false;
    return !has_bits(
        differing_bits(&t->width, &texture->width,
                       BYTES_BETWEEN(gn_texture, width, level_count) + sizeof t->level_count) |
        differing_bits(t->level, texture->level, levels_of(t) * sizeof t->level[0]) |
        differing_bits(s, sampler, BYTES_BETWEEN(gn_sampler, wrap_s, lod_clamp_enabled)) |
        differing_bits(&s->min_lod, &sampler->min_lod,
                       BYTES_BETWEEN(gn_sampler, min_lod, border) + sizeof s->border));
}

/* Returns the state of a texture and a sampler, or null if one of them has a fault. */
static inline const lookup_state *
lookup_state_of(gn_lookup_memory *memory, const gn_texture *texture, const gn_sampler *sampler)
{
    for (uint32_t n = 0; n < memory->count; ++n)
        if (is_state_of(&memory->state[n], texture, sampler))
            return &memory->state[n];
    return gni_add_lookup_state(memory, texture, sampler);
}

#endif
