/* Statuses in words. */
#include <gnomon/status.h>

/* Texts have a fixed width: a table of pointers would need relocation. */
static const char texts[GN_STATUS_COUNT][64] = {
    "no error",
    "a required pointer is null",
    "a number is NaN or infinite",
    "a number is out of range",
    "a direction has no length, or two directions are parallel",
    "the matrix is singular",
    "an enumeration field holds none of its values",
    "a width or height is zero or too large",
    "the format does not fit its use",
    "a stride is too short or too long",
    "memory or a stride is not aligned to its element",
    "surfaces differ in size or number of samples",
    "the target has neither colour nor depth",
    "the pipeline lacks a shader",
    "the pipeline has too many varyings",
    "an attribute has a bad component count or stride",
    "the viewport has a size or an origin that is not allowed",
    "an index or range lies outside the vertex arrays",
    "the workspace is too small",
    "the library or the processor does not have this back end",
    "the point lies in the plane of the eye or behind it",
    "the library was compiled without this feature",
    "the number of samples is neither one nor four",
    "memory that is read overlaps memory that is written",
};

const char *gn_status_text(gn_status status)
{
    if ((unsigned)status >= GN_STATUS_COUNT)
        return "unknown status";
    return texts[status];
}
