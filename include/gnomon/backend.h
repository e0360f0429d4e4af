/* Back ends: the same stages compiled for several instruction sets. All of them write the same bits
 * to surfaces and textures and differ in speed alone. Processors differ in the bits of a NaN that
 * arithmetic makes, so every NaN that is stored as a float of 32 bits is 0x7FC00000 and every NaN
 * that is stored as a float of 16 bits is 0x7E00; only copies keep other NaNs. Shaders, and callers
 * of the functions of gnomon/sampling.h and gnomon/bulk.h, may see a NaN of any bits. */
#ifndef GNOMON_BACKEND_H
#define GNOMON_BACKEND_H

#include <stdbool.h>

#include "api.h"

typedef enum gn_backend {
    GN_BACKEND_AUTO = 0, /* the fastest there is, asked of the processor in every draw */
    GN_BACKEND_PORTABLE, /* plain C */
    GN_BACKEND_SSE2,
    GN_BACKEND_AVX2,
    GN_BACKEND_AVX512, /* F, BW, DQ and VL */
    GN_BACKEND_NEON,   /* 64-bit Arm */
    GN_BACKEND_WASM_SIMD128,
    GN_BACKEND_COUNT /* the number of values, not a back end */
} gn_backend;

GN_BEGIN

/* Whether the library holds this back end and the processor and its operating system
 * can run it. GN_BACKEND_AUTO always is; other values are not. */
GN_API bool gn_backend_available(gn_backend backend);

/* The fastest available. Asking the processor takes 20 microseconds on some virtual
 * machines: a program with many small draws asks once and names the answer in its
 * workspace. */
GN_API gn_backend gn_backend_best(void);

/* "portable", "sse2" and so on; "unknown" for no gn_backend. */
GN_API const char *gn_backend_name(gn_backend backend);

GN_END

#endif
