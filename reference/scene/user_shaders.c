/* Chooses the form of the users' shaders for a back end. */
#include "user_shaders.h"

#include <string.h>

extern const user_shaders user_shaders_baseline, user_shaders_avx2, user_shaders_avx512;

/* The back end may be an emulated one. */
static bool processor_has_avx512(void)
{
#if defined(__x86_64__) && defined(__GNUC__)
    return __builtin_cpu_supports("avx512f");
#else
    return false;
#endif
}

const user_shaders *user_shaders_for(gn_backend backend)
{
    const char *name = gn_backend_name(backend == GN_BACKEND_AUTO ? gn_backend_best() : backend);

    if (strcmp(name, "avx512") == 0 && processor_has_avx512())
        return &user_shaders_avx512;
    return strcmp(name, "avx2") == 0 ? &user_shaders_avx2 : &user_shaders_baseline;
}
