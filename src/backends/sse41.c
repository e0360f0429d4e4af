/* The stages over SSE4.1 registers. */
#include "../config/backends.h"

#if GN_HAVE_SSE41
#define GN_LANES_SSE41
#define GN_RUN gn_run_sse41
#define GN_BULK gn_bulk_sse41
#include "stages.inl"
#endif
