/* Properties of rays and barycentric coordinates: each answer against the answer computed from the
 * stored floats in long double, with the bounds of ray.h. Half of the rays and points are aimed at
 * edges and corners, where rounding decides, and many triangles are slivers. */
#include <float.h>
#include <math.h>
#include <stdbool.h>

#include <gnomon.h>

#include "random_inputs.h"
#include "wide.h"

/* a + factor * b */
static wide4 added(wide4 a, wide factor, wide4 b)
{
    return combined(1.0L, a, factor, b);
}

static wide4 positive_cross(wide4 a, wide4 b)
{
    return crossed(positive(a), positive(b), 1.0L);
}

/* A weight of a corner: 0, 1, or roughly between them. */
static wide some_weight(struct theft *t)
{
    switch (theft_random_bits(t, 2)) {
    case 0:
        return 0.0L;
    case 1:
        return 1.0L;
    default:
        return (wide)theft_random_bits(t, 16) * 0x1.8p-16L - 0.25L;
    }
}

/* A triangle of these numbers, often a sliver: c is almost on the line through a and b. */
struct triangle {
    gn_vec3 a, b, c;
    wide4 from, to_b, to_c; /* a, b - a, c - a */
};

static struct triangle some_triangle(struct theft *t, const float *f)
{
    struct triangle tri = {vec3_of(f), vec3_of(f + 3), vec3_of(f + 6), .from = {{0}}};
    tri.from = wide_vec(tri.a);
    tri.to_b = added(wide_vec(tri.b), -1.0L, tri.from);
    if (theft_random_bits(t, 1) != 0) {
        const wide4 side = wide_vec(tri.c);
        const wide off = ldexpl(1.0L, -(int)theft_random_bits(t, 5));
        tri.c = narrowed(added(added(tri.from, some_weight(t), tri.to_b), off, side));
    }
    tri.to_c = added(wide_vec(tri.c), -1.0L, tri.from);
    return tri;
}

/* A quotient of two determinants, and the error that the contract allows. */
struct quotient {
    wide value, error;
};

/* The determinant of a, b and c divided by d, whose terms' magnitudes are summed in d_terms. */
static struct quotient quotient_of(wide4 a, wide4 b, wide4 c, wide d, wide d_terms)
{
    const wide value = dot(a, crossed(b, c, -1.0L)) / d;
    const wide terms = dot(positive(a), positive_cross(b, c)) + fabsl(value) * d_terms;
    return (struct quotient){value, 7.5L * WIDE_U * WIDE_SLACK * terms /
                                            (fabsl(d) - 7.5L * WIDE_U * d_terms) +
                                        WIDE_U * fabsl(value)};
}

static bool near(float got, struct quotient q)
{
    return fabsl((wide)got - q.value) <= q.error;
}

static enum theft_trial_res triangles_are_hit(struct theft *t, void *arg)
{
    const float *f = arg;
    const struct triangle tri = some_triangle(t, f);
    gn_ray ray = {vec3_of(f + 9), vec3_of(f + 12)};
    const wide4 origin = wide_vec(ray.origin);
    if (theft_random_bits(t, 2) != 0) { /* at a point of the triangle's plane */
        const wide u = some_weight(t), v = theft_random_bits(t, 1) ? 1.0L - u : some_weight(t);
        const wide4 aim = added(added(tri.from, u, tri.to_b), v, tri.to_c);
        ray.direction = narrowed(added(aim, -1.0L, origin));
    }
    const wide4 d = wide_vec(ray.direction), from_a = added(origin, -1.0L, tri.from);
    const wide whole = dot(tri.to_b, crossed(d, tri.to_c, -1.0L));
    const wide terms = dot(positive(tri.to_b), positive_cross(d, tri.to_c));
    if (!(fabsl(whole) > 8.0L * WIDE_U * terms) || fabsl(whole) < 0x1p-100L ||
        fabsl(whole) > 0x1p125L)
        return THEFT_TRIAL_SKIP;
    const struct quotient q[3] = {quotient_of(tri.to_c, from_a, tri.to_b, whole, terms),
                                  quotient_of(from_a, d, tri.to_c, whole, terms),
                                  quotient_of(d, from_a, tri.to_b, whole, terms)};
    const wide rest = 1.0L - q[1].value - q[2].value;
    const wide rest_error = q[1].error + q[2].error + 2.0L * WIDE_U;
    const bool surely = q[0].value > q[0].error && q[1].value > q[1].error &&
                        q[2].value > q[2].error && rest > rest_error;
    const bool never = q[0].value < -q[0].error || q[1].value < -q[1].error ||
                       q[2].value < -q[2].error || rest < -rest_error;
    gn_ray_hit hit = {-1.0f, -1.0f, -1.0f}, front = hit;
    const bool hits = gn_ray_hits_triangle(&ray, tri.a, tri.b, tri.c, &hit);
    const bool hits_front = gn_ray_hits_triangle_front(&ray, tri.a, tri.b, tri.c, &front);
    if ((surely && !hits) || (never && hits) || hits_front != (hits && whole > 0.0L))
        return THEFT_TRIAL_FAIL;
    if (!hits)
        return verdict(hit.t == -1.0f && front.t == -1.0f);
    return verdict(near(hit.t, q[0]) && near(hit.u, q[1]) && near(hit.v, q[2]));
}

/* Boxes. */

/* The numbers as a box and a ray. Components of the ray's direction are zero at times; the ray is
 * often aimed at a corner, an edge or a face. */
static gn_ray some_ray(struct theft *t, const float *f, gn_box *box)
{
    float *const low = &box->min.x, *const high = &box->max.x;
    gn_ray ray = {vec3_of(f + 6), vec3_of(f + 9)};
    float *const origin = &ray.origin.x, *const direction = &ray.direction.x;
    const bool aimed = theft_random_bits(t, 2) != 0;
    for (int k = 0; k < 3; ++k) {
        low[k] = fminf(f[k], f[3 + k]);
        high[k] = fmaxf(f[k], f[3 + k]);
        const unsigned where = (unsigned)theft_random_bits(t, 3);
        if (where == 0)
            origin[k] = low[k];
        else if (where == 1)
            high[k] = low[k];
        if (aimed)
            direction[k] = (where & 1 ? low[k] : high[k]) - origin[k];
        if (where == 7)
            direction[k] = 0.0f;
    }
    return ray;
}

/* A ray that meets an edge or a corner at t = (1 + j * 2^-shift) * scale exactly, although the
 * differences of the coordinates are not floats; or misses it by some u. At that place it enters
 * some of the three slabs and leaves the others. */
static gn_ray touching_ray(struct theft *t, gn_box *box)
{
    float *const low = &box->min.x, *const high = &box->max.x;
    gn_ray ray;
    float *const origin = &ray.origin.x, *const direction = &ray.direction.x;
    const bool tiny = theft_random_bits(t, 2) == 3;
    const float space = tiny ? 0x1p-35f : 1.0f, speed = tiny ? 0x1p115f : 1.0f;
    const int shift = 18 + (int)theft_random_bits(t, 4);
    const float j = (float)theft_random_bits(t, 12);
    const float miss = theft_random_bits(t, 1) ? (float)theft_random_bits(t, 6) * 0x1p-24f : 0.0f;
    const int leaves = (int)theft_random_bits(t, 8) % 3;
    for (int k = 0; k < 3; ++k) {
        const float d = 1.0f + (float)theft_random_bits(t, 12);
        const float edge = ldexpf(j * d, -shift) - (k == leaves ? d * miss : 0.0f);
        const bool mirrored = theft_random_bits(t, 1) != 0;
        const bool leave = k == leaves || theft_random_bits(t, 1) != 0;
        const float sign = mirrored ? -space : space, size = leave ? -9000.0f : 9000.0f;
        origin[k] = -d * sign;
        direction[k] = (mirrored ? -d : d) * speed;
        low[k] = fminf(edge * sign, size * sign);
        high[k] = fmaxf(edge * sign, size * sign);
    }
    return ray;
}

static enum theft_trial_res boxes_are_hit(struct theft *t, void *arg)
{
    gn_box box;
    const gn_ray ray = theft_random_bits(t, 1) ? touching_ray(t, &box) : some_ray(t, arg, &box);
    const wide4 o = wide_vec(ray.origin), d = wide_vec(ray.direction);
    const wide4 low = wide_vec(box.min), high = wide_vec(box.max);
    wide enter = 0.0L, leave = INFINITY;
    bool possible = true;
    for (int k = 0; k < 3; ++k) {
        if (!isfinite((float)o.v[k]) || !isfinite((float)d.v[k]) || isnan((float)low.v[k]) ||
            isnan((float)high.v[k]))
            return THEFT_TRIAL_SKIP;
        if (d.v[k] == 0.0L) {
            possible = possible && low.v[k] <= o.v[k] && o.v[k] <= high.v[k];
            continue;
        }
        const wide first = (low.v[k] - o.v[k]) / d.v[k], second = (high.v[k] - o.v[k]) / d.v[k];
        enter = fmaxl(enter, fminl(first, second));
        leave = fminl(leave, fmaxl(first, second));
    }
    gn_ray_span span = {-1.0f, -1.0f};
    const bool hits = gn_ray_hits_box(&ray, &box, &span);
    if (!hits)
        return verdict(span.enter == -1.0f && !(possible && leave >= 0.0L && enter <= leave));
    const wide near_miss = enter - leave;
    if (!possible || !(span.enter <= span.leave) ||
        !(enter > 0x1p127L || leave == INFINITY ||
          near_miss <= 12.0L * WIDE_U * fabsl(leave) + 0x1p-146L))
        return THEFT_TRIAL_FAIL;
    leave = fmaxl(leave, enter);
    const wide largest = (wide)FLT_MAX;
    const bool enters = fabsl((wide)span.enter - enter) <= 2.0L * WIDE_U * enter + 0x1p-149L ||
                        (isinf(span.enter) && enter * (1.0L + 4.0L * WIDE_U) > largest);
    const bool leaves = fabsl((wide)span.leave - leave) <= 2.0L * WIDE_U * leave + 0x1p-149L ||
                        (isinf(span.leave) && leave * (1.0L + 4.0L * WIDE_U) > largest);
    return verdict(enters && leaves);
}

/* Barycentric coordinates. */

/* In a plane the triangle and the point lose their z. */
static enum theft_trial_res weights_are(struct theft *t, const float *f, bool flat)
{
    struct triangle tri = some_triangle(t, f);
    gn_vec3 p = vec3_of(f + 9), weights = {-9.0f, -9.0f, -9.0f};
    if (theft_random_bits(t, 1) != 0) {
        const wide4 on_side = added(tri.from, some_weight(t), tri.to_b);
        p = narrowed(added(on_side, some_weight(t), tri.to_c));
    }
    const gn_status status =
        flat ? gn_barycentric_2d((gn_vec2){p.x, p.y}, (gn_vec2){tri.a.x, tri.a.y},
                                 (gn_vec2){tri.b.x, tri.b.y}, (gn_vec2){tri.c.x, tri.c.y}, &weights)
             : gn_barycentric_3d(p, tri.a, tri.b, tri.c, &weights);
    if (flat)
        p.z = tri.a.z = tri.b.z = tri.c.z = 0.0f;
    const gn_vec3 corners[3] = {tri.a, tri.b, tri.c};
    const wide4 to_b = added(wide_vec(tri.b), -1.0L, wide_vec(tri.a));
    const wide4 to_c = added(wide_vec(tri.c), -1.0L, wide_vec(tri.a));
    const wide4 n = crossed(to_b, to_c, -1.0L), terms = positive_cross(to_b, to_c);
    const wide4 one = {{1.0L, 1.0L, 1.0L, 0.0L}};
    const wide whole = dot(positive(n), one), all = WIDE_U * dot(terms, one);
    if (status == GN_DEGENERATE)
        return verdict(whole <= (flat ? 20.0L : 72.0L) * all + 0x1p-125L && weights.x == -9.0f);
    if (status != GN_OK || whole < (flat ? 12.0L : 56.0L) * all)
        return THEFT_TRIAL_FAIL;
    const float got[3] = {weights.x, weights.y, weights.z};
    for (int k = 0; k < 3; ++k) {
        const wide4 to_next = added(wide_vec(corners[(k + 1) % 3]), -1.0L, wide_vec(p));
        const wide4 to_last = added(wide_vec(corners[(k + 2) % 3]), -1.0L, wide_vec(p));
        const wide4 m = crossed(to_next, to_last, -1.0L);
        const wide4 m_terms = positive_cross(to_next, to_last);
        const wide weight = dot(n, m) / dot(n, n);
        const wide error =
            flat ? 6.0L * WIDE_SLACK * (m_terms.v[2] + fabsl(weight) * terms.v[2]) / whole
                 : 24.0L *
                       (length(n) * length(m_terms) + length(terms) * length(m) +
                        fabsl(weight) * length(n) * length(terms)) /
                       dot(n, n);
        if (!(fabsl((wide)got[k] - weight) <= WIDE_U * (error + fabsl(weight))))
            return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

static enum theft_trial_res weights_are_in_the_plane(struct theft *t, void *arg)
{
    return weights_are(t, arg, true);
}

static enum theft_trial_res weights_are_in_space(struct theft *t, void *arg)
{
    return weights_are(t, arg, false);
}

/* Rays through pixels, over the stored inverses as ray.h does it. */

/* m times v; with `positive_terms`, the sums of magnitudes. */
static wide4 times(const gn_mat4 *m, wide4 v, bool positive_terms)
{
    wide4 result = {{0.0L}};
    for (int row = 0; row < 4; ++row)
        for (int k = 0; k < 4; ++k) {
            const wide term = (wide)m->m[k][row] * v.v[k];
            result.v[row] += positive_terms ? fabsl(term) : term;
        }
    return result;
}

/* A viewport at the origin and a pixel in it, or at least near it. */
static void some_pixel(struct theft *t, const struct made *window, gn_transform *viewport,
                       float *column, float *row)
{
    const float width = fabsf(window->numbers[2]), height = fabsf(window->numbers[3]);
    if (theft_random_bits(t, 1) != 0)
        gn_viewport_no(0.0f, 0.0f, width, height, 0.0f, 1.0f, viewport);
    *column = floorf(width * (float)theft_random_bits(t, 10) * 0x1p-10f);
    *row = floorf(height * (float)theft_random_bits(t, 10) * 0x1p-10f);
}

static enum theft_trial_res rays_go_through_pixels(struct theft *t, void *arg1, void *arg2,
                                                   void *arg3)
{
    const struct made *projection = arg1, *view = arg2;
    gn_transform viewport = ((struct made *)arg3)->transform;
    const int convention = (int)theft_random_bits(t, 8) % 3;
    const wide depth = convention == 0 ? -1.0L : convention == 1 ? 0.0L : 1.0L;
    float column, row;
    some_pixel(t, arg3, &viewport, &column, &row);
    gn_ray ray;
    gn_status (*const functions[3])(const gn_transform *, const gn_transform *,
                                    const gn_transform *, float, float, gn_ray *) = {
        gn_ray_through_pixel_no, gn_ray_through_pixel_zo, gn_ray_through_pixel_reversed};
    const gn_status status = functions[convention](&projection->transform, &view->transform,
                                                   &viewport, column, row, &ray);

    const gn_mat4 *p = &projection->transform.inverse, *v = &view->transform.inverse;
    const wide4 pixel = {{(wide)column + 0.5L, (wide)row + 0.5L, 0.0L, 1.0L}};
    wide4 ndc = times(&viewport.inverse, pixel, false);
    wide4 counted = times(&viewport.inverse, pixel, true);
    ndc.v[2] = depth;
    ndc.v[3] = counted.v[2] = counted.v[3] = 1.0L;
    wide4 origin = times(p, ndc, false), error = times(p, counted, true);
    const wide w = origin.v[3], w_terms = error.v[3], c_w = (wide)p->m[2][3];
    if (!(fabsl(w) > 0x1p6L * WIDE_U * w_terms))
        return THEFT_TRIAL_SKIP;
    if (w < 0.0L || status != GN_OK)
        return verdict(w < 0.0L && status == GN_BEHIND_EYE);

    wide4 g = {{0.0L}}, direction = {{0.0L}};
    for (int k = 0; k < 3; ++k) {
        const wide c = (wide)p->m[2][k];
        origin.v[k] /= w;
        error.v[k] = 8.0L * WIDE_U * (error.v[k] + fabsl(origin.v[k]) * w_terms) / w;
        direction.v[k] = (c - c_w * origin.v[k]) * (convention == 2 ? -1.0L : 1.0L);
        g.v[k] = fabsl(c_w) * error.v[k] + 3.0L * WIDE_U * (fabsl(c) + fabsl(c_w * origin.v[k])) +
                 4.0L * WIDE_U * fabsl(direction.v[k]);
    }
    origin.v[3] = 1.0L;
    error.v[3] = 0.0L;
    const wide4 moved = times(v, origin, false);
    const wide4 bound = added(times(v, error, true), 4.0L * WIDE_U, times(v, origin, true));
    for (int k = 0; k < 3; ++k)
        if (!(fabsl(wide_vec(ray.origin).v[k] - moved.v[k]) <= bound.v[k] * WIDE_SLACK))
            return THEFT_TRIAL_FAIL;
    const wide4 turned = times(v, direction, false);
    const wide4 expected = added(turned, 1.0L / length(turned) - 1.0L, turned);
    wide off = 2.0L * length(times(v, g, true)) / length(turned) + 6.0L * WIDE_U;
    const gn_mat4 *forward = &projection->transform.matrix;
    if (projection->kind == PERSPECTIVE && forward->m[0][0] >= 1.0f && forward->m[1][1] >= 1.0f &&
        viewport.matrix.m[3][0] == viewport.matrix.m[0][0])
        off = fminl(off, 32.0L * WIDE_U);
    return verdict(length(added(wide_vec(ray.direction), -1.0L, expected)) <= off * WIDE_SLACK);
}

static const property rays[] = {
    PROPERTY1("ray and triangle", triangles_are_hit, FLOATS_WITHIN(3)),
    PROPERTY1("ray and triangle, more scales", triangles_are_hit, FLOATS_WITHIN(12)),
    PROPERTY1("ray and box", boxes_are_hit, FLOATS_WITHIN(3)),
    PROPERTY1("ray and box, any floats", boxes_are_hit, ANY_FLOATS),
    PROPERTY1("barycentric, plane", weights_are_in_the_plane, FLOATS_WITHIN(12)),
    PROPERTY1("barycentric, space", weights_are_in_space, FLOATS_WITHIN(12)),
    PROPERTY3("ray through a pixel", rays_go_through_pixels,
              TRANSFORMS(ORTHOGRAPHIC, PERSPECTIVE + 1, 12), TRANSFORMS(ROTATE_X, LOOK_AT + 1, 12),
              TRANSFORMS(VIEWPORT, VIEWPORT + 1, 12)),
};

SUITE(properties_rays, rays);
