/* What the page's modules leave out of the library: a file that is compiled first, so that the
 * library's own list of features (src/config/features.h) holds but for these. A picture of the page
 * has one colour of 8 bits per channel, depths as floats and no stencil. */
#ifndef LESS_FEATURES_H
#define LESS_FEATURES_H

#include "../../../src/config/features.h"

#undef GN_HAVE_ONE_LANE
#define GN_HAVE_ONE_LANE 0
#undef GN_HAVE_STENCIL
#define GN_HAVE_STENCIL 0
#undef GN_HAVE_FORMATS
#define GN_HAVE_FORMATS 0
#undef GN_HAVE_INSTANCES
#define GN_HAVE_INSTANCES 0
#undef GN_HAVE_ATTACHMENTS
#define GN_HAVE_ATTACHMENTS 0
#undef GN_HAVE_DISTANCES
#define GN_HAVE_DISTANCES 0
#undef GN_HAVE_POINT_LIGHTS
#define GN_HAVE_POINT_LIGHTS 0
#undef GN_HAVE_STATISTICS
#define GN_HAVE_STATISTICS 0

#endif
