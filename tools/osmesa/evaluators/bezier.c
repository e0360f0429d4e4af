/* Evaluates Bezier curves and surfaces: points by Horner's scheme, tangents by de Casteljau's
 * algorithm (G. Farin, Curves and Surfaces for CAGD, chapters 5 and 14). */
#include "bezier.h"

void bezier_curve(const GLfloat *points, int step, int components, int order, GLfloat t,
                  GLfloat *out)
{
    const GLfloat s = 1.0f - t;
    GLfloat binomial = (GLfloat)(order - 1), power = t;

    for (int c = 0; c < components; ++c)
        out[c] = points[c];
    for (int i = 1; i < order; ++i) {
        if (i > 1) {
            binomial *= (GLfloat)(order - i);
            binomial *= 1.0f / (GLfloat)i;
            power *= t;
        }
        for (int c = 0; c < components; ++c)
            out[c] = s * out[c] + binomial * power * points[i * step + c];
    }
}

void bezier_point(const bezier_surface *surface, GLfloat u, GLfloat v, GLfloat *out)
{
    const int n = surface->components, columns = surface->order[1];
    GLfloat curve[MOST_ORDER * MOST_COMPONENTS];

    if (columns > surface->order[0]) {
        for (int j = 0; j < columns; ++j)
            bezier_curve(surface->points + j * n, columns * n, n, surface->order[0], u,
                         curve + j * n);
        bezier_curve(curve, n, n, columns, v, out);
        return;
    }
    for (int i = 0; i < surface->order[0]; ++i)
        bezier_curve(surface->points + i * columns * n, n, n, columns, v, curve + i * n);
    bezier_curve(curve, n, n, surface->order[0], u, out);
}

/* One component of the control points, which steps of de Casteljau's algorithm make fewer. */
typedef struct control_net {
    int order[2]; /* 2 or more */
    GLfloat value[MOST_ORDER][MOST_ORDER];
} control_net;

/* A component of a point and of the derivatives there. */
typedef struct tangent {
    GLfloat value, du, dv;
} tangent;

static GLfloat between(GLfloat a, GLfloat b, GLfloat t)
{
    return (1.0f - t) * a + t * b;
}

/* A direction of one control point gets a second one, which is equal to it. */
static void fill_net(control_net *net, const bezier_surface *surface, int component)
{
    const int *const order = surface->order;

    for (int k = 0; k < 2; ++k)
        net->order[k] = order[k] > 1 ? order[k] : 2;
    for (int i = 0; i < net->order[0]; ++i)
        for (int j = 0; j < net->order[1]; ++j) {
            const int row = i < order[0] ? i : 0, column = j < order[1] ? j : 0;

            net->value[i][j] =
                surface->points[(row * order[1] + column) * surface->components + component];
        }
}

/* Takes one point from each direction. */
static void reduce_both(control_net *net, GLfloat u, GLfloat v)
{
    GLfloat(*const p)[MOST_ORDER] = net->value;

    --net->order[0];
    --net->order[1];
    for (int i = 0; i < net->order[0]; ++i)
        for (int j = 0; j < net->order[1]; ++j)
            p[i][j] = between(between(p[i][j], p[i + 1][j], u),
                              between(p[i][j + 1], p[i + 1][j + 1], u), v);
}

static tangent tangent_of_four(const control_net *net, GLfloat u, GLfloat v)
{
    const GLfloat(*const p)[MOST_ORDER] = net->value;

    return (tangent){.value =
                         between(between(p[0][0], p[0][1], v), between(p[1][0], p[1][1], v), u),
                     .du = between(p[1][0] - p[0][0], p[1][1] - p[0][1], v),
                     .dv = between(p[0][1] - p[0][0], p[1][1] - p[1][0], u)};
}

/* Returns the tangent where two rows of `count` points are left, or two columns if `is_column`: the
 * position between both is `across`, that along them is `along`. */
static tangent tangent_of_two(const control_net *net, bool is_column, GLfloat across, GLfloat along)
{
    const int count = net->order[is_column ? 0 : 1];
    GLfloat middle[MOST_ORDER], change[MOST_ORDER];
    GLfloat derivative_along, derivative_across;

    for (int i = 0; i < count; ++i) {
        const GLfloat a = net->value[is_column ? i : 0][is_column ? 0 : i];
        const GLfloat b = net->value[is_column ? i : 1][is_column ? 1 : i];

        middle[i] = between(a, b, across);
        change[i] = b - a;
    }
    for (int left = count - 1; left >= 2; --left)
        for (int i = 0; i < left; ++i) {
            middle[i] = between(middle[i], middle[i + 1], along);
            change[i] = between(change[i], change[i + 1], along);
        }
    derivative_along = middle[1] - middle[0];
    derivative_across = between(change[0], change[1], along);
    return (tangent){.value = between(middle[0], middle[1], along),
                     .du = is_column ? derivative_along : derivative_across,
                     .dv = is_column ? derivative_across : derivative_along};
}

void bezier_tangents(const bezier_surface *surface, GLfloat u, GLfloat v, GLfloat *out, GLfloat *du,
                     GLfloat *dv)
{
    for (int c = 0; c < surface->components; ++c) {
        control_net net;
        tangent t;

        fill_net(&net, surface, c);
        while (net.order[0] > 2 && net.order[1] > 2)
            reduce_both(&net, u, v);
        if (net.order[0] == net.order[1])
            t = tangent_of_four(&net, u, v);
        else if (net.order[0] == 2)
            t = tangent_of_two(&net, false, u, v);
        else
            t = tangent_of_two(&net, true, v, u);
        out[c] = t.value;
        du[c] = t.du;
        dv[c] = t.dv;
    }
}
