/* Shading over AVX-512 registers. The target asked for can fuse multiplications with
 * additions; that it does not rests on -ffp-contract=off. */
#include "../config/have.h"

#include "shading.h"

#if GN_HAVE_AVX512 && GN_SPECIALISED

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
#include "shading_form.h"

void gn_shading_avx512(const gn_pipeline *pipeline, shading_functions *out)
{
    fill_shading(pipeline, out);
}

#if !defined(GN_LANES_INTRINSICS_HEADER)
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif
#endif
