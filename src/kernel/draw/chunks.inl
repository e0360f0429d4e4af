/* The indices of a mesh in chunks: which vertices each of them names, and how many slots must be
 * shaded before its elements are assembled. */
#ifndef GN_KERNEL_DRAW_CHUNKS_INL
#define GN_KERNEL_DRAW_CHUNKS_INL

#include "elements.inl"

/* Returns the least and the greatest vertex that elements first to first + count - 1 name. Restarts
 * are skipped; the range may be empty. Lanes compare signed numbers: subtracting 2^31 turns
 * unsigned order into signed order. */
static vertex_range find_range(const mesh_slice *mesh, uint32_t first, uint32_t count)
{
    const lanes_i bias = lanes_i_splat(INT32_MIN);
    const lanes_i base = lanes_i_add(bias, lanes_i_splat((int32_t)mesh->base));
    lanes_i low = lanes_i_splat(INT32_MAX);
    lanes_i high = lanes_i_splat(INT32_MIN);
    int32_t lows[LANES], highs[LANES];
    vertex_range range = {UINT32_MAX, 0};
    uint32_t done = 0;

    if (mesh->index_format == GN_INDEX_UINT32 && !has_restarts(mesh)) {
        const int32_t *indices = (const int32_t *)mesh->indices + mesh->first + first;

        for (; count - done >= LANES; done += LANES) {
            const lanes_i index = lanes_i_add(lanes_i_load(indices + done), base);
            low = lanes_i_min(low, index);
            high = lanes_i_max(high, index);
        }
    }
    lanes_i_store(lows, lanes_i_add(low, bias));
    lanes_i_store(highs, lanes_i_add(high, bias));
    GN_EACH_LANE (l) {
        const vertex_range lane = {(uint32_t)lows[l], (uint32_t)highs[l]};
        range = join_ranges(range, lane);
    }
    while (done < count) {
        uint32_t vertex[ELEMENTS_READ];
        const uint32_t some = count - done < ELEMENTS_READ ? count - done : ELEMENTS_READ;

        read_elements(mesh, first + done, some, vertex);
        for (uint32_t i = 0; i < some; ++i) {
            const vertex_range one = {vertex[i], vertex[i]};
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

    for (uint32_t c = first; c < first + count; ++c) {
        const uint32_t skipped = c * chunks->size;
        const uint32_t rest = chunks->mesh->count - skipped;

        chunks->range[c] =
            find_range(chunks->mesh, skipped, rest < chunks->size ? rest : chunks->size);
    }
}

/* Turns each chunk's `high` into a running maximum; returns the overall range. */
static vertex_range accumulate_chunks(index_chunks *chunks)
{
    vertex_range all = chunks->range[0];

    for (uint32_t c = 1; c < chunks->count; ++c) {
        all = join_ranges(all, chunks->range[c]);
        chunks->range[c].high = all.high;
    }
    return all;
}

/* Returns how many slots must be shaded before the elements of a chunk can be assembled: a multiple
 * of sixteen, or all. */
static inline uint32_t slots_of_chunk(const draw_state *draw, uint32_t chunk)
{
    const uint32_t last = draw->chunks.range[chunk].high - draw->map.base;
    const uint32_t slots = (last / LANES + 1) * LANES;

    return slots < draw->map.count ? slots : draw->map.count;
}

/* Returns how many slots must be shaded before the elements below `end` can be assembled. */
static inline uint32_t slots_before(const draw_state *draw, uint32_t end)
{
    const uint32_t last_in_slice = end < draw->slice.count ? end - 1 : draw->slice.count - 1;
    const uint32_t before = (uint32_t)(draw->slice.first - draw->chunks.mesh->first);

    return slots_of_chunk(draw, (before + last_in_slice) / draw->chunks.size);
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

    for (uint32_t c = 0; c < chunks->count; ++c) {
        const uint32_t last = c + reach < chunks->count ? c + reach : chunks->count - 1;
        const uint32_t first = chunks->range[c].low - draw->map.base;
        const uint32_t end = (slots_of_chunk(draw, last) + LANES - 1) & ~(uint32_t)(LANES - 1);
        const uint32_t used = end - first;

        if (chunks->range[c].low <= chunks->range[c].high) /* not restarts alone */
            most = used > most ? used : most;
    }
    return most;
}

#endif
