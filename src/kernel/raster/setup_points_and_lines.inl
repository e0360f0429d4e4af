/* Set-up of points and lines, sixteen at a time: a line's two long edges, and the planes of depth,
 * 1/w and the varyings. */
#ifndef GN_KERNEL_RASTER_SETUP_POINTS_AND_LINES_INL
#define GN_KERNEL_RASTER_SETUP_POINTS_AND_LINES_INL

#include "setup.inl"

/* Gathers the values of a plane's attribute at one vertex of each primitive: depth, 1/w or a
 * varying. Smooth varyings are divided by w. */
static inline void gather_values(const gn_pipeline *pipeline, const unsigned char *memory,
                                 const uint32_t vertex[LANES], uint32_t plane, float value[LANES])
{
    const uint32_t n = plane - VARYING_PLANES;

    GN_EACH_LANE (l) {
        const stored_vertex *v = (const stored_vertex *)(const void *)(memory + vertex[l]);

        value[l] = plane == DEPTH_PLANE                              ? v->window[2]
                   : plane == ONE_OVER_W_PLANE                       ? v->window[3]
                   : pipeline->program.interpolation[n] == GN_SMOOTH ? v->varying[n] * v->window[3]
                                                                     : v->varying[n];
    }
}

static inline bool is_flat(const gn_pipeline *pipeline, uint32_t plane)
{
    return plane >= VARYING_PLANES &&
           pipeline->program.interpolation[plane - VARYING_PLANES] == GN_FLAT;
}

/* Sets the words from which locate_in_point computes gl_PointCoord, by planes evaluated at the
 * numbers of pixels; on a multisampled target, at places measured from the corners of pixels. */
static inline void setup_point_words(const box_state *state, const gn_pipeline *pipeline,
                                     const unsigned char *memory, const primitive_list *list,
                                     primitive_setup *setup)
{
    const float up = pipeline->raster.point_origin == GN_POINT_LOWER_LEFT ? 1.0f : -1.0f;
    const float center = is_multisampled(state) ? 0.0f : 0.5f;

    GN_EACH_LANE (l) {
        const stored_vertex *v = (const stored_vertex *)(const void *)(memory + list->vertex[0][l]);
        const float w = v->window[3];
        const float per_pixel = 256.0f / (float)size_of_point(state, v);

        setup->corner.point[POINT_PER_PIXEL][l] = per_pixel * w;
        setup->corner.point[POINT_ORIGIN_S][l] = (0.5f - per_pixel * (v->window[0] - center)) * w;
        setup->corner.point[POINT_ORIGIN_T][l] =
            (0.5f - up * per_pixel * (v->window[1] - center)) * w;
    }
}

/* Sets up the points of a list. Precondition: all lanes are filled (fill_list). */
static inline void setup_points(const box_state *state, const gn_pipeline *pipeline,
                                const unsigned char *memory, const primitive_list *list,
                                primitive_setup *setup)
{
    float value[LANES];

    setup_point_words(state, pipeline, memory, list, setup);
    for (uint32_t n = 0; n < VARYING_PLANES + pipeline->program.varying_count; ++n) {
        const uint32_t *const vertex = is_flat(pipeline, n) ? list->provoking : list->vertex[0];

        gather_values(pipeline, memory, vertex, n, value);
        lanes_store(setup->plane[n][PLANE_ORIGIN], lanes_load(value));
        lanes_store(setup->plane[n][PLANE_PER_X], lanes_splat(0.0f));
        lanes_store(setup->plane[n][PLANE_PER_Y], lanes_splat(0.0f));
    }
}

/* Sets edge `edge` of the line in a lane: from point a to b, moved across by `shift`. */
static inline void set_line_edge(primitive_setup *setup, int edge, uint32_t lane, int minor,
                                 const int32_t a[2], const int32_t b[2], int32_t shift)
{
    setup->edge[edge].per_x[lane] = a[1] - b[1];
    setup->edge[edge].per_y[lane] = a[0] - b[0];
    setup->corner.snapped[edge][!minor][lane] = a[!minor];
    setup->corner.snapped[edge][minor][lane] = a[minor] + shift;
}

/* Sets the two long edges of each line, with inside to their right. The second edge is set twice,
 * since coverage takes three. */
static inline void setup_line_edges(const box_state *state, const unsigned char *memory,
                                    const primitive_list *list, primitive_setup *setup)
{
    for (uint32_t l = 0; l < list->count; ++l) {
        const stored_vertex *const first =
            (const stored_vertex *)(const void *)(memory + list->vertex[0][l]);
        const stored_vertex *const second =
            (const stored_vertex *)(const void *)(memory + list->vertex[1][l]);
        line_middle m;

        middle_of_line(state, first, second, &m);
        /* For a line along x the lower edge goes left and the upper one right; for one along y the
         * left edge goes up and the right one down. */
        const int32_t *const low = m.end[0];
        const int32_t *const high = m.end[1];
        const bool level = m.major == 0;
        const int minor = level ? 1 : 0;
        set_line_edge(setup, 0, l, minor, level ? high : low, level ? low : high,
                      -state->half_width);
        for (int i = 1; i < 3; ++i)
            set_line_edge(setup, i, l, minor, level ? low : high, level ? high : low,
                          state->half_width);
    }
}

/* Differences of a line's ends in window coordinates. */
typedef struct line_basis {
    bool is_sampled; /* multisampled: values change along the line, in both directions */
    lanes_f d[2];
    lanes_f x0, y0; /* the first end, measured from the pixel's centre, on all targets */
    lanes_f extent, one_over_square;
    lanes_m x_major;
} line_basis;

static inline void set_line_basis(const box_state *state, const unsigned char *memory,
                                  const primitive_list *list, line_basis *b)
{
    const lanes_f one = lanes_splat(1.0f);
    const lanes_f *const d = b->d;
    lanes_i row[2][4];

    for (int i = 0; i < 2; ++i)
        lanes_i_gather_rows(memory + VERTEX_WINDOW, list->vertex[i], 1, row[i]);
    for (int c = 0; c < 2; ++c)
        b->d[c] = lanes_sub(lanes_as_float(row[0][c]), lanes_as_float(row[1][c]));
    b->is_sampled = is_multisampled(state);
    b->x0 = lanes_sub(lanes_as_float(row[0][0]), lanes_splat(0.5f));
    b->y0 = lanes_sub(lanes_as_float(row[0][1]), lanes_splat(0.5f));
    b->x_major = lanes_not(lanes_greater(lanes_magnitude(d[1]), lanes_magnitude(d[0])));

    const lanes_f along = lanes_select(b->x_major, d[0], d[1]);
    const lanes_f slope = lanes_div(lanes_select(b->x_major, d[1], d[0]), along);
    b->extent = lanes_mul(along, lanes_add(one, lanes_mul(slope, slope)));
    b->one_over_square = lanes_div(one, lanes_add(lanes_mul(d[0], d[0]), lanes_mul(d[1], d[1])));
}

/* Makes the plane of depth, 1/w or a varying. Without samples, values change along the major axis
 * alone: the slope along the other axis is 0, or NaN if the ends' values differ by infinity. On a
 * multisampled target they change along the line. */
static inline void make_line_plane(const line_basis *b, lanes_f a0, lanes_f a1,
                                   float plane[PLANE_TERMS][LANES])
{
    const lanes_f da = lanes_sub(a0, a1);
    const lanes_f per = lanes_mul(lanes_mul(da, b->extent), b->one_over_square);
    const lanes_f none = lanes_mul(lanes_mul(da, lanes_splat(0.0f)), b->one_over_square);
    lanes_f per_x = lanes_select(b->x_major, per, none);
    lanes_f per_y = lanes_select(b->x_major, none, per);

    if (b->is_sampled) {
        per_x = lanes_mul(lanes_mul(da, b->d[0]), b->one_over_square);
        per_y = lanes_mul(lanes_mul(da, b->d[1]), b->one_over_square);
    }
    const lanes_f at_zero = lanes_add(lanes_mul(per_x, b->x0), lanes_mul(per_y, b->y0));

    lanes_store(plane[PLANE_ORIGIN], lanes_sub(a0, at_zero));
    lanes_store(plane[PLANE_PER_X], per_x);
    lanes_store(plane[PLANE_PER_Y], per_y);
}

/* Sets up the lines of a list. Precondition: all lanes are filled (fill_list). */
static inline void setup_lines(const box_state *state, const gn_pipeline *pipeline,
                               const unsigned char *memory, const primitive_list *list,
                               primitive_setup *setup)
{
    float first[LANES], second[LANES];
    line_basis basis;

    if (!is_multisampled(state))
        setup_line_edges(state, memory, list, setup);
    set_line_basis(state, memory, list, &basis);
    for (uint32_t n = 0; n < VARYING_PLANES + pipeline->program.varying_count; ++n) {
        if (is_flat(pipeline, n)) {
            make_flat_plane(memory, list, n - VARYING_PLANES, setup->plane[n]);
            continue;
        }
        gather_values(pipeline, memory, list->vertex[0], n, first);
        gather_values(pipeline, memory, list->vertex[1], n, second);
        make_line_plane(&basis, lanes_load(first), lanes_load(second), setup->plane[n]);
    }
}

#endif
