/* The ready-made fragment shaders but for metallic-roughness, against gnomon/light.h at chosen
 * vectors, computed in double and not in the library's order of operations. */
#include "ready_made.h"

static gn_light *const light = &uniforms.lit.light;
static gn_material *const material = &uniforms.lit.material;

/* A camera at the origin of world space looks along -z at a surface of grey 0.5, which faces it at
 * distance 2. The light is behind the camera. */
static int reset(void **state)
{
    static const float grey[GN_SHADER_VARYINGS] = {0.5f, 0.5f, 0.5f, 0.25f, 0.25f, 0.75f,
                                                   0.0f, 0.0f, 2.0f, 0.0f,  0.0f,  -2.0f,
                                                   1.0f, 0.0f, 0.0f, 1.0f};

    reset_uniforms();
    light->direction.z = 1.0f;
    light->ambient = (gn_vec3){0.1f, 0.1f, 0.1f};
    light->diffuse = (gn_vec3){0.8f, 0.8f, 0.8f};
    set_varyings(0, grey, GN_SHADER_VARYINGS);
    return 0;
}

static void light_of_one_side(void **state)
{
    static const int shaders[] = {PHONG, BLINN_PHONG, TOON};

    for (int i = 0; i < 3; ++i) {
        reset(state);
        expect_grey(shaders[i], 0.5 * (0.1 + 0.8));
        assert_float_equal(rgba[3], 0.25f, 2e-6f);
        set_varying(NORMAL, 0.0f, 0.0f, -3.0f);
        material->specular = (gn_vec3){1.0f, 1.0f, 1.0f};
        material->exponent = 2;
        expect_grey(shaders[i], 0.5 * 0.1);
    }
}

/* N is (0.6, 0, 0.8), so that R.V = 2 * 0.8 * 0.8 - 1 and N.H = 0.8. */
static void highlights(void **state)
{
    static const uint32_t exponents[] = {0, 1, 2, 3, 5, 32, 77};

    set_varying(NORMAL, 1.2f, 0.0f, 1.6f);
    material->specular = (gn_vec3){0.5f, 1.0f, 2.0f};
    for (int i = 0; i < 7; ++i) {
        const double base = 0.5 * (0.1 + 0.8 * 0.8);
        const double r = pow(0.28, exponents[i]), n = pow(0.8, exponents[i]);

        material->exponent = exponents[i];
        expect_color(PHONG, base + 0.5 * r, base + r, base + 2.0 * r);
        expect_color(BLINN_PHONG, base + 0.5 * n, base + n, base + 2.0 * n);
    }
}

static void bands(void **state)
{
    static const struct {
        uint32_t bands;
        float cosine, lit;
    } cases[] = {
        {0, 0.24f, 0.0f}, {0, 0.26f, 1.0f / 3.0f}, {4, 0.51f, 2.0f / 3.0f},     {4, 0.76f, 1.0f},
        {2, 0.49f, 0.0f}, {2, 0.51f, 1.0f},        {256, 0.5f, 128.0f / 255.0f}};

    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const float z = cases[i].cosine;

        set_varying(NORMAL, sqrtf(1.0f - z * z), 0.0f, z);
        material->bands = cases[i].bands;
        expect_grey(TOON, 0.5 * (0.1 + 0.8 * (double)cases[i].lit));
    }
}

/* 5 away, with N.L = 0.6. */
static void set_point_light(float constant, float linear, float quadratic)
{
    light->kind = GN_LIGHT_POINT;
    light->position = (gn_vec3){4.0f, 0.0f, 1.0f};
    light->constant = constant;
    light->linear = linear;
    light->quadratic = quadratic;
}

/* One coefficient alone is enough for a light to fade. */
static void point_lights(void **state)
{
    static const struct {
        float constant, linear, quadratic;
        double attenuation;
    } cases[] = {
        {0, 0, 0, 1}, {0.5f, 0.1f, 0.04f, 2}, {4, 0, 0, 4}, {0, 0.8f, 0, 4}, {0, 0, 0.16f, 4}};

    for (int i = 0; i < 5; ++i) {
        set_point_light(cases[i].constant, cases[i].linear, cases[i].quadratic);
        expect_grey(PHONG, 0.5 * (0.1 + 0.8 * 0.6 / cases[i].attenuation));
    }
    set_point_light(2.0f, 0.0f, 0.0f);
    material->specular = (gn_vec3){1.0f, 1.0f, 1.0f};
    expect_grey(PHONG, 0.5 * (0.1 + 0.8 * 0.6 / 2.0) + 0.5);
}

/* Ranges that end at twice, at once and at half the distance: max(1 - (d / range)^4, 0). The window
 * multiplies the attenuation. */
static void lights_end_at_their_range(void **state)
{
    static const double expected[3] = {1.0 - 1.0 / 16.0, 0.0, 0.0};
    static const float ranges[3] = {10.0f, 5.0f, 2.5f};

    light->direction = (gn_vec3){0.8f, 0.0f, 0.6f}; /* a spot light's axis */
    light->inner_cosine = 0.5f;
    for (int i = 0; i < 6; ++i) {
        set_point_light(i < 3 ? 0.0f : 2.0f, 0.0f, 0.0f);
        light->kind = i % 2 ? GN_LIGHT_SPOT : GN_LIGHT_POINT;
        light->range = ranges[i % 3];
        expect_grey(PHONG, 0.5 * (0.1 + 0.8 * 0.6 * expected[i % 3] / (i < 3 ? 1.0 : 2.0)));
    }
    light->kind = GN_LIGHT_DIRECTIONAL; /* its range is not read */
    expect_grey(PHONG, 0.5 * (0.1 + 0.8 * 0.6));
}

/* The light stands 2 above the surface in the direction of N, so the axis (sin, 0, cos) is at an
 * angle of that cosine to L. KHR_lights_punctual: ((cosine - outer) / (inner - outer))^2. */
static void cones_of_spot_lights(void **state)
{
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

    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const float cosine = cases[i].cosine;

        light->kind = GN_LIGHT_SPOT;
        light->direction = (gn_vec3){sqrtf(1.0f - cosine * cosine), 0.0f, cosine};
        light->inner_cosine = cases[i].inner;
        light->outer_cosine = cases[i].outer;
        expect_grey(PHONG, 0.5 * (0.1 + 0.8 * cases[i].part));
    }
}

/* Three lights: light 0 at N.L = 1, a directional one at 0.6 and a point light at 0.8, which fades
 * to a half. Their ambients add up too. */
static void set_three_lights(gn_light more[2])
{
    memset(more, 0, 2 * sizeof *more);
    more[0].direction = (gn_vec3){0.8f, 0.0f, 0.6f};
    more[0].ambient = (gn_vec3){0.01f, 0.02f, 0.03f};
    more[0].diffuse = (gn_vec3){0.25f, 0.5f, 1.0f};
    more[1].kind = GN_LIGHT_POINT;
    more[1].position = (gn_vec3){-3.0f, 0.0f, 2.0f};
    more[1].constant = 2.0f;
    more[1].diffuse = (gn_vec3){0.5f, 0.25f, 0.0f};
    uniforms.lit.more_lights = more;
    uniforms.lit.more_light_count = 2;
}

/* R.V is N.L here, as V is N; N.H is the cosine of half the angle. The point light's highlight
 * fades with the light. In four bands the cosines 1, 0.6 and 0.8 become 1, 2/3 and 1. A shadow
 * falls from light 0 alone. */
static void lights_add_up(void **state)
{
    static const double r = 0.5 * (0.11 + 0.8 + 0.25 * 0.6 + 0.5 * 0.4),
                        g = 0.5 * (0.12 + 0.8 + 0.5 * 0.6 + 0.25 * 0.4),
                        b = 0.5 * (0.13 + 0.8 + 1.0 * 0.6);
    static const float nearest = 0.25f;
    const gn_texture map = texture_of(GN_FORMAT_D32F, &nearest);
    gn_light more[2];

    set_three_lights(more);
    expect_color(PHONG, r, g, b);
    expect_color(BLINN_PHONG, r, g, b);
    expect_color(TOON, 0.5 * (0.11 + 0.8 + 0.25 * 2.0 / 3.0 + 0.5 / 2.0),
                 0.5 * (0.12 + 0.8 + 0.5 * 2.0 / 3.0 + 0.25 / 2.0), 0.5 * (0.13 + 0.8 + 2.0 / 3.0));
    material->specular = (gn_vec3){1.0f, 0.5f, 0.25f};
    material->exponent = 2;
    for (int i = 0; i < 2; ++i) {
        const double shone = i == 0 ? 1.0 + 0.36 + 0.64 / 2.0 : 1.0 + 0.8 + 0.9 / 2.0;

        expect_color(PHONG + i, r + shone, g + shone / 2, b + shone / 4);
    }
    memset(&material->specular, 0, sizeof material->specular);
    uniforms.lit.shadow.map = &map;
    uniforms.lit.shadow.sampler.compare = GN_LESS_OR_EQUAL;
    uniforms.lit.shadow.clip_from_world.m[3][3] = 1.0f; /* every place is at the depth 0.5 */
    expect_color(PHONG, r - 0.5 * 0.8, g - 0.5 * 0.8, b - 0.5 * 0.8);
}

/* A plane with the normal (0.6, 0, 0.8): from pixel to pixel the place moves by (0.08, 0, -0.06) to
 * the right and by (0, 0.1, 0) up. */
static void normals_of_faces(void **state)
{
    gn_light more = *light;

    for (int l = 0; l < GN_LANES; ++l) {
        const float x = (float)(l % 4), y = (float)(l / 4);

        varying[PLACE][l] = 0.08f * x;
        varying[PLACE + 1][l] = 0.1f * y;
        varying[PLACE + 2][l] = -0.06f * x - 2.0f;
    }
    set_varying(NORMAL, 0.0f, 0.0f, 0.0f);
    expect_grey(FLAT, 0.5 * (0.1 + 0.8 * 0.8));
    more.direction = (gn_vec3){0.6f, 0.0f, 0.8f}; /* N */
    uniforms.lit.more_lights = &more;
    uniforms.lit.more_light_count = 1;
    expect_grey(FLAT, 0.5 * (0.1 + 0.8 * 0.8 + 0.1 + 0.8));
}

static void maps_multiply_and_add(void **state)
{
    const float diffuse[4] = {0.5f, 0.25f, 1.0f, 0.5f}, specular[4] = {0.5f, 0.0f, 1.0f, 9.0f},
                glow[4] = {0.0f, 0.125f, 0.25f, 9.0f};
    const gn_texture map[3] = {texture_of(GN_FORMAT_RGBA32F, diffuse),
                               texture_of(GN_FORMAT_RGBA32F, specular),
                               texture_of(GN_FORMAT_RGBA32F, glow)};

    material->diffuse_map = &map[0];
    material->specular_map = &map[1];
    material->glow_map = &map[2];
    material->specular = (gn_vec3){0.5f, 0.5f, 0.5f};
    expect_color(PHONG, 0.25 * 0.9 + 0.25, 0.125 * 0.9 + 0.125, 0.5 * 0.9 + 0.5 + 0.25);
    assert_true(rgba[3] == 0.125f);
}

/* The map's vector is (0.6, 0, 0.8), and then (0, 1, 0). The tangent is -y, so that the bitangent
 * is x. */
static void normal_maps(void **state)
{
    const float tilted[4] = {0.8f, 0.5f, 0.9f, 0.0f}, up[4] = {0.5f, 1.0f, 0.5f, 0.0f};
    const gn_texture map[2] = {texture_of(GN_FORMAT_RGBA32F, tilted),
                               texture_of(GN_FORMAT_RGBA32F, up)};

    material->normal_map = &map[0];
    uniforms.lit.normal_matrix.m[0][0] = -1.0f;
    expect_color(NORMAL_COLOR, 0.5 - 0.3, 0.5, 0.5 + 0.4);
    assert_true(rgba[3] == 1.0f);
    material->normal_space = GN_NORMAL_OF_TANGENTS;
    set_varying(NORMAL, 0.0f, 0.0f, 1.0f);
    set_varying(TANGENT, 0.0f, -1.0f, 0.0f);
    expect_color(NORMAL_COLOR, 0.5, 0.5 - 0.3, 0.5 + 0.4);
    material->normal_map = &map[1];
    expect_color(NORMAL_COLOR, 1.0, 0.5, 0.5);
    set_varyings(HANDEDNESS, (const float[1]){-1.0f}, 1);
    expect_color(NORMAL_COLOR, 0.0, 0.5, 0.5);
}

/* Alphas of 0.2, 0.4, 0.6, 0.8 and NaN in lanes 0 to 4, under a map that halves alpha. glTF 2.0
 * section 3.9.4: an alpha that is equal to the cut-off is kept. NaN is not below it. */
static void cutoffs(void **state)
{
    static const int shaders[] = {UNLIT, FLAT, GOURAUD, TOON, PHONG, BLINN_PHONG};
    static const float halving[4] = {1.0f, 1.0f, 1.0f, 0.5f};
    static const struct {
        float cutoff;
        uint32_t kept;
    } cases[] = {{0.0f, 31}, {0.15f, 30}, {0.5f * (0.2f + 0.2f * 2.0f), 28}, {1.0f, 16}};
    const gn_texture map = texture_of(GN_FORMAT_RGBA32F, halving);

    for (int l = 0; l < 4; ++l)
        varying[ALPHA][l] = 0.2f + 0.2f * (float)l;
    varying[ALPHA][4] = NAN;
    material->diffuse_map = uniforms.unlit.map = &map;
    for (int i = 0; i < 4; ++i) {
        material->alpha_cutoff = uniforms.unlit.alpha_cutoff = cases[i].cutoff;
        for (int s = 0; s < 6; ++s) {
            shade(shaders[s]);
            assert_int_equal(kept & 31, cases[i].kept);
        }
    }
    shade(NORMAL_COLOR);
    assert_int_equal(kept & 31, 31);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(light_of_one_side),
        cmocka_unit_test_setup(highlights, reset),
        cmocka_unit_test_setup(bands, reset),
        cmocka_unit_test_setup(point_lights, reset),
        cmocka_unit_test_setup(lights_end_at_their_range, reset),
        cmocka_unit_test_setup(cones_of_spot_lights, reset),
        cmocka_unit_test_setup(lights_add_up, reset),
        cmocka_unit_test_setup(normals_of_faces, reset),
        cmocka_unit_test_setup(maps_multiply_and_add, reset),
        cmocka_unit_test_setup(normal_maps, reset),
        cmocka_unit_test_setup(cutoffs, reset),
    };
    return cmocka_run_group_tests_name("shading", tests, NULL, NULL);
}
