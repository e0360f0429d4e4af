/* Comparisons: one enumeration for the depth test, the stencil test and depth textures. The comment
 * at each field of this type says which two values are compared. */
#ifndef GNOMON_COMPARE_H
#define GNOMON_COMPARE_H

typedef enum gn_compare {
    GN_COMPARE_DEFAULT = 0, /* OpenGL's initial function: GN_LESS for the depth test, GN_ALWAYS for
                               the stencil test, no comparison for a sampler */
    GN_NEVER,
    GN_LESS,
    GN_EQUAL,
    GN_LESS_OR_EQUAL,
    GN_GREATER,
    GN_NOT_EQUAL,
    GN_GREATER_OR_EQUAL,
    GN_ALWAYS
} gn_compare;

#endif
