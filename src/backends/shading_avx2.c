/* Shading over AVX2 registers. */
#include "../config/have.h"

#include "shading.h"

#if GN_HAVE_AVX2 && GN_SPECIALISED
#include <immintrin.h>

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif

#define GN_LANES_AVX2
#include "shading_form.h"

void gn_shading_avx2(const gn_pipeline *pipeline, shading_functions *out)
{
    fill_shading(pipeline, out);
}

#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif
