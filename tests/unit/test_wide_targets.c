/* Wide and tall targets, many indices, many threads: what a draw does in long runs of pixels equals
 * what it does in short ones. The runs of a draw end at the sides of the scissor, so narrow
 * scissors side by side must draw what one draw without scissor draws. */
#include <stdlib.h>
#include <string.h>

#include "backwards.h"
#include "noise.h"
#include "unit.h"

enum { WIDTH = 400, HEIGHT = 5, STRIP = 80, TRIANGLES = 4, VARYINGS = 4, TALL = 600 };

typedef struct frame {
    unsigned char color[WIDTH * HEIGHT * 16 * GN_SAMPLES];
    unsigned char depth[WIDTH * HEIGHT * 8 * GN_SAMPLES];
} frame;

static frame whole, strips, first;
static float position[3 * TRIANGLES][3], color[3 * TRIANGLES][4];
static gn_color_uniforms uniforms;
static unsigned char memory[GN_WORKSPACE_SIZE(64, VARYINGS)];

/* Triangles over most of the target, one behind the other, of equal and of different colours. */
static void make_triangles(uint32_t seed)
{
    for (int i = 0; i < 3 * TRIANGLES; ++i) {
        position[i][0] = (i % 3 == 1 ? 1.5f : -1.2f) + noise(&seed);
        position[i][1] = (i % 3 == 2 ? 4.0f : -2.5f) + noise(&seed);
        position[i][2] = 1.6f * noise(&seed) - 0.8f;
        for (int c = 0; c < 4; ++c)
            color[i][c] = i / 3 % 3 == 0 ? (float)(i / 3 + c) / 16.0f : noise(&seed);
    }
}

static void shade_with_everything(const void *none, const gn_fragment_input *input,
                                  gn_fragment_output *output)
{
    for (int c = 0; c < 4; ++c)
        for (int l = 0; l < GN_LANES; ++l) {
            output->color[c][l] = input->varying[c][l] + input->position[2][l] * 0.125f;
            if (c == 3 && (int)input->position[0][l] % 5 == 0)
                output->kept &= ~(1u << l);
        }
}

static gn_target target_on(frame *f, gn_format color_format, gn_format depth_format, bool sampled)
{
    gn_target target;

    memset(f, 0, sizeof *f);
    memset(&target, 0, sizeof target);
    if (color_format != GN_FORMAT_NONE) {
        target.color[0] = gn_surface_bottom_up(f->color, color_format, WIDTH, HEIGHT);
        if (sampled)
            target.color[0] = gn_surface_multisampled(&target.color[0]);
        assert_int_equal(gn_clear_color(&target.color[0], 0.25f, 0.5f, 0.75f, 0.5f), GN_OK);
    }
    if (depth_format != GN_FORMAT_NONE) {
        target.depth = gn_surface_bottom_up(f->depth, depth_format, WIDTH, HEIGHT);
        if (sampled)
            target.depth = gn_surface_multisampled(&target.depth);
        assert_int_equal(gn_clear_depth_stencil(&target.depth, 0.75f, 3), GN_OK);
    }
    return target;
}

static gn_mesh triangles(void)
{
    gn_mesh mesh = {.vertex_count = 3 * TRIANGLES, .count = 3 * TRIANGLES};

    mesh.attribute[GN_ATTRIBUTE_POSITION] = (gn_attribute){.data = position[0], .components = 3};
    mesh.attribute[GN_ATTRIBUTE_COLOR] = (gn_attribute){.data = color[0], .components = 4};
    return mesh;
}

/* Draws on both frames and compares. Draws in three back ends' forms: the best, the portable one,
 * and the one that counts. */
static void compare(gn_pipeline *pipeline, gn_format color_format, gn_format depth_format,
                    bool sampled)
{
    for (int way = 0; way < 3; ++way) {
        uint64_t passed[2] = {0, 0};
        gn_workspace workspace = {.memory = memory, .size = sizeof memory};
        const gn_mesh mesh = triangles();
        gn_target target = target_on(&whole, color_format, depth_format, sampled);

        workspace.backend = way == 1 ? GN_BACKEND_PORTABLE : gn_backend_best();
        workspace.samples_passed = way == 2 ? &passed[0] : NULL;
        pipeline->raster.scissor.enabled = false;
        assert_int_equal(gn_draw(&target, pipeline, &mesh, &workspace), GN_OK);

        target = target_on(&strips, color_format, depth_format, sampled);
        workspace.samples_passed = way == 2 ? &passed[1] : NULL;
        pipeline->raster.scissor.enabled = true;
        pipeline->raster.scissor.y = 0;
        pipeline->raster.scissor.width = STRIP;
        pipeline->raster.scissor.height = HEIGHT;
        for (int32_t x = 0; x < WIDTH; x += STRIP) {
            pipeline->raster.scissor.x = x;
            assert_int_equal(gn_draw(&target, pipeline, &mesh, &workspace), GN_OK);
        }
        assert_memory_equal(&whole, &strips, sizeof whole);
        assert_int_equal(passed[0], passed[1]);
        if (way == 0)
            first = whole;
        assert_memory_equal(&whole, &first, sizeof whole);
    }
}

static gn_pipeline plain(void)
{
    gn_pipeline p;

    memset(&p, 0, sizeof p);
    gn_mat4_identity(&uniforms.clip_from_model);
    assert_int_equal(gn_use_vertex_color(&p, &uniforms), GN_OK);
    return p;
}

static void runs_in_every_state(void **state)
{
    static const gn_format colors[] = {GN_FORMAT_RGBA8,   GN_FORMAT_BGRA8,   GN_FORMAT_RGB565,
                                       GN_FORMAT_RGBA16F, GN_FORMAT_RGBA32F, GN_FORMAT_NONE};
    static const gn_format depths[] = {GN_FORMAT_D24S8, GN_FORMAT_D16, GN_FORMAT_D32F};
    enum { KINDS = 9 };

    make_triangles(5);
    for (size_t i = 0; i < 2 * COUNT(colors) * KINDS; ++i) {
        const size_t kind = i / 2 % KINDS, f = i / 2 / KINDS;
        gn_pipeline p = plain();

        p.depth.test_enabled = kind != 1;
        p.color.blend[0].enabled = kind == 2 || kind == 6;
        p.color.blend[0].source = GN_FACTOR_SOURCE_ALPHA;
        p.color.blend[0].destination = GN_FACTOR_ONE_MINUS_SOURCE_ALPHA;
        p.color.logic_enabled = kind == 3;
        p.color.logic_operation = GN_LOGIC_XOR;
        p.stencil.test_enabled = kind == 4;
        p.stencil.front.function = p.stencil.back.function = GN_LESS_OR_EQUAL;
        p.stencil.front.reference = p.stencil.back.reference = 3;
        p.stencil.front.pass = GN_STENCIL_INCREMENT;
        p.stencil.back.depth_fail = GN_STENCIL_INVERT;
        p.samples.alpha_to_coverage_enabled = p.samples.alpha_to_one_enabled = kind == 5;
        if (kind >= 6 && colors[f] != GN_FORMAT_NONE) {
            p.program.fragment_shader = shade_with_everything;
            p.program.fragment_reads_position = true;
            p.program.fragment_discards = kind == 7;
        }
        if (kind == 8) {
            p.depth.clamp_enabled = true;
            p.depth.range.enabled = true;
            p.depth.range.z_far = 0.5f;
            p.color.write_disabled[0] = GN_CHANNEL_GREEN;
        }
        compare(&p, colors[f], depths[(f + kind) % 3], i % 2);
    }
}

/* Nothing of the source is in the result, or nothing at all is written. */
static void blends_without_a_source(void **state)
{
    static const gn_blend_factor factors[] = {
        GN_FACTOR_ZERO,         GN_FACTOR_ONE,          GN_FACTOR_DESTINATION_COLOR,
        GN_FACTOR_SOURCE_COLOR, GN_FACTOR_SOURCE_ALPHA, GN_FACTOR_CONSTANT_ALPHA};

    make_triangles(6);
    for (size_t source = 0; source < 6; ++source)
        for (size_t destination = 0; destination < 6; ++destination) {
            gn_pipeline p = plain();

            p.color.blend[0].enabled = true;
            p.color.blend[0].source = factors[source];
            p.color.blend[0].destination = factors[destination];
            p.color.blend_constant[3] = 0.5f;
            compare(&p, GN_FORMAT_RGBA8, GN_FORMAT_NONE, false);
            compare(&p, GN_FORMAT_RGBA16, GN_FORMAT_NONE, false);
            p.color.blend[0].alpha_source = factors[destination];
            p.color.blend[0].alpha_destination = GN_FACTOR_ONE_MINUS_SOURCE_ALPHA;
            compare(&p, GN_FORMAT_RGBA16, GN_FORMAT_NONE, false);
        }
}

/* Draws many small triangles over a tall target. */
static void draw_tall(uint32_t *pixels, gn_workspace *workspace, const uint32_t *indices,
                      uint32_t count)
{
    gn_pipeline p = plain();
    gn_target target;
    gn_mesh mesh = triangles();

    mesh.count = count;
    mesh.indices = indices;
    mesh.index_format = GN_INDEX_UINT32;
    memset(&target, 0, sizeof target);
    target.color[0] = gn_surface_bottom_up(pixels, GN_FORMAT_RGBA8, 3, TALL);
    p.color.blend[0].enabled = true;
    p.color.blend[0].source = GN_FACTOR_SOURCE_ALPHA;
    p.color.blend[0].destination = GN_FACTOR_ONE_MINUS_SOURCE_ALPHA;
    assert_int_equal(gn_clear_color(&target.color[0], 0, 0, 0, 0), GN_OK);
    assert_int_equal(gn_draw(&target, &p, &mesh, workspace), GN_OK);
}

/* More indices than the parts of a draw hold, more triangles than a round, and any number of
 * threads. */
static void many_indices_and_threads(void **state)
{
    static const uint32_t threads[] = {0, 1, 2, 9, 21, 64, 65, 80, 81, 1000, UINT32_MAX};
    static const uint32_t counts[] = {3000, 600000};
    uint32_t *const indices = malloc(counts[1] * sizeof *indices);
    static uint32_t one[3 * TALL], other[3 * TALL];
    const size_t size = gn_workspace_size_parallel(3 * TRIANGLES, counts[1] / 3, VARYINGS);
    gn_workspace workspace = {.memory = malloc(size), .size = size};
    uint32_t seed = 8;

    assert_true(indices && workspace.memory);
    make_triangles(8);
    for (int i = 0; i < 3 * TRIANGLES; ++i)
        position[i][1] = 2.0f * noise(&seed) - 1.0f;
    for (size_t n = 0; n < 2; ++n) {
        /* Most triangles have no area: their corners are one vertex. */
        for (uint32_t i = 0; i < counts[n]; ++i)
            indices[i] = i / 3 % (n ? 6000 : 20) == 7 ? i % 3 + 3 * (i / 60 % TRIANGLES) : 1;
        workspace.parallel = NULL;
        draw_tall(one, &workspace, indices, counts[n]);
        workspace.parallel = run_backwards;
        for (size_t t = n ? 2 : 0; t < (n ? 3 : COUNT(threads)); ++t) {
            workspace.threads = threads[t];
            draw_tall(other, &workspace, indices, counts[n]);
            assert_memory_equal(one, other, sizeof one);
        }
    }
    free(indices);
    free(workspace.memory);
}

static void workspaces_of_any_size(void **state)
{
    const uint32_t most = GN_MAX_VARYINGS + GN_MAX_CLIP_DISTANCES;

    assert_true(gn_workspace_size_parallel(3, 1, most + 1) == SIZE_MAX);
    assert_true(gn_workspace_size(3, most + 1) == SIZE_MAX);
    assert_true(gn_workspace_size(3, most) < SIZE_MAX);
    /* Rounds do not grow without end. */
    assert_true(gn_workspace_size_parallel(3, 100000, 4) ==
                gn_workspace_size_parallel(3, UINT32_MAX, 4));
    assert_true(gn_workspace_size_parallel(3, 1000, 4) < gn_workspace_size_parallel(3, 50000, 4));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(runs_in_every_state),
        cmocka_unit_test(blends_without_a_source),
        cmocka_unit_test(many_indices_and_threads),
        cmocka_unit_test(workspaces_of_any_size),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
