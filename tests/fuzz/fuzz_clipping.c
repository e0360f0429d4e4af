/* Primitives with vertices anywhere in clip space, infinities and NaN included, against the view
 * volume and clip distances: what is inside is not clipped, what is outside draws nothing, and a
 * clip distance that nothing is behind changes nothing. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"

enum { WIDTH = 40, HEIGHT = 24, VERTICES = 4, DISTANCES = 2 };

typedef struct clipped {
    float position[VERTICES][4];
    float distance[VERTICES][DISTANCES];
    uint32_t distances, idle; /* idle ones are 1 at every vertex */
} clipped;

static void shade_vertices(const void *uniforms, const gn_vertex_input *input,
                           gn_vertex_output *output)
{
    const clipped *const c = uniforms;

    for (int i = 0; i < 4; ++i) {
        memcpy(output->position[i], input->attribute[0][i], sizeof output->position[i]);
        memcpy(output->varying[i], input->attribute[0][3 - i], sizeof output->varying[i]);
    }
    for (uint32_t d = 0; d < c->distances + c->idle; ++d)
        for (int l = 0; l < GN_LANES; ++l)
            output->clip_distance[d][l] =
                d < c->distances ? input->attribute[1][d][l] : 1.0f + (float)d;
}

static void shade_fragments(const void *uniforms, const gn_fragment_input *input,
                            gn_fragment_output *output)
{
    (void)uniforms;
    for (int i = 0; i < 4; ++i)
        memcpy(output->color[i], input->varying[i], sizeof output->color[i]);
}

typedef struct picture {
    float color[WIDTH * HEIGHT][4];
    float depth[WIDTH * HEIGHT];
    gn_draw_statistics counts;
} picture;

static void draw(const gn_pipeline *state, clipped *c, gn_backend backend, picture *result)
{
    static unsigned char memory[GN_WORKSPACE_SIZE(16, 4 + GN_MAX_CLIP_DISTANCES)];
    gn_pipeline pipeline = *state;
    const gn_target target = {
        {gn_surface_bottom_up(result->color, GN_FORMAT_RGBA32F, WIDTH, HEIGHT)},
        gn_surface_bottom_up(result->depth, GN_FORMAT_D32F, WIDTH, HEIGHT)};
    const gn_mesh mesh = {
        .attribute = {{&c->position[0][0], 4, 0, 0}, {&c->distance[0][0], DISTANCES, 0, 0}},
        .vertex_count = VERTICES,
        .count = VERTICES};
    gn_workspace workspace = {
        .memory = memory, .size = sizeof memory, .backend = backend, .statistics = &result->counts};

    memset(result, 0, sizeof *result);
    pipeline.program.vertex_shader = shade_vertices;
    pipeline.program.fragment_shader = shade_fragments;
    pipeline.program.uniforms = c;
    pipeline.program.varying_count = 4;
    pipeline.program.clip_distance_count = c->distances + c->idle;
    FUZZ_REQUIRE(gn_clear_depth(&target.depth, 0.5f) == GN_OK);
    FUZZ_REQUIRE(gn_draw(&target, &pipeline, &mesh, &workspace) == GN_OK);
}

/* Whether a vertex is well inside the volume. */
static bool is_inside(const float p[4], bool zero_to_one, bool clamps)
{
    const bool near = clamps || p[2] >= (zero_to_one ? 0.0f : -p[3]);

    return p[3] > 0.0f && isfinite(p[3]) && fabsf(p[0]) <= p[3] && fabsf(p[1]) <= p[3] && near &&
           (clamps || p[2] <= p[3]);
}

/* Whether both planes of an axis have every vertex on one's wrong side. */
static bool is_beside(const clipped *c, int axis, float sign)
{
    for (int i = 0; i < VERTICES; ++i)
        if (!(sign * c->position[i][axis] > c->position[i][3]))
            return false;
    return true;
}

static void require_sense(const gn_pipeline *state, const clipped *c, const picture *p)
{
    const gn_draw_statistics *const n = &p->counts;
    const bool zero_to_one = state->depth.clip_depth == GN_ZERO_TO_ONE;
    bool inside = c->distances == 0;
    bool drawn = false;

    for (int i = 0; i < VERTICES; ++i)
        inside = inside && is_inside(c->position[i], zero_to_one, state->depth.clamp_enabled);
    FUZZ_REQUIRE(n->primitives ==
                 n->not_finite + n->outside + n->without_area + n->culled + n->missed + n->drawn);
    FUZZ_REQUIRE(!inside || (n->outside == 0 && n->clipped == 0));
    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
        drawn = drawn || p->depth[i] != 0.5f;
        FUZZ_REQUIRE(p->depth[i] >= 0.0f && p->depth[i] <= 1.0f);
    }
    FUZZ_REQUIRE(!drawn || n->drawn > 0);
    for (int axis = 0; axis < 2; ++axis)
        if (is_beside(c, axis, 1.0f) || is_beside(c, axis, -1.0f))
            FUZZ_REQUIRE(n->drawn == 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    fuzz_input in = fuzz_begin(bytes, size);
    static clipped c;
    static picture expected, other;
    const uint8_t kind = fuzz_byte(&in), more = fuzz_byte(&in);
    gn_pipeline state = {.depth = {.test_enabled = true, .function = GN_ALWAYS}};

    memset(&c, 0, sizeof c);
    state.raster.topology = (gn_topology)(kind % 7);
    state.raster.polygon_mode_front = (gn_polygon_mode)((kind >> 3 & 3) % 3);
    state.raster.polygon_mode_back = (gn_polygon_mode)((kind >> 5 & 3) % 3);
    state.raster.line_width = state.raster.point_size = (float)(more >> 5);
    state.depth.clip_depth = more & 1 ? GN_ZERO_TO_ONE : GN_NEGATIVE_ONE_TO_ONE;
    state.depth.clamp_enabled = more & 2;
    c.distances = (more >> 2 & 3) % 3;
    for (int i = 0; i < VERTICES; ++i) {
        for (int k = 0; k < 4; ++k)
            c.position[i][k] = more & 16 ? fuzz_float(&in) : fuzz_tame(&in);
        for (uint32_t d = 0; d < c.distances; ++d)
            c.distance[i][d] = fuzz_tame(&in);
    }
    draw(&state, &c, GN_BACKEND_PORTABLE, &expected);
    require_sense(&state, &c, &expected);
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
        if (!gn_backend_available((gn_backend)b))
            continue;
        c.idle = kind >> 7 && b == GN_BACKEND_PORTABLE ? 1 + more % 4 : 0;
        draw(&state, &c, (gn_backend)b, &other);
        FUZZ_REQUIRE(!memcmp(&expected, &other, sizeof other));
    }
    return 0;
}
