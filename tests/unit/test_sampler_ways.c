/* Lookups in textures have several ways through the library: some for the common samplers, some for
 * texels that lie as usual in memory. Descriptions of one lookup that take different ways must read
 * the same colours: bounds of the level of detail that bound nothing, and rows far apart. */
#include <stdlib.h>
#include <string.h>

#include "unit.h"

enum { SIZE = 20, FAR_APART = 1 << 17, WAYS = 5 };

static uint32_t texels[64 * 64 * 2];
static unsigned char *apart[GN_MAX_LEVELS];
static uint32_t frames[WAYS][SIZE * SIZE];
static uint16_t depths[SIZE * SIZE];

static uint32_t noise(uint32_t *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return *seed >> 8;
}

static uint32_t level_size(uint32_t size, uint32_t level)
{
    return size >> level > 0 ? size >> level : 1;
}

/* Makes the texture of way `way`: 0, 1: packed; 2: level 0 far apart; 3: the others; 4: all. */
static gn_texture texture_of(int way, uint32_t width, uint32_t height, uint32_t levels)
{
    gn_texture texture;

    assert_int_equal(gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, width, height, 1, levels,
                                       texels, &texture),
                     GN_OK);
    for (uint32_t n = 0; n < levels; ++n) {
        gn_texture_level *const level = &texture.level[n];

        if (way < 2 || (way == 2 && n > 0) || (way == 3 && n == 0))
            continue;
        for (uint32_t row = 0; row < level_size(height, n); ++row)
            memcpy(apart[n] + (size_t)row * FAR_APART,
                   (const unsigned char *)level->texels + (ptrdiff_t)row * level->row_stride,
                   4 * level_size(width, n));
        level->texels = apart[n];
        level->row_stride = FAR_APART;
    }
    return texture;
}

/* Draws a square whose texture is larger than the screen's pixels at one side, and smaller at the
 * other. */
static void draw(uint32_t *frame, const gn_texture *texture, const gn_sampler *sampler, float scale,
                 bool tilted)
{
    static unsigned char memory[GN_WORKSPACE_SIZE(16, 8)];
    static gn_unlit_uniforms uniforms;
    const float far = tilted ? 9.0f : 1.0f;
    const float position[4][4] = {
        {-1, -1, 0, 1}, {far, -far, 0, far}, {-1, 1, 0, 1}, {far, far, 0, far}};
    const float place[4][2] = {{-0.3f, -0.2f},
                               {-0.3f + scale, -0.2f},
                               {-0.3f, -0.2f + scale},
                               {-0.3f + scale, 0.1f + scale}};
    gn_target target;
    gn_pipeline p;
    gn_mesh mesh = {.vertex_count = 4, .count = 4};
    gn_workspace workspace = {.memory = memory, .size = sizeof memory};

    memset(&target, 0, sizeof target);
    memset(&p, 0, sizeof p);
    target.color[0] = gn_surface_bottom_up(frame, GN_FORMAT_RGBA8, SIZE, SIZE);
    target.depth = gn_surface_bottom_up(depths, GN_FORMAT_D16, SIZE, SIZE);
    p.depth.test = true;
    p.depth.function = GN_LESS_OR_EQUAL;
    p.raster.topology = GN_TRIANGLE_STRIP;
    gn_mat4_identity(&uniforms.clip_from_model);
    uniforms.map = texture;
    uniforms.sampler = *sampler;
    assert_int_equal(gn_use_unlit(&p, &uniforms), GN_OK);
    mesh.attribute[GN_ATTRIBUTE_POSITION] = (gn_attribute){.data = position[0], .components = 4};
    mesh.attribute[GN_ATTRIBUTE_TEXCOORD] = (gn_attribute){.data = place[0], .components = 2};
    assert_int_equal(gn_clear_color(&target.color[0], 0, 0, 0, 0), GN_OK);
    assert_int_equal(gn_clear_depth(&target.depth, 1), GN_OK);
    for (int best = 0; best < 2; ++best) {
        workspace.backend = best ? gn_backend_best() : GN_BACKEND_PORTABLE;
        assert_int_equal(gn_draw(&target, &p, &mesh, &workspace), GN_OK);
    }
}

static void compare_ways(uint32_t width, uint32_t height, uint32_t levels,
                         const gn_sampler *sampler)
{
    static const float scales[] = {0.04f, 0.6f, 1.0f, 3.7f, 14.0f};

    for (size_t n = 0; n < 2 * sizeof scales / sizeof *scales; ++n) {
        for (int way = 0; way < WAYS; ++way) {
            const gn_texture texture = texture_of(way, width, height, levels);
            gn_sampler same = *sampler;

            if (way == 1) {
                same.lod_clamped = true;
                same.min_lod = -1000.0f;
                same.max_lod = 1000.0f;
            }
            draw(frames[way], &texture, &same, scales[n / 2], n % 2);
            assert_memory_equal(frames[way], frames[0], sizeof frames[0]);
        }
    }
}

static void every_way_reads_the_same(void **state)
{
    static const gn_wrap wraps[] = {GN_WRAP_REPEAT, GN_WRAP_CLAMP_TO_EDGE, GN_WRAP_MIRRORED_REPEAT};
    static const uint32_t sizes[][3] = {{16, 16, 1}, {16, 16, 5}, {13, 7, 4}, {32, 8, 3}};
    uint32_t seed = 3;

    (void)state;
    for (int n = 0; n < 6; ++n) {
        apart[n] = calloc(33, FAR_APART);
        assert_non_null(apart[n]);
    }
    for (size_t i = 0; i < sizeof texels / sizeof *texels; ++i)
        texels[i] = noise(&seed);
    for (size_t i = 0; i < sizeof texels / sizeof *texels; ++i)
        texels[i] ^= noise(&seed) << 8;
    for (size_t size = 0; size < sizeof sizes / sizeof *sizes; ++size)
        for (int filter = 0; filter < 12; ++filter)
            for (size_t wrap = 0; wrap < 4; ++wrap) {
                gn_sampler sampler;

                memset(&sampler, 0, sizeof sampler);
                sampler.magnify = (gn_magnify)(filter % 2);
                sampler.minify = (gn_minify)(filter / 2);
                sampler.wrap_s = wraps[wrap % 3];
                sampler.wrap_t = wraps[wrap == 3 ? 1 : wrap];
                compare_ways(sizes[size][0], sizes[size][1], sizes[size][2], &sampler);
            }
    for (int n = 0; n < 6; ++n)
        free(apart[n]);
}

/* Sizes of textures that no memory holds. */
static void textures_that_are_too_large(void **state)
{
    gn_texture texture, before;

    (void)state;
    memset(&before, 0x5A, sizeof before);
    texture = before;
    assert_int_equal(
        gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, 0, 1, 1, 1, texels, &texture),
        GN_INVALID_SIZE);
    assert_int_equal(
        gn_texture_packed(GN_TEXTURE_2D, GN_FORMAT_RGBA8, 4, 4, 1, 4, texels, &texture),
        GN_INVALID_SIZE);
    assert_memory_equal(&texture, &before, sizeof texture);
    assert_int_equal(gn_texture_memory_size(GN_TEXTURE_2D, GN_FORMAT_RGBA8, 4, 4, 1, 4), 0);
    assert_int_equal(gn_texture_memory_size(GN_TEXTURE_2D, GN_FORMAT_RGBA8, 4, 4, 1, 3), 84);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_way_reads_the_same),
        cmocka_unit_test(textures_that_are_too_large),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
