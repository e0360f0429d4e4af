/* Validation of textures and samplers: returns the status of the first fault. */
#include "sampler_faults.h"
#include "texture_faults.h"

gn_status gn_texture_check(const gn_texture *texture)
{
    return fault_of_texture(texture);
}

gn_status gn_sampler_check(const gn_sampler *sampler)
{
    return fault_of_sampler(sampler);
}

bool gn_lookup_needs_quads(const gn_texture *texture, const gn_sampler *sampler)
{
    return !is_level_0(texture, sampler);
}
