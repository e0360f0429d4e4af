/* Moves a camera as a hand moves it in a window: around its target, sideways, nearer. */
#ifndef ORBIT_H
#define ORBIT_H

#include "camera.h"

/* Takes what camera_place has chosen, so that the options do not depend on the model. */
void orbit_begin(camera_options *o, const camera *placed);

/* Turns the camera around its target by pixels to the right and down; it stops short of straight
 * above and below. */
void orbit_turn(camera_options *o, int right, int down);

/* Moves camera and target so that what is at the target moves by these pixels of a picture of this
 * height. */
void orbit_pan(camera_options *o, int right, int down, uint32_t height);

/* Goes nearer to the target, by steps of a tenth of the distance; negative: away. */
void orbit_zoom(camera_options *o, int steps);

#endif
