/* The text of src/texture without what needs another texture than a 2D one, more samples than one
 * or no filter. The calls of what is left out do nothing; no draw of the page reaches them. Every
 * header is included before its functions are named away.
 *
 * Not alone: the parameters that are left over are warnings of other compilers. */
#ifndef LESS_TEXTURE_PARTS_H
#define LESS_TEXTURE_PARTS_H

/* The text has functions, and parameters of functions, for what is left out. */
#if defined(__clang__)
#pragma clang diagnostic ignored "-Wunused-parameter"
#pragma clang diagnostic ignored "-Wunused-function"
#endif

#include "formats.h"

#include "../../../src/kernel/texture/cube.inl"

#define cube_gradient(...) ((void)0)
#define cube_project(...) ((void)0)

#include "../../../src/kernel/texture/cube_filter.inl"

#define filter_cube(state, place, level, ...) ((void)(level))
#define gather_cube(...) ((void)0)

#include "../../../src/kernel/texture/anisotropic.inl"

#define lookup_anisotropic(...) ((void)0)

#include "../../../src/kernel/texture/texel_fetch.inl"
#include "../../../src/kernel/texture/lookup.inl"

#endif
