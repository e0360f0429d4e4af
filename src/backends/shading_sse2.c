/* Shading over SSE2 registers. */
#include "../config/backends.h"
#include "../config/features.h"

#if GN_HAVE_SSE2 && GN_SPECIALISED
#define GN_SHADING gni_shading_sse2
#include "shading.inl"
#endif
