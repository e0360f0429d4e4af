/* Headers of PLY files. */
#include "ply.h"

#include <string.h>

/* More textures than any writer names; every one costs a pass over the faces. */
#define MOST_TEXTURES 256

static const struct {
    char name[8], sized_name[8];
    size_t size;
} types[PLY_TYPE_COUNT] = {
    {"char", "int8", 1}, {"uchar", "uint8", 1}, {"short", "int16", 2},   {"ushort", "uint16", 2},
    {"int", "int32", 4}, {"uint", "uint32", 4}, {"float", "float32", 4}, {"double", "float64", 8},
};

size_t ply_type_size(ply_type type)
{
    return types[type].size;
}

bool ply_type_is_float(ply_type type)
{
    return type == PLY_FLOAT32 || type == PLY_FLOAT64;
}

/* Records a fault on the line that is read, with the word's text in place of %s. */
static bool fail_word(model_reader *r, const text_cursor *t, const char *format, text_word word)
{
    char copy[64];
    return reader_fail_at(r, reader_line(r, t->statement), format,
                          text_copy(word, copy, sizeof copy));
}

static bool read_type(model_reader *r, text_cursor *t, ply_type *type)
{
    text_word word;
    if (!text_next_word(t, &word))
        return reader_fail_at(r, reader_line(r, t->statement), "property has no type");
    for (int i = 0; i < PLY_TYPE_COUNT; ++i)
        if (text_is(word, types[i].name) || text_is(word, types[i].sized_name)) {
            *type = (ply_type)i;
            return true;
        }
    return fail_word(r, t, "%s is not a type of PLY's properties", word);
}

static bool read_format(model_reader *r, text_cursor *t, ply_header *h)
{
    static const char *const names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    text_word name, version;
    int i = 0;
    text_next_word(t, &name);
    text_next_word(t, &version);
    while (i < 3 && !text_is(name, names[i]))
        ++i;
    if (i == 3)
        return fail_word(r, t, "format %s is not read", name);
    if (!text_is(version, "1.0"))
        return fail_word(r, t, "version %s of PLY is not read, only 1.0", version);
    h->encoding = (ply_encoding)i;
    return true;
}

static bool read_element(model_reader *r, text_cursor *t, ply_header *h)
{
    ply_element e;
    text_word number;
    int64_t count;
    memset(&e, 0, sizeof e);
    if (!text_next_word(t, &e.name))
        return reader_fail_at(r, reader_line(r, t->statement), "element has no name");
    text_next_word(t, &number);
    if (!text_integer(number, &count) || count < 0)
        return fail_word(r, t, "the number of elements is wrong: %s", number);
    e.count = (uint64_t)count;
    e.first_property = h->property_count;
    if (!reader_grow(r, &h->elements, &h->element_room, h->element_count + 1, sizeof e))
        return false;
    h->elements[h->element_count++] = e;
    return true;
}

static bool read_property(model_reader *r, text_cursor *t, ply_header *h)
{
    ply_property p;
    memset(&p, 0, sizeof p);
    if (h->element_count == 0)
        return reader_fail_at(r, reader_line(r, t->statement),
                              "property stands before any element");
    text_cursor behind = *t;
    text_word word;
    p.is_list = text_next_word(&behind, &word) && text_is(word, "list");
    if (p.is_list) {
        *t = behind;
        if (!read_type(r, t, &p.count_type))
            return false;
        if (ply_type_is_float(p.count_type))
            return reader_fail_at(r, reader_line(r, t->statement),
                                  "the length of a list cannot be a float");
    }
    if (!read_type(r, t, &p.type))
        return false;
    if (!text_next_word(t, &p.name))
        return reader_fail_at(r, reader_line(r, t->statement), "property has no name");
    if (!reader_grow(r, &h->properties, &h->property_room, h->property_count + 1, sizeof p))
        return false;
    h->properties[h->property_count++] = p;
    ++h->elements[h->element_count - 1].property_count;
    return true;
}

/* Finds MeshLab's name of a texture in a comment; a name may hold blanks. */
static bool read_comment(model_reader *r, text_cursor *t, ply_header *h)
{
    text_word word;
    if (!text_next_word(t, &word) || !text_is_any_case(word, "TextureFile"))
        return true;
    word = text_rest(t);
    if (word.length == 0)
        return true;
    if (h->texture_count == MOST_TEXTURES) {
        reader_warn(r, reader_line(r, t->statement), "more than %d texture files are not drawn",
                    MOST_TEXTURES);
        return true;
    }
    if (!reader_grow(r, &h->textures, &h->texture_room, h->texture_count + 1, sizeof word))
        return false;
    h->textures[h->texture_count++] = word;
    return true;
}

/* Reads one line. */
static bool read_statement(model_reader *r, text_cursor *t, ply_header *h, bool *has_format)
{
    text_word keyword;
    char copy[64];
    text_next_word(t, &keyword);
    if (text_is(keyword, "comment"))
        return read_comment(r, t, h);
    if (text_is(keyword, "obj_info"))
        return true;
    if (text_is(keyword, "element"))
        return read_element(r, t, h);
    if (text_is(keyword, "property"))
        return read_property(r, t, h);
    if (text_is(keyword, "format")) {
        *has_format = true;
        return read_format(r, t, h);
    }
    reader_warn(r, reader_line(r, t->statement), "%s is not known in a header",
                text_copy(keyword, copy, sizeof copy));
    return true;
}

/* Steps behind the line of end_header. Bytes of a binary file may look like the end of a line: a
 * line feed behind a carriage return belongs to the end only if the first line does not end in a
 * carriage return alone. */
static void pass_end_of_header(text_cursor *t, bool only_returns)
{
    while (t->at < t->end && *t->at != '\n' && *t->at != '\r')
        ++t->at;
    if (t->at == t->end)
        return;
    if (*t->at == '\r' && !only_returns && t->end - t->at > 1 && t->at[1] == '\n')
        ++t->at;
    ++t->at;
    ++t->line;
}

static void pass_line(text_cursor *t)
{
    while (t->at < t->end && *t->at != '\n' && *t->at != '\r')
        ++t->at;
}

bool ply_header_read(model_reader *r, ply_header *h)
{
    text_cursor t = text_begin(r->bytes, r->size);
    text_word word;
    bool has_format = false;
    memset(h, 0, sizeof *h);
    /* The array is there, so that elements without properties point into it. */
    if (!reader_grow(r, &h->properties, &h->property_room, 1, sizeof *h->properties))
        return false;
    if (!text_next_line(&t) || !text_next_word(&t, &word) || !text_is(word, "ply"))
        return reader_fail(r, "it does not begin with the line \"ply\", so it is no PLY file");
    pass_line(&t);
    const bool only_returns = t.end - t.at > 1 && t.at[0] == '\r' && t.at[1] != '\n';
    for (;;) {
        if (!text_next_line(&t))
            return reader_fail(r, "it is cut short: its header has no end_header");
        text_cursor line = t;
        if (text_next_word(&line, &word) && text_is(word, "end_header"))
            break;
        if (!read_statement(r, &t, h, &has_format))
            return false;
        pass_line(&t);
    }
    if (!has_format)
        return reader_fail(r, "its header has no format");
    pass_end_of_header(&t, only_returns);
    h->body = t;
    return true;
}

void ply_header_free(model_reader *r, ply_header *h)
{
    reader_release(r, h->elements, h->element_room, sizeof *h->elements);
    reader_release(r, h->properties, h->property_room, sizeof *h->properties);
    reader_release(r, h->textures, h->texture_room, sizeof *h->textures);
}
