/* The stages over AVX2 registers. */
#include "../config/backends.h"

#if GN_HAVE_AVX2
#define GN_LANES_AVX2
#define GN_RUN gni_run_avx2
#define GN_BULK gni_bulk_avx2
#include "stages.inl"
#endif
