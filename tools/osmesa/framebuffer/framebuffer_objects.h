/* Framebuffer objects and renderbuffers (ARB_framebuffer_object; OpenGL 4.5 chapter 9). Contexts
 * that share them count references, as with buffers. */
#ifndef OSMESA_FRAMEBUFFER_OBJECTS_H
#define OSMESA_FRAMEBUFFER_OBJECTS_H

#include "../context/gl_context.h"
#include "../textures/texture_objects.h"

typedef struct renderbuffer_format {
    GLenum internal_format, base_format;
    gn_format format;
    unsigned char bits[6]; /* red, green, blue, alpha, depth, stencil */
} renderbuffer_format;

typedef struct renderbuffer {
    int references;
    GLuint name;
    GLenum internal_format;             /* as the program gave it */
    const renderbuffer_format *kept_as; /* null: no storage yet */
    gn_surface surface;
} renderbuffer;

/* What is attached: a renderbuffer, a part of a texture, or nothing. */
typedef struct attachment {
    renderbuffer *renderbuffer;
    texture_object *texture;
    GLint level;
    GLint face, slice; /* of a cube; of a 3D texture */
} attachment;

enum { DEPTH_ATTACHMENT = GN_MAX_COLORS, STENCIL_ATTACHMENT, ATTACHMENTS };

struct framebuffer_object {
    int references;
    GLuint name;
    attachment attached[ATTACHMENTS]; /* colours, depth, stencil */
    GLenum draw_buffer[GN_MAX_COLORS], read_buffer;
};

/* Drop what an object table held, or a reference. */
void release_renderbuffer(void *renderbuffer);
void release_framebuffer(void *framebuffer);

/* Unbinds the framebuffers and the renderbuffer of a context. */
void unbind_framebuffers(context *gl);

/* Detaches a texture whose name is deleted from the framebuffers that are bound. */
void detach_texture(context *gl, const texture_object *texture);

/* Returns what is attached at an index as a surface, zeroed if nothing is; `bits` are those of its
 * channels, depth and stencil. Null pointers are allowed. */
gn_surface attached_surface(const attachment *attached, unsigned char bits[6]);

/* Returns whether a framebuffer can be drawn to: GL_FRAMEBUFFER_COMPLETE, or why not. */
GLenum framebuffer_status(const framebuffer_object *framebuffer);

/* Returns the index of an attachment by its name, or -1. */
int attachment_index(GLenum name);

#endif
