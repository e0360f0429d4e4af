/* How what is in a picture is drawn: shader, light and maps, as draws of a scene. */
#ifndef LOOK_H
#define LOOK_H

#include <scene.h>

#include "camera.h"
#include "maps.h"
#include "model.h"
#include "options.h"
#include "shadow.h"

typedef struct look {
    const options *options; /* filter, highlights, bands, wireframe */
    shading shading;        /* any but SHADING_AUTOMATIC */
    camera view;
    bounding_sphere bounds;  /* of all that may throw shadows */
    gn_vec3 light_direction; /* towards the light, unit length */
    gn_vec3 ambient;
    gn_vec3 diffuse;
    const shadow_pass *shadow; /* drawn; null: everything is in the light */
} look;

/* A look of light over the viewer's shoulder, or from where the options say, and enough from
 * everywhere to see the rest by. 0, or EXIT_FAULT with the reason printed. */
int look_choose(const options *o, const camera *view, shading which, look *result);

/* Adds a part to a scene, with copies of what it needs. A part with a diffuse map has no colours
 * but those of its vertices. */
scene_draw *look_add_part(scene *s, const look *l, const model_part *part, const part_maps *maps);

#endif
