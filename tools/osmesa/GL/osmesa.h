/* OSMesa: OpenGL that draws into the program's own memory. The interface is that of Mesa's
 * off-screen library (version 11.2); this library implements it with Gnomon.
 *
 *     static GLubyte pixels[HEIGHT][WIDTH][4];
 *     OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
 *     OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, WIDTH, HEIGHT);
 *     ... draw with OpenGL ...
 *     glFinish();                      // now the pixels are there
 *     OSMesaDestroyContext(context); */
#ifndef OSMESA_H
#define OSMESA_H

#ifndef GL_VERSION_1_1
#include <GL/gl.h>
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define OSMESA_MAJOR_VERSION 11
#define OSMESA_MINOR_VERSION 2
#define OSMESA_PATCH_VERSION 0

/* The channels of a pixel, in the order in which they lie in memory. */
#define OSMESA_COLOR_INDEX GL_COLOR_INDEX
#define OSMESA_RGBA GL_RGBA
#define OSMESA_BGRA 0x1
#define OSMESA_ARGB 0x2
#define OSMESA_RGB GL_RGB
#define OSMESA_BGR 0x4
#define OSMESA_RGB_565 0x5

/* Parameters of OSMesaPixelStore. */
#define OSMESA_ROW_LENGTH 0x10 /* pixels from row to row; 0: the width */
#define OSMESA_Y_UP 0x11       /* nonzero, as at first: the bottom row lies first in memory */

/* Parameters of OSMesaGetIntegerv. */
#define OSMESA_WIDTH 0x20
#define OSMESA_HEIGHT 0x21
#define OSMESA_FORMAT 0x22 /* also an attribute of contexts */
#define OSMESA_TYPE 0x23
#define OSMESA_MAX_WIDTH 0x24
#define OSMESA_MAX_HEIGHT 0x25

/* Attributes of OSMesaCreateContextAttribs: pairs of name and value, ended by 0. */
#define OSMESA_DEPTH_BITS 0x30
#define OSMESA_STENCIL_BITS 0x31
#define OSMESA_ACCUM_BITS 0x32
#define OSMESA_PROFILE 0x33
#define OSMESA_CORE_PROFILE 0x34
#define OSMESA_COMPAT_PROFILE 0x35
#define OSMESA_CONTEXT_MAJOR_VERSION 0x36
#define OSMESA_CONTEXT_MINOR_VERSION 0x37

typedef struct osmesa_context *OSMesaContext;
typedef void (*OSMESAproc)(void);

/* Creates a context with a depth buffer of 24 bits and a stencil buffer of 8 bits. Contexts share
 * textures and buffer objects with `sharelist`, if that is not null. Returns null if the format is
 * not supported or memory is short. */
GLAPI OSMesaContext GLAPIENTRY OSMesaCreateContext(GLenum format, OSMesaContext sharelist);

/* Creates a context with at least as many bits of depth and stencil; 0: none. */
GLAPI OSMesaContext GLAPIENTRY OSMesaCreateContextExt(GLenum format, GLint depthBits,
                                                      GLint stencilBits, GLint accumBits,
                                                      OSMesaContext sharelist);

/* Creates a context by a list of attributes. Returns null for OSMESA_CORE_PROFILE and for versions
 * of OpenGL beyond 2.1, since there is no shading language. */
GLAPI OSMesaContext GLAPIENTRY OSMesaCreateContextAttribs(const int *attribList,
                                                          OSMesaContext sharelist);

GLAPI void GLAPIENTRY OSMesaDestroyContext(OSMesaContext context);

/* Makes a context current in the calling thread, and binds it to the program's memory. The type is
 * GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT_5_6_5 (with OSMESA_RGB_565), GL_UNSIGNED_SHORT, GL_HALF_FLOAT
 * or GL_FLOAT. Returns GL_FALSE if the arguments are not valid. Null for both pointers releases the
 * current context. */
GLAPI GLboolean GLAPIENTRY OSMesaMakeCurrent(OSMesaContext context, void *buffer, GLenum type,
                                             GLsizei width, GLsizei height);

GLAPI OSMesaContext GLAPIENTRY OSMesaGetCurrentContext(void);

/* Sets how the current context's image lies in memory, from the next OSMesaMakeCurrent or glFinish
 * on. */
GLAPI void GLAPIENTRY OSMesaPixelStore(GLint name, GLint value);

GLAPI void GLAPIENTRY OSMesaGetIntegerv(GLint name, GLint *value);

/* Returns the depth buffer of a context: 2 or 4 bytes a pixel, the bottom row first. */
GLAPI GLboolean GLAPIENTRY OSMesaGetDepthBuffer(OSMesaContext context, GLint *width, GLint *height,
                                                GLint *bytesPerValue, void **buffer);

/* Returns the program's memory that a context was bound to. */
GLAPI GLboolean GLAPIENTRY OSMesaGetColorBuffer(OSMesaContext context, GLint *width, GLint *height,
                                                GLint *format, void **buffer);

/* Returns OpenGL's or OSMesa's function of this name, null for other names. */
GLAPI OSMESAproc GLAPIENTRY OSMesaGetProcAddress(const char *name);

/* Whether colours of vertices and fragments are clamped to 0..1. */
GLAPI void GLAPIENTRY OSMesaColorClamp(GLboolean enable);

/* Mesa's filters of finished images. There are none here. */
GLAPI void GLAPIENTRY OSMesaPostprocess(OSMesaContext context, const char *filter,
                                        unsigned enable_value);

#ifdef __cplusplus
}
#endif

#endif
