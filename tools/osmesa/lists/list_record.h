/* How display lists record calls (OpenGL 2.1 section 5.4).
 *
 * registry.py writes, for each function that lists record, the function that programs call: it
 * records the call while a list is compiled, and executes it by execute_glNAME, which is what the
 * files here define under the C name glNAME. So a function is recorded as soon as it is defined, if
 * the registry tells how long what its pointers refer to is. If not, there are two ways:
 *
 * - a row in SIZES of registry.py, whose expression may call a function that is declared here;
 * - a function compile_glNAME with the same parameters, which calls record_call, as those of
 *   list_arrays.c do.
 *
 * `registry.py GL_XML recorded OBJECT...` lists how each function is recorded. */
#ifndef OSMESA_LIST_RECORD_H
#define OSMESA_LIST_RECORD_H

#include "../context/gl_context.h"

/* Executes a recorded call. */
typedef void replay_function(void *arguments);

typedef enum call_kind {
    CALL_OTHER,
    CALL_BEGIN,
    CALL_END,
    CALL_VERTEX, /* sets an attribute, or adds a vertex */
    CALL_OF_LIST
} call_kind;

/* Returns GL_COMPILE or GL_COMPILE_AND_EXECUTE while the current context compiles a list, else 0.
 */
GLenum compiled_mode(void);

/* Appends a call to the list that is compiled. Returns memory for its arguments, which live as long
 * as the list; null if memory is short, which is an error. */
void *record_call(replay_function *replay, size_t size, call_kind kind);

/* Returns a copy, which lives as long as the list; null if there is nothing or memory is short. */
void *record_memory(const void *memory, size_t size);

/* Says that a function is not recorded, but executed. */
void not_recorded(const char *function);

/* How pixels lay in memory when they were recorded. */
typedef struct recorded_unpack {
    pixel_store store;
    buffer_object *buffer;
    GLint buffer_name;
} recorded_unpack;

/* Returns the state under which what record_image copied is read. */
recorded_unpack current_unpack(void);

/* Exchanges the context's state and a recorded one: before a call is replayed, and after it. */
void swap_unpack(recorded_unpack *unpack);

/* Returns a copy of pixels, of the program's memory or of the buffer that they are read from. */
void *record_image(const void *pixels, size_t size);

/* How many bytes pixels have from their pointer on, as glPixelStore lays them out; 0 if they have
 * no such format. */
size_t image_bytes(GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLenum type);
size_t bitmap_bytes(GLsizei width, GLsizei height);

/* Returns how many values a parameter has that has a name. */
size_t parameter_count(GLenum name);

/* Returns the bytes of the names of glCallLists. */
size_t name_bytes(GLsizei count, GLenum type);

/* Whether a texture target is a proxy, whose images are not recorded. */
bool is_proxy(GLenum target);

#endif
