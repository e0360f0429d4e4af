/* Processes that draw the scenes of the parity gate with the reference. Each has a profile of its
 * own, because Mesa reads its environment once. */
#ifndef DISTANCE_DRAWER_H
#define DISTANCE_DRAWER_H

#include <stdio.h>

#include "generate.h"
#include "measure.h"
#include "osmesa.h"

/* The scenes that are drawn, class by class: `scenes` in all, shared evenly by the classes. */
typedef struct drawer_plan {
    uint64_t scenes, seed;
} drawer_plan;

/* Returns the number of scenes of a class. */
uint64_t drawer_scenes(const drawer_plan *plan, int class);

typedef struct drawer {
    long process;
    FILE *frames;
    char text[256]; /* driver, version and renderer; or why the drawer failed */
} drawer;

/* Starts a process that draws the plan's scenes in order. False with the reason in d->text. The
 * calling process must have no reference. */
bool drawer_start(drawer *d, reference_profile profile, const drawer_plan *plan);

/* Waits for the next scene's frames, which the caller has allocated. False with the reason in
 * d->text. */
bool drawer_receive(drawer *d, distance_side *side);

/* Ends the process, also before it is done. */
void drawer_stop(drawer *d);

#endif
