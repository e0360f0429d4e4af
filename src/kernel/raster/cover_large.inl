/* Coverage of large triangles. Edge functions are exact in 64 bits at the corner of a square. A
 * row's outside and inside squares are counted in strides of 64 squares and less. */
#ifndef GN_KERNEL_RASTER_COVER_LARGE_INL
#define GN_KERNEL_RASTER_COVER_LARGE_INL

#include "block_queue.inl"

/* Exceeds every change of an edge function within a square: 3 * (|per_x| + |per_y|), both below
 * 2^25. A value that is clamped to this keeps its sign in all of the square. */
#define EDGE_LIMIT ((int64_t)1 << 28)

/* An edge function of a large triangle. */
typedef struct large_edge {
    int64_t constant; /* at the pixel (0, 0) of the target */
    int32_t per_x, per_y;
    int32_t least; /* least and greatest change within a square, from its lower left pixel */
    int32_t greatest;
    lanes_i pixel; /* change from there to each of its pixels */
} large_edge;

/* Returns a * b, which needs 64 bits. */
static inline int64_t wide_product(int32_t a, int32_t b)
{
    return (int64_t)a * b;
}

/* Returns 1 if the pixels whose centres lie on an edge belong to the primitive, otherwise 0. Left
 * edges own their ties; of horizontal edges the lower one does, in clip space. */
static inline int32_t owns_ties(int32_t per_x, int32_t per_y, bool upside_down)
{
    return per_x < 0 || (per_x == 0 && (upside_down ? per_y < 0 : per_y > 0));
}

/* Sets the edge function of the edge through a point in snapped coordinates. */
static inline void set_edge_through(large_edge *e, int32_t per_x, int32_t per_y, int32_t x,
                                    int32_t y, bool upside_down)
{
    const int32_t change_x = -per_x * (SQUARE_SIZE - 1);
    const int32_t change_y = per_y * (SQUARE_SIZE - 1);
    const int32_t own = owns_ties(per_x, per_y, upside_down);

    e->constant = (wide_product(per_x, x) - wide_product(per_y, y) + own - 1) >> 8;
    e->per_x = per_x;
    e->per_y = per_y;
    e->least = (change_x < 0 ? change_x : 0) + (change_y < 0 ? change_y : 0);
    e->greatest = (change_x > 0 ? change_x : 0) + (change_y > 0 ? change_y : 0);
    e->pixel = edge_values(0, per_x, per_y);
}

static void set_large_edge(large_edge *e, const primitive_setup *setup, int edge, uint32_t lane)
{
    set_edge_through(e, setup->edge[edge].per_x[lane], setup->edge[edge].per_y[lane],
                     setup->corner.snapped[edge][0][lane], setup->corner.snapped[edge][1][lane],
                     setup->upside_down != 0);
}

/* The values of the three edge functions at the lower left pixel of a square. */
typedef struct corner_values {
    int64_t v[3];
} corner_values;

static inline corner_values values_at(const large_edge edge[3], int32_t x, int32_t y)
{
    corner_values c;

    for (int i = 0; i < 3; ++i)
        c.v[i] = edge[i].constant - wide_product(edge[i].per_x, x) + wide_product(edge[i].per_y, y);
    return c;
}

/* Returns the values `squares` squares further to the right. */
static inline corner_values step_right(const large_edge edge[3], corner_values c, int32_t squares)
{
    for (int i = 0; i < 3; ++i)
        c.v[i] -= wide_product(edge[i].per_x, squares * SQUARE_SIZE);
    return c;
}

/* Returns whether one edge excludes all of the square. With `rising`, only edges whose functions
 * grow to the right count: they exclude squares to the left too. */
static inline bool is_outside(const large_edge edge[3], corner_values c, bool rising)
{
    bool outside = false;

    for (int i = 0; i < 3; ++i)
        outside |= c.v[i] + edge[i].greatest < 0 && (!rising || edge[i].per_x < 0);
    return outside;
}

static inline bool is_inside(const large_edge edge[3], corner_values c)
{
    return c.v[0] + edge[0].least >= 0 && c.v[1] + edge[1].least >= 0 &&
           c.v[2] + edge[2].least >= 0;
}

/* Returns how many squares from this one on are inside, up to `limit`. Precondition: this square is
 * inside. Triangles are convex, so every square between two that are inside is inside. */
static inline int32_t count_inside(const large_edge edge[3], corner_values c, int32_t limit)
{
    int32_t count = 1;

    for (int32_t stride = 64; stride > 0; stride /= 2)
        while (count + stride <= limit && is_inside(edge, step_right(edge, c, count + stride - 1)))
            count += stride;
    return count;
}

/* Returns how many squares from this one on are certainly outside, up to `limit`. */
static inline int32_t count_outside(const large_edge edge[3], corner_values c, int32_t limit)
{
    int32_t count = 0;

    for (int32_t stride = 64; stride > 0; stride /= 2)
        while (count + stride <= limit &&
               is_outside(edge, step_right(edge, c, count + stride - 1), true))
            count += stride;
    return count;
}

static inline uint32_t edge_mask(const large_edge edge[3], corner_values c)
{
    lanes_i sign = lanes_i_splat(0);

    for (int i = 0; i < 3; ++i) {
        const int64_t v = c.v[i] > EDGE_LIMIT    ? EDGE_LIMIT
                          : c.v[i] < -EDGE_LIMIT ? -EDGE_LIMIT
                                                 : c.v[i];
        sign = lanes_i_or(sign, lanes_i_add(lanes_i_splat((int32_t)v), edge[i].pixel));
    }
    return GN_ALL_LANES & ~lanes_i_sign_bits(sign);
}

/* Covers one row of squares, from the square at (left, y) to the pixel max_x. Squares may hang over
 * any side of `region`, which may be a band, a scissor or a box. `others` is as in add_span. */
GN_INLINE void cover_row(const pixel_rectangle *region, const large_edge edge[3], int32_t left,
                         int32_t max_x, int32_t y, uint32_t lane, block_queue *queue,
                         uint32_t *others)
{
    corner_values c = values_at(edge, left, y);
    int32_t squares = (max_x - left) / SQUARE_SIZE + 1;
    int32_t skip = is_outside(edge, c, true) ? count_outside(edge, c, squares) : 0;
    int32_t x = left;

    while (squares > skip) {
        c = step_right(edge, c, skip);
        x += skip * SQUARE_SIZE;
        squares -= skip;
        if (is_outside(edge, c, false))
            return;

        const uint32_t overhang = square_mask(region, x, y);
        skip = 1;
        if (SQUARE_SIZE > 1 && !is_inside(edge, c)) {
            const uint32_t coverage = overhang & edge_mask(edge, c);
            if (coverage)
                add_partial_square(queue, lane, x, y, coverage);
        } else if (overhang != GN_ALL_LANES) {
            add_partial_square(queue, lane, x, y, overhang);
        } else {
            /* The last square of a row may hang over the region. */
            const int32_t full_squares = (region->max_x + 1 - x) / SQUARE_SIZE;
            skip = count_inside(edge, c, squares < full_squares ? squares : full_squares);
            add_span(queue, lane, x, y, (uint32_t)skip, others);
        }
    }
}

/* Large triangles that are covered together. */
#define LARGE_TOGETHER (GN_STATES_SPECIALISED ? LANES : 1)

/* The three edge functions of a triangle. */
typedef struct large_edges {
    large_edge of[3];
} large_edges;

static inline void set_large_edges(large_edges *edges, const primitive_setup *setup, uint32_t lane)
{
    for (int i = 0; i < 3; ++i)
        set_large_edge(&edges->of[i], setup, i, lane);
}

/* Sets the edges of `count` lanes of a set-up from `first` on. */
GN_INLINE void set_edges_of_each(large_edges *edges, const primitive_setup *setup, uint32_t first,
                                 uint32_t count)
{
    for (uint32_t i = 0; i < count; ++i)
        set_large_edges(&edges[i], setup, first + i);
}

/* Covers the row of squares at y for lanes `first` to `end` - 1 of a list. edges[0] belongs to lane
 * `first`. `others` is as in add_span. */
GN_INLINE void cover_row_of_each(const pixel_rectangle *region, const large_edges *edges,
                                 const primitive_list *list, uint32_t first, uint32_t end,
                                 int32_t y, block_queue *queue, uint32_t *others)
{
    for (uint32_t l = first; l < end; ++l) {
        const int32_t min_x = list->bounds[BOUNDS_MIN_X][l];

        if (end - first > 1)
            *others = queue->count;
        if (y + SQUARE_SIZE > list->bounds[BOUNDS_MIN_Y][l] && y <= list->bounds[BOUNDS_MAX_Y][l])
            cover_row(region, edges[l - first].of, square_start(min_x),
                      list->bounds[BOUNDS_MAX_X][l], y, l, queue, others);
    }
}

/* Covers lanes `first` to `end` - 1 of a list, row by row. Parameters are those of
 * cover_row_of_each. */
GN_INLINE void cover_rows(const pixel_rectangle *region, const large_edges *edges,
                          const primitive_list *list, uint32_t first, uint32_t end,
                          block_queue *queue)
{
    int32_t bottom = list->bounds[BOUNDS_MIN_Y][first];
    int32_t top = list->bounds[BOUNDS_MAX_Y][first];
    uint32_t others = queue->count;

    for (uint32_t l = first + 1; LANES > 1 && l < end; ++l) {
        const int32_t min_y = list->bounds[BOUNDS_MIN_Y][l];
        const int32_t max_y = list->bounds[BOUNDS_MAX_Y][l];

        bottom = min_y < bottom ? min_y : bottom;
        top = max_y > top ? max_y : top;
    }
    for (int32_t y = square_start(bottom); y <= top; y += SQUARE_SIZE)
        cover_row_of_each(region, edges, list, first, end, y, queue, &others);
}

/* Covers lanes `first` to `end` - 1 of a list. Precondition: they are large, and at most
 * LARGE_TOGETHER. Each row of squares is covered for all triangles before the next row, while its
 * pixels are in the nearest cache. Within a square the triangles keep their order. */
GN_OUT_OF_LINE void cover_large(const pixel_rectangle *region, const primitive_setup *setup,
                                const primitive_list *list, uint32_t first, uint32_t end,
                                block_queue *queue)
{
    large_edges edges[LARGE_TOGETHER];

    set_edges_of_each(edges, setup, first, end - first);
    cover_rows(region, edges, list, first, end, queue);
}

#endif
