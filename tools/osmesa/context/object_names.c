/* The table of names: a hash table with open addressing. */
#include "object_names.h"

#include <stdlib.h>

/* Open addressing with linear probing; a key of 0 is an empty place. The number of places is a
 * power of two, and at most half of them are used. */
typedef struct place {
    GLuint name;
    void *object;
} place;

struct object_table {
    place *places;
    size_t size, used;
    GLuint greatest;
};

enum { FIRST_SIZE = 64 };

object_table *create_table(void)
{
    object_table *const table = calloc(1, sizeof *table);

    if (!table)
        return NULL;
    table->places = calloc(FIRST_SIZE, sizeof *table->places);
    table->size = FIRST_SIZE;
    if (!table->places) {
        free(table);
        return NULL;
    }
    return table;
}

void destroy_table(object_table *table, void (*release)(void *))
{
    if (!table)
        return;
    for (size_t i = 0; i < table->size; ++i)
        if (table->places[i].object)
            release(table->places[i].object);
    free(table->places);
    free(table);
}

/* Returns the place of a name, or the empty place where it belongs. */
static place *place_of(place *places, size_t size, GLuint name)
{
    size_t i = name * 2654435761u & (size - 1);

    while (places[i].name && places[i].name != name)
        i = (i + 1) & (size - 1);
    return &places[i];
}

static bool grow(object_table *table)
{
    const size_t size = 2 * table->size;
    place *const places = calloc(size, sizeof *places);

    if (!places)
        return false;
    for (size_t i = 0; i < table->size; ++i)
        if (table->places[i].name)
            *place_of(places, size, table->places[i].name) = table->places[i];
    free(table->places);
    table->places = places;
    table->size = size;
    return true;
}

bool set_object(object_table *table, GLuint name, void *object)
{
    place *p;

    if (2 * (table->used + 1) > table->size && !grow(table))
        return false;
    p = place_of(table->places, table->size, name);
    table->used += p->name == 0;
    p->name = name;
    p->object = object;
    if (name > table->greatest)
        table->greatest = name;
    return true;
}

bool reserve_names(object_table *table, GLsizei count, GLuint *names)
{
    for (GLsizei i = 0; i < count; ++i) {
        GLuint name = table->greatest + 1;

        while (name == 0 || is_reserved(table, name))
            ++name;
        if (!set_object(table, name, NULL))
            return false;
        names[i] = name;
    }
    return true;
}

GLuint free_range(const object_table *table, GLsizei count)
{
    GLuint first = 1;

    if ((GLuint)count <= UINT32_MAX - table->greatest)
        return table->greatest + 1;
    for (GLuint name = 1; name; ++name)
        if (is_reserved(table, name))
            first = name + 1;
        else if (name - first + 1 == (GLuint)count)
            return first;
    return 0;
}

bool is_reserved(const object_table *table, GLuint name)
{
    return name && place_of(table->places, table->size, name)->name == name;
}

void *find_object(const object_table *table, GLuint name)
{
    return name ? place_of(table->places, table->size, name)->object : NULL;
}

/* Places after a freed one move up if their names would no longer be found. */
void *remove_name(object_table *table, GLuint name)
{
    place *const freed = name ? place_of(table->places, table->size, name) : NULL;
    void *object;
    size_t i;

    if (!freed || !freed->name)
        return NULL;
    object = freed->object;
    freed->name = 0;
    freed->object = NULL;
    --table->used;
    for (i = (size_t)(freed - table->places + 1) & (table->size - 1); table->places[i].name;
         i = (i + 1) & (table->size - 1)) {
        const place moved = table->places[i];

        table->places[i].name = 0;
        table->places[i].object = NULL;
        *place_of(table->places, table->size, moved.name) = moved;
    }
    return object;
}
