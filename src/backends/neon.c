/* The kernel over the registers of 64-bit Arm's Advanced SIMD. */
#include "../config/backends.h"

#if GN_HAVE_NEON
#define GN_LANES_NEON
#define GN_DRAW gni_draw_neon
#define GN_BULK gni_bulk_neon
#include "backend.inl"
#endif
