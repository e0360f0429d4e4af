/* Pictures: what the options ask for and what the model holds, as a scene. */
#ifndef PICTURE_H
#define PICTURE_H

#include <scene.h>

#include "model.h"
#include "options.h"

/* Reads the model and its textures, places the camera and describes it all as a scene to draw
 * into GN_FORMAT_RGBA8 and GN_FORMAT_D32F. 0 and *result, to be freed with scene_free;
 * otherwise EXIT_FAULT with the reason printed. */
int picture_describe(const options *o, scene **result);

/* Adds a part to a scene: SCENE_TEXTURED_GOURAUD wants a texture set afterwards. */
scene_draw *picture_add_part(scene *s, const model_part *part, scene_shader shader,
                             const camera *view, gn_vec3 light_direction);

/* Length of a model's path without its extension. */
size_t picture_stem_length(const char *model_path);

/* "out.png: 1024x1024, 2492 triangles, textured" on standard output. */
void picture_print_summary(const char *name, const scene *s);

#endif
