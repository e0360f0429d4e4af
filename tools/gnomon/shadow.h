/* The first of two passes for shadows: a scene with depth alone, as the light sees it, and the map
 * that the library draws from it. */
#ifndef SHADOW_H
#define SHADOW_H

#include "scene.h"

#include "camera.h"
#include "model.h"

typedef struct shadow_pass {
    scene *scene;      /* without colour, depth GN_FORMAT_D32F */
    scene_frame frame; /* drawn by the library */
    gn_mat4 clip_from_world;
} shadow_pass;

/* Begins a pass with a directional light that sees the whole sphere. `direction` is towards the
 * light, of unit length. Returns 0, or EXIT_FAULT with the reason printed and nothing to free. */
int shadow_begin(const bounding_sphere *bounds, gn_vec3 direction, shadow_pass *result);

/* Adds a part that throws shadows. */
void shadow_add_part(shadow_pass *pass, const model_part *part);

/* Places the model of draw i elsewhere. */
void shadow_place(shadow_pass *pass, size_t i, const gn_mat4 *world_from_model);

/* Draws the map. Returns 0, or EXIT_FAULT with the reason printed; free the pass either way. */
int shadow_draw(shadow_pass *pass, gn_backend backend);

/* Gives the drawn map to a draw. */
void shadow_apply(const shadow_pass *pass, scene_draw *draw);

/* Frees a pass, or a zeroed one. */
void shadow_free(shadow_pass *pass);

#endif
