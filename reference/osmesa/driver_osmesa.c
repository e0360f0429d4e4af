/* The driver OSMesa: Mesa draws into memory, without a window system. The constants and types are
 * those of GL/osmesa.h, a header that systems without OSMesa lack. */
#include "gl.h"

typedef struct osmesa_context *OSMesaContext;

enum {
    OSMESA_FORMAT = 0x22,
    OSMESA_PROFILE = 0x33,
    OSMESA_CORE_PROFILE = 0x34,
    OSMESA_COMPAT_PROFILE = 0x35,
    OSMESA_CONTEXT_MAJOR_VERSION = 0x36,
    OSMESA_CONTEXT_MINOR_VERSION = 0x37,
    OSMESA_RGBA = GL_RGBA
};

static OSMesaContext (*create_context)(const int *attributes, OSMesaContext shared);
static GLboolean (*make_current)(OSMesaContext, void *buffer, GLenum type, GLsizei width,
                                 GLsizei height);
static reference_function (*get_function)(const char *name);
static void (*destroy_context)(OSMesaContext);

static bool load(char *error, size_t error_size)
{
    void *const library = reference_load_library("libOSMesa.so.8", "libosmesa6", error, error_size);

    if (!library)
        return false;
    create_context = (OSMesaContext(*)(const int *, OSMesaContext))reference_library_function(
        library, "OSMesaCreateContextAttribs");
    make_current = (GLboolean(*)(OSMesaContext, void *, GLenum, GLsizei,
                                 GLsizei))reference_library_function(library, "OSMesaMakeCurrent");
    get_function = (reference_function(*)(const char *))reference_library_function(
        library, "OSMesaGetProcAddress");
    destroy_context =
        (void (*)(OSMesaContext))reference_library_function(library, "OSMesaDestroyContext");
    return (create_context && make_current && get_function && destroy_context) ||
           reference_fail(error, error_size, "libOSMesa.so.8 lacks functions of Mesa 11.2");
}

static void *create(bool compatible, char *error, size_t error_size)
{
    /* The window's buffer, which OSMesa requires; nothing is drawn to it. */
    enum { SIZE = 16 };
    static unsigned char window[SIZE * SIZE * 4];
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_PROFILE,
                              compatible ? OSMESA_COMPAT_PROFILE : OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              4,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              5,
                              0};
    const OSMesaContext context = create_context(attributes, NULL);

    if (!context) {
        reference_fail(error, error_size, "OSMesa gives no OpenGL 4.5 context");
        return NULL;
    }
    if (!make_current(context, window, GL_UNSIGNED_BYTE, SIZE, SIZE)) {
        reference_fail(error, error_size, "OSMesa cannot make its context current");
        destroy_context(context);
        return NULL;
    }
    return context;
}

static reference_function function(const char *name)
{
    return get_function(name);
}

static void destroy(void *context)
{
    destroy_context(context);
}

const reference_driver reference_osmesa = {"OSMesa", load, create, function, destroy};
