/* The teapot as `gnomon demo` and the web page show it: camera, light, glaze, maps and ground. */
#ifndef TEAPOT_SCENE_H
#define TEAPOT_SCENE_H

#include "scene.h"

#include "look.h"
#include "maps.h"
#include "model.h"
#include "options.h"

#define TEAPOT_FOV_DEGREES 35.0f

/* The colour behind the teapot, which its ground has at the edge. */
extern const float teapot_background[4];

/* Sets eye and target where they are not given. */
void teapot_place_camera(camera_options *o);

/* A sphere around teapot and ground. */
bounding_sphere teapot_sphere(void);

/* Sets the colour and the direction of the light. */
void teapot_light(look *l);

/* The teapot in its glaze. Returns false if there is not enough memory. */
bool teapot_create_glazed(uint32_t tessellation, model *result);

/* The ground with a shadow painted on it. Returns false if there is not enough memory. */
bool teapot_create_ground(model *result);

/* Makes the maps of `wanted`, a set of 1 << map_kind. Returns false if there is not enough
 * memory. */
bool teapot_create_maps(unsigned int wanted, bool in_tangent_space, part_maps *result);

/* Adds ground and teapot to a scene; pictures of normals and depths have no ground. Under a look
 * with shadows the ground is lit, and its colours change. */
void teapot_add_draws(const look *l, const part_maps *maps, model *ground, const model *teapot,
                      scene *s);

#endif
