/* Properties of projections, viewports and the transforms between conventions. Expected values come
 * from the definition of the volume, bounds from the public headers; sums of the stored floats are
 * computed in double. */
#include <math.h>
#include <string.h>

#include <gnomon.h>

#include "double_matrix.h"
#include "random_inputs.h"
#include "random_projections.h"

/* |E| <= factor u |M||M^-1|, for both orders of the product. */
static bool inverts(const gn_mat4 *a, const gn_mat4 *b, double factor)
{
    const matrix m = widened(a), inverse = widened(b);
    const matrix m_size = magnitudes(m), inverse_size = magnitudes(inverse);
    return within(lack(m, inverse), scaled(factor * U, product(m_size, inverse_size))) &&
           within(lack(inverse, m), scaled(factor * U, product(inverse_size, m_size)));
}

/* The inverse in the pair, and the inverse computed from the matrix's entries, also for a matrix
 * whose clip w is scaled. */
static enum theft_trial_res projections_have_inverses(struct theft *t, void *arg)
{
    const struct projection *p = arg;
    const gn_transform *both = &p->transform;
    gn_mat4 inverse, stretched = both->matrix;
    if (!inverts(&both->matrix, &both->inverse, 1.0))
        return THEFT_TRIAL_FAIL;
    if (p->volume == BOX)
        return verdict(gn_mat4_invert_orthographic(&both->matrix, &inverse) == GN_OK &&
                       memcmp(&inverse, &both->inverse, sizeof inverse) == 0);
    if (gn_mat4_invert_perspective(&both->matrix, &inverse) != GN_OK ||
        memcmp(&inverse, &both->inverse, sizeof inverse) != 0)
        return THEFT_TRIAL_FAIL;
    stretched.m[2][3] = random_number(t, 10);
    return verdict(gn_mat4_invert_perspective(&stretched, &inverse) == GN_OK &&
                   inverts(&stretched, &inverse, 3.0));
}

/* Depths of the near and the far plane, by name. */
static void depths_of(struct convention c, double depths[2])
{
    depths[c.reversed] = c.zero_to_one ? 0.0 : -1.0;
    depths[!c.reversed] = 1.0;
}

/* The eight corners of a volume, those at infinity as directions, become the corners of the clip
 * volume, within the bounds of each coordinate. */
static enum theft_trial_res corners_go_to_corners(struct theft *t, void *arg)
{
    const struct projection *p = arg;
    const matrix m = widened(&p->transform.matrix);
    const double hand = p->convention.left_handed ? 1.0 : -1.0;
    double planes[6], depths[2];
    (void)t;
    planes_of(p, planes);
    depths_of(p->convention, depths);
    for (int corner = 0; corner < 8; ++corner) {
        const int far = corner >> 2;
        const double distance = planes[4 + far], other = planes[5 - far];
        const double apart = fabs(planes[5] - planes[4]);
        const bool direction = isinf(distance);
        const double z = direction ? hand : hand * distance, w = direction ? 0.0 : 1.0;
        const double spread = p->volume == BOX ? 1.0
                              : direction      ? 1.0 / planes[4]
                                               : distance / planes[4];
        const double clip_w = m.m[2][3] * z + m.m[3][3] * w;
        if (clip_w != (p->volume == BOX ? 1.0 : fabs(z)))
            return THEFT_TRIAL_FAIL;
        for (int axis = 0; axis < 2; ++axis) {
            const int side = corner >> axis & 1;
            const double scaled_x = m.m[axis][axis] * planes[2 * axis + side] * spread / clip_w;
            const double skew = (m.m[2][axis] * z + m.m[3][axis] * w) / clip_w;
            const double bound = 3.0 * U * (fabs(scaled_x) + fabs(skew)) * SLACK;
            if (!(fabs(scaled_x + skew - (side ? 1.0 : -1.0)) <= bound))
                return THEFT_TRIAL_FAIL;
        }
        const double scaled_z = m.m[2][2] * z, depth = (scaled_z + m.m[3][2] * w) / clip_w;
        double bound = 0.0;
        if (p->volume == BOX)
            bound = 3.0 * U * (fabs(scaled_z) + fabs(m.m[3][2]));
        else if (!p->convention.infinite && !p->convention.zero_to_one)
            bound = 4.0 * U * (3.0 * other + distance) / apart;
        else if (!p->convention.infinite)
            bound = U * other / apart + 2.0 * U * depths[far];
        if (!(fabs(depth - depths[far]) <= bound * SLACK))
            return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

/* By depth range, then with y up and down. */
static gn_status (*const viewports[4])(float, float, float, float, float, float, gn_transform *) = {
    gn_viewport_no, gn_viewport_no_y_down, gn_viewport_zo, gn_viewport_zo_y_down};

/* Viewports: -1 and 1 become the named borders, and back. */
static enum theft_trial_res viewports_fill_windows(struct theft *t, void *arg)
{
    const float *f = arg;
    const float n[6] = {f[0], f[1], fabsf(f[2]), fabsf(f[3]), f[4], f[5]};
    (void)t;
    if (n[4] == n[5])
        return THEFT_TRIAL_SKIP;
    for (int kind = 0; kind < 4; ++kind) {
        gn_transform view;
        gn_mat4 inverse;
        if (viewports[kind](n[0], n[1], n[2], n[3], n[4], n[5], &view) != GN_OK ||
            !inverts(&view.matrix, &view.inverse, 1.0) ||
            gn_mat4_invert_orthographic(&view.matrix, &inverse) != GN_OK ||
            memcmp(&inverse, &view.inverse, sizeof inverse) != 0)
            return THEFT_TRIAL_FAIL;
        const matrix m = widened(&view.matrix);
        for (int end = 0; end < 2; ++end) {
            const bool down = kind % 2 == 1, zero_to_one = kind >= 2;
            const double side = end ? 1.0 : -1.0;
            const double ndc[3] = {side, side, zero_to_one && !end ? 0.0 : side};
            const double expected[3] = {(double)n[0] + (end ? (double)n[2] : 0.0),
                                        (double)n[1] + (end != down ? (double)n[3] : 0.0),
                                        (double)n[end ? 5 : 4]};
            for (int axis = 0; axis < 3; ++axis) {
                const double moved = m.m[axis][axis] * ndc[axis], offset = m.m[3][axis];
                if (!(fabs(moved + offset - expected[axis]) <=
                      2.0 * U * (fabs(moved) + fabs(offset)) * SLACK))
                    return THEFT_TRIAL_FAIL;
            }
        }
    }
    return THEFT_TRIAL_PASS;
}

/* A camera somewhere, and a window. */
struct camera {
    gn_vec3 eye, target, up;
    float x, y, width, height;
};

static struct camera camera_of(const float *f)
{
    return (struct camera){vec3_of(f), vec3_of(f + 3), vec3_of(f + 6), f[9],
                           f[10],      fabsf(f[11]),   fabsf(f[12])};
}

/* A way to the window: the projection in a convention, with transforms before and after it, and the
 * viewport. */
struct route {
    struct convention convention;
    bool mirrored_world; /* seen by gn_look_at_lh instead of gn_flip_z */
    gn_status (*after)(gn_transform *);
    bool zero_to_one, y_down, depth_reversed; /* of the viewport */
    bool down;                                /* window y is measured from the top */
};

#define NOTHING gn_transform_identity

static const struct route routes[] = {
    {{0, 0, 0, 0}, 0, NOTHING, 0, 0, 0, 0},   /* OpenGL */
    {{1, 1, 0, 0}, 0, NOTHING, 1, 1, 0, 1},   /* Direct3D */
    {{1, 1, 0, 0}, 1, NOTHING, 1, 1, 0, 1},   /* Direct3D in its own world */
    {{0, 1, 0, 0}, 0, gn_flip_y, 1, 0, 0, 1}, /* Vulkan */
    {{0, 1, 1, 0}, 0, gn_flip_y, 1, 0, 1, 1}, /* Vulkan, reversed */
    {{0, 0, 0, 0}, 0, gn_clip_no_to_zo, 1, 0, 0, 0},
    {{1, 1, 0, 0}, 0, gn_clip_zo_to_no, 0, 1, 0, 1},
    {{0, 1, 0, 0}, 0, gn_clip_reverse_zo, 1, 0, 1, 0},
    {{0, 1, 1, 0}, 0, gn_clip_reverse_zo, 1, 0, 0, 0},
    {{1, 0, 1, 0}, 1, gn_flip_z, 0, 0, 0, 0},
    {{1, 0, 1, 0}, 0, NOTHING, 0, 1, 1, 1},
};

/* The stages of a route: view, projection with the step after it, viewport. */
struct stages {
    gn_transform view, projection, viewport;
};

static bool follow(const struct route *route, const struct projection *p, const struct camera *c,
                   struct stages *stages)
{
    struct convention convention = route->convention;
    const float first = route->depth_reversed ? 1.0f : 0.0f;
    gn_transform step;
    gn_vec3 eye = c->eye, target = c->target, up = c->up;
    gn_status status;
    convention.infinite = p->convention.infinite;
    if (route->mirrored_world) {
        eye.z = -eye.z;
        target.z = -target.z;
        up.z = -up.z;
        status = gn_look_at_lh(eye, target, up, &stages->view);
    } else {
        status = gn_look_at_rh(eye, target, up, &stages->view);
        if (status == GN_OK && convention.left_handed && (status = gn_flip_z(&step)) == GN_OK)
            status = gn_transform_compose(&step, &stages->view, &stages->view);
    }
    return status == GN_OK && project_in(p, convention, &stages->projection) == GN_OK &&
           route->after(&step) == GN_OK &&
           gn_transform_compose(&step, &stages->projection, &stages->projection) == GN_OK &&
           viewports[2 * route->zero_to_one + route->y_down](
               c->x, c->y, c->width, c->height, first, 1.0f - first, &stages->viewport) == GN_OK;
}

/* Window coordinates of a point of view space, y up, computed from the planes alone. */
static void window_of(const struct projection *p, const struct camera *c, const double view[3],
                      double window[3])
{
    double planes[6];
    planes_of(p, planes);
    const double t = -view[2], z_near = planes[4], z_far = planes[5];
    const double shrink = p->volume == BOX ? 1.0 : z_near / t;
    window[0] =
        (double)c->x + (double)c->width * (view[0] * shrink - planes[0]) / (planes[1] - planes[0]);
    window[1] =
        (double)c->y + (double)c->height * (view[1] * shrink - planes[2]) / (planes[3] - planes[2]);
    window[2] = p->volume == BOX ? (t - z_near) / (z_far - z_near)
                : isinf(z_far)   ? 1.0 - z_near / t
                                 : (1.0 / z_near - 1.0 / t) / (1.0 / z_near - 1.0 / z_far);
}

static void column(const matrix *m, const double v[4], double result[4])
{
    for (int row = 0; row < 4; ++row) {
        result[row] = 0.0;
        for (int k = 0; k < 4; ++k)
            result[row] += m->m[k][row] * v[k];
    }
}

/* How far errors e of the coordinates c move c / c.w, to first order; `division` is for the
 * rounding of the division itself. */
static double divided_error(const double c[4], const double e[4], int axis, double division)
{
    const double quotient = fabs(c[axis] / c[3]);
    return (e[axis] + quotient * e[3]) / fabs(c[3]) + division * U * quotient;
}

/* One camera draws equal pixels in every convention. The error is at most 32 u of the terms:
 * rounding the entries (3 u at most each), composing the step, the view and the projection, and
 * transforming the point. */
static enum theft_trial_res conventions_agree(struct theft *t, void *arg1, void *arg2)
{
    const struct projection *p = arg1;
    const struct camera c = camera_of(arg2);
    const double at = 0.05 + 0.9 * (double)theft_random_bits(t, 16) * 0x1p-16;
    struct stages stages;
    double planes[6], window[3], view[4];
    if (!follow(&routes[0], p, &c, &stages))
        return THEFT_TRIAL_SKIP;
    planes_of(p, planes);
    const double reach = isinf(planes[5]) ? 10.0 * planes[4] : planes[5];
    const float distance = (float)(planes[4] + at * (reach - planes[4]));
    const double spread = p->volume == BOX ? 1.0 : (double)distance / planes[4];
    const gn_vec3 seen = {(float)((planes[0] + at * (planes[1] - planes[0])) * spread),
                          (float)((planes[3] + at * (planes[2] - planes[3])) * spread), -distance};
    const gn_vec3 point = gn_mat4_transform_point(&stages.view.inverse, seen);
    const double world[4] = {(double)point.x, (double)point.y, (double)point.z, 1.0};
    const matrix first_view = widened(&stages.view.matrix);
    column(&first_view, world, view);
    window_of(p, &c, view, window);
    for (size_t i = 0; i < sizeof routes / sizeof routes[0]; ++i) {
        const struct route *route = &routes[i];
        gn_transform to_clip;
        gn_vec3 from = point, got;
        if (route->mirrored_world)
            from.z = -from.z;
        if (!follow(route, p, &c, &stages) ||
            gn_transform_compose(&stages.projection, &stages.view, &to_clip) != GN_OK)
            return THEFT_TRIAL_FAIL;
        const matrix exact =
            product(widened(&stages.projection.matrix), widened(&stages.view.matrix));
        const matrix terms = product(magnitudes(widened(&stages.projection.matrix)),
                                     magnitudes(widened(&stages.view.matrix)));
        const double place[4] = {(double)from.x, (double)from.y, (double)from.z, 1.0};
        const double size[4] = {fabs(place[0]), fabs(place[1]), fabs(place[2]), 1.0};
        double clip[4], error[4];
        column(&exact, place, clip);
        column(&terms, size, error);
        for (int k = 0; k < 4; ++k)
            error[k] *= 32.0 * U;
        if (error[3] > 0x1p-8 * clip[3])
            return THEFT_TRIAL_SKIP;
        if (gn_project(&to_clip, &stages.viewport, from, &got) != GN_OK)
            return THEFT_TRIAL_FAIL;
        const double y = (double)c.y + (double)c.height - (window[1] - (double)c.y);
        const double expected[3] = {window[0], route->down ? y : window[1], window[2]};
        const double result[3] = {(double)got.x, (double)got.y, (double)got.z};
        const matrix placing = widened(&stages.viewport.matrix);
        for (int axis = 0; axis < 3; ++axis) {
            const double scale = fabs(placing.m[axis][axis]), offset = fabs(placing.m[3][axis]);
            const double bound =
                scale * divided_error(clip, error, axis, 8.0) + 4.0 * U * (scale + offset);
            if (!(fabs(result[axis] - expected[axis]) <= bound * (1.0 + 0x1p-6)))
                return THEFT_TRIAL_FAIL;
        }
    }
    return THEFT_TRIAL_PASS;
}

/* gn_project and gn_unproject, each within the bounds of project.h. */
static enum theft_trial_res projecting_is_right(struct theft *t, void *arg1, void *arg2)
{
    const struct projection *p = arg1;
    const struct camera c = camera_of(arg2);
    const struct route route = {
        p->convention, 0, NOTHING, p->convention.zero_to_one, theft_random_bits(t, 1) != 0, 0, 0};
    struct stages stages;
    gn_transform to_clip;
    gn_vec3 window, back;
    if (!follow(&route, p, &c, &stages) ||
        gn_transform_compose(&stages.projection, &stages.view, &to_clip) != GN_OK)
        return THEFT_TRIAL_SKIP;
    const float x = random_number(t, 4), y = random_number(t, 4);
    const gn_vec3 seen = {x, y, p->convention.left_handed ? 8.0f : -8.0f};
    const gn_vec3 point = gn_mat4_transform_point(&stages.view.inverse, seen);
    const gn_status status = gn_project(&to_clip, &stages.viewport, point, &window);
    const matrix m = widened(&to_clip.matrix), inverse = widened(&to_clip.inverse);
    const matrix m_size = magnitudes(m), inverse_size = magnitudes(inverse);
    const matrix placing = widened(&stages.viewport.matrix);
    const matrix lifting = widened(&stages.viewport.inverse);
    const double place[4] = {(double)point.x, (double)point.y, (double)point.z, 1.0};
    const double size[4] = {fabs(place[0]), fabs(place[1]), fabs(place[2]), 1.0};
    double clip[4], error[4], ndc[4], ndc_error[4], ndc_size[4];
    column(&m, place, clip);
    column(&m_size, size, error);
    for (int k = 0; k < 4; ++k)
        error[k] *= 4.0 * U;
    if (error[3] > 0x1p-10 * fabs(clip[3]))
        return THEFT_TRIAL_SKIP;
    if (status != (clip[3] > 0.0 ? GN_OK : GN_BEHIND_EYE))
        return THEFT_TRIAL_FAIL;
    if (status != GN_OK)
        return THEFT_TRIAL_SKIP;

    const double got[3] = {(double)window.x, (double)window.y, (double)window.z};
    for (int axis = 0; axis < 3; ++axis) {
        const double scale = placing.m[axis][axis], offset = placing.m[3][axis];
        const double moved = scale * clip[axis] / clip[3];
        const double off = fabs(scale) * divided_error(clip, error, axis, 4.0) + U * fabs(offset);
        if (!(fabs(got[axis] - (moved + offset)) <= off * (1.0 + 0x1p-8)))
            return THEFT_TRIAL_FAIL;
        ndc[axis] = lifting.m[axis][axis] * got[axis] + lifting.m[3][axis];
        ndc_error[axis] =
            U * (2.0 * fabs(lifting.m[axis][axis] * got[axis]) + fabs(lifting.m[3][axis]));
        ndc_size[axis] = fabs(ndc[axis]);
    }
    ndc[3] = ndc_size[3] = 1.0;
    ndc_error[3] = 0.0;

    double lifted[4], from_ndc[4], from_size[4];
    column(&inverse, ndc, lifted);
    column(&inverse_size, ndc_error, from_ndc);
    column(&inverse_size, ndc_size, from_size);
    for (int k = 0; k < 4; ++k)
        error[k] = from_ndc[k] + 4.0 * U * from_size[k];
    if (error[3] > 0x1p-10 * fabs(lifted[3]))
        return THEFT_TRIAL_SKIP;
    if (gn_unproject(&to_clip, &stages.viewport, window, &back) !=
        (lifted[3] > 0.0 ? GN_OK : GN_BEHIND_EYE))
        return THEFT_TRIAL_FAIL;
    const double returned[3] = {(double)back.x, (double)back.y, (double)back.z};
    for (int axis = 0; axis < 3; ++axis)
        if (!(fabs(returned[axis] - lifted[axis] / lifted[3]) <=
              divided_error(lifted, error, axis, 2.0) * (1.0 + 0x1p-8)))
            return THEFT_TRIAL_FAIL;
    return THEFT_TRIAL_PASS;
}

/* For clip coordinates of any floats, gn_clip_to_ndc returns the status of its contract, or
 * quotients within two roundings. */
static enum theft_trial_res division_is_right(struct theft *t, void *arg)
{
    const float *f = arg;
    (void)t;
    for (int i = 0; i + 3 < FLOATS; ++i) {
        const gn_vec4 clip = vec4_of(f + i);
        const double x[3] = {(double)clip.x, (double)clip.y, (double)clip.z}, w = (double)clip.w;
        const bool finite = all_finite(f + i, 4);
        gn_vec3 ndc = {7.0f, 7.0f, 7.0f};
        const gn_status status = gn_clip_to_ndc(clip, &ndc);
        if (!finite || w <= 0.0) {
            if (status != (finite ? GN_BEHIND_EYE : GN_NOT_FINITE) || ndc.x != 7.0f)
                return THEFT_TRIAL_FAIL;
            continue;
        }
        const double largest = fmax(fabs(x[0]), fmax(fabs(x[1]), fabs(x[2]))) / w;
        if (status == GN_OUT_OF_RANGE) {
            if (largest < 0x1.fffffp127 && w >= 0x1p-126)
                return THEFT_TRIAL_FAIL;
            continue;
        }
        const double got[3] = {(double)ndc.x, (double)ndc.y, (double)ndc.z};
        /* A reciprocal below 2^-126 is rounded to a multiple of 2^-149. */
        const double reciprocal = w > 0x1p126 ? 0x1p-150 * w : 0.0;
        for (int k = 0; k < 3; ++k)
            if (status != GN_OK || !(fabs(got[k] - x[k] / w) <=
                                     (2.0 * U * SLACK + reciprocal) * fabs(x[k] / w) + 0x1p-149))
                return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

/* gn_perspective_fault finds nothing where every convention returns GN_OK and near is not above
 * far, and only there. */
static enum theft_trial_res perspective_faults_agree(struct theft *t, void *arg)
{
    const float *f = arg;
    (void)t;
    for (int i = 0; i + 3 < FLOATS; ++i) {
        const struct projection p = {.volume = SYMMETRIC,
                                     .numbers = {f[i], f[i + 1], f[i + 2], f[i + 3]}};
        gn_transform result;
        bool good[2] = {!(f[i + 2] > f[i + 3]), true}; /* with a far plane, and without */
        for (int c = 0; c < 16; ++c) {
            const struct convention convention = {c & 1, c & 2, c & 4, c & 8};
            good[c >> 3] &= project_in(&p, convention, &result) == GN_OK;
        }
        const bool is_endless = isinf(f[i + 3]) && f[i + 3] > 0.0f;
        const bool found = gn_perspective_fault(f[i], f[i + 1], f[i + 2], f[i + 3]) != NULL;
        const bool found_endless = gn_perspective_fault(f[i], f[i + 1], f[i + 2], INFINITY) != NULL;
        if (found == good[is_endless] || found_endless == good[1])
            return THEFT_TRIAL_FAIL;
    }
    return THEFT_TRIAL_PASS;
}

static const property projections[] = {
    PROPERTY1("projections of every convention: inverse", projections_have_inverses,
              PROJECTIONS(30, false)),
    PROPERTY1("projections of every convention: corners to corners", corners_go_to_corners,
              PROJECTIONS(30, false)),
    PROPERTY1("viewports of every convention: borders, inverse", viewports_fill_windows,
              FLOATS_WITHIN(60)),
    PROPERTY2("conventions: the same window coordinates", conventions_agree, PROJECTIONS(5, true),
              FLOATS_WITHIN(5)),
    PROPERTY2("project, unproject: within bounds", projecting_is_right, PROJECTIONS(5, true),
              FLOATS_WITHIN(5)),
    PROPERTY1("clip to NDC: quotients", division_is_right, ANY_FLOATS),
    PROPERTY1("perspective: faults in words, any floats", perspective_faults_agree, ANY_FLOATS),
    PROPERTY1("perspective: faults in words, moderate floats", perspective_faults_agree,
              FLOATS_WITHIN(5)),
};

SUITE(properties_projections, projections);
