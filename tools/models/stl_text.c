/* STL files that are texts. */
#include <math.h>
#include <string.h>

#include "stl.h"
#include "text.h"

/* Where in a text reading is. */
typedef struct text_reader {
    model_reader *r;
    text_cursor at;
    stl_facets *facets;
    stl_facet facet;
    bool in_solid, in_facet;
    int corner_count; /* of the facet */
} text_reader;

static bool fail_here(const text_reader *t, const char *what)
{
    return reader_fail_at(t->r, reader_line(t->r, t->at.line), "%s", what);
}

/* The next word, on this line or a later one; empty at the end of the file. */
static text_word next_word(text_reader *t)
{
    text_word word = {NULL, 0};
    if (!text_next_word(&t->at, &word) && text_next_line(&t->at))
        text_next_word(&t->at, &word);
    return word;
}

static bool next_is(text_reader *t, const char *expected)
{
    text_reader behind = *t;
    if (!text_is_any_case(next_word(&behind), expected))
        return false;
    t->at = behind.at;
    return true;
}

/* Whether the line goes on. */
static bool line_goes_on(const text_reader *t)
{
    text_cursor behind = t->at;
    text_word word;
    return text_next_word(&behind, &word);
}

/* A facet may have no normal: then one is computed. So it is with one that is not a number. */
static bool begin_facet(text_reader *t)
{
    if (t->in_facet)
        return fail_here(t, "facet begins in another facet, which has no endfacet");
    memset(&t->facet, 0, sizeof t->facet);
    t->in_facet = true;
    t->corner_count = 0;
    if (!line_goes_on(t) || !next_is(t, "normal"))
        return true;
    for (int c = 0; c < 3; ++c) {
        double value;
        text_word word;
        if (!text_next_word(&t->at, &word) || !text_number(word, true, &value))
            value = NAN;
        t->facet.normal[c] = (float)value;
    }
    return true;
}

static bool read_vertex(text_reader *t)
{
    static const char names[3] = {'x', 'y', 'z'};
    if (!t->in_facet)
        return fail_here(t, "vertex stands outside a facet");
    if (t->corner_count == 3)
        return fail_here(t, "the facet has more than 3 vertices");
    for (int c = 0; c < 3; ++c) {
        char copy[64];
        const text_word word = next_word(t);
        if (word.length == 0)
            return fail_here(t, "it is cut short: it ends in a vertex");
        if (!text_number(word, false, &t->facet.corners[t->corner_count][c]))
            return reader_fail_at(t->r, reader_line(t->r, t->at.line),
                                  "%c of vertex is not a number: %s", names[c],
                                  text_copy(word, copy, sizeof copy));
    }
    ++t->corner_count;
    return true;
}

static bool end_facet(text_reader *t)
{
    stl_facets *const f = t->facets;
    if (!t->in_facet)
        return fail_here(t, "endfacet stands outside a facet");
    if (t->corner_count != 3)
        return reader_fail_at(t->r, reader_line(t->r, t->at.line),
                              "the facet has %d vertices, not 3", t->corner_count);
    if (!reader_grow(t->r, &f->array, &f->room, f->count + 1, sizeof *f->array))
        return false;
    f->array[f->count++] = t->facet;
    t->in_facet = false;
    return true;
}

static bool end_solid(text_reader *t)
{
    if (t->in_facet)
        return fail_here(t, "endsolid stands in a facet, which has no endfacet");
    t->in_solid = false;
    text_rest(&t->at);
    return true;
}

static bool read_statement(text_reader *t, text_word word)
{
    char copy[64];
    if (text_is_any_case(word, "vertex"))
        return read_vertex(t);
    if (text_is_any_case(word, "facet"))
        return begin_facet(t);
    if (text_is_any_case(word, "endfacet"))
        return end_facet(t);
    if (text_is_any_case(word, "endsolid"))
        return end_solid(t);
    if (text_is_any_case(word, "solid")) {
        /* The rest of the line is a name, which may be anything. */
        t->in_solid = true;
        text_rest(&t->at);
        return true;
    }
    if (text_is_any_case(word, "outer") || text_is_any_case(word, "loop") ||
        text_is_any_case(word, "endloop"))
        return true;
    reader_warn(t->r, reader_line(t->r, t->at.line), "%s is not known",
                text_copy(word, copy, sizeof copy));
    text_rest(&t->at);
    return true;
}

/* At the end of the file, what is open may have lost only its last lines. */
static bool end_file(text_reader *t)
{
    const bool is_open = t->in_facet || t->in_solid;
    if (t->in_facet && t->corner_count < 3)
        return reader_fail_at(t->r, reader_line(t->r, t->at.line),
                              "it is cut short: the last facet has only %d of 3 vertices",
                              t->corner_count);
    if (t->in_facet && !end_facet(t))
        return false;
    if (is_open)
        reader_warn(t->r, reader_line(t->r, t->at.line),
                    "it ends without endsolid; it may be cut short");
    return true;
}

bool stl_read_text(model_reader *r, stl_facets *facets)
{
    text_reader t;
    memset(&t, 0, sizeof t);
    t.r = r;
    t.facets = facets;
    t.at = text_begin(r->bytes, r->size);
    for (;;) {
        const text_word word = next_word(&t);
        if (word.length == 0)
            return end_file(&t);
        if (!read_statement(&t, word))
            return false;
    }
}
