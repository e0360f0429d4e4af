/* The graph of what the traced stages compute: a node is the result of one operation in one lane,
 * with its bits and the nodes it was computed from. Operands have lower numbers than results. A map
 * of memory follows values through arrays: it says which node was stored where. */
#ifndef EXPLAIN_GRAPH_H
#define EXPLAIN_GRAPH_H

#include "prose.h"

/* X(NAME, symbol, operands, how it is written, type of the result). Operations are those of
 * src/lanes/lanes.h for one lane; `binary` ones are written between their operands. Types: f is a
 * float, i a 32-bit integer, m a mask of all ones or all zeros. */
#define GRAPH_OPERATIONS(X)                                                                        \
    X(NONE, "", 0, LEAF, 'i')                                                                      \
    X(FLOAT, "", 0, LEAF, 'f')   /* a constant, or what memory held before */                      \
    X(INTEGER, "", 0, LEAF, 'i') /* likewise */                                                    \
    X(MASK, "", 0, LEAF, 'm')                                                                      \
    X(ADD, "+", 2, SUM, 'f')                                                                       \
    X(SUB, "-", 2, SUM, 'f')                                                                       \
    X(MUL, "*", 2, PRODUCT, 'f')                                                                   \
    X(DIV, "/", 2, PRODUCT, 'f')                                                                   \
    X(SQRT, "sqrt", 1, CALL, 'f')                                                                  \
    X(MIN, "min", 2, CALL, 'f')                                                                    \
    X(MAX, "max", 2, CALL, 'f')                                                                    \
    X(FLOOR, "floor", 1, CALL, 'f')                                                                \
    X(MAGNITUDE, "abs", 1, CALL, 'f')                                                              \
    X(GREATER, ">", 2, COMPARISON, 'm')                                                            \
    X(LESS_EQUAL, "<=", 2, COMPARISON, 'm')                                                        \
    X(AND, "&&", 2, LOGIC, 'm')                                                                    \
    X(NOT, "!", 1, PREFIX, 'm')                                                                    \
    X(SELECT, "?", 3, CHOICE, 'f')                                                                 \
    X(TRUNCATE, "int", 1, CALL, 'i')                                                               \
    X(ROUND, "round", 1, CALL, 'i')                                                                \
    X(FLOOR_TO_INT, "int_floor", 1, CALL, 'i')                                                     \
    X(TO_FLOAT, "float", 1, CALL, 'f')                                                             \
    X(I_ADD, "+", 2, SUM, 'i')                                                                     \
    X(I_SUB, "-", 2, SUM, 'i')                                                                     \
    X(I_MUL, "*", 2, PRODUCT, 'i')                                                                 \
    X(I_SHIFT_LEFT, "<<", 2, SHIFT, 'i')                                                           \
    X(I_SHIFT_RIGHT, ">>", 2, SHIFT, 'i')                                                          \
    X(I_MIN, "min", 2, CALL, 'i')                                                                  \
    X(I_MAX, "max", 2, CALL, 'i')                                                                  \
    X(I_OR, "|", 2, BITS, 'i')                                                                     \
    X(I_AND, "&", 2, BITS, 'i')                                                                    \
    X(I_XOR, "^", 2, BITS, 'i')                                                                    \
    X(I_GREATER, ">", 2, COMPARISON, 'm')                                                          \
    X(I_EQUAL, "==", 2, COMPARISON, 'm')                                                           \
    X(I_SELECT, "?", 3, CHOICE, 'i')                                                               \
    X(I_CLAMP, "clamp", 3, CALL, 'i')                                                              \
    X(UNPACK_BYTE, "byte", 2, CALL, 'f')  /* byte n of a word, times 1/255 */                      \
    X(PACK_BYTE, "to_byte", 1, CALL, 'i') /* round(255 * a), within 0 to 255 */                    \
    X(PACK_WORD, "bytes", 4, CALL, 'i')   /* four bytes, the first lowest */                       \
    X(MUL_SHORTS, "mul_shorts", 2, CALL, 'i')                                                      \
    X(HIGH_BYTES, "high_bytes", 1, CALL, 'i')                                                      \
    X(ADD_BYTES, "add_bytes", 2, CALL, 'i')                                                        \
    X(SUB_BYTES, "sub_bytes", 2, CALL, 'i')                                                        \
    X(ADD_SHORTS, "add_shorts", 2, CALL, 'i')                                                      \
    X(SUB_SHORTS, "sub_shorts", 2, CALL, 'i')                                                      \
    X(SCALE_SHORTS, "scale_shorts", 2, CALL, 'i')

typedef enum graph_operation {
#define GRAPH_ENUMERATE(name, symbol, operands, notation, type) OP_##name,
    GRAPH_OPERATIONS(GRAPH_ENUMERATE)
#undef GRAPH_ENUMERATE
        OP_COUNT
} graph_operation;

/* How operations are written, those that bind least first. */
typedef enum graph_notation {
    NOTATION_CHOICE,
    NOTATION_LOGIC,
    NOTATION_BITS,
    NOTATION_COMPARISON,
    NOTATION_SHIFT,
    NOTATION_SUM,
    NOTATION_PRODUCT,
    NOTATION_PREFIX,
    NOTATION_CALL,
    NOTATION_LEAF
} graph_notation;

typedef struct graph_traits {
    char symbol[13];
    uint8_t operands, notation;
    char type;
} graph_traits;

extern const graph_traits graph_traits_of[OP_COUNT];

/* A node's number; 0 is no node. */
typedef uint32_t node_id;

typedef struct graph_node {
    uint32_t bits;
    node_id operand[4];
    uint32_t name; /* offset in the names; 0: none */
    uint8_t operation;
    bool is_told; /* a texel that the report has */
} graph_node;

typedef struct graph {
    graph_node *nodes; /* nodes[0] is not used */
    uint32_t count, room;
    prose names;
    struct stored_node *stored; /* a hash table by address */
    uint32_t stored_count, stored_room;
    bool is_recording;
    bool failed; /* memory ran out: nodes are missing */
} graph;

/* The graph of the draw that is being traced. */
extern graph trace;

/* Whether operand b of an operation is a number and no node. */
static inline bool graph_has_count(graph_operation operation)
{
    return operation == OP_I_SHIFT_LEFT || operation == OP_I_SHIFT_RIGHT ||
           operation == OP_UNPACK_BYTE;
}

/* Forgets all nodes. */
void graph_clear(void);
void graph_free(void);

/* Adds a node. Returns 0 if memory runs out or nothing is recorded. */
node_id graph_add(graph_operation operation, uint32_t bits, node_id a, node_id b, node_id c,
                  node_id d);

/* Adds the result of a float operation, computed here, for steps of the library that are scalar C.
 * Returns 0 if an operand is no node. */
node_id graph_compute(graph_operation operation, node_id a, node_id b);
node_id graph_number(float f);

/* Node `n` of the operands, 0 if there is none. */
node_id graph_operand(node_id node, int n);

/* Replaces operand n of a node by another node with the same bits; does nothing if they differ. */
void graph_relink(node_id node, int n, node_id to);

bool graph_is(node_id node, graph_operation operation);
uint32_t graph_bits(node_id node);

/* Whether a node's value depends on another one. */
bool graph_reaches(node_id from, node_id to);

/* Names a node; a later name replaces an earlier one. */
void graph_name(node_id node, const char *name);
const char *graph_name_of(node_id node);

/* Memory: graph_store says that the word at an address is a node's; graph_load returns the node of
 * the word that is there now, 0 if nobody stored it or it has changed since. */
void graph_store(const void *address, node_id node);
node_id graph_load(const void *address, uint32_t bits);

/* Evaluates a node's operation anew from its operands' bits, in a few lines of plain C that share
 * nothing with the library. Returns false, and what it finds, if the bits differ from the node's
 * (two NaN are equal). */
bool graph_check(node_id node, uint32_t *found);

/* Checks all nodes; returns how many are wrong, and the first of them. */
uint32_t graph_check_all(node_id *first);

/* Writes a node's expression down to named nodes and leaves, for a reader of C. */
void graph_print(prose *t, node_id node);

/* Returns the node whose expression is to be printed in a step of its own before that of `root`: it
 * has no name, and is used twice in the expression, or the expression is too long without. Returns
 * 0 if there is none. */
node_id graph_next_step(node_id root);

/* Writes a node's value: a float, an integer, or true or false. */
void graph_print_value(prose *t, node_id node);

#endif
