/* Whether a dimension of a texture repeats by a mask of bits. */
#ifndef GN_TEXTURE_WRAPS_H
#define GN_TEXTURE_WRAPS_H

#include <gnomon/lookup.h>

static inline bool is_power_of_two(uint32_t n)
{
    return (n & (n - 1)) == 0;
}

/* Returns whether a dimension repeats by a mask: if its largest level is a power of two. */
static inline bool repeats_by_mask(gn_wrap wrap, uint32_t largest)
{
    return wrap == GN_WRAP_REPEAT && is_power_of_two(largest);
}

#endif
