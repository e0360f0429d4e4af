/* The state of the pipeline: targets and viewports, depth, culling, interpolation,
 * colours the target rounds, and all of it together. */
#include "generate_parts.h"

#include <string.h>

typedef void shape_function(builder *b, uint32_t count);

static void any_triangles(builder *b, uint32_t count)
{
    shape_triangles(b, (placement)random_below(&b->random, PLACE_COUNT), count);
}

/* One of the shapes of separate triangles. */
void shape_separate(builder *b, uint32_t count)
{
    shape_function *const shapes[] = {any_triangles, shape_ties,   shape_behind,
                                      shape_tiny,    shape_huge,   shape_near_crossing,
                                      shape_slivers, any_triangles};
    shapes[random_below(&b->random, 8)](b, count);
}

void shape_any(builder *b, uint32_t count)
{
    const uint32_t which = random_below(&b->random, 6);
    if (which == 0)
        shape_strip(b, count);
    else if (which == 1)
        shape_any_grid(b, 6);
    else if (which == 2)
        shape_pile(b, 1 + count / 3);
    else
        shape_separate(b, count);
}

gn_viewport random_viewport(builder *b)
{
    random_source *r = &b->random;
    const float width = (float)b->scene->width, height = (float)b->scene->height;
    gn_viewport v = {true, 0.0f, 0.0f, width, height};
    switch (random_below(r, 6)) {
    case 0: /* inside the target, on whole pixels */
        v.x = (float)random_below(r, b->scene->width);
        v.y = (float)random_below(r, b->scene->height);
        v.width = (float)(1 + random_below(r, b->scene->width - (uint32_t)v.x));
        v.height = (float)(1 + random_below(r, b->scene->height - (uint32_t)v.y));
        break;
    case 1: /* anywhere, in fractions */
        v.x = random_float(r, -0.5f, 1.0f) * width;
        v.y = random_float(r, -0.5f, 1.0f) * height;
        v.width = random_float(r, 0.1f, 2.0f) * width;
        v.height = random_float(r, 0.1f, 2.0f) * height;
        break;
    case 2: /* sides through pixel centres and on quarter pixels */
        v.x = (float)random_between(r, -8, 40) * 0.25f;
        v.y = (float)random_between(r, -8, 40) * 0.25f;
        v.width = (float)random_between(r, 1, 500) * 0.25f;
        v.height = (float)random_between(r, 1, 500) * 0.25f;
        break;
    case 3: /* larger than the target on all sides */
        v.x = -width * random_float(r, 0.0f, 3.0f);
        v.y = -height * random_float(r, 0.0f, 3.0f);
        v.width = width * random_float(r, 4.0f, 8.0f);
        v.height = height * random_float(r, 4.0f, 8.0f);
        break;
    case 4: /* less than a pixel, and now and then nothing */
        v.x = random_float(r, 0.0f, width);
        v.y = random_float(r, 0.0f, height);
        v.width = random_chance(r, 20) ? 0.0f : random_float(r, 0.0f, 3.0f);
        v.height = random_chance(r, 20) ? 0.0f : random_float(r, 0.0f, 3.0f);
        break;
    default: /* the whole target, set explicitly */
        break;
    }
    return v;
}

void generate_framebuffers(builder *b)
{
    static const uint32_t sizes[] = {1,  1,  2,  3,  4,  5,  7,   8,   9,   13,  15,  16,
                                     17, 31, 33, 63, 64, 65, 100, 127, 129, 200, 255, 257};
    static const gn_format depths[] = {GN_FORMAT_NONE, GN_FORMAT_D16, GN_FORMAT_D24,
                                       GN_FORMAT_D32F};
    random_source *r = &b->random;
    uint32_t width = sizes[random_below(r, 24)], height = sizes[random_below(r, 24)];
    if (width * height > 32768)
        height = 1 + random_below(r, 16);
    builder_target(b, width, height, GN_FORMAT_RGBA8, depths[random_below(r, 4)]);
    for (uint32_t draws = 1 + random_below(r, 3); draws > 0; --draws) {
        builder_common_state(b);
        if (random_chance(r, 70))
            b->state.raster.viewport = random_viewport(b);
        if (random_chance(r, 50) || b->state.raster.viewport.width == 0.0f)
            shape_separate(b, 1 + builder_triangle_count(b) / 2);
        else
            shape_any_grid(b, 5);
        builder_draw(b);
    }
}

gn_depth_range random_depth_range(builder *b)
{
    random_source *r = &b->random;
    gn_depth_range range = {true, 0.0f, 1.0f};
    switch (random_below(r, 6)) {
    case 0:
        range.z_near = 1.0f;
        range.z_far = 0.0f;
        break;
    case 1:
        range.z_near = random_unit(r);
        range.z_far = random_unit(r);
        break;
    case 2:
        range.z_near = (float)random_below(r, 5) * 0.25f;
        range.z_far = (float)random_below(r, 5) * 0.25f;
        break;
    case 3:
        range.z_near = range.z_far = random_unit(r);
        break;
    case 4: /* a few steps of the coarser formats */
        range.z_near = random_unit(r) * 0.999f;
        range.z_far = range.z_near + random_octave(r, -24, -12);
        break;
    default:
        break;
    }
    return range;
}

void generate_depth_state(builder *b)
{
    static const gn_format depths[] = {GN_FORMAT_D16,  GN_FORMAT_D24, GN_FORMAT_D32F,
                                       GN_FORMAT_D16,  GN_FORMAT_D24, GN_FORMAT_D32F,
                                       GN_FORMAT_D32F, GN_FORMAT_NONE};
    random_source *r = &b->random;
    builder_common_target(b);
    b->scene->depth_format = depths[random_below(r, 8)];
    const float clear_depths[] = {1.0f, 1.0f, 0.0f, 0.5f, random_unit(r)};
    b->scene->clear_depth = clear_depths[random_below(r, 5)];
    for (uint32_t draws = 1 + random_below(r, 5); draws > 0; --draws) {
        builder_common_state(b);
        b->state.depth.test_enabled = random_chance(r, 90);
        b->state.depth.function = random_comparison(r);
        b->state.depth.write_disabled = random_chance(r, 25);
        if (random_chance(r, 60))
            b->state.depth.range = random_depth_range(b);
        if (random_chance(r, 60))
            shape_pile(b, 1 + builder_triangle_count(b) / 3);
        else
            shape_separate(b, 1 + builder_triangle_count(b) / 3);
        builder_draw(b);
    }
}

void generate_culling(builder *b)
{
    random_source *r = &b->random;
    builder_common_target(b);
    for (uint32_t draws = 1 + random_below(r, 4); draws > 0; --draws) {
        builder_common_state(b);
        b->state.raster.cull = (gn_cull)random_below(r, random_chance(r, 20) ? 4 : 3);
        b->state.raster.front_face = (gn_front_face)random_below(r, 2);
        b->state.raster.provoking_vertex = (gn_provoking_vertex)random_below(r, 2);
        const bool flat = random_chance(r, 60);
        for (int i = 0; flat && i < 4; ++i)
            b->state.program.interpolation[i] = GN_FLAT;
        const uint32_t kind = random_below(r, 10), count = 1 + builder_triangle_count(b) / 2;
        if (kind < 3) {
            shape_strip(b, count);
        } else if (kind < 6) {
            shape_turning(b, count);
            /* The reference culls by another rule if some vertex of a draw is outside the view
             * volume. */
            shape_triangles(b, PLACE_ANYWHERE, random_below(r, 2));
        } else {
            shape_separate(b, count);
        }
        builder_draw(b);
    }
}

/* Triangles with w from 1/64 to 64 that cross the two planes of one axis only. A corner
 * of the view volume would leave an edge lying on one of its sides, along which
 * the reference divides 0 by 0 for noperspective varyings: out of contract. */
static void shape_across_one_axis(builder *b, uint32_t count)
{
    random_source *r = &b->random;
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t axis = random_below(r, 3);
        const float extent = random_chance(r, 50) ? 0.99f : random_octave(r, 0, 2);
        const int32_t octaves = random_between(r, 0, 6);
        for (int k = 0; k < 3; ++k) {
            vertex *v = builder_vertex(b);
            const float w = random_octave(r, -octaves, octaves - 1);
            for (uint32_t c = 0; c < 3; ++c)
                v->position[c] = w * (c == axis ? random_float(r, -extent, extent)
                                                : random_float(r, -0.99f, 0.99f));
            v->position[3] = w;
        }
    }
}

/* One mode for all components, or one each; true where one is noperspective. */
static bool random_interpolation(builder *b)
{
    random_source *r = &b->random;
    const bool mixed = random_chance(r, 50);
    const gn_interpolation all = (gn_interpolation)random_below(r, 3);
    bool noperspective = false;
    for (int i = 0; i < 4; ++i) {
        b->state.program.interpolation[i] = mixed ? (gn_interpolation)random_below(r, 3) : all;
        noperspective = noperspective || b->state.program.interpolation[i] == GN_NOPERSPECTIVE;
    }
    return noperspective;
}

void generate_interpolation(builder *b)
{
    random_source *r = &b->random;
    builder_common_target(b);
    const gn_format depths[] = {GN_FORMAT_NONE, GN_FORMAT_D24};
    b->scene->depth_format = depths[random_below(r, 2)];
    for (uint32_t draws = 1 + random_below(r, 2); draws > 0; --draws) {
        builder_common_state(b);
        b->state.depth.test_enabled = b->scene->depth_format != GN_FORMAT_NONE;
        b->state.raster.provoking_vertex = (gn_provoking_vertex)random_below(r, 2);
        const uint32_t count = builder_triangle_count(b);
        if (random_interpolation(b) || random_chance(r, 50))
            shape_across_one_axis(b, count);
        else
            shape_separate(b, count);
        builder_draw(b);
    }
}

void generate_float_color(builder *b)
{
    random_source *r = &b->random;
    builder_common_target(b);
    b->scene->color_format = GN_FORMAT_RGBA32F;
    for (int i = 0; i < 4; ++i)
        b->scene->clear_color[i] = random_float(r, -2.0f, 3.0f);
    for (uint32_t draws = 1 + random_below(r, 2); draws > 0; --draws) {
        builder_common_state(b);
        b->state.raster.provoking_vertex = (gn_provoking_vertex)random_below(r, 2);
        const gn_interpolation all = random_chance(r, 75) ? GN_SMOOTH : GN_FLAT;
        const bool noperspective = random_chance(r, 25);
        for (int i = 0; i < 4; ++i)
            b->state.program.interpolation[i] = noperspective ? GN_NOPERSPECTIVE : all;
        const uint32_t count = builder_triangle_count(b);
        if (noperspective)
            shape_across_one_axis(b, count);
        else
            shape_separate(b, count);
        const float scale = random_chance(r, 50) ? 1.0f : random_octave(r, -20, 20);
        for (uint32_t i = 0; i < b->vertex_count; ++i)
            for (int c = 0; c < 4; ++c)
                b->vertices[i].color[c] = scale * random_float(r, -1.0f, 1.0f);
        builder_draw(b);
    }
}

/* Values where the conversion to a byte decides something: half steps, the ends of
 * the range, and magnitudes at which an integer conversion overflows. */
static float edge_color(random_source *r)
{
    const float sign = random_sign(r);
    switch (random_below(r, 6)) {
    case 0:
        return ((float)random_between(r, -2, 258) + 0.5f) / 255.0f;
    case 1:
        return (float)random_between(r, -2, 257) / 255.0f;
    case 2:
        return sign * random_octave(r, 0, 40);
    case 3:
        return random_float(r, -1.0f, 2.0f);
    case 4:
        return sign * random_octave(r, -40, -1);
    default:
        return random_unit(r);
    }
}

void generate_color_range(builder *b)
{
    random_source *r = &b->random;
    builder_common_target(b);
    for (int i = 0; i < 4; ++i)
        b->scene->clear_color[i] = edge_color(r);
    for (uint32_t draws = 1 + random_below(r, 3); draws > 0; --draws) {
        builder_common_state(b);
        const bool flat = random_chance(r, 50);
        for (int i = 0; flat && i < 4; ++i)
            b->state.program.interpolation[i] = GN_FLAT;
        any_triangles(b, builder_triangle_count(b));
        for (uint32_t i = 0; i < b->vertex_count; ++i)
            for (int c = 0; c < 4; ++c)
                b->vertices[i].color[c] = edge_color(r);
        builder_draw(b);
    }
}

static void mixed_draw(builder *b)
{
    static const gn_compare functions[] = {GN_LESS, GN_LESS_OR_EQUAL, GN_ALWAYS, GN_GREATER};
    random_source *r = &b->random;
    builder_common_state(b);
    b->state.depth.function = functions[random_below(r, 4)];
    if (random_chance(r, 30))
        b->state.raster.viewport = random_viewport(b);
    if (random_chance(r, 30))
        b->state.depth.range = random_depth_range(b);
    if (random_chance(r, 20))
        b->state.raster.scissor = random_scissor(b);
    if (random_chance(r, 20))
        b->state.raster.polygon_offset = random_polygon_offset(b);
    b->state.depth.clamp_enabled = random_chance(r, 15);
    b->state.depth.clip_depth = (gn_clip_depth)random_chance(r, 15);
    b->state.raster.cull = (gn_cull)(random_chance(r, 40) ? random_below(r, 3) : 0);
    b->state.raster.front_face = (gn_front_face)random_below(r, 2);
    b->state.raster.provoking_vertex = (gn_provoking_vertex)random_below(r, 2);
    b->shader = (scene_shader)(random_chance(r, 40) ? random_below(r, 3) : 0);
    b->uniforms.light.light_direction.z = 1.0f;
    b->uniforms.light.ambient = (gn_vec3){0.25f, 0.25f, 0.5f};
    b->uniforms.light.diffuse = (gn_vec3){0.75f, 0.5f, 0.5f};

    if (random_chance(r, 15))
        state_outlines(b);
    const uint32_t count = 1 + builder_triangle_count(b) / 3;
    const bool empty =
        b->state.raster.viewport.enabled &&
        (b->state.raster.viewport.width == 0.0f || b->state.raster.viewport.height == 0.0f);
    switch (empty ? 5 : random_below(r, 10)) {
    case 0:
        shape_any_grid(b, 6);
        break;
    case 1:
        shape_hub(b, 3 + random_below(r, 20));
        break;
    case 2:
        shape_strip(b, count);
        break;
    case 3:
        shape_pile(b, count);
        break;
    case 4:
        shape_random_indices(b, PLACE_ANYWHERE, 3 + random_below(r, 60), count);
        b->index_format = GN_INDEX_UINT16;
        break;
    case 5:
        shape_degenerate(b, count);
        break;
    case 6:
        shape_points(b, count);
        break;
    case 7:
        shape_lines(b, count);
        break;
    default:
        shape_separate(b, count);
        break;
    }
    b->lead = random_chance(r, 20) ? random_below(r, 9) : 0;
    mix_color_state(b);
    mix_attachments(b, false);
    if (b->scene->more_colors[0] != GN_FORMAT_NONE && random_chance(r, 60))
        random_outputs(b);
    if (random_chance(r, 10))
        random_inputs(b);
    else if (random_chance(r, 5))
        random_derivatives(b);
    if (random_chance(r, 20))
        random_stencil(b);
    fit_outlines(b);
    b->counted = random_chance(r, 10);
    if (random_chance(r, 25))
        shape_elements(b);
    if (random_chance(r, 15))
        random_clip_planes(b, 1 + random_below(r, 2));
    builder_draw(b);
}

void generate_mixed(builder *b)
{
    static const gn_format stencils[] = {GN_FORMAT_D24S8, GN_FORMAT_D32FS8, GN_FORMAT_S8};
    builder_common_target(b);
    if (random_chance(&b->random, 30))
        b->scene->depth_format = stencils[random_below(&b->random, 3)];
    const uint32_t kind = random_below(&b->random, 10);
    if (kind < 4)
        b->scene->color_format = random_color_format(b);
    else if (kind < 5)
        b->scene->color_format = GN_FORMAT_RGBA32F;
    if (random_chance(&b->random, 15))
        add_attachments(b);
    const gn_format format = b->scene->color_format;
    const bool floats = format == GN_FORMAT_RGBA32F || format == GN_FORMAT_R32F;
    for (uint32_t i = 0, draws = 2 + random_below(&b->random, 4); i < draws; ++i)
        if (floats || random_chance(&b->random, 50))
            varied_draw(b, may_blend_after(b, i));
        else
            mixed_draw(b);
}
