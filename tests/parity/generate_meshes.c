/* Meshes with shared edges, piles, strips and fans, random indices. */
#include "generate_parts.h"

#include <math.h>
#include <string.h>

/* Depth and w of a mesh are linear functions of the place, so that the mesh is a plane or nearly
 * one; sometimes vertices are moved off the plane. */
typedef struct relief {
    float z[3], w[3];
    float roughness;
} relief;

static relief random_relief(builder *b)
{
    random_source *r = &b->random;
    relief f = {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, 0.0f};
    for (int i = 0; i < 3; ++i)
        f.z[i] = random_float(r, -0.4f, 0.4f);
    if (random_chance(r, 60)) {
        f.w[0] = random_octave(r, -1, 1);
        f.w[1] = f.w[0] * random_float(r, -0.45f, 0.45f);
        f.w[2] = f.w[0] * random_float(r, -0.45f, 0.45f);
    }
    f.roughness = random_chance(r, 50) ? 0.0f : random_float(r, 0.0f, 0.5f);
    return f;
}

static void place_on_relief(builder *b, const relief *f, vertex *v, float x, float y)
{
    const gn_viewport view = builder_viewport(b);
    const float u = 2.0f * (x - view.x) / view.width - 1.0f;
    const float t = 2.0f * (y - view.y) / view.height - 1.0f;
    const float rough = f->roughness * random_float(&b->random, -1.0f, 1.0f);
    float w = f->w[0] + f->w[1] * u + f->w[2] * t;
    if (w < 0.05f && f->w[0] > 0.0f)
        w = 0.05f; /* far outside the viewport, so that no plane has to go through the eye */
    builder_place(b, v, x, y, f->z[0] + f->z[1] * u + f->z[2] * t + rough, w);
}

static void triangle(builder *b, uint32_t v0, uint32_t v1, uint32_t v2)
{
    const uint32_t corner[3] = {v0, v1, v2}, turn = random_below(&b->random, 3);
    for (uint32_t k = 0; k < 3; ++k)
        builder_index(b, corner[(k + turn) % 3]);
}

void shape_grid(builder *b, uint32_t columns, uint32_t rows)
{
    random_source *r = &b->random;
    const gn_viewport view = builder_viewport(b);
    const relief f = random_relief(b);
    const bool ties = random_chance(r, 50);
    const float jitter = random_chance(r, 30) ? 0.0f : random_float(r, 0.0f, 0.6f);
    const float margin = random_float(r, -0.3f, 0.3f);
    const float x0 = view.x + view.width * margin, y0 = view.y + view.height * margin;
    const float step_x = view.width * (1.0f - 2.0f * margin) / (float)columns;
    const float step_y = view.height * (1.0f - 2.0f * margin) / (float)rows;
    const uint32_t base = b->vertex_count;
    for (uint32_t j = 0; j <= rows; ++j)
        for (uint32_t i = 0; i <= columns; ++i) {
            const bool inner = i > 0 && i < columns && j > 0 && j < rows;
            const float move = inner ? jitter : 0.0f;
            float x = x0 + step_x * ((float)i + random_float(r, -move, move));
            float y = y0 + step_y * ((float)j + random_float(r, -move, move));
            if (ties) {
                const float grain = random_chance(r, 70) ? 2.0f : 4.0f;
                x = floorf(x * grain) / grain;
                y = floorf(y * grain) / grain;
            }
            place_on_relief(b, &f, builder_vertex(b), x, y);
        }
    for (uint32_t j = 0; j < rows; ++j)
        for (uint32_t i = 0; i < columns; ++i) {
            const uint32_t low = base + j * (columns + 1) + i, high = low + columns + 1;
            if (random_chance(r, 50)) {
                triangle(b, low, low + 1, high + 1);
                triangle(b, low, high + 1, high);
            } else {
                triangle(b, low, low + 1, high);
                triangle(b, low + 1, high + 1, high);
            }
        }
}

void shape_any_grid(builder *b, uint32_t most)
{
    const uint32_t columns = 1 + random_below(&b->random, most);
    shape_grid(b, columns, 1 + random_below(&b->random, most));
}

void shape_hub(builder *b, uint32_t spokes)
{
    random_source *r = &b->random;
    const gn_viewport view = builder_viewport(b);
    const relief f = random_relief(b);
    const float grain = random_chance(r, 50) ? 2.0f : 256.0f;
    const float x = floorf((view.x + view.width * random_unit(r)) * grain) / grain;
    const float y = floorf((view.y + view.height * random_unit(r)) * grain) / grain;
    const float radius = fmaxf(view.width, view.height) * random_octave(r, -3, 0);
    const uint32_t hub = b->vertex_count;
    place_on_relief(b, &f, builder_vertex(b), x, y);
    /* The places are around a square, not a circle: no trigonometry, and some exact ties. */
    for (uint32_t i = 0; i < spokes; ++i) {
        const float t = 4.0f * (float)i / (float)spokes, side = floorf(t), along = t - side;
        const float u = side == 0.0f   ? 1.0f
                        : side == 1.0f ? 1.0f - 2.0f * along
                        : side == 2.0f ? -1.0f
                                       : 2.0f * along - 1.0f;
        const float v = side == 0.0f   ? 2.0f * along - 1.0f
                        : side == 1.0f ? 1.0f
                        : side == 2.0f ? 1.0f - 2.0f * along
                                       : -1.0f;
        place_on_relief(b, &f, builder_vertex(b), x + radius * u, y + radius * v);
    }
    for (uint32_t i = 0; i < spokes; ++i)
        triangle(b, hub, hub + 1 + i, hub + 1 + (i + 1) % spokes);
}

void shape_pile(builder *b, uint32_t count)
{
    random_source *r = &b->random;
    const uint32_t kind = random_below(r, 3);
    for (uint32_t i = 0; i < count; ++i) {
        const float level = (float)random_between(r, -2, 2) * 0.25f;
        /* Two planes, so that many triangles lie in one and cross the other. */
        const float slope_x = i & 1 ? 0.5f : -0.25f, slope_y = i & 1 ? -0.25f : 0.5f;
        for (int k = 0; k < 3; ++k) {
            vertex *v = builder_vertex(b);
            shape_place(b, v, random_chance(r, 50) ? PLACE_AFFINE : PLACE_TIES);
            const float w = v->position[3];
            if (kind == 0)
                v->position[2] = level * w;
            else if (kind == 1)
                v->position[2] = slope_x * v->position[0] + slope_y * v->position[1];
        }
    }
}

void shape_strip(builder *b, uint32_t triangles)
{
    random_source *r = &b->random;
    const gn_viewport view = builder_viewport(b);
    const bool fan = random_chance(r, 50);
    b->state.raster.topology = fan ? GN_TRIANGLE_FAN : GN_TRIANGLE_STRIP;
    /* Now and then too few vertices for a triangle; often four, which the reference may draw as a
     * quadrilateral. */
    const uint32_t kind = random_below(r, 20);
    const uint32_t count = kind == 0 ? random_below(r, 3) : kind < 5 ? 4 : triangles + 2;
    const bool walk = random_chance(r, 60);
    float x = view.x + 0.5f * view.width, y = view.y + 0.5f * view.height;
    for (uint32_t i = 0; i < count; ++i) {
        vertex *v = builder_vertex(b);
        shape_place(b, v, random_chance(r, 30) ? PLACE_ANYWHERE : PLACE_TIES);
        if (!walk)
            continue;
        x += 0.2f * view.width * random_float(r, -1.0f, 1.0f);
        y += 0.2f * view.height * random_float(r, -1.0f, 1.0f);
        if (random_chance(r, 50)) {
            x = floorf(x * 2.0f) * 0.5f;
            y = floorf(y * 2.0f) * 0.5f;
        }
        const float z = random_float(r, -1.0f, 1.0f);
        builder_place(b, v, x, y, z, random_power(r, -1, 1));
    }
}

void shape_random_indices(builder *b, placement p, uint32_t vertices, uint32_t triangles)
{
    random_source *r = &b->random;
    const uint32_t base = b->vertex_count;
    for (uint32_t i = 0; i < vertices; ++i)
        shape_place(b, builder_vertex(b), p);
    const uint32_t per = b->state.raster.topology == GN_TRIANGLES ? 3 * triangles : triangles + 2;
    for (uint32_t i = 0; i < per; ++i)
        builder_index(b, base + random_below(r, vertices));
}

static gn_index_format random_index_format(builder *b)
{
    static const gn_index_format formats[] = {GN_INDEX_NONE, GN_INDEX_UINT8, GN_INDEX_UINT16,
                                              GN_INDEX_UINT32};
    const gn_index_format format = formats[random_below(&b->random, 4)];
    return format == GN_INDEX_UINT8 && b->vertex_count > 256 ? GN_INDEX_UINT16 : format;
}

void generate_meshes(builder *b)
{
    random_source *r = &b->random;
    builder_common_target(b);
    for (uint32_t draws = 1 + random_below(r, 2); draws > 0; --draws) {
        builder_common_state(b);
        if (random_chance(r, 65))
            shape_any_grid(b, 9);
        else
            shape_hub(b, 3 + random_below(r, 40));
        b->index_format = random_index_format(b);
        builder_draw(b);
    }
}

void generate_piles(builder *b)
{
    random_source *r = &b->random;
    static const gn_compare functions[] = {GN_LESS, GN_LESS_OR_EQUAL, GN_EQUAL, GN_GREATER};
    builder_common_target(b);
    const gn_format depths[] = {GN_FORMAT_D16, GN_FORMAT_D24, GN_FORMAT_D32F};
    b->scene->depth_format = depths[random_below(r, 3)];
    for (uint32_t draws = 1 + random_below(r, 3); draws > 0; --draws) {
        builder_common_state(b);
        b->state.depth.test_enabled = true;
        b->state.depth.function = functions[random_below(r, 2)];
        shape_pile(b, 1 + builder_triangle_count(b) / 2);
        if (random_chance(r, 40)) { /* the triangles again, to meet the depths just written */
            builder_draw(b);
            b->state.depth.function = functions[random_below(r, 4)];
            scene_draw *first = &b->scene->draws[b->scene->draw_count - 1];
            const float *position = first->mesh.attribute[GN_ATTRIBUTE_POSITION].data;
            for (uint32_t i = 0; i < first->mesh.vertex_count; ++i)
                memcpy(builder_vertex(b)->position, position + 4 * i, 4 * sizeof *position);
        }
        builder_draw(b);
    }
}

/* A fan of four vertices without indices, which the reference draws as a quadrilateral if nothing
 * is clipped and nothing asks for a provoking vertex. */
static void draw_fan_of_four(builder *b)
{
    random_source *r = &b->random;
    static const placement places[] = {PLACE_INSIDE, PLACE_INSIDE, PLACE_ANYWHERE, PLACE_CLIP};
    const placement place = places[random_below(r, 4)];

    b->state.raster.topology = GN_TRIANGLE_FAN;
    b->state.raster.provoking_vertex =
        random_chance(r, 80) ? GN_PROVOKING_FIRST : GN_PROVOKING_LAST;
    if (random_chance(r, 30)) {
        b->state.raster.polygon_mode_front = (gn_polygon_mode)random_below(r, 3);
        b->state.raster.polygon_mode_back = (gn_polygon_mode)random_below(r, 3);
    }
    for (int i = 0; i < 4; ++i)
        shape_place(b, builder_vertex(b), place);
    b->index_format = GN_INDEX_NONE;
    builder_draw(b);
}

void generate_strips(builder *b)
{
    random_source *r = &b->random;
    builder_common_target(b);
    for (uint32_t draws = 1 + random_below(r, 3); draws > 0; --draws) {
        builder_common_state(b);
        if (random_chance(r, 25)) {
            draw_fan_of_four(b);
            continue;
        }
        const bool flat = random_chance(r, 50);
        for (int i = 0; flat && i < 4; ++i)
            b->state.program.interpolation[i] = GN_FLAT;
        b->state.raster.provoking_vertex = (gn_provoking_vertex)random_below(r, 2);
        shape_strip(b, builder_triangle_count(b));
        b->index_format = random_index_format(b);
        builder_draw(b);
    }
}

void generate_indexed(builder *b)
{
    random_source *r = &b->random;
    builder_common_target(b);
    for (uint32_t draws = 1 + random_below(r, 2); draws > 0; --draws) {
        builder_common_state(b);
        b->state.raster.topology =
            random_chance(r, 60) ? GN_TRIANGLES : (gn_topology)random_below(r, 3);
        const uint32_t vertices =
            random_chance(r, 70) ? 3 + random_below(r, 40) : 200 + random_below(r, 400);
        const placement p = (placement)random_below(r, PLACE_COUNT);
        shape_random_indices(b, p, vertices, builder_triangle_count(b));
        const gn_index_format formats[] = {GN_INDEX_UINT8, GN_INDEX_UINT16, GN_INDEX_UINT32};
        b->index_format = formats[vertices > 256 ? 1 + random_below(r, 2) : random_below(r, 3)];
        if (b->state.raster.topology == GN_TRIANGLES && random_chance(r, 20)) {
            builder_index(b, 0); /* one or two elements that make no triangle */
            if (random_chance(r, 50))
                builder_index(b, 0);
        }
        if (random_chance(r, 60))
            b->lead = random_below(r, 20);
        if (random_chance(r, 60))
            b->trail = random_below(r, 20);
        if (random_chance(r, 15))
            b->index_format = GN_INDEX_NONE;
        builder_draw(b);
    }
}
