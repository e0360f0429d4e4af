/* Marks functions over lanes that are compiled for AVX2 too; the loader takes what the processor
 * has. What they call is compiled with them. The pixels are the same: nothing is fused or
 * reordered. Compiled for AVX-512 as well they were not faster. */
#ifndef OSMESA_LANE_FUNCTION_H
#define OSMESA_LANE_FUNCTION_H

#include <stdint.h> /* __GLIBC__ */

#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__)
#define LANE_FUNCTION __attribute__((flatten, target_clones("default", "avx2")))
#else
#define LANE_FUNCTION
#endif

#endif
