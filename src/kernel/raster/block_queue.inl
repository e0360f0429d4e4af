/* What coverage hands to the fragment stages: blocks, which it queues, and spans of covered
 * squares. */
#ifndef GN_KERNEL_RASTER_BLOCK_QUEUE_INL
#define GN_KERNEL_RASTER_BLOCK_QUEUE_INL

#include "square.inl"

/* A function that shades blocks, in order; it may change them. No pixel is in two blocks of one
 * triangle, or in both halves of a block. */
typedef void blocks_function(const void *context, covered_block *blocks, uint32_t count);

/* A function that shades a span: `count` neighbouring squares in a row, all of their pixels
 * covered, the first at (x, y), a multiple of the square's size. */
typedef void span_function(const void *context, uint32_t lane, int32_t x, int32_t y,
                           uint32_t count);

/* The functions that shade a draw's fragments. `spans` is null if spans are shaded as blocks. If
 * `packs`, small triangles are covered in packed halves: packing takes time, but saves more where
 * fragments call a shader. */
typedef struct fragment_functions {
    blocks_function *blocks;
    span_function *spans;
    bool packs;
} fragment_functions;

/* Blocks that are shaded together, of one or more triangles: fewer where operations are loops, to
 * save stack. */
#if !GN_STATES_SPECIALISED
#define QUEUE_BLOCKS 1
#elif defined(GN_LANES_ARRAYS)
#define QUEUE_BLOCKS 16
#else
#define QUEUE_BLOCKS 32
#endif

typedef struct block_queue {
    const fragment_functions *shade;
    const void *context;
    uint32_t count;
    covered_block block[QUEUE_BLOCKS];
} block_queue;

static inline void start_queue(block_queue *queue, const fragment_functions *shade,
                               const void *context)
{
    queue->shade = shade;
    queue->context = context;
    queue->count = 0;
}

static inline void flush_queue(block_queue *queue)
{
    if (queue->count)
        queue->shade->blocks(queue->context, queue->block, queue->count);
    queue->count = 0;
}

/* Shades the queued blocks if fewer than `room` blocks fit. */
static inline void make_queue_room(block_queue *queue, uint32_t room)
{
    if (queue->count + room > QUEUE_BLOCKS)
        flush_queue(queue);
}

/* Adds a square if any of its pixels is covered. Precondition: the queue has room. There is no
 * branch on the coverage, since processors cannot predict it. */
static inline void add_square(block_queue *queue, uint32_t lane, int32_t x, int32_t y,
                              uint32_t coverage)
{
    covered_block *const block = &queue->block[queue->count];

    block->lane = lane;
    block->at = square_block(x, y);
    block->covered[0] = coverage & HALF_COVERED;
    block->covered[1] = coverage >> HALF_LANES;
    queue->count += coverage != 0;
}

/* Adds a span of covered squares. If `others` is not 0, the queue may hold blocks of other
 * triangles: these are shaded first, so that every pixel sees the triangles in order, and `others`
 * becomes 0. */
static inline void add_span(block_queue *queue, uint32_t lane, int32_t x, int32_t y, uint32_t count,
                            uint32_t *others)
{
    if (queue->shade->spans && (count > 1 || LANES == 1)) {
        if (*others)
            flush_queue(queue);
        *others = 0;
        queue->shade->spans(queue->context, lane, x, y, count);
        return;
    }
    for (uint32_t i = 0; i < count; ++i) {
        make_queue_room(queue, 1);
        add_square(queue, lane, x + (int32_t)i * SQUARE_SIZE, y, GN_ALL_LANES);
    }
}

/* Adds a square of which some pixels are covered, and makes room for it first. */
static inline void add_partial_square(block_queue *queue, uint32_t lane, int32_t x, int32_t y,
                                      uint32_t coverage)
{
    make_queue_room(queue, 1);
    add_square(queue, lane, x, y, coverage);
}

#endif
