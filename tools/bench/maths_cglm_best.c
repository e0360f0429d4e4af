/* cglm at its fastest: the Makefile compiles this file with AVX2 and fused multiply-add, if the
 * target can have them. */
#include "maths_cglm.h"

#if defined(__AVX2__) && defined(__FMA__)
maths_pass *maths_cglm_best(maths_operation operation)
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? passes[operation]
                                                                           : NULL;
}
#else
maths_pass *maths_cglm_best(maths_operation operation)
{
    (void)passes[operation];
    return NULL;
}
#endif
