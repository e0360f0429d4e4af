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

static bool is_basic(gn_format format)
{
    return format == GN_FORMAT_RGBA8 || format == GN_FORMAT_RGBA32F || format == GN_FORMAT_RGB565 ||
           format == GN_FORMAT_RGB565_SWAPPED;
}

/* What the colour 1, 0, 1/5, 3/5 is in a format: 255, 0, 51, 153 in RGBA8. */
typedef struct converted {
    gn_format format;
    uint32_t size; /* of an element */
    uint32_t element[4];
} converted;

/* By the rules for fragments in reference/RULES.md. Floats are 51 and 153 times 1 / 255, rounded
 * before and after. 565 and 5551 take the highest bits of the bytes, RGBA4 their 17th. Halves are
 * cut off towards zero. sRGB's 1/5 is 1.055 * 0.2^(1/2.4) - 0.055 = 0.4845, of 255 that is 123.6.
 * RGB10_A2's blue is the upper bits of 13107, its alpha 0.6 * 3 = 1.8. In R11F_G11F_B10F, 1/5 is
 * 1.6 / 8, with 19 of 32 steps and the exponent -3 + 15. */
static const converted conversions[] = {
    {GN_FORMAT_RGBA8, 4, {0x993300FFu}},
    {GN_FORMAT_RGBA32F, 4, {0x3F800000u, 0, 0x3E4CCCCEu, 0x3F19999Au}},
    {GN_FORMAT_BGRA8, 4, {0x99FF0033u}},
    {GN_FORMAT_R8, 1, {0xFF}},
    {GN_FORMAT_RG8, 2, {0x00FF}},
    {GN_FORMAT_RGB8, 1, {0xFF, 0, 0x33}},
    {GN_FORMAT_RGB565, 2, {31u << 11 | 6}},
    {GN_FORMAT_RGB5_A1, 2, {31u << 11 | 6u << 1 | 1}},
    {GN_FORMAT_RGBA4, 2, {15u << 12 | 3u << 4 | 9}},
    {GN_FORMAT_R16, 2, {65535}},
    {GN_FORMAT_RGBA16, 2, {65535, 0, 13107, 39321}},
    {GN_FORMAT_R32F, 4, {0x3F800000u}},
    {GN_FORMAT_RGBA16F, 2, {0x3C00, 0, 0x3266, 0x38CC}},
    {GN_FORMAT_SRGB8_A8, 4, {0x997C00FFu}},
    {GN_FORMAT_RG16F, 4, {0x00003C00u}},
    {GN_FORMAT_RGB565_SWAPPED, 1, {31u << 3, 6}},
    {GN_FORMAT_RGB10_A2, 4, {1023u | (13107u >> 6) << 20 | 2u << 30}},
    {GN_FORMAT_R11F_G11F_B10F, 4, {0x3C0u | (12u << 5 | 19u) << 22}},
    {GN_FORMAT_RGB32F, 4, {0x3F800000u, 0, 0x3E4CCCCEu}}};

/* Null for depths and stencils. */
static const converted *conversion_of(gn_format format)
{
    for (size_t i = 0; i < sizeof conversions / sizeof *conversions; ++i)
        if (conversions[i].format == format)
            return &conversions[i];
    return NULL;
}

static void expect_pixels(const unsigned char *pixels, const converted *c)
{
    const uint32_t elements = gn_format_size(c->format) / c->size;

    for (uint32_t i = 0; i < SIDE * SIDE * elements; ++i) {
        const unsigned char *const at = pixels + (size_t)i * c->size;
        uint16_t half;
        uint32_t word;

        memcpy(&half, at, sizeof half);
        memcpy(&word, at, sizeof word);
        word = c->size == 1 ? *at : c->size == 2 ? half : word;
        if (word != c->element[i % elements])
            fail_msg("format %d: element %u is %x", (int)c->format, i, word);
    }
}

static void blits_convert_or_are_refused(void **state)
{
    static const uint32_t from[SIDE * SIDE] = {0x993300FFu, 0x993300FFu, 0x993300FFu, 0x993300FFu};
    uint32_t to[BYTES / 4 + 1];
    unsigned char untouched[sizeof to];
    uint32_t formats = 0;

    memset(untouched, 0xA5, sizeof untouched);
    for (int f = GN_FORMAT_NONE + 1; gn_format_size((gn_format)f) > 0; ++f) {
        const gn_surface s =
            gn_surface_bottom_up((void *)(uintptr_t)from, GN_FORMAT_RGBA8, SIDE, SIDE);
        const gn_surface d = gn_surface_bottom_up(to, (gn_format)f, SIDE, SIDE);
        const converted *const c = conversion_of((gn_format)f);
        const gn_status expected = !c ? GN_INVALID_FORMAT : is_basic((gn_format)f) ? GN_OK : LACKED;

        memset(to, 0xA5, sizeof to);
        assert_int_equal(gn_blit(&d, NULL, &s, NULL, NULL), expected);
        if (expected == GN_OK)
            expect_pixels((const unsigned char *)to, c);
        else
            assert_memory_equal(to, untouched, sizeof to);
        assert_int_equal(gn_clear_color(&d, 1.0f, 0.0f, 0.25f, 0.5f), expected);
        formats += c != NULL;
    }
    assert_int_equal(formats, sizeof conversions / sizeof *conversions);
}

static void blits_that_mix_are_refused(void **state)
{
    const gn_rectangle one = {0, 0, 1, 1};
    gn_blit_options linear;
    uint16_t from[SIDE * SIDE] = {0xF801, 0xF801, 0xF801, 0xF801}, to[SIDE * SIDE] = {0, 0, 0, 0};
    const gn_surface s = gn_surface_bottom_up(from, GN_FORMAT_RGB5_A1, SIDE, SIDE);
    const gn_surface d = gn_surface_bottom_up(to, GN_FORMAT_RGB5_A1, SIDE, SIDE);

    memset(&linear, 0, sizeof linear);
    linear.filter = GN_BLIT_LINEAR;
    assert_int_equal(gn_blit(&d, &one, &s, NULL, &linear), LACKED);
    assert_int_equal(to[0], LACKED == GN_OK ? 0xF801 : 0);
    assert_int_equal(gn_blit(&d, NULL, &s, NULL, NULL), GN_OK);
    assert_memory_equal(to, from, sizeof to);
}

static void samplers_are_refused(void **state)
{
    gn_sampler none, s;

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
    s.lod_clamp_enabled = true;
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

/* Of four samples. */
static gn_surface sampled(void *pixels, uint32_t width)
{
    gn_surface s = gn_surface_bottom_up(pixels, GN_FORMAT_RGBA8, width, 1);

    s.samples = GN_SAMPLES;
    s.sample_stride = (ptrdiff_t)width * 4;
    s.row_stride = s.sample_stride * GN_SAMPLES;
    return s;
}

static void samples_are_refused(void **state)
{
    uint32_t from[GN_SAMPLES] = {0, 0x0000FF00u, 0x0000FF00u, 0x00FFFF00u}, to = 0xA5A5A5A5u;
    const gn_surface samples = sampled(from, 1);
    const gn_surface image = gn_surface_bottom_up(&to, GN_FORMAT_RGBA8, 1, 1);

    assert_int_equal(gn_resolve(&image, NULL), GN_NULL_POINTER);
    assert_int_equal(gn_resolve(NULL, &samples), GN_NULL_POINTER);
    assert_int_equal(to, 0xA5A5A5A5u);
    assert_int_equal(gn_resolve(&image, &samples), LACKED);
    assert_int_equal(to, LACKED == GN_OK ? 0x0040BF00u : 0xA5A5A5A5u);
    assert_int_equal(gn_clear_color(&samples, 1.0f, 1.0f, 1.0f, 1.0f), LACKED);
    assert_int_equal(from[3], LACKED == GN_OK ? 0xFFFFFFFFu : 0x00FFFF00u);
}

static void levels_are_refused(void **state)
{
    static const uint32_t first[SIDE * SIDE] = {0, 0xFF, 0xFF, 0xFF};
    uint32_t second = 0xA5A5A5A5u;
    gn_texture t;

    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, SIDE, SIDE, 1, 1, first, &t),
                     GN_OK);
    assert_int_equal(gn_texture_generate_levels(&t, &second, sizeof second), LACKED);
    assert_int_equal(second, LACKED == GN_OK ? 191 : 0xA5A5A5A5u);
    assert_int_equal(t.level_count, LACKED == GN_OK ? 2 : 1);
    t.level_count = 2;
    t.level[1] = t.level[0];
    assert_int_equal(gn_texture_check(&t), LACKED);
    t.level_count = 1;
    t.target = GN_TEXTURE_CUBE;
    t.level[0].layer_stride = sizeof first;
    assert_int_equal(gn_texture_check(&t), LACKED);
    t.target = GN_TEXTURE_2D;
    t.format = GN_FORMAT_BGRA8;
    assert_int_equal(gn_texture_check(&t), LACKED == GN_OK ? GN_OK : GN_INVALID_FORMAT);
}

static void no_vertices(const void *uniforms, const gn_vertex_input *input,
                        gn_vertex_output *output)
{
    (void)uniforms;
    (void)input;
    (void)output;
}

static void no_fragments(const void *uniforms, const gn_fragment_input *input,
                         gn_fragment_output *output)
{
    (void)uniforms;
    (void)input;
    (void)output;
}

static void targets_are_refused(void **state)
{
    uint64_t pixels[2][SIDE * SIDE * GN_SAMPLES];
    const gn_surface color = gn_surface_bottom_up(pixels[0], GN_FORMAT_RGBA8, SIDE, 1);
    const gn_surface depth = gn_surface_bottom_up(pixels[1], GN_FORMAT_D32F, SIDE, 1);
    gn_target plain, t;

    memset(&plain, 0, sizeof plain);
    plain.color[0] = color;
    plain.depth = depth;
    assert_int_equal(gn_target_check(&plain), GN_OK);
    t = plain;
    t.color[0].format = GN_FORMAT_BGRA8;
    assert_int_equal(gn_target_check(&t), LACKED);
    t = plain;
    t.color[1] = gn_surface_bottom_up(pixels[1], GN_FORMAT_RGBA8, SIDE, 1);
    assert_int_equal(gn_target_check(&t), LACKED);
    t = plain;
    t.depth = gn_surface_bottom_up(pixels[1], GN_FORMAT_D24S8, SIDE, 1);
    assert_int_equal(gn_target_check(&t), LACKED);
    t.depth.format = GN_FORMAT_NONE;
    t.color[0] = sampled(pixels[0], SIDE);
    assert_int_equal(gn_target_check(&t), LACKED);
}

enum { WIDE = 90, HIGH = 20 };

/* Draws three triangles that overlap in depth, the last one textured with two bytes a texel, into a
 * target of any format. */
static void draw_three(void *pixels, gn_format format, gn_format depth_format, gn_format texels)
{
    static const float position[] = {-1, -1, 0,     1, -1,    0,     1,     1,  0.5f,
                                     -1, 1,  -0.5f, 1, 0.5f,  0.5f,  -0.5f, -1, -0.9f,
                                     -1, -1, 0.9f,  1, -0.8f, -0.7f, 0,     1,  0.3f};
    static const float color[] = {1, 0, 0.3f, 0.2f, 1, 0,    0, 0.4f, 1, 0.9f, 0.6f, 0.1f, 0, 0,
                                  0, 1, 1,    1,    1, 0.5f, 1, 1,    1, 0.5f, 0.7f, 1,    1};
    static const float texcoord[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 1, 2};
    static const unsigned char shorts[2][8] = {{0x1F, 0xF8, 0xE0, 0x07, 0xEF, 0x7B, 0x10, 0x84},
                                               {0xF8, 0x1F, 0x07, 0xE0, 0x7B, 0xEF, 0x84, 0x10}};
    static unsigned char memory[GN_WORKSPACE_SIZE(9, GN_SHADER_VARYINGS)];
    static uint32_t depths[WIDE * HIGH];
    uint16_t texel[4];
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};
    gn_mesh mesh = {.vertex_count = 9, .count = 6};
    gn_pipeline p = {.depth.test_enabled = true};
    gn_color_uniforms plain = {.clip_from_model = {{{0}}}};
    gn_unlit_uniforms mapped = {
        .sampler = {.minify = GN_MINIFY_NEAREST, .magnify = GN_MAGNIFY_NEAREST}};
    gn_texture t;
    gn_target target = {{gn_surface_top_down(pixels, format, WIDE, HIGH)},
                        gn_surface_bottom_up(depths, depth_format, WIDE, HIGH)};

    memcpy(texel, shorts[texels == GN_FORMAT_RGB565_SWAPPED], sizeof texel);
    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, texels, 2, 2, 1, 1, texel, &t), GN_OK);
    if (depth_format == GN_FORMAT_NONE)
        target.depth = (gn_surface){.format = GN_FORMAT_NONE};
    else
        assert_int_equal(gn_clear_depth(&target.depth, 1), GN_OK);
    assert_int_equal(gn_clear_color(&target.color[0], 0, 1, 0, 1), GN_OK);
    mesh.attribute[GN_ATTRIBUTE_POSITION] = (gn_attribute){.data = position, .components = 3};
    mesh.attribute[GN_ATTRIBUTE_COLOR] = (gn_attribute){.data = color, .components = 3};
    mesh.attribute[GN_ATTRIBUTE_TEXCOORD] = (gn_attribute){.data = texcoord, .components = 2};
    gn_mat4_identity(&plain.clip_from_model);
    mapped.clip_from_model = plain.clip_from_model;
    mapped.map = &t;
    assert_int_equal(gn_use_vertex_color(&p, &plain), GN_OK);
    assert_int_equal(gn_draw(&target, &p, &mesh, &workspace), GN_OK);
    mesh.first = 6;
    mesh.count = 3;
    for (int filter = 0; filter < 2; ++filter) {
        mapped.sampler.minify = filter ? GN_MINIFY_LINEAR : GN_MINIFY_NEAREST;
        mapped.sampler.magnify = filter ? GN_MAGNIFY_LINEAR : GN_MAGNIFY_NEAREST;
        p.raster.viewport = (gn_viewport){true, filter ? 30.0f : 0, 0, WIDE, HIGH};
        assert_int_equal(gn_use_unlit(&p, &mapped), GN_OK);
        assert_int_equal(gn_draw(&target, &p, &mesh, &workspace), GN_OK);
    }
}

/* Pixels of two bytes are the highest bits of the bytes of RGBA8 (reference/RULES.md). Rows are
 * longer than what one lane draws at a time. */
static void two_bytes_are_the_high_bits_of_four(void **state)
{
    static const gn_format depths[] = {GN_FORMAT_D16, GN_FORMAT_D24, GN_FORMAT_D32F,
                                       GN_FORMAT_NONE};
    static uint32_t four[WIDE * HIGH];
    static uint16_t two[WIDE * HIGH];
    static unsigned char swapped[2 * WIDE * HIGH];

    for (size_t d = 0; d < sizeof depths / sizeof *depths; ++d) {
        uint32_t hues = 0;

        draw_three(four, GN_FORMAT_RGBA8, depths[d], GN_FORMAT_RGB565);
        draw_three(two, GN_FORMAT_RGB565, depths[d], GN_FORMAT_RGB565_SWAPPED);
        draw_three(swapped, GN_FORMAT_RGB565_SWAPPED, depths[d], GN_FORMAT_RGB565);
        for (size_t i = 0; i < WIDE * HIGH; ++i) {
            const uint32_t c = four[i];
            const uint32_t high = (c & 0xF8) << 8 | (c >> 5 & 0x7E0) | (c >> 19 & 0x1F);

            hues += i > 0 && four[i] != four[i - 1];
            assert_int_equal(two[i], high);
            assert_int_equal(swapped[2 * i] << 8 | swapped[2 * i + 1], high);
        }
        assert_true(hues > WIDE * HIGH / 2);
    }
}

/* A texel's channel is its number divided by the largest one: of 255, 16 of 31 are 131.6 and 32 of
 * 63 are 129.5238. */
static void texels_of_two_bytes(void **state)
{
    static const float position[] = {-1, -1, 0, 3, -1, 0, -1, 3, 0};
    static const float white[] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
    static const float texcoord[] = {0, 0, 0, 0, 0, 0};
    static const unsigned char texel[2][2] = {{0x10, 0x84}, {0x84, 0x10}};
    static unsigned char memory[GN_WORKSPACE_SIZE(3, GN_SHADER_VARYINGS)];

    for (int i = 0; i < 2; ++i) {
        uint32_t pixel = 0;
        uint16_t aligned;
        gn_workspace workspace = {.memory = memory, .size = sizeof memory};
        gn_mesh mesh = {.vertex_count = 3, .count = 3};
        gn_pipeline p = {.depth.test_enabled = false};
        gn_unlit_uniforms u = {
            .sampler = {.minify = GN_MINIFY_NEAREST, .magnify = GN_MAGNIFY_NEAREST}};
        gn_target target = {.color = {gn_surface_bottom_up(&pixel, GN_FORMAT_RGBA8, 1, 1)}};
        gn_texture t;

        memcpy(&aligned, texel[i], sizeof aligned);
        assert_int_equal(gn_texture_packed(GN_TEXTURE_2D,
                                           i ? GN_FORMAT_RGB565_SWAPPED : GN_FORMAT_RGB565, 1, 1, 1,
                                           1, &aligned, &t),
                         GN_OK);
        mesh.attribute[GN_ATTRIBUTE_POSITION] = (gn_attribute){.data = position, .components = 3};
        mesh.attribute[GN_ATTRIBUTE_COLOR] = (gn_attribute){.data = white, .components = 3};
        mesh.attribute[GN_ATTRIBUTE_TEXCOORD] = (gn_attribute){.data = texcoord, .components = 2};
        gn_mat4_identity(&u.clip_from_model);
        u.map = &t;
        assert_int_equal(gn_use_unlit(&p, &u), GN_OK);
        assert_int_equal(gn_draw(&target, &p, &mesh, &workspace), GN_OK);
        assert_int_equal(pixel, 0xFF848284u);
    }
}

/* A pipeline with one thing more than any library draws. */
static void pipelines_are_refused(void **state)
{
    gn_pipeline plain, p[16];
    size_t n = 0;

    memset(&plain, 0, sizeof plain);
    plain.program.vertex_shader = no_vertices;
    plain.program.fragment_shader = no_fragments;
    assert_int_equal(gn_pipeline_check(&plain, NULL), GN_OK);
    for (size_t i = 0; i < sizeof p / sizeof *p; ++i)
        p[i] = plain;
    p[n++].raster.topology = GN_LINES;
    p[n++].raster.topology = GN_POINTS;
    p[n++].raster.polygon_mode_front = GN_POLYGON_LINE;
    p[n++].raster.polygon_mode_back = GN_POLYGON_POINT;
    p[n++].raster.polygon_offset.enabled = true;
    p[n++].depth.clamp_enabled = true;
    p[n++].color.write_disabled[0] = 1;
    p[n++].color.blend[0].enabled = true;
    p[n++].color.logic_enabled = true;
    p[n++].program.color_count = 2;
    p[n++].program.clip_distance_count = 1;
    p[n++].program.fragment_reads_point_coordinate = true;
    p[n++].program.fragment_reads_sample_mask = true;
    p[n++].program.fragment_writes_sample_mask = true;
    for (size_t i = 0; i < n; ++i)
        if (gn_pipeline_check(&p[i], NULL) != LACKED)
            fail_msg("pipeline %zu: status %d", i, (int)gn_pipeline_check(&p[i], NULL));
}

static void meshes_and_counts_are_refused(void **state)
{
    static unsigned char memory[GN_WORKSPACE_SIZE(3, 0)];
    uint32_t pixel = 0;
    gn_draw_statistics counts;
    gn_workspace workspace;
    gn_pipeline p;
    gn_target target;
    gn_mesh mesh;

    memset(&mesh, 0, sizeof mesh);
    mesh.instance_count = 1;
    assert_int_equal(gn_mesh_check(&mesh), GN_OK);
    mesh.instance_count = 2;
    assert_int_equal(gn_mesh_check(&mesh), LACKED);
    mesh.instance_count = 1;
    mesh.restart = GN_RESTART_INDEX;
    assert_int_equal(gn_mesh_check(&mesh), LACKED);

    memset(&mesh, 0, sizeof mesh);
    memset(&p, 0, sizeof p);
    memset(&target, 0, sizeof target);
    memset(&workspace, 0, sizeof workspace);
    memset(&counts, 0, sizeof counts);
    p.program.vertex_shader = no_vertices;
    p.program.fragment_shader = no_fragments;
    target.color[0] = gn_surface_bottom_up(&pixel, GN_FORMAT_RGBA8, 1, 1);
    workspace.memory = memory;
    workspace.size = sizeof memory;
    assert_int_equal(gn_draw(&target, &p, &mesh, &workspace), GN_OK);
    workspace.statistics = &counts;
    assert_int_equal(gn_draw(&target, &p, &mesh, &workspace), LACKED);
}

static void shadow_map(gn_texture *map, const float *depth)
{
    memset(map, 0, sizeof *map);
    map->format = GN_FORMAT_D32F;
    map->width = map->height = 1;
    map->level[0].texels = depth;
    map->level[0].row_stride = sizeof *depth;
}

static void lights_are_refused(void **state)
{
    const float depth = 0.5f;
    gn_texture map;
    gn_light more;
    gn_lit_uniforms lit;
    gn_pipeline p;

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
    lit.more_light_count = 0;
    shadow_map(&map, &depth);
    lit.shadow.map = &map;
    lit.shadow.sampler.compare = GN_LESS;
    assert_int_equal(gn_use_phong(&p, &lit), LACKED);
}

/* Values of features that a library lacks are not looked at. */
static void values_without_a_feature(void **state)
{
    gn_pipeline plain, p;

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

#if defined(GN_DEBUG) || !defined(GN_BASIC) || !defined(GN_SMALL)

static void whole_target(const void *uniforms, const gn_vertex_input *input,
                         gn_vertex_output *output)
{
    (void)uniforms;
    for (int l = 0; l < GN_LANES; ++l) {
        const uint32_t id = input->vertex_id[l];

        output->position[0][l] = id == 1 ? 3.0f : -1.0f;
        output->position[1][l] = id == 2 ? 3.0f : -1.0f;
        output->position[2][l] = 0.0f;
        output->position[3][l] = 1.0f;
    }
}

typedef struct textured {
    gn_texture map;
    gn_sampler sampler;
} textured;

static void look_up(const void *uniforms, const gn_fragment_input *input,
                    gn_fragment_output *output)
{
    static const float middle[GN_LANES];
    const textured *const u = uniforms;

    gn_fragment_lookup_2d(input, &u->map, &u->sampler, middle, middle, output->color);
}

/* A texture and a sampler of a caller's shader, each forgotten in turn, are black and a fault. */
static void forgotten_textures_are_faults(void **state)
{
    static unsigned char memory[GN_WORKSPACE_SIZE(3, 0)];
    const uint32_t texel = 0xFF8040C0;
    textured u;
    uint32_t pixel;
    gn_pipeline p;
    gn_mesh mesh;
    gn_target target;
    gn_workspace workspace;

    memset(&u, 0, sizeof u);
    memset(&p, 0, sizeof p);
    memset(&mesh, 0, sizeof mesh);
    memset(&target, 0, sizeof target);
    memset(&workspace, 0, sizeof workspace);
    p.program.vertex_shader = whole_target;
    p.program.fragment_shader = look_up;
    p.program.uniforms = &u;
    mesh.vertex_count = mesh.count = 3;
    target.color[0] = gn_surface_bottom_up(&pixel, GN_FORMAT_RGBA8, 1, 1);
    workspace.memory = memory;
    workspace.size = sizeof memory;
    u.sampler.magnify = GN_MAGNIFY_NEAREST;
    u.sampler.minify = GN_MINIFY_NEAREST;
    pixel = 0;
    assert_int_equal(gn_draw(&target, &p, &mesh, &workspace), gn_texture_check(&u.map));
    assert_int_not_equal(gn_texture_check(&u.map), GN_OK);
    assert_int_equal(pixel, 0xFF000000);
    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, 1, 1, 1, 1, &texel, &u.map),
                     GN_OK);
    assert_int_equal(gn_draw(&target, &p, &mesh, &workspace), GN_OK);
    assert_int_equal(pixel, texel);
    u.sampler.wrap_s = (gn_wrap)99;
    assert_int_equal(gn_draw(&target, &p, &mesh, &workspace), GN_INVALID_ENUM);
    assert_int_equal(pixel, 0xFF000000);
}

#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(blits_convert_or_are_refused),
        cmocka_unit_test(blits_that_mix_are_refused),
        cmocka_unit_test(samplers_are_refused),
        cmocka_unit_test(stencil_is_not_cleared),
        cmocka_unit_test(samples_are_refused),
        cmocka_unit_test(levels_are_refused),
        cmocka_unit_test(targets_are_refused),
        cmocka_unit_test(two_bytes_are_the_high_bits_of_four),
        cmocka_unit_test(texels_of_two_bytes),
        cmocka_unit_test(pipelines_are_refused),
        cmocka_unit_test(meshes_and_counts_are_refused),
        cmocka_unit_test(lights_are_refused),
        cmocka_unit_test(values_without_a_feature),
#if defined(GN_DEBUG) || !defined(GN_BASIC) || !defined(GN_SMALL)
        cmocka_unit_test(forgotten_textures_are_faults),
#endif
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
