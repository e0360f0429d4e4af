/* The kernel over AVX2 registers. */
#include "../config/backends.h"

#if GN_HAVE_AVX2
#define GN_LANES_AVX2
#define GN_DRAW gni_draw_avx2
#define GN_BULK gni_bulk_avx2
#include "backend.inl"
#endif
