/* The operations of recording lanes on memory.
 * Not alone: recording_lanes.h includes it. */
#ifndef EXPLAIN_RECORDING_MEMORY_H
#define EXPLAIN_RECORDING_MEMORY_H

/* Whether arrays that lanes_load loads were written in scalar C: set-up of points and lines fills
 * one array again and again, and equal bits may be another attribute's. */
static bool loads_are_leaves;

RECORD lanes_f lanes_load(const float *p)
{
    lanes_f r;

    r.plain = plain_lanes_load(p);
    for (int l = 0; l < GN_LANES; ++l)
        r.node[l] = loads_are_leaves ? graph_add(OP_FLOAT, bits_of_float(p[l]), 0, 0, 0, 0)
                                     : record_load(p + l, bits_of_float(p[l]), OP_FLOAT);
    return r;
}

RECORD void record_store(float *p, const node_id *a)
{
    plain_lanes_store(p, RECORD_LANES(lanes_f, a)->plain);
    for (int l = 0; l < GN_LANES; ++l)
        graph_store(p + l, a[l]);
}
#define lanes_store(p, a) record_store(p, (a).node)

RECORD lanes_i lanes_i_load(const stored_word *p)
{
    lanes_i r;

    r.plain = plain_lanes_i_load(p);
    for (int l = 0; l < GN_LANES; ++l)
        r.node[l] = record_load(p + l, (uint32_t)p[l], OP_INTEGER);
    return r;
}

RECORD void record_i_store(stored_word *p, const node_id *a)
{
    plain_lanes_i_store(p, RECORD_LANES(lanes_i, a)->plain);
    for (int l = 0; l < GN_LANES; ++l)
        graph_store(p + l, a[l]);
}
#define lanes_i_store(p, a) record_i_store(p, (a).node)

/* Returns the word of lane l of a block. */
static inline const stored_word *block_word(const unsigned char *lower, const unsigned char *upper,
                                            ptrdiff_t stride, int l)
{
    const unsigned char *const row = (l < GN_LANES / 2 ? lower : upper) + l / 4 % 2 * stride;

    return (const stored_word *)(const void *)row + l % 4;
}

RECORD lanes_i lanes_i_load_block(const unsigned char *lower, const unsigned char *upper,
                                  ptrdiff_t stride)
{
    lanes_i r;

    r.plain = plain_lanes_i_load_block(lower, upper, stride);
    for (int l = 0; l < GN_LANES; ++l)
        r.node[l] =
            record_load(block_word(lower, upper, stride, l), (uint32_t)r.plain.v[l], OP_INTEGER);
    return r;
}

RECORD void lanes_i_store_block(unsigned char *lower, unsigned char *upper, ptrdiff_t stride,
                                lanes_i a)
{
    plain_lanes_i_store_block(lower, upper, stride, a.plain);
    for (int l = 0; l < GN_LANES; ++l)
        graph_store(block_word(lower, upper, stride, l), a.node[l]);
}

RECORD void lanes_i_gather_rows(const unsigned char *memory, const uint32_t *offset, uint32_t step,
                                lanes_i out[4])
{
    plain_lanes_i rows[4];

    plain_lanes_i_gather_rows(memory, offset, step, rows);
    for (int c = 0; c < 4; ++c) {
        out[c].plain = rows[c];
        for (int l = 0; l < GN_LANES; ++l)
            out[c].node[l] = record_load(memory + offset[(uint32_t)l * step] + 4 * c,
                                         (uint32_t)rows[c].v[l], OP_INTEGER);
    }
}

RECORD void lanes_i_scatter_rows(unsigned char *memory, size_t stride, const lanes_i in[4])
{
    plain_lanes_i rows[4];

    for (int c = 0; c < 4; ++c)
        rows[c] = in[c].plain;
    plain_lanes_i_scatter_rows(memory, stride, rows);
    for (int c = 0; c < 4; ++c)
        for (int l = 0; l < GN_LANES; ++l)
            graph_store(memory + (size_t)l * stride + 4 * c, in[c].node[l]);
}

RECORD lanes_i lanes_i_gather(const stored_word *base, lanes_i index)
{
    lanes_i r;

    r.plain = plain_lanes_i_gather(base, index.plain);
    for (int l = 0; l < GN_LANES; ++l)
        r.node[l] = record_load(base + index.plain.v[l], (uint32_t)r.plain.v[l], OP_INTEGER);
    return r;
}

RECORD void lanes_i_gather_pairs(const stored_word *base, lanes_i index, lanes_i *first,
                                 lanes_i *second)
{
    *first = lanes_i_gather(base, index);
    *second = lanes_i_gather(base + 1, index);
}

RECORD lanes_f record_unpack_unorm8(const node_id *packed, int channel)
{
    lanes_f r;

    r.plain = plain_lanes_unpack_unorm8(RECORD_LANES(lanes_i, packed)->plain, channel);
    record_number(OP_UNPACK_BYTE, r.plain.v, packed, (uint32_t)channel, r.node);
    return r;
}
#define lanes_unpack_unorm8(packed, channel) record_unpack_unorm8((packed).node, channel)

RECORD lanes_i lanes_pack_unorm8(lanes_f red, lanes_f green, lanes_f blue, lanes_f alpha)
{
    lanes_i r;

    r.plain = plain_lanes_pack_unorm8(red.plain, green.plain, blue.plain, alpha.plain);
    for (int l = 0; l < GN_LANES; ++l) {
        const uint32_t word = (uint32_t)r.plain.v[l];
        const node_id byte[4] = {graph_add(OP_PACK_BYTE, word & 255, red.node[l], 0, 0, 0),
                                 graph_add(OP_PACK_BYTE, word >> 8 & 255, green.node[l], 0, 0, 0),
                                 graph_add(OP_PACK_BYTE, word >> 16 & 255, blue.node[l], 0, 0, 0),
                                 graph_add(OP_PACK_BYTE, word >> 24, alpha.node[l], 0, 0, 0)};

        r.node[l] = graph_add(OP_PACK_WORD, word, byte[0], byte[1], byte[2], byte[3]);
    }
    return r;
}

/* In place of src/lanes/gather.h, whose forms go through memory one lane at a time. */
#define GN_LANES_GATHER_H

static inline int32_t number_of_bytes(const unsigned char *p, int count)
{
    uint32_t number = p[0];

    for (int n = 1; n < count; ++n)
        number |= (uint32_t)p[n] << 8 * n;
    return (int32_t)number;
}

RECORD lanes_i lanes_i_gather_bytes(const unsigned char *base, lanes_i offset, int count)
{
    lanes_i r;

    for (int l = 0; l < GN_LANES; ++l) {
        const unsigned char *const p = base + offset.plain.v[l];

        r.plain.v[l] = number_of_bytes(p, count);
        r.node[l] = trace.is_recording ? record_leaf(p, (uint32_t)r.plain.v[l], OP_INTEGER) : 0;
    }
    return r;
}

RECORD void lanes_i_gather_fours(const stored_word *base, lanes_i index, lanes_i out[4])
{
    for (int c = 0; c < 4; ++c)
        out[c] = lanes_i_gather(base + c, index);
}

RECORD void lanes_i_gather_eight(const unsigned char *base, lanes_i offset, lanes_i *low,
                                 lanes_i *high)
{
    *low = lanes_i_gather_bytes(base, offset, 4);
    *high = lanes_i_gather_bytes(base + 4, offset, 4);
}

#endif
