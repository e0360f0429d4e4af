/* What limits drawing in window and clip space (the scissor and more), and what changes depth. */
#include "generate_parts.h"

gn_scissor random_scissor(builder *b)
{
    random_source *r = &b->random;
    const int32_t width = (int32_t)b->scene->width, height = (int32_t)b->scene->height;
    gn_scissor s = {true, 0, 0, (uint32_t)width, (uint32_t)height};
    switch (random_below(r, 8)) {
    case 0: /* a few pixels */
        s.x = random_between(r, 0, width - 1);
        s.y = random_between(r, 0, height - 1);
        s.width = random_below(r, 7);
        s.height = random_below(r, 7);
        break;
    case 1: /* over some sides of the target, or beside the target */
        s.x = random_between(r, -width, width + 4);
        s.y = random_between(r, -height, height + 4);
        s.width = random_below(r, 2 * b->scene->width);
        s.height = random_below(r, 2 * b->scene->height);
        break;
    case 2: /* the largest possible */
        s.x = random_between(r, -8, width);
        s.y = random_between(r, -8, height);
        s.width = random_chance(r, 50) ? INT32_MAX / 2 : 16384;
        s.height = random_chance(r, 50) ? INT32_MAX / 2 : 16384;
        break;
    case 3: /* a column or a row */
        s.x = random_between(r, 0, width - 1);
        s.y = random_between(r, 0, height - 1);
        if (random_chance(r, 50)) {
            s.x = 0;
            s.height = 1 + random_below(r, 2);
        } else {
            s.y = 0;
            s.width = 1 + random_below(r, 2);
        }
        break;
    default:
        s.x = random_between(r, 0, width - 1);
        s.y = random_between(r, 0, height - 1);
        s.width = 1 + random_below(r, (uint32_t)(width - s.x));
        s.height = 1 + random_below(r, (uint32_t)(height - s.y));
        break;
    }
    return s;
}

void generate_scissor(builder *b)
{
    random_source *r = &b->random;
    builder_common_target(b);
    for (uint32_t draws = 1 + random_below(r, 4); draws > 0; --draws) {
        builder_common_state(b);
        b->state.raster.scissor = random_scissor(b);
        const uint32_t count = builder_triangle_count(b);
        switch (random_below(r, 4)) {
        case 0:
            shape_any_grid(b, 6);
            break;
        case 1:
            shape_pile(b, 1 + count / 4);
            break;
        default:
            shape_separate(b, count);
            break;
        }
        builder_draw(b);
    }
}

static float offset_number(builder *b)
{
    random_source *r = &b->random;
    switch (random_below(r, 4)) {
    case 0:
        return 0.0f;
    case 1:
        return random_sign(r);
    case 2: {
        const float sign = random_sign(r);
        return sign * random_octave(r, -4, 4);
    }
    default:
        return (float)random_between(r, -40, 40) * 0.25f;
    }
}

gn_polygon_offset random_polygon_offset(builder *b)
{
    random_source *r = &b->random;
    gn_polygon_offset o = {true, 0.0f, 0.0f, 0.0f};
    o.factor = offset_number(b);
    o.units = offset_number(b);
    if (random_chance(r, 40))
        o.units *= random_octave(r, 0, 20); /* a large part of the range of 24-bit depths */
    if (random_chance(r, 40)) {
        const float sign = random_sign(r);
        o.clamp = sign * random_octave(r, -16, -2);
    }
    return o;
}

void generate_offset(builder *b)
{
    static const gn_format depths[] = {GN_FORMAT_D16, GN_FORMAT_D24, GN_FORMAT_D32F};
    random_source *r = &b->random;
    builder_common_target(b);
    b->scene->depth_format = depths[random_below(r, 3)];
    for (uint32_t draws = 1 + random_below(r, 4); draws > 0; --draws) {
        builder_common_state(b);
        b->state.depth.test_enabled = true;
        b->state.depth.function = random_chance(r, 30) ? GN_ALWAYS : GN_LESS;
        if (random_chance(r, 30))
            b->state.depth.range = random_depth_range(b);
        if (random_chance(r, 85))
            b->state.raster.polygon_offset = random_polygon_offset(b);
        if (random_chance(r, 50))
            shape_pile(b, 1 + builder_triangle_count(b) / 3);
        else
            shape_separate(b, 1 + builder_triangle_count(b) / 3);
        builder_draw(b);
    }
}

/* Depths far outside the view volume, or moved so that z starts at 0. */
static void move_depths(builder *b)
{
    random_source *r = &b->random;
    const float scale = random_chance(r, 50) ? 1.0f : random_octave(r, 0, 3);
    const bool halves = random_chance(r, 50);
    for (uint32_t i = 0; i < b->vertex_count; ++i) {
        float *p = b->vertices[i].position;
        p[2] = scale * (halves ? 0.5f * (p[2] + p[3]) : p[2]);
    }
}

void generate_clip_depth(builder *b)
{
    static const gn_format depths[] = {GN_FORMAT_D16, GN_FORMAT_D24, GN_FORMAT_D32F};
    random_source *r = &b->random;
    builder_common_target(b);
    if (random_chance(r, 75))
        b->scene->depth_format = depths[random_below(r, 3)];
    for (uint32_t draws = 1 + random_below(r, 4); draws > 0; --draws) {
        builder_common_state(b);
        b->state.depth.function = random_chance(r, 30) ? GN_ALWAYS : GN_LESS_OR_EQUAL;
        b->state.depth.clamp_enabled = random_chance(r, 60);
        b->state.depth.clip_depth = (gn_clip_depth)random_chance(r, 60);
        if (random_chance(r, 50))
            b->state.depth.range = random_depth_range(b);
        if (random_chance(r, 20))
            b->state.raster.polygon_offset = random_polygon_offset(b);
        b->state.raster.cull = (gn_cull)(random_chance(r, 30) ? random_below(r, 3) : 0);
        if (random_chance(r, 30))
            shape_pile(b, 1 + builder_triangle_count(b) / 3);
        else
            shape_any(b, 1 + builder_triangle_count(b) / 2);
        move_depths(b);
        builder_draw(b);
    }
}

void random_clip_planes(builder *b, uint32_t count)
{
    random_source *r = &b->random;
    b->state.program.clip_distance_count = count;
    for (uint32_t i = 0; i < count; ++i) {
        float *p = b->clip_plane[i];
        for (int c = 0; c < 3; ++c)
            p[c] = random_float(r, -1.0f, 1.0f);
        p[3] = random_float(r, -0.2f, 1.0f);
        switch (random_below(r, 8)) {
        case 0: /* across one axis */
            p[random_below(r, 3)] = 0.0f;
            p[random_below(r, 3)] = 0.0f;
            break;
        case 1: /* about through a vertex */
            if (b->vertex_count > 0) {
                const vertex *v = &b->vertices[random_below(r, b->vertex_count)];
                const float d = p[0] * v->position[0] + p[1] * v->position[1];
                p[3] = -(d + p[2] * v->position[2]) / (v->position[3] != 0.0f ? v->position[3] : 1);
            }
            break;
        case 2: { /* nearly all or all vertices inside or outside */
            const float sign = random_sign(r);
            p[3] = sign * random_octave(r, 0, 6);
            break;
        }
        case 3: {
            const float scale = random_octave(r, -20, 20);
            for (int c = 0; c < 4; ++c)
                p[c] *= scale;
            break;
        }
        default:
            break;
        }
    }
}

void generate_clip_distance(builder *b)
{
    random_source *r = &b->random;
    builder_common_target(b);
    for (uint32_t draws = 1 + random_below(r, 4); draws > 0; --draws) {
        builder_common_state(b);
        b->state.raster.cull = (gn_cull)(random_chance(r, 30) ? random_below(r, 3) : 0);
        b->state.raster.provoking_vertex = (gn_provoking_vertex)random_below(r, 2);
        b->state.depth.clamp_enabled = random_chance(r, 10);
        const bool flat = random_chance(r, 25);
        for (int i = 0; flat && i < 4; ++i)
            b->state.program.interpolation[i] = GN_FLAT;
        const uint32_t count = 1 + builder_triangle_count(b) / 2;
        switch (random_below(r, 6)) {
        case 0:
            shape_any_grid(b, 6);
            break;
        case 1:
            shape_strip(b, count);
            break;
        case 2:
            shape_lines(b, count);
            for (int i = 0; !flat && i < 4; ++i)
                b->state.program.interpolation[i] = (gn_interpolation)random_below(r, 2);
            break;
        case 3:
            shape_points(b, count);
            break;
        default:
            shape_any(b, count);
            break;
        }
        random_clip_planes(b, random_chance(r, 60) ? 1 + random_below(r, 2) : random_below(r, 9));
        builder_draw(b);
    }
}
