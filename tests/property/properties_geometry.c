/* Properties of culling and of transformed boxes: each answer against the answer computed from the
 * stored floats in long double, with the bounds of culling.h. Half of the boxes and spheres are
 * made to touch a plane, so that rounding decides. */
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include <gnomon.h>

#include "random_inputs.h"
#include "wide.h"

/* The place of a point, with a w of 1. */
static wide4 place_of(const float *f)
{
    return (wide4){{(wide)f[0], (wide)f[1], (wide)f[2], 1.0L}};
}

/* Planes. */

/* Bound i of clip space as a plane of the stored matrix, with a normal of length one. Returns false
 * if the normal is zero; then only the sign of the offset is kept. */
static bool exact_plane(const gn_mat4 *m, int i, bool zero_to_one, wide4 *plane)
{
    const bool alone = zero_to_one && i == GN_PLANE_NEAR;
    wide4 normal;
    for (int k = 0; k < 4; ++k) {
        const wide row = (wide)m->m[k][i / 2], w = (wide)m->m[k][3];
        plane->v[k] = alone ? row : i % 2 == 0 ? w + row : w - row;
    }
    normal = *plane;
    normal.v[3] = 0.0L;
    if (length(normal) == 0.0L) {
        plane->v[3] = (wide)((plane->v[3] > 0.0L) - (plane->v[3] < 0.0L));
        return false;
    }
    *plane = combined(1.0L / length(normal), *plane, 0.0L, *plane);
    return true;
}

static bool plane_is(const gn_plane *got, wide4 exact, bool is_plane)
{
    const float stored[4] = {got->normal.x, got->normal.y, got->normal.z, got->offset};
    wide least = 2.0L, most = 0.0L;
    for (int k = 0; k < 4; ++k) {
        const wide ratio = (wide)stored[k] / exact.v[k];
        if (!is_plane || exact.v[k] == 0.0L) {
            if ((wide)stored[k] != exact.v[k])
                return false;
        } else if (fabsl(exact.v[k]) >= 0x1p-120L) {
            if (!(fabsl(ratio - 1.0L) <= 8.0L * WIDE_U))
                return false;
            least = fminl(ratio, least);
            most = fmaxl(ratio, most);
        }
    }
    return !is_plane || most - least <= 4.0L * WIDE_U * WIDE_SLACK;
}

/* The planes of the matrix and their exact forms. */
struct volume {
    gn_plane planes[GN_PLANE_COUNT];
    wide4 exact[GN_PLANE_COUNT];
    bool is_plane[GN_PLANE_COUNT];
};

static bool make_volume(const gn_mat4 *m, bool zero_to_one, struct volume *volume)
{
    const gn_status status = zero_to_one ? gn_frustum_planes_zo(m, volume->planes)
                                         : gn_frustum_planes_no(m, volume->planes);
    for (int i = 0; i < GN_PLANE_COUNT && status == GN_OK; ++i)
        volume->is_plane[i] = exact_plane(m, i, zero_to_one, &volume->exact[i]);
    return status == GN_OK;
}

static enum theft_trial_res planes_are_the_bounds(struct theft *t, void *arg)
{
    struct volume volume;
    (void)t;
    for (int convention = 0; convention < 2; ++convention) {
        if (!make_volume(arg, convention == 1, &volume))
            return THEFT_TRIAL_SKIP;
        for (int i = 0; i < GN_PLANE_COUNT; ++i)
            if (!plane_is(&volume.planes[i], volume.exact[i], volume.is_plane[i]))
                return THEFT_TRIAL_FAIL;
    }
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
        const wide sure =
            sums[i].terms < 0x1p127L ? 16.0L * WIDE_U * sums[i].terms * WIDE_SLACK : (wide)INFINITY;
        outside = outside || sums[i].most < 0.0L;
        inside = inside && sums[i].least >= 0.0L;
        surely_outside = surely_outside || sums[i].most < -sure;
        surely_inside = surely_inside && sums[i].least > sure;
    }
    return answer == GN_OUTSIDE  ? outside
           : answer == GN_INSIDE ? inside
                                 : !surely_outside && !surely_inside;
}

/* The magnitudes of a plane's terms as the contract of culling counts them. */
static wide counted(wide4 plane, wide4 place)
{
    const wide4 least = {{0x1p-120L, 0x1p-120L, 0x1p-120L, 0x1p-120L}};
    return dot(combined(1.0L, positive(plane), 1.0L, least), positive(place));
}

static enum theft_trial_res boxes_are_culled_safely(struct theft *t, void *arg1, void *arg2)
{
    const float *f = arg2;
    struct volume volume;
    struct sums sums[GN_PLANE_COUNT];
    if (!make_volume(arg1, theft_random_bits(t, 1) != 0, &volume))
        return THEFT_TRIAL_SKIP;

    /* The corner farthest along some plane's normal, or against it, and often on the plane. */
    const int touched = (int)theft_random_bits(t, 8) % GN_PLANE_COUNT;
    const wide4 plane = volume.exact[touched], corner = place_of(f);
    const bool touch = theft_random_bits(t, 2) != 0, behind = theft_random_bits(t, 1) != 0;
    const bool point = theft_random_bits(t, 3) == 0;
    const wide away = touch && volume.is_plane[touched] ? dot(plane, corner) : 0.0L;
    gn_box box;
    float *const low = &box.min.x, *const high = &box.max.x;
    for (int k = 0; k < 3; ++k) {
        const float from = (float)(corner.v[k] - away * plane.v[k]);
        const float size = point ? 0.0f : fabsf(f[3 + k]);
        const bool grows = (plane.v[k] < 0.0L) == behind;
        low[k] = grows ? from : from - size;
        high[k] = grows ? from + size : from;
    }
    if (!all_finite(low, 3) || !all_finite(high, 3))
        return verdict(gn_cull_box(volume.planes, &box) == GN_INTERSECTING);

    for (int i = 0; i < GN_PLANE_COUNT; ++i) {
        wide4 most = place_of(high), least = place_of(low), largest = most;
        for (int k = 0; k < 3; ++k) {
            largest.v[k] = fmaxl(fabsl(most.v[k]), fabsl(least.v[k]));
            if (volume.exact[i].v[k] < 0.0L) {
                most.v[k] = (wide)low[k];
                least.v[k] = (wide)high[k];
            }
        }
        sums[i] = (struct sums){dot(volume.exact[i], most), dot(volume.exact[i], least),
                                counted(volume.exact[i], largest)};
    }
    return verdict(answer_is(gn_cull_box(volume.planes, &box), sums));
}

static enum theft_trial_res spheres_are_culled_safely(struct theft *t, void *arg1, void *arg2)
{
    const float *f = arg2;
    struct volume volume;
    struct sums sums[GN_PLANE_COUNT];
    if (!make_volume(arg1, theft_random_bits(t, 1) != 0, &volume))
        return THEFT_TRIAL_SKIP;
    const int touched = (int)theft_random_bits(t, 8) % GN_PLANE_COUNT;
    const wide4 place = place_of(f);
    const bool touch = theft_random_bits(t, 2) != 0 && volume.is_plane[touched];
    const float radius = touch ? (float)fabsl(dot(volume.exact[touched], place)) : fabsf(f[3]);
    const gn_containment answer = gn_cull_sphere(volume.planes, vec3_of(f), radius);
    if (!isfinite(radius) || !all_finite(f, 3))
        return verdict(answer == GN_INTERSECTING);
    for (int i = 0; i < GN_PLANE_COUNT; ++i) {
        const wide away = dot(volume.exact[i], place);
        const wide reach = volume.is_plane[i] ? (wide)radius : 0.0L;
        sums[i] =
            (struct sums){away + reach, away - reach, counted(volume.exact[i], place) + reach};
    }
    return verdict(answer_is(answer, sums));
}

/* The same for a projection after a view or model. */
static enum theft_trial_res projections_cull_safely(struct theft *t, void *a, void *b, void *c)
{
    gn_mat4 m;
    gn_mat4_multiply(&((struct made *)a)->transform.matrix, &((struct made *)b)->transform.matrix,
                     &m);
    const enum theft_trial_res boxes = boxes_are_culled_safely(t, &m, c);
    return boxes == THEFT_TRIAL_PASS ? spheres_are_culled_safely(t, &m, c) : boxes;
}

static bool box_holds(const gn_box *box, wide4 p)
{
    const wide4 low = wide_vec(box->min), high = wide_vec(box->max);
    for (int k = 0; k < 3; ++k)
        if (!(p.v[k] >= low.v[k] && p.v[k] <= high.v[k]))
            return false;
    return true;
}

/* The exact and the rounded corners are in the box, and the box is little larger. */
static enum theft_trial_res boxes_hold_their_corners(struct theft *t, void *arg1, void *arg2)
{
    const gn_mat4 *m = arg1;
    const float *f = arg2;
    gn_box box, moved;
    float low[3], high[3];
    (void)t;
    for (int k = 0; k < 3; ++k) {
        low[k] = fminf(f[k], f[3 + k]);
        high[k] = fmaxf(f[k], f[3 + k]);
    }
    box.min = vec3_of(low);
    box.max = vec3_of(high);
    if (gn_mat4_transform_box(m, &box, &moved) != GN_OK)
        return THEFT_TRIAL_SKIP;
    wide least[3] = {INFINITY, INFINITY, INFINITY}, most[3] = {-INFINITY, -INFINITY, -INFINITY};
    wide terms[3] = {0.0L, 0.0L, 0.0L};
    for (int corner = 0; corner < 8; ++corner) {
        const float p[3] = {corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1],
                            corner & 4 ? high[2] : low[2]};
        const wide4 place = place_of(p);
        wide4 exact = {{0.0L}};
        for (int row = 0; row < 3; ++row) {
            const wide4 row_of = {
                {(wide)m->m[0][row], (wide)m->m[1][row], (wide)m->m[2][row], (wide)m->m[3][row]}};
            exact.v[row] = dot(row_of, place);
            least[row] = fminl(least[row], exact.v[row]);
            most[row] = fmaxl(most[row], exact.v[row]);
            terms[row] = fmaxl(terms[row], dot(positive(row_of), positive(place)));
        }
        if (!box_holds(&moved, exact) ||
            !box_holds(&moved, wide_vec(gn_mat4_transform_point(m, vec3_of(p)))))
            return THEFT_TRIAL_FAIL;
    }
    const wide4 got_low = wide_vec(moved.min), got_high = wide_vec(moved.max);
    for (int k = 0; k < 3; ++k) {
        const wide beyond = 12.0L * WIDE_U * terms[k] * WIDE_SLACK + 0x1p-146L;
        if (!(least[k] - got_low.v[k] <= beyond) || !(got_high.v[k] - most[k] <= beyond))
            return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

static const property geometry[] = {
    PROPERTY1("view volume: planes", planes_are_the_bounds, FLOATS_WITHIN(20)),
    PROPERTY1("view volume, any floats: planes", planes_are_the_bounds, ANY_FLOATS),
    PROPERTY3("culling, projections: boxes, spheres", projections_cull_safely,
              TRANSFORMS(ORTHOGRAPHIC, PERSPECTIVE + 1, 12), TRANSFORMS(0, AFFINE_KINDS, 8),
              FLOATS_WITHIN(20)),
    PROPERTY2("culling, any matrix: boxes", boxes_are_culled_safely, FLOATS_WITHIN(4),
              FLOATS_WITHIN(4)),
    PROPERTY2("culling, any matrix: spheres", spheres_are_culled_safely, FLOATS_WITHIN(4),
              FLOATS_WITHIN(4)),
    PROPERTY2("culling, any floats: boxes", boxes_are_culled_safely, FLOATS_WITHIN(4), ANY_FLOATS),
    PROPERTY2("culling, any floats: spheres", spheres_are_culled_safely, FLOATS_WITHIN(4),
              ANY_FLOATS),
    PROPERTY2("transformed boxes: corners within", boxes_hold_their_corners, FLOATS_WITHIN(20),
              FLOATS_WITHIN(20)),
    PROPERTY2("transformed boxes, any floats: corners within", boxes_hold_their_corners,
              FLOATS_WITHIN(20), ANY_FLOATS),
};

SUITE(properties_geometry, geometry);
