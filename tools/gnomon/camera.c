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

/* An angle of view that any model can be seen with. */
#define PLAIN_FOV_DEGREES 40.0f

static const double degree = 3.14159265358979323846 / 180.0;

/* The direction from the target to the eye: that of the side, or else +z, or -y for models whose up
 * is z, turned a little to the right and lifted. It may have any length. */
static gn_vec3 direction_of(const camera_options *asked)
{
    gn_vec3 up = asked->up;
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
    if (!asked->side_given)
        return gn_vec3_add(gn_vec3_add(forward, gn_vec3_scale(right, 0.4f)),
                           gn_vec3_scale(up, 0.25f));
    switch (asked->side) {
    case SIDE_BACK:
        return gn_vec3_scale(forward, -1.0f);
    case SIDE_LEFT:
        return gn_vec3_scale(right, -1.0f);
    case SIDE_RIGHT:
        return right;
    case SIDE_TOP:
        return up;
    case SIDE_BOTTOM:
        return gn_vec3_scale(up, -1.0f);
    case SIDE_ISO:
        return gn_vec3_add(gn_vec3_add(forward, right), up);
    default:
        return forward;
    }
}

static bool are_equal(gn_vec3 a, gn_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
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
    if (are_equal(asked->up, (gn_vec3){0.0f, 0.0f, 0.0f}))
        return report_fault("--up", "impossible camera: the vector is zero");
    return 0;
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

/* A place of the options, from the origin of the sphere's space. */
static gn_vec3 from_origin(gn_vec3 place, const double rest[3], const double origin[3])
{
    return (gn_vec3){(float)((double)place.x + rest[0] - origin[0]),
                     (float)((double)place.y + rest[1] - origin[1]),
                     (float)((double)place.z + rest[2] - origin[2])};
}

/* Where the camera stands, looks and has its top; the eye and the target are those asked for, or
 * else those that frame the sphere. Writes the view too. */
static gn_status look_at(const camera_options *asked, const bounding_sphere *sphere, double aspect,
                         camera *result, gn_transform *view)
{
    const gn_vec3 center = {(float)sphere->center[0], (float)sphere->center[1],
                            (float)sphere->center[2]};
    result->target = center;
    if (asked->target_given)
        result->target = from_origin(asked->target, asked->target_rest, sphere->origin);
    result->eye = from_origin(asked->eye, asked->eye_rest, sphere->origin);
    result->up = asked->up;
    if (!asked->eye_given) {
        gn_vec3 direction = {0.0f, 0.0f, 1.0f};
        gn_vec3_normalize(direction_of(asked), &direction);
        double distance = 2.0 * sphere->radius;
        if (!asked->orthographic)
            distance = sphere->radius * framing_distance((double)asked->fov_degrees, aspect);
        result->eye = gn_vec3_add(result->target, gn_vec3_scale(direction, (float)distance));
    }
    gn_status status = gn_look_at_rh(result->eye, result->target, result->up, view);
    const bool is_side = asked->side_given && !asked->eye_given && !asked->target_given;
    if (status == GN_DEGENERATE && (!asked->up_given || is_side)) {
        /* If the camera looks straight down or up, the top of the picture points to the back. */
        result->up =
            fabsf(asked->up.z) > 0.9f ? (gn_vec3){0.0f, 1.0f, 0.0f} : (gn_vec3){0.0f, 0.0f, -1.0f};
        status = gn_look_at_rh(result->eye, result->target, result->up, view);
    }
    return status;
}

/* Computes the camera. If it returns GN_DEGENERATE, eye, target and up are set, and there is no
 * view of them. */
static gn_status place(const camera_options *asked, const bounding_sphere *sphere, double aspect,
                       camera *result)
{
    const gn_vec3 center = {(float)sphere->center[0], (float)sphere->center[1],
                            (float)sphere->center[2]};
    gn_transform view, projection, seen, clip;
    gn_status status = look_at(asked, sphere, aspect, result, &view);
    if (status != GN_OK)
        return status;

    double middle = -(double)gn_mat4_transform_point(&view.matrix, center).z;
    double half = fmax(sphere->radius * DEPTH_MARGIN, fabs(middle) * THINNEST_SLICE);
    double z_near = middle - half;
    double z_far = middle + half;
    choose_planes(asked, sphere, &z_near, &z_far);
    status = project(asked, aspect, (float)z_near, (float)z_far, &projection);
    if (status == GN_OK)
        status = turn_view(asked->convention, &view, &seen);
    if (status == GN_OK)
        status = gn_transform_compose(&projection, &seen, &clip);
    if (status != GN_OK)
        return status;

    gn_vec3 light = {-0.35f, 0.5f, 1.0f};
    gn_vec3_normalize(gn_mat4_transform_direction(&view.inverse, light), &light);
    result->clip_from_world = clip.matrix;
    result->view_from_world = seen.matrix;
    result->clip_from_view = projection.matrix;
    result->zero_to_one = asked->convention != CONVENTION_OPENGL;
    result->y_down = asked->convention == CONVENTION_VULKAN;
    result->light_direction = light;
    return GN_OK;
}

/* The parts of a camera that options set. */
enum { PART_NEAR, PART_FAR, PART_SIZE, PART_EYE, PART_TARGET, PART_COUNT };

/* The option that sets the part, null if it is not given. */
static const char *option_of(const camera_options *asked, int part)
{
    switch (part) {
    case PART_NEAR:
        return asked->near_given ? "--near" : NULL;
    case PART_FAR:
        return asked->far_given ? "--far" : NULL;
    case PART_SIZE:
        return asked->orthographic ? "--orthographic" : asked->fov_given ? "--fov" : NULL;
    case PART_EYE:
        return asked->eye_given ? "--eye" : NULL;
    default:
        return asked->target_given ? "--target" : NULL;
    }
}

/* Leaves the part to camera_place. */
static void leave_out(int part, const bounding_sphere *sphere, camera_options *asked)
{
    switch (part) {
    case PART_NEAR:
        asked->near_given = false;
        break;
    case PART_FAR:
        asked->far_given = false;
        break;
    case PART_SIZE:
        asked->orthographic_height = (float)(2.0 * sphere->radius);
        asked->fov_degrees = PLAIN_FOV_DEGREES;
        break;
    case PART_EYE:
        asked->eye_given = false;
        break;
    default:
        asked->target_given = false;
    }
}

/* The option that makes the camera impossible: the first one without which it is possible. If there
 * is none, but without all of them it is possible, the first of those that are given. Null: the
 * models are at fault. */
static const char *impossible_option(const camera_options *asked, const bounding_sphere *sphere,
                                     double aspect)
{
    camera_options none = *asked;
    const char *first = NULL;
    camera ignored;
    for (int part = 0; part < PART_COUNT; ++part) {
        const char *const option = option_of(asked, part);
        if (option == NULL)
            continue;
        camera_options others = *asked;
        leave_out(part, sphere, &others);
        if (place(&others, sphere, aspect, &ignored) == GN_OK)
            return option;
        leave_out(part, sphere, &none);
        first = first != NULL ? first : option;
    }
    return place(&none, sphere, aspect, &ignored) == GN_OK ? first : NULL;
}

int camera_place(const camera_options *asked, const bounding_sphere *sphere, uint32_t width,
                 uint32_t height, camera *result)
{
    const double aspect = (double)width / (double)height;
    camera placed;
    int fault = check(asked);
    if (fault != 0)
        return fault;
    const gn_status status = place(asked, sphere, aspect, &placed);
    if (status == GN_OK) {
        *result = placed;
        return 0;
    }
    const bool has_no_length = status == GN_DEGENERATE && are_equal(placed.eye, placed.target);
    if (has_no_length && asked->eye_given)
        return report_fault("--eye", "impossible camera: the eye is where the target is");
    if (status == GN_DEGENERATE && !has_no_length)
        return report_fault("--up", "impossible camera: the vector is parallel to the view");
    const char *const why =
        has_no_length ? "the eye would be where the target is" : gn_status_text(status);
    const char *const option = impossible_option(asked, sphere, aspect);
    if (option != NULL)
        return report_fault(option, "impossible camera for these models: %s", why);
    return report_fault("camera",
                        "the models are too large, too small or too far from the origin: %s", why);
}
