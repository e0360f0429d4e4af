/* The state of lookups, which is worked out by one function for all back ends. */
#include "lookup_state.h"

#include "../scalars/bits.h"
#include "wraps.h"

/* Sets a sampler's border as a texel of a format: clamped to the format's range. */
static void set_border(lookup_state *state)
{
    const channel_decoding *const first = &state->decoding->channel[0];
    const bool has_range = first->kind == CHANNEL_FRACTION || first->kind == CHANNEL_SRGB;
    const bool has_sign = !has_range && first->width >= 16;

    for (int c = 0; c < 4; ++c) {
        float value = state->sampler.border[c];

        if (has_range)
            value = value > 0.0f ? value < 1.0f ? value : 1.0f : 0.0f;
        else if (!has_sign)
            value = value > 0.0f ? value : 0.0f;
        state->border[c] = value;
    }
}

static void set_level(lookup_state *state, uint32_t level)
{
    const texel_extent extent = extent_of_level(&state->texture, level);
    lookup_level *const l = &state->level[level];

    gni_lay_out_texels(&state->texture, level, &l->layout);
    l->size[0] = extent.width;
    l->size[1] = extent.height;
    l->size[2] = extent.layers;
}

/* Copies a texture with the levels that it has. */
static void copy_texture(gn_texture *to, const gn_texture *from)
{
    to->target = from->target;
    to->format = from->format;
    to->width = from->width;
    to->height = from->height;
    to->depth = from->depth;
    to->level_count = from->level_count;
    for (uint32_t n = 0; n < levels_of(from); ++n)
        to->level[n] = from->level[n];
}

/* Sets the state of a checked texture and a checked sampler. */
static void set_lookup_state(lookup_state *state, const gn_texture *texture,
                             const gn_sampler *sampler)
{
    const gn_texture_target target = texture->target;
    const uint32_t largest[3] = {texture->width, texture->height, texture->depth};

    state->of_texture = texture;
    state->of_sampler = sampler;
    copy_texture(&state->texture, texture);
    state->sampler = *sampler;
    state->kernel = kernel_of(texture, sampler, &state->nearest);
    state->decoding = &gni_decodings[texture->format];
    state->dimensions = target == GN_TEXTURE_1D ? 1 : target == GN_TEXTURE_3D ? 3 : 2;
    state->wrap[0] = sampler->wrap_s;
    state->wrap[1] = sampler->wrap_t;
    state->wrap[2] = sampler->wrap_r;
    state->compare = state->decoding->has_depth ? sampler->compare : GN_COMPARE_DEFAULT;
    state->has_border = false;
    state->may_be_inner = true;
    for (int n = 0; n < 3; ++n) {
        const bool is_filtered = n < state->dimensions && target != GN_TEXTURE_CUBE;

        state->masks[n] = repeats_by_mask(state->wrap[n], largest[n]);
        state->may_be_inner = state->may_be_inner &&
                              (n >= state->dimensions || state->wrap[n] <= GN_WRAP_CLAMP_TO_EDGE);
        state->has_border =
            state->has_border || (is_filtered && state->wrap[n] == GN_WRAP_CLAMP_TO_BORDER);
    }
    state->mixes_border = state->has_border && state->compare == GN_COMPARE_DEFAULT;
    if (state->has_border)
        set_border(state);
    for (int c = 0; c < 4 && state->has_border; ++c)
        state->mixes_border = state->mixes_border && is_finite(state->border[c]);
    for (uint32_t level = 0; level < levels_of(texture); ++level)
        set_level(state, level);
}

const lookup_state *gni_add_lookup_state(gn_lookup_memory *memory, const gn_texture *texture,
                                         const gn_sampler *sampler)
{
    lookup_state *const state = &memory->state[memory->next];

    if (!may_be_looked_up(memory, texture, sampler))
        return 0;
    set_lookup_state(state, texture, sampler);
    memory->next = (memory->next + 1) % memory->capacity;
    if (memory->count < memory->capacity)
        ++memory->count;
    return state;
}
