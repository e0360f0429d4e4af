/* Elements of the program's arrays as floats. */
#ifndef OSMESA_ARRAY_FETCH_H
#define OSMESA_ARRAY_FETCH_H

#include "../context/gl_context.h"

/* Returns element 0 of an array, in its buffer or in the program's memory. */
const unsigned char *array_start(const vertex_array *array);

/* Returns the bytes from element to element. */
size_t array_stride(const vertex_array *array);

/* Whether a buffer holds elements up to `last`; true for an array in the program's memory. */
bool array_holds(const vertex_array *array, size_t last);

/* Reads an element. Integers of colours and normals (`is_fraction`) become fractions. Components
 * that the array lacks are left alone. */
void fetch_element(const vertex_array *array, bool is_fraction, size_t element, GLfloat value[4]);

/* Whether integers of an array are fractions. */
bool is_fraction_array(enum array_name name);

/* What the arrays that are enabled have for one element. */
typedef struct element_values {
    uint32_t present; /* bits of array_name */
    int size[ARRAYS];
    GLfloat value[ARRAYS][4];
} element_values;

void read_array_element(const context *gl, size_t element, element_values *values);

/* Sets the attributes of an element, the position last, as the functions of immediate mode do. */
void set_array_element(const element_values *values);

/* Makes the attributes of `count` vertices from `first` on of the arrays that are enabled. Arrays
 * of floats are used in place; others are converted into the context's scratch. Returns false if
 * there is nothing to draw: no array of positions, a buffer that is too short, no memory. */
bool gather_attributes(context *gl, size_t first, size_t count, gn_mesh *mesh,
                       const char *function);

#endif
