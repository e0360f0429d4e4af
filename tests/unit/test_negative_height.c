/* Viewports of negative height: the picture is that of a positive height whose shader has negated
 * y, with every back end, but for horizontal edges on centres of pixels, which no triangle here
 * has. */
#include "unit.h"

#include <string.h>

enum { WIDTH = 37, HEIGHT = 29, VERTICES = 9 };

typedef struct mirror {
    float sign; /* of y */
} mirror;

static void place(const void *uniforms, const gn_vertex_input *input, gn_vertex_output *output)
{
    const mirror *const m = uniforms;

    for (int l = 0; l < GN_LANES; ++l) {
        output->position[0][l] = input->attribute[0][0][l];
        output->position[1][l] = m->sign * input->attribute[0][1][l];
        output->position[2][l] = input->attribute[0][2][l];
        output->position[3][l] = input->attribute[0][3][l];
        for (int c = 0; c < 4; ++c)
            output->varying[c][l] = input->attribute[0][c][l];
    }
}

static void paint(const void *uniforms, const gn_fragment_input *input, gn_fragment_output *output)
{
    memcpy(output->color, input->varying, sizeof(float[4][GN_LANES]));
}

/* No vertex lies beyond two sides at a time, since clipping takes the sides of y in another order.
 */
static const float vertices[VERTICES][4] = {
    {-0.9f, -0.7f, 0.1f, 1.0f},  {0.8f, -0.5f, 0.6f, 1.2f},  {0.1f, 0.9f, -0.3f, 1.0f},
    {-1.4f, -0.2f, -0.5f, 1.0f}, {0.7f, 0.3f, 0.2f, 0.9f},   {-0.2f, 0.6f, 0.4f, 1.1f},
    {0.3f, -1.7f, 0.0f, 1.0f},   {0.9f, -0.1f, -0.6f, 1.0f}, {0.2f, -0.3f, 0.8f, 1.3f}};

static void draw(gn_backend backend, float height, float pixels[HEIGHT][WIDTH][4])
{
    static unsigned char memory[GN_WORKSPACE_SIZE(VERTICES, 4)];
    static uint32_t depth[HEIGHT][WIDTH];
    const mirror m = {height < 0.0f ? 1.0f : -1.0f};
    const gn_target target = {
        .color = {gn_surface_bottom_up(pixels, GN_FORMAT_RGBA32F, WIDTH, HEIGHT)},
        .depth = gn_surface_bottom_up(depth, GN_FORMAT_D24, WIDTH, HEIGHT)};
    const gn_mesh mesh = {.attribute = {{.data = vertices[0], .components = 4}},
                          .vertex_count = VERTICES,
                          .count = VERTICES};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory, .backend = backend};
    gn_pipeline pipeline = {.program = {.vertex_shader = place,
                                        .fragment_shader = paint,
                                        .uniforms = &m,
                                        .varying_count = 4},
                            .raster = {.cull = GN_CULL_FRONT,
                                       .viewport = {.enabled = true,
                                                    .x = 2,
                                                    .y = height < 0.0f ? 1 - height : 1,
                                                    .width = WIDTH - 3,
                                                    .height = height}},
                            .depth = {.test_enabled = true}};

    assert_int_equal(gn_clear_color(&target.color[0], 0, 0, 0, 0), GN_OK);
    assert_int_equal(gn_clear_depth(&target.depth, 1.0f), GN_OK);
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
}

static void test_equals_negated_y(void **state)
{
    static float up[HEIGHT][WIDTH][4], down[HEIGHT][WIDTH][4], none[HEIGHT][WIDTH][4];

    for (gn_backend b = GN_BACKEND_AUTO; b < GN_BACKEND_COUNT; b = next_backend(b)) {
        draw(b, HEIGHT - 2, up);
        draw(b, -(HEIGHT - 2), down);
        assert_memory_equal(up, down, sizeof up);
        assert_memory_not_equal(up, none, sizeof up);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_equals_negated_y)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
