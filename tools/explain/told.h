/* What is told about a pixel, as data: fragments, in each the stages in order, in each the values
 * with their bits and the expressions that made them. The text and the JSON are written from it. */
#ifndef EXPLAIN_TOLD_H
#define EXPLAIN_TOLD_H

#include "graph.h"

/* Offsets of words in the report's strings. With `is_computed` the expression is a formula of
 * values that were told before. */
typedef struct report_value {
    uint32_t name, value, bits, expression;
    bool is_computed;
} report_value;

typedef struct report_stage {
    uint32_t title;
    uint32_t first, count; /* of the values */
} report_stage;

/* A fragment's stages are those of its primitive, and then its own. */
typedef struct report_fragment {
    uint32_t draw, primitive;
    const char *kind; /* "triangle", "line" or "point" */
    uint32_t result;
    uint32_t corner_count;
    int32_t corner[3][2]; /* snapped, in 1/256 pixel */
    uint32_t shared, shared_end, own, own_end;
} report_fragment;

typedef struct report {
    prose strings;
    report_value *values;
    report_stage *stages;
    report_fragment *fragments;
    report_fragment missing; /* a primitive without a fragment at the pixel, and why */
    bool has_missing;
    uint32_t value_count, value_room, stage_count, stage_room, fragment_count, fragment_room;
    uint32_t steps;  /* t1, t2, ... in the fragment so far */
    uint32_t nodes;  /* that were evaluated anew */
    uint32_t faults; /* checks that failed; the first one is told in `fault` */
    prose fault;
    bool failed; /* memory ran out */
} report;

extern report told;

void report_clear(void);
void report_free(void);

const char *report_words(uint32_t offset);

/* Begins a stage. A stage without values is not told. */
void report_begin(const char *title);

/* Tells a node's value, names the node, and tells the expression that made it, after steps of its
 * own where it is long. A node that is named already is told as the other name. A constant is told
 * as a number and gets no name. */
void report_node(const char *name, node_id node);

/* Tells a pixel's word as its four bytes. */
void report_word(const char *name, node_id node);

/* Tells a value that the stages did not compute, and where it comes from; names the node. */
void report_given(const char *name, node_id node, const char *where);
void report_given_word(const char *name, node_id node, const char *where);

/* Tells words; `bits` and `expression` may be "". */
void report_tell(const char *name, const char *value, const char *bits, const char *expression);

/* Tells an integer with an expression. */
void report_integer(const char *name, int64_t value, const char *expression);

/* Counts a check that failed. */
void told_fault(const char *what, const char *more);

/* Evaluates all nodes of the graph anew. */
void report_check_nodes(void);

/* Adds a fragment, whose shared stages are those from `shared` to the last one so far; report_end
 * ends it. Returns null if memory ran out. */
report_fragment *report_add_fragment(uint32_t shared, uint32_t shared_end);
void report_end(const char *result);

/* Tells why a primitive has no fragment. Its stages are those from `shared` to the last one. */
void report_missing(uint32_t draw, uint32_t primitive, const char *kind, uint32_t shared,
                    const char *reason);

/* Returns words joined, in memory that lasts for 64 calls. */
const char *joined(const char *a, const char *b, const char *c);
const char *joined_number(const char *a, int64_t n, const char *c);

#endif
