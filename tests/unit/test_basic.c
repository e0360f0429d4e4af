/* A library compiled with GN_BASIC refuses by status what it lacks, and then writes nothing: it
 * neither leaves a feature out nor does something else instead. In every other library the same
 * calls succeed. */
#include <string.h>

#include "unit.h"

#if defined(GN_BASIC)
#define LACKED GN_NOT_COMPILED
#else
#define LACKED GN_OK
#endif

enum { SIDE = 2, BYTES = 16 * SIDE * SIDE };

/* The pixels are 1/4, 1/2, 3/4, 1 in RGBA8. */
static gn_surface source(uint32_t pixels[SIDE * SIDE])
{
    const gn_surface s = gn_surface_bottom_up(pixels, GN_FORMAT_RGBA8, SIDE, SIDE);

    assert_int_equal(gn_clear_color(&s, 0.25f, 0.5f, 0.75f, 1.0f), GN_OK);
    return s;
}

static bool is_basic(gn_format format)
{
    return format == GN_FORMAT_RGBA8 || format == GN_FORMAT_RGBA32F;
}

static void blits_convert_or_are_refused(void **state)
{
    uint32_t from[SIDE * SIDE];
    float to[BYTES / sizeof(float)], cleared[BYTES / sizeof(float)];
    const gn_surface s = source(from);

    (void)state;
    for (int f = GN_FORMAT_NONE + 1; f <= GN_FORMAT_R11F_G11F_B10F; ++f) {
        const gn_surface d = gn_surface_bottom_up(to, (gn_format)f, SIDE, SIDE);
        const gn_surface expected = gn_surface_bottom_up(cleared, (gn_format)f, SIDE, SIDE);

        memset(to, 0, sizeof to);
        memset(cleared, 0, sizeof cleared);
        const gn_status status =
            gn_clear_color(&expected, 64 / 255.0f, 128 / 255.0f, 191 / 255.0f, 1.0f);
        if (status == GN_INVALID_FORMAT) /* depth or stencil */
            continue;
        assert_int_equal(status, is_basic((gn_format)f) ? GN_OK : LACKED);
        assert_int_equal(gn_blit(&d, NULL, &s, NULL, NULL), status);
        if (is_basic((gn_format)f) || status != GN_OK) /* others differ by rounding */
            assert_memory_equal(to, cleared, sizeof to);
    }
}

static void blits_that_mix_are_refused(void **state)
{
    const gn_rectangle one = {0, 0, 1, 1};
    gn_blit_options linear;
    uint16_t from[SIDE * SIDE] = {0xF800, 0xF800, 0xF800, 0xF800}, to[SIDE * SIDE] = {0, 0, 0, 0};
    const gn_surface s = gn_surface_bottom_up(from, GN_FORMAT_RGB565, SIDE, SIDE);
    const gn_surface d = gn_surface_bottom_up(to, GN_FORMAT_RGB565, SIDE, SIDE);

    (void)state;
    memset(&linear, 0, sizeof linear);
    linear.filter = GN_BLIT_LINEAR;
    assert_int_equal(gn_blit(&d, &one, &s, NULL, &linear), LACKED);
    assert_int_equal(to[0], LACKED == GN_OK ? 0xF800 : 0);
    assert_int_equal(gn_blit(&d, NULL, &s, NULL, NULL), GN_OK);
    assert_memory_equal(to, from, sizeof to);
}

static void samplers_are_refused(void **state)
{
    gn_sampler none, s;

    (void)state;
    memset(&none, 0, sizeof none);
    none.minify = GN_MINIFY_LINEAR;
    assert_int_equal(gn_sampler_check(&none), GN_OK);
    for (int wrap = GN_WRAP_REPEAT; wrap <= GN_WRAP_MIRROR_CLAMP_TO_EDGE; ++wrap) {
        const gn_status expected = wrap <= GN_WRAP_CLAMP_TO_EDGE ? GN_OK : LACKED;

        s = none;
        s.wrap_s = (gn_wrap)wrap;
        assert_int_equal(gn_sampler_check(&s), expected);
        s = none;
        s.wrap_t = (gn_wrap)wrap;
        assert_int_equal(gn_sampler_check(&s), expected);
    }
    s = none;
    s.lod_bias = 1.0f;
    assert_int_equal(gn_sampler_check(&s), LACKED);
    s = none;
    s.lod_clamped = true;
    assert_int_equal(gn_sampler_check(&s), LACKED);
    s = none;
    s.max_anisotropy = 1;
    assert_int_equal(gn_sampler_check(&s), GN_OK);
    s.max_anisotropy = 2;
    assert_int_equal(gn_sampler_check(&s), LACKED);
}

static void stencil_is_not_cleared(void **state)
{
    static const gn_format formats[] = {GN_FORMAT_D24S8, GN_FORMAT_D32FS8, GN_FORMAT_S8};
    uint64_t pixels[SIDE * SIDE];

    (void)state;
    for (size_t f = 0; f < sizeof formats / sizeof *formats; ++f) {
        const gn_surface s = gn_surface_bottom_up(pixels, formats[f], SIDE, SIDE);
        const gn_status of_depth = formats[f] == GN_FORMAT_S8 ? GN_INVALID_FORMAT : LACKED;
        const unsigned char *const bytes = (const unsigned char *)pixels;

        memset(pixels, 0xA5, sizeof pixels);
        assert_int_equal(gn_clear_depth(&s, 0.5f), of_depth);
        assert_int_equal(gn_clear_stencil(&s, 7), LACKED);
        assert_int_equal(gn_clear_depth_stencil(&s, 0.5f, 7), LACKED);
        assert_int_equal(bytes[0] == 0xA5, LACKED != GN_OK);
    }
}

static void no_vertices(const void *uniforms, const gn_vertex_input *input,
                        gn_vertex_output *output)
{
    (void)uniforms;
    (void)input;
    (void)output;
}

static void lights_are_refused(void **state)
{
    gn_light more;
    gn_lit_uniforms lit;
    gn_pipeline p;

    (void)state;
    memset(&lit, 0, sizeof lit);
    memset(&more, 0, sizeof more);
    memset(&p, 0, sizeof p);
    lit.material.alpha_cutoff = 0.5f;
    assert_int_equal(gn_use_phong(&p, &lit), GN_OK);
    lit.light.kind = GN_LIGHT_POINT;
    assert_int_equal(gn_use_phong(&p, &lit), LACKED);
    lit.light.kind = GN_LIGHT_SPOT;
    assert_int_equal(gn_use_gouraud(&p, &lit), LACKED);
    lit.light.kind = (gn_light_kind)99;
    assert_int_equal(gn_use_phong(&p, &lit), LACKED == GN_OK ? GN_INVALID_ENUM : LACKED);
    lit.light.kind = GN_LIGHT_DIRECTIONAL;
    lit.more_lights = &more;
    lit.more_light_count = 1;
    assert_int_equal(gn_use_phong(&p, &lit), LACKED);
}

/* Values of features that a library lacks are not looked at. */
static void values_without_a_feature(void **state)
{
    gn_pipeline plain, p;

    (void)state;
    memset(&plain, 0, sizeof plain);
    plain.program.vertex_shader = no_vertices;
    assert_int_equal(gn_pipeline_check(&plain, NULL), GN_OK);
    p = plain;
    p.color.logic_operation = (gn_logic_operation)99;
    assert_int_equal(gn_pipeline_check(&p, NULL), LACKED == GN_OK ? GN_INVALID_ENUM : GN_OK);
    p = plain;
    p.samples.write_disabled = 1u << GN_SAMPLES;
    assert_int_equal(gn_pipeline_check(&p, NULL), LACKED == GN_OK ? GN_OUT_OF_RANGE : GN_OK);
    p = plain;
    p.program.color_count = GN_MAX_COLORS + 1;
    assert_int_equal(gn_pipeline_check(&p, NULL), LACKED == GN_OK ? GN_OUT_OF_RANGE : LACKED);
    p = plain;
    p.program.clip_distance_count = GN_MAX_CLIP_DISTANCES + 1;
    assert_int_equal(gn_pipeline_check(&p, NULL), LACKED == GN_OK ? GN_OUT_OF_RANGE : LACKED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(blits_convert_or_are_refused),
        cmocka_unit_test(blits_that_mix_are_refused),
        cmocka_unit_test(samplers_are_refused),
        cmocka_unit_test(stencil_is_not_cleared),
        cmocka_unit_test(lights_are_refused),
        cmocka_unit_test(values_without_a_feature),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
