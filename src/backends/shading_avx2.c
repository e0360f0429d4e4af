/* Shading over AVX2 registers. */
#include "../config/backends.h"
#include "../config/features.h"

#if GN_HAVE_AVX2 && GN_SPECIALISED
#define GN_LANES_AVX2
#define GN_SHADING gni_shading_avx2
#include "shading.inl"
#endif
