/* How far two frames of one scene are from each other. */
#ifndef DISTANCE_MEASURE_H
#define DISTANCE_MEASURE_H

#include "scene.h"

/* Sizes of differences, one per pixel: that of the channel that differs most. */
typedef struct distance_sizes {
    uint64_t pixels;
    double sum, largest;
} distance_sizes;

/* A pixel is a sample if there are several; resolved images are left out. A pixel is covered if it
 * differs from the clear values, in colour or depth. Differences have sizes where both frames cover
 * the pixel. Two NaN are equal. */
typedef struct distance {
    uint64_t scenes;
    uint64_t covered;  /* in one frame or both */
    uint64_t coverage; /* in one frame only */
    uint64_t color;    /* pixels that have another colour in any bit */
    uint64_t visible;  /* pixels whose colours differ by more than 1/255, relative where above 1 */
    uint64_t depth;    /* pixels that have another depth or stencil in any bit */
    distance_sizes steps;       /* colours that are no floats, in 1/255 */
    distance_sizes relative;    /* floats: |a - b| / max(|a|, |b|); 2 if one alone is finite */
    distance_sizes depth_steps; /* in steps of 24 bits */
} distance;

/* The frame that a side drew, and the frame that it cleared. */
typedef struct distance_side {
    scene_frame drawn, cleared;
} distance_side;

/* Adds the distance of a scene's frames to d. */
void distance_measure(const distance_side *a, const distance_side *b, distance *d);

void distance_add(distance *sum, const distance *d);

#endif
