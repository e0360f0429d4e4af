/* Culling, set-up and edge functions of triangles, for all window coordinates (infinities and NaN
 * too) and all snapped coordinates within SNAPPED_LIMIT, which culling lets pass: no shift, sum,
 * product or negation of signed numbers overflows, and no access is out of bounds. Bounds are found
 * for all snapped coordinates. Left to the reader: area_signs multiplies in 64 bits only in lanes
 * within the limit, as cull_triangles asks; Eva does not follow a bit for each lane.
 * @options: -eva-precision 2
 * @reaches: cull_triangles area_signs cull_unsnapped find_bounds setup_edges place_squares
 * @reaches: setup_planes make_plane setup_opaque set_edge_through edge_values edge_mask values_at
 * @reaches: not_negative set_small_edge */
#include "eva.h"

#include "kernel/raster/cover_large.inl"
#include "kernel/raster/cover_packed.inl"
#include "kernel/raster/setup.inl"

#define VARYINGS 4
#define STRIDE 64
#define VERTICES 3

static union {
    float alignment;
    unsigned char bytes[VERTICES * STRIDE];
} memory;

static union {
    primitive_setup setup;
    unsigned char bytes[sizeof(primitive_setup) +
                        (VARYING_PLANES + VARYINGS) * sizeof(float[PLANE_TERMS][GN_LANES])];
} room;

static void any_vertices(void)
{
    for (uint32_t n = 0; n < VERTICES; ++n) {
        stored_vertex *const v = vertex_at(memory.bytes, n * STRIDE);

        for (int i = 0; i < 4; ++i) {
            v->window[i] = any_float;
            v->clip[i] = any_float;
            v->varying[i] = any_float;
        }
        v->snapped[0] = int32_from(-SNAPPED_LIMIT, SNAPPED_LIMIT);
        v->snapped[1] = int32_from(-SNAPPED_LIMIT, SNAPPED_LIMIT);
        v->outcode = any_uint32;
        v->point_size = any_float;
    }
}

int main(void)
{
    static gn_pipeline pipeline;
    static triangle_group group;
    static primitive_list list;
    static cull_result result;
    static cull_state state;
    static large_edge edge[3];
    static small_edges small;
    uint32_t used;
    corner_values c;

    any_vertices();
    state.region.min_x = int32_from(0, GN_MAX_SIZE);
    state.region.min_y = int32_from(0, GN_MAX_SIZE);
    state.region.max_x = int32_from(-1, GN_MAX_SIZE - 1);
    state.region.max_y = int32_from(-1, GN_MAX_SIZE - 1);
    state.drop_clockwise = any_bool;
    state.drop_counter_clockwise = any_bool;
    state.front_clockwise = any_bool;
    state.box.reach = any_bool ? 96 : 0;
    group.count = uint32_from(1, GN_LANES);
    group.stride = 1;
    for (int i = 0; i < 3; ++i) {
        group.corner[i] = group.made[i];
        for (int l = 0; l < GN_LANES; ++l)
            group.made[i][l] = (uint32_t)i * STRIDE;
    }
    used = find_bounds(&state.region, state.box.reach, lanes_i_splat(any_int32),
                       lanes_i_splat(any_int32), lanes_i_splat(any_int32), lanes_i_splat(any_int32),
                       result.bounds);
    cull_triangles(&state, any_bool, memory.bytes, &group, &result);

    list.count = uint32_from(1, GN_LANES);
    for (int l = 0; l < GN_LANES; ++l) {
        list.bounds[BOUNDS_MIN_X][l] = int32_from(0, GN_MAX_SIZE - 1);
        list.bounds[BOUNDS_MIN_Y][l] = int32_from(0, GN_MAX_SIZE - 1);
        list.bounds[BOUNDS_MAX_X][l] = int32_from(0, GN_MAX_SIZE - 1);
        list.bounds[BOUNDS_MAX_Y][l] = int32_from(0, GN_MAX_SIZE - 1);
        for (int i = 0; i < 3; ++i)
            list.vertex[i][l] = (uint32_t)i * STRIDE;
        list.provoking[l] = uint32_from(0, 2) * STRIDE;
    }
    pipeline.program.varying_count = VARYINGS;
    for (int i = 0; i < VARYINGS; ++i)
        pipeline.program.interpolation[i] = (gn_interpolation)uint32_from(0, 2);
    room.setup.upside_down = uint32_from(0, 1);
    setup_edges(&state.region, memory.bytes, &list, &room.setup);
    setup_planes(&pipeline, 0, any_bool ? 0.5f : 0.0f, memory.bytes, &list, &room.setup);
    setup_opaque(&pipeline, &list, &room.setup);

    for (int i = 0; i < 3; ++i) {
        const int32_t x = int32_from(-SNAPPED_LIMIT, SNAPPED_LIMIT);
        const int32_t y = int32_from(-SNAPPED_LIMIT, SNAPPED_LIMIT);

        set_edge_through(&edge[i], int32_from(-2 * SNAPPED_LIMIT, 2 * SNAPPED_LIMIT),
                         int32_from(-2 * SNAPPED_LIMIT, 2 * SNAPPED_LIMIT), x, y, any_bool);
    }
    c = values_at(edge, int32_from(-3, GN_MAX_SIZE), int32_from(-3, GN_MAX_SIZE));
    used = edge_mask(edge, c);

    for (int i = 0; i < 3; ++i) {
        room.setup.edge[i].start[0] = any_int32;
        room.setup.edge[i].per_x[0] = int32_from(-PACKED_EXTENT, PACKED_EXTENT);
        room.setup.edge[i].per_y[0] = int32_from(-PACKED_EXTENT, PACKED_EXTENT);
        set_small_edge(&small, &room.setup, i, 0);
    }
    used = lanes_met(&small, 0, small.pixel);
    used = count_lanes(any_uint32);
    //@ assert used <= 64;
    return 0;
}
