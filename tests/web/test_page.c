/* The page's functions without a browser: states and camera. Dropped models are those of
 * test_page_models.c, pictures the contract's (tests/contract/check_page_pictures.c). */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../unit/unit.h"
#include "page.h"
#include "page_parts.h"
#include "page_text.h"

#define RANDOM_STATES 3000
#define RANDOM_NUMBERS 200000

static uint64_t seed = 7;

static uint32_t any(uint32_t below)
{
    seed = seed * UINT64_C(6364136223846793005) + 1442695040888963407;
    return (uint32_t)(seed >> 33) % below;
}

/* A finite float of any bits. */
static float any_float(void)
{
    for (;;) {
        const uint32_t bits = any(65536) << 16 | any(65536);
        float f;
        memcpy(&f, &bits, sizeof f);
        if (isfinite(f))
            return f;
    }
}

/* A float that a camera may have. */
static float any_distance(void)
{
    float f;
    do
        f = fabsf(any_float());
    while (!(f > 1e-18f && f < 1e18f));
    return f;
}

static uint32_t bits_of(float f)
{
    uint32_t bits;
    memcpy(&bits, &f, sizeof bits);
    return bits;
}

static void numbers_restore_their_bits(void **state)
{
    static const float special[] = {0.0f,      -0.0f,   1.0f,        0.1f,     999.99994f, 1e9f,
                                    9999999.f, FLT_MAX, FLT_MIN,     -1e-45f,  16777216.f, 1e22f,
                                    1e-10f,    3.4e38f, 8.589973e9f, 1.17e-38f};
    text t = {0};
    for (size_t i = 0; i < RANDOM_NUMBERS; ++i) {
        const float f = i < sizeof special / sizeof *special ? special[i] : any_float();
        float read;
        text_clear(&t);
        text_add_float(&t, f);
        const char *from = text_of(&t);
        assert_true(text_read_float(&from, &read));
        assert_int_equal(*from, '\0');
        assert_int_equal(bits_of(read), bits_of(f));
        /* The C library reads the same number. */
        assert_int_equal(bits_of(strtof(text_of(&t), NULL)), bits_of(f));
    }
    free(t.chars);
}

static void numbers_have_no_more_digits_than_needed(void **state)
{
    static const struct {
        float number;
        char text[16];
    } rows[] = {
        {0.1f, "0.1"},   {-2.5f, "-2.5"},        {640.0f, "640"},      {1.0f / 3, "0.33333334"},
        {1e18f, "1e18"}, {16777216, "16777216"}, {1e-7f, "0.0000001"}, {0.0f, "0"}};
    text t = {0};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i) {
        text_clear(&t);
        text_add_float(&t, rows[i].number);
        assert_string_equal(text_of(&t), rows[i].text);
    }
    free(t.chars);
}

static void no_number_is_read_from_other_text(void **state)
{
    static const char *const wrong[] = {"",   "-",   "+",       ".",    "e5",  "x1",
                                        "1e", "1e+", "1e99999", "4e38", "nan", "inf"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
        const char *from = wrong[i];
        float f;
        assert_false(text_read_float(&from, &f));
        assert_ptr_equal(from, wrong[i]);
    }
}

/* Appends "key=value" of a random value, or nothing. */
static void add_key(char *state, const char *key, const char *format, ...)
{
    va_list arguments;
    if (any(3) == 0)
        return;
    if (*state != '\0')
        strcat(state, "&");
    strcat(state, key);
    strcat(state, "=");
    va_start(arguments, format);
    vsprintf(state + strlen(state), format, arguments);
    va_end(arguments);
}

static const char *one_of(const char *const *names, uint32_t count)
{
    return names[any(count)];
}

static void make_state(char *state)
{
    static const char *const models[] = {"teapot", "triangle", "square", "cube", "dropped"};
    static const char *const shaders[] = {"vertex-color", "unlit", "flat",    "gouraud",    "toon",
                                          "phong",        "depth", "normals", "blinn-phong"};
    static const char *const filters[] = {"nearest", "linear", "mipmap"};
    static const char *const polygons[] = {"fill", "line", "point"};
    static const char *const cull[] = {"none", "back", "front"};
    static const char *const conventions[] = {"opengl", "direct3d", "vulkan"};
    static const char *const switches[] = {"on", "off"};
    const uint32_t width = 1 + any(4096);
    const uint32_t height = 1 + any(4096);
    const double x = (double)any_distance();
    const double y = (double)any_distance();
    *state = '\0';
    add_key(state, "model", "%s", one_of(models, 5));
    add_key(state, "size", "%ux%u", width, height);
    add_key(state, "shader", "%s", one_of(shaders, 9));
    add_key(state, "maps", "%s", one_of(switches, 2));
    add_key(state, "filter", "%s", one_of(filters, 3));
    add_key(state, "samples", "%u", any(2) * 3 + 1);
    add_key(state, "polygons", "%s", one_of(polygons, 3));
    add_key(state, "cull", "%s", one_of(cull, 3));
    add_key(state, "shadows", "%s", one_of(switches, 2));
    add_key(state, "bands", "%u", 2 + any(254));
    add_key(state, "exponent", "%u", 1 + any(1024));
    add_key(state, "convention", "%s", one_of(conventions, 3));
    add_key(state, "fov", "%.9g", 0.125 + any(1000) * 0.17);
    add_key(state, "near", "%.9g", (double)any_distance());
    add_key(state, "far", "%.9g", (double)any_distance());
    add_key(state, "eye", "%.9g,%.9g,%.9g", x, -y, 0.5);
    add_key(state, "target", "%.9g,%.9g,%.9g", -0.0, y, x);
}

static void states_are_restored(void **state)
{
    for (int i = 0; i < RANDOM_STATES; ++i) {
        char given[1024], canonical[1024];
        make_state(given);
        assert_int_equal(page_set_state(given), 0);
        const page_settings before = *page_settings_now();
        strcpy(canonical, page_state());
        assert_int_equal(page_set_state(""), 0);
        assert_string_equal(page_state(), "");
        assert_int_equal(page_set_state(canonical), 0);
        assert_string_equal(page_state(), canonical);
        const page_settings *const after = page_settings_now();
        assert_int_equal(after->model, before.model);
        assert_int_equal(after->maps, before.maps);
        assert_int_equal(after->options.width, before.options.width);
        assert_int_equal(after->options.shading, before.options.shading);
        assert_int_equal(after->options.camera.convention, before.options.camera.convention);
        assert_int_equal(after->options.camera.eye_given, before.options.camera.eye_given);
        if (before.options.camera.eye_given)
            assert_int_equal(bits_of(after->options.camera.eye.x),
                             bits_of(before.options.camera.eye.x));
        if (before.options.camera.near_given)
            assert_int_equal(bits_of(after->options.camera.near),
                             bits_of(before.options.camera.near));
    }
}

static void keys_in_any_order_and_one_by_one_are_one_state(void **state)
{
    assert_int_equal(page_set_state("fov=50&&shader=toon&model=cube&fov=40&"), 0);
    assert_string_equal(page_state(), "model=cube&shader=toon&fov=40");
    assert_int_equal(page_set_state(""), 0);
    assert_int_equal(page_set("fov", "40"), 0);
    assert_int_equal(page_set("model", "cube"), 0);
    assert_int_equal(page_set("shader", "toon"), 0);
    assert_string_equal(page_state(), "model=cube&shader=toon&fov=40");
    assert_int_equal(page_set("shader", ""), 0);
    assert_int_equal(page_set("fov", "35"), 0);
    assert_string_equal(page_state(), "model=cube");
}

static void a_wrong_key_or_value_changes_nothing(void **state)
{
    static const char *const wrong[][2] = {{"model", "pot"}, {"", "1"},        {"eye", "1,2,3,"},
                                           {"Size", "9x9"},  {"size", "9x9 "}, {"fov", "1e-3"}};
    assert_int_equal(page_set_state("model=square&size=9x8"), 0);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
        assert_int_equal(page_set(wrong[i][0], wrong[i][1]), 1);
        assert_string_not_equal(page_message(), "");
        assert_string_equal(page_state(), "model=square&size=9x8");
    }
    assert_int_equal(page_set("cull", "back"), 0);
    assert_string_equal(page_message(), "");
}

/* The camera that the state has after page_build. */
static camera built(const char *state)
{
    assert_int_equal(page_set_state(state), 0);
    assert_int_equal(page_build(), 0);
    return *page_camera();
}

static double distance(const camera *c)
{
    const gn_vec3 d = gn_vec3_subtract(c->eye, c->target);
    return sqrt((double)d.x * (double)d.x + (double)d.y * (double)d.y + (double)d.z * (double)d.z);
}

static void a_turn_keeps_target_and_distance(void **state)
{
    const camera before = built("model=cube");
    assert_int_equal(page_turn(200, -30), 0);
    assert_int_equal(page_build(), 0);
    const camera after = *page_camera();
    assert_memory_equal(&after.target, &before.target, sizeof after.target);
    assert_true(fabs(distance(&after) / distance(&before) - 1.0) < 1e-6);
    assert_true(fabsf(after.eye.x - before.eye.x) > 1.0f);
    /* Whole turns lead back, however many. */
    const camera once = built(page_state());
    assert_int_equal(page_turn(900 * 1000000, 0), 0);
    assert_int_equal(page_build(), 0);
    assert_true(fabsf(page_camera()->eye.x - once.eye.x) < 1e-5f);
}

static void a_turn_stops_short_of_straight_above(void **state)
{
    built("model=cube");
    for (int i = 0; i < 5; ++i)
        assert_int_equal(page_turn(0, 600), 0);
    assert_int_equal(page_build(), 0);
    const camera above = *page_camera();
    assert_true(above.eye.y > 0.99f * (float)distance(&above));
    assert_true(fabsf(above.eye.x - above.target.x) + fabsf(above.eye.z - above.target.z) > 0.01f);
    /* From straight above too. */
    built("model=cube&eye=0,5,0&target=0,0,0");
    assert_int_equal(page_turn(10, -50), 0);
    assert_int_equal(page_build(), 0);
    assert_true(page_camera()->eye.y < 4.99f);
}

static void a_pan_moves_eye_and_target_alike(void **state)
{
    const camera before = built("");
    assert_int_equal(page_pan(40, 25), 0);
    assert_int_equal(page_build(), 0);
    const gn_vec3 eye = gn_vec3_subtract(page_camera()->eye, before.eye);
    const gn_vec3 target = gn_vec3_subtract(page_camera()->target, before.target);
    assert_true(fabsf(eye.x - target.x) + fabsf(eye.y - target.y) + fabsf(eye.z - target.z) <
                1e-5f);
    assert_true(fabsf(eye.x) + fabsf(eye.y) + fabsf(eye.z) > 0.1f);
    /* What was at the target moves by 40 pixels of 640 to the right, and 25 of 480 down. */
    const gn_vec4 p = {before.target.x, before.target.y, before.target.z, 1.0f};
    const gn_vec4 clip = gn_mat4_multiply_vec4(&page_camera()->clip_from_world, p);
    assert_true(fabsf(clip.x / clip.w * 320.0f - 40.0f) < 0.5f);
    assert_true(fabsf(clip.y / clip.w * 240.0f + 25.0f) < 0.5f);
}

static void zooms_are_bounded(void **state)
{
    const camera before = built("model=triangle");
    assert_int_equal(page_zoom(1), 0);
    assert_int_equal(page_build(), 0);
    assert_true(fabs(distance(page_camera()) / distance(&before) - 0.9) < 1e-5);
    page_zoom(INT32_MAX);
    page_build();
    built("model=triangle");
    page_zoom(INT32_MIN);
    page_build();
    /* Whatever came out, the next state works. */
    built("");
}

static void planes_and_targets_must_be_possible(void **state)
{
    static const char *const impossible[] = {"near=4&far=2", "near=4&far=4",
                                             "eye=1,1,1&target=1,1,1", "model=dropped"};
    for (size_t i = 0; i < sizeof impossible / sizeof *impossible; ++i) {
        assert_int_equal(page_set_state(impossible[i]), 0);
        assert_int_equal(page_build(), 1);
        assert_string_not_equal(page_message(), "");
        assert_null(page_scene());
        assert_int_equal(page_draw(0, 1), 1);
    }
    built("near=2&far=4");
    assert_string_equal(page_message(), "");
}

/* In clip space every convention has the point where its table says (tools/guide/conventions.md):
 * OpenGL's depth is -w to w, the others' 0 to w; Vulkan's y points down. */
static void conventions_are_those_of_the_apis(void **state)
{
    static const char *const names[3] = {"opengl", "direct3d", "vulkan"};
    gn_vec4 clip[3];
    for (int i = 0; i < 3; ++i) {
        char words[128];
        sprintf(words, "convention=%s&near=2&far=20&eye=1,2,9&target=0,0,1", names[i]);
        const camera c = built(words);
        clip[i] = gn_mat4_multiply_vec4(&c.clip_from_world, (gn_vec4){0.5f, 0.75f, 1.0f, 1.0f});
        assert_int_equal(c.zero_to_one, i != 0);
        assert_int_equal(c.y_down, i == 2);
        assert_int_equal(page_scene()->draws[0].state.depth.clip_depth,
                         i == 0 ? GN_NEGATIVE_ONE_TO_ONE : GN_ZERO_TO_ONE);
    }
    for (int i = 1; i < 3; ++i) {
        assert_true(fabsf(clip[i].x - clip[0].x) < 1e-5f);
        assert_true(fabsf(clip[i].w - clip[0].w) < 1e-5f);
        assert_true(fabsf(clip[i].y - (i == 2 ? -clip[0].y : clip[0].y)) < 1e-5f);
        assert_true(fabsf(clip[i].z - 0.5f * (clip[0].z + clip[0].w)) < 1e-4f);
    }
}

/* A picture in Vulkan's convention is as upright as one in OpenGL's: few pixels differ. */
static void every_convention_is_upright(void **state)
{
    static const char *const others[2] = {"direct3d", "vulkan"};
    static const char *const shaders[3] = {"phong", "flat", "gouraud"};
    for (int s = 0; s < 3; ++s) {
        char words[128];
        sprintf(words, "size=160x120&shader=%s", shaders[s]);
        built(words);
        assert_int_equal(page_draw(0, 120), 0);
        uint8_t first[160 * 120 * 4];
        memcpy(first, page_color(), sizeof first);
        for (int i = 0; i < 2; ++i) {
            int differing = 0;
            sprintf(words, "size=160x120&shader=%s&convention=%s", shaders[s], others[i]);
            built(words);
            assert_int_equal(page_draw(0, 120), 0);
            for (size_t p = 0; p < sizeof first; ++p)
                differing += abs(page_color()[p] - first[p]) > 8;
            assert_true(differing < (int)sizeof first / 100);
        }
    }
}

/* A scene of the same contents is placed, not made again. */
static void a_moved_camera_makes_the_same_scene(void **state)
{
    static const char moved[] = "size=64x48&convention=vulkan&samples=4&shadows=on&eye=2,3,9";
    char hash[17];
    built(moved);
    assert_int_equal(page_draw(0, 48), 0);
    strcpy(hash, page_hash(page_color(), 64, 48));
    built("size=320x200&shadows=on");
    const void *const before = page_scene()->draws[1].mesh.indices;
    built(moved);
    assert_ptr_equal(page_scene()->draws[1].mesh.indices, before);
    assert_int_equal(page_draw(0, 48), 0);
    assert_string_equal(page_hash(page_color(), 64, 48), hash);
}

/* FNV-1a of 64 bits, from its definition: of "a" it is af63dc4c8601ec8c. */
static void the_hash_is_fnv(void **state)
{
    static const uint8_t pixel[4] = {1, 2, 3, 4};
    static const uint8_t all[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 3, 4};
    uint64_t hash = UINT64_C(14695981039346656037);
    char expected[17];
    assert_true((hash ^ 'a') * UINT64_C(1099511628211) == UINT64_C(0xaf63dc4c8601ec8c));
    for (size_t i = 0; i < sizeof all; ++i)
        hash = (hash ^ all[i]) * UINT64_C(1099511628211);
    sprintf(expected, "%016llx", (unsigned long long)hash);
    assert_string_equal(page_hash(pixel, 1, 1), expected);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_restore_their_bits),
        cmocka_unit_test(numbers_have_no_more_digits_than_needed),
        cmocka_unit_test(no_number_is_read_from_other_text),
        cmocka_unit_test(states_are_restored),
        cmocka_unit_test(keys_in_any_order_and_one_by_one_are_one_state),
        cmocka_unit_test(a_wrong_key_or_value_changes_nothing),
        cmocka_unit_test(a_turn_keeps_target_and_distance),
        cmocka_unit_test(a_turn_stops_short_of_straight_above),
        cmocka_unit_test(a_pan_moves_eye_and_target_alike),
        cmocka_unit_test(zooms_are_bounded),
        cmocka_unit_test(planes_and_targets_must_be_possible),
        cmocka_unit_test(conventions_are_those_of_the_apis),
        cmocka_unit_test(every_convention_is_upright),
        cmocka_unit_test(a_moved_camera_makes_the_same_scene),
        cmocka_unit_test(the_hash_is_fnv),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
