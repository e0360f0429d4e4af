/** @file
 * Comparisons: one enumeration for the depth test, the stencil test and depth textures. The comment
 * at each field of this type says which two values are compared. */
#ifndef GNOMON_COMPARE_H
#define GNOMON_COMPARE_H

/** A comparison of two values, `a FUNCTION b`. */
typedef enum gn_compare {
    GN_COMPARE_DEFAULT = 0, /**< OpenGL's initial function: GN_LESS for the depth test, GN_ALWAYS
                                 for the stencil test, no comparison for a sampler */
    GN_NEVER,               /**< false */
    GN_LESS,                /**< a < b */
    GN_EQUAL,               /**< a == b */
    GN_LESS_OR_EQUAL,       /**< a <= b */
    GN_GREATER,             /**< a > b */
    GN_NOT_EQUAL,           /**< a != b */
    GN_GREATER_OR_EQUAL,    /**< a >= b */
    GN_ALWAYS               /**< true */
} gn_compare;

#endif
