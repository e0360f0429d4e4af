/* Writes nodes for readers of C: values, and expressions down to named nodes and leaves. */
#include <stdlib.h>

#include "graph.h"

/* Operations that an expression shows at most before a part of it becomes a step of its own. */
#define MOST_OPERATIONS 6

/* Choices that the coverage of a pixel decides are not shown: what they chose takes their place. */
static node_id chosen(node_id node)
{
    while ((graph_is(node, OP_SELECT) || graph_is(node, OP_I_SELECT)) && !*graph_name_of(node) &&
           graph_is(graph_operand(node, 0), OP_MASK))
        node = graph_operand(node, graph_bits(graph_operand(node, 0)) ? 1 : 2);
    return node;
}

static const graph_traits *traits(node_id node)
{
    return &graph_traits_of[trace.nodes[node].operation];
}

/* Whether an operand is a number and no node. */
static bool is_number(node_id node, int operand)
{
    return operand == 1 && graph_has_count((graph_operation)trace.nodes[node].operation);
}

static node_id operand_of(node_id node, int n)
{
    return is_number(node, n) ? 0 : chosen(graph_operand(node, n));
}

static bool is_inner(node_id node)
{
    return node && !*graph_name_of(node) && traits(node)->notation != NOTATION_LEAF;
}

void graph_print_value(prose *t, node_id node)
{
    const char type = node ? traits(node)->type : 'i';

    if (type == 'f')
        prose_float(t, float_of_bits(graph_bits(node)));
    else if (type == 'm')
        prose_put(t, graph_bits(node) ? "true" : "false");
    else
        prose_integer(t, (int32_t)graph_bits(node));
}

static void print_operand(prose *t, node_id node, int n, int least);

static void print_node(prose *t, node_id node)
{
    const graph_traits *const how = traits(node);
    const int binds = how->notation;

    switch (how->notation) {
    case NOTATION_LEAF:
        if (how->type == 'i' && graph_bits(node) + 0x10000u > 0x20000u) { /* a mask of bits */
            prose_put(t, "0x");
            prose_hexadecimal(t, graph_bits(node), 8);
        } else {
            graph_print_value(t, node);
        }
        break;
    case NOTATION_CHOICE:
        print_operand(t, node, 0, binds + 1);
        prose_put(t, " ? ");
        print_operand(t, node, 1, binds + 1);
        prose_put(t, " : ");
        print_operand(t, node, 2, binds);
        break;
    case NOTATION_PREFIX:
        prose_put(t, how->symbol);
        print_operand(t, node, 0, binds);
        break;
    case NOTATION_CALL:
        prose_put(t, how->symbol);
        prose_character(t, '(');
        for (int n = 0; n < how->operands; ++n) {
            prose_put(t, n ? ", " : "");
            print_operand(t, node, n, 0);
        }
        prose_character(t, ')');
        break;
    case NOTATION_BITS:
    case NOTATION_SHIFT:
        /* Few know how these bind among each other, so everything in them is in parentheses. */
        print_operand(t, node, 0, NOTATION_PREFIX);
        prose_character(t, ' ');
        prose_put(t, how->symbol);
        prose_character(t, ' ');
        print_operand(t, node, 1, NOTATION_PREFIX);
        break;
    default:
        print_operand(t, node, 0, binds);
        prose_character(t, ' ');
        prose_put(t, how->symbol);
        prose_character(t, ' ');
        print_operand(t, node, 1, binds + 1);
        break;
    }
}

/* Prints an operand, in parentheses if it binds less than `least`. */
static void print_operand(prose *t, node_id node, int n, int least)
{
    const node_id operand = operand_of(node, n);

    if (is_number(node, n)) {
        prose_integer(t, trace.nodes[node].operand[n]);
    } else if (!operand) {
        prose_character(t, '?');
    } else if (*graph_name_of(operand)) {
        prose_put(t, graph_name_of(operand));
    } else {
        const bool encloses = traits(operand)->notation < least;

        prose_put(t, encloses ? "(" : "");
        print_node(t, operand);
        prose_put(t, encloses ? ")" : "");
    }
}

void graph_print(prose *t, node_id node)
{
    const node_id shown = chosen(node);

    if (!node)
        return;
    if (shown != node && *graph_name_of(shown))
        prose_put(t, graph_name_of(shown));
    else
        print_node(t, shown);
}

/* What graph_next_step knows of a node of the expression. */
typedef struct use {
    uint16_t uses, operations;
} use;

node_id graph_next_step(node_id root)
{
    root = chosen(root);
    use *const all = root ? calloc((size_t)root + 1, sizeof *all) : 0;
    node_id lowest = root, step = 0;

    if (!all)
        return 0;
    all[root].uses = 1;
    for (node_id node = root; node >= lowest && node; --node) {
        if (!all[node].uses || (node != root && !is_inner(node)))
            continue;
        for (int n = 0; n < traits(node)->operands; ++n) {
            const node_id operand = operand_of(node, n);

            if (is_inner(operand)) {
                all[operand].uses += all[operand].uses < 9;
                lowest = operand < lowest ? operand : lowest;
            }
        }
    }
    for (node_id node = lowest; node < root && !step; ++node) {
        if (!all[node].uses)
            continue;
        all[node].operations = 1;
        for (int n = 0; n < traits(node)->operands; ++n)
            all[node].operations += all[operand_of(node, n)].operations;
        if (all[node].uses > 1 || all[node].operations >= MOST_OPERATIONS)
            step = node;
    }
    free(all);
    return step;
}
