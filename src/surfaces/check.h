/* The first check of functions that take surfaces of any kind. */
#ifndef GN_SURFACES_CHECK_H
#define GN_SURFACES_CHECK_H

#include <gnomon/surface.h>

/* Returns the first fault of a surface; GN_FORMAT_NONE is a fault. */
gn_status gn_check_any_surface(const gn_surface *surface);

#endif
