/** @file
 * Gnomon: 3D mathematics and software rendering in freestanding C99.
 *
 * This header includes the headers below; each can also be included alone.
 *
 *     version.h     the version, of headers and of the library
 *     status.h      what functions say about their input
 *     scalar.h      square roots, trigonometry, exponentials, the same on every target
 *     vec.h         vectors of two to four components
 *     mat.h         3x3 and 4x4 matrices
 *     quat.h        rotations as quaternions
 *     bulk.h        arrays of vectors by one matrix, and of matrices
 *     transform.h   transforms: a matrix together with its analytic inverse
 *     inverse.h     inverses of bare matrices of known kinds
 *     decompose.h   a model matrix into translation, rotation and scale
 *     projection.h  projections and viewports, as transforms
 *     conventions.h OpenGL, Direct3D and Vulkan, and from one to another
 *     project.h     points to the window and back
 *     culling.h     planes of a view volume; boxes and spheres against them
 *     ray.h         rays through pixels, against triangles and boxes
 *     compare.h     comparisons of depth, stencil and depth textures
 *     lanes.h       how many vertices or fragments are processed at a time
 *     surface.h     colour and depth images in the caller's memory, and clears
 *     blit.h        rectangles of surfaces onto others, converted and scaled
 *     texture.h     images that shaders read
 *     lookup.h      lookups in textures: wraps, filters, levels of detail
 *     derivatives.h dFdx, dFdy and fwidth for users' shaders
 *     program.h     shaders: what they receive, write and look up
 *     pipeline.h    the state of a draw, with its program
 *     backend.h     instruction sets
 *     parallel.h    threads, which are the caller's
 *     draw.h        meshes, the workspace and the draw itself
 *     statistics.h  counts of what became of the primitives and fragments of draws
 *     light.h       lights, materials and shadow maps of the ready-made shaders
 *     shaders.h     ready-made shaders
 *     shader_functions.h  shaders as functions of one vertex and one fragment
 *     shader_vectors.h    inline functions of vectors for such shaders
 *     shader_types.h      what such shaders take and return
 *     shader_loop.h       parts of the macros of shader_functions.h, not for users
 *
 * Conventions, for every function whose name does not say otherwise:
 *
 *     matrices      column-major storage, float m[column][row], column vectors: the
 *                   bytes of an OpenGL uniform
 *     angles        radians
 *     space         right-handed; clip space as in OpenGL, -w <= x, y, z <= w
 *     windows       y points up, row 0 is the bottom row, pixel centres at +0.5
 *     depth         0 is near, 1 is far, unless a depth range says otherwise
 *     memory        the caller's; the library allocates nothing and keeps no pointer
 *     aliasing      outputs must not overlap inputs unless a contract says they may
 *     arithmetic    IEEE binary32, rounded to nearest, in the order written
 *     reference     the rasterizer whose pixels the library's equal bit for bit: OSMesa of
 *                   Mesa 25.0.7 with llvmpipe, pinned to vectors of 128 bits. Its rules,
 *                   and what is left out, are a page of the documentation (RULES.md)
 *     names         a function of mathematics whose name begins with its type, such as
 *                   gn_vec3_add, and every function of scalar.h is a call into the
 *                   library; only calls return a gn_status. A name that ends in a
 *                   number of components, such as gn_add3, is inline, for shaders. The
 *                   same word is the same operation with the same bits; shader_vectors.h
 *                   names the exceptions
 */
#ifndef GNOMON_H
#define GNOMON_H

#include "gnomon/backend.h"
#include "gnomon/blit.h"
#include "gnomon/bulk.h"
#include "gnomon/compare.h"
#include "gnomon/conventions.h"
#include "gnomon/culling.h"
#include "gnomon/decompose.h"
#include "gnomon/derivatives.h"
#include "gnomon/draw.h"
#include "gnomon/inverse.h"
#include "gnomon/lanes.h"
#include "gnomon/light.h"
#include "gnomon/mat.h"
#include "gnomon/parallel.h"
#include "gnomon/pipeline.h"
#include "gnomon/program.h"
#include "gnomon/project.h"
#include "gnomon/projection.h"
#include "gnomon/quat.h"
#include "gnomon/ray.h"
#include "gnomon/lookup.h"
#include "gnomon/scalar.h"
#include "gnomon/shader_functions.h"
#include "gnomon/shader_loop.h"
#include "gnomon/shader_types.h"
#include "gnomon/shader_vectors.h"
#include "gnomon/shaders.h"
#include "gnomon/statistics.h"
#include "gnomon/status.h"
#include "gnomon/surface.h"
#include "gnomon/texture.h"
#include "gnomon/transform.h"
#include "gnomon/vec.h"
#include "gnomon/version.h"

#endif
