/* Computes the matrices of a setup, and its points at every stage. */
#include "transform.h"

#include <math.h>
#include <stdlib.h>

#include "report.h"
#include "rotation.h"

typedef gn_status finite_perspective(float, float, float, float, gn_transform *);
typedef gn_status infinite_perspective(float, float, float, gn_transform *);
typedef gn_status finite_box(float, float, float, float, float, float, gn_transform *);
typedef gn_status infinite_frustum(float, float, float, float, float, gn_transform *);

/* By convention, and whether depth is reversed. */
static finite_perspective *const perspectives[3][2] = {
    {gn_perspective_rh_no, gn_perspective_rh_no_reversed},
    {gn_perspective_lh_zo, gn_perspective_lh_zo_reversed},
    {gn_perspective_rh_zo, gn_perspective_rh_zo_reversed},
};
static infinite_perspective *const infinite_perspectives[3][2] = {
    {gn_perspective_rh_no_infinite, gn_perspective_rh_no_infinite_reversed},
    {gn_perspective_lh_zo_infinite, gn_perspective_lh_zo_infinite_reversed},
    {gn_perspective_rh_zo_infinite, gn_perspective_rh_zo_infinite_reversed},
};
static finite_box *const orthographics[3][2] = {
    {gn_orthographic_rh_no, gn_orthographic_rh_no_reversed},
    {gn_orthographic_lh_zo, gn_orthographic_lh_zo_reversed},
    {gn_orthographic_rh_zo, gn_orthographic_rh_zo_reversed},
};
static finite_box *const frusta[3][2] = {
    {gn_frustum_rh_no, gn_frustum_rh_no_reversed},
    {gn_frustum_lh_zo, gn_frustum_lh_zo_reversed},
    {gn_frustum_rh_zo, gn_frustum_rh_zo_reversed},
};
static infinite_frustum *const infinite_frusta[3][2] = {
    {gn_frustum_rh_no_infinite, gn_frustum_rh_no_infinite_reversed},
    {gn_frustum_lh_zo_infinite, gn_frustum_lh_zo_infinite_reversed},
    {gn_frustum_rh_zo_infinite, gn_frustum_rh_zo_infinite_reversed},
};

static int status_fault(const setup *s, unsigned long line, const char *what, gn_status status)
{
    return status == GN_OK ? 0
                           : transform_fault(s->file, line, "%s: %s", what, gn_status_text(status));
}

/* A fault of one direction; it may have any length but 0. */
static int direction_fault(const setup *s, unsigned long line, const char *what, gn_status status)
{
    if (status == GN_DEGENERATE)
        return transform_fault(s->file, line, "%s: the direction has no length", what);
    return status_fault(s, line, what, status);
}

/* The vector of a statement, or its default. */
static gn_vec3 vector(const setup *s, keyword which, float x, float y, float z)
{
    const float *n = s->given[which].number;
    gn_vec3 given = {n[0], n[1], n[2]}, otherwise = {x, y, z};
    return s->given[which].line > 0 ? given : otherwise;
}

/* T R S, with the rotations one after another. */
static int make_model(const setup *s, gn_transform *result)
{
    const gn_vec3 scale = vector(s, KEYWORD_SCALE, 1.0f, 1.0f, 1.0f), none = {0.0f, 0.0f, 0.0f};
    const gn_vec3 offset = vector(s, KEYWORD_TRANSLATE, 0.0f, 0.0f, 0.0f);
    gn_transform rotation, next;
    gn_mat3 turn;
    gn_transform_identity(&rotation);
    for (size_t i = 0; i < s->rotations.count; ++i) {
        const statement *r = &s->rotations.all[i];
        const gn_vec3 axis = {r->number[0], r->number[1], r->number[2]};
        gn_status status = rotation_about(axis, r->number[3], &next);
        if (status == GN_OK)
            status = gn_transform_compose(&next, &rotation, &rotation);
        if (status != GN_OK)
            return direction_fault(s, r->line, "rotate", status);
    }
    gn_mat4_upper_left(&rotation.matrix, &turn);
    if (scale.x == 0.0f || scale.y == 0.0f || scale.z == 0.0f)
        return transform_fault(s->file, s->given[KEYWORD_SCALE].line, "scale: a factor is zero");
    int fault =
        status_fault(s, s->given[KEYWORD_SCALE].line, "scale", gn_trs(none, &turn, scale, result));
    return fault != 0 ? fault
                      : status_fault(s, s->given[KEYWORD_TRANSLATE].line, "translate",
                                     gn_trs(offset, &turn, scale, result));
}

/* From right, up and forward, normalized. */
static int make_view_of_axes(const setup *s, gn_vec3 position, gn_transform *view)
{
    static const keyword names[3] = {KEYWORD_RIGHT, KEYWORD_UP, KEYWORD_FORWARD};
    const float ahead = s->convention == CONVENTION_DIRECT3D ? 1.0f : -1.0f;
    gn_vec3 axis[3];
    gn_transform camera;
    for (int i = 0; i < 3; ++i) {
        gn_status status = gn_vec3_normalize(vector(s, names[i], 0.0f, 0.0f, 0.0f), &axis[i]);
        if (status != GN_OK)
            return direction_fault(s, s->given[names[i]].line, transform_keyword(names[i]), status);
    }
    const unsigned long line = s->given[KEYWORD_FORWARD].line;
    axis[2] = gn_vec3_scale(axis[2], ahead);
    const float hand = gn_vec3_dot(gn_vec3_cross(axis[0], axis[1]), axis[2]);
    gn_status status = gn_frame_orthonormal(axis[0], axis[1], axis[2], position, &camera);
    if (status == GN_OUT_OF_RANGE)
        return transform_fault(s->file, line,
                               "right, up and forward are not perpendicular to each other");
    if (status == GN_OK && hand < 0.0f)
        return transform_fault(s->file, line,
                               "forward is opposite to what right and up make in a "
                               "%s-handed world",
                               ahead > 0.0f ? "left" : "right");
    if (status == GN_OK)
        status = gn_transform_invert(&camera, view);
    return status_fault(s, line, "camera", status);
}

static bool are_equal(gn_vec3 a, gn_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* "in line 7", or the default that a statement has if it is not given. */
static const char *where(const setup *s, keyword which, const char *otherwise)
{
    static char text[32];
    if (s->given[which].line == 0)
        return otherwise;
    snprintf(text, sizeof text, "in line %lu", s->given[which].line);
    return text;
}

/* Says why there is no view in this direction. */
static int view_fault(const setup *s, gn_vec3 position, gn_vec3 target, gn_vec3 up,
                      gn_status status)
{
    const gn_vec3 zero = {0.0f, 0.0f, 0.0f};
    const unsigned long up_line = s->given[KEYWORD_UP].line;
    const unsigned long target_line = s->given[KEYWORD_TARGET].line;
    if (status != GN_DEGENERATE)
        return status_fault(s, target_line > 0 ? target_line : up_line,
                            target_line > 0 ? "target" : "up", status);
    if (are_equal(up, zero))
        return direction_fault(s, up_line, "up", status);
    if (target_line == 0)
        return transform_fault(s->file, up_line,
                               "up: it is parallel to the view, which is along z");
    if (are_equal(target, position))
        return transform_fault(s->file, target_line, "target: it is where the camera is, %s",
                               where(s, KEYWORD_POSITION, "at 0 0 0"));
    return transform_fault(s->file, target_line, "target: the view is parallel to up, %s",
                           where(s, KEYWORD_UP, "which is 0 1 0 by default"));
}

static int make_view(const setup *s, gn_transform *view)
{
    const bool left_handed = s->convention == CONVENTION_DIRECT3D;
    const gn_vec3 position = vector(s, KEYWORD_POSITION, 0.0f, 0.0f, 0.0f);
    const gn_vec3 up = vector(s, KEYWORD_UP, 0.0f, 1.0f, 0.0f);
    const gn_vec3 target = vector(s, KEYWORD_TARGET, 0.0f, 0.0f, 0.0f);
    const gn_vec3 ahead = {0.0f, 0.0f, left_handed ? 1.0f : -1.0f};
    gn_status status;
    if (s->given[KEYWORD_RIGHT].line > 0)
        return make_view_of_axes(s, position, view);
    if (s->given[KEYWORD_TARGET].line > 0)
        status = left_handed ? gn_look_at_lh(position, target, up, view)
                             : gn_look_at_rh(position, target, up, view);
    else
        status = left_handed ? gn_look_to_lh(position, ahead, up, view)
                             : gn_look_to_rh(position, ahead, up, view);
    return status == GN_OK ? 0 : view_fault(s, position, target, up, status);
}

/* A fault of one number of the setup, named by its own statement. */
static int number_fault(const setup *s, keyword which, const char *why)
{
    return transform_fault(s->file, s->given[which].line, "%s: %s", transform_keyword(which), why);
}

/* Checks the numbers of a projection. The functions of the library take planes in either order;
 * here the plane that is called near is the nearer one. */
static int check_projection(const setup *s, keyword which)
{
    const statement *g = s->given;
    const float *n = g[which].number;
    const float z_near = g[KEYWORD_NEAR].number[0], z_far = g[KEYWORD_FAR].number[0];
    if (which == KEYWORD_PERSPECTIVE && !(n[0] > 0.0f && n[0] < 180.0f))
        return number_fault(s, which, "the angle is not within 0 to 180 degrees");
    if (which != KEYWORD_PERSPECTIVE && n[0] == n[1])
        return number_fault(s, which, "left and right are the same");
    if (which != KEYWORD_PERSPECTIVE && n[2] == n[3])
        return number_fault(s, which, "bottom and top are the same");
    if (which != KEYWORD_ORTHOGRAPHIC && !(z_near > 0.0f))
        return number_fault(s, KEYWORD_NEAR, "it is not above 0");
    if (s->infinite)
        return 0;
    if (which != KEYWORD_ORTHOGRAPHIC && !(z_far > 0.0f))
        return number_fault(s, KEYWORD_FAR, "it is not above 0");
    if (!(z_far > z_near))
        return transform_fault(s->file, g[KEYWORD_FAR].line,
                               "far: it is not beyond near, which is in line %lu",
                               g[KEYWORD_NEAR].line);
    return 0;
}

/* Says why there is no projection of numbers that are right one by one. */
static int projection_fault(const setup *s, keyword which, gn_status status)
{
    return number_fault(
        s, which,
        status == GN_OUT_OF_RANGE || status == GN_SINGULAR
            ? "a number of the matrix or of its inverse would be too large or too small"
            : gn_status_text(status));
}

static int make_projection(const setup *s, gn_transform *projection)
{
    const statement *g = s->given;
    const float z_near = g[KEYWORD_NEAR].number[0], z_far = g[KEYWORD_FAR].number[0];
    const int c = s->convention, r = s->reversed;
    keyword which = KEYWORD_PERSPECTIVE;
    while (g[which].line == 0)
        ++which;
    const float *n = g[which].number;
    gn_status status;
    const int fault = check_projection(s, which);
    if (fault != 0)
        return fault;
    if (which == KEYWORD_ORTHOGRAPHIC) {
        status = orthographics[c][r](n[0], n[1], n[2], n[3], z_near, z_far, projection);
    } else if (which == KEYWORD_FRUSTUM) {
        status = s->infinite ? infinite_frusta[c][r](n[0], n[1], n[2], n[3], z_near, projection)
                             : frusta[c][r](n[0], n[1], n[2], n[3], z_near, z_far, projection);
    } else {
        const float fov = rotation_radians(n[0]);
        const float aspect = g[KEYWORD_SCREEN].number[0] / g[KEYWORD_SCREEN].number[1];
        status = s->infinite ? infinite_perspectives[c][r](fov, aspect, z_near, projection)
                             : perspectives[c][r](fov, aspect, z_near, z_far, projection);
    }
    if (status == GN_OK && s->convention == CONVENTION_VULKAN) {
        gn_transform flip;
        gn_flip_y(&flip);
        status = gn_transform_compose(&flip, projection, projection);
    }
    return status == GN_OK ? 0 : projection_fault(s, which, status);
}

static int make_viewport(const setup *s, gn_transform *viewport)
{
    const float *size = s->given[KEYWORD_SCREEN].number;
    gn_status status =
        s->convention == CONVENTION_OPENGL
            ? gn_viewport_no(0.0f, 0.0f, size[0], size[1], 0.0f, 1.0f, viewport)
        : s->convention == CONVENTION_VULKAN
            ? gn_viewport_zo(0.0f, 0.0f, size[0], size[1], 0.0f, 1.0f, viewport)
            : gn_viewport_zo_y_down(0.0f, 0.0f, size[0], size[1], 0.0f, 1.0f, viewport);
    return status_fault(s, s->given[KEYWORD_SCREEN].line, "screen", status);
}

/* The planes that the clip coordinates are beyond. Vulkan's clip y points down. With reversed
 * depth, near and far are exchanged. */
static unsigned outside(const setup *s, gn_vec4 c)
{
    const unsigned low = s->reversed ? OUTSIDE_FAR : OUTSIDE_NEAR;
    const unsigned high = s->reversed ? OUTSIDE_NEAR : OUTSIDE_FAR;
    const float up = s->convention == CONVENTION_VULKAN ? -c.y : c.y;
    const float least = s->convention == CONVENTION_OPENGL ? -c.w : 0.0f;
    return (c.x < -c.w ? OUTSIDE_LEFT : 0u) | (c.x > c.w ? OUTSIDE_RIGHT : 0u) |
           (up < -c.w ? OUTSIDE_BOTTOM : 0u) | (up > c.w ? OUTSIDE_TOP : 0u) |
           (c.z < least ? low : 0u) | (c.z > c.w ? high : 0u);
}

static int compute_place(const setup *s, const statement *point, const places *p, place *result)
{
    const gn_vec3 local = {point->number[0], point->number[1], point->number[2]};
    result->local = local;
    result->world = gn_mat4_transform_point(&p->model.matrix, local);
    result->view = gn_mat4_transform_point(&p->view.matrix, result->world);
    const gn_vec4 view = {result->view.x, result->view.y, result->view.z, 1.0f};
    result->clip = gn_mat4_multiply_vec4(&p->projection.matrix, view);
    switch (gn_clip_to_ndc(result->clip, &result->ndc)) {
    case GN_OK:
        result->pixel = gn_mat4_transform_point(&p->viewport.matrix, result->ndc);
        result->division =
            isfinite(result->pixel.x) && isfinite(result->pixel.y) && isfinite(result->pixel.z)
                ? DIVIDED
                : TOO_LARGE;
        break;
    case GN_BEHIND_EYE:
        result->division = result->clip.w < 0.0f ? BEHIND_EYE : IN_EYE_PLANE;
        break;
    case GN_OUT_OF_RANGE:
        result->division = TOO_LARGE;
        break;
    default:
        return transform_fault(s->file, point->line, "point: its coordinates overflow");
    }
    result->outside = outside(s, result->clip);
    return 0;
}

static void combine(places *p)
{
    gn_transform *combined = &p->combined;
    p->has_combined = gn_transform_compose(&p->view, &p->model, combined) == GN_OK &&
                      gn_transform_compose(&p->projection, combined, combined) == GN_OK;
}

int transform_compute(const setup *s, places *result)
{
    int fault = make_model(s, &result->model);
    if (fault == 0)
        fault = make_view(s, &result->view);
    if (fault == 0)
        fault = make_projection(s, &result->projection);
    if (fault == 0)
        fault = make_viewport(s, &result->viewport);
    if (fault != 0)
        return fault;
    combine(result);
    result->all = calloc(s->points.count + 1, sizeof *result->all);
    if (result->all == NULL)
        return report_fault(s->file, "not enough memory");
    for (; fault == 0 && result->count < s->points.count; ++result->count)
        fault =
            compute_place(s, &s->points.all[result->count], result, &result->all[result->count]);
    return fault;
}

void transform_places_free(places *p)
{
    free(p->all);
}
