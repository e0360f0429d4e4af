/* Calls of evaluators with random arguments, and of what they draw. */
#include "state_calls.h"

/* Maps of curves and of surfaces, and a wrong one. */
static GLenum map_target(GLint i)
{
    const GLenum target = (i & 16 ? GL_MAP2_COLOR_4 : GL_MAP1_COLOR_4) + (GLenum)(i & 15) % 9;

    return i & 0xC0 ? target : 12345;
}

enum { POINTS = 31 * 31 * 5 * 5 };

static const GLfloat *floats_of(const arguments *a)
{
    static GLfloat points[POINTS];

    for (int i = 0; i < POINTS; ++i)
        points[i] = a->f[i % 16] + (GLfloat)(i % 7);
    return points;
}

static const GLdouble *doubles_of(const arguments *a)
{
    static GLdouble points[POINTS];

    for (int i = 0; i < POINTS; ++i)
        points[i] = a->d[i % 16] + (GLdouble)(i % 7);
    return points;
}

/* 1 to 4 mostly; or wrong ones. */
static GLint order_of(GLint i)
{
    return i & 7 ? 1 + (i >> 3 & 3) : (i >> 3 & 31);
}

static GLenum switch_of(GLint i)
{
    return i & 3 ? map_target(i >> 2 | 64) : GL_AUTO_NORMAL;
}

/* Sets all attributes that maps set. In the reference, evaluators lose the current values of
 * those. */
static void set_current_values(const library *gl, const arguments *a)
{
    gl->Color4f(a->f[4], a->f[5], a->f[6], a->f[7]);
    gl->Normal3f(a->f[8], a->f[9], a->f[10]);
    gl->TexCoord4f(a->f[11], a->f[12], a->f[13], a->f[14]);
}

void call_evaluators(const library *gl, unsigned kind, const arguments *a)
{
    const GLint *const i = a->i;
    const GLfloat *const f = a->f;
    const GLdouble *const d = a->d;
    const GLint order = order_of(i[1]), other = order_of(i[2]);
    const GLint stride = i[3] & 15 ? 4 : i[3] >> 4 & 3;

    if (kind >= 8 && kind <= 10)
        set_current_values(gl, a);
    switch (kind) {
    case 0:
        gl->Map1f(map_target(i[0]), f[0], i[3] & 0x700 ? f[1] : f[0], stride, order, floats_of(a));
        break;
    case 1:
        gl->Map1d(map_target(i[0]), d[0], d[1], stride, order, doubles_of(a));
        break;
    case 2:
        gl->Map2f(map_target(i[0]), f[0], f[1], stride * 32, order, f[2],
                  i[3] & 0x700 ? f[3] : f[2], stride, other, floats_of(a));
        break;
    case 3:
        gl->Map2d(map_target(i[0]), d[0], d[1], stride, order, d[2], d[3], stride * 32, other,
                  doubles_of(a));
        break;
    case 4:
        gl->MapGrid1f(i[0] & 15, f[0], f[1]);
        break;
    case 5:
        gl->MapGrid1d(i[0], d[0], d[1]);
        break;
    case 6:
        gl->MapGrid2f(i[0] & 15, f[0], f[1], i[1] & 15, f[2], f[3]);
        break;
    case 7:
        gl->MapGrid2d(i[0], d[0], d[1], i[1], d[2], d[3]);
        break;
    case 8:
        gl->EvalMesh1(i[0] & 1 ? GL_LINE : i[0] & 2 ? GL_POINT : a->e[0], i[1] & 7, i[2] & 15);
        break;
    case 9:
        gl->EvalMesh2(i[0] & 1   ? GL_LINE
                      : i[0] & 2 ? GL_FILL
                      : i[0] & 4 ? GL_POINT
                                 : a->e[0],
                      i[1] & 7, i[2] & 15, i[1] >> 3 & 7, i[2] >> 4 & 7);
        break;
    case 10:
        gl->Begin(i[0] & 1 ? GL_QUAD_STRIP : GL_POINTS);
        gl->EvalCoord1f(f[0]);
        gl->EvalCoord1d(d[0]);
        gl->EvalPoint1(i[1]);
        gl->EvalCoord2f(f[0], f[1]);
        gl->EvalCoord2d(d[0], d[1]);
        gl->EvalPoint2(i[1], i[2]);
        if (i[0] & 2)
            gl->MapGrid1f(3, f[0], f[1]); /* an error */
        if (i[0] & 4)
            gl->EvalMesh1(GL_POINT, 0, 1);
        gl->End();
        break;
    default:
        i[0] & 1 ? gl->Enable(switch_of(i[1])) : gl->Disable(switch_of(i[1]));
        break;
    }
    if (kind >= 8 && kind <= 10)
        set_current_values(gl, a);
}
