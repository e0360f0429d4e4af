/* Properties of rays and barycentric coordinates: each answer against the answer computed from the
 * stored floats in long double, with the bounds of ray.h. Half of the rays and points are aimed at
 * edges and corners, where rounding decides, and many triangles are slivers. */
#include <float.h>
#include <math.h>
#include <stdbool.h>

#include <gnomon.h>

#include "double_matrix.h"
#include "properties.h"
#include "random_inputs.h"

typedef long double wide;

#define WIDE_U 0x1p-24L
#define WIDE_SLACK ((wide)SLACK)

static enum theft_trial_res verdict(bool holds)
{
    return holds ? THEFT_TRIAL_PASS : THEFT_TRIAL_FAIL;
}

typedef struct triple {
    wide v[3];
} triple;

static triple widened3(gn_vec3 v)
{
    const triple result = {{(wide)v.x, (wide)v.y, (wide)v.z}};
    return result;
}

static gn_vec3 narrowed(triple a)
{
    const gn_vec3 v = {(float)a.v[0], (float)a.v[1], (float)a.v[2]};
    return v;
}

/* a + factor * b */
static triple added(triple a, wide factor, triple b)
{
    for (int k = 0; k < 3; ++k)
        a.v[k] += factor * b.v[k];
    return a;
}

static triple positive(triple a)
{
    for (int k = 0; k < 3; ++k)
        a.v[k] = fabsl(a.v[k]);
    return a;
}

/* The cross product; with sign = 1, every term is positive if a and b are. */
static triple crossed(triple a, triple b, wide sign)
{
    triple c;
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        c.v[k] = a.v[i] * b.v[j] + sign * a.v[j] * b.v[i];
    }
    return c;
}

static triple positive_cross(triple a, triple b)
{
    return crossed(positive(a), positive(b), 1.0L);
}

static wide dot(triple a, triple b)
{
    return a.v[0] * b.v[0] + a.v[1] * b.v[1] + a.v[2] * b.v[2];
}

static wide size(triple a)
{
    return sqrtl(dot(a, a));
}

static wide determinant(triple a, triple b, triple c)
{
    return dot(a, crossed(b, c, -1.0L));
}

static wide permanent(triple a, triple b, triple c)
{
    return dot(positive(a), positive_cross(b, c));
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
    triple from, to_b, to_c; /* a, b - a, c - a */
};

static struct triangle some_triangle(struct theft *t, const float *f)
{
    struct triangle tri = {
        {f[0], f[1], f[2]}, {f[3], f[4], f[5]}, {f[6], f[7], f[8]}, .from = {{0}}};
    tri.from = widened3(tri.a);
    tri.to_b = added(widened3(tri.b), -1.0L, tri.from);
    if (theft_random_bits(t, 1) != 0) {
        const triple side = widened3(tri.c);
        const wide off = ldexpl(1.0L, -(int)theft_random_bits(t, 5));
        tri.c = narrowed(added(added(tri.from, some_weight(t), tri.to_b), off, side));
    }
    tri.to_c = added(widened3(tri.c), -1.0L, tri.from);
    return tri;
}

/* A point of the triangle's plane, in the triangle or near it. */
static triple some_point(struct theft *t, const struct triangle *tri)
{
    const triple on_side = added(tri->from, some_weight(t), tri->to_b);
    return added(on_side, some_weight(t), tri->to_c);
}

/* A quotient of two determinants, and the error that the contract allows. */
struct quotient {
    wide value, error;
};

static struct quotient quotient_of(wide numerator, wide numerator_terms, wide d, wide d_terms)
{
    const struct quotient q = {numerator / d,
                               7.5L * WIDE_U * WIDE_SLACK *
                                       (numerator_terms + fabsl(numerator / d) * d_terms) /
                                       (fabsl(d) - 7.5L * WIDE_U * d_terms) +
                                   WIDE_U * fabsl(numerator / d)};
    return q;
}

static bool near(float got, struct quotient q)
{
    return fabsl((wide)got - q.value) <= q.error;
}

/* Both descriptions of a hit lead to one point, within their errors. */
static bool same_point(const gn_ray *ray, const struct triangle *tri, const gn_ray_hit *hit,
                       const struct quotient q[3])
{
    const triple d = widened3(ray->direction);
    const triple along = added(widened3(ray->origin), (wide)hit->t, d);
    const triple inside = added(added(tri->from, (wide)hit->u, tri->to_b), (wide)hit->v, tri->to_c);
    for (int k = 0; k < 3; ++k) {
        const wide allowed = q[0].error * fabsl(d.v[k]) + q[1].error * fabsl(tri->to_b.v[k]) +
                             q[2].error * fabsl(tri->to_c.v[k]);
        if (!(fabsl(along.v[k] - inside.v[k]) <=
              allowed * WIDE_SLACK + 0x1p-50L * (fabsl(along.v[k]) + fabsl(tri->from.v[k]))))
            return false;
    }
    return true;
}

static enum theft_trial_res triangles_are_hit(struct theft *t, void *arg)
{
    const float *f = arg;
    const struct triangle tri = some_triangle(t, f);
    gn_ray ray = {{f[9], f[10], f[11]}, {f[12], f[13], f[14]}};
    const triple origin = widened3(ray.origin);
    if (theft_random_bits(t, 2) != 0) { /* at a point of the triangle's plane */
        const wide u = some_weight(t), v = theft_random_bits(t, 1) ? 1.0L - u : some_weight(t);
        const triple aim = added(added(tri.from, u, tri.to_b), v, tri.to_c);
        ray.direction = narrowed(added(aim, -1.0L, origin));
    }
    const triple d = widened3(ray.direction), from_a = added(origin, -1.0L, tri.from);
    const wide whole = determinant(tri.to_b, d, tri.to_c);
    const wide terms = permanent(tri.to_b, d, tri.to_c);
    if (!(fabsl(whole) > 8.0L * WIDE_U * terms) || fabsl(whole) < 0x1p-100L ||
        fabsl(whole) > 0x1p125L)
        return THEFT_TRIAL_SKIP;
    const struct quotient q[3] = {
        quotient_of(determinant(tri.to_c, from_a, tri.to_b), permanent(tri.to_c, from_a, tri.to_b),
                    whole, terms),
        quotient_of(determinant(from_a, d, tri.to_c), permanent(from_a, d, tri.to_c), whole, terms),
        quotient_of(determinant(d, from_a, tri.to_b), permanent(d, from_a, tri.to_b), whole,
                    terms)};
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
    return verdict(near(hit.t, q[0]) && near(hit.u, q[1]) && near(hit.v, q[2]) &&
                   same_point(&ray, &tri, &hit, q));
}

/* Boxes. */

/* The numbers as a box and a ray. Components of the ray's direction are zero at times; the ray is
 * often aimed at a corner, an edge or a face. */
static gn_ray some_ray(struct theft *t, const float *f, gn_box *box)
{
    float *const low = &box->min.x, *const high = &box->max.x;
    gn_ray ray = {{f[6], f[7], f[8]}, {f[9], f[10], f[11]}};
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
    const triple o = widened3(ray.origin), d = widened3(ray.direction);
    const triple low = widened3(box.min), high = widened3(box.max);
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

static wide length(triple v)
{
    return sqrtl(dot(v, v));
}

static enum theft_trial_res weights_are_in_the_plane(struct theft *t, void *arg)
{
    const float *f = arg;
    const struct triangle tri = some_triangle(t, f);
    const gn_vec2 corners[3] = {{tri.a.x, tri.a.y}, {tri.b.x, tri.b.y}, {tri.c.x, tri.c.y}};
    gn_vec2 p = {f[9], f[10]};
    if (theft_random_bits(t, 1) != 0) {
        const triple inside = some_point(t, &tri);
        p.x = (float)inside.v[0];
        p.y = (float)inside.v[1];
    }
    gn_vec3 weights = {-9.0f, -9.0f, -9.0f};
    const gn_status status = gn_barycentric_2d(p, corners[0], corners[1], corners[2], &weights);
    const triple flat_b = {{tri.to_b.v[0], tri.to_b.v[1], 0.0L}};
    const triple flat_c = {{tri.to_c.v[0], tri.to_c.v[1], 0.0L}};
    const wide area = crossed(flat_b, flat_c, -1.0L).v[2];
    const wide terms = positive_cross(flat_b, flat_c).v[2];
    if (status == GN_DEGENERATE)
        return verdict(fabsl(area) < 20.0L * WIDE_U * terms + 0x1p-125L && weights.x == -9.0f);
    if (status != GN_OK || fabsl(area) < 12.0L * WIDE_U * terms)
        return THEFT_TRIAL_FAIL;
    const float got[3] = {weights.x, weights.y, weights.z};
    wide sum = -1.0L, sum_error = 0.0L;
    for (int k = 0; k < 3; ++k) {
        const gn_vec2 next = corners[(k + 1) % 3], last = corners[(k + 2) % 3];
        const triple to_next = {{(wide)next.x - (wide)p.x, (wide)next.y - (wide)p.y, 0.0L}};
        const triple to_last = {{(wide)last.x - (wide)p.x, (wide)last.y - (wide)p.y, 0.0L}};
        const wide weight = crossed(to_next, to_last, -1.0L).v[2] / area;
        const wide error = 6.0L * WIDE_U * WIDE_SLACK *
                               (positive_cross(to_next, to_last).v[2] + fabsl(weight) * terms) /
                               fabsl(area) +
                           WIDE_U * fabsl(weight);
        if (!(fabsl((wide)got[k] - weight) <= error))
            return THEFT_TRIAL_FAIL;
        sum += (wide)got[k];
        sum_error += error;
    }
    return verdict(fabsl(sum) <= sum_error);
}

static enum theft_trial_res weights_are_in_space(struct theft *t, void *arg)
{
    const float *f = arg;
    const struct triangle tri = some_triangle(t, f);
    const gn_vec3 corners[3] = {tri.a, tri.b, tri.c};
    gn_vec3 p = {f[9], f[10], f[11]};
    if (theft_random_bits(t, 1) != 0)
        p = narrowed(some_point(t, &tri));
    gn_vec3 weights = {-9.0f, -9.0f, -9.0f};
    const gn_status status = gn_barycentric_3d(p, corners[0], corners[1], corners[2], &weights);
    const triple n = crossed(tri.to_b, tri.to_c, -1.0L);
    const triple terms = positive_cross(tri.to_b, tri.to_c), one = {{1.0L, 1.0L, 1.0L}};
    if (status == GN_DEGENERATE)
        return verdict(dot(positive(n), one) <= 72.0L * WIDE_U * dot(terms, one) + 0x1p-125L &&
                       weights.x == -9.0f);
    if (status != GN_OK || dot(positive(n), one) < 56.0L * WIDE_U * dot(terms, one))
        return THEFT_TRIAL_FAIL;
    const float got[3] = {weights.x, weights.y, weights.z};
    for (int k = 0; k < 3; ++k) {
        const triple to_next = added(widened3(corners[(k + 1) % 3]), -1.0L, widened3(p));
        const triple to_last = added(widened3(corners[(k + 2) % 3]), -1.0L, widened3(p));
        const triple m = crossed(to_next, to_last, -1.0L);
        const wide weight = dot(n, m) / dot(n, n);
        const wide sums = length(n) * length(positive_cross(to_next, to_last)) +
                          length(terms) * length(m) + fabsl(weight) * length(n) * length(terms);
        if (!(fabsl((wide)got[k] - weight) <=
              24.0L * WIDE_U * sums / dot(n, n) + WIDE_U * fabsl(weight)))
            return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

/* Rays through pixels, over the stored inverses as ray.h does it. */

/* The first three rows of m times (v, w); with `positive`, the sum of magnitudes. */
static triple times(const gn_mat4 *m, triple v, wide w, bool positive_terms)
{
    triple result;
    for (int row = 0; row < 3; ++row) {
        result.v[row] = 0.0L;
        for (int k = 0; k < 4; ++k) {
            const wide term = (wide)m->m[k][row] * (k < 3 ? v.v[k] : w);
            result.v[row] += positive_terms ? fabsl(term) : term;
        }
    }
    return result;
}

static wide fourth(const gn_mat4 *m, triple v, bool positive_terms)
{
    wide result = 0.0L;
    for (int k = 0; k < 4; ++k) {
        const wide term = (wide)m->m[k][3] * (k < 3 ? v.v[k] : 1.0L);
        result += positive_terms ? fabsl(term) : term;
    }
    return result;
}

static bool within3(triple error, triple bound)
{
    for (int k = 0; k < 3; ++k)
        if (!(fabsl(error.v[k]) <= bound.v[k] * WIDE_SLACK))
            return false;
    return true;
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
    const triple pixel = {{(wide)column + 0.5L, (wide)row + 0.5L, 0.0L}};
    triple ndc = times(&viewport.inverse, pixel, 1.0L, false);
    triple counted = times(&viewport.inverse, pixel, 1.0L, true);
    ndc.v[2] = depth;
    counted.v[2] = 1.0L;
    const wide w = fourth(p, ndc, false), w_terms = fourth(p, counted, true);
    if (!(fabsl(w) > 0x1p6L * WIDE_U * w_terms) || (status != GN_OK && status != GN_BEHIND_EYE))
        return THEFT_TRIAL_SKIP;
    if (w < 0.0L || status == GN_BEHIND_EYE)
        return verdict(w < 0.0L && status == GN_BEHIND_EYE);

    triple origin = times(p, ndc, 1.0L, false), error = times(p, counted, 1.0L, true);
    triple c, g, direction;
    const wide c_w = (wide)p->m[2][3];
    for (int k = 0; k < 3; ++k) {
        origin.v[k] /= w;
        error.v[k] = 8.0L * WIDE_U * (error.v[k] + fabsl(origin.v[k]) * w_terms) / w;
        c.v[k] = (wide)p->m[2][k];
        direction.v[k] = (c.v[k] - c_w * origin.v[k]) * (convention == 2 ? -1.0L : 1.0L);
        g.v[k] = fabsl(c_w) * error.v[k] +
                 3.0L * WIDE_U * (fabsl(c.v[k]) + fabsl(c_w * origin.v[k])) +
                 4.0L * WIDE_U * fabsl(direction.v[k]);
    }
    const triple moved = times(v, origin, 1.0L, false);
    triple bound = added(times(v, error, 0.0L, true), 4.0L * WIDE_U, times(v, origin, 1.0L, true));
    if (!within3(added(widened3(ray.origin), -1.0L, moved), bound))
        return THEFT_TRIAL_FAIL;
    const triple turned = times(v, direction, 0.0L, false);
    const triple expected = added(turned, 1.0L / size(turned) - 1.0L, turned);
    wide off = 2.0L * size(times(v, g, 0.0L, true)) / size(turned) + 6.0L * WIDE_U;
    const gn_mat4 *forward = &projection->transform.matrix;
    if (projection->kind == PERSPECTIVE && forward->m[0][0] >= 1.0f && forward->m[1][1] >= 1.0f &&
        viewport.matrix.m[3][0] == viewport.matrix.m[0][0])
        off = fminl(off, 32.0L * WIDE_U);
    return verdict(size(added(widened3(ray.direction), -1.0L, expected)) <= off * WIDE_SLACK);
}

int properties_rays(uint64_t seed, size_t trials)
{
    struct choice projections = {ORTHOGRAPHIC, PERSPECTIVE + 1, 12};
    struct choice views = {ROTATE_X, LOOK_AT + 1, 12}, windows = {VIEWPORT, VIEWPORT + 1, 12};
    struct choice small = {0, 0, 3}, moderate = {0, 0, 12};
    const struct theft_type_info projection_info = random_transforms(&projections);
    const struct theft_type_info view_info = random_transforms(&views);
    const struct theft_type_info window_info = random_transforms(&windows);
    const struct theft_type_info small_info = random_floats(&small);
    const struct theft_type_info moderate_info = random_floats(&moderate);
    const struct theft_type_info float_info = random_floats(NULL);
    const struct theft_run_config properties[] = {
        {.name = "ray and triangle", .prop1 = triangles_are_hit, .type_info = {&small_info}},
        {.name = "ray and triangle, more scales",
         .prop1 = triangles_are_hit,
         .type_info = {&moderate_info}},
        {.name = "ray and box", .prop1 = boxes_are_hit, .type_info = {&small_info}},
        {.name = "ray and box, any floats", .prop1 = boxes_are_hit, .type_info = {&float_info}},
        {.name = "barycentric, plane",
         .prop1 = weights_are_in_the_plane,
         .type_info = {&moderate_info}},
        {.name = "barycentric, space",
         .prop1 = weights_are_in_space,
         .type_info = {&moderate_info}},
        {.name = "ray through a pixel",
         .prop3 = rays_go_through_pixels,
         .type_info = {&projection_info, &view_info, &window_info}},
    };
    int failed = 0;
    for (size_t i = 0; i < sizeof properties / sizeof properties[0]; ++i)
        failed += property_run(properties[i], seed, trials);
    return failed;
}
