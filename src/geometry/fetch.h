/* Vertex fetch: attribute arrays of the caller into structures of arrays. */
#ifndef GN_GEOMETRY_FETCH_H
#define GN_GEOMETRY_FETCH_H

#include "types.h"

#include "../lanes/lanes.h"

/* Components of an attribute that come from its array. */
static inline uint32_t array_components(const gn_attribute *attribute)
{
    return attribute->data ? attribute->components : 0;
}

/* What arrays lack, 0, 0, 0, 1, which stays as it is from batch to batch. */
static inline void fetch_defaults(const gn_mesh *mesh,
                                  float attribute[GN_MAX_ATTRIBUTES][4][GN_LANES])
{
    for (uint32_t a = 0; a < GN_MAX_ATTRIBUTES; ++a) {
        for (uint32_t c = array_components(&mesh->attribute[a]); c < 4; ++c) {
            GN_EACH_LANE (l)
                attribute[a][c][l] = c == 3 ? 1.0f : 0.0f;
        }
    }
}

/* Sixteen vertices' attributes, as far as the arrays have them. */
static inline void fetch_attributes(const gn_mesh *mesh, const uint32_t vertex_id[GN_LANES],
                                    float attribute[GN_MAX_ATTRIBUTES][4][GN_LANES])
{
    for (uint32_t a = 0; a < GN_MAX_ATTRIBUTES; ++a) {
        const gn_attribute *source = &mesh->attribute[a];
        const uint32_t components = array_components(source);
        const size_t stride = source->stride ? source->stride / sizeof(float) : components;

        for (uint32_t c = 0; c < components; ++c) {
            GN_EACH_LANE (l)
                attribute[a][c][l] = source->data[vertex_id[l] * stride + c];
        }
    }
}

#endif
