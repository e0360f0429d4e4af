/* The material files of an OBJ file, and materials by name. */
#include <stdlib.h>
#include <string.h>

#include "mtl.h"

/* A file's name longer than this is taken for damage. */
#define LONGEST_NAME 1024

static mtl_library *find_library(mtl_materials *m, text_word name)
{
    for (uint32_t i = 0; i < m->library_count; ++i)
        if (text_is(name, m->libraries[i].name))
            return m->libraries + i;
    return NULL;
}

/* What became of a name. */
typedef enum outcome { IS_READ, IS_NOT_THERE, HAS_FAILED } outcome;

/* Opens and reads a file, unless this was done before. */
static outcome add_library(model_reader *r, mtl_materials *m, text_word name, const char **reason)
{
    const mtl_library *const known = find_library(m, name);
    *reason = "its name is too long";
    if (known != NULL)
        return IS_READ;
    if (name.length == 0 || name.length >= LONGEST_NAME)
        return IS_NOT_THERE;
    *reason = "there are too many material files";
    if (m->library_count == MTL_MOST_LIBRARIES)
        return IS_NOT_THERE;
    mtl_library *const library = m->libraries + m->library_count;
    library->name_size = name.length + 1;
    library->name = reader_allocate(r, library->name_size, 1);
    if (library->name == NULL)
        return HAS_FAILED;
    memcpy(library->name, name.start, name.length);
    if (!reader_open(r, library->name, &library->file, reason)) {
        reader_release(r, library->name, library->name_size, 1);
        return IS_NOT_THERE;
    }
    return mtl_read(r, m, m->library_count++) ? IS_READ : HAS_FAILED;
}

static text_word without_quotes(text_word name)
{
    if (name.length > 2 && name.start[0] == '"' && name.start[name.length - 1] == '"')
        return (text_word){name.start + 1, name.length - 2};
    return name;
}

/* Reads a file whose name may stand in quotes. */
static outcome add_perhaps_quoted(model_reader *r, mtl_materials *m, text_word name,
                                  const char **reason)
{
    const outcome first = add_library(r, m, name, reason);
    const text_word bare = without_quotes(name);
    return first == IS_NOT_THERE && bare.start != name.start ? add_library(r, m, bare, reason)
                                                             : first;
}

static void warn_of_library(model_reader *r, mtl_materials *m, text_word name, uint64_t line,
                            const char *reason)
{
    char copy[200];
    m->is_one_missing = true;
    reader_warn(r, reader_line(r, line), "the material file '%s' cannot be read: %s",
                text_copy(without_quotes(name), copy, sizeof copy), reason);
}

bool mtl_add_libraries(model_reader *r, mtl_materials *m, text_word names, uint64_t line)
{
    const char *reason;
    char text[256];
    text_cursor t = {names.start, names.start + names.length, line, '#', true, line};
    text_word word;
    bool is_any_there = false;
    if (names.length == 0) {
        reader_warn(r, reader_line(r, line), "mtllib names no file");
        return true;
    }
    const outcome whole = add_perhaps_quoted(r, m, names, &reason);
    if (whole != IS_NOT_THERE)
        return whole == IS_READ;
    /* The reason is kept for the case that no word names a file either. */
    text_copy((text_word){reason, strlen(reason)}, text, sizeof text);
    for (text_cursor words = t; !is_any_there && text_next_word(&words, &word);) {
        const outcome one = add_perhaps_quoted(r, m, word, &reason);
        if (one == HAS_FAILED)
            return false;
        is_any_there = one == IS_READ;
    }
    if (!is_any_there) {
        warn_of_library(r, m, names, line, text);
        return true;
    }
    while (text_next_word(&t, &word)) {
        const outcome one = add_perhaps_quoted(r, m, word, &reason);
        if (one == HAS_FAILED)
            return false;
        if (one == IS_NOT_THERE)
            warn_of_library(r, m, word, line, reason);
    }
    return true;
}

static int compare_words(text_word a, text_word b)
{
    const size_t shorter = a.length < b.length ? a.length : b.length;
    const int order = shorter > 0 ? memcmp(a.start, b.start, shorter) : 0;
    return order != 0 ? order : (a.length > b.length) - (a.length < b.length);
}

static int compare_names(const mtl_material *a, text_word name, text_word full_name)
{
    const int order = compare_words(a->name, name);
    return order != 0 ? order : compare_words(a->full_name, full_name);
}

static int compare_materials(const void *a, const void *b)
{
    const mtl_material *const p = a, *const q = b;
    const int order = compare_names(p, q->name, q->full_name);
    if (order != 0)
        return order;
    if (p->library != q->library)
        return p->library < q->library ? -1 : 1;
    return (p->line > q->line) - (p->line < q->line);
}

void mtl_sort(model_reader *r, mtl_materials *m)
{
    const char *const name = r->name;
    char copy[80];
    if (m->count > 0)
        qsort(m->all, m->count, sizeof *m->all, compare_materials);
    for (size_t i = 1; i < m->count; ++i) {
        const mtl_material *const again = m->all + i;
        if (compare_names(again - 1, again->name, again->full_name) != 0)
            continue;
        r->name = m->libraries[again->library].name;
        reader_warn(r, reader_line(r, again->line),
                    "the material '%s' is defined twice; the first definition is used",
                    text_copy(again->full_name, copy, sizeof copy));
    }
    r->name = name;
}

/* The first material that is not before these names. */
static size_t lower_bound(const mtl_materials *m, text_word name, text_word full_name)
{
    size_t low = 0, high = m->count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (compare_names(m->all + middle, name, full_name) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

uint32_t mtl_find(const mtl_materials *m, text_word name, text_word full_name)
{
    size_t at = lower_bound(m, name, full_name);
    if (at < m->count && compare_names(m->all + at, name, full_name) == 0)
        return (uint32_t)at;
    /* What stands behind # is a comment if it tells no materials apart. */
    at = lower_bound(m, name, (text_word){name.start, 0});
    return at < m->count && compare_words(m->all[at].name, name) == 0 ? (uint32_t)at
                                                                      : MTL_NO_MATERIAL;
}

void mtl_free(model_reader *r, mtl_materials *m)
{
    for (uint32_t i = 0; i < m->library_count; ++i) {
        reader_close(r, &m->libraries[i].file);
        reader_release(r, m->libraries[i].name, m->libraries[i].name_size, 1);
    }
    reader_release(r, m->all, m->room, sizeof *m->all);
    m->all = NULL;
    m->count = m->room = 0;
    m->library_count = 0;
}
