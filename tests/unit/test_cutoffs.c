/* Alpha cut-offs in draws: fragments below the cut-off leave neither colour nor depth and are not
 * counted, on every back end. */
#include "canvas.h"

/* Alpha rises along x from 0 to 1, so at the centres of columns 3 and 4 it is 3.5 / 8 and
 * 4.5 / 8. The square lies at the depth 0.5. */
static const float fading[16] = {1, 1, 1, 0, 1, 1, 1, 1, 1, 1, 1, 0, 1, 1, 1, 1};

/* 0.5 * (2^24 - 1), rounded to even. */
#define HALF_DEPTH 0x800000u
#define FARTHEST 0xFFFFFFu

static gn_unlit_uniforms unlit;
static gn_lit_uniforms lit;
static gn_metallic_roughness_uniforms metallic;

static gn_status use_unlit(gn_pipeline *p)
{
    return gn_use_unlit(p, &unlit);
}

static gn_status use_gouraud(gn_pipeline *p)
{
    return gn_use_gouraud(p, &lit);
}

static gn_status use_flat(gn_pipeline *p)
{
    return gn_use_flat(p, &lit);
}

static gn_status use_toon(gn_pipeline *p)
{
    return gn_use_toon(p, &lit);
}

static gn_status use_phong(gn_pipeline *p)
{
    return gn_use_phong(p, &lit);
}

static gn_status use_blinn_phong(gn_pipeline *p)
{
    return gn_use_blinn_phong(p, &lit);
}

static gn_status use_metallic_roughness(gn_pipeline *p)
{
    return gn_use_metallic_roughness(p, &metallic);
}

typedef gn_status use_function(gn_pipeline *p);

static use_function *const uses[] = {
    use_unlit, use_gouraud, use_flat, use_toon, use_phong, use_blinn_phong, use_metallic_roughness};

enum { USES = sizeof uses / sizeof *uses };

static void set_cutoff(float cutoff)
{
    unlit.alpha_cutoff = lit.material.alpha_cutoff = metallic.material.alpha_cutoff = cutoff;
}

/* Draws the square; columns from `first` on must be drawn. */
static void assert_columns(use_function *use, gn_backend backend, bool has_color, int first)
{
    uint64_t passed = 0;

    reset(square, 4, GN_TRIANGLE_STRIP);
    c.mesh.attribute[GN_ATTRIBUTE_COLOR].data = fading;
    c.workspace.backend = backend;
    c.workspace.samples_passed = &passed;
    c.pipeline.depth.test = true;
    if (!has_color)
        memset(&c.target.color[0], 0, sizeof c.target.color[0]);
    assert_int_equal(use(&c.pipeline), GN_OK);
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(passed, SIZE * (SIZE - first));
    for (int i = 0; i < SIZE * SIZE; ++i) {
        const bool drawn = i % SIZE >= first;

        assert_int_equal(c.depth[i], drawn ? HALF_DEPTH : FARTHEST);
        assert_int_equal(c.color[i] != 0, drawn && has_color);
    }
}

static void transparent_columns_are_discarded(void **state)
{
    (void)state;
    for (int b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; ++b) {
        for (int i = 0; gn_backend_available((gn_backend)b) && i < 2 * USES; ++i) {
            memset(&unlit, 0, sizeof unlit);
            memset(&lit, 0, sizeof lit);
            gn_mat4_identity(&unlit.clip_from_model);
            gn_mat4_identity(&lit.clip_from_model);
            gn_mat4_identity(&lit.world_from_model);
            memset(&metallic, 0, sizeof metallic);
            gn_mat4_identity(&metallic.clip_from_model);
            gn_mat4_identity(&metallic.world_from_model);
            metallic.light.ambient = (gn_vec3){1.0f, 1.0f, 1.0f};
            lit.light.ambient = (gn_vec3){1.0f, 1.0f, 1.0f};
            assert_columns(uses[i / 2], (gn_backend)b, i % 2, 0);
            set_cutoff(0.5f);
            assert_columns(uses[i / 2], (gn_backend)b, i % 2, 4);
            set_cutoff(2.0f);
            assert_columns(uses[i / 2], (gn_backend)b, i % 2, SIZE);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(transparent_columns_are_discarded),
    };
    return cmocka_run_group_tests_name("alpha cut-offs", tests, NULL, NULL);
}
