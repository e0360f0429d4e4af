/* Construction of the benchmark's scenes. */
#include "scenes.h"

#include <math.h>
#include <stdlib.h>

enum { SIZE = 1024, QUADS = 64 };

static scene *empty_scene(void)
{
    scene *s = scene_create(SIZE, SIZE, GN_FORMAT_RGBA8, GN_FORMAT_D24);

    s->clear_color[3] = 1.0f;
    s->clear_depth = 1.0f;
    return s;
}

static scene_draw *add_draw(scene *s, scene_shader shader)
{
    scene_draw *d = scene_add_draw(s);
    gn_transform projection;

    d->shader = shader;
    d->state.depth_test = true;
    gn_perspective_rh_no(GN_PI / 2, 1.0f, 0.5f, 200.0f, &projection);
    d->uniforms.light.clip_from_model = projection.matrix;
    return d;
}

static void add_quads(scene *s)
{
    static const float corner_color[4][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
    float position[QUADS * 4 * 3];
    float color[QUADS * 4 * 3];
    uint32_t index[QUADS * 6];

    for (uint32_t q = 0; q < QUADS; ++q) {
        const float distance = 1.0f + 100.0f * (float)(QUADS - 1 - q) / (QUADS - 1);

        for (uint32_t v = 0; v < 4; ++v) {
            float *p = &position[3 * (4 * q + v)];
            const float d = v < 2 ? distance : 1.25f * distance;

            p[0] = v & 1 ? d : -d;
            p[1] = v < 2 ? -d : d;
            p[2] = -d;
            for (int c = 0; c < 3; ++c)
                color[3 * (4 * q + v) + (uint32_t)c] = corner_color[v][c];
        }
        const uint32_t order[6] = {0, 1, 2, 2, 1, 3};
        for (int i = 0; i < 6; ++i)
            index[6 * q + (uint32_t)i] = 4 * q + order[i];
    }
    scene_draw *d = add_draw(s, SCENE_VERTEX_COLOR);
    scene_set_attribute(d, GN_ATTRIBUTE_POSITION, position, 3, QUADS * 4);
    scene_set_attribute(d, GN_ATTRIBUTE_COLOR, color, 3, QUADS * 4);
    scene_set_indices(d, index, QUADS * 6, GN_INDEX_UINT32);
    d->mesh.count = QUADS * 6;
}

/* A cube of n x n squares a face, blown up to a unit sphere, seen so that it is
 * `across` pixels wide: its outline is at the angle whose sine is 1 / distance. */
static void add_sphere(scene *s, uint32_t n, float across)
{
    static const int axes[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                   {1, 0, 2}, {2, 1, 0}, {0, 2, 1}};
    const uint32_t side = n + 1;
    const uint32_t vertices = 6 * side * side;
    const float tangent = across / SIZE;
    const float distance = sqrtf(1.0f + tangent * tangent) / tangent;
    float *normal = malloc(vertices * 3 * sizeof *normal);
    float *color = malloc(vertices * 3 * sizeof *color);
    uint32_t *index = malloc((size_t)n * n * 36 * sizeof *index);
    uint32_t v = 0, i = 0;

    for (uint32_t face = 0; face < 6; ++face) {
        const uint32_t base = v;

        for (uint32_t y = 0; y < side; ++y) {
            for (uint32_t x = 0; x < side; ++x, ++v) {
                float p[3];

                p[axes[face][0]] = 2.0f * (float)x / (float)n - 1.0f;
                p[axes[face][1]] = 2.0f * (float)y / (float)n - 1.0f;
                p[axes[face][2]] = face < 3 ? 1.0f : -1.0f;
                const float length = sqrtf(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
                for (uint32_t c = 0; c < 3; ++c) {
                    normal[3 * v + c] = p[c] / length;
                    color[3 * v + c] = 0.5f + 0.5f * p[c] / length;
                }
            }
        }
        for (uint32_t y = 0; y < n; ++y) {
            for (uint32_t x = 0; x < n; ++x) {
                const uint32_t a = base + y * side + x;
                const uint32_t square[6] = {a, a + 1, a + side, a + side, a + 1, a + side + 1};
                for (int k = 0; k < 6; ++k)
                    index[i++] = square[k];
            }
        }
    }

    scene_draw *d = add_draw(s, SCENE_GOURAUD);
    gn_transform back;
    const gn_vec3 light = {0.0f, 0.6f, 0.8f};
    gn_translate((gn_vec3){0.0f, 0.0f, -distance}, &back);
    gn_mat4_multiply(&d->uniforms.light.clip_from_model, &back.matrix,
                     &d->uniforms.light.clip_from_model);
    d->uniforms.light.light_direction = light;
    d->uniforms.light.ambient = (gn_vec3){0.2f, 0.2f, 0.2f};
    d->uniforms.light.diffuse = (gn_vec3){0.8f, 0.8f, 0.8f};
    d->state.cull = GN_CULL_BACK;
    scene_set_attribute(d, GN_ATTRIBUTE_POSITION, normal, 3, vertices);
    scene_set_attribute(d, GN_ATTRIBUTE_NORMAL, normal, 3, vertices);
    scene_set_attribute(d, GN_ATTRIBUTE_COLOR, color, 3, vertices);
    scene_set_indices(d, index, i, GN_INDEX_UINT32);
    d->mesh.count = i;
    free(normal);
    free(color);
    free(index);
}

const char *bench_scene_name(int index)
{
    static const char *const names[BENCH_SCENE_COUNT] = {"S1", "S3", "S5", "S6"};

    return names[index];
}

scene *bench_scene(int index)
{
    scene *s = empty_scene();

    switch (index) {
    case 0:
        add_quads(s);
        break;
    case 1:
        add_sphere(s, 129, 820.0f);
        break;
    case 2:
        add_sphere(s, 289, 564.0f);
        break;
    default:
        break;
    }
    return s;
}
