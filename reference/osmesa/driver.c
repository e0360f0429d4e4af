/* Which driver the reference uses, and its functions. */
#include "gl.h"

#include <stdlib.h>
#include <string.h>

static const reference_driver *named_driver(const char *name, char *error, size_t error_size)
{
    const reference_driver *const driver = !strcmp(name, "osmesa") ? &reference_osmesa
                                           : !strcmp(name, "egl")  ? &reference_egl
                                                                   : NULL;

    if (!driver)
        reference_fail(error, error_size, "REFERENCE is \"%s\", it can be osmesa or egl", name);
    return driver && driver->load(error, error_size) ? driver : NULL;
}

const reference_driver *reference_choose_driver(char *error, size_t error_size)
{
    const char *const name = getenv("REFERENCE");
    char no_osmesa[200], no_egl[200];

    if (name && *name)
        return named_driver(name, error, error_size);
    if (reference_osmesa.load(no_osmesa, sizeof no_osmesa))
        return &reference_osmesa;
    if (reference_egl.load(no_egl, sizeof no_egl))
        return &reference_egl;
    reference_fail(error, error_size, "neither OSMesa nor EGL is installed: %s; %s", no_osmesa,
                   no_egl);
    return NULL;
}

bool reference_load_functions(const reference_driver *driver, char *error, size_t error_size)
{
#define GL_LOAD(type, f)                                                                           \
    f = (type)driver->function(#f);                                                                \
    if (!f)                                                                                        \
        return reference_fail(error, error_size, "%s lacks the function " #f, driver->name);
    GL_FUNCTIONS(GL_LOAD)
    return true;
}
