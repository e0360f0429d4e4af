/* Lookups in textures at sixteen places, of which a test may change any. */
#ifndef UNIT_LOOKUPS_H
#define UNIT_LOOKUPS_H

#include <string.h>

#include "unit.h"

typedef struct places {
    float at[3][GN_LANES], x[3][GN_LANES], y[3][GN_LANES], lod[GN_LANES], reference[GN_LANES];
} places;

/* All lanes are at one place; its gradients, level of detail and reference value are 0. */
static inline places places_at(float s, float t, float r)
{
    places p;

    memset(&p, 0, sizeof p);
    for (int l = 0; l < GN_LANES; ++l) {
        p.at[0][l] = s;
        p.at[1][l] = t;
        p.at[2][l] = r;
    }
    return p;
}

static inline void set_lanes(float lanes[GN_LANES], float value)
{
    for (int l = 0; l < GN_LANES; ++l)
        lanes[l] = value;
}

static inline gn_lookup lookup_of(const places *p, gn_lod_source source)
{
    gn_lookup lookup;

    memset(&lookup, 0, sizeof lookup);
    lookup.lod_source = source;
    lookup.lod = source == GN_LOD_EXPLICIT ? p->lod : NULL;
    lookup.reference = p->reference;
    for (int n = 0; n < 3; ++n) {
        lookup.coordinate[n] = p->at[n];
        lookup.gradient_x[n] = p->x[n];
        lookup.gradient_y[n] = p->y[n];
    }
    return lookup;
}

/* Looks up equal places, whose texels must be equal. */
static inline void lookup_each(const gn_texture *t, const gn_sampler *s, const places *p,
                               gn_lod_source source, float texel[4])
{
    const gn_lookup lookup = lookup_of(p, source);
    float lanes[4][GN_LANES];

    assert_int_equal(gn_texture_check(t), GN_OK);
    assert_int_equal(gn_sampler_check(s), GN_OK);
    gn_texture_lookup(t, s, &lookup, lanes);
    for (int c = 0; c < 4; ++c) {
        texel[c] = lanes[c][0];
        for (int l = 1; l < GN_LANES; ++l)
            assert_memory_equal(&lanes[c][l], &texel[c], sizeof texel[c]);
    }
}

static inline gn_sampler sampler_of(gn_wrap wrap, gn_magnify magnify, gn_minify minify)
{
    gn_sampler s;

    memset(&s, 0, sizeof s);
    s.wrap_s = s.wrap_t = s.wrap_r = wrap;
    s.magnify = magnify;
    s.minify = minify;
    return s;
}

/* A tightly packed texture. */
static inline gn_texture texture_of(gn_texture_target target, gn_format format, uint32_t width,
                                    uint32_t height, uint32_t depth, uint32_t levels,
                                    const void *texels)
{
    gn_texture t;

    assert_int_equal(gn_texture_packed(target, format, width, height, depth, levels, texels, &t),
                     GN_OK);
    return t;
}

#endif
