/* The kernel over AVX-512 registers. */
#include "../config/backends.h"

#if GN_HAVE_AVX512
#define GN_LANES_AVX512
#define GN_DRAW gni_draw_avx512
#define GN_BULK gni_bulk_avx512
#include "backend.inl"
#endif
