/* What look.c is made of: the maps, the colours and the lights of a draw. */
#ifndef LOOK_PARTS_H
#define LOOK_PARTS_H

#include "look.h"

/* Copies the maps into the draw, with their samplers. Maps without texels are not set. */
void look_set_maps(scene_draw *draw, const look *l, const model_part *part, const part_maps *maps);

/* Copies the vertices' colours into the draw: white where a map takes the material's place, opaque
 * where alpha has no meaning, linear if the picture is. */
void look_set_colors(scene_draw *draw, const look *l, const model_part *part,
                     const part_maps *maps);

/* Sets the lights of a draw: the look's own, or the file's. */
void look_set_lights(scene_draw *draw, const look *l);

/* A colour of the display (sRGB, IEC 61966-2-1) as linear light, and back. */
float look_to_linear(float encoded);
float look_to_encoded(float linear);

#endif
