/* The report's memory. */
#include "told.h"

#include <stdlib.h>
#include <string.h>

report told;

void report_clear(void)
{
    report_free();
    prose_character(&told.strings, 0); /* offset 0 is "" */
}

void report_free(void)
{
    free(told.values);
    free(told.stages);
    free(told.fragments);
    prose_free(&told.strings);
    prose_free(&told.fault);
    memset(&told, 0, sizeof told);
}

const char *report_words(uint32_t offset)
{
    return told.strings.at ? told.strings.at + offset : "";
}

/* Makes room for one more element. */
static bool grow(void *memory, uint32_t count, uint32_t *room, size_t size)
{
    void **const at = memory;

    if (count < *room)
        return true;
    const uint32_t more = *room ? 2 * *room : 64;
    void *const grown = realloc(*at, more * size);

    if (!grown) {
        told.failed = true;
        return false;
    }
    *at = grown;
    *room = more;
    return true;
}

static uint32_t keep(const char *words)
{
    const uint32_t offset = (uint32_t)told.strings.length;

    if (!*words)
        return 0;
    prose_put(&told.strings, words);
    prose_character(&told.strings, 0);
    told.failed |= told.strings.failed;
    return told.strings.failed ? 0 : offset;
}

static void drop_empty_stage(void)
{
    if (told.stage_count && told.stages[told.stage_count - 1].count == 0)
        --told.stage_count;
}

void report_begin(const char *title)
{
    drop_empty_stage();
    if (!grow(&told.stages, told.stage_count, &told.stage_room, sizeof *told.stages))
        return;
    told.stages[told.stage_count++] = (report_stage){keep(title), told.value_count, 0};
}

/* Whether the next values are told with formulas. */
static bool is_computed;

void report_tell(const char *name, const char *value, const char *bits, const char *expression)
{
    if (!told.stage_count ||
        !grow(&told.values, told.value_count, &told.value_room, sizeof *told.values))
        return;
    const report_value v = {keep(name), keep(value), keep(bits), keep(expression), is_computed};

    told.values[told.value_count++] = v;
    ++told.stages[told.stage_count - 1].count;
}

void report_integer(const char *name, int64_t value, const char *expression)
{
    prose number = {0};

    prose_integer(&number, value);
    report_tell(name, prose_of(&number), "", expression);
    prose_free(&number);
}

/* Whether the next value is told as four bytes. */
static bool as_bytes;

static void tell_node(const char *name, node_id node, const char *expression)
{
    prose value = {0}, bits = {0};

    for (int n = 0; as_bytes && n < 4; ++n) {
        prose_put(&value, n ? " " : "");
        prose_integer(&value, graph_bits(node) >> 8 * n & 255);
    }
    if (!as_bytes)
        graph_print_value(&value, node);
    if (graph_traits_of[trace.nodes[node].operation].type != 'm')
        prose_hexadecimal(&bits, graph_bits(node), 8);
    report_tell(name, prose_of(&value), prose_of(&bits), expression);
    prose_free(&value);
    prose_free(&bits);
}

static void tell_named(const char *given_name, node_id node, bool is_word)
{
    prose expression = {0};
    char name[96] = ""; /* the given one may be joined, and steps join words too */

    strncat(name, given_name, sizeof name - 1);

    if (!node) {
        told_fault("a value that was not recorded: ", name);
        return;
    }
    if (*graph_name_of(node)) {
        as_bytes = is_word;
        tell_node(name, node, graph_name_of(node));
        as_bytes = false;
        return;
    }
    if (graph_traits_of[trace.nodes[node].operation].notation == NOTATION_LEAF) {
        /* A constant, which other values may share, so it gets no name. */
        graph_print(&expression, node);
        tell_node(name, node, prose_of(&expression));
        prose_free(&expression);
        return;
    }
    for (node_id step; (step = graph_next_step(node)) != 0;) {
        const char *const label = joined_number("t", ++told.steps, "");

        prose_clear(&expression);
        graph_print(&expression, step);
        tell_node(label, step, prose_of(&expression));
        graph_name(step, label);
    }
    prose_clear(&expression);
    graph_print(&expression, node);
    as_bytes = is_word;
    tell_node(name, node, prose_of(&expression));
    as_bytes = false;
    graph_name(node, name);
    prose_free(&expression);
}

void report_node(const char *name, node_id node)
{
    is_computed = true;
    tell_named(name, node, false);
    is_computed = false;
}

void report_word(const char *name, node_id node)
{
    is_computed = true;
    tell_named(name, node, true);
    is_computed = false;
}

static void tell_given(const char *name, node_id node, const char *where, bool is_word)
{
    if (!node) {
        told_fault("a value that was not recorded: ", name);
        return;
    }
    as_bytes = is_word;
    tell_node(name, node, where);
    as_bytes = false;
    graph_name(node, name);
}

void report_given(const char *name, node_id node, const char *where)
{
    tell_given(name, node, where, false);
}

void report_given_word(const char *name, node_id node, const char *where)
{
    tell_given(name, node, where, true);
}

void told_fault(const char *what, const char *more)
{
    if (told.faults++ == 0) {
        prose_put(&told.fault, what);
        prose_put(&told.fault, more);
    }
}

void report_check_nodes(void)
{
    node_id first;
    uint32_t found;
    const uint32_t wrong = graph_check_all(&first);

    told.nodes += trace.count ? trace.count - 1 : 0;
    if (!wrong)
        return;
    prose words = {0};

    graph_check(first, &found);
    prose_put(&words, graph_traits_of[trace.nodes[first].operation].symbol);
    prose_character(&words, ' ');
    prose_hexadecimal(&words, graph_bits(first), 8);
    prose_put(&words, " is ");
    prose_hexadecimal(&words, found, 8);
    prose_put(&words, " here");
    told_fault("a step that was evaluated anew has another result: ", prose_of(&words));
    told.faults += wrong - 1;
    prose_free(&words);
}

report_fragment *report_add_fragment(uint32_t shared, uint32_t shared_end)
{
    if (!grow(&told.fragments, told.fragment_count, &told.fragment_room, sizeof *told.fragments))
        return 0;
    report_fragment *const f = &told.fragments[told.fragment_count++];

    memset(f, 0, sizeof *f);
    f->kind = "triangle";
    f->shared = shared;
    f->shared_end = shared_end;
    f->own = f->own_end = told.stage_count;
    return f;
}

void report_end(const char *result)
{
    if (!told.fragment_count)
        return;
    drop_empty_stage();
    told.fragments[told.fragment_count - 1].result = keep(result);
    told.fragments[told.fragment_count - 1].own_end = told.stage_count;
}

void report_missing(uint32_t draw, uint32_t primitive, const char *kind, uint32_t shared,
                    const char *reason)
{
    report_fragment *const f = &told.missing;

    drop_empty_stage();
    memset(f, 0, sizeof *f);
    f->draw = draw;
    f->primitive = primitive;
    f->kind = kind;
    f->result = keep(reason);
    f->shared = shared;
    f->shared_end = f->own = f->own_end = told.stage_count;
    told.has_missing = true;
}

static char *next_buffer(void)
{
    static char buffer[64][96];
    static unsigned at;

    return buffer[at++ % 64];
}

static char *append(char *to, const char *end, const char *words)
{
    while (*words && to < end)
        *to++ = *words++;
    *to = 0;
    return to;
}

const char *joined(const char *a, const char *b, const char *c)
{
    char *const buffer = next_buffer();
    const char *const end = buffer + 95;

    append(append(append(buffer, end, a), end, b), end, c);
    return buffer;
}

const char *joined_number(const char *a, int64_t n, const char *c)
{
    prose number = {0};

    prose_integer(&number, n);
    const char *const result = joined(a, prose_of(&number), c);
    prose_free(&number);
    return result;
}
