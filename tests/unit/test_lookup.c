/* Lookups in textures: every fault of a sampler as status and text; wraps, borders, gathers and
 * compared depths with cases worked by hand, at one place and at sixteen; ways to describe one
 * lookup that take different ways through the library. tests/parity/textures compares with the
 * reference, tests/property with any coordinates. */
#include <math.h>
#include <stdlib.h>

#include "formats.h"
#include "lookups.h"
#include "noise.h"

/* Texel (x, y) of the image is (x, y, 0, 1) in 1/255, eight columns and two rows. */
enum { WIDTH = 8, HEIGHT = 2 };

static gn_texture columns(void)
{
    static uint32_t image[WIDTH * HEIGHT];

    for (uint32_t i = 0; i < WIDTH * HEIGHT; ++i)
        image[i] = i % WIDTH | i / WIDTH << 8 | 0xFF000000u;
    return texture_of(GN_TEXTURE_2D, GN_FORMAT_RGBA8, WIDTH, HEIGHT, 1, 1, image);
}

static gn_sampler sampler(gn_wrap wrap, bool linear)
{
    return sampler_of(wrap, linear ? GN_MAGNIFY_LINEAR : GN_MAGNIFY_NEAREST,
                      linear ? GN_MINIFY_LINEAR : GN_MINIFY_NEAREST);
}

static void expect_fault(const gn_sampler *s, gn_status status, const char *word)
{
    const char *const text = gn_sampler_fault(s);

    assert_int_equal(gn_sampler_check(s), status);
    assert_int_equal(!text, status == GN_OK);
    if (text)
        assert_non_null(strstr(text, word));
}

static void faults(void **state)
{
    const gn_sampler good = sampler(GN_WRAP_MIRROR_CLAMP_TO_EDGE, false);
    gn_sampler s = good;

    expect_fault(&s, GN_OK, NULL);
    expect_fault(NULL, GN_NULL_POINTER, "null");
    s.wrap_s = (gn_wrap)5;
    expect_fault(&s, GN_INVALID_ENUM, "wrap_s");
    s = good;
    s.wrap_t = (gn_wrap)-1;
    expect_fault(&s, GN_INVALID_ENUM, "wrap_t");
    s = good;
    s.wrap_r = (gn_wrap)5;
    expect_fault(&s, GN_INVALID_ENUM, "wrap_r");
    s = good;
    s.magnify = (gn_magnify)2;
    expect_fault(&s, GN_INVALID_ENUM, "magnify");
    s = good;
    s.minify = (gn_minify)6;
    expect_fault(&s, GN_INVALID_ENUM, "minify");
    s = good;
    s.compare = (gn_compare)9;
    expect_fault(&s, GN_INVALID_ENUM, "compare");
    s = good;
    s.lod_bias = INFINITY;
    expect_fault(&s, GN_NOT_FINITE, "lod_bias");
    s = good;
    s.min_lod = NAN;
    expect_fault(&s, GN_OK, NULL);
    s.lod_clamp_enabled = true;
    expect_fault(&s, GN_NOT_FINITE, "min_lod");
    s.min_lod = 0;
    s.max_lod = -INFINITY;
    expect_fault(&s, GN_NOT_FINITE, "max_lod");
    s.max_lod = -1;
    expect_fault(&s, GN_OUT_OF_RANGE, "min_lod");
    s = good;
    s.max_anisotropy = GN_MAX_ANISOTROPY;
    expect_fault(&s, GN_OK, NULL);
    s.max_anisotropy = GN_MAX_ANISOTROPY + 1;
    expect_fault(&s, GN_OUT_OF_RANGE, "max_anisotropy");
    s = good;
    s.border[3] = NAN;
    expect_fault(&s, GN_NOT_FINITE, "border");
    s.border[3] = INFINITY;
    expect_fault(&s, GN_OK, NULL);
}

/* Red in 1/255 at (s, 0.25), looked up at one place and at sixteen. */
static float red_at(const gn_texture *t, const gn_sampler *sampler, float s)
{
    const places p = places_at(s, 0.25f, 0);
    float one[4], sixteen[4];

    gn_texture_lookup_at(t, sampler, (const float[]){s, 0.25f, 0}, 0, 0, one);
    lookup_each(t, sampler, &p, GN_LOD_EXPLICIT, sixteen);
    assert_memory_equal(one, sixteen, sizeof one);
    return one[0] * 255.0f;
}

#define NEAR(a, b) assert_true(fabsf((a) - (b)) < 1e-4f)

/* By the nearest filter at -1.3, -0.2, 0.3, 1.2, 2.2: texels -10.4, -1.6, 2.4, 9.6, 17.6. By the
 * linear filter at -0.3, -0.05, 0.3, 1.05, 1.3: s * 8 - 0.5 is -2.9, -0.9, 1.9, 7.9, 9.9. */
static void wraps(void **state)
{
    static const float at[2][5] = {{-1.3f, -0.2f, 0.3f, 1.2f, 2.2f},
                                   {-0.3f, -0.05f, 0.3f, 1.05f, 1.3f}};
    static const float expected[2][5][5] = {{{5, 6, 2, 1, 1},     /* repeat */
                                             {0, 0, 2, 7, 7},     /* clamp to edge */
                                             {5, 1, 2, 6, 1},     /* mirrored */
                                             {99, 99, 2, 99, 99}, /* border */
                                             {7, 1, 2, 7, 7}},    /* mirrored once */
                                            {{5.1f, 6.3f, 1.9f, 0.7f, 1.9f},
                                             {0, 0, 1.9f, 7, 7},
                                             {1.9f, 0, 1.9f, 7, 5.1f},
                                             {99, 89.1f, 1.9f, 89.8f, 99},
                                             {1.9f, 0, 1.9f, 7, 7}}};
    const gn_texture t = columns();

    for (int i = 0; i < 2 * 5 * 5; ++i) {
        gn_sampler s = sampler((gn_wrap)(i / 5 % 5), i / 25);

        s.border[0] = 99.0f / 255.0f;
        s.wrap_t = GN_WRAP_CLAMP_TO_EDGE;
        NEAR(red_at(&t, &s, at[i / 25][i % 5]), expected[i / 25][i / 5 % 5][i % 5]);
    }
}

/* The border is clamped for a normalized format; at the edge half of it is mixed in. Floats without
 * sign have no border below 0, and no upper limit. */
static void borders(void **state)
{
    static const struct {
        gn_format format;
        bool linear;
        float border, at, expected;
    } cases[] = {
        {GN_FORMAT_RGBA8, false, 2, -1, 255},         {GN_FORMAT_RGBA8, false, -2, 9, 0},
        {GN_FORMAT_RGBA8, true, 1, 0, 127.5f},        {GN_FORMAT_RGBA8, true, 1, 1, 131},
        {GN_FORMAT_RGBA8, true, 1, 0.5f, 3.5f},       {GN_FORMAT_R11F_G11F_B10F, false, 3, -1, 765},
        {GN_FORMAT_R11F_G11F_B10F, false, -2, -1, 0}, {GN_FORMAT_RG16F, false, -2, -1, -510}};
    gn_texture t = columns();

    for (size_t i = 0; i < COUNT(cases); ++i) {
        gn_sampler s = sampler(GN_WRAP_CLAMP_TO_BORDER, cases[i].linear);

        s.wrap_t = GN_WRAP_REPEAT;
        s.border[0] = cases[i].border;
        t.format = cases[i].format;
        NEAR(red_at(&t, &s, cases[i].at), cases[i].expected);
    }
}

/* Around (0.5, 0.5) are columns 3 and 4, rows 0 and 1, in the order from the upper left round. */
static void gathers(void **state)
{
    static const float expected[4][4] = {{3, 4, 4, 3}, {1, 1, 0, 0}, {0}, {255, 255, 255, 255}};
    const gn_texture t = columns();
    const gn_sampler s = sampler(GN_WRAP_CLAMP_TO_EDGE, false);
    const places p = places_at(0.5f, 0.5f, 0);
    gn_lookup lookup = lookup_of(&p, GN_LOD_IMPLICIT);
    float texel[4][GN_LANES];

    lookup.coordinate[2] = lookup.reference = NULL;
    for (int c = 0; c < 4; ++c) {
        gn_texture_gather(&t, &s, &lookup, c, texel);
        for (int i = 0; i < 4; ++i)
            NEAR(texel[i][7] * 255.0f, expected[c][i]);
    }
}

/* The result at (s, 0.5). */
static float compared(const gn_texture *t, gn_sampler s, gn_compare function, float at,
                      float reference)
{
    float texel[4];

    s.compare = function;
    gn_texture_lookup_at(t, &s, (const float[]){at, 0.5f, 0}, 0, reference, texel);
    assert_true(texel[1] == 0 && texel[2] == 0 && texel[3] == 1);
    return texel[0];
}

static void compared_depths(void **state)
{
    static const struct {
        float reference;
        int holds[8]; /* never, <, =, <=, >, not =, >=, always */
    } cases[] = {{0.25f, {0, 1, 0, 1, 0, 1, 0, 1}},
                 {0.5f, {0, 0, 1, 1, 0, 0, 1, 1}},
                 {0.75f, {0, 0, 0, 0, 1, 1, 1, 1}},
                 {INFINITY, {0, 0, 0, 0, 1, 1, 1, 1}},
                 {NAN, {0, 0, 0, 0, 0, 1, 0, 1}}};
    static const float depth = 0.5f;
    const gn_texture t = texture_of(GN_TEXTURE_2D, GN_FORMAT_D32F, 1, 1, 1, 1, &depth);
    const gn_sampler s = sampler(GN_WRAP_CLAMP_TO_EDGE, false);

    for (size_t i = 0; i < COUNT(cases); ++i)
        for (int f = 0; f < 8; ++f)
            assert_true(compared(&t, s, (gn_compare)(f + 1), 0.5f, cases[i].reference) ==
                        (float)cases[i].holds[f]);
}

/* For normalized formats, reference values are clamped to 0..1 and NaN becomes 1; for formats of
 * floats they are not. */
static void references_of_comparisons(void **state)
{
    static const uint16_t fractions[2] = {0, 65535};
    static const float floats[2] = {0, 1};
    static const struct {
        bool is_float;
        float at, reference, expected;
    } cases[] = {{false, 0.25f, -2, 1},  {false, 0.75f, -2, 0},  {false, 0.75f, 2, 1},
                 {false, 0.75f, NAN, 1}, {false, 0.25f, NAN, 0}, {true, 0.25f, -2, 0},
                 {true, 0.75f, 2, 0},    {true, 0.75f, 1, 1}};
    const gn_texture textures[2] = {texture_of(GN_TEXTURE_2D, GN_FORMAT_D16, 2, 1, 1, 1, fractions),
                                    texture_of(GN_TEXTURE_2D, GN_FORMAT_D32F, 2, 1, 1, 1, floats)};

    for (size_t i = 0; i < COUNT(cases); ++i)
        assert_true(compared(&textures[cases[i].is_float], sampler(GN_WRAP_CLAMP_TO_EDGE, false),
                             GN_EQUAL, cases[i].at, cases[i].reference) == cases[i].expected);
}

/* Only the second of the depths 0.25 and 0.75 is at least 0.5: the filter mixes results, not
 * depths. The last case is where the weight is NaN. */
static void filtered_comparisons(void **state)
{
    static const float depths[2] = {0.25f, 0.75f};
    const gn_texture t = texture_of(GN_TEXTURE_2D, GN_FORMAT_D32F, 2, 1, 1, 1, depths);
    const gn_sampler s = sampler(GN_WRAP_CLAMP_TO_EDGE, true);
    const gn_sampler repeat = sampler(GN_WRAP_REPEAT, true);

    assert_true(compared(&t, s, GN_LESS_OR_EQUAL, 0.625f, 0.5f) == 0.75f);
    assert_true(compared(&t, s, GN_GREATER_OR_EQUAL, 0.625f, 0.5f) == 0.25f);
    assert_true(compared(&t, s, GN_LESS_OR_EQUAL, 0.625f, 0.125f) == 1);
    assert_true(compared(&t, s, GN_COMPARE_DEFAULT, 0.625f, 0.5f) == 0.625f);
    assert_true(compared(&t, repeat, GN_NEVER, INFINITY, 0.5f) == 0);
}

/* Lookups have several ways through the library: some for the common samplers, some for texels that
 * lie as usual in memory. Bounds of the level of detail that bound nothing, and rows far apart,
 * describe the same lookup. */
enum { SIZE = 20, FAR_APART = 1 << 17, WAYS = 5 };

static uint32_t texels[64 * 64 * 2];
static unsigned char *apart[GN_MAX_LEVELS];

/* Makes the texture of a way: 0, 1: packed; 2: level 0 far apart; 3: the others; 4: all. */
static gn_texture texture_of_way(int way, const uint32_t size[3])
{
    gn_texture t = texture_of(GN_TEXTURE_2D, GN_FORMAT_RGBA8, size[0], size[1], 1, size[2], texels);

    for (uint32_t n = 0; n < size[2]; ++n) {
        gn_texture_level *const level = &t.level[n];

        if (way < 2 || (way == 2 && n > 0) || (way == 3 && n == 0))
            continue;
        for (ptrdiff_t row = 0; row == 0 || row < (ptrdiff_t)(size[1] >> n); ++row)
            memcpy(apart[n] + row * FAR_APART,
                   (const unsigned char *)level->texels + row * level->row_stride,
                   (size_t)level->row_stride);
        level->texels = apart[n];
        level->row_stride = FAR_APART;
    }
    return t;
}

static void pass_texcoord(const void *unused, const gn_vertex_input *in, gn_vertex_output *out)
{
    for (int l = 0; l < GN_LANES; ++l) {
        for (int i = 0; i < 4; ++i)
            out->position[i][l] = in->attribute[GN_ATTRIBUTE_POSITION][i][l];
        for (int i = 0; i < 2; ++i)
            out->varying[i][l] = in->attribute[GN_ATTRIBUTE_TEXCOORD][i][l];
    }
}

static void lookup_map(const void *uniforms, const gn_fragment_input *in, gn_fragment_output *out)
{
    const gn_unlit_uniforms *const u = uniforms;

    gn_fragment_lookup_2d(in, u->map, &u->sampler, in->varying[0], in->varying[1], out->color);
}

/* Draws a square whose texture is larger than the screen's pixels at one side, and smaller at the
 * other; with a shader of the test's, or a ready-made one. */
static void draw(uint32_t *frame, gn_backend backend, const gn_texture *texture,
                 const gn_sampler *sampler, float scale, bool tilted, gn_fragment_shader *shader)
{
    static unsigned char memory[GN_WORKSPACE_SIZE(16, 8)];
    static gn_unlit_uniforms uniforms;
    const float far = tilted ? 9.0f : 1.0f, s = scale - 0.3f, t = scale - 0.2f;
    const float position[4][4] = {
        {-1, -1, 0, 1}, {far, -far, 0, far}, {-1, 1, 0, 1}, {far, far, 0, far}};
    const float place[4][2] = {{-0.3f, -0.2f}, {s, -0.2f}, {-0.3f, t}, {s, t + 0.3f}};
    gn_target target = {.color = {gn_surface_bottom_up(frame, GN_FORMAT_RGBA8, SIZE, SIZE)}};
    gn_pipeline p = {.raster.topology = GN_TRIANGLE_STRIP};
    gn_mesh mesh = {.vertex_count = 4, .count = 4};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory, .backend = backend};

    gn_mat4_identity(&uniforms.clip_from_model);
    uniforms.map = texture;
    uniforms.sampler = *sampler;
    assert_int_equal(gn_use_unlit(&p, &uniforms), GN_OK);
    if (shader) {
        p.program.vertex_shader = pass_texcoord;
        p.program.fragment_shader = shader;
    }
    mesh.attribute[GN_ATTRIBUTE_POSITION] = (gn_attribute){.data = position[0], .components = 4};
    mesh.attribute[GN_ATTRIBUTE_TEXCOORD] = (gn_attribute){.data = place[0], .components = 2};
    assert_int_equal(gn_clear_color(&target.color[0], 0, 0, 0, 0), GN_OK);
    assert_int_equal(gn_draw(&target, &p, &mesh, &workspace), GN_OK);
}

static void every_way_reads_the_same(void **state)
{
    static const gn_wrap wraps[] = {GN_WRAP_REPEAT, GN_WRAP_CLAMP_TO_EDGE, GN_WRAP_MIRRORED_REPEAT};
    static const uint32_t sizes[][3] = {{16, 16, 1}, {16, 16, 5}, {13, 7, 4}, {32, 8, 3}};
    static const float scales[] = {0.04f, 0.6f, 1.0f, 3.7f, 14.0f};
    static uint32_t frames[2 * GN_BACKEND_COUNT][SIZE * SIZE];
    uint64_t seed = 3;

    for (int n = 0; n < 6; ++n) {
        apart[n] = calloc(33, FAR_APART);
        assert_non_null(apart[n]);
    }
    for (size_t i = 0; i < COUNT(texels); ++i)
        texels[i] = random_bits(&seed);
    for (int i = 0; i < 4 * 12 * 4 * 10; ++i) {
        const int wrap = i / 48 % 4, scale = i / 192 / 2;

        for (int way = 0; way < WAYS; ++way) {
            const gn_texture texture = texture_of_way(way, sizes[i % 4]);
            gn_sampler s =
                sampler_of(wraps[wrap % 3], (gn_magnify)(i / 4 % 2), (gn_minify)(i / 8 % 6));

            s.wrap_t = wraps[wrap == 3 ? 1 : wrap];
            s.lod_clamp_enabled = way == 1;
            s.min_lod = -1000;
            s.max_lod = 1000;
            for (gn_backend b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; b = next_backend(b)) {
                uint32_t *const first = frames[2 * b], *const frame =
                                                           first + (way > 0) * SIZE * SIZE;

                draw(frame, b, &texture, &s, scales[scale], i / 192 % 2,
                     scale % 2 ? lookup_map : NULL);
                assert_memory_equal(frame, first, sizeof frames[0]);
            }
        }
    }
    for (int n = 0; n < 6; ++n)
        free(apart[n]);
}

static gn_texture loose;
static uint32_t different;

/* Samples with all functions that a shader has, some lanes with hostile coordinates, and in the
 * loose texture; counts what differs, NaN being equal to NaN. */
static void compare_functions(const void *uniforms, const gn_fragment_input *in,
                              gn_fragment_output *out)
{
    static const float hostile[] = {NAN, INFINITY, -INFINITY, 3e9f, -3e9f, 0, -0.0f, 1};
    const gn_unlit_uniforms *const u = uniforms;
    places p = places_at(0, 0, 0);
    const gn_lookup lookup = lookup_of(&p, GN_LOD_IMPLICIT);
    float others[3][4][GN_LANES];

    for (int l = 0; l < GN_LANES; ++l) {
        const bool is_hostile = (in->x[0] + in->y[0]) / 4 % 4 == 3;

        p.at[0][l] = is_hostile ? hostile[l % 8] : in->varying[0][l];
        p.at[1][l] = is_hostile ? hostile[(l / 2 + in->y[0] / 4) % 8] : in->varying[1][l];
    }
    gn_fragment_lookup_2d(in, u->map, &u->sampler, p.at[0], p.at[1], out->color);
    gn_fragment_lookup_2d(in, &loose, &u->sampler, p.at[0], p.at[1], others[0]);
    gn_fragment_lookup(in, u->map, &u->sampler, &lookup, others[1]);
    gn_texture_lookup_2d(u->map, &u->sampler, p.at[0], p.at[1], others[2]);
    for (int i = 0; i < 3 * 4 * GN_LANES; ++i) {
        const float a = out->color[i / 3 % 4][i / 12], b = others[i % 3][i / 3 % 4][i / 12];

        different += memcmp(&a, &b, sizeof a) != 0 && !(isnan(a) && isnan(b));
    }
}

/* Texels are loaded in several ways, by format and alignment. Rows that begin at any multiple of
 * the format's element, in either direction, in memory that ends with the last texel, have the
 * samples of tightly packed rows. */
static void every_function_reads_the_same(void **state)
{
    static const uint32_t sizes[][2] = {{8, 4}, {7, 5}, {1, 8}};
    static uint32_t frame[SIZE * SIZE];
    uint64_t seed = 4;

    for (size_t i = 0; i < COUNT(texels); ++i)
        texels[i] = random_bits(&seed);
    for (size_t i = 0; i < COUNT(formats) * 5 * 12; ++i) {
        const struct format *const format = &formats[i / 60];
        const bool flipped = (i / 12 + i / 60) % 2;
        const uint32_t width = sizes[(i + i / 60) % 3][0], height = sizes[(i + i / 60) % 3][1];
        const size_t row = width * format->size, stride = row + format->element;
        unsigned char *const memory = malloc(format->element + (height - 1) * stride + row);
        unsigned char *const first =
            memory + format->element + (flipped ? (height - 1) * stride : 0);
        const gn_sampler s =
            sampler_of((gn_wrap)(i / 12 % 5), (gn_magnify)(i / 6 % 2), (gn_minify)(i % 6));

        assert_non_null(memory);
        if (format->format == GN_FORMAT_S8) {
            free(memory);
            continue;
        }
        const gn_texture tight =
            texture_of(GN_TEXTURE_2D, format->format, width, height, 1, 1, texels);
        loose = tight;
        loose.level[0].texels = first;
        loose.level[0].row_stride = flipped ? -(ptrdiff_t)stride : (ptrdiff_t)stride;
        for (ptrdiff_t y = 0; y < (ptrdiff_t)height; ++y)
            memcpy(first + y * loose.level[0].row_stride,
                   (const unsigned char *)texels + y * (ptrdiff_t)row, row);
        for (gn_backend b = GN_BACKEND_PORTABLE; b < GN_BACKEND_COUNT; b = next_backend(b)) {
            different = 0;
            draw(frame, b, &tight, &s, 2, true, compare_functions);
            if (different)
                fail_msg("%s, format %d, case %zu: %u differ", gn_backend_name(b),
                         (int)format->format, i, different);
        }
        free(memory);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faults),
        cmocka_unit_test(wraps),
        cmocka_unit_test(borders),
        cmocka_unit_test(gathers),
        cmocka_unit_test(compared_depths),
        cmocka_unit_test(references_of_comparisons),
        cmocka_unit_test(filtered_comparisons),
        cmocka_unit_test(every_way_reads_the_same),
        cmocka_unit_test(every_function_reads_the_same),
    };
    return cmocka_run_group_tests_name("lookup", tests, NULL, NULL);
}
