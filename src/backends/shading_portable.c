/* Shading over the portable lanes. */
#include "../config/backends.h"
#include "../config/features.h"

#if GN_HAVE_PORTABLE && GN_SPECIALISED
#define GN_SHADING gni_shading_portable
#include "shading.inl"
#endif
