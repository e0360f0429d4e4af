/* The kernel over SSE2 registers, the form that lanes.h takes by itself on x86. */
#include "../config/backends.h"

#if GN_HAVE_SSE2
#define GN_DRAW gni_draw_sse2
#define GN_BULK gni_bulk_sse2
#include "backend.inl"
#endif
