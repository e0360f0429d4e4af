/* A stand-in for libwaffle-1.so.0, by which piglit's programs open windows and contexts: windows
 * are memory, contexts are OSMesa's. It has the functions that piglit calls. If the environment has
 * PICTURE, the window's pixels are written to that file when the program ends. */
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <waffle-1/waffle.h>

#include "GL/osmesa.h"

struct waffle_display {
    int unused;
};

struct waffle_config {
    int depth_bits, stencil_bits, accumulation_bits;
    int profile, major, minor;
};

struct waffle_context {
    OSMesaContext context;
};

struct waffle_window {
    int width, height;
    GLubyte *pixels;
};

static struct waffle_display the_display;
static struct waffle_window *shown; /* the window that was made current last */

/* The functions of the libOSMesa.so.8 that is found first. It is not linked, so that this library
 * can be preloaded to every program. */
static struct osmesa {
    OSMesaContext (*CreateContextAttribs)(const int *attributes, OSMesaContext shared);
    void (*DestroyContext)(OSMesaContext context);
    GLboolean (*MakeCurrent)(OSMesaContext context, void *pixels, GLenum type, GLsizei width,
                             GLsizei height);
    OSMesaContext (*GetCurrentContext)(void);
    OSMESAproc (*GetProcAddress)(const char *name);
    void (*Finish)(void);
} osmesa;

static bool load(void *library, const char *name, void *function)
{
    void *const found = dlsym(library, name);

    memcpy(function, &found, sizeof found);
    if (!found)
        fprintf(stderr, "%s is lacking\n", name);
    return found != NULL;
}

static bool load_osmesa(void)
{
    void *const library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);

    if (!library) {
        fprintf(stderr, "%s\n", dlerror());
        return false;
    }
    return load(library, "OSMesaCreateContextAttribs", &osmesa.CreateContextAttribs) &&
           load(library, "OSMesaDestroyContext", &osmesa.DestroyContext) &&
           load(library, "OSMesaMakeCurrent", &osmesa.MakeCurrent) &&
           load(library, "OSMesaGetCurrentContext", &osmesa.GetCurrentContext) &&
           load(library, "OSMesaGetProcAddress", &osmesa.GetProcAddress) &&
           load(library, "glFinish", &osmesa.Finish);
}

static void finish(void)
{
    if (osmesa.GetCurrentContext())
        osmesa.Finish();
}

static void write_picture(void)
{
    const char *name = getenv("PICTURE");
    FILE *file = name && shown ? fopen(name, "wb") : NULL;

    if (!file)
        return;
    finish();
    fprintf(file, "P7\nWIDTH %d\nHEIGHT %d\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n",
            shown->width, shown->height);
    fwrite(shown->pixels, 4, (size_t)shown->width * (size_t)shown->height, file);
    fclose(file);
    shown = NULL;
}

bool waffle_init(const int32_t *attrib_list)
{
    (void)attrib_list;
    return load_osmesa() && atexit(write_picture) == 0;
}

const struct waffle_error_info *waffle_error_get_info(void)
{
    static const struct waffle_error_info info = {WAFFLE_ERROR_UNSUPPORTED_ON_PLATFORM,
                                                  "OSMesa does not have it", 23};

    return &info;
}

const char *waffle_error_to_string(enum waffle_error e)
{
    return e == WAFFLE_NO_ERROR ? "WAFFLE_NO_ERROR" : "WAFFLE_ERROR_UNSUPPORTED_ON_PLATFORM";
}

int32_t waffle_attrib_list_length(const int32_t attrib_list[])
{
    int32_t pairs = 0;

    while (attrib_list && attrib_list[2 * pairs])
        ++pairs;
    return pairs;
}

struct waffle_display *waffle_display_connect(const char *name)
{
    (void)name;
    return &the_display;
}

bool waffle_display_disconnect(struct waffle_display *self)
{
    (void)self;
    return true;
}

bool waffle_display_supports_context_api(struct waffle_display *self, int32_t context_api)
{
    (void)self;
    return context_api == WAFFLE_CONTEXT_OPENGL;
}

static bool set_attribute(struct waffle_config *c, int32_t name, int32_t value)
{
    switch (name) {
    case WAFFLE_CONTEXT_API:
        return value == WAFFLE_CONTEXT_OPENGL;
    case WAFFLE_CONTEXT_MAJOR_VERSION:
        return c->major = value, true;
    case WAFFLE_CONTEXT_MINOR_VERSION:
        return c->minor = value, true;
    case WAFFLE_CONTEXT_PROFILE:
        return c->profile = value == WAFFLE_CONTEXT_CORE_PROFILE ? OSMESA_CORE_PROFILE
                                                                 : OSMESA_COMPAT_PROFILE,
               true;
    case WAFFLE_DEPTH_SIZE:
        return c->depth_bits = value, true;
    case WAFFLE_STENCIL_SIZE:
        return c->stencil_bits = value, true;
    case WAFFLE_ACCUM_BUFFER:
        return c->accumulation_bits = value ? 16 : 0, true;
    case WAFFLE_SAMPLES:
        return value <= 0;
    case WAFFLE_CONTEXT_FORWARD_COMPATIBLE:
    case WAFFLE_CONTEXT_ROBUST_ACCESS:
        return value != true;
    default:
        return true;
    }
}

struct waffle_config *waffle_config_choose(struct waffle_display *dpy, const int32_t attrib_list[])
{
    struct waffle_config *c = calloc(1, sizeof *c);
    bool is_possible = c != NULL;

    (void)dpy;
    for (const int32_t *pair = attrib_list; pair && *pair && is_possible; pair += 2)
        is_possible = set_attribute(c, pair[0], pair[1]);
    if (is_possible)
        return c;
    free(c);
    return NULL;
}

bool waffle_config_destroy(struct waffle_config *self)
{
    free(self);
    return true;
}

/* A value of -1, "do not care", is 0 bits or version 1.0. */
static int known(int value)
{
    return value > 0 ? value : 0;
}

struct waffle_context *waffle_context_create(struct waffle_config *config,
                                             struct waffle_context *shared_ctx)
{
    struct waffle_context *c = calloc(1, sizeof *c);
    int attributes[20] = {OSMESA_FORMAT,       OSMESA_RGBA,
                          OSMESA_DEPTH_BITS,   known(config->depth_bits),
                          OSMESA_STENCIL_BITS, known(config->stencil_bits),
                          OSMESA_ACCUM_BITS,   known(config->accumulation_bits)};
    int *next = attributes + 8;

    if (!c)
        return NULL;
    if (config->profile) {
        *next++ = OSMESA_PROFILE;
        *next++ = config->profile;
    }
    if (config->major > 0) {
        *next++ = OSMESA_CONTEXT_MAJOR_VERSION;
        *next++ = config->major;
        *next++ = OSMESA_CONTEXT_MINOR_VERSION;
        *next++ = known(config->minor);
    }
    c->context = osmesa.CreateContextAttribs(attributes, shared_ctx ? shared_ctx->context : NULL);
    if (c->context)
        return c;
    free(c);
    return NULL;
}

bool waffle_context_destroy(struct waffle_context *self)
{
    if (self)
        osmesa.DestroyContext(self->context);
    free(self);
    return true;
}

struct waffle_window *waffle_window_create(struct waffle_config *config, int32_t width,
                                           int32_t height)
{
    struct waffle_window *w = calloc(1, sizeof *w);

    (void)config;
    if (!w)
        return NULL;
    w->width = width;
    w->height = height;
    w->pixels = calloc((size_t)width * (size_t)height, 4);
    return w;
}

bool waffle_window_destroy(struct waffle_window *self)
{
    if (self == shown)
        write_picture();
    shown = NULL;
    if (self)
        free(self->pixels);
    free(self);
    return true;
}

bool waffle_window_show(struct waffle_window *self)
{
    (void)self;
    return true;
}

bool waffle_window_swap_buffers(struct waffle_window *self)
{
    (void)self;
    finish();
    return true;
}

union waffle_native_window *waffle_window_get_native(struct waffle_window *self)
{
    (void)self;
    return NULL;
}

bool waffle_make_current(struct waffle_display *dpy, struct waffle_window *window,
                         struct waffle_context *ctx)
{
    static GLubyte no_window[4];

    (void)dpy;
    if (!ctx)
        write_picture();
    if (!ctx)
        return osmesa.MakeCurrent(NULL, NULL, 0, 0, 0);
    shown = window;
    return window ? osmesa.MakeCurrent(ctx->context, window->pixels, GL_UNSIGNED_BYTE,
                                       window->width, window->height)
                  : osmesa.MakeCurrent(ctx->context, no_window, GL_UNSIGNED_BYTE, 1, 1);
}

void *waffle_get_proc_address(const char *name)
{
    const OSMESAproc found = osmesa.GetProcAddress(name);
    void *address;

    memcpy(&address, &found, sizeof address);
    return address;
}

/* piglit looks OpenGL's functions up by GLX. */
OSMESAproc glXGetProcAddressARB(const GLubyte *name);
OSMESAproc glXGetProcAddressARB(const GLubyte *name)
{
    return osmesa.GetProcAddress((const char *)name);
}

bool waffle_dl_can_open(int32_t dl)
{
    return dl == WAFFLE_DL_OPENGL;
}

void *waffle_dl_sym(int32_t dl, const char *name)
{
    return waffle_dl_can_open(dl) ? waffle_get_proc_address(name) : NULL;
}
