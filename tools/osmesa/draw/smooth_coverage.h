/* How much of their fragments smooth lines and points cover. */
#ifndef OSMESA_SMOOTH_COVERAGE_H
#define OSMESA_SMOOTH_COVERAGE_H

#include <gnomon.h>

/* Multiply the alpha of fragments by what is covered; those outside a point are discarded. The
 * varyings are those that smooth_primitives.c sets. */
void cover_smooth_line(const float (*coverage)[GN_LANES], gn_fragment_output *output);
void cover_smooth_point(const float (*coverage)[GN_LANES], gn_fragment_output *output);

#endif
