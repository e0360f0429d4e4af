/* Oracle B, in integers of any length. */
#include "clip_triangle.h"

#include <gmp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A function that is linear in window x and y, and its value at the present centre. A centre has
 * halves, so values are doubled: x * (2 * px + 1) + y * (2 * py + 1) + 2 * one. */
typedef struct linear {
    mpz_t x, y, one;
    mpz_t at, step;
} linear;

enum { SIGNS = 5, MOST_CORNERS = 16 }; /* three edges, near, far */

struct clip_triangle {
    linear sign[SIGNS]; /* positive where a centre is covered */
    linear smooth_sum;  /* the sum of the edges */
    linear smooth[EXACT_ATTRIBUTES / 2];
    linear straight[EXACT_ATTRIBUTES / 2];
    mpz_t determinant; /* positive: the sum of edge * w */
    int orientation;   /* of the triangle; 0 if it has no area in the window */
    int attribute_exponent;
    int32_t at[2];
    double viewport[2][2];               /* [axis]: the ends */
    long double corner[MOST_CORNERS][2]; /* what lies in the view volume, in the window */
    int corners;
    long double reach;
    mpz_t row[3][3], position[3][4], attribute[3][EXACT_ATTRIBUTES], scratch[2];
};

static void linear_init(linear *f)
{
    mpz_inits(f->x, f->y, f->one, f->at, f->step, (mpz_ptr)0);
}

static void linear_clear(linear *f)
{
    mpz_clears(f->x, f->y, f->one, f->at, f->step, (mpz_ptr)0);
}

static void for_each_linear(clip_triangle *t, void (*act)(linear *f))
{
    for (int i = 0; i < SIGNS; ++i)
        act(&t->sign[i]);
    act(&t->smooth_sum);
    for (int a = 0; a < EXACT_ATTRIBUTES / 2; ++a) {
        act(&t->smooth[a]);
        act(&t->straight[a]);
    }
}

static void for_each_integer(clip_triangle *t, void (*act)(mpz_ptr z))
{
    act(t->determinant);
    for (int i = 0; i < 3; ++i) {
        for (int c = 0; c < 3; ++c)
            act(t->row[i][c]);
        for (int c = 0; c < 4; ++c)
            act(t->position[i][c]);
        for (int a = 0; a < EXACT_ATTRIBUTES; ++a)
            act(t->attribute[i][a]);
    }
    act(t->scratch[0]);
    act(t->scratch[1]);
}

clip_triangle *clip_triangle_create(void)
{
    clip_triangle *const t = calloc(1, sizeof *t);

    if (t) {
        for_each_linear(t, linear_init);
        for_each_integer(t, mpz_init);
    }
    return t;
}

void clip_triangle_free(clip_triangle *t)
{
    if (t) {
        for_each_linear(t, linear_clear);
        for_each_integer(t, mpz_clear);
    }
    free(t);
}

/* ---- Integers from floats ---- */

/* No exponent of a float or double reaches this. */
#define NO_EXPONENT (1 << 20)

/* Returns the exponent of the last of a number's 53 digits; 0 has none. */
static int last_exponent(double value)
{
    int exponent;

    frexp(value, &exponent);
    return value == 0.0 ? NO_EXPONENT : exponent - 53;
}

static int lesser(int a, int b)
{
    return a < b ? a : b;
}

/* Sets z to value / 2^exponent, which is an integer. */
static void set_scaled(mpz_ptr z, double value, int exponent)
{
    int own;
    const double digits = ldexp(frexp(value, &own), 53);

    mpz_set_d(z, digits);
    if (value != 0.0)
        mpz_mul_2exp(z, z, (mp_bitcnt_t)(own - 53 - exponent));
}

/* ---- Linear functions ---- */

/* f = f + g * factor */
static void add_product(linear *f, const linear *g, mpz_srcptr factor)
{
    mpz_addmul(f->x, g->x, factor);
    mpz_addmul(f->y, g->y, factor);
    mpz_addmul(f->one, g->one, factor);
}

static void set_zero(linear *f)
{
    mpz_set_ui(f->x, 0);
    mpz_set_ui(f->y, 0);
    mpz_set_ui(f->one, 0);
}

/* Sets f to the cross product of two rows: f(x, y) = |(x, y, 1), a, b|. */
static void set_edge(linear *f, mpz_t a[3], mpz_t b[3])
{
    mpz_mul(f->x, a[1], b[2]);
    mpz_submul(f->x, a[2], b[1]);
    mpz_mul(f->y, a[2], b[0]);
    mpz_submul(f->y, a[0], b[2]);
    mpz_mul(f->one, a[0], b[1]);
    mpz_submul(f->one, a[1], b[0]);
}

static void negate(linear *f)
{
    mpz_neg(f->x, f->x);
    mpz_neg(f->y, f->y);
    mpz_neg(f->one, f->one);
}

static void evaluate(linear *f, int32_t x, int32_t y)
{
    mpz_mul_si(f->at, f->x, 2 * (long)x + 1);
    mpz_mul_si(f->step, f->y, 2 * (long)y + 1);
    mpz_add(f->at, f->at, f->step);
    mpz_addmul_ui(f->at, f->one, 2);
    mpz_mul_2exp(f->step, f->x, 1);
}

/* ---- The triangle ---- */

static void set_integers(clip_triangle *t, const clip_vertex vertex[3])
{
    int position = NO_EXPONENT, attribute = NO_EXPONENT;

    for (int i = 0; i < 3; ++i) {
        for (int c = 0; c < 4; ++c)
            position = lesser(position, last_exponent((double)vertex[i].position[c]));
        for (int a = 0; a < EXACT_ATTRIBUTES; ++a)
            attribute = lesser(attribute, last_exponent((double)vertex[i].attribute[a]));
    }
    t->attribute_exponent = attribute;
    for (int i = 0; i < 3; ++i) {
        for (int c = 0; c < 4; ++c)
            set_scaled(t->position[i][c], (double)vertex[i].position[c], position);
        for (int a = 0; a < EXACT_ATTRIBUTES; ++a)
            set_scaled(t->attribute[i][a], (double)vertex[i].attribute[a], attribute);
    }
}

/* Sets the homogeneous window coordinates, times a power of two that makes the viewport's numbers
 * integers too. Sums and halves of the viewport's numbers are exact in double. */
static void set_rows(clip_triangle *t, const gn_viewport *v)
{
    const double scale[2] = {0.5 * (double)v->width, 0.5 * (double)v->height};
    const double translate[2] = {scale[0] + (double)v->x, scale[1] + (double)v->y};
    int exponent = 0;

    for (int c = 0; c < 2; ++c) {
        exponent = lesser(exponent, last_exponent(scale[c]));
        exponent = lesser(exponent, last_exponent(translate[c]));
        t->viewport[c][0] = translate[c] - scale[c];
        t->viewport[c][1] = translate[c] + scale[c];
    }
    for (int c = 0; c < 2; ++c) {
        set_scaled(t->scratch[0], scale[c], exponent);
        set_scaled(t->scratch[1], translate[c], exponent);
        for (int i = 0; i < 3; ++i) {
            mpz_mul(t->row[i][c], t->position[i][c], t->scratch[0]);
            mpz_addmul(t->row[i][c], t->position[i][3], t->scratch[1]);
        }
    }
    for (int i = 0; i < 3; ++i)
        mpz_mul_2exp(t->row[i][2], t->position[i][3], (mp_bitcnt_t)-exponent);
}

/* Sets a half-space of the view volume: the sum of edge * (w + z) or of edge * (w - z). */
static void set_half_space(clip_triangle *t, linear *f, bool near)
{
    set_zero(f);
    for (int i = 0; i < 3; ++i) {
        if (near)
            mpz_add(t->scratch[0], t->position[i][3], t->position[i][2]);
        else
            mpz_sub(t->scratch[0], t->position[i][3], t->position[i][2]);
        add_product(f, &t->sign[i], t->scratch[0]);
    }
}

static void set_values(clip_triangle *t)
{
    mpz_set_ui(t->scratch[0], 1);
    set_zero(&t->smooth_sum);
    for (int i = 0; i < 3; ++i)
        add_product(&t->smooth_sum, &t->sign[i], t->scratch[0]);
    for (int a = 0; a < EXACT_ATTRIBUTES / 2; ++a) {
        set_zero(&t->smooth[a]);
        set_zero(&t->straight[a]);
        for (int i = 0; i < 3; ++i) {
            add_product(&t->smooth[a], &t->sign[i], t->attribute[i][a]);
            mpz_mul(t->scratch[0], t->position[i][3], t->attribute[i][EXACT_ATTRIBUTES / 2 + a]);
            add_product(&t->straight[a], &t->sign[i], t->scratch[0]);
        }
    }
}

/* ---- The polygon of edges, for distances alone ---- */

typedef struct polygon {
    long double v[MOST_CORNERS][4];
    int count;
} polygon;

static long double plane_distance(const long double v[4], int plane)
{
    return plane % 2 ? v[3] - v[plane / 2] : v[3] + v[plane / 2];
}

static void clip_polygon(polygon *p, int plane)
{
    const polygon in = *p;

    p->count = 0;
    for (int i = 0; i < in.count; ++i) {
        const long double *const a = in.v[i], *const b = in.v[(i + 1) % in.count];
        const long double da = plane_distance(a, plane), db = plane_distance(b, plane);

        if (da >= 0.0L)
            memcpy(p->v[p->count++], a, sizeof in.v[i]);
        if ((da < 0.0L) != (db < 0.0L)) {
            for (int c = 0; c < 4; ++c)
                p->v[p->count][c] = (a[c] * db - b[c] * da) / (db - da);
            ++p->count;
        }
    }
}

/* Projects what clipping has left of the triangle. */
static void find_corners(clip_triangle *t, const clip_vertex vertex[3])
{
    const double *const x = t->viewport[0], *const y = t->viewport[1];
    const long double half[2] = {(x[1] - x[0]) / 2.0L, (y[1] - y[0]) / 2.0L};
    const long double middle[2] = {(x[0] + x[1]) / 2.0L, (y[0] + y[1]) / 2.0L};
    long double greatest = 0.0L, least_w = HUGE_VALL;
    polygon p = {.count = 3};

    for (int i = 0; i < 3; ++i) {
        for (int c = 0; c < 4; ++c) {
            p.v[i][c] = (long double)vertex[i].position[c];
            greatest = fmaxl(greatest, fabsl(p.v[i][c]));
        }
    }
    for (int plane = 0; plane < 6; ++plane)
        clip_polygon(&p, plane);
    t->corners = p.count;
    for (int i = 0; i < p.count; ++i) {
        least_w = fminl(least_w, p.v[i][3]);
        for (int c = 0; c < 2; ++c)
            t->corner[i][c] = middle[c] + half[c] * (p.v[i][c] / p.v[i][3]);
    }
    t->reach = fmaxl(half[0], half[1]) * greatest / least_w;
}

void clip_triangle_set(clip_triangle *t, const clip_vertex vertex[3], const gn_viewport *viewport)
{
    set_integers(t, vertex);
    set_rows(t, viewport);
    for (int i = 0; i < 3; ++i)
        set_edge(&t->sign[i], t->row[(i + 1) % 3], t->row[(i + 2) % 3]);
    mpz_mul(t->determinant, t->sign[0].x, t->row[0][0]);
    mpz_addmul(t->determinant, t->sign[0].y, t->row[0][1]);
    mpz_addmul(t->determinant, t->sign[0].one, t->row[0][2]);
    t->orientation = mpz_sgn(t->determinant);
    for (int i = 0; i < 3 && t->orientation < 0; ++i)
        negate(&t->sign[i]);

    /* D in the units of edge * w, in which attributes have it. */
    mpz_set_ui(t->determinant, 0);
    for (int i = 0; i < 3; ++i)
        mpz_addmul(t->determinant, t->sign[i].one, t->position[i][3]);
    set_half_space(t, &t->sign[3], true);
    set_half_space(t, &t->sign[4], false);
    set_values(t);
    find_corners(t, vertex);
}

void clip_triangle_go(clip_triangle *t, int32_t x, int32_t y)
{
    t->at[0] = x;
    t->at[1] = y;
    for (int i = 0; i < SIGNS; ++i)
        evaluate(&t->sign[i], x, y);
}

void clip_triangle_step(clip_triangle *t)
{
    ++t->at[0];
    for (int i = 0; i < SIGNS; ++i)
        mpz_add(t->sign[i].at, t->sign[i].at, t->sign[i].step);
}

int clip_triangle_covers(const clip_triangle *t)
{
    int least = t->orientation ? 1 : -1;

    for (int c = 0; c < 2; ++c) {
        const double centre = t->at[c] + 0.5;

        for (int end = 0; end < 2; ++end) {
            const double inwards = end ? t->viewport[c][1] - centre : centre - t->viewport[c][0];

            least = lesser(least, (inwards > 0.0) - (inwards < 0.0));
        }
    }
    for (int i = 0; i < SIGNS; ++i)
        least = lesser(least, mpz_sgn(t->sign[i].at));
    return least;
}

/* Returns a / (b * 2^exponent). Both are truncated to 53 bits, the ratio is rounded. */
static double ratio(mpz_srcptr a, mpz_srcptr b, long exponent)
{
    long of_a, of_b;
    const double digits_a = mpz_get_d_2exp(&of_a, a);
    const double digits_b = mpz_get_d_2exp(&of_b, b);

    return ldexp(digits_a / digits_b, (int)(of_a - of_b - exponent));
}

/* (a / s)' = (a' * s - a * s') / s^2; a and s are doubled, their derivatives are not. */
static double smooth_slope(clip_triangle *t, const linear *a)
{
    const linear *const sum = &t->smooth_sum;
    double along[2];

    mpz_mul(t->scratch[1], sum->at, sum->at);
    for (int axis = 0; axis < 2; ++axis) {
        mpz_mul(t->scratch[0], axis ? a->y : a->x, sum->at);
        mpz_submul(t->scratch[0], a->at, axis ? sum->y : sum->x);
        along[axis] = ratio(t->scratch[0], t->scratch[1], -1 - t->attribute_exponent);
    }
    return hypot(along[0], along[1]);
}

static double straight_slope(const clip_triangle *t, const linear *a, long exponent)
{
    return hypot(ratio(a->x, t->determinant, exponent), ratio(a->y, t->determinant, exponent));
}

exact_values clip_triangle_values(clip_triangle *t)
{
    const int exponent = t->attribute_exponent;
    exact_values v;

    evaluate(&t->smooth_sum, t->at[0], t->at[1]);
    for (int a = 0; a < EXACT_ATTRIBUTES / 2; ++a) {
        linear *const smooth = &t->smooth[a], *const straight = &t->straight[a];
        const int n = EXACT_ATTRIBUTES / 2 + a;

        evaluate(smooth, t->at[0], t->at[1]);
        evaluate(straight, t->at[0], t->at[1]);
        v.value[a] = ratio(smooth->at, t->smooth_sum.at, -exponent);
        v.slope[a] = smooth_slope(t, smooth);
        v.value[n] = ratio(straight->at, t->determinant, 1 - exponent);
        v.slope[n] = straight_slope(t, straight, -exponent);
    }
    /* (z / w + 1) / 2 = (z + w) / (2 * w) */
    v.value[EXACT_DEPTH] = ratio(t->sign[3].at, t->determinant, 2);
    v.slope[EXACT_DEPTH] = straight_slope(t, &t->sign[3], 1);
    return v;
}

double clip_triangle_reach(const clip_triangle *t)
{
    return (double)t->reach;
}

double clip_triangle_distance(const clip_triangle *t)
{
    const long double x = t->at[0] + 0.5L, y = t->at[1] + 0.5L;
    long double nearest = HUGE_VALL;

    for (int i = 0; i < t->corners; ++i) {
        const long double *const a = t->corner[i], *const b = t->corner[(i + 1) % t->corners];
        const long double dx = b[0] - a[0], dy = b[1] - a[1];
        const long double square = dx * dx + dy * dy;
        long double along = square > 0.0L ? ((x - a[0]) * dx + (y - a[1]) * dy) / square : 0.0L;

        along = along > 1.0L ? 1.0L : along > 0.0L ? along : 0.0L;
        nearest = fminl(nearest, hypotl(a[0] + along * dx - x, a[1] + along * dy - y));
    }
    return (double)nearest;
}
