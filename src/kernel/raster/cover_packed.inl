/* Coverage in packed blocks: the covered halves of a small triangle's squares, two to a block, so
 * that fewer pixels outside the triangle are shaded in vain. */
#ifndef GN_KERNEL_RASTER_COVER_PACKED_INL
#define GN_KERNEL_RASTER_COVER_PACKED_INL

#include "block_queue.inl"

/* Halves side by side in a uint64_t: a byte of coverage each, the first in the lowest byte. */
#define HALVES_TOGETHER 8
#define EVERY_HALF(byte) (UINT64_C(0x0101010101010101) * (byte))

/* Lanes of the left and of the right quad of a half. */
#define LEFT_QUAD 0x33u
#define RIGHT_QUAD 0xCCu

static inline uint32_t count_covered(uint64_t halves)
{
    halves = (halves | halves >> 4) & EVERY_HALF(15);
    halves = (halves | halves >> 2) & EVERY_HALF(3);
    halves = (halves | halves >> 1) & EVERY_HALF(1);
    return (uint32_t)(halves * EVERY_HALF(1) >> 56);
}

/* Adds the covered ones of `size` halves from (x, y) on to a queue that holds `count` halves;
 * returns how many it holds then. There is no branch on their coverage, since processors cannot
 * predict it. If the outer quads on both sides are empty, the halves may begin two columns further
 * right: they stay on these squares and overlap no other row's. This is done if it leaves fewer
 * halves. */
static inline uint32_t add_halves(block_queue *queue, uint32_t lane, uint32_t count,
                                  uint64_t halves, uint32_t size, int32_t x, int32_t y)
{
    if (!(halves & LEFT_QUAD) && !(halves >> 8 * (size - 1) & RIGHT_QUAD)) {
        const uint64_t moved =
            (halves >> 2 & EVERY_HALF(LEFT_QUAD)) | (halves >> 6 & EVERY_HALF(RIGHT_QUAD));

        if (count_covered(moved) < count_covered(halves)) {
            halves = moved;
            x += SQUARE_SIZE / 2;
        }
    }
    for (uint32_t i = 0; i < size; ++i) {
        covered_block *const block = &queue->block[count / 2];
        const uint32_t covered = (uint32_t)(halves >> 8 * i) & HALF_COVERED;

        block->lane = lane;
        block->at.x[count % 2] = x + (int32_t)i * SQUARE_SIZE;
        block->at.y[count % 2] = y;
        block->covered[count % 2] = covered;
        count += covered != 0;
    }
    return count;
}

/* Makes blocks of the queue's first `count` halves. A half that is left over is paired with an
 * empty one: the other half of its square at a multiple of four rows. All rows of that square are
 * in the band (place_squares). */
static inline void finish_halves(block_queue *queue, uint32_t count)
{
    covered_block *const last = &queue->block[count / 2];

    if (count % 2) {
        last->at.x[1] = last->at.x[0];
        last->at.y[1] = last->at.y[0] ^ (SQUARE_SIZE / 2);
        last->covered[1] = 0;
    }
    queue->count = (count + 1) / 2;
}

/* The edge functions of a small triangle. */
typedef struct small_edges {
    int32_t start[3]; /* at the lower left pixel of a row's first square */
    int32_t fall_per_square[3], rise_per_row[3];
    lanes_i pixel[3];    /* change from there to each pixel of a square */
    lanes_i greatest[3]; /* change from there to the greatest value in each of sixteen squares */
} small_edges;

#define SQUARE_NUMBER(l) l

static inline void set_small_edge(small_edges *e, const primitive_setup *setup, int edge,
                                  uint32_t lane)
{
    static const int32_t number[LANES] = GN_NUMBERS(SQUARE_NUMBER);
    const int32_t per_x = setup->edge[edge].per_x[lane];
    const int32_t per_y = setup->edge[edge].per_y[lane];
    const int32_t rise = (per_x < 0 ? -per_x : 0) + (per_y > 0 ? per_y : 0);

    e->start[edge] = setup->edge[edge].start[lane];
    e->fall_per_square[edge] = SQUARE_SIZE * per_x;
    e->rise_per_row[edge] = SQUARE_SIZE * per_y;
    e->pixel[edge] = edge_values(0, per_x, per_y);
    e->greatest[edge] =
        lanes_i_sub(lanes_i_splat((SQUARE_SIZE - 1) * rise),
                    lanes_i_mul(lanes_i_splat(e->fall_per_square[edge]), lanes_i_load(number)));
}

static inline void set_small_edges(small_edges *e, const primitive_setup *setup, uint32_t lane)
{
    for (int i = 0; i < 3; ++i)
        set_small_edge(e, setup, i, lane);
}

/* Moves the edge functions to the next row of squares. */
static inline void step_up(small_edges *e)
{
    for (int i = 0; i < 3; ++i)
        e->start[i] += e->rise_per_row[i];
}

/* Returns the lanes in which no edge function is negative. `term` says what lanes are: the pixels
 * of square `number` of a row (`pixel`), or that square and the next fifteen (`greatest`). Squares
 * that are met are consecutive. */
static inline uint32_t lanes_met(const small_edges *e, int32_t number, const lanes_i term[3])
{
    lanes_i value[3];

    for (int i = 0; i < 3; ++i)
        value[i] =
            lanes_i_add(lanes_i_splat(e->start[i] - e->fall_per_square[i] * number), term[i]);
    return not_negative(value);
}

/* Covers the row of `squares` squares at y, from the one at (left, y) on. `count` is the number of
 * halves that the queue holds; returns how many it holds then. */
GN_INLINE uint32_t cover_packed_row(const pixel_rectangle *region, const small_edges *edges,
                                    int32_t left, int32_t squares, int32_t y, uint32_t lane,
                                    block_queue *queue, uint32_t count)
{
    const square_range columns = squares_inside(region->min_x, region->max_x);
    const bool hangs = begins_outside(squares_inside(region->min_y, region->max_y), y);

    for (int32_t from = 0; from < squares; from += LANES) {
        const uint32_t met = lanes_met(edges, from, edges->greatest);
        const int32_t first = from + (int32_t)count_lanes(~met & (met - 1) & GN_ALL_LANES);
        const int32_t after = first + (int32_t)count_lanes(met);
        const int32_t end = after < squares ? after : squares;

        for (int32_t n = first; n < end; n += HALVES_TOGETHER) {
            const uint32_t size = end - n < HALVES_TOGETHER ? (uint32_t)(end - n) : HALVES_TOGETHER;
            const int32_t x = left + n * SQUARE_SIZE;
            uint64_t lower = 0, upper = 0;

            for (uint32_t i = 0; i < size; ++i) {
                const int32_t column = x + (int32_t)i * SQUARE_SIZE;
                uint32_t coverage = lanes_met(edges, n + (int32_t)i, edges->pixel);

                if (hangs || begins_outside(columns, column))
                    coverage &= square_mask(region, column, y);
                lower |= (uint64_t)(coverage & HALF_COVERED) << 8 * i;
                upper |= (uint64_t)(coverage >> HALF_LANES) << 8 * i;
            }
            if (count > 2u * QUEUE_BLOCKS - 1 - 2 * HALVES_TOGETHER) {
                finish_halves(queue, count);
                flush_queue(queue);
                count = 0;
            }
            count = add_halves(queue, lane, count, lower, size, x, y);
            count = add_halves(queue, lane, count, upper, size, x, y + SQUARE_SIZE / 2);
        }
    }
    return count;
}

/* Covers a triangle below PACKED_EXTENT. Pixels outside the triangle's bounds are outside an edge
 * too, so only what hangs over `region` is masked. */
GN_OUT_OF_LINE void cover_packed(const pixel_rectangle *region, const primitive_setup *setup,
                                 const primitive_list *list, uint32_t lane, block_queue *queue)
{
    const int32_t left = setup->origin[0][lane];
    const int32_t squares = (list->bounds[BOUNDS_MAX_X][lane] - left) / SQUARE_SIZE + 1;
    const int32_t max_y = list->bounds[BOUNDS_MAX_Y][lane];
    small_edges edges;
    uint32_t count = 2 * queue->count; /* halves */

    set_small_edges(&edges, setup, lane);
    for (int32_t y = setup->origin[1][lane]; y <= max_y; y += SQUARE_SIZE) {
        count = cover_packed_row(region, &edges, left, squares, y, lane, queue, count);
        step_up(&edges);
    }
    finish_halves(queue, count);
}

#endif
