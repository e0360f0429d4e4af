/* The operations of lanes_portable.h between lanes and memory: packed colours, blocks of pixels,
 * rows of words, words by index.
 * Not alone: lanes_portable.h includes it after the types of lanes. */
#ifndef GN_LANES_LANES_PORTABLE_MEMORY_H
#define GN_LANES_LANES_PORTABLE_MEMORY_H

/* Returns one channel of lanes_pack_unorm8. From 0 to 255, adding 2^23 rounds and leaves the
 * integer in the low bits. Products that are negative, NaN or at least 2^31 yield 0: as
 * unsigned numbers their bits are at least LANE_BITS_2_31. */
static inline uint32_t lane_unorm8(float channel)
{
    const float scaled = channel * 255.0f;
    const int32_t bits = lane_as_int(scaled);
    const int32_t none = lane_mask((uint32_t)bits >= LANE_BITS_2_31);
    const int32_t full = lane_mask(bits > LANE_BITS_255);

    return (uint32_t)((lane_as_int(scaled + 8388608.0f) | full) & ~none) & 0xFFu;
}

/* Returns lane_unorm8(channel) for a channel in 0..1; outside, that or a number above 255. The bits
 * of 2^23 + n are those of 2^23 with n in the low byte. */
static inline uint32_t lane_near_unorm8(float channel)
{
    return (uint32_t)lane_as_int(channel * 255.0f + 8388608.0f) ^ LANE_BITS_2_23;
}

/* Packs channels as round-half-even(c * 255) saturated to 0..255, the first in the low byte. NaN
 * and products beyond the 32-bit integers become 0. A single lane takes a shorter path if all
 * channels are within 0..1. */
static inline lanes_i lanes_pack_unorm8(lanes_f red, lanes_f green, lanes_f blue, lanes_f alpha)
{
    lanes_i r;
    if (LANES == 1) {
        const uint32_t channel[4] = {lane_near_unorm8(red.v[0]), lane_near_unorm8(green.v[0]),
                                     lane_near_unorm8(blue.v[0]), lane_near_unorm8(alpha.v[0])};

        if ((channel[0] | channel[1] | channel[2] | channel[3]) <= 255) {
            r.v[0] = (int32_t)(channel[0] | channel[1] << 8 | channel[2] << 16 | channel[3] << 24);
            return r;
        }
    }
    GN_EACH_LANE (l)
        r.v[l] = (int32_t)(lane_unorm8(red.v[l]) | lane_unorm8(green.v[l]) << 8 |
                           lane_unorm8(blue.v[l]) << 16 | lane_unorm8(alpha.v[l]) << 24);
    return r;
}

/* Loads the lanes of a block: from each half, two rows of four values, `stride` bytes apart. */
static inline lanes_i lanes_i_load_block(const unsigned char *lower, const unsigned char *upper,
                                         ptrdiff_t stride)
{
    lanes_i r;
    GN_EACH_LANE (l) {
        const unsigned char *const row = (l < LANES / 2 ? lower : upper) + l / 4 % 2 * stride;
        r.v[l] = ((const stored_word *)(const void *)row)[l % 4];
    }
    return r;
}

static inline void lanes_i_store_block(unsigned char *lower, unsigned char *upper, ptrdiff_t stride,
                                       lanes_i a)
{
    GN_EACH_LANE (l) {
        unsigned char *const row = (l < LANES / 2 ? lower : upper) + l / 4 % 2 * stride;
        ((stored_word *)(void *)row)[l % 4] = a.v[l];
    }
}

/* Loads sixteen rows of four words; row l is at offset[l * step]. Word c of row l becomes lane l of
 * out[c]. */
static inline void lanes_i_gather_rows(const unsigned char *memory, const uint32_t *offset,
                                       uint32_t step, lanes_i out[4])
{
    GN_EACH_LANE (l) {
        const stored_word *const row =
            (const stored_word *)(const void *)(memory + offset[(uint32_t)l * step]);
        GN_UNROLLED
        for (int c = 0; c < 4; ++c)
            out[c].v[l] = row[c];
    }
}

/* Stores sixteen rows of four words, `stride` bytes apart: the inverse of lanes_i_gather_rows. */
static inline void lanes_i_scatter_rows(unsigned char *memory, size_t stride, const lanes_i in[4])
{
    GN_EACH_LANE (l) {
        stored_word *const row = (stored_word *)(void *)(memory + (size_t)l * stride);
        GN_UNROLLED
        for (int c = 0; c < 4; ++c)
            row[c] = in[c].v[l];
    }
}

/* Returns channel 0 to 3 of packed colours: byte * (1/255). */
static inline lanes_f lanes_unpack_unorm8(lanes_i packed, int channel)
{
    lanes_f r;
    GN_EACH_LANE (l)
        r.v[l] = (float)((uint32_t)packed.v[l] >> 8 * channel & 0xFF) * (float)(1.0 / 255.0);
    return r;
}

/* Returns base[index]. */
static inline lanes_i lanes_i_gather(const stored_word *base, lanes_i index)
{
    GN_EACH_LANE (l)
        index.v[l] = base[index.v[l]];
    return index;
}

/* Writes base[index] and base[index + 1]. */
static inline void lanes_i_gather_pairs(const stored_word *base, lanes_i index, lanes_i *first,
                                        lanes_i *second)
{
    GN_EACH_LANE (l) {
        first->v[l] = base[index.v[l]];
        second->v[l] = base[index.v[l] + 1];
    }
}

#endif
