/* What GN_SMALL implies. It asks for little code, at the price of speed; the pixels are the
 * same, and so are the sizes of workspaces. */
#ifndef GN_LANES_SMALL_H
#define GN_LANES_SMALL_H

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

/* Whether operations of the portable lanes are called with addresses (calls.h). */
#if GN_IS_SMALL && defined(__GNUC__)
#define GN_LANES_CALLED 1
#else
#define GN_LANES_CALLED 0
#endif

#endif
