/* Lanes that record: the operations of src/lanes/lanes.h, each of which calls the library's own
 * portable operation and adds a node for every lane to the graph. Operations that only move bits
 * (as_int, as_float, m_as_int, the lanes of quads) hand the nodes on. Values in memory are followed
 * by their addresses; what no operation stored becomes a leaf, which record_leaf names. */
#ifndef EXPLAIN_RECORDING_LANES_H
#define EXPLAIN_RECORDING_LANES_H

#include "graph.h"
#include "plain_lanes.h"

typedef struct lanes_f {
    plain_lanes_f plain;
    node_id node[GN_LANES];
} lanes_f;

typedef struct lanes_i {
    plain_lanes_i plain;
    node_id node[GN_LANES];
} lanes_i;

typedef struct lanes_m {
    plain_lanes_m plain;
    node_id node[GN_LANES];
} lanes_m;

/* Returns a leaf for a word that memory holds, and a constant that a stage uses. */
static node_id record_leaf(const void *address, uint32_t bits, graph_operation type);
static node_id record_constant(float f);

/* Records an operation in every lane. Absent operands are null. */
static void record(graph_operation operation, const void *result, const node_id *a,
                   const node_id *b, const node_id *c, node_id node[GN_LANES])
{
    const uint32_t *const bits = (const uint32_t *)result;

    for (int l = 0; l < GN_LANES; ++l)
        node[l] = trace.is_recording ? graph_add(operation, bits[l], a ? a[l] : 0, b ? b[l] : 0,
                                                 c ? c[l] : 0, 0)
                                     : 0;
}

/* Records an operation whose second operand is a number. */
static void record_number(graph_operation operation, const void *result, const node_id *a,
                          uint32_t number, node_id node[GN_LANES])
{
    const uint32_t *const bits = (const uint32_t *)result;

    for (int l = 0; l < GN_LANES; ++l)
        node[l] = trace.is_recording ? graph_add(operation, bits[l], a[l], number, 0, 0) : 0;
}

/* Gives every lane one node. */
static void record_same(node_id same, node_id node[GN_LANES])
{
    for (int l = 0; l < GN_LANES; ++l)
        node[l] = same;
}

static node_id record_load(const void *address, uint32_t bits, graph_operation type)
{
    const node_id known = graph_load(address, bits);

    return known || !trace.is_recording ? known : record_leaf(address, bits, type);
}

#define RECORD_UNARY(result, name, operand, operation)                                             \
    static inline result lanes_##name(operand a)                                                   \
    {                                                                                              \
        result r;                                                                                  \
        r.plain = plain_lanes_##name(a.plain);                                                     \
        record(operation, r.plain.v, a.node, 0, 0, r.node);                                        \
        return r;                                                                                  \
    }

#define RECORD_BINARY(result, name, operand, operation)                                            \
    static inline result lanes_##name(operand a, operand b)                                        \
    {                                                                                              \
        result r;                                                                                  \
        r.plain = plain_lanes_##name(a.plain, b.plain);                                            \
        record(operation, r.plain.v, a.node, b.node, 0, r.node);                                   \
        return r;                                                                                  \
    }

#define RECORD_SELECT(type, name, operation)                                                       \
    static inline type lanes_##name(lanes_m m, type a, type b)                                     \
    {                                                                                              \
        type r;                                                                                    \
        r.plain = plain_lanes_##name(m.plain, a.plain, b.plain);                                   \
        record(operation, r.plain.v, m.node, a.node, b.node, r.node);                              \
        return r;                                                                                  \
    }

#define RECORD_MOVE(result, name, operand)                                                         \
    static inline result lanes_##name(operand a)                                                   \
    {                                                                                              \
        result r;                                                                                  \
        r.plain = plain_lanes_##name(a.plain);                                                     \
        for (int l = 0; l < GN_LANES; ++l)                                                         \
            r.node[l] = a.node[l];                                                                 \
        return r;                                                                                  \
    }

RECORD_BINARY(lanes_f, add, lanes_f, OP_ADD)
RECORD_BINARY(lanes_f, sub, lanes_f, OP_SUB)
RECORD_BINARY(lanes_f, mul, lanes_f, OP_MUL)
RECORD_BINARY(lanes_f, div, lanes_f, OP_DIV)
RECORD_UNARY(lanes_f, sqrt, lanes_f, OP_SQRT)
RECORD_BINARY(lanes_f, min, lanes_f, OP_MIN)
RECORD_BINARY(lanes_f, max, lanes_f, OP_MAX)
RECORD_UNARY(lanes_f, floor, lanes_f, OP_FLOOR)
RECORD_UNARY(lanes_f, magnitude, lanes_f, OP_MAGNITUDE)
RECORD_BINARY(lanes_m, greater, lanes_f, OP_GREATER)
RECORD_BINARY(lanes_m, less_equal, lanes_f, OP_LESS_EQUAL)
RECORD_BINARY(lanes_m, and, lanes_m, OP_AND)
RECORD_UNARY(lanes_m, not, lanes_m, OP_NOT)
RECORD_SELECT(lanes_f, select, OP_SELECT)
RECORD_UNARY(lanes_i, truncate, lanes_f, OP_TRUNCATE)
RECORD_UNARY(lanes_i, round, lanes_f, OP_ROUND)
RECORD_UNARY(lanes_i, floor_to_int, lanes_f, OP_FLOOR_TO_INT)
RECORD_UNARY(lanes_f, to_float, lanes_i, OP_TO_FLOAT)
RECORD_BINARY(lanes_i, i_add, lanes_i, OP_I_ADD)
RECORD_BINARY(lanes_i, i_sub, lanes_i, OP_I_SUB)
RECORD_BINARY(lanes_i, i_mul, lanes_i, OP_I_MUL)
RECORD_BINARY(lanes_i, i_mul_shorts, lanes_i, OP_MUL_SHORTS)
RECORD_UNARY(lanes_i, i_high_bytes, lanes_i, OP_HIGH_BYTES)
RECORD_BINARY(lanes_i, i_add_bytes, lanes_i, OP_ADD_BYTES)
RECORD_BINARY(lanes_i, i_sub_bytes, lanes_i, OP_SUB_BYTES)
RECORD_BINARY(lanes_i, i_add_shorts, lanes_i, OP_ADD_SHORTS)
RECORD_BINARY(lanes_i, i_sub_shorts, lanes_i, OP_SUB_SHORTS)
RECORD_BINARY(lanes_i, i_scale_shorts, lanes_i, OP_SCALE_SHORTS)
RECORD_BINARY(lanes_i, i_min, lanes_i, OP_I_MIN)
RECORD_BINARY(lanes_i, i_max, lanes_i, OP_I_MAX)
RECORD_BINARY(lanes_i, i_or, lanes_i, OP_I_OR)
RECORD_BINARY(lanes_i, i_and, lanes_i, OP_I_AND)
RECORD_BINARY(lanes_i, i_xor, lanes_i, OP_I_XOR)
RECORD_BINARY(lanes_m, i_greater, lanes_i, OP_I_GREATER)
RECORD_BINARY(lanes_m, i_equal, lanes_i, OP_I_EQUAL)
RECORD_SELECT(lanes_i, i_select, OP_I_SELECT)
RECORD_MOVE(lanes_i, as_int, lanes_f)
RECORD_MOVE(lanes_f, as_float, lanes_i)
RECORD_MOVE(lanes_i, m_as_int, lanes_m)

static inline lanes_i lanes_i_clamp(lanes_i a, lanes_i low, lanes_i high)
{
    lanes_i r;

    r.plain = plain_lanes_i_clamp(a.plain, low.plain, high.plain);
    record(OP_I_CLAMP, r.plain.v, a.node, low.node, high.node, r.node);
    return r;
}

#define RECORD_SHIFT(name, operation)                                                              \
    static inline lanes_i lanes_##name(lanes_i a, int count)                                       \
    {                                                                                              \
        lanes_i r;                                                                                 \
        r.plain = plain_lanes_##name(a.plain, count);                                              \
        record_number(operation, r.plain.v, a.node, (uint32_t)count, r.node);                      \
        return r;                                                                                  \
    }

RECORD_SHIFT(i_shift_left, OP_I_SHIFT_LEFT)
RECORD_SHIFT(i_shift_right, OP_I_SHIFT_RIGHT)

/* The lanes of a quad: `from` is the lane whose value lane l takes. */
#define RECORD_QUAD(name, from)                                                                    \
    static inline lanes_f lanes_quad_##name(lanes_f a)                                             \
    {                                                                                              \
        lanes_f r;                                                                                 \
        r.plain = plain_lanes_quad_##name(a.plain);                                                \
        for (int l = 0; l < GN_LANES; ++l)                                                         \
            r.node[l] = a.node[from];                                                              \
        return r;                                                                                  \
    }

RECORD_QUAD(left, l & ~1)
RECORD_QUAD(right, l | 1)
RECORD_QUAD(lower, l & ~4)
RECORD_QUAD(upper, l | 4)

static inline uint32_t lanes_bits(lanes_m a)
{
    return plain_lanes_bits(a.plain);
}

static inline uint32_t lanes_i_sign_bits(lanes_i a)
{
    return plain_lanes_i_sign_bits(a.plain);
}

static inline lanes_f lanes_splat(float a)
{
    lanes_f r;

    r.plain = plain_lanes_splat(a);
    record_same(trace.is_recording ? record_constant(a) : 0, r.node);
    return r;
}

static inline lanes_i lanes_i_splat(int32_t a)
{
    lanes_i r;

    r.plain = plain_lanes_i_splat(a);
    record_same(graph_add(OP_INTEGER, (uint32_t)a, 0, 0, 0, 0), r.node);
    return r;
}

static inline lanes_i lanes_i_halves(int32_t lower, int32_t upper)
{
    lanes_i r;

    r.plain = plain_lanes_i_halves(lower, upper);
    record(OP_INTEGER, r.plain.v, 0, 0, 0, r.node);
    return r;
}

static inline lanes_i lanes_i_plane(int32_t per_column, int32_t per_row)
{
    lanes_i r;

    r.plain = plain_lanes_i_plane(per_column, per_row);
    record(OP_INTEGER, r.plain.v, 0, 0, 0, r.node);
    return r;
}

static inline lanes_m lanes_from_bits(uint32_t bits)
{
    lanes_m r;

    r.plain = plain_lanes_from_bits(bits);
    record(OP_MASK, r.plain.v, 0, 0, 0, r.node);
    return r;
}

static inline lanes_i lanes_i_mul_short(lanes_i a, int32_t b)
{
    return lanes_i_mul(a, lanes_i_splat(b));
}

/* per_x * (x + column) + origin, and per_y * (y + row). */
static inline lanes_f lanes_columns(float per_x, float x, float origin)
{
    lanes_f columns;

    columns.plain = plain_lanes_columns(1.0f, x, 0.0f);
    record(OP_FLOAT, columns.plain.v, 0, 0, 0, columns.node);
    return lanes_add(lanes_mul(lanes_splat(per_x), columns), lanes_splat(origin));
}

static inline lanes_f lanes_rows(float per_y, float y)
{
    lanes_f rows;

    rows.plain = plain_lanes_rows(1.0f, y);
    record(OP_FLOAT, rows.plain.v, 0, 0, 0, rows.node);
    return lanes_mul(lanes_splat(per_y), rows);
}

#include "recording_memory.h"

#endif
