/* OpenGL's types (OpenGL 4.6 table 2.2). Its enumerations and functions are in gl_registry.h, which
 * registry.py writes. */
#ifndef OSMESA_GL_TYPES_H
#define OSMESA_GL_TYPES_H

#include <stddef.h>
#include <stdint.h>

typedef unsigned int GLenum, GLbitfield, GLuint, GLhandleARB;
typedef unsigned char GLboolean, GLubyte;
typedef void GLvoid;
typedef signed char GLbyte;
typedef short GLshort;
typedef unsigned short GLushort, GLhalf, GLhalfNV, GLhalfARB;
typedef int GLint, GLsizei, GLclampx, GLfixed;
typedef float GLfloat, GLclampf;
typedef double GLdouble, GLclampd;
typedef char GLchar, GLcharARB;
typedef int64_t GLint64, GLint64EXT;
typedef uint64_t GLuint64, GLuint64EXT;
typedef ptrdiff_t GLintptr, GLsizeiptr, GLintptrARB, GLsizeiptrARB, GLvdpauSurfaceNV;
typedef struct gl_sync *GLsync;
typedef void *GLeglImageOES, *GLeglClientBufferEXT;
typedef void (*GLDEBUGPROC)(GLenum, GLenum, GLuint, GLenum, GLsizei, const GLchar *, const void *);
typedef GLDEBUGPROC GLDEBUGPROCARB, GLDEBUGPROCKHR;
typedef void (*GLDEBUGPROCAMD)(GLuint, GLenum, GLenum, GLsizei, const GLchar *, void *);
typedef void (*GLVULKANPROCNV)(void);
struct _cl_context;
struct _cl_event;

/* Returns the fraction that an integer stands for in colours and normals (OpenGL 2.1 table 2.9). */
static inline GLfloat fraction_of_int(GLint value)
{
    return (2.0f * (GLfloat)value + 1.0f) * (1.0f / 4294967294.0f);
}

#endif
