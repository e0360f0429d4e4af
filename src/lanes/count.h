/* LANES: how many vertices, triangles or fragments the text that includes this takes at a time. The
 * arrays that shaders and lookups take have GN_LANES elements in every form; with GN_LANES_ONE only
 * the first is used. */
#ifndef GN_LANES_COUNT_H
#define GN_LANES_COUNT_H

#include <gnomon/lanes.h>

#if defined(GN_LANES_ONE)
#define LANES 1
#else
#define LANES GN_LANES
#endif

/* Whether the form draws points and lines, and targets with several samples a pixel. The form of
 * one lane beside one of sixteen (GN_HAVE_ONE_LANE) does not. */
#define DRAWS_LINES (GN_HAVE_LINES && LANES == GN_LANES)
#define DRAWS_SAMPLES (GN_HAVE_SAMPLES && LANES == GN_LANES)

#endif
