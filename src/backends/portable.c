/* The kernel over the portable lanes: plain C, or vectors of GNU C (GN_HAVE_VECTORS). */
#include "../config/backends.h"

#if GN_HAVE_PORTABLE
#define GN_DRAW gni_draw_portable
#define GN_BULK gni_bulk_portable
#include "backend.inl"
#endif
