/* Primitive assembly: which elements make triangle i of a topology, in the order
 * in which the reference hands them to triangle set-up. The provoking vertex
 * comes last or first, and later stages keep it there. */
#ifndef GN_GEOMETRY_ASSEMBLE_H
#define GN_GEOMETRY_ASSEMBLE_H

#include "types.h"

static inline uint32_t triangle_count(gn_topology topology, uint32_t count)
{
    if (topology == GN_TRIANGLES)
        return count / 3;
    return count < 3 ? 0 : count - 2;
}

static inline vertex_triangle assemble_triangle(gn_topology topology, gn_provoking_vertex provoking,
                                                uint32_t i)
{
    const bool first = provoking == GN_PROVOKING_FIRST;
    const uint32_t odd = i & 1;
    vertex_triangle t;

    switch (topology) {
    case GN_TRIANGLE_STRIP:
        t.slot[0] = first ? i : i + odd;
        t.slot[1] = first ? i + 1 + odd : i + 1 - odd;
        t.slot[2] = first ? i + 2 - odd : i + 2;
        break;
    case GN_TRIANGLE_FAN:
        t.slot[0] = first ? i + 1 : 0;
        t.slot[1] = first ? i + 2 : i + 1;
        t.slot[2] = first ? 0 : i + 2;
        break;
    default:
        t.slot[0] = 3 * i;
        t.slot[1] = 3 * i + 1;
        t.slot[2] = 3 * i + 2;
        break;
    }
    t.provoking = t.slot[first ? 0 : 2];
    return t;
}

static inline vertex_triangle assemble_quad(uint32_t i)
{
    const vertex_triangle t = {{0, i + 1, i + 2}, 0};

    return t;
}

#endif
