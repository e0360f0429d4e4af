/* The libraries of drivers, which are loaded while the program runs. */
#define _GNU_SOURCE /* dlinfo */
#include "gl.h"

#include <dlfcn.h>
#include <link.h>
#include <string.h>

void *reference_load_library(const char *name, const char *package, char *error, size_t error_size)
{
    void *const library = dlopen(name, RTLD_NOW | RTLD_LOCAL);

    if (!library)
        reference_fail(error, error_size, "%s (Debian's package %s)", dlerror(), package);
    return library;
}

const char *reference_library_path(void *library)
{
    struct link_map *map;

    return dlinfo(library, RTLD_DI_LINKMAP, &map) == 0 ? map->l_name : "";
}

reference_function reference_library_function(void *library, const char *name)
{
    void *const address = dlsym(library, name);
    reference_function function;

    /* C cannot cast a pointer to data to one to a function. POSIX gives both one form. */
    memcpy(&function, &address, sizeof function);
    return function;
}
