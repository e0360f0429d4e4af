/* The drivers through which the reference reaches Mesa's llvmpipe. Mesa 25.1 has no OSMesa; EGL
 * runs the same llvmpipe and draws the same pixels. Libraries are loaded when a reference is
 * created, so one program serves machines with either of them, and what draws without the
 * reference needs none. */
#ifndef OSMESA_DRIVER_H
#define OSMESA_DRIVER_H

#include <stdbool.h>
#include <stddef.h>

typedef void (*reference_function)(void);

typedef struct reference_driver {
    const char *name; /* such as "OSMesa" */

    /* Loads the driver's libraries, which stay in the process. Returns false, with the reason and
     * the Debian package in error, if they are not installed. */
    bool (*load)(char *error, size_t error_size);

    /* Creates an OpenGL 4.5 context and makes it current in the calling thread, with a small
     * framebuffer of its own. The context has the compatibility profile or the core profile.
     * Returns null with the reason in error. */
    void *(*create)(bool compatible, char *error, size_t error_size);

    /* Returns OpenGL's function of this name, null if the driver lacks it; a context exists. */
    reference_function (*function)(const char *name);

    void (*destroy)(void *context);
} reference_driver;

extern const reference_driver reference_osmesa, reference_egl;

/* Returns the driver that the environment's variable REFERENCE names, "osmesa" or "egl". Without
 * it, returns OSMesa, or EGL if OSMesa is not installed. The driver is loaded. Returns null, with
 * the reason in error, if it cannot be loaded and for another value. */
const reference_driver *reference_choose_driver(char *error, size_t error_size);

/* Sets the pointers of functions.h. Returns false, with the name of a function that the driver
 * lacks in error; a context exists. */
bool reference_load_functions(const reference_driver *driver, char *error, size_t error_size);

/* Loads the library of this name. Returns null, with the reason and the package in error, if it is
 * not installed. */
void *reference_load_library(const char *name, const char *package, char *error, size_t error_size);

/* Returns the path that a library was loaded from, "" if it is not known. */
const char *reference_library_path(void *library);

/* Returns the function of this name in a library, null if there is none. */
reference_function reference_library_function(void *library, const char *name);

#endif
