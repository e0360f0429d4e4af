/* glGetFramebufferAttachmentParameteriv (OpenGL 4.5 section 9.2.3). Where the specification leaves
 * an error open, it is the reference's. */
#include <gl_registry.h>

#include "framebuffer_objects.h"
#include "window_bits.h"
#include "../context/gl_errors.h"

typedef struct description {
    GLenum type; /* GL_NONE if nothing is attached */
    bool is_window, is_window_color;
    const attachment *attached; /* null: the window's buffer */
    unsigned char bits[6];      /* red, green, blue, alpha, depth, stencil */
    gn_format format;           /* 0: it has no image */
} description;

/* Returns false if the window has no buffer of that name. */
static bool describe_window_buffer(const window_state *window, GLenum name, description *d)
{
    const bool is_depth = name == GL_DEPTH, is_stencil = name == GL_STENCIL;
    const bool is_right = name == GL_FRONT_RIGHT || name == GL_BACK_RIGHT;
    const bool is_left =
        name == GL_FRONT || name == GL_FRONT_LEFT || name == GL_BACK || name == GL_BACK_LEFT;
    const bool is_there =
        is_left || (is_depth && window->depth_bits) || (is_stencil && window->stencil_bits);

    d->is_window = true;
    d->is_window_color = is_left || is_right;
    d->type = is_there ? GL_FRAMEBUFFER_DEFAULT : GL_NONE;
    d->format = window->target.color[0].format;
    for (int c = 0; c < 4 && is_left; ++c)
        d->bits[c] = (unsigned char)window_color_bits(window, c);
    if (is_depth || is_stencil) {
        d->format = window->target.depth.format;
        d->bits[4] = (unsigned char)window->depth_bits;
        d->bits[5] = (unsigned char)window->stencil_bits;
    }
    return is_left || is_right || is_depth || is_stencil;
}

static void describe_attachment(const attachment *attached, description *d)
{
    d->attached = attached;
    d->type = attached->renderbuffer ? GL_RENDERBUFFER : attached->texture ? GL_TEXTURE : GL_NONE;
    d->format = attached_surface(attached, d->bits).format;
    if (attached->renderbuffer && attached->renderbuffer->kept_as) /* it may have no pixels */
        d->format = attached->renderbuffer->kept_as->format;
}

static bool is_same(const attachment *a, const attachment *b)
{
    return a->renderbuffer == b->renderbuffer && a->texture == b->texture && a->level == b->level &&
           a->face == b->face && a->slice == b->slice;
}

/* Describes what a name stands for in a framebuffer. Returns false, with an error, if it stands for
 * nothing. */
static bool describe(context *gl, const framebuffer_object *framebuffer, GLenum name,
                     description *d, const char *function)
{
    const bool is_pair = name == GL_DEPTH_STENCIL_ATTACHMENT;
    const int index = is_pair ? DEPTH_ATTACHMENT : attachment_index(name);
    const bool is_beyond =
        name >= GL_COLOR_ATTACHMENT0 + GN_MAX_COLORS && name <= GL_COLOR_ATTACHMENT31;

    if (!framebuffer && describe_window_buffer(&gl->window, name, d))
        return true;
    if (framebuffer && index >= 0) {
        const attachment *const attached = &framebuffer->attached[index];

        describe_attachment(attached, d);
        if (!is_pair || is_same(attached, &framebuffer->attached[STENCIL_ATTACHMENT]))
            return true;
        gl_error(gl, GL_INVALID_OPERATION, function);
        return false;
    }
    gl_error(gl, framebuffer && is_beyond ? GL_INVALID_OPERATION : GL_INVALID_ENUM, function);
    return false;
}

static GLint component_type(const description *d)
{
    switch (d->format) {
    case GN_FORMAT_NONE:
        return GL_NONE;
    case GN_FORMAT_RGBA16F:
    case GN_FORMAT_RGBA32F:
    case GN_FORMAT_D32F:
    case GN_FORMAT_D32FS8:
        return GL_FLOAT;
    case GN_FORMAT_S8:
        return GL_INDEX;
    default:
        return GL_UNSIGNED_NORMALIZED;
    }
}

/* Returns the value of a parameter of a texture. */
static GLint texture_value(const attachment *attached, GLenum parameter)
{
    const bool is_cube = attached->texture->target == GL_TEXTURE_CUBE_MAP;

    switch (parameter) {
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL:
        return attached->level;
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE:
        return is_cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + attached->face : 0;
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER:
        return attached->slice;
    default: /* GL_FRAMEBUFFER_ATTACHMENT_LAYERED */
        return GL_FALSE;
    }
}

static GLint name_of(const attachment *attached)
{
    return attached->renderbuffer ? (GLint)attached->renderbuffer->name
           : attached->texture    ? (GLint)attached->texture->name
                                  : 0;
}

void glGetFramebufferAttachmentParameteriv(GLenum target, GLenum name, GLenum parameter,
                                           GLint *value)
{
    context *const gl = enter(__func__);
    const bool is_read = target == GL_READ_FRAMEBUFFER;
    const bool is_draw = target == GL_FRAMEBUFFER || target == GL_DRAW_FRAMEBUFFER;
    const framebuffer_object *const framebuffer = !gl       ? NULL
                                                  : is_read ? gl->read_framebuffer
                                                            : gl->draw_framebuffer;
    description d = {0};
    GLenum error = GL_NO_ERROR;

    if (!gl)
        return;
    if (!is_read && !is_draw) {
        gl_error(gl, GL_INVALID_ENUM, __func__);
        return;
    }
    if (!describe(gl, framebuffer, name, &d, __func__))
        return;
    switch (parameter) {
    case GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE:
        *value = (GLint)d.type;
        return;
    case GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME:
        if (d.is_window)
            error = GL_INVALID_ENUM;
        else
            *value = name_of(d.attached);
        break;
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL:
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE:
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER:
    case GL_FRAMEBUFFER_ATTACHMENT_LAYERED:
        if (d.type == GL_TEXTURE)
            *value = texture_value(d.attached, parameter);
        else
            error = d.type == GL_NONE ? GL_INVALID_OPERATION : GL_INVALID_ENUM;
        break;
    case GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING:
        if (d.type == GL_NONE && (!d.is_window || d.is_window_color))
            error = GL_INVALID_OPERATION;
        else
            *value = d.format == GN_FORMAT_SRGB8_A8 ? GL_SRGB : GL_LINEAR;
        break;
    case GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE:
        if (d.type == GL_NONE || name == GL_DEPTH_STENCIL_ATTACHMENT)
            error = GL_INVALID_OPERATION;
        else
            *value = component_type(&d);
        break;
    case GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE:
    case GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE:
    case GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE:
    case GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE:
    case GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE:
    case GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE:
        if (d.type == GL_NONE)
            error = GL_INVALID_OPERATION;
        else
            *value = d.bits[parameter - GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE];
        break;
    default:
        error = GL_INVALID_ENUM;
    }
    if (error)
        gl_error(gl, error, __func__);
}
