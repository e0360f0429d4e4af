/* Points and lines: sizes and widths, and ends at every kind of place that the rules
 * distinguish. */
#include "generate_parts.h"

#include <math.h>

/* Most sizes are small; halves and steps of 1/256 test rounding. */
static float random_size(random_source *r)
{
    switch (random_below(r, 8)) {
    case 0:
        return 1.0f;
    case 1:
        return (float)random_below(r, 20) * 0.5f;
    case 2:
        return (float)random_below(r, 2048) / 256.0f;
    case 3:
        return (float)random_below(r, 2048) / 512.0f;
    case 4:
        return random_octave(r, -3, 8);
    case 5:
        return 0.0f;
    default:
        return random_float(r, 0.0f, 6.0f);
    }
}

/* Chooses as shape_place does, but also places beside and on the sides of pixels and of the view
 * volume. */
static void place_end(builder *b, placement p)
{
    random_source *r = &b->random;
    vertex *v = builder_vertex(b);
    shape_place(b, v, p);
    if (p != PLACE_CLIP && random_chance(r, 5)) {
        const int axis = (int)random_below(r, 3);
        v->position[axis] = v->position[3] * random_sign(r);
    }
}

void shape_points(builder *b, uint32_t count)
{
    random_source *r = &b->random;
    const placement p = (placement)random_below(r, PLACE_COUNT);
    b->state.raster.topology = GN_POINTS;
    b->state.raster.point_size = random_size(r);
    b->state.raster.point_origin = (gn_point_origin)random_below(r, 2);
    /* The reference cuts off points of the vertex shader's size at the viewport
     * (reference/RULES.md). */
    b->state.program.vertex_writes_point_size = scene_shader_has_sizes(b->shader) &&
                                                !b->state.raster.viewport.enabled &&
                                                random_chance(r, 50);
    for (uint32_t i = 0; i < count; ++i) {
        place_end(b, p);
        b->vertices[b->vertex_count - 1].texcoord[0] =
            random_chance(r, 5) ? -random_size(r) : random_size(r);
    }
}

void shape_lines(builder *b, uint32_t count)
{
    static const gn_topology topologies[] = {GN_LINES, GN_LINES, GN_LINE_STRIP, GN_LINE_LOOP};
    random_source *r = &b->random;
    const gn_viewport view = builder_viewport(b);
    const placement p = (placement)random_below(r, PLACE_COUNT);
    const uint32_t kind = random_below(r, 3);
    b->state.raster.topology = topologies[random_below(r, 4)];
    b->state.raster.line_width = random_chance(r, 40) ? 0.0f : random_size(r);
    /* Now and then too few vertices for a line. */
    const uint32_t elements = random_chance(r, 5) ? random_below(r, 3) : count + 1;
    float x = 0.0f, y = 0.0f;
    for (uint32_t i = 0; i < elements; ++i) {
        if (kind == 0 && p != PLACE_CLIP) { /* near the previous one */
            const bool far = i == 0 || random_chance(r, 10);
            const float grain = random_chance(r, 60) ? 4.0f : 256.0f;
            const float dx = random_float(r, -4.0f, 4.0f), dy = random_float(r, -4.0f, 4.0f);
            x = far ? view.x + random_unit(r) * view.width : x + dx;
            y = far ? view.y + random_unit(r) * view.height : y + dy;
            x = floorf(x * grain) / grain;
            y = floorf(y * grain) / grain;
            const float z = random_float(r, -1.0f, 1.0f);
            const float w = random_chance(r, 60) ? 1.0f : random_power(r, -1, 1);
            builder_place(b, builder_vertex(b), x, y, z, w);
        } else {
            place_end(b, p);
        }
    }
    if (b->vertex_count == 0)
        builder_vertex(b);
}

static void random_state(builder *b)
{
    random_source *r = &b->random;
    builder_common_state(b);
    b->state.raster.provoking_vertex = (gn_provoking_vertex)random_below(r, 2);
    b->state.raster.cull = (gn_cull)random_below(r, 4);
    const bool one = random_chance(r, 50);
    const gn_interpolation all = (gn_interpolation)random_below(r, 3);
    for (int i = 0; i < 4; ++i)
        b->state.program.interpolation[i] = one ? all : (gn_interpolation)random_below(r, 3);
    if (random_chance(r, 15))
        b->shader = (scene_shader)random_below(r, 3);
    b->uniforms.light.light_direction.z = 1.0f;
    b->uniforms.light.ambient = (gn_vec3){0.25f, 0.25f, 0.5f};
    b->uniforms.light.diffuse = (gn_vec3){0.75f, 0.5f, 0.5f};
}

static void random_target(builder *b)
{
    builder_common_target(b);
    if (random_chance(&b->random, 25))
        b->scene->color_format = GN_FORMAT_RGBA32F;
}

static void generate(builder *b, void (*shape)(builder *, uint32_t))
{
    random_source *r = &b->random;
    for (uint32_t draws = 1 + random_below(r, 3); draws > 0; --draws) {
        random_state(b);
        shape(b, builder_triangle_count(b));
        if (random_chance(r, 30)) {
            const uint32_t elements = b->vertex_count;
            b->index_format =
                b->vertex_count > 256 ? GN_INDEX_UINT16 : (gn_index_format)random_below(r, 4);
            for (uint32_t i = 0; i < elements; ++i)
                builder_index(b, random_below(r, b->vertex_count));
        }
        b->lead = random_chance(r, 20) ? random_below(r, 9) : 0;
        b->trail = random_chance(r, 20) ? random_below(r, 9) : 0;
        builder_draw(b);
    }
}

void generate_points(builder *b)
{
    random_target(b);
    generate(b, shape_points);
}

void generate_lines(builder *b)
{
    random_target(b);
    generate(b, shape_lines);
}

void generate_point_coordinates(builder *b)
{
    random_source *r = &b->random;
    builder_common_target(b);
    if (random_chance(r, 70))
        b->scene->color_format = GN_FORMAT_RGBA32F;
    for (uint32_t draws = 1 + random_below(r, 3); draws > 0; --draws) {
        builder_common_state(b);
        b->shader = SCENE_INPUTS;
        shape_points(b, builder_triangle_count(b));
        random_inputs(b);
        b->state.program.fragment_reads_point_coordinate = true;
        if (random_chance(r, 20))
            shape_elements(b);
        builder_draw(b);
    }
}

void state_outlines(builder *b)
{
    random_source *r = &b->random;
    b->state.raster.polygon_mode_front = (gn_polygon_mode)random_below(r, 3);
    b->state.raster.polygon_mode_back = random_chance(r, 40) ? b->state.raster.polygon_mode_front
                                                             : (gn_polygon_mode)random_below(r, 3);
    b->state.raster.line_width = random_chance(r, 60) ? 0.0f : random_size(r);
    b->state.raster.point_size = random_size(r);
}

/* The reference tests the stencil with the wrong face (reference/RULES.md). */
void fit_outlines(builder *b)
{
    const bool unfilled = b->state.raster.polygon_mode_front != GN_POLYGON_FILL ||
                          b->state.raster.polygon_mode_back != GN_POLYGON_FILL;
    const bool reads_facing =
        b->shader == SCENE_INPUTS && !b->state.program.fragment_reads_point_coordinate;
    if (unfilled && b->state.stencil.test_enabled && !reads_facing)
        b->state.stencil.back = b->state.stencil.front;
}

static void shape_outlines(builder *b, uint32_t count)
{
    random_source *r = &b->random;
    state_outlines(b);
    b->state.raster.front_face = (gn_front_face)random_below(r, 2);
    b->state.raster.cull = (gn_cull)(random_chance(r, 40) ? random_below(r, 3) : 0);
    b->state.depth.clamp_enabled = random_chance(r, 10);
    switch (random_below(r, 4)) {
    case 0:
        shape_any_grid(b, 5);
        break;
    case 1:
        shape_strip(b, count);
        break;
    default:
        b->state.program.vertex_writes_point_size =
            b->shader == SCENE_VERTEX_COLOR && random_chance(r, 50);
        shape_any(b, 1 + count / 3);
        for (uint32_t i = 0; i < b->vertex_count; ++i)
            b->vertices[i].texcoord[0] = random_size(r);
        break;
    }
    if (random_chance(r, 15))
        random_clip_planes(b, 1 + random_below(r, 3));
    if (random_chance(r, 20))
        random_inputs(b);
    if (random_chance(r, 25))
        random_stencil(b);
    if (random_chance(r, 25)) {
        b->state.raster.polygon_offset = random_polygon_offset(b);
        b->state.depth.range.enabled = random_chance(r, 50);
        b->state.depth.range.z_near = 0.25f;
        b->state.depth.range.z_far = random_chance(r, 50) ? 0.75f : 0.0f;
    }
    fit_outlines(b);
    b->counted = random_chance(r, 10);
}

void generate_outlines(builder *b)
{
    static const gn_format depths[] = {GN_FORMAT_D16,   GN_FORMAT_D24,    GN_FORMAT_D32F,
                                       GN_FORMAT_D24S8, GN_FORMAT_D32FS8, GN_FORMAT_S8};
    random_target(b);
    b->scene->depth_format = depths[random_below(&b->random, 6)];
    generate(b, shape_outlines);
}
