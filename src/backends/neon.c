/* The stages over the registers of 64-bit Arm's Advanced SIMD. */
#include "../config/backends.h"

#if GN_HAVE_NEON
#define GN_LANES_NEON
#define GN_RUN gni_run_neon
#define GN_BULK gni_bulk_neon
#include "stages.inl"
#endif
