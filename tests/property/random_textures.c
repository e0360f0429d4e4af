/* Random textures, samplers and numbers. */
#include "random_textures.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "scene_format.h"

gn_format random_target_format(random_source *r)
{
    if (random_chance(r, 40))
        return GN_FORMAT_RGBA8;
    return random_chance(r, 20) ? GN_FORMAT_RGBA32F
                                : scene_color_formats[random_below(r, SCENE_COLOR_FORMATS)];
}

gn_texture random_texture_shape(random_source *r, uint32_t most)
{
    static const gn_format depths[] = {GN_FORMAT_D16, GN_FORMAT_D24, GN_FORMAT_D32F,
                                       GN_FORMAT_D24S8, GN_FORMAT_D32FS8};
    gn_texture t;
    uint32_t levels = 1;

    memset(&t, 0, sizeof t);
    t.target = (gn_texture_target)random_below(r, 5);
    t.format = random_chance(r, 25) ? depths[random_below(r, 5)] : random_target_format(r);
    t.width = 1 + random_below(r, most);
    t.height = 1 + random_below(r, most);
    t.depth = 1 + random_below(r, most < 8 ? most : 8);
    if (t.target == GN_TEXTURE_CUBE)
        t.height = t.width;
    if (t.target == GN_TEXTURE_1D)
        t.height = 1;
    while (t.width >> levels || t.height >> levels ||
           (t.target == GN_TEXTURE_3D && t.depth >> levels))
        ++levels;
    t.level_count = random_chance(r, 50) ? levels : random_below(r, levels + 1);
    return t;
}

gn_sampler random_sampler_state(random_source *r)
{
    gn_sampler s;

    memset(&s, 0, sizeof s);
    s.wrap_s = (gn_wrap)random_below(r, 5);
    s.wrap_t = (gn_wrap)random_below(r, 5);
    s.wrap_r = (gn_wrap)random_below(r, 5);
    s.magnify = (gn_magnify)random_below(r, 2);
    s.minify = (gn_minify)random_below(r, 6);
    s.compare = (gn_compare)random_below(r, 9);
    if (random_chance(r, 30))
        s.lod_bias = random_chance(r, 50) ? random_float(r, -4.0f, 4.0f)
                                          : random_signed_octave(r, -126, 126);
    s.lod_clamp_enabled = random_chance(r, 30);
    s.min_lod = random_float(r, -4.0f, 8.0f);
    s.max_lod = s.min_lod + random_float(r, 0.0f, 8.0f);
    if (random_chance(r, 15))
        s.max_anisotropy = random_below(r, GN_MAX_ANISOTROPY + 1);
    for (int c = 0; c < 4; ++c)
        s.border[c] = random_float(r, 0.25f, 0.5f);
    return s;
}

float random_hostile_number(random_source *r)
{
    static const float numbers[] = {0.0f,        1.0f,     16777216.0f, FLT_MAX, FLT_MIN,
                                    FLT_MIN / 8, INFINITY, NAN,         1e30f,   2147483648.0f};
    const float sign = random_sign(r);

    switch (random_below(r, 4)) {
    case 0:
        return sign * numbers[random_below(r, 10)];
    case 1:
        return sign * random_octave(r, -126, 126);
    default:
        return random_float(r, -2.0f, 3.0f);
    }
}
