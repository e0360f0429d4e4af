/* Shading over AVX-512 registers. */
#include "../config/backends.h"
#include "../config/features.h"

#if GN_HAVE_AVX512 && GN_SPECIALISED
#define GN_LANES_AVX512
#define GN_SHADING gni_shading_avx512
#include "shading.inl"
#endif
