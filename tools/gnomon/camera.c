/* Places the camera and its clipping planes. */
#include "camera.h"

#include <math.h>

#include "report.h"

/* Margins around a framed sphere, and around it in depth. */
#define FRAME_MARGIN 1.02
#define DEPTH_MARGIN 1.01

/* The near plane if the eye is inside the sphere, as a fraction of the sphere and of the far
 * plane. */
#define NEAREST_OF_RADIUS 1e-3
#define NEAREST_OF_FAR 1e-4

/* The least distance from the middle to either clipping plane, as a fraction of the middle's
 * distance. It keeps the planes apart as floats if the eye is far away. */
#define THINNEST_SLICE 1e-4

static const double degree = 3.14159265358979323846 / 180.0;

/* The direction from the target to the eye: +z, or -y for models whose up is z, turned a little to
 * the right and lifted. It may have any length. */
static gn_vec3 default_direction(gn_vec3 up)
{
    gn_vec3 forward = {0.0f, 0.0f, 1.0f};
    gn_vec3 right;
    if (gn_vec3_normalize(up, &up) != GN_OK)
        return forward;
    if (fabsf(up.z) > 0.9f)
        forward = (gn_vec3){0.0f, -1.0f, 0.0f};
    right = gn_vec3_cross(up, forward);
    if (gn_vec3_normalize(right, &right) != GN_OK)
        return forward;
    forward = gn_vec3_cross(right, up);
    return gn_vec3_add(gn_vec3_add(forward, gn_vec3_scale(right, 0.4f)), gn_vec3_scale(up, 0.25f));
}

static bool is_zero(gn_vec3 v)
{
    return v.x == 0.0f && v.y == 0.0f && v.z == 0.0f;
}

static int check(const camera_options *asked)
{
    if (asked->orthographic && !(asked->orthographic_height > 0.0f))
        return report_fault("--orthographic", "impossible camera: the height must be above 0");
    if (!(asked->fov_degrees > 0.0f && asked->fov_degrees < 180.0f))
        return report_fault("--fov",
                            "impossible camera: the angle must be above 0 and below 180 degrees");
    if (!asked->orthographic && asked->near_given && !(asked->near > 0.0f))
        return report_fault("--near", "impossible camera: the distance must be above 0");
    if (!asked->orthographic && asked->far_given && !(asked->far > 0.0f))
        return report_fault("--far", "impossible camera: the distance must be above 0");
    if (asked->near_given && asked->far_given && !(asked->far > asked->near))
        return report_fault("--far", "impossible camera: it must be beyond --near");
    if (is_zero(asked->up))
        return report_fault("--up", "impossible camera: the vector is zero");
    return 0;
}

/* Reports that no camera can be computed, by an option that was given, or else by the models. */
static int report_impossible(const camera_options *asked, gn_status status)
{
    const char *const option = asked->eye_given      ? "--eye"
                               : asked->target_given ? "--target"
                               : asked->orthographic ? "--orthographic"
                               : asked->fov_given    ? "--fov"
                               : asked->near_given   ? "--near"
                               : asked->far_given    ? "--far"
                                                     : NULL;
    if (option != NULL)
        return report_fault(option, "impossible camera for these models: %s",
                            gn_status_text(status));
    return report_fault("camera",
                        "the models are too large, too small or too far from the origin: %s",
                        gn_status_text(status));
}

/* The distance from which a sphere of radius 1 just fits into the narrower of both angles. */
static double framing_distance(double fov_degrees, double aspect)
{
    double half = 0.5 * fov_degrees * degree;
    if (aspect < 1.0)
        half = atan(tan(half) * aspect);
    return FRAME_MARGIN / sin(half);
}

/* The distances of the clipping planes: those asked for, otherwise those around the sphere, which
 * are passed in. A plane that is not asked for makes way for one that is. */
static void choose_planes(const camera_options *asked, const bounding_sphere *sphere,
                          double *z_near, double *z_far)
{
    const double thickness = *z_far - *z_near;
    if (asked->far_given)
        *z_far = (double)asked->far;
    if (asked->near_given)
        *z_near = (double)asked->near;
    else if (!asked->orthographic)
        *z_near = fmax(*z_near, fmax(sphere->radius * NEAREST_OF_RADIUS, *z_far * NEAREST_OF_FAR));
    if (*z_far > *z_near || (asked->near_given && asked->far_given))
        return;
    /* Everything is behind the eye, or beyond the plane asked for. */
    if (asked->far_given)
        *z_near = asked->orthographic ? *z_far - thickness : *z_far * NEAREST_OF_FAR;
    else
        *z_far = asked->orthographic ? *z_near + thickness : *z_near * 2.0;
}

static gn_status project_in_perspective(convention_option convention, float fov_y, float aspect,
                                        float z_near, float z_far, gn_transform *result)
{
    switch (convention) {
    case CONVENTION_DIRECT3D:
        return gn_perspective_lh_zo(fov_y, aspect, z_near, z_far, result);
    case CONVENTION_VULKAN:
        return gn_perspective_rh_zo(fov_y, aspect, z_near, z_far, result);
    default:
        return gn_perspective_rh_no(fov_y, aspect, z_near, z_far, result);
    }
}

static gn_status project_in_parallel(convention_option convention, float right, float top,
                                     float z_near, float z_far, gn_transform *result)
{
    switch (convention) {
    case CONVENTION_DIRECT3D:
        return gn_orthographic_lh_zo(-right, right, -top, top, z_near, z_far, result);
    case CONVENTION_VULKAN:
        return gn_orthographic_rh_zo(-right, right, -top, top, z_near, z_far, result);
    default:
        return gn_orthographic_rh_no(-right, right, -top, top, z_near, z_far, result);
    }
}

static gn_status project(const camera_options *asked, double aspect, float z_near, float z_far,
                         gn_transform *result)
{
    const convention_option convention = asked->convention;
    const float half_height = 0.5f * asked->orthographic_height;
    const float half_width = (float)((double)half_height * aspect);
    const float fov = (float)((double)asked->fov_degrees * degree);
    gn_transform plain, flip;
    gn_status status =
        asked->orthographic
            ? project_in_parallel(convention, half_width, half_height, z_near, z_far, &plain)
            : project_in_perspective(convention, fov, (float)aspect, z_near, z_far, &plain);
    *result = plain;
    if (status == GN_OK && convention == CONVENTION_VULKAN) {
        gn_flip_y(&flip);
        status = gn_transform_compose(&flip, &plain, result);
    }
    return status;
}

/* The view space of a convention from that of OpenGL. */
static gn_status turn_view(convention_option convention, const gn_transform *view,
                           gn_transform *result)
{
    gn_transform flip;
    *result = *view;
    if (convention != CONVENTION_DIRECT3D)
        return GN_OK;
    gn_flip_z(&flip);
    return gn_transform_compose(&flip, view, result);
}

int camera_place(const camera_options *asked, const bounding_sphere *sphere, uint32_t width,
                 uint32_t height, camera *result)
{
    int fault = check(asked);
    if (fault != 0)
        return fault;

    double aspect = (double)width / (double)height;
    gn_vec3 center = {(float)sphere->center[0], (float)sphere->center[1], (float)sphere->center[2]};
    gn_vec3 target = asked->target_given ? asked->target : center;
    gn_vec3 eye = asked->eye;
    gn_vec3 up = asked->up;

    if (!asked->eye_given) {
        gn_vec3 direction = {0.0f, 0.0f, 1.0f};
        gn_vec3_normalize(default_direction(up), &direction);
        double distance = 2.0 * sphere->radius;
        if (!asked->orthographic)
            distance = sphere->radius * framing_distance((double)asked->fov_degrees, aspect);
        eye = gn_vec3_add(target, gn_vec3_scale(direction, (float)distance));
    }
    if (asked->eye_given && eye.x == target.x && eye.y == target.y && eye.z == target.z)
        return report_fault("--eye", "impossible camera: the eye is where the target is");

    gn_transform view;
    gn_status status = gn_look_at_rh(eye, target, up, &view);
    if (status == GN_DEGENERATE && !asked->up_given) {
        /* If the camera looks straight down or up, the top of the picture points away from +z. */
        up = (gn_vec3){0.0f, 0.0f, -1.0f};
        status = gn_look_at_rh(eye, target, up, &view);
    }
    if (status == GN_DEGENERATE)
        return report_fault("--up", "impossible camera: the vector is parallel to the view");
    if (status != GN_OK)
        return report_impossible(asked, status);

    double middle = -(double)gn_mat4_transform_point(&view.matrix, center).z;
    double half = fmax(sphere->radius * DEPTH_MARGIN, fabs(middle) * THINNEST_SLICE);
    double z_near = middle - half;
    double z_far = middle + half;
    choose_planes(asked, sphere, &z_near, &z_far);
    gn_transform projection, seen, clip;
    status = project(asked, aspect, (float)z_near, (float)z_far, &projection);
    if (status == GN_OK)
        status = turn_view(asked->convention, &view, &seen);
    if (status == GN_OK)
        status = gn_transform_compose(&projection, &seen, &clip);
    if (status != GN_OK)
        return report_impossible(asked, status);

    gn_vec3 light = {-0.35f, 0.5f, 1.0f};
    gn_vec3_normalize(gn_mat4_transform_direction(&view.inverse, light), &light);
    result->clip_from_world = clip.matrix;
    result->view_from_world = seen.matrix;
    result->clip_from_view = projection.matrix;
    result->zero_to_one = asked->convention != CONVENTION_OPENGL;
    result->y_down = asked->convention == CONVENTION_VULKAN;
    result->eye = eye;
    result->target = target;
    result->up = up;
    result->light_direction = light;
    return 0;
}
