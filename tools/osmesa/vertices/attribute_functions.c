/* glVertex, glColor and the like, for every type and number of components. Integers of colours and
 * normals become fractions as OpenGL 2.1 table 2.9 says. */
#include <gl_registry.h>

#include "../context/gl_errors.h"
#include "immediate.h"

/* The functions' letters, their types, and how a value becomes a float or a fraction. */
#define FLOAT_OF(x) ((GLfloat)(x))
#define BYTE_FRACTION(x) ((2.0f * (GLfloat)(x) + 1.0f) * (1.0f / 255.0f))
#define SHORT_FRACTION(x) ((2.0f * (GLfloat)(x) + 1.0f) * (1.0f / 65535.0f))
#define UBYTE_FRACTION(x) ((GLfloat)(x) / 255.0f)
#define USHORT_FRACTION(x) ((GLfloat)(x) * (1.0f / 65535.0f))
#define UINT_FRACTION(x) ((GLfloat)((GLdouble)(x) * (1.0 / 4294967295.0)))

#define EACH_NUMBER_TYPE(X)                                                                        \
    X(d, GLdouble, FLOAT_OF) X(f, GLfloat, FLOAT_OF) X(i, GLint, FLOAT_OF) X(s, GLshort, FLOAT_OF)
#define EACH_NORMAL_TYPE(X)                                                                        \
    X(b, GLbyte, BYTE_FRACTION)                                                                    \
    X(d, GLdouble, FLOAT_OF)                                                                       \
    X(f, GLfloat, FLOAT_OF) X(i, GLint, fraction_of_int) X(s, GLshort, SHORT_FRACTION)
#define EACH_COLOR_TYPE(X)                                                                         \
    EACH_NORMAL_TYPE(X)                                                                            \
    X(ub, GLubyte, UBYTE_FRACTION) X(ui, GLuint, UINT_FRACTION) X(us, GLushort, USHORT_FRACTION)

#define VERTEX(letter, type, convert)                                                              \
    void glVertex2##letter(type x, type y)                                                         \
    {                                                                                              \
        add_vertex(2, (GLfloat)x, (GLfloat)y, 0.0f, 1.0f);                                         \
    }                                                                                              \
    void glVertex3##letter(type x, type y, type z)                                                 \
    {                                                                                              \
        add_vertex(3, (GLfloat)x, (GLfloat)y, (GLfloat)z, 1.0f);                                   \
    }                                                                                              \
    void glVertex4##letter(type x, type y, type z, type w)                                         \
    {                                                                                              \
        add_vertex(4, (GLfloat)x, (GLfloat)y, (GLfloat)z, (GLfloat)w);                             \
    }                                                                                              \
    void glVertex2##letter##v(const type *v)                                                       \
    {                                                                                              \
        glVertex2##letter(v[0], v[1]);                                                             \
    }                                                                                              \
    void glVertex3##letter##v(const type *v)                                                       \
    {                                                                                              \
        glVertex3##letter(v[0], v[1], v[2]);                                                       \
    }                                                                                              \
    void glVertex4##letter##v(const type *v)                                                       \
    {                                                                                              \
        glVertex4##letter(v[0], v[1], v[2], v[3]);                                                 \
    }

EACH_NUMBER_TYPE(VERTEX)

#define COLOR_(letter, type, convert)                                                              \
    void glColor3##letter(type r, type g, type b)                                                  \
    {                                                                                              \
        set_attribute(COLOR, 0, 4, 3, (GLfloat[4]){convert(r), convert(g), convert(b), 1.0f});     \
    }                                                                                              \
    void glColor4##letter(type r, type g, type b, type a)                                          \
    {                                                                                              \
        set_attribute(COLOR, 0, 4, 4,                                                              \
                      (GLfloat[4]){convert(r), convert(g), convert(b), convert(a)});               \
    }                                                                                              \
    void glSecondaryColor3##letter(type r, type g, type b)                                         \
    {                                                                                              \
        set_attribute(SECONDARY_AND_FOG, 0, 3, 3,                                                  \
                      (GLfloat[3]){convert(r), convert(g), convert(b)});                           \
    }                                                                                              \
    void glColor3##letter##v(const type *v)                                                        \
    {                                                                                              \
        glColor3##letter(v[0], v[1], v[2]);                                                        \
    }                                                                                              \
    void glColor4##letter##v(const type *v)                                                        \
    {                                                                                              \
        glColor4##letter(v[0], v[1], v[2], v[3]);                                                  \
    }                                                                                              \
    void glSecondaryColor3##letter##v(const type *v)                                               \
    {                                                                                              \
        glSecondaryColor3##letter(v[0], v[1], v[2]);                                               \
    }

EACH_COLOR_TYPE(COLOR_)

#define NORMAL_(letter, type, convert)                                                             \
    void glNormal3##letter(type x, type y, type z)                                                 \
    {                                                                                              \
        set_attribute(NORMAL, 0, 3, 3, (GLfloat[3]){convert(x), convert(y), convert(z)});          \
    }                                                                                              \
    void glNormal3##letter##v(const type *v)                                                       \
    {                                                                                              \
        glNormal3##letter(v[0], v[1], v[2]);                                                       \
    }

EACH_NORMAL_TYPE(NORMAL_)

static void set_coordinates(int size, GLenum unit, GLfloat s, GLfloat t, GLfloat r, GLfloat q)
{
    if (unit - GL_TEXTURE0 < TEXTURE_UNITS)
        set_attribute((enum attribute_name)(TEXTURE_COORDINATE + unit - GL_TEXTURE0), 0, 4, size,
                      (GLfloat[4]){s, t, r, q});
}

#define COORDINATES(letter, type, convert)                                                         \
    void glMultiTexCoord1##letter(GLenum unit, type s)                                             \
    {                                                                                              \
        set_coordinates(1, unit, (GLfloat)s, 0.0f, 0.0f, 1.0f);                                    \
    }                                                                                              \
    void glMultiTexCoord2##letter(GLenum unit, type s, type t)                                     \
    {                                                                                              \
        set_coordinates(2, unit, (GLfloat)s, (GLfloat)t, 0.0f, 1.0f);                              \
    }                                                                                              \
    void glMultiTexCoord3##letter(GLenum unit, type s, type t, type r)                             \
    {                                                                                              \
        set_coordinates(3, unit, (GLfloat)s, (GLfloat)t, (GLfloat)r, 1.0f);                        \
    }                                                                                              \
    void glMultiTexCoord4##letter(GLenum unit, type s, type t, type r, type q)                     \
    {                                                                                              \
        set_coordinates(4, unit, (GLfloat)s, (GLfloat)t, (GLfloat)r, (GLfloat)q);                  \
    }                                                                                              \
    void glMultiTexCoord1##letter##v(GLenum unit, const type *v)                                   \
    {                                                                                              \
        glMultiTexCoord1##letter(unit, v[0]);                                                      \
    }                                                                                              \
    void glMultiTexCoord2##letter##v(GLenum unit, const type *v)                                   \
    {                                                                                              \
        glMultiTexCoord2##letter(unit, v[0], v[1]);                                                \
    }                                                                                              \
    void glMultiTexCoord3##letter##v(GLenum unit, const type *v)                                   \
    {                                                                                              \
        glMultiTexCoord3##letter(unit, v[0], v[1], v[2]);                                          \
    }                                                                                              \
    void glMultiTexCoord4##letter##v(GLenum unit, const type *v)                                   \
    {                                                                                              \
        glMultiTexCoord4##letter(unit, v[0], v[1], v[2], v[3]);                                    \
    }                                                                                              \
    void glTexCoord1##letter(type s)                                                               \
    {                                                                                              \
        glMultiTexCoord1##letter(GL_TEXTURE0, s);                                                  \
    }                                                                                              \
    void glTexCoord2##letter(type s, type t)                                                       \
    {                                                                                              \
        glMultiTexCoord2##letter(GL_TEXTURE0, s, t);                                               \
    }                                                                                              \
    void glTexCoord3##letter(type s, type t, type r)                                               \
    {                                                                                              \
        glMultiTexCoord3##letter(GL_TEXTURE0, s, t, r);                                            \
    }                                                                                              \
    void glTexCoord4##letter(type s, type t, type r, type q)                                       \
    {                                                                                              \
        glMultiTexCoord4##letter(GL_TEXTURE0, s, t, r, q);                                         \
    }                                                                                              \
    void glTexCoord1##letter##v(const type *v)                                                     \
    {                                                                                              \
        glTexCoord1##letter(v[0]);                                                                 \
    }                                                                                              \
    void glTexCoord2##letter##v(const type *v)                                                     \
    {                                                                                              \
        glTexCoord2##letter(v[0], v[1]);                                                           \
    }                                                                                              \
    void glTexCoord3##letter##v(const type *v)                                                     \
    {                                                                                              \
        glTexCoord3##letter(v[0], v[1], v[2]);                                                     \
    }                                                                                              \
    void glTexCoord4##letter##v(const type *v)                                                     \
    {                                                                                              \
        glTexCoord4##letter(v[0], v[1], v[2], v[3]);                                               \
    }

EACH_NUMBER_TYPE(COORDINATES)

void glFogCoordf(GLfloat coordinate)
{
    set_attribute(SECONDARY_AND_FOG, 3, 1, 1, &coordinate);
}

void glFogCoordd(GLdouble coordinate)
{
    glFogCoordf((GLfloat)coordinate);
}

void glFogCoordfv(const GLfloat *v)
{
    glFogCoordf(v[0]);
}

void glFogCoorddv(const GLdouble *v)
{
    glFogCoordf((GLfloat)v[0]);
}

void glEdgeFlag(GLboolean flag)
{
    context *const gl = current_context();

    if (gl)
        gl->current.edge_flag = flag != 0;
}

void glEdgeFlagv(const GLboolean *v)
{
    glEdgeFlag(v[0]);
}

#define INDEX_(letter, type)                                                                       \
    void glIndex##letter(type index)                                                               \
    {                                                                                              \
        context *const gl = current_context();                                                     \
                                                                                                   \
        if (gl)                                                                                    \
            gl->current.index = (GLfloat)index;                                                    \
    }                                                                                              \
    void glIndex##letter##v(const type *v)                                                         \
    {                                                                                              \
        glIndex##letter(v[0]);                                                                     \
    }

INDEX_(d, GLdouble)
INDEX_(f, GLfloat)
INDEX_(i, GLint)
INDEX_(s, GLshort)
INDEX_(ub, GLubyte)

/* Rectangles are quads (section 2.10). */

void glRectf(GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2)
{
    if (!enter(__func__))
        return;
    glBegin(GL_QUADS);
    glVertex2f(x1, y1);
    glVertex2f(x2, y1);
    glVertex2f(x2, y2);
    glVertex2f(x1, y2);
    glEnd();
}

#define RECTANGLE_OF_VECTORS(letter, type)                                                         \
    void glRect##letter##v(const type *v1, const type *v2)                                         \
    {                                                                                              \
        glRectf((GLfloat)v1[0], (GLfloat)v1[1], (GLfloat)v2[0], (GLfloat)v2[1]);                   \
    }
#define RECTANGLE(letter, type)                                                                    \
    void glRect##letter(type x1, type y1, type x2, type y2)                                        \
    {                                                                                              \
        glRectf((GLfloat)x1, (GLfloat)y1, (GLfloat)x2, (GLfloat)y2);                               \
    }                                                                                              \
    RECTANGLE_OF_VECTORS(letter, type)

RECTANGLE(d, GLdouble)
RECTANGLE(i, GLint)
RECTANGLE(s, GLshort)
RECTANGLE_OF_VECTORS(f, GLfloat)
