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
    bool is_linear;         /* colours are linear light: the target is GN_FORMAT_SRGB8_A8 */
    camera view;
    bounding_sphere bounds;  /* the sphere around everything that may throw shadows */
    gn_vec3 light_direction; /* towards the light, unit length */
    gn_vec3 ambient;
    gn_vec3 diffuse;
    uint32_t light_count; /* of the file's lights, in place of that direction; 0: none */
    gn_light lights[GN_MAX_LIGHTS];
    const shadow_pass *shadow; /* the drawn map; null: no shadows */
} look;

/* Sets a look with light over the viewer's shoulder, or from where the options say, and enough
 * ambient light to see the rest. Returns 0, or EXIT_FAULT with the reason printed. */
int look_choose(const options *o, const camera *view, shading which, look *result);

/* Chooses the lights of a look: those of the model's file if the picture is linear and no option
 * gives a light, at most GN_MAX_LIGHTS of them. They are made so bright together that the middle of
 * the model receives as much light as from the look's own, which is what a camera's exposure is
 * for. */
void look_choose_lights(look *l, const model *m, const bounding_sphere *bounds);

/* Sets matrices and light of a draw for a model that is placed there, as the camera sees it, and
 * the state that depends on the camera's convention. */
void look_place(scene_draw *draw, const look *l, const gn_transform *world_from_model);

/* Which of the part's triangles are not drawn: the options say, or else the material. */
gn_cull look_cull(const options *o, const model_part *part);

/* Whether the part is blended with what is behind it. */
bool look_blends(const options *o, const model_part *part);

/* Adds a part to a scene, with copies of everything that it needs. Maps that the shader does not
 * take are ignored. The colours of vertices are multiplied by the diffuse map. */
scene_draw *look_add_part(scene *s, const look *l, const model_part *part, const part_maps *maps);

#endif
