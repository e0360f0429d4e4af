/** @file
 * What a function reports about its input. GN_OK is zero, so `if (status)` means "if something is
 * wrong". Every other value names one fault. Unless a contract says otherwise, a function that does
 * not return GN_OK has written nothing. */
#ifndef GNOMON_STATUS_H
#define GNOMON_STATUS_H

#include "api.h"

/** GN_OK, or the fault that a function has found. */
typedef enum gn_status {
    GN_OK = 0,
    GN_NULL_POINTER,   /**< a pointer that must be given is null */
    GN_NOT_FINITE,     /**< a number is NaN or infinite */
    GN_OUT_OF_RANGE,   /**< a number lies outside what the contract allows */
    GN_DEGENERATE,     /**< a direction of length zero, or two that are parallel */
    GN_SINGULAR,       /**< a matrix without an inverse */
    GN_INVALID_ENUM,   /**< an enumeration field holds none of its values */
    GN_INVALID_SIZE,   /**< a width, height or depth that is not allowed, or too many levels for
                            it */
    GN_INVALID_FORMAT, /**< a surface or texture format that does not fit its use */
    GN_INVALID_STRIDE, /**< a stride of rows or samples that is too short or too long */
    GN_MISALIGNED,     /**< memory or a stride not aligned to the element it holds */
    GN_SIZE_MISMATCH,  /**< surfaces differ in size or number of samples */
    GN_NO_SURFACE,     /**< a target without colour and depth */
    GN_NO_SHADER, /**< no vertex shader, or no fragment shader where colour, discarding, depth or a
                       sample mask needs one */
    GN_TOO_MANY_VARYINGS,   /**< more than GN_MAX_VARYINGS */
    GN_INVALID_ATTRIBUTE,   /**< an attribute without 1 to 4 components, or with a bad stride */
    GN_INVALID_VIEWPORT,    /**< a viewport with a size or an origin that is not allowed */
    GN_INDEX_OUT_OF_RANGE,  /**< an index names a vertex the arrays do not have */
    GN_WORKSPACE_TOO_SMALL, /**< below the minimum; the size queries say how much is needed */
    GN_BACKEND_UNAVAILABLE, /**< a back end the library or the processor does not have */
    GN_BEHIND_EYE,          /**< a point in the plane of the eye, behind it, or at infinity */
    GN_NOT_COMPILED,        /**< a feature that the library was compiled without */
    GN_INVALID_SAMPLES,     /**< a number of samples that a surface or the call does not allow */
    GN_OVERLAP,             /**< memory that is read overlaps memory that is written */
    GN_STATUS_COUNT         /**< the number of values, not a status */
} gn_status;

GN_BEGIN

/** Returns the status in words: a sentence without a full stop, in static storage. For a value that
 * is no gn_status, returns "unknown status". */
GN_API const char *gn_status_text(gn_status status);

GN_END

#endif
