/* Tables from names to objects: buffers, textures, renderbuffers, framebuffers, display lists,
 * queries. A name is a number above 0 that a glGen function returns or the program chooses. */
#ifndef OSMESA_OBJECT_NAMES_H
#define OSMESA_OBJECT_NAMES_H

#include <stdbool.h>

#include "gl_types.h"

typedef struct object_table object_table;

/* Returns an empty table, null if memory is short. */
object_table *create_table(void);

/* Frees a table, and each object in it by a function. */
void destroy_table(object_table *table, void (*release)(void *));

/* Reserves `count` consecutive names; false if memory is short. */
bool reserve_names(object_table *table, GLsizei count, GLuint *names);

/* Returns the first of `count` consecutive names that are free, 0 if there are none. */
GLuint free_range(const object_table *table, GLsizei count);

/* Whether a name is reserved or has an object. */
bool is_reserved(const object_table *table, GLuint name);

/* Returns the object of a name, null if it has none. */
void *find_object(const object_table *table, GLuint name);

/* Gives a name an object; false if memory is short. */
bool set_object(object_table *table, GLuint name, void *object);

/* Frees a name and returns its object, which may be null. */
void *remove_name(object_table *table, GLuint name);

#endif
