/* The ready-made shaders: every one, with every combination of maps and lights. */
#include "generate_parts.h"

#include <stdlib.h>

/* No byte is 0, nor is a float: what is added to a texel may be denormal. */
static void random_map_texels(random_source *r, const gn_texture *t, void *texels)
{
    const size_t count = (size_t)t->width * t->height;

    for (size_t i = 0; t->format != GN_FORMAT_RGBA32F && i < count; i++)
        ((uint32_t *)texels)[i] = (uint32_t)(random_bits(r) >> 32) | 0x01010101u;
    for (size_t i = 0; t->format == GN_FORMAT_RGBA32F && i < 4 * count; i++)
        ((float *)texels)[i] = random_float(r, 0.01f, 1.0f);
}

/* A 2D texture over memory that the caller frees. */
static void *random_map(builder *b, gn_texture *t)
{
    static const uint32_t sides[] = {1, 2, 3, 4, 5, 7, 8, 16, 20, 32};
    random_source *r = &b->random;

    t->width = sides[random_below(r, 10)];
    t->height = random_chance(r, 40) ? t->width : sides[random_below(r, 10)];
    t->format = random_chance(r, 80) ? GN_FORMAT_RGBA8 : GN_FORMAT_RGBA32F;
    void *texels = malloc((size_t)t->width * t->height * gn_format_size(t->format));
    if (!texels) {
        fprintf(stderr, "parity: out of memory\n");
        exit(EXIT_FAILURE);
    }
    random_map_texels(r, t, texels);
    scene_pack_texture(t, texels);
    return texels;
}

static gn_vec3 random_vec3(random_source *r, float low, float high)
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
    for (int i = 0; i < 3; i++)
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

    for (uint32_t i = 0; i < b->vertex_count; i++) {
        vertex *v = &b->vertices[i];
        const gn_vec3 tangent = random_vec3(r, -1.0f, 1.0f);

        for (int c = 0; c < 2; c++)
            v->texcoord[c] = v->texcoord[c] * extent - 0.25f;
        v->tangent[0] = tangent.x;
        v->tangent[1] = tangent.y;
        v->tangent[2] = tangent.z;
        v->tangent[3] = random_sign(r);
    }
}

static void random_shape(builder *b)
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

static void add_shaded(builder *b, scene_shader shader)
{
    random_source *r = &b->random;
    void *texels[1 + SCENE_MAP_COUNT] = {NULL};

    builder_common_state(b);
    b->shader = shader;
    random_shape(b);
    random_surface(b);
    random_texture_coordinates(b);
    if (random_chance(r, 15))
        b->color_components = 0;
    b->uniforms.sampler.wrap_s = (gn_wrap)random_below(r, 2);
    b->uniforms.sampler.wrap_t = (gn_wrap)random_below(r, 2);
    b->uniforms.sampler.magnify = (gn_magnify)random_below(r, 2);
    b->uniforms.sampler.minify = (gn_minify)random_below(r, 3);
    if (random_chance(r, 50) || shader == SCENE_TEXTURED_GOURAUD)
        texels[SCENE_MAP_COUNT] = random_map(b, &b->uniforms.texture);
    for (int m = SCENE_NORMAL_MAP; m <= SCENE_GLOW_MAP; m++)
        if (random_chance(r, 50))
            texels[m] = random_map(b, &b->surface.map[m]);
    if (shader == SCENE_DEPTH_COLOR && random_chance(r, 60)) {
        b->surface.black = random_float(r, 0.0f, 0.4f);
        b->surface.white = random_float(r, 0.5f, 1.0f);
    }
    if (shader == SCENE_DEPTH_COLOR && random_chance(r, 30))
        b->state.polygon_offset = random_polygon_offset(b);
    if (random_chance(r, 10))
        random_clip_planes(b, 1 + random_below(r, 2));
    if (b->scene->color_format == GN_FORMAT_RGBA8 && random_chance(r, 10))
        lay_over(b, 0);
    builder_draw(b);
    for (int m = 0; m <= SCENE_MAP_COUNT; m++)
        free(texels[m]);
}

/* Depth alone needs a depth buffer. */
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
    for (uint32_t draws = 1 + random_below(r, 2); draws > 0; draws--)
        add_shaded(b, random_shader(b));
}
