/* The first fault of a sampler, in the order of its fields. */
#ifndef GN_TEXTURE_SAMPLER_FAULTS_H
#define GN_TEXTURE_SAMPLER_FAULTS_H

#include <gnomon/lookup.h>

#include "../config/faults.h"
#include "../config/features.h"
#include "../scalars/bits.h"
#include "lookup_kernels.h"

static inline fault fault_of_lod_range(const gn_sampler *s)
{
    if (!s->lod_clamp_enabled)
        return NO_FAULT;
    FAULT_IF(!is_finite(s->min_lod), GN_NOT_FINITE, "min_lod is not finite");
    FAULT_IF(!is_finite(s->max_lod), GN_NOT_FINITE, "max_lod is not finite");
    FAULT_IF(s->min_lod > s->max_lod, GN_OUT_OF_RANGE, "min_lod is above max_lod");
    return NO_FAULT;
}

static inline fault fault_of_sampler(const gn_sampler *s)
{
    const unsigned last = GN_WRAP_MIRROR_CLAMP_TO_EDGE;

    FAULT_IF(!s, GN_NULL_POINTER, "the sampler is null");
    FAULT_IF((unsigned)s->wrap_s > last, GN_INVALID_ENUM, "wrap_s is no gn_wrap");
    FAULT_IF((unsigned)s->wrap_t > last, GN_INVALID_ENUM, "wrap_t is no gn_wrap");
    FAULT_IF((unsigned)s->magnify > GN_MAGNIFY_NEAREST, GN_INVALID_ENUM,
             "magnify is no gn_magnify");
    FAULT_IF((unsigned)s->minify > GN_MINIFY_LINEAR_MIPMAP_LINEAR, GN_INVALID_ENUM,
             "minify is no gn_minify");
    /* A library of one lane has no derivatives to choose a filter by. */
    FAULT_IF(GN_LANES == 1 && (s->magnify == GN_MAGNIFY_LINEAR) != minifies_linearly(s->minify),
             GN_NOT_COMPILED, "minify differs from magnify, and this library has one lane");
    if (!GN_HAVE_TEXTURES) {
        FAULT_IF(s->wrap_s > GN_WRAP_CLAMP_TO_EDGE, GN_NOT_COMPILED,
                 "wrap_s mirrors or has a border in a GN_BASIC library");
        FAULT_IF(s->wrap_t > GN_WRAP_CLAMP_TO_EDGE, GN_NOT_COMPILED,
                 "wrap_t mirrors or has a border in a GN_BASIC library");
        FAULT_IF(s->lod_bias != 0.0f, GN_NOT_COMPILED, "lod_bias is not 0 in a GN_BASIC library");
        FAULT_IF(s->lod_clamp_enabled, GN_NOT_COMPILED,
                 "lod_clamp_enabled is on in a GN_BASIC library");
        FAULT_IF(s->max_anisotropy > 1, GN_NOT_COMPILED,
                 "max_anisotropy is above 1 in a GN_BASIC library");
        return NO_FAULT; /* no lookup of such a library reads the other members */
    }
    FAULT_IF((unsigned)s->wrap_r > last, GN_INVALID_ENUM, "wrap_r is no gn_wrap");
    FAULT_IF((unsigned)s->compare > GN_ALWAYS, GN_INVALID_ENUM, "compare is no gn_compare");
    FAULT_IF(!is_finite(s->lod_bias), GN_NOT_FINITE, "lod_bias is not finite");
    FAULT_FROM(fault_of_lod_range(s));
    FAULT_IF(s->max_anisotropy > GN_MAX_ANISOTROPY, GN_OUT_OF_RANGE,
             "max_anisotropy is above GN_MAX_ANISOTROPY");
    for (int c = 0; c < 4; ++c)
        FAULT_IF(s->border[c] != s->border[c], GN_NOT_FINITE, "a number of border is NaN");
    return NO_FAULT;
}

#endif
