/* How a picture's contents are drawn: shader, light and maps, as draws of a scene. */
#ifndef LOOK_H
#define LOOK_H

#include "scene.h"

#include "camera.h"
#include "maps.h"
#include "model.h"
#include "options.h"
#include "shadow.h"

typedef struct look {
    const options *options; /* filter, highlights, bands, wireframe */
    shading shading;        /* any but SHADING_AUTOMATIC */
    camera view;
    bounding_sphere bounds;  /* the sphere around everything that may throw shadows */
    gn_vec3 light_direction; /* towards the light, unit length */
    gn_vec3 ambient;
    gn_vec3 diffuse;
    const shadow_pass *shadow; /* the drawn map; null: no shadows */
} look;

/* Sets a look with light over the viewer's shoulder, or from where the options say, and enough
 * ambient light to see the rest. Returns 0, or EXIT_FAULT with the reason printed. */
int look_choose(const options *o, const camera *view, shading which, look *result);

/* Sets matrices and light of a draw for a model that is placed there, as the camera sees it, and
 * the state that depends on the camera's convention. */
void look_place(scene_draw *draw, const look *l, const gn_transform *world_from_model);

/* Whether the part is blended with what is behind it. */
bool look_blends(const options *o, const model_part *part);

/* Adds a part to a scene, with copies of everything that it needs. Maps that the shader does not
 * take are ignored. The colours of vertices are multiplied by the diffuse map. */
scene_draw *look_add_part(scene *s, const look *l, const model_part *part, const part_maps *maps);

#endif
