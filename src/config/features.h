/* What is compiled in. GN_SMALL asks for little code at the price of speed; pixels stay the
 * same. GN_BASIC asks for fewer features. */
#ifndef GN_CONFIG_FEATURES_H
#define GN_CONFIG_FEATURES_H

#include <gnomon/lanes.h>

#if defined(GN_SMALL)
#define GN_IS_SMALL 1
#else
#define GN_IS_SMALL 0
#endif

/* Whether common states of a draw have functions of their own, compiled from the same text, and
 * each back end has its own form of ready-made shaders and of lookups. Otherwise one form of each
 * serves all. */
#define GN_SPECIALISED (!GN_IS_SMALL)

/* Whether spans are drawn in rows. One lane draws a few states in rows even if the code must be
 * small. LANES is the form's (lanes/count.h). */
#define GN_HAVE_ROWS (GN_SPECIALISED || LANES == 1)

/* Whether lookups fetch texels of GN_FORMAT_RGBA8 as words. Small builds of sixteen lanes fetch all
 * texels alike. */
#define GN_HAVE_WORDS (GN_SPECIALISED || GN_LANES == 1 || GN_HAVE_ONE_LANE)

/* Whether draws run in tasks on the caller's threads. Otherwise the calling thread draws alone. */
#define GN_HAVE_TASKS (!GN_IS_SMALL)

/* With GN_BASIC only triangles are drawn, under a depth test, with colours that replace the
 * surface's. A call that asks for anything else returns GN_NOT_COMPILED; numbers that belong to the
 * missing feature are not checked. */
#if defined(GN_BASIC)
#define GN_HAVE_LINES 0
#define GN_HAVE_STENCIL 0
#define GN_HAVE_COMBINING 0
#define GN_HAVE_OFFSET 0
#define GN_HAVE_FORMATS 0
#define GN_HAVE_INSTANCES 0
#define GN_HAVE_ATTACHMENTS 0
#define GN_HAVE_SAMPLES 0
#define GN_HAVE_DISTANCES 0
#define GN_HAVE_TEXTURES 0
#define GN_HAVE_POINT_LIGHTS 0
#define GN_HAVE_STATISTICS 0
#else
#define GN_HAVE_LINES 1
#define GN_HAVE_STENCIL 1
#define GN_HAVE_COMBINING 1    /* blending, logical operations, write masks */
#define GN_HAVE_OFFSET 1       /* polygon offset, depth clamp */
#define GN_HAVE_FORMATS 1      /* colour formats beside format_is_basic's */
#define GN_HAVE_INSTANCES 1    /* instances and primitive restart */
#define GN_HAVE_ATTACHMENTS 1  /* more than one colour attachment */
#define GN_HAVE_SAMPLES 1      /* more than one sample per pixel */
#define GN_HAVE_DISTANCES 1    /* the user's clip distances */
#define GN_HAVE_TEXTURES 1     /* textures beside 2D ones of one level */
#define GN_HAVE_POINT_LIGHTS 1 /* ready-made shaders: point and spot lights, several lights */
#define GN_HAVE_STATISTICS 1   /* counts of primitives; passing samples are always counted */
#endif

/* Whether lookups of callers' shaders check textures and samplers. A small library with textures of
 * one kind does so only if it is compiled for finding faults. */
#if defined(GN_DEBUG)
#define GN_CHECKS_LOOKUPS 1
#else
#define GN_CHECKS_LOOKUPS (GN_SPECIALISED || GN_HAVE_TEXTURES)
#endif

/* Whether the portable lanes are vectors of GNU C (registers_vectors.h): nearly twice as fast as
 * plain C, and smaller, if the compiler optimises. GCC converts vectors from version 9 on.
 * GN_NO_VECTORS asks for plain C. */
#if GN_HAVE_REGISTERS && GN_LANES == 16 && !GN_IS_SMALL && !defined(GN_NO_VECTORS) &&              \
    defined(__GNUC__) && defined(__OPTIMIZE__) && (defined(__clang__) || __GNUC__ >= 9)
#define GN_HAVE_VECTORS 1
#else
#define GN_HAVE_VECTORS 0
#endif

/* Whether operations of the portable lanes are functions that take addresses (calls.h). */
#if GN_IS_SMALL && defined(__GNUC__) && GN_LANES > 1
#define GN_LANES_CALLED 1
#else
#define GN_LANES_CALLED 0
#endif

#endif
