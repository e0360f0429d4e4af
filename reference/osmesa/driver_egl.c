/* The driver EGL on Mesa's surfaceless platform: a context without a window system. */
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "gl.h"

static reference_function (*get_function)(const char *name);
static EGLDisplay display;

/* libEGL looks for Mesa where the system lists it. If this libEGL is not the system's, but stands
 * in FOLDER/lib/MACHINE/, FOLDER/share/glvnd/egl_vendor.d lists the Mesa that belongs to it. */
static void find_mesa(void *library)
{
    static const char list[] = "/share/glvnd/egl_vendor.d";
    char path[PATH_MAX];

    snprintf(path, sizeof path - sizeof list, "%s", reference_library_path(library));
    for (int parts = 0; parts < 3; ++parts) {
        char *const slash = strrchr(path, '/');

        if (!slash)
            return;
        *slash = '\0';
    }
    if (!strcmp(path, "/usr") || !*path)
        return;
    strcat(path, list);
    setenv("__EGL_VENDOR_LIBRARY_DIRS", path, 0);
}

static bool load(char *error, size_t error_size)
{
    void *const library = reference_load_library("libEGL.so.1", "libegl1", error, error_size);

    if (!library)
        return false;
    find_mesa(library);
    get_function = (reference_function(*)(const char *))reference_library_function(
        library, "eglGetProcAddress");
    return get_function || reference_fail(error, error_size, "libEGL.so.1 is no EGL");
}

/* Opens the display. Without LIBGL_ALWAYS_SOFTWARE it would be a graphics card's, where there is
 * one. */
static bool open_display(char *error, size_t error_size)
{
    const PFNEGLGETPLATFORMDISPLAYPROC get_platform_display =
        (PFNEGLGETPLATFORMDISPLAYPROC)get_function("eglGetPlatformDisplay");
    const PFNEGLINITIALIZEPROC initialize = (PFNEGLINITIALIZEPROC)get_function("eglInitialize");
    const PFNEGLBINDAPIPROC bind_api = (PFNEGLBINDAPIPROC)get_function("eglBindAPI");

    setenv("LIBGL_ALWAYS_SOFTWARE", "true", 1);
    display = get_platform_display && initialize && bind_api
                  ? get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL)
                  : EGL_NO_DISPLAY;
    if (display == EGL_NO_DISPLAY)
        return reference_fail(error, error_size,
                              "EGL lacks the surfaceless platform (Debian's package libegl-mesa0)");
    return (initialize(display, NULL, NULL) && bind_api(EGL_OPENGL_API)) ||
           reference_fail(error, error_size,
                          "EGL lacks llvmpipe (Debian's package libgl1-mesa-dri)");
}

static void *fail(const char *why, char *error, size_t error_size)
{
    const PFNEGLGETERRORPROC get_error = (PFNEGLGETERRORPROC)get_function("eglGetError");

    reference_fail(error, error_size, "EGL %s, error %#x", why, (unsigned)get_error());
    return NULL;
}

static void *create(bool compatible, char *error, size_t error_size)
{
    /* The framebuffer that OSMesa requires has these channels too; nothing is drawn to it. */
    static const EGLint config_attributes[] = {EGL_SURFACE_TYPE,
                                               EGL_PBUFFER_BIT,
                                               EGL_RENDERABLE_TYPE,
                                               EGL_OPENGL_BIT,
                                               EGL_RED_SIZE,
                                               8,
                                               EGL_GREEN_SIZE,
                                               8,
                                               EGL_BLUE_SIZE,
                                               8,
                                               EGL_ALPHA_SIZE,
                                               8,
                                               EGL_NONE};
    static const EGLint surface_attributes[] = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
    const EGLint context_attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                         4,
                                         EGL_CONTEXT_MINOR_VERSION,
                                         5,
                                         EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                         compatible ? EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT
                                                    : EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                         EGL_NONE};
    EGLConfig config;
    EGLint count = 0;

    if (!open_display(error, error_size))
        return NULL;

    const PFNEGLCHOOSECONFIGPROC choose = (PFNEGLCHOOSECONFIGPROC)get_function("eglChooseConfig");
    const PFNEGLCREATEPBUFFERSURFACEPROC create_surface =
        (PFNEGLCREATEPBUFFERSURFACEPROC)get_function("eglCreatePbufferSurface");
    const PFNEGLCREATECONTEXTPROC create_context =
        (PFNEGLCREATECONTEXTPROC)get_function("eglCreateContext");
    const PFNEGLMAKECURRENTPROC make_current =
        (PFNEGLMAKECURRENTPROC)get_function("eglMakeCurrent");

    if (!choose(display, config_attributes, &config, 1, &count) || count == 0)
        return fail("has no configuration with RGBA8", error, error_size);
    const EGLSurface surface = create_surface(display, config, surface_attributes);
    if (surface == EGL_NO_SURFACE)
        return fail("creates no pbuffer", error, error_size);
    const EGLContext context = create_context(display, config, EGL_NO_CONTEXT, context_attributes);
    if (context == EGL_NO_CONTEXT)
        return fail("gives no OpenGL 4.5 context", error, error_size);
    if (!make_current(display, surface, surface, context))
        return fail("cannot make its context current", error, error_size);
    return context;
}

static reference_function function(const char *name)
{
    return get_function(name);
}

/* The display and its libraries stay until the process ends: LeakSanitizer names the library of a
 * leak only while the library is loaded. The surface goes with the display. */
static void destroy(void *context)
{
    const PFNEGLMAKECURRENTPROC make_current =
        (PFNEGLMAKECURRENTPROC)get_function("eglMakeCurrent");
    const PFNEGLDESTROYCONTEXTPROC destroy_context =
        (PFNEGLDESTROYCONTEXTPROC)get_function("eglDestroyContext");

    make_current(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    destroy_context(display, context);
}

const reference_driver reference_egl = {"Mesa EGL", load, create, function, destroy};
