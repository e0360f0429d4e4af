/* The functions that name, bind, fill and check framebuffer objects. */
#include "framebuffer_objects.h"

#include <gl_registry.h>
#include <stdlib.h>
#include <string.h>

#include "../context/gl_errors.h"
#include "../context/name_calls.h"
#include "../context/object_names.h"

static void detach(attachment *attached)
{
    release_renderbuffer(attached->renderbuffer);
    release_texture(attached->texture);
    memset(attached, 0, sizeof *attached);
}

void release_framebuffer(void *released)
{
    framebuffer_object *const framebuffer = released;

    if (!framebuffer || --framebuffer->references > 0)
        return;
    for (int i = 0; i < ATTACHMENTS; ++i)
        detach(&framebuffer->attached[i]);
    free(framebuffer);
}

static void refer_to_framebuffer(framebuffer_object **place, framebuffer_object *framebuffer)
{
    framebuffer_object *const before = *place;

    if (framebuffer)
        ++framebuffer->references;
    *place = framebuffer;
    release_framebuffer(before);
}

void unbind_framebuffers(context *gl)
{
    refer_to_framebuffer(&gl->draw_framebuffer, NULL);
    refer_to_framebuffer(&gl->read_framebuffer, NULL);
    release_renderbuffer(gl->renderbuffer);
    gl->renderbuffer = NULL;
}

void detach_texture(context *gl, const texture_object *texture)
{
    framebuffer_object *const bound[] = {gl->draw_framebuffer, gl->read_framebuffer};

    for (int b = 0; b < 2; ++b)
        for (int i = 0; bound[b] && i < ATTACHMENTS; ++i)
            if (bound[b]->attached[i].texture == texture)
                detach(&bound[b]->attached[i]);
}

int attachment_index(GLenum name)
{
    if (name >= GL_COLOR_ATTACHMENT0 && name < GL_COLOR_ATTACHMENT0 + GN_MAX_COLORS)
        return (int)(name - GL_COLOR_ATTACHMENT0);
    return name == GL_DEPTH_ATTACHMENT     ? DEPTH_ATTACHMENT
           : name == GL_STENCIL_ATTACHMENT ? STENCIL_ATTACHMENT
                                           : -1;
}

static gn_surface texture_surface(const attachment *attached, unsigned char bits[6])
{
    const texture_image *const image = &attached->texture->image[attached->face][attached->level];
    const bool is_color = image->base_format == GL_RGB || image->base_format == GL_RGBA;
    const bool is_depth =
        image->base_format == GL_DEPTH_COMPONENT || image->base_format == GL_DEPTH_STENCIL;
    const unsigned char size =
        image->format == GN_FORMAT_RGBA32F || image->format == GN_FORMAT_D32F ||
                image->format == GN_FORMAT_D32FS8
            ? 32
        : image->format == GN_FORMAT_RGBA16 || image->format == GN_FORMAT_D16 ? 16
        : is_depth                                                            ? 24
                                                                              : 8;
    const size_t slice_size =
        (size_t)image->width * (size_t)image->height * gn_format_size(image->format);

    if (!image->texels || !(is_color || is_depth) || attached->slice >= image->depth)
        return (gn_surface){0};
    for (int c = 0; bits && is_color && c < 4; ++c)
        bits[c] = c == 3 && image->base_format == GL_RGB ? 0 : size;
    if (bits && is_depth) {
        bits[4] = size;
        bits[5] = image->base_format == GL_DEPTH_STENCIL ? 8 : 0;
    }
    attached->texture->cube_is_old = true; /* the caller may draw */
    return gn_surface_bottom_up(image->texels + (size_t)attached->slice * slice_size, image->format,
                                (uint32_t)image->width, (uint32_t)image->height);
}

gn_surface attached_surface(const attachment *attached, unsigned char bits[6])
{
    if (attached->texture)
        return texture_surface(attached, bits);
    if (!attached->renderbuffer || !attached->renderbuffer->kept_as)
        return (gn_surface){0};
    if (bits)
        memcpy(bits, attached->renderbuffer->kept_as->bits, 6);
    return attached->renderbuffer->surface;
}

static bool is_attached(const attachment *attached)
{
    return attached->renderbuffer || attached->texture;
}

/* Whether what is attached at an index may be there. */
static bool is_complete(const attachment *attached, int index)
{
    unsigned char bits[6] = {0};
    const gn_surface surface = attached_surface(attached, bits);

    if (!surface.format)
        return false;
    return index == DEPTH_ATTACHMENT     ? bits[4] != 0
           : index == STENCIL_ATTACHMENT ? bits[5] != 0
                                         : bits[0] != 0;
}

GLenum framebuffer_status(const framebuffer_object *framebuffer)
{
    const attachment *const depth = &framebuffer->attached[DEPTH_ATTACHMENT];
    const attachment *const stencil = &framebuffer->attached[STENCIL_ATTACHMENT];
    uint32_t samples = 0;
    bool is_empty = true;

    for (int i = 0; i < ATTACHMENTS; ++i) {
        const attachment *const attached = &framebuffer->attached[i];
        uint32_t own;

        if (!is_attached(attached))
            continue;
        if (!is_complete(attached, i))
            return GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT;
        own = attached_surface(attached, NULL).samples;
        if (!is_empty && own != samples)
            return GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE;
        samples = own;
        is_empty = false;
    }
    if (is_empty)
        return GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT;
    if (is_attached(depth) && is_attached(stencil) && depth->renderbuffer != stencil->renderbuffer)
        return GL_FRAMEBUFFER_UNSUPPORTED;
    return GL_FRAMEBUFFER_COMPLETE;
}

/* Functions */

void glGenFramebuffers(GLsizei count, GLuint *names)
{
    context *const gl = enter(__func__);

    if (gl)
        generate_names(gl, gl->shared->framebuffers, count, names, __func__);
}

/* Takes a framebuffer, whose name still holds a reference, from where it is bound. */
static void unbind(framebuffer_object **place, framebuffer_object *framebuffer)
{
    if (*place != framebuffer)
        return;
    *place = NULL;
    --framebuffer->references;
}

void glDeleteFramebuffers(GLsizei count, const GLuint *names)
{
    context *const gl = enter(__func__);

    if (!gl || !is_count(gl, count, __func__))
        return;
    for (GLsizei i = 0; i < count; ++i) {
        framebuffer_object *const framebuffer = remove_name(gl->shared->framebuffers, names[i]);

        if (!framebuffer)
            continue;
        unbind(&gl->draw_framebuffer, framebuffer);
        unbind(&gl->read_framebuffer, framebuffer);
        release_framebuffer(framebuffer);
    }
}

GLboolean glIsFramebuffer(GLuint name)
{
    context *const gl = enter(__func__);

    return gl && find_object(gl->shared->framebuffers, name) != NULL;
}

static framebuffer_object *create_framebuffer(context *gl, GLuint name)
{
    framebuffer_object *const framebuffer = calloc(1, sizeof *framebuffer);

    if (!framebuffer || !set_object(gl->shared->framebuffers, name, framebuffer)) {
        free(framebuffer);
        return NULL;
    }
    framebuffer->references = 1;
    framebuffer->name = name;
    framebuffer->draw_buffer[0] = framebuffer->read_buffer = GL_COLOR_ATTACHMENT0;
    return framebuffer;
}

void glBindFramebuffer(GLenum target, GLuint name)
{
    context *const gl = enter(__func__);
    framebuffer_object *framebuffer;

    if (!gl)
        return;
    if (target != GL_FRAMEBUFFER && target != GL_DRAW_FRAMEBUFFER &&
        target != GL_READ_FRAMEBUFFER) {
        gl_error(gl, GL_INVALID_ENUM, __func__);
        return;
    }
    framebuffer = name ? find_object(gl->shared->framebuffers, name) : NULL;
    if (name && !framebuffer)
        framebuffer = create_framebuffer(gl, name);
    if (name && !framebuffer) {
        gl_error(gl, GL_OUT_OF_MEMORY, __func__);
        return;
    }
    if (target != GL_READ_FRAMEBUFFER)
        refer_to_framebuffer(&gl->draw_framebuffer, framebuffer);
    if (target != GL_DRAW_FRAMEBUFFER)
        refer_to_framebuffer(&gl->read_framebuffer, framebuffer);
}

/* Finds the framebuffer that is bound to a target, null for the window. Returns false, with an
 * error, for another target. */
static bool find_bound(context *gl, GLenum target, framebuffer_object **framebuffer,
                       const char *function)
{
    if (target != GL_FRAMEBUFFER && target != GL_DRAW_FRAMEBUFFER &&
        target != GL_READ_FRAMEBUFFER) {
        gl_error(gl, GL_INVALID_ENUM, function);
        return false;
    }
    *framebuffer = target == GL_READ_FRAMEBUFFER ? gl->read_framebuffer : gl->draw_framebuffer;
    return true;
}

GLenum glCheckFramebufferStatus(GLenum target)
{
    context *const gl = enter(__func__);
    framebuffer_object *framebuffer;

    if (!gl || !find_bound(gl, target, &framebuffer, __func__))
        return 0;
    return framebuffer ? framebuffer_status(framebuffer) : GL_FRAMEBUFFER_COMPLETE;
}

/* Whether something can be attached to a framebuffer under a name. Makes errors. */
static bool is_attachable(context *gl, const framebuffer_object *framebuffer, GLenum name,
                          const char *function)
{
    const bool is_window = !framebuffer;

    if (is_window ||
        (name >= GL_COLOR_ATTACHMENT0 + GN_MAX_COLORS && name <= GL_COLOR_ATTACHMENT31)) {
        gl_error(gl, GL_INVALID_OPERATION, function);
        return false;
    }
    if (attachment_index(name) < 0 && name != GL_DEPTH_STENCIL_ATTACHMENT) {
        gl_error(gl, GL_INVALID_ENUM, function);
        return false;
    }
    return true;
}

static void attach(framebuffer_object *framebuffer, GLenum name, const attachment *attached)
{
    const bool is_pair = name == GL_DEPTH_STENCIL_ATTACHMENT;
    const int first = is_pair ? DEPTH_ATTACHMENT : attachment_index(name);

    for (int i = first; i <= first + is_pair; ++i) {
        if (attached->renderbuffer)
            ++attached->renderbuffer->references;
        if (attached->texture)
            ++attached->texture->references;
        detach(&framebuffer->attached[i]);
        framebuffer->attached[i] = *attached;
    }
}

void glFramebufferRenderbuffer(GLenum target, GLenum name, GLenum renderbuffer_target,
                               GLuint buffer)
{
    context *const gl = enter(__func__);
    framebuffer_object *framebuffer;
    attachment attached = {0};

    if (!gl)
        return;
    if (!find_bound(gl, target, &framebuffer, __func__))
        return;
    if (renderbuffer_target != GL_RENDERBUFFER) {
        gl_error(gl, GL_INVALID_ENUM, __func__);
        return;
    }
    attached.renderbuffer = buffer ? find_object(gl->shared->renderbuffers, buffer) : NULL;
    if (buffer && !attached.renderbuffer) {
        gl_error(gl, GL_INVALID_OPERATION, __func__);
    } else if (is_attachable(gl, framebuffer, name, __func__)) {
        const renderbuffer_format *const format =
            attached.renderbuffer ? attached.renderbuffer->kept_as : NULL;

        if (name == GL_DEPTH_STENCIL_ATTACHMENT && format &&
            format->base_format != GL_DEPTH_STENCIL)
            gl_error(gl, GL_INVALID_OPERATION, __func__);
        else
            attach(framebuffer, name, &attached);
    }
}

static bool is_cube_face(GLenum target)
{
    return target >= GL_TEXTURE_CUBE_MAP_POSITIVE_X && target <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z;
}

static bool is_image_target(GLenum target)
{
    return target == GL_TEXTURE_1D || target == GL_TEXTURE_2D || target == GL_TEXTURE_3D ||
           target == GL_TEXTURE_RECTANGLE || target == GL_TEXTURE_CUBE_MAP || is_cube_face(target);
}

/* Attaches a part of a texture, whose name is in `texture`, if its target is `texture_target` and
 * the function has that target, `expected`. */
static void attach_texture(const char *function, GLenum target, GLenum name, GLenum texture_target,
                           GLenum expected, GLuint texture, GLint level, GLint slice)
{
    const bool is_face = is_cube_face(texture_target);
    context *const gl = enter(function);
    framebuffer_object *framebuffer;
    attachment attached = {0};

    if (!gl || !find_bound(gl, target, &framebuffer, function))
        return;
    attached.texture = texture ? find_object(gl->shared->textures, texture) : NULL;
    if (attached.texture && !is_image_target(texture_target)) {
        gl_error(gl, GL_INVALID_ENUM, function);
        return;
    }
    if (texture && (!attached.texture || texture_target != expected ||
                    attached.texture->target != (is_face ? GL_TEXTURE_CUBE_MAP : texture_target))) {
        gl_error(gl, GL_INVALID_OPERATION, function);
        return;
    }
    if (texture && (level < 0 || level >= GN_MAX_LEVELS || slice < 0 ||
                    greatest_size(attached.texture->target) >> level == 0 ||
                    slice >= greatest_size(attached.texture->target))) {
        gl_error(gl, GL_INVALID_VALUE, function);
        return;
    }
    if (texture) {
        attached.level = level;
        attached.slice = slice;
        attached.face = is_face ? (GLint)(texture_target - GL_TEXTURE_CUBE_MAP_POSITIVE_X) : 0;
    }
    if (is_attachable(gl, framebuffer, name, function))
        attach(framebuffer, name, &attached);
}

void glFramebufferTexture1D(GLenum target, GLenum name, GLenum texture_target, GLuint texture,
                            GLint level)
{
    attach_texture(__func__, target, name, texture_target, GL_TEXTURE_1D, texture, level, 0);
}

void glFramebufferTexture2D(GLenum target, GLenum name, GLenum texture_target, GLuint texture,
                            GLint level)
{
    attach_texture(__func__, target, name, texture_target,
                   is_cube_face(texture_target) ? texture_target : GL_TEXTURE_2D, texture, level,
                   0);
}

void glFramebufferTexture3D(GLenum target, GLenum name, GLenum texture_target, GLuint texture,
                            GLint level, GLint slice)
{
    attach_texture(__func__, target, name, texture_target, GL_TEXTURE_3D, texture, level, slice);
}

/* The layers of a cube are its faces. The reference looks at the attachment before the layer. */
void glFramebufferTextureLayer(GLenum target, GLenum name, GLuint texture, GLint level, GLint layer)
{
    context *const gl = enter(__func__);
    const texture_object *const object =
        gl && texture ? find_object(gl->shared->textures, texture) : NULL;
    const bool is_cube = object && object->target == GL_TEXTURE_CUBE_MAP;
    const GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X + (GLenum)layer;
    framebuffer_object *framebuffer;

    if (!gl || !find_bound(gl, target, &framebuffer, __func__))
        return;
    if (texture && !object)
        gl_error(gl, GL_INVALID_OPERATION, __func__);
    else if (!is_attachable(gl, framebuffer, name, __func__))
        return;
    else if (is_cube && !is_cube_face(face))
        gl_error(gl, GL_INVALID_VALUE, __func__);
    else if (is_cube)
        attach_texture(__func__, target, name, face, face, texture, level, 0);
    else
        attach_texture(__func__, target, name, GL_TEXTURE_3D, GL_TEXTURE_3D, texture, level, layer);
}
