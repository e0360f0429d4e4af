/* Inputs and outputs of fragment shaders: facing, primitive, position, samples; discard, depth,
 * samples. And counting of fragments. */
#include "generate_parts.h"

#include <math.h>

/* Stretches colours, so that the alpha that decides about discarding lies around the threshold, and
 * the blue that becomes depth is outside 0..1 now and then. */
static void stretch_colors(builder *b)
{
    random_source *r = &b->random;
    const float low = random_chance(r, 50) ? 0.0f : -0.5f;
    const float high = random_chance(r, 50) ? 1.0f : 1.5f;
    const bool equal = random_chance(r, 10);
    for (uint32_t i = 0; i < b->vertex_count; ++i)
        for (int c = 2; c < 4; ++c)
            b->vertices[i].color[c] = equal ? 0.5f : random_float(r, low, high);
    if (b->vertex_count > 0 && random_chance(r, 10))
        b->vertices[random_below(r, b->vertex_count)].color[2] = NAN;
}

/* Whether the draw has points alone. */
static bool draws_points(const gn_pipeline *p)
{
    return p->raster.topology == GN_POINTS || (p->raster.topology <= GN_TRIANGLE_FAN &&
                                               p->raster.polygon_mode_front == GN_POLYGON_POINT &&
                                               p->raster.polygon_mode_back == GN_POLYGON_POINT);
}

void random_inputs(builder *b)
{
    random_source *r = &b->random;
    b->shader = SCENE_INPUTS;
    b->color_components = 4;
    b->state.program.fragment_reads_position = random_chance(r, 50);
    b->state.program.fragment_reads_primitive = random_chance(r, 50);
    b->state.program.fragment_discards = random_chance(r, 50);
    b->state.program.fragment_writes_depth = random_chance(r, 40);
    b->state.program.fragment_reads_point_coordinate =
        draws_points(&b->state) && random_chance(r, 70);
    b->state.program.fragment_reads_sample_mask = random_chance(r, 25);
    b->state.program.fragment_writes_sample_mask = random_chance(r, 25);
    stretch_colors(b);
}

void generate_inputs(builder *b)
{
    static const gn_format depths[] = {GN_FORMAT_NONE, GN_FORMAT_D16, GN_FORMAT_D24,
                                       GN_FORMAT_D32F};
    random_source *r = &b->random;
    builder_common_target(b);
    b->scene->depth_format = depths[random_below(r, 4)];
    if (random_chance(r, 50))
        b->scene->color_format = GN_FORMAT_RGBA32F;
    for (uint32_t draws = 1 + random_below(r, 3); draws > 0; --draws) {
        builder_common_state(b);
        b->state.depth.function = random_chance(r, 50) ? random_comparison(r) : GN_COMPARE_DEFAULT;
        b->state.depth.write_disabled = random_chance(r, 15);
        b->state.raster.cull = (gn_cull)(random_chance(r, 30) ? random_below(r, 3) : 0);
        b->state.raster.front_face = (gn_front_face)random_below(r, 2);
        b->state.raster.provoking_vertex = (gn_provoking_vertex)random_below(r, 2);
        if (random_chance(r, 3)) /* longer than a segment of the reference */
            shape_triangles(b, PLACE_ANYWHERE, 1300 + random_below(r, 1500));
        else
            shape_any(b, builder_triangle_count(b));
        random_inputs(b);
        builder_draw(b);
    }
}

void generate_counting(builder *b)
{
    static const gn_format depths[] = {GN_FORMAT_NONE, GN_FORMAT_D16,   GN_FORMAT_D24,
                                       GN_FORMAT_D32F, GN_FORMAT_D24S8, GN_FORMAT_D32FS8};
    random_source *r = &b->random;
    builder_common_target(b);
    b->scene->depth_format = depths[random_below(r, 6)];
    for (uint32_t draws = 1 + random_below(r, 4); draws > 0; --draws) {
        builder_common_state(b);
        b->state.depth.function = random_chance(r, 30) ? random_comparison(r) : GN_COMPARE_DEFAULT;
        b->state.raster.cull = (gn_cull)(random_chance(r, 30) ? random_below(r, 3) : 0);
        if (random_chance(r, 15))
            random_stencil(b);
        if (random_chance(r, 10)) /* enough for several tasks */
            shape_triangles(b, PLACE_ANYWHERE, 600 + random_below(r, 1500));
        else
            shape_any(b, builder_triangle_count(b));
        if (random_chance(r, 20))
            random_inputs(b);
        b->counted = random_chance(r, 80);
        builder_draw(b);
    }
}

void random_derivatives(builder *b)
{
    static const gn_interpolation mixed[] = {GN_SMOOTH, GN_NOPERSPECTIVE, GN_SMOOTH, GN_FLAT};
    random_source *r = &b->random;
    const bool one = random_chance(r, 70);
    const gn_interpolation all = (gn_interpolation)random_below(r, 2);
    b->shader = SCENE_DERIVATIVES;
    for (int i = 0; i < 4; ++i)
        b->state.program.interpolation[i] = one ? all : mixed[i];
    /* Steep enough to change bytes. */
    const float scale = b->scene->color_format == GN_FORMAT_RGBA32F ? 1.0f : 16.0f;
    for (uint32_t i = 0; i < b->vertex_count; ++i)
        for (int c = 0; c < 4; ++c)
            b->vertices[i].color[c] = (b->vertices[i].color[c] - 0.5f) * scale;
}

void generate_derivatives(builder *b)
{
    random_source *r = &b->random;
    builder_common_target(b);
    if (random_chance(r, 80))
        b->scene->color_format = GN_FORMAT_RGBA32F;
    for (uint32_t draws = 1 + random_below(r, 2); draws > 0; --draws) {
        builder_common_state(b);
        b->state.raster.provoking_vertex = (gn_provoking_vertex)random_below(r, 2);
        const uint32_t kind = random_below(r, 20);
        if (kind == 0)
            shape_points(b, builder_triangle_count(b));
        else if (kind == 1)
            shape_lines(b, builder_triangle_count(b));
        else
            shape_any(b, builder_triangle_count(b));
        random_derivatives(b);
        builder_draw(b);
    }
}
