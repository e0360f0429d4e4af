/* The camera: computes matrices from the options and the place of the model. */
#ifndef CAMERA_H
#define CAMERA_H

#include <gnomon.h>

#include "options.h"

/* A sphere around everything that is drawn; radius > 0. */
typedef struct bounding_sphere {
    double center[3];
    double radius;
    double origin[3]; /* of the space in which the centre is given, in the world */
} bounding_sphere;

typedef struct camera {
    gn_mat4 clip_from_world;
    gn_mat4 view_from_world, clip_from_view; /* clip_from_world's factors */
    bool zero_to_one;                        /* clip space's depth: 0 to w instead of -w to w */
    bool y_down;                             /* clip space's y */
    gn_vec3 eye, target, up;
    gn_vec3 light_direction; /* over the viewer's left shoulder, world space, unit length */
} camera;

/* Places the camera. Options that are not given are chosen so that the sphere is framed: the target
 * is its centre; the eye is in front (+z), a little to the right and above, where the whole sphere
 * fits into the picture. The result is in the space of the sphere: what is called world there
 * begins at its origin. Returns 0, or EXIT_FAULT with the reason printed. */
int camera_place(const camera_options *asked, const bounding_sphere *sphere, uint32_t width,
                 uint32_t height, camera *result);

#endif
