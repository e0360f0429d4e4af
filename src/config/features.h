/* What is compiled in. GN_SMALL asks for little code at the price of speed; the pixels and the
 * sizes of workspaces are the same. GN_BASIC asks for fewer features. */
#ifndef GN_CONFIG_FEATURES_H
#define GN_CONFIG_FEATURES_H

#if defined(GN_SMALL)
#define GN_IS_SMALL 1
#else
#define GN_IS_SMALL 0
#endif

/* Whether common states of a draw have code of their own, made from the same text, and a
 * back end its own form of ready-made shaders and of sampling; otherwise one form of each
 * serves all. */
#define GN_SPECIALISED (!GN_IS_SMALL)

/* Whether draws run in tasks on the caller's threads; otherwise the calling thread draws
 * alone. */
#define GN_HAVE_TASKS (!GN_IS_SMALL)

/* With GN_BASIC only triangles are drawn, under a depth test and with colours that replace
 * those that are there; what else a draw asks for is GN_NOT_COMPILED, and the numbers that go with
 * it are not looked at. */
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
#define GN_HAVE_FORMATS 1      /* of colours, beside RGBA8 and RGBA32F */
#define GN_HAVE_INSTANCES 1    /* and primitive restart */
#define GN_HAVE_ATTACHMENTS 1  /* more than one colour */
#define GN_HAVE_SAMPLES 1      /* more than one a pixel */
#define GN_HAVE_DISTANCES 1    /* to clip by, of the user's */
#define GN_HAVE_TEXTURES 1     /* beside 2D ones of one level, RGBA8 or RGBA32F */
#define GN_HAVE_POINT_LIGHTS 1 /* of the ready-made shaders */
#define GN_HAVE_STATISTICS 1   /* of primitives; samples that pass are always counted */
#endif

/* Whether operations of the portable lanes are called with addresses (calls.h). */
#if GN_IS_SMALL && defined(__GNUC__)
#define GN_LANES_CALLED 1
#else
#define GN_LANES_CALLED 0
#endif

#endif
