/* The faults of textures and samplers in words. */
#define GN_FAULT_TEXTS
#include "sampler_faults.h"
#include "texture_faults.h"

const char *gn_texture_fault(const gn_texture *texture)
{
    return fault_of_texture(texture);
}

const char *gn_sampler_fault(const gn_sampler *sampler)
{
    return fault_of_sampler(sampler);
}
