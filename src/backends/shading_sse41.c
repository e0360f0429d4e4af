/* Shading over SSE4.1 registers. */
#include "../config/backends.h"
#include "../config/features.h"

#if GN_HAVE_SSE41 && GN_SPECIALISED
#define GN_LANES_SSE41
#define GN_SHADING gni_shading_sse41
#include "shading.inl"
#endif
