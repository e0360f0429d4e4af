/* Checks lesson 12, whose shader the reference cannot draw: every pixel's colour is decided again,
 * in plain C, from the normal that the ready-made shader of normals draws there. Runs the lesson
 * with its own colours and with random ones. usage: check-toon MODEL.obj PICTURE.tga SEED */
#include <gnomon.h>

static gn_status checked_draw(const gn_target *target, const gn_pipeline *pipeline,
                              const gn_mesh *mesh, gn_workspace *workspace);

#define main toon_main
#define gn_draw checked_draw
#include "../../tools/examples/12_toon.c"
#undef gn_draw
#undef main

#include <math.h>

/* A brightness this near to a threshold may be on either side: normals are rounded to colours. Both
 * shaders interpolate the same bits, so that even in thin triangles no more than this is lost. */
#define NEAR 1e-6

static float normals[WIDTH * HEIGHT][4];
static uint32_t normal_depth[WIDTH * HEIGHT];
static unsigned char normal_memory[GN_WORKSPACE_SIZE(0, GN_SHADER_VARYINGS)];
static unsigned long pixels, undecided, wrong;
static unsigned long in_band[MOST_BANDS];

static uint32_t packed(gn_vec4 c)
{
    const float channel[4] = {c.x, c.y, c.z, c.w};
    uint32_t result = 0;

    for (int i = 0; i < 4; ++i)
        result |= (uint32_t)(channel[i] * 255.0f + 0.5f) << (8 * i);
    return result;
}

static int band_of(const toon_uniforms *u, double brightness)
{
    int band = 0;

    for (int i = 1; i < u->bands; ++i)
        band = brightness >= (double)u->threshold[i] ? i : band;
    return band;
}

static void draw_normals(const toon_uniforms *u, const gn_mesh *mesh)
{
    gn_target target = {{gn_surface_bottom_up(normals, GN_FORMAT_RGBA32F, WIDTH, HEIGHT)},
                        gn_surface_bottom_up(normal_depth, GN_FORMAT_D24, WIDTH, HEIGHT)};
    gn_lit_uniforms lit = {.clip_from_model = u->clip_from_model,
                           .normal_matrix = u->normal_matrix};
    gn_pipeline pipeline = {.depth.test_enabled = true};
    gn_workspace workspace = {.memory = normal_memory, .size = sizeof normal_memory};

    gn_clear_color(&target.color[0], 0, 0, 0, 0);
    gn_clear_depth(&target.depth, 1);
    lesson_check(gn_use_normal_color(&pipeline, &lit));
    lesson_check(gn_draw(&target, &pipeline, mesh, &workspace));
}

static gn_status checked_draw(const gn_target *target, const gn_pipeline *pipeline,
                              const gn_mesh *mesh, gn_workspace *workspace)
{
    const toon_uniforms *u = pipeline->program.uniforms;
    const gn_status status = gn_draw(target, pipeline, mesh, workspace);

    draw_normals(u, mesh);
    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
        const float *n = normals[i];
        const double brightness = (2.0 * (double)n[0] - 1) * (double)u->to_light.x +
                                  (2.0 * (double)n[1] - 1) * (double)u->to_light.y +
                                  (2.0 * (double)n[2] - 1) * (double)u->to_light.z;
        const int low = band_of(u, brightness - NEAR), high = band_of(u, brightness + NEAR);

        if (n[3] == 0) {
            wrong += color[i] != 0xFFFFFFFFu;
            continue;
        }
        ++pixels;
        ++in_band[low];
        undecided += low != high;
        wrong += color[i] != packed(u->color[low]) && color[i] != packed(u->color[high]);
    }
    return status;
}

static uint32_t next_random(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return *state >> 8;
}

/* Colours differ in all pairs; thresholds grow. */
static void run_random(const char *model, const char *picture, uint32_t *state)
{
    char words[2 * MOST_BANDS + 2][32];
    char *arguments[2 * MOST_BANDS + 3] = {(char *)"toon", (char *)model, (char *)picture};
    const int bands = 1 + (int)(next_random(state) % MOST_BANDS);
    double threshold = 0;

    for (int i = 0; i < 2 * bands - 1; ++i) {
        if (i % 2 == 0) {
            snprintf(words[i], sizeof words[i], "%02x%04x", i * 16 + 1,
                     next_random(state) & 0xFFFF);
        } else {
            threshold += (1 - threshold) * (double)(next_random(state) % 1000) / 2000;
            snprintf(words[i], sizeof words[i], "%.6f", threshold);
        }
        arguments[3 + i] = words[i];
    }
    if (toon_main(3 + 2 * bands - 1, arguments) != 0)
        wrong += 1;
}

int main(int argc, char **argv)
{
    char *own[] = {(char *)"toon", argv[1], argv[2], NULL};
    unsigned long used = 0;

    if (argc != 4)
        return 2;
    wrong += toon_main(3, own) != 0;
    for (int i = 0; i < MOST_BANDS; ++i)
        used += in_band[i] > 0;
    wrong += used != 4; /* the lesson's own colours are all seen */
    uint32_t state = (uint32_t)strtoul(argv[3], NULL, 10);
    for (int i = 0; i < 20; ++i)
        run_random(argv[1], argv[2], &state);
    printf("toon: %lu pixels decided again (seed %s), %lu too near to a threshold to tell, %lu "
           "wrong\n",
           pixels, argv[3], undecided, wrong);
    return wrong > 0 || undecided > pixels / 1000;
}
