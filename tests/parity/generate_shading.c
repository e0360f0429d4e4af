/* The ready-made shaders with a light and a texture: bodies and loose triangles under a camera,
 * with random rotations. */
#include "generate_parts.h"

#include <math.h>
#include <stdlib.h>

static gn_mat4 product(const gn_mat4 *a, const gn_mat4 *b)
{
    gn_mat4 m;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) {
            m.m[column][row] = 0.0f;
            for (int k = 0; k < 4; ++k)
                m.m[column][row] += a->m[k][row] * b->m[column][k];
        }
    return m;
}

void random_camera(builder *b)
{
    random_source *r = &b->random;
    const gn_mat3 turn = builder_rotation(b);
    const float distance = random_float(r, 1.2f, 5.0f);
    const float z_near = random_chance(r, 70) ? 0.1f : distance - random_float(r, 0.0f, 1.0f);
    const float z_far = z_near + random_float(r, 1.0f, 10.0f), zoom = random_octave(r, -1, 1);
    float stretch[3];
    for (int i = 0; i < 3; ++i)
        stretch[i] = random_chance(r, 70) ? 1.0f : random_octave(r, -1, 0);

    gn_mat4 view = {{{0}}}, projection = {{{0}}};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            view.m[i][j] = turn.m[i][j] * stretch[i];
            b->uniforms.light.normal_matrix.m[i][j] = turn.m[i][j] / stretch[i];
        }
    view.m[3][2] = -distance;
    view.m[3][3] = 1.0f;
    projection.m[0][0] = zoom;
    projection.m[1][1] = zoom;
    projection.m[2][2] = (z_far + z_near) / (z_near - z_far);
    projection.m[2][3] = -1.0f;
    projection.m[3][2] = 2.0f * z_far * z_near / (z_near - z_far);
    b->view_from_model = view;
    b->uniforms.light.clip_from_model = product(&projection, &view);
}

void random_light(builder *b)
{
    random_source *r = &b->random;
    const gn_mat3 turn = builder_rotation(b);
    const bool strong = random_chance(r, 30);
    b->uniforms.light.light_direction = (gn_vec3){turn.m[0][0], turn.m[0][1], turn.m[0][2]};
    float color[6];
    for (int i = 0; i < 6; ++i)
        color[i] = random_unit(r);
    b->uniforms.light.ambient = (gn_vec3){color[0], color[1], color[2]};
    b->uniforms.light.diffuse = (gn_vec3){color[3], color[4], color[5]};
    if (strong)
        b->uniforms.light.diffuse.y *= 8.0f;
}

/* A cube of 6 * n * n cells, projected to a sphere; every face has its own vertices. */
static void add_sphere(builder *b, uint32_t n)
{
    for (uint32_t face = 0; face < 6; ++face) {
        const uint32_t axis = face % 3, base = b->vertex_count;
        const float side = face < 3 ? 1.0f : -1.0f;
        for (uint32_t j = 0; j <= n; ++j)
            for (uint32_t i = 0; i <= n; ++i) {
                vertex *v = builder_vertex(b);
                float p[3];
                p[axis] = side;
                p[(axis + 1) % 3] = side * (2.0f * (float)i / (float)n - 1.0f);
                p[(axis + 2) % 3] = 2.0f * (float)j / (float)n - 1.0f;
                const float length = sqrtf(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
                for (int c = 0; c < 3; ++c)
                    v->position[c] = v->normal[c] = p[c] / length;
                v->texcoord[0] = (float)i / (float)n;
                v->texcoord[1] = (float)j / (float)n;
            }
        for (uint32_t j = 0; j < n; ++j)
            for (uint32_t i = 0; i < n; ++i) {
                const uint32_t low = base + j * (n + 1) + i, high = low + n + 1;
                const uint32_t corner[6] = {low, low + 1, high + 1, low, high + 1, high};
                for (int k = 0; k < 6; ++k)
                    builder_index(b, corner[k]);
            }
    }
}

static void add_loose_triangles(builder *b, uint32_t count)
{
    random_source *r = &b->random;
    for (uint32_t i = 0; i < 3 * count; ++i) {
        vertex *v = builder_vertex(b);
        const float length = random_chance(r, 80) ? 1.0f : random_octave(r, -8, 8);
        for (int c = 0; c < 3; ++c) {
            v->position[c] = random_float(r, -1.2f, 1.2f);
            v->normal[c] *= length;
        }
    }
}

void add_body(builder *b)
{
    random_source *r = &b->random;
    if (random_chance(r, 60))
        add_sphere(b, 1 + random_below(r, 4));
    else
        add_loose_triangles(b, builder_triangle_count(b));
    b->index_format = b->index_count > 0 && random_chance(r, 50) ? GN_INDEX_UINT16 : GN_INDEX_NONE;
    b->position_components = random_chance(r, 50) ? 3 : 4;
    if (random_chance(r, 30))
        b->state.raster.cull = GN_CULL_BACK;
}

void generate_lit(builder *b)
{
    random_source *r = &b->random;
    builder_common_target(b);
    for (uint32_t draws = 1 + random_below(r, 2); draws > 0; --draws) {
        builder_common_state(b);
        b->state.raster.provoking_vertex = (gn_provoking_vertex)random_below(r, 2);
        b->shader = random_chance(r, 50) ? SCENE_FLAT : SCENE_GOURAUD;
        random_camera(b);
        random_light(b);
        add_body(b);
        builder_draw(b);
    }
}

static void *random_texels(builder *b, uint32_t count, gn_format format)
{
    random_source *r = &b->random;
    const size_t size = format == GN_FORMAT_RGBA8 ? 4 : 16;
    void *texels = malloc(count * size);
    if (!texels) {
        fprintf(stderr, "parity: out of memory\n");
        exit(EXIT_FAILURE);
    }
    uint32_t *packed = texels;
    float *channels = texels;
    if (format == GN_FORMAT_RGBA8)
        for (uint32_t i = 0; i < count; ++i)
            packed[i] = (uint32_t)(random_bits(r) >> 32);
    else
        for (uint32_t i = 0; i < 4 * count; ++i)
            channels[i] = random_chance(r, 80) ? random_unit(r) : random_float(r, -1.0f, 2.0f);
    return texels;
}

/* Texture coordinates of the drawn vertices: within the texture, repeated, far away, beyond the
 * integers, not finite, or on texel borders and centres, where the nearest filter and the weights
 * tie. */
static void random_texcoords(builder *b)
{
    random_source *r = &b->random;
    const float size[2] = {(float)b->uniforms.texture.width, (float)b->uniforms.texture.height};
    const uint32_t kind = random_below(r, 6);
    const float extent = random_octave(r, -3, 6);
    const int32_t octave = random_between(r, 20, 60);
    for (uint32_t i = 0; i < b->vertex_count; ++i)
        for (int c = 0; c < 2; ++c) {
            float *s = &b->vertices[i].texcoord[c];
            if (kind == 1) {
                *s = random_float(r, -3.0f, 4.0f);
            } else if (kind == 2) {
                *s = random_float(r, -extent, extent);
            } else if (kind == 3) {
                *s = (float)random_between(r, -6, 20) * 0.5f / size[c];
            } else if (kind == 4) {
                *s = *s * 1.5f - 0.25f;
            } else if (kind == 5 && random_chance(r, 5)) {
                *s = random_chance(r, 50) ? NAN : random_chance(r, 50) ? INFINITY : -INFINITY;
            } else if (kind == 5) {
                const float sign = random_sign(r);
                *s = sign * random_octave(r, octave, octave);
            }
        }
}

/* A draw with this shader and a random texture. */
static void add_textured(builder *b, scene_shader shader, gn_format format)
{
    static const uint32_t sizes[] = {1, 1, 2, 3, 4, 5, 7, 8, 16, 20, 32, 37, 50, 64};
    random_source *r = &b->random;
    builder_common_state(b);
    b->shader = shader;
    random_light(b);
    if (random_chance(r, 65)) {
        random_camera(b);
        add_body(b);
    } else {
        const placement places[] = {PLACE_ANYWHERE, PLACE_AFFINE, PLACE_TIES, PLACE_CLIP};
        const placement place = places[random_below(r, 4)];
        shape_triangles(b, place, builder_triangle_count(b));
    }
    gn_texture *t = &b->uniforms.texture;
    t->width = sizes[random_below(r, 14)];
    t->height = random_chance(r, 40) ? t->width : sizes[random_below(r, 14)];
    t->format = random_chance(r, 70) ? GN_FORMAT_RGBA8 : GN_FORMAT_RGBA32F;
    if (format != GN_FORMAT_NONE)
        t->format = format;
    void *texels = random_texels(b, t->width * t->height, t->format);
    t->level[0].texels = texels;
    b->uniforms.sampler.wrap_s = (gn_wrap)random_below(r, 5);
    b->uniforms.sampler.wrap_t = (gn_wrap)random_below(r, 5);
    for (int c = 0; c < 4; ++c) /* not 0, like the texels */
        b->uniforms.sampler.border[c] = random_float(r, 0.25f, 1.0f);
    b->uniforms.sampler.magnify = (gn_magnify)random_below(r, 2);
    b->uniforms.sampler.minify = (gn_minify)random_below(r, 6);
    random_texcoords(b);
    if (b->scene->color_format == GN_FORMAT_RGBA8 && random_chance(r, 10))
        lay_over(b, 0);
    builder_draw(b);
    free(texels);
}

void generate_textured(builder *b)
{
    random_source *r = &b->random;
    builder_common_target(b);
    if (random_chance(r, 15))
        b->scene->color_format = GN_FORMAT_RGBA32F;
    for (uint32_t draws = 1 + random_below(r, 2); draws > 0; --draws)
        add_textured(b, SCENE_TEXTURED_GOURAUD, GN_FORMAT_NONE);
}

/* The power of 32 may be denormal, which the contract leaves out. It is added to a texel, so it
 * shows only if the texel is 0. Bytes often are 0, so a target of floats gets a texture of
 * floats. */
void generate_phong(builder *b)
{
    random_source *r = &b->random;
    builder_common_target(b);
    const bool floats = random_chance(r, 25);
    if (floats)
        b->scene->color_format = GN_FORMAT_RGBA32F;
    for (uint32_t draws = 1 + random_below(r, 2); draws > 0; --draws) {
        gn_mat4_identity(&b->view_from_model);
        b->specular.x = random_unit(r);
        b->specular.y = random_unit(r);
        b->specular.z = random_octave(r, -2, 2);
        add_textured(b, SCENE_PHONG, floats ? GN_FORMAT_RGBA32F : GN_FORMAT_NONE);
    }
}
