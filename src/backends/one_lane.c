/* The kernel over one lane, for draws of which no fragment needs its neighbours. */
#include "../config/backends.h"
#include "../config/features.h"

#if GN_HAVE_ONE_LANE
#define GN_LANES_ONE
#define GN_DRAW gni_draw_one_lane
#include "backend.inl"
#endif
