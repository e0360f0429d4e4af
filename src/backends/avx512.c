/* The stages over AVX-512 registers. The target asked for can fuse multiplications with
 * additions; that it does not rests on -ffp-contract=off. */
#include "../config/have.h"
#include "stages.h"

#if GN_HAVE_AVX512

#if !defined(GN_LANES_INTRINSICS_HEADER)
#include <immintrin.h>

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx512f,avx512bw,avx512dq,avx512vl"))),        \
                             apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx512f,avx512bw,avx512dq,avx512vl")
#endif
#endif

#define GN_LANES_AVX512
#include "../draw/mesh.h"
#include "../math/bulk.h"

gn_status gn_run_avx512(const draw_job *job)
{
    return draw_mesh(job);
}

void gn_bulk_avx512(const bulk_job *job)
{
    run_bulk(job);
}

#if !defined(GN_LANES_INTRINSICS_HEADER)
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif
#endif
