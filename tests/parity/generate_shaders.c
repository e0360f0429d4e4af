/* The ready-made shaders: each with every combination of maps and lights. */
#include "generate_parts.h"

#include <stdlib.h>
#include <string.h>

/* No byte and no float is 0: a denormal may be added to a texel, and shows only if the texel is
 * 0. */
static void random_map_texels(random_source *r, const gn_texture *t, void *texels)
{
    const size_t count = scene_texture_elements(t) / (t->format == GN_FORMAT_RGBA32F ? 4u : 1u);

    for (size_t i = 0; t->format != GN_FORMAT_RGBA32F && i < count; ++i)
        ((uint32_t *)texels)[i] = (uint32_t)(random_bits(r) >> 32) | 0x01010101u;
    for (size_t i = 0; t->format == GN_FORMAT_RGBA32F && i < 4 * count; ++i)
        ((float *)texels)[i] = random_float(r, 0.01f, 1.0f);
}

void *random_map(builder *b, gn_texture *t)
{
    static const uint32_t sides[] = {1, 2, 3, 4, 5, 7, 8, 16, 20, 32};
    random_source *r = &b->random;

    t->width = sides[random_below(r, 10)];
    t->height = random_chance(r, 40) ? t->width : sides[random_below(r, 10)];
    t->format = random_chance(r, 60)   ? GN_FORMAT_RGBA8
                : random_chance(r, 50) ? GN_FORMAT_RGBA32F
                                       : GN_FORMAT_SRGB8_A8;
    t->level_count = 1;
    while (random_chance(r, 50) && (t->width | t->height) >> t->level_count)
        ++t->level_count;
    void *texels = malloc(scene_texture_elements(t) * scene_element_size(t->format));
    if (!texels) {
        fprintf(stderr, "parity: out of memory\n");
        exit(EXIT_FAILURE);
    }
    random_map_texels(r, t, texels);
    scene_pack_texture(t, texels);
    return texels;
}

gn_vec3 random_vec3(random_source *r, float low, float high)
{
    gn_vec3 v;

    v.x = random_float(r, low, high);
    v.y = random_float(r, low, high);
    v.z = random_float(r, low, high);
    return v;
}

static void random_point_light(builder *b)
{
    random_source *r = &b->random;
    scene_surface *s = &b->surface;

    s->has_point_light = true;
    s->light_position = random_vec3(r, -4.0f, 4.0f);
    for (int i = 0; i < 3; ++i)
        s->attenuation[i] = random_chance(r, 60) ? random_float(r, 0.0f, 2.0f) : 0.0f;
}

static void random_surface(builder *b)
{
    static const uint32_t exponents[] = {0, 1, 2, 3, 5, 8, 20, 32, 77, 128};
    random_source *r = &b->random;
    scene_surface *s = &b->surface;

    random_light(b);
    s->world_from_model = b->view_from_model;
    if (random_chance(r, 30))
        s->eye = random_vec3(r, -3.0f, 3.0f);
    if (random_chance(r, 50))
        random_point_light(b);
    b->specular = random_vec3(r, 0.0f, 1.0f);
    s->exponent = exponents[random_below(r, 10)];
    s->bands = random_chance(r, 30) ? 0 : 2 + random_below(r, random_chance(r, 80) ? 8 : 255);
    s->normal_space = (gn_normal_space)random_below(r, 2);
    b->has_tangents = random_chance(r, 90);
}

static void random_texture_coordinates(builder *b)
{
    random_source *r = &b->random;
    const float extent = random_octave(r, -2, 3);

    for (uint32_t i = 0; i < b->vertex_count; ++i) {
        vertex *v = &b->vertices[i];
        const gn_vec3 tangent = random_vec3(r, -1.0f, 1.0f);

        for (int c = 0; c < 2; ++c)
            v->texcoord[c] = v->texcoord[c] * extent - 0.25f;
        v->tangent[0] = tangent.x;
        v->tangent[1] = tangent.y;
        v->tangent[2] = tangent.z;
        v->tangent[3] = random_sign(r);
    }
}

void shape_shaded(builder *b)
{
    random_source *r = &b->random;
    const uint32_t which = random_below(r, 100);

    gn_mat4_identity(&b->view_from_model);
    if (which < 65) {
        random_camera(b);
        add_body(b);
    } else if (which < 92) {
        const placement places[] = {PLACE_ANYWHERE, PLACE_AFFINE, PLACE_TIES, PLACE_CLIP};
        const placement place = places[random_below(r, 4)];

        shape_triangles(b, place, builder_triangle_count(b));
    } else {
        shape_strip(b, 1 + random_below(r, 30));
    }
}

void random_map_sampler(random_source *r, gn_sampler *s)
{
    s->wrap_s = (gn_wrap)random_below(r, 5);
    s->wrap_t = (gn_wrap)random_below(r, 5);
    s->magnify = (gn_magnify)random_below(r, 2);
    s->minify = (gn_minify)random_below(r, 6);
    for (int c = 0; c < 4; ++c)
        s->border[c] = random_float(r, 0.25f, 1.0f);
}

void random_shading(builder *b, shading_memory *memory)
{
    random_source *r = &b->random;

    memset(memory, 0, sizeof *memory);
    random_surface(b);
    random_texture_coordinates(b);
    if (random_chance(r, 15))
        b->color_components = 0;
    random_map_sampler(r, &b->uniforms.sampler);
    if (random_chance(r, 50) || b->shader == SCENE_TEXTURED_GOURAUD)
        memory->texels[SCENE_MAP_COUNT] = random_map(b, &b->uniforms.texture);
    for (int m = SCENE_NORMAL_MAP; m <= SCENE_GLOW_MAP; ++m)
        if (random_chance(r, 50))
            memory->texels[m] = random_map(b, &b->surface.map[m]);
    if (b->shader == SCENE_DEPTH_COLOR && random_chance(r, 60)) {
        b->surface.black = random_float(r, 0.0f, 0.4f);
        b->surface.white = random_float(r, 0.5f, 1.0f);
    }
}

void free_shading(shading_memory *memory)
{
    for (int m = 0; m <= SCENE_MAP_COUNT; ++m)
        free(memory->texels[m]);
}

static void add_shaded(builder *b, scene_shader shader)
{
    random_source *r = &b->random;
    shading_memory memory;

    builder_common_state(b);
    b->shader = shader;
    shape_shaded(b);
    random_shading(b, &memory);
    if (shader == SCENE_DEPTH_COLOR && random_chance(r, 30))
        b->state.raster.polygon_offset = random_polygon_offset(b);
    if (random_chance(r, 10))
        random_clip_planes(b, 1 + random_below(r, 2));
    if (b->scene->color_format == GN_FORMAT_RGBA8 && random_chance(r, 10))
        lay_over(b, 0);
    builder_draw(b);
    free_shading(&memory);
}

/* A shader that writes only depth needs a depth buffer. */
static scene_shader random_shader(builder *b)
{
    static const scene_shader shaders[] = {
        SCENE_MAPPED_PHONG, SCENE_BLINN_PHONG,  SCENE_MAPPED_PHONG,
        SCENE_BLINN_PHONG,  SCENE_FACES,        SCENE_TOON,
        SCENE_FLAT,         SCENE_GOURAUD,      SCENE_TEXTURED_GOURAUD,
        SCENE_UNLIT,        SCENE_NORMAL_COLOR, SCENE_DEPTH_COLOR,
        SCENE_DEPTH_ONLY};

    return shaders[random_below(&b->random, b->scene->depth_format == GN_FORMAT_NONE ? 12 : 13)];
}

void generate_shaders(builder *b)
{
    random_source *r = &b->random;

    builder_common_target(b);
    if (random_chance(r, 40))
        b->scene->color_format = GN_FORMAT_RGBA32F;
    for (uint32_t draws = 1 + random_below(r, 2); draws > 0; --draws)
        add_shaded(b, random_shader(b));
}

/* ---- Shadow maps ---- */

/* A light that sees the body from a random side: from afar with an orthographic projection, or from
 * near. The body is at the origin of model space. */
static void random_light_camera(builder *b)
{
    random_source *r = &b->random;
    scene_surface *s = &b->surface;
    const gn_mat3 turn = builder_rotation(b);
    const bool is_near = random_chance(r, 40);
    const float distance = random_float(r, 2.0f, 4.0f), zoom = random_float(r, 0.7f, 2.0f);
    const float *center = s->world_from_model.m[3];
    float towards[3];
    gn_mat4 view = {{{0}}}, projection = {{{0}}};

    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            view.m[column][row] = turn.m[column][row];
            view.m[3][row] -= turn.m[column][row] * center[column];
        }
        towards[row] = turn.m[row][2];
    }
    view.m[3][2] -= distance;
    view.m[3][3] = 1.0f;
    projection.m[0][0] = zoom * (is_near ? 1.5f : 0.6f);
    projection.m[1][1] = zoom * (is_near ? 1.5f : 0.6f);
    projection.m[2][2] = is_near ? -1.5f : -0.25f;
    projection.m[2][3] = is_near ? -1.0f : 0.0f;
    projection.m[3][2] = is_near ? -1.25f : -1.0f;
    projection.m[3][3] = is_near ? 0.0f : 1.0f;
    gn_mat4_multiply(&projection, &view, &s->shadow_from_world);
    s->has_point_light = is_near;
    b->uniforms.light.light_direction = (gn_vec3){towards[0], towards[1], towards[2]};
    s->light_position =
        (gn_vec3){center[0] + distance * towards[0], center[1] + distance * towards[1],
                  center[2] + distance * towards[2]};
}

/* Adds the shadow map: the library draws the last draw as the light sees it. Another class, that of
 * gn_use_depth_only, tests that the reference draws equal depths. */
static void add_shadow_map(builder *b)
{
    static const gn_format formats[] = {GN_FORMAT_D16, GN_FORMAT_D24, GN_FORMAT_D32F,
                                        GN_FORMAT_D24S8, GN_FORMAT_D32FS8};
    random_source *r = &b->random;
    scene_draw *d = &b->scene->draws[b->scene->draw_count - 1];
    const gn_format format = formats[random_below(r, 5)];
    const uint32_t height = 1 + random_below(r, 64);
    const uint32_t width = 1 + random_below(r, 64);
    scene *first = scene_create(width, height, GN_FORMAT_RGBA8, format);
    scene *copy = scene_copy(b->scene);
    scene_draw seen = copy->draws[copy->draw_count - 1];
    const gn_topology topology = seen.state.raster.topology;
    scene_frame frame;
    gn_texture map = {GN_TEXTURE_2D, first->depth_format, first->width, first->height, 1, 1, {{0}}};

    memset(&seen.state, 0, sizeof seen.state);
    memset(&seen.clear, 0, sizeof seen.clear);
    seen.shader = SCENE_DEPTH_ONLY;
    seen.state.raster.topology = topology;
    seen.state.depth.test_enabled = true;
    if (random_chance(r, 70))
        seen.state.raster.polygon_offset = random_polygon_offset(b);
    gn_mat4_multiply(&b->surface.shadow_from_world, &b->surface.world_from_model,
                     &seen.uniforms.light.clip_from_model);
    *scene_add_draw(first) = seen;
    --copy->draw_count;
    if (!scene_frame_allocate(&frame, first) ||
        scene_draw_library(first, &frame, 0, GN_BACKEND_PORTABLE) != GN_OK) {
        fprintf(stderr, "parity: a shadow map cannot be drawn\n");
        exit(EXIT_FAILURE);
    }
    scene_pack_texture(&map, frame.depth);
    scene_set_map(d, SCENE_SHADOW_MAP, &map);
    scene_frame_free(&frame);
    scene_free(first);
    scene_free(copy);
}

static scene_shader random_shadowed_shader(builder *b)
{
    static const scene_shader shaders[] = {SCENE_FACES, SCENE_TOON, SCENE_MAPPED_PHONG,
                                           SCENE_BLINN_PHONG};

    return shaders[random_below(&b->random, 4)];
}

void shadowed_draw(builder *b, scene_shader (*choose)(builder *), void (*add_more)(builder *))
{
    random_source *r = &b->random;
    gn_sampler *sampler;

    builder_common_state(b);
    b->shader = choose(b);
    random_camera(b);
    add_body(b);
    random_surface(b);
    random_texture_coordinates(b);
    random_light_camera(b);
    sampler = &b->surface.shadow_sampler;
    random_map_sampler(r, sampler);
    sampler->compare = random_chance(r, 60) ? GN_LESS_OR_EQUAL : random_comparison(r);
    if (random_chance(r, 70))
        sampler->wrap_s = sampler->wrap_t = GN_WRAP_CLAMP_TO_BORDER;
    sampler->border[0] = random_chance(r, 80) ? 1.0f : random_unit(r);
    if (add_more)
        add_more(b);

    const scene_surface surface = b->surface;
    builder_draw(b);
    b->surface = surface;
    add_shadow_map(b);
}

void generate_shadowed(builder *b)
{
    builder_common_target(b);
    if (random_chance(&b->random, 40))
        b->scene->color_format = GN_FORMAT_RGBA32F;
    for (uint32_t draws = 1 + random_below(&b->random, 2); draws > 0; --draws)
        shadowed_draw(b, random_shadowed_shader, NULL);
}
