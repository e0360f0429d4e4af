/* What is drawn over one lane, in a library that has that form beside sixteen lanes
 * (GN_HAVE_ONE_LANE, as the sanitized tests have), and what its shaders find. In any other library
 * the same draws take sixteen lanes, and the pixels are the same. */
#include "canvas.h"
#include "ready_made.h"

static const float big[12] = {-1, -1, 0, 1, 3, -1, 0, 1, -1, 3, 0, 1};
static const float half[12] = {-1, -1, 0, 1, 0.1f, -1, 0, 1, -1, 0.1f, 0, 1};
static uint32_t largest_count, calls;
static bool wants_quads;

/* Lookups depend on their neighbours where filters or levels are chosen by the footprint. */
static void neighbours_of_lookups(void **state)
{
    static const uint32_t texels[16 * 16 * 2];
    gn_texture one, many;
    gn_sampler s = {.magnify = GN_MAGNIFY_LINEAR, .minify = GN_MINIFY_LINEAR};

    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, 16, 16, 1, 1, texels, &one),
                     GN_OK);
    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, 16, 16, 1, 5, texels, &many),
                     GN_OK);
    assert_false(gn_lookup_needs_quads(&one, &s));
    assert_false(gn_lookup_needs_quads(&many, &s));
    s.minify = GN_MINIFY_NEAREST;
    assert_true(gn_lookup_needs_quads(&one, &s));
    s.magnify = GN_MAGNIFY_NEAREST;
    assert_false(gn_lookup_needs_quads(&one, &s));
    s.minify = GN_MINIFY_NEAREST_MIPMAP_LINEAR;
    assert_false(gn_lookup_needs_quads(&one, &s));
    assert_true(gn_lookup_needs_quads(&many, &s));
    s.minify = GN_MINIFY_NEAREST;
    s.max_anisotropy = 4;
    assert_true(gn_lookup_needs_quads(&one, &s));
}

static void count_lanes_red(const void *u, const gn_fragment_input *input,
                            gn_fragment_output *output)
{
    largest_count = input->count > largest_count ? input->count : largest_count;
    ++calls;
    for (uint32_t l = 0; l < input->count; ++l) {
        output->color[0][l] = 1.0f;
        output->color[3][l] = 1.0f;
    }
}

static bool quads_as_wanted(const gn_program *program)
{
    return wants_quads;
}

/* Draws on the portable back end; returns the most lanes that a call of the shader had. */
static uint32_t drawn_with(const gn_program *program)
{
    largest_count = calls = 0;
    c.pipeline.program = *program;
    c.workspace.backend = GN_BACKEND_PORTABLE;
    memset(c.color, 0, sizeof c.color);
    assert_int_equal(draw(), GN_OK);
    for (int i = 0; i < SIZE * SIZE; ++i)
        assert_int_equal(c.color[i], 0xFF0000FFu);
    return largest_count;
}

/* The program says whether its fragments need neighbours, and is asked by every draw. */
static void programs_say_what_they_need(void **state)
{
    const uint32_t one = GN_HAVE_ONE_LANE ? 1 : GN_LANES;
    gn_program program;

    reset(big, 3, GN_TRIANGLES);
    program = c.pipeline.program;
    program.fragment_shader = count_lanes_red;
    assert_int_equal(drawn_with(&program),
                     GN_LANES); /* gn_use_vertex_color's answer: not its shader */
    program.needs_quads = NULL;
    assert_int_equal(drawn_with(&program), GN_LANES);
    program.needs_quads = quads_as_wanted;
    wants_quads = true;
    assert_int_equal(drawn_with(&program), GN_LANES);
    wants_quads = false;
    assert_int_equal(drawn_with(&program), one);
    assert_true(GN_HAVE_ONE_LANE ? calls == SIZE * SIZE : calls < SIZE * SIZE);

    c.pipeline.raster.polygon_mode_front = c.pipeline.raster.polygon_mode_back = GN_POLYGON_LINE;
    c.pipeline.program = program;
    c.mesh = mesh_of(half, 4, 3);
    largest_count = 0;
    assert_int_equal(draw(), GN_OK);
    assert_int_equal(largest_count, GN_LANES);
}

typedef struct place {
    gn_vec4 color;
} place;

static gn_vec4 place_vertex(const void *u, gn_vertex *vertex, place *out)
{
    out->color = gn_make4(1.0f, 0.0f, 0.0f, 1.0f);
    return vertex->attribute[GN_ATTRIBUTE_POSITION];
}

static gn_vec4 count_fragment(const void *u, const place *in, gn_fragment *fragment)
{
    ++calls;
    return in->color;
}

GN_SHADERS(use_counting, void, place, place_vertex, count_fragment);

/* Functions of one fragment run once a covered fragment over one lane, and for whole blocks else.
 */
static void functions_run_over_one_lane(void **state)
{
    reset(big, 3, GN_TRIANGLES);
    assert_int_equal(use_counting(&c.pipeline, NULL), GN_OK);
    drawn_with(&c.pipeline.program);
    assert_true(GN_HAVE_ONE_LANE ? calls == SIZE * SIZE : calls % GN_LANES == 0);

    calls = 0;
    c.mesh = mesh_of(half, 4, 3);
    memset(c.color, 0, sizeof c.color);
    assert_int_equal(draw(), GN_OK);
    uint32_t covered = 0;
    for (int i = 0; i < SIZE * SIZE; ++i)
        covered += c.color[i] != 0;
    if (GN_HAVE_ONE_LANE)
        assert_int_equal(calls, covered);
    else
        assert_true(calls > covered && calls % GN_LANES == 0);
}

/* Every ready-made program but the flat one says what it needs, by its maps and their sampler. */
static void ready_made_programs(void **state)
{
    static const unsigned char texel[4] = {255, 255, 255, 255};
    const gn_texture map = texture_of(GN_FORMAT_RGBA8, texel);

    for (int shader = 0; shader < SHADERS; ++shader) {
        const bool has_map =
            shader != VERTEX_COLOR && shader != DEPTH_ONLY && shader != DEPTH_COLOR;
        gn_pipeline p;

        memset(&p, 0, sizeof p);
        reset_uniforms();
        uniforms.depth.white = 1.0f;
        uniforms.unlit.map = uniforms.lit.material.diffuse_map = &map;
        uniforms.metallic.material.emissive_map.texture = &map;
        uniforms.unlit.sampler.minify = uniforms.lit.material.sampler.minify =
            uniforms.metallic.material.emissive_map.sampler.minify = GN_MINIFY_LINEAR;
        assert_int_equal(use_shader(shader, &p), GN_OK);
        if (!GN_HAVE_ONE_LANE || shader == FLAT) {
            assert_null(p.program.needs_quads);
            continue;
        }
        assert_false(p.program.needs_quads(&p.program));
        uniforms.unlit.sampler.minify = uniforms.lit.material.sampler.minify =
            uniforms.metallic.material.emissive_map.sampler.minify = GN_MINIFY_NEAREST;
        assert_int_equal(p.program.needs_quads(&p.program), has_map);
        uniforms.unlit.map = uniforms.lit.material.diffuse_map = NULL;
        uniforms.metallic.material.emissive_map.texture = NULL;
        assert_false(p.program.needs_quads(&p.program));
        p.program.vertex_shader = pass_positions;
        assert_true(p.program.needs_quads(&p.program));
    }
}

static gn_sampler asked;
static gn_texture asked_texture;

static void look_up(const void *u, const gn_fragment_input *input, gn_fragment_output *output)
{
    gn_fragment_lookup_2d(input, &asked_texture, &asked, input->varying[0], input->varying[1],
                          output->color);
}

/* A lookup that needs neighbours which the program has said not to need is black, and a fault. */
static void broken_promises(void **state)
{
    static const unsigned char red[4] = {255, 0, 0, 255};

    reset(big, 3, GN_TRIANGLES);
    asked_texture = texture_of(GN_FORMAT_RGBA8, red);
    memset(&asked, 0, sizeof asked);
    asked.minify = GN_MINIFY_LINEAR;
    wants_quads = false;
    c.pipeline.program.fragment_shader = look_up;
    c.pipeline.program.needs_quads = quads_as_wanted;
    const gn_program program = c.pipeline.program;
    drawn_with(&program);

    asked.minify = GN_MINIFY_NEAREST;
    assert_int_equal(draw(), GN_HAVE_ONE_LANE ? GN_NOT_COMPILED : GN_OK);
    assert_int_equal(c.color[0], GN_HAVE_ONE_LANE ? 0xFF000000u : 0xFF0000FFu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(neighbours_of_lookups),
        cmocka_unit_test(programs_say_what_they_need),
        cmocka_unit_test(functions_run_over_one_lane),
        cmocka_unit_test(ready_made_programs),
        cmocka_unit_test(broken_promises),
    };
    return cmocka_run_group_tests_name("one_lane", tests, NULL, NULL);
}
