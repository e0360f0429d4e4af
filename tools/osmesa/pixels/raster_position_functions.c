/* glRasterPos and glWindowPos, for every type and number of components (OpenGL 2.1 section 2.13).
 */
#include <gl_registry.h>

#include "raster_position.h"

static void set_from_vertex(const char *function, GLfloat x, GLfloat y, GLfloat z, GLfloat w)
{
    context *const gl = enter(function);

    if (gl)
        set_raster_position(gl, (GLfloat[4]){x, y, z, w});
}

static void set_in_window(const char *function, GLfloat x, GLfloat y, GLfloat z)
{
    context *const gl = enter(function);

    if (gl)
        set_window_position(gl, x, y, z);
}

#define EACH_NUMBER_TYPE(X) X(d, GLdouble) X(f, GLfloat) X(i, GLint) X(s, GLshort)

#define RASTER_POSITION(letter, type)                                                              \
    void glRasterPos2##letter(type x, type y)                                                      \
    {                                                                                              \
        set_from_vertex(__func__, (GLfloat)x, (GLfloat)y, 0.0f, 1.0f);                             \
    }                                                                                              \
    void glRasterPos3##letter(type x, type y, type z)                                              \
    {                                                                                              \
        set_from_vertex(__func__, (GLfloat)x, (GLfloat)y, (GLfloat)z, 1.0f);                       \
    }                                                                                              \
    void glRasterPos4##letter(type x, type y, type z, type w)                                      \
    {                                                                                              \
        set_from_vertex(__func__, (GLfloat)x, (GLfloat)y, (GLfloat)z, (GLfloat)w);                 \
    }                                                                                              \
    void glRasterPos2##letter##v(const type *v)                                                    \
    {                                                                                              \
        glRasterPos2##letter(v[0], v[1]);                                                          \
    }                                                                                              \
    void glRasterPos3##letter##v(const type *v)                                                    \
    {                                                                                              \
        glRasterPos3##letter(v[0], v[1], v[2]);                                                    \
    }                                                                                              \
    void glRasterPos4##letter##v(const type *v)                                                    \
    {                                                                                              \
        glRasterPos4##letter(v[0], v[1], v[2], v[3]);                                              \
    }

EACH_NUMBER_TYPE(RASTER_POSITION)

#define WINDOW_POSITION(letter, type)                                                              \
    void glWindowPos2##letter(type x, type y)                                                      \
    {                                                                                              \
        set_in_window(__func__, (GLfloat)x, (GLfloat)y, 0.0f);                                     \
    }                                                                                              \
    void glWindowPos3##letter(type x, type y, type z)                                              \
    {                                                                                              \
        set_in_window(__func__, (GLfloat)x, (GLfloat)y, (GLfloat)z);                               \
    }                                                                                              \
    void glWindowPos2##letter##v(const type *v)                                                    \
    {                                                                                              \
        glWindowPos2##letter(v[0], v[1]);                                                          \
    }                                                                                              \
    void glWindowPos3##letter##v(const type *v)                                                    \
    {                                                                                              \
        glWindowPos3##letter(v[0], v[1], v[2]);                                                    \
    }

EACH_NUMBER_TYPE(WINDOW_POSITION)
