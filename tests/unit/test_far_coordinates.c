/* Coordinates of repeated textures around the ends of the integers. Needs no more than a GN_BASIC
 * library has, over any number of lanes. */
#include <math.h>
#include <string.h>

#include "unit.h"

/* Texel (x, y) is (10 x + y, 0, 0, 255). */
enum { SIDE = 4 };

static uint32_t image[SIDE * SIDE];

static gn_texture numbered(void)
{
    gn_texture t;

    for (uint32_t i = 0; i < SIDE * SIDE; ++i)
        image[i] = i % SIDE * 10 + i / SIDE + 0xFF000000u;
    memset(&t, 0, sizeof t);
    t.level[0].texels = image;
    t.level[0].row_stride = 4 * SIDE;
    t.width = t.height = SIDE;
    t.format = GN_FORMAT_RGBA8;
    assert_int_equal(gn_texture_check(&t), GN_OK);
    return t;
}

/* Returns the red of the nearest texel, as the byte that it is in memory. */
static int nearest(const gn_texture *texture, float s, float t)
{
    gn_sampler sampler;
    float along_s[GN_LANES], along_t[GN_LANES], texel[4][GN_LANES];

    memset(&sampler, 0, sizeof sampler);
    sampler.magnify = GN_MAGNIFY_NEAREST;
    sampler.minify = GN_MINIFY_NEAREST;
    for (int l = 0; l < GN_LANES; ++l) {
        along_s[l] = s;
        along_t[l] = t;
    }
    gn_sample_2d(texture, &sampler, along_s, along_t, texel);
    for (int l = 1; l < GN_LANES; ++l)
        assert_true(texel[0][l] == texel[0][0]);
    return (int)lrintf(255.0f * texel[0][0]);
}

/* Floats of 2^24 or more are whole numbers: the place of 0, in texel 0. */
static void texels_of_coordinates(void **state)
{
    (void)state;
    static const struct {
        float coordinate;
        int texel;
    } cases[] = {{0.0f, 0},
                 {-0.0f, 0},
                 {0.3f, 1},
                 {0.75f, 3},
                 {-0.25f, 3},
                 {-0.3f, 2},
                 {-1e-45f, 3},
                 {7.6f, 2},
                 {-7.6f, 1},
                 {0x1.5p20f, 0},
                 {-0x1p20f + 0.5f, 2},
                 {0x1.fffffep28f, 0},
                 {0x1p29f, 0},
                 {-0x1.fffffep28f, 0},
                 {-0x1p29f, 0},
                 {-0x1.000002p29f, 0},
                 {3e9f, 0},
                 {-3e9f, 0},
                 {1e30f, 0},
                 {-1e30f, 0},
                 {0x1.fffffep127f, 0},
                 {-0x1.fffffep127f, 0}};
    const gn_texture texture = numbered();

    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i)
        for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k)
            assert_int_equal(nearest(&texture, cases[i].coordinate, cases[k].coordinate),
                             10 * cases[i].texel + cases[k].texel);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(texels_of_coordinates),
    };
    return cmocka_run_group_tests_name("far coordinates", tests, NULL, NULL);
}
