/* Moves cameras. */
#include "orbit.h"

#include <math.h>

/* Degrees for a pixel, and the greatest angle above and below the horizon. */
#define TURN_SPEED 0.4
#define STEEPEST 89.0

#define ZOOM_STEP 0.9

/* Distances beyond which a float's neighbours are visible. */
#define LEAST_DISTANCE 1e-18
#define GREATEST_DISTANCE 1e18

static const double degree = 3.14159265358979323846 / 180.0;

/* The frame of the camera: its axes, and its distance from the target. */
typedef struct frame {
    gn_vec3 up, east, north; /* the directions of the angles; unit length */
    double distance, azimuth, elevation;
} frame;

static double dot(gn_vec3 a, gn_vec3 b)
{
    return (double)a.x * (double)b.x + (double)a.y * (double)b.y + (double)a.z * (double)b.z;
}

/* Any direction across another. */
static gn_vec3 across(gn_vec3 up)
{
    gn_vec3 other = fabsf(up.y) > 0.9f ? (gn_vec3){0.0f, 0.0f, 1.0f} : (gn_vec3){0.0f, 1.0f, 0.0f};
    gn_vec3 result = gn_vec3_cross(other, up);
    gn_vec3_normalize(result, &result);
    return result;
}

static frame frame_of(const camera_options *o)
{
    frame f;
    const gn_vec3 back = gn_vec3_subtract(o->eye, o->target);
    gn_vec3_normalize(o->up, &f.up);
    f.east = across(f.up);
    f.north = gn_vec3_cross(f.up, f.east);
    f.distance = sqrt(dot(back, back));
    f.elevation = asin(fmin(fmax(dot(back, f.up) / f.distance, -1.0), 1.0));
    f.azimuth = atan2(dot(back, f.north), dot(back, f.east));
    return f;
}

static gn_vec3 sum(gn_vec3 a, double ka, gn_vec3 b, double kb, gn_vec3 c, double kc)
{
    return (gn_vec3){
        (float)((double)a.x * ka + (double)b.x * kb + (double)c.x * kc),
        (float)((double)a.y * ka + (double)b.y * kb + (double)c.y * kc),
        (float)((double)a.z * ka + (double)b.z * kb + (double)c.z * kc),
    };
}

static void place_eye(camera_options *o, const frame *f)
{
    const double flat = cos(f->elevation);
    const gn_vec3 back =
        sum(f->east, f->distance * flat * cos(f->azimuth), f->north,
            f->distance * flat * sin(f->azimuth), f->up, f->distance * sin(f->elevation));
    o->eye = gn_vec3_add(o->target, back);
}

void orbit_begin(camera_options *o, const camera *placed)
{
    o->eye_given = o->target_given = o->up_given = true;
    o->eye = placed->eye;
    o->target = placed->target;
    o->up = placed->up;
}

void orbit_turn(camera_options *o, int right, int down)
{
    frame f = frame_of(o);
    f.azimuth -= right * TURN_SPEED * degree;
    f.elevation += down * TURN_SPEED * degree;
    f.elevation = fmin(fmax(f.elevation, -STEEPEST * degree), STEEPEST * degree);
    place_eye(o, &f);
}

void orbit_pan(camera_options *o, int right, int down, uint32_t height)
{
    const frame f = frame_of(o);
    const double visible = o->orthographic
                               ? (double)o->orthographic_height
                               : 2.0 * f.distance * tan(0.5 * (double)o->fov_degrees * degree);
    const double pixel = visible / height;
    gn_vec3 back = gn_vec3_subtract(o->eye, o->target), side, above;
    gn_vec3_normalize(back, &back);
    side = gn_vec3_cross(f.up, back);
    gn_vec3_normalize(side, &side);
    above = gn_vec3_cross(back, side);
    const gn_vec3 none = {0.0f, 0.0f, 0.0f};
    const gn_vec3 move = sum(side, -right * pixel, above, down * pixel, none, 0.0);
    o->eye = gn_vec3_add(o->eye, move);
    o->target = gn_vec3_add(o->target, move);
}

void orbit_zoom(camera_options *o, int steps)
{
    const double factor = pow(ZOOM_STEP, steps);
    frame f = frame_of(o);
    if (o->orthographic) {
        const double height = (double)o->orthographic_height * factor;
        o->orthographic_height = (float)fmin(fmax(height, LEAST_DISTANCE), GREATEST_DISTANCE);
    } else {
        f.distance = fmin(fmax(f.distance * factor, LEAST_DISTANCE), GREATEST_DISTANCE);
        place_eye(o, &f);
    }
}
