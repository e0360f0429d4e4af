/* Formats that hold depth and stencil keep every bit of depth that the formats of depth alone keep:
 * the same triangles leave the same depths, whatever stencil does beside them. */
#include <string.h>

#include "unit.h"

enum { SIZE = 33, TRIANGLES = 12 };

static float position[3 * TRIANGLES][3];
static uint32_t plain[SIZE * SIZE], both[2 * SIZE * SIZE];
static gn_color_uniforms uniforms;

static float noise(uint32_t *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (float)(*seed >> 8) / 16777216.0f;
}

static uint64_t draw(void *memory, gn_format format, gn_compare function, bool stencil)
{
    static unsigned char scratch[GN_WORKSPACE_SIZE(64, 8)];
    uint64_t passed = 0;
    gn_workspace workspace = {.memory = scratch, .size = sizeof scratch, .samples_passed = &passed};
    gn_mesh mesh = {.vertex_count = 3 * TRIANGLES, .count = 3 * TRIANGLES};
    gn_target target;
    gn_pipeline p;

    memset(&target, 0, sizeof target);
    memset(&p, 0, sizeof p);
    target.depth = gn_surface_bottom_up(memory, format, SIZE, SIZE);
    assert_int_equal(gn_clear_depth(&target.depth, 0.7f), GN_OK);
    mesh.attribute[GN_ATTRIBUTE_POSITION] = (gn_attribute){.data = position[0], .components = 3};
    gn_mat4_identity(&uniforms.clip_from_model);
    assert_int_equal(gn_use_depth_only(&p, &uniforms), GN_OK);
    p.depth.test = true;
    p.depth.function = function;
    p.stencil.test = stencil;
    p.stencil.front.pass = p.stencil.back.depth_fail = GN_STENCIL_INVERT;
    p.stencil.front.depth_fail = GN_STENCIL_INCREMENT;
    assert_int_equal(gn_draw(&target, &p, &mesh, &workspace), GN_OK);
    return passed;
}

static void depths_do_not_depend_on_stencil(void **state)
{
    uint32_t seed = 4;

    (void)state;
    for (int i = 0; i < 3 * TRIANGLES; ++i)
        for (int c = 0; c < 3; ++c)
            position[i][c] = (c < 2 ? 3.0f : 1.9f) * (noise(&seed) - 0.5f);
    for (int f = GN_COMPARE_DEFAULT; f <= GN_ALWAYS; ++f)
        for (int stencil = 0; stencil < 2; ++stencil) {
            uint64_t passed;

            memset(both, 0, sizeof both);
            memset(plain, 0, sizeof plain);
            passed = draw(plain, GN_FORMAT_D32F, (gn_compare)f, false);
            assert_int_equal(draw(both, GN_FORMAT_D32FS8, (gn_compare)f, stencil), passed);
            for (int i = 0; i < SIZE * SIZE; ++i) {
                assert_int_equal(both[2 * i], plain[i]);
                assert_int_equal(both[2 * i + 1] & ~255u, 0);
            }
            passed = draw(plain, GN_FORMAT_D24, (gn_compare)f, false);
            assert_int_equal(draw(both, GN_FORMAT_D24S8, (gn_compare)f, stencil), passed);
            for (int i = 0; i < SIZE * SIZE; ++i)
                assert_int_equal(both[i] & 0xFFFFFF, plain[i]);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(depths_do_not_depend_on_stencil)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
