/* Loads the two libraries by the names of their functions. */
#include "two_libraries.h"

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

#include "driver.h"
#include "osmesa.h"

static bool load_function(void *handle, OSMESAproc (*by_name)(const char *), const char *name,
                          void *function)
{
    OSMESAproc found = by_name ? by_name(name) : reference_library_function(handle, name);

    memcpy(function, &found, sizeof found);
    if (!found)
        fprintf(stderr, "%s is lacking\n", name);
    return found != NULL;
}

static bool load_functions(library *l, void *handle)
{
    OSMESAproc (*by_name)(const char *);
    bool complete = load_function(handle, NULL, "OSMesaGetProcAddress", &by_name);

#define LOAD(name) complete = load_function(handle, NULL, #name, &l->name) && complete;
    OSMESA_FUNCTIONS(LOAD)
#undef LOAD
#define LOAD(name) complete = complete && load_function(handle, by_name, "gl" #name, &l->name);
    TESTED_FUNCTIONS(LOAD)
    return complete;
}

/* Whether the reference is that of the contract; with a message if not. */
static bool is_contract_version(const library *gl)
{
    static GLubyte pixel[4];
    const OSMesaContext context = gl->OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
    const char *version = NULL;
    bool is_right;

    if (context && gl->OSMesaMakeCurrent(context, pixel, GL_UNSIGNED_BYTE, 1, 1))
        version = (const char *)gl->GetString(GL_VERSION);
    is_right = version && strstr(version, "Mesa 25.0.7");
    if (!is_right)
        fprintf(stderr, "the reference is %s, not Mesa 25.0.7: 'make setup' fetches it\n",
                version ? version : "unknown");
    gl->OSMesaMakeCurrent(NULL, NULL, 0, 0, 0);
    gl->OSMesaDestroyContext(context);
    return is_right;
}

bool load_libraries(const char *path, library libraries[LIBRARIES])
{
    char error[200];
    void *const theirs =
        (reference_set_environment(REFERENCE_PINNED),
         reference_load_library("libOSMesa.so.8", "libosmesa6", error, sizeof error));
    void *const ours = dlopen(path, RTLD_NOW | RTLD_LOCAL);

    libraries[REFERENCE].name = "reference";
    libraries[OURS].name = "ours";
    if (!theirs || !ours) {
        fprintf(stderr, "%s\n", theirs ? dlerror() : error);
        return false;
    }
    return load_functions(&libraries[REFERENCE], theirs) &&
           is_contract_version(&libraries[REFERENCE]) && load_functions(&libraries[OURS], ours);
}
