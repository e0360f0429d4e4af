/* Vertex fetch: from the caller's attribute arrays to structures of arrays. */
#ifndef GN_KERNEL_GEOMETRY_FETCH_ATTRIBUTES_INL
#define GN_KERNEL_GEOMETRY_FETCH_ATTRIBUTES_INL

#include "geometry.h"

#include "../../lanes/lanes.h"

/* Returns how many components of an attribute come from its array, vertex by vertex. */
static inline uint32_t array_components(const gn_attribute *attribute)
{
    return attribute->data && attribute->divisor == 0 ? attribute->components : 0;
}

static inline uint32_t present_attributes(const mesh_slice *mesh)
{
    uint32_t bits = 0;

    for (uint32_t a = 0; a < GN_MAX_ATTRIBUTES; ++a)
        bits |= (uint32_t)(mesh->attribute[a].data != 0) << a;
    return bits;
}

/* Returns a component that all vertices of an instance share: 0, 0, 0, 1 if there is no array. */
static inline float constant_component(const gn_attribute *source, uint32_t instance, uint32_t c)
{
    if (!source->data || source->divisor == 0 || c >= source->components)
        return c == 3 ? 1.0f : 0.0f;

    const size_t stride = source->stride ? source->stride / sizeof(float) : source->components;
    return source->data[instance / source->divisor * stride + c];
}

/* Writes the components that all vertices of an instance share. fetch_attributes leaves them as
 * they are. */
static inline void fetch_constants(const mesh_slice *mesh,
                                   float attribute[GN_MAX_ATTRIBUTES][4][GN_LANES])
{
    for (uint32_t a = 0; a < GN_MAX_ATTRIBUTES; ++a) {
        for (uint32_t c = array_components(&mesh->attribute[a]); c < 4; ++c) {
            const float value = constant_component(&mesh->attribute[a], mesh->instance, c);

            GN_EACH_LANE (l)
                attribute[a][c][l] = value;
        }
    }
}

/* Returns whether rows of four words from every vertex up to `last` lie in the attribute's array,
 * at offsets that fit 32 bits. The last vertices of an attribute with fewer components lack
 * them. */
static inline bool has_rows_in_memory(const gn_attribute *source, size_t stride,
                                      uint32_t vertex_count, uint32_t last)
{
    const uint64_t end = (uint64_t)(vertex_count - 1) * stride + source->components;

    return end <= UINT32_MAX / sizeof(float) && (uint64_t)last * stride + 4 <= end;
}

static inline void fetch_rows(const gn_attribute *source, size_t stride,
                              const uint32_t vertex[GN_LANES], float out[4][GN_LANES])
{
    uint32_t offset[LANES];
    lanes_i row[4];

    GN_EACH_LANE (l)
        offset[l] = vertex[l] * (uint32_t)(stride * sizeof(float));
    lanes_i_gather_rows((const unsigned char *)source->data, offset, 1, row);
    for (uint32_t c = 0; c < source->components; ++c)
        lanes_store(out[c], lanes_as_float(row[c]));
}

/* Fetches those components of sixteen vertices that their arrays have. */
GN_FRAMED void fetch_attributes(const mesh_slice *mesh, const uint32_t vertex[LANES],
                                float attribute[GN_MAX_ATTRIBUTES][4][GN_LANES])
{
    uint32_t last = 0;

    GN_EACH_LANE (l)
        last = vertex[l] > last ? vertex[l] : last;
    for (uint32_t a = 0; a < GN_MAX_ATTRIBUTES; ++a) {
        const gn_attribute *source = &mesh->attribute[a];
        const uint32_t components = array_components(source);
        const size_t stride = source->stride ? source->stride / sizeof(float) : components;

        if (components == 0)
            continue;
        if (LANES == 1) { /* rows of four words gain nothing */
            const float *const first = source->data + vertex[0] * stride;

            for (uint32_t c = 0; c < components; ++c)
                attribute[a][c][0] = first[c];
            continue;
        }
        if (has_rows_in_memory(source, stride, mesh->vertex_count, last)) {
            fetch_rows(source, stride, vertex, attribute[a]);
            continue;
        }
        for (uint32_t c = 0; c < components; ++c)
            GN_EACH_LANE (l)
                attribute[a][c][l] = source->data[vertex[l] * stride + c];
    }
}

#endif
