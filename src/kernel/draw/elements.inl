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
                             (uint64_t)first + count > draw->mesh->count;

    read_elements(draw->mesh, first, count - closing, vertex);
    read_elements(draw->mesh, 0, closing, vertex + count - closing);
}

/* Returns the least and the greatest vertex that elements first to first + count - 1 name. Restarts
 * are skipped; the range may be empty. Lanes compare signed numbers: subtracting 2^31 turns
 * unsigned order into signed order. */
static index_range find_range(const mesh_slice *mesh, uint32_t first, uint32_t count)
{
    const lanes_i bias = lanes_i_splat(INT32_MIN);
    const lanes_i base = lanes_i_add(bias, lanes_i_splat((int32_t)mesh->base));
    lanes_i low = lanes_i_splat(INT32_MAX);
    lanes_i high = lanes_i_splat(INT32_MIN);
    int32_t lows[GN_LANES], highs[GN_LANES];
    index_range range = {UINT32_MAX, 0};
    uint32_t done = 0;

    if (mesh->index_format == GN_INDEX_UINT32 && !has_restarts(mesh)) {
        const int32_t *indices = (const int32_t *)mesh->indices + mesh->first + first;

        for (; count - done >= GN_LANES; done += GN_LANES) {
            const lanes_i index = lanes_i_add(lanes_i_load(indices + done), base);
            low = lanes_i_min(low, index);
            high = lanes_i_max(high, index);
        }
    }
    lanes_i_store(lows, lanes_i_add(low, bias));
    lanes_i_store(highs, lanes_i_add(high, bias));
    GN_EACH_LANE (l) {
        const index_range lane = {(uint32_t)lows[l], (uint32_t)highs[l]};
        range = join_ranges(range, lane);
    }
    while (done < count) {
        uint32_t vertex[ELEMENTS_READ];
        const uint32_t some = count - done < ELEMENTS_READ ? count - done : ELEMENTS_READ;

        read_elements(mesh, first + done, some, vertex);
        for (uint32_t i = 0; i < some; ++i) {
            const index_range one = {vertex[i], vertex[i]};
            if (!has_restarts(mesh) || vertex[i] - mesh->base != mesh->restart_index)
                range = join_ranges(range, one);
        }
        done += some;
    }
    return range;
}

static inline void divide_indices(index_chunks *chunks, const mesh_slice *mesh)
{
    const uint32_t count = mesh->count;
    const uint32_t even = (count - 1) / INDEX_CHUNKS + 1;

    chunks->mesh = mesh;
    chunks->size = even > CHUNK_INDICES ? even : CHUNK_INDICES;
    chunks->count = (count - 1) / chunks->size + 1;
}

/* Finds the range of vertices of chunks first to first + count - 1. */
static void scan_chunks(draw_state *draw, uint32_t first, uint32_t count)
{
    index_chunks *const chunks = &draw->chunks;

    for (uint32_t p = first; p < first + count; ++p) {
        const uint32_t skipped = p * chunks->size;
        const uint32_t rest = chunks->mesh->count - skipped;

        chunks->range[p] =
            find_range(chunks->mesh, skipped, rest < chunks->size ? rest : chunks->size);
    }
}

/* Turns each chunk's `high` into a running maximum; returns the overall range. */
static index_range join_chunks(index_chunks *chunks)
{
    index_range all = chunks->range[0];

    for (uint32_t p = 1; p < chunks->count; ++p) {
        all = join_ranges(all, chunks->range[p]);
        chunks->range[p].high = all.high;
    }
    return all;
}

/* Returns how many slots must be shaded before the elements of a chunk can be assembled: a multiple
 * of sixteen, or all. */
static inline uint32_t slots_of_chunk(const draw_state *draw, uint32_t chunk)
{
    const uint32_t last = draw->chunks.range[chunk].high - draw->map.base;
    const uint32_t slots = (last / GN_LANES + 1) * GN_LANES;

    return slots < draw->map.count ? slots : draw->map.count;
}

/* Returns how many slots must be shaded before the elements below `end` can be assembled. */
static inline uint32_t slots_before(const draw_state *draw, uint32_t end)
{
    const uint32_t last_in_slice = end < draw->mesh->count ? end - 1 : draw->mesh->count - 1;
    const uint32_t last =
        GN_HAVE_INSTANCES ? (uint32_t)(draw->mesh->first - draw->chunks.mesh->first) + last_in_slice
                          : last_in_slice;

    return slots_of_chunk(draw, last / draw->chunks.size);
}

/* Returns the most slots in use at once if a shared draw takes `elements` elements at a time: from
 * the first vertex that their first chunk names to the last vertex that is shaded for their last
 * chunk, rounded up to a packet. A later chunk that names an earlier vertex counts in its own
 * turn. */
static uint32_t slots_in_use(const draw_state *draw, uint32_t elements)
{
    const index_chunks *chunks = &draw->chunks;
    const uint32_t reach = (elements - 1) / chunks->size + 1;
    uint32_t most = 0;

    for (uint32_t p = 0; p < chunks->count; ++p) {
        const uint32_t last = p + reach < chunks->count ? p + reach : chunks->count - 1;
        const uint32_t first = chunks->range[p].low - draw->map.base;
        const uint32_t end =
            (slots_of_chunk(draw, last) + GN_LANES - 1) & ~(uint32_t)(GN_LANES - 1);
        const uint32_t used = end - first;

        if (chunks->range[p].low <= chunks->range[p].high) /* not restarts alone */
            most = used > most ? used : most;
    }
    return most;
}

/* Finds where the vertices of triangles first to first + count - 1 of the slice are stored: writes
 * the offset of each of their elements and returns how many elements there are. A fan's first
 * offset is that of the slice's first element. */
GN_SHARED uint32_t locate_elements(const draw_state *draw, uint32_t first, uint32_t count,
                                   uint32_t offset[ASSEMBLE_MAX_ELEMENTS])
{
    const gn_topology topology = draw->pipeline->raster.topology;
    const uint32_t elements = element_count(topology, count);
    const uint32_t element = first_element(topology, first);
    const uint32_t vertices = draw->vertices;
    const uint32_t stride = draw->stride;
    const bool is_fan = topology == GN_TRIANGLE_FAN;

    if (draw->map.shared) {
        read_drawn_elements(draw, element, elements, offset);
        if (is_fan)
            read_elements(draw->mesh, 0, 1, offset);
        for (uint32_t i = 0; i < elements; ++i)
            offset[i] = vertices + ((offset[i] - draw->map.base) & draw->map.ring) * stride;
    } else {
        for (uint32_t i = 0; i < elements; ++i)
            offset[i] = vertices + (element + i - draw->map.first) * stride;
        if (is_fan)
            offset[0] = vertices;
    }
    return elements;
}

#endif
