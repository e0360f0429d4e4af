/* Where in their pixels fragments of multisampled targets are shaded: at centres, centroids or
 * samples (OpenGL 4.5 section 14.3.1; reference/RULES.md, "Samples"). */
#ifndef GN_KERNEL_FRAGMENT_LOCATIONS_INL
#define GN_KERNEL_FRAGMENT_LOCATIONS_INL

#include "../raster/cover_samples.inl"
#include "planes.inl"

/* Returns a sample's place in a pixel, in pixels from the pixel's lower left corner. */
static inline float sample_place(uint32_t sample, int axis)
{
    return (float)(128 + sample_offset(sample, axis)) * (1.0f / 256.0f);
}

/* Whether all varyings are at samples, because the pipeline asks for more than one call a pixel. */
static inline bool shades_all_samples(const gn_pipeline *pipeline)
{
    return pipeline->samples.shading_enabled && pipeline->samples.least_shading * GN_SAMPLES > 1.0f;
}

/* Sets the places of centroids: the first present sample, or the centre if all samples or none are
 * present. `present` has the lanes of each sample. */
static inline void set_centroid_places(block_places *at, const pixel_block *block,
                                       const uint32_t present[GN_SAMPLES])
{
    lanes_f inside[2] = {lanes_splat(0.5f), lanes_splat(0.5f)};
    uint32_t all = GN_ALL_LANES;

    for (uint32_t s = 0; s < GN_SAMPLES; ++s)
        all &= present[s];
    for (uint32_t s = GN_SAMPLES; s-- > 0;) {
        const lanes_m moved = lanes_from_bits(present[s] & ~all);

        for (int axis = 0; axis < 2; ++axis)
            inside[axis] = lanes_select(moved, lanes_splat(sample_place(s, axis)), inside[axis]);
    }
    set_places(at, block, 0);
    at->x = lanes_add(at->x, inside[0]);
    at->y = lanes_add(at->y, inside[1]);
}

#endif
