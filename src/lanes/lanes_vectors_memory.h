/* The operations of lanes_vectors.h between lanes and memory: packed colours, blocks of pixels,
 * rows of words, words by index.
 * Not alone: lanes_vectors.h includes it after the types of lanes. */
#ifndef GN_LANES_LANES_VECTORS_MEMORY_H
#define GN_LANES_LANES_VECTORS_MEMORY_H

/* Returns one channel of lanes_pack_unorm8 in the low bytes; what is above them differs. From 0 to
 * 255, adding 2^23 rounds and leaves the integer in the low bits. The bits of every input that
 * yields 0 are at least those of 2^31 as unsigned numbers; with the other sign they have the same
 * order as signed numbers. */
GN_OPERATION vector_u lanes_vector_unorm8(vector_f channel)
{
    const vector_f scaled = channel * 255.0f;
    const vector_i bits = (vector_i)scaled;
    const vector_i some = (vector_i)((bits ^ INT32_MIN) < (LANE_BITS_2_31 ^ INT32_MIN));
    const vector_i full = (vector_i)(bits > LANE_BITS_255);

    return (vector_u)(((vector_i)(scaled + 8388608.0f) | full) & some);
}

GN_OPERATION vector_i lanes_vector_pack(vector_f red, vector_f green, vector_f blue, vector_f alpha)
{
    return (vector_i)((lanes_vector_unorm8(red) & 0xFFu) |
                      (lanes_vector_unorm8(green) & 0xFFu) << 8 |
                      (lanes_vector_unorm8(blue) & 0xFFu) << 16 | lanes_vector_unorm8(alpha) << 24);
}

GN_OPERATION lanes_i lanes_pack_unorm8(lanes_f red, lanes_f green, lanes_f blue, lanes_f alpha)
{
    LANES_EACH_REGISTER(lanes_i, lanes_vector_pack(red.q[n], green.q[n], blue.q[n], alpha.q[n]));
}

GN_OPERATION vector_f lanes_vector_unpack(vector_i packed, int channel)
{
    const vector_i byte = (vector_i)((vector_u)packed >> (uint32_t)(8 * channel)) & 0xFF;

    return __builtin_convertvector(byte, vector_f) * (float)(1.0 / 255.0);
}

GN_OPERATION lanes_f lanes_unpack_unorm8(lanes_i packed, int channel)
{
    LANES_EACH_REGISTER(lanes_f, lanes_vector_unpack(packed.q[n], channel));
}

GN_OPERATION lanes_i lanes_i_load_block(const unsigned char *lower, const unsigned char *upper,
                                        ptrdiff_t stride)
{
    LANES_EACH_REGISTER(lanes_i, lanes_vector_load((n < 2 ? lower : upper) + n % 2 * stride));
}

GN_OPERATION void lanes_i_store_block(unsigned char *lower, unsigned char *upper, ptrdiff_t stride,
                                      lanes_i a)
{
    lanes_vector_store(lower, a.q[0]);
    lanes_vector_store(lower + stride, a.q[1]);
    lanes_vector_store(upper, a.q[2]);
    lanes_vector_store(upper + stride, a.q[3]);
}

/* Transposes 4x4 words. */
GN_OPERATION void lanes_vector_transpose(vector_i r[4])
{
    const vector_i a = LANES_SHUFFLE(r[0], r[1], 0, 4, 1, 5);
    const vector_i b = LANES_SHUFFLE(r[0], r[1], 2, 6, 3, 7);
    const vector_i c = LANES_SHUFFLE(r[2], r[3], 0, 4, 1, 5);
    const vector_i d = LANES_SHUFFLE(r[2], r[3], 2, 6, 3, 7);

    r[0] = LANES_SHUFFLE(a, c, 0, 1, 4, 5);
    r[1] = LANES_SHUFFLE(a, c, 2, 3, 6, 7);
    r[2] = LANES_SHUFFLE(b, d, 0, 1, 4, 5);
    r[3] = LANES_SHUFFLE(b, d, 2, 3, 6, 7);
}

/* Puts four rows of four words into register n of four lanes_i. */
GN_OPERATION void lanes_vector_from_rows(vector_i row[4], int n, lanes_i out[4])
{
    lanes_vector_transpose(row);
    GN_UNROLLED
    for (int c = 0; c < 4; ++c)
        out[c].q[n] = row[c];
}

GN_OPERATION void lanes_vector_to_rows(const lanes_i in[4], int n, vector_i row[4])
{
    GN_UNROLLED
    for (int c = 0; c < 4; ++c)
        row[c] = in[c].q[n];
    lanes_vector_transpose(row);
}

GN_OPERATION void lanes_i_gather_rows(const unsigned char *memory, const uint32_t *offset,
                                      uint32_t step, lanes_i out[4])
{
    GN_UNROLLED
    for (int n = 0; n < 4; ++n) {
        vector_i r[4];

        GN_UNROLLED
        for (int l = 0; l < 4; ++l)
            r[l] = lanes_vector_load(memory + offset[(uint32_t)(4 * n + l) * step]);
        lanes_vector_from_rows(r, n, out);
    }
}

GN_OPERATION void lanes_i_scatter_rows(unsigned char *memory, size_t stride, const lanes_i in[4])
{
    GN_UNROLLED
    for (int n = 0; n < 4; ++n) {
        vector_i r[4];

        lanes_vector_to_rows(in, n, r);
        GN_UNROLLED
        for (int l = 0; l < 4; ++l)
            lanes_vector_store(memory + (size_t)(4 * n + l) * stride, r[l]);
    }
}

GN_OPERATION vector_i lanes_vector_gather(const stored_word *base, const int32_t at[4])
{
    return (vector_i){base[at[0]], base[at[1]], base[at[2]], base[at[3]]};
}

GN_OPERATION lanes_i lanes_i_gather(const stored_word *base, lanes_i index)
{
    int32_t at[GN_LANES];

    lanes_i_store(at, index);
    LANES_EACH_REGISTER(lanes_i, lanes_vector_gather(base, at + 4 * n));
}

/* Loads two pairs of words. */
GN_OPERATION vector_i lanes_vector_pairs(const stored_word *base, int32_t first, int32_t second)
{
    return (vector_i)(vector_pairs){*(const stored_pair *)(const void *)(base + first),
                                    *(const stored_pair *)(const void *)(base + second)};
}

GN_OPERATION void lanes_i_gather_pairs(const stored_word *base, lanes_i index, lanes_i *first,
                                       lanes_i *second)
{
    int32_t at[GN_LANES];

    lanes_i_store(at, index);
    GN_UNROLLED
    for (int n = 0; n < 4; ++n) {
        const vector_i low = lanes_vector_pairs(base, at[4 * n], at[4 * n + 1]);
        const vector_i high = lanes_vector_pairs(base, at[4 * n + 2], at[4 * n + 3]);

        first->q[n] = LANES_SHUFFLE(low, high, 0, 2, 4, 6);
        second->q[n] = LANES_SHUFFLE(low, high, 1, 3, 5, 7);
    }
}

#endif
