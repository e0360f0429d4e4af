/* Vertex fetch: attribute arrays of the caller into structures of arrays. */
#ifndef GN_GEOMETRY_FETCH_H
#define GN_GEOMETRY_FETCH_H

#include "types.h"

static inline void fetch_attributes(const gn_mesh *mesh, const uint32_t vertex_id[GN_LANES],
                                    float attribute[GN_MAX_ATTRIBUTES][4][GN_LANES])
{
    for (uint32_t a = 0; a < GN_MAX_ATTRIBUTES; ++a) {
        const gn_attribute *source = &mesh->attribute[a];
        const uint32_t components = source->data ? source->components : 0;
        const size_t stride = source->stride ? source->stride / sizeof(float) : components;

        for (uint32_t c = 0; c < components; ++c) {
            for (uint32_t l = 0; l < GN_LANES; ++l)
                attribute[a][c][l] = source->data[vertex_id[l] * stride + c];
        }
        for (uint32_t c = components; c < 4; ++c) {
            for (uint32_t l = 0; l < GN_LANES; ++l)
                attribute[a][c][l] = c == 3 ? 1.0f : 0.0f;
        }
    }
}

#endif
