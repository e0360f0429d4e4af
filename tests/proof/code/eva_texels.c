/* Numbers of texels, for all floats as coordinates (infinities and NaN too), every wrap, and sizes
 * of which the smallest, the greatest and those about powers of two are taken one by one: they lie
 * in the level, as texture/wrap.h says. No conversion of a float overflows.
 * @options: -eva-precision 2
 * @reaches: wrap_nearest wrap_linear wrap_linear_any wrap_gathered second_texel clamped_texels
 * @reaches: mirrored fraction_of nearest_integer lanes_floor lanes_round lanes_truncate */
#include "eva.h"

#include "texture/wrap.h"

static lanes_f any_coordinates(void)
{
    lanes_f a;

    for (int l = 0; l < GN_LANES; ++l)
        a.v[l] = any_float;
    return a;
}

static void check(lanes_i texel, int32_t size)
{
    for (int l = 0; l < GN_LANES; ++l) {
        const int32_t number = texel.v[l];

        /*@ assert 0 <= number < size; */
        (void)number;
    }
}

static void check_wrap(gn_wrap wrap, bool masked, uint32_t size)
{
    lanes_i texel[2];

    texel[0] = wrap_nearest(wrap, masked, any_coordinates(), size);
    if (wrap != GN_WRAP_CLAMP_TO_BORDER)
        check(texel[0], (int32_t)size);
    wrap_linear_any(wrap, masked, any_coordinates(), size, texel);
    if (wrap != GN_WRAP_CLAMP_TO_BORDER) {
        check(texel[0], (int32_t)size);
        check(texel[1], (int32_t)size);
    }
    wrap_gathered(wrap, masked, any_coordinates(), size, texel);
    if (wrap != GN_WRAP_CLAMP_TO_BORDER) {
        check(texel[0], (int32_t)size);
        check(texel[1], (int32_t)size);
    }
}

int main(void)
{
    static const uint16_t size[] = {1, 2, 3, 4, 5, 7, 8, 255, 256, 257, 8191, 8192, 16383, 16384};

    /*@ loop unroll 20; */
    for (uint32_t n = 0; n < sizeof size / sizeof size[0]; ++n) {
        /*@ loop unroll 5; */
        for (int wrap = GN_WRAP_REPEAT; wrap <= GN_WRAP_MIRROR_CLAMP_TO_EDGE; ++wrap)
            check_wrap((gn_wrap)wrap, false, size[n]);
        if (is_power_of_two(size[n]))
            check_wrap(GN_WRAP_REPEAT, true, size[n]);
    }
    return 0;
}
