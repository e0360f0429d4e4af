/* What functions that take surfaces of any kind ask of them first. */
#ifndef GN_SURFACES_CHECK_H
#define GN_SURFACES_CHECK_H

#include "gnomon/surface.h"

/* The first fault of a surface of any format but GN_FORMAT_NONE. */
gn_status gn_check_any_surface(const gn_surface *surface);

#endif
