/* Builds one scene: its targets, vertices, their placement in the window, and the draw made of
 * them. */
#include "builder.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void *grown(void *memory, uint32_t count, uint32_t *capacity, size_t size)
{
    if (count < *capacity)
        return memory;
    *capacity = *capacity ? *capacity * 2 : 64;
    void *bigger = realloc(memory, *capacity * size);
    if (!bigger) {
        fprintf(stderr, "parity: out of memory\n");
        exit(EXIT_FAILURE);
    }
    return bigger;
}

static void reset_draw(builder *b)
{
    b->shader = SCENE_VERTEX_COLOR;
    b->counted = false;
    memset(&b->uniforms, 0, sizeof b->uniforms);
    for (int i = 0; i < 4; ++i)
        b->uniforms.light.clip_from_model.m[i][i] = 1.0f;
    for (int i = 0; i < 3; ++i)
        b->uniforms.light.normal_matrix.m[i][i] = 1.0f;
    memset(&b->surface, 0, sizeof b->surface);
    gn_mat4_identity(&b->surface.world_from_model);
    gn_mat4_identity(&b->surface.shadow_from_world);
    b->has_tangents = false;
    memset(b->clip_plane, 0, sizeof b->clip_plane);
    b->index_format = GN_INDEX_NONE;
    b->color_components = random_chance(&b->random, 85) ? 4 : 3;
    b->position_components = 4;
    b->texcoord_components = 2;
    b->restart = GN_RESTART_NONE;
    b->restart_index = 0;
    b->base_vertex = 0;
    b->instance_count = 0;
    b->color_divisor = 0;
    b->lead = 0;
    b->trail = 0;
    b->vertex_count = 0;
    b->index_count = 0;
}

void builder_begin(builder *b, uint64_t seed)
{
    memset(b, 0, sizeof *b);
    b->random = random_seed(seed);
    reset_draw(b);
}

scene *builder_end(builder *b)
{
    free(b->vertices);
    free(b->indices);
    return b->scene;
}

void builder_target(builder *b, uint32_t width, uint32_t height, gn_format color, gn_format depth)
{
    static const float clear_depths[] = {1.0f, 1.0f, 1.0f, 0.75f};
    random_source *r = &b->random;
    b->scene = scene_create(width, height, color, depth);
    for (int i = 0; i < 4; ++i)
        b->scene->clear_color[i] = random_unit(r);
    b->scene->clear_depth = clear_depths[random_below(r, 4)];
}

void builder_common_target(builder *b)
{
    random_source *r = &b->random;
    uint32_t size[2];
    const bool powers = random_chance(r, 50);
    for (int i = 0; i < 2; ++i)
        size[i] = powers ? 16u << random_below(r, 4) : 16 + random_below(r, 113);
    const gn_format depths[] = {GN_FORMAT_NONE, GN_FORMAT_D16, GN_FORMAT_D24, GN_FORMAT_D32F};
    builder_target(b, size[0], size[1], GN_FORMAT_RGBA8, depths[random_below(r, 4)]);
}

void builder_common_state(builder *b)
{
    memset(&b->state, 0, sizeof b->state);
    if (b->scene->depth_format != GN_FORMAT_NONE)
        b->state.depth.test_enabled = random_chance(&b->random, 75);
}

gn_viewport builder_viewport(const builder *b)
{
    gn_viewport whole = {false, 0.0f, 0.0f, (float)b->scene->width, (float)b->scene->height};
    return b->state.raster.viewport.enabled ? b->state.raster.viewport : whole;
}

vertex *builder_vertex(builder *b)
{
    random_source *r = &b->random;
    b->vertices = grown(b->vertices, b->vertex_count, &b->vertex_capacity, sizeof *b->vertices);
    vertex *v = &b->vertices[b->vertex_count++];
    memset(v, 0, sizeof *v);
    v->position[3] = 1.0f;
    for (int i = 0; i < 4; ++i)
        v->color[i] = random_unit(r);
    do {
        for (int i = 0; i < 3; ++i)
            v->normal[i] = random_float(r, -1.0f, 1.0f);
    } while (fabsf(v->normal[0]) + fabsf(v->normal[1]) + fabsf(v->normal[2]) < 0.01f);
    for (int i = 0; i < 2; ++i)
        v->texcoord[i] = random_unit(r);
    return v;
}

void builder_index(builder *b, uint32_t index)
{
    b->indices = grown(b->indices, b->index_count, &b->index_capacity, sizeof *b->indices);
    b->indices[b->index_count++] = index;
}

static float unmapped(float window, float origin, float size)
{
    const double half = 0.5 * (double)size;
    return half > 0.0 ? (float)(((double)window - (half + (double)origin)) / half) : 0.0f;
}

void builder_place(const builder *b, vertex *v, float x, float y, float z, float w)
{
    const gn_viewport viewport = builder_viewport(b);
    v->position[0] = unmapped(x, viewport.x, viewport.width) * w;
    v->position[1] = unmapped(y, viewport.y, viewport.height) * w;
    v->position[2] = z * w;
    v->position[3] = w;
}

/* Writes out the vertices that the indices name, and removes the indices. */
static void expand_indices(builder *b)
{
    const uint32_t count = b->index_count, old = b->vertex_count;
    for (uint32_t i = 0; i < count; ++i) {
        b->vertices = grown(b->vertices, b->vertex_count, &b->vertex_capacity, sizeof *b->vertices);
        b->vertices[b->vertex_count++] = b->vertices[b->indices[i]];
    }
    memmove(b->vertices, b->vertices + old, count * sizeof *b->vertices);
    b->vertex_count = count;
    b->index_count = 0;
}

/* Adds elements at both ends that the draw's first and count leave out. */
static void add_margins(builder *b)
{
    random_source *r = &b->random;
    const uint32_t extra = b->lead + b->trail;
    if (b->index_format != GN_INDEX_NONE) {
        for (uint32_t i = 0; i < extra; ++i)
            builder_index(b, random_below(r, b->vertex_count));
        memmove(b->indices + b->lead, b->indices, (b->index_count - extra) * sizeof *b->indices);
        for (uint32_t i = 0; i < b->lead; ++i)
            b->indices[i] = random_below(r, b->vertex_count);
        for (uint32_t i = b->index_count - b->trail; i < b->index_count; ++i)
            b->indices[i] = random_below(r, b->vertex_count);
        return;
    }
    for (uint32_t i = 0; i < extra; ++i)
        builder_vertex(b);
    memmove(b->vertices + b->lead, b->vertices, (b->vertex_count - extra) * sizeof *b->vertices);
    const uint32_t margins[2][2] = {{0, b->lead}, {b->vertex_count - b->trail, b->vertex_count}};
    for (int m = 0; m < 2; ++m)
        for (uint32_t i = margins[m][0]; i < margins[m][1]; ++i)
            for (int c = 0; c < 3; ++c)
                b->vertices[i].position[c] = random_float(r, -1.0f, 1.0f);
}

static void set_attribute(const builder *b, scene_draw *d, gn_shader_attribute attribute,
                          size_t offset, uint32_t components)
{
    if (components == 0)
        return;
    float *data = malloc(b->vertex_count * components * sizeof *data);
    if (!data) {
        fprintf(stderr, "parity: out of memory\n");
        exit(EXIT_FAILURE);
    }
    for (uint32_t i = 0; i < b->vertex_count; ++i)
        memcpy(data + i * components, (const char *)&b->vertices[i] + offset,
               components * sizeof *data);
    scene_set_attribute(d, attribute, data, components, b->vertex_count);
    free(data);
}

/* Whether some vertex has a clip w of 0 that stays 0 when x and y are clipped. */
static bool has_vertex_at_eye(const builder *b)
{
    for (uint32_t i = 0; i < b->vertex_count; ++i) {
        const float *p = b->vertices[i].position;
        if (p[0] == 0.0f && p[1] == 0.0f && p[3] == 0.0f)
            return true;
    }
    return false;
}

/* Converts indices to the form that the mesh stores. */
static void store_indices(builder *b)
{
    const uint32_t largest = b->index_format == GN_INDEX_UINT8    ? UINT8_MAX
                             : b->index_format == GN_INDEX_UINT16 ? UINT16_MAX
                                                                  : UINT32_MAX;
    b->restart_index &= largest; /* an index below the base vertex has wrapped around */
    for (uint32_t i = 0; i < b->index_count; ++i)
        if (b->indices[i] != BUILDER_RESTART)
            b->indices[i] -= (uint32_t)b->base_vertex;
        else
            b->indices[i] = b->restart == GN_RESTART_INDEX ? b->restart_index : largest;
}

static void set_surface(const builder *b, scene_draw *d)
{
    d->surface = b->surface;
    for (int m = 0; m < SCENE_MAP_COUNT; ++m) {
        d->surface.map[m].level[0].texels = NULL;
        if (b->surface.map[m].level[0].texels)
            scene_set_map(d, (scene_map)m, &b->surface.map[m]);
    }
}

/* The caller frees the texels after builder_draw. What else was chosen stays for the next draw. */
static void forget_texels(builder *b)
{
    b->uniforms.texture.level[0].texels = NULL;
    for (int m = 0; m < SCENE_MAP_COUNT; ++m)
        b->surface.map[m].level[0].texels = NULL;
}

void builder_draw(builder *b)
{
    if (b->vertex_count == 0) {
        forget_texels(b);
        return;
    }
    if (b->index_format == GN_INDEX_NONE && b->index_count > 0)
        expand_indices(b);
    if (b->index_format != GN_INDEX_NONE && b->index_count == 0)
        for (uint32_t i = 0; i < b->vertex_count; ++i)
            builder_index(b, i);
    /* reference/RULES.md leaves these out. */
    if (has_vertex_at_eye(b))
        b->state.depth.clamp_enabled = false;
    if (b->scene->depth_format == GN_FORMAT_NONE || b->scene->depth_format == GN_FORMAT_S8)
        memset(&b->state.raster.polygon_offset, 0, sizeof b->state.raster.polygon_offset);
    const uint32_t count = b->index_format == GN_INDEX_NONE ? b->vertex_count : b->index_count;
    if (b->lead + b->trail > 0)
        add_margins(b);

    scene_draw *d = scene_add_draw(b->scene);
    d->shader = b->shader;
    d->state = b->state;
    d->counted = b->counted;
    d->uniforms.light = b->uniforms.light;
    d->uniforms.sampler = b->uniforms.sampler;
    d->view_from_model = b->view_from_model;
    d->specular = b->specular;
    memcpy(d->clip_plane, b->clip_plane, sizeof d->clip_plane);
    set_attribute(b, d, GN_ATTRIBUTE_POSITION, offsetof(vertex, position), b->position_components);
    set_attribute(b, d, GN_ATTRIBUTE_COLOR, offsetof(vertex, color), b->color_components);
    if (scene_shader_is_lit(b->shader))
        set_attribute(b, d, GN_ATTRIBUTE_NORMAL, offsetof(vertex, normal), 3);
    if (scene_shader_is_textured(b->shader) || scene_shader_shows_surface(b->shader) ||
        b->shader == SCENE_UNLIT || b->state.program.vertex_writes_point_size)
        set_attribute(b, d, GN_ATTRIBUTE_TEXCOORD, offsetof(vertex, texcoord),
                      b->texcoord_components);
    if (scene_shader_shows_surface(b->shader) && b->has_tangents)
        set_attribute(b, d, GN_ATTRIBUTE_TANGENT, offsetof(vertex, tangent), 4);
    if (b->index_format != GN_INDEX_NONE)
        store_indices(b);
    d->mesh.restart = b->restart;
    d->mesh.restart_index = b->restart_index;
    d->mesh.base_vertex = b->base_vertex;
    d->mesh.instance_count = b->instance_count;
    if (b->color_components > 0)
        d->mesh.attribute[GN_ATTRIBUTE_COLOR].divisor = b->color_divisor;
    if (b->index_format != GN_INDEX_NONE)
        scene_set_indices(d, b->indices, b->index_count, b->index_format);
    d->mesh.first = b->lead;
    d->mesh.count = count;
    set_surface(b, d);
    if (b->uniforms.texture.level[0].texels) {
        scene_pack_texture(&b->uniforms.texture, b->uniforms.texture.level[0].texels);
        scene_set_levels(d, &b->uniforms.texture);
    }
    reset_draw(b);
}

uint32_t builder_triangle_count(builder *b)
{
    random_source *r = &b->random;
    const uint32_t which = random_below(r, 10);
    if (which < 5)
        return 1 + random_below(r, 16);
    if (which < 8)
        return 17 + random_below(r, 48);
    return 65 + random_below(r, 136);
}

gn_mat3 builder_rotation(builder *b)
{
    random_source *r = &b->random;
    float q[4], square;
    do {
        square = 0.0f;
        for (int i = 0; i < 4; ++i) {
            q[i] = random_float(r, -1.0f, 1.0f);
            square += q[i] * q[i];
        }
    } while (square > 1.0f || square < 0.01f);
    const float x = q[0], y = q[1], z = q[2], w = q[3], f = 2.0f / square;
    const gn_mat3 m = {{{1.0f - f * (y * y + z * z), f * (x * y + w * z), f * (x * z - w * y)},
                        {f * (x * y - w * z), 1.0f - f * (x * x + z * z), f * (y * z + w * x)},
                        {f * (x * z + w * y), f * (y * z - w * x), 1.0f - f * (x * x + y * y)}}};
    return m;
}
