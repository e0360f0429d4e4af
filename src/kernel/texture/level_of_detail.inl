/* The level of detail of each lane, and the levels that it selects (OpenGL 4.5 sections 8.14.1 and
 * 8.14.3), in the order of operations of the reference rasterizer. */
#ifndef GN_KERNEL_TEXTURE_LEVEL_OF_DETAIL_INL
#define GN_KERNEL_TEXTURE_LEVEL_OF_DETAIL_INL

#include "cube_filter.inl"

/* The two levels of each lane, the weight of the second, and the lanes, as bits, in which the
 * texture is minified. */
typedef struct level_choice {
    lanes_i level, next;
    lanes_f weight;
    uint32_t minified;
} level_choice;

/* Writes the gradients of the lookup, or the differences within each lane's row and column of its
 * quad. */
GN_INLINE void coordinate_gradients(const gn_lookup *lookup, int dimension, lanes_f *along_x,
                                    lanes_f *along_y)
{
    if (lookup->lod_source == GN_LOD_GRADIENTS) {
        *along_x = lanes_load(lookup->gradient_x[dimension]);
        *along_y = lanes_load(lookup->gradient_y[dimension]);
    } else {
        const lanes_f coordinate = lanes_load(lookup->coordinate[dimension]);

        *along_x = derivative_x(coordinate);
        *along_y = derivative_y(coordinate);
    }
}

/* Writes the squared lengths of two gradients, in texels. */
GN_INLINE void squared_lengths(const lookup_state *state, int dimensions, const lanes_f along_x[3],
                               const lanes_f along_y[3], lanes_f *out_x, lanes_f *out_y)
{
    lanes_f x = lanes_splat(0.0f), y = x;

    for (int n = 0; n < 3 && n < dimensions; ++n) {
        const lanes_f size = lanes_splat((float)state->level[0].size[n]);
        const lanes_f dx = lanes_mul(along_x[n], size);
        const lanes_f dy = lanes_mul(along_y[n], size);

        x = n == 0 ? lanes_mul(dx, dx) : lanes_add(x, lanes_mul(dx, dx));
        y = n == 0 ? lanes_mul(dy, dy) : lanes_add(y, lanes_mul(dy, dy));
    }
    *out_x = x;
    *out_y = y;
}

/* Returns the exponent of a positive float: n for 2^n. */
static inline lanes_i exponent_of(lanes_f a)
{
    return lanes_i_sub(lanes_i_and(lanes_i_shift_right(lanes_as_int(a), 23), lanes_i_splat(255)),
                       lanes_i_splat(127));
}

/* Returns log2, linear between powers of two. */
static inline lanes_f rough_log2(lanes_f a)
{
    const lanes_i mantissa = lanes_i_or(lanes_i_and(lanes_as_int(a), lanes_i_splat(0x007FFFFF)),
                                        lanes_i_splat(0x3F800000));
    const lanes_i below = lanes_i_sub(exponent_of(a), lanes_i_splat(1));

    return lanes_add(lanes_to_float(below), lanes_as_float(mantissa));
}

/* Returns whether the lanes of a quad may have levels of their own. */
static inline bool has_lod_per_lane(const gn_lookup *lookup)
{
    return lookup->lod_source == GN_LOD_GRADIENTS || lookup->lod;
}

/* The numbers that a lookup and its sampler add to the level of detail, and its limits. */
typedef struct lod_adjustment {
    float bias;
    bool has_least, has_most;
    float least, most;
} lod_adjustment;

/* Returns the bias clamped to -16 to 16 and rounded to a multiple of 1/256, ties away from zero. */
static inline float quantised_bias(float bias)
{
    const float limited = bias > 16.0f ? 16.0f : bias < -16.0f ? -16.0f : bias;
    const float scaled = limited * 256.0f + (limited < 0.0f ? -0.5f : 0.5f);

    return (float)(int32_t)scaled * (1.0f / 256.0f);
}

/* A lower limit at or below 0, or an upper limit of GN_MAX_LEVELS or more, has no effect. */
static inline lod_adjustment lod_adjustment_of(const gn_sampler *sampler)
{
    lod_adjustment a;

    a.bias = sampler->lod_bias == 0.0f ? 0.0f : quantised_bias(sampler->lod_bias);
    a.least = sampler->lod_clamp_enabled ? sampler->min_lod : 0.0f;
    a.most = sampler->lod_clamp_enabled ? sampler->max_lod : (float)GN_MAX_LEVELS;
    a.has_least = a.least > 0.0f;
    a.has_most = a.most < (float)GN_MAX_LEVELS;
    return a;
}

/* Returns whether the limits leave only one level of detail, max_lod. As in the reference, a lower
 * limit below 0 counts as 0 here, so that an upper limit below 0 leaves more than one. */
static inline bool has_one_lod(const gn_sampler *sampler)
{
    const float least = sampler->min_lod > 0.0f ? sampler->min_lod : 0.0f;

    return sampler->lod_clamp_enabled && sampler->max_lod == least;
}

/* Chooses the levels that a level of detail selects. */
static inline void choose_levels(const gn_sampler *sampler, int32_t last, lanes_f lod,
                                 level_choice *out)
{
    const lanes_i top = lanes_i_splat(last), zero = lanes_i_splat(0);

    out->minified = lanes_bits(lanes_not(lanes_less_equal(lod, lanes_splat(0.0f))));
    if (mixes_levels(sampler->minify)) {
        const lanes_f whole = lanes_floor(lod); /* -0 or 0 of -0, so 0 is added below */
        const lanes_f weight = lanes_add(lanes_sub(lod, whole), lanes_splat(0.0f));
        const lanes_i level = lanes_truncate(whole);
        const lanes_i next = lanes_i_add(level, lanes_i_splat(1));

        out->level = lanes_i_max(lanes_i_min(level, top), zero);
        out->next = lanes_i_max(lanes_i_min(next, top), zero);
        /* Below the first level, and from the last on, both levels are the same. */
        out->weight =
            lanes_select(lanes_i_greater(out->next, out->level), weight, lanes_splat(0.0f));
    } else {
        out->level = out->next = lanes_i_clamp(lanes_round(lod), zero, top);
        out->weight = lanes_splat(0.0f);
    }
}

/* Chooses the nearest level if nothing is added to the level of detail: half the exponent of the
 * squared footprint, rounded up; if the footprint is not squared, as in one dimension, the exponent
 * of the footprint times the root of 2. */
static inline void choose_nearest_level(bool squared, int32_t last, lanes_f footprint,
                                        level_choice *out)
{
    const lanes_i one = lanes_i_splat(1);
    const lanes_i level = squared ? lanes_i_shift_right(lanes_i_add(exponent_of(footprint), one), 1)
                                  : exponent_of(lanes_mul(footprint, lanes_splat(1.41421354f)));

    out->minified = lanes_bits(lanes_not(lanes_less_equal(footprint, lanes_splat(1.0f))));
    out->level = out->next = lanes_i_clamp(level, lanes_i_splat(0), lanes_i_splat(last));
    out->weight = lanes_splat(0.0f);
}

/* Writes the gradients of the lookup, or the differences of its coordinates. For cubes these are
 * converted from gradients of the direction to gradients on each lane's face. */
GN_INLINE void find_gradients(const lookup_place *place, const gn_lookup *lookup, bool is_cube,
                              int dimensions, lanes_f along_x[3], lanes_f along_y[3])
{
    const int count = is_cube ? 3 : dimensions;
    lanes_f x[3], y[3];

    for (int n = 0; n < 3 && n < count; ++n)
        coordinate_gradients(lookup, n, &along_x[n], &along_y[n]);
    if (!is_cube)
        return;
    cube_gradient(place->cube, along_x, x);
    cube_gradient(place->cube, along_y, y);
    for (int n = 0; n < 2; ++n) {
        along_x[n] = x[n];
        along_y[n] = y[n];
    }
}

/* Replaces infinity and NaN by 0: the texture counts as magnified. */
static inline lanes_f finite_footprint(lanes_f footprint)
{
    return lanes_select(lanes_less_equal(footprint, lanes_splat(FLT_MAX)), footprint,
                        lanes_splat(0.0f));
}

/* Returns whether each lane has its own footprint: if gradients are given, and for cubes with
 * several levels or with a lod for each lane. Otherwise a quad has one footprint, that of its lower
 * left lane. */
static inline bool has_own_footprint(const lookup_state *state, const gn_lookup *lookup)
{
    return lookup->lod_source == GN_LOD_GRADIENTS ||
           (state->texture.target == GN_TEXTURE_CUBE &&
            (lookup->lod || (has_levels(state->sampler.minify) && levels_of(&state->texture) > 1)));
}

/* Returns each lane's footprint, shared within quads where has_own_footprint is false. */
static inline lanes_f shared_footprint(const lookup_state *state, const gn_lookup *lookup,
                                       lanes_f footprint)
{
    const lanes_f shared =
        has_own_footprint(state, lookup) ? footprint : of_first_in_quad(footprint);

    return state->texture.target == GN_TEXTURE_CUBE || lookup->lod_source == GN_LOD_GRADIENTS
               ? finite_footprint(shared)
               : shared;
}

/* Returns the greater of the squared lengths of the gradients; for a single dimension the greater
 * length itself. */
GN_WIDE_INLINE lanes_f footprint_in(const lookup_state *state, const lookup_place *place,
                                    const gn_lookup *lookup, bool is_cube, int dimensions)
{
    lanes_f along_x[3], along_y[3], x, y;

    find_gradients(place, lookup, is_cube, dimensions, along_x, along_y);
    if (dimensions == 1)
        return lanes_mul(lanes_max(lanes_magnitude(along_x[0]), lanes_magnitude(along_y[0])),
                         lanes_splat((float)state->texture.width));
    squared_lengths(state, dimensions, along_x, along_y, &x, &y);
    return lanes_max(x, y);
}

/* Each branch compiles the footprint once more, with constants. */
static inline lanes_f find_footprint(const lookup_state *state, const lookup_place *place,
                                     const gn_lookup *lookup)
{
    const int dimensions = state->dimensions;
    lanes_f footprint;

    if (state->texture.target == GN_TEXTURE_CUBE)
        footprint = footprint_in(state, place, lookup, true, 2);
    else if (dimensions == 2)
        footprint = footprint_in(state, place, lookup, false, 2);
    else
        footprint = footprint_in(state, place, lookup, false, dimensions);
    return shared_footprint(state, lookup, footprint);
}

/* Chooses the levels of a lookup. `known` is the footprint, or null if it must be computed. */
GN_OUT_OF_LINE void find_levels(const lookup_state *state, const lookup_place *place,
                                const gn_lookup *lookup, const lanes_f *known, level_choice *out)
{
    const gn_sampler *const sampler = &state->sampler;
    const int32_t last = (int32_t)levels_of(&state->texture) - 1;
    const lod_adjustment a = lod_adjustment_of(sampler);
    const bool has_lod = lookup->lod && lookup->lod_source != GN_LOD_GRADIENTS;
    const bool adjusted = has_lod || a.bias != 0.0f || a.has_least || a.has_most;
    const bool squared = state->dimensions > 1;
    lanes_f lod = has_lod ? lanes_load(lookup->lod) : lanes_splat(0.0f);

    if (has_one_lod(sampler)) {
        choose_levels(sampler, last, lanes_splat(sampler->max_lod), out);
        return;
    }
    if (lookup->lod_source != GN_LOD_EXPLICIT) {
        const lanes_f footprint = known ? *known : find_footprint(state, place, lookup);

        if (!adjusted && !mixes_levels(sampler->minify)) {
            choose_nearest_level(squared, last, footprint, out);
            return;
        }

        const lanes_f square = squared ? footprint : lanes_mul(footprint, footprint);
        const lanes_f found = lanes_mul(rough_log2(square), lanes_splat(0.5f));
        lod = has_lod ? lanes_add(found, lod) : found;
    }
    if (a.bias != 0.0f)
        lod = lanes_add(lod, lanes_splat(a.bias));
    if (a.has_most)
        lod = lanes_min(lod, lanes_splat(a.most));
    if (a.has_least)
        lod = lanes_max(lod, lanes_splat(a.least));
    choose_levels(sampler, last, lod, out);
}

#endif
