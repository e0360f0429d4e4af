/* The material of glTF 2.0: what gn_use_metallic_roughness refuses, and its pixels against the
 * formulas of the specification's appendix B, computed in double from the angles. */
#include "ready_made.h"

#define PI 3.14159265358979323846

static gn_metallic_roughness *const material = &uniforms.metallic.material;
static gn_light *const light = &uniforms.metallic.light;

/* The eye at the origin looks along -z at a surface 2 away, which faces it. The light is behind the
 * eye. The surface is white and matte. */
static int reset(void **state)
{
    static const float white[GN_SHADER_VARYINGS] = {1.0f, 1.0f, 1.0f, 0.5f, 0.25f, 0.75f,
                                                    0.0f, 0.0f, 1.0f, 0.0f, 0.0f,  -2.0f,
                                                    1.0f, 0.0f, 0.0f, 1.0f};

    reset_uniforms();
    light->direction.z = 1.0f;
    light->diffuse = (gn_vec3){1.0f, 1.0f, 1.0f};
    material->roughness = material->normal_scale = material->occlusion_strength = 1.0f;
    set_varyings(0, white, GN_SHADER_VARYINGS);
    is_front = true;
    return 0;
}

static void expect(double red, double green, double blue)
{
    expect_color(METALLIC_ROUGHNESS, red, green, blue);
}

static void use_ambient_light_alone(void)
{
    light->diffuse = (gn_vec3){0.0f, 0.0f, 0.0f};
    light->ambient = (gn_vec3){1.0f, 1.0f, 1.0f};
}

/* The reflectance of appendix B with the height-correlated visibility, times N.L, for a base colour
 * in one channel. */
static double reflectance(double base, double metallic, double roughness, double n_l, double n_v,
                          double n_h, double v_h)
{
    const double a = roughness * roughness, a2 = a * a;
    const double f0 = 0.04 + (base - 0.04) * metallic;
    const double fresnel = f0 + (1.0 - f0) * pow(1.0 - v_h, 5.0);
    const double distribution = a2 / (PI * pow(n_h * n_h * (a2 - 1.0) + 1.0, 2.0));
    const double visibility =
        0.5 / (n_l * sqrt(n_v * n_v * (1.0 - a2) + a2) + n_v * sqrt(n_l * n_l * (1.0 - a2) + a2));

    return ((1.0 - fresnel) * base * (1.0 - metallic) / PI + fresnel * distribution * visibility) *
           n_l;
}

static void expect_reflectance(double base, double metallic, double roughness, double n_l,
                               double n_v, double n_h, double v_h)
{
    const double r = reflectance(base, metallic, roughness, n_l, n_v, n_h, v_h);

    expect(r, r, r);
}

/* Where N, L and V are one direction, D is 1 / (pi A) and the visibility is 1/4. */
static void surfaces_that_face_light_and_eye(void **state)
{
    expect(0.97 / PI, 0.97 / PI, 0.97 / PI); /* 96 % diffuse, 4 % times 1/4 */
    assert_true(rgba[3] == 0.5f);
    material->metallic = 1.0f;
    expect(0.25 / PI, 0.25 / PI, 0.25 / PI);
    material->roughness = 0.5f; /* A is 1/16 */
    expect(4.0 / PI, 4.0 / PI, 4.0 / PI);
    set_varying(0, 0.5f, 0.25f, 0.0f);
    light->diffuse = (gn_vec3){3.0f, 2.0f, 1.0f};
    expect(3.0 * 0.5 * 4.0 / PI, 2.0 * 0.25 * 4.0 / PI, 0.0);
}

/* V is z. L is at an angle in the plane of x and z, and N at another one. Floats hold (N.H)^2 with
 * an error of 2^-24, which grows where D divides by the small square of a difference from 1. */
static void surfaces_at_angles(void **state)
{
    static const double degrees[][2] = {{20, 0},   {60, 0},   {60, 30},
                                        {60, -20}, {100, 40}, {150, 70}};
    static const float factors[][2] = {{0, 1}, {1, 1}, {0.25f, 0.5f}, {1, 0.25f}, {0, 0.1f}};

    set_varying(0, 0.75f, 0.5f, 0.125f);
    for (size_t i = 0; i < 30; ++i) {
        const double from = degrees[i / 5][0] * PI / 180.0;
        const double normal = degrees[i / 5][1] * PI / 180.0;
        const double n_h = cos(from / 2.0 - normal), v_h = cos(from / 2.0);
        const double metallic = (double)factors[i % 5][0], roughness = (double)factors[i % 5][1];
        const double width = n_h * n_h * (pow(roughness, 4.0) - 1.0) + 1.0;

        light->direction = (gn_vec3){(float)sin(from), 0.0f, (float)cos(from)};
        set_varying(NORMAL, 2.0f * (float)sin(normal), 0.0f, 2.0f * (float)cos(normal));
        material->metallic = factors[i % 5][0];
        material->roughness = factors[i % 5][1];
        shade(METALLIC_ROUGHNESS);
        for (int c = 0; c < 3; ++c) {
            const double expected = reflectance((double)varying[c][0], metallic, roughness,
                                                cos(from - normal), cos(normal), n_h, v_h);

            assert_true(fabs((double)rgba[c] - expected) <= (1e-5 + 4e-7 / width) * expected);
        }
    }
}

/* Light from behind reflects nothing, whatever the eye sees; the light at the eye's back gives no
 * direction H. Only ambient light and emission are left. */
static void surfaces_away_from_the_light(void **state)
{
    static const gn_vec3 directions[] = {
        {0.0f, 0.0f, -1.0f}, {1.0f, 0.0f, 0.0f}, {0.8f, 0.0f, -0.6f}};

    for (int i = 0; i < 3; ++i) {
        reset(state);
        light->direction = directions[i];
        light->ambient = (gn_vec3){0.5f, 0.25f, 0.0f};
        material->emissive = (gn_vec3){0.0f, 0.125f, 2.0f};
        material->roughness = i == 2 ? 0.0f : 1.0f;
        expect(0.5 * 1.04, 0.25 * 1.04 + 0.125, 2.0);
        set_varying(NORMAL, 1.0f, 0.0f, 0.0f); /* the eye sees the edge */
        light->direction = (gn_vec3){-1.0f, 0.0f, 0.0f};
        expect(0.5 * 1.04, 0.25 * 1.04 + 0.125, 2.0);
    }
    reset(state);
    set_varying(NORMAL, 0.0f, 0.0f, 0.0f); /* a mesh without normals */
    light->ambient.x = 0.5f;
    expect(0.5 * 1.04, 0.0, 0.0);
}

static void smooth_surfaces_have_the_least_roughness(void **state)
{
    float smooth[4];

    material->metallic = 1.0f;
    material->roughness = 0.0f;
    shade(METALLIC_ROUGHNESS);
    memcpy(smooth, rgba, sizeof smooth);
    material->roughness = 0.045f;
    shade(METALLIC_ROUGHNESS);
    assert_memory_equal(smooth, rgba, sizeof smooth);
    /* A = 0.045^4; floats hold (N.H)^2 * (A - 1) + 1 to about 3 %. */
    assert_true(fabs((double)smooth[0] / (0.25 / (PI * pow(0.045, 4.0))) - 1.0) < 0.07);
}

static void lights_add_up(void **state)
{
    gn_light more[2];

    memset(more, 0, sizeof more);
    more[0].direction = (gn_vec3){0.6f, 0.0f, 0.8f};
    more[0].diffuse = (gn_vec3){0.5f, 0.0f, 0.0f};
    more[0].ambient = (gn_vec3){0.0f, 0.25f, 0.0f};
    more[1].kind = GN_LIGHT_POINT; /* at the eye, 2 away */
    more[1].quadratic = 1.0f;
    more[1].diffuse = (gn_vec3){0.0f, 4.0f, 0.0f};
    light->ambient = (gn_vec3){0.5f, 0.5f, 0.0f};
    uniforms.metallic.more_lights = more;
    uniforms.metallic.more_light_count = 2;
    expect(0.97 / PI + 0.5 * 1.04 +
               0.5 * reflectance(1.0, 0.0, 1.0, 0.8, 1.0, sqrt(0.9), sqrt(0.9)),
           2.0 * 0.97 / PI + 0.75 * 1.04, 0.97 / PI);
}

/* The byte 188 of sRGB is ((188 / 255 + 0.055) / 1.055)^2.4; alpha is linear. */
static void maps(void **state)
{
    static const float rough[4] = {9.0f, 0.5f, 0.25f, 9.0f}, open[4] = {0.25f, 9.0f, 9.0f, 9.0f},
                       glow[4] = {0.5f, 0.25f, 1.0f, 9.0f}, half[4] = {0.5f, 1.0f, 1.0f, 0.5f};
    static const uint8_t bytes[4] = {188, 255, 0, 128};
    const gn_texture texture[5] = {
        texture_of(GN_FORMAT_RGBA32F, rough), texture_of(GN_FORMAT_RGBA32F, open),
        texture_of(GN_FORMAT_RGBA32F, glow), texture_of(GN_FORMAT_RGBA32F, half),
        texture_of(GN_FORMAT_SRGB8_A8, bytes)};

    material->metallic_roughness_map.texture = &texture[0];
    material->metallic = 1.0f;
    expect_reflectance(1.0, 0.25, 0.5, 1.0, 1.0, 1.0, 1.0);
    material->metallic = 0.5f;
    material->base_color_map.texture = &texture[3];
    expect(reflectance(0.5, 0.125, 0.5, 1.0, 1.0, 1.0, 1.0),
           reflectance(1.0, 0.125, 0.5, 1.0, 1.0, 1.0, 1.0),
           reflectance(1.0, 0.125, 0.5, 1.0, 1.0, 1.0, 1.0));
    assert_true(rgba[3] == 0.25f);

    reset(state);
    use_ambient_light_alone();
    material->occlusion_map.texture = &texture[1];
    material->emissive_map.texture = &texture[2];
    material->emissive = (gn_vec3){1.0f, 2.0f, 0.0f};
    for (int i = 0; i < 3; ++i) {
        const double left = 1.04 * (1.0 - 0.75 * 0.5 * i);

        material->occlusion_strength = 0.5f * (float)i;
        expect(left + 0.5, left + 0.5, left);
    }
    reset(state);
    use_ambient_light_alone();
    material->base_color_map.texture = &texture[4];
    shade(METALLIC_ROUGHNESS);
    assert_true(fabs((double)rgba[0] - 0.04 - pow((188.0 / 255.0 + 0.055) / 1.055, 2.4)) < 1e-3);
    expect((double)rgba[0], 1.04, 0.04);
    assert_float_equal(rgba[3], 0.5 * 128.0 / 255.0, 2e-6);
}

/* The map's vector is (0.6, 0, 0.8); a scale of 0.5 makes it (0.3, 0, 0.8). The tangent is x, so
 * the normal lies in the plane of x and z. */
static void normal_maps_are_scaled(void **state)
{
    static const float tilted[4] = {0.8f, 0.5f, 0.9f, 0.0f};
    const gn_texture texture = texture_of(GN_FORMAT_RGBA32F, tilted);

    material->normal_map.texture = &texture;
    material->metallic = 1.0f;
    for (int i = 0; i < 3; ++i) {
        const double scale = 0.5 * i, cosine = 0.8 / sqrt(0.36 * scale * scale + 0.64);

        material->normal_scale = (float)scale;
        expect_reflectance(1.0, 1.0, 1.0, cosine, cosine, cosine, 1.0);
    }
}

static void back_faces_of_double_sided_surfaces_are_lit(void **state)
{
    set_varying(NORMAL, 0.0f, 0.0f, -1.0f);
    is_front = false;
    expect(0.0, 0.0, 0.0);
    material->double_sided = true;
    expect(0.97 / PI, 0.97 / PI, 0.97 / PI);
    is_front = true;
    expect(0.0, 0.0, 0.0);
}

static void shadows_and_cutoffs(void **state)
{
    static const float nearest = 0.25f;
    const gn_texture map = texture_of(GN_FORMAT_D32F, &nearest);

    light->ambient.x = 0.5f;
    uniforms.metallic.shadow.map = &map;
    uniforms.metallic.shadow.sampler.compare = GN_LESS_OR_EQUAL;
    uniforms.metallic.shadow.clip_from_world.m[3][3] = 1.0f; /* every place is at the depth 0.5 */
    expect(0.5 * 1.04, 0.0, 0.0);
    assert_int_equal(kept, 0xFFFF);
    material->alpha_cutoff = 0.5f;
    varying[ALPHA][3] = 0.49f;
    shade(METALLIC_ROUGHNESS);
    assert_int_equal(kept, 0xFFFF & ~8);
}

static void assert_refused(gn_status expected)
{
    assert_shader_refuses(METALLIC_ROUGHNESS, expected);
    reset(NULL);
}

static void bad_uniforms_leave_the_pipeline(void **state)
{
    gn_map *const map[5] = {&material->base_color_map, &material->metallic_roughness_map,
                            &material->normal_map, &material->occlusion_map,
                            &material->emissive_map};
    float *const factor[3] = {&material->metallic, &material->roughness,
                              &material->occlusion_strength};
    float *const number[4] = {&material->normal_scale, &material->emissive.x, &material->emissive.y,
                              &material->emissive.z};
    static const uint32_t texel = 0;
    gn_texture good = texture_of(GN_FORMAT_RGBA8, &texel), empty = good, line;

    assert_int_equal(gn_texture_packed(GN_TEXTURE_1D, GN_FORMAT_RGBA8, 1, 1, 1, 1, &texel, &line),
                     GN_OK);
    empty.width = 0;
    for (int i = 0; i < 5; ++i) {
        map[i]->texture = &empty;
        assert_refused(GN_INVALID_SIZE);
        map[i]->texture = &line;
        assert_refused(GN_INVALID_ENUM);
        map[i]->texture = &good;
        map[i]->sampler.wrap_s = (gn_wrap)9;
        assert_refused(GN_INVALID_ENUM);
    }
    for (int i = 0; i < 9; ++i) {
        *factor[i / 3] = i % 3 == 0 ? NAN : i % 3 == 1 ? -0.5f : 1.5f;
        assert_refused(i % 3 == 0 ? GN_NOT_FINITE : GN_OUT_OF_RANGE);
    }
    for (int i = 0; i < 4; ++i) {
        *number[i] = INFINITY;
        assert_refused(GN_NOT_FINITE);
    }
    material->alpha_cutoff = -1.0f;
    assert_refused(GN_OUT_OF_RANGE);
    material->alpha_cutoff = INFINITY;
    assert_refused(GN_NOT_FINITE);
    light->kind = (gn_light_kind)3;
    assert_refused(GN_INVALID_ENUM);
    uniforms.metallic.more_light_count = 1;
    assert_refused(GN_NULL_POINTER);
    uniforms.metallic.shadow.map = &good;
    assert_refused(GN_INVALID_FORMAT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(surfaces_that_face_light_and_eye, reset),
        cmocka_unit_test_setup(surfaces_at_angles, reset),
        cmocka_unit_test(surfaces_away_from_the_light),
        cmocka_unit_test_setup(smooth_surfaces_have_the_least_roughness, reset),
        cmocka_unit_test_setup(lights_add_up, reset),
        cmocka_unit_test_setup(maps, reset),
        cmocka_unit_test_setup(normal_maps_are_scaled, reset),
        cmocka_unit_test_setup(back_faces_of_double_sided_surfaces_are_lit, reset),
        cmocka_unit_test_setup(shadows_and_cutoffs, reset),
        cmocka_unit_test_setup(bad_uniforms_leave_the_pipeline, reset),
    };
    return cmocka_run_group_tests_name("metallic-roughness", tests, NULL, NULL);
}
