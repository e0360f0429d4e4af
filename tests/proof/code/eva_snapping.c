/* Snapping of points and their sizes, for all finite window coordinates, sizes and line widths: no
 * conversion of a float and no sum overflows. NaN is left out because Eva keeps it in the branch
 * that a comparison with NaN never takes.
 * @reaches: box_state_of snap_size round_to_even can_snap snap_end size_of_point point_range
 * @reaches: point_box
 * @reaches: pixels_of_box */
#include "eva.h"

#include "kernel/raster/points_and_lines.inl"

static void any_vertex(stored_vertex *v)
{
    for (int c = 0; c < 4; ++c) {
        v->window[c] = finite_float();
        v->clip[c] = finite_float();
    }
    v->snapped[0] = any_int32;
    v->snapped[1] = any_int32;
    v->outcode = any_uint32;
    v->point_size = finite_float();
}

int main(void)
{
    static gn_pipeline pipeline;
    const pixel_rectangle region = {int32_from(0, GN_MAX_SIZE), int32_from(0, GN_MAX_SIZE),
                                    int32_from(-1, GN_MAX_SIZE - 1),
                                    int32_from(-1, GN_MAX_SIZE - 1)};
    stored_vertex v[2];
    pixel_rectangle box;
    int32_t low[2], high[2];

    pipeline.raster.point_size = finite_float();
    pipeline.raster.line_width = finite_float();
    pipeline.raster.viewport.enabled = any_bool;
    pipeline.raster.viewport.height = finite_float();
    pipeline.program.vertex_writes_point_size = any_bool;
    pipeline.raster.topology = (gn_topology)uint32_from(0, 10);
    any_vertex(&v[0]);
    any_vertex(&v[1]);
    box_state state = box_state_of(&pipeline);
    state.reach = any_bool ? 96 : 0;

    point_range(&state, &v[0], low, high);
    point_box(&state, &region, &v[0], &box);
    return 0;
}
