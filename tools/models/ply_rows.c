/* Elements of PLY files as rows: which property is which value, in whatever order they stand. */
#include <string.h>

#include "ply.h"

static const ply_name *find_name(const ply_name *names, const ply_property *p)
{
    for (; names->name != NULL; ++names)
        if (names->is_list == p->is_list && text_is(p->name, names->name))
            return names;
    return NULL;
}

/* Takes a target for a property. Returns false if another property has it. */
static bool take(ply_rows *rows, const ply_name *name, ply_type type)
{
    bool *const is_taken =
        name->is_list ? rows->has_list + name->target : rows->has_value + name->target;
    if (*is_taken)
        return false;
    *is_taken = true;
    if (!name->is_list)
        rows->types[name->target] = type;
    return true;
}

bool ply_rows_begin(ply_rows *rows, ply_source *s, const ply_header *h, const ply_name *names,
                    bool is_quiet)
{
    const ply_element *const e = s->element;
    memset(rows, 0, sizeof *rows);
    rows->source = s;
    rows->element = e;
    rows->properties = h->properties + e->first_property;
    rows->targets = reader_allocate(s->r, e->property_count, 1);
    if (rows->targets == NULL)
        return false;
    for (size_t i = 0; i < e->property_count; ++i) {
        const ply_property *const p = rows->properties + i;
        const ply_name *const name = find_name(names, p);
        char element[64], property[64];
        rows->targets[i] = PLY_NOWHERE;
        if (name != NULL && take(rows, name, p->type))
            rows->targets[i] = name->target;
        else if (!is_quiet)
            reader_warn(s->r, NULL, "property %s of %s is not drawn",
                        text_copy(p->name, property, sizeof property),
                        text_copy(e->name, element, sizeof element));
    }
    s->number = UINT64_MAX;
    return true;
}

static bool read_list(ply_rows *rows, const ply_property *p, uint8_t target)
{
    model_reader *const r = rows->source->r;
    size_t length;
    double ignored;
    if (!ply_read_length(rows->source, p, &length))
        return false;
    if (target == PLY_NOWHERE) {
        for (size_t i = 0; i < length; ++i)
            if (!ply_read_number(rows->source, p, p->type, &ignored))
                return false;
        return true;
    }
    if (!reader_grow(r, &rows->lists[target], &rows->list_room[target], length, sizeof(double)))
        return false;
    for (size_t i = 0; i < length; ++i)
        if (!ply_read_number(rows->source, p, p->type, rows->lists[target] + i))
            return false;
    rows->list_length[target] = length;
    return true;
}

bool ply_rows_next(ply_rows *rows)
{
    ply_source *const s = rows->source;
    ++s->number;
    if (!ply_begin_row(s))
        return false;
    for (size_t i = 0; i < rows->element->property_count; ++i) {
        const ply_property *const p = rows->properties + i;
        const uint8_t target = rows->targets[i];
        double ignored;
        if (p->is_list ? !read_list(rows, p, target)
                       : !ply_read_number(s, p, p->type,
                                          target == PLY_NOWHERE ? &ignored : rows->values + target))
            return false;
    }
    ply_end_row(s);
    return true;
}

void ply_rows_free(ply_rows *rows)
{
    model_reader *const r = rows->source->r;
    for (int i = 0; i < PLY_LISTS; ++i)
        reader_release(r, rows->lists[i], rows->list_room[i], sizeof(double));
    reader_release(r, rows->targets, rows->element->property_count, 1);
}

bool ply_rows_have(ply_rows *rows, int first, int count, const char *what)
{
    int there = 0;
    for (int i = first; i < first + count; ++i)
        there += rows->has_value[i];
    char element[64];
    if (there > 0 && there < count)
        reader_warn(rows->source->r, NULL, "%s of %s are not drawn: a property is missing", what,
                    text_copy(rows->element->name, element, sizeof element));
    return there == count;
}

static double largest_of(ply_type type)
{
    switch (type) {
    case PLY_INT16:
    case PLY_UINT16:
        return 65535.0;
    case PLY_FLOAT32:
    case PLY_FLOAT64:
        return 1.0;
    default:
        return 255.0;
    }
}

void ply_rows_color(const ply_rows *rows, float color[4])
{
    for (int i = PLY_RED; i < PLY_ALPHA; ++i)
        color[i] = PLY_GREY;
    color[PLY_ALPHA] = 1.0f;
    for (int i = PLY_RED; i < PLY_COLOR_COUNT; ++i)
        if (rows->has_value[i])
            color[i] = (float)(rows->values[i] / largest_of(rows->types[i]));
}
