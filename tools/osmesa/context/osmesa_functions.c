/* The functions of OSMesa: contexts, windows, and functions by name. */
#include <gl_registry.h>
#include <stdlib.h>
#include <string.h>

#include "attribute_stacks.h"
#include "GL/osmesa.h"
#include "../vertices/buffer_objects.h"
#include "../lists/display_lists.h"
#include "../draw/draw_threads.h"
#include "../evaluators/evaluator_maps.h"
#include "entries.h"
#include "../framebuffer/accumulation.h"
#include "../framebuffer/framebuffer_objects.h"
#include "gl_context.h"
#include "gl_errors.h"
#include "initial_state.h"
#include "object_names.h"
#include "../textures/texture_objects.h"
#include "../framebuffer/window.h"
#include "../framebuffer/window_bits.h"

static shared_objects *create_shared(void)
{
    shared_objects *const shared = calloc(1, sizeof *shared);

    if (!shared)
        return NULL;
    shared->references = 1;
    shared->buffers = create_table();
    shared->textures = create_table();
    shared->renderbuffers = create_table();
    shared->framebuffers = create_table();
    shared->lists = create_table();
    if (!create_textures(shared->default_texture) || !shared->buffers || !shared->textures ||
        !shared->renderbuffers || !shared->framebuffers || !shared->lists) {
        destroy_table(shared->framebuffers, release_framebuffer);
        destroy_table(shared->renderbuffers, release_renderbuffer);
        destroy_table(shared->buffers, release_buffer);
        destroy_table(shared->textures, release_texture);
        destroy_table(shared->lists, destroy_list);
        release_textures(shared->default_texture);
        free(shared);
        return NULL;
    }
    return shared;
}

static void release_shared(shared_objects *shared)
{
    if (!shared || --shared->references > 0)
        return;
    destroy_table(shared->framebuffers, release_framebuffer);
    destroy_table(shared->renderbuffers, release_renderbuffer);
    destroy_table(shared->buffers, release_buffer);
    destroy_table(shared->textures, release_texture);
    destroy_table(shared->lists, destroy_list);
    release_textures(shared->default_texture);
    free(shared);
}

static bool is_format(GLenum format)
{
    static const GLenum formats[] = {OSMESA_RGBA, OSMESA_BGRA, OSMESA_ARGB,
                                     OSMESA_RGB,  OSMESA_BGR,  OSMESA_RGB_565};

    for (size_t i = 0; i < sizeof formats / sizeof *formats; ++i)
        if (formats[i] == format)
            return true;
    return false;
}

OSMesaContext OSMesaCreateContextExt(GLenum format, GLint depth_bits, GLint stencil_bits,
                                     GLint accum_bits, OSMesaContext sharelist)
{
    context *const gl = is_format(format) ? calloc(1, sizeof *gl) : NULL;

    if (!gl)
        return NULL;
    set_initial_state(gl);
    gl->window.format = format;
    gl->window.type = format == OSMESA_RGB_565 ? GL_UNSIGNED_SHORT_5_6_5 : GL_UNSIGNED_BYTE;
    gl->window.y_up = 1;
    gl->window.depth_bits = stencil_bits > 0   ? 24
                            : depth_bits <= 0  ? 0
                            : depth_bits <= 16 ? 16
                            : depth_bits <= 24 ? 24
                                               : 32;
    gl->window.stencil_bits = stencil_bits > 0 ? 8 : 0;
    gl->window.accumulation_bits = accum_bits > 0 ? ACCUMULATION_BITS : 0;
    gl->shared = sharelist ? sharelist->shared : create_shared();
    if (!gl->shared) {
        free(gl);
        return NULL;
    }
    if (sharelist)
        ++gl->shared->references;
    gl->queries = create_table();
    if (!gl->queries || !create_textures(gl->proxy)) {
        destroy_table(gl->queries, free);
        release_shared(gl->shared);
        free(gl);
        return NULL;
    }
    bind_default_textures(gl);
    return gl;
}

OSMesaContext OSMesaCreateContext(GLenum format, OSMesaContext sharelist)
{
    return OSMesaCreateContextExt(format, 24, 8, 0, sharelist);
}

OSMesaContext OSMesaCreateContextAttribs(const int *attributes, OSMesaContext sharelist)
{
    GLenum format = OSMESA_RGBA;
    int depth = 0, stencil = 0, accumulation = 0, major = 1, minor = 0;

    for (; attributes && attributes[0]; attributes += 2) {
        const int value = attributes[1];

        switch (attributes[0]) {
        case OSMESA_FORMAT:
            format = (GLenum)value;
            break;
        case OSMESA_DEPTH_BITS:
            depth = value;
            break;
        case OSMESA_STENCIL_BITS:
            stencil = value;
            break;
        case OSMESA_ACCUM_BITS:
            accumulation = value;
            break;
        case OSMESA_CONTEXT_MAJOR_VERSION:
            major = value;
            break;
        case OSMESA_CONTEXT_MINOR_VERSION:
            minor = value;
            break;
        case OSMESA_PROFILE:
            if (value != OSMESA_COMPAT_PROFILE) {
                debug_line(__func__, "there is no core profile");
                return NULL;
            }
            break;
        default:
            return NULL;
        }
    }
    if (depth < 0 || stencil < 0 || accumulation < 0)
        return NULL;
    if (major > 2 || (major == 2 && minor > 1)) {
        debug_line(__func__, "there is no OpenGL 3");
        return NULL;
    }
    return OSMesaCreateContextExt(format, depth, stencil, accumulation, sharelist);
}

static void unbind_buffers(array_state *a)
{
    refer_to_buffer(&a->array_buffer, &a->array_buffer_name, NULL);
    refer_to_buffer(&a->element_buffer, &a->element_buffer_name, NULL);
    refer_to_buffer(&a->pack_buffer, &a->pack_buffer_name, NULL);
    refer_to_buffer(&a->unpack_buffer, &a->unpack_buffer_name, NULL);
    for (int i = 0; i < ARRAYS; ++i)
        refer_to_buffer(&a->array[i].buffer, &a->array[i].buffer_name, NULL);
}

void OSMesaDestroyContext(OSMesaContext gl)
{
    if (!gl)
        return;
    if (gl == current_context()) {
        flush_vertices(gl);
        set_current_context(NULL);
    }
    finish_window(&gl->window);
    release_window(&gl->window);
    free_attribute_stacks(gl);
    unbind_buffers(&gl->arrays);
    unbind_textures(gl);
    release_textures(gl->proxy);
    unbind_framebuffers(gl);
    release_shared(gl->shared);
    destroy_table(gl->queries, free);
    free_compiled_list(gl);
    free_evaluator_maps(gl);
    free(gl->immediate.vertex);
    free(gl->vertices.memory);
    free(gl->indices.memory);
    free(gl->pixels.memory);
    free(gl->corners.memory);
    free(gl->flags.memory);
    free(gl->shaded.memory);
    end_draw_threads(&gl->workspace);
    free(gl->workspace.memory);
    free(gl);
}

GLboolean OSMesaMakeCurrent(OSMesaContext gl, void *buffer, GLenum type, GLsizei width,
                            GLsizei height)
{
    context *const before = current_context();
    bool is_first;

    if (before) {
        flush_vertices(before);
        finish_window(&before->window);
    }
    if (!gl && !buffer) {
        set_current_context(NULL);
        return GL_TRUE;
    }
    if (!gl || !buffer)
        return GL_FALSE;
    is_first = !gl->window.memory;
    if (!bind_window(&gl->window, buffer, type, width, height))
        return GL_FALSE;
    if (is_first) {
        gl->transform.viewport[2] = gl->fragment.scissor_box[2] = width;
        gl->transform.viewport[3] = gl->fragment.scissor_box[3] = height;
    }
    set_current_context(gl);
    return GL_TRUE;
}

OSMesaContext OSMesaGetCurrentContext(void)
{
    return current_context();
}

void OSMesaPixelStore(GLint name, GLint value)
{
    context *const gl = current_context();

    if (!gl)
        return;
    flush_vertices(gl);
    if (name == OSMESA_ROW_LENGTH)
        gl->window.row_length = value < 0 ? 0 : value;
    else if (name == OSMESA_Y_UP)
        gl->window.y_up = value != 0;
    lay_out_window(&gl->window);
}

void OSMesaGetIntegerv(GLint name, GLint *value)
{
    const context *const gl = current_context();

    switch (name) {
    case OSMESA_WIDTH:
        *value = gl ? gl->window.width : 0;
        break;
    case OSMESA_HEIGHT:
        *value = gl ? gl->window.height : 0;
        break;
    case OSMESA_FORMAT:
        *value = gl ? (GLint)gl->window.format : 0;
        break;
    case OSMESA_TYPE:
        *value = gl ? (GLint)gl->window.type : 0;
        break;
    case OSMESA_ROW_LENGTH:
        *value = gl ? gl->window.row_length : 0;
        break;
    case OSMESA_Y_UP:
        *value = gl ? gl->window.y_up : 0;
        break;
    case OSMESA_MAX_WIDTH:
    case OSMESA_MAX_HEIGHT:
        *value = GN_MAX_SIZE;
        break;
    default:
        break;
    }
}

GLboolean OSMesaGetDepthBuffer(OSMesaContext gl, GLint *width, GLint *height, GLint *bytes,
                               void **buffer)
{
    const gn_surface *const depth = gl ? &gl->window.target.depth : NULL;
    const bool is_there = depth && depth->format;

    *width = is_there ? gl->window.width : 0;
    *height = is_there ? gl->window.height : 0;
    *bytes = is_there ? (GLint)gn_format_size(depth->format) : 0;
    *buffer = is_there ? gl->window.depth_memory : NULL;
    return is_there;
}

GLboolean OSMesaGetColorBuffer(OSMesaContext gl, GLint *width, GLint *height, GLint *format,
                               void **buffer)
{
    const bool is_there = gl && gl->window.memory;

    *width = is_there ? gl->window.width : 0;
    *height = is_there ? gl->window.height : 0;
    *format = is_there ? (GLint)gl->window.format : 0;
    *buffer = is_there ? gl->window.memory : NULL;
    return is_there;
}

void OSMesaColorClamp(GLboolean enable)
{
    context *const gl = current_context();

    if (gl)
        flush_vertices(gl);
    if (gl)
        gl->clamp_vertex_color = gl->clamp_fragment_color = enable ? GL_TRUE : GL_FIXED_ONLY;
}

void OSMesaPostprocess(OSMesaContext gl, const char *filter, unsigned value)
{
    (void)gl;
    (void)filter;
    (void)value;
}

static const entry_point own_entries[] = {
#define OWN(name)                                                                                  \
    {                                                                                              \
#name, (entry_function *)name                                                              \
    }
    OWN(OSMesaCreateContext),  OWN(OSMesaCreateContextExt), OWN(OSMesaCreateContextAttribs),
    OWN(OSMesaDestroyContext), OWN(OSMesaMakeCurrent),      OWN(OSMesaGetCurrentContext),
    OWN(OSMesaPixelStore),     OWN(OSMesaGetIntegerv),      OWN(OSMesaGetDepthBuffer),
    OWN(OSMesaGetColorBuffer), OWN(OSMesaColorClamp),       OWN(OSMesaPostprocess),
#undef OWN
};

static int compare_entries(const void *a, const void *b)
{
    return strcmp(((const entry_point *)a)->name, ((const entry_point *)b)->name);
}

OSMESAproc OSMesaGetProcAddress(const char *name)
{
    const entry_point key = {name, NULL};
    const entry_point *const found =
        name ? bsearch(&key, entries, entry_count, sizeof key, compare_entries) : NULL;

    for (size_t i = 0; name && i < sizeof own_entries / sizeof *own_entries; ++i)
        if (strcmp(own_entries[i].name, name) == 0)
            return own_entries[i].function;
    if (name && strcmp(name, "OSMesaGetProcAddress") == 0)
        return (OSMESAproc)OSMesaGetProcAddress;
    return found ? found->function : NULL;
}
