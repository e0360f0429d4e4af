/* Calls of functions that set state, with random arguments, right and wrong ones.
 *
 * Not alone: registry.py writes gl_registry.h, which it includes. */
#ifndef OSMESA_STATE_CALLS_H
#define OSMESA_STATE_CALLS_H

#include "random.h"
#include "two_libraries.h"

/* Random arguments, drawn once for both libraries. */
typedef struct arguments {
    GLenum e[4];
    GLenum name;
    GLint i[4];
    GLsizei stride; /* the reference, of OpenGL 4.5, refuses those above 2048 */
    GLfloat f[16];
    GLdouble d[16];
} arguments;

void choose_arguments(random_source *r, arguments *a);

/* The numbers of kinds of calls, and the call of one kind: of matrices, of lights, of textures,
 * of pixels, of stacks of attributes, of display lists, of selection and feedback, of
 * evaluators, of queries, and of other state. */
enum {
    KINDS = 78,
    MATRIX_KINDS = 18,
    LIGHT_KINDS = 13,
    TEXTURE_KINDS = 12,
    PIXEL_KINDS = 24,
    LIST_KINDS = 9,
    STACK_KINDS = 7,
    MODE_KINDS = 11,
    EVALUATOR_KINDS = 14,
    QUERY_KINDS = 13
};
void call_function(const library *gl, unsigned kind, const arguments *a);
void call_matrix(const library *gl, unsigned kind, const arguments *a);
void call_light(const library *gl, unsigned kind, const arguments *a);
void call_texture(const library *gl, unsigned kind, const arguments *a);
void call_pixels(const library *gl, unsigned kind, const arguments *a);

/* A group of calls. */
typedef struct call_group {
    const char *name;
    unsigned kinds, chance; /* in a hundred, if none of the groups before it was chosen */
    void (*call)(const library *gl, unsigned kind, const arguments *a);
    GLint (*returning)(const library *gl, unsigned kind, const arguments *a); /* or null */
} call_group;

const call_group *choose_group(random_source *r);

/* Returns what the call returns, or 0. */
GLint call_of_group(const library *gl, const call_group *group, unsigned kind, const arguments *a);

/* Whether a pattern of polygons takes little memory with these parameters of the storage of pixels.
 */
bool has_little_storage(const library *gl, GLenum row_length, GLenum skip_rows, GLenum skip_pixels);
GLbitfield attribute_groups(const arguments *a);
void call_stacks(const library *gl, unsigned kind, const arguments *a);
void call_evaluators(const library *gl, unsigned kind, const arguments *a);
void call_lists(const library *gl, unsigned kind, const arguments *a);

/* Return what the call returns, or which memory it returns. */
GLint call_mode(const library *gl, unsigned kind, const arguments *a);
GLint call_query(const library *gl, unsigned kind, const arguments *a);

#endif
