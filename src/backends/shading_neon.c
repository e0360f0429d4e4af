/* Shading over the registers of 64-bit Arm's Advanced SIMD. */
#include "../config/backends.h"
#include "../config/features.h"

#if GN_HAVE_NEON && GN_SPECIALISED
#define GN_LANES_NEON
#define GN_SHADING gni_shading_neon
#include "shading.inl"
#endif
