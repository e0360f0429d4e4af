/* Anisotropic filtering (EXT_texture_filter_anisotropic; OpenGL 4.6 section 8.14). If the footprint
 * of a lookup is longer in one direction than in the other, the lookup is the mean of several
 * samples along the longer gradient, each with a footprint shorter by the number of samples. */
#ifndef GN_KERNEL_TEXTURE_ANISOTROPIC_INL
#define GN_KERNEL_TEXTURE_ANISOTROPIC_INL

#include "lookup_parts.inl"

/* The samples of each lane's lookup. */
typedef struct anisotropy {
    lanes_f count;     /* 1 to GN_MAX_ANISOTROPY */
    lanes_f footprint; /* of one sample, as find_footprint returns it */
    lanes_f middle[3]; /* coordinates; for cubes the direction */
    lanes_f along[3];  /* the longer gradient of the coordinates */
    int dimensions;    /* number of coordinates: 2 or 3 */
} anisotropy;

/* Returns min(ceil(Pmax / Pmin), most), from the squares of the lengths: the least n for which n^2
 * Pmin^2 is not below Pmax^2, so that no root or quotient is rounded. Returns 1 if Pmax is not
 * above one texel (the texture is magnified) and if a square is infinite or not a number. */
static inline lanes_f sample_count(lanes_f longer, lanes_f shorter, uint32_t most)
{
    const lanes_m is_minified = lanes_and(lanes_greater(longer, lanes_splat(1.0f)),
                                          lanes_less_equal(longer, lanes_splat(FLT_MAX)));
    lanes_f count = lanes_splat(1.0f);

    for (uint32_t n = 1; n < most; ++n) {
        const lanes_f reach = lanes_mul(lanes_splat((float)(n * n)), shorter);
        const lanes_m is_more = lanes_and(is_minified, lanes_greater(longer, reach));

        if (lanes_bits(is_more) == 0)
            break;
        count = lanes_select(is_more, lanes_splat((float)(n + 1)), count);
    }
    return count;
}

/* Finds the samples. Lanes of a quad that share a footprint share the count and the gradient of the
 * lower left lane. For cubes the lengths are measured on the face. */
GN_OUT_OF_LINE void find_anisotropy(const lookup_state *state, const lookup_place *place,
                                    const gn_lookup *lookup, anisotropy *out)
{
    const bool is_cube = state->texture.target == GN_TEXTURE_CUBE;
    const bool is_own = has_own_footprint(state, lookup);
    lanes_f along_x[3], along_y[3], on_face_x[2], on_face_y[2], x, y;

    out->dimensions = is_cube ? 3 : state->dimensions;
    for (int n = 0; n < out->dimensions; ++n) {
        out->middle[n] = lanes_load(lookup->coordinate[n]);
        coordinate_gradients(lookup, n, &along_x[n], &along_y[n]);
    }
    if (is_cube) {
        cube_gradient(place->cube, along_x, on_face_x);
        cube_gradient(place->cube, along_y, on_face_y);
    }
    squared_lengths(state, state->dimensions, is_cube ? on_face_x : along_x,
                    is_cube ? on_face_y : along_y, &x, &y);

    const lanes_m is_x = lanes_greater(x, y);
    const lanes_f longer = lanes_max(x, y);
    const lanes_f count = sample_count(longer, lanes_min(x, y), state->sampler.max_anisotropy);

    out->count = is_own ? count : of_first_in_quad(count);
    out->footprint = shared_footprint(state, lookup, lanes_div(longer, lanes_mul(count, count)));
    for (int n = 0; n < out->dimensions; ++n) {
        const lanes_f along = lanes_select(is_x, along_x[n], along_y[n]);

        out->along[n] = is_own ? along : of_first_in_quad(along);
    }
}

/* Writes the coordinates of sample i, from 1 to count: i / (count + 1) - 1/2 of the longer gradient
 * from the middle. A lane with one sample stays at the middle, also if its gradient is not finite.
 * Lanes with fewer than i samples look at an arbitrary place. */
static inline void find_sample(const anisotropy *a, int i, lanes_f at[3])
{
    const lanes_f parts = lanes_add(a->count, lanes_splat(1.0f));
    const lanes_f offset =
        lanes_div(lanes_sub(lanes_splat((float)(2 * i)), parts), lanes_add(parts, parts));
    const lanes_m moves = lanes_greater(a->count, lanes_splat(1.0f));

    for (int n = 0; n < a->dimensions; ++n)
        at[n] = lanes_select(moves, lanes_add(a->middle[n], lanes_mul(offset, a->along[n])),
                             a->middle[n]);
}

/* Returns the lanes that have a sample i. */
static inline lanes_m has_sample(const anisotropy *a, int i)
{
    return lanes_less_equal(lanes_splat((float)i), a->count);
}

/* Adds sample i to the mean of the samples before it, in a way that keeps equal samples exact. */
static inline void take_sample(const lookup_state *state, const anisotropy *a, int i,
                               const lanes_f sample[4], lanes_f mean[4])
{
    const lanes_m is_there = has_sample(a, i);
    const lanes_f weight = lanes_splat(1.0f / (float)i);

    for (int c = 0; c < state->decoding->channels; ++c)
        mean[c] = lanes_select(is_there, mix(weight, mean[c], sample[c]), mean[c]);
}

/* Moves a place to other coordinates, `moved`; for cubes to a direction. */
static inline void move_place(const lookup_state *state, const lanes_f at[3], bool has_gradients,
                              float moved[3][GN_LANES], cube_place *cube)
{
    if (state->texture.target == GN_TEXTURE_CUBE) {
        cube_project(at, has_gradients, cube);
        return;
    }
    for (int n = 0; n < state->dimensions; ++n)
        lanes_store(moved[n], at[n]);
}

/* Does what lookup_in_state does. Precondition: is_anisotropic (lookup.inl). */
GN_OUT_OF_LINE void lookup_anisotropic(const lookup_state *state, const gn_lookup *lookup,
                                       float texel[4][GN_LANES])
{
    const bool has_gradients = asks_for_gradients(state, lookup);
    lookup_place place;
    cube_place cube;
    level_choice choice;
    anisotropy a;
    lanes_f at[3], sample[4], mean[4];
    float moved[3][GN_LANES];
    const float *const coordinates[3] = {moved[0], moved[1], moved[2]};
    uint32_t linear, two_levels;

    set_place(state, lookup->coordinate, lookup->reference, has_gradients, &place, &cube);
    find_anisotropy(state, &place, lookup, &a);
    place.coordinate = coordinates;
    find_levels(state, &place, lookup, &a.footprint, &choice);
    choose_filters(state, lookup, &choice, &linear, &two_levels);
    for (int i = 1; i == 1 || lanes_bits(has_sample(&a, i)) != 0; ++i) {
        find_sample(&a, i, at);
        move_place(state, at, has_gradients, moved, &cube);
        filter_levels(state, &place, &choice, linear, two_levels, i == 1 ? mean : sample);
        if (i > 1)
            take_sample(state, &a, i, sample, mean);
    }
    for (int c = 0; c < 4; ++c)
        store_channel(state, c, mean[c], texel[c]);
}

#endif
