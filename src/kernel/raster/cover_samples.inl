/* Coverage of multisampled targets: the edge rule of cover_large.inl at the four samples of every
 * pixel instead of at its centre. Squares have a mask for each sample; covered ones form spans. */
#ifndef GN_KERNEL_RASTER_COVER_SAMPLES_INL
#define GN_KERNEL_RASTER_COVER_SAMPLES_INL

#include "cover_large.inl"
#include "points_and_lines.inl"

/* The greatest distance of a sample from its pixel's centre along one axis, in 1/256 pixel. */
#define SAMPLE_REACH 96

/* Returns a sample's offset from the pixel's centre along an axis, in 1/256 pixel. */
static inline int32_t sample_offset(uint32_t sample, int axis)
{
    static const int8_t offset[GN_SAMPLES][2] = {{-32, -96}, {96, -32}, {-96, 32}, {32, 96}};

    return offset[sample][axis];
}

/* A square with the covered pixels of each sample; its coordinates are multiples of its size. */
typedef struct sampled_square {
    uint32_t lane;
    int32_t x, y;
    uint32_t coverage[GN_SAMPLES];
} sampled_square;

/* A function that shades squares, in order. */
typedef void samples_function(const void *context, const sampled_square *squares, uint32_t count);

/* Shorter spans are shaded as squares. */
#define LEAST_SAMPLED_SPAN 4

/* Squares that are shaded together, of one or more triangles. */
#define SAMPLED_SQUARES (GN_STATES_SPECIALISED ? 16 : 1)

typedef struct sample_queue {
    samples_function *shade;
    span_function *spans; /* shades spans of squares all of whose samples are covered, or null */
    const void *context;
    uint32_t count;
    sampled_square square[SAMPLED_SQUARES];
} sample_queue;

static inline void flush_sample_queue(sample_queue *queue)
{
    if (queue->count)
        queue->shade(queue->context, queue->square, queue->count);
    queue->count = 0;
}

/* Adds a square if any sample is covered. */
static inline void add_sampled_square(sample_queue *queue, uint32_t lane, int32_t x, int32_t y,
                                      const uint32_t coverage[GN_SAMPLES])
{
    sampled_square *const square = &queue->square[queue->count];
    uint32_t any = 0;

    square->lane = lane;
    square->x = x;
    square->y = y;
    for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
        square->coverage[s] = coverage[s];
        any |= coverage[s];
    }
    queue->count += any != 0;
    if (queue->count == SAMPLED_SQUARES)
        flush_sample_queue(queue);
}

/* Adds a span of squares all of whose samples are covered. If the queue holds squares of other
 * triangles, these are shaded first, so that every sample sees the triangles in order. */
static inline void add_sampled_span(sample_queue *queue, uint32_t lane, int32_t x, int32_t y,
                                    int32_t count)
{
    static const uint32_t all[GN_SAMPLES] = {GN_ALL_LANES, GN_ALL_LANES, GN_ALL_LANES,
                                             GN_ALL_LANES};

    if (queue->spans && count >= LEAST_SAMPLED_SPAN) {
        if (queue->count && queue->square[0].lane != lane)
            flush_sample_queue(queue);
        queue->spans(queue->context, lane, x, y, (uint32_t)count);
        return;
    }
    for (int32_t n = 0; n < count; ++n)
        add_sampled_square(queue, lane, x + n * SQUARE_SIZE, y, all);
}

/* The three edges of a triangle as each sample sees them: moved by the negated sample_offset. */
typedef struct sampled_edges {
    bool upside_down; /* as of primitive_setup */
    large_edge of[GN_SAMPLES][3];
    large_edge least[3]; /* the least of all samples: a square inside it is inside for all */
} sampled_edges;

/* Sets `least` of an edge from those of the samples, which differ in their constants alone. */
static inline void set_least_edge(sampled_edges *edges, int edge, int32_t per_x, int32_t per_y,
                                  int32_t x, int32_t y)
{
    large_edge *const least = &edges->least[edge];

    set_edge_through(least, per_x, per_y, x - sample_offset(0, 0), y - sample_offset(0, 1),
                     edges->upside_down);
    for (uint32_t s = 1; s < GN_SAMPLES; ++s)
        if (edges->of[s][edge].constant < least->constant)
            least->constant = edges->of[s][edge].constant;
}

/* Sets an edge of every sample from the edge through the point (x, y). */
static inline void set_edge_of_samples(sampled_edges *edges, int edge, int32_t per_x, int32_t per_y,
                                       int32_t x, int32_t y)
{
    for (uint32_t s = 0; s < GN_SAMPLES; ++s)
        set_edge_through(&edges->of[s][edge], per_x, per_y, x - sample_offset(s, 0),
                         y - sample_offset(s, 1), edges->upside_down);
}

static void set_sampled_edge(sampled_edges *edges, int edge, int32_t per_x, int32_t per_y,
                             int32_t x, int32_t y)
{
    set_edge_of_samples(edges, edge, per_x, per_y, x, y);
    set_least_edge(edges, edge, per_x, per_y, x, y);
}

/* Returns whether every square further to the right is outside too. */
static inline bool has_ended(const large_edge edge[3], corner_values c)
{
    bool ended = false;

    for (int i = 0; i < 3; ++i)
        ended |= edge[i].per_x >= 0 && c.v[i] + edge[i].greatest < 0;
    return ended;
}

/* Returns how many of a row's first `squares` squares lie left of the triangle for all samples. */
static inline int32_t skip_outside(const sampled_edges *edges, int32_t x, int32_t y,
                                   int32_t squares)
{
    for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
        const corner_values c = values_at(edges->of[s], x, y);
        const int32_t count =
            is_outside(edges->of[s], c, true) ? count_outside(edges->of[s], c, squares) : 0;

        squares = count < squares ? count : squares;
    }
    return squares;
}

/* Finds the covered pixels of a square for each sample. Returns whether squares further to the
 * right may have covered pixels. */
static inline bool sample_masks(const sampled_edges *edges, int32_t x, int32_t y, uint32_t inside,
                                uint32_t coverage[GN_SAMPLES])
{
    bool goes_on = false;

    for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
        const large_edge *const edge = edges->of[s];
        const corner_values c = values_at(edge, x, y);

        coverage[s] = is_outside(edge, c, false) ? 0
                      : is_inside(edge, c)       ? inside
                                                 : inside & edge_mask(edge, c);
        goes_on |= !has_ended(edge, c);
    }
    return goes_on;
}

/* Sets the edges of a list's triangle. */
GN_INLINE void set_sampled_edges(sampled_edges *edges, const primitive_setup *setup, uint32_t lane)
{
    edges->upside_down = setup->upside_down != 0;
    for (int i = 0; i < 3; ++i)
        set_sampled_edge(edges, i, setup->edge[i].per_x[lane], setup->edge[i].per_y[lane],
                         setup->corner.snapped[i][0][lane], setup->corner.snapped[i][1][lane]);
}

/* Adds the squares of one row in which samples are covered, from the square at (left, y) to the
 * pixel max_x. */
GN_INLINE void cover_sample_row(const pixel_rectangle *region, const sampled_edges *edges,
                                int32_t left, int32_t max_x, int32_t y, uint32_t lane,
                                sample_queue *queue)
{
    const int32_t squares = (max_x - left) / SQUARE_SIZE + 1;
    int32_t x = left + skip_outside(edges, left, y, squares) * SQUARE_SIZE;
    bool goes_on = true;

    while (goes_on && x <= max_x) {
        const uint32_t inside = square_mask(region, x, y);
        const corner_values c = values_at(edges->least, x, y);
        uint32_t coverage[GN_SAMPLES];

        if (inside == GN_ALL_LANES && is_inside(edges->least, c)) {
            const int32_t last = max_x < region->max_x ? max_x : region->max_x;
            const int32_t full_squares = (last + 1 - x) / SQUARE_SIZE;
            const int32_t span = count_inside(edges->least, c, full_squares > 1 ? full_squares : 1);

            add_sampled_span(queue, lane, x, y, span);
            x += span * SQUARE_SIZE;
            continue;
        }
        goes_on = sample_masks(edges, x, y, inside, coverage);
        add_sampled_square(queue, lane, x, y, coverage);
        x += SQUARE_SIZE;
    }
}

/* Adds the squares of a list's triangle in which samples are covered, from the bottom up and from
 * left to right. */
GN_INLINE void cover_sample_rows(const pixel_rectangle *region, const sampled_edges *edges,
                                 const primitive_list *list, uint32_t lane, sample_queue *queue)
{
    const int32_t left = square_start(list->bounds[BOUNDS_MIN_X][lane]);
    const int32_t bottom = square_start(list->bounds[BOUNDS_MIN_Y][lane]);
    const int32_t max_x = list->bounds[BOUNDS_MAX_X][lane];
    const int32_t max_y = list->bounds[BOUNDS_MAX_Y][lane];

    for (int32_t y = bottom; y <= max_y; y += SQUARE_SIZE)
        cover_sample_row(region, edges, left, max_x, y, lane, queue);
}

/* Covers a list's triangle. Its bounds hold every pixel with a sample inside. */
static inline void cover_triangle_samples(const pixel_rectangle *region,
                                          const primitive_setup *setup, const primitive_list *list,
                                          uint32_t lane, sample_queue *queue)
{
    sampled_edges edges;

    set_sampled_edges(&edges, setup, lane);
    cover_sample_rows(region, &edges, list, lane, queue);
}

/* Finds the covered pixels of a square for each sample, inside all of six edges. */
static inline void sample_masks_between(const sampled_edges *edges, const sampled_edges *others,
                                        int32_t x, int32_t y, uint32_t inside,
                                        uint32_t coverage[GN_SAMPLES])
{
    uint32_t rest[GN_SAMPLES];

    sample_masks(edges, x, y, inside, coverage);
    sample_masks(others, x, y, GN_ALL_LANES, rest);
    for (uint32_t s = 0; s < GN_SAMPLES; ++s)
        coverage[s] &= rest[s];
}

/* Covers the part of a row of a box's squares that is inside all of six edges. */
static inline void cover_sample_row_between(const pixel_rectangle *box, const sampled_edges *edges,
                                            const sampled_edges *others, int32_t y, uint32_t lane,
                                            sample_queue *queue)
{
    for (int32_t x = square_start(box->min_x); x <= box->max_x; x += SQUARE_SIZE) {
        const uint32_t inside = square_mask(box, x, y);
        uint32_t coverage[GN_SAMPLES];

        sample_masks_between(edges, others, x, y, inside, coverage);
        add_sampled_square(queue, lane, x, y, coverage);
    }
}

/* Covers the part of a box that is inside all of six edges. */
static inline void cover_samples_between(const pixel_rectangle *box, const sampled_edges *edges,
                                         const sampled_edges *others, uint32_t lane,
                                         sample_queue *queue)
{
    for (int32_t y = square_start(box->min_y); y <= box->max_y; y += SQUARE_SIZE)
        cover_sample_row_between(box, edges, others, y, lane, queue);
}

/* Covers a line between two vertices: what lies right of its first three edges and of its last
 * three. `box` holds all pixels that the line may have. */
static inline void cover_line_samples(const box_state *state, const stored_vertex *first,
                                      const stored_vertex *second, const pixel_rectangle *box,
                                      uint32_t lane, sample_queue *queue)
{
    int32_t corner[4][2];
    sampled_edges edges, others;

    if (!line_corners(state, first, second, corner))
        return;
    edges.upside_down = others.upside_down = state->upside_down;
    for (int i = 0; i < 4; ++i) {
        const int32_t *const from = corner[i];
        const int32_t *const to = corner[(i + 1) % 4];
        const int32_t per_x = from[1] - to[1];
        const int32_t per_y = from[0] - to[0];

        if (i < 3)
            set_sampled_edge(&edges, i, per_x, per_y, from[0], from[1]);
        if (i > 0)
            set_sampled_edge(&others, i - 1, per_x, per_y, from[0], from[1]);
    }
    cover_samples_between(box, &edges, &others, lane, queue);
}

/* Returns the pixels of the square at (x, y) inside a rectangle, which need not reach into the
 * square. */
static inline uint32_t rectangle_mask(const pixel_rectangle *r, int32_t x, int32_t y)
{
    if (r->min_x > x + (SQUARE_SIZE - 1) || r->max_x < x || r->min_y > y + (SQUARE_SIZE - 1) ||
        r->max_y < y)
        return 0;
    return square_mask(r, x, y);
}

/* Covers the part of a box in which each sample has a rectangle of its own. */
static inline void cover_box_samples(const pixel_rectangle *box,
                                     const pixel_rectangle covered[GN_SAMPLES], uint32_t lane,
                                     sample_queue *queue)
{
    for (int32_t y = square_start(box->min_y); y <= box->max_y; y += SQUARE_SIZE) {
        for (int32_t x = square_start(box->min_x); x <= box->max_x; x += SQUARE_SIZE) {
            uint32_t coverage[GN_SAMPLES];

            for (uint32_t s = 0; s < GN_SAMPLES; ++s)
                coverage[s] = rectangle_mask(&covered[s], x, y);
            add_sampled_square(queue, lane, x, y, coverage);
        }
    }
}

/* Covers the point of a vertex. `box` holds all pixels that the point may have. */
static inline void cover_point_samples(const box_state *state, const stored_vertex *v,
                                       const pixel_rectangle *box, uint32_t lane,
                                       sample_queue *queue)
{
    pixel_rectangle covered[GN_SAMPLES];
    int32_t low[2], high[2];

    if (!point_range(state, v, low, high))
        return;
    for (uint32_t s = 0; s < GN_SAMPLES; ++s) {
        int32_t from[2], to[2];

        for (int c = 0; c < 2; ++c) {
            from[c] = low[c] - sample_offset(s, c);
            to[c] = high[c] - sample_offset(s, c);
        }
        if (!pixels_of_box(box, from, to, state->upside_down, &covered[s]))
            covered[s].max_y = covered[s].min_y - SQUARE_SIZE;
    }
    cover_box_samples(box, covered, lane, queue);
}

#endif
