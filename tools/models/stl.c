/* Reads STL files: decides whether a file is a text or binary. */
#include <string.h>

#include "stl.h"
#include "text.h"

/* Whether the size is the one that the number of triangles announces. */
static bool has_binary_size(const model_reader *r)
{
    if (r->size < STL_HEADER_SIZE)
        return false;
    const uint64_t count = reader_word(r->bytes + 80);
    return r->size == STL_HEADER_SIZE + STL_RECORD_SIZE * count;
}

static bool is_keyword(text_word word)
{
    static const char *const keywords[] = {"solid", "facet", "outer", "vertex", "endsolid"};
    for (size_t i = 0; i < sizeof keywords / sizeof keywords[0]; ++i)
        if (text_is_any_case(word, keywords[i]))
            return true;
    return false;
}

/* Texts have no zeros, and binary files have some near their beginning. */
static bool has_zeros(const model_reader *r)
{
    return memchr(r->bytes, 0, r->size < 512 ? r->size : 512) != NULL;
}

/* Whether a file whose size says nothing is a text. Headers of binary files may begin with "solid"
 * too, but a text has a keyword on its second line. */
static bool is_text(const model_reader *r)
{
    text_cursor t = text_begin(r->bytes, r->size);
    text_word word;
    if (!text_next_line(&t) || !text_next_word(&t, &word) || !is_keyword(word))
        return false;
    text_rest(&t);
    return !has_zeros(r) || (text_next_line(&t) && text_next_word(&t, &word) && is_keyword(word));
}

static bool read_facets(model_reader *r, stl_facets *facets)
{
    if (has_binary_size(r))
        return stl_read_binary(r, facets);
    if (is_text(r))
        return stl_read_text(r, facets);
    if (r->size < STL_HEADER_SIZE || !has_zeros(r))
        return reader_fail(r, "it is neither binary STL nor a text that begins with \"solid\"");
    return stl_read_binary(r, facets);
}

bool read_stl(model_reader *r)
{
    stl_facets facets;
    memset(&facets, 0, sizeof facets);
    for (int c = 0; c < 3; ++c)
        facets.color[c] = 0.8f;
    facets.color[3] = 1.0f;
    const bool good = read_facets(r, &facets) && stl_make_part(r, &facets);
    reader_release(r, facets.array, facets.room, sizeof *facets.array);
    return good;
}
