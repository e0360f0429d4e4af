/* The graph's memory: nodes, names, and what was stored where. */
#include "graph.h"

#include <stdlib.h>
#include <string.h>

const graph_traits graph_traits_of[OP_COUNT] = {
#define GRAPH_TRAITS(name, symbol, operands, notation, type)                                       \
    {symbol, operands, NOTATION_##notation, type},
    GRAPH_OPERATIONS(GRAPH_TRAITS)
#undef GRAPH_TRAITS
};

graph trace;

typedef struct stored_node {
    uintptr_t address;
    node_id node; /* 0: an empty place */
} stored_node;

void graph_clear(void)
{
    trace.count = 1;
    prose_clear(&trace.names);
    prose_character(&trace.names, ' '); /* so that no name has offset 0 */
    trace.stored_count = 0;
    if (trace.stored)
        memset(trace.stored, 0, trace.stored_room * sizeof *trace.stored);
}

void graph_free(void)
{
    free(trace.nodes);
    free(trace.stored);
    prose_free(&trace.names);
    memset(&trace, 0, sizeof trace);
}

/* Returns a node, 0 for a number that is none: a stage may pass lanes on that it has not set, if
 * they are not chosen. */
static node_id known(node_id node)
{
    return node < trace.count ? node : 0;
}

node_id graph_add(graph_operation operation, uint32_t bits, node_id a, node_id b, node_id c,
                  node_id d)
{
    if (!trace.is_recording || trace.failed)
        return 0;
    if (trace.count >= trace.room) {
        const uint32_t room = trace.room ? 2 * trace.room : 1 << 14;
        graph_node *const nodes = realloc(trace.nodes, room * sizeof *nodes);

        if (!nodes) {
            trace.failed = true;
            return 0;
        }
        trace.nodes = nodes;
        trace.room = room;
        trace.count += trace.count == 0;
    }
    graph_node *const n = &trace.nodes[trace.count];

    n->bits = bits;
    n->operand[0] = known(a);
    n->operand[1] = graph_has_count(operation) ? b : known(b);
    n->operand[2] = known(c);
    n->operand[3] = known(d);
    n->name = 0;
    n->operation = (uint8_t)operation;
    n->is_told = false;
    return trace.count++;
}

node_id graph_number(float f)
{
    return graph_add(OP_FLOAT, bits_of_float(f), 0, 0, 0, 0);
}

node_id graph_compute(graph_operation operation, node_id a, node_id b)
{
    const float x = float_of_bits(graph_bits(a)), y = float_of_bits(graph_bits(b));
    const float result = operation == OP_ADD   ? x + y
                         : operation == OP_SUB ? x - y
                         : operation == OP_MUL ? x * y
                                               : x / y;

    return a && b ? graph_add(operation, bits_of_float(result), a, b, 0, 0) : 0;
}

node_id graph_operand(node_id node, int n)
{
    return known(node) && n < graph_traits_of[trace.nodes[node].operation].operands
               ? trace.nodes[node].operand[n]
               : 0;
}

uint32_t graph_bits(node_id node)
{
    return node ? trace.nodes[node].bits : 0;
}

void graph_relink(node_id node, int n, node_id to)
{
    const node_id from = graph_operand(node, n);

    if (from && to && graph_bits(from) == graph_bits(to))
        trace.nodes[node].operand[n] = to;
}

bool graph_is(node_id node, graph_operation operation)
{
    return node && trace.nodes[node].operation == operation;
}

void graph_name(node_id node, const char *name)
{
    if (!node || name == graph_name_of(node)) /* growing would move the name */
        return;
    trace.nodes[node].name = (uint32_t)trace.names.length;
    prose_put(&trace.names, name);
    prose_character(&trace.names, 0);
    trace.failed |= trace.names.failed;
}

const char *graph_name_of(node_id node)
{
    return node && trace.nodes[node].name ? trace.names.at + trace.nodes[node].name : "";
}

/* Returns the place of an address, or the empty one where it belongs. */
static stored_node *place_of(stored_node *table, uint32_t room, uintptr_t address)
{
    uint32_t at = (uint32_t)(address >> 2) * 2654435761u;

    for (at &= room - 1; table[at].node && table[at].address != address;)
        at = (at + 1) & (room - 1);
    return &table[at];
}

static bool grow_stored(void)
{
    const uint32_t room = trace.stored_room ? 2 * trace.stored_room : 1 << 14;
    stored_node *const table = calloc(room, sizeof *table);

    if (!table)
        return false;
    for (uint32_t i = 0; i < trace.stored_room; ++i)
        if (trace.stored[i].node)
            *place_of(table, room, trace.stored[i].address) = trace.stored[i];
    free(trace.stored);
    trace.stored = table;
    trace.stored_room = room;
    return true;
}

void graph_store(const void *address, node_id node)
{
    if (!trace.is_recording || !node)
        return;
    if (2 * trace.stored_count >= trace.stored_room && !grow_stored()) {
        trace.failed = true;
        return;
    }
    stored_node *const place = place_of(trace.stored, trace.stored_room, (uintptr_t)address);

    trace.stored_count += !place->node;
    place->address = (uintptr_t)address;
    place->node = node;
}

node_id graph_load(const void *address, uint32_t bits)
{
    if (!trace.is_recording || !trace.stored)
        return 0;
    const node_id node = place_of(trace.stored, trace.stored_room, (uintptr_t)address)->node;

    return node && graph_bits(node) == bits ? node : 0;
}

bool graph_reaches(node_id from, node_id to)
{
    /* Operands have lower numbers: one pass downwards marks all that the node depends on. */
    uint8_t *const marks = from >= to && to ? calloc(from - to + 1, 1) : 0;

    if (!marks)
        return false;
    marks[from - to] = 1;
    for (node_id node = from; node > to; --node) {
        const int operands = graph_traits_of[trace.nodes[node].operation].operands;

        for (int n = 0; n < operands && marks[node - to]; ++n) {
            const bool is_count =
                n == 1 && graph_has_count((graph_operation)trace.nodes[node].operation);

            if (!is_count && trace.nodes[node].operand[n] >= to)
                marks[trace.nodes[node].operand[n] - to] = 1;
        }
    }
    const bool reached = marks[0] != 0;

    free(marks);
    return reached;
}
