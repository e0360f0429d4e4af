/* The stages over AVX2 registers. Fused multiply-add stays out: the target asked for
 * does not have it, and the library is compiled without contraction. */
#include "../config/have.h"
#include "stages.h"

#if GN_HAVE_AVX2
#include <immintrin.h>

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif

#define GN_LANES_AVX2
#include "../draw/mesh.h"
#include "../math/bulk.h"

gn_status gn_run_avx2(const draw_job *job)
{
    return draw_mesh(job);
}

void gn_bulk_avx2(const bulk_job *job)
{
    run_bulk(job);
}

#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif
