/* One block of fragments: depth, varyings, shader, colour. */
#include "fragment.h"

fragment_state gn_fragment_state(const gn_target *target, const gn_pipeline *pipeline)
{
    fragment_state s;

    s.pipeline = pipeline;
    s.target = target;
    s.depth = gn_depth_state(target, pipeline);
    return s;
}

/* per_y * y + (per_x * x + origin), in this order. */
static lanes_f interpolate(const attribute_plane *plane, lanes_f x, lanes_f y)
{
    const lanes_f column =
        lanes_add(lanes_mul(lanes_splat(plane->per_x), x), lanes_splat(plane->origin));

    return lanes_add(lanes_mul(lanes_splat(plane->per_y), y), column);
}

static void interpolate_varyings(const gn_pipeline *pipeline, const raster_triangle *triangle,
                                 lanes_f x, lanes_f y, float (*varying)[GN_LANES])
{
    const lanes_f w = lanes_div(lanes_splat(1.0f), interpolate(&triangle->one_over_w, x, y));

    for (uint32_t n = 0; n < pipeline->varying_count; ++n) {
        const attribute_plane *plane = &triangle->varying[n];

        switch (pipeline->interpolation[n]) {
        case GN_FLAT:
            lanes_store(varying[n], lanes_splat(plane->origin));
            break;
        case GN_NOPERSPECTIVE:
            lanes_store(varying[n], interpolate(plane, x, y));
            break;
        default:
            lanes_store(varying[n], lanes_mul(interpolate(plane, x, y), w));
            break;
        }
    }
}

void gn_shade_block(void *context, const raster_triangle *triangle, int32_t x, int32_t y,
                    uint32_t coverage)
{
    const fragment_state *state = context;
    const gn_pipeline *pipeline = state->pipeline;
    static const int32_t columns[GN_LANES] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
    static const int32_t rows[GN_LANES] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
    const lanes_f pixel_x = lanes_to_float(lanes_i_add(lanes_i_splat(x), lanes_i_load(columns)));
    const lanes_f pixel_y = lanes_to_float(lanes_i_add(lanes_i_splat(y), lanes_i_load(rows)));

    if (state->depth.enabled) {
        coverage = gn_test_depth(&state->depth, &state->target->depth, x, y, coverage,
                                 interpolate(&triangle->depth, pixel_x, pixel_y));
        if (!coverage)
            return;
    }
    if (state->target->color.format == GN_FORMAT_NONE)
        return;

    float varying[GN_MAX_VARYINGS][GN_LANES];
    float color[4][GN_LANES];
    gn_fragment_input input;
    gn_fragment_output output;

    interpolate_varyings(pipeline, triangle, pixel_x, pixel_y, varying);
    input.varying = (const float(*)[GN_LANES])varying;
    input.coverage = coverage;
    input.x = x;
    input.y = y;
    output.color = color;
    pipeline->fragment_shader(pipeline->uniforms, &input, &output);
    gn_write_color(&state->target->color, x, y, coverage, color);
}
