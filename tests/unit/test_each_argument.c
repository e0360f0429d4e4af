/* Each number of a surface, a rectangle, a resolve and a ready-made shader is checked alone, while
 * all others are good; and clears of colours whose channels are almost equal. */
#include <math.h>
#include <string.h>

#include "unit.h"

static uint32_t from_memory[64 * 64 * 4], to_memory[64 * 64 * 4];

static void every_corner_has_a_range(void **state)
{
    const gn_surface to = gn_surface_bottom_up(to_memory, GN_FORMAT_RGBA8, 4, 4);
    const gn_surface from = gn_surface_bottom_up(from_memory, GN_FORMAT_RGBA8, 4, 4);

    (void)state;
    for (int n = 0; n < 4; ++n)
        for (int sign = -1; sign <= 1; sign += 2) {
            gn_rectangle r = {0, 0, 4, 4};
            int32_t *const corner[] = {&r.x0, &r.y0, &r.x1, &r.y1};

            *corner[n] = sign * (GN_MAX_SIZE + 1);
            memset(to_memory, 0xEE, sizeof to_memory);
            assert_int_equal(gn_blit(&to, &r, &from, NULL, NULL), GN_OUT_OF_RANGE);
            assert_int_equal(gn_blit(&to, NULL, &from, &r, NULL), GN_OUT_OF_RANGE);
            assert_int_equal(to_memory[0], 0xEEEEEEEE);
            *corner[n] = sign * GN_MAX_SIZE;
            assert_int_equal(gn_blit(&to, &r, &from, NULL, NULL), GN_OK);
            assert_int_equal(gn_blit(&to, NULL, &from, &r, NULL), GN_OK);
        }
}

/* Views of one image overlap if their addresses do; pixels are only compared if pixels, stride and
 * format are equal. */
static void views_of_one_memory_overlap(void **state)
{
    const gn_rectangle left = {0, 0, 2, 4}, right = {2, 0, 4, 4};
    const gn_surface a = gn_surface_bottom_up(from_memory, GN_FORMAT_RGBA8, 4, 4);
    gn_surface b = a;

    (void)state;
    assert_int_equal(gn_blit(&a, &left, &b, &right, NULL), GN_OK);
    assert_int_equal(gn_blit(&a, &left, &b, &left, NULL), GN_OVERLAP);
    b.row_stride *= 2;
    assert_int_equal(gn_blit(&a, &left, &b, &right, NULL), GN_OVERLAP);
    b = a;
    b.format = GN_FORMAT_R32F;
    assert_int_equal(gn_blit(&a, &left, &b, &right, NULL), GN_OVERLAP);
    b = a;
    b.pixels = from_memory + 1;
    b.width = 3;
    assert_int_equal(gn_blit(&a, &left, &b, &left, NULL), GN_OVERLAP);
}

/* Every bit of depth and stencil is copied or kept, scaled and mirrored too. */
static void depth_and_stencil_are_kept_apart(void **state)
{
    static const gn_format formats[] = {GN_FORMAT_D24S8, GN_FORMAT_D32FS8};

    (void)state;
    for (size_t f = 0; f < 2; ++f)
        for (int kept = 0; kept < 4; ++kept)
            for (int shape = 0; shape < 3; ++shape) {
                const gn_surface from = gn_surface_bottom_up(from_memory, formats[f], 20, 1);
                const gn_surface to = gn_surface_bottom_up(to_memory, formats[f], 40, 1);
                const gn_rectangle drawn = shape == 0   ? (gn_rectangle){0, 0, 40, 1}
                                           : shape == 1 ? (gn_rectangle){20, 0, 0, 1}
                                                        : (gn_rectangle){0, 0, 20, 1};
                const uint32_t words = formats[f] == GN_FORMAT_D24S8 ? 1 : 2;
                gn_blit_options options;

                memset(&options, 0, sizeof options);
                options.keeps_depth = kept & 1;
                options.keeps_stencil = kept & 2;
                for (uint32_t i = 0; i < 20; ++i) {
                    from_memory[words * i] = words == 1 ? 0x10203040u + i : 0x3F000000u + i;
                    if (words == 2)
                        from_memory[2 * i + 1] = 100 + i;
                }
                memset(to_memory, 0x55, sizeof to_memory);
                assert_int_equal(gn_blit(&to, &drawn, &from, NULL, &options), GN_OK);
                for (uint32_t x = 0; x < 40; ++x) {
                    const uint32_t read = shape == 0 ? x / 2 : shape == 1 ? 19 - x : x;
                    const bool is_drawn = shape == 0 || x < 20;
                    const uint32_t depth = words == 1 ? 0x00FFFFFFu : 0xFFFFFFFFu;
                    const uint32_t written[2] = {words == 1 ? (kept & 1 ? 0 : depth) |
                                                                  (kept & 2 ? 0 : ~depth)
                                                 : kept & 1 ? 0
                                                            : depth,
                                                 kept & 2 ? 0 : 255u};

                    for (uint32_t w = 0; w < words; ++w) {
                        const uint32_t bits = is_drawn ? written[w] : 0;
                        const uint32_t wanted =
                            (0x55555555u & ~bits) |
                            (is_drawn ? from_memory[words * read + w] & bits : 0);

                        assert_int_equal(to_memory[words * x + w], wanted);
                    }
                }
            }
}

static void resolved_sizes_and_depths(void **state)
{
    const gn_surface image = gn_surface_bottom_up(from_memory, GN_FORMAT_D32F, 4, 4);
    const gn_surface samples = gn_surface_multisampled(&image);
    gn_surface to = gn_surface_bottom_up(to_memory, GN_FORMAT_D32F, 4, 4);

    (void)state;
    to.height = 3;
    assert_int_equal(gn_resolve(&to, &samples), GN_SIZE_MISMATCH);
    to.height = 4;
    to.width = 3;
    assert_int_equal(gn_resolve(&to, &samples), GN_SIZE_MISMATCH);
    to.width = 4;
    for (uint32_t i = 0; i < 64; ++i)
        from_memory[i] = 0x3F000000u + i;
    memset(to_memory, 0, sizeof to_memory);
    assert_int_equal(gn_resolve(&to, &samples), GN_OK); /* depth is not averaged */
    assert_memory_equal(to_memory, from_memory, 64);
    memset(to_memory, 0, sizeof to_memory);
    assert_int_equal(gn_resolve(&to, &image), GN_OK); /* one sample is copied */
    assert_memory_equal(to_memory, from_memory, 64);
    assert_int_equal(to_memory[16], 0);
}

static void views_of_what_is_no_surface(void **state)
{
    const gn_surface good = gn_surface_bottom_up(to_memory, GN_FORMAT_RGBA8, 4, 4);
    gn_surface s;

    (void)state;
    s = gn_surface_top_down(to_memory, GN_FORMAT_RGBA8, 4, 4);
    assert_ptr_equal(s.pixels, to_memory + 12);
    assert_ptr_equal(gn_surface_top_down(to_memory, GN_FORMAT_RGBA8, 4, 0).pixels, to_memory);
    assert_ptr_equal(gn_surface_top_down(to_memory, GN_FORMAT_RGBA8, 4, GN_MAX_SIZE + 1).pixels,
                     to_memory);
    assert_ptr_equal(gn_surface_top_down(to_memory, GN_FORMAT_RGBA8, GN_MAX_SIZE + 1, 4).pixels,
                     to_memory);
    assert_null(gn_surface_top_down(NULL, GN_FORMAT_RGBA8, 4, 4).pixels);

    s = good;
    s.height = 0;
    assert_true(gn_surface_multisampled(&s).sample_stride == PTRDIFF_MAX - 15);
    s.height = 2;
    s.row_stride = PTRDIFF_MAX;
    assert_true(gn_surface_multisampled(&s).sample_stride == PTRDIFF_MAX - 15);
    s.height = 1;
    assert_true(gn_surface_multisampled(&s).sample_stride == PTRDIFF_MAX);
    assert_true(gn_surface_multisampled(&good).sample_stride == 64);
    assert_null(gn_surface_multisampled(NULL).pixels);

    assert_null(gn_surface_sample(NULL, 0).pixels);
    assert_null(gn_surface_sample(&good, 1).pixels);
    assert_ptr_equal(gn_surface_sample(&good, 0).pixels, to_memory);
    s = good;
    s.pixels = NULL;
    assert_null(gn_surface_sample(&s, 0).pixels);
    assert_int_equal(gn_surface_sample(&s, 0).width, 0);
    assert_int_equal(gn_surface_rows(&s, 0, 1).width, 0);
    s = gn_surface_multisampled(&good);
    assert_ptr_equal(gn_surface_sample(&s, GN_SAMPLES - 1).pixels,
                     to_memory + 16 * (GN_SAMPLES - 1));
    assert_null(gn_surface_sample(&s, GN_SAMPLES).pixels);
}

/* Long runs of equal words may be filled in another way than runs in which one word differs. */
static void clears_of_almost_equal_channels(void **state)
{
    (void)state;
    for (int differs = 0; differs <= 4; ++differs)
        for (uint32_t width = 1; width <= 64; width += 21) {
            const gn_surface s = gn_surface_bottom_up(to_memory, GN_FORMAT_RGBA32F, width, 64);
            float c[4] = {0.5f, 0.5f, 0.5f, 0.5f}, stored[4];

            if (differs < 4)
                c[differs] = 0.25f;
            memset(to_memory, 0, sizeof to_memory);
            assert_int_equal(gn_clear_color(&s, c[0], c[1], c[2], c[3]), GN_OK);
            for (uint32_t i = 0; i < width * 64; ++i) {
                memcpy(stored, to_memory + 4 * i, sizeof stored);
                assert_memory_equal(stored, c, sizeof c);
            }
            for (uint32_t i = width * 64 * 4; i < 64 * 64 * 4; ++i)
                assert_int_equal(to_memory[i], 0);
        }
}

/* Depths whose product with 2^24 - 1 is half-way, or near it. */
static void cleared_depths_round_to_even(void **state)
{
    static const struct {
        float depth;
        uint32_t word;
    } cases[] = {{0, 0},
                 {1, 0xFFFFFF},
                 {0.5f, 0x800000},
                 {0.25f, 0x400000},
                 {0.75f, 0xBFFFFF},
                 {0x1p-24f, 1},
                 {0x1p-25f, 0},
                 {0x1.8p-24f, 1},
                 {0x1p-60f, 0},
                 {0x1p-149f, 0},
                 {0x1.fffffep-1f, 0xFFFFFE}};
    const gn_surface s = gn_surface_bottom_up(to_memory, GN_FORMAT_D24S8, 1, 1);

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const double exact = (double)cases[i].depth * 0xFFFFFF;

        to_memory[0] = 0;
        assert_int_equal(gn_clear_depth(&s, cases[i].depth), GN_OK);
        assert_int_equal(to_memory[0] & 0xFFFFFF, (uint32_t)nearbyint(exact));
        assert_int_equal(to_memory[0] & 0xFFFFFF, cases[i].word);
    }
}

static void write_nothing(const void *uniforms, const gn_vertex_input *input,
                          gn_vertex_output *output)
{
    (void)uniforms;
    (void)input;
    (void)output;
}

/* A pipeline whose only ready-made shader reads uniforms that are null. */
static void every_ready_made_shader_needs_uniforms(void **state)
{
    static gn_lit_uniforms lit;
    static gn_unlit_uniforms unlit;
    static gn_color_uniforms color;
    static gn_depth_color_uniforms depth;
    static gn_metallic_roughness_uniforms metallic;
    gn_target target;

    (void)state;
    memset(&target, 0, sizeof target);
    target.color[0] = gn_surface_bottom_up(to_memory, GN_FORMAT_RGBA8, 4, 4);
    depth.white = 1;
    for (int i = 0; i < 10; ++i) {
        gn_pipeline p, own, other;
        gn_status used;

        memset(&p, 0, sizeof p);
        used = i == 0   ? gn_use_vertex_color(&p, &color)
               : i == 1 ? gn_use_unlit(&p, &unlit)
               : i == 2 ? gn_use_depth_color(&p, &depth)
               : i == 3 ? gn_use_flat(&p, &lit)
               : i == 4 ? gn_use_gouraud(&p, &lit)
               : i == 5 ? gn_use_toon(&p, &lit)
               : i == 6 ? gn_use_phong(&p, &lit)
               : i == 7 ? gn_use_blinn_phong(&p, &lit)
               : i == 8 ? gn_use_metallic_roughness(&p, &metallic)
                        : gn_use_normal_color(&p, &lit);
        assert_int_equal(used, GN_OK);
        assert_int_equal(gn_pipeline_check(&p, &target), GN_OK);
        p.program.uniforms = NULL;
        assert_int_equal(gn_pipeline_check(&p, &target), GN_NULL_POINTER);
        own = p; /* with a fragment shader that reads no uniforms */
        memset(&other, 0, sizeof other);
        assert_int_equal(gn_use_vertex_color(&other, &color), GN_OK);
        own.program.fragment_shader = other.program.fragment_shader;
        assert_int_equal(gn_pipeline_check(&own, &target), GN_NULL_POINTER);
        own = p; /* with a vertex shader that is not ready-made */
        own.program.vertex_shader = write_nothing;
        assert_int_equal(gn_pipeline_check(&own, &target), i == 0 ? GN_OK : GN_NULL_POINTER);
    }
    for (int sign = 0; sign < 2; ++sign) {
        gn_pipeline p;

        memset(&p, 0, sizeof p);
        depth.black = sign ? NAN : 0;
        depth.white = sign ? 1 : NAN;
        assert_int_equal(gn_use_depth_color(&p, &depth), GN_NOT_FINITE);
    }
}

/* Depth 0.5 as grey: between black and white; both 0 mean 0 to 1. */
static void depths_between_black_and_white(void **state)
{
    static const float ends[][3] = {
        {0, 0, 128}, {0, 0.5f, 255}, {0.5f, 0, 0}, {1, 0, 128}, {0, 1, 128}};
    static const float position[3][3] = {{-3, -3, 0}, {3, -3, 0}, {0, 6, 0}};
    static unsigned char memory[GN_WORKSPACE_SIZE(16, 8)];
    static gn_depth_color_uniforms depth;

    (void)state;
    gn_mat4_identity(&depth.clip_from_model);
    for (size_t i = 0; i < sizeof ends / sizeof *ends; ++i) {
        gn_workspace workspace = {.memory = memory, .size = sizeof memory};
        gn_mesh mesh = {.vertex_count = 3, .count = 3};
        gn_target target;
        gn_pipeline p;

        memset(&target, 0, sizeof target);
        memset(&p, 0, sizeof p);
        target.color[0] = gn_surface_bottom_up(to_memory, GN_FORMAT_RGBA8, 4, 4);
        mesh.attribute[GN_ATTRIBUTE_POSITION] =
            (gn_attribute){.data = position[0], .components = 3};
        depth.black = ends[i][0];
        depth.white = ends[i][1];
        assert_int_equal(gn_use_depth_color(&p, &depth), GN_OK);
        assert_int_equal(gn_draw(&target, &p, &mesh, &workspace), GN_OK);
        assert_int_equal(to_memory[5] & 255, (int)ends[i][2]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_corner_has_a_range),
        cmocka_unit_test(views_of_one_memory_overlap),
        cmocka_unit_test(depth_and_stencil_are_kept_apart),
        cmocka_unit_test(resolved_sizes_and_depths),
        cmocka_unit_test(views_of_what_is_no_surface),
        cmocka_unit_test(clears_of_almost_equal_channels),
        cmocka_unit_test(cleared_depths_round_to_even),
        cmocka_unit_test(every_ready_made_shader_needs_uniforms),
        cmocka_unit_test(depths_between_black_and_white),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
