/* Derivatives for fragment shaders: how a value that a shader has computed for the sixteen
 * fragments of a block (gn_fragment_input) changes from pixel to pixel. GLSL's dFdx, dFdy and
 * fwidth in their fine form: differences within quads of 2x2 fragments, at even window
 * coordinates, along the row or column of each fragment (GLSL 4.50 section 8.13.1). All sixteen
 * lanes are read: those of fragments that are not covered hold the varyings of the primitive's
 * plane there. */
#ifndef GNOMON_DERIVATIVES_H
#define GNOMON_DERIVATIVES_H

#include "sampling.h"

GN_BEGIN

/* The right minus the left fragment of the quad's row that a lane is in, so that both get the
 * same. out may be value. */
GN_API void gn_derivative_x(const float value[GN_LANES], float out[GN_LANES]);

/* The upper minus the lower fragment of the quad's column that a lane is in. out may be value. */
GN_API void gn_derivative_y(const float value[GN_LANES], float out[GN_LANES]);

/* |derivative x| + |derivative y|: GLSL's fwidth. out may be value. */
GN_API void gn_derivative_width(const float value[GN_LANES], float out[GN_LANES]);

GN_END

#endif
