/* Lookups of fragment shaders: those through the shader's input give the bits of the public
 * functions, whatever textures and samplers one call or the next looks up; faulty ones are opaque
 * black, and the draw returns their fault. */
#include "backwards.h"
#include "drawing.h"
#include "lookups.h"
#include "noise.h"

enum { SIDE = 32, KINDS = 24, PIXELS = SIDE * SIDE };

static uint32_t texels[64 * 64 * 2];
static float colors[PIXELS][4];
static bool calls_public; /* the shader calls the public functions */
static int lookups_made;

static int set_up(void **state)
{
    static uint32_t seed = 3;

    for (size_t i = 0; i < sizeof texels / sizeof *texels; ++i)
        texels[i] = (uint32_t)(noise(&seed) * 0x1p32f);
    return 0;
}

/* Textures and samplers of many kinds, by number. */
static gn_texture texture_of_kind(int kind)
{
    static const gn_texture_target targets[] = {GN_TEXTURE_2D, GN_TEXTURE_2D, GN_TEXTURE_1D,
                                                GN_TEXTURE_CUBE};
    static const gn_format formats[] = {GN_FORMAT_RGBA8, GN_FORMAT_RGBA16F, GN_FORMAT_RGB8,
                                        GN_FORMAT_RGBA8, GN_FORMAT_SRGB8_A8};
    const gn_texture_target target = targets[kind % 4];
    const uint32_t size = 8u << kind % 2;
    gn_texture t;

    assert_int_equal(gn_texture_packed(target, formats[kind % 5], size,
                                       target == GN_TEXTURE_1D ? 1 : size, 1, kind % 3 ? 1 : 4,
                                       texels, &t),
                     GN_OK);
    return t;
}

static gn_sampler sampler_of_kind(int kind)
{
    gn_sampler s =
        sampler_of((gn_wrap)(kind % 5), kind % 2 ? GN_MAGNIFY_NEAREST : GN_MAGNIFY_LINEAR,
                   (gn_minify)(kind % 6));

    s.lod_bias = kind % 7 == 6 ? 0.5f : 0.0f;
    s.border[kind % 4] = 0.5f;
    return s;
}

static void look_up(const gn_fragment_input *in, const gn_texture *t, const gn_sampler *s, int kind,
                    float texel[4][GN_LANES])
{
    const float *const zero = in->varying[2];
    const int32_t column[GN_LANES] = {1, 2, 3, 100}, row[GN_LANES] = {0};
    const int32_t *const number[3] = {column, row, row};
    gn_lookup lookup;

    memset(&lookup, 0, sizeof lookup);
    lookup.coordinate[0] = in->varying[0];
    lookup.coordinate[1] = in->varying[1];
    lookup.coordinate[2] = zero;
    ++lookups_made;
    if (kind % 8 == 7)
        calls_public ? gn_texture_fetch(t, number, NULL, texel)
                     : gn_fragment_fetch(in, t, number, NULL, texel);
    else if (kind % 8 == 5 && t->target == GN_TEXTURE_2D)
        calls_public ? gn_texture_gather(t, s, &lookup, 1, texel)
                     : gn_fragment_gather(in, t, s, &lookup, 1, texel);
    else if (t->target == GN_TEXTURE_2D)
        calls_public ? gn_texture_lookup_2d(t, s, in->varying[0], in->varying[1], texel)
                     : gn_fragment_lookup_2d(in, t, s, in->varying[0], in->varying[1], texel);
    else
        calls_public ? gn_texture_lookup(t, s, &lookup, texel)
                     : gn_fragment_lookup(in, t, s, &lookup, texel);
}

/* Adds the texels of all kinds, which stand in the same variables one after the other. */
static void add_kinds(const void *uniforms, const gn_fragment_input *in, gn_fragment_output *out)
{
    float texel[4][GN_LANES];
    gn_texture t;
    gn_sampler s;

    for (int kind = 0; kind < KINDS; ++kind) {
        t = texture_of_kind(kind);
        s = sampler_of_kind(kind);
        look_up(in, &t, &s, kind, texel);
        for (int c = 0; c < 4; ++c)
            for (int l = 0; l < GN_LANES; ++l)
                out->color[c][l] = 0.75f * out->color[c][l] + texel[c][l];
    }
}

static void place(const void *uniforms, const gn_vertex_input *in, gn_vertex_output *out)
{
    for (int l = 0; l < GN_LANES; ++l) {
        for (int c = 0; c < 4; ++c)
            out->position[c][l] = in->attribute[0][c][l];
        out->varying[0][l] = 1.5f * in->attribute[0][0][l];
        out->varying[1][l] = in->attribute[0][1][l] - 0.25f * in->attribute[0][0][l];
        out->varying[2][l] = 0.5f;
    }
}

static gn_status draw(gn_fragment_shader *shader, const void *uniforms, gn_backend backend,
                      gn_parallel *parallel)
{
    static const float corners[][4] = {{-1, -1, 0, 1}, {3, -1, 0, 1}, {-1, 3, 0, 1}};
    static unsigned char memory[1 << 22];
    const gn_target target = {{gn_surface_bottom_up(colors, GN_FORMAT_RGBA32F, SIDE, SIDE)}, {0}};
    const gn_mesh mesh = mesh_of(corners[0], 4, 3);
    gn_workspace workspace = {
        .memory = memory, .size = sizeof memory, .backend = backend, .parallel = parallel};
    gn_pipeline pipeline;

    memset(&pipeline, 0, sizeof pipeline);
    memset(colors, 0, sizeof colors);
    pipeline.program.vertex_shader = place;
    pipeline.program.fragment_shader = shader;
    pipeline.program.uniforms = uniforms;
    pipeline.program.varying_count = 3;
    return gn_draw(&target, &pipeline, &mesh, &workspace);
}

static void are_those_of_the_public_functions(void **state)
{
    static float expected[PIXELS][4];

    for (gn_backend k = GN_BACKEND_AUTO; k < GN_BACKEND_COUNT; k = backend_after(k)) {
        lookups_made = 0;
        calls_public = true;
        assert_int_equal(draw(add_kinds, NULL, k, NULL), GN_OK);
        memcpy(expected, colors, sizeof colors);
        calls_public = false;
        assert_int_equal(draw(add_kinds, NULL, k, NULL), GN_OK);
        assert_memory_equal(colors, expected, sizeof colors);
        assert_true(lookups_made >= 2 * KINDS * PIXELS / GN_LANES);
    }
}

/* A texture whose levels, or a sampler whose filter, changes from call to call. */
typedef struct changing {
    gn_texture texture;
    gn_sampler sampler;
    int calls;
} changing;

static void change(const void *uniforms, const gn_fragment_input *in, gn_fragment_output *out)
{
    changing *const u = (changing *)(uintptr_t)uniforms;
    float expected[4][GN_LANES];

    u->texture.level[3].texels = texels + 64 * (u->calls % 5);
    u->texture.level[0].row_stride = u->calls % 3 ? 64 : 128;
    u->sampler.border[3] = (float)(u->calls % 4);
    u->sampler.lod_clamp_enabled = u->calls % 2;
    gn_texture_lookup_2d(&u->texture, &u->sampler, in->varying[0], in->varying[1], expected);
    gn_fragment_lookup_2d(in, &u->texture, &u->sampler, in->varying[0], in->varying[1], out->color);
    assert_memory_equal(out->color, expected, sizeof expected);
    ++u->calls;
}

static void see_changes(void **state)
{
    changing u;

    memset(&u, 0, sizeof u);
    assert_int_equal(
        gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, 16, 16, 1, 5, texels, &u.texture), GN_OK);
    u.sampler.wrap_s = u.sampler.wrap_t = GN_WRAP_CLAMP_TO_BORDER;
    u.sampler.minify = GN_MINIFY_LINEAR_MIPMAP_LINEAR;
    u.sampler.min_lod = u.sampler.max_lod = 3.0f;
    assert_int_equal(draw(change, &u, GN_BACKEND_AUTO, NULL), GN_OK);
    assert_true(u.calls >= PIXELS / GN_LANES);
}

typedef struct faulty {
    gn_texture texture;
    gn_sampler sampler;
    bool fetches, right_alone; /* only fragments in the right half look up */
} faulty;

static void look_up_faulty(const void *uniforms, const gn_fragment_input *in,
                           gn_fragment_output *out)
{
    static const int32_t zero[GN_LANES];
    static const int32_t *const number[3] = {zero, zero, zero};
    const faulty *const u = uniforms;

    for (int l = 0; l < GN_LANES; ++l)
        out->color[0][l] = 0.25f;
    if (u->right_alone && in->x[0] < SIDE / 2)
        return;
    if (u->fetches)
        gn_fragment_fetch(in, &u->texture, number, NULL, out->color);
    else
        gn_fragment_lookup_2d(in, &u->texture, &u->sampler, in->varying[0], in->varying[1],
                              out->color);
}

static void expect_fault(const faulty *u, gn_status status)
{
    for (gn_backend k = GN_BACKEND_AUTO; k < GN_BACKEND_COUNT; k = backend_after(k))
        for (int tasks = 0; tasks < 2; ++tasks) {
            assert_int_equal(draw(look_up_faulty, u, k, tasks ? run_backwards : NULL), status);
            assert_true(colors[PIXELS - 1][0] == 0.0f && colors[PIXELS - 1][3] == 1.0f);
            assert_true(colors[0][0] == (u->right_alone ? 0.25f : 0.0f));
        }
}

static void faults_are_returned(void **state)
{
    faulty u;

    memset(&u, 0, sizeof u);
    expect_fault(&u, gn_texture_check(&u.texture)); /* zeroed */
    assert_int_not_equal(gn_texture_check(&u.texture), GN_OK);
    u.fetches = true;
    expect_fault(&u, gn_texture_check(&u.texture));
    u.fetches = false;
    u.texture = texture_of_kind(0);
    u.texture.level[2].texels = NULL;
    u.right_alone = true;
    expect_fault(&u, GN_NULL_POINTER);
    u.texture = texture_of_kind(0);
    u.sampler.wrap_t = (gn_wrap)77;
    expect_fault(&u, GN_INVALID_ENUM);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(are_those_of_the_public_functions),
        cmocka_unit_test(see_changes),
        cmocka_unit_test(faults_are_returned),
    };

    return cmocka_run_group_tests_name("lookups of shaders", tests, set_up, NULL);
}
