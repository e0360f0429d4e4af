/* Primitive assembly: which elements make the triangles of a topology, in the order in which the
 * reference hands triangles to set-up. The provoking vertex comes last or first, and later stages
 * keep it there. */
#ifndef GN_KERNEL_GEOMETRY_ASSEMBLE_H
#define GN_KERNEL_GEOMETRY_ASSEMBLE_H

#include "geometry.h"

typedef enum primitive_kind { KIND_TRIANGLE, KIND_LINE, KIND_POINT } primitive_kind;

static inline primitive_kind kind_of(gn_topology topology)
{
    return topology == GN_POINTS ? KIND_POINT : topology >= GN_LINES ? KIND_LINE : KIND_TRIANGLE;
}

/* Returns the number of vertices of a primitive. */
static inline uint32_t corner_count(gn_topology topology)
{
    return topology == GN_POINTS ? 1 : topology >= GN_LINES ? 2 : 3;
}

/* Returns how many elements lie between the first of a primitive and the first of the next. */
static inline uint32_t element_stride(gn_topology topology)
{
    return topology == GN_TRIANGLES ? 3 : topology == GN_LINES ? 2 : 1;
}

/* Returns how many primitives a number of elements make, from any primitive on. Precondition: the
 * elements make at least one. */
static inline uint32_t primitives_of(gn_topology topology, uint32_t elements)
{
    return (elements - corner_count(topology)) / element_stride(topology) + 1;
}

/* Returns how many primitives `count` elements make. A line loop has one line more than a strip. */
static inline uint32_t primitive_count(gn_topology topology, uint32_t count)
{
    if (count < corner_count(topology))
        return 0;
    return primitives_of(topology, count) + (topology == GN_LINE_LOOP);
}

/* Primitives `first` to first + count - 1 have the elements first_element to first_element +
 * element_count - 1; those of a fan also have the slice's first element. The element after the last
 * one of a line loop is its first. */
static inline uint32_t first_element(gn_topology topology, uint32_t first)
{
    return element_stride(topology) * first;
}

static inline uint32_t element_count(gn_topology topology, uint32_t count)
{
    return element_stride(topology) * (count - 1) + corner_count(topology);
}

/* Primitives whose elements are located together, and the most elements that these have. */
#define PRIMITIVES_LOCATED 16
#define ASSEMBLE_MAX_ELEMENTS (3 * PRIMITIVES_LOCATED)

/* Assembles group->count triangles from `first` on. `element` holds the vertices of the elements
 * from first_element on; for a fan its first place holds the slice's first element. All places must
 * hold vertices, and `element` must last as long as the group. A fan that is taken as a quad has
 * the triangles (0, i+1, i+2), whichever vertex provokes. */
static inline void assemble_triangles(gn_topology topology, bool provoking_first, bool is_quad,
                                      uint32_t first, const uint32_t *element,
                                      triangle_group *group)
{
    uint32_t *const a = group->made[0];
    uint32_t *const b = group->made[1];
    uint32_t *const c = group->made[2];
    const bool center_first = is_quad || !provoking_first;

    if (topology == GN_TRIANGLES) {
        group->stride = 3;
        for (int i = 0; i < 3; ++i)
            group->corner[i] = element + i;
        return;
    }
    group->stride = 1;
    for (int i = 0; i < 3; ++i)
        group->corner[i] = group->made[i];
    for (uint32_t l = 0; l < LANES; ++l) {
        const uint32_t odd = (first + l) & 1;

        if (topology == GN_TRIANGLE_STRIP) {
            a[l] = element[provoking_first ? l : l + odd];
            b[l] = element[provoking_first ? l + 1 + odd : l + 1 - odd];
            c[l] = element[provoking_first ? l + 2 - odd : l + 2];
        } else {
            a[l] = element[center_first ? 0 : l + 1];
            b[l] = element[center_first ? l + 1 : l + 2];
            c[l] = element[center_first ? l + 2 : 0];
        }
    }
}

#endif
