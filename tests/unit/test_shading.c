/* The ready-made fragment shaders against gnomon/light.h, at chosen vectors, computed in double and
 * not in the library's order of operations. */
#include <math.h>
#include <string.h>

#include "unit.h"

enum { NORMAL = 6, PLACE = 9, TANGENT = 12, HANDEDNESS = 15 };

static gn_lit_uniforms uniforms;
static float varying[GN_SHADER_VARYINGS][GN_LANES];

/* A camera at the origin of world space looks along -z at a surface of grey 0.5, which faces it at
 * distance 2. The light is behind the camera. */
static int reset(void **state)
{
    (void)state;
    static const float grey[GN_SHADER_VARYINGS] = {0.5f, 0.5f, 0.5f, 0.25f, 0.25f, 0.75f,
                                                   0.0f, 0.0f, 2.0f, 0.0f,  0.0f,  -2.0f,
                                                   1.0f, 0.0f, 0.0f, 1.0f};

    memset(&uniforms, 0, sizeof uniforms);
    for (int i = 0; i < 3; ++i)
        uniforms.normal_matrix.m[i][i] = 1.0f;
    uniforms.light.direction.z = 1.0f;
    uniforms.light.ambient = (gn_vec3){0.1f, 0.1f, 0.1f};
    uniforms.light.diffuse = (gn_vec3){0.8f, 0.8f, 0.8f};
    for (int n = 0; n < GN_SHADER_VARYINGS; ++n)
        for (int l = 0; l < GN_LANES; ++l)
            varying[n][l] = grey[n];
    return 0;
}

static void set_varying(int first, float x, float y, float z)
{
    for (int l = 0; l < GN_LANES; ++l) {
        varying[first][l] = x;
        varying[first + 1][l] = y;
        varying[first + 2][l] = z;
    }
}

/* One texel of floats. */
static gn_texture single(const float texel[4])
{
    gn_texture t;

    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA32F, 1, 1, 1, 1, texel, &t),
                     GN_OK);
    return t;
}

typedef gn_status use_function(gn_pipeline *pipeline, const gn_lit_uniforms *uniforms);

/* The pixel in lane 5 after the shader. Where all lanes have equal inputs, all lanes must have this
 * pixel. */
static void shade(use_function *use, float rgba[4])
{
    static float color[4][GN_LANES];
    static const gn_sampling sampling = {gn_sample_2d, gn_sample, gn_gather, gn_fetch};
    gn_pipeline p = {0};
    gn_fragment_input in = {0};
    gn_fragment_output out = {0};

    assert_int_equal(use(&p, &uniforms), GN_OK);
    in.varying = (const float(*)[GN_LANES])varying;
    in.coverage = 0xFFFF;
    in.sampling = &sampling;
    out.color = color;
    p.program.fragment_shader(p.program.uniforms, &in, &out);
    for (int c = 0; c < 4; ++c)
        rgba[c] = color[c][5];
}

#define NEAR(a, b) assert_true(fabs((double)(a) - (double)(b)) < 2e-6)

static void light_of_one_side(void **state)
{
    (void)state;
    use_function *const uses[] = {gn_use_phong, gn_use_blinn_phong, gn_use_toon};
    float rgba[4];

    for (int i = 0; i < 3; ++i) {
        reset(NULL);
        shade(uses[i], rgba);
        NEAR(rgba[0], 0.5 * (0.1 + 0.8));
        NEAR(rgba[3], 0.25);
        set_varying(NORMAL, 0.0f, 0.0f, -3.0f);
        uniforms.material.specular = (gn_vec3){1.0f, 1.0f, 1.0f};
        uniforms.material.exponent = 2;
        shade(uses[i], rgba);
        NEAR(rgba[1], 0.5 * 0.1);
    }
}

/* N is (0.6, 0, 0.8), so that R.V = 2 * 0.8 * 0.8 - 1 and N.H = 0.8. */
static void highlights(void **state)
{
    (void)state;
    static const uint32_t exponents[] = {0, 1, 2, 3, 5, 32, 77};
    float rgba[4];

    set_varying(NORMAL, 1.2f, 0.0f, 1.6f);
    uniforms.material.specular = (gn_vec3){0.5f, 1.0f, 2.0f};
    for (int i = 0; i < 7; ++i) {
        const double base = 0.5 * (0.1 + 0.8 * 0.8);

        uniforms.material.exponent = exponents[i];
        shade(gn_use_phong, rgba);
        NEAR(rgba[0], base + 0.5 * pow(0.28, exponents[i]));
        NEAR(rgba[2], base + 2.0 * pow(0.28, exponents[i]));
        shade(gn_use_blinn_phong, rgba);
        NEAR(rgba[1], base + pow(0.8, exponents[i]));
    }
}

static void bands(void **state)
{
    (void)state;
    static const struct {
        uint32_t bands;
        float cosine, lit;
    } cases[] = {
        {0, 0.24f, 0.0f}, {0, 0.26f, 1.0f / 3.0f}, {4, 0.51f, 2.0f / 3.0f},     {4, 0.76f, 1.0f},
        {2, 0.49f, 0.0f}, {2, 0.51f, 1.0f},        {256, 0.5f, 128.0f / 255.0f}};
    float rgba[4];

    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const float z = cases[i].cosine;

        set_varying(NORMAL, sqrtf(1.0f - z * z), 0.0f, z);
        uniforms.material.bands = cases[i].bands;
        shade(gn_use_toon, rgba);
        NEAR(rgba[0], 0.5 * (0.1 + 0.8 * (double)cases[i].lit));
    }
}

static void point_lights(void **state)
{
    (void)state;
    float rgba[4];

    uniforms.light.kind = GN_LIGHT_POINT;
    uniforms.light.position = (gn_vec3){4.0f, 0.0f, 1.0f}; /* 5 away, N.L = 0.6 */
    shade(gn_use_phong, rgba);
    NEAR(rgba[0], 0.5 * (0.1 + 0.8 * 0.6));
    uniforms.light.constant = 0.5f;
    uniforms.light.linear = 0.1f;
    uniforms.light.quadratic = 0.04f;
    shade(gn_use_phong, rgba);
    NEAR(rgba[0], 0.5 * (0.1 + 0.8 * 0.6 / 2.0));
    uniforms.material.specular = (gn_vec3){1.0f, 1.0f, 1.0f};
    shade(gn_use_phong, rgba);
    NEAR(rgba[0], 0.5 * (0.1 + 0.8 * 0.6 / 2.0) + 0.5);
}

/* One coefficient alone is enough for a point light to fade. The light is 5 away, and N.L = 0.6. */
static void lights_fade_by_one_coefficient(void **state)
{
    (void)state;
    float *const coefficients[] = {&uniforms.light.constant, &uniforms.light.linear,
                                   &uniforms.light.quadratic};
    static const float values[] = {4.0f, 0.8f, 0.16f};
    float rgba[4];

    for (int i = 0; i < 3; ++i) {
        reset(NULL);
        uniforms.light.kind = GN_LIGHT_POINT;
        uniforms.light.position = (gn_vec3){4.0f, 0.0f, 1.0f};
        *coefficients[i] = values[i];
        shade(gn_use_phong, rgba);
        NEAR(rgba[0], 0.5 * (0.1 + 0.8 * 0.6 / 4.0));
    }
}

/* A light 5 away with N.L = 0.6, whose range ends at twice, at once and at half the distance:
 * max(1 - (d / range)^4, 0). The window multiplies the attenuation. */
static void lights_end_at_their_range(void **state)
{
    (void)state;
    static const double expected[3] = {1.0 - 1.0 / 16.0, 0.0, 0.0};
    static const float ranges[3] = {10.0f, 5.0f, 2.5f};
    float rgba[4];

    uniforms.light.position = (gn_vec3){4.0f, 0.0f, 1.0f};
    for (int i = 0; i < 6; ++i) {
        const double faded = i < 3 ? 1.0 : 0.5;

        uniforms.light.kind = i % 2 ? GN_LIGHT_SPOT : GN_LIGHT_POINT;
        uniforms.light.direction = (gn_vec3){0.8f, 0.0f, 0.6f}; /* its axis */
        uniforms.light.inner_cosine = 0.5f;
        uniforms.light.constant = i < 3 ? 0.0f : 2.0f;
        uniforms.light.range = ranges[i % 3];
        shade(gn_use_phong, rgba);
        NEAR(rgba[0], 0.5 * (0.1 + 0.8 * 0.6 * expected[i % 3] * faded));
    }
    uniforms.light.kind = GN_LIGHT_DIRECTIONAL; /* its range is not read */
    shade(gn_use_phong, rgba);
    NEAR(rgba[0], 0.5 * (0.1 + 0.8 * 0.6));
}

/* The light stands 2 above the surface in the direction of N, so the axis (sin, 0, cos) is at an
 * angle of that cosine to L. KHR_lights_punctual: ((cosine - outer) / (inner - outer))^2. */
static void cones_of_spot_lights(void **state)
{
    (void)state;
    static const struct {
        float cosine, inner, outer;
        double part;
    } cases[] = {
        {0.95f, 0.9f, 0.7f, 1.0},    {0.9f, 0.9f, 0.7f, 1.0},  {0.8f, 0.9f, 0.7f, 0.25},
        {0.75f, 0.9f, 0.7f, 0.0625}, {0.65f, 0.9f, 0.7f, 0.0}, {-1.0f, 0.9f, 0.7f, 0.0},
        {0.71f, 0.7f, 0.7f, 1.0},    {0.69f, 0.7f, 0.7f, 0.0}, /* a sharp border */
        {0.5f, 0.0f, 0.0f, 1.0},     {-0.5f, 0.0f, 0.0f, 0.0}, /* zeroed: a half space */
        {0.0f, 0.5f, -0.5f, 0.25},
    };
    float rgba[4];

    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const float cosine = cases[i].cosine;

        uniforms.light.kind = GN_LIGHT_SPOT;
        uniforms.light.position = (gn_vec3){0.0f, 0.0f, 0.0f};
        uniforms.light.direction = (gn_vec3){sqrtf(1.0f - cosine * cosine), 0.0f, cosine};
        uniforms.light.inner_cosine = cases[i].inner;
        uniforms.light.outer_cosine = cases[i].outer;
        shade(gn_use_phong, rgba);
        NEAR(rgba[0], 0.5 * (0.1 + 0.8 * cases[i].part));
    }
}

/* Three lights: light 0 at N.L = 1, a directional one at 0.6 and a point light at 0.8, which fades
 * to a half. Their ambients add up too. */
static void set_three_lights(gn_light more[2])
{
    static const gn_light none;

    more[0] = more[1] = none;
    more[0].direction = (gn_vec3){0.8f, 0.0f, 0.6f};
    more[0].ambient = (gn_vec3){0.01f, 0.02f, 0.03f};
    more[0].diffuse = (gn_vec3){0.25f, 0.5f, 1.0f};
    more[1].kind = GN_LIGHT_POINT;
    more[1].position = (gn_vec3){-3.0f, 0.0f, 2.0f};
    more[1].constant = 2.0f;
    more[1].diffuse = (gn_vec3){0.5f, 0.25f, 0.0f};
    uniforms.more_lights = more;
    uniforms.more_light_count = 2;
}

static void lights_add_up(void **state)
{
    (void)state;
    static use_function *const uses[] = {gn_use_phong, gn_use_blinn_phong};
    static const double ambient[3] = {0.11, 0.12, 0.13};
    static const double diffuse[3] = {0.8 + 0.25 * 0.6 + 0.5 * 0.4, 0.8 + 0.5 * 0.6 + 0.25 * 0.4,
                                      0.8 + 1.0 * 0.6};
    gn_light more[2];
    float rgba[4];

    for (int i = 0; i < 2; ++i) {
        reset(NULL);
        set_three_lights(more);
        shade(uses[i], rgba);
        for (int c = 0; c < 3; ++c)
            NEAR(rgba[c], 0.5 * (ambient[c] + diffuse[c]));
        NEAR(rgba[3], 0.25);
        uniforms.material.specular = (gn_vec3){1.0f, 0.5f, 0.25f};
        uniforms.material.exponent = 2;
        shade(uses[i], rgba);
        /* R.V is N.L here, as V is N; N.H is the cosine of half the angle. The point light's
         * highlight fades with the light. */
        const double shone = i == 0 ? 1.0 + 0.36 + 0.64 / 2.0 : 1.0 + 0.8 + 0.9 / 2.0;

        for (int c = 0; c < 3; ++c)
            NEAR(rgba[c], 0.5 * (ambient[c] + diffuse[c]) + shone / (1 << c));
    }
}

/* In four bands the cosines 1, 0.6 and 0.8 become 1, 2/3 and 1. */
static void bands_of_several_lights(void **state)
{
    (void)state;
    gn_light more[2];
    float rgba[4];

    set_three_lights(more);
    shade(gn_use_toon, rgba);
    NEAR(rgba[0], 0.5 * (0.11 + 0.8 + 0.25 * 2.0 / 3.0 + 0.5 / 2.0));
}

/* A shadow falls from light 0 alone. */
static void shadows_of_several_lights(void **state)
{
    (void)state;
    static const float nearest = 0.25f;
    gn_texture map;
    gn_light more[2];
    float rgba[4];

    set_three_lights(more);
    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_D32F, 1, 1, 1, 1, &nearest, &map),
                     GN_OK);
    uniforms.shadow.map = &map;
    uniforms.shadow.sampler.compare = GN_LESS_OR_EQUAL;
    uniforms.shadow.clip_from_world.m[3][3] = 1.0f; /* every place is at the depth 0.5 */
    shade(gn_use_phong, rgba);
    NEAR(rgba[0], 0.5 * (0.11 + 0.25 * 0.6 + 0.5 * 0.4));
}

/* A plane with the normal (0.6, 0, 0.8): from pixel to pixel the place moves by (0.08, 0, -0.06) to
 * the right and by (0, 0.1, 0) up. */
static void normals_of_faces(void **state)
{
    (void)state;
    float rgba[4];

    for (int l = 0; l < GN_LANES; ++l) {
        const float x = (float)(l % 4), y = (float)(l / 4);

        varying[PLACE][l] = 0.08f * x;
        varying[PLACE + 1][l] = 0.1f * y;
        varying[PLACE + 2][l] = -0.06f * x - 2.0f;
    }
    set_varying(NORMAL, 0.0f, 0.0f, 0.0f);
    shade(gn_use_flat, rgba);
    NEAR(rgba[0], 0.5 * (0.1 + 0.8 * 0.8));
    gn_light more = uniforms.light;
    more.direction = (gn_vec3){0.6f, 0.0f, 0.8f}; /* N */
    uniforms.more_lights = &more;
    uniforms.more_light_count = 1;
    shade(gn_use_flat, rgba);
    NEAR(rgba[0], 0.5 * (0.1 + 0.8 * 0.8 + 0.1 + 0.8));
}

static void maps_multiply_and_add(void **state)
{
    (void)state;
    const float diffuse[4] = {0.5f, 0.25f, 1.0f, 0.5f}, specular[4] = {0.5f, 0.0f, 1.0f, 9.0f},
                glow[4] = {0.0f, 0.125f, 0.25f, 9.0f};
    const gn_texture map[3] = {single(diffuse), single(specular), single(glow)};
    float rgba[4];

    uniforms.material.diffuse_map = &map[0];
    uniforms.material.specular_map = &map[1];
    uniforms.material.glow_map = &map[2];
    uniforms.material.specular = (gn_vec3){0.5f, 0.5f, 0.5f};
    shade(gn_use_phong, rgba);
    NEAR(rgba[0], 0.25 * 0.9 + 0.25);
    NEAR(rgba[1], 0.125 * 0.9 + 0.125);
    NEAR(rgba[2], 0.5 * 0.9 + 0.5 + 0.25);
    NEAR(rgba[3], 0.125);
}

/* The map's vector is (0.6, 0, 0.8). Normals have twice and tangents three times their proper
 * length, as interpolation may make them. */
static void normal_maps(void **state)
{
    (void)state;
    const float tilted[4] = {0.8f, 0.5f, 0.9f, 0.0f}, up[4] = {0.5f, 1.0f, 0.5f, 0.0f};
    const gn_texture map[2] = {single(tilted), single(up)};
    float rgba[4];

    uniforms.material.normal_map = &map[0];
    uniforms.normal_matrix.m[0][0] = -1.0f;
    shade(gn_use_normal_color, rgba);
    NEAR(rgba[0], 0.5 - 0.3);
    NEAR(rgba[2], 0.5 + 0.4);
    NEAR(rgba[3], 1.0);
    uniforms.material.normal_space = GN_NORMAL_OF_TANGENTS;
    set_varying(NORMAL, 0.0f, 0.0f, 1.0f);
    set_varying(TANGENT, 0.0f, -1.0f, 0.0f); /* so that the bitangent is x */
    shade(gn_use_normal_color, rgba);
    NEAR(rgba[1], 0.5 - 0.3);
    NEAR(rgba[2], 0.5 + 0.4);
    uniforms.material.normal_map = &map[1];
    shade(gn_use_normal_color, rgba);
    NEAR(rgba[0], 1.0);
    for (int l = 0; l < GN_LANES; ++l)
        varying[HANDEDNESS][l] = -1.0f;
    shade(gn_use_normal_color, rgba);
    NEAR(rgba[0], 0.0);
}

/* Runs a shader with alphas of 0.2, 0.4, 0.6, 0.8 and NaN in lanes 0 to 4 under a map that halves
 * alpha. Returns the bits of the fragments kept among the five. */
static uint32_t kept_by(use_function *use, float cutoff)
{
    static const float halving[4] = {1.0f, 1.0f, 1.0f, 0.5f};
    static float color[4][GN_LANES];
    static const gn_sampling sampling = {gn_sample_2d, gn_sample, gn_gather, gn_fetch};
    const gn_texture map = single(halving);
    gn_unlit_uniforms unlit = {0};
    gn_pipeline p = {0};
    gn_fragment_input in = {0};
    gn_fragment_output out = {0};

    for (int l = 0; l < 4; ++l)
        varying[3][l] = 0.2f + 0.2f * (float)l;
    varying[3][4] = NAN;
    uniforms.material.diffuse_map = unlit.map = &map;
    uniforms.material.alpha_cutoff = unlit.alpha_cutoff = cutoff;
    assert_int_equal(use ? use(&p, &uniforms) : gn_use_unlit(&p, &unlit), GN_OK);
    in.varying = (const float(*)[GN_LANES])varying;
    in.coverage = 0xFFFF;
    in.sampling = &sampling;
    out.color = color;
    out.kept = 0xFFFF;
    p.program.fragment_shader(p.program.uniforms, &in, &out);
    return out.kept & 31;
}

/* glTF 2.0 section 3.9.4: an alpha that is equal to the cut-off is kept. NaN is not below it. */
static void cutoffs(void **state)
{
    (void)state;
    use_function *const uses[] = {NULL,        gn_use_flat,  gn_use_gouraud,
                                  gn_use_toon, gn_use_phong, gn_use_blinn_phong};

    for (int i = 0; i < 6; ++i) {
        reset(NULL);
        assert_int_equal(kept_by(uses[i], 0.0f), 31);
        assert_int_equal(kept_by(uses[i], 0.15f), 30);
        assert_int_equal(kept_by(uses[i], 0.5f * (0.2f + 0.2f * 2.0f)), 28);
        assert_int_equal(kept_by(uses[i], 1.0f), 16);
    }
    assert_int_equal(kept_by(gn_use_normal_color, 1.0f), 31);
}

/* The light's camera maps z = -2 to the depth 0.6. */
static void shadows(void **state)
{
    (void)state;
    static const float texels[2] = {0.5f, 0.75f};
    gn_texture map[2];
    float rgba[4];

    for (int i = 0; i < 2; ++i)
        assert_int_equal(
            gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_D32F, 1, 1, 1, 1, &texels[i], &map[i]),
            GN_OK);
    uniforms.shadow.sampler.compare = GN_LESS_OR_EQUAL;
    uniforms.shadow.clip_from_world.m[2][2] = -0.1f;
    uniforms.shadow.clip_from_world.m[3][3] = 1.0f;
    uniforms.material.specular = (gn_vec3){1.0f, 1.0f, 1.0f};
    uniforms.shadow.map = &map[0];
    shade(gn_use_phong, rgba);
    NEAR(rgba[0], 0.5 * 0.1);
    uniforms.shadow.map = &map[1];
    shade(gn_use_phong, rgba);
    NEAR(rgba[0], 0.5 * 0.9 + 1.0);
}

static void depths_as_grey(void **state)
{
    (void)state;
    static float color[4][GN_LANES], position[4][GN_LANES];
    gn_depth_color_uniforms depth = {{{{0}}}, 0.0f, 0.0f};
    gn_pipeline p = {0};
    gn_fragment_input in = {0};
    gn_fragment_output out = {0};

    assert_int_equal(gn_use_depth_color(&p, &depth), GN_OK);
    assert_true(p.program.fragment_reads_position);
    for (int l = 0; l < GN_LANES; ++l)
        position[2][l] = 0.625f;
    in.position = (const float(*)[GN_LANES])position;
    out.color = color;
    p.program.fragment_shader(&depth, &in, &out);
    assert_true(color[0][3] == 0.625f && color[3][3] == 1.0f);
    depth.black = 0.5f;
    depth.white = 0.75f;
    p.program.fragment_shader(&depth, &in, &out);
    assert_true(color[1][15] == 0.5f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(light_of_one_side, reset),
        cmocka_unit_test_setup(highlights, reset),
        cmocka_unit_test_setup(bands, reset),
        cmocka_unit_test_setup(point_lights, reset),
        cmocka_unit_test(lights_fade_by_one_coefficient),
        cmocka_unit_test_setup(lights_end_at_their_range, reset),
        cmocka_unit_test_setup(cones_of_spot_lights, reset),
        cmocka_unit_test_setup(lights_add_up, reset),
        cmocka_unit_test_setup(bands_of_several_lights, reset),
        cmocka_unit_test_setup(shadows_of_several_lights, reset),
        cmocka_unit_test_setup(normals_of_faces, reset),
        cmocka_unit_test_setup(maps_multiply_and_add, reset),
        cmocka_unit_test_setup(normal_maps, reset),
        cmocka_unit_test(cutoffs),
        cmocka_unit_test_setup(shadows, reset),
        cmocka_unit_test_setup(depths_as_grey, reset),
    };
    return cmocka_run_group_tests_name("shading", tests, NULL, NULL);
}
