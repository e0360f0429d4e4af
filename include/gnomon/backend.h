/** @file
 * Back ends: the same stages compiled for several instruction sets. All back ends write the same
 * bits to surfaces and textures; they differ only in speed.
 *
 * Processors differ in the bits of a NaN that arithmetic produces. Therefore every NaN stored as a
 * 32-bit float is 0x7FC00000, as a 16-bit float 0x7E00, with 11 bits 0x7E0 and with 10 bits 0x3F0.
 * Only copies keep other NaNs. Shaders, and callers of the functions of gnomon/lookup.h and
 * gnomon/bulk.h, may see a NaN of any bits. */
#ifndef GNOMON_BACKEND_H
#define GNOMON_BACKEND_H

#include <stdbool.h>

#include "api.h"

/** An instruction set. */
typedef enum gn_backend {
    GN_BACKEND_AUTO = 0, /**< the fastest available; a workspace's first draw asks the processor */
    GN_BACKEND_PORTABLE, /**< C without instructions of one target */
    GN_BACKEND_SSE41,    /**< x86; with SSE3 and SSSE3 */
    GN_BACKEND_AVX2,     /**< 64-bit x86; with F16C */
    GN_BACKEND_AVX512,   /**< 64-bit x86; F, BW, DQ and VL, and what AVX2 needs */
    GN_BACKEND_NEON,     /**< 64-bit Arm */
    GN_BACKEND_WASM_SIMD128, /**< WebAssembly, if compiled with -msimd128 */
    GN_BACKEND_COUNT         /**< the number of values, not a back end */
} gn_backend;

GN_BEGIN

/** Returns whether the library contains this back end and the processor and the operating system
 * can run it. Returns true for GN_BACKEND_AUTO and false for values that are no gn_backend. */
GN_API bool gn_backend_available(gn_backend backend);

/** Returns the available back end that is fastest on the whole: measured on some processors,
 * decided by family and model on others. Another may be faster in some state. Every call asks the
 * processor, which takes up to 50 microseconds on virtual machines. gn_draw asks once for each
 * workspace. Blits, resolves and the generation of levels of 32,768 pixels or more ask in every
 * call; so do the functions of gnomon/bulk.h as stated there. */
GN_API gn_backend gn_backend_best(void);

/** Returns the name: "portable", "sse41" and so on; "unknown" for a value that is no gn_backend. */
GN_API const char *gn_backend_name(gn_backend backend);

GN_END

#endif
