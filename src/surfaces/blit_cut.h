/* Cuts a blit's rectangles to the surfaces and the scissor. */
#ifndef GN_SURFACES_BLIT_CUT_H
#define GN_SURFACES_BLIT_CUT_H

#include <stdbool.h>

#include <gnomon/blit.h>

/* One dimension of a rectangle, from a first end to a last end, which may be the lower one. */
typedef struct blit_range {
    int32_t first, last;
} blit_range;

/* Cuts `cut` at `limit`; `above` says whether numbers above or below the limit are cut off. At most
 * one end of `cut` lies there and is moved to the limit. The corresponding end of `other` is moved
 * in proportion, counted from the lower end of `cut`, to the nearest integer. */
static inline void cut_end(blit_range *cut, blit_range *other, int32_t limit, bool above)
{
    const bool rises = cut->first < cut->last;
    const int32_t low = rises ? cut->first : cut->last;
    const int32_t high = rises ? cut->last : cut->first;
    const int32_t anchor = rises ? other->first : other->last;
    const int32_t end = rises ? other->last : other->first;

    if (above ? high <= limit : low >= limit)
        return;
    const float length = (float)(limit - low) / (float)(high - low) * (float)(end - anchor);
    const int32_t follows = anchor + (int32_t)(length + (length < 0.0f ? -0.5f : 0.5f));
    if (rises == above) {
        cut->last = limit;
        other->last = follows;
    } else {
        cut->first = limit;
        other->first = follows;
    }
}

static inline bool lies_outside(const blit_range *r, int32_t low, int32_t high)
{
    return (r->first <= low && r->last <= low) || (r->first >= high && r->last >= high);
}

/* Cuts the ranges to low..high of the destination and 0..size of the source. Returns false if
 * nothing is left. */
static inline bool cut_ranges(blit_range *to, blit_range *from, int32_t low, int32_t high,
                              int32_t size)
{
    if (to->first == to->last || from->first == from->last || low >= high ||
        lies_outside(to, low, high) || lies_outside(from, 0, size))
        return false;
    cut_end(to, from, high, true);
    cut_end(to, from, low, false);

    /* The rest of the source may round to an empty range, at which a texel is still read. */
    if (from->first == from->last)
        return from->first >= 0 && from->first <= size;
    if (lies_outside(from, 0, size))
        return false;
    cut_end(from, to, size, true);
    cut_end(from, to, 0, false);
    return to->first != to->last;
}

#endif
