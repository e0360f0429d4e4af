/* Culling, sixteen triangles at a time: finds the winding and the bounds in pixels, and drops what
 * cannot be seen before anything else is computed. Culling uses snapped coordinates in integers,
 * which is exact. */
#ifndef GN_KERNEL_RASTER_CULL_INL
#define GN_KERNEL_RASTER_CULL_INL

#include "../../lanes/lanes.h"
#include "points_and_lines.inl"
#include "scissor.h"

/* The state of a draw that culling needs. */
typedef struct cull_state {
    pixel_rectangle region; /* where is drawn: the scissored target, or a band of it */
    bool drop_clockwise, drop_counter_clockwise;
    bool front_clockwise;
    bool provoking_first;
    bool culls_unsnapped; /* the reference culls a second time (cull_unsnapped) */
    bool is_unfilled;     /* triangles of some winding are drawn as lines or points */
    gn_polygon_mode mode_clockwise, mode_counter_clockwise;
    box_state box;
} cull_state;

/* Sixteen triangles after culling, one bit each: those to draw; those of them that are clockwise;
 * and those that cross the boundary of the view volume. A crossing triangle is still to be clipped,
 * and nothing else is known of it. */
typedef struct cull_result {
    uint32_t drawn, clockwise, crossing;
    int32_t bounds[BOUNDS_COUNT][LANES];
} cull_result;

static inline cull_state cull_state_of(const gn_pipeline *p, uint32_t width, uint32_t height)
{
    const bool front_clockwise = p->raster.front_face == GN_FRONT_CLOCKWISE;
    const bool drop_back =
        p->raster.cull == GN_CULL_BACK || p->raster.cull == GN_CULL_FRONT_AND_BACK;
    const bool drop_front =
        p->raster.cull == GN_CULL_FRONT || p->raster.cull == GN_CULL_FRONT_AND_BACK;
    cull_state s;

    s.region = scissored_target(&p->raster.scissor, width, height);
    s.front_clockwise = front_clockwise;
    s.drop_clockwise = front_clockwise ? drop_front : drop_back;
    s.drop_counter_clockwise = front_clockwise ? drop_back : drop_front;
    s.provoking_first = p->raster.provoking_vertex == GN_PROVOKING_FIRST;
    s.culls_unsnapped = false;
    s.box = box_state_of(p);
    s.is_unfilled = false;
    s.mode_clockwise = s.mode_counter_clockwise = GN_POLYGON_FILL;
    if (DRAWS_LINES) {
        /* A culled face takes the mode of the other face, which shows in triangles without area. */
        const gn_polygon_mode front =
            drop_front ? p->raster.polygon_mode_back : p->raster.polygon_mode_front;
        const gn_polygon_mode back =
            drop_back ? p->raster.polygon_mode_front : p->raster.polygon_mode_back;

        s.is_unfilled = kind_of(p->raster.topology) == KIND_TRIANGLE &&
                        (front != GN_POLYGON_FILL || back != GN_POLYGON_FILL);
        s.mode_clockwise = front_clockwise ? front : back;
        s.mode_counter_clockwise = front_clockwise ? back : front;
    }
    return s;
}

/* Gathers a row of four words of one corner of sixteen triangles, as structure of arrays. */
static inline void gather_corner(const unsigned char *memory, const triangle_group *group,
                                 int corner, uint32_t row, lanes_i out[4])
{
    if (group->stride == 3)
        lanes_i_gather_rows(memory + row, group->corner[corner], 3, out);
    else
        lanes_i_gather_rows(memory + row, group->corner[corner], 1, out);
}

/* Returns numbers with the signs of the areas, which are positive for clockwise triangles. They are
 * exact: computed in 32 bits where extents are small, in 64 where `large` has the lane's bit. */
GN_FRAMED lanes_i area_signs(const lanes_i x[3], const lanes_i y[3], uint32_t large)
{
    const lanes_i area = lanes_i_sub(lanes_i_mul(lanes_i_sub(x[0], x[1]), lanes_i_sub(y[2], y[0])),
                                     lanes_i_mul(lanes_i_sub(x[2], x[0]), lanes_i_sub(y[0], y[1])));
    int32_t sign[LANES], px[3][LANES], py[3][LANES];

    if (!large)
        return area;
    lanes_i_store(sign, area);
    for (int i = 0; i < 3; ++i) {
        lanes_i_store(px[i], x[i]);
        lanes_i_store(py[i], y[i]);
    }
    GN_EACH_LANE (l) {
        if (large >> l & 1u) {
            const int64_t exact = ((int64_t)px[0][l] - px[1][l]) * ((int64_t)py[2][l] - py[0][l]) -
                                  ((int64_t)px[2][l] - px[0][l]) * ((int64_t)py[0][l] - py[1][l]);
            sign[l] = (exact > 0) - (exact < 0);
        }
    }
    return lanes_i_load(sign);
}

/* Returns the bits of triangles that stay when the reference culls a second time, by the area of
 * unsnapped window coordinates. The reference does so in segments with vertices outside the view
 * volume; the two areas disagree on slivers. A triangle without area is back-facing. */
GN_OUT_OF_LINE uint32_t cull_unsnapped(const cull_state *state, const unsigned char *memory,
                                       const triangle_group *group)
{
    lanes_f x[3], y[3];

    for (int i = 0; i < 3; ++i) {
        lanes_i row[4];
        gather_corner(memory, group, i, VERTEX_WINDOW, row);
        x[i] = lanes_as_float(row[0]);
        y[i] = lanes_as_float(row[1]);
    }
    const lanes_f area = lanes_sub(lanes_mul(lanes_sub(x[0], x[2]), lanes_sub(y[1], y[2])),
                                   lanes_mul(lanes_sub(y[0], y[2]), lanes_sub(x[1], x[2])));
    const uint32_t none =
        lanes_bits(lanes_i_equal(lanes_as_int(lanes_magnitude(area)), lanes_i_splat(0)));
    const uint32_t negative = lanes_bits(lanes_greater(lanes_splat(0.0f), area));
    const uint32_t clockwise = state->front_clockwise ? negative : negative | none;

    return (state->drop_clockwise ? 0 : clockwise) |
           (state->drop_counter_clockwise ? 0 : ~clockwise);
}

static inline lanes_i least_of(const lanes_i a[3])
{
    return lanes_i_min(lanes_i_min(a[0], a[1]), a[2]);
}

static inline lanes_i greatest_of(const lanes_i a[3])
{
    return lanes_i_max(lanes_i_max(a[0], a[1]), a[2]);
}

/* Finds the pixels in the region whose centre (256 * p in snapped coordinates), or anything up to
 * `reach` around it, lies between the extremes. Returns the bits of triangles that have any. */
GN_FRAMED uint32_t find_bounds(const pixel_rectangle *region, int32_t reach, lanes_i min_x,
                               lanes_i min_y, lanes_i max_x, lanes_i max_y,
                               int32_t bounds[BOUNDS_COUNT][LANES])
{
    const lanes_i up = lanes_i_splat(255 - reach);
    const lanes_i beyond = lanes_i_splat(reach);

    min_x = lanes_i_shift_right(lanes_i_add(min_x, up), 8);
    min_y = lanes_i_shift_right(lanes_i_add(min_y, up), 8);
    max_x = lanes_i_shift_right(lanes_i_add(max_x, beyond), 8);
    max_y = lanes_i_shift_right(lanes_i_add(max_y, beyond), 8);
    min_x = lanes_i_max(min_x, lanes_i_splat(region->min_x));
    min_y = lanes_i_max(min_y, lanes_i_splat(region->min_y));
    max_x = lanes_i_min(max_x, lanes_i_splat(region->max_x));
    max_y = lanes_i_min(max_y, lanes_i_splat(region->max_y));
    lanes_i_store(bounds[BOUNDS_MIN_X], min_x);
    lanes_i_store(bounds[BOUNDS_MIN_Y], min_y);
    lanes_i_store(bounds[BOUNDS_MAX_X], max_x);
    lanes_i_store(bounds[BOUNDS_MAX_Y], max_y);
    return ~lanes_bits(lanes_i_greater(min_x, max_x)) & ~lanes_bits(lanes_i_greater(min_y, max_y));
}

/* Culls a group. `culls_unsnapped` is not the state's for the pieces of unfilled triangles, which
 * are culled by their unsnapped areas alone. */
GN_FRAMED void cull_triangles(const cull_state *state, bool culls_unsnapped,
                              const unsigned char *memory, const triangle_group *group,
                              cull_result *result)
{
    const uint32_t lanes = GN_ALL_LANES >> (LANES - group->count);
    lanes_i word[3][VERTEX_WORDS], x[3], y[3], outcode[3];

    GN_UNROLLED
    for (int i = 0; i < 3; ++i) {
        gather_corner(memory, group, i, VERTEX_SNAPPED, word[i]);
        x[i] = word[i][SNAPPED_X];
        y[i] = word[i][SNAPPED_Y];
        outcode[i] = word[i][SNAPPED_OUTCODE];
    }
    const lanes_i zero = lanes_i_splat(0);
    const lanes_i all_out = lanes_i_and(lanes_i_and(outcode[0], outcode[1]), outcode[2]);
    const lanes_i any_out = lanes_i_or(lanes_i_or(outcode[0], outcode[1]), outcode[2]);
    const uint32_t visible = lanes & lanes_bits(lanes_i_equal(all_out, zero));
    const uint32_t inside = lanes_bits(lanes_i_equal(any_out, zero));

    result->crossing = visible & ~inside;

    const lanes_i min_x = least_of(x);
    const lanes_i min_y = least_of(y);
    const lanes_i max_x = greatest_of(x);
    const lanes_i max_y = greatest_of(y);
    const lanes_i limit = lanes_i_splat(SNAPPED_LIMIT);
    const lanes_i least = lanes_i_min(min_x, min_y);
    const lanes_i greatest = lanes_i_max(max_x, max_y);
    const uint32_t beyond = lanes_bits(lanes_i_greater(greatest, limit)) |
                            lanes_bits(lanes_i_greater(lanes_i_splat(-SNAPPED_LIMIT), least));
    const lanes_i extent = lanes_i_max(lanes_i_sub(max_x, min_x), lanes_i_sub(max_y, min_y));
    const uint32_t large = lanes_bits(lanes_i_greater(extent, lanes_i_splat(SMALL_EXTENT - 1)));
    uint32_t drawn = visible & inside & ~beyond;
    const lanes_i area = area_signs(x, y, large & drawn);

    result->clockwise = lanes_bits(lanes_i_greater(area, zero));
    drawn &= ~lanes_bits(lanes_i_equal(area, zero));
    if (state->drop_clockwise)
        drawn &= ~result->clockwise;
    if (state->drop_counter_clockwise)
        drawn &= result->clockwise;
    if (drawn)
        drawn &= find_bounds(&state->region, DRAWS_SAMPLES ? state->box.reach : 0, min_x, min_y,
                             max_x, max_y, result->bounds);
    if (culls_unsnapped && drawn)
        drawn &= cull_unsnapped(state, memory, group);
    result->drawn = drawn;
}

#endif
