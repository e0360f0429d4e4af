/* Properties of culling, rays and barycentric coordinates: each answer against the answer computed
 * from the stored floats in long double, with the bounds of the public headers. Half of the boxes,
 * spheres and rays are made to touch, so that rounding decides. */
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include <gnomon.h>

#include "double_matrix.h"
#include "properties.h"
#include "random_inputs.h"

typedef long double wide;

#define WIDE_U 0x1p-24L

static enum theft_trial_res verdict(bool holds)
{
    return holds ? THEFT_TRIAL_PASS : THEFT_TRIAL_FAIL;
}

static wide magnitude_of_sum(const wide *a, const wide *b, int count)
{
    wide total = 0.0L;
    for (int i = 0; i < count; ++i)
        total += fabsl(a[i] * b[i]);
    return total;
}

static wide dot(const wide *a, const wide *b, int count)
{
    wide total = 0.0L;
    for (int i = 0; i < count; ++i)
        total += a[i] * b[i];
    return total;
}

static gn_vec3 vec3_of(const float *f)
{
    const gn_vec3 v = {f[0], f[1], f[2]};
    return v;
}

static bool is_finite(gn_vec3 v)
{
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

static void widen(gn_vec3 v, wide out[3])
{
    out[0] = (wide)v.x;
    out[1] = (wide)v.y;
    out[2] = (wide)v.z;
}

static gn_vec3 narrowed(const wide *v)
{
    const gn_vec3 n = {(float)v[0], (float)v[1], (float)v[2]};
    return n;
}

/* Planes. */

/* Bound i of clip space as a plane of the stored matrix, with a normal of length one. Returns false
 * if the normal is zero; then only the sign of the offset is kept. */
static bool exact_plane(const gn_mat4 *m, int i, bool zero_to_one, wide plane[4])
{
    const bool alone = zero_to_one && i == GN_PLANE_NEAR;
    for (int k = 0; k < 4; ++k) {
        const wide row = (wide)m->m[k][i / 2], w = (wide)m->m[k][3];
        plane[k] = alone ? row : i % 2 == 0 ? w + row : w - row;
    }
    const wide length = sqrtl(dot(plane, plane, 3));
    if (length == 0.0L) {
        plane[3] = (wide)((plane[3] > 0.0L) - (plane[3] < 0.0L));
        return false;
    }
    for (int k = 0; k < 4; ++k)
        plane[k] /= length;
    return true;
}

static bool plane_is(const gn_plane *got, const wide exact[4], bool is_plane)
{
    const float stored[4] = {got->normal.x, got->normal.y, got->normal.z, got->offset};
    wide least = 2.0L, most = 0.0L;
    for (int k = 0; k < 4; ++k) {
        if (!is_plane || exact[k] == 0.0L) {
            if ((wide)stored[k] != exact[k])
                return false;
            continue;
        }
        if (fabsl(exact[k]) < 0x1p-120L)
            continue;
        const wide ratio = (wide)stored[k] / exact[k];
        least = ratio < least ? ratio : least;
        most = ratio > most ? ratio : most;
    }
    return !is_plane || (least >= 1.0L - 8.0L * WIDE_U && most <= 1.0L + 8.0L * WIDE_U &&
                         most - least <= 4.0L * WIDE_U * (wide)SLACK);
}

/* The planes of the matrix and their exact forms. */
struct volume {
    gn_plane planes[GN_PLANE_COUNT];
    wide exact[GN_PLANE_COUNT][4];
    bool is_plane[GN_PLANE_COUNT];
};

static bool make_volume(const gn_mat4 *m, bool zero_to_one, struct volume *volume)
{
    const gn_status status = zero_to_one ? gn_frustum_planes_zo(m, volume->planes)
                                         : gn_frustum_planes_no(m, volume->planes);
    for (int i = 0; i < GN_PLANE_COUNT && status == GN_OK; ++i)
        volume->is_plane[i] = exact_plane(m, i, zero_to_one, volume->exact[i]);
    return status == GN_OK;
}

static enum theft_trial_res planes_are_the_bounds(struct theft *t, void *arg)
{
    const gn_mat4 *m = arg;
    struct volume volume;
    for (int convention = 0; convention < 2; ++convention) {
        if (!make_volume(m, convention == 1, &volume))
            return THEFT_TRIAL_SKIP;
        for (int i = 0; i < GN_PLANE_COUNT; ++i)
            if (!plane_is(&volume.planes[i], volume.exact[i], volume.is_plane[i]))
                return THEFT_TRIAL_FAIL;
    }
    (void)t;
    return THEFT_TRIAL_PASS;
}

/* Culling. For a set, its largest and smallest sums over each plane and the magnitudes of the terms
 * are given; the result is which answers are allowed. */
struct sums {
    wide most, least, terms;
};

static bool answer_is(gn_containment answer, const struct sums *sums)
{
    bool outside = false, inside = true, surely_outside = false, surely_inside = true;
    for (int i = 0; i < GN_PLANE_COUNT; ++i) {
        const wide sure = sums[i].terms < 0x1p127L ? 16.0L * WIDE_U * sums[i].terms * (wide)SLACK
                                                   : (wide)INFINITY;
        outside = outside || sums[i].most < 0.0L;
        inside = inside && sums[i].least >= 0.0L;
        surely_outside = surely_outside || sums[i].most < -sure;
        surely_inside = surely_inside && sums[i].least > sure;
    }
    return answer == GN_OUTSIDE  ? outside
           : answer == GN_INSIDE ? inside
                                 : !surely_outside && !surely_inside;
}

/* The magnitudes of a plane's coefficients as the contract of culling counts them. */
static void counted(const wide plane[4], wide result[4])
{
    for (int k = 0; k < 4; ++k)
        result[k] = fabsl(plane[k]) + 0x1p-120L;
}

static enum theft_trial_res boxes_are_culled_safely(struct theft *t, void *arg1, void *arg2)
{
    const gn_mat4 *m = arg1;
    const float *f = arg2;
    struct volume volume;
    struct sums sums[GN_PLANE_COUNT];
    if (!make_volume(m, theft_random_bits(t, 1) != 0, &volume))
        return THEFT_TRIAL_SKIP;

    /* The corner farthest along some plane's normal, or against it, and often on the plane. */
    const int touched = (int)theft_random_bits(t, 8) % GN_PLANE_COUNT;
    const wide *plane = volume.exact[touched];
    const bool touch = theft_random_bits(t, 2) != 0, behind = theft_random_bits(t, 1) != 0;
    const bool point = theft_random_bits(t, 3) == 0;
    wide corner[4] = {(wide)f[0], (wide)f[1], (wide)f[2], 1.0L};
    const wide away = touch && volume.is_plane[touched] ? dot(plane, corner, 4) : 0.0L;
    wide low[4] = {0.0L, 0.0L, 0.0L, 1.0L}, high[4] = {0.0L, 0.0L, 0.0L, 1.0L};
    for (int k = 0; k < 3; ++k) {
        const float from = (float)(corner[k] - away * plane[k]);
        const float size = point ? 0.0f : fabsf(f[3 + k]);
        const bool grows = (plane[k] < 0.0L) == behind;
        low[k] = (wide)(grows ? from : from - size);
        high[k] = (wide)(grows ? from + size : from);
    }
    const gn_box box = {narrowed(low), narrowed(high)};
    if (!is_finite(box.min) || !is_finite(box.max))
        return verdict(gn_cull_box(volume.planes, &box) == GN_INTERSECTING);

    for (int i = 0; i < GN_PLANE_COUNT; ++i) {
        wide most[4], least[4], largest[4], coefficients[4];
        for (int k = 0; k < 4; ++k) {
            const bool up = volume.exact[i][k] >= 0.0L;
            most[k] = up ? high[k] : low[k];
            least[k] = up ? low[k] : high[k];
            largest[k] = fmaxl(fabsl(low[k]), fabsl(high[k]));
        }
        counted(volume.exact[i], coefficients);
        sums[i].most = dot(volume.exact[i], most, 4);
        sums[i].least = dot(volume.exact[i], least, 4);
        sums[i].terms = magnitude_of_sum(coefficients, largest, 4);
    }
    return verdict(answer_is(gn_cull_box(volume.planes, &box), sums));
}

static enum theft_trial_res spheres_are_culled_safely(struct theft *t, void *arg1, void *arg2)
{
    const gn_mat4 *m = arg1;
    const float *f = arg2;
    struct volume volume;
    struct sums sums[GN_PLANE_COUNT];
    if (!make_volume(m, theft_random_bits(t, 1) != 0, &volume))
        return THEFT_TRIAL_SKIP;
    const int touched = (int)theft_random_bits(t, 8) % GN_PLANE_COUNT;
    const gn_vec3 center = vec3_of(f);
    const wide place[4] = {(wide)f[0], (wide)f[1], (wide)f[2], 1.0L};
    const bool touch = theft_random_bits(t, 2) != 0 && volume.is_plane[touched];
    const float radius = touch ? (float)fabsl(dot(volume.exact[touched], place, 4)) : fabsf(f[3]);
    if (!isfinite(radius) || !is_finite(center))
        return verdict(gn_cull_sphere(volume.planes, center, radius) == GN_INTERSECTING);
    for (int i = 0; i < GN_PLANE_COUNT; ++i) {
        const wide away = dot(volume.exact[i], place, 4);
        const wide reach = volume.is_plane[i] ? (wide)radius : 0.0L;
        wide coefficients[4];
        counted(volume.exact[i], coefficients);
        sums[i].most = away + reach;
        sums[i].least = away - reach;
        sums[i].terms = magnitude_of_sum(coefficients, place, 4) + reach;
    }
    return verdict(answer_is(gn_cull_sphere(volume.planes, center, radius), sums));
}

static bool box_holds(const gn_box *box, const wide p[3])
{
    wide low[3], high[3];
    widen(box->min, low);
    widen(box->max, high);
    for (int k = 0; k < 3; ++k)
        if (!(p[k] >= low[k] && p[k] <= high[k]))
            return false;
    return true;
}

static enum theft_trial_res boxes_hold_their_corners(struct theft *t, void *arg1, void *arg2)
{
    const gn_mat4 *m = arg1;
    const float *f = arg2;
    gn_box box, moved;
    float *const low = &box.min.x, *const high = &box.max.x;
    for (int k = 0; k < 3; ++k) {
        low[k] = fminf(f[k], f[3 + k]);
        high[k] = fmaxf(f[k], f[3 + k]);
    }
    if (gn_mat4_transform_box(m, &box, &moved) != GN_OK)
        return THEFT_TRIAL_SKIP;
    wide least[3] = {INFINITY, INFINITY, INFINITY}, most[3] = {-INFINITY, -INFINITY, -INFINITY};
    wide terms[3] = {0.0L, 0.0L, 0.0L};
    for (int corner = 0; corner < 8; ++corner) {
        const gn_vec3 p = {corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1],
                           corner & 4 ? high[2] : low[2]};
        const wide place[4] = {(wide)p.x, (wide)p.y, (wide)p.z, 1.0L};
        wide exact[3], rounded[3];
        for (int row = 0; row < 3; ++row) {
            const wide coefficients[4] = {(wide)m->m[0][row], (wide)m->m[1][row],
                                          (wide)m->m[2][row], (wide)m->m[3][row]};
            exact[row] = dot(coefficients, place, 4);
            least[row] = fminl(least[row], exact[row]);
            most[row] = fmaxl(most[row], exact[row]);
            terms[row] = fmaxl(terms[row], magnitude_of_sum(coefficients, place, 4));
        }
        widen(gn_mat4_transform_point(m, p), rounded);
        if (!box_holds(&moved, exact) || !box_holds(&moved, rounded))
            return THEFT_TRIAL_FAIL;
    }
    wide got_low[3], got_high[3];
    widen(moved.min, got_low);
    widen(moved.max, got_high);
    for (int k = 0; k < 3; ++k) {
        const wide beyond = 12.0L * WIDE_U * terms[k] * (wide)SLACK + 0x1p-146L;
        if (!(least[k] - got_low[k] <= beyond) || !(got_high[k] - most[k] <= beyond))
            return THEFT_TRIAL_FAIL;
    }
    (void)t;
    return THEFT_TRIAL_PASS;
}

/* Matrices: a projection after a view or model, or random numbers. */

static enum theft_trial_res on_projection(struct theft *t, void *arg1, void *arg2, void *arg3,
                                          enum theft_trial_res (*property)(struct theft *, void *,
                                                                           void *))
{
    gn_mat4 m;
    gn_mat4_multiply(&((struct made *)arg1)->transform.matrix,
                     &((struct made *)arg2)->transform.matrix, &m);
    return property(t, &m, arg3);
}

static enum theft_trial_res projection_boxes(struct theft *t, void *a, void *b, void *c)
{
    return on_projection(t, a, b, c, boxes_are_culled_safely);
}

static enum theft_trial_res projection_spheres(struct theft *t, void *a, void *b, void *c)
{
    return on_projection(t, a, b, c, spheres_are_culled_safely);
}

int properties_geometry(uint64_t seed, size_t trials)
{
    struct choice projections = {ORTHOGRAPHIC, PERSPECTIVE + 1, 12}, affine = {0, AFFINE_KINDS, 8};
    struct choice moderate = {0, 0, 20}, near_one = {0, 0, 4};
    const struct theft_type_info projection_info = random_transforms(&projections);
    const struct theft_type_info affine_info = random_transforms(&affine);
    const struct theft_type_info moderate_info = random_floats(&moderate);
    const struct theft_type_info near_one_info = random_floats(&near_one);
    const struct theft_type_info float_info = random_floats(NULL);
    const struct theft_run_config properties[] = {
        {.name = "view volume: planes",
         .prop1 = planes_are_the_bounds,
         .type_info = {&moderate_info}},
        {.name = "view volume, any floats: planes",
         .prop1 = planes_are_the_bounds,
         .type_info = {&float_info}},
        {.name = "culling, projections: boxes",
         .prop3 = projection_boxes,
         .type_info = {&projection_info, &affine_info, &moderate_info}},
        {.name = "culling, projections: spheres",
         .prop3 = projection_spheres,
         .type_info = {&projection_info, &affine_info, &moderate_info}},
        {.name = "culling, any matrix: boxes",
         .prop2 = boxes_are_culled_safely,
         .type_info = {&near_one_info, &near_one_info}},
        {.name = "culling, any matrix: spheres",
         .prop2 = spheres_are_culled_safely,
         .type_info = {&near_one_info, &near_one_info}},
        {.name = "culling, any floats: boxes",
         .prop2 = boxes_are_culled_safely,
         .type_info = {&near_one_info, &float_info}},
        {.name = "culling, any floats: spheres",
         .prop2 = spheres_are_culled_safely,
         .type_info = {&near_one_info, &float_info}},
        {.name = "transformed boxes: corners within",
         .prop2 = boxes_hold_their_corners,
         .type_info = {&moderate_info, &moderate_info}},
        {.name = "transformed boxes, any floats: corners within",
         .prop2 = boxes_hold_their_corners,
         .type_info = {&moderate_info, &float_info}},
    };
    int failed = 0;
    for (size_t i = 0; i < sizeof properties / sizeof properties[0]; ++i)
        failed += property_run(properties[i], seed, trials);
    return failed;
}
