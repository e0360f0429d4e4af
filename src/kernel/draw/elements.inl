/* The elements of a draw: which vertices they name, and where these vertices are stored. */
#ifndef GN_KERNEL_DRAW_ELEMENTS_INL
#define GN_KERNEL_DRAW_ELEMENTS_INL

#include "draw_state.inl"

/* Elements that are read at a time. */
#define ELEMENTS_READ 16

/* Reads the vertices that elements first to first + count - 1 name. */
static inline void read_elements(const mesh_slice *mesh, uint32_t first, uint32_t count,
                                 uint32_t *vertex)
{
    const size_t at = mesh->first + first;

    switch (mesh->index_format) {
    case GN_INDEX_UINT8:
        for (uint32_t i = 0; i < count; ++i)
            vertex[i] = ((const uint8_t *)mesh->indices)[at + i] + mesh->base;
        break;
    case GN_INDEX_UINT16:
        for (uint32_t i = 0; i < count; ++i)
            vertex[i] = ((const uint16_t *)mesh->indices)[at + i] + mesh->base;
        break;
    case GN_INDEX_UINT32:
        for (uint32_t i = 0; i < count; ++i)
            vertex[i] = ((const uint32_t *)mesh->indices)[at + i] + mesh->base;
        break;
    default:
        for (uint32_t i = 0; i < count; ++i)
            vertex[i] = (uint32_t)(at + i);
        break;
    }
}

static inline bool has_restarts(const mesh_slice *mesh)
{
    return GN_HAVE_INSTANCES && mesh->restarts;
}

/* Finds the next slice of a mesh with restarts, at or after element *from, and advances *from past
 * it. Returns false if there is none. */
static bool find_slice(const mesh_slice *mesh, uint32_t *from, mesh_slice *slice)
{
    const uint32_t none = mesh->restart_index + mesh->base;
    uint32_t begin = 0, i = *from;
    bool found = false;

    while (i < mesh->count) {
        uint32_t vertex[ELEMENTS_READ];
        const uint32_t count = mesh->count - i < ELEMENTS_READ ? mesh->count - i : ELEMENTS_READ;
        uint32_t l = 0;

        read_elements(mesh, i, count, vertex);
        while (!found && l < count && vertex[l] == none)
            ++l;
        if (!found)
            begin = i + l;
        found = found || l < count;
        while (l < count && vertex[l] != none)
            ++l;
        i += l;
        if (found && l < count)
            break;
    }
    slice->first = mesh->first + begin;
    slice->count = i - begin;
    *from = i;
    return found;
}

/* Reads the vertices that elements of the draw's slice name. A line loop has one more element than
 * its slice: the first again. */
static inline void read_drawn_elements(const draw_state *draw, uint32_t first, uint32_t count,
                                       uint32_t *vertex)
{
    const uint32_t closing = draw->pipeline->raster.topology == GN_LINE_LOOP &&
                             (uint64_t)first + count > draw->slice.count;

    read_elements(&draw->slice, first, count - closing, vertex);
    read_elements(&draw->slice, 0, closing, vertex + count - closing);
}

/* Finds where the vertices of primitives first to first + count - 1 of the slice are stored: writes
 * the offset of each of their elements and returns how many elements there are. A fan's first
 * offset is that of the slice's first element. */
GN_SHARED uint32_t locate_elements(const draw_state *draw, uint32_t first, uint32_t count,
                                   uint32_t offset[ASSEMBLE_MAX_ELEMENTS])
{
    const gn_topology topology = draw->pipeline->raster.topology;
    const uint32_t elements = element_count(topology, count);
    const uint32_t element = first_element(topology, first);
    const uint32_t slot_0 = draw->slots_offset;
    const uint32_t stride = draw->stride;
    const bool is_fan = topology == GN_TRIANGLE_FAN;

    if (draw->map.shared) {
        read_drawn_elements(draw, element, elements, offset);
        if (is_fan)
            read_elements(&draw->slice, 0, 1, offset);
        for (uint32_t i = 0; i < elements; ++i)
            offset[i] = slot_0 + ((offset[i] - draw->map.base) & draw->map.ring) * stride;
    } else {
        for (uint32_t i = 0; i < elements; ++i)
            offset[i] = slot_0 + (element + i - draw->map.first) * stride;
        if (is_fan)
            offset[0] = slot_0;
    }
    return elements;
}

#endif
