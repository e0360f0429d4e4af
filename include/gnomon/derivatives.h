/** @file
 * Derivatives for fragment shaders: how a value that a shader has computed for the sixteen
 * fragments of a block (gn_fragment_input) changes from pixel to pixel. These are GLSL's dFdx, dFdy
 * and fwidth in their fine form: differences within quads of 2x2 fragments, which begin at even
 * window coordinates, along the row or column of each fragment (GLSL 4.50 section 8.13.1).
 *
 * A library of one lane (gnomon/lanes.h) has no neighbours: its derivatives are 0.
 *
 * All sixteen lanes are read. In lanes of fragments that are not covered, varyings continue the
 * plane of the primitive. */
#ifndef GNOMON_DERIVATIVES_H
#define GNOMON_DERIVATIVES_H

#include "lookup.h"

GN_BEGIN

/** Writes, for each lane, the right minus the left fragment of the quad row that holds the lane;
 * both lanes of a row receive the same value. out may be value. */
GN_API void gn_derivative_x(const float value[GN_LANES], float out[GN_LANES]);

/** Writes, for each lane, the upper minus the lower fragment of the quad column that holds the
 * lane; both lanes of a column receive the same value. out may be value. */
GN_API void gn_derivative_y(const float value[GN_LANES], float out[GN_LANES]);

/** Writes |derivative x| + |derivative y|: GLSL's fwidth. out may be value. */
GN_API void gn_derivative_width(const float value[GN_LANES], float out[GN_LANES]);

GN_END

#endif
