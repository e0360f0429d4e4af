/* The kernel over SSE4.1 registers. */
#include "../config/backends.h"

#if GN_HAVE_SSE41
#define GN_LANES_SSE41
#define GN_DRAW gni_draw_sse41
#define GN_BULK gni_bulk_sse41
#include "backend.inl"
#endif
