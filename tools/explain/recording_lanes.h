/* Lanes that record: the operations of src/lanes/lanes.h, each of which calls the library's own
 * portable operation and adds a node for every lane to the graph. Operations that only move bits
 * (as_int, as_float, m_as_int, the lanes of quads) hand the nodes on. Values in memory are followed
 * by their addresses; what no operation stored becomes a leaf, which record_leaf names. */
#ifndef EXPLAIN_RECORDING_LANES_H
#define EXPLAIN_RECORDING_LANES_H

#include "graph.h"
#include "plain_lanes.h"

typedef struct lanes_f {
    node_id node[GN_LANES]; /* first: operations take its address as that of the lanes */
    plain_lanes_f plain;
} lanes_f;

typedef struct lanes_i {
    node_id node[GN_LANES]; /* first: operations take its address as that of the lanes */
    plain_lanes_i plain;
} lanes_i;

typedef struct lanes_m {
    node_id node[GN_LANES]; /* first: operations take its address as that of the lanes */
    plain_lanes_m plain;
} lanes_m;

/* Returns a leaf for a word that memory holds, and a constant that a stage uses. */
node_id record_leaf(const void *address, uint32_t bits, graph_operation type);
node_id record_constant(float f);

/* Records an operation in every lane. Absent operands are null. */
static void record(graph_operation operation, const void *result, const node_id *a,
                   const node_id *b, const node_id *c, node_id node[GN_LANES])
{
    const uint32_t *const bits = (const uint32_t *)result;

    for (int l = 0; l < GN_LANES; ++l)
        node[l] = trace.is_recording
                      ? graph_add(operation, bits[l], a ? a[l] : 0, b ? b[l] : 0, c ? c[l] : 0, 0)
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

/* Operations take addresses, as with GN_SMALL (src/lanes/calls.h): passing lanes by value takes
 * more code than most operations, at every call. An operand is passed as the array in its
 * structure, whose address C takes implicitly, also for the result of another operation. Such a
 * result lives until the end of the expression (C11 6.2.4). */
#if defined(__GNUC__)
#define RECORD static __attribute__((noinline, unused))
#else
#define RECORD static
#endif

#define RECORD_LANES(type, operand) ((const type *)(const void *)(operand))

#define RECORD_UNARY(result, name, type, operation)                                                \
    RECORD result record_##name(const node_id *a)                                                  \
    {                                                                                              \
        result r;                                                                                  \
        r.plain = plain_lanes_##name(RECORD_LANES(type, a)->plain);                                \
        record(operation, r.plain.v, a, 0, 0, r.node);                                             \
        return r;                                                                                  \
    }

#define RECORD_BINARY(result, name, type, operation)                                               \
    RECORD result record_##name(const node_id *a, const node_id *b)                                \
    {                                                                                              \
        result r;                                                                                  \
        r.plain = plain_lanes_##name(RECORD_LANES(type, a)->plain, RECORD_LANES(type, b)->plain);  \
        record(operation, r.plain.v, a, b, 0, r.node);                                             \
        return r;                                                                                  \
    }

#define RECORD_SELECT(type, name, operation)                                                       \
    RECORD type record_##name(const node_id *m, const node_id *a, const node_id *b)                \
    {                                                                                              \
        type r;                                                                                    \
        r.plain = plain_lanes_##name(RECORD_LANES(lanes_m, m)->plain,                              \
                                     RECORD_LANES(type, a)->plain, RECORD_LANES(type, b)->plain);  \
        record(operation, r.plain.v, m, a, b, r.node);                                             \
        return r;                                                                                  \
    }

#define RECORD_MOVE(result, name, type)                                                            \
    RECORD result record_##name(const node_id *a)                                                  \
    {                                                                                              \
        result r;                                                                                  \
        r.plain = plain_lanes_##name(RECORD_LANES(type, a)->plain);                                \
        for (int l = 0; l < GN_LANES; ++l)                                                         \
            r.node[l] = a[l];                                                                      \
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

RECORD lanes_i record_i_clamp(const node_id *a, const node_id *low, const node_id *high)
{
    lanes_i r;

    r.plain =
        plain_lanes_i_clamp(RECORD_LANES(lanes_i, a)->plain, RECORD_LANES(lanes_i, low)->plain,
                            RECORD_LANES(lanes_i, high)->plain);
    record(OP_I_CLAMP, r.plain.v, a, low, high, r.node);
    return r;
}

#define RECORD_SHIFT(name, operation)                                                              \
    RECORD lanes_i record_##name(const node_id *a, int count)                                      \
    {                                                                                              \
        lanes_i r;                                                                                 \
        r.plain = plain_lanes_##name(RECORD_LANES(lanes_i, a)->plain, count);                      \
        record_number(operation, r.plain.v, a, (uint32_t)count, r.node);                           \
        return r;                                                                                  \
    }

RECORD_SHIFT(i_shift_left, OP_I_SHIFT_LEFT)
RECORD_SHIFT(i_shift_right, OP_I_SHIFT_RIGHT)

#define lanes_sqrt(a) record_sqrt((a).node)
#define lanes_floor(a) record_floor((a).node)
#define lanes_magnitude(a) record_magnitude((a).node)
#define lanes_not(a) record_not((a).node)
#define lanes_truncate(a) record_truncate((a).node)
#define lanes_round(a) record_round((a).node)
#define lanes_floor_to_int(a) record_floor_to_int((a).node)
#define lanes_to_float(a) record_to_float((a).node)
#define lanes_i_high_bytes(a) record_i_high_bytes((a).node)
#define lanes_as_int(a) record_as_int((a).node)
#define lanes_as_float(a) record_as_float((a).node)
#define lanes_m_as_int(a) record_m_as_int((a).node)
#define lanes_add(a, b) record_add((a).node, (b).node)
#define lanes_sub(a, b) record_sub((a).node, (b).node)
#define lanes_mul(a, b) record_mul((a).node, (b).node)
#define lanes_div(a, b) record_div((a).node, (b).node)
#define lanes_min(a, b) record_min((a).node, (b).node)
#define lanes_max(a, b) record_max((a).node, (b).node)
#define lanes_greater(a, b) record_greater((a).node, (b).node)
#define lanes_less_equal(a, b) record_less_equal((a).node, (b).node)
#define lanes_and(a, b) record_and((a).node, (b).node)
#define lanes_i_add(a, b) record_i_add((a).node, (b).node)
#define lanes_i_sub(a, b) record_i_sub((a).node, (b).node)
#define lanes_i_mul(a, b) record_i_mul((a).node, (b).node)
#define lanes_i_mul_shorts(a, b) record_i_mul_shorts((a).node, (b).node)
#define lanes_i_add_bytes(a, b) record_i_add_bytes((a).node, (b).node)
#define lanes_i_sub_bytes(a, b) record_i_sub_bytes((a).node, (b).node)
#define lanes_i_add_shorts(a, b) record_i_add_shorts((a).node, (b).node)
#define lanes_i_sub_shorts(a, b) record_i_sub_shorts((a).node, (b).node)
#define lanes_i_scale_shorts(a, b) record_i_scale_shorts((a).node, (b).node)
#define lanes_i_min(a, b) record_i_min((a).node, (b).node)
#define lanes_i_max(a, b) record_i_max((a).node, (b).node)
#define lanes_i_or(a, b) record_i_or((a).node, (b).node)
#define lanes_i_and(a, b) record_i_and((a).node, (b).node)
#define lanes_i_xor(a, b) record_i_xor((a).node, (b).node)
#define lanes_i_greater(a, b) record_i_greater((a).node, (b).node)
#define lanes_i_equal(a, b) record_i_equal((a).node, (b).node)
#define lanes_select(m, a, b) record_select((m).node, (a).node, (b).node)
#define lanes_i_select(m, a, b) record_i_select((m).node, (a).node, (b).node)
#define lanes_i_clamp(a, low, high) record_i_clamp((a).node, (low).node, (high).node)
#define lanes_i_shift_left(a, count) record_i_shift_left((a).node, count)
#define lanes_i_shift_right(a, count) record_i_shift_right((a).node, count)

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

RECORD lanes_f lanes_splat(float a)
{
    lanes_f r;

    r.plain = plain_lanes_splat(a);
    record_same(trace.is_recording ? record_constant(a) : 0, r.node);
    return r;
}

RECORD lanes_i lanes_i_splat(int32_t a)
{
    lanes_i r;

    r.plain = plain_lanes_i_splat(a);
    record_same(graph_add(OP_INTEGER, (uint32_t)a, 0, 0, 0, 0), r.node);
    return r;
}

static inline lanes_i lanes_i_splat_two(int32_t lower, int32_t upper)
{
    lanes_i r;

    r.plain = plain_lanes_i_splat_two(lower, upper);
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

RECORD lanes_m lanes_from_bits(uint32_t bits)
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
