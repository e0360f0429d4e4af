/* Triangle set-up, sixteen at a time: edge functions with the tie rule folded in, and the planes of
 * depth, 1/w and the varyings. Coverage is decided on snapped coordinates in integers, which is
 * exact; attributes use the unsnapped ones (OpenGL 4.5 section 14.6.1; Pineda 1988 for edge
 * functions). */
#ifndef GN_KERNEL_RASTER_SETUP_INL
#define GN_KERNEL_RASTER_SETUP_INL

#include "cull.inl"
#include "offset.inl"

/* Finds the pixel at which a triangle's squares begin. Squares of one pixel begin at the bounds.
 * Larger ones begin at the even coordinates at or below the bounds, so that they consist of whole
 * quads. If the highest square would then leave the band, rows begin at a multiple of four instead:
 * the rows above may be another thread's, and a band ends at a multiple of four or with the
 * target. */
GN_FRAMED void place_squares(const pixel_rectangle *region, const primitive_list *list,
                             lanes_i origin[2])
{
    const lanes_i min_y = lanes_i_load(list->bounds[BOUNDS_MIN_Y]);
    const lanes_i max_y = lanes_i_load(list->bounds[BOUNDS_MAX_Y]);
    const lanes_i to_square = lanes_i_splat(~(SQUARE_SIZE - 1));
    const lanes_i to_quad = lanes_i_splat(~1);
    const lanes_i even = lanes_i_and(min_y, to_quad);
    const lanes_i highest = lanes_i_add(even, lanes_i_and(lanes_i_sub(max_y, even), to_square));
    const lanes_m leaves =
        lanes_i_greater(highest, lanes_i_splat(region->max_y - (SQUARE_SIZE - 1)));

    origin[0] = lanes_i_load(list->bounds[BOUNDS_MIN_X]);
    origin[1] = min_y;
    if (SQUARE_SIZE > 1) {
        origin[0] = lanes_i_and(origin[0], to_quad);
        origin[1] = lanes_i_select(leaves, lanes_i_and(min_y, to_square), even);
    }
}

/* Sets up the edge functions. A pixel is inside where C - 256*per_x*px + 256*per_y*py > 0; edges
 * that own their ties have 1 added to C. C + 256*k > 0 is floor((C - 1) / 256) + k >= 0. */
static inline void setup_edges(const pixel_rectangle *region, const unsigned char *memory,
                               const primitive_list *list, primitive_setup *setup)
{
    const lanes_i zero = lanes_i_splat(0);
    lanes_i x[3], y[3], origin[2];

    GN_UNROLLED
    for (int i = 0; i < 3; ++i) {
        lanes_i word[VERTEX_WORDS];
        lanes_i_gather_rows(memory + VERTEX_SNAPPED, list->vertex[i], 1, word);
        x[i] = word[SNAPPED_X];
        y[i] = word[SNAPPED_Y];
        lanes_i_store(setup->corner.snapped[i][0], x[i]);
        lanes_i_store(setup->corner.snapped[i][1], y[i]);
    }
    const lanes_i extent = lanes_i_max(lanes_i_sub(greatest_of(x), least_of(x)),
                                       lanes_i_sub(greatest_of(y), least_of(y)));
    setup->large = lanes_bits(lanes_i_greater(extent, lanes_i_splat(SMALL_EXTENT - 1)));
    setup->unpacked = lanes_bits(lanes_i_greater(extent, lanes_i_splat(PACKED_EXTENT - 1)));
    place_squares(region, list, origin);
    lanes_i_store(setup->origin[0], origin[0]);
    lanes_i_store(setup->origin[1], origin[1]);

    const lanes_i left = lanes_i_shift_left(origin[0], 8);
    const lanes_i bottom = lanes_i_shift_left(origin[1], 8);
    GN_UNROLLED
    for (int i = 0; i < 3; ++i) {
        const int j = i == 2 ? 0 : i + 1;
        const lanes_i per_x = lanes_i_sub(y[i], y[j]);
        const lanes_i per_y = lanes_i_sub(x[i], x[j]);
        const lanes_m lower =
            setup->upside_down ? lanes_i_greater(zero, per_y) : lanes_i_greater(per_y, zero);
        const lanes_m horizontal = lanes_and(lanes_i_equal(per_x, zero), lower);
        const lanes_i own = /* as owns_ties */
            lanes_i_or(lanes_m_as_int(lanes_i_greater(zero, per_x)), lanes_m_as_int(horizontal));
        const lanes_i c = lanes_i_sub(lanes_i_mul(per_x, lanes_i_sub(x[i], left)),
                                      lanes_i_mul(per_y, lanes_i_sub(y[i], bottom)));

        /* The mask is -1 where ties are owned: C - 1 is c - 1 - mask. */
        lanes_i_store(setup->edge[i].start,
                      lanes_i_shift_right(lanes_i_sub(lanes_i_add(c, lanes_i_splat(-1)), own), 8));
        lanes_i_store(setup->edge[i].per_x, per_x);
        lanes_i_store(setup->edge[i].per_y, per_y);
    }
}

/* Window differences of the vertices, divided by the triangle's area. */
typedef struct plane_basis {
    lanes_f x0, y0; /* vertex 0, less `center` of set_basis */
    lanes_f dx01, dy01, dx20, dy20;
} plane_basis;

static inline void set_basis(plane_basis *b, const lanes_f x[3], const lanes_f y[3], float center)
{
    const lanes_f inside_pixel = lanes_splat(center);
    const lanes_f dx01 = lanes_sub(x[0], x[1]);
    const lanes_f dy01 = lanes_sub(y[0], y[1]);
    const lanes_f dx20 = lanes_sub(x[2], x[0]);
    const lanes_f dy20 = lanes_sub(y[2], y[0]);
    const lanes_f one_over_area =
        lanes_div(lanes_splat(1.0f), lanes_sub(lanes_mul(dx01, dy20), lanes_mul(dx20, dy01)));

    b->x0 = lanes_sub(x[0], inside_pixel);
    b->y0 = lanes_sub(y[0], inside_pixel);
    b->dx01 = lanes_mul(dx01, one_over_area);
    b->dy01 = lanes_mul(dy01, one_over_area);
    b->dx20 = lanes_mul(dx20, one_over_area);
    b->dy20 = lanes_mul(dy20, one_over_area);
}

static inline void make_plane(const plane_basis *b, const lanes_f a[3],
                              float plane[PLANE_TERMS][LANES])
{
    const lanes_f da01 = lanes_sub(a[0], a[1]);
    const lanes_f da20 = lanes_sub(a[2], a[0]);
    const lanes_f per_x = lanes_sub(lanes_mul(da01, b->dy20), lanes_mul(da20, b->dy01));
    const lanes_f per_y = lanes_sub(lanes_mul(da20, b->dx01), lanes_mul(da01, b->dx20));
    const lanes_f at_zero = lanes_add(lanes_mul(per_x, b->x0), lanes_mul(per_y, b->y0));

    lanes_store(plane[PLANE_ORIGIN], lanes_sub(a[0], at_zero));
    lanes_store(plane[PLANE_PER_X], per_x);
    lanes_store(plane[PLANE_PER_Y], per_y);
}

static inline void make_flat_plane(const unsigned char *memory, const primitive_list *list,
                                   uint32_t varying, float plane[PLANE_TERMS][LANES])
{
    GN_EACH_LANE (l) {
        const stored_vertex *v = (const stored_vertex *)(const void *)(memory + list->provoking[l]);

        plane[PLANE_ORIGIN][l] = v->varying[varying];
        plane[PLANE_PER_X][l] = 0.0f;
        plane[PLANE_PER_Y][l] = 0.0f;
    }
}

/* Sets up the planes of depth, 1/w and the varyings; a vertex has four varyings in a row. A plane
 * at (x, y) has the value at (x, y) + `center` of the window. */
static inline void setup_planes(const gn_pipeline *pipeline, const offset_state *offset,
                                float center, const unsigned char *memory,
                                const primitive_list *list, primitive_setup *setup)
{
    const unsigned char *const varyings = memory + VERTEX_VARYING;
    lanes_i row[3][4];
    lanes_f x[3], y[3], z[3], one_over_w[3];
    plane_basis basis;

    GN_UNROLLED
    for (int i = 0; i < 3; ++i) {
        lanes_i_gather_rows(memory + VERTEX_WINDOW, list->vertex[i], 1, row[i]);
        x[i] = lanes_as_float(row[i][0]);
        y[i] = lanes_as_float(row[i][1]);
        z[i] = lanes_as_float(row[i][2]);
        one_over_w[i] = lanes_as_float(row[i][3]);
    }
    set_basis(&basis, x, y, center);
    make_plane(&basis, z, setup->plane[DEPTH_PLANE]);
    /* Where vertices have moved instead, the offset is 0. */
    if (GN_HAVE_OFFSET && pipeline->raster.polygon_offset.enabled)
        lanes_store(setup->offset,
                    offset->moves ? offset_depths(offset, x, y, z) : lanes_splat(0.0f));
    make_plane(&basis, one_over_w, setup->plane[ONE_OVER_W_PLANE]);

    for (uint32_t n = 0; n < pipeline->program.varying_count; ++n) {
        float(*const plane)[LANES] = setup->plane[VARYING_PLANES + n];
        lanes_f a[3];

        if (n % 4 == 0) {
            GN_UNROLLED
            for (int i = 0; i < 3; ++i)
                lanes_i_gather_rows(varyings + n / 4 * VERTEX_ROW, list->vertex[i], 1, row[i]);
        }
        if (pipeline->program.interpolation[n] == GN_FLAT) {
            make_flat_plane(memory, list, n, plane);
            continue;
        }
        GN_UNROLLED
        for (int i = 0; i < 3; ++i) {
            a[i] = lanes_as_float(row[i][n % 4]);
            if (pipeline->program.interpolation[n] == GN_SMOOTH)
                a[i] = lanes_mul(a[i], one_over_w[i]);
        }
        make_plane(&basis, a, plane);
    }
}

/* Stores the numbers and flags of primitives of one kind. */
static inline void setup_identities(primitive_kind kind, const primitive_list *list,
                                    primitive_setup *setup)
{
    lanes_i_store(setup->primitive, lanes_i_load(list->primitive));
    lanes_i_store(setup->flags,
                  lanes_i_or(lanes_i_and(lanes_m_as_int(lanes_from_bits(list->back)),
                                         lanes_i_splat(PRIMITIVE_IS_BACK)),
                             lanes_i_splat(kind == KIND_POINT ? PRIMITIVE_IS_POINT : 0)));
}

/* Returns the values of a plane at one pixel of each lane's triangle, computed as for fragments. */
static inline lanes_f plane_at_pixels(float plane[PLANE_TERMS][LANES], lanes_f x, lanes_f y)
{
    return lanes_add(
        lanes_mul(lanes_load(plane[PLANE_PER_Y]), y),
        lanes_add(lanes_mul(lanes_load(plane[PLANE_PER_X]), x), lanes_load(plane[PLANE_ORIGIN])));
}

/* Returns the pixels of the bounds, along an axis, at which a plane's values are least (or with
 * `greatest`, greatest): the first ones where the plane rises. */
static inline lanes_f extreme_pixels(lanes_f per_pixel, const int32_t first[LANES],
                                     const int32_t last[LANES], bool greatest)
{
    const lanes_m rises = lanes_greater(per_pixel, lanes_splat(0.0f));
    const int32_t *const if_rises = greatest ? last : first;
    const int32_t *const otherwise = greatest ? first : last;

    return lanes_to_float(lanes_i_select(rises, lanes_i_load(if_rises), lanes_i_load(otherwise)));
}

/* Returns the lanes in which a plane's values at all pixels of the bounds are above low and at most
 * high. Every rounded operation is monotonic, so the extremes lie at two corners of the bounds. If
 * a slope is infinite or NaN, so is the value at a corner. */
static inline lanes_m plane_lies_between(const primitive_list *list,
                                         float plane[PLANE_TERMS][LANES], float low, float high)
{
    lanes_f value[2];

    GN_UNROLLED
    for (int greatest = 0; greatest < 2; ++greatest) {
        const lanes_f x = extreme_pixels(lanes_load(plane[PLANE_PER_X]), list->bounds[BOUNDS_MIN_X],
                                         list->bounds[BOUNDS_MAX_X], greatest);
        const lanes_f y = extreme_pixels(lanes_load(plane[PLANE_PER_Y]), list->bounds[BOUNDS_MIN_Y],
                                         list->bounds[BOUNDS_MAX_Y], greatest);

        value[greatest] = plane_at_pixels(plane, x, y);
    }
    return lanes_and(lanes_greater(value[0], lanes_splat(low)),
                     lanes_less_equal(value[1], lanes_splat(high)));
}

/* Finds the opaque triangles. Their depths are above 0 and at most 1, so they need no clamping.
 * Their fourth varying is within 2^-22 of 1, like the alpha of opaque colours: its plane equals the
 * plane of 1/w, and it is multiplied by the reciprocal of 1/w, if both are in the range of normal
 * floats. */
GN_FRAMED void setup_opaque(const gn_pipeline *pipeline, const primitive_list *list,
                            primitive_setup *setup)
{
    const float tiny = 1.0f / ((float)(1 << 30) * (float)(1 << 30));
    float(*const one_over_w)[LANES] = setup->plane[ONE_OVER_W_PLANE];
    float(*const alpha)[LANES] = setup->plane[VARYING_PLANES + 3];
    lanes_m opaque = lanes_from_bits(0);

    if (pipeline->program.varying_count > 3 && pipeline->program.interpolation[3] == GN_SMOOTH) {
        opaque = lanes_from_bits(GN_ALL_LANES);
        GN_UNROLLED
        for (int term = 0; term < PLANE_TERMS; ++term)
            opaque = lanes_and(opaque, lanes_i_equal(lanes_as_int(lanes_load(one_over_w[term])),
                                                     lanes_as_int(lanes_load(alpha[term]))));
        opaque = lanes_and(opaque, plane_lies_between(list, setup->plane[DEPTH_PLANE], 0.0f, 1.0f));
        opaque = lanes_and(opaque, plane_lies_between(list, one_over_w, tiny, 1.0f / tiny));
    }
    lanes_i_store(setup->opaque, lanes_m_as_int(opaque));
}

/* Sets up the triangles of a list. Precondition: all lanes are filled (fill_list). */
GN_SHARED void setup_triangles(const gn_pipeline *pipeline, const offset_state *offset,
                               float center, const pixel_rectangle *region,
                               const unsigned char *memory, const primitive_list *list,
                               primitive_setup *setup)
{
    setup_edges(region, memory, list, setup);
    setup_planes(pipeline, offset, center, memory, list, setup);
    setup_identities(KIND_TRIANGLE, list, setup);
    if (GN_HAVE_ROWS)
        setup_opaque(pipeline, list, setup);
}

#endif
